//! What a reader assumes reaches the user of every verb: on standard error, in the JSON, and as an error with `--strict`.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface};
use serde_json::Value;

/// A tetrahedron with a surplus line.
const SURPLUS: &str = "OFF
4 4 0
0 0 0
1 0 0
0 1 0
0 0 1
3 0 2 1
3 0 1 3
3 1 2 3
3 0 3 2
7 7 7 7
";

/// One verb of each family, with what it needs on a closed surface.
const VERBS: [&[&str]; 16] = [
    &["info"],
    &["homology"],
    &["persistence"],
    &["pi1"],
    &["loops"],
    &["cycles"],
    &["homotopic", "0 1 2 0"],
    &["subgroups"],
    &["cut"],
    &["cover", "--copies", "1"],
    &["cocycles"],
    &["link", "--simplices", "0"],
    &["incidence", "--operator", "FE"],
    &["congruence", "--tolerance", "0.1"],
    &["arrange"],
    &["boolean", "union"],
];

/// The command line of a verb: the file before what stands behind the inputs.
fn of<'a>(verb: &[&'a str], file: &'a str, options: &[&'a str]) -> Vec<&'a str> {
    match verb {
        ["homotopic", walk] => [&["homotopic", file, *walk], options].concat(),
        _ => [verb, &[file], options].concat(),
    }
}

#[test]
fn remarks_of_readers_reach_the_user_of_every_verb() {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("surplus.off");
    std::fs::write(&path, SURPLUS).unwrap();
    let file = argument(&path);
    for verb in VERBS {
        let run = coface(&of(verb, file, &["--json"]));
        let answer = run.json();
        let remarks = answer["remarks"].as_array().unwrap();
        let surplus = |one: &&Value| one["code"] == "trailing-content";
        assert_eq!(remarks.iter().filter(surplus).count(), 1, "{verb:?}: {remarks:?}");
        assert_eq!(remarks[0]["code"], "trailing-content", "{verb:?}: in front of the others");
        // An answer about several inputs begins its remarks with the name.
        let message = remarks[0]["message"].as_str().unwrap();
        let named = format!("{file}: ");
        let line = format!("remark: {named}{}", message.strip_prefix(&named).unwrap_or(message));
        let said = |stderr: &str| stderr.lines().filter(|said| *said == line).count();
        assert_eq!(said(&run.stderr), 1, "{verb:?}: {}", run.stderr);
        // The page of info has its remarks.
        let page = coface(&of(verb, file, &[]));
        let on_the_page = usize::from(verb == ["info"]);
        assert_eq!(said(&page.stderr), 1 - on_the_page, "{verb:?}: {}", page.stderr);
        let quiet = coface(&of(verb, file, &["--json", "--quiet"]));
        assert_eq!(quiet.stderr, "", "{verb:?}");
        assert_eq!(quiet.json(), answer, "{verb:?}");
        let refused = coface(&of(verb, file, &["--strict"]));
        assert!(refused.fails_with(1).contains("surplus.off"), "{verb:?}");
    }
}

/// Of several inputs each remark names its own, and what has none is as it was.
#[test]
fn remarks_of_several_inputs_name_them() {
    let folder = tempfile::tempdir().unwrap();
    let [first, second] = ["a.off", "b.off"].map(|name| folder.path().join(name));
    std::fs::write(&first, SURPLUS).unwrap();
    std::fs::write(&second, SURPLUS.replace("0 0 1\n", "0 0 2\n")).unwrap();
    let run = coface(&["congruence", argument(&first), argument(&second), "--tolerance", "0", "--json"]);
    let remarks = run.json()["remarks"].clone();
    assert!(remarks[0]["places"][0]["file"].as_str().unwrap().ends_with("a.off"), "{remarks}");
    assert!(remarks[1]["places"][0]["file"].as_str().unwrap().ends_with("b.off"), "{remarks}");
    assert_eq!(run.stderr.lines().count(), 2, "{}", run.stderr);
}

/// An assumption that no reader makes but the answer reports is refused before anything is written.
#[test]
fn strict_refuses_what_an_answer_assumes() {
    let folder = tempfile::tempdir().unwrap();
    let [drawing, out] = ["hole.wkt", "out.wkt"].map(|name| folder.path().join(name));
    // The hole is not inside of its ring.
    std::fs::write(&drawing, "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (8 8, 9 8, 9 9, 8 8))").unwrap();
    let union = ["boolean", "union", argument(&drawing), "-o", argument(&out)];
    let served = coface(&[&union[..], &["--json"]].concat()).json();
    assert_eq!(served["remarks"][0]["code"], "drawing-assumption", "{served}");
    std::fs::remove_file(&out).unwrap();
    let refused = coface(&[&union[..], &["--strict"]].concat());
    assert!(refused.fails_with(1).contains("--strict"), "{}", refused.stderr);
    assert!(!out.exists());
}
