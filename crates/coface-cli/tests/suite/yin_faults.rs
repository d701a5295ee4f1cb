//! What `coface yin` says where files and options are wrong, and that nothing is half done then.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{Run, argument, coface};
use serde_json::{Value, json};
use std::path::PathBuf;
use tempfile::TempDir;

fn run(arguments: &[&str]) -> Run {
    coface(&[&["yin"], arguments].concat())
}

fn yin(arguments: &[&str]) -> Value {
    run(&[arguments, &["--json", "--quiet"]].concat()).json()
}

fn fails(arguments: &[&str]) -> String {
    let run = run(&[arguments, &["--quiet"]].concat());
    let message = run.fails_with(1).to_owned();
    assert!(message.contains("; "), "{arguments:?}: no cure: {message}");
    message
}

fn file(folder: &TempDir, name: &str, text: &str) -> PathBuf {
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    path
}

/// An ellipse as a cubic spline.
fn ellipse(folder: &TempDir) -> PathBuf {
    let points: Vec<[f64; 2]> = (0..24)
        .map(|i| f64::from(i) * std::f64::consts::TAU / 24.0)
        .map(|t| [2.0 * t.cos(), t.sin()])
        .collect();
    file(folder, "ellipse.json", &json!({"order": 4, "curves": [{"points": points}]}).to_string())
}

#[test]
fn names_that_are_spelt_wrong_are_named() {
    let folder = tempfile::tempdir().unwrap();
    for (text, line) in [
        ("Circle 0 0 1 1 0.1\nCirle 0 0 3 0 0.1\n", 2),
        ("Cirle 0 0 1 1 0.1\n", 1),
        ("1e-10\nRectangel 0 0 1 1 0 1 0.1\n", 2),
        ("circle 0 0 1 1 0.1\n", 1),
    ] {
        let message = fails(&["info", argument(&file(&folder, "a.txt", text))]);
        assert!(message.contains(&format!("a.txt:{line}: column 1: \"")), "{message}");
        assert!(message.contains("Circle, Rectangle, OrientedJordanCurve"), "{message}");
    }
    // A key that is spelt wrong is no error, but said.
    let text = "{\"order\":4,\"curves\":[{\"points\":[[0,0],[1,0],[0,1]],\"kink\":[0]}],\"nextvertex\":4}";
    let told = run(&["info", argument(&file(&folder, "a.json", text))]);
    assert_eq!(told.status, 0);
    assert!(
        told.stderr.contains("\"kink\" of curve 0") && told.stderr.contains("\"nextvertex\""),
        "{}",
        told.stderr
    );
    let said = fails(&[
        "info",
        argument(&file(&folder, "n.json", "{\"curves\":[{\"points\":[[0,0],[NaN,0],[0,1]]}]}")),
    ]);
    assert!(said.contains("no NaN"), "{said}");
}

#[test]
fn what_bounds_nothing_is_said() {
    let folder = tempfile::tempdir().unwrap();
    let told = run(&["info", argument(&file(&folder, "a.wkt", "POINT (1 1)"))]);
    assert!(told.status == 0 && told.stderr.contains("points alone bound nothing"), "{}", told.stderr);
    let svg = "<svg xmlns='http://www.w3.org/2000/svg'><path fill='none' d='M0 0h3v2h-3z'/></svg>";
    let told = run(&["info", argument(&file(&folder, "a.svg", svg)), "--json"]);
    assert_eq!(told.json()["area"], json!(6.0));
    assert!(told.stderr.contains("nothing is filled: 1 closed outline"), "{}", told.stderr);
    let far = "{\"order\":4,\"curves\":[{\"points\":[[0,0],[1e300,0],[1e300,1e300],[0,1e300]]}]}";
    let told = run(&["info", argument(&file(&folder, "far.json", far))]);
    assert!(told.stdout.contains("too large") && !told.stdout.contains("infinite"), "{}", told.stdout);
    let told = run(&["info", argument(&file(&folder, "far.json", far)), "--json"]);
    let answer = told.json();
    assert_eq!((&answer["bounded"], &answer["area"]), (&json!(true), &json!(null)));
    assert_eq!(answer["remarks"][0]["code"], json!("beyond-range"));
    assert!(told.stderr.contains("the area is beyond the range of numbers: scale the set down by 1e-200"));
    let near = folder.path().join("near.json");
    yin(&[
        "transform",
        argument(&file(&folder, "far.json", far)),
        "--scale",
        "1e-200",
        "-o",
        argument(&near),
    ]);
    let area = yin(&["info", argument(&near)])["area"].as_f64().unwrap();
    assert!(area > 1e200 && area < 2e200, "{area:e}");
}

#[test]
fn kinks_are_edited_by_places_and_names() {
    let folder = tempfile::tempdir().unwrap();
    let text = "{\"order\":4,\"curves\":[{\"points\":[[0,0],[4,0],[5,2],[4,4],[0,4]],\"kinks\":[0,4],\"name\":\"a:b\"}]}";
    let path = file(&folder, "leaf.json", text);
    let path = argument(&path);
    let by_place =
        yin(&["kinks", path, "--erase-near", "0.5,3", "--insert-near", "4.5,0.1", "--insert-near", "6,2"]);
    assert_eq!(by_place["curves"][0]["kinks"], json!([0, 1, 2]));
    let by_name = yin(&["kinks", path, "--erase", "1", "--insert", "a:b:1", "--insert", "0:2"]);
    assert_eq!(by_name["curves"], by_place["curves"]);
    for (words, said) in [
        (&["--insert", "rim:1"][..], "no curve is named \"rim\""),
        (&["--insert-near", "0,0"], "knot 0 of curve 0 is a kink already: v0"),
        (&["--insert-near", "4,0", "--insert-near", "4.1,0"], "twice"),
        (&["--reset", "--erase-near", "4,0"], "the set has no kinks"),
    ] {
        let told = run(&[&["kinks", path], words].concat());
        assert!(told.status == 1 && told.stderr.contains(said), "{words:?}: {}", told.stderr);
    }
    let told =
        run(&["kinks", argument(&file(&folder, "none.json", "{\"curves\":[]}")), "--insert-near", "0,0"]);
    assert!(told.status == 1 && told.stderr.contains("the set has no curves"), "{}", told.stderr);
}

#[test]
fn kinks_that_are_not_there_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = ellipse(&folder);
    let before = std::fs::read(&path).unwrap();
    let path = argument(&path);
    for (words, said) in [
        (&["kinks", path, "--insert", "0:1,0:1"][..], "given twice"),
        (&["kinks", path, "--insert", "0:1", "--insert", "0:25"], "knot 25"),
        (&["kinks", path, "--insert", "1:0"], "no curve 1"),
        (&["kinks", path, "--erase", "3"], "no kink v3"),
        (&["kinks", path, "--erase", "v3"], "no kink v3"),
        (&["kinks", path, "--reset", "0:1,0:1"], "given twice"),
        (&["kinks", path, "--reset", "0:99"], "99"),
        (&["info", path, "--kinks", "0:1,0:1"], "given twice"),
        (&["fit", path, "--kinks", "0:5,0:5"], "given twice"),
        (&["fit", path, "--kinks", "0:77"], "77"),
        (&["fit", path, "--kinks", "77:5"], "no curve 77"),
    ] {
        let message = fails(&[words, &["-o", path]].concat());
        assert!(message.contains(said), "{words:?}: {message}");
        assert!(message.contains("ellipse.json"), "{words:?}: {message}");
        assert_eq!(std::fs::read(path).unwrap(), before, "{words:?}");
    }
    for words in [&["kinks", path, "--insert", "-1:0"][..], &["kinks", path, "--erase", "-1"]] {
        let wrong = run(words);
        assert!(wrong.status == 2 && wrong.stderr.contains("is no "), "{}", wrong.stderr);
    }
}

#[test]
fn of_two_files_none_is_written_if_one_cannot_be() {
    let folder = tempfile::tempdir().unwrap();
    let path = ellipse(&folder);
    let path = argument(&path);
    let [map, set] = ["map.json", "set.wkt"].map(|name| folder.path().join(name));
    // The format cannot hold curves: neither the set nor where it comes from is written.
    let message = fails(&["join", path, path, "--provenance", argument(&map), "-o", argument(&set)]);
    assert!(message.contains("set.wkt") && message.contains("--flatten"), "{message}");
    assert!(!map.exists() && !set.exists());
    let nowhere = folder.path().join("no/map.json");
    let message = fails(&[
        "join",
        path,
        path,
        "--provenance",
        argument(&nowhere),
        "--flatten",
        "0.01",
        "-o",
        argument(&set),
    ]);
    assert!(message.contains("map.json") && !set.exists(), "{message}");
    let told = run(&[
        "join",
        path,
        path,
        "--provenance",
        argument(&map),
        "--flatten",
        "0.01",
        "-o",
        argument(&set),
        "--json",
    ]);
    assert!(told.json()["area"].is_number() && set.exists());
    let sources: Value = serde_json::from_slice(&std::fs::read(&map).unwrap()).unwrap();
    assert_eq!(sources["sources"][0].as_array().unwrap().len(), 24);
    // Nor is anything left of a set that chords do not bound.
    let said = fails(&["info", path, "--flatten", "1e-300", "-o", argument(&folder.path().join("b.wkt"))]);
    assert!(said.contains("curve 0: piece 0") && said.len() < 300, "{said}");
    let mut names: Vec<_> =
        std::fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(names, ["ellipse.json", "map.json", "set.wkt"]);
}

#[test]
fn outputs_that_are_none_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    let path = ellipse(&folder);
    let path = argument(&path);
    let other = |name: &str| folder.path().join(name);
    for (words, said) in [
        (&["info", path, "-o", argument(&other("a.weather"))][..], "no format known"),
        (&["cut-cells", path, "-o", argument(&other("a.svg"))], ".csv or .json"),
        (&["cut-cells", path, "--picture", "kinks", "-o", argument(&other("a.csv"))], "--picture"),
        (&["cut-cells", path, "--spacing", "-1"], "-1"),
        (&["cut-cells", path, "--spacing", "0"], "size 0"),
        (&["cut-cells", path, "--grid", "100000"], "2^30"),
        (&["combine", "a & c", path], "input 2"),
        (&["combine", "a &", path], "the formula"),
        (&["info", path, "--picture", "forest"], ".svg"),
    ] {
        let run = run(words);
        let message = run.fails_with(1);
        assert!(message.contains(said), "{words:?}: {message}");
    }
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
}
