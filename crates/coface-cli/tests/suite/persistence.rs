//! `coface persistence` as a user runs it.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a skipped test says so")]

use crate::program::{argument, coface, coface_reading};
use serde_json::{Value, json};
use std::path::PathBuf;

/// A tent: a square pyramid without its floor, the tip at height 2, corners at 0, 0, 0 and 1.
const TENT: &str = "OFF\n5 4 0\n0 0 0\n1 0 0\n1 1 1\n0 1 0\n0.5 0.5 2\n3 0 1 4\n3 1 2 4\n3 2 3 4\n3 3 0 4\n";
/// The projective plane with six vertices.
const PLANE: &str =
    r#"{"facets":[[0,1,2],[0,1,5],[0,2,4],[0,3,4],[0,3,5],[1,2,3],[1,3,4],[1,4,5],[2,3,5],[2,4,5]]}"#;

fn folder_with(files: &[(&str, &str)]) -> (tempfile::TempDir, Vec<PathBuf>) {
    let folder = tempfile::tempdir().unwrap();
    let paths = files.iter().map(|(name, text)| {
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        path
    });
    let paths = paths.collect();
    (folder, paths)
}

fn intervals(object: &Value) -> Vec<(u64, f64, Option<f64>)> {
    let one = |pair: &Value| {
        (pair["degree"].as_u64().unwrap(), pair["birth"].as_f64().unwrap(), pair["death"].as_f64())
    };
    object["diagram"].as_array().unwrap().iter().map(one).collect()
}

#[test]
fn a_tent_by_height() {
    let object = coface_reading(&["persistence", "-", "--json"], TENT.as_bytes()).json();
    // The corners 1, 0, 3 make a path at height 0, the corner at 1 closes a loop, and the tip fills it.
    assert_eq!(intervals(&object), [(0, 0.0, None), (1, 1.0, Some(2.0))]);
    assert_eq!(
        (&object["field"], &object["function"], &object["star"], &object["betti"]),
        (&json!(2), &json!("z"), &json!("lower"), &json!([1, 0, 0]))
    );
    let vertices = |pair: usize, key: &str| object["diagram"][pair][key].as_array().map(Vec::len);
    assert_eq!((vertices(1, "birth_cell"), vertices(1, "death_cell")), (Some(2), Some(3)));
    assert_eq!(vertices(0, "death_cell"), None);
    let all =
        coface_reading(&["persistence", "-", "--json", "--min-persistence", "-1"], TENT.as_bytes()).json();
    assert_eq!(intervals(&all).len(), 9, "17 cells, one of them alone");
    let none =
        coface_reading(&["persistence", "-", "--json", "--min-persistence", "1"], TENT.as_bytes()).json();
    assert_eq!(intervals(&none), [(0, 0.0, None)]);
}

#[test]
fn a_tent_from_above() {
    let object = coface_reading(&["persistence", "-", "--json", "--upper-star"], TENT.as_bytes()).json();
    assert_eq!((intervals(&object), &object["star"]), (vec![(0, 2.0, None)], &json!("upper")));
    let text = coface_reading(&["persistence", "-", "--function", "x"], TENT.as_bytes()).stdout;
    assert!(text.contains("function: x, lower star") && text.contains("degree 0: 1 class"), "{text}");
}

#[test]
fn without_positions_the_function_is_the_vertex_number() {
    let object = coface_reading(&["persistence", "-", "--json"], PLANE.as_bytes()).json();
    assert_eq!((&object["function"], &object["betti"]), (&json!("vertex number"), &json!([1, 1, 1])));
    let run = coface_reading(&["persistence", "-", "--json", "--coefficients", "f3"], PLANE.as_bytes());
    assert_eq!(run.json()["betti"], json!([1, 0, 0]));
}

#[test]
fn files_that_other_programs_read() {
    let (folder, paths) = folder_with(&[("tent.off", TENT)]);
    let written = |name: &str| {
        let out = folder.path().join(name);
        let run = coface(&["persistence", argument(&paths[0]), "-o", argument(&out)]);
        assert_eq!((run.status, run.stdout.as_str()), (0, ""), "{}", run.stderr);
        std::fs::read_to_string(out).unwrap()
    };
    assert_eq!(written("a.pers"), "2 0 0 inf\n2 1 1 2\n");
    assert_eq!(
        written("a.txt"),
        "persistence intervals in dim 0:\n [0, )\npersistence intervals in dim 1:\n [1,2)\npersistence intervals in dim 2:\n"
    );
    assert!(written("a.csv").starts_with("degree,birth,death,birth_cell,death_cell\n0,0,inf,0,\n1,1,2,"));
    let object: Value = serde_json::from_str(&written("a.json")).unwrap();
    assert_eq!(intervals(&object).len(), 2);
}

#[test]
fn functions_and_values_from_files() {
    let (_folder, paths) = folder_with(&[
        ("rim.json", "[[0,1],[1,2],[0,2]]"),
        ("numbers.txt", "0\n5\n-1.5\n"),
        ("values.json", "[[0,0,0],[1,2,3]]"),
        ("cells.json", r#"{"cells":[[[1,0],1],[[1,2],2],[[2,0],3]]}"#),
    ]);
    let run = |option: &str, file: usize| {
        let run = coface(&["persistence", argument(&paths[0]), "--json", option, argument(&paths[file])]);
        intervals(&run.json())
    };
    assert_eq!(run("--function", 1), [(0, -1.5, None), (1, 5.0, None)]);
    assert_eq!(
        run("--values", 2),
        [(0, 0.0, None), (0, 0.0, Some(1.0)), (0, 0.0, Some(2.0)), (1, 3.0, None)]
    );
    // Here vertex 2 enters with the second edge and does not live on its own.
    assert_eq!(run("--values", 3), [(0, 1.0, None), (1, 3.0, None)]);
}

#[test]
fn wrong_inputs_are_named() {
    let (folder, paths) = folder_with(&[
        ("rim.json", "[[0,1],[1,2],[0,2]]"),
        ("short.txt", "0\n5\n"),
        ("word.txt", "0\nfive\n6\n"),
        ("late.json", r#"{"values":[[0,0,4],[1,2,3]]}"#),
        ("foreign.json", r#"{"cells":[[[0,1],1],[[1,7],2]]}"#),
        ("broken.json", r#"{"values":[[0,"#),
        ("other.json", r#"{"facets":[[0,1]]}"#),
        ("part.json", r#"{"cells":[[[0,1],1]]}"#),
    ]);
    let message = |arguments: &[&str]| {
        let mut all = vec!["persistence", argument(&paths[0]), "--json"];
        all.extend(arguments);
        coface(&all).fails_with(1).to_owned()
    };
    let function = |file: usize| message(&["--function", argument(&paths[file])]);
    let values = |file: usize| message(&["--values", argument(&paths[file])]);
    assert!(function(1).contains("short.txt: 2 values for 3 vertices"), "{}", function(1));
    assert!(function(2).contains("word.txt:2: \"five\" is not a finite number"), "{}", function(2));
    assert!(message(&["--function", "z"]).contains("no positions"));
    assert!(message(&["--function", "no-such-file"]).contains("no-such-file"));
    assert!(values(3).contains("cell c1 of degree 1 enters at 2, before its face c2"), "{}", values(3));
    assert!(values(4).contains("there is no cell [1, 7] in the model"), "{}", values(4));
    assert!(values(5).contains("broken.json"), "{}", values(5));
    assert!(values(6).contains("no values of cells"), "{}", values(6));
    assert!(values(7).contains("has no value"), "{}", values(7));
    assert!(message(&["--coefficients", "z"]).contains("f2, f3"));
    let out = folder.path().join("out.docx");
    assert!(message(&["-o", argument(&out)]).contains(".pers, .txt, .csv or .json"));
    assert!(!out.exists());
    let torus = coface_reading(&["persistence", "-"], br#"{"next":[2,3,4,5,0,1]}"#);
    assert!(torus.fails_with(1).contains("zero boundary"), "{}", torus.stderr);
    for wrong in
        [&["--coefficients", "f4"][..], &["--min-persistence", "nan"], &["--values", "a", "--function", "x"]]
    {
        let mut all = vec!["persistence", argument(&paths[0])];
        all.extend(wrong);
        coface(&all).fails_with(2);
    }
}

/// On real surfaces and volumes the classes that stay are the homology over the same field.
#[test]
fn classes_that_stay_are_homology() {
    let Some(folder) = std::env::var_os("COFACE_DATA").map(PathBuf::from) else {
        println!("COFACE_DATA is not set: real files are skipped");
        return;
    };
    let mut compared = 0;
    for part in ["surfaces", "volumes"] {
        for file in std::fs::read_dir(folder.join(part)).unwrap() {
            let path = file.unwrap().path();
            let field = if compared % 2 == 0 { "f2" } else { "f3" };
            let groups = coface(&["homology", argument(&path), "--json", "--coefficients", field]);
            if groups.status != 0 {
                continue;
            }
            let groups = groups.json();
            let betti: Vec<&Value> =
                groups["homology"].as_array().unwrap().iter().map(|group| &group["betti"]).collect();
            let object = coface(&["persistence", argument(&path), "--json", "--coefficients", field]).json();
            assert_eq!(object["betti"], json!(betti), "{}", path.display());
            compared += 1;
        }
    }
    assert!(compared > 10, "{compared} files");
}
