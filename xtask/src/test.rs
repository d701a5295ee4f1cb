//! `cargo xtask test`: everything that a change must pass.

use crate::packages::packages;
use crate::python::python;
use crate::tally::{Failures, Tally};
use crate::viewer::{browser, viewer};
use crate::{cargo, root};
use std::io::{BufRead, BufReader};
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, PoisonError};
use std::time::Instant;

/// Runs every check to the end, says what is skipped and why, and closes with the slowest stages and the counts.
///
/// Everything is built once, beside what needs no build. Then three lanes run side by side: the tests in Rust, those in Python and in a
/// browser, and the lints and docs with the examples in these, which are compiled one crate after the other. Lints and docs share the build
/// folder, and with it all macros and build scripts, which are a quarter of a build from nothing; so they start when the tests have been found
/// built and leave them the lock of that folder. In CI the compiler lints and documents what it builds, and of this lane the examples are left.
pub(crate) fn run() -> ExitCode {
    let begin = Instant::now();
    let mut tally = Tally::default();
    check(&mut tally, "format", &mut cargo(&["fmt", "--all", "--check"]));
    graphblas(&mut tally);
    let (has_built, has_begun) = (AtomicBool::new(false), Event::default());
    let building = |tally: &mut Tally| has_built.store(build(tally), Ordering::Relaxed);
    let beside = |tally: &mut Tally| {
        crate::python::prepare_early();
        viewer(tally);
        packages(tally);
        crate::advisories::check(tally);
        oldest_rust(tally);
    };
    side_by_side(&mut tally, &[&building, &beside]);
    let rust = |tally: &mut Tally| {
        let all = [&["test", "--workspace", "--no-fail-fast", "--tests"], features()].concat();
        run_counted(tally, "tests", cargo(&all), || has_begun.set());
        // Tests that were not found built did not begin.
        has_begun.set();
        guide(tally);
        readme(tally);
        crate::book::check(tally);
    };
    let others = |tally: &mut Tally| {
        python(tally);
        browser(tally);
    };
    let lints = |tally: &mut Tally| {
        has_begun.wait();
        if !is_linted_by_compiler() {
            lints_and_docs(tally);
        }
        let examples = [&["test", "--workspace", "--no-fail-fast", "--doc"], features()].concat();
        run_counted(tally, "examples in the docs", cargo(&examples), || ());
    };
    if has_built.into_inner() {
        side_by_side(&mut tally, &[&rust, &others, &lints]);
    } else {
        lints_and_docs(&mut tally);
    }
    skips(&mut tally);
    close(&tally, begin)
}

/// Something that happens once, which other threads wait for.
#[derive(Default)]
struct Event {
    has_happened: Mutex<bool>,
    change: Condvar,
}

impl Event {
    fn set(&self) {
        *self.has_happened.lock().unwrap_or_else(PoisonError::into_inner) = true;
        self.change.notify_all();
    }

    fn wait(&self) {
        let has_happened = self.has_happened.lock().unwrap_or_else(PoisonError::into_inner);
        drop(self.change.wait_while(has_happened, |has_happened| !*has_happened));
    }
}

/// Runs lanes at once, and adds up what they found.
fn side_by_side(tally: &mut Tally, lanes: &[&(dyn Fn(&mut Tally) + Sync)]) {
    let found: Vec<Tally> = std::thread::scope(|scope| {
        let run = |lane: &'_ (dyn Fn(&mut Tally) + Sync)| {
            let mut tally = Tally::default();
            lane(&mut tally);
            tally
        };
        let lanes: Vec<_> = lanes.iter().map(|lane| scope.spawn(move || run(*lane))).collect();
        lanes.into_iter().map(|lane| lane.join().unwrap_or_else(|_| Tally::of_panic())).collect()
    });
    found.into_iter().for_each(|lane| tally.add(lane));
}

/// Lints and docs of everything. With the same features as the tests: with others everything would be built again.
fn lints_and_docs(tally: &mut Tally) {
    let lints = ["clippy", "--quiet", "--workspace", "--all-targets"];
    check(tally, "lints", &mut cargo(&[&lints[..], features(), &["--", "-D", "warnings"]].concat()));
    check(tally, "docs", docs(&mut cargo(&["doc", "--quiet", "--workspace", "--no-deps"])));
}

/// Builds everything that a test runs; whether that went well.
pub(crate) fn build(tally: &mut Tally) -> bool {
    let all = [&["build", "--quiet", "--workspace", "--lib", "--bins", "--tests", "--examples"], features()];
    let (has_passed, said) = checked(tally, "build", &mut cargo(&all.concat()));
    if has_passed && is_linted_by_compiler() {
        let is_clean = !said.contains("warning");
        tally.count(is_clean);
        if !is_clean {
            tally.fail("lints and docs", &said.lines().map(str::to_owned).collect::<Vec<_>>());
        }
        println!("== lints and docs: {}, with the build", verdict(is_clean));
    }
    has_passed
}

/// Whether the compiler lints and documents what it builds, and says what it finds as warnings: `.ci/rustc` does.
fn is_linted_by_compiler() -> bool {
    let wrapper = std::env::var_os("RUSTC_WORKSPACE_WRAPPER");
    wrapper.is_some_and(|wrapper| Path::new(&wrapper).ends_with(".ci/rustc"))
}

/// Runs the checks of one crate: format, lints, docs, tests.
pub(crate) fn run_crate(name: &str) -> ExitCode {
    let begin = Instant::now();
    let mut tally = Tally::default();
    check(&mut tally, "format", &mut cargo(&["fmt", "--package", name, "--check"]));
    run_counted(&mut tally, "tests", cargo(&["test", "--no-fail-fast", "--package", name]), || ());
    let lints = ["clippy", "--quiet", "--all-targets", "--package", name, "--", "-D", "warnings"];
    check(&mut tally, "lints", &mut cargo(&lints));
    check(&mut tally, "docs", docs(&mut cargo(&["doc", "--quiet", "--no-deps", "--package", name])));
    skips(&mut tally);
    close(&tally, begin)
}

/// Prints the end of a run.
fn close(tally: &Tally, begin: Instant) -> ExitCode {
    println!("\n{}{:.0} s in all", tally.to_text(), begin.elapsed().as_secs_f64());
    println!("{}", tally.to_line());
    if tally.failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// The docs as they are published: without warnings, and with formulas set where there is a network.
fn docs(command: &mut Command) -> &mut Command {
    let header = root().join(HEADER).display().to_string();
    command.env("CARGO_ENCODED_RUSTDOCFLAGS", ["-D", "warnings", "--html-in-header", &header].join("\u{1f}"))
}

/// What stands in the head of each page of the docs.
const HEADER: &str = "docs/katex-header.html";

/// Whether the oldest Rust that `Cargo.toml` promises builds everything. Where it is not installed, the lint `incompatible_msrv`, which is on
/// in all crates, still finds what the standard library did not have then.
fn oldest_rust(tally: &mut Tally) {
    let manifest = std::fs::read_to_string(root().join("Cargo.toml")).unwrap_or_default();
    let version = manifest
        .lines()
        .find_map(|line| line.strip_prefix("rust-version = "))
        .unwrap_or_default()
        .trim_matches('"');
    let installed = Command::new("rustup").args(["toolchain", "list"]).output();
    let has_it = installed.is_ok_and(|output| {
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        text.lines().any(|line| line.strip_prefix(version).is_some_and(|rest| rest.starts_with(['-', '.'])))
    });
    if !has_it {
        tally.skip(
            &format!("a build with Rust {version}"),
            "rustup has no such toolchain; the lint incompatible_msrv was on",
        );
        return;
    }
    let mut build = Command::new("rustup");
    build.args(["run", version, "cargo", "check", "--quiet", "--workspace"]).current_dir(root());
    build.env_remove("CARGO").env_remove("RUSTUP_TOOLCHAIN").env_remove("RUSTC");
    check(tally, &format!("Rust {version}"), &mut build);
}

/// Runs a command and prints what it says when it has ended: lanes do not mix their lines.
pub(crate) fn check(tally: &mut Tally, name: &str, command: &mut Command) {
    checked(tally, name, command);
}

/// The same; whether all went well, and what was said.
fn checked(tally: &mut Tally, name: &str, command: &mut Command) -> (bool, String) {
    println!("== {name}: {}", words(command));
    let begin = Instant::now();
    let (has_passed, said) = match command.stdin(Stdio::null()).output() {
        Ok(output) => (
            output.status.success(),
            [String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr)].concat(),
        ),
        Err(error) => (false, format!("cannot run: {error}\n")),
    };
    let seconds = begin.elapsed().as_secs_f64();
    tally.count(has_passed);
    tally.time(name, seconds);
    if !has_passed {
        let lines: Vec<String> = said.lines().map(str::to_owned).collect();
        tally.fail(name, &lines);
    }
    println!("{said}== {name}: {} in {seconds:.0} s", verdict(has_passed));
    (has_passed, said)
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

/// The build folder.
pub(crate) fn target() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from)
}

/// A program that the tests have built.
pub(crate) fn built(name: &str) -> Command {
    let mut command =
        Command::new(target().join("debug").join(name).with_extension(std::env::consts::EXE_EXTENSION));
    command.current_dir(root());
    command
}

/// Many tests in one command, which says how many passed; all are run even when some fail.
/// `begun` is called when the first of them starts, and cargo has done its part.
pub(crate) fn run_counted(tally: &mut Tally, name: &str, command: Command, begun: impl Fn()) {
    println!("== {name}: {}", words(&command));
    let begin = Instant::now();
    let mut counts = Tally::default();
    let mut failures = Failures::default();
    let is_done = follow(command, &mut counts, &mut failures, begun).unwrap_or_else(|error| {
        println!("cannot run: {error}");
        false
    });
    // Tests that do not compile, or do not run at all, give no count.
    if counts.failed == 0 && (!is_done || counts.passed == 0) {
        counts.failed = 1;
    }
    let seconds = begin.elapsed().as_secs_f64();
    println!("== {name}: {} in {seconds:.0} s", counts.to_line());
    if counts.failed > 0 {
        counts.fail(name, &failures.into_lines());
    }
    counts.time(name, seconds);
    tally.add(counts);
}

/// Runs tests, prints what they say, and keeps the time of each program. Whether all went well.
fn follow(
    mut command: Command,
    counts: &mut Tally,
    failures: &mut Failures,
    begun: impl Fn(),
) -> std::io::Result<bool> {
    // One pipe for both: cargo says on standard error which program it runs, and the program on standard output how long it took.
    let (reader, writer) = std::io::pipe()?;
    command.stdin(Stdio::null()).stdout(writer.try_clone()?).stderr(writer);
    let mut child = command.spawn()?;
    // The command has ends of the pipe, which would stay open.
    drop(command);
    let (mut program, mut package) = (String::new(), String::new());
    for line in BufReader::new(reader).lines().map_while(Result::ok) {
        println!("{line}");
        counts.add_line(&line);
        failures.add_line(&line);
        let words = line.trim();
        if let Some(what) =
            words.strip_prefix("Running ").or_else(|| words.strip_prefix("Doc-tests ").map(|_| words))
        {
            program = named(what, &mut package);
            begun();
        }
        let time = line.strip_prefix("test result: ").and_then(|rest| rest.rsplit_once("finished in "));
        if let Some(seconds) = time.and_then(|(_, time)| time.trim_end_matches('s').parse().ok()) {
            counts.time(&program, seconds);
        }
    }
    Ok(child.wait()?.success())
}

/// A program of tests by its crate: cargo says `unittests src/lib.rs (target/debug/deps/coface_io-0123456789abcdef)`. Behind it follow the other tests of
/// the same crate, whose programs have names of their own.
fn named(what: &str, package: &mut String) -> String {
    let Some((target, path)) = what.split_once(" (") else { return what.to_owned() };
    let file =
        Path::new(path.trim_end_matches(')')).file_name().unwrap_or_default().to_string_lossy().into_owned();
    match target.strip_prefix("unittests ") {
        Some(source) => {
            file.rsplit_once('-').map_or(file.as_str(), |(name, _)| name).clone_into(package);
            format!("{package}: {source}")
        }
        None => format!("{package}: {target}"),
    }
}

/// All features: those of the tests that need the C library GraphBLAS, and those that are not in the default build of the program.
const GRAPHBLAS: [&str; 2] =
    ["--features", "coface-cli/arrow,coface-arrange/graphblas-tests,coface-graphblas/installed"];

/// The features that need no library and are not in the default build of the program.
const OPTIONAL: [&str; 2] = ["--features", "coface-cli/arrow"];

/// Sees to it that the C library GraphBLAS is there, where that is possible.
fn graphblas(tally: &mut Tally) {
    if !has_graphblas() {
        install_package("libgraphblas-dev");
    }
    if !has_graphblas() {
        tally.skip("tests of graphblas", "the package libgraphblas-dev is not installed, and cannot be");
    }
}

/// The features that everything is built with: all whose libraries are there.
pub(crate) fn features() -> &'static [&'static str] {
    if has_graphblas() { &GRAPHBLAS } else { &OPTIONAL }
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
    let what = "tests on real files";
    match std::env::var_os("COFACE_DATA").map(PathBuf::from) {
        None => tally.skip(what, "the environment variable COFACE_DATA names no folder"),
        Some(folder) if !folder.join("MANIFEST.json").is_file() => {
            tally.skip(what, &format!("no MANIFEST.json in {}", folder.display()));
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
    use super::{named, promised_commands};

    #[test]
    fn programs_are_named_by_their_crate() {
        let mut package = String::new();
        for (what, name) in [
            ("unittests src/lib.rs (target/debug/deps/coface_io-0123456789abcdef)", "coface_io: src/lib.rs"),
            (
                "tests/suite/main.rs (target/debug/deps/suite-0123456789abcdef)",
                "coface_io: tests/suite/main.rs",
            ),
            ("Doc-tests coface_io", "Doc-tests coface_io"),
        ] {
            assert_eq!(named(what, &mut package), name);
        }
    }

    #[test]
    fn promised_commands_are_found() {
        let text = "Try\n```sh\n$ cargo run --release -- info data/spot.obj   # a report\ncargo run --release -- info mine.obj\n\
                    cargo run --release -- info --json data/spot.obj | jq .\n```\n";
        assert_eq!(promised_commands(text), [["info", "data/spot.obj"]]);
    }
}
