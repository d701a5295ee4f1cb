//! `coface persistence --rips` as a user runs it.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_in, coface_reading};
use serde_json::{Value, json};
use std::path::Path;

/// Points of a hexagon of sides 1, in halves and roots of 3.
fn hexagon() -> Vec<[f64; 2]> {
    let high = 3f64.sqrt() / 2.0;
    vec![[1.0, 0.0], [0.5, high], [-0.5, high], [-1.0, 0.0], [-0.5, -high], [0.5, -high]]
}

fn distance(a: [f64; 2], b: [f64; 2]) -> f64 {
    let squares = (a[0] - b[0]) * (a[0] - b[0]) + (a[1] - b[1]) * (a[1] - b[1]);
    squares.sqrt()
}

fn write(folder: &Path, name: &str, rows: impl IntoIterator<Item = Vec<f64>>, between: &str) {
    let line = |row: Vec<f64>| row.iter().map(f64::to_string).collect::<Vec<_>>().join(between);
    let text: Vec<String> = rows.into_iter().map(line).collect();
    std::fs::write(folder.join(name), text.join("\n") + "\n").unwrap();
}

fn diagram(folder: &Path, arguments: &[&str]) -> Value {
    let all = [&["persistence"], arguments, &["--rips", "--dimension", "2", "--json"]].concat();
    coface_in(folder, &all).json()
}

#[test]
fn points_and_all_tables_of_distances_have_one_diagram() {
    let folder = tempfile::tempdir().unwrap();
    let (place, points) = (folder.path(), hexagon());
    let row = |i: usize, others: std::ops::Range<usize>| -> Vec<f64> {
        others.map(|j| distance(points[i], points[j])).collect()
    };
    write(place, "a.csv", points.iter().map(|p| p.to_vec()), ",");
    write(place, "a.txt", points.iter().map(|p| p.to_vec()), " ");
    write(place, "a.xyz", points.iter().map(|p| vec![p[0], p[1], 0.0]), " ");
    write(place, "square.csv", (0..6).map(|i| row(i, 0..6)), ",");
    write(place, "lower.csv", (1..6).map(|i| row(i, 0..i)), ",");
    write(place, "a.lower_distance_matrix", (1..6).map(|i| row(i, 0..i)), ",");
    write(place, "upper.csv", (0..5).map(|i| row(i, i + 1..6)), ",");
    let list = (0..6).flat_map(|i| (0..i).map(move |j| (i, j)));
    let list = list.map(|(i, j)| vec![i as f64, j as f64, distance(points[i], points[j])]);
    write(place, "list.txt", list, " ");
    let first = diagram(place, &["a.csv"]);
    // Six edges close the hexagon at 1 and triangles of the second distances fill it; at the enclosing radius all is one simplex.
    let of_degree = |degree: u64| -> Vec<(f64, Option<f64>)> {
        let pairs =
            first["diagram"].as_array().unwrap().iter().filter(|pair| pair["degree"] == json!(degree));
        pairs.map(|pair| (pair["birth"].as_f64().unwrap(), pair["death"].as_f64())).collect()
    };
    assert_eq!(of_degree(0).len(), 6);
    let [(birth, Some(death))] = of_degree(1)[..] else { panic!("{first}") };
    assert!((birth - 1.0).abs() < 1e-15 && (death - 3f64.sqrt()).abs() < 1e-15, "{birth} {death}");
    // The octahedron of the two nearer distances, a sphere, is filled by the diagonals.
    let [(birth, Some(death))] = of_degree(2)[..] else { panic!("{first}") };
    assert!((birth - 3f64.sqrt()).abs() < 1e-15 && (death - 2.0).abs() < 1e-15, "{birth} {death}");
    assert_eq!((&first["function"], &first["star"]), (&json!("vietoris-rips"), &json!(null)));
    let others: [&[&str]; 8] = [
        &["a.txt"],
        &["a.xyz"],
        &["square.csv", "--distances", "square"],
        &["square.csv"],
        &["lower.csv", "--distances", "lower"],
        &["a.lower_distance_matrix"],
        &["upper.csv", "--distances", "upper"],
        &["list.txt", "--distances", "sparse"],
    ];
    for other in others {
        assert_eq!(diagram(place, other)["diagram"], first["diagram"], "{other:?}");
    }
    for coefficients in ["3", "f3"] {
        let other = diagram(place, &["a.csv", "--coefficients", coefficients]);
        assert_eq!((&other["diagram"], &other["field"]), (&first["diagram"], &json!(3)));
    }
    let short = diagram(place, &["a.csv", "--threshold", "1.5"]);
    assert_eq!((&short["betti"], &short["threshold"]), (&json!([1, 1, 0]), &json!(1.5)));
    // What is written has the classes too.
    let run = coface_in(place, &["persistence", "a.csv", "--rips", "-o", "a.pers"]);
    assert_eq!((run.status, run.stdout.as_str()), (0, ""), "{}", run.stderr);
    assert_eq!(std::fs::read_to_string(place.join("a.pers")).unwrap().lines().count(), 7);
}

/// Points at 0, 1 and 2 by their distances, which nobody has to say; or three points in space.
#[test]
fn a_table_that_looks_like_distances_has_distances() {
    let table = b"0 1 2\n1 0 1\n2 1 0\n";
    let deaths = |options: &[&str]| {
        let run = coface_reading(&[&["persistence", "-", "--rips", "--json"], options].concat(), table);
        let deaths: Vec<Option<f64>> =
            run.json()["diagram"].as_array().unwrap().iter().map(|pair| pair["death"].as_f64()).collect();
        (deaths, run.stderr.contains("--distances points"))
    };
    assert_eq!(deaths(&[]), (vec![None, Some(1.0), Some(1.0)], true));
    assert_eq!(deaths(&["--distances", "square"]), (vec![None, Some(1.0), Some(1.0)], false));
    let [side, long] = [3f64.sqrt(), 8f64.sqrt()];
    assert!(side < long);
    assert_eq!(deaths(&["--distances", "points"]), (vec![None, Some(side), Some(side)], false));
}

#[test]
fn a_series_by_delays() {
    let folder = tempfile::tempdir().unwrap();
    let wave = |t: usize| vec![(t as f64 * std::f64::consts::TAU / 24.0).sin()];
    write(folder.path(), "wave.csv", (0..72).map(wave), ",");
    let arguments = ["wave.csv", "--delay", "6", "--min-persistence", "0.5"];
    let object = diagram(folder.path(), &arguments);
    // The circle of (sin t, cos t).
    let loops: Vec<&Value> =
        object["diagram"].as_array().unwrap().iter().filter(|pair| pair["degree"] == json!(1)).collect();
    assert_eq!(loops.len(), 1, "{object}");
    let run = coface_in(folder.path(), &["persistence", "wave.csv", "--rips", "--delay", "80"]);
    assert!(run.fails_with(1).contains("no 2 values that are 80 apart"), "{}", run.stderr);
}

#[test]
fn nothing_and_one_point() {
    let empty = coface_reading(&["persistence", "-", "--rips", "--json"], b"");
    assert!(empty.fails_with(1).contains("there is no point"), "{}", empty.stderr);
    let one = coface_reading(&["persistence", "-", "--rips", "--json"], b"1 2 3\n").json();
    assert_eq!(one["betti"], json!([1, 0]));
    // Points that are equal are joined at once.
    let twice = coface_reading(&["persistence", "-", "--rips", "--json"], b"1 2 3\n1 2 3\n").json();
    assert_eq!(twice["diagram"].as_array().unwrap().len(), 1);
}

#[test]
fn wrong_tables_are_named_by_their_lines() {
    let folder = tempfile::tempdir().unwrap();
    let message = |text: &str, options: &[&str]| {
        let path = folder.path().join("a.csv");
        std::fs::write(&path, text).unwrap();
        let all = [&["persistence", argument(&path), "--rips"], options].concat();
        coface(&all).fails_with(1).to_owned()
    };
    for (text, options, said) in [
        ("0 0\n1\n", &[][..], "a.csv:2: point 1 has 1 coordinate, and point 0 has 2"),
        ("0 0\n1 nan\n", &[], "a.csv:2: "),
        ("0 0\n1 x\n", &[], "a.csv:2: "),
        ("0 1\n2 0\n", &["--distances", "square"], "row 1 says that point 0 is at 2, row 0 says 1"),
        ("1 2\n", &["--distances", "lower"], "3 points have 3 pairs"),
        ("0 1 -2\n", &["--distances", "sparse"], "-2"),
        ("0 1.5 2\n", &["--distances", "sparse"], "1.5 is no point"),
        ("0 0\n1 0\n", &["--coefficients", "4"], "no prime field of 4 elements"),
    ] {
        let all = match options {
            ["--coefficients", _] => {
                let path = folder.path().join("a.csv");
                coface(&[&["persistence", argument(&path), "--rips"], options].concat())
                    .fails_with(2)
                    .to_owned()
            }
            _ => message(text, options),
        };
        assert!(all.contains(said), "{text:?} {options:?}: {all}");
    }
    let path = folder.path().join("a.csv");
    // A function on the vertices of the complex.
    assert_eq!(coface(&["persistence", argument(&path), "--rips", "--function", "x"]).status, 0);
    coface(&["persistence", argument(&path), "--dimension", "2"]).fails_with(2);
}

#[test]
fn memory_is_foretold_with_a_threshold_that_fits() {
    let folder = tempfile::tempdir().unwrap();
    let point = |i: usize| vec![((i * 37) % 101) as f64, ((i * 53) % 103) as f64, ((i * 71) % 107) as f64];
    write(folder.path(), "many.csv", (0..400).map(point), ",");
    let ask = |more: &[&str]| {
        let all =
            [&["persistence", "many.csv", "--rips", "--dimension", "3", "--memory", "32M"], more].concat();
        coface_in(folder.path(), &all)
    };
    let run = ask(&[]);
    let said = run.fails_with(1);
    assert!(said.contains("400 + ") && said.contains("of memory"), "{said}");
    let threshold = said.split("(--threshold ").nth(1).and_then(|rest| rest.split(')').next()).unwrap();
    let run = ask(&["--threshold", threshold]);
    assert_eq!(run.status, 0, "{}", run.stderr);
}

/// Tables of other people have names in front, and labels or dates beside the numbers.
#[test]
fn columns_of_words_are_left_out_with_a_remark() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    let numbers = ["0,0", "2,0", "2,2", "0,2.5"];
    let table = |row: &dyn Fn(&str) -> String| numbers.map(row).join("\n");
    std::fs::write(place.join("plain.csv"), table(&|row| row.to_owned())).unwrap();
    let labelled = table(&|row| format!("{row},setosa"));
    std::fs::write(place.join("labelled.csv"), format!("length,width,species\n{labelled}\n")).unwrap();
    std::fs::write(place.join("dated.csv"), table(&|row| format!("2026-11-29,{row}"))).unwrap();
    for kind in [&["--rips"][..], &["--alpha"], &["--cech"], &["--landmarks", "3"]] {
        let diagram = |name: &str| {
            let mut answer = coface_in(place, &[&["persistence", name, "--json"], kind].concat()).json();
            let remarks = answer["remarks"].take();
            (answer["diagram"].take(), remarks)
        };
        let (plain, none) = diagram("plain.csv");
        assert!(!none.to_string().contains("data-left-out"), "{none}");
        for name in ["labelled.csv", "dated.csv"] {
            let (found, remarks) = diagram(name);
            assert_eq!(found, plain, "{name} {kind:?}");
            assert!(
                remarks.to_string().contains("a column of words is left out"),
                "{name} {kind:?}: {remarks}"
            );
        }
    }
    for (text, fault) in [
        ("0,0,a\n1,1,2\n", "mixed.csv:2: \"2\" is a number, and the column begins with a word"),
        ("0,0,a\n1,1,\n", "mixed.csv:2: a line has 2 entries, and the first has 3"),
    ] {
        std::fs::write(place.join("mixed.csv"), text).unwrap();
        for options in [&["persistence", "mixed.csv", "--rips"][..], &["info", "mixed.csv"]] {
            let said = coface_in(place, options).fails_with(1).to_owned();
            assert!(said.contains(fault), "{said}");
        }
    }
}

/// The Betti numbers in a report.
fn betti(report: &Value) -> Vec<u64> {
    let groups = report["homology"].as_array().unwrap().iter();
    groups.map(|group| group["betti"].as_u64().unwrap()).collect()
}

/// A crystal whose atoms are at the corners and centers of cubes: all tetrahedra between them are alike.
#[test]
fn points_that_repeat_are_a_torus() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    write(place, "crystal.csv", [vec![0.0, 0.0, 0.0], vec![1.0, 1.0, 1.0]], ",");
    let ask = |words: &[&str]| coface_in(place, &[words, &["--periods", "2,2,2", "--json"]].concat()).json();
    let answer = ask(&["persistence", "crystal.csv", "--alpha"]);
    assert_eq!(answer["betti"], json!([1, 3, 3, 1]));
    let merged = &answer["diagram"][1];
    assert_eq!([&merged["death"], &merged["death_cell"]], [&json!(0.75), &json!([0, 1])]);
    let last = answer["diagram"].as_array().unwrap().last().unwrap();
    assert_eq!([&last["birth"], &last["degree"]], [&json!(1.25), &json!(3)]);
    assert_eq!(
        ask(&["persistence", "crystal.csv", "--alpha", "--radii"])["diagram"][1]["death"],
        0.75f64.sqrt()
    );
    // At the value where atoms touch.
    assert_eq!(ask(&["info", "crystal.csv", "--alpha", "0.75"])["f_vector"], json!([2, 8]));
    let many =
        (0..300).map(|i| vec![f64::from(i * 37 % 101), f64::from(i * 53 % 103), f64::from(i * 71 % 107)]);
    write(place, "many.csv", many, ",");
    let run =
        coface_in(place, &["convert", "many.csv", "--alpha", "--periods", "101,103,107", "-o", "many.json"]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    let torus = coface_in(place, &["info", "many.json", "--json"]).json();
    assert_eq!((&torus["f_vector"][0], betti(&torus)), (&json!(300), vec![1, 3, 3, 1]));
    for (words, fault) in [
        (
            &["--alpha", "--periods", "1,2"][..],
            "points of 3 coordinates in a periodic box of 2 sides; give one length",
        ),
        (&["--alpha", "--periods", "1,2,0"], "a side of a periodic box is 0; give positive lengths"),
        (&["--rips", "--periods", "1,2,3"], "--periods"),
    ] {
        let run = coface_in(place, &[&["info", "crystal.csv"], words].concat());
        assert!(run.status > 0 && run.stderr.contains(fault), "{}", run.stderr);
    }
}

#[test]
fn mapper_of_a_circle_is_a_circle() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    let circle = |i: u32| {
        let (y, x) = (f64::from(i) * std::f64::consts::TAU / 60.0).sin_cos();
        vec![x, y, 10.0 * y]
    };
    write(place, "circle.csv", (0..60).map(circle), ",");
    let ask = |words: &[&str]| coface_in(place, &[words, &["--mapper", "4", "--json"]].concat()).json();
    let answer = ask(&["info", "circle.csv", "--lens", "last", "--threshold", "0.2"]);
    assert_eq!((&answer["f_vector"], betti(&answer)), (&json!([6, 6]), vec![1, 1]));
    let answer = ask(&["info", "circle.csv", "--lens", "y", "--overlap", "0.5"]);
    assert_eq!(betti(&answer), [1, 1]);
    assert!(answer["remarks"].to_string().contains("the least distance at which all are connected"));
    let answer = ask(&["persistence", "circle.csv", "--lens", "1", "--threshold", "1.2"]);
    assert_eq!(answer["betti"], json!([1, 1]));
    assert!((answer["diagram"][0]["birth"].as_f64().unwrap() + 0.83).abs() < 0.1, "{answer}");
    let run = coface_in(
        place,
        &["convert", "circle.csv", "--mapper", "4", "--lens", "y", "--threshold", "1.2", "-o", "graph.vtk"],
    );
    assert_eq!(run.status, 0, "{}", run.stderr);
    assert_eq!(coface_in(place, &["info", "graph.vtk", "--json"]).json()["f_vector"], json!([6, 6]));
    // Many intervals over each point: a nerve of high dimension, which has no place in space.
    let large = coface_in(
        place,
        &[
            "info",
            "circle.csv",
            "--mapper",
            "10",
            "--overlap",
            "0.9",
            "--threshold",
            "1.2",
            "--lens",
            "y",
            "--json",
        ],
    );
    let large = large.json();
    assert_eq!(large["components"], 1);
    assert!(large["dimension"].as_u64() > Some(3), "{large}");
    let run = coface_in(place, &["shard", "circle.csv", "--mapper", "4", "--parts", "2", "-o", "parts"]);
    assert!(run.fails_with(1).contains("coface convert INPUT --mapper N -o COMPLEX.json"));
    for (words, status, fault) in [
        (&["--mapper", "4", "--lens", "3"][..], 1, "points of 3 coordinates have no coordinate 3"),
        (
            &["--mapper", "4", "--lens", "w"],
            2,
            "give x, y, z, the number of a coordinate, last or eccentricity",
        ),
        (&["--mapper", "4", "--overlap", "1"], 2, "give a number from 0 to 0.9"),
        (&["--mapper", "0"], 2, "0"),
        (&["--mapper", "4", "--threshold", "-1"], 1, "distances are not negative"),
    ] {
        assert!(
            coface_in(place, &[&["info", "circle.csv"], words].concat()).fails_with(status).contains(fault),
            "{words:?}"
        );
    }
}
