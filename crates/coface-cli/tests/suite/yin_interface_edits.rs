//! `yin normalize`, `fit`, `kinks` and `cut-cells` of interfaces, and contacts of phases that move.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface};
use serde_json::{Value, json};
use std::path::PathBuf;
use tempfile::TempDir;

/// A bar over two squares, one of which has a knot more on their common side.
const MAP: &str = r#"{"type":"FeatureCollection","features":[
 {"type":"Feature","properties":{"name":"bar"},"geometry":{"type":"Polygon","coordinates":[[[0,1],[2,1],[2,2],[0,2],[0,1]]]}},
 {"type":"Feature","properties":{"name":"left"},"geometry":{"type":"Polygon","coordinates":[[[0,0],[1,0],[1,0.5],[1,1],[0,1],[0,0]]]}},
 {"type":"Feature","properties":{"name":"right"},"geometry":{"type":"Polygon","coordinates":[[[1,0],[2,0],[2,1],[1,1],[1,0]]]}}]}"#;

fn interface(folder: &TempDir) -> PathBuf {
    let map = folder.path().join("map.geojson");
    std::fs::write(&map, MAP).unwrap();
    let path = folder.path().join("rooms.json");
    assert_eq!(coface(&["yin", "interface", argument(&map), "-o", argument(&path)]).status, 0);
    path
}

fn yin(arguments: &[&str]) -> Value {
    coface(&[&["yin"], arguments, &["--json", "--quiet"]].concat()).json()
}

fn areas(answer: &Value) -> Vec<f64> {
    answer["phases"].as_array().unwrap().iter().map(|phase| phase["area"].as_f64().unwrap()).collect()
}

/// The verb writes an interface that is valid, with these areas within a part of one.
fn written(folder: &TempDir, arguments: &[&str], expected: &[f64], within: f64) -> PathBuf {
    let path = folder.path().join(format!("{}-{}.json", arguments[0], arguments.len()));
    let answer = yin(&[arguments, &["-o", argument(&path)]].concat());
    assert_eq!(yin(&["validate", argument(&path)])["valid"], json!(true));
    let again = yin(&["info", argument(&path)]);
    for found in [&answer, &again] {
        for (own, area) in areas(found).iter().zip(expected) {
            assert!((own - area).abs() <= within, "{arguments:?}: {own} and {area}");
        }
    }
    assert_eq!((&answer["edges"], &answer["vertices"]), (&again["edges"], &again["vertices"]));
    path
}

#[test]
fn results_are_interfaces_again() {
    let folder = TempDir::new().unwrap();
    let path = interface(&folder);
    let rooms = argument(&path);
    let unique = written(&folder, &["normalize", rooms], &[2.0, 1.0, 1.0], 0.0);
    assert_eq!(yin(&["normalize", rooms])["straightened"], json!(1));
    assert_eq!(yin(&["normalize", argument(&unique)])["straightened"], json!(0));
    assert_eq!(yin(&["info", argument(&unique)])["junctions"].as_array().unwrap().len(), 4);
    let straight = written(&folder, &["fit", rooms, "--kinks", "detect:45"], &[2.0, 1.0, 1.0], 1e-15);
    assert_eq!(yin(&["info", argument(&straight)])["order"], json!(4));
    // What is fitted may be fitted again, and each edge is the boundary on both of its sides.
    let round = written(
        &folder,
        &["fit", argument(&straight), "--kinks", "none", "--order", "6"],
        &[2.0, 1.0, 1.0],
        0.8,
    );
    let sum = yin(&["compare", argument(&round), argument(&straight)])["area_xor"].as_f64().unwrap();
    assert!(sum > 0.01 && sum < 3.0, "{sum}");
    let phase = |number: usize| format!("{}#{number}", argument(&round));
    assert_eq!(yin(&["meet", &phase(1), &phase(2)])["empty"], json!(true));
    assert_eq!(yin(&["join", &phase(0), &phase(1), &phase(2)])["curve_counts"], json!([1, 0]));
}

#[test]
fn kinks_of_interfaces_come_and_go() {
    let folder = TempDir::new().unwrap();
    let path = interface(&folder);
    let rooms = argument(&path);
    let before = yin(&["kinks", rooms]);
    assert_eq!(before["kink_points"], json!([]));
    let cut = written(
        &folder,
        &["kinks", rooms, "--insert-near", "0,0", "--insert-near", "1,0.5"],
        &[2.0, 1.0, 1.0],
        0.0,
    );
    let found = yin(&["kinks", argument(&cut)]);
    let points = |found: &Value| -> Vec<Value> {
        found["kink_points"].as_array().unwrap().iter().map(|kink| kink["point"].clone()).collect()
    };
    let mut sorted = points(&found);
    sorted.sort_by_key(|point| point[0].as_f64().unwrap() as i64);
    assert_eq!(sorted, [json!([0.0, 0.0]), json!([1.0, 0.5])]);
    assert!(
        found["kink_points"]
            .as_array()
            .unwrap()
            .iter()
            .all(|kink| kink["phases"].as_array().unwrap().contains(&json!(1)))
    );
    // By their names, and by places.
    let names: Vec<String> = (found["kink_points"].as_array().unwrap().iter())
        .map(|kink| format!("v{}", kink["vertex"]))
        .collect();
    assert_eq!(yin(&["kinks", argument(&cut), "--erase", &names.join(",")])["edges"], before["edges"]);
    assert_eq!(points(&yin(&["kinks", argument(&cut), "--erase-near", "1,0.4"])), [json!([0.0, 0.0])]);
    assert_eq!(points(&yin(&["kinks", argument(&cut), "--reset"])), [] as [Value; 0]);
    let page = coface(&["yin", "kinks", argument(&cut)]);
    assert!(page.stdout.contains("between"), "{}", page.stdout);
    for (arguments, said) in [
        (&["--insert", "0:0"][..], "is a junction"),
        (&["--insert", "99:0"], "there is no edge 99"),
        (&["--insert", "rim:0"], "write EDGE:KNOT"),
        (&["--erase", "0"], "there is no kink v0"),
        (&["--erase-near", "0,0"], "has no kinks"),
        (&["--order", "4"], "--order is of one set"),
        (&["--ends", "natural"], "--ends natural is of one set"),
    ] {
        let refused = coface(&[&["yin", "kinks", rooms, "--quiet"], arguments].concat());
        assert!(refused.fails_with(1).contains(said), "{arguments:?}: {}", refused.stderr);
    }
}

#[test]
fn cells_of_phases_add_up() {
    let folder = TempDir::new().unwrap();
    let path = interface(&folder);
    let rooms = argument(&path);
    let answer = yin(&["cut-cells", rooms, "--grid", "8x6"]);
    assert_eq!((&answer["area"], &answer["length"]), (&json!(4.0), &json!(11.0)));
    assert_eq!(answer["phases"][1]["area_of_phase"], json!(1.0));
    let table = folder.path().join("cells.csv");
    coface(&["yin", "cut-cells", rooms, "--grid", "8x6", "-o", argument(&table)]);
    let text = std::fs::read_to_string(&table).unwrap();
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("column,row,phase,name,coverage,area,length"));
    let mut sums = vec![0.0; 48];
    for line in lines {
        let words: Vec<&str> = line.split(',').collect();
        let [column, row] = [0, 1].map(|at: usize| words[at].parse::<usize>().unwrap());
        sums[8 * row + column] += words[5].parse::<f64>().unwrap();
    }
    assert!(sums.iter().all(|sum| (sum - 4.0 / 48.0).abs() < 1e-15), "{sums:?}");
    let shifted = yin(&["cut-cells", rooms, "--grid", "3", "--origin", "-0.3,-0.4", "--spacing", "1"]);
    assert!((shifted["area"].as_f64().unwrap() - 4.0).abs() < 1e-14);
    assert!((shifted["length"].as_f64().unwrap() - 11.0).abs() < 1e-14);
    assert!(coface(&["yin", "cut-cells", rooms]).stdout.contains("left"));
}

#[test]
fn crossed_edges_are_repaired() {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("bow.json");
    let bow = json!({"files":[],"order":2,"phases":[{"name":"a","area":1,"perimeter":1,"components":1,"holes":0,"neighbors":[]}],
        "vertices":[[0,0]],"edges":[{"ends":[0,0],"left":0,"right":null,"length":1,"pieces":4,"knots":[0,1,2,3,4],
        "controls":[[0,0],[2,2],[2,0],[0,2],[0,0]]}],"junctions":[],"smooth_pairs":[],"length":1,"remarks":[]});
    std::fs::write(&path, bow.to_string()).unwrap();
    let refused = coface(&["yin", "info", argument(&path)]);
    assert!(refused.fails_with(1).contains("coface yin normalize"), "{}", refused.stderr);
    let mended = written(&folder, &["normalize", argument(&path)], &[2.0], 0.0);
    assert!(yin(&["normalize", argument(&path)])["repaired"].as_str().unwrap().contains("cross"));
    assert_eq!(yin(&["normalize", argument(&mended)])["repaired"], Value::Null);
    written(&folder, &["normalize", argument(&path), "--rule", "positive"], &[1.0], 0.0);
}

#[test]
fn phases_in_contact() {
    let folder = TempDir::new().unwrap();
    let disk = |name: &str, x: f64| {
        let ring: Vec<[f64; 2]> = (0..64)
            .map(|i| f64::from(i) * std::f64::consts::TAU / 64.0)
            .map(|t| [x + t.cos(), t.sin()])
            .collect();
        let path = folder.path().join(name);
        std::fs::write(&path, json!({"order": 4, "curves": [{"points": ring}]}).to_string()).unwrap();
        path
    };
    let [a, b] = [disk("a.json", -1.25), disk("b.json", 1.25)];
    let common = [
        "advect",
        argument(&a),
        argument(&b),
        "--velocity",
        "-x; 0",
        "--time",
        "1",
        "--step",
        "0.05",
        "--spacing",
        "0.1",
    ];
    let output = folder.path().join("met.json");
    let contact = ["--contact-distance", "0.25"];
    let met = yin(&[&common[..], &contact, &["--on-contact", "merge", "-o", argument(&output)]].concat());
    let event = &met["events"][0];
    assert_eq!((&event["kind"], &event["phases"]), (&json!("phases-meet"), &json!([0, 1])));
    assert!((event["time"].as_f64().unwrap() - 2f64.ln()).abs() < 1e-3, "{event}");
    assert_eq!(met["contact_distance"], json!(0.25));
    assert!(
        met["remarks"].as_array().unwrap().iter().any(|remark| remark["code"] == json!("topology-repaired"))
    );
    assert_eq!(yin(&["validate", argument(&output)])["valid"], json!(true));
    assert_eq!(yin(&["info", argument(&output)])["junctions"].as_array().unwrap().len(), 2);
    // What came of it is an interface like any other, and moves on.
    let on = yin(&["advect", argument(&output), "--velocity", "1,0", "--time", "1", "--spacing", "0.1"]);
    assert_eq!(on["junctions"].as_array().unwrap().len(), 2);
    let kept = yin(&[&common[..], &contact, &["--on-contact", "keep"]].concat());
    assert_eq!((&kept["events"][0]["kind"], &kept["junctions"]), (&json!("contact"), &json!([])));
    assert!(
        kept["remarks"].as_array().unwrap().iter().any(|remark| remark["code"] == json!("contacts-kept"))
    );
    let fine = yin(&[&common[..], &["--on-contact", "merge", "--contact-distance", "1e-6"]].concat());
    assert!(
        fine["remarks"]
            .as_array()
            .unwrap()
            .iter()
            .any(|remark| remark["code"] == json!("contact-below-knots"))
    );
}
