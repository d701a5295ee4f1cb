//! `cargo xtask answers`: what every verb answers on every file, kept in a folder and compared.
//!
//! A *run* is one call of the program with `--json`. Its record holds the exit status, the answer and the standard error. Records of two programs
//! are compared key by key: a change that is meant to keep all answers is checked against the program from before it.
//!
//! ```text
//! cargo xtask answers --write DIR --program OLD     the records of the old program
//! cargo xtask answers --against DIR                 runs the program of this checkout and prints every difference
//! ```

mod compare;
mod run;
mod table;

use crate::cargo;
use crate::test::built;
use compare::{Report, compare};
use run::{Record, Runner};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Duration;

/// The words of the command line.
#[derive(Debug)]
struct Request {
    folder: PathBuf,
    is_writing: bool,
    program: Option<PathBuf>,
    only: Option<String>,
    limit: Duration,
    jobs: usize,
}

impl Request {
    fn from_words(words: &[String]) -> Result<Self, String> {
        let (mut folder, mut program, mut only) = (None, None, None);
        let mut limit = Duration::from_secs(60);
        let mut jobs = std::thread::available_parallelism().map_or(2, usize::from);
        let mut rest = words.iter();
        while let Some(word) = rest.next() {
            let value = rest.next().ok_or_else(|| format!("{word} needs a value"))?;
            let number = || value.parse::<u64>().map_err(|_| format!("{word}: {value} is not a number"));
            match word.as_str() {
                "--write" => folder = Some((PathBuf::from(value), true)),
                "--against" => folder = Some((PathBuf::from(value), false)),
                "--program" => program = Some(PathBuf::from(value)),
                "--only" => only = Some(value.clone()),
                "--seconds" => limit = Duration::from_secs(number()?),
                "--jobs" => jobs = usize::try_from(number()?).unwrap_or(1).max(1),
                _ => return Err(format!("{word} is not an option of answers")),
            }
        }
        let (folder, is_writing) = folder.ok_or("give --write DIR or --against DIR")?;
        Ok(Self { folder, is_writing, program, only, limit, jobs })
    }
}

/// Writes the records, or compares with those of a folder.
pub(crate) fn answers(words: &[String]) -> ExitCode {
    let done = Request::from_words(words).and_then(|request| serve(&request));
    match done {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(fault) => {
            eprintln!("error: {fault}");
            ExitCode::from(2)
        }
    }
}

/// Whether all is as it was.
fn serve(request: &Request) -> Result<bool, String> {
    let program = program(request.program.as_deref())?;
    let scratch = std::env::temp_dir().join(format!("coface-answers-{}", std::process::id()));
    let made = std::fs::create_dir_all(&scratch).map_err(|error| format!("{}: {error}", scratch.display()));
    let outcome = made.and_then(|()| serve_in(request, &program, &scratch));
    // Nothing is lost if the folder stays.
    std::fs::remove_dir_all(&scratch).ok();
    outcome
}

fn serve_in(request: &Request, program: &Path, scratch: &Path) -> Result<bool, String> {
    let mut runs = table::runs(scratch)?;
    if let Some(word) = &request.only {
        runs.retain(|run| run.name().contains(word.as_str()));
    }
    println!("{} runs of {}", runs.len(), program.display());
    let runner = Runner { program, scratch, limit: request.limit };
    if request.is_writing {
        std::fs::create_dir_all(&request.folder)
            .map_err(|error| format!("{}: {error}", request.folder.display()))?;
        let failures = run::each(&runs, request.jobs, |run| {
            let record = runner.record(run)?;
            record.write(&request.folder.join(run.file_name()))
        });
        return failures.map(|()| true);
    }
    let report = std::sync::Mutex::new(Report::default());
    run::each(&runs, request.jobs, |run| {
        let path = request.folder.join(run.file_name());
        let lines = match Record::read(&path)? {
            Some(old) => compare(&run.name(), &old, &runner.record(run)?),
            None => compare::missing(&run.name()),
        };
        report.lock().map_err(|_| "a run panicked".to_owned())?.add(lines);
        Ok::<(), String>(())
    })?;
    let report = report.into_inner().map_err(|_| "a run panicked".to_owned())?;
    print!("{}", report.to_text());
    Ok(report.is_clean())
}

/// The program that was named, or that of this checkout, built as the tests build it.
fn program(named: Option<&Path>) -> Result<PathBuf, String> {
    let path = match named {
        Some(path) => path.to_owned(),
        None => {
            let status = cargo(&["build", "--quiet", "--package", "coface-cli"]).status();
            if !status.is_ok_and(|status| status.success()) {
                return Err("the program cannot be built".to_owned());
            }
            PathBuf::from(built("coface").get_program())
        }
    };
    path.canonicalize().map_err(|error| format!("{}: {error}", path.display()))
}

#[cfg(test)]
mod tests {
    use super::Request;

    #[test]
    fn a_request_names_one_folder() {
        let words = |text: &str| text.split(' ').map(str::to_owned).collect::<Vec<_>>();
        let request = Request::from_words(&words("--against old --seconds 5 --only pi1")).expect("a request");
        assert!(!request.is_writing);
        assert_eq!((request.limit.as_secs(), request.only.as_deref()), (5, Some("pi1")));
        assert!(Request::from_words(&words("--seconds 5")).is_err_and(|fault| fault.contains("--against")));
        assert!(Request::from_words(&words("--against")).is_err_and(|fault| fault.contains("a value")));
        assert!(
            Request::from_words(&words("--sideways x")).is_err_and(|fault| fault.contains("not an option"))
        );
    }
}
