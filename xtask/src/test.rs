//! `cargo xtask test`: everything that a change must pass.

use crate::python::python;
use crate::tally::Tally;
use crate::viewer::viewer;
use crate::{cargo, root};
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::time::Instant;

/// Runs every check to the end, says what is skipped and why, and closes with the counts.
pub(crate) fn run() -> ExitCode {
    let begin = Instant::now();
    let mut tally = Tally::default();
    check(&mut tally, "format", &mut cargo(&["fmt", "--all", "--check"]));
    // All at once: with other features everything would be built again. The lints and the types do not need the library.
    let lints =
        [&["clippy", "--quiet", "--workspace", "--all-targets"], &GRAPHBLAS[..], &["--", "-D", "warnings"]];
    check(&mut tally, "lints", &mut cargo(&lints.concat()));
    let mut docs = cargo(&["doc", "--quiet", "--workspace", "--no-deps"]);
    check(&mut tally, "docs", docs.env("RUSTDOCFLAGS", "-D warnings"));
    graphblas(&mut tally);
    let all = [&["test", "--workspace", "--no-fail-fast"], features()].concat();
    run_counted(&mut tally, "tests", cargo(&all));
    viewer(&mut tally);
    python(&mut tally);
    guide(&mut tally);
    readme(&mut tally);
    skips(&mut tally);
    println!("\n{:.0} s in all", begin.elapsed().as_secs_f64());
    println!("{}", tally.to_line());
    if tally.failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

pub(crate) fn check(tally: &mut Tally, name: &str, command: &mut Command) {
    println!("== {name}: {}", words(command));
    let begin = Instant::now();
    let has_passed = match command.stdin(Stdio::null()).status() {
        Ok(status) => status.success(),
        Err(error) => {
            println!("cannot run: {error}");
            false
        }
    };
    tally.count(has_passed);
    println!("== {name}: {} in {:.0} s", verdict(has_passed), begin.elapsed().as_secs_f64());
}

/// The pages of the guide: each example checks its own answers. The tests before this have built them.
fn guide(tally: &mut Tally) {
    let folder = root().join("crates/coface/examples");
    let mut pages: Vec<String> = std::fs::read_dir(&folder)
        .into_iter()
        .flatten()
        .filter_map(|entry| Some(entry.ok()?.path().file_stem()?.to_str()?.to_owned()))
        .collect();
    pages.sort();
    for page in pages {
        check(tally, &page, &mut built(&format!("examples/{page}")));
    }
}

/// A program that the tests have built.
pub(crate) fn built(name: &str) -> Command {
    let folder = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from);
    let mut command =
        Command::new(folder.join("debug").join(name).with_extension(std::env::consts::EXE_EXTENSION));
    command.current_dir(root());
    command
}

/// Many tests in one command, which says how many passed; all are run even when some fail.
pub(crate) fn run_counted(tally: &mut Tally, name: &str, mut command: Command) {
    println!("== {name}: {}", words(&command));
    let begin = Instant::now();
    let mut counts = Tally::default();
    let mut is_done = false;
    match command.stdin(Stdio::null()).stdout(Stdio::piped()).spawn() {
        Ok(mut child) => {
            for line in child
                .stdout
                .take()
                .into_iter()
                .flat_map(|pipe| BufReader::new(pipe).lines())
                .map_while(Result::ok)
            {
                println!("{line}");
                counts.add_line(&line);
            }
            is_done = child.wait().is_ok_and(|status| status.success());
        }
        Err(error) => println!("cannot run: {error}"),
    }
    // Tests that do not compile, or do not run at all, give no count.
    if counts.failed == 0 && (!is_done || counts.passed == 0) {
        counts.failed = 1;
    }
    println!("== {name}: {} in {:.0} s", counts.to_line(), begin.elapsed().as_secs_f64());
    tally.passed += counts.passed;
    tally.failed += counts.failed;
    tally.skipped += counts.skipped;
}

/// The tests that need the C library GraphBLAS.
const GRAPHBLAS: [&str; 2] = ["--features", "coface-arrange/graphblas-tests,coface-graphblas/installed"];

/// Sees to it that the C library GraphBLAS is there, where that is possible.
fn graphblas(tally: &mut Tally) {
    if !has_graphblas() {
        install_package("libgraphblas-dev");
    }
    if !has_graphblas() {
        println!(
            "== skipped: tests of graphblas (the package libgraphblas-dev is not installed, and cannot be)"
        );
        tally.skipped += 1;
    }
}

/// The features that everything is built with: all whose libraries are there.
pub(crate) fn features() -> &'static [&'static str] {
    if has_graphblas() { &GRAPHBLAS } else { &[] }
}

/// Whether the linker finds the library: the compiler prints a path for a file that it knows, and the bare name else.
fn has_graphblas() -> bool {
    let output = Command::new("cc").arg("-print-file-name=libgraphblas.so").output();
    output.is_ok_and(|output| String::from_utf8_lossy(&output.stdout).contains('/'))
}

/// Installs a package on a system with apt, as root; else nothing happens.
pub(crate) fn install_package(name: &str) {
    let user = Command::new("id").arg("-u").output();
    if !user.is_ok_and(|output| output.stdout.trim_ascii() == b"0") {
        return;
    }
    let apt = |words: &[&str]| {
        let mut command = Command::new("apt-get");
        command.args(words).env("DEBIAN_FRONTEND", "noninteractive").stdin(Stdio::null());
        command.status().is_ok_and(|status| status.success())
    };
    let install = ["install", "-y", "-q", "--no-install-recommends", name];
    println!("== {name}: apt-get {}", install.join(" "));
    if !apt(&install) && apt(&["update", "-q"]) {
        apt(&install);
    }
}

/// Runs the commands that the README promises, with the program that the tests have built: building it once more with all optimizations takes
/// minutes and shows nothing.
fn readme(tally: &mut Tally) {
    let text = std::fs::read_to_string(root().join("README.md")).unwrap_or_default();
    let commands = promised_commands(&text);
    if commands.is_empty() {
        println!("== readme: failed, README.md has no line `cargo run --release -- ...`");
        tally.count(false);
    }
    for arguments in commands {
        promise(tally, built("coface").args(arguments));
    }
}

/// Runs a command that has to succeed and to print something.
fn promise(tally: &mut Tally, command: &mut Command) {
    println!("== readme: {}", words(command));
    let output = command.stdin(Stdio::null()).stderr(Stdio::inherit()).output();
    let has_passed = output.is_ok_and(|output| {
        print!("{}", String::from_utf8_lossy(&output.stdout));
        output.status.success() && !output.stdout.is_empty()
    });
    tally.count(has_passed);
    println!("== readme: {}", verdict(has_passed));
}

/// What a text says to the program about files of the repository: the words after `--`.
fn promised_commands(text: &str) -> Vec<Vec<&str>> {
    text.lines()
        .map(|line| line.trim().trim_start_matches("$ "))
        .filter(|line| line.starts_with("cargo run --release -- ") && line.contains("data/"))
        .filter(|line| !line.contains(['|', '>', '"', '\'', '`']))
        .map(|line| line.split(" #").next().unwrap_or(line).split_whitespace().skip(4).collect())
        .collect()
}

fn skips(tally: &mut Tally) {
    let mut skip = |what: &str, why: &str| {
        println!("== skipped: {what} ({why})");
        tally.skipped += 1;
    };
    match std::env::var_os("COFACE_DATA").map(PathBuf::from) {
        None => skip("tests on real files", "the environment variable COFACE_DATA names no folder"),
        Some(folder) if !folder.join("MANIFEST.json").is_file() => {
            skip("tests on real files", &format!("no MANIFEST.json in {}", folder.display()));
        }
        Some(_) => {}
    }
}

fn words(command: &Command) -> String {
    let arguments = command.get_args().map(|word| word.to_string_lossy());
    let program = Path::new(command.get_program()).file_stem().unwrap_or_default();
    std::iter::once(program.to_string_lossy()).chain(arguments).collect::<Vec<_>>().join(" ")
}

fn verdict(has_passed: bool) -> &'static str {
    if has_passed { "passed" } else { "failed" }
}

#[cfg(test)]
mod tests {
    use super::promised_commands;

    #[test]
    fn promised_commands_are_found() {
        let text = "Try\n```sh\n$ cargo run --release -- info data/spot.obj   # a report\ncargo run --release -- info mine.obj\n\
                    cargo run --release -- info --json data/spot.obj | jq .\n```\n";
        assert_eq!(promised_commands(text), [["info", "data/spot.obj"]]);
    }
}
