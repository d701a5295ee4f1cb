//! `coface persistence --extended` as a user runs it.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_in, coface_reading};
use serde_json::{Value, json};

fn pairs(object: &Value) -> Vec<Value> {
    let pair = |pair: &Value| json!([pair["kind"], pair["degree"], pair["birth"], pair["death"]]);
    object["diagram"].as_array().unwrap().iter().map(pair).collect()
}

#[test]
fn a_circle_has_a_valley_a_hill_and_itself() {
    let circle = b"OFF\n4 4 0\n0 0 0\n1 2 0\n2 1 0\n3 3 0\n2 0 1\n2 1 2\n2 2 3\n2 3 0\n";
    let object =
        coface_reading(&["persistence", "-", "--extended", "--function", "y", "--json"], circle).json();
    assert_eq!(
        pairs(&object),
        [
            json!(["ordinary", 0, 1.0, 2.0]),
            json!(["extended+", 0, 0.0, 3.0]),
            json!(["extended-", 1, 3.0, 0.0]),
            json!(["relative", 1, 2.0, 1.0]),
        ]
    );
    assert_eq!((&object["betti"], &object["star"]), (&json!([1, 1]), &json!("extended")));
    let page = coface_reading(&["persistence", "-", "--extended", "--function", "y"], circle).stdout;
    assert!(
        page.contains("function: y, extended") && page.contains("3 to 0  extended-, from [2, 3] to"),
        "{page}"
    );
}

/// Upside down ordinary and relative classes change places: degrees of relative ones are one more.
#[test]
fn a_torus_has_its_classes_both_ways() {
    let folder = tempfile::tempdir().unwrap();
    let make = ["generate", "torus", "-o", "torus.off"];
    assert_eq!(coface_in(folder.path(), &make).status, 0);
    let mesh = std::fs::read_to_string(folder.path().join("torus.off")).unwrap();
    let upside_down: Vec<String> = mesh
        .lines()
        .enumerate()
        .map(|(number, line)| match line.split_whitespace().collect::<Vec<_>>()[..] {
            [x, y, z] if number > 1 => format!("{x} {y} {}", -z.parse::<f64>().unwrap()),
            _ => line.to_owned(),
        })
        .collect();
    std::fs::write(folder.path().join("down.off"), upside_down.join("\n") + "\n").unwrap();
    let ask = |name: &str| {
        coface_in(folder.path(), &["persistence", name, "--extended", "--function", "z", "--json"]).json()
    };
    let (up, down) = (ask("torus.off"), ask("down.off"));
    assert_eq!(up["betti"], json!([1, 2, 1]));
    let of_kind = |object: &Value, kind: &str, sign: f64, shift: u64| {
        let mut found: Vec<String> = object["diagram"]
            .as_array()
            .unwrap()
            .iter()
            .filter(|pair| pair["kind"] == json!(kind))
            .map(|pair| {
                let value = |name: &str| sign * pair[name].as_f64().unwrap() + 0.0;
                format!(
                    "{} {:.9} {:.9}",
                    pair["degree"].as_u64().unwrap() + shift,
                    value("birth"),
                    value("death")
                )
            })
            .collect();
        found.sort();
        found
    };
    assert_eq!(of_kind(&up, "ordinary", 1.0, 1), of_kind(&down, "relative", -1.0, 0));
}

#[test]
fn what_has_no_kinds_is_refused() {
    let path = b"[[0,1],[1,2]]";
    let said =
        coface_reading(&["persistence", "-", "--extended", "-o", "x.pers"], path).fails_with(1).to_owned();
    assert!(said.contains("write extended and zigzag persistence as .json or .csv"), "{said}");
    coface(&["persistence", "a.json", "--extended", "--upper-star"]).fails_with(2);
    let edge = coface_reading(&["persistence", "-", "--extended", "--json"], b"[[3]]").json();
    assert_eq!(pairs(&edge), [json!(["extended+", 0, 3.0, 3.0])]);
}

/// The checker makes the cone over the complex by itself.
#[test]
fn extended_classes_are_proved() {
    use crate::certificates::{BAND, PLANE, lie_about};
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let (input, certificate) = (path("in.json"), path("in.cert"));
    for (text, options) in [
        (PLANE, &["--coefficients", "3"][..]),
        (BAND, &["--min-persistence", "1"]),
        ("[[0,1],[1,2],[2,0],[3]]", &[]),
        ("[[0,1,2],[1,2,3]]", &["--min-persistence", "-1"]),
    ] {
        std::fs::write(&input, text).unwrap();
        let words = [
            "persistence",
            argument(&input),
            "--extended",
            "--certificate",
            argument(&certificate),
            "--json",
        ];
        let answer = coface(&[&words[..], options].concat()).json();
        let verdict = coface(&["check", argument(&certificate), argument(&input), "--json"]).json();
        assert_eq!(verdict["unchecked"], serde_json::json!([]), "{verdict}");
        let proved = verdict["proved"].as_array().unwrap();
        assert_eq!(proved[0], "the values of the vertices are vertex number");
        let extended = answer["diagram"].as_array().unwrap().iter();
        let extended = extended.filter(|pair| pair["kind"].as_str().unwrap().starts_with("extended")).count();
        let betti: u64 = answer["betti"].as_array().unwrap().iter().map(|x| x.as_u64().unwrap()).sum();
        assert_eq!(extended as u64, betti);
        lie_about(&certificate, &[&input]);
    }
    // A surface with positions, by its height.
    let surface = path("torus.off");
    assert_eq!(coface(&["generate", "torus", "-o", argument(&surface)]).status, 0);
    let run = coface(&[
        "persistence",
        argument(&surface),
        "--extended",
        "--function",
        "x",
        "--certificate",
        argument(&certificate),
        "-q",
    ]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    let verdict = coface(&["check", argument(&certificate), argument(&surface), "--json"]).json();
    assert_eq!(verdict["proved"][0], "the values of the vertices are x");
    // What belongs to another file is refused.
    assert_eq!(coface(&["check", argument(&certificate), argument(&input)]).status, 1);
}
