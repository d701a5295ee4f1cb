//! The truth test: what the program says about real files, against facts that other tools measured.
//!
//! The folder named by the environment variable `COFACE_DATA` holds `MANIFEST.json`, one record a file, and the files.
//! Without the variable only the models shipped in `data/` are looked at, and the other tests say that they skip.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a skipped test says so")]

use crate::program::{argument, coface};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// The data folder and its records, if there is one.
fn manifest() -> Option<(PathBuf, Vec<Value>)> {
    let Some(folder) = std::env::var_os("COFACE_DATA").map(PathBuf::from) else {
        println!("COFACE_DATA is not set: the truth test is skipped");
        return None;
    };
    let text = std::fs::read_to_string(folder.join("MANIFEST.json")).unwrap();
    let manifest: Value = serde_json::from_str(&text).unwrap();
    Some((folder, manifest["files"].as_array().unwrap().clone()))
}

/// The records of one folder of the data.
fn records<'a>(files: &'a [Value], folder: &'a str) -> impl Iterator<Item = (&'a str, &'a Value)> {
    files
        .iter()
        .map(|record| (record["file"].as_str().unwrap(), record))
        .filter(move |(file, _)| file.starts_with(folder))
}

/// Compares answers with facts and gathers what differs, so that one run shows every fault.
#[derive(Default)]
struct Comparison {
    compared: usize,
    faults: Vec<String>,
}

impl Comparison {
    fn equal(&mut self, file: &str, what: &str, answer: &Value, fact: &Value) {
        self.compared += 1;
        if answer != fact {
            self.faults.push(format!("{file}: {what} is {answer}, but the record says {fact}"));
        }
    }

    /// Numbers that were measured with another order of rounding.
    fn close(&mut self, file: &str, what: &str, answer: &Value, fact: &Value) {
        self.compared += 1;
        let (a, b) = (answer.as_f64().unwrap_or(f64::NAN), fact.as_f64().unwrap());
        if (a - b).abs() <= 1e-7 * a.abs().max(b.abs()) {
            return;
        }
        self.faults.push(format!("{file}: {what} is {answer}, but the record says {fact}"));
    }

    /// The report on a file that must be readable.
    fn report(&mut self, path: &str) -> Option<Value> {
        let run = coface(&["info", "--json", path]);
        if run.status != 0 {
            self.faults.push(run.stderr);
            return None;
        }
        Some(run.json())
    }

    #[track_caller]
    fn conclude(self, least: usize) {
        assert!(self.faults.is_empty(), "{} faults:\n{}", self.faults.len(), self.faults.join("\n"));
        assert!(self.compared >= least, "only {} facts were compared", self.compared);
    }
}

fn verdict(manifold: &Value) -> Value {
    json!(if manifold.as_bool().unwrap() { "yes" } else { "no" })
}

fn betti(homology: &Value) -> Value {
    homology.as_array().unwrap().iter().map(|group| group["betti"].clone()).collect()
}

/// Checks Betti numbers and torsion over Z against ranks over Q and over fields with `p` elements: by universal
/// coefficients the rank over a field counts each torsion order that `p` divides in its degree and in the next.
fn check_homology(comparison: &mut Comparison, file: &str, homology: &Value, record: &Value) {
    comparison.equal(file, "the Betti numbers", &betti(homology), &record["betti"]);
    for (key, prime) in [("betti_F2", 2), ("betti_F3", 3)] {
        let divisible = |group: &Value| {
            let orders = group["torsion"].as_array().unwrap();
            orders.iter().filter(|order| order.as_u64().unwrap().is_multiple_of(prime)).count() as u64
        };
        let groups = homology.as_array().unwrap();
        let ranks: Value = (0..groups.len())
            .map(|k| {
                let below = if k > 0 { divisible(&groups[k - 1]) } else { 0 };
                groups[k]["betti"].as_u64().unwrap() + divisible(&groups[k]) + below
            })
            .collect();
        comparison.equal(file, key, &ranks, &record[key]);
    }
    if record["torsion"].as_str().is_some_and(|torsion| torsion.starts_with("none")) {
        let orders: Vec<&Value> = homology
            .as_array()
            .unwrap()
            .iter()
            .flat_map(|group| group["torsion"].as_array().unwrap())
            .collect();
        comparison.equal(file, "the torsion", &json!(orders), &json!([]));
    }
}

/// How many places the report has for a sort of problem.
fn problem_count(report: &Value, kind: &str) -> Value {
    let problems = report["problems"].as_array().unwrap();
    problems
        .iter()
        .find(|problem| problem["kind"] == kind)
        .map_or(json!(0), |problem| problem["count"].clone())
}

#[test]
fn surfaces_are_what_the_records_say() {
    let Some((folder, files)) = manifest() else { return };
    let mut comparison = Comparison::default();
    for (file, record) in records(&files, "surfaces/") {
        let c = &mut comparison;
        let Some(report) = c.report(argument(&folder.join(file))) else { continue };
        c.equal(file, "the kind", &report["kind"], &json!("surface"));
        let counts = json!([record["vertices"], record["edges"], record["faces"]]);
        c.equal(file, "the f-vector", &report["f_vector"], &counts);
        for (key, fact) in [
            ("components", "components"),
            ("euler_characteristic", "euler"),
            ("boundary_loops", "boundary_loops"),
            ("orientable", "orientable"),
            ("coherently_oriented", "coherently_oriented"),
        ] {
            c.equal(file, key, &report[key], &record[fact]);
        }
        let manifold = &report["manifold"];
        c.equal(file, "the manifold verdict", &manifold["verdict"], &verdict(&record["manifold"]));
        c.equal(file, "the witness", &manifold["witness"].is_null().into(), &record["manifold"]);
        c.equal(file, "closed", &manifold["closed"], &json!(record["boundary_loops"] == 0));
        // The record adds genera up over components; the report gives one of a connected surface.
        let connected = record["components"] == 1 && record["manifold"] == true;
        let genus = match (connected, record["orientable"].as_bool()) {
            (true, Some(true)) => record["genus"].clone(),
            (true, Some(false)) => {
                let missing =
                    2 - record["euler"].as_i64().unwrap() - record["boundary_loops"].as_i64().unwrap();
                json!(missing)
            }
            _ => Value::Null,
        };
        c.equal(file, "the genus", &report["genus"], &genus);
        c.equal(file, "whether there is a name", &report["name"].is_string().into(), &record["manifold"]);
        check_homology(c, file, &report["homology"], record);
        if file == "surfaces/tetraplex.off" {
            // The record measured the first three of four coordinates. In four dimensions these are 1200 equilateral
            // triangles whose sides are 2 divided by the golden ratio, but for the rounding of the file.
            let side = 5_f64.sqrt() - 1.0;
            let ratio = report["area"].as_f64().unwrap() / (1200.0 * 3_f64.sqrt() / 4.0 * side * side);
            c.equal(file, "the area", &json!((ratio - 1.0).abs() < 1e-5), &json!(true));
        } else if !record["area"].is_null() {
            c.close(file, "the area", &report["area"], &record["area"]);
        }
        if !record["signed_volume"].is_null() {
            c.close(file, "the signed volume", &report["signed_volume"], &record["signed_volume"]);
        }
        for (kind, fact) in [
            ("nonmanifold_ridge", "nonmanifold_edges"),
            ("duplicate_cell", "duplicate_faces"),
            ("isolated_vertex", "isolated_vertices"),
        ] {
            c.equal(file, kind, &problem_count(&report, kind), &record[fact]);
        }
    }
    comparison.conclude(400);
}

#[test]
fn volumes_are_what_the_records_say() {
    let Some((folder, files)) = manifest() else { return };
    let mut comparison = Comparison::default();
    for (file, record) in records(&files, "volumes/") {
        let c = &mut comparison;
        let Some(report) = c.report(argument(&folder.join(file))) else { continue };
        c.equal(file, "the kind", &report["kind"], &json!("volume"));
        let counts = json!([record["vertices"], record["edges"], record["faces"], record["cells"]]);
        c.equal(file, "the f-vector", &report["f_vector"], &counts);
        c.equal(file, "the components", &report["components"], &record["components"]);
        c.equal(file, "the Euler characteristic", &report["euler_characteristic"], &record["euler"]);
        c.equal(file, "the manifold verdict", &report["manifold"]["verdict"], &verdict(&record["manifold"]));
        c.equal(file, "closed", &report["manifold"]["closed"], &json!(record["boundary_faces"] == 0));
        if !record["orientable"].is_null() {
            c.equal(file, "orientable", &report["orientable"], &record["orientable"]);
        }
        let skin = &report["boundary_surface"];
        for (key, fact) in [
            ("faces", "boundary_faces"),
            ("components", "boundary_surfaces"),
            ("euler_characteristic", "boundary_euler"),
            ("manifold", "boundary_is_manifold"),
        ] {
            c.equal(file, &format!("{key} of the boundary"), &skin[key], &record[fact]);
        }
        for key in ["boundary_loops", "genus", "name"] {
            c.equal(file, key, &report[key], &Value::Null);
        }
        check_homology(c, file, &report["homology"], record);
        if record["cells"] == record["tets"] && record["tets_negative"] == 0 {
            c.close(file, "the signed volume", &report["signed_volume"], &record["tet_volume"]);
        }
        c.equal(file, "isolated", &problem_count(&report, "isolated_vertex"), &record["isolated_vertices"]);
        c.equal(file, "duplicates", &problem_count(&report, "duplicate_cell"), &record["duplicate_cells"]);
    }
    comparison.conclude(60);
}

#[test]
fn facet_lists_are_what_the_records_say() {
    let Some((folder, _)) = manifest() else { return };
    let text = std::fs::read_to_string(folder.join("complexes/facet_lists.json")).unwrap();
    let complexes: Vec<Value> = serde_json::from_str(&text).unwrap();
    let place = tempfile::tempdir().unwrap();
    let mut comparison = Comparison::default();
    for record in &complexes {
        let file = record["name"].as_str().unwrap();
        let path = place.path().join("complex.json");
        std::fs::write(&path, json!({"facets": record["facets"]}).to_string()).unwrap();
        let c = &mut comparison;
        let Some(report) = c.report(argument(&path)) else { continue };
        c.equal(file, "the kind", &report["kind"], &json!("complex"));
        for (key, fact) in [
            ("dimension", "dim"),
            ("f_vector", "f_vector"),
            ("euler_characteristic", "euler"),
            ("pure", "pure"),
            ("orientable", "orientable"),
        ] {
            c.equal(file, key, &report[key], &record[fact]);
        }
        c.equal(file, "closed", &report["manifold"]["closed"], &record["closed"]);
        // The names tell the pseudomanifolds; beyond dimension 3 the verdict may stay open, but not be wrong.
        let verdict = report["manifold"]["verdict"].as_str().unwrap();
        let right = match (file.starts_with("PM"), record["dim"].as_u64().unwrap()) {
            (true, _) => verdict == "no",
            (false, 0..=3) => verdict == "yes",
            (false, _) => verdict != "no",
        };
        c.equal(
            file,
            &format!("whether the manifold verdict {verdict:?} is right"),
            &json!(right),
            &json!(true),
        );
        let expected: Option<Vec<Value>> = record["integral_homology"].as_array().map(|groups| {
            let group =
                |(k, g): (usize, &Value)| json!({"degree": k, "betti": g["rank"], "torsion": g["torsion"]});
            groups.iter().enumerate().map(group).collect()
        });
        match expected {
            Some(groups) => c.equal(file, "the homology", &report["homology"], &json!(groups)),
            None => c.equal(
                file,
                "the Betti numbers",
                &betti(&report["homology"]),
                &record["betti_by_prime"]["101"],
            ),
        }
        for (prime, ranks) in record["betti_by_prime"].as_object().unwrap() {
            let coefficients = format!("f{prime}");
            let run = coface(&["homology", argument(&path), "--json", "--coefficients", &coefficients]);
            c.equal(file, &coefficients, &betti(&run.json()["homology"]), ranks);
        }
        if record["dim"] == 2 && !file.starts_with("PM") {
            let (euler, circles) = (record["euler"].as_i64().unwrap(), i64::from(record["closed"] == false));
            let missing = 2 - euler - circles;
            let genus = if record["orientable"] == true { missing / 2 } else { missing };
            c.equal(file, "the genus", &report["genus"], &json!(genus));
            c.equal(file, "the boundary loops", &report["boundary_loops"], &json!(circles));
        }
    }
    comparison.conclude(200);
}

#[test]
fn tricky_files_are_read_or_refused_as_expected() {
    let Some((folder, files)) = manifest() else { return };
    let mut seen = 0;
    for (file, record) in records(&files, "tricky/") {
        let path = folder.join(file);
        let run = coface(&["info", "--json", argument(&path)]);
        seen += 1;
        match file {
            // The line with two references: refused or reported, with its number, and never a triangle.
            "tricky/notenoughindices.obj" => {
                let told = if run.status == 0 {
                    let report = run.json();
                    assert_eq!(report["f_vector"], json!([3, 3, 1]), "{report}");
                    report["warnings"].to_string()
                } else {
                    run.fails_with(1).to_owned()
                };
                let text = std::fs::read_to_string(&path).unwrap();
                let short = |line: &str| line.starts_with("f ") && line.split_whitespace().count() == 3;
                let line = text.lines().position(short).unwrap() + 1;
                assert!(told.contains(&line.to_string()), "line {line}: {told}");
            }
            "tricky/invalidvertex.stl" => assert!(run.fails_with(1).contains(":89:"), "{}", run.stderr),
            "tricky/unparseable.stl" => {
                assert!(run.fails_with(1).contains("unparseable.stl:"), "{}", run.stderr);
            }
            "tricky/ply_empty_header.ply" => {
                let report = run.json();
                assert_eq!((&report["f_vector"], &report["dimension"]), (&json!([]), &Value::Null));
                assert_eq!(report["components"], 0);
            }
            "tricky/negative_indices.obj" | "tricky/cube1.off" => {
                let report = run.json();
                let counts = json!([record["vertices"], record["edges"], record["faces"]]);
                assert_eq!(report["f_vector"], counts);
                for key in ["components", "boundary_loops", "orientable", "coherently_oriented", "genus"] {
                    assert_eq!(report[key], record[key], "{file}: {key}");
                }
                assert_eq!(report["name"], "sphere");
            }
            _ => panic!("{file} is not in the table: {}", record["expected"]),
        }
    }
    assert_eq!(seen, 6, "every tricky file is in the table");
}

/// Counted by an independent script; Betti numbers by persistent cohomology over three fields.
#[test]
fn shipped_models_have_their_known_facts() {
    let table = [
        ("spot.obj", "obj", json!([2930, 8784, 5856]), json!([1, 0, 1]), "yes", json!("sphere")),
        ("fan3.obj", "obj", json!([5, 7, 3]), json!([1, 0, 0]), "no", Value::Null),
        ("moebius.obj", "obj", json!([280, 504, 224]), json!([1, 1, 0]), "yes", json!("Moebius band")),
        ("platonic_shelf.obj", "obj", json!([50, 90, 50]), json!([5, 0, 5]), "yes", json!("5 spheres")),
        ("fandisk_quads.off", "off", json!([766, 1528, 764]), json!([1, 0, 1]), "yes", json!("sphere")),
        ("box.msh", "msh", json!([358, 1774, 2522, 1105]), json!([1, 0, 0, 0]), "yes", Value::Null),
        ("beam_h5t12.mesh", "mesh", json!([32, 76, 67, 17]), json!([1, 0, 5, 0]), "no", Value::Null),
        ("cylinder.vtk", "vtk", json!([354, 1921, 2916, 1348]), json!([1, 0, 0, 0]), "yes", Value::Null),
    ];
    for (file, format, f_vector, betti, manifold, name) in table {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data").join(file);
        let report = coface(&["info", "--json", argument(&path)]).json();
        assert_eq!(report["format"], format, "{file}");
        assert_eq!(report["f_vector"], f_vector, "{file}");
        assert_eq!(report["manifold"]["verdict"], manifold, "{file}");
        assert_eq!(report["name"], name, "{file}");
        let groups = report["homology"].as_array().unwrap();
        let found: Vec<Value> = groups.iter().map(|group| group["betti"].clone()).collect();
        assert_eq!(Value::from(found), betti, "{file}");
        assert!(groups.iter().all(|group| group["torsion"] == json!([])), "{file}");
    }
}
