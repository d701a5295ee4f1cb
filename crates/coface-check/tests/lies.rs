//! True certificates are verified, and changed ones are refused. Certificates are made here by a method of their own: dense elimination.

#![allow(
    clippy::needless_range_loop,
    clippy::type_complexity,
    reason = "dense elimination is written as its formulas are"
)]
use coface_check::{Complex, check, sha256};
use serde_json::{Value, json};

/// The projective plane with six vertices.
const PLANE: &str = "[[0,1,2],[0,1,5],[0,2,4],[0,3,4],[0,3,5],[1,2,3],[1,3,4],[1,4,5],[2,3,5],[2,4,5]]";

type Dense = Vec<Vec<i64>>;

fn identity(size: usize) -> Dense {
    (0..size).map(|i| (0..size).map(|j| i64::from(i == j)).collect()).collect()
}

/// U, its inverse, V, its inverse, and the diagonal of U A V, by steps on rows and columns.
fn smith(mut a: Dense, rows: usize, width: usize) -> ([Dense; 4], Vec<i64>) {
    let [mut u, mut ui, mut v, mut vi] = [identity(rows), identity(rows), identity(width), identity(width)];
    let mut diagonal = Vec::new();
    for t in 0..rows.min(width) {
        loop {
            let places = (t..rows).flat_map(|i| (t..width).map(move |j| (i, j)));
            let Some((i, j)) = places.filter(|&(i, j)| a[i][j] != 0).min_by_key(|&(i, j)| a[i][j].abs())
            else {
                return ([u, ui, v, vi], diagonal);
            };
            a.swap(t, i);
            u.swap(t, i);
            ui.iter_mut().for_each(|row| row.swap(t, i));
            a.iter_mut().for_each(|row| row.swap(t, j));
            v.iter_mut().for_each(|row| row.swap(t, j));
            vi.swap(t, j);
            let mut is_clear = true;
            for i in t + 1..rows {
                let q = a[i][t] / a[t][t];
                for j in 0..width {
                    a[i][j] -= q * a[t][j];
                }
                for j in 0..rows {
                    u[i][j] -= q * u[t][j];
                    ui[j][t] += q * ui[j][i];
                }
                is_clear &= a[i][t] == 0;
            }
            for j in t + 1..width {
                let q = a[t][j] / a[t][t];
                for row in a.iter_mut().chain(v.iter_mut()) {
                    row[j] -= q * row[t];
                }
                for i in 0..width {
                    vi[t][i] += q * vi[j][i];
                }
                is_clear &= a[t][j] == 0;
            }
            if is_clear {
                break;
            }
        }
        if a[t][t] < 0 {
            a[t].iter_mut().chain(u[t].iter_mut()).for_each(|entry| *entry = -*entry);
            ui.iter_mut().for_each(|row| row[t] = -row[t]);
        }
        diagonal.push(a[t][t]);
    }
    ([u, ui, v, vi], diagonal)
}

fn columns(matrix: &Dense) -> Value {
    let column = |j: usize| -> Value {
        let entries = matrix.iter().enumerate().filter(|(_, row)| row[j] != 0);
        entries.map(|(i, row)| json!([i, row[j]])).collect()
    };
    (0..matrix.len()).map(column).collect()
}

/// A certificate without pairs, of groups over the integers as (rank, torsion).
fn certificate(input: &str, coefficients: &str, cohomology: bool, groups: &[(u64, &[u64])]) -> Value {
    let complex = Complex::read(input.as_bytes()).expect("the input is read");
    let counts = complex.counts();
    let forms = (1..counts.len()).map(|degree| {
        let mut dense = vec![vec![0; counts[degree]]; counts[degree - 1]];
        for cell in 0..counts[degree] {
            complex
                .boundary(degree, cell)
                .iter()
                .for_each(|(face, entry)| dense[*face as usize][cell] = *entry);
        }
        let ([u, ui, v, vi], diagonal) = smith(dense, counts[degree - 1], counts[degree]);
        json!({"left": columns(&u), "left_inverse": columns(&ui), "right": columns(&v),
               "right_inverse": columns(&vi), "diagonal": diagonal})
    });
    let groups = groups.iter().enumerate();
    let groups: Value = groups
        .map(|(k, (betti, torsion))| json!({"degree": k, "betti": betti, "torsion": torsion}))
        .collect();
    json!({
        "coface_certificate": 1, "kind": "homology", "inputs": [{"name": "a.json", "sha256": sha256(input.as_bytes())}], "reduced": false,
        "answer": {"file": "a.json", "coefficients": coefficients, "cohomology": cohomology, "homology": groups,
                   "cycles": [[1]], "remarks": []},
        "proof": {"cells": counts, "pairs": vec![json!([]); counts.len() - 1], "smith": forms.collect::<Vec<_>>()},
    })
}

fn verdict(certificate: &Value, input: &str) -> Result<Vec<String>, String> {
    let found = check(certificate.to_string().as_bytes(), &[input.as_bytes()]);
    found.map(|verdict| verdict.proved().to_vec()).map_err(|fault| fault.to_string())
}

#[test]
fn groups_of_the_projective_plane_follow_over_every_ring() {
    let cases: &[(&str, bool, &[(u64, &[u64])])] = &[
        ("Z", false, &[(1, &[]), (0, &[2]), (0, &[])]),
        ("Z", true, &[(1, &[]), (0, &[]), (0, &[2])]),
        ("Q", false, &[(1, &[]), (0, &[]), (0, &[])]),
        ("Z/2", false, &[(1, &[]), (1, &[]), (1, &[])]),
        ("Z/3", true, &[(1, &[]), (0, &[]), (0, &[])]),
        ("Z/4", false, &[(1, &[]), (0, &[2]), (0, &[2])]),
    ];
    for (ring, cohomology, groups) in cases {
        let proved = verdict(&certificate(PLANE, ring, *cohomology, groups), PLANE);
        assert_eq!(proved.map(|claims| claims.len()), Ok(3), "{ring} {cohomology}");
        // Each group made larger by one summand is refused.
        for k in 0..3 {
            let mut enlarged = groups.to_vec();
            enlarged[k].0 += 1;
            let refusal = verdict(&certificate(PLANE, ring, *cohomology, &enlarged), PLANE).unwrap_err();
            assert!(refusal.starts_with("answer: H"), "{refusal}");
        }
    }
    let certificate = certificate(PLANE, "Z", false, cases[0].2);
    let found = check(certificate.to_string().as_bytes(), &[PLANE.as_bytes()]).expect("it is true");
    assert_eq!(found.proved(), ["H_0 = Z", "H_1 = Z/2", "H_2 = 0"]);
    assert_eq!(found.unchecked(), ["cycles"]);
}

/// A triangle with pairs: the disk and one edge, then a spanning tree.
fn disk() -> (&'static str, Value) {
    let input = "[[0,1,2]]";
    let mut whole = certificate(input, "Z", false, &[(1, &[]), (0, &[]), (0, &[])]);
    // Edges 0, 1, 2 are {0, 1}, {0, 2}, {1, 2}: the last cancels with the triangle.
    whole["proof"]["pairs"] = json!([[[1, 0], [2, 1]], [[2, 0]]]);
    whole["proof"]["smith"] = json!([null, null]);
    (input, whole)
}

#[test]
fn pairs_cancel_in_their_order_alone() {
    let (input, whole) = disk();
    assert_eq!(verdict(&whole, input), Ok(["H_0 = Z", "H_1 = 0", "H_2 = 0"].map(str::to_owned).to_vec()));
    let refused = [
        (json!([[[1, 0], [2, 1]], [[2, 0], [2, 0]]]), "two pairs"),
        (json!([[[1, 0], [2, 0]], [[2, 0]]]), "two pairs"),
        (json!([[[2, 0], [1, 1]], [[2, 0]]]), "no unit incidence"),
        // {0, 1} with 0 before {0, 2} with 2: the second has the face 0 of the first.
        (json!([[[0, 0], [2, 1]], [[2, 0]]]), "order is wrong"),
        (json!([[[1, 0]], [[2, 0]]]), "it is not"),
        (json!([[[1, 0], [9, 1]], [[2, 0]]]), "there is no cell"),
        (json!([[[1, 0], [2, 1]]]), "pairs of 1 degrees"),
    ];
    for (pairs, why) in refused {
        let mut changed = whole.clone();
        changed["proof"]["pairs"] = pairs.clone();
        let refusal = verdict(&changed, input).expect_err("a wrong matching");
        assert!(refusal.contains(why), "{pairs}: {refusal}");
    }
}

/// All places of a value, as JSON pointers.
fn places(value: &Value, here: &str, found: &mut Vec<String>) {
    found.push(here.to_owned());
    match value {
        Value::Array(items) => {
            items.iter().enumerate().for_each(|(i, item)| places(item, &format!("{here}/{i}"), found));
        }
        Value::Object(items) => {
            items.iter().for_each(|(key, item)| places(item, &format!("{here}/{key}"), found));
        }
        _ => (),
    }
}

fn mutate(value: &mut Value, kind: u64, at: usize) {
    *value = match (value.take(), kind % 4) {
        (Value::Number(n), 0) => (n.as_i64().unwrap_or(0) + 1).into(),
        (Value::Number(n), 1) => (n.as_i64().unwrap_or(0) - 1).into(),
        (Value::Number(n), 2) => (-n.as_i64().unwrap_or(0)).into(),
        (Value::Number(_), _) => Value::Null,
        (Value::Bool(b), _) => (!b).into(),
        (Value::String(s), 0) => (s + "0").into(),
        (Value::String(_), 1) => "Q".into(),
        (Value::String(_), _) => "Z/2".into(),
        (Value::Array(mut items), kind) if !items.is_empty() => {
            let at = at % items.len();
            match kind {
                0 => drop(items.remove(at)),
                1 => items.insert(at, items[at].clone()),
                2 => items.swap(at, 0),
                _ => items[at] = Value::Null,
            }
            items.into()
        }
        (Value::Object(items), _) => {
            let at = at % items.len();
            items.into_iter().enumerate().filter(|(i, _)| *i != at).map(|(_, item)| item).collect()
        }
        (other, _) => json!([other]),
    };
}

#[test]
fn changed_certificates_are_refused_or_prove_the_same() {
    // These keys say nothing that is proved: the name of the input, and parts of the answer that are listed as unchecked.
    let meaning = |certificate: &Value| {
        let mut kept = certificate.clone();
        let answer = kept["answer"].as_object_mut().expect("an accepted answer is an object");
        ["file", "remarks", "cycles"].iter().for_each(|key| drop(answer.remove(*key)));
        kept["inputs"][0].as_object_mut().expect("an input has a hash").remove("name");
        kept
    };
    let plane = certificate(PLANE, "Z", false, &[(1, &[]), (0, &[2]), (0, &[])]);
    let (triangle, pairs) = disk();
    for (input, whole) in [(PLANE, plane), (triangle, pairs)] {
        let truth = verdict(&whole, input).expect("it is true");
        let mut all = Vec::new();
        places(&whole, "", &mut all);
        let mut state = 29u64;
        let mut random = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as usize
        };
        let mut accepted = 0;
        for _ in 0..10_000 {
            let place = &all[random() % all.len()];
            let mut changed = whole.clone();
            mutate(
                changed.pointer_mut(place).expect("a place of the certificate"),
                random() as u64,
                random(),
            );
            let Ok(proved) = verdict(&changed, input) else { continue };
            // The groups of a disk are the same over each ring and in cohomology: an answer to such a question is true as well.
            if input == triangle && ["/answer/coefficients", "/answer/cohomology"].contains(&&place[..]) {
                continue;
            }
            assert_eq!(proved, truth, "{place}");
            // Entries of a column and pairs of a matching may stand in another order, if it is an order of elimination too.
            let is_order = place.starts_with("/proof/smith/") || place.starts_with("/proof/pairs/");
            assert!(is_order || meaning(&changed) == meaning(&whole), "{place}");
            accepted += 1;
        }
        assert!(accepted < 3_000, "{accepted} of 10,000 changes are accepted");
        assert!(
            verdict(&whole, "[[0,1,2],[3]]")
                .expect_err("another input")
                .starts_with("input: the certificate")
        );
    }
}

#[test]
fn inputs_that_mean_several_things_are_refused() {
    let refused: [&[u8]; 11] = [
        b"",
        b"{}",
        b"[]",
        b"[[0,0]]",
        b"[[0]] [[1]]",
        br#"{"facets":[[0]],"boundaries":[]}"#,
        br#"{"boundaries":[{"rows":9000000,"cols":1,"entries":[]}]}"#,
        br#"{"boundaries":[{"rows":1,"cols":1,"entries":[[0,0,1]]},{"rows":1,"cols":1,"entries":[[0,0,1]]}]}"#,
        b"OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
        b"v 0 0 0\nq 1\n",
        b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n",
    ];
    for input in refused {
        assert!(Complex::read(input).is_err(), "{}", String::from_utf8_lossy(input));
    }
    // Facets whose faces would not fit.
    let long: Vec<u32> = (0..64).collect();
    assert!(Complex::read(json!([long]).to_string().as_bytes()).is_err());
    let quads = b"OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n2 1 0\n4 0 1 2 3\n4 1 4 5 2\n";
    assert_eq!(Complex::read(quads).expect("two squares").counts(), [6, 7, 2]);
}
