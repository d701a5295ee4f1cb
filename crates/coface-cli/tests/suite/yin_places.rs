//! `coface yin locate`, `sample`, `curvature`, `validate`, `normalize` and `transform`: answers that go in again, and what is refused.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface};
use serde_json::{Value, json};
use std::path::PathBuf;
use tempfile::TempDir;

fn yin(arguments: &[&str]) -> Value {
    coface(&[&["yin"], arguments, &["--json", "--quiet"]].concat()).json()
}

fn fails(arguments: &[&str]) -> String {
    coface(&[&["yin"], arguments, &["--quiet"]].concat()).fails_with(1).to_owned()
}

fn file(folder: &TempDir, name: &str, text: &str) -> PathBuf {
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    path
}

/// A disk of radius 2 about (5, 5) with a square hole of side 1 in its middle.
fn washer(folder: &TempDir) -> PathBuf {
    let ring = |count: u32| -> Vec<[f64; 2]> {
        let angle = |i: u32| f64::from(i) * std::f64::consts::TAU / f64::from(count);
        (0..count).map(|i| [5.0 + 2.0 * angle(i).cos(), 5.0 + 2.0 * angle(i).sin()]).collect()
    };
    let hole = [[4.5, 4.5], [4.5, 5.5], [5.5, 5.5], [5.5, 4.5]];
    let curves = json!([{"name": "rim", "points": ring(64)}, {"points": hole, "kinks": [0, 1, 2, 3]}]);
    file(folder, "washer.json", &json!({"order": 4, "curves": curves}).to_string())
}

#[test]
fn points_are_located_with_signed_distances() {
    let folder = TempDir::new().unwrap();
    let set = washer(&folder);
    let set = argument(&set);
    let points = file(&folder, "points.csv", "x,y\n5,5\n5,6\n5.5,5\n5,9\n");
    let found = yin(&["locate", set, "--points", argument(&points), "--point", "-1,5"]);
    assert_eq!(
        (found["inside"].as_u64(), found["boundary"].as_u64(), found["outside"].as_u64()),
        (Some(1), Some(1), Some(3))
    );
    let words: Vec<&str> =
        found["points"].as_array().unwrap().iter().map(|p| p["location"].as_str().unwrap()).collect();
    assert_eq!(words, ["outside", "outside", "inside", "boundary", "outside"]);
    for (point, expected) in found["points"].as_array().unwrap().iter().zip([-4.0, -0.5, 0.5, 0.0, -2.0]) {
        assert!((point["signed_distance"].as_f64().unwrap() - expected).abs() < 1e-4, "{point}");
    }
    // The nearest points are on the boundary but for rounding: they go in again.
    let table = folder.path().join("found.csv");
    coface(&["yin", "locate", set, "--points", argument(&points), "-o", argument(&table), "--json"]).json();
    let text = std::fs::read_to_string(&table).unwrap();
    assert!(text.starts_with("x,y,location,signed_distance,nearest_x"), "{text}");
    let nearest: String = text
        .lines()
        .skip(1)
        .map(|line| {
            let words: Vec<&str> = line.split(',').collect();
            format!("{} {}\n", words[4], words[5])
        })
        .collect();
    let again = file(&folder, "nearest.xyz", &nearest);
    let found = yin(&["locate", set, "--points", argument(&again)]);
    for point in found["points"].as_array().unwrap() {
        assert!(point["signed_distance"].as_f64().unwrap().abs() < 1e-14, "{point}");
    }
    let plane = file(&folder, "plane.json", r#"{"plane":true}"#);
    let found = yin(&["locate", argument(&plane), "--point", "1,1"]);
    assert!(found["points"][0]["location"] == "inside" && found["points"][0]["signed_distance"].is_null());
    assert!(fails(&["locate", set]).contains("--point X,Y"));
    assert!(fails(&["locate", set, "--points", "nothing.csv"]).contains("nothing.csv"));
    assert!(fails(&["locate", set, "--point", "1,1", "-o", "found.obj"]).contains(".csv or .json"));
    coface(&["yin", "locate", set, "--point", "1;1"]).fails_with(2);
}

#[test]
fn samples_have_lengths_directions_and_curvatures() {
    let folder = TempDir::new().unwrap();
    let set = washer(&folder);
    let set = argument(&set);
    let found = yin(&["sample", set, "--spacing", "0.1"]);
    let samples = found["samples"].as_array().unwrap();
    // The rim is 4 pi long, the hole 4.
    assert_eq!(samples.iter().filter(|sample| sample["curve"] == 0).count(), 126);
    assert_eq!(samples.iter().filter(|sample| sample["curve"] == 1).count(), 40);
    assert!((samples[7]["curvature"].as_f64().unwrap() - 0.5).abs() < 1e-2);
    assert_eq!(yin(&["sample", set])["samples"].as_array().unwrap().len(), 8 * 68);
    let table = folder.path().join("samples.csv");
    coface(&["yin", "sample", set, "--count", "10", "-o", argument(&table), "--json"]).json();
    assert_eq!(std::fs::read_to_string(&table).unwrap().lines().count(), 21);
    assert!(fails(&["sample", set, "--spacing", "0"]).contains("positive length"));
    assert!(fails(&["sample", set, "--count", "0"]).contains("one or more"));
    assert!(fails(&["sample", set, "--spacing", "1e-300"]).contains("fewer"));
    coface(&["yin", "sample", set, "--count", "3", "--spacing", "1"]).fails_with(2);
}

#[test]
fn curvatures_are_signed() {
    let folder = TempDir::new().unwrap();
    let set = washer(&folder);
    let found = yin(&["curvature", argument(&set)]);
    let near = |value: &Value, expected: f64| (value["value"].as_f64().unwrap() - expected).abs() < 1e-2;
    assert!(near(&found["curves"][0]["least"], 0.5) && near(&found["curves"][0]["greatest"], 0.5));
    assert!(near(&found["curves"][1]["least"], 0.0) && near(&found["curves"][1]["sharpest"], -90.0));
    assert!(found["curves"][1]["roughest"].is_null());
    assert!(fails(&["curvature", argument(&set), "-o", "a.csv"]).contains("written as .json"));
}

#[test]
fn what_bounds_no_set_is_listed() {
    let folder = TempDir::new().unwrap();
    let good = yin(&["validate", argument(&washer(&folder))]);
    assert!(good["valid"] == true && good["faults"].as_array().unwrap().is_empty());
    assert!(good["roughest"]["degrees"].as_f64().unwrap().abs() < 1e-9);
    let text = json!({"order": 2, "curves": [
        {"points": [[0, 0], [2, 2], [2, 0], [0, 2]]},
        {"points": [[10, 0], [12, 0], [12, 2], [10, 2]]},
        {"points": [[20, 0], [22, 2], [22, 0], [20, 2]]},
    ]});
    let bad = file(&folder, "bad.json", &text.to_string());
    let run = coface(&["yin", "validate", argument(&bad), "--json", "--quiet"]);
    let found: Value = serde_json::from_str(&run.stdout).unwrap();
    assert!(run.status == 1 && run.stderr.contains("coface yin normalize"), "{}", run.stderr);
    let faults = found["faults"].as_array().unwrap();
    assert_eq!(faults.len(), 2, "{found}");
    for (fault, (curve, point)) in faults.iter().zip([(0, [1.0, 1.0]), (2, [21.0, 1.0])]) {
        assert_eq!(
            (&fault["kind"], &fault["curves"], &fault["point"]),
            (&json!("self_meeting"), &json!([curve]), &json!(point))
        );
    }
    let two = json!({"order": 2, "curves": [{"points": [[0, 0], [2, 0], [2, 2], [0, 2]]}, {"points": [[1, 1], [3, 1], [3, 3], [1, 3]]}]});
    let two = file(&folder, "two.json", &two.to_string());
    let run = coface(&["yin", "validate", argument(&two), "--json", "--quiet"]);
    let found: Value = serde_json::from_str(&run.stdout).unwrap();
    assert_eq!(
        (&found["faults"][0]["kind"], &found["faults"][0]["curves"]),
        (&json!("crossing"), &json!([0, 1]))
    );
    // What normalize makes of them is valid.
    let out = folder.path().join("out.json");
    let out = argument(&out);
    for (input, area) in [(&bad, 8.0), (&two, 7.0)] {
        let found = yin(&["normalize", argument(input), "-o", out]);
        assert_eq!(found["area"], json!(area));
        assert_eq!(yin(&["validate", out])["valid"], true);
        let again = yin(&["normalize", out]);
        assert_eq!(
            (&again["area"], &again["rounds"], &again["straightened"]),
            (&json!(area), &json!(0), &json!(0))
        );
    }
}

#[test]
fn images_go_back() {
    let folder = TempDir::new().unwrap();
    let set = washer(&folder);
    let (set, out, back) = (argument(&set), folder.path().join("out.json"), folder.path().join("back.json"));
    let (out, back) = (argument(&out), argument(&back));
    let moved = yin(&[
        "transform",
        set,
        "--scale",
        "2",
        "--rotate",
        "30",
        "--translate",
        "-1,3",
        "--center",
        "5,5",
        "-o",
        out,
    ]);
    let before = yin(&["info", set]);
    assert!((moved["area"].as_f64().unwrap() - 4.0 * before["area"].as_f64().unwrap()).abs() < 1e-11);
    assert_eq!((&moved["kinks"], &moved["curves"][0]["name"]), (&json!(4), &json!("rim")));
    yin(&["transform", out, "--translate", "1,-3", "-o", back]);
    yin(&["transform", back, "--scale", "0.5", "--rotate", "-30", "--center", "5,5", "-o", back]);
    let found = yin(&["compare", set, back]);
    assert!(found["area_xor"].as_f64().unwrap() < 1e-12, "{found}");
    let mirrored = yin(&["transform", set, "--matrix", "0,1,0,1,0,0", "-o", out]);
    assert!((mirrored["area"].as_f64().unwrap() - before["area"].as_f64().unwrap()).abs() < 1e-12);
    assert!(fails(&["transform", set]).contains("--scale"));
    assert!(fails(&["transform", set, "--scale", "0"]).contains("determinant"));
    assert!(fails(&["transform", set, "--scale", "1e308", "-o", out]).contains("not finite"));
    coface(&["yin", "transform", set, "--matrix", "1,0,0,1"]).fails_with(2);
}

fn circle(folder: &TempDir, count: u32) -> PathBuf {
    let angle = |i: u32| f64::from(i) * std::f64::consts::TAU / f64::from(count);
    let points: Vec<[f64; 2]> =
        (0..count).map(|i| [3.0 + 2.0 * angle(i).cos(), 2.0 * angle(i).sin()]).collect();
    let text = json!({"order": 4, "curves": [{"points": points}]}).to_string();
    file(folder, &format!("c{count}.json"), &text)
}

#[test]
fn fits_of_a_circle_come_near_it_at_order_four() {
    let folder = TempDir::new().unwrap();
    let files: Vec<PathBuf> = [16, 32, 64].into_iter().map(|count| circle(&folder, count)).collect();
    let names: Vec<&str> = files.iter().map(|path| argument(path)).collect();
    let series = [&["compare", "--series", "--exact", "circle:3,0,2"], &names[..]].concat();
    let found = yin(&series);
    let rows = found["rows"].as_array().unwrap();
    assert_eq!((rows.len(), found["reference"].as_str()), (3, Some("circle:3,0,2")));
    assert!(rows[0]["area_rate"].is_null());
    for row in &rows[1..] {
        for key in ["area_rate", "hausdorff_rate"] {
            assert!((row[key].as_f64().unwrap() - 4.0).abs() < 0.2, "{row}");
        }
    }
    // One by one they are the same, and the area of the shape is right.
    let one = yin(&["compare", names[2], "--exact", "circle:3,0,2"]);
    assert_eq!(one["area_xor"], rows[2]["area_xor"]);
    let turned = yin(&["compare", names[2], "--exact", "ellipse:3,0,2,2,30"]);
    let miss = turned["area_xor"].as_f64().unwrap() - one["area_xor"].as_f64().unwrap();
    assert!(miss.abs() < 1e-12, "{miss}");
    for (key, truth) in [("hausdorff", 1e-5), ("along_normals", 1e-5)] {
        let [found, off] = [key.to_owned(), format!("{key}_error")].map(|key| one[&key].as_f64().unwrap());
        assert!(found < truth && off < 1e-2 * found, "{key} {found:e} {off:e}");
    }
    assert!(one["normals_left_out"].as_f64().unwrap() < 0.02);
    let rate = rows[2]["curvature_rate"].as_f64().unwrap();
    assert!((rate - 2.0).abs() < 0.2, "{rate}");
    // The same circle by expressions, whatever way they run.
    for function in ["function:3+2*cos(t); 2*sin(t)", "function:3+2*sin(t*2*pi/T); 2*cos(t)"] {
        let same = yin(&["compare", names[2], "--exact", function]);
        let miss = same["area_xor"].as_f64().unwrap() - one["area_xor"].as_f64().unwrap();
        assert!(miss.abs() < 1e-12, "{function} {miss:e}");
    }
    for (function, said) in [
        ("function:cos(t/2); sin(t)", "does not close"),
        ("function:x*cos(t); sin(t)", "no point at t = 0"),
        ("function:log(t); sin(t)", "no point at t = 0"),
        ("function:cos(t)", "there is one expression"),
        ("function:sin(t); sin(2*t)", "more than once"),
    ] {
        let told = fails(&["compare", names[0], "--exact", function]);
        assert!(told.contains("--exact") && told.contains(said), "{function}: {told}");
    }
    let rough = "function:3+(2+abs(cos(t-1)))*cos(t); (2+abs(cos(t-1)))*sin(t)";
    let rough = yin(&["compare", names[0], "--exact", rough]);
    assert_eq!(rough["remarks"][0]["code"], json!("arcs-approximated"));
    // Without a shape the last file is what the others come near.
    let last = yin(&[&["compare", "--series"], &names[..]].concat());
    assert_eq!((last["rows"].as_array().unwrap().len(), last["reference"].as_str().is_some()), (2, true));
    assert!(fails(&["compare", names[0]]).contains("--exact"));
    assert!(fails(&["compare", names[0], names[1], names[2]]).contains("--series"));
    let wrong = coface(&["yin", "compare", names[0], "--exact", "circle:1,2"]);
    assert!(wrong.fails_with(2).contains("circle:X,Y,RADIUS"));
}
