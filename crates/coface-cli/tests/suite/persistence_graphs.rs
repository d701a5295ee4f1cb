//! `coface persistence --flag` as a user runs it.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{coface, coface_in, coface_reading};
use serde_json::{Value, json};

fn ask(text: &str, more: &[&str]) -> Value {
    let all = [&["persistence", "-", "--flag", "--json"], more].concat();
    coface_reading(&all, text.as_bytes()).json()
}

/// The cycle of four vertices with a diagonal that comes later, and a vertex by itself.
const GRAPH: &str = "u,v,value\n10,20,1\n20,30,2\n30,40,3\n40,10,4\n10,30,6\n7\n20,20,0.5\n";

#[test]
fn a_cycle_is_filled_by_its_diagonal() {
    let object = ask(GRAPH, &[]);
    let pairs = object["diagram"].as_array().unwrap();
    let hole = pairs.last().unwrap();
    assert_eq!((&hole["birth"], &hole["death"]), (&json!(4.0), &json!(6.0)));
    assert_eq!(hole["birth_cell"], json!([10, 40]));
    assert_eq!((&object["betti"], &object["function"]), (&json!([2, 0]), &json!("flag complex")));
    assert!(
        pairs.iter().any(|pair| pair["birth"] == json!(0.5) && pair["birth_cell"] == json!([20])),
        "{object}"
    );
    assert_eq!(ask(GRAPH, &["--threshold", "5"])["betti"], json!([2, 1]));
    assert_eq!(ask(GRAPH, &["--dimension", "2", "--coefficients", "3"])["betti"], json!([2, 0, 0]));
    // Edges without values enter at 1.
    assert_eq!(ask("0 1\n1 2\n2 0\n2 3\n", &[])["betti"], json!([1, 0]));
    assert_eq!(ask("", &[])["betti"], json!([0, 0]));
}

/// The flag complex of all distances is the Vietoris-Rips filtration.
#[test]
fn distances_are_a_graph() {
    let folder = tempfile::tempdir().unwrap();
    let number = |i: usize, j: usize| ((i * 37 + j * 91) % 53 + 1) as f64;
    let list: String =
        (0..12).flat_map(|i| (0..i).map(move |j| format!("{i} {j} {}\n", number(i, j)))).collect();
    std::fs::write(folder.path().join("list.txt"), list).unwrap();
    let run = |option: &[&str]| {
        let all = [&["persistence", "list.txt", "--json", "--dimension", "2", "--threshold", "60"], option]
            .concat();
        coface_in(folder.path(), &all).json()["diagram"].clone()
    };
    assert_eq!(run(&["--flag"]), run(&["--rips", "--distances", "sparse"]));
}

/// The matrices of Matrix Market: vertices count from 1 there, and the line of counts is no edge.
#[test]
fn a_sparse_matrix_is_a_graph_or_has_distances() {
    let folder = tempfile::tempdir().unwrap();
    let banner = "%%MatrixMarket matrix coordinate real";
    let cycle = "% a cycle of four, with a diagonal, and a point by itself\n5 5 5\n2 1 1\n3 2 2\n4 3 3\n4 1 4\n3 1 6\n";
    std::fs::write(folder.path().join("cycle.mtx"), format!("{banner} symmetric\n{cycle}")).unwrap();
    std::fs::write(folder.path().join("list.txt"), "1 0 1\n2 1 2\n3 2 3\n3 0 4\n2 0 6\n4\n").unwrap();
    let run = |words: &[&str]| {
        coface_in(folder.path(), &[&["persistence"], words, &["--json"]].concat()).json()["diagram"].clone()
    };
    assert_eq!(run(&["cycle.mtx", "--flag"]), run(&["list.txt", "--flag"]));
    // Blanks or a mark before the first line, and other letters, change nothing: the line of counts is never an edge.
    for before in ["  ", "\u{feff}", "\u{feff} "] {
        let text = format!("{before}{} SYMMETRIC\n{cycle}", banner.to_uppercase());
        std::fs::write(folder.path().join("other.mtx"), text).unwrap();
        assert_eq!(run(&["other.mtx", "--flag"]), run(&["list.txt", "--flag"]), "{before:?}");
        assert_eq!(run(&["other.mtx", "--rips"]), run(&["cycle.mtx", "--rips"]), "{before:?}");
    }
    let all = ["--threshold", "9"];
    let rips = run(&[&["cycle.mtx", "--rips"], &all[..]].concat());
    let holes: Vec<_> = rips.as_array().unwrap().iter().filter(|pair| pair["degree"] == json!(1)).collect();
    assert_eq!((holes.len(), &holes[0]["birth"], &holes[0]["death"]), (1, &json!(4.0), &json!(6.0)));
    let essential = rips.as_array().unwrap().iter().filter(|pair| pair["death"].is_null()).count();
    assert_eq!(essential, 2, "the point by itself is there: {rips}");
    // A pattern has edges without values; in a general matrix an entry leads one way.
    let loops = "%%MatrixMarket matrix coordinate pattern general\n3 3 4\n1 2\n2 3\n3 1\n2 1\n";
    assert_eq!(
        ask(loops, &["--directed"])["betti"],
        json!([1, 1]),
        "of two loops the edges 2 3, 3 1 and 2 1 bound a triangle"
    );
    assert_eq!(ask(loops, &[])["betti"], json!([1, 0]));
    let said = |text: &str, option: &str| {
        coface_reading(&["persistence", "-", option], text.as_bytes()).fails_with(1).to_owned()
    };
    assert!(
        said(&format!("{banner} general\n3 3 1\n4 1 2\n"), "--flag")
            .contains("standard input:3: the row is 4")
    );
    assert!(said(&format!("{banner} general\n2 3 1\n1 1 2\n"), "--rips").contains("2 rows and 3 columns"));
    assert!(said(loops, "--rips").contains("standard input:3: a pattern has no distances"));
}

#[test]
fn wrong_graphs_are_named_by_their_lines() {
    let said = |text: &str| {
        coface_reading(&["persistence", "-", "--flag"], text.as_bytes()).fails_with(1).to_owned()
    };
    assert!(said("0 1 2\n0 1.5 2\n").contains("standard input:2: \"1.5\" is no vertex"));
    assert!(said("0 1 2 3\n").contains("the row has 4 entries, not 3"));
    assert!(said("0 1 two\n").contains("standard input:1: \"two\" is not a number"));
    assert!(said("0 0 1\n0 0 2\n").contains("standard input:2: vertex 0 has two values, 1 and 2"));
    assert!(
        said("7 7 3\n7 9 2\n")
            .contains("standard input:2: the edge of 7 and 9 enters at 2, before vertex 7, at 3")
    );
    assert!(said("0 1 2\n0 1 inf\n").contains("standard input:2: the value of the edge from 0 to 1 is inf"));
    assert!(said("a b nan\n").contains("the value of the edge from \"a\" to \"b\" is NaN"));
    coface(&["persistence", "a.csv", "--flag", "--rips"]).fails_with(2);
    coface(&["persistence", "a.csv", "--flag", "--distances", "sparse"]).fails_with(2);
}

#[test]
fn of_two_values_the_smaller_one_is_taken() {
    let run =
        coface_reading(&["persistence", "-", "--flag", "--json"], b"7 9 3\n9 7 2\n7 9 2\n1 9 4\n9 1 4\n");
    assert_eq!(run.json()["diagram"][2]["death"], json!(2.0), "{}", run.stderr);
    assert!(run.stderr.contains("1 edge is given again with another value"), "{}", run.stderr);
    coface_reading(&["persistence", "-", "--flag", "--strict"], b"7 9 3\n9 7 2\n").fails_with(1);
}

#[test]
fn vertices_have_numbers_or_names() {
    let object =
        ask("source;target;color;weight\nBern;\"St. Gallen\";red;3\n\"St. Gallen\";Chur;blue;5\n", &[]);
    assert_eq!(object["vertex_names"], json!(["Bern", "St. Gallen", "Chur"]));
    assert_eq!(object["diagram"][2]["death"], json!(5.0));
    let page = coface_reading(&["persistence", "-", "--flag"], b"Bern Thun 3\n").stdout;
    assert!(
        page.contains("from [Thun] to [Bern, Thun]") || page.contains("from [Thun] to [Thun, Bern]"),
        "{page}"
    );
    // Of flagser, and with comments of others.
    let object = ask("dim 0:\n0 0.5 1\ndim 1:\n0 1 2\n1 2 3\n", &[]);
    assert_eq!(object["diagram"][1]["birth"], json!(0.5));
    assert_eq!(ask("% sym\n# a graph\n// again\n3,4\n", &[])["betti"], json!([1, 0]));
}

const GRAPHML: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<graphml xmlns="http://graphml.graphdrawing.org/xmlns">
  <key id="d0" for="edge" attr.name="weight" attr.type="double"><default>1.5</default></key>
  <key id="d1" for="node" attr.name="weight" attr.type="double"/>
  <graph edgedefault="undirected">
    <node id="a"><data key="d1">0.5</data></node>
    <node id="b"/>
    <node id="c"/>
    <edge source="a" target="b"><data key="d0">2</data></edge>
    <edge source="b" target="c"/>
    <edge source="c" target="a"><data key="d0">4</data></edge>
    <edge source="c" target="c"/>
  </graph>
</graphml>
"#;

#[test]
fn graphs_of_graphml_have_weights_and_names() {
    let run = coface_reading(&["persistence", "-", "--flag", "--json"], GRAPHML.as_bytes());
    let object = run.json();
    assert_eq!(object["vertex_names"], json!(["a", "b", "c"]));
    let births: Vec<f64> =
        object["diagram"].as_array().unwrap().iter().filter_map(|pair| pair["birth"].as_f64()).collect();
    assert!(births.contains(&0.5), "{object}");
    assert!(object["diagram"].as_array().unwrap().iter().any(|pair| pair["death"] == json!(1.5)), "{object}");
    assert!(run.stderr.contains("1 edge of a vertex with itself was left out"), "{}", run.stderr);
    let said = |from: &str, to: &str| {
        let text = GRAPHML.replacen(from, to, 1);
        coface_reading(&["persistence", "-", "--flag"], text.as_bytes()).fails_with(1).to_owned()
    };
    assert!(
        said("<data key=\"d0\">2<", "<data key=\"d0\">two<")
            .contains("standard input:9: the weight \"two\" is no number")
    );
    assert!(
        said("target=\"b\"", "target=\"z\"")
            .contains("the target of an edge is \"z\", and no node has this id")
    );
    assert!(said(">2<", ">NaN<").contains("the value of the edge from \"a\" to \"b\" is NaN"));
    assert!(said("</graphml>", "").contains("no XML"));
    let text = GRAPHML.replace("graphml", "svg");
    assert!(
        coface_reading(&["persistence", "-", "--flag"], text.as_bytes())
            .fails_with(1)
            .contains("not a graph")
    );
}

#[test]
fn graphs_and_points_are_models_at_a_scale() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    std::fs::write(place.join("graph.txt"), GRAPH).unwrap();
    std::fs::write(place.join("points.csv"), "0,0\n3,0\n3,4\n0,4\n").unwrap();
    std::fs::write(place.join("line.lower_distance_matrix"), "3\n5 4\n").unwrap();
    let info =
        |words: &[&str]| coface_in(place, &[&["info", "--json"], words].concat()).json()["f_vector"].clone();
    assert_eq!(info(&["graph.txt", "--flag"]), json!([5, 5, 2]));
    // A picture is not looked for in a text file.
    assert_eq!(coface_in(place, &["render", "graph.txt", "--flag", "-o", "graph.svg"]).status, 0);
    assert_eq!(info(&["graph.txt", "--flag", "--threshold", "4"]), json!([5, 4]));
    assert_eq!(info(&["points.csv", "--rips", "--threshold", "4"]), json!([4, 4]));
    assert_eq!(info(&["points.csv", "--rips", "--dimension", "1"]), json!([4, 6]));
    assert_eq!(info(&["points.csv", "--rips", "--dimension", "3"]), json!([4, 6, 4, 1]));
    assert_eq!(info(&["points.csv", "--cech", "--threshold", "2"]), json!([4, 4]));
    assert_eq!(info(&["line.lower_distance_matrix", "--rips", "--threshold", "4"]), json!([3, 2]));
    let line = ["homology", "points.csv", "--rips", "--threshold", "4", "--generators", "--json"];
    let found = coface_in(place, &line).json();
    assert_eq!(found["homology"][1]["betti"], json!(1), "{found}");
    for option in ["--rips", "--cech"] {
        let line = ["convert", "points.csv", option, "--threshold", "4.5", "-o", "x.json"];
        assert_eq!(coface_in(place, &line).status, 0);
        assert_eq!(info(&["x.json"]), info(&["points.csv", option, "--threshold", "4.5"]));
    }
    // The verb has an option of this name.
    let line = ["skeleton", "points.csv", "--rips", "--points-dimension", "3", "--dimension", "1", "--json"];
    assert_eq!(coface_in(place, &line).status, 0);
    let said = coface_in(place, &["homology", "points.csv", "--rips"]).stderr;
    assert!(said.contains("simplices up to dimension 2 were taken"), "{said}");
    coface_in(place, &["info", "points.csv", "--rips", "--threshold", "-1"]).fails_with(1);
    coface_in(place, &["info", "points.csv", "--rips", "--flag"]).fails_with(2);
}

#[test]
fn directed_cycles_are_loops() {
    let line = ["persistence", "-", "--flag", "--directed", "--json"];
    let object = coface_reading(&line, b"7 9 1\n9 7 2\n").json();
    assert_eq!(object["betti"], json!([1, 1]));
    assert_eq!(object["diagram"][2]["birth_cell"], json!([9, 7]));
    let both = "a b\na c\nb a\nb c\nc a\nc b\n";
    let line = ["homology", "-", "--flag", "--directed", "--dimension", "3", "--json"];
    let found = coface_reading(&line, both.as_bytes()).json();
    let betti: Vec<_> =
        found["homology"].as_array().unwrap().iter().map(|group| group["betti"].clone()).collect();
    assert_eq!(betti, [json!(1), json!(0), json!(2)]);
    let text = GRAPHML.replace("undirected", "directed");
    let run = coface_reading(&["persistence", "-", "--flag"], text.as_bytes());
    assert!(run.stderr.contains("--directed"), "{}", run.stderr);
    coface(&["persistence", "a.csv", "--directed"]).fails_with(2);
}

#[test]
fn sizes_are_foretold_with_a_threshold_that_fits() {
    let folder = tempfile::tempdir().unwrap();
    let point = |i: usize| format!("{},{},{}\n", i * 37 % 101, i * 53 % 103, i * 71 % 107);
    std::fs::write(folder.path().join("many.csv"), (0..600).map(point).collect::<String>()).unwrap();
    let edge = |i: usize, j: usize| format!("{i},{j},{}\n", (i * 37 + j * 91) % 997);
    let edges = (0..120).flat_map(|i| (0..120).filter(move |&j| i != j).map(move |j| (i, j)));
    std::fs::write(folder.path().join("graph.csv"), edges.map(|(i, j)| edge(i, j)).collect::<String>())
        .unwrap();
    for options in
        [&["many.csv", "--rips"][..], &["many.csv", "--cech"], &["graph.csv", "--flag", "--directed"]]
    {
        let line = [&["convert", "-o", "x.json", "--memory", "40M", "--dimension", "2"], options].concat();
        let run = coface_in(folder.path(), &line);
        let said = run.fails_with(1).to_owned();
        let word =
            |before: &str| said.split(before).nth(1).and_then(|rest| rest.split([' ', ')']).next()).unwrap();
        let again = coface_in(folder.path(), &[&line[..], &["--threshold", word("--threshold ")]].concat());
        assert_eq!(again.status, 0, "{said}: {}", again.stderr);
        let counts = coface_in(folder.path(), &["info", "x.json", "--json"]).json()["f_vector"].clone();
        let count: u64 = counts.as_array().unwrap().iter().map(|count| count.as_u64().unwrap()).sum();
        let most: u64 = word("more than ").parse().unwrap();
        assert!((most / 10..=most).contains(&count), "{said}: {counts}");
    }
}

#[test]
fn landmarks_have_witnesses() {
    let folder = tempfile::tempdir().unwrap();
    let point = |i: usize| {
        let angle = i as f64 * std::f64::consts::TAU / 60.0;
        format!("{},{}\n", angle.cos(), angle.sin())
    };
    std::fs::write(folder.path().join("circle.csv"), (0..60).map(point).collect::<String>()).unwrap();
    let ask = |words: &[&str]| {
        coface_in(folder.path(), &[&["persistence", "circle.csv", "--json"], words].concat()).json()
    };
    let object = ask(&["--landmarks", "8", "--threshold", "0.1"]);
    assert_eq!(object["betti"], json!([1, 1]));
    assert_eq!(object["function"], json!("squared distances of the witness complex"));
    assert_eq!(
        ask(&["--landmarks", "8", "--threshold", "0", "--strong", "--dimension", "0"])["betti"],
        json!([8])
    );
    let line = ["info", "circle.csv", "--landmarks", "8", "--threshold", "0", "--json"];
    assert_eq!(coface_in(folder.path(), &line).json()["f_vector"], json!([8, 8]));
    coface_in(folder.path(), &["info", "circle.csv", "--strong"]).fails_with(2);
}

/// Both are nerves of balls.
#[test]
fn diagrams_of_alpha_and_cech_complexes_are_near() {
    let folder = tempfile::tempdir().unwrap();
    let point = |i: usize| format!("{},{}\n", i * 37 % 101, i * 53 % 103);
    std::fs::write(folder.path().join("a.csv"), (0..25).map(point).collect::<String>()).unwrap();
    let ask = |more: &[&str]| {
        let object = coface_in(
            folder.path(),
            &[&["persistence", "a.csv", "--json", "--min-persistence", "1e-9"], more].concat(),
        )
        .json();
        let mut classes: Vec<[f64; 3]> = object["diagram"]
            .as_array()
            .unwrap()
            .iter()
            .filter(|pair| pair["degree"] != json!(2))
            .map(|pair| {
                [
                    pair["degree"].as_f64().unwrap(),
                    pair["birth"].as_f64().unwrap(),
                    pair["death"].as_f64().unwrap_or(1e9),
                ]
            })
            .collect();
        classes.sort_by(|a, b| a.partial_cmp(b).unwrap());
        classes
    };
    let (cech, alpha) = (ask(&["--cech"]), ask(&["--alpha", "--radii"]));
    assert_eq!(cech.len(), alpha.len());
    let near = |a: &[f64; 3], b: &[f64; 3]| a.iter().zip(b).all(|(x, y)| (x - y).abs() <= 1e-9);
    assert!(cech.iter().zip(&alpha).all(|(a, b)| near(a, b)), "{cech:?} {alpha:?}");
}
