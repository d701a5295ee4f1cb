//! `coface persistence --vineyard` as a user runs it.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{coface, coface_in};
use serde_json::{Value, json};

/// Degree, birth and death of the classes of a persistence diagram.
fn classes(object: &Value) -> Vec<String> {
    let pairs = object["diagram"].as_array().unwrap().iter();
    let mut found: Vec<String> =
        pairs.map(|pair| format!("{} {} {}", pair["degree"], pair["birth"], pair["death"])).collect();
    found.sort();
    found
}

/// Those of the points of vines at a parameter that are not on the diagonal.
fn at(object: &Value, parameter: f64) -> Vec<String> {
    let mut found = Vec::new();
    for vine in object["vines"].as_array().unwrap() {
        for point in vine["points"].as_array().unwrap() {
            if point[0] == json!(parameter) && point[1] != point[2] {
                found.push(format!("{} {} {}", vine["degree"], point[1], point[2]));
            }
        }
    }
    found.sort();
    found
}

/// From height to breadth and back: the diagrams at the functions are those of the functions.
#[test]
fn vines_of_a_mesh_pass_its_diagrams() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    assert_eq!(
        coface_in(place, &["generate", "torus", "--columns", "24", "--rows", "16", "-o", "torus.off"]).status,
        0
    );
    let count = coface_in(place, &["info", "torus.off", "--json"]).json()["f_vector"][0].as_u64().unwrap();
    let values: String = (0..count).map(|i| format!("{}\n", (i * 37 % 101) as f64 / 10.0)).collect();
    std::fs::write(place.join("f.txt"), values).unwrap();
    for field in ["2", "3"] {
        let functions = ["z", "x", "f.txt", "z"];
        let line =
            [&["persistence", "torus.off", "--json", "--coefficients", field, "--vineyard"], &functions[..]];
        let object = coface_in(place, &line.concat()).json();
        assert_eq!(object["functions"], json!(functions));
        for (number, function) in functions.iter().enumerate() {
            let line =
                ["persistence", "torus.off", "--json", "--coefficients", field, "--function", function];
            let diagram = coface_in(place, &line).json();
            assert_eq!(at(&object, number as f64), classes(&diagram), "{function}");
        }
    }
    let line = ["persistence", "torus.off", "--vineyard", "z", "x", "--min-persistence", "1", "-o", "v.csv"];
    assert_eq!(coface_in(place, &line).status, 0);
    let text = std::fs::read_to_string(place.join("v.csv")).unwrap();
    assert!(text.starts_with("vine,degree,parameter,birth,death\n0,0,0,"), "{text}");
    assert!(text.contains(",inf\n"));
    let line = ["persistence", "torus.off", "--vineyard", "z", "x", "-o", "v.json"];
    assert_eq!(coface_in(place, &line).status, 0);
    let page = coface_in(place, &["persistence", "torus.off", "--vineyard", "z", "x"]).stdout;
    assert!(page.contains("functions: z, x") && page.contains("never) at 0 to"), "{page}");
}

#[test]
fn wrong_functions_are_named() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    std::fs::write(place.join("path.json"), "[[0,1],[1,2]]").unwrap();
    std::fs::write(place.join("short.txt"), "1\n2\n").unwrap();
    std::fs::write(place.join("f.txt"), "1\n5\n2\n").unwrap();
    let said = |words: &[&str]| {
        coface_in(place, &[&["persistence", "path.json", "--vineyard"], words].concat())
            .fails_with(1)
            .to_owned()
    };
    assert!(said(&["f.txt", "short.txt"]).contains("short.txt"));
    assert!(said(&["f.txt", "z"]).contains("no positions"));
    assert!(said(&["f.txt", "-o", "v.vtk"]).contains("vines are written as .json or .csv"));
    coface(&["persistence", "path.json", "--vineyard", "x", "--extended"]).fails_with(2);
    coface(&["persistence", "path.json", "--vineyard"]).fails_with(2);
}
