//! `--alpha` as a user runs it.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{coface, coface_in, coface_reading};
use serde_json::{Value, json};
use std::path::Path;

/// The corners of a rectangle of sides 6 and 8.
const RECTANGLE: &[u8] = b"x,y\n0,0\n6,0\n6,8\n0,8\n";

fn classes(object: &Value) -> Vec<(u64, f64, Option<f64>)> {
    let class = |pair: &Value| {
        (pair["degree"].as_u64().unwrap(), pair["birth"].as_f64().unwrap(), pair["death"].as_f64())
    };
    let mut classes: Vec<_> = object["diagram"].as_array().unwrap().iter().map(class).collect();
    classes.sort_by(|a, b| a.partial_cmp(b).unwrap());
    classes
}

#[test]
fn a_rectangle_is_a_loop_between_two_squared_radii() {
    let ask = |more: &[&str]| {
        coface_reading(&[&["persistence", "-", "--json", "--alpha"], more].concat(), RECTANGLE).json()
    };
    let object = ask(&[]);
    let components = [(0, 0.0, None), (0, 0.0, Some(9.0)), (0, 0.0, Some(9.0)), (0, 0.0, Some(16.0))];
    let expected: Vec<_> = components.into_iter().chain([(1, 16.0, Some(25.0))]).collect();
    assert_eq!(classes(&object), expected);
    assert_eq!(object["function"], json!("squared radii of the alpha complex"));
    let radii = ask(&["--radii"]);
    assert_eq!(classes(&radii).last(), Some(&(1, 4.0, Some(5.0))));
    assert_eq!(radii["function"], json!("radii of the alpha complex"));
    assert_eq!(ask(&["16"])["betti"], json!([1, 1]));
    assert_eq!(ask(&["4", "--radii"])["betti"], json!([1, 1]));
    assert_eq!(classes(&ask(&["--coefficients", "3"])), expected);
    // The height on the complex of a value, as on any model.
    assert_eq!(ask(&["16", "--function", "x"])["betti"], json!([1, 1]));
}

#[test]
fn cycles_are_made_of_points() {
    let line = ["persistence", "-", "--json", "--cycles", "--min-persistence", "1", "--alpha"];
    let object = coface_reading(&line, RECTANGLE).json();
    let hole = object["diagram"].as_array().unwrap().last().unwrap().clone();
    assert_eq!(hole["cycle"].as_array().unwrap().len(), 4, "{hole}");
    assert_eq!(hole["bounding_chain"].as_array().unwrap().len(), 2, "{hole}");
}

#[test]
fn every_verb_takes_points_at_a_value() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    std::fs::write(place.join("a.csv"), RECTANGLE).unwrap();
    let info =
        |more: &[&str]| coface_in(place, &[&["info", "a.csv", "--json", "--alpha"], more].concat()).json();
    assert_eq!(info(&[])["f_vector"], json!([4, 5, 2]));
    assert_eq!(info(&["9"])["f_vector"], json!([4, 2]));
    assert_eq!(info(&["-1"])["f_vector"], json!([]));
    let groups = coface_in(place, &["homology", "a.csv", "--alpha", "16", "--generators", "--json"]).json();
    assert_eq!(groups["homology"][1]["betti"], json!(1), "{groups}");
    // The name of a file is no value.
    let swapped = coface_in(place, &["info", "--alpha", "a.csv", "--json"]).json();
    assert_eq!(swapped["f_vector"], json!([4, 5, 2]));
    let run = coface_in(place, &["convert", "a.csv", "--alpha", "-o", "a.obj"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    let text = std::fs::read_to_string(place.join("a.obj")).unwrap();
    assert_eq!(text.lines().filter(|line| line.starts_with("f ")).count(), 2, "{text}");
    // Of space, with the vertices of a model.
    std::fs::write(place.join("b.obj"), "v 0 0 0\nv 6 0 0\nv 0 8 0\nv 0 0 1\n").unwrap();
    let run = coface_in(place, &["convert", "b.obj", "--alpha", "-o", "b.vtk"]);
    assert_eq!((run.status, run.stderr.as_str()), (0, ""));
    assert_eq!(coface_in(place, &["info", "b.vtk", "--json"]).json()["f_vector"], json!([4, 6, 4, 1]));
}

/// Joining components is the same for balls of half the distance.
#[test]
fn components_die_at_half_the_distances_of_rips() {
    let folder = tempfile::tempdir().unwrap();
    let point = |i: usize| format!("{},{},{}", i * 37 % 101, i * 53 % 103, i * 71 % 107);
    write(folder.path(), "a.csv", (0..60).map(point));
    write(folder.path(), "turned.csv", (0..60).rev().map(point));
    let ask = |name: &str, more: &[&str]| {
        classes(&coface_in(folder.path(), &[&["persistence", name, "--json"], more].concat()).json())
    };
    let of_points = |classes: &[(u64, f64, Option<f64>)]| -> Vec<f64> {
        classes.iter().filter(|class| class.0 == 0).filter_map(|class| class.2).collect()
    };
    let alpha = ask("a.csv", &["--alpha", "--radii"]);
    let rips = ask("a.csv", &["--rips"]);
    let (one, other) = (of_points(&alpha), of_points(&rips));
    assert_eq!((one.len(), other.len()), (59, 59));
    assert!(one.iter().zip(&other).all(|(radius, diameter)| (2.0 * radius - diameter).abs() < 1e-12));
    // Values are the nearest numbers to the exact ones, whatever the order of the points.
    assert_eq!(ask("turned.csv", &["--alpha", "--radii"]), alpha);
}

fn write(folder: &Path, name: &str, rows: impl Iterator<Item = String>) {
    std::fs::write(folder.join(name), rows.collect::<Vec<_>>().join("\n") + "\n").unwrap();
}

#[test]
fn weights_are_squared_radii() {
    let ask =
        |table: &[u8]| coface_reading(&["persistence", "-", "--json", "--alpha", "--weighted"], table).json();
    let object = ask(b"0 0 4\n4 0 0\n");
    assert_eq!(classes(&object), [(0, -4.0, None), (0, 0.0, Some(2.25))]);
    let run = coface_reading(&["persistence", "-", "--alpha", "--weighted"], b"0 8\n4 8\n2 0\n");
    assert!(run.stderr.contains("1 point is in no simplex"), "{}", run.stderr);
}

#[test]
fn degenerate_points_are_points() {
    let ask = |table: &str| {
        let run = coface_reading(&["persistence", "-", "--json", "--alpha"], table.as_bytes());
        assert_eq!(run.status, 0, "{table}: {}", run.stderr);
        (classes(&run.json()), run.stderr.contains("in no simplex"))
    };
    let nothing = coface_reading(&["persistence", "-", "--alpha"], b"");
    assert!(nothing.fails_with(1).contains("there is no point"), "{}", nothing.stderr);
    assert_eq!(ask("1 2 3\n"), (vec![(0, 0.0, None)], false));
    assert_eq!(ask("1 2 3\n1 2 3\n1 2 3\n"), (vec![(0, 0.0, None)], true));
    let on_a_line = vec![(0, 0.0, None), (0, 0.0, Some(0.75)), (0, 0.0, Some(0.75))];
    assert_eq!(ask("0 0 0\n1 1 1\n2 2 2\n"), (on_a_line, false));
    // The corners of a cube are on one sphere.
    let corners: String = (0..8).map(|i| format!("{} {} {}\n", i & 1, i >> 1 & 1, i >> 2)).collect();
    let (classes, _) = ask(&corners);
    let cavity: Vec<_> = classes.iter().filter(|class| class.0 == 2).collect();
    assert_eq!(cavity, [&(2, 0.5, Some(0.75))]);
    assert_eq!(classes.iter().filter(|class| class.0 == 1).count(), 5);
}

#[test]
fn wrong_tables_are_named_by_their_lines() {
    let said = |table: &str, more: &[&str]| {
        coface_reading(&[&["persistence", "-", "--alpha"], more].concat(), table.as_bytes())
            .fails_with(1)
            .to_owned()
    };
    assert!(said("0 0\n1\n", &[]).contains("standard input:2: point 1 has 1 coordinate, and point 0 has 2"));
    assert!(said("0 0\n1 inf\n", &[]).contains("a coordinate of point 1 is inf"));
    assert!(said("1 2 3 4\n", &[]).contains("--rips"));
    assert!(said("1 2\n", &["--threshold", "2"]).contains("--alpha A"));
    coface(&["persistence", "a.csv", "--weighted"]).fails_with(2);
    coface(&["persistence", "a.csv", "--alpha", "--rips"]).fails_with(2);
    coface(&["info", "a.csv", "--alpha", "two"]).fails_with(2);
}

#[test]
fn memory_is_foretold() {
    let folder = tempfile::tempdir().unwrap();
    write(
        folder.path(),
        "many.csv",
        (0..60_000usize).map(|i| format!("{i},{},{}", i * 7919 % 60_013, i * 104_729 % 60_017)),
    );
    let run = coface_in(folder.path(), &["persistence", "many.csv", "--alpha", "--memory", "100M"]);
    let said = run.fails_with(1);
    assert!(said.contains("the alpha complex of 60000 points of 3 coordinates needs about"), "{said}");
}
