//! Interfaces as inputs of the verbs of `yin`, and their phases as sets.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_reading};
use serde_json::json;
use std::path::PathBuf;
use tempfile::TempDir;

/// A bar over two squares.
const MAP: &str = r#"{"type":"FeatureCollection","features":[
 {"type":"Feature","properties":{"name":"bar"},"geometry":{"type":"Polygon","coordinates":[[[0,1],[2,1],[2,2],[0,2],[0,1]]]}},
 {"type":"Feature","properties":{"name":"left"},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,1],[0,1],[0,0]]]}},
 {"type":"Feature","properties":{"name":"right"},"geometry":{"type":"Polygon","coordinates":[[[1,0],[2,0],[2,1],[1,1],[1,0]]]}}]}"#;

/// The interface of the map in a file of a folder.
fn interface(folder: &TempDir) -> PathBuf {
    let map = folder.path().join("map.geojson");
    std::fs::write(&map, MAP).unwrap();
    let path = folder.path().join("rooms.json");
    assert_eq!(coface(&["yin", "interface", argument(&map), "-o", argument(&path)]).status, 0);
    path
}

fn yin(arguments: &[&str]) -> serde_json::Value {
    coface(&[&["yin"], arguments, &["--json"]].concat()).json()
}

#[test]
fn info_says_the_same_as_the_verb_that_wrote_it() {
    let folder = TempDir::new().unwrap();
    let path = interface(&folder);
    let whole = yin(&["info", argument(&path)]);
    assert_eq!(whole, yin(&["interface", argument(&path)]));
    assert_eq!(
        (whole["phases"][1]["name"].as_str(), whole["phases"][1]["area"].as_f64()),
        (Some("left"), Some(1.0))
    );
    let page = coface(&["yin", "info", argument(&path)]);
    assert!(page.stdout.contains("4 T") && page.stdout.contains("bar"), "{}", page.stdout);
    // So it does on standard input, and of what it wrote itself.
    let text = std::fs::read(&path).unwrap();
    let piped = coface_reading(&["yin", "info", "-", "--json"], &text).json();
    assert_eq!((&piped["edges"], &piped["junctions"]), (&whole["edges"], &whole["junctions"]));
    let again = folder.path().join("again.json");
    coface(&["yin", "info", argument(&path), "-o", argument(&again)]);
    assert_eq!(yin(&["info", argument(&again)])["edges"], whole["edges"]);
    let drawn = folder.path().join("rooms.svg");
    assert_eq!(coface(&["yin", "info", argument(&path), "-o", argument(&drawn)]).status, 0);
    assert_eq!(std::fs::read_to_string(&drawn).unwrap().matches("<circle").count(), 4);
}

#[test]
fn phases_are_sets_by_name_and_by_number() {
    let folder = TempDir::new().unwrap();
    let path = interface(&folder);
    let phase = |name: &str| format!("{}#{name}", argument(&path));
    for (name, number, area) in [("bar", "0", 2.0), ("left", "1", 1.0), ("right", "2", 1.0)] {
        let found = yin(&["info", &phase(name)]);
        assert_eq!(found["area"], json!(area));
        assert_eq!(found["curves"], yin(&["info", &phase(number)])["curves"]);
    }
    assert_eq!(yin(&["join", &phase("bar"), &phase("left"), &phase("right")])["area"], json!(4.0));
    assert_eq!(yin(&["meet", &phase("bar"), &phase("left")])["empty"], json!(true));
    assert_eq!(yin(&["complement", &phase("bar")])["bounded"], json!(false));
    assert_eq!(yin(&["info", &phase("bar"), "--order", "6"])["order"], json!(6));
    assert_eq!(yin(&["validate", &phase("bar")])["valid"], json!(true));
    assert_eq!(yin(&["cut-cells", &phase("0"), "--grid", "2"])["full"], json!(4));
    assert_eq!(yin(&["compare", &phase("left"), &phase("right")])["area_xor"], json!(2.0));
    let moved =
        yin(&["advect", &phase("bar"), "--velocity", "1,0", "--time", "1", "--spacing", "3", "--events"]);
    assert!((moved["bounding_box"][0][0].as_f64().unwrap() - 1.0).abs() < 1e-12);
    let text = std::fs::read(&path).unwrap();
    assert_eq!(coface_reading(&["yin", "info", "-#left", "--json"], &text).status, 2, "an option");
    // A file with a # in its name is that file.
    let odd = folder.path().join("odd#0.json");
    std::fs::copy(&path, &odd).unwrap();
    assert_eq!(yin(&["info", argument(&odd)])["phases"].as_array().unwrap().len(), 3);
    assert_eq!(yin(&["info", &format!("{}#right", argument(&odd))])["area"], json!(1.0));
    let gone = coface(&["yin", "info", &phase("attic")]);
    assert!(
        gone.status == 1
            && gone.stderr.contains("give one of \"bar\", \"left\", \"right\", or a number below 3")
    );
}

#[test]
fn places_of_interfaces() {
    let folder = TempDir::new().unwrap();
    let path = interface(&folder);
    let path = argument(&path);
    let found =
        yin(&["locate", path, "--point", "0.5,1.5", "--point", "1,0.5", "--point", "1,1", "--point", "9,1"]);
    let phases: Vec<_> =
        found["points"].as_array().unwrap().iter().map(|point| point["phases"].clone()).collect();
    assert_eq!(phases, [json!([0]), json!([1, 2]), json!([0, 1, 2]), json!([])]);
    assert_eq!(
        (&found["outside"], &found["boundary"], &found["phases"][0]["inside"]),
        (&json!(1), &json!(2), &json!(1))
    );
    assert_eq!(
        (&found["points"][3]["distance"], &found["points"][3]["nearest"]),
        (&json!(7.0), &json!([2.0, 1.0]))
    );
    let table = folder.path().join("points.csv");
    coface(&["yin", "locate", path, "--point", "1,0.5", "-o", argument(&table)]);
    let text = std::fs::read_to_string(&table).unwrap();
    assert!(
        text.ends_with("1.0,0.5,boundary,1 2,0.0,1.0,0.5,2,0,0.5\n")
            || text.contains("boundary,1 2,0.0,1.0,0.5,"),
        "{text}"
    );
    let samples = yin(&["sample", path, "--count", "4"]);
    let edges = yin(&["info", path])["edges"].as_array().unwrap().len();
    assert_eq!(samples["samples"].as_array().unwrap().len(), 5 * edges);
    let bends = yin(&["curvature", path]);
    assert_eq!(bends["edges"].as_array().unwrap().len(), edges);
    for verb in ["locate", "sample", "curvature"] {
        let point: &[&str] = if verb == "locate" { &["--point", "1,1"] } else { &[] };
        assert_eq!(coface(&[&["yin", verb, path], point].concat()).status, 0);
    }
}

#[test]
fn images_and_comparisons_of_interfaces() {
    let folder = TempDir::new().unwrap();
    let path = interface(&folder);
    let mirrored = folder.path().join("mirrored.json");
    let line = ["transform", argument(&path), "--scale", "-2,2", "-o", argument(&mirrored)];
    assert_eq!(coface(&[&["yin"], &line[..]].concat()).status, 0);
    let found = yin(&["info", argument(&mirrored)]);
    let areas: Vec<f64> =
        found["phases"].as_array().unwrap().iter().map(|phase| phase["area"].as_f64().unwrap()).collect();
    assert_eq!(areas, [8.0, 4.0, 4.0]);
    let back = folder.path().join("back.json");
    coface(&["yin", "transform", argument(&mirrored), "--scale", "-0.5,0.5", "-o", argument(&back)]);
    let found = yin(&["compare", argument(&path), argument(&back)]);
    assert_eq!((&found["area_xor"], &found["junctions"]), (&json!(0.0), &json!([4, 4])));
    assert_eq!(found["phases"][2]["files"], json!(["right", "right"]));
    assert_eq!(yin(&["validate", argument(&back)])["valid"], json!(true));
    let one = coface(&["yin", "compare", argument(&path), argument(&back), "--series"]);
    assert!(one.status == 1 && one.stderr.contains("rooms.json#0"), "{}", one.stderr);
}

#[test]
fn pages_show_phases_and_junctions() {
    let folder = TempDir::new().unwrap();
    let path = interface(&folder);
    let page = folder.path().join("rooms.html");
    let shown = coface(&["view", argument(&path), "-o", argument(&page), "--json"]).json();
    let layers: Vec<_> =
        shown["layers"].as_array().unwrap().iter().map(|layer| layer["name"].clone()).collect();
    assert_eq!(layers, ["phase bar", "phase left", "phase right", "edges", "junctions"]);
    assert!(std::fs::read_to_string(&page).unwrap().contains("phase left"));
}

#[test]
fn damaged_interfaces_are_refused_with_the_place() {
    let folder = TempDir::new().unwrap();
    let path = interface(&folder);
    let text = std::fs::read_to_string(&path).unwrap();
    let damaged = folder.path().join("damaged.json");
    for (from, to) in [
        ("\"ends\":[", "\"ends\":[77,"),
        ("\"left\":0", "\"left\":9"),
        ("\"junctions\"", "\"junctions\":7,\"x\""),
    ] {
        assert!(text.contains(from), "{from}");
        std::fs::write(&damaged, text.replacen(from, to, 1)).unwrap();
        for verb in ["info", "validate", "sample", "curvature"] {
            let found = coface(&["yin", verb, argument(&damaged)]);
            assert!(
                found.status == 1 && found.stderr.contains("damaged.json"),
                "{verb} {from}: {}",
                found.stderr
            );
        }
    }
    let answer = folder.path().join("answer.json");
    std::fs::write(&answer, coface(&["yin", "info", argument(&path), "--json"]).stdout).unwrap();
    let found = coface(&["yin", "info", argument(&answer)]);
    assert!(found.status == 1 && found.stderr.contains("interface -o FILE.json"), "{}", found.stderr);
}

#[test]
fn events_of_interfaces_have_times_and_phases() {
    let folder = TempDir::new().unwrap();
    let path = interface(&folder);
    // The edge between the squares has the length exp(-t), and the least distance of knots is 0.05.
    let line =
        ["advect", argument(&path), "--velocity", "0; -y", "--time", "4", "--spacing", "0.5", "--events"];
    let found = yin(&line);
    let event = &found["events"][0];
    assert_eq!((event["kind"].as_str(), &event["phases"]), (Some("junctions-meet"), &json!([0, 1, 2])));
    assert!((event["time"].as_f64().unwrap() - 20.0f64.ln()).abs() < 1e-3, "{event}");
    assert_eq!((&event["before"], &found["event_tolerance"]), (&json!(null), &json!(4e-5)));
    // In parts the same; and on a page.
    let out = folder.path().join("out.json");
    let parts = yin(&[&line[..], &["--frames", "4", "-o", argument(&out)]].concat());
    let times = |found: &serde_json::Value| {
        let events = found["events"].as_array().unwrap();
        events.iter().map(|event| event["time"].as_f64().unwrap()).collect::<Vec<f64>>()
    };
    assert!(times(&parts).len() == times(&found).len());
    assert!(times(&parts).iter().zip(times(&found)).all(|(a, b)| (a - b).abs() < 1e-3));
    let page = coface(&[&["yin"], &line[..]].concat()).stdout;
    assert!(page.contains("junctions meet") && page.contains("Events"), "{page}");
    let without = yin(&["advect", argument(&path), "--velocity", "1,0", "--time", "0.1", "--spacing", "3"]);
    assert_eq!(without["events"], json!(null));
    // A room that shrinks away.
    let dot = folder.path().join("dot.wkt");
    std::fs::write(&dot, "POLYGON ((-1 -1, 1 -1, 1 1, -1 1, -1 -1))").unwrap();
    let line = ["--inputs", "files", "--velocity", "-x; -y", "--time", "6", "--spacing", "0.5", "--events"];
    let found = yin(&[&["advect", argument(&dot)], &line[..]].concat());
    assert_eq!(
        (&found["events"][0]["kind"], &found["events"][0]["after"]["components"]),
        (&json!("phase-vanishes"), &json!(0))
    );
}
