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

/// What `interface -o` writes is a file for every verb, and its phases behind a # too.
#[test]
fn other_verbs_take_interfaces_and_their_phases() {
    let folder = TempDir::new().unwrap();
    let map = file(&folder, "map.geojson", MAP);
    let all = folder.path().join("all.json");
    interface(&[argument(&map), "-o", argument(&all)]);
    let phase = |name: &str| folder.path().join(format!("all.json#{name}"));
    let found = coface(&["arrange", argument(&all), "--json", "--quiet"]).json();
    assert_eq!((&found["f_vector"][2], found["measures"].as_array().unwrap().len()), (&json!(3), 3));
    let wkt = folder.path().join("left.wkt");
    for name in ["left", "1"] {
        assert_eq!(coface(&["convert", argument(&phase(name)), "-o", argument(&wkt), "--quiet"]).status, 0);
        let found = coface(&["yin", "info", argument(&wkt), "--json", "--quiet"]).json();
        assert_eq!(found["area"], json!(1.0));
    }
    let found = coface(&["info", argument(&phase("0")), "--json", "--quiet"]).json();
    assert_eq!(found["components"], json!(1));
    for name in ["bar", "2"] {
        let svg = folder.path().join("a.svg");
        assert_eq!(coface(&["render", argument(&phase(name)), "-o", argument(&svg), "--quiet"]).status, 0);
        let page = folder.path().join("a.html");
        assert_eq!(coface(&["view", argument(&phase(name)), "-o", argument(&page), "--quiet"]).status, 0);
    }
    let refused = coface(&["info", argument(&phase("cellar")), "--quiet"]);
    let said = refused.fails_with(1);
    assert!(said.contains("there is no phase \"cellar\"") && said.contains("0 to 2"), "{said}");
}

#[test]
fn points_beside_phases_are_told() {
    let folder = TempDir::new().unwrap();
    let text = MAP.replace(
        "\"features\":[",
        "\"features\":[{\"type\":\"Feature\",\"properties\":{},\"geometry\":{\"type\":\"Point\",\"coordinates\":[5,5]}},",
    );
    let found = interface(&[argument(&file(&folder, "map.geojson", &text))]);
    assert_eq!(found["phases"].as_array().unwrap().len(), 3);
    assert!(found["remarks"][0]["message"].as_str().unwrap().contains("1 point beside polygons"), "{found}");
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
    // The order and the kinks that are asked for are those of the phases.
    let cubic = interface(&[argument(&labels), "--order", "4"]);
    let smooth = interface(&[argument(&labels), "--order", "6", "--kinks", "none"]);
    assert_eq!([&found["order"], &cubic["order"], &smooth["order"]], [&json!(2), &json!(4), &json!(6)]);
    let one = folder.path().join("line.npy");
    std::fs::write(&one, b"\x93NUMPY\x01\x00damaged").unwrap();
    assert_eq!(coface(&["yin", "interface", argument(&one)]).status, 1);
}

fn advect(arguments: &[&str]) -> Value {
    coface(&[&["yin", "advect"], arguments, &["--json", "--quiet"]].concat()).json()
}

fn areas(found: &Value) -> Vec<f64> {
    found["phases"].as_array().unwrap().iter().map(|phase| phase["area"].as_f64().unwrap()).collect()
}

/// Three phases in a vortex: areas come nearer to what they were as the spacing falls, junctions stay, and what is written goes in again.
#[test]
fn interfaces_move_and_keep_areas_and_junctions() {
    let folder = TempDir::new().unwrap();
    // The map in the middle of the unit square.
    let map = MAP.replace("[0,", "[0.4,").replace("[1,", "[0.5,").replace("[2,", "[0.6,");
    let map = map.replace(",0]", ",0.6]").replace(",1]", ",0.7]").replace(",2]", ",0.8]");
    let map = file(&folder, "map.geojson", &map);
    let before = interface(&[argument(&map), "--order", "4"]);
    let output = folder.path().join("moved.json");
    let run = |spacing: &str, more: &[&str]| {
        let common =
            [argument(&map), "--order", "4", "--inputs", "features", "--flow", "vortex", "--time", "1"];
        let steps = ["--spacing", spacing, "--step", spacing];
        advect(&[&common[..], &steps, more].concat())
    };
    let errors = ["0.02", "0.01", "0.005"].map(|spacing| {
        let moved = run(spacing, &["-o", argument(&output)]);
        assert_eq!(
            moved["junctions"].as_array().unwrap().len(),
            before["junctions"].as_array().unwrap().len()
        );
        let kinds = |found: &Value| -> Vec<String> {
            let junctions = found["junctions"].as_array().unwrap();
            junctions.iter().map(|own| own["kind"].as_str().unwrap().to_owned()).collect()
        };
        assert_eq!(kinds(&moved), kinds(&before));
        assert_eq!(moved["areas_before"], json!(areas(&before)));
        let pairs = areas(&moved).into_iter().zip(areas(&before));
        pairs.map(|(after, before)| (after - before).abs()).fold(0.0, f64::max)
    });
    assert!(errors[2] < 1e-6 && errors[1] < errors[0] / 4.0 && errors[2] < errors[1] / 4.0, "{errors:?}");
    // The file gives the same phases to both verbs.
    let moved = run("0.005", &[]);
    let again = interface(&[argument(&output)]);
    let kinds_and_points = |found: &Value| -> Vec<(Value, Value)> {
        let junctions = found["junctions"].as_array().unwrap();
        junctions.iter().map(|own| (own["kind"].clone(), own["point"].clone())).collect()
    };
    assert_eq!((areas(&again), kinds_and_points(&again)), (areas(&moved), kinds_and_points(&moved)));
    let sets = folder.path().join("phase.json");
    let back = ["--flow", "vortex", "--time", "-1", "--spacing", "0.005", "--step", "0.01"];
    let back = advect(&[&[argument(&output)][..], &back, &["--sets", argument(&sets)]].concat());
    assert_eq!(back["phases"].as_array().unwrap().len(), 3);
    let one = coface(&["yin", "info", argument(&folder.path().join("phase-002.json")), "--json"]).json();
    assert_eq!(one["area"], back["phases"][1]["area"]);
    // Another angle of smooth junctions is taken anew from the phases.
    let sharp = interface(&[argument(&output), "--smooth", "-1"]);
    assert!(sharp["junctions"].as_array().unwrap().iter().all(|junction| junction["kind"] == "y"));
}

/// There and back in a period: each phase comes to where it was.
#[test]
fn labels_turn_around_and_come_back() {
    let folder = TempDir::new().unwrap();
    let image = file(&folder, "cells.pgm", "P2\n3 2 3\n1 1 2\n3 3 2\n");
    let output = folder.path().join("way.json");
    let turn = ["--flow", "rotation", "--speed", "6.283185307179586", "--spacing", "0.5", "--step", "0.01"];
    let turn = [&turn[..], &["--scheme", "cooper-verner"]].concat();
    let moved =
        advect(&[&[argument(&image)][..], &turn, &["--frames", "4", "-o", argument(&output)]].concat());
    assert_eq!(moved["frames"].as_array().unwrap().len(), 4);
    for (area, whole) in areas(&moved).into_iter().zip([2.0, 2.0, 2.0]) {
        assert!((area - whole).abs() < 1e-6, "{moved}");
    }
    // After a quarter the lower left corner is at the lower right.
    let quarter = interface(&[argument(&folder.path().join("way-001.json"))]);
    let has = |x: f64, y: f64| {
        quarter["vertices"]
            .as_array()
            .unwrap()
            .iter()
            .any(|own| (own[0].as_f64().unwrap() - x).hypot(own[1].as_f64().unwrap() - y) < 1e-6)
    };
    assert!(has(-1.0, 2.0) && !has(1.0, 2.0), "{quarter}");
    let picture = folder.path().join("moved.svg");
    advect(&[&[argument(&image)][..], &turn, &["-o", argument(&picture)]].concat());
    assert!(std::fs::read_to_string(&picture).unwrap().contains("<svg"));
}

#[test]
fn interfaces_that_are_none_are_refused() {
    let folder = TempDir::new().unwrap();
    let map = file(&folder, "map.geojson", MAP);
    let output = folder.path().join("whole.json");
    interface(&[argument(&map), "-o", argument(&output)]);
    let whole: Value = serde_json::from_str(&std::fs::read_to_string(&output).unwrap()).unwrap();
    let refused = |change: &dyn Fn(&mut Value), said: &str| {
        let mut broken = whole.clone();
        change(&mut broken);
        let path = file(&folder, "broken.json", &broken.to_string());
        for words in [&["yin", "interface"][..], &["yin", "advect", "--velocity", "1,0"]] {
            let error = coface(&[words, &[argument(&path), "--quiet"]].concat());
            let error = error.fails_with(1);
            assert!(error.contains(said) && error.contains("broken.json"), "{said}: {error}");
        }
    };
    refused(&|own| own["edges"][0]["controls"] = Value::Null, "no control points");
    refused(&|own| own["edges"][0]["ends"] = json!([0, 99]), "vertex 99");
    refused(&|own| own["edges"][0]["left"] = json!(7), "phase 7, which there is not");
    refused(&|own| own["edges"][0]["right"] = own["edges"][0]["left"].clone(), "same phase on both sides");
    refused(&|own| own["vertices"][0] = json!([0.5, 0.25]), "does not lead");
    refused(&|own| own["order"] = json!(5), "order");
    refused(&|own| own["smooth_pairs"] = json!([[[0, 3], [1, 1]]]), "is 3");
    refused(&|own| own["smooth_pairs"] = json!([[[99, 1], [1, 1]]]), "edge 99");
    refused(&|own| own["edges"] = json!("none"), "cannot be read");
    // A wall moved across another.
    refused(
        &|own| {
            let edges = own["edges"].as_array_mut().unwrap();
            let inner =
                edges.iter_mut().find(|own| !own["left"].is_null() && !own["right"].is_null()).unwrap();
            let [first, last] = [0, 1].map(|end| {
                let controls = inner["controls"].as_array().unwrap();
                if end == 0 { controls[0].clone() } else { controls[controls.len() - 1].clone() }
            });
            inner["controls"] = json!([first, [5.0, 7.0], last]);
            inner["knots"] = json!([0.0, 1.0, 2.0]);
        },
        "",
    );
}
