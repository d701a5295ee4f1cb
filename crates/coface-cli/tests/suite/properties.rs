//! Properties of the features of GeoJSON through `arrange`, `boolean` and `convert`.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

fn file(folder: &tempfile::TempDir, name: &str, text: &str) -> PathBuf {
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    path
}

fn square(properties: &str, x: f64, side: f64) -> String {
    let r = x + side;
    format!(
        "{{\"type\":\"Feature\",\"properties\":{properties},\"geometry\":{{\"type\":\"Polygon\",\
         \"coordinates\":[[[{x},{x}],[{r},{x}],[{r},{r}],[{x},{r}],[{x},{x}]]]}}}}"
    )
}

fn collection(features: &[String]) -> String {
    format!("{{\"type\":\"FeatureCollection\",\"features\":[\n{}\n]}}\n", features.join(",\n"))
}

fn features(path: &Path) -> Vec<Value> {
    let value: Value = serde_json::from_slice(&std::fs::read(path).unwrap()).unwrap();
    value["features"].as_array().unwrap().clone()
}

fn properties(path: &Path) -> Vec<Value> {
    features(path).iter().map(|feature| feature["properties"].clone()).collect()
}

#[test]
fn a_map_that_is_converted_to_itself_is_the_same_file() {
    let folder = tempfile::tempdir().unwrap();
    let text = collection(&[
        square(
            r#"{"name":"west","height":1.50,"tags":{"b":[null,true],"a":12345678901234567890123}}"#,
            0.,
            2.,
        ),
        square(r#"{"name":"west"}"#, 3., 2.),
        square("{}", 6., 2.),
        r#"{"type":"Feature","id":"n7","properties":{"empty":""},"geometry":null}"#.to_owned(),
    ]);
    let (given, out) = (file(&folder, "map.geojson", &text), folder.path().join("out.geojson"));
    let answer = coface(&["convert", "--json", argument(&given), "-o", argument(&out)]).json();
    assert_eq!(answer["remarks"], json!([]));
    assert_eq!(std::fs::read_to_string(&out).unwrap(), text);
    // A format without properties says how many features lose theirs; the names are groups.
    let wkt = folder.path().join("out.wkt");
    let answer = coface(&["convert", "--json", argument(&given), "-o", argument(&wkt)]).json();
    let remarks = answer["remarks"].as_array().unwrap();
    let lost =
        remarks.iter().find(|remark| remark["message"].as_str().unwrap().contains("properties")).unwrap();
    assert_eq!((&lost["code"], &lost["count"]), (&json!("format-keeps-less"), &json!(2)), "{lost}");
}

#[test]
fn a_chain_of_verbs_keeps_properties() {
    let folder = tempfile::tempdir().unwrap();
    let a = file(&folder, "a.geojson", &square(r#"{"zone":"A","year":2020}"#, 0., 2.));
    let b = file(&folder, "b.geojson", &square(r#"{"zone":"B","year":2020,"area":"given"}"#, 1., 2.));
    let path = |name: &str| folder.path().join(name);
    let (faces, merged, copy) = (path("faces.geojson"), path("merged.geojson"), path("copy.geojson"));
    coface(&["arrange", "--json", argument(&a), argument(&b), "-o", argument(&faces)]).json();
    let [a, b] = [&a, &b].map(|path| argument(path));
    let expected = [
        json!({"area": 3.0, "face": 0, "inside": [a], "zone": "A", "year": 2020}),
        json!({"area": 1.0, "face": 1, "inside": [a, b], "zone": ["A", "B"], "year": 2020}),
        json!({"area": 3.0, "face": 2, "inside": [b], "zone": "B", "year": 2020}),
    ];
    assert_eq!(properties(&faces), expected);
    let formula = ["boolean", "--json", "union", argument(&faces), "--keep-walls", "-o", argument(&merged)];
    coface(&formula).json();
    coface(&["convert", "--json", argument(&merged), "-o", argument(&copy)]).json();
    assert_eq!(std::fs::read(&copy).unwrap(), std::fs::read(&merged).unwrap());
    let found = properties(&copy);
    assert_eq!(found.len(), 3);
    for expected in &expected {
        let same = |found: &&Value| {
            ["area", "face", "inside", "zone", "year"].iter().all(|&key| found[key] == expected[key])
        };
        assert_eq!(found.iter().filter(same).count(), 1, "{expected} in {found:?}");
    }
    // In one step: the polygon comes from both.
    coface(&["boolean", "--json", "union", a, b, "-o", argument(&merged)]).json();
    let expected = json!({"area": 7.0, "polygon": 0, "regions": [a, b], "zone": ["A", "B"], "year": 2020});
    assert_eq!(properties(&merged), [expected]);
    for verb in ["arrange", "boolean"] {
        let help = coface(&[verb, "--help"]).stdout.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(
            help.contains("a key with different values has the list of them in the order of the inputs"),
            "{verb}"
        );
    }
}

#[test]
fn a_topology_converts_to_features_with_their_properties() {
    let folder = tempfile::tempdir().unwrap();
    let topology = r#"{"type":"Topology","arcs":[[[0,0],[1,0],[0,1],[0,0]]],"objects":{"o":{"type":"Polygon",
        "id":12,"arcs":[[0]],"properties":{"kind" : "lake", "depth": 3.10}}}}"#;
    let (given, out) = (file(&folder, "map.topojson", topology), folder.path().join("out.geojson"));
    coface(&["convert", "--json", argument(&given), "-o", argument(&out)]).json();
    let text = std::fs::read_to_string(&out).unwrap();
    assert!(
        text.contains(r#""id":12,"properties":{"kind":"lake","depth":3.10},"geometry":{"type":"Polygon""#),
        "{text}"
    );
}
