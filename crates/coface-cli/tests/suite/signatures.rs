//! Lists of isomorphism signatures: a row a line, as the lines come.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface};
use serde_json::{Value, json};
use std::fmt::Write;
use std::fs;
use std::path::Path;

/// Signatures before and behind their names, two ideal vertices of knots, and lines that are none.
const LIST: &str = "# a census\ncMcabbjak L(3,1) : #1\n\nL(8,3)\tcMcabbjqs\ncPcbbbiht\nfigure eight cPcbbbiht\n\
                    cMcabb?qw bad\nxyz\n\tcMcabbjxr\n";

fn rows(path: &Path) -> Vec<Value> {
    fs::read_to_string(path).unwrap().lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

#[test]
fn every_line_has_a_row_and_bad_ones_stop_nothing() {
    let folder = tempfile::tempdir().unwrap();
    let (list, out) = (folder.path().join("census.sig"), folder.path().join("rows.jsonl"));
    fs::write(&list, LIST).unwrap();
    let run = coface(&["batch", argument(&list), "-o", argument(&out), "--with", "pi1"]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    assert!(run.stdout.ends_with(": 7 lines, 2 errors (2 parse)\n"), "{}", run.stdout);
    let found = rows(&out);
    let said = |key: &str| found.iter().map(|row| row[key].clone()).collect::<Vec<_>>();
    assert_eq!(said("line"), [2, 4, 5, 6, 7, 8, 9].map(Value::from));
    let names = [json!("L(3,1) : #1"), json!("L(8,3)"), json!(null), json!("figure eight"), json!("bad")];
    assert_eq!(said("name")[..5], names);
    assert_eq!(found[0]["homology"][1], json!({"degree": 1, "betti": 0, "torsion": [3]}));
    assert_eq!(found[1]["groups"][0]["name"], "Z/8");
    assert_eq!(found[3]["homology"][1], json!({"degree": 1, "betti": 1, "torsion": []}));
    assert_eq!((&found[3]["ideal_vertices"], &found[3]["manifold"]), (&json!(1), &json!("yes")));
    let error = &found[4]["error"];
    assert_eq!(error["kind"], "parse");
    assert!(error["message"].as_str().unwrap().contains("census.sig:7: character 7"), "{error}");
    assert_eq!(said("signature")[6], "cMcabbjxr");
    // A row says of a closed manifold what info says.
    let info = coface(&["info", "--json", &format!("{}#L(8,3)", argument(&list))]).json();
    for key in ["f_vector", "components", "euler_characteristic", "orientable", "homology"] {
        assert_eq!(found[1][key], info[key], "{key}");
    }
    let strict = coface(&["batch", argument(&list), "-o", argument(&out), "--strict"]);
    assert_eq!(strict.status, 1);
    assert!(strict.stderr.contains("2 of 7 rows are errors"), "{}", strict.stderr);
    let whole =
        coface(&["batch", argument(&list), "-o", argument(&out), "--pseudomanifold", "--json"]).json();
    assert_eq!(whole["files"], 7);
    assert_eq!(rows(&out)[3]["manifold"], "no");
}

#[test]
fn texts_and_several_lists_are_streams_and_jobs_do_not_matter() {
    let folder = tempfile::tempdir().unwrap();
    let [first, second, one, two] =
        ["census.txt", "more.sig", "1.csv", "2.csv"].map(|name| folder.path().join(name));
    let mut text = String::new();
    for i in 0..700 {
        writeln!(text, "{} number {i}", ["cMcabbjqs", "cMcabbjak", "cPcbbbiht"][i % 3]).unwrap();
    }
    fs::write(&first, &text).unwrap();
    fs::write(&second, LIST).unwrap();
    let lists = [argument(&first), argument(&second)];
    for (out, jobs) in [(&one, "1"), (&two, "3")] {
        let run =
            coface(&["batch", lists[0], lists[1], "-o", argument(out), "--jobs", jobs, "--with", "pi1"]);
        assert!(run.stdout.ends_with(": 707 lines, 2 errors (2 parse)\n"), "{} {}", run.stdout, run.stderr);
    }
    let table = fs::read_to_string(&one).unwrap();
    assert_eq!(table, fs::read_to_string(&two).unwrap());
    assert_eq!(table.lines().count(), 708);
    assert!(
        table.starts_with("path,line,name,signature,error_kind,error_message,error_cure,f_0,"),
        "{table:.80}"
    );
    assert!(table.lines().next().unwrap().ends_with(",orientable,group,group_generators,group_relators"));
}

#[test]
fn tables_are_parquet() {
    let folder = tempfile::tempdir().unwrap();
    let (list, out) = (folder.path().join("census.sig"), folder.path().join("rows.parquet"));
    fs::write(&list, LIST).unwrap();
    coface(&["batch", argument(&list), "-o", argument(&out), "--json"]).json();
    let bytes = fs::read(&out).unwrap();
    assert!(bytes.starts_with(b"PAR1") && bytes.ends_with(b"PAR1"));
    let has = |text: &[u8]| bytes.windows(text.len()).any(|part| part == text);
    assert!(has(b"torsion_1") && has(b"L(3,1) : #1") && !has(b"group_relators"));
}

#[test]
fn lists_that_are_not_there_are_rows() {
    let folder = tempfile::tempdir().unwrap();
    let (list, out) = (folder.path().join("none.sig"), folder.path().join("rows.jsonl"));
    let answer = coface(&["batch", argument(&list), "-o", argument(&out), "--json"]).json();
    assert_eq!((&answer["files"], &answer["errors"]), (&json!(1), &json!({"io": 1})));
    assert_eq!(rows(&out)[0]["line"], json!(null));
    let triangle = folder.path().join("triangle.json");
    fs::write(&triangle, "[[0,1,2]]").unwrap();
    let refused = coface(&["batch", argument(&triangle), "-o", argument(&out), "--with", "pi1"]);
    assert!(refused.fails_with(1).contains("ask coface pi1"), "{}", refused.stderr);
}
