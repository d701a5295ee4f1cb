//! Bills of materials: what a program is made of, in the form of CycloneDX.

use super::Outcome;
use serde_json::{Map, Value, json};
use std::collections::{BTreeMap, BTreeSet};

/// The bill of materials of a package: all that is linked with it, with licences and checksums.
///
/// `metadata` is what `cargo metadata --filter-platform` prints, `lock` is `Cargo.lock`.
///
/// References: CycloneDX 1.5 (ECMA-424).
pub(super) fn bill(metadata: &Value, lock: &str, root: &str) -> Outcome<Value> {
    let packages: BTreeMap<&str, &Value> =
        list(&metadata["packages"]).filter_map(|package| Some((package["id"].as_str()?, package))).collect();
    let nodes: BTreeMap<&str, &Value> =
        list(&metadata["resolve"]["nodes"]).filter_map(|node| Some((node["id"].as_str()?, node))).collect();
    let is_root = |package: &&Value| package["name"] == root;
    let start = packages.values().copied().find(is_root).ok_or("the package is not in the workspace")?;
    let start = start["id"].as_str().unwrap_or_default();
    let mut found = BTreeSet::from([start]);
    let mut waiting = vec![start];
    let mut dependencies = Vec::new();
    while let Some(id) = waiting.pop() {
        // Dependencies of tests and of build scripts are not in the program.
        let is_linked =
            |dependency: &&Value| list(&dependency["dep_kinds"]).any(|kind| kind["kind"].is_null());
        let linked: BTreeSet<&str> = nodes
            .get(id)
            .into_iter()
            .flat_map(|node| list(&node["deps"]))
            .filter(is_linked)
            .filter_map(|dependency| dependency["pkg"].as_str())
            .collect();
        waiting.extend(linked.iter().copied().filter(|id| found.insert(id)));
        let names: Vec<String> = linked.iter().filter_map(|id| Some(reference(packages.get(id)?))).collect();
        if let Some(package) = packages.get(id) {
            dependencies.push(json!({ "ref": reference(package), "dependsOn": names }));
        }
    }
    dependencies.sort_by_key(|entry| entry["ref"].as_str().unwrap_or_default().to_owned());
    let sums = checksums(lock);
    let components: Vec<Value> = found
        .iter()
        .filter(|id| **id != start)
        .filter_map(|id| packages.get(id))
        .map(|package| component(package, "library", &sums))
        .collect();
    let main = packages.get(start).map(|package| component(package, "application", &sums));
    Ok(json!({
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": { "component": main },
        "components": components,
        "dependencies": dependencies,
    }))
}

fn list(value: &Value) -> impl Iterator<Item = &Value> {
    value.as_array().into_iter().flatten()
}

fn reference(package: &Value) -> String {
    let part = |key: &str| package[key].as_str().unwrap_or_default();
    format!("pkg:cargo/{}@{}", part("name"), part("version"))
}

fn component(package: &Value, kind: &str, sums: &BTreeMap<(String, String), String>) -> Value {
    let part = |key: &str| package[key].as_str().unwrap_or_default().to_owned();
    let mut found = Map::new();
    found.insert("type".into(), kind.into());
    found.insert("bom-ref".into(), reference(package).into());
    found.insert("name".into(), part("name").into());
    found.insert("version".into(), part("version").into());
    found.insert("purl".into(), reference(package).into());
    if let Some(licence) = package["license"].as_str() {
        // Old manifests write a slash for OR.
        found.insert(
            "licenses".into(),
            json!([{ "expression": licence.replace('/', " OR ").replace("  ", " ") }]),
        );
    }
    if let Some(sum) = sums.get(&(part("name"), part("version"))) {
        found.insert("hashes".into(), json!([{ "alg": "SHA-256", "content": sum }]));
    }
    found.into()
}

/// The checksum of each package with its version; our own have none.
fn checksums(lock: &str) -> BTreeMap<(String, String), String> {
    let mut sums = BTreeMap::new();
    for entry in lock.split("[[package]]").skip(1) {
        let value = |key: &str| {
            let line = entry.lines().find_map(|line| line.strip_prefix(key)?.strip_prefix(" = "));
            line.map(|word| word.trim_matches('"').to_owned())
        };
        if let (Some(name), Some(version), Some(sum)) = (value("name"), value("version"), value("checksum")) {
            sums.insert((name, version), sum);
        }
    }
    sums
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_linked_is_listed_once() {
        let package = |name: &str, licence: &str| json!({ "id": name, "name": name, "version": "1.0.0", "license": licence });
        let needs = |name: &str, kind: Value| json!({ "pkg": name, "dep_kinds": [{ "kind": kind }] });
        let metadata = json!({
            "packages": [package("own", "MIT"), package("a", "MIT/Apache-2.0"), package("b", "Zlib"), package("tool", "MIT")],
            "resolve": { "nodes": [
                { "id": "own", "deps": [needs("a", Value::Null), needs("b", Value::Null), needs("tool", json!("dev"))] },
                { "id": "a", "deps": [needs("b", Value::Null)] },
                { "id": "b", "deps": [needs("tool", json!("build"))] },
            ] },
        });
        let lock = "[[package]]\nname = \"a\"\nversion = \"1.0.0\"\nchecksum = \"12ab\"\n";
        let found = bill(&metadata, lock, "own").unwrap();
        let names: Vec<&str> = list(&found["components"]).filter_map(|part| part["name"].as_str()).collect();
        assert_eq!(names, ["a", "b"]);
        let first = &found["components"][0];
        assert_eq!(first["hashes"][0]["content"], "12ab");
        assert_eq!(first["licenses"][0]["expression"], "MIT OR Apache-2.0");
        assert_eq!(found["metadata"]["component"]["type"], "application");
        assert_eq!(found["dependencies"][2]["dependsOn"], json!(["pkg:cargo/a@1.0.0", "pkg:cargo/b@1.0.0"]));
        assert!(bill(&metadata, lock, "other").is_err());
    }
}
