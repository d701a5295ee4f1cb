//! `cargo xtask wild DIR`: what `coface info` says to the files of a folder that others made.

use std::collections::{BTreeMap, BTreeSet};
use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

const USAGE: &str = "usage: cargo xtask wild DIR.. [--program PATH] [--seconds N] [--jobs N] [--all]
  runs `coface info` on every file below the folders and counts what is read, and what is refused for which reason
  --program PATH  the program to run; without it the one in the target folder is built
  --seconds N     a file that takes longer is refused [60]
  --jobs N        so many files at a time [2]
  --all           lists every file that is refused, not one for each reason";

/// What was said to one file.
enum Outcome {
    /// It was read, with these remarks by their codes.
    Read(Vec<String>),
    /// It was refused with this message.
    Refused(String),
}

struct Request {
    folders: Vec<PathBuf>,
    program: Option<PathBuf>,
    seconds: u64,
    jobs: usize,
    lists_all: bool,
}

pub(crate) fn wild(words: &[String]) -> ExitCode {
    let Some(request) = parse(words) else {
        eprintln!("{USAGE}");
        return ExitCode::from(2);
    };
    let Some(program) = request.program.clone().or_else(build) else {
        eprintln!("the program does not build");
        return ExitCode::FAILURE;
    };
    let mut files = Vec::new();
    for folder in &request.folders {
        if let Err(error) = add_files(folder, &mut files) {
            eprintln!("{}: {error}", folder.display());
            return ExitCode::FAILURE;
        }
    }
    files.sort();
    let next = AtomicUsize::new(0);
    let outcomes = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..request.jobs {
            scope.spawn(|| {
                while let Some(file) = files.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let outcome = examine(&program, file, Duration::from_secs(request.seconds));
                    outcomes.lock().expect("no thread panics with the lock").push((file.clone(), outcome));
                }
            });
        }
    });
    let mut outcomes = outcomes.into_inner().expect("no thread panics with the lock");
    outcomes.sort_by(|(a, _), (b, _)| a.cmp(b));
    print!("{}", summary(&outcomes, request.lists_all));
    ExitCode::SUCCESS
}

fn parse(words: &[String]) -> Option<Request> {
    let mut request = Request { folders: Vec::new(), program: None, seconds: 60, jobs: 2, lists_all: false };
    let mut words = words.iter();
    while let Some(word) = words.next() {
        match word.as_str() {
            "--program" => request.program = Some(words.next()?.into()),
            "--seconds" => request.seconds = words.next()?.parse().ok()?,
            "--jobs" => request.jobs = words.next()?.parse().ok().filter(|&jobs| jobs > 0)?,
            "--all" => request.lists_all = true,
            word if word.starts_with("--") => return None,
            folder => request.folders.push(folder.into()),
        }
    }
    (!request.folders.is_empty()).then_some(request)
}

/// Builds the program; gives its path.
pub(crate) fn build() -> Option<PathBuf> {
    let words = ["build", "--quiet", "--package", "coface-cli"];
    if !crate::cargo(&words).status().is_ok_and(|status| status.success()) {
        return None;
    }
    let target =
        std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| crate::root().join("target"), PathBuf::from);
    Some(target.join("debug").join(format!("coface{}", std::env::consts::EXE_SUFFIX)))
}

/// The files below the folders of a command line `DIR.. [--program PATH]`, and the program to try them with, which is built if none is named.
/// What is wrong is printed.
pub(crate) fn files_and_program(words: &[String], usage: &str) -> Result<(Vec<PathBuf>, PathBuf), ExitCode> {
    let (mut folders, mut program) = (Vec::new(), None);
    let mut words = words.iter();
    while let Some(word) = words.next() {
        match word.as_str() {
            "--program" => program = words.next().map(PathBuf::from),
            word if word.starts_with("--") => folders.clear(),
            folder => folders.push(PathBuf::from(folder)),
        }
    }
    if folders.is_empty() {
        eprintln!("{usage}");
        return Err(ExitCode::from(2));
    }
    let Some(program) = program.or_else(build) else {
        eprintln!("the program does not build");
        return Err(ExitCode::FAILURE);
    };
    let mut files = Vec::new();
    for folder in &folders {
        if let Err(error) = add_files(folder, &mut files) {
            eprintln!("{}: {error}", folder.display());
            return Err(ExitCode::FAILURE);
        }
    }
    Ok((files, program))
}

/// Adds the regular files below a folder; links are not followed.
fn add_files(folder: &Path, files: &mut Vec<PathBuf>) -> std::io::Result<()> {
    for entry in std::fs::read_dir(folder)? {
        let entry = entry?;
        let kind = entry.file_type()?;
        if kind.is_dir() {
            add_files(&entry.path(), files)?;
        } else if kind.is_file() {
            files.push(entry.path());
        }
    }
    Ok(())
}

/// Runs the program on one file.
fn examine(program: &Path, file: &Path, limit: Duration) -> Outcome {
    let child = Command::new(program)
        .args(["info", "--json", "--quiet"])
        .arg(file)
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn();
    let Ok(mut child) = child else { return Outcome::Refused("the program does not start".to_owned()) };
    let mut streams = (child.stdout.take(), child.stderr.take());
    let output = std::thread::spawn(move || read_all(streams.0.as_mut()));
    let errors = std::thread::spawn(move || read_all(streams.1.as_mut()));
    let start = Instant::now();
    let status = loop {
        match child.try_wait() {
            Ok(Some(status)) => break Some(status),
            Ok(None) if start.elapsed() < limit => std::thread::sleep(Duration::from_millis(2)),
            _ => {
                let _ = child.kill();
                let _ = child.wait();
                break None;
            }
        }
    };
    let (output, errors) = (output.join().unwrap_or_default(), errors.join().unwrap_or_default());
    match status {
        None => Outcome::Refused(format!("takes longer than {} s", limit.as_secs())),
        Some(status) if status.success() => Outcome::Read(codes(&output)),
        Some(_) => {
            let message = errors.lines().find(|line| !line.trim().is_empty()).unwrap_or("no message");
            Outcome::Refused(message.to_owned())
        }
    }
}

fn read_all(stream: Option<&mut impl Read>) -> String {
    let mut bytes = Vec::new();
    if let Some(stream) = stream {
        let _ = stream.read_to_end(&mut bytes);
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// The codes of the remarks of an answer.
fn codes(answer: &str) -> Vec<String> {
    let answer: serde_json::Value = serde_json::from_str(answer).unwrap_or_default();
    let remarks = answer["remarks"].as_array().cloned().unwrap_or_default();
    let codes: BTreeSet<String> =
        remarks.iter().filter_map(|remark| remark["code"].as_str().map(str::to_owned)).collect();
    codes.into_iter().collect()
}

/// The message without what is of one file alone: its name, its numbers, and what it quotes.
fn cause(message: &str, file: &Path) -> String {
    let message = message.replace(&file.display().to_string(), "");
    let message = message.trim_start_matches("error:").trim_start_matches([' ', ':']);
    let (mut cause, mut is_quoted) = (String::new(), false);
    for c in message.chars() {
        match c {
            '"' => {
                is_quoted = !is_quoted;
                cause.push(c);
            }
            _ if is_quoted => {}
            c if c.is_ascii_digit() => {
                if !cause.ends_with('#') {
                    cause.push('#');
                }
            }
            c => cause.push(c),
        }
    }
    cause
}

/// How many files were read, with which remarks, and how many were refused, with an example for each reason.
fn summary(outcomes: &[(PathBuf, Outcome)], lists_all: bool) -> String {
    let mut read = 0;
    let mut kinds: BTreeMap<String, (usize, usize)> = BTreeMap::new();
    let mut remarks: BTreeMap<&str, usize> = BTreeMap::new();
    let mut causes: BTreeMap<String, Vec<(&Path, &str)>> = BTreeMap::new();
    for (file, outcome) in outcomes {
        let extension =
            file.extension().map_or_else(String::new, |e| e.to_string_lossy().to_ascii_lowercase());
        let kind = kinds.entry(extension).or_default();
        kind.1 += 1;
        match outcome {
            Outcome::Read(codes) => {
                read += 1;
                kind.0 += 1;
                codes.iter().for_each(|code| *remarks.entry(code).or_default() += 1);
            }
            Outcome::Refused(message) => {
                causes.entry(cause(message, file)).or_default().push((file, message));
            }
        }
    }
    let mut text = format!("{read} of {} files are read\n", outcomes.len());
    for (extension, (read, count)) in kinds {
        let name = if extension.is_empty() { "no extension".to_owned() } else { format!(".{extension}") };
        text += &format!("  {read:>5} of {count:>5}  {name}\n");
    }
    if !remarks.is_empty() {
        text += "files with remarks, by code\n";
        remarks.iter().for_each(|(code, count)| text += &format!("  {count:>5}  {code}\n"));
    }
    let mut causes: Vec<(String, Vec<(&Path, &str)>)> = causes.into_iter().collect();
    causes.sort_by_key(|(_, files)| std::cmp::Reverse(files.len()));
    if !causes.is_empty() {
        text += "files that are refused, by reason\n";
    }
    for (_, files) in causes {
        let shown = if lists_all { files.len() } else { 1 };
        for (i, (file, message)) in files.iter().take(shown).enumerate() {
            let count = if i == 0 { files.len().to_string() } else { String::new() };
            let message = message.replace(&file.display().to_string(), "FILE");
            text += &format!("  {count:>5}  {message}\n         {}\n", file.display());
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refusals_are_counted_by_their_reason() {
        let refused = |name: &str, line: u32| {
            let message = format!("error: {name}: line {line}: \"x{line}\" is not a number");
            (PathBuf::from(name), Outcome::Refused(message))
        };
        let outcomes = [
            refused("a/1.off", 3),
            refused("a/2.off", 14),
            (PathBuf::from("a/3.OFF"), Outcome::Read(vec!["repeated-vertex".to_owned()])),
            (PathBuf::from("b/4"), Outcome::Refused("takes longer than 60 s".to_owned())),
        ];
        let text = summary(&outcomes, false);
        assert!(text.starts_with("1 of 4 files are read\n"), "{text}");
        assert!(
            text.contains("      1 of     3  .off\n") && text.contains("      1  repeated-vertex\n"),
            "{text}"
        );
        assert!(
            text.contains("      2  error: FILE: line 3: \"x3\" is not a number\n         a/1.off\n"),
            "{text}"
        );
        assert!(!text.contains("a/2.off") && summary(&outcomes, true).contains("a/2.off"));
        assert_eq!(cause("error: f: at 12: \"a 3\"", Path::new("f")), "at #: \"\"");
    }

    #[test]
    fn options_are_read() {
        let words = |text: &str| text.split(' ').map(str::to_owned).collect::<Vec<_>>();
        let request = parse(&words("a --seconds 5 b --all --program p")).unwrap();
        assert_eq!((request.folders.len(), request.seconds, request.lists_all), (2, 5, true));
        for bad in ["--all", "a --jobs 0", "a --what", "a --program"] {
            assert!(parse(&words(bad)).is_none(), "{bad}");
        }
    }
}
