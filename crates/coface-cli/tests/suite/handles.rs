//! `coface cycles --handles`, `--fill-handles` and `--time-limit`.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_in};
use serde_json::{Value, json};
use std::path::Path;

fn made(folder: &Path, line: &str) {
    let run = coface_in(folder, &line.split(' ').collect::<Vec<_>>());
    assert_eq!(run.status, 0, "{line}: {}", run.stderr);
}

#[test]
fn handles_of_a_torus_are_listed_written_and_drawn() {
    let folder = tempfile::tempdir().unwrap();
    let place = |name: &str| folder.path().join(name);
    made(folder.path(), "generate torus -o torus.off");
    let torus = place("torus.off");
    let answer = coface(&["cycles", argument(&torus), "--handles", "--json"]).json();
    assert_eq!((&answer["genus"], &answer["handles"][0]["shorter"]), (&json!(1), &json!("handle")));
    let found = &answer["handles"][0];
    assert_eq!(found["length"], found["handle"]["length"]);
    assert!(found["handle"]["length"].as_f64() < found["tunnel"]["length"].as_f64());
    let text = coface(&["cycles", argument(&torus), "--handles"]).stdout;
    assert!(text.contains("handle loop") && text.contains("tunnel loop"), "{text}");
    // A threshold leaves out what is no noise.
    let none = coface(&["cycles", argument(&torus), "--handles", "--shorter-than", "0.01", "--json"]).json();
    assert_eq!((&none["genus"], &none["handles"]), (&json!(1), &json!([])));
    let loops = place("loops.json");
    made(folder.path(), "cycles torus.off --handles -o loops.json");
    let written: Value = serde_json::from_str(&std::fs::read_to_string(&loops).unwrap()).unwrap();
    assert_eq!(written["kinds"], json!(["handle", "tunnel"]));
    // Other verbs read them, and pictures have them in two colors.
    let compared = coface(&["homotopic", argument(&torus), "--walks", argument(&loops), "--json"]).json();
    assert_eq!(compared["walks"][0]["bounds"], json!(false));
    made(folder.path(), "view torus.off --with loops.json -o page.html");
    let page = std::fs::read_to_string(place("page.html")).unwrap();
    assert!(page.contains("handle loops") && page.contains("tunnel loops"));
    made(folder.path(), "cycles torus.off --handles -o lines.obj");
    assert!(std::fs::read_to_string(place("lines.obj")).unwrap().lines().any(|line| line.starts_with("l ")));
}

#[test]
fn filled_handles_leave_spheres() {
    let folder = tempfile::tempdir().unwrap();
    for (family, genus) in [("torus", 1), ("genus --genus 3 --subdivisions 3", 3), ("csaszar", 1)] {
        made(folder.path(), &format!("generate {family} -o model.off"));
        let model = folder.path().join("model.off");
        let sphere = folder.path().join("sphere.off");
        let run =
            coface(&["cycles", argument(&model), "--fill-handles", "all", "-o", argument(&sphere), "--json"]);
        let answer = run.json();
        assert_eq!(answer["before"]["genus"], json!(genus), "{family}");
        if family == "csaszar" {
            // Seven vertices leave no room: what cannot be filled is listed.
            let done = answer["filled"].as_array().unwrap().len();
            assert!(
                done == 1
                    || !answer["left"].as_array().unwrap().is_empty()
                    || !answer["remarks"].as_array().unwrap().is_empty()
            );
            continue;
        }
        assert_eq!(answer["after"]["genus"], json!(0), "{family}: {answer}");
        assert_eq!(answer["filled"].as_array().unwrap().len(), genus, "{family}");
        let after = &answer["after"];
        assert_eq!(
            (&after["closed"], &after["orientable"], &after["components"]),
            (&json!(true), &json!(true), &json!(1))
        );
        assert_eq!(after["euler_characteristic"], json!(2));
        let info = coface(&["info", argument(&sphere), "--check", "geometry", "--json"]).json();
        assert_eq!((&info["genus"], &info["manifold"]["verdict"]), (&json!(0), &json!("yes")), "{family}");
        for (i, filled) in answer["filled"].as_array().unwrap().iter().enumerate() {
            let edges = filled["vertices"].as_array().unwrap().len() - 1;
            assert_eq!(filled["added_triangles"], json!(2 * (edges - 2)), "{family} {i}");
            assert_eq!(filled["added_vertices"].as_array().unwrap().len(), edges);
        }
    }
    made(folder.path(), "generate torus -o torus.off");
    let torus = folder.path().join("torus.off");
    let answer = coface(&["cycles", argument(&torus), "--fill-handles", "0.01", "--json"]).json();
    assert_eq!((&answer["before"], &answer["filled"]), (&answer["after"], &json!([])));
}

#[test]
fn surfaces_without_an_inside_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("torus.json"), r#"{"next":[1,2,3,0],"twin":[2,3,0,1]}"#).unwrap();
    for (name, says) in [("torus.json", "surfaces of polygons")] {
        for option in [&["--handles"][..], &["--fill-handles", "1"]] {
            let run = coface_in(folder.path(), &[&["cycles", name], option].concat());
            assert!(run.fails_with(1).contains(says), "{}", run.stderr);
        }
    }
    let run = coface(&["cycles", "-", "--handles", "--kind", "non-separating"]);
    assert_eq!(run.status, 2, "{}", run.stderr);
}

#[test]
fn a_search_that_is_stopped_says_what_it_knows() {
    let folder = tempfile::tempdir().unwrap();
    made(folder.path(), "generate torus --columns 40 --rows 30 -o torus.off");
    let torus = folder.path().join("torus.off");
    for kind in ["non-contractible", "non-separating"] {
        let full = coface(&["cycles", argument(&torus), "--kind", kind, "--json"]).json();
        assert_eq!(full["lower_bound"], full["cycles"][0]["length"]);
        assert_eq!(full["remarks"], json!([]));
        let long =
            coface(&["cycles", argument(&torus), "--kind", kind, "--time-limit", "1h", "--json"]).json();
        assert_eq!(long, full);
        let short =
            coface(&["cycles", argument(&torus), "--kind", kind, "--time-limit", "1ms", "--json"]).json();
        let [bound, length] =
            [&short["lower_bound"], &short["cycles"][0]["length"]].map(|x| x.as_f64().unwrap());
        assert!(
            bound <= length
                && bound <= full["lower_bound"].as_f64().unwrap()
                && length >= full["cycles"][0]["length"].as_f64().unwrap()
        );
        if bound < length {
            assert_eq!(short["remarks"][0]["code"], json!("search-ended"));
        }
    }
}
