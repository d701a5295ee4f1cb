//! `cargo xtask studio`: the page that computes, in one file. The program is built as a WebAssembly module that asks for the system calls of WASI
//! (preview 1), packed by gzip, and put into the page as base64.
//!
//! The target comes from rustup where it can be had; elsewhere from Debian's `rustc-web`, `cargo-web`, `rust-web-src`, `lld-19` and `wasi-libc`, which
//! build the standard library too.

use crate::tally::Tally;
use crate::targets::is_installed;
use crate::test::check;
use crate::viewer::{chromium, npm, on_path, output, prepare};
use crate::{cargo, root};
use base64::Engine;
use std::error::Error;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};

const TARGET: &str = "wasm32-wasip1";

/// The most bytes that the page may have.
const MOST_BYTES: usize = 6 << 20;

/// The most bytes that the packed program in it may have. Aim: 2,500,000.
const MOST_PACKED: usize = 4_300_000;

/// Where the page has the program.
const PLACE: &str = r#"<script type="text/plain" id="program"></script>"#;

/// Where a toolchain of rustup has the sources of the standard library.
const LIBRARY: &str = "lib/rustlib/src/rust/library/Cargo.lock";

/// Where Debian has the library of C of WASI.
const WASI_LIBRARY: &str = "/usr/lib/wasm32-wasi";

/// Builds the page, and with `is_tested` runs it in a browser.
pub(crate) fn run(is_tested: bool) -> ExitCode {
    let page = match build() {
        Ok(page) => page,
        Err(error) => {
            eprintln!("the studio cannot be built: {error}");
            return ExitCode::FAILURE;
        }
    };
    if !is_tested {
        return ExitCode::SUCCESS;
    }
    let Some(chromium) = chromium() else {
        eprintln!("the studio cannot be tested: chromium is not installed, and cannot be");
        return ExitCode::FAILURE;
    };
    let is_built = cargo(&["build", "--release", "--package", "coface-cli"])
        .status()
        .is_ok_and(|status| status.success());
    if !is_built {
        return ExitCode::FAILURE;
    }
    let mut tally = Tally::default();
    let mut tests = npm(&["run", "--silent", "test:studio"]);
    tests.env("COFACE_PROGRAM", root().join("target/release/coface"));
    tests.env("COFACE_MODULE", module_path()).env("COFACE_STUDIO", page).env("CHROMIUM", chromium);
    check(&mut tally, "the studio in a browser", &mut tests);
    println!("{}", tally.to_line());
    if tally.failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// The page, written to `dist/studio.html`.
fn build() -> Result<PathBuf, Box<dyn Error>> {
    prepare()?;
    build_module()?;
    let module = smaller(&module_path())?;
    let folder = root().join("dist");
    let place = folder.display().to_string();
    if !npm(&["run", "--silent", "build:studio", "--", "--outDir", &place]).status()?.success() {
        return Err("its page cannot be built".into());
    }
    let packed = packed(&module)?;
    let text = base64::engine::general_purpose::STANDARD.encode(&packed);
    let path = folder.join("studio.html");
    let page = fs::read_to_string(&path)?;
    if page.matches(PLACE).count() != 1 {
        return Err(format!("the page has no {PLACE}").into());
    }
    let page = page.replace(PLACE, &PLACE.replace("><", &format!(">{text}<")));
    fs::write(&path, &page)?;
    println!(
        "dist/studio.html: {} bytes; the program in it {} bytes, packed {}",
        page.len(),
        module.len(),
        packed.len()
    );
    if page.len() > MOST_BYTES {
        return Err(format!("the page has more than {MOST_BYTES} bytes").into());
    }
    if packed.len() > MOST_PACKED {
        return Err(format!("the packed program has more than {MOST_PACKED} bytes").into());
    }
    Ok(path)
}

fn target_folder() -> PathBuf {
    root().join("target/studio")
}

fn module_path() -> PathBuf {
    target_folder().join(TARGET).join("release/coface.wasm")
}

/// Builds the program as a module, for size. Names of functions stay in it: they say which are alike.
fn build_module() -> Result<(), Box<dyn Error>> {
    let words = ["build", "--release", "--package", "coface-cli", "--target", TARGET];
    let mut command = if is_installed(TARGET) { rustup(&words) } else { debian(&words)? };
    for (name, value) in
        [("OPT_LEVEL", "z"), ("LTO", "fat"), ("CODEGEN_UNITS", "1"), ("PANIC", "abort"), ("STRIP", "none")]
    {
        command.env(format!("CARGO_PROFILE_RELEASE_{name}"), value);
    }
    command.env("CARGO_TARGET_DIR", target_folder());
    match command.stdin(Stdio::null()).status()?.success() {
        true => Ok(()),
        false => Err("the program cannot be built for WASI".into()),
    }
}

/// The command with the compiler of rustup, which builds the standard library too where its sources can be had.
fn rustup(words: &[&str]) -> Command {
    let mut command = cargo(words);
    if has_sources() {
        build_standard_library(&mut command, "rustc");
    } else {
        println!("the sources of the standard library are not there: the module is larger than it could be");
    }
    command
}

/// Whether the sources of the standard library are there, or can be had.
fn has_sources() -> bool {
    let is_there = || {
        output(Command::new("rustc").args(["--print", "sysroot"]))
            .is_some_and(|folder| Path::new(folder.trim()).join(LIBRARY).is_file())
    };
    let add = || {
        let mut command = Command::new("rustup");
        command.args(["component", "add", "rust-src"]).stdin(Stdio::null());
        command.status().is_ok_and(|status| status.success())
    };
    is_there() || (add() && is_there())
}

/// Builds the standard library with the program: without what is said of a panic, which ends the program as it would anyway and is said by the
/// page, and with shorter ways to sort. `RUSTC_BOOTSTRAP` lets a stable compiler do so.
fn build_standard_library(command: &mut Command, rustc: &str) {
    let flags = |panic| format!("-Zunstable-options -Cpanic={panic} -Zlocation-detail=none");
    let is_known = |panic| {
        let mut ask = Command::new(rustc);
        ask.args(flags(panic).split(' ')).args(["--print", "cfg"]).env("RUSTC_BOOTSTRAP", "1");
        output(ask.stderr(Stdio::null())).is_some()
    };
    // Compilers before 1.91 do not know it.
    let panic = if is_known("immediate-abort") { "immediate-abort" } else { "abort" };
    command.args(["-Zbuild-std=std,panic_abort", "-Zbuild-std-features=optimize_for_size"]);
    command.env("RUSTC_BOOTSTRAP", "1").env("CARGO_TARGET_WASM32_WASIP1_RUSTFLAGS", flags(panic));
}

/// The command with the compiler of Debian, which builds the standard library, and a linker that finds the library of C.
fn debian(words: &[&str]) -> Result<Command, Box<dyn Error>> {
    const PACKAGES: &str = "rustc-web, cargo-web, rust-web-src, lld-19 and wasi-libc";
    let [cargo, rustc] = ["/usr/bin/cargo", "/usr/bin/rustc"].map(Path::new);
    let start = Path::new(WASI_LIBRARY).join("crt1-command.o");
    if !cargo.is_file() || !rustc.is_file() || !start.is_file() || on_path("wasm-ld-19").is_none() {
        return Err(format!(
            "rustup has no target {TARGET}; Debian's {PACKAGES} build it where they are installed"
        )
        .into());
    }
    fs::create_dir_all(target_folder())?;
    let linker = target_folder().join("wasm-ld.sh");
    fs::write(&linker, LINKER.replace("LIBRARY", WASI_LIBRARY))?;
    make_executable(&linker)?;
    let mut command = Command::new(cargo);
    command.args(words).current_dir(root());
    build_standard_library(&mut command, "/usr/bin/rustc");
    command.env("RUSTC", rustc).env("CARGO_TARGET_WASM32_WASIP1_LINKER", linker);
    command.env_remove("RUSTUP_TOOLCHAIN").env_remove("CARGO");
    Ok(command)
}

/// The linker of LLVM, told where the start file and the library of C are. What Debian's library of C lacks, threads, the page answers: there are none.
const LINKER: &str = r#"#!/bin/sh
for word do
    shift
    case $word in crt1-command.o) word=LIBRARY/crt1-command.o ;; esac
    set -- "$@" "$word"
done
exec wasm-ld-19 "$@" "-LLIBRARY" --import-undefined
"#;

#[cfg(unix)]
fn make_executable(path: &Path) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    fs::set_permissions(path, fs::Permissions::from_mode(0o755))
}

#[cfg(not(unix))]
fn make_executable(_: &Path) -> std::io::Result<()> {
    Ok(())
}

/// The module after `wasm-opt`, which the packages of the viewer have: smaller, and functions of one name beside each other, where gzip finds
/// what they have in common.
fn smaller(module: &Path) -> Result<Vec<u8>, Box<dyn Error>> {
    let path = target_folder().join("smaller.wasm");
    let features = [
        "--enable-bulk-memory",
        "--enable-nontrapping-float-to-int",
        "--enable-sign-ext",
        "--enable-mutable-globals",
        "--enable-multivalue",
        "--enable-reference-types",
    ];
    let mut command = Command::new(root().join("viewer/node_modules/.bin/wasm-opt"));
    command.args(features).args(["-Oz", "--reorder-functions-by-name", "--strip-debug", "--strip-producers"]);
    match command.arg(module).arg("-o").arg(&path).status()?.success() {
        true => Ok(fs::read(path)?),
        false => Err("wasm-opt fails".into()),
    }
}

/// The module as gzip, which browsers unpack, by the packer that makes the least of it.
fn packed(module: &[u8]) -> Result<Vec<u8>, Box<dyn Error>> {
    let mut packed = Vec::new();
    zopfli::compress(zopfli::Options::default(), zopfli::Format::Gzip, module, &mut packed)?;
    Ok(packed)
}
