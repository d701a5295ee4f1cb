//! One version everywhere.

use super::{Outcome, said};
use crate::{cargo, root};
use semver::Version;
use std::fs;

/// Puts the version into every file that names it, and the date into the changelog and the citation.
pub(super) fn set(wanted: &Version, date: &str) -> Outcome<()> {
    check_date(date)?;
    let manifest = fs::read_to_string(root().join("Cargo.toml"))?;
    let now = current(&manifest)?;
    // The first release of a version that was never tagged keeps its number.
    if *wanted < now {
        return Err(format!("the version is {now}, and {wanted} is before it").into());
    }
    let changelog = fs::read_to_string(root().join("CHANGELOG.md"))?;
    let citation = fs::read_to_string(root().join("CITATION.cff"))?;
    let recipe = fs::read_to_string(root().join("packaging/conda/recipe.yaml"))?;
    let viewer = fs::read_to_string(root().join("viewer/package.json"))?;
    // Here the version stands first of all, and again with the package itself, before all others.
    let lock = fs::read_to_string(root().join("viewer/package-lock.json"))?;
    let in_json = |text: &str| quoted(text, "\"version\": ", &now, wanted);
    // All new texts first: nothing is written if one of them fails.
    let texts = [
        ("Cargo.toml", of_manifest(&manifest, &now, wanted)),
        ("CHANGELOG.md", of_changelog(&changelog, wanted, date)?),
        ("CITATION.cff", of_citation(&citation, wanted, date)),
        ("packaging/conda/recipe.yaml", quoted(&recipe, "version: ", &now, wanted)),
        ("viewer/package.json", in_json(&viewer)),
        ("viewer/package-lock.json", in_json(&in_json(&lock))),
    ];
    for (name, text) in texts {
        fs::write(root().join(name), text)?;
        println!("{name}: {now} -> {wanted}");
    }
    // Cargo.lock has the versions of our own crates.
    said(&mut cargo(&["update", "--workspace", "--quiet", "--offline"]))?;
    println!("Cargo.lock: made again");
    println!("\nNow: cargo xtask test && cargo xtask package --allow-dirty");
    println!("git commit -am \"release {wanted}\" && git tag -a v{wanted} -m \"coface {wanted}\"");
    println!("cargo publish --workspace, cargo xtask archive, cargo xtask python --wheel");
    Ok(())
}

fn check_date(date: &str) -> Outcome<()> {
    let parts: Vec<&str> = date.split('-').collect();
    let is_date = parts.iter().map(|part| part.len()).eq([4, 2, 2])
        && parts.iter().all(|part| part.bytes().all(|byte| byte.is_ascii_digit()));
    if is_date { Ok(()) } else { Err(format!("\"{date}\" is no day: 2026-12-01").into()) }
}

/// The version of the workspace.
pub(super) fn current(manifest: &str) -> Outcome<Version> {
    let section =
        manifest.split("[workspace.package]").nth(1).ok_or("Cargo.toml has no [workspace.package]")?;
    let line = section.lines().find_map(|line| line.strip_prefix("version = "));
    Ok(line.ok_or("[workspace.package] has no version")?.trim_matches('"').parse()?)
}

/// The manifest with another version of the workspace and of the crates that need each other.
fn of_manifest(manifest: &str, now: &Version, wanted: &Version) -> String {
    let [old, new] = [now, wanted].map(|version| format!("version = \"{version}\""));
    let lines = manifest.lines().map(|line| {
        let is_own = line == old || (line.starts_with("coface") && line.contains("path = "));
        if is_own { line.replace(&old, &new) } else { line.to_owned() }
    });
    lines.map(|line| line + "\n").collect()
}

/// The changelog where what is unreleased is this version.
fn of_changelog(changelog: &str, wanted: &Version, date: &str) -> Outcome<String> {
    const UNRELEASED: &str = "## [Unreleased]\n";
    if changelog.contains(&format!("\n## [{wanted}]")) {
        return Err(format!("CHANGELOG.md has a section {wanted} already").into());
    }
    let (before, after) =
        changelog.split_once(UNRELEASED).ok_or("CHANGELOG.md has no section [Unreleased]")?;
    let own = after.split("\n## [").next().unwrap_or_default();
    if own.trim().is_empty() {
        return Err("nothing is unreleased in CHANGELOG.md".into());
    }
    Ok(format!("{before}{UNRELEASED}\n## [{wanted}] - {date}\n{after}"))
}

/// A text with another version after the first key of this kind.
fn quoted(text: &str, key: &str, now: &Version, wanted: &Version) -> String {
    text.replacen(&format!("{key}\"{now}\""), &format!("{key}\"{wanted}\""), 1)
}

/// The citation with version and date.
fn of_citation(citation: &str, wanted: &Version, date: &str) -> String {
    let lines = citation.lines().filter(|line| !line.starts_with("date-released:"));
    let new = lines.flat_map(|line| match line.starts_with("version:") {
        true => vec![format!("version: {wanted}"), format!("date-released: {date}")],
        false => vec![line.to_owned()],
    });
    new.map(|line| line + "\n").collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_manifest_names_the_version_of_our_own_crates_alone() {
        let text = "[workspace.package]\nversion = \"0.1.0\"\n\n[workspace.dependencies]\n\
                    coface-io = { path = \"crates/coface-io\", version = \"0.1.0\" }\nother = { version = \"0.1.0\" }\n";
        let [old, new] = ["0.1.0", "0.2.0"].map(|version| version.parse().unwrap());
        assert_eq!(current(text).unwrap(), old);
        let found = of_manifest(text, &old, &new);
        assert_eq!(current(&found).unwrap(), new);
        assert!(
            found.contains("coface-io\", version = \"0.2.0\"")
                && found.contains("other = { version = \"0.1.0\" }")
        );
    }

    #[test]
    fn a_changelog_gets_a_section() {
        let text = "# Changelog\n\n## [Unreleased]\n\n### Added\n- more\n\n## [0.1.0] - 2026-11-22\n- all\n";
        let version = "0.2.0".parse().unwrap();
        let found = of_changelog(text, &version, "2026-12-01").unwrap();
        assert!(found.contains("## [Unreleased]\n\n## [0.2.0] - 2026-12-01\n\n### Added\n- more"), "{found}");
        assert!(
            of_changelog(&found, &"0.3.0".parse().unwrap(), "2026-12-02").is_err(),
            "nothing is unreleased"
        );
        assert!(of_changelog(&found, &version, "2026-12-02").is_err(), "there is such a section");
        assert!(check_date("1.12.2026").is_err() && check_date("2026-12-01").is_ok());
    }

    #[test]
    fn a_citation_has_one_date() {
        let text = "cff-version: 1.2.0\nversion: 0.1.0\ntitle: coface\n";
        let version = "0.2.0".parse().unwrap();
        let found = of_citation(&of_citation(text, &version, "2026-12-01"), &version, "2026-12-02");
        assert_eq!(found, "cff-version: 1.2.0\nversion: 0.2.0\ndate-released: 2026-12-02\ntitle: coface\n");
    }
}
