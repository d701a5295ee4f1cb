//! A release of the Python package: the source distribution and the wheel for this machine, looked at by the tools of packagers.

use crate::root;
use crate::tally::Tally;
use crate::test::check;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode};
use std::{env, fs, io};

/// The manifest of what is compiled.
const MANIFEST: &str = "crates/coface-py/Cargo.toml";
/// What makes a source distribution, and looks at it.
const TOOLS: [&str; 2] = ["maturin>=1.9,<2", "twine>=6"];
/// What a wheel needs beside: a linker for old versions of the C library, and readers of wheels.
const WHEEL_TOOLS: [&str; 3] = ["ziglang>=0.13", "abi3audit>=0.0.11", "check-wheel-contents>=0.6"];
/// What each source distribution has.
const PARTS: [&str; 6] =
    ["Cargo.lock", "LICENSE-APACHE", "LICENSE-MIT", "PKG-INFO", "pyproject.toml", "python/coface/py.typed"];
/// The bytes that a wheel may have.
const LARGEST: u64 = 21 << 20;

/// Makes the source distribution, and the wheel too if it is wanted, which builds everything for release.
pub(crate) fn wheels(with_wheel: bool) -> ExitCode {
    let mut tally = Tally::default();
    if let Err(error) = prepare(&mut tally, with_wheel) {
        println!("== wheels: failed: {error}");
        tally.count(false);
    }
    if tally.failed == 0 {
        make(&mut tally, with_wheel);
    }
    println!("{}", tally.to_line());
    if tally.failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// Sees to it that there is an environment with the tools, and an empty folder for what is made.
fn prepare(tally: &mut Tally, with_wheel: bool) -> io::Result<()> {
    for folder in [dist(), unpacked()] {
        if folder.exists() {
            fs::remove_dir_all(&folder)?;
        }
        fs::create_dir_all(&folder)?;
    }
    if !program().is_file() {
        let environment = folder().join("environment");
        check(tally, "environment", Command::new("python3").args(["-m", "venv"]).arg(environment));
    }
    let tools = if with_wheel { &[&TOOLS[..], &WHEEL_TOOLS].concat() } else { &TOOLS[..] };
    let install = ["-m", "pip", "install", "--quiet", "--disable-pip-version-check"];
    check(tally, "tools", python(&install).args(tools));
    Ok(())
}

fn make(tally: &mut Tally, with_wheel: bool) {
    let out = dist().display().to_string();
    let sdist = ["-m", "maturin", "sdist", "--manifest-path", MANIFEST, "--out", &out];
    check(tally, "source distribution", &mut python(&sdist));
    if with_wheel {
        let mut build = python(&["-m", "maturin", "build", "--release", "--strip", "--locked"]);
        build.args(["--manifest-path", MANIFEST, "--out", &out]);
        if cfg!(target_os = "linux") {
            build.args(["--compatibility", "manylinux_2_28", "--zig"]);
        }
        check(tally, "wheel", &mut build);
    }
    let made = made();
    check(tally, "metadata", python(&["-m", "twine", "check", "--strict"]).args(&made));
    for file in &made {
        if file.extension().is_some_and(|extension| extension == "whl") {
            look_at_wheel(tally, file);
        } else {
            look_at_source(tally, file, with_wheel);
        }
    }
}

fn look_at_wheel(tally: &mut Tally, wheel: &Path) {
    let size = fs::metadata(wheel).map_or(u64::MAX, |facts| facts.len());
    println!("== wheel: {size} bytes, at most {LARGEST}");
    tally.count(size <= LARGEST);
    check(tally, "contents of the wheel", python(&["-m", "check_wheel_contents"]).arg(wheel));
    check(tally, "stable interface", python(&["-m", "abi3audit", "--strict", "--report"]).arg(wheel));
}

/// Whether a source distribution has its parts, and cargo takes the crates that are locked; if `with_check` is set, compiled with nothing but
/// vendored crates.
fn look_at_source(tally: &mut Tally, source: &Path, with_check: bool) {
    let folder = unpacked();
    check(tally, "unpacking", python(&["-m", "tarfile", "-e"]).arg(source).arg(&folder));
    let Some(top) = fs::read_dir(&folder).ok().and_then(|mut entries| Some(entries.next()?.ok()?.path()))
    else {
        println!("== source distribution: failed, it is empty");
        tally.count(false);
        return;
    };
    for part in PARTS {
        let is_there = top.join(part).is_file();
        if !is_there {
            println!("== source distribution: failed, {part} is not in it");
        }
        tally.count(is_there);
    }
    let cargo = |words: &[&str]| {
        let mut command = Command::new(env::var_os("CARGO").unwrap_or_else(|| "cargo".into()));
        command.args(words).current_dir(&top);
        command
    };
    // The lock is that of the whole repository: cargo leaves out what is not needed here, and may not choose anything else.
    let before = locked(&top);
    check(tally, "crates", &mut cargo(&["tree", "--quiet", "--package", "coface-py", "--depth", "0"]));
    let is_kept = locked(&top).is_subset(&before) && !before.is_empty();
    println!(
        "== crates: {}",
        if is_kept { "those that are locked" } else { "failed, others than those that are locked" }
    );
    tally.count(is_kept);
    if !with_check {
        return;
    }
    // Crates beside their source, and nothing else: what this prints is the configuration that says so.
    let vendored = cargo(&["vendor", "--locked"]).output();
    let is_written = vendored.as_ref().is_ok_and(|output| {
        let place = top.join(".cargo");
        output.status.success()
            && fs::create_dir_all(&place).is_ok()
            && fs::write(place.join("config.toml"), &output.stdout).is_ok()
    });
    tally.count(is_written);
    let words = ["check", "--offline", "--locked", "--quiet", "--package", "coface-py"];
    let mut offline = cargo(&words);
    // Nothing that was downloaded before is at hand either.
    offline.env("CARGO_TARGET_DIR", folder.join("target")).env("CARGO_HOME", folder.join("home"));
    check(tally, "compiling without a network", &mut offline);
}

/// Names and versions in the lock of a folder.
fn locked(folder: &Path) -> BTreeSet<String> {
    let text = fs::read_to_string(folder.join("Cargo.lock")).unwrap_or_default();
    let parts = text.split("[[package]]").skip(1);
    parts.map(|part| part.lines().filter(|line| line.contains(" = \"")).take(2).collect()).collect()
}

/// What stands in the folder of what is made.
fn made() -> Vec<PathBuf> {
    let mut found: Vec<PathBuf> =
        fs::read_dir(dist()).into_iter().flatten().filter_map(|entry| Some(entry.ok()?.path())).collect();
    found.sort();
    found
}

/// Python of the environment of tools, in the root of the repository, with the programs of that environment.
fn python(words: &[&str]) -> Command {
    let mut command = Command::new(program());
    let own = program().parent().map(Path::to_owned);
    let others = env::var_os("PATH").unwrap_or_default();
    let path = env::join_paths(own.into_iter().chain(env::split_paths(&others))).unwrap_or(others);
    command.args(words).current_dir(root()).env("PATH", path);
    command
}

fn program() -> PathBuf {
    folder().join(if cfg!(windows) { "environment/Scripts/python.exe" } else { "environment/bin/python" })
}

fn dist() -> PathBuf {
    folder().join("dist")
}

fn unpacked() -> PathBuf {
    folder().join("unpacked")
}

fn folder() -> PathBuf {
    env::var_os("CARGO_TARGET_DIR")
        .map_or_else(|| root().join("target"), PathBuf::from)
        .join("release-python")
}
