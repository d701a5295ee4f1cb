//! The census of 3-manifolds through the program: what it says about gluing tables, against what Regina found, and
//! isomorphism signatures there and back.
//!
//! The folder named by the environment variable `COFACE_DATA` holds the tables; without it this test says that it skips.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a skipped test says so")]

use crate::program::{argument, coface, coface_reading};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// The file of the tables and its entries, if it is there.
fn census() -> Option<(PathBuf, Vec<Value>)> {
    let Some(folder) = std::env::var_os("COFACE_DATA").map(PathBuf::from) else {
        println!("COFACE_DATA is not set: the census of 3-manifolds is skipped");
        return None;
    };
    let path = folder.join("complexes/three_manifolds.json");
    let list: Value = serde_json::from_str(&std::fs::read_to_string(&path).unwrap()).unwrap();
    Some((path, list.as_array().unwrap().clone()))
}

fn even(orders: &Value) -> u64 {
    orders.as_array().unwrap().iter().filter(|order| order.as_u64().unwrap() % 2 == 0).count() as u64
}

#[test]
fn every_table_has_the_answers_of_the_census() {
    let Some((path, entries)) = census() else { return };
    assert_eq!(entries.len(), 53);
    for entry in &entries {
        let name = entry["name"].as_str().unwrap();
        let place = format!("{}#{name}", argument(&path));
        let report = coface(&["info", "--json", &place]).json();
        assert_eq!(report["kind"], "complex", "{name}");
        assert_eq!(report["f_vector"], entry["f_vector"], "{name}");
        assert_eq!(report["orientable"], entry["orientable"], "{name}");
        assert_eq!(report["manifold"], json!({"verdict": "yes", "closed": true, "witness": null}), "{name}");
        assert_eq!(report["components"], 1, "{name}");
        let groups = coface(&["homology", "--json", &place]).json()["homology"].clone();
        assert_eq!(report["homology"], groups, "{name}");
        let h1 = json!({"rank": groups[1]["betti"], "torsion": groups[1]["torsion"]});
        assert_eq!(h1, entry["H1"], "{name}");
        // Universal coefficients over F_2, and the program itself over F_2.
        let betti2 =
            groups[2]["betti"].as_u64().unwrap() + even(&groups[2]["torsion"]) + even(&groups[1]["torsion"]);
        assert_eq!(Value::from(betti2), entry["betti2_F2"], "{name}");
        let over_f2 = coface(&["homology", "--json", "--coefficients", "f2", &place]).json();
        assert_eq!(over_f2["homology"][2]["betti"], entry["betti2_F2"], "{name}");
    }
}

#[test]
fn every_table_has_the_signature_of_the_census() {
    let Some((path, entries)) = census() else { return };
    for entry in &entries {
        let name = entry["name"].as_str().unwrap();
        let run = coface(&["convert", "--to", "isosig", &format!("{}#{name}", argument(&path))]);
        assert_eq!(run.status, 0, "{name}: {}", run.stderr);
        assert_eq!(run.stdout.trim_end(), entry["isosig"].as_str().unwrap(), "{name}");
        let table = coface_reading(&["convert", "--to", "json", "-"], run.stdout.as_bytes());
        assert_eq!(table.status, 0, "{name}: {}", table.stderr);
        let again = coface_reading(&["convert", "--to", "isosig", "-"], table.stdout.as_bytes());
        assert_eq!(again.stdout, run.stdout, "{name}");
        let report = coface_reading(&["info", "--json", "-"], run.stdout.as_bytes()).json();
        assert_eq!(report["format"], "isosig");
        assert_eq!(report["f_vector"], entry["f_vector"], "{name}");
    }
}

#[test]
fn signatures_are_chosen_by_their_place() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("list.isosig");
    std::fs::write(&path, "# two\ncMcabbgqw\ncPcbbbiht\n").unwrap();
    assert_eq!(coface(&["info", "--json", argument(&path)]).json()["manifold"]["verdict"], "yes");
    let message = coface(&["info", "--strict", argument(&path)]).fails_with(1).to_owned();
    assert!(message.contains("2 signatures") && message.contains("FILE#2"), "{message}");
    let second = format!("{}#2", argument(&path));
    let report = coface(&["info", "--json", "--pseudomanifold", &second]).json();
    assert_eq!(report["manifold"]["witness"]["kind"], "link_not_a_sphere");
    assert_eq!(report["manifold"]["witness"]["cells"], json!([[0]]));
    assert!(
        coface(&["info", &format!("{}#3", argument(&path))])
            .fails_with(1)
            .contains("there is no signature 3")
    );
    std::fs::write(&path, "cMcabb?qw\n").unwrap();
    let message = coface(&["info", argument(&path)]).fails_with(1).to_owned();
    assert!(message.contains(":1:") && message.contains("character 7"), "{message}");
}

#[test]
fn tables_become_no_meshes() {
    let table = br#"{"gluings":[[null,null,[0,[1,2,0]]],"#;
    let fault = coface_reading(&["info", "-"], table);
    fault.fails_with(1);
    // A Moebius band of one triangle.
    let table = br#"{"name": "band", "gluings": [[[0,[2,0,1]], null, [0,[1,2,0]]]], "more": 1}"#;
    let report = coface_reading(&["info", "--json", "-"], table).json();
    assert_eq!(report["name"], "Moebius band");
    assert_eq!((&report["boundary_loops"], &report["orientable"]), (&json!(1), &json!(false)));
    let output = coface_reading(&["convert", "--to", "off", "-"], table);
    assert!(output.fails_with(1).contains("error"));
    let output = coface_reading(&["convert", "--to", "isosig", "-"], table);
    assert!(output.fails_with(1).contains("dimension 2"));
    let output = coface_reading(&["link", "--simplices", "0", "-"], table);
    output.fails_with(1);
    let generators = coface_reading(&["homology", "--json", "-", "--generators"], table).json();
    assert_eq!(generators["generators"][1][0]["order"], 0);
}

/// A table becomes a facet list with the same homology, and each new vertex says which cell of the table it lies in.
#[test]
fn tables_become_simplicial_complexes() {
    let folder = tempfile::tempdir().unwrap();
    let [table, facets, labels] =
        ["lens.isosig", "facets.json", "labels.json"].map(|name| folder.path().join(name));
    std::fs::write(&table, "cMcabbjxr\n").unwrap();
    let run = coface(&[
        "convert",
        argument(&table),
        "--triangulate",
        "-o",
        argument(&facets),
        "--labels",
        argument(&labels),
    ]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    let report = coface(&["info", argument(&facets), "--json"]).json();
    assert_eq!((&report["manifold"]["verdict"], &report["orientable"]), (&json!("yes"), &json!(true)));
    assert_eq!(report["homology"][1]["torsion"], json!([5]));
    let labels: Value = serde_json::from_str(&std::fs::read_to_string(&labels).unwrap()).unwrap();
    let carriers = labels["carriers"].as_array().unwrap();
    assert_eq!(carriers.len() as u64, report["f_vector"][0].as_u64().unwrap());
    assert_eq!(carriers.iter().filter(|carrier| carrier[0] == 0).count(), 1);
    let mesh = coface(&["convert", argument(&facets), "--triangulate", "--to", "json"]);
    assert!(mesh.fails_with(1).contains("gluing tables"), "{}", mesh.stderr);
}

/// The complement of the figure-eight knot: what is asked is about the manifold with boundary, unless the point at infinity is kept.
#[test]
fn ideal_vertices_are_cut_off() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("knot.sig");
    std::fs::write(&path, "cPcbbbiht\n").unwrap();
    let knot = argument(&path);
    let has_remark = |answer: &Value| {
        let remarks = answer["remarks"].as_array().unwrap();
        remarks.iter().any(|said| {
            said["code"] == "ideal-vertices-cut"
                && said["message"].as_str().unwrap().contains("--pseudomanifold")
        })
    };
    let first = |answer: &Value| answer["homology"][1]["betti"].clone();
    for verb in ["info", "homology"] {
        let run = coface(&[verb, knot]);
        assert!((run.stdout.clone() + &run.stderr).contains("--pseudomanifold"), "{verb}: {}", run.stderr);
        let answer = coface(&[verb, "--json", knot]).json();
        assert_eq!((first(&answer), has_remark(&answer)), (json!(1), true), "{verb}");
        let answer = coface(&[verb, "--json", "--pseudomanifold", knot]).json();
        assert_eq!((first(&answer), has_remark(&answer)), (json!(0), false), "{verb}");
        assert_eq!(coface(&[verb, "--json", "--strict", knot]).status, 0, "{verb}");
    }
    let report = coface(&["info", "--json", knot]).json();
    assert_eq!(report["manifold"]["verdict"], "yes");
    assert_eq!(report["manifold"]["closed"], false);
    let group = coface(&["pi1", "--json", "--simplify", knot]).json();
    assert!(has_remark(&group));
    assert_eq!(group["components"][0]["name"], Value::Null, "neither trivial nor Z");
    assert_eq!(group["components"][0]["generators"], 2);
    let group = coface(&["pi1", "--json", "--pseudomanifold", knot]).json();
    assert_eq!((&group["components"][0]["name"], has_remark(&group)), (&json!("trivial"), false));

    let bounded = folder.path().join("bounded.json");
    let run = coface(&["convert", "--truncate", knot, "-o", argument(&bounded)]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    let again = coface(&["info", "--json", argument(&bounded)]).json();
    assert_eq!((&again["f_vector"], first(&again)), (&report["f_vector"], json!(1)));
    assert!(!has_remark(&again));
    let message =
        coface(&["convert", "--truncate", argument(&bounded), "--to", "json"]).fails_with(1).to_owned();
    assert!(message.contains("no vertex is ideal") && message.contains("without --truncate"), "{message}");
}

/// What is cut into parts is what is asked about in one piece, and says so too; a folder of another request is not taken for this one.
#[test]
fn parts_of_ideal_triangulations() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("knot.sig");
    std::fs::write(&path, "cPcbbbiht\n").unwrap();
    let knot = argument(&path);
    let has_remark = |answer: &Value| {
        answer["remarks"].as_array().unwrap().iter().any(|remark| remark["code"] == "ideal-vertices-cut")
    };
    let [cut, points] = ["cut", "points"].map(|name| folder.path().join(name));
    let in_parts = |work: &Path, options: &[&str]| {
        coface(&[&["homology", knot, "--parts", "2", "--work", argument(work), "--json"], options].concat())
    };
    for (options, work, expected) in [(&[][..], &cut, true), (&["--pseudomanifold"][..], &points, false)] {
        let whole = coface(&[&["homology", "--json", knot], options].concat()).json();
        // The second time from what the first has left.
        for _ in 0..2 {
            let run = in_parts(work, options);
            let answer = run.json();
            assert_eq!(answer["homology"], whole["homology"], "{options:?}");
            assert_eq!(has_remark(&answer), expected, "{options:?}");
            assert_eq!(run.stderr.matches("is ideal").count(), usize::from(expected), "{}", run.stderr);
        }
    }
    assert!(in_parts(&cut, &["--pseudomanifold"]).fails_with(1).contains("shards of another complex"));
    let shards = folder.path().join("shards");
    let run = coface(&["shard", knot, "--parts", "2", "-o", argument(&shards)]);
    assert!(run.stderr.contains("vertex 0 is ideal"), "{}", run.stderr);
    assert_eq!(coface(&["reduce", argument(&shards)]).status, 0);
    assert!(has_remark(&coface(&["merge", argument(&shards), "--json"]).json()));
}

/// That edges have no lengths is said beside that vertices are cut.
#[test]
fn loops_of_ideal_triangulations() {
    let answer = coface_reading(&["loops", "--json", "--format", "isosig", "-"], b"cPcbbbiht\n").json();
    let codes: Vec<&str> =
        answer["remarks"].as_array().unwrap().iter().map(|remark| remark["code"].as_str().unwrap()).collect();
    assert_eq!(codes, ["ideal-vertices-cut", "unit-lengths"]);
}

/// Names of 3-manifolds rest on the triangulation, or on one that moves lead to.
#[test]
fn three_manifolds_have_names_where_they_are_proved() {
    let folder = tempfile::tempdir().unwrap();
    let [list, rows, facets] = ["list.sig", "rows.jsonl", "sphere.json"].map(|name| folder.path().join(name));
    std::fs::write(&list, "bkaagb\ncMcabbjqs\neLAkbccddemkij\ncPcbbbiht\n").unwrap();
    let run = coface(&["batch", argument(&list), "-o", argument(&rows), "--with", "pi1,names"]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    let rows = std::fs::read_to_string(&rows).unwrap();
    let names: Vec<Value> =
        rows.lines().map(|row| serde_json::from_str::<Value>(row).unwrap()["space"].clone()).collect();
    assert_eq!(names[0], json!({"name": "S3", "proof": "folded_tetrahedron"}));
    assert_eq!(names[1], json!({"name": "L(8,3)", "proof": "layered_solid_tori"}));
    assert_eq!(names[2], json!({"name": "SFS [S2: (2,1) (2,1) (3,-1)]", "proof": "seifert_fibration"}));
    assert_eq!(names[3], Value::Null);
    let report = coface(&["info", "--json", &format!("{}#2", argument(&list))]).json();
    assert_eq!((&report["name"], &report["name_proof"]), (&json!("L(8,3)"), &json!("layered_solid_tori")));
    std::fs::write(&facets, "[[0,1,2,3],[0,1,2,4],[0,1,3,4],[0,2,3,4],[1,2,3,4]]").unwrap();
    assert_eq!(coface(&["info", "--json", argument(&facets)]).json()["name"], "S3");
    assert!(coface(&["info", argument(&facets)]).stdout.contains(": S3."));
}

/// Signatures of Regina 7.5 stand for the same tables; those of both generations may stand in one list.
#[test]
fn signatures_of_the_second_generation_are_read() {
    let folder = tempfile::tempdir().unwrap();
    let list = folder.path().join("list.sig");
    std::fs::write(&list, "bNjd L(5,2)\ncN6OXa S2 x S1\nbkaajn L(5,2)\n").unwrap();
    let written = |number: u32| {
        let place = format!("{}#{number}", argument(&list));
        coface(&["convert", &place, "--to", "isosig"]).stdout.trim_end().to_owned()
    };
    assert_eq!([1, 2, 3].map(written), ["bkaajn", "cMcabbjaj", "bkaajn"]);
    std::fs::write(&list, "bNjd_\n").unwrap();
    assert!(coface(&["info", argument(&list)]).fails_with(1).contains("'_'"));
}

/// A triangulation is looked up in a list, in which it may stand with other names of its tetrahedra.
#[test]
fn manifolds_are_looked_up_in_a_census() {
    let folder = tempfile::tempdir().unwrap();
    let [census, broken, lens, facets] =
        ["census.sig", "broken.sig", "lens.sig", "facets.json"].map(|name| folder.path().join(name));
    std::fs::write(&census, "# closed\nbkaagj S3\ncMcabbjqs L(8,3) : #1\nbkaajn\n").unwrap();
    std::fs::write(&broken, "bkaagj S3\nnothing\n").unwrap();
    std::fs::write(&lens, "cMcabbjqs\n").unwrap();
    coface(&["convert", argument(&lens), "--triangulate", "-o", argument(&facets)]);
    let looked_up =
        |list: &Path| coface(&["simplify", argument(&facets), "--census", argument(list), "--json"]);
    let answer = looked_up(&census).json();
    assert_eq!(answer["census"]["triangulation_count"], 3);
    assert_eq!(
        answer["census"]["found"],
        json!({"line": 3, "signature": "cMcabbjqs", "name": "L(8,3) : #1"})
    );
    let page = coface(&["simplify", argument(&facets), "--census", argument(&census)]);
    assert!(page.stdout.contains("L(8,3) : #1") && page.stdout.contains("line 3 of"), "{}", page.stdout);
    std::fs::write(&census, "bkaagj S3\n").unwrap();
    assert_eq!(looked_up(&census).json()["census"]["found"], Value::Null);
    assert!(
        coface(&["simplify", argument(&facets), "--census", argument(&census)])
            .stdout
            .contains("none of the 1")
    );
    assert!(looked_up(&broken).fails_with(1).contains("broken.sig:2:"));
    assert!(looked_up(&folder.path().join("missing.sig")).fails_with(1).contains("missing.sig"));
}

/// Moves make a triangulation smaller; the signature of what is left is that of the file that is written.
#[test]
fn manifolds_are_simplified_by_moves() {
    let folder = tempfile::tempdir().unwrap();
    let [lens, facets, small] = ["lens.sig", "facets.json", "small.sig"].map(|name| folder.path().join(name));
    std::fs::write(&lens, "cMcabbjqs\n").unwrap();
    coface(&["convert", argument(&lens), "--triangulate", "-o", argument(&facets)]);
    let answer = coface(&["simplify", argument(&facets), "-o", argument(&small), "--json"]).json();
    let (before, after) = (&answer["f_vector_before"][3], &answer["f_vector"][3]);
    assert!(after.as_u64().unwrap() * 4 < before.as_u64().unwrap(), "{before} {after}");
    assert_eq!(answer["homology"][1]["torsion"], json!([8]));
    assert_eq!(std::fs::read_to_string(&small).unwrap().trim_end(), answer["signature"].as_str().unwrap());
    let page = coface(&["simplify", argument(&facets), "--log"]);
    assert!(page.stdout.contains("at edge") && page.stdout.contains("signature"), "{}", page.stdout);
    // Any triangulation has a signature.
    let signature = coface(&["convert", argument(&facets), "--to", "isosig"]);
    assert_eq!(signature.status, 0, "{}", signature.stderr);
    let same = folder.path().join("same.sig");
    std::fs::write(&same, &signature.stdout).unwrap();
    let answer = coface(&["isomorphic", argument(&facets), argument(&same), "--json"]).json();
    assert_eq!((&answer["isomorphic"], &answer["difference"]), (&json!(true), &Value::Null));
    let answer = coface(&["isomorphic", argument(&lens), argument(&same), "--json"]).json();
    assert!(answer["difference"].as_str().unwrap().ends_with(" simplices"), "{answer}");
    let triangle = folder.path().join("triangle.json");
    std::fs::write(&triangle, "[[0,1,2]]").unwrap();
    assert!(coface(&["simplify", argument(&triangle)]).fails_with(1).contains("dimension 3"));
}
