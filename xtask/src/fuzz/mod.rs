//! `cargo xtask fuzz`: builds the fuzz targets with the nightly toolchain and runs them one after the other.
//!
//! Each target starts from its corpus in `fuzz/corpus`. What it finds on top, and the inputs that break a promise, go to the folder `fuzz` of the
//! build folder, where the next run goes on.

mod log;

use crate::root;
use log::{Findings, read_log};
use std::collections::VecDeque;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};

const USAGE: &str = "usage: cargo xtask fuzz --minutes N [--target NAME].. [--jobs N] [--sanitizer NAME]
  --minutes N       the time for all targets together, divided evenly
  --target NAME     this target alone; may be given several times
  --jobs N          so many targets at a time [1]
  --sanitizer NAME  builds with a sanitizer, such as `address`: slower, and worth it after a change of unsafe code";

/// No input is longer than this.
const MOST_LENGTH: usize = 64 << 10;
/// No input of that length takes so many seconds.
const MOST_SECONDS: u64 = 5;
/// No run takes so many MiB. A single allocation fails long before: see `fuzz/src/lib.rs`.
const MOST_MEMORY: usize = 1024;

#[derive(Debug, PartialEq)]
struct Request {
    minutes: f64,
    targets: Vec<String>,
    jobs: usize,
    sanitizer: Option<String>,
}

impl Request {
    fn from_words(words: &[String]) -> Result<Self, String> {
        let mut request = Self { minutes: 0.0, targets: Vec::new(), jobs: 1, sanitizer: None };
        let mut rest = words.iter();
        while let Some(word) = rest.next() {
            let value = rest.next().ok_or_else(|| format!("{word} needs a value"))?;
            let wrong = || format!("{word}: {value} is not a number above 0");
            match word.as_str() {
                "--minutes" => {
                    let minutes =
                        value.parse().ok().filter(|&minutes: &f64| minutes > 0.0 && minutes.is_finite());
                    request.minutes = minutes.ok_or_else(wrong)?;
                }
                "--jobs" => request.jobs = value.parse().ok().filter(|&jobs| jobs > 0).ok_or_else(wrong)?,
                "--target" => request.targets.push(value.clone()),
                "--sanitizer" => request.sanitizer = Some(value.clone()),
                _ => return Err(format!("{word} is not an option of fuzz")),
            }
        }
        if request.minutes == 0.0 { Err("give --minutes N".to_owned()) } else { Ok(request) }
    }
}

/// Builds and runs the targets; fails if one of them has found a fault.
pub(crate) fn fuzz(words: &[String]) -> ExitCode {
    let request = match Request::from_words(words) {
        Ok(request) => request,
        Err(fault) => {
            eprintln!("error: {fault}\n{USAGE}");
            return ExitCode::from(2);
        }
    };
    match run(&request) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(fault) => {
            eprintln!("error: {fault}");
            ExitCode::FAILURE
        }
    }
}

/// Whether no target has found a fault.
fn run(request: &Request) -> Result<bool, String> {
    let manifest = root().join("fuzz/Cargo.toml");
    let text =
        std::fs::read_to_string(&manifest).map_err(|error| format!("{}: {error}", manifest.display()))?;
    let all = target_names(&text);
    if let Some(unknown) = request.targets.iter().find(|name| !all.contains(&name.as_str())) {
        return Err(format!("there is no fuzz target {unknown}; there are {}", all.join(", ")));
    }
    let is_chosen =
        |name: &&str| request.targets.is_empty() || request.targets.iter().any(|chosen| chosen == name);
    let chosen: Vec<&str> = all.into_iter().filter(is_chosen).collect();
    let programs = build(request, &chosen)?;
    let seconds = (request.minutes * 60.0 * request.jobs as f64 / chosen.len() as f64).max(1.0) as u64;
    println!("{} targets, {seconds} s each", chosen.len());
    println!("{}", Findings::HEADER);
    let waiting = Mutex::new(VecDeque::from(chosen));
    let is_clean = AtomicBool::new(true);
    let faults = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..request.jobs {
            scope.spawn(|| {
                loop {
                    let next = waiting.lock().expect("no thread panics with the lock").pop_front();
                    let Some(name) = next else { break };
                    let findings = run_target(name, &programs, seconds);
                    println!("{}", findings.to_line(name));
                    if let Some(fault) = findings.fault {
                        is_clean.store(false, Ordering::Relaxed);
                        faults
                            .lock()
                            .expect("no thread panics with the lock")
                            .push(format!("{name}: {fault}"));
                    }
                }
            });
        }
    });
    for fault in faults.into_inner().expect("no thread panics with the lock") {
        println!("\n{fault}");
    }
    Ok(is_clean.into_inner())
}

/// The targets that a manifest lists.
fn target_names(manifest: &str) -> Vec<&str> {
    let sections = manifest.split("[[bin]]").skip(1);
    let names = sections.filter_map(|section| section.lines().find_map(|line| line.strip_prefix("name = ")));
    names.map(|name| name.trim().trim_matches('"')).collect()
}

/// What the compiler is told so that libFuzzer sees which branches an input takes and what it is compared with.
const COVERAGE: [&str; 7] = [
    "-Cpasses=sancov-module",
    "-Cllvm-args=-sanitizer-coverage-level=4",
    "-Cllvm-args=-sanitizer-coverage-inline-8bit-counters",
    "-Cllvm-args=-sanitizer-coverage-pc-table",
    "-Cllvm-args=-sanitizer-coverage-trace-compares",
    "--cfg=fuzzing",
    "-Cdebug-assertions",
];

/// Builds the targets; gives the folder of the programs.
fn build(request: &Request, targets: &[&str]) -> Result<PathBuf, String> {
    let version = Command::new("rustup").args(["run", "nightly", "rustc", "-vV"]).output();
    let version = version.ok().filter(|output| output.status.success()).ok_or(
        "fuzzing needs the nightly toolchain (for coverage): rustup toolchain install nightly --profile minimal",
    )?;
    let version = String::from_utf8_lossy(&version.stdout).into_owned();
    let host =
        version.lines().find_map(|line| line.strip_prefix("host: ")).ok_or("rustc does not name its host")?;
    let folder = match &request.sanitizer {
        None => folder(),
        Some(sanitizer) => folder().join(sanitizer),
    };
    let mut flags: Vec<String> = COVERAGE.map(str::to_owned).to_vec();
    flags.extend(request.sanitizer.as_ref().map(|sanitizer| format!("-Zsanitizer={sanitizer}")));
    let mut command = Command::new("rustup");
    command.args(["run", "nightly", "cargo", "build", "--release", "--target", host, "--manifest-path"]);
    command.arg(root().join("fuzz/Cargo.toml")).arg("--target-dir").arg(&folder);
    command.args(targets.iter().flat_map(|name| ["--bin", name]));
    // The toolchain that runs this task must not choose the compiler.
    for name in ["CARGO", "RUSTUP_TOOLCHAIN", "RUSTC", "RUSTFLAGS"] {
        command.env_remove(name);
    }
    command.env("CARGO_ENCODED_RUSTFLAGS", flags.join("\u{1f}"));
    match command.status() {
        Ok(status) if status.success() => Ok(folder.join(host).join("release")),
        Ok(_) => Err("the fuzz targets do not build".to_owned()),
        Err(error) => Err(format!("rustup cannot be run: {error}")),
    }
}

/// Where programs, what is found, and faults go: the build folder is no part of the repository.
fn folder() -> PathBuf {
    let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), PathBuf::from);
    target.join("fuzz")
}

/// Runs one target for some time.
fn run_target(name: &str, programs: &Path, seconds: u64) -> Findings {
    let found = folder().join("corpus").join(name);
    let artifacts = folder().join("artifacts").join(name);
    for folder in [&found, &artifacts] {
        if let Err(error) = std::fs::create_dir_all(folder) {
            return Findings::of_fault(format!("{}: {error}", folder.display()));
        }
    }
    let mut command = Command::new(programs.join(name));
    command.arg(&found).arg(root().join("fuzz/corpus").join(name));
    command.arg(format!("-artifact_prefix={}/", artifacts.display()));
    command.args([format!("-max_total_time={seconds}"), format!("-max_len={MOST_LENGTH}")]);
    command.args([format!("-timeout={MOST_SECONDS}"), format!("-rss_limit_mb={MOST_MEMORY}")]);
    command.args(["-print_final_stats=1", "-report_slow_units=100"]);
    let words = root().join("fuzz/words").join(name).with_extension("txt");
    if words.is_file() {
        command.arg(format!("-dict={}", words.display()));
    }
    match command.current_dir(root()).stdin(Stdio::null()).stdout(Stdio::null()).output() {
        Ok(output) => read_log(&String::from_utf8_lossy(&output.stderr), output.status.success()),
        Err(error) => Findings::of_fault(format!("cannot be run: {error}")),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn words(text: &str) -> Vec<String> {
        text.split_whitespace().map(str::to_owned).collect()
    }

    #[test]
    fn requests_are_parsed() {
        let request =
            Request::from_words(&words("--minutes 0.5 --target read_off --target read_obj --jobs 2"))
                .unwrap();
        assert_eq!((request.minutes, request.jobs), (0.5, 2));
        assert_eq!(request.targets, ["read_off", "read_obj"]);
        for wrong in ["", "--jobs 2", "--minutes", "--minutes 0", "--minutes soon", "--minutes 1 --all x"] {
            assert!(Request::from_words(&words(wrong)).is_err(), "{wrong}");
        }
    }

    #[test]
    fn targets_of_a_manifest_are_found() {
        let manifest = "[package]\nname = \"fuzz\"\n\n[[bin]]\nname = \"read_off\"\npath = \"a.rs\"\n\n[[bin]]\nname = \"read_obj\"\n";
        assert_eq!(target_names(manifest), ["read_off", "read_obj"]);
    }
}
