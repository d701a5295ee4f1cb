//! `coface persistence --cycles` as a user runs it.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{coface_in, coface_reading};
use serde_json::{Value, json};
use std::collections::BTreeMap;

/// The boundary of a list of terms [coefficient, vertices of a simplex], modulo a prime.
fn boundary(chain: &Value, prime: i64) -> BTreeMap<Vec<u64>, i64> {
    let mut sum = BTreeMap::new();
    for term in chain.as_array().unwrap() {
        let coefficient = term[0].as_i64().unwrap();
        let vertices: Vec<u64> =
            term[1].as_array().unwrap().iter().map(|vertex| vertex.as_u64().unwrap()).collect();
        for left_out in 0..vertices.len() {
            let mut face = vertices.clone();
            face.remove(left_out);
            // Faces are compared in rising order, with the sign of the permutation.
            let swaps = (0..face.len()).flat_map(|i| (0..i).map(move |j| (j, i)));
            let is_odd = swaps.filter(|&(j, i)| face[j] > face[i]).count() % 2 == 1;
            face.sort_unstable();
            let sign = if (left_out % 2 == 1) == is_odd { 1 } else { -1 };
            *sum.entry(face).or_insert(0) += sign * coefficient;
        }
    }
    sum.retain(|_, x| {
        *x = x.rem_euclid(prime);
        *x != 0
    });
    sum
}

fn as_chain(chain: &Value, prime: i64) -> BTreeMap<Vec<u64>, i64> {
    let mut sum = BTreeMap::new();
    for term in chain.as_array().unwrap() {
        let mut vertices: Vec<u64> =
            term[1].as_array().unwrap().iter().map(|vertex| vertex.as_u64().unwrap()).collect();
        let pairs = (0..vertices.len()).flat_map(|i| (0..i).map(move |j| (j, i)));
        let is_odd = pairs.filter(|&(j, i)| vertices[j] > vertices[i]).count() % 2 == 1;
        vertices.sort_unstable();
        let x = term[0].as_i64().unwrap();
        *sum.entry(vertices).or_insert(0) += if is_odd { -x } else { x };
    }
    sum.retain(|_, x| {
        *x = x.rem_euclid(prime);
        *x != 0
    });
    sum
}

/// That the terms of each class prove it: its cycle is one, is what its bounding chain bounds, and has the value 1 under its cocycle.
fn assert_proved(answer: &Value, prime: i64) {
    for pair in answer["diagram"].as_array().unwrap() {
        if pair["degree"] != json!(0) {
            assert!(boundary(&pair["cycle"], prime).is_empty(), "{pair}");
        }
        assert_eq!(pair["death"].is_null(), pair["bounding_chain"].is_null(), "{pair}");
        if !pair["death"].is_null() {
            assert_eq!(boundary(&pair["bounding_chain"], prime), as_chain(&pair["cycle"], prime), "{pair}");
        }
        let (cycle, cocycle) = (as_chain(&pair["cycle"], prime), as_chain(&pair["cocycle"], prime));
        let value: i64 = cycle.iter().map(|(cell, x)| x * cocycle.get(cell).unwrap_or(&0)).sum();
        assert_eq!(value.rem_euclid(prime), 1, "{pair}");
    }
}

/// Every complex of points has cycles; the diameters of their simplices say when they are there.
#[test]
fn cycles_of_points_prove_their_diagrams() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    let point = |i: usize| [(i * 37 % 101) as f64, (i * 53 % 103) as f64, (i * 71 % 107) as f64];
    let row = |i: usize| point(i).map(|x| x.to_string()).join(",");
    std::fs::write(place.join("p.csv"), (0..24).map(|i| row(i) + "\n").collect::<String>()).unwrap();
    let diameter = |cell: &Vec<u64>| {
        let pairs = cell.iter().flat_map(|&i| cell.iter().map(move |&j| (i as usize, j as usize)));
        let lengths = pairs
            .map(|(i, j)| point(i).iter().zip(point(j)).map(|(x, y)| (x - y) * (x - y)).sum::<f64>().sqrt());
        lengths.fold(0.0, f64::max)
    };
    for (prime, options) in [
        (2, &["--rips", "--dimension", "2"][..]),
        (3, &["--rips", "--threshold", "60"]),
        (5, &["--cech", "--dimension", "2"]),
        (3, &["--landmarks", "12"]),
        (7, &["--alpha", "--radii"]),
    ] {
        let field = prime.to_string();
        let line =
            [&["persistence", "p.csv", "--cycles", "--json", "--coefficients", &field], options].concat();
        let answer = coface_in(place, &line).json();
        assert_proved(&answer, prime);
        // The same classes as without cycles.
        let line = [&["persistence", "p.csv", "--json", "--coefficients", &field], options].concat();
        let plain = coface_in(place, &line).json();
        let classes = |answer: &Value| {
            let pairs = answer["diagram"].as_array().unwrap().iter();
            let mut all: Vec<String> =
                pairs.map(|pair| format!("{} {} {}", pair["degree"], pair["birth"], pair["death"])).collect();
            all.sort();
            all
        };
        assert_eq!(classes(&answer), classes(&plain), "{options:?}");
        for key in ["betti", "function", "threshold"] {
            assert_eq!(answer[key], plain[key], "{options:?}");
        }
        if options[0] != "--rips" {
            continue;
        }
        for pair in answer["diagram"].as_array().unwrap() {
            let last = |chain: &Value| as_chain(chain, prime).keys().map(&diameter).fold(0.0, f64::max);
            assert!((last(&pair["cycle"]) - pair["birth"].as_f64().unwrap()).abs() < 1e-9, "{pair}");
            if let Some(death) = pair["death"].as_f64() {
                assert!((last(&pair["bounding_chain"]) - death).abs() < 1e-9, "{pair}");
            }
        }
    }
    let line = ["persistence", "p.csv", "--rips", "--min-persistence", "5", "--cycles", "p.vtk"];
    assert_eq!(coface_in(place, &line).status, 0);
    assert!(std::fs::read(place.join("p.vtk")).is_ok_and(|bytes| !bytes.is_empty()));
}

#[test]
fn cycles_of_graphs_have_their_vertices() {
    let square = b"a c 1\nc b 2\nb d 3\nd a 4\na b 6\n";
    let line = ["persistence", "-", "--flag", "--cycles", "--json"];
    let answer = coface_reading(&line, square).json();
    assert_eq!(answer["vertex_names"], json!(["a", "c", "b", "d"]));
    let hole = answer["diagram"].as_array().unwrap().last().unwrap();
    assert_eq!((&hole["birth"], &hole["death"]), (&json!(4.0), &json!(6.0)));
    assert_eq!(
        (hole["cycle"].as_array().unwrap().len(), hole["bounding_chain"].as_array().unwrap().len()),
        (4, 2)
    );
    let numbers = b"10 30 1\n30 20 2\n20 40 3\n40 10 4\n10 20 6\n";
    let answer = coface_reading(&line, numbers).json();
    assert_proved(&answer, 2);
    let hole = answer["diagram"].as_array().unwrap().last().unwrap();
    let vertices: Vec<Vec<u64>> = as_chain(&hole["cycle"], 2).into_keys().collect();
    assert_eq!(vertices, [[10, 30], [10, 40], [20, 30], [20, 40]]);
    let line = ["persistence", "-", "--flag", "--directed", "--cycles", "--json"];
    let answer = coface_reading(&line, b"7 9 1\n9 7 2\n").json();
    assert_eq!(answer["diagram"][2]["cycle"].as_array().unwrap().len(), 2);
    // There are no positions to draw at.
    let run = coface_reading(&["persistence", "-", "--flag", "--cycles", "x.obj"], numbers);
    assert!(run.fails_with(1).contains(".json"), "{}", run.stderr);
}

/// A torus of height 0 to 3, whose answer is checked from its JSON alone.
#[test]
fn cycles_of_a_mesh_prove_its_diagram() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    assert_eq!(coface_in(place, &["generate", "torus", "-o", "torus.off"]).status, 0);
    for prime in [2i64, 3] {
        let field = format!("f{prime}");
        let run = coface_in(
            place,
            &["persistence", "torus.off", "--coefficients", &field, "--cycles", "torus.obj", "--json"],
        );
        let answer = run.json();
        assert_eq!(answer["torsion_primes"], json!([]));
        let pairs = answer["diagram"].as_array().unwrap();
        assert_eq!(answer["betti"], json!([1, 2, 1]));
        for pair in pairs {
            if pair["degree"] != json!(0) {
                assert!(boundary(&pair["cycle"], prime).is_empty(), "{pair}");
            }
            match pair["death"].is_null() {
                true => assert!(pair["bounding_chain"].is_null()),
                false => {
                    let bounded = boundary(&pair["bounding_chain"], prime);
                    assert_eq!(bounded, as_chain(&pair["cycle"], prime), "{pair}");
                }
            }
            // Terms of a cocycle and a cycle name cells alike.
            let value: i64 = pair["cocycle"]
                .as_array()
                .unwrap()
                .iter()
                .flat_map(|a| pair["cycle"].as_array().unwrap().iter().map(move |b| (a, b)))
                .filter(|(a, b)| a[1] == b[1])
                .map(|(a, b)| a[0].as_i64().unwrap() * b[0].as_i64().unwrap())
                .sum();
            assert_eq!(value.rem_euclid(prime), 1, "{pair}");
        }
    }
    let obj = std::fs::read_to_string(place.join("torus.obj")).unwrap();
    assert!(obj.contains("g H2_0_from_1_to_inf"), "{obj}");
}

#[test]
fn cycles_are_written_as_json_and_pictures() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    std::fs::write(place.join("rim.off"), "OFF\n4 2 0\n0 0 0\n1 1 0\n2 0 0\n1 3 0\n3 0 1 2\n3 0 2 3\n")
        .unwrap();
    for name in ["a.json", "a.vtk", "a.obj", "a.vtu"] {
        let run = coface_in(place, &["persistence", "rim.off", "--function", "y", "--cycles", name]);
        assert_eq!(run.status, 0, "{name}: {}", run.stderr);
        assert!(place.join(name).is_file());
        assert!(run.stdout.contains("the same pairs over every field"), "{}", run.stdout);
    }
    let written: Value = serde_json::from_slice(&std::fs::read(place.join("a.json")).unwrap()).unwrap();
    assert!(written["diagram"][0]["cycle"].is_array());
    // Without --cycles nothing of it is there.
    let plain = coface_in(place, &["persistence", "rim.off", "--json"]).json();
    assert!(plain["diagram"][0].get("cycle").is_none() && plain.get("torsion_primes").is_none());
}

/// The projective plane of six vertices, as it grows vertex by vertex.
#[test]
fn primes_of_torsion_are_named() {
    let plane = b"[[0,1,2],[0,2,3],[0,3,4],[0,4,5],[0,5,1],[1,2,4],[2,3,5],[3,4,1],[4,5,2],[5,1,3]]";
    let answer = coface_reading(&["persistence", "-", "--cycles", "--json"], plane).json();
    assert_eq!(answer["torsion_primes"], json!([2]));
    let page = coface_reading(&["persistence", "-", "--cycles"], plane).stdout;
    assert!(page.contains("p in [2]"), "{page}");
}

#[test]
fn cycles_of_volumes_are_those_of_their_voxels() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    let header = "NRRD0004\ntype: double\ndimension: 2\nsizes: 3 3\nencoding: ascii\n\n";
    std::fs::write(place.join("ring.nrrd"), format!("{header}1 1 1 1 0 1 1 1 1\n")).unwrap();
    let run = coface_in(place, &["persistence", "ring.nrrd", "--function", "y", "--cycles", "--json"]);
    let answer = run.json();
    assert_eq!(answer["betti"], json!([1, 1, 0]));
    let hole = answer["diagram"].as_array().unwrap().iter().find(|pair| pair["degree"] == json!(1)).unwrap();
    assert!(hole["cycle"].as_array().unwrap().len() >= 4);
}

/// Five points on a circle, of which each has one distance to its neighbors and another to the rest: classes of one birth.
#[test]
fn cycles_change_no_pair() {
    let folder = tempfile::tempdir().unwrap();
    let square = "0 1 2 1 3\n1 0 1 3 1\n2 1 0 1 3\n1 3 1 0 1\n3 1 3 1 0\n";
    let graph = "1,0,4\n2,1,3\n3,0,4\n3,1,1\n4,0,1\n4,2,2\n4,3,3\n5,0,2\n5,2,2\n5,3,4\n5,4,4\n6,0,3\n6,2,2\n6,5,1\n7,0,4\n7,1,1\n7,3,3\n7,4,3\n7,5,1\n7,6,4\n";
    std::fs::write(folder.path().join("square.csv"), square).unwrap();
    std::fs::write(folder.path().join("graph.csv"), graph).unwrap();
    for line in [&["square.csv", "--rips", "--distances", "square"][..], &["graph.csv", "--flag"]] {
        let ask = |more: &[&str]| {
            coface_in(folder.path(), &[&["persistence"][..], line, &["--json"], more].concat()).json()
        };
        let (with, without) = (ask(&["--cycles"]), ask(&[]));
        let cells = |answer: &Value| -> Vec<Value> {
            let pairs = answer["diagram"].as_array().unwrap().iter();
            let keys = ["degree", "birth", "death", "birth_cell", "death_cell"];
            pairs.map(|pair| keys.iter().map(|key| pair[*key].clone()).collect()).collect()
        };
        assert_eq!(cells(&with), cells(&without), "{line:?}");
        assert_proved(&with, 2);
    }
}

#[test]
fn cycles_are_written_in_formats_that_are_known() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("p.csv"), "0 0\n3 0\n3 4\n0 4\n").unwrap();
    for line in [
        &["persistence", "p.csv", "--rips", "--cycles", "o.zzz"][..],
        &["homology", "p.csv", "--rips", "--generators", "o.zzz"],
    ] {
        let said = coface_in(folder.path(), line).fails_with(1).to_owned();
        assert!(
            said.contains("o.zzz: the extension \"zzz\" is no format known here; end it in one of off, obj"),
            "{said}"
        );
        // What is read alone, and what is named twice, is none of them.
        assert!(!said.contains("gltf") && !said.contains("nrrd"), "{said}");
        assert!(!folder.path().join("o.zzz").exists());
    }
    let missing = coface_in(folder.path(), &["persistence", "p.csv", "--function", "none.txt"])
        .fails_with(1)
        .to_owned();
    assert!(missing.contains("none.txt: there is no such file or folder; check the path"), "{missing}");
}
