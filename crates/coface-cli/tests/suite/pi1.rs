//! `coface pi1`: groups, loops, counts, faults.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_reading};
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
fn named_spaces_name_their_groups() {
    let answer = coface_reading(&["pi1", "-", "--json"], b"kLAMzMzkbccdefghijjemkihhqqhxj\n").json();
    let component = &answer["components"][0];
    assert_eq!(component["name"], "(semidirect product of Z/37 by Z/8, acting by inversion) x Z/13");
    assert_eq!(component["space"]["name"], "SFS [S2: (2,1) (2,1) (37,-11)]");
    assert_eq!(component["abelianization"], json!({ "betti": 0, "torsion": [104] }));
    assert_eq!(component.get("unrecognized"), None);
    let page = coface_reading(&["pi1", "-"], b"kLAMzMzkbccdefghijjemkihhqqhxj\n");
    assert!(page.stdout.contains("the space is SFS [S2: (2,1) (2,1) (37,-11)]"), "{}", page.stdout);
    // The complement of the figure-eight knot.
    let knot = coface_reading(&["pi1", "-", "--json"], b"cPcbbbiht\n").json();
    assert_eq!(knot["components"][0]["name"], Value::Null);
    assert_eq!(knot["components"][0]["unrecognized"], "no_rule");
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

/// The torus with 7 vertices.
fn torus() -> Vec<u8> {
    let facets = (0..7).flat_map(|i| [[i, i + 1, i + 3], [i, i + 2, i + 3]].map(|t| t.map(|v| v % 7)));
    json!(facets.collect::<Vec<_>>()).to_string().into_bytes()
}

#[test]
fn loops_of_surfaces_are_shortest_or_canonical() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("loops.json");
    let options = ["pi1", "-", "--json", "--shortest", "--base", "5", "--loops", argument(&path), "--quiet"];
    let answer = coface_reading(&options, &torus()).json();
    let component = &answer["components"][0];
    assert_eq!((&component["base"], &component["name"]), (&json!(5), &json!("Z^2")));
    assert_eq!(component["lengths"], json!([3.0, 3.0]));
    let loops: Value = serde_json::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
    for path in loops["loops"].as_array().unwrap() {
        assert_eq!((path.as_array().unwrap().len(), &path[0], &path[3]), (4, &json!(5), &json!(5)));
    }
    let answer = coface_reading(&["pi1", "-", "--json", "--canonical"], &torus()).json();
    assert_eq!(answer["components"][0]["relators"], json!([[1, 2, -1, -2]]));
    let answer = coface_reading(&["pi1", "-", "--json", "--canonical"], PLANE).json();
    assert_eq!(answer["components"][0]["relators"], json!([[1, 1]]));
    // With positions, lengths are those of the drawing: a strip of squares around a hole of 3 by 3.
    let mesh = folder.path().join("ring.obj");
    let mut text = String::new();
    for y in 0..4 {
        for x in 0..4 {
            text += &format!("v {x} {y} 0\n");
        }
    }
    let corner = |x: u32, y: u32| 4 * y + x + 1;
    for (x, y) in (0..9).map(|i| (i % 3, i / 3)).filter(|&square| square != (1, 1)) {
        let corners = [corner(x, y), corner(x + 1, y), corner(x + 1, y + 1), corner(x, y + 1)];
        text += &format!("f {} {} {} {}\n", corners[0], corners[1], corners[2], corners[3]);
    }
    std::fs::write(&mesh, text).unwrap();
    let answer = coface(&["pi1", argument(&mesh), "--json", "--shortest", "--base", "5"]).json();
    assert_eq!(answer["components"][0]["lengths"], json!([4.0]));
    assert_eq!(answer["components"][0]["name"], "Z");
    let page = coface_reading(&["pi1", "-", "--shortest", "--quiet"], &torus());
    assert!(page.stdout.contains("lengths"), "{}", page.stdout);
    // A book of three pages is no surface.
    let run = coface_reading(&["pi1", "-", "--shortest"], b"[[0,1,2],[0,1,3],[0,1,4]]");
    assert!(run.fails_with(1).contains("is on 3 sides of faces"), "{}", run.stderr);
}

#[test]
fn walks_are_compared() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("walks.json");
    let compare = |walks: Value| {
        std::fs::write(&path, json!({ "walks": walks }).to_string()).unwrap();
        coface_reading(&["pi1", "-", "--json", "--walks", argument(&path)], &torus())
    };
    // A rim of a triangle, a loop, the same loop from another vertex, another loop, a commutator.
    let answer =
        compare(json!([[0, 1, 3, 0], [0, 1, 2, 3, 4, 5, 6, 0], [3, 4, 5, 6, 0, 1, 2, 3], [0, 1, 2, 0], [4]]))
            .json();
    let walks = &answer["walks"];
    let contractible: Vec<bool> = (0..5).map(|i| walks[i]["contractible"].as_bool().unwrap()).collect();
    assert_eq!(contractible, [true, false, false, false, true]);
    assert_eq!(walks[0]["homology"], json!([0, 0]));
    assert_eq!(walks[1]["homology"], walks[2]["homology"]);
    let pair = |i: usize, j: usize| {
        let pairs = answer["pairs"].as_array().unwrap();
        pairs.iter().find(|pair| pair["walks"] == json!([i, j])).unwrap()
    };
    assert_eq!(
        pair(1, 2),
        &json!({ "walks": [1, 2], "homotopic": null, "freely_homotopic": true, "homologous": true })
    );
    assert_eq!(pair(0, 1)["homotopic"], false);
    assert_eq!(pair(0, 4)["freely_homotopic"], true);
    let run = compare(json!([[0, 1, 0], [0, 1]]));
    assert!(run.fails_with(1).contains("walk 2 starts at vertex 0 but ends at 1"), "{}", run.stderr);
    let run = compare(json!([[0, 9, 0]]));
    assert!(run.fails_with(1).contains("walk 1 goes through vertex 9"), "{}", run.stderr);
    // Two triangles apart: no edge between them.
    std::fs::write(&path, "[[10,11,12,20,10]]").unwrap();
    let run = coface_reading(&["pi1", "-", "--walks", argument(&path)], b"[[10,11,12],[20,21,22]]");
    assert!(run.fails_with(1).contains("step 3 of walk 1 goes from vertex 12 to 20"), "{}", run.stderr);
}

/// The torus with seven vertices.
const TORUS: &[u8] =
    b"[[0,1,3],[1,2,4],[2,3,5],[3,4,6],[4,5,0],[5,6,1],[6,0,2],[0,2,3],[1,3,4],[2,4,5],[3,5,6],[4,6,0],[5,0,1],[6,1,2]]";

#[test]
fn short_cycles_are_found_on_request() {
    for (kind, count) in [("non-contractible", 1), ("non-separating", 1), ("homology-basis", 2)] {
        let answer = coface_reading(&["pi1", "-", "--json", "--quiet", "--cycles", kind], TORUS).json();
        let cycles = answer["cycles"].as_array().unwrap();
        assert_eq!(cycles.len(), count);
        for cycle in cycles {
            assert_eq!(cycle["length"], 3.0);
            let vertices = cycle["vertices"].as_array().unwrap();
            assert_eq!((vertices.len(), vertices.first()), (4, vertices.last()));
        }
    }
    let through = ["pi1", "-", "--json", "--quiet", "--cycles", "non-contractible", "--through", "5"];
    let cycle = &coface_reading(&through, TORUS).json()["cycles"][0];
    assert!(cycle["vertices"].as_array().unwrap().contains(&5.into()));
    let missing = ["pi1", "-", "--cycles", "non-contractible", "--through", "7"];
    assert!(coface_reading(&missing, TORUS).fails_with(1).contains("no vertex 7"));
    let sphere = coface_reading(
        &["pi1", "-", "--json", "--quiet", "--cycles", "non-contractible"],
        b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]",
    );
    assert_eq!(sphere.json()["cycles"], json!([]));
}
