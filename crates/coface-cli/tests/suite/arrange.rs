//! `coface arrange` in the plane: counts, areas, what contains each face, what is written, and what is refused.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a test says what it skips")]

use crate::program::{argument, coface, coface_reading};
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// A file of this name with this text in a folder of its own.
fn file(folder: &tempfile::TempDir, name: &str, text: &str) -> PathBuf {
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    path
}

/// Closed polygons as segments.
fn segments(polygons: &[&[[f64; 2]]]) -> String {
    let mut text = String::new();
    for polygon in polygons {
        for (i, a) in polygon.iter().enumerate() {
            let b = polygon[(i + 1) % polygon.len()];
            writeln!(text, "{:?},{:?},{:?},{:?}", a[0], a[1], b[0], b[1]).unwrap();
        }
    }
    text
}

fn square(x: f64, y: f64, side: f64) -> [[f64; 2]; 4] {
    [[x, y], [x + side, y], [x + side, y + side], [x, y + side]]
}

fn arranged(text: &str, options: &[&str]) -> Value {
    let arguments = [&["arrange", "-", "--json", "--format", "lines"], options].concat();
    let value = coface_reading(&arguments, text.as_bytes()).json();
    assert_eq!((&value["dimension"], &value["products_zero"]), (&json!(2), &json!(true)));
    let counts: Vec<i64> =
        value["f_vector"].as_array().unwrap().iter().map(|n| n.as_i64().unwrap()).collect();
    assert_eq!(counts[0] - counts[1] + counts[2], value["components"].as_i64().unwrap());
    assert_eq!(value["measures"].as_array().unwrap().len() as i64, counts[2]);
    assert_eq!(value["inside"].as_array().unwrap().len() as i64, counts[2]);
    value
}

/// The areas, the largest first.
fn areas(value: &Value) -> Vec<f64> {
    let mut areas: Vec<f64> =
        value["measures"].as_array().unwrap().iter().map(|area| area.as_f64().unwrap()).collect();
    areas.sort_by(|a, b| b.total_cmp(a));
    areas
}

#[test]
fn the_facts_of_the_plane_hold() {
    let pentagon = [[0., 0.], [4., 0.], [4., 1.], [2., 4.], [0., 4.]];
    assert_eq!(areas(&arranged(&segments(&[&pentagon]), &[])), [13.0]);
    let (big, middle, small) = (square(0., 0., 4.), square(1., 1., 2.), square(1.5, 1.5, 0.5));
    let corner: &[[f64; 2]] = &[[0., 0.], [1., 2.], [2., 1.]];
    let wide: &[[f64; 2]] = &[[0., 0.], [2., 0.], [2., 1.], [0., 1.]];
    let beside: &[[f64; 2]] = &[[1., 0.], [3., 0.], [3., 1.], [1., 1.]];
    type Case<'a> = (&'a [&'a [[f64; 2]]], [u64; 3], &'a [f64], u64);
    let cases: [Case<'_>; 7] = [
        (&[&big, &middle, &small], [12, 12, 3], &[12.0, 3.75, 0.25], 2),
        (&[&square(0., 0., 1.), &square(1., 1., 1.)], [7, 8, 2], &[1.0, 1.0], 0),
        (&[wide, beside], [8, 10, 3], &[1.0, 1.0, 1.0], 0),
        (&[&square(0., 0., 1e6), &square(5e5, 5e5, 1e6)], [10, 12, 3], &[7.5e11, 7.5e11, 2.5e11], 0),
        (&[&big, corner], [6, 7, 2], &[14.5, 1.5], 0),
        (&[&square(0., 0., 1e-5)], [4, 4, 1], &[1e-10], 0),
        (&[&square(0., 0., 1.), &square(0., 0., 1.)], [4, 4, 1], &[1.0], 0),
    ];
    for (polygons, counts, truth, holes) in cases {
        let value = arranged(&segments(polygons), &[]);
        assert_eq!(value["f_vector"], json!(counts), "{polygons:?}");
        assert_eq!(value["holes"], json!(holes));
        let areas = areas(&value);
        assert!(
            areas.iter().zip(truth).all(|(area, truth)| (area - truth).abs() <= 1e-12 * truth),
            "{areas:?}"
        );
        assert_eq!(value["rounding"]["valid"], json!(true));
        // What lines enclose an odd number of times is inside of their file.
        let reversed: String =
            segments(polygons).lines().rev().fold(String::new(), |text, line| text + line + "\n");
        assert_eq!(arranged(&reversed, &[])["measures"], value["measures"]);
    }
}

#[test]
fn loose_ends_are_kept_or_pruned() {
    let dangling = segments(&[&square(0., 0., 2.)]) + "1,0,1,1\n5,5,6,6\n9,9,9,9\n";
    let value = arranged(&dangling, &[]);
    assert_eq!(value["f_vector"], json!([9, 7, 1]));
    assert_eq!((&value["bridges"], &value["dangling_edges"]), (&json!(2), &json!(2)));
    assert_eq!(value["inside"], json!([[]]), "a drawing with loose ends contains nothing");
    let pruned = arranged(&dangling, &["--prune"]);
    assert_eq!(pruned["f_vector"], json!([5, 5, 1]));
    assert_eq!(pruned["measures"], json!([4.0]));
    let bridged = segments(&[&square(0., 0., 4.), &square(1., 1., 1.)]) + "0,0,1,1\n";
    let value = arranged(&bridged, &[]);
    assert_eq!(value["f_vector"], json!([8, 9, 2]));
    assert_eq!(
        (&value["bridges"], &value["dangling_edges"], &value["holes"]),
        (&json!(1), &json!(0), &json!(0))
    );
    let pruned = arranged(&bridged, &["--prune"]);
    assert_eq!((&pruned["f_vector"], &pruned["holes"]), (&json!([8, 8, 2]), &json!(1)));
}

#[test]
fn regions_of_files_of_all_formats_contain_faces() {
    let folder = tempfile::tempdir().unwrap();
    let ring = |x: f64, y: f64, side: f64, turned: bool| {
        let mut corners = square(x, y, side).to_vec();
        if turned {
            corners.reverse();
        }
        corners.push(corners[0]);
        corners
    };
    let a = file(
        &folder,
        "a.geojson",
        // The hole runs the same way around as the outer ring.
        &json!({"type": "Polygon", "coordinates": [ring(0., 0., 4., false), ring(1., 1., 2., false)]})
            .to_string(),
    );
    let b = file(&folder, "b.obj", "v 2 2 0\nv 6 2 0\nv 6 6 0\nv 2 6 0\nf 4 3 2 1\n");
    let c = file(
        &folder,
        "c.svg",
        "<svg xmlns='http://www.w3.org/2000/svg'><rect x='-1' y='-1' width='8' height='8'/></svg>",
    );
    let d = file(&folder, "d.lines", &segments(&[&square(0., 0., 1.)]));
    let e = file(&folder, "e.wkt", "LINESTRING (-9 0.5, 9 0.5)\n");
    let paths = [&a, &b, &c, &d, &e];
    let inputs: Vec<&str> = paths.iter().map(|path| argument(path)).collect();
    let run = |rule: &[&str]| {
        let mut arguments = vec!["arrange", "--json"];
        arguments.extend_from_slice(&inputs);
        arguments.extend_from_slice(rule);
        coface(&arguments).json()
    };
    let area_inside = |value: &Value, wanted: &[u64]| -> f64 {
        let faces = value["inside"].as_array().unwrap().iter().zip(value["measures"].as_array().unwrap());
        faces.filter(|(inside, _)| **inside == json!(wanted)).map(|(_, area)| area.as_f64().unwrap()).sum()
    };
    let value = run(&[]);
    // Of the square of 64: a is 16 - 4, b is 16, they share 4 - 1, d lies in a.
    for (wanted, area) in [
        (&[0, 2][..], 12.0 - 3.0 - 1.0),
        (&[0, 1, 2], 3.0),
        (&[1, 2], 13.0),
        (&[0, 2, 3], 1.0),
        (&[2], 64.0 - 12.0 - 13.0),
    ] {
        assert_eq!(area_inside(&value, wanted), area, "{wanted:?}");
    }
    let evenodd = run(&["--rule", "evenodd"]);
    assert_eq!(evenodd["inside"], value["inside"]);
    // The face of b is turned, and the hole of a is none.
    let positive = run(&["--rule", "positive"]);
    assert_eq!(area_inside(&positive, &[0, 2]), 15.0);
    assert_eq!(area_inside(&positive, &[1, 2]), 0.0);
    assert_eq!(coface(&["arrange", inputs[0], "--rule", "sometimes"]).status, 2);
}

#[test]
fn what_is_written_is_arranged_to_itself() {
    let folder = tempfile::tempdir().unwrap();
    let drawing = file(
        &folder,
        "drawing.lines",
        &(segments(&[
            &square(0., 0., 8.),
            &square(1., 1., 2.),
            &square(4., 4., 8.),
            &[[0., 0.], [1., 4.], [4., 1.]],
        ]) + "7,1,9,1\n2,6,3,6\n5,1,5,1\n"),
    );
    let options = ["--snap", "--quiet"];
    let run = |input: &Path| coface(&[&["arrange", argument(input), "--json"], &options[..]].concat()).json();
    let value = run(&drawing);
    assert_eq!(value["rounding"]["exact"], json!(true));
    for name in ["again.geojson", "again.wkt", "again.lines", "again.json", "again.svg"] {
        let path = folder.path().join(name);
        coface(&[&["arrange", argument(&drawing), "-o", argument(&path)], &options[..]].concat());
        let again = run(&path);
        // Segments as text have no points without segments but those that have no length.
        assert_eq!(again["f_vector"], value["f_vector"], "{name}");
        assert_eq!(again["measures"], value["measures"], "{name}");
        assert_eq!(again["holes"], value["holes"], "{name}");
    }
    for name in ["mesh.obj", "mesh.ply", "mesh.vtk", "mesh.off"] {
        let path = folder.path().join(name);
        let run = coface(
            &[&["arrange", argument(&drawing), "-o", argument(&path), "--prune"], &options[..]].concat(),
        );
        assert_eq!(run.status, 0, "{name}: {}", run.stderr);
        let info = coface(&["info", argument(&path), "--json"]).json();
        let total: f64 =
            value["measures"].as_array().unwrap().iter().map(|area| area.as_f64().unwrap()).sum();
        assert!((info["area"].as_f64().unwrap() - total).abs() < 1e-12 * total, "{name}");
    }
    let map: Value =
        serde_json::from_slice(&std::fs::read(folder.path().join("again.geojson")).unwrap()).unwrap();
    let feature = &map["features"][0];
    assert_eq!(feature["properties"]["area"], value["measures"][0]);
    assert_eq!(feature["properties"]["face"], json!(0));
    let complex: Value =
        serde_json::from_slice(&std::fs::read(folder.path().join("again.json")).unwrap()).unwrap();
    assert_eq!(complex["boundaries"].as_array().unwrap().len(), 2);
}

#[test]
fn provenance_names_segments_and_regions() {
    let folder = tempfile::tempdir().unwrap();
    let a = file(&folder, "a.wkt", "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))");
    let b = file(&folder, "b.wkt", "POLYGON ((1 0, 3 0, 3 1, 1 1, 1 0))");
    let out = folder.path().join("from.json");
    let run = coface(&["arrange", argument(&a), argument(&b), "--provenance", argument(&out)]);
    assert_eq!((run.status, run.stdout.as_str()), (0, ""), "{}", run.stderr);
    let from: Value = serde_json::from_slice(&std::fs::read(&out).unwrap()).unwrap();
    let edges = from["edges"].as_array().unwrap();
    assert_eq!(edges.iter().filter(|edge| **edge == json!([[0, 0], [1, 0]])).count(), 1);
    assert!(from["vertices"].as_array().unwrap().contains(&json!({"segments": [[0, 1], [1, 2]]})));
    assert!(from["vertices"].as_array().unwrap().contains(&json!({"vertex": [1, 0]})));
    assert_eq!(from["faces"], json!([[0], [0, 1], [1]]));
    let message = coface(&["arrange", argument(&a), "--provenance", "from.txt"]).fails_with(1).to_owned();
    assert!(message.contains(".json"), "{message}");
}

#[test]
fn what_cannot_be_arranged_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let lines = file(&folder, "a.lines", "0,0,2,2\n0,2,2,0\n0,1,2,1.1\n");
    let fails = |arguments: &[&str]| coface(arguments).fails_with(1).to_owned();
    assert_eq!(coface(&["arrange"]).status, 2);
    let message = fails(&["arrange", argument(&lines), "--max-cells", "10"]);
    assert!(message.contains("10"), "{message}");
    assert_eq!(coface(&["arrange", argument(&lines), "--max-cells", "100", "--json"]).status, 0);
    let message = fails(&["arrange", argument(&lines), "-o", "a.docx"]);
    assert!(message.contains("a.docx"), "{message}");
    let steep = file(&folder, "steep.obj", "v 0 0 0\nv 1 0 1\nv 1 1 0\nf 1 2 3\n");
    let message = fails(&["arrange", argument(&steep), "--dimension", "2"]);
    assert!(message.contains("steep.obj: v1 is at height 1"), "{message}");
    let facets = file(&folder, "facets.json", "[[0,1],[1,2]]");
    let message = fails(&["arrange", argument(&facets), "--dimension", "2"]);
    assert!(message.contains("abstract structure"), "{message}");
    let message = fails(&["arrange", argument(&file(&folder, "nan.lines", "0,0,1,1\n0,0,1,nan\n"))]);
    assert!(message.contains("nan.lines:2"), "{message}");
    let message = fails(&["arrange", argument(&file(&folder, "empty.lines", ""))]);
    assert!(message.contains("empty"), "{message}");
    let nothing =
        coface(&["arrange", argument(&file(&folder, "none.lines", "# nothing\n")), "--json"]).json();
    assert_eq!((&nothing["f_vector"], &nothing["dimension"]), (&json!([0, 0, 0]), &json!(2)));
    let curve = file(&folder, "c.svg", "<svg xmlns='http://www.w3.org/2000/svg'>\n<circle r='2'/></svg>");
    let message = fails(&["arrange", argument(&curve), "--strict"]);
    assert!(message.contains("c.svg") && message.contains("--flatten"), "{message}");
    let nearly = coface(&["arrange", argument(&curve), "--json"]).json();
    assert!((areas(&nearly)[0] - 4.0 * std::f64::consts::PI).abs() < 0.07);
    assert_eq!(nearly["remarks"][0]["code"], json!("curves-flattened"));
    let disk = coface(&["arrange", argument(&curve), "--flatten", "1e-7", "--json"]).json();
    assert!((areas(&disk)[0] - 4.0 * std::f64::consts::PI).abs() < 2e-6);
    assert_eq!(disk["inside"], json!([[0]]));
    assert_eq!(coface(&["arrange", argument(&curve), "--flatten", "-1"]).status, 2);
    // Twice the same is the same, with any number of threads.
    let run = |threads: &str| coface(&["arrange", argument(&lines), "--json", "--threads", threads]).stdout;
    assert_eq!(run("1"), run("2"));
}

#[test]
fn rounding_that_changes_the_complex_is_said() {
    // Three lines that nearly meet in (1, 1) make a triangle that is too small for numbers of this size.
    let near = "0,0,2,2\n0,2,2,0\n0,1,4,1.0000000000000002\n";
    let value = arranged(near, &["--exact"]);
    assert_eq!((&value["f_vector"], &value["rounding"]["valid"]), (&json!([9, 9, 1]), &json!(false)));
    let run = coface_reading(&["arrange", "-", "--exact"], near.as_bytes());
    assert!(run.stderr.contains("without --exact"), "{}", run.stderr);
    // By default it is made valid, and that is said.
    let settled = arranged(near, &[]);
    let rounding = &settled["rounding"];
    assert_eq!((&settled["f_vector"], &rounding["valid"]), (&json!([7, 6, 0]), &json!(true)));
    assert_eq!(
        (&rounding["exact"], &rounding["moved"], &rounding["vanished"]),
        (&json!(false), &json!(2), &json!(1))
    );
    assert_eq!(settled["remarks"][0]["code"], json!("features-joined"));
    assert_eq!(settled["snap_rounds"], json!(null));
    let snapped = arranged(near, &["--snap"]);
    assert_eq!((&snapped["f_vector"], &snapped["rounding"]["exact"]), (&json!([7, 6, 0]), &json!(true)));
    assert_eq!(snapped["snap_rounds"], json!(1));
}

#[test]
fn recorded_drawings_have_their_counts() {
    let Some(data) = std::env::var_os("COFACE_DATA") else {
        println!("skipped: COFACE_DATA is not set");
        return;
    };
    let planar = Path::new(&data).join("planar");
    for (name, counts) in [
        ("test1.lines", [32, 48, 17]),
        ("test2.lines", [39, 61, 23]),
        ("test3.lines", [12, 16, 5]),
        ("test4.lines", [16, 20, 6]),
        ("earcut-dude.json", [104, 104, 3]),
        ("polygon.svg", [12, 12, 1]),
    ] {
        let value = coface(&["arrange", argument(&planar.join(name)), "--json"]).json();
        assert_eq!(value["f_vector"], json!(counts), "{name}");
        assert_eq!(value["products_zero"], json!(true));
    }
}

#[test]
fn arrangements_are_written_to_be_looked_at() {
    let folder = tempfile::tempdir().unwrap();
    let flat = file(&folder, "flat.lines", &segments(&[&square(0.0, 0.0, 2.0), &square(1.0, 1.0, 2.0)]));
    let sheets =
        "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nv 1 -1 -1\nv 1 3 -1\nv 1 3 1\nv 1 -1 1\nf 1 2 3 4\nf 5 6 7 8\n";
    let sheets = file(&folder, "sheets.obj", sheets);
    for input in [&flat, &sheets] {
        for extension in ["vtu", "vtp", "gltf", "glb", "png", "svg"] {
            let out = folder.path().join(format!("out.{extension}"));
            let run = coface(&["arrange", argument(input), "-o", argument(&out), "-q"]);
            assert_eq!((run.status, run.stderr.as_str()), (0, ""), "{extension}");
            let bytes = std::fs::read(&out).unwrap();
            match extension {
                "vtu" | "vtp" => {
                    let report = coface(&["info", argument(&out), "--json"]).json();
                    assert!(report["f_vector"][2].as_u64() >= Some(3), "{extension}");
                }
                "gltf" => assert!(serde_json::from_slice::<Value>(&bytes).unwrap()["meshes"].is_array()),
                "glb" => assert!(bytes.starts_with(b"glTF")),
                "png" => assert!(bytes.starts_with(b"\x89PNG")),
                _ => assert!(bytes.starts_with(b"<svg") || bytes.starts_with(b"<?xml")),
            }
        }
        let run = coface(&["arrange", argument(input), "-o", argument(&folder.path().join("out.docx"))]);
        let message = run.fails_with(1);
        assert!(
            message.contains("\"docx\" is no format known here; end it in one of off")
                && message.contains("png"),
            "{message}"
        );
    }
}

/// Drawings that meet only nearly have the cells of the exact drawing, and what was glued is said; a Boolean has its outline.
#[test]
fn congruence_glues_what_is_near() {
    let exact = segments(&[&square(0.0, 0.0, 2.0), &square(2.0, 1.0, 2.0)]);
    let near = segments(&[&square(0.0, 0.0, 2.0), &square(2.0005, 1.0003, 2.0)]);
    let options = ["--method", "congruence", "--tolerance", "0.01"];
    let [expected, found] = [arranged(&exact, &[]), arranged(&near, &options)];
    assert_eq!(found["f_vector"], expected["f_vector"]);
    assert!(areas(&found).iter().zip(areas(&expected)).all(|(x, y)| (x - y).abs() < 0.01));
    let done = &found["congruence"];
    assert_eq!((&done["tolerance"], &done["collapsed"]), (&json!(0.01), &json!(0)));
    assert_eq!(done["stacked_f_vector"], json!([26, 10]));
    let diameter = done["largest_class_diameter"].as_f64().unwrap();
    assert!((0.0005..0.001).contains(&diameter), "{diameter}");
    assert_eq!(found["joined"]["edges"], json!(2));
    assert!(expected.get("congruence").is_none());
    let folder = tempfile::tempdir().unwrap();
    let [a, b] = [
        ("a.wkt", "POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))"),
        ("b.wkt", "POLYGON ((2.001 0, 4 0, 4 2, 1.9995 2, 2.001 0))"),
    ]
    .map(|(name, text)| file(&folder, name, text));
    let union = [&["boolean", "union", argument(&a), argument(&b)][..], &options, &["--json"]].concat();
    let answer = coface(&union).json();
    assert_eq!((&answer["f_vector"], &answer["measure"]), (&json!([6, 6, 1]), &json!(8.0)));
    assert_eq!(answer["joined"]["classes"], json!([[1, 4], [2, 7]]));
    assert_eq!(answer["congruence"]["stacked_f_vector"], json!([24, 8]));
    // A segment that is too short is left out, which is said.
    let short = format!("{exact}7,7,7.001,7\n");
    let found = arranged(&short, &options);
    assert_eq!(found["congruence"]["collapsed"], json!(1));
    assert!(found["remarks"][0]["message"].as_str().unwrap().contains("1 segment collapsed"), "{found}");
}
