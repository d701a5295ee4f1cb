//! `cargo xtask targets`: the program for other systems and processors. It is checked for each of them; with `--run` what can be linked and run on
//! this machine is: the program for Windows under Wine, and the arithmetic of another processor under an emulator.

use crate::tally::Tally;
use crate::test::check;
use crate::viewer::{on_path, output};
use crate::{cargo, root};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};

/// Another system or processor.
struct Target {
    name: &'static str,
    /// What is run of it, if anything.
    run: Option<Run>,
}

/// How tests for another system are linked and run, and which.
struct Run {
    linker: &'static str,
    /// The programs that run others, the first that is there, with their words.
    runners: &'static [(&'static str, &'static [&'static str])],
    /// Where they come from.
    packages: &'static str,
    crates: &'static [&'static str],
}

const TARGETS: &[Target] = &[
    Target {
        name: "x86_64-pc-windows-gnu",
        run: Some(Run {
            linker: "x86_64-w64-mingw32-gcc",
            runners: &[("wine", &[]), ("wine64", &[]), ("/usr/lib/wine/wine64", &[])],
            packages: "gcc-mingw-w64-x86-64 and wine",
            crates: &["coface-io", "coface-cli"],
        }),
    },
    Target {
        name: "aarch64-unknown-linux-gnu",
        run: Some(Run {
            linker: "aarch64-linux-gnu-gcc",
            runners: &[("qemu-aarch64", &["-L", "/usr/aarch64-linux-gnu"])],
            packages: "gcc-aarch64-linux-gnu, libc6-dev-arm64-cross and qemu-user",
            crates: &["coface-algebra", "coface-geometry"],
        }),
    },
    Target { name: "aarch64-apple-darwin", run: None },
    Target { name: "wasm32-wasip1", run: None },
];

/// Checks all targets, or the one that is named; runs what can be run of them if that is asked for.
pub(crate) fn targets(words: &[String]) -> ExitCode {
    let (mut is_run, mut only) = (false, None);
    for word in words {
        match word.as_str() {
            "--run" => is_run = true,
            name if TARGETS.iter().any(|target| target.name == name) => only = Some(name),
            _ => {
                let names: Vec<&str> = TARGETS.iter().map(|target| target.name).collect();
                eprintln!("usage: cargo xtask targets [--run] [TARGET]; TARGET is {}", names.join(", "));
                return ExitCode::from(2);
            }
        }
    }
    let mut tally = Tally::default();
    for target in TARGETS.iter().filter(|target| only.is_none_or(|name| name == target.name)) {
        target.check(&mut tally);
        if let Some(run) = target.run.as_ref().filter(|_| is_run) {
            run.tests(target.name, &mut tally);
        }
    }
    println!("{}{}", tally.to_text(), tally.to_line());
    if tally.failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

impl Target {
    fn check(&self, tally: &mut Tally) {
        if !is_installed(self.name) {
            tally.skip(self.name, "rustup has no such target, and cannot fetch it");
            return;
        }
        let mut command = cargo(&["check", "--quiet", "--package", "coface-cli", "--target", self.name]);
        check(tally, self.name, command.env("CARGO_TARGET_DIR", folder()));
    }
}

impl Run {
    fn tests(&self, target: &str, tally: &mut Tally) {
        let is_there = |program: &str| Path::new(program).is_file() || on_path(program).is_some();
        let runner = self.runners.iter().find(|(program, _)| is_there(program));
        let (Some((program, own)), true) = (runner, is_installed(target) && is_there(self.linker)) else {
            tally.skip(
                &format!("tests for {target}"),
                &format!("{} run them where they are installed", self.packages),
            );
            return;
        };
        let mut words =
            vec!["test", "--quiet", "--no-fail-fast", "--lib", "--bins", "--tests", "--target", target];
        words.extend(self.crates.iter().flat_map(|name| ["--package", name]));
        let mut command = cargo(&words);
        let variable =
            |what: &str| format!("CARGO_TARGET_{}_{what}", target.to_uppercase().replace('-', "_"));
        command.env(variable("LINKER"), self.linker);
        command.env(variable("RUNNER"), [&[*program], *own].concat().join(" "));
        // An emulator says nothing about what is not meant.
        command.env("CARGO_TARGET_DIR", folder()).env("WINEDEBUG", "-all").env_remove("COFACE_DATA");
        if program.contains("wine")
            && let Some(libraries) = self.libraries()
        {
            command.env("WINEPATH", format!("Z:{}", libraries.display().to_string().replace('/', "\\")));
        }
        check(tally, &format!("tests for {target}"), &mut command);
    }

    /// A folder with the library that Rust takes random numbers from, which Wine has had since version 8.5 only. It is looked for there last.
    fn libraries(&self) -> Option<PathBuf> {
        let place = folder().join("wine");
        let (source, library) = (place.join("prng.c"), place.join("bcryptprimitives.dll"));
        if !library.is_file() {
            std::fs::create_dir_all(&place).ok()?;
            std::fs::write(&source, PRNG).ok()?;
            let mut compiler = Command::new(self.linker);
            compiler.args(["-shared", "-o"]).arg(&library).arg(&source).arg("-ladvapi32");
            compiler.status().ok().filter(std::process::ExitStatus::success)?;
        }
        Some(place)
    }
}

/// Random bytes as Windows 10 gives them, by what older systems have.
const PRNG: &str = "#include <windows.h>
#include <ntsecapi.h>
__declspec(dllexport) BOOL WINAPI ProcessPrng(PBYTE bytes, SIZE_T count) { return RtlGenRandom(bytes, (ULONG)count); }
";

/// Whether the standard library for a target is there, or can be fetched.
pub(crate) fn is_installed(target: &str) -> bool {
    output(Command::new("rustc").args(["--print", "target-libdir", "--target", target]))
        .is_some_and(|folder| Path::new(folder.trim()).is_dir())
        || Command::new("rustup")
            .args(["target", "add", target])
            .stdin(Stdio::null())
            .status()
            .is_ok_and(|status| status.success())
}

/// A build folder of its own: other flags would make everything be built again.
fn folder() -> PathBuf {
    root().join("target/targets")
}
