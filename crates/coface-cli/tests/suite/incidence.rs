//! `coface incidence`: operators of small models that can be checked by hand, and of real files.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a test says what it skips")]

use crate::program::{argument, coface, coface_reading};
use serde_json::{Value, json};
use std::collections::BTreeSet;
use std::path::PathBuf;

/// A cube of six quadrangles; vertex 4x + 2y + z.
const CUBE: &str = "OFF
8 6 0
0 0 0
0 0 1
0 1 0
0 1 1
1 0 0
1 0 1
1 1 0
1 1 1
4 0 1 3 2
4 4 6 7 5
4 0 4 5 1
4 2 3 7 6
4 0 2 6 4
4 1 5 7 3
";

/// An arrow 0 1 2 3 with its notch at 3, and the triangle 0 2 3 in the notch: the chord 0 2 is an edge of the triangle only.
const ARROW: &str = "OFF
4 2 0
0 0 0
2 3 0
4 0 0
2 1 0
4 0 1 2 3
3 0 3 2
";

fn reading(arguments: &[&str], input: &str) -> Value {
    coface_reading(&[&["incidence", "--json"], arguments, &["-"]].concat(), input.as_bytes()).json()
}

fn places(answer: &Value) -> BTreeSet<(u64, u64)> {
    let entries = answer["entries"].as_array().unwrap();
    entries.iter().map(|e| (e[0].as_u64().unwrap(), e[1].as_u64().unwrap())).collect()
}

#[test]
fn counts_have_a_histogram() {
    let answer = reading(&["--operator", "FE", "--shared"], CUBE);
    assert_eq!(
        answer,
        json!({"file": "standard input", "operator": "FE", "kind": "shared vertices", "rows": 6, "columns": 12,
               "entries_count": 48, "histogram": {"1": 24, "2": 24}, "remarks": []})
    );
    assert_eq!(reading(&["--operator", "vv"], CUBE)["histogram"], json!({"1": 24, "3": 8}));
    assert_eq!(reading(&["--operator", "FF"], CUBE)["histogram"], json!({"2": 24, "4": 6}));
    assert_eq!(reading(&["--operator", "CC"], CUBE)["entries_count"], 0);
    let named = coface_reading(&["incidence", "-", "FF", "--json"], CUBE.as_bytes()).json();
    assert_eq!(named, reading(&["--operator", "FF"], CUBE));
    let listed = reading(&["--operator", "FF", "--entries"], CUBE);
    assert_eq!(listed["histogram"], json!({"2": 24, "4": 6}));
    let first: Vec<&Value> = listed["entries"].as_array().unwrap().iter().take(5).collect();
    assert_eq!(json!(first), json!([[0, 0, 4], [0, 2, 2], [0, 3, 2], [0, 4, 2], [0, 5, 2]]));
}

#[test]
fn thresholds_leave_the_diagonal_out() {
    let adjacent = reading(&["--operator", "FF", "--at-least", "2", "--entries"], CUBE);
    assert_eq!((&adjacent["kind"], &adjacent["histogram"]), (&json!("at least"), &json!({"1": 24})));
    assert!(places(&adjacent).iter().all(|(row, column)| row != column));
    let corners = reading(&["--operator", "FE", "--exactly", "1"], CUBE);
    assert_eq!(corners["entries_count"], 24);
}

/// The chord of the arrow shares two vertices with it and is no edge of it.
#[test]
fn incidence_is_not_taken_from_counts() {
    let counted = reading(&["--operator", "FE", "--exactly", "2", "--entries"], ARROW);
    let incident = reading(&["--operator", "FE", "--incident", "--entries"], ARROW);
    assert_eq!((&counted["entries_count"], &incident["entries_count"]), (&json!(8), &json!(7)));
    let more: Vec<(u64, u64)> = places(&counted).difference(&places(&incident)).copied().collect();
    // The edges are 01, 02, 03, 12, 23.
    assert_eq!(more, [(0, 1)]);
    for (name, count) in [("VV", 10), ("EE", 16), ("FF", 2), ("FV", 7), ("VE", 10), ("EF", 7)] {
        assert_eq!(reading(&["--operator", name, "--incident"], ARROW)["entries_count"], count, "{name}");
    }
}

#[test]
fn signed_operators_compose_to_zero() {
    let matrix = |name: &str| {
        let answer = reading(&["--operator", name, "--signed", "--entries"], CUBE);
        let shape = [&answer["rows"], &answer["columns"]].map(|n| n.as_u64().unwrap() as usize);
        let mut matrix = vec![vec![0i64; shape[1]]; shape[0]];
        for entry in answer["entries"].as_array().unwrap() {
            let [i, j] = [0, 1].map(|k| entry[k].as_u64().unwrap() as usize);
            matrix[i][j] = entry[2].as_i64().unwrap();
        }
        matrix
    };
    let (edges, faces, boundary) = (matrix("EV"), matrix("FE"), matrix("EF"));
    for (face, row) in faces.iter().enumerate() {
        assert_eq!(row.iter().map(|x| x.abs()).sum::<i64>(), 4);
        let mut sums = [0; 8];
        for (entry, edge) in row.iter().zip(&edges) {
            sums.iter_mut().zip(edge).for_each(|(sum, end)| *sum += entry * end);
        }
        assert_eq!(sums, [0; 8]);
        assert!((0..12).all(|edge| boundary[edge][face] == row[edge]));
    }
    assert_eq!(reading(&["--operator", "EV", "--signed"], CUBE)["histogram"], json!({"-1": 12, "1": 12}));
    let refused = coface_reading(&["incidence", "--operator", "FV", "--signed", "-"], CUBE.as_bytes());
    assert!(refused.fails_with(1).contains("no boundary"));
    // A loop has a sign, but no two ends. The chain complex of a path has all operators.
    let path = r#"{"boundaries":[{"rows":3,"cols":2,"entries":[[0,0,-1],[1,0,1],[1,1,-1],[2,1,1]]}]}"#;
    assert_eq!(reading(&["--operator", "VV", "--incident"], path)["entries_count"], 4);
    let circle = r#"{"boundaries":[{"rows":1,"cols":1,"entries":[]}]}"#;
    assert_eq!(reading(&["--operator", "EV", "--signed"], circle)["entries_count"], 0);
    assert_eq!(reading(&["--operator", "CF", "--signed"], circle)["rows"], 0);
    let refused = coface_reading(&["incidence", "--operator", "EV", "-"], circle.as_bytes());
    assert!(refused.fails_with(1).contains("not sets of vertices"));
}

#[test]
fn simplices_of_any_dimension_have_operators() {
    let facets = r#"{"facets":[[0,1,2,3,4],[1,2,3,4,9]]}"#;
    let answer = reading(&["--operator", "4:3", "--incident"], facets);
    assert_eq!(
        (&answer["rows"], &answer["columns"], &answer["entries_count"]),
        (&json!(2), &json!(9), &json!(10))
    );
    assert_eq!(reading(&["--operator", "4:4", "--incident"], facets)["entries_count"], 2);
    assert_eq!(reading(&["--operator", "CE", "--incident"], facets)["rows"], 9);
}

#[test]
fn files_are_written_whole() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let cube = path("cube.off");
    std::fs::write(&cube, CUBE).unwrap();
    let run = |options: &[&str], name: &str| {
        let target = path(name);
        let run = coface(&[&["incidence", argument(&cube)], options, &["-o", argument(&target)]].concat());
        assert_eq!((run.status, run.stdout.as_str()), (0, ""), "{}", run.stderr);
        std::fs::read_to_string(target).unwrap()
    };
    let text = run(&["--operator", "FE", "--incident"], "fe.mtx");
    assert!(text.starts_with("%%MatrixMarket matrix coordinate pattern general\n6 12 24\n"), "{text}");
    assert_eq!(text.lines().count(), 26);
    let text = run(&["--operator", "EV", "--signed"], "ev.mtx");
    assert!(
        text.starts_with("%%MatrixMarket matrix coordinate integer general\n12 8 24\n1 1 -1\n"),
        "{text}"
    );
    let object: Value = serde_json::from_str(&run(&["--operator", "VF"], "vf.json")).unwrap();
    assert_eq!(object["entries"].as_array().unwrap().len(), 24);
    let refused =
        coface(&["incidence", argument(&cube), "--operator", "FE", "-o", argument(&path("fe.txt"))]);
    assert!(refused.fails_with(1).contains(".mtx or .json"));
    assert!(!path("fe.txt").exists());
}

#[test]
fn usage_is_checked() {
    for arguments in [
        &["incidence", "-"][..],
        &["incidence", "-", "--operator", "FX"],
        &["incidence", "-", "--operator", "FE", "--at-least", "0"],
        &["incidence", "-", "--operator", "FE", "--incident", "--signed"],
        &["incidence", "-", "--operator", "FE", "--at-least", "1", "--exactly", "1"],
    ] {
        assert_eq!(coface(arguments).status, 2, "{arguments:?}");
    }
    let page = coface_reading(&["incidence", "-", "--operator", "FE", "--shared"], CUBE.as_bytes());
    assert!(page.stdout.contains("operator FE of standard input"), "{}", page.stdout);
    assert!(page.stdout.contains("48"), "{}", page.stdout);
}

/// Of two dimensions the operator is the incidence matrix, and a small one is printed whole.
#[test]
fn two_dimensions_are_incident() {
    let plain = reading(&["--operator", "FE", "--entries"], ARROW);
    assert_eq!(plain, reading(&["--operator", "FE", "--incident", "--entries"], ARROW));
    assert_eq!((&plain["kind"], &plain["entries_count"]), (&json!("incident"), &json!(7)));
    let page = coface_reading(&["incidence", "-", "--operator", "FE"], ARROW.as_bytes()).stdout;
    // The edges are 01, 02, 03, 12, 23; the arrow has all but 02, the triangle 02, 03, 23.
    assert!(page.contains("\n   1  .  1  1  1\n   .  1  1  .  1\n"), "{page}");
    let counts = coface_reading(&["incidence", "-", "--operator", "VV"], ARROW.as_bytes()).stdout;
    assert!(counts.contains("\n   3  1  1  1\n"), "{counts}");
}

/// Each edge of a surface has two faces, or one at the boundary, and two vertices; the records say how many edges there are.
#[test]
fn real_surfaces_have_two_faces_at_an_edge() {
    let Some(data) = std::env::var_os("COFACE_DATA").map(PathBuf::from) else {
        println!("COFACE_DATA is not set: the test on real surfaces is skipped");
        return;
    };
    let manifest: Value =
        serde_json::from_slice(&std::fs::read(data.join("MANIFEST.json")).unwrap()).unwrap();
    let mut compared = 0;
    for record in manifest["files"].as_array().unwrap() {
        let number = |key: &str| record[key].as_u64();
        let (Some(edges), Some(boundary), Some(vertices)) =
            (number("edges"), number("boundary_edges"), number("vertices"))
        else {
            continue;
        };
        if record["manifold"] != true
            || number("duplicate_faces") != Some(0)
            || number("bytes") > Some(2_000_000)
        {
            continue;
        }
        let file = record["file"].as_str().unwrap();
        let path = data.join(file);
        let counted = |name: &str, kind: &str| {
            let answer = coface(&["incidence", argument(&path), "--operator", name, kind, "--json"]).json();
            (answer["rows"].as_u64().unwrap(), answer["entries_count"].as_u64().unwrap())
        };
        assert_eq!(counted("EF", "--incident"), (edges, 2 * edges - boundary), "{file}");
        assert_eq!(counted("EF", "--signed"), (edges, 2 * edges - boundary), "{file}");
        assert_eq!(counted("VV", "--incident"), (vertices, 2 * edges), "{file}");
        compared += 1;
    }
    assert!(compared >= 5, "only {compared} surfaces were compared");
}

/// What is written can be read: the operator is the boundary of a chain complex.
#[test]
fn a_matrix_is_a_chain_complex() {
    let folder = tempfile::tempdir().unwrap();
    let mesh = folder.path().join("ring.off");
    std::fs::write(&mesh, "OFF\n4 4 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 1\n2 1 2\n2 2 3\n2 3 0\n").unwrap();
    let matrix = folder.path().join("ve.mtx");
    coface(&["incidence", argument(&mesh), "VE", "--signed", "-o", argument(&matrix)]);
    let run = coface(&["homology", argument(&matrix)]);
    assert!(run.stdout.contains("H_1 = Z"), "{}", run.stdout);
    assert!(run.stderr.contains("taken for a boundary"), "{}", run.stderr);
    let json = folder.path().join("ve.json");
    assert_eq!(coface(&["convert", argument(&matrix), "-o", argument(&json)]).status, 0);
    assert_eq!(
        coface(&["homology", argument(&json), "--json"]).json()["homology"],
        coface(&["homology", argument(&matrix), "--json"]).json()["homology"]
    );
}
