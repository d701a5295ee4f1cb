//! What the packages that we depend on are: their licences, where they come from, and which are there twice.

use crate::cargo;
use crate::tally::Tally;
use crate::test::check;
use serde_json::Value;
use std::collections::BTreeMap;
use std::process::{Command, Stdio};

/// Licences that may be linked with ours.
const LICENCES: &[&str] = &[
    "MIT",
    "Apache-2.0",
    "Apache-2.0 WITH LLVM-exception",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "BSL-1.0",
    "CC0-1.0",
    "ISC",
    "Unicode-3.0",
    "Unlicense",
    "Zlib",
    "0BSD",
    "MIT-0",
    "bzip2-1.0.6",
];

/// Packages that may be there in two versions, as those who need them have not met yet; the same as in `deny.toml`.
const TWICE: &[&str] = &["cpufeatures", "getrandom", "miniz_oxide", "syn"];

/// Asks `cargo deny` where it is installed, and looks by ourselves else.
pub(crate) fn packages(tally: &mut Tally) {
    let has_deny =
        Command::new("cargo-deny").arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    if has_deny.is_ok_and(|status| status.success()) {
        // Advisories come over the network, which a check must not need.
        check(tally, "packages", &mut cargo(&["deny", "--offline", "check", "bans", "licenses", "sources"]));
        return;
    }
    let begin = std::time::Instant::now();
    println!("== packages: cargo metadata (cargo-deny is not installed)");
    let faults = metadata().map_or_else(|fault| vec![fault], |metadata| faults(&metadata));
    for fault in &faults {
        println!("{fault}");
    }
    tally.count(faults.is_empty());
    if !faults.is_empty() {
        tally.fail("packages", &faults);
    }
    println!("== packages: {} faults in {:.0} s", faults.len(), begin.elapsed().as_secs_f64());
}

/// What cargo knows of the packages for this kind of machine; those for others may not be here, and a check must not need the network.
fn metadata() -> Result<Value, String> {
    let output = Command::new("rustc").arg("-vV").output().map_err(|error| format!("rustc: {error}"))?;
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    let host = text.lines().find_map(|line| line.strip_prefix("host: ")).ok_or("rustc -vV names no host")?;
    let words = ["metadata", "--format-version", "1", "--filter-platform", host];
    let output = cargo(&words).stderr(Stdio::inherit()).output();
    let output = output.map_err(|error| format!("cargo metadata: {error}"))?;
    serde_json::from_slice(&output.stdout).map_err(|error| format!("cargo metadata: {error}"))
}

/// What is wrong with the packages that `cargo metadata` lists.
fn faults(metadata: &Value) -> Vec<String> {
    let mut faults = Vec::new();
    let mut versions: BTreeMap<&str, Vec<&str>> = BTreeMap::new();
    let packages = metadata.get("packages").and_then(Value::as_array);
    for package in packages.into_iter().flatten() {
        let text = |key: &str| package.get(key).and_then(Value::as_str);
        let (Some(name), Some(version)) = (text("name"), text("version")) else {
            faults.push("cargo metadata: a package without a name or a version".to_owned());
            continue;
        };
        versions.entry(name).or_default().push(version);
        match text("license") {
            Some(licence) if is_allowed(licence) => {}
            Some(licence) => {
                faults.push(format!("{name} {version}: the licence {licence} is not in the list"));
            }
            None => faults.push(format!("{name} {version}: no licence")),
        }
        if let Some(source) = text("source").filter(|source| !source.starts_with("registry+")) {
            faults.push(format!("{name} {version}: comes from {source}, which is no registry"));
        }
    }
    if versions.is_empty() {
        faults.push("cargo metadata: no packages".to_owned());
    }
    for (name, versions) in versions {
        if versions.len() > 1 && !TWICE.contains(&name) {
            faults.push(format!("{name}: there are the versions {}", versions.join(" and ")));
        }
    }
    faults
}

/// Whether one of the choices of an SPDX expression has only licences of the list.
fn is_allowed(expression: &str) -> bool {
    let text = expression.replace('/', " OR ").replace(['(', ')'], " ");
    // `(A OR B) AND C` without its brackets: every part that stands between `AND`s needs one choice that is allowed.
    text.split(" AND ").all(|part| part.split(" OR ").any(|licence| LICENCES.contains(&licence.trim())))
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn cargo_deny_reads_the_same_lists() {
        let text = std::fs::read_to_string(crate::root().join("deny.toml")).expect("deny.toml");
        let list = |key: &str| {
            let (_, rest) = text.split_once(&format!("\n{key} = [")).expect("the key is there");
            let (list, _) = rest.split_once(']').expect("the list ends");
            list.split('"').skip(1).step_by(2).map(str::to_owned).collect::<Vec<_>>()
        };
        assert_eq!(list("allow"), LICENCES);
        assert_eq!(list("skip"), TWICE);
    }

    #[test]
    fn one_choice_of_licences_has_to_be_in_the_list() {
        assert!(is_allowed("MIT OR GPL-3.0"));
        assert!(is_allowed("MIT/Apache-2.0"));
        assert!(is_allowed("(MIT OR Apache-2.0) AND Unicode-3.0"));
        assert!(!is_allowed("GPL-3.0-only"));
        assert!(!is_allowed("MIT AND GPL-3.0-only"));
    }

    #[test]
    fn faults_name_the_package() {
        let package = |name: &str, version: &str, licence: &str, source: &str| json!({"name": name, "version": version, "license": licence, "source": source});
        let metadata = json!({"packages": [
            package("a", "1.0.0", "MIT", "registry+x"),
            package("a", "2.0.0", "MIT", "registry+x"),
            package("b", "1.0.0", "GPL-2.0", "registry+x"),
            package("c", "1.0.0", "MIT", "git+x"),
        ]});
        let found = faults(&metadata);
        assert_eq!(found.len(), 3);
        assert!(
            found[0].contains("b 1.0.0")
                && found[1].contains("c 1.0.0")
                && found[2].contains("1.0.0 and 2.0.0")
        );
    }
}
