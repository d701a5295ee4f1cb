//! What the program prints is what the types of the answers say.

use crate::program::{argument, coface, coface_reading};
use coface::answers::answer::reprinted;
use serde_json::Value;

const TETRAHEDRON: &[u8] = b"[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]";
const PROJECTIVE_PLANE: &[u8] =
    b"[[0,1,2],[0,2,3],[0,3,4],[0,4,5],[0,5,1],[1,2,4],[2,3,5],[3,4,1],[4,5,2],[5,1,3]]";

/// Asserts that a printed answer can be read into its type, and that the type prints the same.
#[track_caller]
fn assert_typed(verb: &str, printed: &Value) {
    let again = reprinted(verb, &printed.to_string()).expect("the verb has an answer type");
    let again: Value = serde_json::from_str(&again.expect("the answer is of its type")).expect("JSON");
    assert_eq!(&again, printed, "{verb}");
    assert!(verb == "info FILES" || printed["remarks"].is_array(), "{verb}: {printed}");
}

#[test]
fn printed_answers_are_those_of_the_types() {
    let vertex: &[&str] = &["--simplices", "0"];
    let verbs: &[(&str, &[&str])] = &[
        ("info", &["--moment", "1,0,0"]),
        ("homology", &["--generators"]),
        ("homology", &["--cohomology", "--coefficients", "f2", "--harmonic"]),
        ("homology", &["--cycle", "0 1; 1 2; -1*0 2"]),
        ("homology", &["--cup", "1", "1", "--coefficients", "f2"]),
        ("persistence", &[]),
        ("pi1", &["--subgroups", "2"]),
        ("pi1", &["--shortest"]),
        ("cut", &[]),
        ("cut", &["--simplify"]),
        ("cover", &["--copies", "1"]),
        ("cover --orientation", &["--orientation"]),
        ("cocycles", &[]),
        ("cocycles", &["--method", "general"]),
        ("cocycles", &["--harmonic"]),
        ("star", vertex),
        ("closure", vertex),
        ("link", vertex),
        ("boundary", &[]),
        ("interior", &[]),
        ("skeleton", &["--dimension", "1"]),
        ("incidence", &["--operator", "FE"]),
        ("incidence", &["--operator", "EV", "--signed", "--entries"]),
    ];
    for model in [TETRAHEDRON, PROJECTIVE_PLANE] {
        for (name, options) in verbs {
            let verb = name.split(' ').next().expect("a verb has a name");
            if verb == "persistence" {
                // Facets have no coordinates to be a function.
                continue;
            }
            let mut arguments = vec![verb, "-", "--json"];
            arguments.extend(*options);
            let run = coface_reading(&arguments, model);
            assert_typed(name, &run.json());
        }
    }
}

#[test]
fn intersection_forms_and_sequences_are_typed() {
    let form = coface_reading(&["homology", "-", "--intersection-form", "--json"], TETRAHEDRON);
    assert_typed("homology", &form.json());
    let disk = coface_reading(
        &["homology", "-", "--relative", "boundary", "--sequence", "--generators", "--json"],
        b"[[0,1,2]]",
    );
    assert_typed("homology", &disk.json());
}

#[test]
fn cocycles_and_tests_of_cochains_are_typed() {
    let folder = tempfile::tempdir().expect("a folder for the test");
    let rim = b"[[0,1],[1,2],[0,2],[0,3]]";
    let found = coface_reading(&["cocycles", "-", "--json"], rim).json();
    assert_eq!(found["rank"], 1);
    assert_typed("cocycles", &found);
    let file = folder.path().join("cochain.json");
    for (cochain, more) in [
        ("[[1,[0,1]]]", &[][..]),
        ("[[1,[0,3]]]", &[]),
        ("[[1.5,[0,1]]]", &["--tolerance", "0.25"]),
        ("[[2.0,[0,3]]]", &["--tolerance", "0.25"]),
    ] {
        std::fs::write(&file, cochain).expect("the file can be written");
        let arguments = [&["cocycles", "-", "--json", "--test", argument(&file)], more].concat();
        let tested = coface_reading(&arguments, rim).json();
        assert_eq!(tested["closed"], true, "{cochain}");
        assert_typed("cocycles --test", &tested);
    }
    std::fs::write(&file, "[[1,[0,1]]]").expect("the file can be written");
    let arguments = ["cocycles", "-", "--json", "--test", argument(&file)];
    let open = coface_reading(&arguments, b"[[0,1,2]]").json();
    assert_eq!((&open["closed"], &open["sum"]), (&Value::from(false), &Value::from(1)));
    assert_typed("cocycles --test", &open);
}

#[test]
fn several_reports_and_files_are_typed() {
    let folder = tempfile::tempdir().expect("a folder for the test");
    let mesh = folder.path().join("tetrahedron.off");
    let text = "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";
    std::fs::write(&mesh, text).expect("the file can be written");
    let missing = folder.path().join("missing.off");
    let both = coface(&["info", argument(&mesh), argument(&missing), "--json"]);
    assert_eq!(both.status, 1);
    assert_typed("info FILES", &serde_json::from_str(&both.stdout).expect("JSON"));
    assert_typed("persistence", &coface(&["persistence", argument(&mesh), "--json"]).json());
    let page = folder.path().join("page.html");
    assert_typed("view", &coface(&["view", argument(&mesh), "-o", argument(&page), "--json"]).json());
    let shards = folder.path().join("shards");
    let shards = argument(&shards);
    assert_typed(
        "shard",
        &coface(&["shard", argument(&mesh), "--parts", "2", "-o", shards, "--json"]).json(),
    );
    assert_typed("reduce", &coface(&["reduce", shards, "--json"]).json());
    assert_typed("merge", &coface(&["merge", shards, "--generators", "--json"]).json());
    let cover = folder.path().join("cut.json");
    let cut = coface(&["cut", argument(&mesh), "-o", argument(&cover), "--json"]);
    assert_typed("cut", &cut.json());
}
