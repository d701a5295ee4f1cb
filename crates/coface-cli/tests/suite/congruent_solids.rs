//! `--method congruence` of solids: the results of the exact method on clear features, whatever the angle and the noise.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::{Path, PathBuf};

const SQUARES: [[usize; 4]; 6] =
    [[1, 3, 4, 2], [5, 6, 8, 7], [1, 2, 6, 5], [3, 7, 8, 4], [1, 5, 7, 3], [2, 4, 8, 6]];
const TOLERANCE: f64 = 1e-3;

/// Numbers that look random, from 0 to 1.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    fn below(&mut self, count: u32) -> f64 {
        (self.next() * f64::from(count)).floor()
    }
}

/// A box as a file.
fn cuboid(path: &Path, [low, high]: [[f64; 3]; 2], mut place: impl FnMut([f64; 3]) -> [f64; 3]) {
    let mut text = String::new();
    for corner in 0..8 {
        let [x, y, z] =
            place([0, 1, 2].map(|axis| if corner >> axis & 1 == 0 { low[axis] } else { high[axis] }));
        writeln!(text, "v {x:?} {y:?} {z:?}").unwrap();
    }
    for [a, b, c, d] in SQUARES {
        writeln!(text, "f {a} {b} {c} {d}").unwrap();
    }
    std::fs::write(path, text).unwrap();
}

fn combined(formula: &str, inputs: &[PathBuf], options: &[&str]) -> Value {
    let inputs = inputs.iter().map(|path| argument(path));
    let all: Vec<&str> = ["boolean", "--formula", formula].into_iter().chain(inputs).collect();
    coface(&[&all[..], options, &["--json"]].concat()).json()
}

/// The Betti numbers of a file of cells.
fn betti(path: &Path) -> Vec<u64> {
    let answer = coface(&["homology", argument(path), "--json"]).json();
    let mut betti: Vec<u64> =
        answer["homology"].as_array().unwrap().iter().map(|group| group["betti"].as_u64().unwrap()).collect();
    betti.truncate(3);
    betti
}

#[test]
fn boxes_have_the_solids_of_the_exact_method() {
    let folder = tempfile::tempdir().unwrap();
    let mut random = Random(24);
    for scene in 0..10 {
        let (angle, shift) = (random.next() * 6.0, random.next() * 100.0);
        let (sine, cosine) = f64::sin_cos(angle);
        let (mut exact, mut near) = (Vec::new(), Vec::new());
        for name in ["a", "b", "c"] {
            let low = [0; 3].map(|_| random.below(5));
            let high = low.map(|from| from + 1.0 + random.below(4));
            let paths = ["exact", "near"].map(|kind| folder.path().join(format!("{name}-{kind}.obj")));
            cuboid(&paths[0], [low, high], |point| point);
            cuboid(&paths[1], [low, high], |[x, y, z]| {
                let mut noise = || (random.next() - 0.5) * TOLERANCE / 4.0;
                let turned = [cosine * x - sine * y + shift, sine * x + cosine * y, z];
                turned.map(|x| x + noise())
            });
            let [own, moved] = paths;
            exact.push(own);
            near.push(moved);
        }
        for formula in ["a | b | c", "(a | b) - c", "a & b", "a ^ b ^ c"] {
            let [own, other] = ["exact.json", "glued.json"].map(|name| folder.path().join(name));
            let options = ["--method", "congruence", "--tolerance", "1e-3", "-o", argument(&other)];
            let expected = combined(formula, &exact, &["-o", argument(&own)]);
            let found = combined(formula, &near, &options);
            let place = format!("scene {scene}, {formula}");
            for key in ["solids", "voids", "cells", "closed", "unbounded"] {
                let (found, expected) = (&found[key], &expected[key]);
                assert!(key == "cells" || found == expected, "{place}: {key} {found}, not {expected}");
            }
            assert_eq!(found["manifold"]["verdict"], expected["manifold"]["verdict"], "{place}");
            let [volume, known] = [&found, &expected].map(|answer| answer["measure"].as_f64().unwrap());
            assert!((volume - known).abs() < 0.05, "{place}: {volume}, not {known}");
            let done = &found["congruence"];
            assert!(done["largest_class_diameter"].as_f64().unwrap() < 2.0 * TOLERANCE, "{place}");
            if known > 0.0 {
                assert_eq!(betti(&other), betti(&own), "{place}");
            }
        }
    }
}

#[test]
fn results_are_written_and_go_in_again() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let turned = |[x, y, z]: [f64; 3]| [0.6 * x - 0.8 * y, 0.8 * x + 0.6 * y, z];
    cuboid(&path("block.obj"), [[0.0; 3], [3.0; 3]], turned);
    cuboid(&path("rod.obj"), [[1.0, 1.0, -1.0], [2.0, 2.0, 4.0]], turned);
    let [block, rod] = ["block.obj", "rod.obj"].map(path);
    let by = |output: &Path, more: &[&str]| {
        let all = ["boolean", "difference", argument(&block), argument(&rod), "--method", "congruence"];
        coface(&[&all[..], &["--tolerance", "1e-9", "-o", argument(output)], more].concat())
    };
    // The solid torus has two faces with a hole, which are triangles in meshes.
    for name in ["torus.off", "torus.stl", "torus.ply", "torus.vtk"] {
        let run = by(&path(name), &[]);
        assert_eq!(run.status, 0, "{}", run.stderr);
        let info = coface(&["info", argument(&path(name)), "--json"]).json();
        assert_eq!(
            (&info["name"], &info["geometry"]["valid_solid"]),
            (&json!("torus"), &json!(true)),
            "{name}"
        );
        // STL has coordinates of 24 bits.
        assert!((info["signed_volume"].as_f64().unwrap() - 24.0).abs() < 1e-4, "{name}");
    }
    let whole = coface(&["boolean", "union", argument(&path("torus.off")), argument(&rod), "--json"]).json();
    assert!((whole["measure"].as_f64().unwrap() - 29.0).abs() < 1e-6);
    let from = path("from.json");
    assert_eq!(by(&path("walls.obj"), &["--triangles", "--provenance", argument(&from)]).status, 0);
    let from: Value = serde_json::from_str(&std::fs::read_to_string(from).unwrap()).unwrap();
    let info = coface(&["info", argument(&path("walls.obj")), "--json"]).json();
    assert_eq!(info["f_vector"][2], json!(from["polygons"].as_array().unwrap().len()));
    let page =
        coface(&["boolean", "union", argument(&block), "--method", "congruence", "--tolerance", "1e-9"]);
    assert!(
        page.stdout.contains("stacked") && page.stdout.contains("volume            27"),
        "{}",
        page.stdout
    );
}

/// What is asked of exact cells is asked of what is glued: the same cells as without, and points that are where they say.
#[test]
fn options_of_exact_cells_are_served() {
    let folder = tempfile::tempdir().unwrap();
    let (sine, cosine) = f64::sin_cos(0.5);
    let turned = |[x, y, z]: [f64; 3]| [cosine * x - sine * y, sine * x + cosine * y, z];
    let paths = ["a.obj", "b.obj"].map(|name| folder.path().join(name));
    cuboid(&paths[0], [[0.0; 3], [2.0; 3]], turned);
    cuboid(&paths[1], [[1.0, 1.0, 0.0], [3.0, 3.0, 2.0]], turned);
    let words = [argument(&paths[0]), argument(&paths[1]), "--method", "congruence", "--tolerance", "1e-9"];
    let arranged =
        |options: &[&str]| coface(&[&["arrange"], &words[..], options, &["--json"]].concat()).json();
    let plain = arranged(&[]);
    assert_eq!(plain["f_vector"][3], 3);
    for options in [&["--snap"][..], &["--exact"], &["--max-cells", "200"], &["--non-planar", "split"]] {
        let answer = arranged(options);
        assert_eq!(answer["f_vector"], plain["f_vector"], "{options:?}");
        assert_eq!(answer["congruence"], plain["congruence"], "{options:?}");
        assert_eq!(answer["rounding"]["valid"], true, "{options:?}");
    }
    // The two boxes have two faces in each of two planes, cut where these overlap.
    let merged = arranged(&["--merge-coplanar"]);
    assert!(merged["f_vector"][2].as_u64() <= plain["f_vector"][2].as_u64());
    assert_eq!(merged["f_vector"][3], 3);
    let graph = folder.path().join("cells.json");
    arranged(&["--graph", argument(&graph)]);
    let graph: Value = serde_json::from_str(&std::fs::read_to_string(&graph).unwrap()).unwrap();
    assert_eq!((graph["nodes"].as_array().unwrap().len(), graph["edges"].as_array().unwrap().len()), (3, 2));
    let few = coface(&[&["arrange"], &words[..], &["--max-cells", "20"]].concat());
    assert!(few.fails_with(1).contains("more than 20"), "{few:?}");
    let united =
        |options: &[&str]| coface(&[&["boolean", "union"], &words[..], options, &["--json"]].concat()).json();
    for options in [&[][..], &["--snap"], &["--exact"], &["--merge-coplanar"], &["--pinches", "split"]] {
        let answer = united(options);
        let volume = answer["measure"].as_f64().unwrap();
        assert!((volume - 14.0).abs() < 1e-9, "{options:?}: {volume}");
        assert!(answer["congruence"].is_object() && answer["manifold"]["verdict"] == "yes", "{options:?}");
    }
}
