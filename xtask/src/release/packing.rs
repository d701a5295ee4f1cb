//! The packages of the crates: packed as for a registry, and looked at.

use super::{Outcome, said, version};
use crate::test::target;
use crate::{cargo, root};
use serde_json::Value;
use std::fs;
use std::process::Command;

/// What each package has.
const PARTS: [&str; 4] = ["Cargo.toml", "LICENSE-APACHE", "LICENSE-MIT", "README.md"];

/// The bytes that a package may have.
const LARGEST: u64 = 10 << 20;

/// Packs all crates that are published, and looks at them.
pub(super) fn package(words: &[String]) -> Outcome<()> {
    let has = |option: &str| words.iter().any(|word| word == option);
    let mut pack = cargo(&["publish", "--dry-run", "--workspace", "--quiet"]);
    if !has("--verify") {
        pack.arg("--no-verify");
    }
    if has("--allow-dirty") {
        pack.arg("--allow-dirty");
    }
    let folder = target().join("release-packages");
    pack.env("CARGO_TARGET_DIR", &folder);
    said(&mut pack)?;
    let own = version::current(&fs::read_to_string(root().join("Cargo.toml"))?)?;
    let metadata: Value =
        serde_json::from_str(&said(&mut cargo(&["metadata", "--format-version", "1", "--no-deps"]))?)?;
    let mut faults = Vec::new();
    let mut count = 0;
    for package in metadata["packages"].as_array().into_iter().flatten() {
        // An empty list: published nowhere.
        if package["publish"].as_array().is_some_and(Vec::is_empty) {
            continue;
        }
        count += 1;
        let name = package["name"].as_str().unwrap_or_default();
        // Where cargo leaves what it would publish, one package or several.
        let file = format!("{name}-{own}.crate");
        let file = ["package/tmp-registry", "package"].map(|place| folder.join(place).join(&file));
        let file = file.into_iter().find(|file| file.is_file()).ok_or(format!("{name} was not packed"))?;
        let size = fs::metadata(&file)?.len();
        let listed = said(Command::new("tar").arg("-tzf").arg(&file))?;
        let missing: Vec<&str> = PARTS
            .into_iter()
            .filter(|part| !listed.lines().any(|line| line == format!("{name}-{own}/{part}")))
            .collect();
        println!("{name} {own}: {size} bytes");
        faults.extend(missing.iter().map(|part| format!("{name} has no {part}")));
        if size > LARGEST {
            faults.push(format!("{name} has {size} bytes, more than {LARGEST}"));
        }
        for key in ["description", "license", "readme", "rust_version"] {
            if package[key].is_null() {
                faults.push(format!("{name} says nothing of its {key}"));
            }
        }
        for key in ["keywords", "categories"] {
            let length = package[key].as_array().map_or(0, Vec::len);
            if !(1..=5).contains(&length) {
                faults.push(format!("{name} has {length} {key}, and 1 to 5 are expected"));
            }
        }
    }
    if !faults.is_empty() {
        return Err(faults.join("\n").into());
    }
    println!("{count} packages");
    Ok(())
}
