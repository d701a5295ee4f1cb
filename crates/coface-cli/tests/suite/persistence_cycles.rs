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
