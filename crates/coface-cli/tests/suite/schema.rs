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
        ("loops", &[]),
        ("loops", &["--canonical"]),
        ("cycles", &["--kind", "non-contractible"]),
        ("homotopic", &["0 1 2 0"]),
        ("subgroups", &["--index", "2"]),
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
    let diagram = folder.path().join("diagram.json");
    coface(&["persistence", argument(&mesh), "-o", argument(&diagram)]);
    let diagram = argument(&diagram);
    assert_typed(
        "diagram distance",
        &coface(&["diagram", "distance", diagram, diagram, "--matching", "--json"]).json(),
    );
    assert_typed("diagram betti", &coface(&["diagram", "betti", diagram, "--json"]).json());
    let image =
        coface(&["diagram", "image", diagram, "--births", "0", "1", "--persistences", "0", "1", "--json"]);
    assert_typed("diagram image", &image.json());
    assert_typed(
        "euler",
        &coface(&["euler", argument(&mesh), "--directions", "3", "--normalize", "--json"]).json(),
    );
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

const CUBE: &str = "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n\
    4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";
const LEAF: &str = r#"{"order":4,"curves":[{"points":[[0,0],[4,0],[5,2],[4,4],[0,4]],"kinks":[0,4]}]}"#;

/// Files of a folder that goes with the test.
struct Files(tempfile::TempDir);

impl Files {
    fn new() -> Self {
        Self(tempfile::tempdir().expect("a folder for the test"))
    }

    fn path(&self, name: &str) -> String {
        argument(&self.0.path().join(name)).to_owned()
    }

    fn write(&self, name: &str, text: &str) -> String {
        std::fs::write(self.0.path().join(name), text).expect("the file can be written");
        self.path(name)
    }
}

/// Asserts that the verb prints an answer of its type.
#[track_caller]
fn assert_prints(name: &str, arguments: &[&str]) {
    assert_typed(name, &coface(&[arguments, &["--json", "--quiet"]].concat()).json());
}

#[test]
fn drawings_are_typed() {
    let files = Files::new();
    let a = files.write("a.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 2 1, 2 2, 1 2, 1 1))");
    let b = files.write("b.wkt", "POLYGON ((3 3, 6 3, 6 6, 3 6, 3 3))");
    let out = files.path("out.json");
    for options in [&[][..], &["--snap"], &["--rule", "nonzero"], &["--provenance", &out]] {
        assert_prints("arrange (plane)", &[&["arrange", &a, &b], options].concat());
        assert_prints("boolean (plane)", &[&["boolean", "union", &a, &b], options].concat());
    }
    assert_prints("info", &["info", &a]);
}

#[test]
fn solids_are_typed() {
    let files = Files::new();
    let a = files.write("a.off", CUBE);
    let out = files.path("provenance.json");
    let shifted: Vec<String> = CUBE
        .lines()
        .enumerate()
        .map(|(i, line)| match (2..10).contains(&i) {
            true => line.split(' ').map(|x| format!("{x}.5 ")).collect(),
            false => line.to_owned(),
        })
        .collect();
    let b = files.write("b.off", &shifted.join("\n"));
    for options in [&[][..], &["--triangles"], &["--provenance", &out]] {
        assert_prints("arrange (space)", &[&["arrange", &a, &b], options].concat());
        assert_prints("boolean (space)", &[&["boolean", "difference", &a, &b], options].concat());
    }
    assert_prints("congruence", &["congruence", &a, &b, "--tolerance", "1e-6"]);
    let out = files.path("out.obj");
    assert_prints("convert", &["convert", &a, "-o", &out]);
    assert_prints("convert", &["convert", &a, "--split-edges", "pairs", "-o", &out]);
    let picture = files.path("out.png");
    assert_prints("render", &["render", &a, "--size", "40x30", "-o", &picture]);
    assert_prints("generate", &["generate", "torus", "-o", &out]);
    let rows = files.path("rows.jsonl");
    assert_prints("batch", &["batch", &a, &b, "-o", &rows]);
}

#[test]
fn sets_are_typed() {
    let files = Files::new();
    let a = files.write("a.json", LEAF);
    let square = r#"{"order":2,"curves":[{"points":[[1,1],[6,1],[6,3],[1,3]],"kinks":[0,1,2,3]}]}"#;
    let b = files.write("b.json", square);
    assert_prints("yin info", &["yin", "info", &b]);
    let linear = files.write("c.json", &square.replace("[1,1]", "[0,0]"));
    for verb in ["meet", "join", "difference"] {
        assert_prints("yin meet", &["yin", verb, &b, &linear]);
    }
    assert_prints("yin meet", &["yin", "complement", &a]);
    assert_prints("yin info", &["yin", "info", &a]);
    assert_prints("yin fit", &["yin", "fit", &b]);
    assert_prints("yin kinks", &["yin", "kinks", &a]);
    assert_prints("yin compare", &["yin", "compare", &a, &b]);
    assert_prints("yin compare --series", &["yin", "compare", "--series", &a, &b, &a]);
    assert_prints("yin interface", &["yin", "interface", &b]);
    assert_prints("yin cut-cells", &["yin", "cut-cells", &b, "--grid", "4x4"]);
    assert_prints("yin locate", &["yin", "locate", &b, "--point", "2,2", "--point", "9,9"]);
    assert_prints("yin sample", &["yin", "sample", &a]);
    assert_prints("yin curvature", &["yin", "curvature", &a]);
    assert_prints("yin validate", &["yin", "validate", &a]);
    assert_prints("yin normalize", &["yin", "normalize", &b]);
    assert_prints("yin info", &["yin", "transform", &a, "--scale", "2"]);
    let moved = ["--flow", "rotation", "--center", "0,0", "--step", "0.1", "--spacing", "0.5"];
    assert_prints("yin advect", &[&["yin", "advect", &a], &moved[..]].concat());
}

#[test]
fn operators_and_diagrams_are_typed() {
    let files = Files::new();
    let cube = files.write("cube.off", CUBE);
    for kind in [&["--incident"][..], &["--at-least", "1"], &["--exactly", "2"], &["--signed"]] {
        let operator = ["incidence", &cube, "--operator", "FE", "--entries"];
        assert_prints("incidence", &[&operator, kind].concat());
    }
    for options in [&["--upper-star"][..], &["--coefficients", "f3"], &["--min-persistence", "-1"]] {
        assert_prints("persistence", &[&["persistence", &cube], options].concat());
    }
    let values = files.write("values.json", r#"{"cells":[[[0],1.5]]}"#);
    let failed = coface(&["persistence", &cube, "--values", &values, "--json"]);
    assert_eq!(failed.status, 1, "cells without a value are refused: {}", failed.stdout);
}

#[test]
fn shards_are_typed() {
    let files = Files::new();
    let cube = files.write("cube.off", CUBE);
    let folder = files.path("shards");
    assert_prints("shard", &["shard", &cube, "--parts", "3", "-o", &folder]);
    assert_prints("reduce", &["reduce", &folder]);
    assert_prints("merge", &["merge", &folder]);
    assert_prints("homology", &["homology", &cube, "--parts", "2", "--generators"]);
    assert_prints("homology", &["homology", &cube, "--parts", "2", "--cohomology"]);
}

#[test]
fn maps_and_decompositions_are_typed() {
    let files = Files::new();
    let rim = files.write("rim.json", "[[0,1],[1,2],[0,2]]");
    let map = files.write("map.json", "[[0,0],[1,2],[2,1]]");
    let run = coface(&["homology", &rim, "--map", &map, "--target", &rim, "--json"]).json();
    assert_eq!(run["map"]["degrees"][1]["matrix"], serde_json::json!([[-1]]));
    assert_typed("homology", &run);
    let cochain = files.write("cochain.json", "[[1.5,[0,1]]]");
    assert_prints("homology", &["homology", &rim, "--decompose", &cochain]);
    assert_prints("homology", &["homology", &rim, "--reduced", "--generators"]);
}
