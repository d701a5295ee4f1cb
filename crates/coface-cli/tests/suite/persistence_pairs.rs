//! `coface persistence --relative` and `--image-of`, and `--collapse`, as a user runs them.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_in, coface_reading};
use serde_json::{Value, json};
use std::path::Path;

fn pairs(object: &Value) -> Vec<Value> {
    let pair = |pair: &Value| json!([pair["degree"], pair["birth"], pair["death"]]);
    object["diagram"].as_array().unwrap().iter().map(pair).collect()
}

/// A square with a vertex in the middle that is higher than the rim, and a group for one triangle.
const TENT: &str =
    "v 0 0 0\nv 1 0 1\nv 1 1 2\nv 0 1 3\nv 0.5 0.5 9\ng lid\nf 1 2 5\ng rest\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

fn asked(place: &Path, options: &[&str]) -> Value {
    coface_in(place, &[&["persistence", "tent.obj", "--json"], options].concat()).json()
}

#[test]
fn a_tent_relative_to_its_rim_and_the_rim_in_the_tent() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    std::fs::write(place.join("tent.obj"), TENT).unwrap();
    std::fs::write(place.join("rim.json"), "[[0,1],[1,2],[2,3],[0,3]]").unwrap();
    let relative = asked(place, &["--relative", "boundary"]);
    assert_eq!(pairs(&relative), [json!([2, 9.0, null])]);
    assert_eq!((&relative["betti"], &relative["relative_to"]), (&json!([0, 0, 1]), &json!("boundary")));
    let file = asked(place, &["--relative", "rim.json"]);
    assert_eq!((&file["diagram"], &file["relative_to"]), (&relative["diagram"], &json!("rim.json")));
    // The loop of the rim bounds when the top is there; all of the rim is joined from the beginning.
    let image = asked(place, &["--image-of", "boundary"]);
    assert_eq!(pairs(&image), [json!([0, 0.0, null]), json!([1, 3.0, 9.0])]);
    assert_eq!((&image["betti"], &image["image_of"]), (&json!([1, 0, 0]), &json!("boundary")));
    let page = coface_in(place, &["persistence", "tent.obj", "--image-of", "boundary"]).stdout;
    assert!(page.contains("persistence of the image of boundary in tent.obj over Z/2"), "{page}");
    // A group of the mesh, by its name.
    let lid = asked(place, &["--relative", "lid", "--min-persistence", "-1"]);
    assert_eq!(lid["betti"], json!([0, 0, 0]));
    assert_eq!(lid["diagram"].as_array().unwrap().len(), 5);
    let page = coface_in(place, &["persistence", "tent.obj", "--relative", "lid"]).stdout;
    assert!(page.contains("over Z/2, relative to lid"), "{page}");
    // Superlevel sets.
    let upper = asked(place, &["--relative", "boundary", "--upper-star"]);
    assert_eq!(pairs(&upper), [json!([0, 9.0, 3.0]), json!([2, 0.0, null])]);
    // Relative cycles have the cells of the whole.
    let cycles = asked(place, &["--relative", "boundary", "--cycles"]);
    let cells: Vec<Value> =
        cycles["diagram"][0]["cycle"].as_array().unwrap().iter().map(|term| term[1].clone()).collect();
    assert_eq!(cells.len(), 4);
    assert!(cells.contains(&json!([0, 1, 4])) || cells.contains(&json!([0, 4, 1])), "{cells:?}");
    let run =
        coface_in(place, &["persistence", "tent.obj", "--relative", "boundary", "--cycles", "cycles.vtk"]);
    assert_eq!(run.status, 0, "{}", run.stderr);
}

/// The checker finds the part by itself, and what is left of the complex.
#[test]
fn classes_of_parts_are_proved() {
    use crate::certificates::{BAND, PLANE, lie_about};
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let (input, part, certificate) = (path("in.json"), path("part.json"), path("in.cert"));
    std::fs::write(&part, "[[0,1],[1,4]]").unwrap();
    for (text, option, is_file, others) in [
        (BAND, "--relative", false, &[][..]),
        (BAND, "--image-of", false, &["--coefficients", "3"]),
        (PLANE, "--relative", true, &["--coefficients", "5", "--min-persistence", "-1"]),
        (PLANE, "--image-of", true, &["--upper-star", "--min-persistence", "-1"]),
    ] {
        std::fs::write(&input, text).unwrap();
        let of = if is_file { argument(&part) } else { "boundary" };
        let words =
            ["persistence", argument(&input), option, of, "--certificate", argument(&certificate), "-q"];
        assert_eq!(coface(&[&words[..], others].concat()).status, 0);
        let mut inputs = vec![input.as_path()];
        if is_file {
            inputs.push(part.as_path());
        }
        let files = inputs.iter().map(|path| argument(path));
        let words: Vec<&str> =
            ["check", argument(&certificate)].into_iter().chain(files).chain(["--json"]).collect();
        let verdict = coface(&words).json();
        assert_eq!(verdict["unchecked"], json!([]), "{verdict}");
        assert!(verdict["proved"][1].as_str().unwrap().starts_with("the diagram is of the"), "{verdict}");
        lie_about(&certificate, &inputs);
    }
}

#[test]
fn what_parts_do_not_go_with_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    std::fs::write(place.join("tent.obj"), TENT).unwrap();
    std::fs::write(place.join("points.csv"), "0 0\n1 0\n0 1\n").unwrap();
    let run = |options: &[&str]| coface_in(place, &[&["persistence"], options].concat());
    run(&["tent.obj", "--image-of", "boundary", "--cycles"]).fails_with(2);
    run(&["tent.obj", "--image-of", "boundary", "--relative", "lid"]).fails_with(2);
    run(&["tent.obj", "--relative", "boundary", "--extended"]).fails_with(2);
    run(&["tent.obj", "--relative", "nothing"]).fails_with(1);
    run(&["points.csv", "--rips", "--relative", "boundary"]).fails_with(1);
    run(&["points.csv", "--rips", "--collapse", "--cycles"]).fails_with(2);
    let said = run(&["tent.obj", "--collapse"]);
    assert!(said.fails_with(1).contains("leave --collapse out"), "{}", said.stderr);
}

/// The classes of a diagram, whatever simplices make and end them.
fn classes(object: &Value) -> Vec<String> {
    let mut classes: Vec<String> = pairs(object).iter().map(Value::to_string).collect();
    classes.sort_unstable();
    classes
}

#[test]
fn collapsed_edges_leave_the_diagram_of_points_and_graphs() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    let point = |i: usize| format!("{} {} {}\n", (i * 37) % 101, (i * 53) % 103, (i * 71) % 107);
    let points: String = (0..60).map(point).collect();
    std::fs::write(place.join("points.csv"), points).unwrap();
    let edge = |i: usize| format!("{} {} {}\n", (i * 7) % 23, (i * 11 + 1 + i % 5) % 23, i % 13);
    let edges: String = (0..160).filter(|i| (i * 7) % 23 != (i * 11 + 1 + i % 5) % 23).map(edge).collect();
    std::fs::write(place.join("graph.txt"), edges).unwrap();
    for kind in [
        &["points.csv", "--rips"][..],
        &["graph.txt", "--flag"],
        &["points.csv", "--rips", "--threshold", "40"],
    ] {
        for dimension in ["0", "1", "2"] {
            let ask = |more: &[&str]| {
                coface_in(place, &[&["persistence", "--json", "--dimension", dimension], kind, more].concat())
                    .json()
            };
            let (plain, collapsed) = (ask(&[]), ask(&["--collapse"]));
            assert_eq!(classes(&plain), classes(&collapsed), "{kind:?} {dimension}");
            assert_eq!(
                (&plain["betti"], &plain["threshold"]),
                (&collapsed["betti"], &collapsed["threshold"])
            );
            let [before, after] = [0, 1].map(|i| collapsed["collapsed"][i].as_u64().unwrap());
            assert!(after < before, "{after} of {before}");
        }
    }
    let page = coface_reading(
        &["persistence", "-", "--rips", "--threshold", "3", "--collapse"],
        b"0 0\n1 0\n2 0\n3 0\n",
    )
    .stdout;
    assert!(page.contains("3 of 6 edges left by collapses"), "{page}");
}

/// Where edges alone do not fit, their number and a threshold that fits are said before they are made.
#[test]
fn memory_of_edges_is_foretold() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    let point =
        |i: usize| format!("{} {} {}\n", (i * 3701) % 10_007, (i * 5303) % 10_009, (i * 7103) % 10_037);
    let points: String = (0..1500).map(point).collect();
    std::fs::write(place.join("many.csv"), points).unwrap();
    for (dimension, memory) in [("1", "50M"), ("1", "30M"), ("2", "40M")] {
        let ask = |more: &[&str]| {
            let all =
                [&["persistence", "many.csv", "--rips", "--dimension", dimension, "--memory", memory], more]
                    .concat();
            coface_in(place, &all)
        };
        let run = ask(&[]);
        let said = run.fails_with(1);
        assert!(
            said.contains("many.csv") && said.contains("1,500 + ") && said.contains("of memory"),
            "{said}"
        );
        let threshold = said.split("(--threshold ").nth(1).and_then(|rest| rest.split(')').next()).unwrap();
        let run = ask(&["--threshold", threshold]);
        assert_eq!(run.status, 0, "{}", run.stderr);
    }
}
