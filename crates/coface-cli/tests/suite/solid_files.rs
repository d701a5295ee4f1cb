//! Solids to and from files: 32-bit numbers that are too coarse, formats without large polygons, objects chosen by name, faces with holes and
//! folds that are narrower than a tolerance.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{Run, argument, coface};
use serde_json::Value;
use std::fmt::Write;
use std::path::{Path, PathBuf};

const SQUARES: [[usize; 4]; 6] =
    [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

fn cube(folder: &Path, name: &str, low: [f64; 3], side: f64) -> PathBuf {
    let mut text = "OFF\n8 6 0\n".to_owned();
    for i in 0..8 {
        let [x, y, z] = [0, 1, 2].map(|axis| low[axis] + if i >> axis & 1 == 0 { 0.0 } else { side });
        writeln!(text, "{x:?} {y:?} {z:?}").unwrap();
    }
    for [a, b, c, d] in SQUARES {
        writeln!(text, "4 {a} {b} {c} {d}").unwrap();
    }
    written(folder, name, &text)
}

fn written(folder: &Path, name: &str, text: &str) -> PathBuf {
    let path = folder.join(name);
    std::fs::write(&path, text).unwrap();
    path
}

fn union(inputs: &[&PathBuf], options: &[&str]) -> Run {
    let inputs = inputs.iter().map(|path| argument(path));
    let all: Vec<&str> =
        ["boolean", "union", "--json"].into_iter().chain(inputs).chain(options.iter().copied()).collect();
    coface(&all)
}

fn info(path: &str) -> Value {
    coface(&["info", path, "--json", "--quiet"]).json()
}

fn is_near(found: &Value, truth: f64, part: f64) -> bool {
    found.as_f64().is_some_and(|found| (found - truth).abs() <= part * truth.abs())
}

/// Two cubes that overlap by half, at an offset, as STL: right, or refused.
#[test]
fn stl_is_right_or_refused_however_far_from_the_origin() {
    let folder = tempfile::tempdir().unwrap();
    let mut counts = [0; 2];
    for step in 0..12 {
        let offset = 10f64.powf(2.0 + f64::from(step) * 0.5);
        for shift in [0.3, 0.5] {
            let a = cube(folder.path(), "a.off", [offset, offset, 0.0], 1.0);
            let b = cube(folder.path(), "b.off", [offset + shift, offset, 0.0], 1.0);
            let truth = union(&[&a, &b], &[]).json()["measure"].as_f64().unwrap();
            let out = folder.path().join("out.stl");
            for options in
                [&[][..], &["--exact"], &["--snap"], &["--tolerance", "1e-6"], &["--method", "congruence"]]
            {
                let run = union(&[&a, &b], &[&["-o", argument(&out)][..], options].concat());
                if run.status != 0 {
                    let cure = "write .off, .ply or .obj, which hold numbers of 64 bits";
                    assert!(run.stderr.contains(cure), "{offset} {options:?} {}", run.stderr);
                    assert!(run.stderr.contains("near the origin STL would do"), "{}", run.stderr);
                    assert!(!run.stderr.contains("encloses nothing"), "{}", run.stderr);
                    counts[1] += 1;
                    continue;
                }
                assert!(is_near(&run.json()["measure"], truth, 0.01), "{offset} {options:?}");
                let read = info(argument(&out));
                assert!(is_near(&read["signed_volume"], truth, 0.01), "{offset} {options:?} {read}");
                counts[0] += 1;
            }
        }
    }
    assert!(counts[0] > 30 && counts[1] > 20, "{counts:?}");
    // The cure.
    let a = cube(folder.path(), "a.off", [1e7, 1e7, 0.0], 1.0);
    let b = cube(folder.path(), "b.off", [1e7 + 0.3, 1e7, 0.0], 1.0);
    for name in ["out.off", "out.ply", "out.obj"] {
        let out = folder.path().join(name);
        assert!(is_near(&union(&[&a, &b], &["-o", argument(&out)]).json()["measure"], 1.3, 1e-8));
        assert!(is_near(&info(argument(&out))["signed_volume"], 1.3, 1e-8), "{name}");
    }
}

#[test]
fn a_plate_thinner_than_32_bits_is_not_lost() {
    // A plate of 5 mm, 100 m wide, 300 km away.
    let folder = tempfile::tempdir().unwrap();
    let a = cube(folder.path(), "a.off", [3e5, 3e5, 0.0], 100.0);
    let b = cube(folder.path(), "b.off", [3e5 + 99.995, 3e5, 0.0], 100.0);
    let out = folder.path().join("out.stl");
    let arguments = ["boolean", "intersection", argument(&a), argument(&b), "-o", argument(&out)];
    let run = coface(&arguments);
    assert_eq!(run.status, 1, "{}", run.stderr);
    assert!(run.stderr.contains("instead of"), "{}", run.stderr);
    assert_eq!(coface(&[&arguments[..4], &["--json", "--quiet"]].concat()).status, 0);
}

#[test]
fn large_polygons_become_triangles_where_a_format_has_none() {
    let folder = tempfile::tempdir().unwrap();
    let a = cube(folder.path(), "a.off", [0.0; 3], 1.0);
    let b = cube(folder.path(), "b.off", [0.5; 3], 1.0);
    for name in ["out.msh", "out.mesh"] {
        let out = folder.path().join(name);
        let run = union(&[&a, &b], &["-o", argument(&out)]);
        assert_eq!(run.status, 0, "{}", run.stderr);
        assert!(run.stderr.contains("all faces are written as triangles"), "{}", run.stderr);
        assert!(is_near(&info(argument(&out))["signed_volume"], 1.875, 1e-12));
        // Cubes alone stay squares.
        let run = union(&[&a], &["-o", argument(&out)]);
        assert!(!run.stderr.contains("triangles"), "{}", run.stderr);
        assert_eq!(info(argument(&out))["f_vector"], serde_json::json!([8, 12, 6]));
        let run = union(&[&a, &b], &["--polygons", "-o", argument(&out)]);
        assert_eq!(run.status, 1, "{}", run.stderr);
    }
}

#[test]
fn an_object_has_its_own_faults_alone() {
    let folder = tempfile::tempdir().unwrap();
    let mut text = String::new();
    for low in [0.0, 5.0] {
        for i in 0..8 {
            let [x, y, z] =
                [0, 1, 2].map(|axis| f64::from(i >> axis & 1) + if axis == 0 { low } else { 0.0 });
            writeln!(text, "v {x} {y} {z}").unwrap();
        }
    }
    for (name, first) in [("good", 1), ("bad", 9)] {
        writeln!(text, "o {name}").unwrap();
        for (i, [a, b, c, d]) in SQUARES.into_iter().enumerate() {
            let [a, b, c, d] = [a, b, c, d].map(|corner| corner + first);
            match (i, name) {
                (0, "bad") => writeln!(text, "f {a} {b} {b} {c} {d}\nf {a} {b} {a}").unwrap(),
                _ => writeln!(text, "f {a} {b} {c} {d}").unwrap(),
            }
        }
    }
    let path = written(folder.path(), "two.obj", &text);
    let of = |part: &str| info(&format!("{}#{part}", argument(&path)));
    assert_eq!(of("good")["warnings"], serde_json::json!([]));
    assert_eq!(of("good")["geometry"]["valid_solid"], true, "{}", of("good")["geometry"]);
    assert_eq!(of("bad")["geometry"]["valid_solid"], false);
    assert!(of("bad")["warnings"].as_array().unwrap().len() >= 2);
}

/// A block of 4 by 4 by 2 with a square shaft, as CityJSON, whose points are moved by less than a quarter of `tolerance`.
fn block_with_shaft(tolerance: f64, seed: u64) -> String {
    let mut state = seed;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64 * 2.0 - 1.0
    };
    let mut vertices = Vec::new();
    for (low, high) in [(0.0, 4.0), (1.0, 3.0)] {
        for [x, y] in [[low, low], [high, low], [high, high], [low, high]] {
            for z in [0.0, 2.0] {
                vertices.push([x, y, z].map(|x| x + 0.14 * tolerance * random()));
            }
        }
    }
    let mut faces = vec!["[[6,4,2,0],[14,12,10,8]]".replace("[14,12,10,8]", "[8,10,12,14]")];
    faces.push("[[1,3,5,7],[15,13,11,9]]".to_owned());
    for i in 0..4 {
        let (a, b) = (2 * i, 2 * ((i + 1) % 4));
        faces.push(format!("[[{a},{b},{},{}]]", b + 1, a + 1));
        faces.push(format!("[[{},{},{},{}]]", b + 8, a + 8, a + 9, b + 9));
    }
    format!(
        r#"{{"type": "CityJSON", "version": "2.0", "CityObjects": {{"a": {{"type": "Building", "geometry": [{{"type": "Solid",
            "lod": "2", "boundaries": [[{}]]}}]}}}}, "vertices": {vertices:?}}}"#,
        faces.join(",")
    )
}

#[test]
fn a_tolerance_keeps_faces_with_holes_flat() {
    let folder = tempfile::tempdir().unwrap();
    for seed in 0..6 {
        let tolerance = if seed == 0 { 0.0 } else { 0.01 };
        let path = written(folder.path(), "block.city.json", &block_with_shaft(tolerance, seed));
        let arranged =
            coface(&["arrange", argument(&path), "--tolerance", "0.01", "--json", "--quiet"]).json();
        assert_eq!(arranged["f_vector"], serde_json::json!([16, 24, 10, 1]), "{seed}");
        assert_eq!(arranged["holes"], 2, "{seed}");
        assert!(is_near(&arranged["measures"][0], 24.0, 0.01), "{seed}");
    }
}

#[test]
fn what_joins_nothing_says_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let a = cube(folder.path(), "a.off", [4e5, 5e6, 30.0], 1.0);
    let b = cube(folder.path(), "b.off", [4e5 + 0.5, 5e6, 30.0], 1.0);
    let run = union(&[&a, &b], &["--tolerance", "1e-9"]);
    assert!(!run.stderr.contains("put together"), "{}", run.stderr);
    let c = cube(folder.path(), "c.off", [4e5 + 1.000_01, 5e6, 30.0], 1.0);
    let run = union(&[&a, &c], &["--tolerance", "1e-4"]);
    assert!(run.stderr.contains("put together"), "{}", run.stderr);
    assert_eq!(run.json()["solids"], 1);
}

#[test]
fn pinches_are_split_by_congruence_too() {
    let folder = tempfile::tempdir().unwrap();
    let a = cube(folder.path(), "a.off", [0.0; 3], 1.0);
    let b = cube(folder.path(), "b.off", [1.0, 1.0, 0.0], 1.0);
    let out = folder.path().join("out.off");
    for options in [&[][..], &["--method", "congruence"]] {
        let run = union(&[&a, &b], &[&["-o", argument(&out)][..], options].concat());
        assert!(run.stderr.contains("written as copies"), "{options:?} {}", run.stderr);
        assert_eq!(info(argument(&out))["manifold"]["verdict"], "yes", "{options:?}");
    }
}

/// A prism of height 1 on a polygon.
fn prism(corners: &[[f64; 2]]) -> String {
    let count = corners.len();
    let mut text = format!("OFF\n{} {} 0\n", 2 * count, count + 2);
    for z in [0, 1] {
        for [x, y] in corners {
            writeln!(text, "{x:?} {y:?} {z}").unwrap();
        }
    }
    let list = |corners: Vec<usize>| {
        let words: Vec<String> = corners.iter().map(usize::to_string).collect();
        format!("{} {}\n", corners.len(), words.join(" "))
    };
    text += &list((0..count).rev().collect());
    text += &list((count..2 * count).collect());
    for i in 0..count {
        let j = (i + 1) % count;
        text += &list(vec![i, j, j + count, i + count]);
    }
    text
}

#[test]
fn folds_narrower_than_the_tolerance_are_closed() {
    let folder = tempfile::tempdir().unwrap();
    // A square with a slit, a spike and a step that are narrower than the tolerance; the slit's tip is beyond its other side's corner.
    let outlines: [&[[f64; 2]]; 3] = [
        &[
            [0., 0.],
            [4., 0.],
            [4., 4.],
            [2.000_1, 4.],
            [2.000_15, 1.],
            [2.000_05, 1.000_1],
            [2., 4.],
            [0., 4.],
        ],
        &[[0., 0.], [4., 0.], [4., 2.], [6., 2.000_05], [4., 2.000_1], [4., 4.], [0., 4.]],
        &[[0., 0.], [2., 0.], [2.000_1, 0.000_1], [1.999_9, 0.000_15], [4., 0.000_2], [4., 4.], [0., 4.]],
    ];
    for (i, outline) in outlines.into_iter().enumerate() {
        let path = written(folder.path(), "fold.off", &prism(outline));
        let other = cube(folder.path(), "other.off", [1.0, 1.0, 0.25], 0.5);
        for tolerance in ["0.0005", "0.001", "0.01"] {
            let run = union(&[&path, &other], &["--tolerance", tolerance]);
            assert_eq!(run.status, 0, "{i} {tolerance} {}", run.stderr);
            assert!(is_near(&run.json()["measure"], 16.0, 0.02), "{i} {tolerance} {}", run.stdout);
        }
    }
}

/// The unit cube of `.poly` files, with more vertices and a top facet.
fn poly(vertices: &[[f64; 3]], top: &str, more: &str) -> String {
    let mut text = format!("{} 3 0 0\n", 8 + vertices.len());
    let corners = [
        [0., 0., 0.],
        [1., 0., 0.],
        [1., 1., 0.],
        [0., 1., 0.],
        [0., 0., 1.],
        [1., 0., 1.],
        [1., 1., 1.],
        [0., 1., 1.],
    ];
    for (i, [x, y, z]) in corners.iter().chain(vertices).enumerate() {
        writeln!(text, "{i} {x} {y} {z}").unwrap();
    }
    let count = 6 + more.matches("1 0\n").count();
    write!(text, "{count} 0\n{top}1 0\n4 0 3 2 1\n").unwrap();
    for side in ["0 1 5 4", "1 2 6 5", "2 3 7 6", "3 0 4 7"] {
        write!(text, "1 0\n4 {side}\n").unwrap();
    }
    text + more + "0\n0\n"
}

/// The facets of `.poly` files are checked as the surfaces with rings that they state.
#[test]
fn facets_are_checked_by_their_rings() {
    let folder = tempfile::tempdir().unwrap();
    let codes = |text: &str| -> Vec<u64> {
        let path = written(folder.path(), "a.poly", text);
        let found = info(argument(&path));
        let faults = found["geometry"]["faults"].as_array().unwrap().clone();
        faults.iter().map(|fault| fault["code"].as_u64().unwrap()).collect()
    };
    let rings =
        [[0.2, 0.2, 1.], [0.8, 0.2, 1.], [0.5, 0.5, 1.], [0.5, 0.3, 1.], [0.8, 0.3, 1.], [0.8, 0.4, 1.]];
    // Two holes that cross.
    let crossing = poly(&rings, "3 0\n4 4 5 6 7\n3 10 9 8\n3 13 12 11\n", "1 0\n3 8 9 10\n");
    assert!(codes(&crossing).contains(&201), "{:?}", codes(&crossing));
    // A hole outside of the top.
    let outside: Vec<[f64; 3]> =
        [[1.2, 1.2], [1.8, 1.2], [1.8, 1.8], [1.2, 1.8]].map(|[x, y]| [x, y, 1.]).to_vec();
    let outside = poly(&outside, "2 1\n4 4 5 6 7\n4 8 11 10 9\n1 0.5 0.5 1.0\n", "");
    assert!(codes(&outside).contains(&206), "{:?}", codes(&outside));
    // A hole that runs the way of the top, filled by a facet.
    let hole = [[0.2, 0.2, 1.], [0.8, 0.2, 1.], [0.5, 0.5, 1.]];
    let same_way = poly(&hole, "2 1\n4 4 5 6 7\n3 8 9 10\n1 0.5 0.3 1.0\n", "1 0\n3 8 9 10\n");
    assert!(codes(&same_way).contains(&208), "{:?}", codes(&same_way));
    let sound = poly(&hole, "2 1\n4 4 5 6 7\n3 10 9 8\n1 0.5 0.3 1.0\n", "1 0\n3 8 9 10\n");
    assert_eq!(codes(&sound), Vec::<u64>::new());
    // A top that is bent by its hole.
    let bent = poly(
        &[[0.2, 0.2, 1.5], [0.8, 0.2, 1.5], [0.5, 0.5, 1.5]],
        "2 1\n4 4 5 6 7\n3 10 9 8\n1 0.5 0.3 1.0\n",
        "1 0\n3 8 9 10\n",
    );
    assert!(codes(&bent).contains(&203), "{:?}", codes(&bent));
}

#[test]
fn a_model_whose_certificate_or_provenance_fails_is_not_written() {
    let folder = tempfile::tempdir().unwrap();
    let a = cube(folder.path(), "a.off", [0.0; 3], 1.0);
    let b = cube(folder.path(), "b.off", [0.5; 3], 1.0);
    let out = folder.path().join("out.off");
    std::fs::write(&out, "an older file").unwrap();
    let no_folder = folder.path().join("no").join("other.json");
    for option in ["--certificate", "--provenance"] {
        for verb in [&["boolean", "union"][..], &["arrange"]] {
            let mut arguments: Vec<&str> = verb.to_vec();
            let places = [&a, &b, &out, &no_folder].map(|path| path.to_str().unwrap());
            arguments.extend([places[0], places[1], "-o", places[2], option, places[3]]);
            let done = coface(&arguments);
            assert_eq!(done.status, 1, "{arguments:?}: {}", done.stderr);
            assert_eq!(std::fs::read_to_string(&out).unwrap(), "an older file", "{arguments:?}");
        }
    }
    let left: Vec<_> =
        std::fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left.len(), 3, "{left:?}");
}
