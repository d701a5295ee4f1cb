//! `coface homology` with all its options, on small spaces whose answers can be checked by hand, and on real files.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_reading};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// The projective plane with six vertices.
const PLANE: &str =
    r#"{"facets":[[0,1,2],[0,1,5],[0,2,4],[0,3,4],[0,3,5],[1,2,3],[1,3,4],[1,4,5],[2,3,5],[2,4,5]]}"#;
/// The torus with seven vertices.
fn torus() -> String {
    let orbit = |a: u32, b: u32, c: u32| (0..7).map(move |i| [(a + i) % 7, (b + i) % 7, (c + i) % 7]);
    json!({"facets": orbit(0, 1, 3).chain(orbit(0, 2, 3)).collect::<Vec<_>>()}).to_string()
}
/// The boundary of the simplex of dimension 5, a sphere, whose intersection form is empty.
const SPHERE_4: &str =
    r#"{"facets":[[0,1,2,3,4],[0,1,2,3,5],[0,1,2,4,5],[0,1,3,4,5],[0,2,3,4,5],[1,2,3,4,5]]}"#;

fn file(folder: &Path, name: &str, text: &str) -> PathBuf {
    let path = folder.join(name);
    std::fs::write(&path, text).unwrap();
    path
}

fn reading(arguments: &[&str], input: &str) -> Value {
    coface_reading(&[arguments, &["--json", "-"]].concat(), input.as_bytes()).json()
}

/// The boundary of a chain `[[coefficient,[vertices..]],..]` of simplices, by faces in rising order.
fn boundary(chain: &Value) -> std::collections::BTreeMap<Vec<u64>, i64> {
    let mut sum = std::collections::BTreeMap::new();
    for term in chain.as_array().unwrap() {
        let coefficient = term[0].as_i64().unwrap();
        let vertices: Vec<u64> = term[1].as_array().unwrap().iter().map(|v| v.as_u64().unwrap()).collect();
        assert!(vertices.is_sorted());
        for i in 0..vertices.len() {
            let mut face = vertices.clone();
            face.remove(i);
            *sum.entry(face).or_insert(0) += if i % 2 == 0 { coefficient } else { -coefficient };
        }
    }
    sum.retain(|_, x| *x != 0);
    sum
}

#[test]
fn torsion_generators_carry_their_certificate() {
    let answer = reading(&["homology", "--generators"], PLANE);
    let generator = &answer["generators"][1][0];
    assert_eq!((&generator["order"], &generator["length"]), (&json!(2), &json!(3)));
    assert!(boundary(&generator["chain"]).is_empty());
    let twice: std::collections::BTreeMap<Vec<u64>, i64> = generator["chain"]
        .as_array()
        .unwrap()
        .iter()
        .map(|term| {
            let vertices = term[1].as_array().unwrap().iter().map(|v| v.as_u64().unwrap()).collect();
            (vertices, 2 * term[0].as_i64().unwrap())
        })
        .collect();
    assert_eq!(boundary(&generator["bounding"]), twice);
    assert_eq!(answer["generators"][0][0]["order"], 0);
    assert_eq!(answer["generators"][2], json!([]));
    // Over F_2 there is a class in each degree, over F_3 in degree 0 only.
    let two = reading(&["homology", "--generators", "--coefficients", "f2"], PLANE);
    let three = reading(&["homology", "--generators", "--coefficients", "f3"], PLANE);
    let counts = |answer: &Value| -> Vec<usize> {
        answer["generators"].as_array().unwrap().iter().map(|list| list.as_array().unwrap().len()).collect()
    };
    assert_eq!((counts(&two), counts(&three)), (vec![1, 1, 1], vec![1, 0, 0]));
    assert_eq!(two["generators"][2][0]["length"], 10, "all triangles, modulo 2");
    let dual = reading(&["homology", "--generators", "--cohomology"], PLANE);
    assert_eq!((counts(&dual), &dual["generators"][2][0]["order"]), (vec![1, 0, 1], &json!(2)));
}

#[test]
fn classes_of_cycles_are_told_with_proofs() {
    let triangle = "0 1; 1 2; 2 0";
    let around = "0 3; 3 4; 4 0";
    let answer = reading(&["homology", "--cycle", triangle, "--cycle", around], PLANE);
    let [first, second] = [0, 1].map(|i| answer["cycles"][i].clone());
    assert_eq!(
        (&first["bounds"], &first["multiple"], &first["class"]),
        (&json!(true), &json!(1), &json!([0]))
    );
    assert_eq!(boundary(&first["bounding"])[&vec![0, 2]], -1);
    assert_eq!(second["bounds"], true, "0 3 4 is a triangle of the plane");
    let odd = reading(&["homology", "--cycle", "0 1; 1 3; 3 0"], PLANE);
    let odd = &odd["cycles"][0];
    assert_eq!((&odd["bounds"], &odd["multiple"], &odd["class"]), (&json!(false), &json!(2), &json!([1])));
    assert_eq!(boundary(&odd["bounding"])[&vec![0, 1]], 2);
    let torus = torus();
    let never = reading(&["homology", "--cycle", "0 1; 1 2; 2 0"], &torus);
    assert_eq!(never["cycles"][0]["multiple"], Value::Null);
    assert!(never["cycles"][0]["cocycle"].is_array());
    let text = coface_reading(&["homology", "-", "--cycle", "0 1; 1 2; 2 0"], torus.as_bytes()).stdout;
    assert!(text.contains("nor does any multiple"), "{text}");
}

#[test]
fn reduced_homology_of_a_point_and_of_two() {
    let betti = |answer: &Value| -> Vec<Value> {
        answer["homology"].as_array().unwrap().iter().map(|group| group["betti"].clone()).collect()
    };
    assert_eq!(betti(&reading(&["homology", "--reduced"], r#"{"facets":[[5]]}"#)), [json!(0)]);
    let two = reading(&["homology", "--reduced", "--generators"], r#"{"facets":[[5],[8]]}"#);
    assert_eq!(betti(&two), [json!(1)]);
    let chain = two["generators"][0][0]["chain"].as_array().unwrap().clone();
    assert_eq!(chain.iter().map(|term| term[0].as_i64().unwrap()).sum::<i64>(), 0, "{chain:?}");
}

#[test]
fn the_sequence_of_a_disk_and_its_rim() {
    let answer =
        reading(&["homology", "--relative", "boundary", "--sequence"], r#"{"facets":[[0,1,2],[0,2,3]]}"#);
    let sequence = &answer["sequence"];
    assert_eq!(sequence["exact"], true);
    assert_eq!(sequence["connecting"][2][0][0].as_i64().unwrap().abs(), 1);
    assert_eq!(sequence["pair"][2]["betti"], 1);
    assert_eq!(sequence["subcomplex"][1]["betti"], 1);
}

#[test]
fn cup_products_and_forms() {
    let torus = torus();
    let answer = reading(&["homology", "--cup", "1", "1"], &torus);
    let table = &answer["cup"]["table"];
    assert_eq!((&table[0][0], &table[1][1]), (&json!([0]), &json!([0])));
    assert_eq!(table[0][1][0].as_i64().unwrap(), -table[1][0][0].as_i64().unwrap());
    assert_eq!(table[0][1][0].as_i64().unwrap().abs(), 1);
    let square = reading(&["homology", "--cup", "1", "1", "--coefficients", "f2"], PLANE);
    assert_eq!(square["cup"]["table"], json!([[[1]]]));
    let skew = reading(&["homology", "--intersection-form"], &torus);
    assert_eq!(
        (&skew["intersection_form"]["rank"], &skew["intersection_form"]["determinant"]),
        (&json!(2), &json!(1))
    );
    let empty = reading(&["homology", "--intersection-form"], SPHERE_4);
    assert_eq!(
        (&empty["intersection_form"]["rank"], &empty["intersection_form"]["parity"]),
        (&json!(0), &json!("even"))
    );
    let refused = coface_reading(&["homology", "--intersection-form", "-"], PLANE.as_bytes());
    assert!(refused.fails_with(1).contains("orient"), "{}", refused.stderr);
}

#[test]
fn harmonic_cochains_of_a_circle_spread_evenly() {
    let circle = r#"{"facets":[[0,1],[1,2],[2,3],[0,3]]}"#;
    let answer = reading(&["homology", "--harmonic"], circle);
    for term in answer["harmonic"][1][0]["chain"].as_array().unwrap() {
        assert!((term[0].as_f64().unwrap().abs() - 0.25).abs() < 1e-12);
    }
    let folder = tempfile::tempdir().unwrap();
    let cochain = file(folder.path(), "w.json", "[[4.0,[1,0]]]");
    let answer = reading(&["homology", "--decompose", argument(&cochain)], circle);
    let norms = &answer["decomposition"]["norms"];
    assert_eq!(norms["cochain"], 4.0);
    assert!((norms["harmonic"].as_f64().unwrap() - 2.0).abs() < 1e-12, "{norms}");
    assert!((norms["exact"].as_f64().unwrap() - 12f64.sqrt()).abs() < 1e-12, "{norms}");
}

#[test]
fn a_double_cover_of_a_circle_has_degree_two() {
    let folder = tempfile::tempdir().unwrap();
    let hexagon = r#"{"facets":[[0,1],[1,2],[2,3],[3,4],[4,5],[0,5]]}"#;
    let triangle = file(folder.path(), "triangle.json", r#"{"facets":[[0,1],[1,2],[0,2]]}"#);
    let map = file(folder.path(), "map.json", "[[0,0],[1,1],[2,2],[3,0],[4,1],[5,2]]");
    let arguments = ["homology", "--map", argument(&map), "--target", argument(&triangle)];
    let answer = reading(&arguments, hexagon);
    let degree = &answer["map"]["degrees"][1];
    assert_eq!(degree["matrix"][0][0].as_i64().unwrap().abs(), 2);
    assert_eq!(degree["cokernel"], json!({"betti": 0, "torsion": [2]}));
    let torn = file(folder.path(), "torn.json", "[[0,0],[1,1],[2,2],[3,0],[4,1]]");
    let arguments = ["homology", "-", "--map", argument(&torn), "--target", argument(&triangle)];
    let refused = coface_reading(&arguments, hexagon.as_bytes());
    assert!(refused.fails_with(1).contains("vertex 5 has no image"), "{}", refused.stderr);
}

#[test]
fn pictures_of_generators_are_written_whole() {
    let folder = tempfile::tempdir().unwrap();
    let model = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/moebius.obj");
    let [vtk, obj, json] = ["loops.vtk", "loops.obj", "loops.json"].map(|name| folder.path().join(name));
    for out in [&vtk, &obj, &json] {
        let run = coface(&["homology", argument(&model), "--generators", argument(out), "--quiet"]);
        assert_eq!(run.status, 0, "{}", run.stderr);
    }
    let text = std::fs::read_to_string(&vtk).unwrap();
    assert!(text.contains("CELL_DATA 2\nSCALARS group int 1"), "one point and one loop");
    let obj = std::fs::read_to_string(&obj).unwrap();
    let line: Vec<&str> = obj.lines().find(|line| line.starts_with("l ")).unwrap().split(' ').collect();
    assert_eq!(line[1], line[line.len() - 1], "the loop is closed");
    let object: Value = serde_json::from_str(&std::fs::read_to_string(&json).unwrap()).unwrap();
    let length = object["generators"][1][0]["length"].as_u64().unwrap() as usize;
    assert_eq!(line.len(), length + 2);
    // A cycle that the program gave is one that it takes.
    let cycle = folder.path().join("cycle.json");
    std::fs::write(&cycle, object["generators"][1][0].to_string()).unwrap();
    let answer = coface(&["homology", argument(&model), "--cycle", argument(&cycle), "--json"]).json();
    assert_eq!(answer["cycles"][0]["class"], json!([1]));
    let abstract_model = coface_reading(&["homology", "-", "--generators", argument(&vtk)], PLANE.as_bytes());
    assert!(abstract_model.fails_with(1).contains(".json"), "{}", abstract_model.stderr);
}

#[test]
fn faults_are_named() {
    for (arguments, words) in [
        (&["--cycle", "0 1; 1 3"][..], "its boundary has the coefficient -1 on {v0}"),
        (&["--cycle", "0 1; 1 9"], "there is no cell [1, 9]"),
        (&["--cycle", "0 1; banana"], "\"banana\" is no part of a chain"),
        (&["--cycle", "nowhere.json"], "nowhere.json: there is no such file or folder"),
        (&["--cycle", "0 1 2; 0 1"], "of degree 2 and the cell [0, 1] of degree 1"),
    ] {
        let run = coface_reading(&[&["homology", "-"], arguments].concat(), PLANE.as_bytes());
        assert!(run.fails_with(1).contains(words), "{}", run.stderr);
    }
}

/// The cycles of every table and surface of the data are cycles, torsion ones bound as many times as they say; the lengths
/// are those of the chains.
#[test]
fn generators_of_real_files_check_out() {
    let Some(folder) = std::env::var_os("COFACE_DATA").map(PathBuf::from) else {
        eprintln!("skipped: COFACE_DATA names no folder with data");
        return;
    };
    let text = std::fs::read_to_string(folder.join("complexes/facet_lists.json")).unwrap();
    let names: Vec<Value> = serde_json::from_str(&text).unwrap();
    for record in &names {
        let path = format!(
            "{}#{}",
            folder.join("complexes/facet_lists.json").display(),
            record["name"].as_str().unwrap()
        );
        let answer = coface(&["homology", &path, "--json", "--generators"]).json();
        for (degree, list) in answer["generators"].as_array().unwrap().iter().enumerate() {
            let group = &answer["homology"][degree];
            let torsion = group["torsion"].as_array().unwrap();
            let list = list.as_array().unwrap();
            assert_eq!(list.len() as u64, torsion.len() as u64 + group["betti"].as_u64().unwrap(), "{path}");
            for (i, generator) in list.iter().enumerate() {
                if degree > 0 {
                    assert!(boundary(&generator["chain"]).is_empty(), "{path} {degree} {i}");
                }
                let order = torsion.get(i).cloned().unwrap_or(json!(0));
                assert_eq!(generator["order"], order, "{path} {degree} {i}");
                assert_eq!(generator["bounding"].is_array(), order != 0, "{path} {degree} {i}");
            }
        }
    }
    assert!(names.len() >= 15);
}

/// A triangle on a box bounds itself, not all that lies around it.
#[test]
fn what_a_cycle_bounds_is_short() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("box.off");
    let made = ["generate", "box", "--shape", "4,4,4", "--boundary", "-o", argument(&path)];
    assert_eq!(coface(&made).status, 0);
    for cycle in ["0 1; 1 6; 6 0", "0 5; 5 30; 30 0"] {
        let answer = coface(&["homology", argument(&path), "--cycle", cycle, "--json"]).json();
        assert_eq!(answer["cycles"][0]["bounding"].as_array().unwrap().len(), 1, "{answer}");
    }
}
