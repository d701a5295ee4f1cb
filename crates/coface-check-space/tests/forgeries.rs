//! False certificates are refused, each by the step that it should be.

use coface_check_space::check;
use serde_json::{Value, json};

/// A tetrahedron with legs of 6, and the same moved by 1 along the diagonal and cut off: both have a corner inside the other.
const INPUT: &str = "OFF\n4 4 0\n0 0 0\n6 0 0\n0 6 0\n0 0 6\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";
const TOOL: &str = "OFF\n4 4 0\n1 1 -1\n2 1 -1\n1 2 -1\n1 1 3\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

/// The tool goes through the bottom: its three slanted sides are cut at height 0 in (1, 1), (7 / 4, 1), (1, 7 / 4).
fn honest() -> Value {
    let hash = |text: &str| coface_check::sha256(text.as_bytes());
    let bottom =
        json!([[0, 2, 1], [0, 2, 8], [2, 10, 8], [2, 1, 10], [1, 9, 10], [1, 0, 9], [0, 8, 9], [8, 10, 9]]);
    json!({
        "coface_certificate": 1, "kind": "solids", "rule": "nonzero", "formula": "0 1 -",
        "inputs": [{"name": "a.off", "sha256": hash(INPUT)}, {"name": "b.off", "sha256": hash(TOOL)}],
        // 36 less a pyramid of height 3 on a right triangle with legs of 3 / 4.
        "answer": {"dimension": 3, "measure": 36.0 - 0.28125, "closed": true, "unbounded": false, "rule": "nonzero", "area": 1.0},
        "proof": {
            "vertices": [[0, 0, 0, 1], [6, 0, 0, 1], [0, 6, 0, 1], [0, 0, 6, 1],
                         [1, 1, -1, 1], [2, 1, -1, 1], [1, 2, -1, 1], [1, 1, 3, 1],
                         [1, 1, 0, 1], [7, 4, 0, 4], [4, 7, 0, 4]],
            "polygons": [bottom, [0, 1, 3], [1, 2, 3], [2, 0, 3],
                         [4, 6, 5],
                         [[4, 5, 7], [4, 5, 9], [4, 9, 8], [8, 9, 7]],
                         [[5, 6, 7], [5, 6, 10], [5, 10, 9], [9, 10, 7]],
                         [[6, 4, 7], [6, 4, 8], [6, 8, 10], [10, 8, 7]]],
        },
    })
}

fn checked(certificate: &Value) -> Result<coface_check::Verdict, coface_check::Fault> {
    check(certificate.to_string().as_bytes(), &[INPUT.as_bytes(), TOOL.as_bytes()])
}

fn refusal(change: impl Fn(&mut Value)) -> String {
    let mut forged = honest();
    change(&mut forged);
    checked(&forged).expect_err("a forgery").to_string()
}

#[test]
fn the_true_one_is_verified() {
    let verdict = checked(&honest()).expect("it is true");
    assert!(verdict.proved()[1].contains("(0 - 1)"), "{:?}", verdict.proved());
    assert_eq!(
        verdict.proved().last().expect("claims"),
        "measure = 35.71875, the volume, to one part in 10^12"
    );
    assert_eq!(verdict.unchecked(), ["area"]);
    for (formula, volume) in
        [("0 1 &", 0.28125), ("1 0 -", 2.0 / 3.0 - 0.28125), ("0 1 |", 36.0 + 2.0 / 3.0 - 0.28125)]
    {
        let mut other = honest();
        other["formula"] = json!(formula);
        other["answer"]["measure"] = json!(volume);
        checked(&other).expect(formula);
    }
}

#[test]
fn forgeries_are_refused_by_their_steps() {
    // Vertices at infinity or elsewhere; polygons that are missing.
    assert!(refusal(|c| c["proof"]["vertices"][9] = json!([7, 4, 0, 0])).starts_with("vertices:"));
    assert!(
        refusal(|c| c["proof"]["vertices"][1] = json!([6, 1, 0, 1]))
            .starts_with("pieces: polygon 0: the corners")
    );
    assert!(refusal(|c| c["proof"]["vertices"][9] = json!([7, 4, 1, 4])).contains("is not in its plane"));
    assert!(refusal(|c| c["proof"]["vertices"][9] = json!([7, 5, 0, 4])).starts_with("pieces:"));
    assert!(
        refusal(|c| c["proof"]["polygons"].as_array_mut().expect("a list").truncate(7))
            .starts_with("pieces:")
    );
    // Pieces that turn the other way, are missing, are there twice, or have a side that is not divided.
    assert!(
        refusal(|c| c["proof"]["polygons"][0][7] = json!([8, 9, 10])).contains("do not all turn one way")
    );
    assert!(
        refusal(|c| c["proof"]["polygons"][0].as_array_mut().expect("a list").truncate(7))
            .contains("a boundary that is not its own")
    );
    assert!(
        refusal(|c| c["proof"]["polygons"][4] = json!([[4, 6, 5], [4, 6, 5], [4, 6, 5]]))
            .contains("polygon 4")
    );
    assert!(refusal(|c| c["proof"]["polygons"][4] = json!([[4, 6, 5]])).contains("is not covered"));
    // Cuts that are left out.
    assert!(refusal(|c| c["proof"]["polygons"][0] = json!([0, 2, 1])).contains("meets the inside of"));
    let whole = |number: usize| [json!([4, 5, 7]), json!([5, 6, 7]), json!([6, 4, 7])][number - 5].clone();
    assert!(
        refusal(|c| (5..8).for_each(|i| c["proof"]["polygons"][i] = whole(i)))
            .contains("meets the inside of")
    );
    assert!(refusal(|c| c["proof"]["polygons"][5] = whole(5)).contains("meets the inside of"));
    // Answers and formulas.
    assert!(refusal(|c| c["formula"] = json!("0 1 |")).starts_with("answer: the volume"));
    assert!(refusal(|c| c["formula"] = json!("0 2 |")).starts_with("formula:"));
    assert!(refusal(|c| c["formula"] = json!("0 !")).starts_with("answer: \"unbounded\""));
    assert!(refusal(|c| c["rule"] = json!("odd")).starts_with("certificate:"));
    for (key, lie) in [
        ("measure", json!(35.718_750_1)),
        ("closed", json!(false)),
        ("unbounded", json!(true)),
        ("dimension", json!(2)),
        ("rule", json!("positive")),
    ] {
        assert!(refusal(|c| c["answer"][key] = lie.clone()).starts_with("answer:"), "{key}");
    }
}

/// The same as an arrangement: the tip of the tool in the block, the rest of each.
fn cells() -> Value {
    let mut certificate = honest();
    certificate["kind"] = json!("space");
    certificate["proof"]["cells"] = json!([[0, 1, 3], [8, 9, 7], [4, 6, 5]]);
    let tip = 0.28125;
    certificate["answer"] = json!({"dimension": 3, "measures": [36.0 - tip, tip, 2.0 / 3.0 - tip],
        "inside": [[0], [0, 1], [1]], "voids": 0, "f_vector": [11, 21, 12, 3]});
    certificate
}

#[test]
fn cells_are_verified_and_false_ones_refused() {
    let verdict = checked(&cells()).expect("it is true");
    assert_eq!(verdict.proved()[1], "3 bounded cells");
    assert_eq!(verdict.unchecked(), ["f_vector"]);
    let refusal = |change: &dyn Fn(&mut Value)| {
        let mut forged = cells();
        change(&mut forged);
        checked(&forged).expect_err("a forgery").to_string()
    };
    // A cell that is left out, named twice, or is the exterior; a triangle that is none.
    assert!(
        refusal(&|c| c["proof"]["cells"] = json!([[0, 1, 3], [8, 9, 7]])).starts_with("cells: there are 3")
    );
    assert!(refusal(&|c| c["proof"]["cells"][1] = json!([0, 3, 2])).starts_with("cells:"));
    assert!(refusal(&|c| c["proof"]["cells"][1] = json!([0, 3, 1])).starts_with("cells:"));
    assert!(
        refusal(&|c| c["proof"]["cells"][1] = json!([0, 3, 7])).starts_with("cells: a cell has no triangle")
    );
    for (key, lie) in [
        ("measures", json!([1.0, 1.0, 1.0])),
        ("measures", json!([1.0])),
        ("inside", json!([[0], [1], [1]])),
        ("voids", json!(1)),
    ] {
        assert!(refusal(&|c| c["answer"][key] = lie.clone()).starts_with("answer:"), "{key}");
    }
}

/// A box in a box in a box, and one beside them: what is between is a cell with a void.
#[test]
fn boxes_in_boxes_are_cells_with_voids() {
    let boxed = |low: i64, high: i64, shift: i64| {
        let at = |bit: i64| if bit == 0 { low } else { high };
        (0..8).map(|i| [at(i & 1) + shift, at(i >> 1 & 1), at(i >> 2)]).collect::<Vec<[i64; 3]>>()
    };
    let all = [boxed(-4, 4, 0), boxed(-2, 2, 0), boxed(-1, 1, 0), boxed(-1, 1, 10)];
    let points: Vec<[i64; 3]> = all.concat();
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let quads: Vec<[i64; 4]> = (0..4).flat_map(|b| faces.map(|face| face.map(|i| 8 * b + i))).collect();
    let lines = |rows: Vec<String>| rows.join("\n");
    let text = format!(
        "OFF\n32 24 0\n{}\n{}\n",
        lines(points.iter().map(|[x, y, z]| format!("{x} {y} {z}")).collect()),
        lines(quads.iter().map(|[a, b, c, d]| format!("4 {a} {b} {c} {d}")).collect())
    );
    let polygons: Vec<Value> =
        quads.iter().map(|&[a, b, c, d]| json!([[a, b, c, d], [a, b, c], [a, c, d]])).collect();
    let certificate = |voids: u32| {
        json!({"coface_certificate": 1, "kind": "space",
            "inputs": [{"name": "", "sha256": coface_check::sha256(text.as_bytes())}],
            "answer": {"measures": [448.0, 56.0, 8.0, 8.0], "voids": voids, "inside": [[0], [0], [0], [0]]},
            "proof": {"vertices": points.iter().map(|[x, y, z]| json!([x, y, z, 1])).collect::<Vec<_>>(),
                      "polygons": polygons, "cells": [[0, 2, 3], [8, 10, 11], [16, 18, 19], [24, 26, 27]]}})
    };
    let checked = |voids: u32| check(certificate(voids).to_string().as_bytes(), &[text.as_bytes()]);
    assert_eq!(checked(2).expect("two cells have a void").proved()[1], "4 bounded cells");
    assert!(checked(1).is_err());
}

/// Two triangles with a common edge, which lies within a side of a third one between them: left whole, it would not be seen around the edge.
#[test]
fn edges_that_overlap_are_divided_alike() {
    let text = "OFF\n7 3 0\n1 0 0\n3 0 0\n2 0 2\n2 0 -2\n0 0 0\n4 0 0\n2 4 0\n3 0 1 2\n3 0 1 3\n3 4 5 6\n";
    let points =
        [[1, 0, 0, 1], [3, 0, 0, 1], [2, 0, 2, 1], [2, 0, -2, 1], [0, 0, 0, 1], [4, 0, 0, 1], [2, 4, 0, 1]];
    let checked = |third: Value| {
        let certificate = json!({"coface_certificate": 1, "kind": "space", "answer": {"voids": 0},
            "inputs": [{"name": "", "sha256": coface_check::sha256(text.as_bytes())}],
            "proof": {"vertices": points, "polygons": [[0, 1, 2], [0, 1, 3], third], "cells": []}});
        check(certificate.to_string().as_bytes(), &[text.as_bytes()])
    };
    checked(json!([[4, 5, 6], [4, 0, 6], [0, 1, 6], [1, 5, 6]])).expect("the side is divided");
    let fault = checked(json!([4, 5, 6])).expect_err("the side is whole").to_string();
    assert!(fault.contains("lies on the edge between [4, 5]"), "{fault}");
}

#[test]
fn open_inputs_are_refused() {
    let open = "OFF\n4 3 0\n0 0 0\n6 0 0\n0 6 0\n0 0 6\n3 0 2 1\n3 0 1 3\n3 1 2 3\n";
    let mut forged = honest();
    forged["inputs"][0]["sha256"] = json!(coface_check::sha256(open.as_bytes()));
    forged["proof"]["polygons"].as_array_mut().expect("a list").remove(3);
    let fault =
        check(forged.to_string().as_bytes(), &[open.as_bytes(), TOOL.as_bytes()]).expect_err("it is open");
    assert!(fault.to_string().contains("is not closed"), "{fault}");
}

/// Two boxes with a common wall: pieces in one plane are one piece, or refused.
#[test]
fn polygons_in_one_plane_share_their_pieces() {
    let boxed = |x: i64| {
        let corner = |i: i64| format!("{} {} {}\n", x + (i & 1), i >> 1 & 1, i >> 2);
        let faces = "4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
        format!("OFF\n8 6 0\n{}{faces}", (0..8).map(corner).collect::<String>())
    };
    let texts = [boxed(0), boxed(1)];
    // The vertices are those of both grids.
    let vertex = |x: i64, i: i64| 4 * (x + (i & 1)) + (i >> 1 & 1) + 2 * (i >> 2);
    let vertices: Vec<Value> = (0..12).map(|v| json!([v / 4, v & 1, v >> 1 & 1, 1])).collect();
    let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let polygon = |x: i64, face: [i64; 4], turned: bool| {
        let [a, b, c, d] = face.map(|i| vertex(x, i));
        if turned {
            json!([[a, b, c, d], [a, b, d], [b, c, d]])
        } else {
            json!([[a, b, c, d], [a, b, c], [a, c, d]])
        }
    };
    let certificate = |turned: bool, volume: f64| {
        let polygons: Vec<Value> =
            [0, 1].iter().flat_map(|&x| faces.map(|face| polygon(x, face, turned && x == 1))).collect();
        let inputs: Vec<Value> = texts
            .iter()
            .map(|text| json!({"name": "", "sha256": coface_check::sha256(text.as_bytes())}))
            .collect();
        json!({"coface_certificate": 1, "kind": "solids", "formula": "0 1 |", "inputs": inputs, "answer": {"measure": volume},
               "proof": {"vertices": vertices, "polygons": polygons}})
    };
    let checked = |certificate: &Value| {
        check(certificate.to_string().as_bytes(), &[texts[0].as_bytes(), texts[1].as_bytes()])
    };
    // [1, 3, 7, 5] of the first and [0, 4, 6, 2] of the second are cut along one diagonal if both are cut from their first corner: 1 to 7, and 0 to 6.
    let verdict = checked(&certificate(false, 2.0)).expect("2");
    assert!(verdict.proved()[1].contains("20 of these triangles bound it"), "{:?}", verdict.proved());
    let fault = checked(&certificate(true, 2.0)).expect_err("the common wall is cut in two ways");
    assert!(fault.to_string().contains("meets the inside of"), "{fault}");
}

#[test]
fn inputs_of_strangers_end() {
    for input in [
        "",
        "OFF",
        "OFF\n4294967295 4294967295 0\n",
        "OFF\n1 1 0\n0 0 nan\n",
        "OFF\n1 1 0\n0 0 0\n3 0 0 7\n",
        "v 1 2\n",
        "f 1 2 3\n",
        "f 0 0 0\n",
        "\u{1}",
    ] {
        let certificate = json!({"coface_certificate": 1, "kind": "solids", "formula": "0", "answer": {"measure": 1.0},
            "inputs": [{"name": "", "sha256": coface_check::sha256(input.as_bytes())}], "proof": {"vertices": [], "polygons": []}});
        assert!(check(certificate.to_string().as_bytes(), &[input.as_bytes()]).is_err(), "{input}");
    }
}
