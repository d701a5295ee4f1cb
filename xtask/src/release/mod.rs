//! Releases: one version everywhere, packages of the crates, and archives of the program.

mod archive;
mod materials;
mod packing;
mod version;

use crate::root;
use std::error::Error;
use std::process::{Command, ExitCode, Stdio};
use std::str::FromStr;

/// Whatever goes wrong, for people.
type Outcome<T> = Result<T, Box<dyn Error>>;

/// `cargo xtask release X.Y.Z`.
pub(crate) fn release(words: &[String]) -> ExitCode {
    ended("release", released(words))
}

/// `cargo xtask package`.
pub(crate) fn package(words: &[String]) -> ExitCode {
    ended("package", known(words, &["--verify", "--allow-dirty"]).and_then(|()| packing::package(words)))
}

/// `cargo xtask archive`.
pub(crate) fn archive(words: &[String]) -> ExitCode {
    ended("archive", known(words, &["--no-build"]).and_then(|()| archive::archive(!words.is_empty())))
}

fn released(words: &[String]) -> Outcome<()> {
    let (mut wanted, mut date, mut may_be_dirty) = (None, None, false);
    let mut rest = words.iter();
    while let Some(word) = rest.next() {
        match word.as_str() {
            "--date" => date = Some(rest.next().ok_or("--date needs a day: --date 2026-12-01")?.clone()),
            "--allow-dirty" => may_be_dirty = true,
            _ if wanted.is_none() => {
                let found = semver::Version::from_str(word);
                wanted = Some(found.map_err(|error| format!("\"{word}\" is no version ({error}): 0.2.0"))?);
            }
            _ => return Err(format!("what is {word}? cargo xtask release X.Y.Z [--date YYYY-MM-DD]").into()),
        }
    }
    let wanted = wanted.ok_or("which version? cargo xtask release X.Y.Z")?;
    if !may_be_dirty && !said(Command::new("git").args(["status", "--porcelain"]))?.is_empty() {
        return Err("there are changes that are not committed; commit them, or add --allow-dirty".into());
    }
    let date = match date {
        Some(date) => date,
        None => said(Command::new("git").args(["log", "-1", "--format=%cs"]))?.trim().to_owned(),
    };
    version::set(&wanted, &date)
}

/// Refuses words that are none of these.
fn known(words: &[String], options: &[&str]) -> Outcome<()> {
    match words.iter().find(|word| !options.contains(&word.as_str())) {
        None => Ok(()),
        Some(word) => Err(format!("what is {word}? There are {}", options.join(", ")).into()),
    }
}

fn ended(name: &str, outcome: Outcome<()>) -> ExitCode {
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("{name}: {error}");
            ExitCode::FAILURE
        }
    }
}

/// What a command in the root of the repository prints; an error unless it succeeds.
fn said(command: &mut Command) -> Outcome<String> {
    let name = command.get_program().to_string_lossy().into_owned();
    let output = command.current_dir(root()).stdin(Stdio::null()).stderr(Stdio::inherit()).output();
    let output = output.map_err(|error| format!("{name} cannot be run: {error}"))?;
    if !output.status.success() {
        return Err(format!("{name} failed").into());
    }
    Ok(String::from_utf8(output.stdout)?)
}
