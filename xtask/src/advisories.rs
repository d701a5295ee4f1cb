//! Known faults of the packages that we depend on: `advisories.txt` is a snapshot of the RustSec advisory database, so that a check needs no
//! network. `cargo xtask advisories DIR` makes it anew from a checkout of the database.

use crate::root;
use crate::tally::Tally;
use semver::{Version, VersionReq};
use std::fmt::Write;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;

const USAGE: &str = "usage: cargo xtask advisories [DIR]
  says which packages of Cargo.lock have known faults; with the folder of a checkout of the RustSec advisory database it
  makes the snapshot xtask/advisories.txt anew first";

/// Advisories that do not concern us, with the reason.
const ACCEPTED: &[(&str, &str)] = &[];

/// A known fault of a package.
struct Advisory {
    id: String,
    package: String,
    /// What has the fault no more, and what never had it.
    sound: Vec<VersionReq>,
    title: String,
}

pub(crate) fn advisories(words: &[String]) -> ExitCode {
    let renewed = match words {
        [] => Ok(()),
        [folder] if !folder.starts_with('-') => renew(Path::new(folder)),
        _ => {
            eprintln!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    let found = renewed.and_then(|()| faults());
    match found {
        Ok(faults) => {
            faults.iter().for_each(|fault| println!("{fault}"));
            if faults.is_empty() { ExitCode::SUCCESS } else { ExitCode::FAILURE }
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

/// The check as a part of all tests.
pub(crate) fn check(tally: &mut Tally) {
    let found = faults().unwrap_or_else(|error| vec![error]);
    found.iter().for_each(|fault| println!("{fault}"));
    tally.count(found.is_empty());
    if !found.is_empty() {
        tally.fail("advisories", &found);
    }
    println!("== advisories: {} packages with known faults", found.len());
}

fn snapshot() -> PathBuf {
    root().join("xtask/advisories.txt")
}

fn faults() -> Result<Vec<String>, String> {
    let read =
        |path: PathBuf| fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()));
    let advisories = parse(&read(snapshot())?)?;
    Ok(faults_of(&packages(&read(root().join("Cargo.lock"))?)?, &advisories))
}

fn faults_of(packages: &[(String, Version)], advisories: &[Advisory]) -> Vec<String> {
    let mut faults = Vec::new();
    for advisory in advisories {
        let is_accepted = ACCEPTED.iter().any(|(id, _)| *id == advisory.id);
        for (name, version) in packages.iter().filter(|(name, _)| *name == advisory.package && !is_accepted) {
            if !advisory.sound.iter().any(|requirement| requirement.matches(version)) {
                faults.push(format!("{name} {version}: {}: {}", advisory.id, advisory.title));
            }
        }
    }
    faults
}

/// The packages of a lock file that come from a registry.
fn packages(lock: &str) -> Result<Vec<(String, Version)>, String> {
    let value = |block: &str, key: &str| -> Option<String> {
        let line = block.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(" = \""))?;
        line.strip_suffix('"').map(str::to_owned)
    };
    let mut found = Vec::new();
    for block in lock.split("[[package]]").filter(|block| value(block, "source").is_some()) {
        let name = value(block, "name").ok_or("Cargo.lock has a package without a name")?;
        let version = value(block, "version").ok_or_else(|| format!("{name} has no version"))?;
        let version = version.parse().map_err(|error| format!("{name} {version}: {error}"))?;
        found.push((name, version));
    }
    Ok(found)
}

/// The lines of the snapshot: identifier, package, what is sound, title, with tabs between them.
fn parse(text: &str) -> Result<Vec<Advisory>, String> {
    let lines = text.lines().filter(|line| !line.starts_with('#'));
    lines.map(|line| advisory(line).ok_or_else(|| format!("advisories.txt: no advisory: {line}"))).collect()
}

fn advisory(line: &str) -> Option<Advisory> {
    let mut fields = line.split('\t');
    let (id, package, sound, title) = (fields.next()?, fields.next()?, fields.next()?, fields.next()?);
    let sound = sound.split(" | ").filter(|one| !one.is_empty()).map(|one| VersionReq::parse(one).ok());
    let sound = sound.collect::<Option<Vec<VersionReq>>>()?;
    Some(Advisory { id: id.to_owned(), package: package.to_owned(), sound, title: title.to_owned() })
}

/// Makes the snapshot anew from `crates/*/*.md` of the database.
fn renew(folder: &Path) -> Result<(), String> {
    let fault = |path: &Path, error: std::io::Error| format!("{}: {error}", path.display());
    let mut lines = Vec::new();
    let crates = folder.join("crates");
    for package in fs::read_dir(&crates).map_err(|error| fault(&crates, error))?.flatten() {
        for file in fs::read_dir(package.path()).map_err(|error| fault(&package.path(), error))?.flatten() {
            let path = file.path();
            let text = fs::read_to_string(&path).map_err(|error| fault(&path, error))?;
            if let Some(line) = line_of(&path.file_stem().unwrap_or_default().to_string_lossy(), &text) {
                lines.push(line);
            }
        }
    }
    if lines.is_empty() {
        return Err(format!("{} has no advisories", crates.display()));
    }
    lines.sort();
    let mut text = String::from(
        "# Identifiers, packages, sound versions and titles of the RustSec advisory database; made by `cargo xtask advisories DIR`.\n",
    );
    for line in lines {
        let _ = writeln!(text, "{line}");
    }
    fs::write(snapshot(), text).map_err(|error| fault(&snapshot(), error))
}

/// The line of an advisory; `None` if it was withdrawn.
fn line_of(id: &str, text: &str) -> Option<String> {
    let front = text.split("```").nth(1)?;
    let package = front.lines().find_map(|line| line.strip_prefix("package = \""))?.strip_suffix('"')?;
    if front.lines().any(|line| line.starts_with("withdrawn")) {
        return None;
    }
    let list = |key: &str| -> Vec<String> {
        let start = front.lines().position(|line| line.starts_with(&format!("{key} = [")));
        let rest =
            start.map_or_else(String::new, |start| front.lines().skip(start).collect::<Vec<_>>().join(" "));
        let inside =
            rest.split_once('[').and_then(|(_, rest)| rest.split_once(']')).map_or("", |(inside, _)| inside);
        inside.split('"').skip(1).step_by(2).map(str::to_owned).collect()
    };
    let sound = [list("patched"), list("unaffected")].concat().join(" | ");
    let title = text.lines().find_map(|line| line.strip_prefix("# ")).unwrap_or_default().replace('\t', " ");
    Some(format!("{id}\t{package}\t{sound}\t{title}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "```toml\n[advisory]\nid = \"RUSTSEC-2025-0002\"\npackage = \"fast-float2\"\n[versions]\n\
                        patched = [\">= 0.2.2\"]\nunaffected = [\n    \"< 0.1.0\",\n]\n```\n# Segmentation fault\n";

    #[test]
    fn versions_with_faults_are_named() {
        let line = line_of("RUSTSEC-2025-0002", TEXT).unwrap();
        assert_eq!(line, "RUSTSEC-2025-0002\tfast-float2\t>= 0.2.2 | < 0.1.0\tSegmentation fault");
        let advisories = parse(&format!("# comment\n{line}\n")).unwrap();
        let lock = |version: &str| {
            format!("[[package]]\nname = \"fast-float2\"\nversion = \"{version}\"\nsource = \"registry\"\n")
        };
        for (version, count) in [("0.2.1", 1), ("0.2.2", 0), ("0.0.9", 0), ("0.1.0", 1)] {
            let packages = packages(&lock(version)).unwrap();
            assert_eq!(faults_of(&packages, &advisories).len(), count, "{version}");
        }
    }

    #[test]
    fn the_snapshot_is_read_and_our_packages_are_sound() {
        let advisories = parse(&fs::read_to_string(snapshot()).unwrap()).unwrap();
        assert!(advisories.len() > 1000, "{}", advisories.len());
        assert_eq!(faults().unwrap(), Vec::<String>::new());
    }
}
