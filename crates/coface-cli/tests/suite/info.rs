//! `coface info`: what it says of parts and of small models.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{coface, coface_reading};
use serde_json::json;

/// The parts of a file are named where there are several, and the permutations of few halfedges are shown in cycles.
#[test]
fn parts_and_permutations_are_told() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        path.display().to_string()
    };
    let two =
        path("two.obj", "o low\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\no high\nv 0 0 9\nf 4 3 2\nf 4 2 1\n");
    let run = coface(&["info", &two]);
    assert!(
        run.stdout.contains("groups            low  1 polygon; FILE#low is read alone"),
        "{}",
        run.stdout
    );
    assert!(run.stdout.contains("                  high  2 polygons"), "{}", run.stdout);
    let groups = coface(&["info", "--json", &two]).json()["groups"].clone();
    let group = |name: &str, count: usize| json!({"name": name, "of": "polygons", "count": count});
    assert_eq!(groups, json!([group("low", 1), group("high", 2)]));
    assert_eq!(coface(&["info", "--json", &format!("{two}#high")]).json()["f_vector"], json!([4, 5, 2]));
    let halfedges = path("h.json", r#"{"next": [2, 0, 1, 4, 5, 3]}"#);
    let text = coface(&["info", &halfedges]).stdout;
    for line in [
        "next              (0 2 1)(3 4 5)  its cycles are the faces",
        "twin              (0 1)(2 3)(4 5)  its cycles are the edges",
        "next of twin      (0)(1 2 4 3)(5)  its cycles are the vertices",
    ] {
        assert!(text.contains(line), "{text}");
    }
}

/// The trees of a small surface are listed whole, and are what the counts say: n - 1 edges, f - 1 edges, and a generator for each of the rest.
#[test]
fn trees_of_small_surfaces_are_listed() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("torus.off").display().to_string();
    coface(&["generate", "csaszar", "-o", &path, "--json"]).json();
    for options in [&["loops", "--json"][..], &["loops", "--json", "--shortest"]] {
        let trees = coface(&[options, &[&path]].concat()).json()["trees"].clone();
        let count = |key: &str| trees[key].as_array().unwrap().len();
        assert_eq!([count("tree"), count("cotree"), count("generators")], [6, 13, 2], "{options:?}");
    }
    let text = coface(&["loops", &path]).stdout;
    assert!(text.contains("  tree ") && text.contains("edges in neither: each makes a loop"), "{text}");
    coface(&["generate", "torus", "-o", &path, "--json"]).json();
    assert!(coface(&["loops", "--json", &path]).json()["trees"].is_null());
}

/// A vertex that no face uses is no facet: the boundary of the rest is taken, with a remark; a facet of one vertex stays a fault.
#[test]
fn stray_vertices_have_no_part_in_boundaries() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        path.display().to_string()
    };
    let mesh = path("stray.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 5 5 5\nf 1 2 3\n");
    for verb in ["boundary", "interior"] {
        let answer = coface(&[verb, "--json", &mesh]).json();
        let remark = &answer["remarks"][0];
        assert_eq!(
            (&remark["message"], &remark["count"]),
            (&json!("left out: 1 vertex that no face uses"), &json!(1))
        );
    }
    let edges = coface(&["boundary", "--json", &mesh]).json()["simplices"].clone();
    assert_eq!(edges, json!([[0], [1], [2], [0, 1], [0, 2], [1, 2]]));
    let facets = path("facets.json", "[[0, 1, 2], [5]]");
    assert!(coface(&["boundary", &facets]).fails_with(1).contains("not pure"));
}

/// Lines of numbers that begin with the origin are no mesh of nothing.
#[test]
fn points_from_the_origin_are_no_empty_mesh() {
    let folder = tempfile::tempdir().unwrap();
    let points = "0 0 0\n1 0 0\n0 1 0\n";
    let unnamed = folder.path().join("points").display().to_string();
    std::fs::write(&unnamed, points).unwrap();
    assert!(coface(&["info", &unnamed]).fails_with(1).contains("of no format known here"));
    // Nor are comments alone, unless the name says so.
    std::fs::write(&unnamed, "#ifndef A\n#endif\n").unwrap();
    assert!(coface(&["info", &unnamed]).fails_with(1).contains("nothing but comments"));
    let empty = format!("{unnamed}.obj");
    std::fs::write(&empty, "# nothing\n").unwrap();
    assert_eq!(coface(&["info", "--json", &empty]).json()["f_vector"], json!([]));
    let named = format!("{unnamed}.xyz");
    std::fs::write(&named, points).unwrap();
    assert_eq!(coface(&["info", "--json", &named]).json()["f_vector"], json!([3]));
}

/// Every fault of a polygon of a drawing is said, with its place and the words of other programs.
#[test]
fn polygons_of_drawings_are_checked() {
    let info = |text: &str| coface_reading(&["info", "-", "--json"], text.as_bytes()).json();
    let valid = info("POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 1 2, 2 1, 1 1))");
    assert_eq!(
        valid["polygons"],
        json!({"count": 1, "valid": true, "reason": null, "faults": [], "reversed_rings": 0})
    );
    assert_eq!(valid["remarks"], json!([]));
    for (text, name, reason, place) in [
        (
            "POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))",
            "ring_crosses_itself",
            "Self-intersection[1 1]",
            json!([[0, 0]]),
        ),
        (
            "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0), (0 1, 0 2, 2 1, 0 1))",
            "rings_overlap",
            "Self-intersection[0 1]",
            json!([[0, 0], [0, 1]]),
        ),
        (
            "MULTIPOLYGON (((0 0, 9 0, 9 9, 0 9, 0 0)), ((2 2, 3 2, 3 3, 2 2)))",
            "polygons_nested",
            "Nested shells[2 2]",
            json!([[1, 0], [0, 0]]),
        ),
        (
            "POLYGON ((0 0, 1 1, 0 0, 1 1, 0 0))",
            "too_few_points",
            "Too few points in geometry component[0 0]",
            json!([[0, 0]]),
        ),
    ] {
        let found = info(text);
        let fault = &found["polygons"]["faults"][0];
        assert_eq!((&fault["name"], &found["polygons"]["reason"]), (&json!(name), &json!(reason)), "{text}");
        assert_eq!(fault["places"][0]["rings"], place, "{text}");
        assert_eq!(found["polygons"]["valid"], json!(false));
        let problem = &found["problems"][0];
        assert_eq!((&problem["kind"], &problem["message"]), (&fault["name"], &fault["message"]));
        assert_eq!(
            (&problem["count"], &problem["points"][0]),
            (&fault["count"], &fault["places"][0]["point"])
        );
        assert_eq!(found["remarks"][0]["code"], json!("invalid-polygon"));
        assert_eq!(found["remarks"][0]["message"], fault["message"]);
        let page = coface_reading(&["info", "-"], text.as_bytes()).stdout;
        assert!(!page.contains("No problems"), "{page}");
    }
    // Polygons of several geometries may overlap: they are not one.
    let two = info("POLYGON ((0 0, 2 0, 2 2, 0 0))\nPOLYGON ((1 0, 3 0, 3 2, 1 0))");
    assert_eq!((&two["polygons"]["valid"], &two["polygons"]["count"]), (&json!(true), &json!(2)));
    let reversed = info("POLYGON ((0 0, 0 1, 1 1, 0 0))");
    assert_eq!(reversed["polygons"]["reversed_rings"], json!(1));
}
