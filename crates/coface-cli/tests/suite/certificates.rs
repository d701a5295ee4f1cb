//! `--certificate` and `coface check`: proofs that hold, and lies that do not.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_reading};
use serde_json::{Value, json};
use std::collections::HashMap;
use std::fs;
use std::path::{Path, PathBuf};

/// The projective plane of 6 vertices: torsion 2 in degree 1.
pub(crate) const PLANE: &str =
    "[[0,1,2],[0,2,3],[0,3,4],[0,4,5],[0,1,5],[1,2,4],[2,4,5],[2,3,5],[1,3,5],[1,3,4]]";

/// Makes a certificate of a file: the file, the certificate, and what the answer says.
fn certified(folder: &Path, name: &str, text: &str, options: &[&str]) -> (PathBuf, PathBuf, Value) {
    let (input, certificate) = (folder.join(name), folder.join(format!("{name}.cert")));
    fs::write(&input, text).unwrap();
    let words = ["homology", argument(&input), "--certificate", argument(&certificate), "--json"];
    let answer = coface(&[&words[..], options].concat()).json();
    (input, certificate, answer)
}

fn checked(certificate: &Path, input: &Path) -> Value {
    coface(&["check", argument(certificate), argument(input), "--json"]).json()
}

#[test]
fn groups_are_proved() {
    let folder = tempfile::tempdir().unwrap();
    for (options, count) in [
        (&[][..], 3),
        (&["--cohomology"][..], 3),
        (&["--coefficients", "q"][..], 3),
        (&["--coefficients", "f2"][..], 3),
        (&["--coefficients", "z/4"][..], 3),
        (&["--reduced"][..], 3),
    ] {
        let (input, certificate, answer) = certified(folder.path(), "plane.json", PLANE, options);
        let verdict = checked(&certificate, &input);
        assert_eq!(verdict["verified"], true, "{options:?}");
        assert_eq!(answer["homology"].as_array().unwrap().len(), count);
        assert!(verdict["proved"].as_array().unwrap().len() >= count, "{verdict}");
        let page = coface(&["check", argument(&certificate), argument(&input)]);
        assert_eq!(page.status, 0);
        assert!(page.stdout.starts_with("verified: "), "{}", page.stdout);
    }
}

pub(crate) const BAND: &str = "[[0,1,2],[1,2,3],[2,3,4],[3,4,0],[4,0,1]]";

#[test]
fn generators_are_proved() {
    let folder = tempfile::tempdir().unwrap();
    let part = folder.path().join("part.json");
    fs::write(&part, "[[0,1],[1,2]]").unwrap();
    let generators = folder.path().join("generators.json");
    for text in [PLANE, BAND] {
        for ring in ["z", "q", "f2", "z/4", "z/6"] {
            for cohomology in [&[][..], &["--cohomology"][..]] {
                let absolute = [&[][..], &["--reduced"], &["--relative", "boundary"]];
                for (options, is_pair) in absolute
                    .map(|one| (one, false))
                    .into_iter()
                    .chain([(&["--relative", argument(&part)][..], true)])
                {
                    let options = [
                        &["--coefficients", ring, "--generators", argument(&generators)],
                        cohomology,
                        options,
                    ]
                    .concat();
                    let (input, certificate, _) = certified(folder.path(), "in.json", text, &options);
                    let mut words = vec!["check", argument(&certificate), argument(&input), "--json"];
                    if is_pair {
                        words.insert(3, argument(&part));
                    }
                    let verdict = coface(&words).json();
                    assert!(verdict["unchecked"].as_array().unwrap().is_empty(), "{options:?} {verdict}");
                    assert!(
                        verdict["proved"]
                            .as_array()
                            .unwrap()
                            .iter()
                            .any(|line| line.to_string().contains("generate"))
                    );
                }
            }
        }
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

fn changed(value: &Value, kind: usize, at: usize) -> Value {
    match value {
        Value::Number(n) => match (kind % 4, n.as_i64()) {
            (0, Some(n)) => (n + 1).into(),
            (1, Some(n)) => (n - 1).into(),
            (2, Some(n)) => (-n).into(),
            (0, None) => json!(n.as_f64().unwrap() * 1.001 + 0.01),
            (1, None) => json!(-n.as_f64().unwrap()),
            _ => Value::Null,
        },
        Value::Bool(b) => (!b).into(),
        Value::String(s) => match kind % 4 {
            0 => format!("{s}0").into(),
            1 => format!("-{s}").into(),
            2 => "no".into(),
            _ => "Q".into(),
        },
        Value::Array(items) if !items.is_empty() => {
            let (mut items, at) = (items.clone(), at % items.len());
            match kind % 4 {
                0 => drop(items.remove(at)),
                1 => items.insert(at, items[at].clone()),
                2 => items.swap(at, 0),
                _ => items[at] = Value::Null,
            }
            items.into()
        }
        Value::Object(items) => {
            let at = at % items.len().max(1);
            items
                .iter()
                .enumerate()
                .filter(|(i, _)| *i != at)
                .map(|(_, (key, item))| (key.clone(), item.clone()))
                .collect()
        }
        other => json!([other]),
    }
}

/// How a claim of the rule begins.
const RULE: &str = "inside is where winding numbers are";

/// What certificates of points leave open whose simplices are listed.
const LISTED: &str = "that these are the simplices of the input";

/// Changes a certificate 10,000 times: each change is refused, or proves nothing that the true one does not. A certificate of a hundred places can
/// be changed in some six hundred ways; one that was drawn before has the same verdict, and is not asked again.
pub(crate) fn lie_about(certificate: &Path, inputs: &[&Path]) {
    let honest: Value = serde_json::from_slice(&fs::read(certificate).unwrap()).unwrap();
    let inputs: Vec<Vec<u8>> = inputs.iter().map(|input| fs::read(input).unwrap()).collect();
    let inputs: Vec<&[u8]> = inputs.iter().map(Vec::as_slice).collect();
    let verdict = |value: &Value| coface_check_binary::check(value.to_string().as_bytes(), &inputs);
    let truth = verdict(&honest).expect("the program wrote it");
    let mut all = Vec::new();
    places(&honest, "", &mut all);
    // Another bound between the same pairs, another tolerance with the same classes, or another threshold with the same simplices is another true claim, and another path may leave the same
    // pieces; other walks are another question.
    let other_claims = ["/min_persistence", "/answer/tolerance", "/answer/threshold"];
    let has_points = ["rips", "image", "zigzag", "vineyard"].contains(&honest["kind"].as_str().unwrap())
        || !honest["facets"].is_null()
        || !honest["part"].is_null()
        || honest["answer"]["star"] == "extended";
    all.retain(|place| {
        // The same pairs over another field are another true claim too.
        (!has_points || place != "/answer/field")
            && !other_claims.contains(&&place[..])
            && !place.starts_with("/along")
            && !place.starts_with("/walks")
    });
    let mut state = 29u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 33) as usize
    };
    let (mut refused, mut lie) = (0, honest);
    let mut told: HashMap<(&str, String), bool> = HashMap::new();
    for _ in 0..10_000 {
        let place = &all[random() % all.len()];
        let lied = changed(lie.pointer(place).unwrap(), random(), random());
        let is_refused = *told.entry((place, lied.to_string())).or_insert_with(|| {
            let truth_there = std::mem::replace(lie.pointer_mut(place).unwrap(), lied);
            let found = verdict(&lie);
            *lie.pointer_mut(place).expect("it was just changed") = truth_there;
            // Another rule that has the same inside is named.
            let is_true = |line: &String| truth.proved().contains(line) || line.starts_with(RULE);
            if let Ok(found) = &found {
                assert!(found.proved().iter().all(is_true), "{place}: {:?}", found.proved());
            }
            found.is_err()
        });
        refused += usize::from(is_refused);
    }
    assert!(refused > 3_000, "{refused} of 10,000 changes are refused");
}

#[test]
fn changed_certificates_are_refused_or_prove_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let generators = folder.path().join("generators.json");
    for (text, options) in [
        (PLANE, &["--coefficients", "z"][..]),
        (PLANE, &["--coefficients", "z/4", "--cohomology"]),
        (BAND, &["--relative", "boundary"]),
    ] {
        let options = [&["--generators", argument(&generators)], options].concat();
        let (input, certificate, _) = certified(folder.path(), "in.json", text, &options);
        lie_about(&certificate, &[&input]);
    }
}

/// The certificate of a report, and what it proves.
fn reported(folder: &Path, name: &str, text: &str) -> (PathBuf, PathBuf, Vec<String>) {
    let (input, certificate) = (folder.join(name), folder.join(format!("{name}.cert")));
    fs::write(&input, text).unwrap();
    coface(&["info", argument(&input), "--certificate", argument(&certificate), "--json"]).json();
    let verdict = checked(&certificate, &input);
    let proved = verdict["proved"].as_array().unwrap();
    (input, certificate, proved.iter().map(|line| line.as_str().unwrap().to_owned()).collect())
}

#[test]
fn reports_are_proved() {
    let folder = tempfile::tempdir().unwrap();
    // The torus of 7 vertices, and a cone over it, whose tip has the torus as its link.
    let torus: Vec<[u32; 3]> =
        (0..7).flat_map(|i| [[i, (i + 1) % 7, (i + 3) % 7], [i, (i + 2) % 7, (i + 3) % 7]]).collect();
    let cone: Vec<[u32; 4]> = torus.iter().map(|[a, b, c]| [*a, *b, *c, 7]).collect();
    let sphere: Vec<Vec<u32>> = (0..5).map(|i| (0..5).filter(|j| *j != i).collect()).collect();
    let plane_cone: Vec<Value> = serde_json::from_str::<Vec<Vec<u32>>>(PLANE)
        .unwrap()
        .iter()
        .map(|f| json!([f[0], f[1], f[2], 6]))
        .collect();
    let cases = [
        (
            json!(torus).to_string(),
            &["genus = 1", "manifold = [\"yes\",true]", "orientable = true", "boundary_loops = 0"][..],
        ),
        (PLANE.to_owned(), &["genus = 1", "orientable = false", "H_1 = Z/2"]),
        (
            BAND.to_owned(),
            &["genus = 1", "orientable = false", "manifold = [\"yes\",false]", "boundary_loops = 1"],
        ),
        ("[[0,1,2],[2,3,4]]".to_owned(), &["manifold = [\"no\",false]", "components = 1"]),
        ("[[0,1,2],[0,1,3],[0,1,4]]".to_owned(), &["manifold = [\"no\",false]", "orientable = null"]),
        ("[[0,1,2],[2,3]]".to_owned(), &["pure = false", "manifold = [\"no\",false]"]),
        ("[[0,1],[1,2],[3,4]]".to_owned(), &["manifold = [\"yes\",false]", "components = 2"]),
        (json!(cone).to_string(), &["manifold = [\"no\",false]", "euler_characteristic = 1"]),
        (json!(plane_cone).to_string(), &["manifold = [\"no\",false]", "orientable = false"]),
        (json!(sphere).to_string(), &["manifold = [\"yes\",true]", "orientable = true", "H_3 = Z"]),
        ("[[0,1,2],[5]]".to_owned(), &["components = 2", "pure = false"]),
        (
            "{\"vertices\":[[0,0],[1,0],[0,1]],\"facets\":[[0,1,2]]}".to_owned(),
            &["f_vector = [3,3,1]", "boundary_loops = 1"],
        ),
        // A sphere with a loop of edges: nothing is its boundary.
        (
            "[[0,2,1],[0,1,3],[1,2,3],[2,0,3],[3,4],[4,5],[3,5]]".to_owned(),
            &["manifold = [\"no\",true]", "pure = false"],
        ),
        (
            "OFF\n6 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n2 0 0\n2 1 0\n4 0 1 2 3\n4 1 4 5 2\n".to_owned(),
            &["genus = 0", "boundary_loops = 1"],
        ),
        (
            "# made by hand\n\nOFF 3 1 0 # counts\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n".to_owned(),
            &["genus = 0", "boundary_loops = 1"],
        ),
    ];
    for (text, expected) in cases {
        let (input, certificate, proved) =
            reported(folder.path(), if text.contains("OFF") { "in.off" } else { "in.json" }, &text);
        for line in expected {
            assert!(proved.iter().any(|found| found == line), "{text}: {line} is not in {proved:?}");
        }
        if text == PLANE || text.len() < 20 {
            lie_about(&certificate, &[&input]);
        }
    }
}

/// Above dimension 3 bistellar moves of the links show that a complex is a manifold: of the complex projective plane, and of a ball.
#[test]
fn manifolds_above_dimension_three_are_proved() {
    let folder = tempfile::tempdir().unwrap();
    for (shape, claim) in [
        (&["cp2"][..], "manifold = [\"yes\",true]"),
        (&["simplex", "--dimension", "4"], "manifold = [\"yes\",false]"),
    ] {
        let (input, certificate) = (folder.path().join("x.json"), folder.path().join("x.cert"));
        assert_eq!(coface(&[&["generate"], shape, &["-o", argument(&input)]].concat()).status, 0);
        coface(&["info", argument(&input), "--certificate", argument(&certificate), "--json"]).json();
        let verdict = checked(&certificate, &input);
        assert!(verdict["proved"].as_array().unwrap().iter().any(|line| line == claim), "{verdict}");
        lie_about(&certificate, &[&input]);
    }
    // Three facets on one ridge are no manifold, which needs no moves; a suspension of a torus has links that are no spheres.
    let book = "[[0,1,2,3,4],[0,1,2,3,5],[0,1,2,3,6]]";
    let (_, _, claims) = reported(folder.path(), "book.json", book);
    assert!(claims.iter().any(|line| line == "manifold = [\"no\",false]"), "{claims:?}");
}

#[test]
fn shapes_of_the_program_are_proved() {
    let folder = tempfile::tempdir().unwrap();
    for family in ["torus", "klein", "rp2", "csaszar", "sphere"] {
        for extension in ["off", "obj"] {
            let made = folder.path().join(format!("{family}.{extension}"));
            let run = coface(&["generate", family, "-o", argument(&made), "-q"]);
            if run.status != 0 {
                // Some families have no positions that the format could hold.
                continue;
            }
            let text = fs::read_to_string(&made).unwrap();
            let (input, certificate, _) =
                certified(folder.path(), &format!("in_{family}.{extension}"), &text, &[]);
            assert_eq!(checked(&certificate, &input)["verified"], true, "{family}.{extension}");
        }
    }
}

#[test]
fn lies_are_found() {
    let folder = tempfile::tempdir().unwrap();
    let (input, certificate, _) = certified(folder.path(), "plane.json", PLANE, &[]);
    let honest: Value = serde_json::from_slice(&fs::read(&certificate).unwrap()).unwrap();
    let lie = |change: &dyn Fn(&mut Value)| {
        let mut changed = honest.clone();
        change(&mut changed);
        let path = folder.path().join("lie.cert");
        fs::write(&path, changed.to_string()).unwrap();
        let run = coface(&["check", argument(&path), argument(&input)]);
        assert_eq!((run.status, run.stdout.as_str()), (1, ""), "{changed}");
        assert!(run.stderr.contains("not verified"), "{}", run.stderr);
    };
    lie(&|value| value["answer"]["homology"][1]["betti"] = json!(1));
    lie(&|value| value["answer"]["homology"][1]["torsion"] = json!([3]));
    lie(&|value| value["answer"]["homology"][1]["torsion"] = json!([]));
    lie(&|value| value["answer"]["coefficients"] = json!("Q"));
    lie(&|value| value["proof"]["pairs"][0] = json!([]));
    lie(&|value| value["inputs"][0]["sha256"] = json!("0"));
    // A certificate of another input.
    let other = folder.path().join("other.json");
    fs::write(&other, "[[0,1,2]]").unwrap();
    let run = coface(&["check", argument(&certificate), argument(&other)]);
    assert_eq!(run.status, 1);
    // What cannot have a certificate leaves no file.
    let place = folder.path().join("volume.cert");
    let mesh = folder.path().join("tetrahedron.mesh");
    assert_eq!(coface(&["generate", "ball", "-o", argument(&mesh), "-q"]).status, 0);
    let run = coface(&["homology", argument(&mesh), "--certificate", argument(&place)]);
    assert_eq!(run.status, 1);
    assert!(run.stderr.contains("no certificate") && !place.exists(), "{}", run.stderr);
}

#[test]
fn what_is_no_certificate_is_told_so() {
    let folder = tempfile::tempdir().unwrap();
    let twins = "{\"coface_certificate\":1,\"answer\":{\"betti\":1,\"betti\":2},\"inputs\":[]}";
    for text in ["v 0 0 0\n", "[]", "{\"inputs\":[]}", twins] {
        let path = folder.path().join("no.cert");
        std::fs::write(&path, text).unwrap();
        let run = coface(&["check", path.to_str().unwrap()]);
        assert!(run.fails_with(1).contains("not verified: certificate: "), "{}", run.stderr);
    }
}

/// Two polygons with a hole and a common edge, and lines that cross, touch and overlap.
const SQUARES: &str = "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))";
const WEDGE: &str = r#"{"type": "Polygon", "coordinates": [[[4, 1], [6, 2], [4, 3], [1.5, 1.5], [4, 1]]]}"#;
const STROKES: &str = "0,0,4,4\n2,2,5,5\n0,3,5,0.1\n";

#[test]
fn drawings_are_proved() {
    let folder = tempfile::tempdir().unwrap();
    let files = [("a.wkt", SQUARES), ("b.geojson", WEDGE), ("c.lines", STROKES)];
    let [a, b, c] = files.map(|(name, text)| {
        fs::write(folder.path().join(name), text).unwrap();
        folder.path().join(name)
    });
    let place = folder.path().join("proof.cert");
    let proved = |words: &[&str], expected: &[&str], inputs: &[&Path]| {
        coface(&[words, &["--certificate", argument(&place), "--json"]].concat()).json();
        let files: Vec<&str> = inputs.iter().map(|input| argument(input)).collect();
        let verdict = coface(&[&["check", argument(&place)], &files[..], &["--json"]].concat()).json();
        let found = verdict["proved"].as_array().unwrap();
        for line in expected {
            assert!(found.iter().any(|found| found == line), "{line} is not in {verdict}");
        }
        lie_about(&place, inputs);
    };
    // By hand: the wedge meets the square in x = 4 alone, from y = 1 to y = 3, and reaches to the right; its tip is in the hole.
    proved(
        &["boolean", "union", argument(&a), argument(&b)],
        &[
            "the result is (0 | 1) of the inputs, numbered from 0",
            "components = 1",
            "holes = 1",
            "pinches = 0",
        ],
        &[&a, &b],
    );
    proved(&["boolean", "difference", argument(&b), argument(&a)], &["components = 2"], &[&b, &a]);
    proved(&["boolean", "--formula", "a - a", argument(&a)], &["measure = 0, to one part in 10^13"], &[&a]);
    proved(&["arrange", argument(&a)], &["f_vector = [8,8,2]", "inside = [[0],[]]", "holes = 1"], &[&a]);
    proved(
        &["arrange", argument(&a), argument(&b), argument(&c)],
        &["products_zero = true", "components = 1"],
        &[&a, &b, &c],
    );
    proved(&["arrange", argument(&a), "--rule", "evenodd"], &["inside = [[0],[]]"], &[&a]);
}

#[test]
fn drawings_that_cannot_be_proved_leave_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let drawing = folder.path().join("a.wkt");
    let place = folder.path().join("proof.cert");
    for text in ["POINT (1 2)", "POLYGON Z ((0 0 1, 1 0 1, 0 1 1, 0 0 1))"] {
        fs::write(&drawing, text).unwrap();
        let run = coface(&["arrange", argument(&drawing), "--certificate", argument(&place)]);
        assert!(run.fails_with(1).contains("no certificate: "), "{}", run.stderr);
        assert!(!place.exists());
    }
}

#[test]
fn holes_of_polygons_without_area_bound_nothing() {
    // Found by the checker: the hole was taken for the outer ring.
    let folder = tempfile::tempdir().unwrap();
    let drawing = folder.path().join("a.wkt");
    let place = folder.path().join("proof.cert");
    fs::write(
        &drawing,
        "POLYGON ((0 4, 0 4, 0 4, 0 4), (0 0, 1 0, 0 1, 0 0))\nPOLYGON ((5 5, 6 5, 5 6, 5 5))",
    )
    .unwrap();
    let answer =
        coface(&["boolean", "union", argument(&drawing), "--certificate", argument(&place), "--json"]).json();
    assert_eq!((&answer["measure"], &answer["polygons"]), (&json!(0.5), &json!(1)));
    assert!(
        answer["remarks"]
            .to_string()
            .contains("1 hole of a polygon whose outer ring is a single point bounds nothing"),
        "{answer}"
    );
    assert_eq!(checked(&place, &drawing)["verified"], true);
}

/// A torus of nine vertices in space.
pub(crate) const TORUS: &str = "OFF\n9 18 0\n3 0 0\n2 0 1\n2 0 -1\n-1.5 2.6 0\n-1 1.7 1\n-1 1.7 -1\n-1.5 -2.6 0\n-1 -1.7 1\n-1 -1.7 -1\n\
    3 0 3 1\n3 3 4 1\n3 1 4 2\n3 4 5 2\n3 2 5 0\n3 5 3 0\n3 3 6 4\n3 6 7 4\n3 4 7 5\n3 7 8 5\n3 5 8 3\n3 8 6 3\n\
    3 6 0 7\n3 0 1 7\n3 7 1 8\n3 1 2 8\n3 8 2 6\n3 2 0 6\n";

/// At each function the points of vines are proved to be the diagram, and lies about them are refused.
#[test]
fn vineyards_are_proved_at_their_functions() {
    let folder = tempfile::tempdir().unwrap();
    let (input, certificate) = (folder.path().join("torus.off"), folder.path().join("torus.cert"));
    fs::write(&input, TORUS).unwrap();
    let values = folder.path().join("values.txt");
    fs::write(&values, "3\n1\n4\n1\n5\n9\n2\n6\n5\n").unwrap();
    let words = ["persistence", argument(&input), "--certificate", argument(&certificate), "--json"];
    coface(&[&words[..], &["--vineyard", "x", "y", "--coefficients", "3"]].concat()).json();
    let verdict = coface(&["check", argument(&certificate), argument(&input), "--json"]).json();
    assert_eq!(verdict["proved"][0], "function 0: the values of the vertices are x");
    assert_eq!(verdict["unchecked"].as_array().map(Vec::len), Some(1), "{verdict}");
    coface(&[&words[..], &["--vineyard", "x", argument(&values), "z"]].concat()).json();
    let verdict = coface(&["check", argument(&certificate), argument(&input), "--json"]).json();
    assert_eq!(verdict["unchecked"][0], "functions");
    // Each kind of lie.
    let honest: Value = serde_json::from_slice(&fs::read(&certificate).unwrap()).unwrap();
    let bytes = fs::read(&input).unwrap();
    let refused = |change: &dyn Fn(&mut Value), part: &str| {
        let mut lie = honest.clone();
        change(&mut lie);
        let fault = coface_check_binary::check(lie.to_string().as_bytes(), &[&bytes]).expect_err("a lie");
        assert!(fault.to_string().contains(part), "{fault}");
    };
    let at = "the points of the vines at function";
    refused(&|lie| drop(lie["answer"]["vines"].as_array_mut().unwrap().pop()), at);
    refused(&|lie| lie["answer"]["vines"][0]["degree"] = json!(1), at);
    refused(&|lie| lie["answer"]["vines"][0]["points"][0][1] = json!(-99.0), at);
    refused(&|lie| lie["answer"]["functions"][0] = json!("y"), "are not y");
    refused(
        &|lie| drop(lie["answer"]["functions"].as_array_mut().unwrap().pop()),
        "a proof for each function",
    );
    refused(&|lie| drop(lie["proof"].as_array_mut().unwrap().pop()), "a proof for each function");
    refused(&|lie| lie["proof"][1]["values"][0][2] = json!(-4.0), "");
    refused(&|lie| drop(lie["proof"][2]["chains"][0].as_array_mut().unwrap().pop()), "chains");
    refused(&|lie| lie["answer"]["vines"][0]["points"] = json!([]), "a vine has no point");
    refused(&|lie| lie["answer"]["vines"][0]["points"].as_array_mut().unwrap().reverse(), "do not rise");
    refused(&|lie| lie["answer"]["vines"][0]["color"] = json!(1), "color");
    let named = |lie: &mut Value| lie["answer"]["vines"][0]["points"][0][0] = json!(7.0);
    refused(&named, "at no function");
}

#[test]
fn diagrams_are_proved_and_lies_about_them_are_not() {
    let folder = tempfile::tempdir().unwrap();
    let (input, certificate) = (folder.path().join("torus.off"), folder.path().join("torus.cert"));
    fs::write(&input, TORUS).unwrap();
    let words = ["persistence", argument(&input), "--certificate", argument(&certificate), "--json"];
    for (options, of_values) in [
        (&[][..], "the values of the vertices are z"),
        (&["--function", "x", "--upper-star", "--coefficients", "3"][..], "the values of the vertices are x"),
        (&["--min-persistence", "-1", "--cycles"][..], "the values of the vertices are z"),
    ] {
        let answer = coface(&[&words[..], options].concat()).json();
        assert_eq!(answer["betti"], json!([1, 2, 1]));
        let verdict = checked(&certificate, &input);
        assert_eq!((&verdict["proved"][0], &verdict["unchecked"]), (&json!(of_values), &json!([])));
        let count = answer["diagram"].as_array().unwrap().iter().filter(|pair| pair["degree"] == 1).count();
        let line = verdict["proved"][3].as_str().unwrap();
        assert!(line.starts_with(&format!("degree 1: the {count} pairs")), "{line}");
    }
    lie_about(&certificate, &[&input]);
    // A height that the file does not have.
    let text = fs::read_to_string(&certificate).unwrap();
    let mut lie: Value = serde_json::from_str(&text).unwrap();
    lie["proof"]["values"][0][4] = json!(1.5);
    fs::write(&certificate, lie.to_string()).unwrap();
    let refused = coface(&["check", argument(&certificate), argument(&input)]);
    assert_eq!(refused.status, 1);
    assert!(refused.stderr.contains("the values of the vertices are not z"), "{}", refused.stderr);
}

/// Points on a ring, with one in its middle and one twice.
const RING: &str = "10 0\n7 7\n0 10\n-7 7\n-10 0\n-7 -7\n0 -10\n7 -7\n0 0\n0 0\n";

#[test]
fn diagrams_of_points_are_proved_and_lies_about_them_are_not() {
    let folder = tempfile::tempdir().unwrap();
    let (input, certificate) = (folder.path().join("ring.csv"), folder.path().join("ring.cert"));
    fs::write(&input, RING).unwrap();
    let words = ["persistence", argument(&input), "--certificate", argument(&certificate), "--json"];
    for (options, expected, unchecked) in [
        (&["--rips"][..], "the rows of the file are 10 points with 2 coordinates", json!([])),
        (
            &["--rips", "--dimension", "2", "--coefficients", "3", "--threshold", "15"],
            "the rows of the file",
            json!([]),
        ),
        (
            &["--alpha"],
            "the simplices are a Delaunay triangulation of 10 points with 2 coordinates",
            json!([]),
        ),
        (
            &["--alpha", "20"],
            "the filtration has the simplices that the certificate lists",
            json!(["function", LISTED]),
        ),
        (
            &["--cech"],
            "the filtration has the simplices that the certificate lists",
            json!(["function", LISTED]),
        ),
        (
            &["--landmarks", "5"],
            "the filtration has the simplices that the certificate lists",
            json!(["function", LISTED]),
        ),
        (
            &["--mapper", "3"],
            "the filtration has the simplices that the certificate lists",
            json!(["function", LISTED]),
        ),
    ] {
        let answer = coface(&[&words[..], options].concat()).json();
        let verdict = checked(&certificate, &input);
        assert!(verdict["proved"][0].as_str().unwrap().starts_with(expected), "{options:?} {verdict}");
        assert_eq!(verdict["unchecked"], unchecked, "{options:?}");
        let certified: Value = serde_json::from_slice(&fs::read(&certificate).unwrap()).unwrap();
        assert_eq!(certified["answer"]["diagram"], answer["diagram"], "{options:?}");
        if options[0] == "--rips" || options == ["--alpha"] {
            lie_about(&certificate, &[&input]);
        }
    }
    // A graph, whose simplices are listed.
    let graph = folder.path().join("graph.txt");
    fs::write(&graph, "2 3\n3 5\n5 9\n9 2\n2 5 4\n").unwrap();
    coface(&["persistence", argument(&graph), "--flag", "--certificate", argument(&certificate), "--json"])
        .json();
    assert_eq!(checked(&certificate, &graph)["unchecked"], json!(["function", "threshold", LISTED]));
    // The checker reads no series of delays.
    fs::remove_file(&certificate).unwrap();
    let run = coface(&[&words[..4], &["--rips", "--delay", "1"]].concat());
    assert!(run.fails_with(1).contains("give points or distances as rows of numbers"), "{}", run.stderr);
    assert!(!certificate.exists());
}

#[test]
fn diagrams_of_images_are_proved_and_lies_about_them_are_not() {
    let folder = tempfile::tempdir().unwrap();
    let (image, certificate) = (folder.path().join("image.pgm"), folder.path().join("image.cert"));
    // A dark ring around a bright pixel, and another dark one.
    fs::write(&image, "P2\n6 4\n# grey\n9\n1 2 1 9 9 9\n2 8 2 9 3 9\n1 1 2 9 9 9\n9 9 9 9 9 9\n").unwrap();
    for (options, line, ring) in [
        (
            &[][..],
            "the image has 4 x 6 voxels, which are cubes, and sublevel sets of their values grow",
            json!([1, 2.0, 8.0]),
        ),
        (
            &["--construction", "v", "--coefficients", "3"],
            "the image has 4 x 6 voxels, which are vertices",
            json!([1, 2.0, 8.0]),
        ),
        (
            &["--superlevel"],
            "the image has 4 x 6 voxels, which are cubes, and superlevel sets",
            json!([0, 8.0, 2.0]),
        ),
    ] {
        let words = ["persistence", argument(&image), "--certificate", argument(&certificate), "--json"];
        let answer = coface(&[&words[..], options].concat()).json();
        let has = |pair: &Value| json!([pair["degree"], pair["birth"], pair["death"]]) == ring;
        assert!(answer["diagram"].as_array().unwrap().iter().any(has), "{answer}");
        let verdict = checked(&certificate, &image);
        assert!(verdict["proved"][0].as_str().unwrap().starts_with(line), "{verdict}");
        assert_eq!(verdict["unchecked"], json!([]));
        lie_about(&certificate, &[&image]);
    }
    fs::remove_file(&certificate).unwrap();
    for option in [&["--periodic", "0"][..], &["--mask", argument(&image)]] {
        let run = coface(
            &[&["persistence", argument(&image), "--certificate", argument(&certificate)], option].concat(),
        );
        assert!(run.fails_with(1).contains("no masks and no periodic axes"), "{}", run.stderr);
        assert!(!certificate.exists());
    }
}

/// The checker reads the triangle of the file, and not what its corners make, though both are a disk here.
#[test]
fn complexes_of_points_have_no_certificates_of_their_files() {
    let folder = tempfile::tempdir().unwrap();
    let (input, certificate) = (folder.path().join("disk.off"), folder.path().join("disk.cert"));
    fs::write(&input, "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").unwrap();
    for verb in [&["homology"][..], &["info"], &["persistence", "--function", "x"]] {
        for option in ["--rips", "--alpha", "--cech"] {
            let words = [verb, &[argument(&input), option, "--certificate", argument(&certificate)]].concat();
            let said = coface(&words).fails_with(1).to_owned();
            assert!(said.contains(&format!("with a certificate takes no {option}")), "{said}");
            assert!(!certificate.exists());
        }
    }
}

/// Certificates and inputs come from standard input too, and a certificate never replaces its input.
#[test]
fn certificates_stand_beside_their_inputs() {
    let folder = tempfile::tempdir().unwrap();
    let (input, certificate) = (folder.path().join("disk.off"), folder.path().join("disk.json"));
    let text = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    fs::write(&input, text).unwrap();
    for verb in ["homology", "info", "pi1", "cut"] {
        let run = coface(&[verb, argument(&input), "--certificate", argument(&input)]);
        assert!(run.fails_with(1).contains("is an input, and would be replaced"), "{verb}: {}", run.stderr);
        let both = ["-o", argument(&certificate), "--certificate", argument(&certificate)];
        let run = coface(&[&[verb, argument(&input)], &both[..]].concat());
        assert!(run.fails_with(1).contains("-o writes the same file"), "{verb}: {}", run.stderr);
        assert_eq!((fs::read_to_string(&input).unwrap(), certificate.exists()), (text.to_owned(), false));
    }
    let run = coface(&["homology", argument(&input), "--generators", argument(&input)]);
    run.fails_with(1);
    assert_eq!(
        coface(&["homology", argument(&input), "--certificate", argument(&certificate), "-q"]).status,
        0
    );
    let bytes = fs::read(&certificate).unwrap();
    let marked = [b"\xef\xbb\xbf", &bytes[..]].concat();
    for given in [&bytes, &marked] {
        let run = coface_reading(&["check", "-", argument(&input)], given);
        assert!(run.stdout.starts_with("verified"), "{}", run.stderr);
    }
    let run = coface_reading(&["check", argument(&certificate), "-"], text.as_bytes());
    assert!(run.stdout.starts_with("verified: -"), "{}{}", run.stdout, run.stderr);
    coface_reading(&["check", "-", "-"], &bytes).fails_with(1);
}

#[test]
fn the_binary_form_says_the_same() {
    let folder = tempfile::tempdir().unwrap();
    let input = folder.path().join("torus.off");
    fs::write(&input, TORUS).unwrap();
    let [text, binary] = ["proof.cert", "proof.bin"].map(|name| folder.path().join(name));
    for verb in [
        &["homology"][..],
        &["info"],
        &["persistence"],
        &["cut"],
        &["cover", "--radius", "1"],
        &["cocycles"],
        &["pi1"],
        &["homotopic", "0 3 6 0", "0 1 2 0"],
    ] {
        for place in [&text, &binary] {
            let line =
                [&verb[..1], &[argument(&input)], &verb[1..], &["--certificate", argument(place), "--json"]];
            coface(&line.concat()).json();
        }
        assert_eq!(checked(&text, &input)["proved"], checked(&binary, &input)["proved"], "{verb:?}");
        // The certificate names its input.
        assert_eq!(coface(&["check", argument(&binary)]).status, 0);
        let bytes = fs::read(&binary).unwrap();
        assert!(bytes.len() < fs::metadata(&text).unwrap().len() as usize, "{verb:?}");
        // A byte that is changed is refused, or leaves what is proved; but another bound between pairs is another true claim.
        if verb[0] == "persistence" {
            continue;
        }
        let read = fs::read(&input).unwrap();
        let truth = coface_check_binary::check(&bytes, &[&read]).unwrap();
        for at in 0..bytes.len() {
            let mut lie = bytes.clone();
            lie[at] ^= 1 << (at % 8);
            if let Ok(found) = coface_check_binary::check(&lie, &[&read]) {
                assert!(found.proved().iter().all(|line| truth.proved().contains(line)), "{verb:?} {at}");
            }
        }
    }
    fs::write(&binary, &fs::read(&binary).unwrap()[..40]).unwrap();
    let run = coface(&["check", argument(&binary), argument(&input)]);
    assert!(run.fails_with(1).contains("the binary form"), "{}", run.stderr);
}

/// Two boxes with a common side and a ball through both: the volume of any formula is proved, and changes of the certificate are seen.
#[test]
fn booleans_of_solids_are_proved() {
    let folder = tempfile::tempdir().unwrap();
    let boxed = |name: &str, x: i32| {
        let path = folder.path().join(name);
        let corner = |i: i32| format!("v {} {} {}\n", x + (i & 1), i >> 1 & 1, i >> 2);
        let faces = "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
        fs::write(&path, (0..8).map(corner).collect::<String>() + faces).unwrap();
        path
    };
    let (left, right) = (boxed("left.obj", 0), boxed("right.obj", 1));
    let ball = folder.path().join("ball.off");
    let points = [[3, 1, 1], [-1, 1, 1], [1, 3, 1], [1, -1, 1], [1, 1, 3], [1, 1, -1]];
    let lines: String = points.iter().map(|[x, y, z]| format!("{x} {y} {z}\n")).collect();
    let sides = "3 0 2 4\n3 2 1 4\n3 1 3 4\n3 3 0 4\n3 2 0 5\n3 1 2 5\n3 3 1 5\n3 0 3 5\n";
    fs::write(&ball, format!("OFF\n6 8 0\n{lines}{sides}")).unwrap();
    let [a, b, c] = [&left, &right, &ball].map(|path| argument(path));
    let place = folder.path().join("part.cert");
    for (formula, proved) in [
        ("a | b", "measure = 2, the volume, to one part in 10^12"),
        ("a & b", "measure = 0, the volume, to one part in 10^12"),
        ("(a | b) & c", "(0 | 1) & 2"),
        ("c - a - b", "((2 - 0) - 1)"),
        ("!a", "unbounded = true"),
    ] {
        coface(&["boolean", "--formula", formula, a, b, c, "--certificate", argument(&place), "--json"])
            .json();
        let verdict = coface(&["check", argument(&place), a, b, c, "--json"]).json();
        let lines = verdict["proved"].as_array().unwrap();
        assert!(lines.iter().any(|line| line.as_str().unwrap().contains(proved)), "{formula}: {lines:?}");
    }
    coface(&["boolean", "--formula", "c - a - b", a, b, c, "--certificate", argument(&place), "--json"])
        .json();
    lie_about(&place, &[&left, &right, &ball]);
    // Three cells of both boxes and six tips of the ball; what is inside of what, and their volumes.
    let answer = coface(&["arrange", a, b, c, "--certificate", argument(&place), "--json"]).json();
    let verdict = coface(&["check", argument(&place), a, b, c, "--json"]).json();
    let lines: Vec<&str> =
        verdict["proved"].as_array().unwrap().iter().map(|line| line.as_str().unwrap()).collect();
    let count = answer["measures"].as_array().unwrap().len();
    assert!(lines.contains(&&format!("{count} bounded cells")[..]), "{lines:?}");
    assert!(lines.iter().any(|line| line.starts_with("inside = ")), "{lines:?}");
    lie_about(&place, &[&left, &right, &ball]);
    let run =
        coface(&["boolean", "union", a, b, "--method", "congruence", "--certificate", argument(&place)]);
    assert!(run.fails_with(1).contains("--certificate"), "{}", run.stderr);
}

/// Two strips of triangles, whose sides are 0.001 apart and whose short edges are shorter than that in one of them.
#[test]
fn congruences_are_proved_and_lies_about_them_are_not() {
    let folder = tempfile::tempdir().unwrap();
    let [left, right, certificate] =
        ["left.off", "right.obj", "merged.cert"].map(|name| folder.path().join(name));
    fs::write(&left, "OFF\n5 3 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n1.0005 0.0002 0\n3 0 1 2\n3 0 2 3\n3 1 4 2\n")
        .unwrap();
    fs::write(
        &right,
        "v 1 0 0.001\nv 2 0 0\nv 2 1 0\nv 1 1.001 0\nv 3 0 0\nv 3 0.0005 0\nf 1 2 3 4\nf 2 5 6 3\nl 5 1\n",
    )
    .unwrap();
    let words = [
        "congruence",
        argument(&left),
        argument(&right),
        "--tolerance",
        "0.01",
        "--certificate",
        argument(&certificate),
        "--json",
    ];
    let inputs = [&left, &right].map(|input| input.as_path());
    let verdict = |certificate: &Path| {
        coface(&["check", argument(certificate), argument(&left), argument(&right), "--json"]).json()
    };
    for (options, classes) in [
        (
            &[][..],
            "11 vertices are 7 classes: joined by steps of at most 0.01, and no two of different classes that near",
        ),
        (
            &["--greedy", "--collisions", "keep"],
            "11 vertices are 7 classes: in order, each with those that have none before within 0.01",
        ),
        (
            &["--representative", "mean", "--stable"],
            "cells become those of a complex with the f-vector [7, 11, 4] by a chain map onto it",
        ),
    ] {
        let answer = coface(&[&words[..], options].concat()).json();
        assert_eq!(answer["f_vector"][0], 7, "{answer}");
        let verdict = verdict(&certificate);
        assert_eq!(verdict["proved"][0], classes, "{options:?}");
        let unchecked: Vec<&str> =
            verdict["unchecked"].as_array().unwrap().iter().filter_map(Value::as_str).collect();
        let is_stable = options.contains(&"--stable");
        assert_eq!(unchecked.contains(&"tolerance"), is_stable, "{unchecked:?}");
        assert!(unchecked.iter().all(|key| {
            ["changed", "largest_class_diameter", "merged_within_blocks", "tolerance"].contains(key)
        }));
        lie_about(&certificate, &inputs);
    }
    // Vertices that are near, in two classes, with everything else as it has to be then.
    let apart = coface(&[
        "congruence",
        argument(&left),
        argument(&right),
        "--tolerance",
        "0",
        "--certificate",
        argument(&certificate),
    ]);
    assert_eq!(apart.status, 0, "{}", apart.stderr);
    let mut lie: Value = serde_json::from_slice(&fs::read(&certificate).unwrap()).unwrap();
    lie["answer"]["tolerance"] = json!(0.01);
    fs::write(&certificate, lie.to_string()).unwrap();
    let refused = coface(&["check", argument(&certificate), argument(&left), argument(&right)]);
    assert_eq!(refused.status, 1);
    assert!(refused.stderr.contains("are near, and in different classes"), "{}", refused.stderr);
    // A file that the checker does not read: nothing is written then.
    let stl = folder.path().join("left.stl");
    assert_eq!(coface(&["convert", argument(&left), "-o", argument(&stl)]).status, 0);
    let refused = coface(&[
        "congruence",
        argument(&stl),
        "--tolerance",
        "0.1",
        "--certificate",
        argument(&certificate),
        "-o",
        argument(&folder.path().join("merged.off")),
    ]);
    assert!(!folder.path().join("merged.off").exists());
    assert_eq!(refused.status, 1);
    assert!(refused.stderr.contains("leave --certificate out, or give a facet list"), "{}", refused.stderr);
}
