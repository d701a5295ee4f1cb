//! `coface pi1`: groups, loops, counts, faults.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

mod program;

use program::{argument, coface, coface_reading};
use serde_json::{Value, json};

const PLANE: &[u8] = b"[[0,1,5],[1,2,5],[2,3,5],[3,4,5],[4,0,5],[0,1,3],[1,2,4],[2,3,0],[3,4,1],[4,0,2]]";

#[test]
fn the_contract_of_the_keys_is_kept() {
    for options in [&["pi1", "-", "--json"][..], &["pi1", "-", "--json", "--simplify"]] {
        let answer = coface_reading(options, PLANE).json();
        let component = &answer["components"][0];
        assert_eq!(component["generators"], 1);
        let relator: Vec<i64> = serde_json::from_value(component["relators"][0].clone()).unwrap();
        assert_eq!((relator.len(), relator[0].abs(), relator[0]), (2, 1, relator[1]));
        assert_eq!(component["abelianization"], json!({ "betti": 0, "torsion": [2] }));
        assert_eq!(component["name"], "Z/2");
        assert_eq!(answer["components"].as_array().unwrap().len(), 1);
    }
    let answer = coface_reading(&["pi1", "-", "--json", "--subgroups", "3"], PLANE).json();
    let component = &answer["components"][0];
    assert_eq!(component["subgroups"][1], json!({ "index": 2, "subgroups": 1, "classes": 1 }));
    assert_eq!(component["subgroups"][2]["subgroups"], 0);
    assert_eq!(component["homomorphisms"]["S3"], json!({ "all": 4, "onto": 0 }));
    assert_eq!(component["homomorphisms"]["A5"], json!({ "all": 16, "onto": 0 }));
}

#[test]
fn loops_are_closed_paths_at_the_base() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("loops.json");
    let answer =
        coface_reading(&["pi1", "-", "--json", "--base", "4", "--loops", argument(&path)], PLANE).json();
    assert_eq!(answer["components"][0]["base"], 4);
    let loops: Value = serde_json::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
    let loops: Vec<Vec<u32>> = serde_json::from_value(loops["loops"].clone()).unwrap();
    assert_eq!(loops.len(), 1);
    assert_eq!((loops[0].first(), loops[0].last()), (Some(&4), Some(&4)));
    // All vertices are neighbors in this plane: a shortest loop has three steps.
    assert_eq!(loops[0].len(), 4);
    // A facet list has no positions to draw lines with.
    let drawing = folder.path().join("loops.obj");
    let run = coface_reading(&["pi1", "-", "--loops", argument(&drawing)], PLANE);
    assert!(run.fails_with(1).contains("write them as .json"), "{}", run.stderr);
    assert!(!drawing.exists());
}

#[test]
fn loops_of_meshes_are_lines() {
    let folder = tempfile::tempdir().unwrap();
    let (mesh, lines) = (folder.path().join("rim.obj"), folder.path().join("lines.obj"));
    std::fs::write(&mesh, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nl 1 2 3 4 1\n").unwrap();
    let answer = coface(&["pi1", argument(&mesh), "--json", "--loops", argument(&lines)]).json();
    assert_eq!(answer["components"][0]["name"], "Z");
    let text = std::fs::read_to_string(&lines).unwrap();
    let line = text.lines().find(|line| line.starts_with("l ")).unwrap();
    assert_eq!(line.split(' ').count(), 6);
}

#[test]
fn people_get_a_page() {
    let page = coface_reading(&["pi1", "-", "--simplify", "--subgroups", "2"], PLANE);
    assert_eq!(page.status, 0, "{}", page.stderr);
    for part in ["fundamental group of standard input", "Z/2", "x1^2", "agrees with H_1", "maps to S3"] {
        assert!(page.stdout.contains(part), "{part} is not in {}", page.stdout);
    }
    let empty = coface_reading(&["pi1", "-", "--json"], b"{\"facets\":[]}").json();
    assert_eq!(empty["components"], json!([]));
}

#[test]
fn what_has_no_loops_is_said() {
    let chains = br#"{"boundaries":[{"rows":1,"cols":1,"entries":[]}]}"#;
    let run = coface_reading(&["pi1", "-"], chains);
    assert!(run.fails_with(1).contains("give the complex as facets"), "{}", run.stderr);
    let run = coface_reading(&["pi1", "-", "--base", "9"], PLANE);
    assert!(run.fails_with(1).contains("there is no vertex 9"), "{}", run.stderr);
    coface_reading(&["pi1", "-", "--subgroups", "0"], PLANE).fails_with(2);
}
