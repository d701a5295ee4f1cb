//! `coface persistence --zigzag` as a user runs it.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{coface, coface_in, coface_reading};
use serde_json::{Value, json};

fn ask(text: &str, more: &[&str]) -> Value {
    let all = [&["persistence", "-", "--zigzag", "--json"], more].concat();
    coface_reading(&all, text.as_bytes()).json()
}

/// Degree, birth, death and kind.
fn intervals(object: &Value) -> Vec<Value> {
    let pairs = object["diagram"].as_array().unwrap().iter();
    pairs.map(|pair| json!([pair["degree"], pair["birth"], pair["death"], pair["kind"]])).collect()
}

/// A loop that is filled and opened again, then cut.
const LOOP: &str = "# a loop\ni 0\ni 1\ni 2\ni 0 1\ni 1 2\ni 2 0\n\ni 0 1 2\nd 0 1 2\nd 2 1 # cut\n";

#[test]
fn a_loop_is_filled_and_opened() {
    let object = ask(LOOP, &[]);
    assert_eq!(
        intervals(&object),
        [
            json!([0, 1.0, null, "closed-open"]),
            json!([0, 2.0, 4.0, "closed-open"]),
            json!([0, 3.0, 5.0, "closed-open"]),
            json!([1, 6.0, 7.0, "closed-open"]),
            json!([1, 8.0, 9.0, "open-closed"]),
        ]
    );
    assert_eq!((&object["betti"], &object["function"]), (&json!([1, 0, 0]), &json!("zigzag")));
    assert_eq!(
        (&object["diagram"][4]["birth_cell"], &object["diagram"][4]["death_cell"]),
        (&json!([0, 1, 2]), &json!([1, 2]))
    );
    assert_eq!(
        ask(LOOP, &["--coefficients", "5", "--min-persistence", "1.5"])["diagram"].as_array().unwrap().len(),
        3
    );
    let page = coface_reading(&["persistence", "-", "--zigzag"], LOOP.as_bytes()).stdout;
    for line in [
        "(8, 9]  persistence 1.000000, from [0, 1, 2] to [1, 2]",
        "[1, never), from [0]",
        "degree 0: 1 class at the end, 2 pairs",
    ] {
        assert!(page.contains(line), "{page}");
    }
    assert_eq!(ask("", &[])["betti"], json!([]));
}

/// Two edges between the same points, at one time or another: open ends on both sides.
#[test]
fn components_apart_and_together() {
    let text = "i 0 @ 0\ni 1 @ 0\ni 0 1 @ 1\nd 0 1 @ 2.5\ni 0 1 @ 4\n";
    assert_eq!(
        intervals(&ask(text, &[])),
        [
            json!([0, 0.0, null, "closed-open"]),
            json!([0, 0.0, 1.0, "closed-open"]),
            json!([0, 2.5, 4.0, "open-open"]),
        ]
    );
}

/// The example of the guide of Dionysus, with its answer; steps as JSON are those of lines.
#[test]
fn forms_of_json() {
    let text = r#"{"simplices": [[0],[1],[0,1],[2],[0,2],[1,2]], "times": [[0.4,0.6,0.7],[0.1],[0.9],[0.9],[0.9],[0.9]]}"#;
    assert_eq!(
        intervals(&ask(text, &[])),
        [
            json!([0, 0.1, null, "closed-open"]),
            json!([0, 0.4, 0.6, "closed-closed"]),
            json!([0, 0.7, 0.9, "closed-open"]),
            json!([1, 0.9, null, "closed-open"]),
        ]
    );
    let stays = r#"{"simplices":[[0],[1],[0,1]],"times":[[0,null],[1,8],[2,5]]}"#;
    let steps = r#"[["i",[0],0],["i",[1],1],["i",[0,1],2],["d",[1,0],5],["d",[1],8]]"#;
    assert_eq!(ask(stays, &[])["diagram"], ask(steps, &[])["diagram"]);
    let numbered = r#"[["i",[0]],["i",[1]],["i",[0,1]]]"#;
    assert_eq!(ask(numbered, &[])["diagram"], ask("i 0\ni 1\ni 0 1\n", &[])["diagram"]);
}

#[test]
fn wrong_zigzags_are_named_by_their_places() {
    let said = |text: &str| {
        coface_reading(&["persistence", "-", "--zigzag"], text.as_bytes()).fails_with(1).to_owned()
    };
    assert!(said("i 0\n\ni 0 1\n").contains("standard input:3: {0, 1} enters before its face {1}"));
    assert!(said("i 0\ni 0\n").contains("standard input:2: {0} enters and is there"));
    assert!(said("d 4\n").contains("standard input:1: {4} leaves and is not there"));
    assert!(said("i 0\ni 1\ni 0 1\nd 1\n").contains("standard input:4: {1} leaves before its coface {0, 1}"));
    assert!(said("i 0 @ 2\ni 1 @ 1\n").contains("standard input:2: the time falls from 2 to 1"));
    assert!(said("i 0 @ 2\ni 1\n").contains("standard input:2: some steps have times and some have none"));
    assert!(
        said("i 0 @ 2\nd 0 @ 3\ni 0 @ 3\n")
            .contains("standard input:3: the simplex {0} enters at 3, the time at which it leaves")
    );
    assert!(said("i 0 @ soon\n").contains("standard input:1: \"soon\" is no time"));
    assert!(said("x 0\n").contains("a step begins with \"x\""));
    assert!(said("i a\n").contains("\"a\" is no vertex"));
    assert!(said("i\n").contains("a simplex without vertices"));
    assert!(said("i 1 1\n").contains("vertex 1 is repeated"));
    assert!(said("[[\"i\",[0]],[\"i\",[0]]]").contains("step 2: {0} enters and is there"));
    assert!(said("[[\"i\"]]").contains("is no step"));
    assert!(said("{\"simplices\":[[0]]}").contains("no list \"times\""));
    assert!(said("{\"simplices\":[[0]],\"times\":[[3,1]]}").contains("do not rise"));
    assert!(said("{\"simplices\":[[0]],\"times\":[]}").contains("1 simplices and 0 lists of times"));
    assert!(said("[").contains("standard input"));
    coface(&["persistence", "a.txt", "--zigzag", "--extended"]).fails_with(2);
    coface(&["persistence", "a.txt", "--zigzag", "--rips"]).fails_with(2);
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("a.txt"), LOOP).unwrap();
    assert!(
        coface_in(folder.path(), &["persistence", "a.txt", "--zigzag", "-o", "a.pers"])
            .fails_with(1)
            .contains(".json")
    );
    assert_eq!(coface_in(folder.path(), &["persistence", "a.txt", "--zigzag", "-o", "a.json"]).status, 0);
    assert_eq!(coface_in(folder.path(), &["persistence", "a.txt", "--zigzag", "-o", "a.csv"]).status, 0);
    let text = std::fs::read_to_string(folder.path().join("a.csv")).unwrap();
    assert!(
        text.contains("\n1,8,9,open-closed,0 1 2,1 2\n") && text.contains("\n0,1,inf,closed-open,0,\n"),
        "{text}"
    );
    // Diagrams of zigzags are data as others.
    let line = ["diagram", "distance", "a.json", "a.csv", "--json"];
    assert_eq!(coface_in(folder.path(), &line).json()["distance"], json!(0.0));
    let line = ["diagram", "distance", "a.json", "a.json", "--json"];
    assert_eq!(coface_in(folder.path(), &line).status, 0);
    coface_in(folder.path(), &["persistence", "missing.txt", "--zigzag"]).fails_with(1);
}

/// Classes are counted at the very values at which simplices enter and leave: the alternating sum is that of the simplices that are there, and
/// a simplex is there at the time at which it leaves.
#[test]
fn curves_of_zigzags_count_what_is_there() {
    let simplices: [&[u32]; 10] =
        [&[0], &[1], &[2], &[3], &[0, 1], &[0, 2], &[1, 2], &[2, 3], &[1, 3], &[0, 1, 2]];
    let is_face = |face: &[u32], of: &[u32]| face.len() < of.len() && face.iter().all(|v| of.contains(v));
    let folder = tempfile::tempdir().unwrap();
    for seed in 1..6_u64 {
        let mut state = seed.wrapping_mul(0x9e37_79b9_7f4a_7c15);
        let (mut is_there, mut text, mut expected) = ([false; 10], String::new(), Vec::new());
        let alternating = |is_there: &[bool; 10]| -> f64 {
            let sign = |at: usize| if simplices[at].len() % 2 == 1 { 1.0 } else { -1.0 };
            (0..10).filter(|&at| is_there[at]).map(sign).sum()
        };
        while expected.len() < 128 {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            let at = (state >> 33) as usize % 10;
            let enters = !is_there[at];
            let fits = (0..10).all(|other| {
                if enters {
                    is_there[other] || !is_face(simplices[other], simplices[at])
                } else {
                    !is_there[other] || !is_face(simplices[at], simplices[other])
                }
            });
            if !fits {
                continue;
            }
            // Before the step what was there is there still.
            let before = alternating(&is_there);
            is_there[at] = enters;
            let names: Vec<String> = simplices[at].iter().map(u32::to_string).collect();
            text += &format!("{} {}\n", if enters { "i" } else { "d" }, names.join(" "));
            expected.push(if enters { alternating(&is_there) } else { before });
            expected.push(alternating(&is_there));
        }
        std::fs::write(folder.path().join("steps.txt"), &text).unwrap();
        // At 1, 1.5, .. and 65, behind the last step.
        expected.push(alternating(&is_there));
        for file in ["steps.json", "steps.csv"] {
            assert_eq!(
                coface_in(folder.path(), &["persistence", "steps.txt", "--zigzag", "-o", file]).status,
                0
            );
            let line = ["diagram", "euler", file, "--samples", "129", "--range", "1", "65", "--json"];
            let answer = coface_in(folder.path(), &line).json();
            assert_eq!(answer["curves"][0]["numbers"], json!(expected), "{file}: {text}");
        }
    }
}

/// A point that enters and leaves at one time is there at that time.
#[test]
fn a_class_of_one_time_is_kept() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("steps.txt"), "i 0 @ 1\ni 1 @ 2\nd 1 @ 2\n").unwrap();
    let line = ["persistence", "steps.txt", "--zigzag", "-o", "steps.csv"];
    assert_eq!(coface_in(folder.path(), &line).status, 0);
    let text = std::fs::read_to_string(folder.path().join("steps.csv")).unwrap();
    assert!(text.contains("\n0,2,2,closed-closed,1,1\n"), "{text}");
    let line = ["diagram", "betti", "steps.csv", "--samples", "3", "--range", "1", "3", "--json"];
    assert_eq!(coface_in(folder.path(), &line).json()["curves"][0]["numbers"], json!([1.0, 2.0, 1.0]));
    let long = ["persistence", "steps.txt", "--zigzag", "--min-persistence", "0.5", "--json"];
    assert_eq!(coface_in(folder.path(), &long).json()["diagram"].as_array().unwrap().len(), 1);
}

/// A loop that is open between two steps, at none of which it is there.
#[test]
fn curves_count_classes_between_their_open_ends() {
    let folder = tempfile::tempdir().unwrap();
    std::fs::write(folder.path().join("z.txt"), "i 0 @ 1\ni 1 @ 2\ni 0 1 @ 3\nd 0 1 @ 4\ni 0 1 @ 5\n")
        .unwrap();
    let line = ["persistence", "z.txt", "--zigzag", "-o", "z.json"];
    assert_eq!(coface_in(folder.path(), &line).status, 0);
    let found = coface_in(folder.path(), &["diagram", "betti", "z.json", "--json"]).json();
    assert_eq!(found["values"], json!([1.0, 1.5, 2.0, 2.5, 3.0, 3.5, 4.0, 4.5, 5.0]));
    assert_eq!(found["curves"][0]["numbers"], json!([1.0, 1.0, 2.0, 2.0, 1.0, 1.0, 1.0, 2.0, 1.0]));
    let found = coface_in(folder.path(), &["diagram", "euler", "z.json", "--json"]).json();
    assert_eq!(found["curves"][0]["numbers"], json!([1.0, 1.0, 2.0, 2.0, 1.0, 1.0, 1.0, 2.0, 1.0]));
}

/// The checker reads the steps and makes the cone by itself.
#[test]
fn classes_of_zigzags_are_proved() {
    use crate::certificates::lie_about;
    use crate::program::{argument, coface};
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    let certificate = path("zigzag.cert");
    let circle = "i 0\ni 1\ni 2\ni 0 1\ni 1 2\ni 0 2\n";
    let filled = format!("{circle}i 0 1 2\nd 0 1 2\nd 0 2 # opened\ni 2 0\ni 0 1 2\n");
    let timed = "i 0 @ 0.5\ni 1 @ 0.5\ni 0 1 @ 0.5\nd 0 1 @ 0.5\nd 1 @ 2\ni 1 @ 3.25\n";
    let steps = r#"[["i",[0],0],["i",[3],1.5],["d",[0],2],["i",[7],2]]"#;
    let stays = r#"{"simplices":[[0],[1],[0,1],[2]],"times":[[0],[1,8],[2,5,6,7],[3,3,4,null]]}"#;
    for (name, text, options) in [
        ("circle.txt", circle, &[][..]),
        ("filled.txt", &filled, &["--coefficients", "3"]),
        ("timed.txt", timed, &["--min-persistence", "-1"]),
        ("steps.json", steps, &[]),
        ("stays.json", stays, &["--min-persistence", "0.5"]),
    ] {
        let input = path(name);
        std::fs::write(&input, text).unwrap();
        let words =
            ["persistence", argument(&input), "--zigzag", "--certificate", argument(&certificate), "-q"];
        let run = coface(&[&words[..], options].concat());
        assert_eq!(run.status, 0, "{name}: {}", run.stderr);
        let verdict = coface(&["check", argument(&certificate), argument(&input), "--json"]).json();
        assert_eq!(verdict["unchecked"], serde_json::json!([]), "{verdict}");
        lie_about(&certificate, &[&input]);
    }
    // Nothing is proved of another zigzag.
    let other = path("other.txt");
    std::fs::write(&other, "i 0\n").unwrap();
    assert_eq!(coface(&["check", argument(&certificate), argument(&other)]).status, 1);
}
