//! `--exact` in the plane through files: what `coface arrange` and `coface boolean` write is input as all drawings at once are.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a test says what it skips")]

use crate::program::{argument, coface};
use serde_json::json;
use std::path::{Path, PathBuf};

/// A file of this name with this text in a folder of its own.
fn file(folder: &tempfile::TempDir, name: &str, text: &str) -> PathBuf {
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    path
}

/// Land of a map and lines across it, one drawing after the other: what `--exact` writes is input as all drawings at once are.
#[test]
fn exact_files_of_drawings_are_input_again() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    let Some(data) = std::env::var_os("COFACE_DATA") else {
        println!("skipped: COFACE_DATA is not set");
        return;
    };
    let land = Path::new(&data).join("planar/land-110m.geojson").display().to_string();
    // Lines that all come near one place.
    let bundle = |first: usize| {
        let line = |i: usize| {
            let angle = 0.1 + (first + 3 * i) as f64 * 0.05;
            let (s, c) = angle.sin_cos();
            [[10.3 - 200.0 * c, 40.1 - 200.0 * s], [10.3 + 200.0 * c, 40.1 + 200.0 * s]]
        };
        let lines: Vec<String> =
            (0..8).map(line).map(|[[a, b], [c, d]]| format!("{a:?},{b:?},{c:?},{d:?}\n")).collect();
        lines.concat()
    };
    let drawings: Vec<String> =
        (0..3).map(|i| argument(&file(&folder, &format!("{i}.lines"), &bundle(i))).to_owned()).collect();
    let keys = ["f_vector", "holes", "components", "bridges", "measures"];
    let json = |arguments: &[&str]| {
        let run = coface(&[&["arrange"], arguments, &["--exact", "--json"]].concat());
        assert_eq!(run.status, 0, "{}", run.stderr);
        run.json()
    };
    let mut last = land.clone();
    let mut inputs: Vec<&str> = vec![&land];
    for (i, drawing) in drawings.iter().enumerate() {
        let output = path(&format!("step{i}.json"));
        let found = json(&[&last, drawing, "-o", &output]);
        inputs.push(drawing);
        let once = json(&inputs);
        keys.iter().for_each(|key| assert_eq!(found[key], once[key], "{key} in step {i}"));
        assert_eq!(found["rounding"]["exact"], json!(false));
        // Arranged alone a file is itself.
        let again = path("again.json");
        json(&[&output, "-o", &again]);
        assert!(std::fs::read(&output).unwrap() == std::fs::read(&again).unwrap());
        last = output;
    }
    // Other verbs read the same cells with rounded points.
    let f_vector = json(&inputs)["f_vector"].clone();
    let info = coface(&["info", &last, "--json"]).json();
    assert_eq!(info["f_vector"][0], f_vector[0]);
    // Another file of JSON keeps what is exact, and files of other formats say that they do not.
    let [kept, lost] = ["kept.json", "lost.cfc"].map(path);
    assert_eq!(coface(&["convert", &last, "-o", &kept]).stderr, "");
    assert_eq!(json(&[&kept])["f_vector"], f_vector);
    let run = coface(&["convert", &last, "-o", &lost]);
    assert!(run.status == 0 && run.stderr.contains("does not keep exact points"), "{}", run.stderr);
    // Without --exact what is read is exact, and what is written is rounded so that it is valid.
    let rounded = path("rounded.json");
    let run = coface(&["arrange", &last, "-o", &rounded]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    assert!(!std::fs::read_to_string(&rounded).unwrap().contains("exact_segments"));
    // A damaged file is refused by all verbs, with what to do.
    let text = std::fs::read_to_string(&last).unwrap();
    let at = text.find("\"pieces\":[\n[").unwrap();
    let damaged =
        format!("{}\"pieces\":[\n[9999999,{}", &text[..at], &text[text[at..].find(',').unwrap() + at + 1..]);
    let damaged = file(&folder, "damaged.json", &damaged);
    for verb in ["arrange", "info"] {
        let run = coface(&[verb, argument(&damaged)]);
        assert_eq!(run.status, 1, "{}", run.stdout);
        let expected = "\"exact_segments\": piece 0 names 9999999, which is not there";
        assert!(run.stderr.contains(expected) && run.stderr.contains("leave the key out"), "{}", run.stderr);
    }
}

/// Land cut in two and put together again is the land, and parts of it are exact to the last bit.
#[test]
fn exact_results_in_the_plane_are_input_again() {
    let folder = tempfile::tempdir().unwrap();
    let Some(data) = std::env::var_os("COFACE_DATA") else {
        println!("skipped: COFACE_DATA is not set");
        return;
    };
    let land = std::path::Path::new(&data).join("planar/land-110m.geojson").display().to_string();
    let path = |name: &str| folder.path().join(name).display().to_string();
    let knife = "POLYGON ((-200.1 -77.7, 190.3 -88.8, 211.7 83.3, 7.1 -3.3, -180.7 60.1, -200.1 -77.7))\n";
    let knife = argument(&file(&folder, "knife.wkt", knife)).to_owned();
    let [inside, outside, whole, xor] = ["inside.json", "outside.json", "whole.json", "xor.json"].map(path);
    for (operation, output) in [("intersection", &inside), ("difference", &outside)] {
        let run = coface(&["boolean", operation, &land, &knife, "--exact", "-o", output]);
        assert_eq!(run.status, 0, "{}", run.stderr);
        assert!(std::fs::read_to_string(output).unwrap().contains("\"exact_segments\""));
    }
    let alone = coface(&["boolean", "union", &land, "--exact", "--json"]).json();
    let joined = coface(&["boolean", "union", &inside, &outside, "--exact", "--json", "-o", &whole]).json();
    for key in ["f_vector", "polygons", "holes", "components", "measures"] {
        assert_eq!(joined[key], alone[key], "{key}");
    }
    for operands in [[&whole, &land], [&inside, &inside]] {
        let run = coface(&["boolean", "xor", operands[0], operands[1], "--json"]).json();
        assert_eq!((&run["measure"], &run["f_vector"]), (&json!(0.0), &json!([0, 0, 0])));
    }
    // With rounded coordinates the parts do not fit: there are slivers.
    let [rounded, rest] = ["rounded.json", "rest.json"].map(path);
    for (operation, output) in [("intersection", &rounded), ("difference", &rest)] {
        assert_eq!(coface(&["boolean", operation, &land, &knife, "-o", output]).status, 0);
    }
    let slivers = coface(&["boolean", "--formula", "a ^ (b | c)", &land, &rounded, &rest, "--json"]).json();
    assert_ne!(slivers["f_vector"], json!([0, 0, 0]));
    // Nothing is said of what was assumed: exact results are what they are.
    let triangle = argument(&file(&folder, "triangle.wkt", "POLYGON((0 0,3 1,1 3,0 0))\n")).to_owned();
    let cut = argument(&file(&folder, "cut.wkt", "POLYGON((1 0,2 4,0 2,1 0))\n")).to_owned();
    let [part, other, both] = ["part.json", "other.json", "both.json"].map(path);
    for (operation, inputs, output) in [
        ("difference", [&triangle, &cut], &part),
        ("intersection", [&triangle, &cut], &other),
        ("union", [&part, &other], &both),
        ("union", [&both, &both], &part),
    ] {
        let run = coface(&["boolean", operation, inputs[0], inputs[1], "--exact", "-o", output]);
        assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{operation}");
    }
    // What is empty is input as well.
    assert_eq!(coface(&["boolean", "difference", &whole, &land, "--exact", "-o", &xor]).status, 0);
    let run = coface(&["boolean", "union", &xor, &knife, "--json"]).json();
    assert_eq!(run["polygons"], json!(1));
}
