//! `coface yin interface`: phases, arcs and junctions, and phases that go in again.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface};
use serde_json::{Value, json};
use std::f64::consts::PI;
use std::path::PathBuf;
use tempfile::TempDir;

fn interface(arguments: &[&str]) -> Value {
    coface(&[&["yin", "interface"], arguments, &["--json", "--quiet"]].concat()).json()
}

fn file(folder: &TempDir, name: &str, text: &str) -> PathBuf {
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    path
}

/// A bar over two squares: one junction of the type T, and two where the outside takes part.
const MAP: &str = r#"{"type":"FeatureCollection","features":[
 {"type":"Feature","properties":{"name":"bar"},"geometry":{"type":"Polygon","coordinates":[[[0,1],[2,1],[2,2],[0,2],[0,1]]]}},
 {"type":"Feature","properties":{"name":"left"},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,1],[0,0]]]}},
 {"type":"Feature","properties":{"name":"right"},"geometry":{"type":"Polygon","coordinates":[[[1,0],[2,0],[2,1],[1,1],[1,0]]]}}]}"#;

#[test]
fn features_are_phases_with_neighbors_and_junctions() {
    let folder = TempDir::new().unwrap();
    let map = file(&folder, "map.geojson", MAP);
    let found = interface(&[argument(&map)]);
    let names: Vec<&str> =
        found["phases"].as_array().unwrap().iter().map(|phase| phase["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["bar", "left", "right"]);
    assert_eq!(found["length"], json!(11.0));
    let areas: Vec<f64> =
        found["phases"].as_array().unwrap().iter().map(|phase| phase["area"].as_f64().unwrap()).collect();
    assert_eq!(areas, [2.0, 1.0, 1.0]);
    assert_eq!(
        found["phases"][0]["neighbors"],
        json!([
            {"phase": null, "edges": found["phases"][0]["neighbors"][0]["edges"], "length": 4.0},
            {"phase": 1, "edges": 1, "length": 1.0},
            {"phase": 2, "edges": 1, "length": 1.0}
        ])
    );
    let junctions = found["junctions"].as_array().unwrap();
    let inner = junctions.iter().find(|junction| junction["point"] == json!([1.0, 1.0])).unwrap();
    assert_eq!((inner["kind"].as_str(), inner["degree"].as_u64()), (Some("t"), Some(3)));
    let mut around: Vec<u64> =
        inner["phases"].as_array().unwrap().iter().map(|phase| phase.as_u64().unwrap()).collect();
    around.sort_unstable();
    assert_eq!(around, [0, 1, 2]);
    // The middle, the ends of the lower bound of the bar, and the lower end of the arc between the squares.
    assert_eq!(junctions.len(), 4);
    assert!(junctions.iter().all(|junction| junction["kind"] == "t"));
    let none = interface(&[argument(&map), "--smooth", "-1"]);
    assert!(none["junctions"].as_array().unwrap().iter().all(|junction| junction["kind"] == "y"));
}

#[test]
fn phases_of_curves_are_written_and_give_the_same_interface() {
    let folder = TempDir::new().unwrap();
    let disk = |name: &str, x: f64| {
        let angle = |i: u32| f64::from(i) * PI / 24.0;
        let points: Vec<[f64; 2]> = (0..48).map(|i| [x + angle(i).cos(), angle(i).sin()]).collect();
        file(&folder, name, &json!({"order": 4, "curves": [{"points": points}]}).to_string())
    };
    let (a, b) = (disk("a.json", 0.0), disk("b.json", 1.0));
    let refused = coface(&["yin", "interface", argument(&a), argument(&b), "--quiet"]);
    let said = refused.fails_with(1);
    assert!(said.contains("they are") && said.contains("--overlaps first"), "{said}");
    let sets = folder.path().join("phase.json");
    let all = folder.path().join("all.json");
    let first =
        [argument(&a), argument(&b), "--overlaps", "first", "--sets", argument(&sets), "-o", argument(&all)];
    let found = interface(&first);
    assert_eq!((found["edges"].as_array().unwrap().len(), found["order"].as_u64()), (3, Some(4)));
    let area = |found: &Value, phase: usize| found["phases"][phase]["area"].as_f64().unwrap();
    let lens = 2.0 * PI / 3.0 - 0.75f64.sqrt();
    assert!((area(&found, 0) - PI).abs() < 1e-4 && (area(&found, 1) - (PI - lens)).abs() < 1e-4);
    let written: Value = serde_json::from_str(&std::fs::read_to_string(&all).unwrap()).unwrap();
    assert!(written["edges"][0]["controls"].as_array().unwrap().len() > 4);
    // The phases do not overlap any more, and have the same arcs.
    let parts = [1, 2].map(|number| folder.path().join(format!("phase-00{number}.json")));
    let again = interface(&[argument(&parts[0]), argument(&parts[1])]);
    assert_eq!(again["edges"].as_array().unwrap().len(), 3);
    assert_eq!((area(&again, 0), area(&again, 1)), (area(&found, 0), area(&found, 1)));
    assert!((again["length"].as_f64().unwrap() - found["length"].as_f64().unwrap()).abs() < 1e-13);
}

#[test]
fn trivial_sets_are_phases_too() {
    let folder = TempDir::new().unwrap();
    let plane = file(&folder, "plane.json", r#"{"plane":true}"#);
    let empty = file(&folder, "empty.json", r#"{"curves":[]}"#);
    let found = interface(&[argument(&empty), argument(&plane)]);
    assert_eq!((found["edges"].as_array().unwrap().len(), &found["length"]), (0, &json!(0.0)));
    let phases = &found["phases"];
    assert_eq!((&phases[0]["area"], &phases[1]["area"]), (&json!(0.0), &Value::Null));
    assert_eq!((&phases[0]["components"], &phases[1]["components"]), (&json!(0), &json!(1)));
    // A set that others cover leaves nothing, and that is said.
    let square = file(&folder, "square.wkt", "POLYGON ((0 0, 1 0, 1 1, 0 1, 0 0))");
    let covered = interface(&[argument(&plane), argument(&square), "--overlaps", "first"]);
    assert_eq!(covered["phases"][1]["area"], json!(0.0));
    assert!(covered["remarks"][0]["message"].as_str().unwrap().contains("no phase is left of it"));
    let curves = coface(&["yin", "interface", argument(&plane), "--inputs", "features", "--quiet"]);
    assert!(curves.fails_with(1).contains("--inputs files"));
}

#[test]
fn labels_of_an_image_are_phases() {
    let folder = TempDir::new().unwrap();
    // A frame of 1 around 2 and 3, and a pixel that is none.
    let image = file(&folder, "cells.pgm", "P2\n# labels\n5 3 3\n1 1 1 1 1\n1 2 3 1 0\n1 1 1 1 1\n");
    let found = interface(&[argument(&image)]);
    let areas: Vec<f64> =
        found["phases"].as_array().unwrap().iter().map(|phase| phase["area"].as_f64().unwrap()).collect();
    assert_eq!(areas, [12.0, 1.0, 1.0]);
    assert_eq!((&found["phases"][0]["name"], &found["phases"][0]["holes"]), (&json!("1"), &json!(1)));
    // All lengths by hand: around the image with its notch 18, around 2 and 3 together 6, and 1 between them.
    assert_eq!(found["length"], json!(25.0));
    let neighbors = &found["phases"][1]["neighbors"];
    assert_eq!([&neighbors[0]["phase"], &neighbors[0]["length"]], [&json!(0), &json!(3.0)]);
    assert_eq!([&neighbors[1]["phase"], &neighbors[1]["length"]], [&json!(2), &json!(1.0)]);
    let wrong = file(&folder, "short.pgm", "P2 2 2 1\n1 1 0\n");
    let said = coface(&["yin", "interface", argument(&wrong), "--quiet"]);
    assert!(said.fails_with(1).contains("3 of 4"));
}

/// An array of NumPy of format 1.0 with these rows of bytes.
fn npy(rows: &[&[u8]]) -> Vec<u8> {
    let header =
        format!("{{'descr': '|u1', 'fortran_order': False, 'shape': ({}, {}), }}", rows.len(), rows[0].len());
    let padding = 64 - (10 + header.len() + 1) % 64;
    let header = format!("{header}{}\n", " ".repeat(padding));
    let mut bytes = b"\x93NUMPY\x01\x00".to_vec();
    bytes.extend((header.len() as u16).to_le_bytes());
    bytes.extend(header.as_bytes());
    rows.iter().for_each(|row| bytes.extend_from_slice(row));
    bytes
}

#[test]
fn arrays_of_labels_are_images() {
    let folder = TempDir::new().unwrap();
    let labels = folder.path().join("labels.npy");
    std::fs::write(&labels, npy(&[&[7, 7, 0], &[7, 3, 3]])).unwrap();
    let found = interface(&[argument(&labels)]);
    let image = file(&folder, "labels.pgm", "P2 3 2 9\n7 7 0\n7 3 3\n");
    let same = interface(&[argument(&image)]);
    assert_eq!((&found["phases"], &found["edges"]), (&same["phases"], &same["edges"]));
    assert_eq!(found["phases"][1]["area"], json!(3.0));
    let one = folder.path().join("line.npy");
    std::fs::write(&one, b"\x93NUMPY\x01\x00damaged").unwrap();
    assert_eq!(coface(&["yin", "interface", argument(&one)]).status, 1);
}
