//! Certificates of cuts, covers and cocycles: proofs that hold, and lies that do not.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::certificates::{BAND, PLANE, TORUS, lie_about};
use crate::program::{argument, coface};
use serde_json::{Value, json};
use std::fs;
use std::path::{Path, PathBuf};

/// The Klein bottle of 9 vertices, a grid of three by three squares glued with a reflection.
fn klein() -> String {
    let vertex = |i: u32, j: u32| if i < 3 { 3 * i + j % 3 } else { (3 - j % 3) % 3 };
    let squares = (0..3).flat_map(|i| (0..3).map(move |j| (i, j)));
    let triangles = squares.flat_map(|(i, j)| {
        let [a, b, c, d] = [vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)];
        [[a, b, c], [a, c, d]]
    });
    json!(triangles.collect::<Vec<_>>()).to_string()
}

/// A sphere and an annulus of squares.
const TWO: &str = "OFF\n12 10 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n5 0 0\n6 0 0\n6 1 0\n5 1 0\n5 0 1\n6 0 1\n6 1 1\n5 1 1\n\
    4 4 5 9 8\n4 5 6 10 9\n4 6 7 11 10\n4 7 4 8 11\n3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n4 4 5 6 7\n4 8 11 10 9\n";
/// The same without the lids of the second sphere.
const TUBE: &str = "OFF\n8 4 0\n5 0 0\n6 0 0\n6 1 0\n5 1 0\n5 0 1\n6 0 1\n6 1 1\n5 1 1\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

/// Makes a certificate: its place and what is proved, after the answer.
fn proved(folder: &Path, input: &Path, words: &[&str]) -> (Value, PathBuf, Vec<String>) {
    let place = folder.join("proof.cert");
    let line = [&words[..1], &[argument(input)], &words[1..], &["--certificate", argument(&place), "--json"]];
    let answer = coface(&line.concat()).json();
    let verdict = coface(&["check", argument(&place), argument(input), "--json"]).json();
    let lines = verdict["proved"].as_array().unwrap().iter();
    (answer, place, lines.map(|line| line.as_str().unwrap().to_owned()).collect())
}

fn written(folder: &Path, text: &str) -> PathBuf {
    let input = folder.join(if text.starts_with("OFF") { "in.off" } else { "in.json" });
    fs::write(&input, text).unwrap();
    input
}

fn has(proved: &[String], expected: &[&str], what: &str) {
    for line in expected {
        assert!(proved.iter().any(|found| found.contains(line)), "{what}: {line} is not in {proved:#?}");
    }
}

#[test]
fn cuts_are_proved_and_lies_about_them_are_not() {
    let folder = tempfile::tempdir().unwrap();
    let sphere = "[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]";
    for (text, options, expected) in [
        (TORUS, &[][..], &["a component, torus, cut along 10 edges to a disk", "3 seams twice"][..]),
        (TORUS, &["--simplify"], &["a component, torus, cut along"]),
        (PLANE, &[], &["projective plane", "1 seam twice"]),
        (
            PLANE,
            &["--simplify", "--base", "4"],
            &["projective plane, cut along 3 edges to a disk of 9 vertices"],
        ),
        (&klein(), &["--simplify"], &["Klein bottle", "twice, as the word says"]),
        (BAND, &["--roles"], &["a component, Moebius band, cut along"]),
        (
            sphere,
            &[],
            &["a component, sphere, cut along 3 edges to a disk of 6 vertices, 9 edges and 4 faces"],
        ),
        (sphere, &["--simplify"], &["a component, sphere, cut along 2 edges to a disk"]),
        (
            "[[0,1,2]]",
            &[],
            &["a component, disk, cut along 0 edges to a disk of 3 vertices, 3 edges and 1 face"],
        ),
        (TWO, &["--simplify"], &["f_vector = [", "a component, sphere, cut along"]),
        (
            TUBE,
            &[],
            &["a component, annulus, cut along 1 edge to a disk of 10 vertices, 13 edges and 4 faces"],
        ),
        (
            TORUS,
            &["--along", "0 3 6 0"],
            &["the path 0 3 6 0 is two-sided and cut", "a component, annulus, of 12"],
        ),
        (
            PLANE,
            &["--along", "1 2 3 4 5 1"],
            &["is two-sided", "a component, Moebius band, of", "a component, disk, of 6 vertices"],
        ),
        (TUBE, &["--along", "0 4"], &["the path 0 4 is open", "a component, disk, of 10 vertices"]),
        (
            sphere,
            &["--along", "0 1 2 0"],
            &["is two-sided", "a component, disk, of 3 vertices, 3 edges and 1 face"],
        ),
    ] {
        let input = written(folder.path(), text);
        let (_, place, lines) = proved(folder.path(), &input, &[&["cut"], options].concat());
        has(&lines, expected, &format!("{text} {options:?}"));
        if [TORUS, TUBE].contains(&text) || options.contains(&"--orientation") {
            lie_about(&place, &[&input]);
        }
    }
}

#[test]
fn covers_are_proved_and_lies_about_them_are_not() {
    let folder = tempfile::tempdir().unwrap();
    for (text, options, expected) in [
        (
            TORUS,
            &["--radius", "1"][..],
            &["5 copies, glued to a disk of", "complete = false", "each word crosses"][..],
        ),
        (TORUS, &["--copies", "1"], &["1 copy, glued to a disk"]),
        (
            PLANE,
            &["--radius", "3"],
            &["2 copies, glued to a sphere", "a covering of degree 2 that is simply connected"],
        ),
        (BAND, &["--copies", "4"], &["4 copies, glued to a disk", "surface = \"Moebius band\""]),
        (TUBE, &["--copies", "3"], &["3 copies, glued to a disk", "surface = \"annulus\""]),
        (TWO, &["--radius", "2", "--component", "1"], &["components = 2", "a covering of degree 1"]),
        (&klein(), &["--radius", "1"], &["surface = \"Klein bottle\""]),
        (PLANE, &["--orientation"], &["surfaces, in some order: sphere", "f_vector = [12,30,20]"]),
        (&klein(), &["--orientation"], &["surfaces, in some order: torus"]),
        (BAND, &["--orientation"], &["surfaces, in some order: annulus"]),
        (TWO, &["--orientation"], &["surfaces, in some order: sphere, sphere, sphere, sphere"]),
    ] {
        let input = written(folder.path(), text);
        let (_, place, lines) = proved(folder.path(), &input, &[&["cover"], options].concat());
        has(&lines, expected, &format!("{text} {options:?}"));
        if [TORUS, TUBE].contains(&text) || options.contains(&"--orientation") {
            lie_about(&place, &[&input]);
        }
    }
}

#[test]
fn cocycles_are_proved_and_lies_about_them_are_not() {
    let folder = tempfile::tempdir().unwrap();
    let graph = "[[0,1],[1,2],[2,0],[2,3],[3,4],[4,2],[7,8]]";
    let solid = "[[0,1,2,3],[1,2,3,4],[2,3,4,5],[3,4,5,6],[4,5,6,0],[5,6,0,1],[6,0,1,2]]";
    for (text, options, rank) in [
        (TORUS, &[][..], 2),
        (TORUS, &["--method", "slicing"], 2),
        (TORUS, &["--method", "general", "--harmonic"][..2], 2),
        (PLANE, &[], 0),
        (&klein(), &[], 1),
        (&klein(), &["--method", "general"], 1),
        (BAND, &[], 1),
        (TWO, &[], 0),
        (graph, &[], 2),
        (solid, &[], 1),
        ("[[0],[1]]", &[], 0),
    ] {
        let input = written(folder.path(), text);
        let (answer, place, lines) = proved(folder.path(), &input, &[&["cocycles"], options].concat());
        assert_eq!(answer["rank"], json!(rank), "{text}");
        let expected = [
            format!("rank = {rank}"),
            "the classes of the cocycles are a basis of the first cohomology over Z".to_owned(),
        ];
        has(&lines, &expected.each_ref().map(String::as_str), text);
        if options.is_empty() && [PLANE, BAND, graph].contains(&text) {
            lie_about(&place, &[&input]);
        }
    }
    // Twice a cocycle is closed, and no basis: its pairing is 2.
    let input = written(folder.path(), BAND);
    let (_, place, _) = proved(folder.path(), &input, &["cocycles"]);
    let mut lie: Value = serde_json::from_slice(&fs::read(&place).unwrap()).unwrap();
    for term in lie["answer"]["cocycles"][0].as_array_mut().unwrap() {
        term[0] = json!(2 * term[0].as_i64().unwrap());
    }
    lie["answer"]["pairing"] = json!([[2 * lie["answer"]["pairing"][0][0].as_i64().unwrap()]]);
    fs::write(&place, lie.to_string()).unwrap();
    let run = coface(&["check", argument(&place), argument(&input)]);
    assert!(
        run.fails_with(1).contains("the cocycles are no basis: a factor of the pairing is"),
        "{}",
        run.stderr
    );
}

#[test]
fn groups_are_proved_and_lies_about_them_are_not() {
    let folder = tempfile::tempdir().unwrap();
    let graph = "[[0,1],[1,2],[2,0],[2,3],[3,4],[4,2],[7,8]]";
    // The boundary of a simplex of dimension 4, whose tetrahedra make faces superfluous, and a solid torus.
    let sphere = "[[0,1,2,3],[0,1,2,4],[0,1,3,4],[0,2,3,4],[1,2,3,4]]";
    let solid = "[[0,1,2,3],[1,2,3,4],[2,3,4,5],[3,4,5,6],[4,5,6,0],[5,6,0,1],[6,0,1,2]]";
    for (text, name) in [
        (TORUS, Some("Z^2")),
        (PLANE, Some("Z/2")),
        (&klein()[..], None),
        (BAND, Some("Z")),
        (TWO, Some("trivial")),
        (TUBE, Some("Z")),
        (graph, Some("Free(2)")),
        (sphere, Some("trivial")),
        (solid, Some("Z")),
        ("[[0],[1]]", Some("trivial")),
    ] {
        let input = written(folder.path(), text);
        for options in [&["pi1"][..], &["pi1", "--simplify"], &["pi1", "--base", "1", "--subgroups", "3"]] {
            let (answer, place, lines) = proved(folder.path(), &input, options);
            let named = name.map(|name| format!("this group is {name}"));
            has(
                &lines,
                &named.iter().map(String::as_str).collect::<Vec<_>>(),
                &format!("{text} {options:?}"),
            );
            if let Some(name) = name {
                assert!(answer["components"].to_string().contains(name), "{answer}");
            }
            if [TORUS, PLANE, sphere].contains(&text) {
                lie_about(&place, &[&input]);
            }
        }
    }
}

#[test]
fn walks_are_proved_and_lies_about_them_are_not() {
    let folder = tempfile::tempdir().unwrap();
    let genus_two = folder.path().join("two.off");
    let run = coface(&["generate", "genus", "--genus", "2", "-o", argument(&genus_two), "-q"]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    let sphere = "[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]";
    for (text, walks, expected) in [
        (
            TORUS,
            &["0 3 6 0", "1 4 7 1", "0 1 2 0", "0 1 3 0", "0 1 7 6 0"][..],
            &["can be contracted are [3, 4]", "that are freely homotopic are [[0, 1], [3, 4]]"][..],
        ),
        (
            PLANE,
            &["0 1 3 0", "0 2 4 0", "0 1 2 0"],
            &["can be contracted are [2]", "with the base fixed are [[0, 1]]"],
        ),
        (
            &klein(),
            &["0 3 6 0", "0 1 2 0", "0 2 1 0"],
            &["can be contracted are []", "freely homotopic are [[1, 2]]"],
        ),
        (
            BAND,
            &["0 1 2 3 4 0", "0 2 4 1 3 0", "0 2 1 0"],
            &["can be contracted are [2]", "that bound are [2]"],
        ),
        (
            TWO,
            &["0 1 2 0", "4 5 6 7 4", "4 5 4"],
            &["can be contracted are [0, 1, 2]", "homologous are [[0, 1], [0, 2], [1, 2]]"],
        ),
        (TUBE, &["0 1 2 3 0", "4 5 6 7 4", "4 7 6 5 4"], &["freely homotopic are [[0, 1]]"]),
        (
            sphere,
            &["0 1 2 0", "3"],
            &["can be contracted are [0, 1]", "that are freely homotopic are [[0, 1]]"],
        ),
    ] {
        let input = written(folder.path(), text);
        let (_, place, lines) = proved(folder.path(), &input, &[&["homotopic"], walks].concat());
        has(&lines, expected, &format!("{text} {walks:?}"));
        if [TORUS, PLANE, BAND].contains(&text) {
            lie_about(&place, &[&input]);
        }
    }
    // On a surface of genus two: its canonical loops, and the commutators of the pairs, which bound and cannot be contracted; the one is the inverse of the other.
    let loops = folder.path().join("loops.json");
    assert_eq!(
        coface(&["loops", argument(&genus_two), "--canonical", "-o", argument(&loops), "-q"]).status,
        0
    );
    let given: Value = serde_json::from_slice(&fs::read(&loops).unwrap()).unwrap();
    let given: Vec<Vec<u32>> = serde_json::from_value(given["loops"].clone()).unwrap();
    let commutator = |a: &Vec<u32>, b: &Vec<u32>, is_back: bool| {
        let (back_a, back_b) = (a.iter().rev(), b.iter().rev());
        let mut walk: Vec<u32> =
            a.iter().chain(b.iter().skip(1)).chain(back_a.skip(1)).chain(back_b.skip(1)).copied().collect();
        if is_back {
            walk.reverse();
        }
        walk
    };
    let walks = [
        given[0].clone(),
        given[1].clone(),
        commutator(&given[0], &given[1], false),
        commutator(&given[2], &given[3], true),
    ];
    let file = folder.path().join("walks.json");
    fs::write(&file, json!({"walks": walks}).to_string()).unwrap();
    let (answer, place, lines) =
        proved(folder.path(), &genus_two, &["homotopic", "--walks", argument(&file)]);
    assert_eq!(answer["walks"][2]["contractible"], json!(false));
    has(
        &lines,
        &[
            "can be contracted are []",
            "that bound are [2, 3]",
            "freely homotopic are [[2, 3]]",
            "homologous are [[2, 3]]",
        ],
        "genus 2",
    );
    lie_about(&place, &[&genus_two]);
}

#[test]
fn what_has_no_certificate_leaves_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path().join("proof.cert");
    for (text, words, why) in [
        ("[[0,1,2],[2,3]]", &["cut"][..], "no surface"),
        ("[[0,1,2],[2,3,4]]", &["cut"], "no surface"),
        ("[[0,1],[1,2]]", &["cover", "--radius", "1"], "no surface"),
        ("[]", &["cut"], "no certificate"),
        ("[]", &["cocycles"], "no certificate"),
        ("[[0,1,2],[2,3]]", &["homotopic", "0 1 2 0"], "lies in no face"),
        ("OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\n2 2 2\n3 0 1 2 255 0 0\n", &["cut"], ""),
    ] {
        let input = written(folder.path(), text);
        let line =
            [&words[..1], &[argument(&input)], &words[1..], &["--certificate", argument(&place)]].concat();
        let run = coface(&line);
        if why.is_empty() {
            assert_eq!(run.status, 0, "{}", run.stderr);
            fs::remove_file(&place).unwrap();
            continue;
        }
        assert!(run.fails_with(1).contains(why), "{text}: {}", run.stderr);
        assert!(!place.exists(), "{text}");
    }
    let input = written(folder.path(), TORUS);
    for words in [
        &["cut", "--canonical"][..],
        &["cut", "--layout", "klein"],
        &["cut", "--boundary"],
        &["cocycles", "--relative", "boundary"],
    ] {
        let line =
            [&words[..1], &[argument(&input)], &words[1..], &["--certificate", argument(&place)]].concat();
        assert_eq!(coface(&line).status, 2, "{words:?}");
    }
    for option in ["--rips", "--alpha"] {
        let run = coface(&["cut", argument(&input), option, "--certificate", argument(&place)]);
        assert!(run.fails_with(1).contains("coface cut with a certificate takes no"), "{}", run.stderr);
    }
}
