//! The verbs of surfaces, and the data on cells that they write.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_reading};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// The torus with seven vertices.
const TORUS: &str = r#"{"facets":[[0,1,3],[1,2,4],[2,3,5],[3,4,6],[4,5,0],[5,6,1],[6,0,2],
    [0,2,3],[1,3,4],[2,4,5],[3,5,6],[4,6,0],[5,0,1],[6,1,2]]}"#;
/// The projective plane with six vertices.
const PLANE: &str =
    r#"{"facets":[[0,1,2],[0,1,5],[0,2,4],[0,3,4],[0,3,5],[1,2,3],[1,3,4],[1,4,5],[2,3,5],[2,4,5]]}"#;
/// An octahedron with positions.
const OCTAHEDRON: &str = "OFF\n6 8 0\n1 0 0\n-1 0 0\n0 1 0\n0 -1 0\n0 0 1\n0 0 -1\n3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n\
    3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n";
/// The surface of genus 2 made of one octagon, a b a^-1 b^-1 c d c^-1 d^-1.
const OCTAGON: &str = r#"{"next":[2,3,1,4,6,7,5,0]}"#;

/// A model that is shipped in `data/`.
fn shipped(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(name)
}

fn reading(arguments: &[&str], input: &str) -> Value {
    coface_reading(arguments, input.as_bytes()).json()
}

fn keys_of(value: &Value, keys: &[&str]) -> Vec<Value> {
    keys.iter().map(|key| value[key].clone()).collect()
}

#[test]
fn data_on_cells_are_told_and_kept_where_the_format_can() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(
        path("a.ply"),
        "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n\
         element face 1\nproperty list uchar int vertex_indices\nproperty double weight\nelement edge 1\nproperty int vertex1\n\
         property int vertex2\nproperty int end_0\nproperty int end_1\nend_header\n0 0 0 0\n1 0 0 7\n0 1 0 255\n3 0 1 2 0.25\n0 1 -3 4\n",
    )
    .unwrap();
    let expected = json!([
        {"name": "red", "on": "vertices", "components": 1, "type": "integer", "range": [0.0, 255.0]},
        {"name": "weight", "on": "polygons", "components": 1, "type": "real", "range": [0.25, 0.25]},
        {"name": "end", "on": "lines", "components": 2, "type": "integer", "range": [-3.0, 4.0]},
    ]);
    assert_eq!(coface(&["info", "--json", argument(&path("a.ply"))]).json()["data"], expected);
    let page = coface(&["info", argument(&path("a.ply"))]).stdout;
    assert!(page.contains("end on lines  2 integers each, -3 to 4"), "{page}");
    let converted = coface(&["convert", argument(&path("a.ply")), "-o", argument(&path("b.ply"))]);
    assert!(converted.stderr.is_empty(), "{}", converted.stderr);
    assert_eq!(coface(&["info", "--json", argument(&path("b.ply"))]).json()["data"], expected);
    let converted = coface(&["convert", argument(&path("a.ply")), "-o", argument(&path("b.obj"))]);
    assert!(converted.stderr.contains("OBJ does not keep data on cells: 3 left out"), "{}", converted.stderr);
    coface(&["convert", argument(&path("a.ply")), "-o", argument(&path("b.vtk"))]);
    let data = coface(&["info", "--json", argument(&path("b.vtk"))]).json()["data"].clone();
    // VTK has one array over all cells.
    assert_eq!(data.as_array().unwrap().len(), 5);
    assert!(data.as_array().unwrap().contains(&expected[0]));
}

#[test]
fn data_that_a_format_cannot_hold_leave_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(
        path("a.vtk"),
        "# vtk DataFile Version 3.0\nt\nASCII\nDATASET POLYDATA\nPOINTS 3 float\n0 0 0 1 0 0 0 1 0\nPOLYGONS 1 4\n3 0 1 2\n\
         POINT_DATA 3\nSCALARS big vtktypeint64\nLOOKUP_TABLE default\n0 1 1099511627776\n",
    )
    .unwrap();
    let run = coface(&["convert", argument(&path("a.vtk")), "-o", argument(&path("b.ply"))]);
    let message = run.fails_with(1);
    assert!(message.contains("the data \"big\" on vertices have larger ones; write VTK"), "{message}");
    assert!(!path("b.ply").exists());
}

#[test]
fn surfaces_are_cut_to_disks() {
    let component = |arguments: &[&str], input: &str| reading(arguments, input)["components"][0].clone();
    let numbers = ["cut_edges", "boundary_edges", "euler_characteristic"];
    let torus = component(&["cut", "-", "--json"], TORUS);
    assert_eq!(keys_of(&torus, &numbers), [8, 16, 1]);
    assert_eq!(torus["f_vector"], json!([16, 29, 14]));
    assert_eq!((torus["surface"].as_str(), torus["generators"].as_i64()), (Some("torus"), Some(2)));
    assert_eq!(torus["relator"].as_array().unwrap().len(), 4);
    let sphere = component(&["cut", "-", "--json"], OCTAHEDRON);
    assert_eq!(keys_of(&sphere, &numbers), [5, 10, 1]);
    assert_eq!(sphere["relator"], json!([]));
    let sphere = component(&["cut", "-", "--json", "--simplify"], OCTAHEDRON);
    // A slit of two edges stays open when edges are told by their ends.
    assert_eq!(keys_of(&sphere, &numbers), [2, 4, 1]);
    assert_eq!(sphere["seams"][0]["kind"], "slit");
    let plane = component(&["cut", "-", "--json", "--simplify"], PLANE);
    assert_eq!(keys_of(&plane, &numbers), [3, 6, 1]);
    assert_eq!(plane["seams"][0]["kind"], "crosscap");
    assert_eq!(plane["word"][0], plane["word"][1]);
    let band = coface(&["cut", "--simplify", "--json", argument(&shipped("moebius.obj"))]).json();
    assert_eq!(band["components"][0]["euler_characteristic"], 1);
    let disk = component(&["cut", "-", "--json", "--simplify"], "[[0,1,2],[1,2,3]]");
    assert_eq!(keys_of(&disk, &numbers), [0, 4, 1]);
    assert_eq!(reading(&["cut", "-", "--json"], "OFF\n1 0 0\n0 0 0\n")["components"], json!([]));
    // Each seam is met twice around the domain.
    for input in [TORUS, PLANE, OCTAHEDRON] {
        let component = component(&["cut", "-", "--json"], input);
        assert_eq!(
            component["word"].as_array().unwrap().len(),
            2 * component["seams"].as_array().unwrap().len()
        );
    }
    let page = coface(&["cut", argument(&shipped("spot.obj"))]).stdout;
    assert!(page.contains("sphere") && page.contains("it is a disk"), "{page}");
}

#[test]
fn surfaces_are_cut_to_canonical_polygons() {
    let cut = |input: &str| reading(&["cut", "-", "--canonical", "--json"], input);
    let annulus = "[[0,1,3],[1,4,3],[1,2,4],[2,5,4],[2,0,5],[0,3,5]]";
    for (input, word, seams) in [
        (TORUS, "a1 b1 a1^-1 b1^-1", 2),
        (PLANE, "c1 c1", 1),
        (OCTAHEDRON, "s1 s1^-1", 1),
        ("[[0,1,2],[1,2,3]]", "d1", 0),
        (annulus, "e1 d1 e1^-1 e2 d2 e2^-1", 2),
    ] {
        let answer = cut(input);
        let component = &answer["components"][0];
        assert_eq!((&component["canonical"], &component["euler_characteristic"]), (&json!(word), &json!(1)));
        assert_eq!(component["seams"].as_array().unwrap().len(), seams);
        // Each seam is on two sides of the disk; the rest of its boundary was there before.
        let edges = |key: &str| component[key].as_i64().unwrap();
        assert!(edges("boundary_edges") >= 2 * edges("cut_edges"));
        let [v, e, f] = [0, 1, 2].map(|degree| answer["refinement"]["f_vector"][degree].as_i64().unwrap());
        let whole = reading(&["info", "-", "--json"], input)["euler_characteristic"].clone();
        assert_eq!(json!(v - e + f), whole);
        for vertex in answer["refinement"]["vertices"].as_array().unwrap() {
            let weights = vertex["weights"].as_array().unwrap().iter().map(|weight| weight.as_f64().unwrap());
            assert!((weights.sum::<f64>() - 1.0).abs() < 1e-12);
        }
    }
    let base = reading(&["cut", "-", "--canonical", "--json", "--base", "4"], TORUS);
    assert_eq!(base["components"][0]["base"], 4);
    for seam in base["components"][0]["seams"].as_array().unwrap() {
        let vertices = seam["vertices"].as_array().unwrap();
        assert_eq!((&vertices[0], &vertices[vertices.len() - 1]), (&json!(4), &json!(4)));
    }
    let refused = coface_reading(&["cut", "-", "--canonical", "--base", "1"], annulus.as_bytes());
    assert!(refused.fails_with(1).contains("it is on the boundary"));
    let page = coface_reading(&["cut", "-", "--canonical"], TORUS.as_bytes()).stdout;
    assert!(page.contains("a1 b1 a1^-1 b1^-1") && page.contains("added"), "{page}");
}

#[test]
fn canonical_polygons_keep_the_surface() {
    let folder = tempfile::tempdir().unwrap();
    let [triple, out] = ["triple.off", "cut.ply"].map(|name| folder.path().join(name));
    coface(&["generate", "genus", "--genus", "3", "-o", argument(&triple)]);
    // Quadrangles that are not flat have another area in pieces.
    let moebius = shipped("moebius.obj");
    let handles = "a1 b1 a1^-1 b1^-1 a2 b2 a2^-1 b2^-1 a3 b3 a3^-1 b3^-1";
    for (path, word, tolerance) in [(&triple, handles, 1e-9), (&moebius, "c1 c1 e1 d1 e1^-1", 1e-3)] {
        let answer = coface(&["cut", "--canonical", "--json", argument(path), "-o", argument(&out)]).json();
        assert_eq!(answer["components"][0]["canonical"], word);
        let report = coface(&["info", "--json", argument(&out)]).json();
        assert_eq!((&report["name"], &report["f_vector"]), (&json!("disk"), &answer["f_vector"]));
        let area = |path: &Path| coface(&["info", "--json", argument(path)]).json()["area"].as_f64().unwrap();
        let (before, after) = (area(path), area(&out));
        assert!((before - after).abs() < tolerance * before, "{before} {after}");
    }
}

#[test]
fn canonical_polygons_are_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    coface(&["generate", "genus", "--genus", "2", "-o", argument(&path("double.off"))]);
    std::fs::write(path("plane.json"), PLANE).unwrap();
    std::fs::write(path("octahedron.off"), OCTAHEDRON).unwrap();
    std::fs::write(path("octagon.json"), OCTAGON).unwrap();
    std::fs::write(path("annulus.json"), "[[0,1,3],[1,4,3],[1,2,4],[2,5,4],[2,0,5],[0,3,5]]").unwrap();
    std::fs::write(path("two.json"), "[[0,1,2],[1,2,3],[10,11,12]]").unwrap();
    for name in ["double.off", "plane.json", "octahedron.off", "octagon.json", "annulus.json", "two.json"] {
        let out = path("drawn.ply");
        let answer =
            coface(&["cut", argument(&path(name)), "--layout", "polygon", "--json", "-o", argument(&out)])
                .json();
        assert_eq!(
            (&answer["layout"]["plane"], &answer["layout"]["turned"]),
            (&json!("polygon"), &json!(0)),
            "{name}"
        );
        let report = coface(&["info", "--json", argument(&out)]).json();
        assert_eq!(report["f_vector"], answer["f_vector"], "{name}");
        // Regular polygons in circles of radius 1; a disk has as many corners as edges around it.
        let area = report["area"].as_f64().unwrap();
        let corners = match name {
            "double.off" | "octagon.json" => 8,
            "annulus.json" => 6,
            "two.json" => continue,
            _ => answer["components"][0]["boundary_edges"].as_u64().unwrap(),
        };
        let expected = corners as f64 / 2.0 * (std::f64::consts::TAU / corners as f64).sin();
        assert!((area - expected).abs() < 1e-9, "{name}: {area} {expected}");
    }
    // Regular octagons whose corners have 45 degrees: the distance of the corners is that of the hyperbolic plane.
    let out = path("klein.json");
    let answer =
        coface(&["cut", argument(&path("double.off")), "--layout", "klein", "--json", "-o", argument(&out)])
            .json();
    assert_eq!((&answer["layout"]["plane"], &answer["layout"]["turned"]), (&json!("klein"), &json!(0)));
    let drawn: Value = serde_json::from_slice(&std::fs::read(&out).unwrap()).unwrap();
    let far = drawn["positions"].as_array().unwrap().iter().map(|point| {
        let [x, y] = [0, 1].map(|axis| point[axis].as_f64().unwrap());
        x.hypot(y)
    });
    let cotangent = (std::f64::consts::PI / 8.0).tan().recip();
    assert!((far.fold(0.0, f64::max) - (1.0 - cotangent.powi(-4)).sqrt()).abs() < 1e-12);
    let refused = coface(&["cut", argument(&path("annulus.json")), "--layout", "klein"]);
    let refused = refused.fails_with(1);
    assert!(refused.contains("is this surface: annulus") && refused.contains("layout polygon"), "{refused}");
    let page = coface(&["cut", argument(&path("double.off")), "--layout", "klein", "--weights", "cotangent"]);
    assert!(page.stdout.contains("regular in the disk of Klein"), "{}", page.stdout);
}

#[test]
fn layouts_are_texture_coordinates() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    coface(&["generate", "genus", "--genus", "2", "-o", argument(&path("double.off"))]);
    let before = coface(&["info", "--json", argument(&path("double.off"))]).json();
    for (name, is_whole) in [("uv.obj", true), ("uv.ply", false), ("uv.vtk", false)] {
        let answer =
            coface(&["cut", argument(&path("double.off")), "--uv", "--json", "-o", argument(&path(name))])
                .json();
        assert_eq!(answer["layout"]["texture"], true);
        let report = coface(&["info", "--json", argument(&path(name))]).json();
        // In OBJ corners have the coordinates, so that the surface is whole.
        let expected = if is_whole { &answer["refinement"]["f_vector"] } else { &answer["f_vector"] };
        assert_eq!(&report["f_vector"], expected, "{name}");
        let [old, new] = [&before, &report].map(|report| report["area"].as_f64().unwrap());
        assert!((old - new).abs() < 1e-9 * old, "{name}");
    }
    let text = std::fs::read_to_string(path("uv.obj")).unwrap();
    let (mut pairs, mut corners) = (Vec::new(), Vec::new());
    for line in text.lines() {
        match line.split_once(' ') {
            Some(("vt", rest)) => {
                pairs.push(rest.split(' ').map(|x| x.parse().unwrap()).collect::<Vec<f64>>());
            }
            Some(("f", rest)) => {
                corners.extend(
                    rest.split(' ').map(|corner| corner.split_once('/').unwrap().1.parse::<usize>().unwrap()),
                );
            }
            _ => {}
        }
    }
    assert!(pairs.iter().all(|pair| pair.len() == 2 && pair.iter().all(|x| (0.0..=1.0).contains(x))));
    assert_eq!(corners.iter().max(), Some(&pairs.len()));
    coface(&["convert", argument(&path("uv.ply")), "-o", argument(&path("uv.gltf"))]);
    let text = std::fs::read_to_string(path("uv.gltf")).unwrap();
    assert!(text.contains("TEXCOORD_0"), "{}", &text[..400]);
    let bare = coface_reading(&["cut", "-", "--uv", "-o", argument(&path("x.obj"))], TORUS.as_bytes());
    let bare = bare.fails_with(1);
    assert!(bare.contains("has no positions; write .json"), "{bare}");
}

#[test]
fn covers_lie_in_the_disk_of_klein() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    coface(&["generate", "genus", "--genus", "2", "-o", argument(&path("double.off"))]);
    let placed = |layout: &str| -> Vec<[f64; 2]> {
        let out = path("cover.json");
        coface(&[
            "cover",
            argument(&path("double.off")),
            "--radius",
            "1",
            "--layout",
            layout,
            "-q",
            "-o",
            argument(&out),
        ]);
        let cover: Value = serde_json::from_slice(&std::fs::read(&out).unwrap()).unwrap();
        assert_eq!(cover["layout"], layout);
        let point = |point: &Value| [0, 1].map(|axis| point[axis].as_f64().unwrap());
        cover["positions"].as_array().unwrap().iter().map(point).collect()
    };
    for ([x, y], [u, v]) in placed("disk").into_iter().zip(placed("klein")) {
        // The hyperbolic distance from the middle is the same: 2 artanh in one disk, artanh in the other.
        let [near, far] = [2.0 * x.hypot(y).atanh(), u.hypot(v).atanh()];
        assert!((near - far).abs() < 1e-6 * (1.0 + near) && (x * v - y * u).abs() < 1e-12);
    }
    let refused = coface_reading(&["cover", "-", "--radius", "1", "--layout", "klein"], TORUS.as_bytes());
    assert!(refused.fails_with(1).contains("take the layout flat"));
}

#[test]
fn a_cut_mesh_says_where_it_comes_from() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(path("a.off"), OCTAHEDRON).unwrap();
    for name in ["b.vtk", "b.ply"] {
        coface(&["cut", "--simplify", argument(&path("a.off")), "-q", "-o", argument(&path(name))]);
        let report = coface(&["info", "--json", argument(&path(name))]).json();
        assert_eq!((&report["name"], &report["f_vector"]), (&json!("disk"), &json!([7, 14, 8])));
        let data = report["data"].as_array().unwrap();
        let on = |name: &str, on: &str| data.iter().any(|data| data["name"] == name && data["on"] == on);
        assert!(on("source", "vertices") && on("face", "polygons") && on("seam", "lines"), "{data:?}");
        assert!(on("source", "lines"));
    }
    coface(&["cut", argument(&path("a.off")), "-q", "-o", argument(&path("b.json"))]);
    let cut: Value = serde_json::from_slice(&std::fs::read(path("b.json")).unwrap()).unwrap();
    assert_eq!(cut["source"].as_array().unwrap().len(), 10);
    let report = coface(&["info", "--json", argument(&path("b.json"))]).json();
    assert_eq!(report["name"], "disk");
    let remark = coface(&["cut", argument(&path("a.off")), "-o", argument(&path("b.obj"))]).stderr;
    assert!(remark.contains("OBJ does not keep data"), "{remark}");
}

#[test]
fn paths_are_cut_open() {
    let along =
        |path: &str, input: &str| coface_reading(&["cut", "-", "--json", "--along", path], input.as_bytes());
    let annulus = along("0 1 2 0", TORUS).json();
    assert_eq!(annulus["path"], json!({"kind": "two-sided", "edges": 3}));
    assert_eq!(annulus["components"][0]["surface"], "annulus");
    let halves = along("0 2 1 3 0", OCTAHEDRON).json();
    assert_eq!(halves["components"].as_array().unwrap().len(), 2);
    let slit = along("0 2", OCTAHEDRON).json();
    assert_eq!(
        (&slit["path"]["kind"], &slit["components"][0]["boundary_edges"]),
        (&json!("open"), &json!(2))
    );
    for (path, input, message) in [
        ("0 1", OCTAHEDRON, "goes from vertex 0 to vertex 1, but no edge joins them"),
        ("0 9", OCTAHEDRON, "there is no vertex 9"),
        ("0", OCTAHEDRON, "two vertices at least"),
        ("0 x", OCTAHEDRON, "\"x\" is no vertex"),
        ("0 2 0", OCTAHEDRON, "edge"),
        ("0 1 2 0", PLANE, "--along"),
    ] {
        let run = along(path, input);
        if path == "0 1 2 0" && run.status == 0 {
            // It bounds a triangle: two-sided.
            continue;
        }
        let text = run.fails_with(1);
        assert!(text.contains(message), "{text}");
    }
    // A line of the projective plane.
    let text = along("0 1 3 0", PLANE).fails_with(1).to_owned();
    assert!(text.contains("one-sided"), "{text}");
}

#[test]
fn covers_grow_as_their_groups_do() {
    let genus_2 = reading(&["cover", "-", "--json", "--radius", "3"], OCTAGON);
    assert_eq!(genus_2["spheres"], json!([1, 8, 56, 392]));
    assert_eq!((&genus_2["copies"], &genus_2["euler_characteristic"]), (&json!(457), &json!(1)));
    assert_eq!(genus_2["words"].as_array().unwrap().len(), 457);
    let torus = reading(&["cover", "-", "--json", "--copies", "7"], TORUS);
    assert_eq!(torus["spheres"], json!([1, 4, 2]));
    assert_eq!(torus["f_vector"][2], 7 * 14);
    let plane = reading(&["cover", "-", "--json", "--copies", "2"], PLANE);
    assert_eq!(
        keys_of(&plane, &["f_vector", "euler_characteristic", "complete"]),
        [json!([12, 30, 20]), json!(2), json!(true)]
    );
    let double = reading(&["cover", "-", "--json", "--orientation"], PLANE);
    assert_eq!((&double["surfaces"], &double["copies"]), (&json!(["sphere"]), &json!(2)));
    for (arguments, input, message) in [
        (["--radius", "12"], OCTAGON, "copies"),
        (["--copies", "0"], TORUS, "cop"),
        (["--component", "3"], TORUS, "component"),
    ] {
        let mut all = vec!["cover", "-", "--json"];
        all.extend(arguments);
        if arguments[0] == "--component" {
            all.extend(["--radius", "1"]);
        }
        let run = coface_reading(&all, input.as_bytes());
        let text = run.fails_with(1);
        assert!(text.contains(message), "{text}");
    }
    coface_reading(&["cover", "-"], TORUS.as_bytes()).fails_with(2);
}

#[test]
fn covers_are_laid_out_and_project() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("cover.vtk");
    let torus = ["cover", "-", "--json", "--radius", "1", "-o", argument(&out)];
    assert_eq!(reading(&torus, TORUS)["layout"], "flat");
    let report = coface(&["info", "--json", argument(&out)]).json();
    assert_eq!((&report["name"], &report["f_vector"][2]), (&json!("disk"), &json!(70)));
    let data = report["data"].as_array().unwrap();
    let names: Vec<String> = data.iter().map(|data| format!("{} {}", data["name"], data["on"])).collect();
    for name in ["source", "copy"] {
        assert!(names.contains(&format!("\"{name}\" \"vertices\"")), "{names:?}");
    }
    for name in ["face", "copy", "length"] {
        assert!(names.contains(&format!("\"{name}\" \"polygons\"")), "{names:?}");
    }
    let flat = coface_reading(&["cover", "-", "--copies", "1", "--layout", "flat"], OCTAHEDRON.as_bytes());
    flat.fails_with(1);
}

#[test]
fn cocycles_are_dual_to_loops() {
    let torus = reading(&["cocycles", "-", "--json"], TORUS);
    assert_eq!(
        keys_of(&torus, &["rank", "pairing", "determinant", "method"]),
        [json!(2), json!([[1, 0], [0, 1]]), json!(1), json!("crossing")]
    );
    let matrix = &torus["intersection"]["matrix"];
    assert_eq!((matrix[0][0].as_i64(), matrix[0][1].as_i64().map(i64::abs)), (Some(0), Some(1)));
    assert_eq!(torus["intersection"]["determinant"], 1);
    // The values on the loops are the pairing.
    for (i, cocycle) in torus["cocycles"].as_array().unwrap().iter().enumerate() {
        for (j, walk) in torus["loops"].as_array().unwrap().iter().enumerate() {
            let walk: Vec<u64> = walk.as_array().unwrap().iter().map(|v| v.as_u64().unwrap()).collect();
            let terms = cocycle.as_array().unwrap();
            let on = |a: u64, b: u64| -> i64 {
                let found = terms.iter().filter(|term| term[1] == json!([a, b]));
                found.map(|term| term[0].as_i64().unwrap()).sum()
            };
            let value = |from: u64, to: u64| on(from, to) - on(to, from);
            let sum: i64 = walk.windows(2).map(|pair| value(pair[0], pair[1])).sum();
            assert_eq!(sum, i64::from(i == j));
        }
    }
    for method in ["slicing", "general"] {
        let found = reading(&["cocycles", "-", "--json", "--method", method], TORUS);
        assert_eq!(keys_of(&found, &["rank", "determinant"]), [2, 1]);
        assert_eq!(found["pairing"], json!([[1, 0], [0, 1]]));
    }
    let disk = r#"{"facets":[[0,1,2]]}"#;
    assert_eq!(reading(&["cocycles", "-", "--json"], disk)["rank"], 0);
    // A Klein bottle of 5 by 5 squares: one loop of infinite order, and one cocycle dual to it.
    let corner = |i: u32, j: u32| i % 5 * 5 + if i == 5 { (5 - j % 5) % 5 } else { j % 5 };
    let squares = (0..25)
        .map(|k| (k / 5, k % 5))
        .map(|(i, j)| [corner(i, j), corner(i + 1, j), corner(i + 1, j + 1), corner(i, j + 1)]);
    let klein: Vec<[u32; 3]> = squares.flat_map(|[a, b, c, d]| [[a, b, c], [a, c, d]]).collect();
    let klein = reading(&["cocycles", "-", "--json"], &json!(klein).to_string());
    assert_eq!(keys_of(&klein, &["rank", "pairing", "determinant"]), [json!(1), json!([[1]]), json!(1)]);
    let plane = reading(&["cocycles", "-", "--json"], PLANE);
    assert_eq!(keys_of(&plane, &["rank", "pairing", "determinant"]), [json!(0), json!([]), json!(1)]);
    coface_reading(&["cocycles", "-", "--method", "slicing"], PLANE.as_bytes()).fails_with(1);
    let band = coface(&["cocycles", "--harmonic", "--json", argument(&shipped("moebius.obj"))]).json();
    assert_eq!((&band["rank"], &band["weights"]), (&json!(1), &json!("uniform")));
    assert_eq!(
        band["harmonic"][0]["values"].as_array().unwrap().len(),
        band["edges"].as_array().unwrap().len()
    );
    // A complex that is no surface.
    let book = r#"[[0,1],[1,2],[0,2],[0,3],[2,3]]"#;
    assert_eq!(
        keys_of(&reading(&["cocycles", "-", "--json"], book), &["rank", "method"]),
        [json!(2), json!("general")]
    );
}

#[test]
fn cochains_are_tested_with_proof() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("w.json");
    let test = |cochain: &str, input: &str, more: &[&str]| {
        std::fs::write(&file, cochain).unwrap();
        let arguments = [&["cocycles", "-", "--json", "--test", argument(&file)], more].concat();
        coface_reading(&arguments, input.as_bytes())
    };
    let rim = "[[0,1],[1,2],[0,2]]";
    let exact = test("[[1,[0,1]],[1,[0,2]]]", rim, &[]).json();
    assert_eq!(keys_of(&exact, &["closed", "exact"]), [true, true]);
    assert_eq!(exact["potential"], json!([[1, [1]], [1, [2]]]));
    let closed = test("[[-3,[1,0]]]", rim, &[]).json();
    assert_eq!(keys_of(&closed, &["closed", "exact"]), [true, false]);
    assert_eq!(
        (closed["period"].as_i64().map(i64::abs), closed["walk"].as_array().unwrap().len()),
        (Some(3), 4)
    );
    let open = test("[[1,[0,1]]]", "[[0,1,2]]", &[]).json();
    assert_eq!(keys_of(&open, &["closed", "exact"]), [false, false]);
    assert_eq!(open["face"], json!([0, 1, 2]));
    let real = test("[[0.5,[0,1]],[0.5,[1,2]],[1.0,[0,2]]]", rim, &["--tolerance", "1e-9"]).json();
    assert_eq!(real["exact"], true);
    let text = test("[[0.5,[0,1]]]", rim, &[]).fails_with(1).to_owned();
    assert!(text.contains("--tolerance"), "{text}");
    let text = test("[[1,[0,7]]]", rim, &[]).fails_with(1).to_owned();
    assert!(text.contains("w.json"), "{text}");
}

#[test]
fn values_on_edges_are_written() {
    let folder = tempfile::tempdir().unwrap();
    let band = shipped("moebius.obj");
    for name in ["w.vtk", "w.ply"] {
        let out = folder.path().join(name);
        coface(&["cocycles", "--harmonic", "-q", argument(&band), "-o", argument(&out)]);
        let report = coface(&["info", "--json", argument(&out)]).json();
        let data = report["data"].as_array().unwrap();
        let on_lines = |name: &str| data.iter().any(|data| data["name"] == name && data["on"] == "lines");
        assert!(on_lines("cocycle_1") && on_lines("harmonic_1"), "{data:?}");
    }
    let text =
        coface_reading(&["cocycles", "-", "-o", argument(&folder.path().join("t.vtk"))], TORUS.as_bytes());
    assert!(text.fails_with(1).contains("write the cocycles as .json"));
}

#[test]
fn what_is_no_surface_is_refused_with_the_cure() {
    let fan = shipped("fan3.obj");
    for verb in [&["cut"][..], &["cover", "--radius", "1"]] {
        let run = coface(&[verb, &[argument(&fan)]].concat());
        let text = run.fails_with(1);
        assert!(text.contains("is on 3 sides of faces") && text.contains("--split-edges"), "{text}");
    }
    let beam = shipped("beam_h5t12.mesh");
    let text = coface(&["cut", argument(&beam)]).fails_with(1).to_owned();
    assert!(text.contains("--boundary"), "{text}");
    let text = coface(&["cut", "--boundary", argument(&beam)]).fails_with(1).to_owned();
    assert!(text.contains("the boundary is no surface") && !text.contains("--split"), "{text}");
    let cylinder = shipped("cylinder.vtk");
    let report = coface(&["cut", "--boundary", "--simplify", "--json", argument(&cylinder)]).json();
    assert_eq!(report["components"][0]["euler_characteristic"], 1);
    let text = coface_reading(&["cut", "-", "--base", "77"], TORUS.as_bytes()).fails_with(1).to_owned();
    assert!(text.contains("there is no vertex 77"), "{text}");
}

#[test]
fn halfedges_become_facet_lists_with_labels() {
    let folder = tempfile::tempdir().unwrap();
    let [facets, labels] = ["facets.json", "labels.json"].map(|name| folder.path().join(name));
    // The torus with one vertex, of two triangles: it takes the second subdivision.
    let torus = br#"{"next":[2,3,4,5,0,1]}"#;
    let words =
        ["convert", "-", "--triangulate", "--labels", argument(&labels), "-o", argument(&facets), "--quiet"];
    assert_eq!(coface_reading(&words, torus).status, 0);
    let answer = coface(&["info", argument(&facets), "--json"]).json();
    assert_eq!((&answer["name"], &answer["f_vector"][2]), (&"torus".into(), &72.into()));
    let labels: Value = serde_json::from_str(&std::fs::read_to_string(&labels).unwrap()).unwrap();
    let labels = labels["carriers"].as_array().unwrap();
    assert_eq!(labels.iter().filter(|label| label[0] == 0).count(), 1, "the one vertex");
    assert_eq!(labels.iter().filter(|label| label[0] == 1).count(), 9, "three in each edge");
}

#[test]
fn more_than_a_finite_cover_gives_all_of_it() {
    let sphere = reading(&["cover", "-", "--json", "--radius", "9"], PLANE);
    assert_eq!(
        keys_of(&sphere, &["copies", "complete", "euler_characteristic"]),
        [json!(2), json!(true), json!(2)]
    );
    let disk = reading(&["cover", "-", "--json", "--radius", "4"], "[[0,1,2],[1,2,3]]");
    assert_eq!(
        keys_of(&disk, &["copies", "complete", "euler_characteristic"]),
        [json!(1), json!(true), json!(1)]
    );
    let copies = reading(&["cover", "-", "--json", "--copies", "25"], PLANE);
    assert_eq!(
        keys_of(&copies, &["copies", "complete", "f_vector"]),
        [json!(2), json!(true), json!([12, 30, 20])]
    );
}

#[test]
fn seams_are_named_as_the_surface_is() {
    // The Klein bottle of one square: it has no handle, so that no seam opens one.
    let folder = tempfile::tempdir().unwrap();
    let klein = folder.path().join("klein.obj");
    coface(&["generate", "klein", "-o", argument(&klein)]);
    let seams =
        coface(&["cut", argument(&klein), "--simplify", "--json"]).json()["components"][0]["seams"].clone();
    let seams = seams.as_array().unwrap();
    assert!(seams.iter().all(|seam| seam["kind"] == "crosscap"), "{seams:?}");
    assert!(seams.iter().any(|seam| seam["glued"] == "moebius"), "{seams:?}");
    let page = coface_reading(&["cut", "-", "--simplify"], OCTAGON.as_bytes()).stdout;
    assert!(page.contains("one of 4 seams that open 2 handles"), "{page}");
    let page = coface_reading(&["cut", "-", "--simplify"], PLANE.as_bytes()).stdout;
    assert!(page.contains("it opens the cross-cap"), "{page}");
}

#[test]
fn cut_names_isolated_vertices() {
    let text = "OFF\n5 4 0\n9 9 9\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 1 3 2\n3 1 2 4\n3 2 3 4\n3 3 1 4\n";
    for along in [&["--simplify"][..], &["--along", "1 2 3 1"]] {
        let run = coface_reading(&[&["cut", "-", "--json"], along].concat(), text.as_bytes());
        let remark = &run.json()["remarks"][0];
        assert_eq!((&remark["code"], &remark["count"]), (&json!("isolated-vertex"), &json!(1)));
        assert!(
            run.stderr.contains("1 isolated vertex in no face") && run.stderr.contains("(0)"),
            "{}",
            run.stderr
        );
    }
}

#[test]
fn paths_that_cannot_be_cut_are_named_by_vertices_of_the_file() {
    let strip = r#"{"facets":[[10,11,14],[10,14,13],[11,12,15],[11,15,14]]}"#;
    let fault = |path: &str| {
        coface_reading(&["cut", "-", "--along", path], strip.as_bytes()).fails_with(1).to_owned()
    };
    assert!(
        fault("10 11 14").contains("step 1 from vertex 10 to 11 runs along the boundary"),
        "{}",
        fault("10 11 14")
    );
    assert!(fault("11 14 11").contains("steps 1 and 2 both run along the edge of vertices 11 and 14"));
    assert!(fault("11 14 10 11").contains("step 3 from vertex 10 to 11 runs along the boundary"));
    assert!(fault("14 10 11 14 13").contains("the path comes through vertex 14 twice"));
    assert!(fault("10 12").contains("step 1 goes from vertex 10 to vertex 12"));
}

#[test]
fn boundaries_that_touch_are_told_as_walks() {
    let page = coface_reading(&["info", "-"], b"[[0,1,2],[0,3,4]]").stdout;
    assert!(page.contains("loop 1: 6 edges  2 walks that touch"), "{page}");
    assert!(page.contains("3 edges  v0 v1 v2 v0") && page.contains("3 edges  v0 v3 v4 v0"), "{page}");
    assert!(!page.contains("not a simple loop"), "{page}");
}

/// Four triangles around one with a boundary of six edges, as a course on surface topology has them: boundary halfedges have no twin.
const FIGURE: &str =
    r#"{"next":[5,10,1,11,3,9,8,6,7,0,2,4],"twin":[null,null,null,null,null,null,9,10,11,6,7,8]}"#;

#[test]
fn halfedges_without_twins_are_boundaries() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(path("figure.json"), FIGURE).unwrap();
    let report = coface(&["info", "--json", argument(&path("figure.json"))]).json();
    assert_eq!(
        keys_of(&report, &["name", "f_vector", "boundary_loops"]),
        [json!("disk"), json!([6, 9, 4]), json!(1)]
    );
    assert_eq!(report["halfedges"][0]["next"], 5);
    assert_eq!(
        (&report["halfedges"][12]["outer"], &report["halfedges"][12]["face"]),
        (&json!(true), &json!(4))
    );
    let page = coface(&["info", argument(&path("figure.json"))]).stdout;
    assert!(page.contains("h0: next h5, twin h12") && page.contains("outer face f4"), "{page}");
    // What is written is read as the same surface; -1 and the halfedge itself stand for no twin too.
    coface(&["convert", argument(&path("figure.json")), "-o", argument(&path("again.json"))]);
    let again = coface(&["info", "--json", argument(&path("again.json"))]).json();
    assert_eq!(again["halfedges"], report["halfedges"]);
    let own: Vec<i32> = (0..12)
        .map(|h| {
            if h < 6 {
                h
            } else if h < 9 {
                h + 3
            } else {
                h - 3
            }
        })
        .collect();
    for twin in [
        FIGURE.replace("null", "-1"),
        FIGURE.replace(&FIGURE[FIGURE.find("\"twin\"").unwrap()..], &format!("\"twin\":{own:?}}}")),
    ] {
        assert_eq!(reading(&["info", "-", "--json"], &twin)["halfedges"], report["halfedges"]);
    }
    let error = coface_reading(&["info", "-"], br#"{"next":[1,0],"outer":[0],"twin":[1,0]}"#);
    assert!(error.fails_with(1).contains("lies between outer faces only"), "{}", error.stderr);
}

#[test]
fn meshes_become_halfedges_and_polygons_again() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(path("cap.off"), OCTAHEDRON.replace("6 8 0", "6 6 0").replace("3 3 1 5\n3 0 3 5\n", ""))
        .unwrap();
    coface(&["convert", argument(&path("cap.off")), "-o", argument(&path("cap.halfedges.json"))]);
    let file: Value = serde_json::from_slice(&std::fs::read(path("cap.halfedges.json")).unwrap()).unwrap();
    assert_eq!((file["next"].as_array().unwrap().len(), &file["outer"]), (22, &json!([6])));
    coface(&["convert", argument(&path("cap.halfedges.json")), "-o", argument(&path("back.off"))]);
    let facts = |name: &str| {
        let report = coface(&["info", "--json", argument(&path(name))]).json();
        keys_of(&report, &["name", "f_vector", "area", "homology", "boundary_loops"])
    };
    assert_eq!(facts("cap.off"), facts("back.off"));
    assert_eq!(facts("cap.off")[0], "disk");
    let error =
        coface_reading(&["convert", "-", "-o", argument(&path("no.halfedges.json"))], PLANE.as_bytes());
    assert!(error.fails_with(1).contains("not orientable"), "{}", error.stderr);
    // The dual of the octahedron is the cube; its dual graph has a line for each edge.
    std::fs::write(path("octahedron.off"), OCTAHEDRON).unwrap();
    coface(&["convert", argument(&path("octahedron.off")), "--dual", "-o", argument(&path("cube.off"))]);
    assert_eq!(facts("cube.off")[1], json!([8, 12, 6]));
    assert!(
        coface(&["info", "--json", argument(&path("cube.off"))]).json()["signed_volume"].as_f64() > Some(0.0)
    );
    coface(&[
        "convert",
        argument(&path("octahedron.off")),
        "--dual-graph",
        "-o",
        argument(&path("graph.obj")),
    ]);
    assert_eq!(facts("graph.obj")[1], json!([8, 12]));
    // With a boundary the dual is the same surface.
    coface(&["convert", argument(&path("cap.off")), "--dual", "-o", argument(&path("dual.off"))]);
    assert_eq!((&facts("dual.off")[0], &facts("dual.off")[1]), (&json!("disk"), &json!([14, 19, 6])));
    let torus = path("torus.json");
    std::fs::write(&torus, r#"{"next":[2,3,4,5,0,1]}"#).unwrap();
    coface(&["convert", argument(&torus), "--dual", "-o", argument(&path("dual.json"))]);
    assert_eq!(facts("dual.json")[1], json!([2, 3, 1]));
}

#[test]
fn edits_are_logged_and_undone() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    std::fs::write(path("a.off"), OCTAHEDRON).unwrap();
    let (a, b, c, log) = (path("a.off"), path("b.off"), path("c.off"), path("log.json"));
    let run = coface(&[
        "edit",
        argument(&a),
        "--poke",
        "0",
        "--flip",
        "0 2",
        "--split",
        "4 6",
        "--poke",
        "1",
        "--json",
        "--log",
        argument(&log),
        "-o",
        argument(&b),
    ]);
    let answer = run.json();
    let ops: Vec<&Value> = answer["edits"].as_array().unwrap().iter().map(|edit| &edit["op"]).collect();
    assert_eq!(ops, ["poke_face", "flip_edge", "split_edge", "poke_face"]);
    assert_eq!(answer["edits"][1]["inverse"][0]["op"], "flip_edge_back");
    assert_eq!(coface(&["info", "--json", argument(&b)]).json()["name"], "sphere");
    coface(&["edit", argument(&b), "--undo", argument(&log), "-o", argument(&c)]);
    let read = |path: &Path| std::fs::read_to_string(path).unwrap();
    coface(&["convert", argument(&a), "-o", argument(&a)]);
    assert_eq!(read(&c), read(&a));
    // Two of four, and what stays is one step of the log again.
    coface(&[
        "edit",
        argument(&b),
        "--undo",
        argument(&log),
        "--steps",
        "2",
        "-o",
        argument(&c),
        "--log",
        argument(&log),
    ]);
    coface(&["edit", argument(&c), "--undo", argument(&log), "-o", argument(&b)]);
    assert_eq!(read(&b), read(&a));
    let error = coface(&["edit", argument(&a), "--undo", argument(&log)]);
    assert!(error.fails_with(1).contains("not the surface that the edits of"), "{}", error.stderr);
    coface(&["edit", argument(&a), "--flip", "0 1 2"]).fails_with(2);
    let error = coface(&["edit", argument(&a), "--flip", "0 1"]);
    assert!(error.fails_with(1).contains("no edge joins vertices 0 and 1"), "{}", error.stderr);
}

#[test]
fn edges_have_roles() {
    let folder = tempfile::tempdir().unwrap();
    let (torus, cut) = (folder.path().join("torus.off"), folder.path().join("cut.json"));
    coface(&["generate", "torus", "--columns", "5", "--rows", "4", "-o", argument(&torus)]);
    let answer = coface(&["cut", argument(&torus), "--roles", "--json", "-o", argument(&cut)]).json();
    let count = |key: &str| answer["roles"][key].as_array().unwrap().len();
    assert_eq!((count("tree"), count("cotree"), count("generators")), (19, 39, 2));
    assert!(coface(&["cut", argument(&torus), "--json"]).json().get("roles").is_none());
    let picture = folder.path().join("torus.svg");
    coface(&["render", argument(&torus), "--with", argument(&cut), "-o", argument(&picture)]);
    let drawn = std::fs::read_to_string(picture).unwrap();
    assert!(
        drawn.contains("<title>generators</title>") && drawn.contains("<title>cotree</title>"),
        "{}",
        drawn.len()
    );
}

#[test]
fn triangulations_under_other_names_are_isomorphic() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str, text: &str| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        path
    };
    let plane = path("plane.json", PLANE);
    // Vertex i is 10 - 2 i, and the facets come in another order.
    let renamed: Vec<Vec<u32>> = serde_json::from_str::<Value>(PLANE).unwrap()["facets"]
        .as_array()
        .unwrap()
        .iter()
        .rev()
        .map(|facet| facet.as_array().unwrap().iter().map(|v| 10 - 2 * v.as_u64().unwrap() as u32).collect())
        .collect();
    let other = path("other.json", &json!({ "facets": renamed }).to_string());
    let answer = coface(&["isomorphic", argument(&plane), argument(&other), "--json"]).json();
    assert_eq!(answer["isomorphic"], true);
    assert_eq!(answer["signatures"][0], answer["signatures"][1]);
    let mut images: Vec<u64> =
        answer["simplices"].as_array().unwrap().iter().map(|image| image.as_u64().unwrap()).collect();
    images.sort_unstable();
    assert_eq!(images, (0..10).collect::<Vec<u64>>());
    let octahedron = path("octahedron.off", OCTAHEDRON);
    let answer = coface(&["isomorphic", argument(&plane), argument(&octahedron), "--json"]).json();
    assert_eq!((&answer["isomorphic"], &answer["simplices"]), (&json!(false), &Value::Null));
    let touching = path("touching.json", "[[0,1,2],[0,3,4]]");
    let error = coface(&["isomorphic", argument(&touching), argument(&plane)]);
    assert!(error.fails_with(1).contains("touch in faces below their facets"), "{}", error.stderr);
}

/// Surfaces of quadrangles are compared as they are: a cube is no other cube cut along diagonals.
#[test]
fn quadrangles_under_other_names_are_isomorphic() {
    let folder = tempfile::tempdir().unwrap();
    let file = |name: &str, text: &str| {
        std::fs::write(folder.path().join(name), text).unwrap();
        folder.path().join(name)
    };
    let vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\nv 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\n";
    let cube = file(
        "cube.obj",
        &format!("{vertices}f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n"),
    );
    let other = file(
        "other.obj",
        &format!("{vertices}f 2 6 8 4\nf 7 5 6 8\nf 3 1 5 7\nf 3 7 8 4\nf 1 2 6 5\nf 4 2 1 3\n"),
    );
    let answer = coface(&["isomorphic", argument(&cube), argument(&other), "--json"]).json();
    assert_eq!(answer["isomorphic"], true, "{answer}");
    assert_eq!(answer["simplices"].as_array().unwrap().len(), 6);
    let open =
        file("open.obj", &format!("{vertices}f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\n"));
    let answer = coface(&["isomorphic", argument(&cube), argument(&open), "--json"]).json();
    assert_eq!((&answer["isomorphic"], &answer["difference"]), (&json!(false), &json!("6 and 5 polygons")));
}

/// Seams run through vertices that the cut has added, which lie between those of the model.
#[test]
fn canonical_seams_are_drawn_over_the_model_that_was_asked() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    let run = |arguments: &[&str]| {
        let run = crate::program::coface_in(place, arguments);
        assert_eq!(run.status, 0, "{}", run.stderr);
        run
    };
    run(&["generate", "genus", "-o", "two.obj"]);
    run(&["cut", "two.obj", "--canonical", "-o", "disk.ply"]);
    let answer = run(&["cut", "two.obj", "--canonical", "--json"]);
    std::fs::write(place.join("cut.json"), &answer.stdout).unwrap();
    assert!(!answer.json()["refinement"]["vertices"].as_array().unwrap().is_empty());
    run(&["view", "two.obj", "--with", "cut.json", "-o", "page.html"]);
    run(&["render", "two.obj", "--with", "cut.json", "-o", "picture.svg"]);
    assert!(std::fs::read_to_string(place.join("page.html")).unwrap().contains("handle 4 of component 1"));
}
