//! A file without a verb, verbs without input, options that a verb has no use for, and the verbs on loops.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_reading};
use serde_json::{Value, json};

const SPHERE: &[u8] = b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]";
/// The torus of seven vertices.
const TORUS: &[u8] = b"[[0,1,3],[1,2,4],[2,3,5],[3,4,6],[4,5,0],[5,6,1],[6,0,2],\
    [0,3,2],[1,4,3],[2,5,4],[3,6,5],[4,0,6],[5,1,0],[6,2,1]]";

#[test]
fn an_option_that_needs_no_value_leaves_the_input_alone() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("circle.json");
    std::fs::write(&path, "[[0,1],[1,2],[0,2]]").unwrap();
    let input = path.to_str().unwrap();
    let usual = coface(&["homology", input, "--generators", "--json"]);
    let swallowed = coface(&["homology", "--generators", input, "--json"]);
    assert_eq!((swallowed.status, &swallowed.stdout), (0, &usual.stdout));
    // A file that is no input of the line stays a value.
    let missing = coface(&["homology", "--generators", "no-such-file.json"]);
    assert!(missing.fails_with(2).contains("<INPUT>"));
    // A file that is there is the value still where something else is wrong.
    let old = folder.path().join("old.json");
    std::fs::write(&old, "[]").unwrap();
    let wrong = coface(&["persistence", input, "--cycles", argument(&old), "--coefficients", "4"]);
    assert!(wrong.fails_with(2).contains("no prime field of 4 elements"), "{}", wrong.stderr);
}

#[test]
fn a_file_alone_is_reported_on() {
    let folder = tempfile::tempdir().unwrap();
    let [first, second] = ["a.json", "b.json"].map(|name| folder.path().join(name));
    std::fs::write(&first, SPHERE).unwrap();
    std::fs::write(&second, TORUS).unwrap();
    let [a, b] = [&first, &second].map(|path| argument(path));
    for options in [&[a][..], &[a, b], &[a, "--all"], &[a, b, "--json"], &["-q", a]] {
        let alone = coface(options);
        assert_eq!(alone.status, 0, "{options:?}: {}", alone.stderr);
        assert_eq!(alone.stdout, coface(&[&["info"], options].concat()).stdout, "{options:?}");
    }
    assert_eq!(coface_reading(&["-", "--json"], TORUS).json()["name"], "torus");
    let unknown = coface(&["homolgy", a]);
    assert!(unknown.fails_with(2).contains("'homology'"), "the nearest verb: {}", unknown.stderr);
    let missing = folder.path().join("missing.off");
    assert!(coface(&[argument(&missing)]).fails_with(2).contains("there is no such file"));
    // Behind a verb that has verbs of its own a file is not a file alone.
    for verb in ["map", "yin", "diagram", "generate"] {
        let run = coface(&[verb, argument(&missing)]);
        assert!(run.fails_with(2).contains("unrecognized subcommand"), "{}", run.stderr);
    }
}

#[test]
fn a_verb_without_input_shows_its_own_usage() {
    for verb in [
        &["info"][..],
        &["homology"],
        &["pi1"],
        &["loops"],
        &["cut"],
        &["arrange"],
        &["boolean", "union"],
        &["convert"],
        &["view"],
        &["batch"],
        &["star"],
    ] {
        let run = coface(verb);
        let usage = format!("Usage: coface {}", verb[0]);
        assert!(run.fails_with(2).contains(&usage), "{verb:?}: {}", run.stderr);
    }
}

#[test]
fn options_of_volumes_are_shown_by_verbs_that_read_them() {
    for verb in ["info", "homology", "pi1", "convert", "view", "shard"] {
        assert!(coface(&[verb, "--help"]).stdout.contains("--threshold"), "{verb}");
    }
    for verb in ["arrange", "boolean", "congruence", "link", "yin", "completions"] {
        assert!(!coface(&[verb, "--help"]).stdout.contains("--threshold"), "{verb}");
    }
    assert!(!coface(&["yin", "info", "--help"]).stdout.contains("--threshold"));
    // They are taken all the same.
    let old = coface_reading(&["star", "-", "--simplices", "0", "--threshold", "1", "--json"], SPHERE);
    assert_eq!(old.json()["simplices"].as_array().unwrap().len(), 7);
}

#[test]
fn loops_of_any_complex_and_of_a_surface() {
    let rim = coface_reading(&["loops", "-", "--json"], b"[[0,1],[1,2],[0,2]]").json();
    let found = &rim["components"][0];
    assert_eq!((&found["name"], &found["relators"]), (&json!("Z"), &json!([])));
    assert_eq!(found["loops"][0]["length"], 3.0);
    assert_eq!(rim["remarks"][0]["code"], "unit-lengths");
    let old = coface_reading(&["pi1", "-", "--canonical", "--json"], TORUS).json();
    let new = coface_reading(&["loops", "-", "--canonical", "--json"], TORUS).json();
    assert_eq!(new["components"][0]["relators"], old["components"][0]["relators"]);
    let lengths: Vec<&Value> =
        new["components"][0]["loops"].as_array().unwrap().iter().map(|one| &one["length"]).collect();
    assert_eq!(json!(lengths), old["components"][0]["lengths"]);
    let page = coface_reading(&["loops", "-", "--canonical"], TORUS).stdout;
    assert!(page.contains("x1 x2 x1^-1 x2^-1"), "{page}");
}

#[test]
fn cycles_and_subgroups_are_those_of_pi1() {
    let old = coface_reading(&["pi1", "-", "--cycles", "homology-basis", "--json"], TORUS).json();
    let new = coface_reading(&["cycles", "-", "--json"], TORUS).json();
    assert_eq!((&new["cycles"], &new["kind"]), (&old["cycles"], &json!("homology-basis")));
    let none = coface_reading(&["cycles", "-", "--kind", "non-contractible"], SPHERE);
    assert!(none.stdout.contains("no closed path is of this kind"), "{}", none.stdout);
    // The subgroups of index n of Z^2 are as many as the sum of the divisors of n.
    let counted = coface_reading(&["subgroups", "-", "--index", "3", "--json"], TORUS).json();
    let counts = counted["components"][0]["subgroups"].as_array().unwrap().clone();
    assert_eq!(counts.iter().map(|one| one["subgroups"].as_u64().unwrap()).collect::<Vec<_>>(), [1, 3, 4]);
}

/// What `loops` writes, `homotopic` reads.
#[test]
fn walks_are_compared() {
    let folder = tempfile::tempdir().unwrap();
    let [torus, loops] = ["torus.json", "loops.json"].map(|name| folder.path().join(name));
    std::fs::write(&torus, TORUS).unwrap();
    let torus = argument(&torus);
    let written = coface(&["loops", torus, "-o", argument(&loops)]);
    assert_eq!((written.status, written.stdout.as_str()), (0, ""), "{}", written.stderr);
    let compared = coface(&["homotopic", torus, "--walks", argument(&loops), "--json"]).json();
    assert_eq!(compared["walks"].as_array().unwrap().len(), 2);
    assert_eq!(compared["pairs"][0]["homologous"], false);
    let given =
        coface(&["homotopic", torus, "0 1 3 0", "0 1 2 3 4 5 6 0", "0 6 5 4 3 2 1 0", "--json"]).json();
    assert_eq!(given["walks"][0]["contractible"], true);
    assert_eq!(given["walks"][1]["contractible"], false);
    let old = folder.path().join("walks.json");
    std::fs::write(&old, "[[0,1,3,0],[0,1,2,3,4,5,6,0],[0,6,5,4,3,2,1,0]]").unwrap();
    let flags = coface(&["pi1", torus, "--canonical", "--walks", argument(&old), "--json"]).json();
    assert_eq!((&flags["walks"], &flags["pairs"]), (&given["walks"], &given["pairs"]));
    assert!(
        coface(&["homotopic", torus, "0 1"]).fails_with(1).contains("end with the vertex it starts with")
    );
}

/// All pairs of ten walks are on the page; of more than it shows, it says how many are left out.
#[test]
fn pairs_of_walks_are_printed_or_counted() {
    let ten = ["0 1 3 0"; 10];
    let page = coface_reading(&[&["homotopic", "-"], &ten[..]].concat(), TORUS).stdout;
    assert_eq!(page.matches("homotopic with the base fixed").count(), 45, "{page}");
    let twenty = ["0 1 3 0"; 20];
    let page = coface_reading(&[&["homotopic", "-"], &twenty[..]].concat(), TORUS).stdout;
    assert!(page.contains("and 90 more pairs"), "{page}");
    let page = coface_reading(&[&["homotopic", "-", "--all"], &twenty[..]].concat(), TORUS).stdout;
    assert_eq!(page.matches("homotopic with the base fixed").count(), 190);
}

#[test]
fn many_components_are_summed_up() {
    let lists: Vec<[u32; 2]> = (0..1000).map(|i| [2 * i, 2 * i + 1]).collect();
    let text = serde_json::to_string(&lists).unwrap();
    let page = coface_reading(&["pi1", "-"], text.as_bytes()).stdout;
    assert!(page.contains("1,000") && page.lines().count() < 10, "{page}");
    let all = coface_reading(&["pi1", "-", "--all"], text.as_bytes()).stdout;
    assert!(all.contains("1000 of 1000"), "{all}");
}

#[test]
fn glosses_agree_with_their_verdicts() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("cochain.json");
    std::fs::write(&file, "[[1,[0,1]]]").unwrap();
    let open = coface_reading(&["cocycles", "-", "--test", argument(&file)], b"[[0,1,2]]").stdout;
    assert!(open.contains("the sum around some face is not zero"), "{open}");
    assert!(open.contains("it is not the difference"), "{open}");
}
