//! `--certificate` and `coface check`: proofs that hold, and lies that do not.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface};
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};

/// The projective plane of 6 vertices: torsion 2 in degree 1.
const PLANE: &str = "[[0,1,2],[0,2,3],[0,3,4],[0,4,5],[0,1,5],[1,2,4],[2,4,5],[2,3,5],[1,3,5],[1,3,4]]";

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
    lie(&|value| value["input"]["sha256"] = json!("0"));
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
