//! Mass properties and moments in `coface info`.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface};
use serde_json::{Value, json};
use std::path::Path;

/// `coface info --json` on a file of this name with this text.
fn info(name: &str, text: &str, options: &[&str]) -> Value {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    coface(&[&["info", argument(&path), "--json"], options].concat()).json()
}

fn is_close(value: &Value, expected: f64) -> bool {
    (value.as_f64().unwrap() - expected).abs() <= 1e-12 * expected.abs().max(1e-30)
}

const TETRAHEDRON: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";

#[test]
fn the_unit_tetrahedron_has_quotients_of_factorials() {
    let options = ["--moment", "0,0,0", "--moment", "10,10,10", "--moment", "1, 1, 0"];
    let found = info("tetrahedron.obj", TETRAHEDRON, &options);
    let moments = &found["moments"];
    assert!(is_close(&moments[0]["volume"], 1.0 / 6.0) && is_close(&moments[2]["volume"], 1.0 / 120.0));
    assert!(is_close(&moments[0]["surface"], 2.366_025_403_784_438_4));
    // 10!^3 / 33!
    assert!(is_close(&moments[1]["volume"], 5.503_049_403_185_398e-18), "{moments}");
    assert_eq!(moments[1]["exponents"], json!([10, 10, 10]));
    let mass = &found["mass"];
    assert!(is_close(&mass["volume"], 1.0 / 6.0) && is_close(&mass["centroid"][2], 0.25));
    // 1/30 about the origin on the diagonal, less 2 * (1/4)^2 / 6; -1/120 beside it, plus (1/4)^2 / 6.
    assert!(is_close(&mass["inertia"][1][1], 1.0 / 30.0 - 1.0 / 48.0));
    assert!(is_close(&mass["inertia"][0][2], 1.0 / 96.0 - 1.0 / 120.0));
    let inside_out =
        TETRAHEDRON.replace("f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4", "f 1 2 3\nf 1 4 2\nf 2 4 3\nf 3 4 1");
    assert!(is_close(&info("reversed.obj", &inside_out, &[])["mass"]["volume"], -1.0 / 6.0));
}

#[test]
fn volume_meshes_have_the_mass_of_their_cells() {
    // Two hexahedra, a box of 1 by 1 by 2; the second may be listed inside out.
    let text = |second: &str| {
        let corners: String = (0..3)
            .flat_map(|z| [[0, 0], [1, 0], [1, 1], [0, 1]].map(|[x, y]| format!("{x} {y} {z} 0\n")))
            .collect();
        format!(
            "MeshVersionFormatted 2\nDimension 3\nVertices 12\n{corners}Hexahedra 2\n1 2 3 4 5 6 7 8 0\n{second} 0\nEnd\n"
        )
    };
    let found = info("box.mesh", &text("5 6 7 8 9 10 11 12"), &["--moment", "0,0,3"]);
    assert!(is_close(&found["mass"]["volume"], 2.0) && is_close(&found["mass"]["centroid"][2], 1.0));
    assert!(is_close(&found["mass"]["inertia"][0][0], 2.0 * (1.0 + 4.0) / 12.0));
    assert!(is_close(&found["mass"]["inertia"][2][2], 2.0 * 2.0 / 12.0));
    assert!(is_close(&found["moments"][0]["volume"], 4.0));
    // Four sides with the integral 4 each, the top with 8, the bottom with 0.
    assert!(is_close(&found["moments"][0]["surface"], 24.0));
    let crossed = info("box.mesh", &text("9 10 11 12 5 6 7 8"), &["--moment", "0,0,1"]);
    assert!(is_close(&crossed["moments"][0]["volume"], 0.5 - 1.5));
    assert_eq!((&crossed["mass"], &crossed["signed_volume"]), (&json!(null), &json!(0.0)));
}

#[test]
fn what_has_no_inside_has_no_mass() {
    let square =
        info("square.obj", "v 0 0 0\nv 2 0 0\nv 2 2 0\nv 0 2 0\nf 1 2 3 4\n", &["--moment", "2,0,0"]);
    assert_eq!((&square["mass"], &square["moments"][0]["volume"]), (&json!(null), &json!(null)));
    assert!(is_close(&square["moments"][0]["surface"], 16.0 / 3.0));
    assert_eq!(square["surface_centroid"], json!([1.0, 1.0, 0.0]));
    let facets = info("facets.json", "[[0,1,2]]", &["--moment", "1,0,0"]);
    assert_eq!((&facets["mass"], &facets["surface_centroid"]), (&json!(null), &json!(null)));
    assert_eq!(facets["moments"], json!([{"exponents": [1, 0, 0], "volume": null, "surface": null}]));
}

#[test]
fn real_models_agree_with_their_volume_and_move_along() {
    let spot = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/spot.obj");
    let text = std::fs::read_to_string(&spot).unwrap();
    let own = info("spot.obj", &text, &[]);
    let moved: String = text
        .lines()
        .map(|line| match line.strip_prefix("v ") {
            Some(point) => {
                let x: Vec<f64> = point.split_whitespace().map(|word| word.parse().unwrap()).collect();
                format!("v {} {} {}\n", 5.0 - x[1], x[0] - 3.0, x[2] + 7.0)
            }
            None => format!("{line}\n"),
        })
        .collect();
    let moved = info("moved.obj", &moved, &[]);
    let close = |a: &Value, b: f64| assert!((a.as_f64().unwrap() - b).abs() < 1e-10, "{a} {b}");
    let number = |value: &Value| value.as_f64().unwrap();
    let (a, b) = (&own["mass"], &moved["mass"]);
    close(&a["volume"], number(&own["signed_volume"]));
    close(&b["volume"], number(&a["volume"]));
    close(&b["centroid"][0], 5.0 - number(&a["centroid"][1]));
    close(&b["centroid"][1], number(&a["centroid"][0]) - 3.0);
    close(&b["centroid"][2], number(&a["centroid"][2]) + 7.0);
    close(&b["inertia"][0][0], number(&a["inertia"][1][1]));
    close(&b["inertia"][1][1], number(&a["inertia"][0][0]));
    close(&b["inertia"][0][1], -number(&a["inertia"][0][1]));
    close(&b["inertia"][2][0], -number(&a["inertia"][2][1]));
}

#[test]
fn exponents_are_three_numbers() {
    for wrong in ["1,2", "1,2,3,4", "-1,0,0", "a,b,c", ""] {
        assert_eq!(coface(&["info", "x.obj", "--moment", wrong]).status, 2, "{wrong}");
    }
    let spot = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/spot.obj");
    let high = coface(&["info", argument(&spot), "--moment", "60,60,0"]);
    assert!(high.fails_with(1).contains("the limit is 100"));
    let page = coface(&["info", argument(&spot), "--moment", "2,0,0"]);
    assert!(page.stdout.contains("center of mass") && page.stdout.contains("x^2 y^0 z^0"), "{}", page.stdout);
}
