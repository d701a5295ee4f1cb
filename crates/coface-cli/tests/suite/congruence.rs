//! `coface congruence`: counts, classes, what is written, and what is refused.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a test says what it skips")]

use crate::program::{argument, coface};
use serde_json::{Value, json};
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

/// A file of this name with this text in a folder of its own.
fn file(folder: &tempfile::TempDir, name: &str, text: &str) -> PathBuf {
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    path
}

fn merged(input: &Path, tolerance: &str, options: &[&str]) -> Value {
    let mut arguments = vec!["congruence", argument(input), "--tolerance", tolerance, "--json"];
    arguments.extend_from_slice(options);
    coface(&arguments).json()
}

/// Unit cubes in a grid of k by k by k, every square of every cube by itself, coordinates off by up to 1e-8.
fn separate_cubes(k: usize) -> String {
    const SQUARES: [[usize; 4]; 6] =
        [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let mut state: u64 = 7;
    let mut noise = || {
        state = state.wrapping_mul(0x5851_f42d_4c95_7f2d).wrapping_add(0x1405_7b7e_f767_814f);
        ((state >> 11) as f64 / (1u64 << 53) as f64 - 0.5) * 2e-8
    };
    let mut text = String::new();
    for cube in 0..k * k * k {
        let corner = [cube % k, cube / k % k, cube / k / k];
        for square in SQUARES {
            for vertex in square {
                let [x, y, z] = [0, 1, 2].map(|axis| (corner[axis] + (vertex >> axis & 1)) as f64 + noise());
                writeln!(text, "v {x} {y} {z}").unwrap();
            }
            text.push_str("f -4 -3 -2 -1\n");
        }
    }
    text
}

#[test]
fn separate_squares_become_a_grid_of_cubes() {
    let folder = tempfile::tempdir().unwrap();
    for k in 1..4 {
        let input = file(&folder, "cubes.obj", &separate_cubes(k));
        let n = k + 1;
        let expected = [n * n * n, 3 * k * n * n, 3 * k * k * n];
        for options in [
            &[][..],
            &["--method", "matrices"],
            &["--greedy"],
            &["--representative", "median"],
            &["--stable"],
        ] {
            let found = merged(&input, "1e-6", options);
            assert_eq!(found["f_vector"], json!(expected), "{k} {options:?}");
            assert_eq!(found["f_vector_before"], json!([24 * k * k * k, 24 * k * k * k, 6 * k * k * k]));
            assert_eq!(found["classes"], found["f_vector"]);
            assert_eq!(found["euler_characteristic"], json!(1 + k * k * k));
            assert_eq!((&found["discarded"], &found["changed"]), (&json!([0, 0, 0]), &json!([0, 0, 0])));
            assert_eq!(found["products_zero"], json!(true));
            let diameter = found["largest_class_diameter"].as_f64().unwrap();
            assert!(diameter > 1e-9 && diameter < 4e-8, "{diameter}");
        }
        let exact = merged(&input, "0", &[]);
        assert_eq!(exact["f_vector"], exact["f_vector_before"]);
    }
}

#[test]
fn recorded_examples_have_their_counts_at_all_tolerances() {
    let Some(data) = std::env::var_os("COFACE_DATA") else {
        println!("skipped: COFACE_DATA is not set");
        return;
    };
    for number in 1..4 {
        let path = Path::new(&data).join(format!("congruence/congruence_ex{number}.json"));
        let record: Value = serde_json::from_slice(&std::fs::read(&path).unwrap()).unwrap();
        let expected = record["expected"].as_object().unwrap();
        assert!(!expected.is_empty());
        for (tolerance, expected) in expected {
            let found = merged(&path, tolerance, &[]);
            let counts = json!([expected["V"], expected["E"], expected["F"]]);
            assert_eq!(found["f_vector"], counts, "{number} {tolerance}");
            assert_eq!(found["euler_characteristic"], expected["chi"]);
            assert_eq!(
                found["discarded"],
                json!([0, expected["collapsed_edges"], expected["collapsed_faces"]])
            );
            assert_eq!(found["products_zero"], json!(true));
        }
    }
}

/// Two unit squares side by side: the second runs along the common edge as the first one does.
const TWO_SQUARES: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n\
                           v 1 0 0\nv 1 1 0\nv 2 1 0\nv 2 0 0\nf 5 6 7 8\n";

#[test]
fn classes_have_members_and_signs() {
    let folder = tempfile::tempdir().unwrap();
    // The common edge as 1 -> 2 in the first, 2 -> 1 in the second square.
    let chains = r#"{"vertices":[[0,0],[1,0],[1,1],[0,1],[1,0],[1,1],[2,1],[2,0]],
        "d0":[[0,0,-1],[0,1,1],[1,1,-1],[1,2,1],[2,2,-1],[2,3,1],[3,3,-1],[3,0,1],
              [4,4,1],[4,5,-1],[5,5,1],[5,6,-1],[6,6,1],[6,7,-1],[7,7,1],[7,4,-1]],
        "d1":[[0,0,1],[0,1,1],[0,2,1],[0,3,1],[1,4,1],[1,5,1],[1,6,1],[1,7,1]]}"#;
    let input = file(&folder, "squares.json", chains);
    let classes = folder.path().join("classes.json");
    let found = merged(&input, "1e-9", &["--classes", argument(&classes)]);
    assert_eq!(found["f_vector"], json!([6, 7, 2]));
    let classes: Value = serde_json::from_slice(&std::fs::read(&classes).unwrap()).unwrap();
    let of_degree = &classes["classes"];
    assert_eq!(of_degree[0]["members"], json!([[0], [1, 4], [2, 5], [3], [6], [7]]));
    assert_eq!(of_degree[1]["members"], json!([[0], [1, 4], [2], [3], [5], [6], [7]]));
    assert_eq!(of_degree[1]["signs"][1], json!([1, -1]));
    assert_eq!(of_degree[2], json!({"degree": 2, "members": [[0], [1]], "signs": [[1], [1]]}));
}

#[test]
fn what_is_written_is_the_quotient() {
    let folder = tempfile::tempdir().unwrap();
    let input = file(&folder, "squares.obj", TWO_SQUARES);
    for name in ["out.obj", "out.off", "out.ply", "out.vtk", "out.mesh", "out.json"] {
        let out = folder.path().join(name);
        let found = merged(&input, "1e-9", &["-o", argument(&out)]);
        let info = coface(&["info", argument(&out), "--json"]).json();
        assert_eq!(info["f_vector"], found["f_vector"], "{name}");
        assert_eq!(info["f_vector"], json!([6, 7, 2]), "{name}");
        assert_eq!(info["homology"][0]["betti"], json!(1));
    }
    let cubes = file(&folder, "cube.obj", &separate_cubes(1));
    let out = folder.path().join("cube.off");
    merged(&cubes, "1e-6", &["-o", argument(&out), "--representative", "mean"]);
    let info = coface(&["info", argument(&out), "--json"]).json();
    assert_eq!((&info["name"], &info["coherently_oriented"]), (&json!("sphere"), &json!(true)));
    assert!((info["signed_volume"].as_f64().unwrap() - 1.0).abs() < 1e-7);
    // The chain complex written is read again, and nothing is left to merge.
    let out = folder.path().join("cube.json");
    merged(&cubes, "1e-6", &["-o", argument(&out)]);
    assert_eq!(merged(&out, "1e-6", &[])["f_vector_before"], json!([8, 12, 6]));
    let loops = folder.path().join("lines.obj");
    let lines = file(&folder, "l.obj", "v 0 0 0\nv 1 0 0\nv 1 1e-9 0\nv 2 0 0\nv 5 5 5\nl 1 2\nl 3 4\n");
    merged(&lines, "1e-6", &["-o", argument(&loops)]);
    assert_eq!(coface(&["info", argument(&loops), "--json"]).json()["f_vector"], json!([4, 2]));
}

#[test]
fn cells_that_lose_their_shape_are_counted() {
    let folder = tempfile::tempdir().unwrap();
    let quad = file(&folder, "quad.obj", "v 0 0 0\nv 1 0 0\nv 1 1e-7 0\nv 0 1 0\nf 1 2 3 4\n");
    let out = folder.path().join("triangle.obj");
    let found = merged(&quad, "1e-6", &["--collisions", "keep", "-o", argument(&out)]);
    assert_eq!((&found["f_vector"], &found["discarded"]), (&json!([3, 3, 1]), &json!([0, 1, 0])));
    assert_eq!((&found["changed"], &found["products_zero"]), (&json!([0, 0, 1]), &json!(true)));
    let info = coface(&["info", argument(&out), "--json"]).json();
    assert_eq!(info["top_cells"], json!([{"shape": "triangle", "count": 1}]));
    let triangle = file(&folder, "speck.obj", "v 0 0 0\nv 1e-7 0 0\nv 0 1e-7 0\nf 1 2 3\n");
    let found = merged(&triangle, "1e-6", &[]);
    assert_eq!((&found["f_vector"], &found["discarded"]), (&json!([1, 0, 0]), &json!([0, 3, 1])));
    // Two opposite corners of a hexagon come together: one pinched face, or two triangles.
    let hexagon = file(
        &folder,
        "hexagon.obj",
        "v 0 0 0\nv 2 -1 0\nv 2 1 0\nv 1e-8 0 0\nv -2 1 0\nv -2 -1 0\nf 1 2 3 4 5 6\n",
    );
    let out = folder.path().join("bow_tie.off");
    let split = merged(&hexagon, "1e-6", &["-o", argument(&out)]);
    assert_eq!((&split["f_vector"], &split["products_zero"]), (&json!([5, 6, 2]), &json!(true)));
    let info = coface(&["info", argument(&out), "--json"]).json();
    assert_eq!((&info["f_vector"], &info["area"]), (&json!([5, 6, 2]), &json!(4.0)));
    let whole = merged(&hexagon, "1e-6", &["--collisions", "keep"]);
    assert_eq!(whole["f_vector"], json!([5, 6, 1]));
    let mesh = ["--tolerance", "1e-6", "--collisions", "keep", "-o", argument(&out)];
    let mesh = coface(&[&["congruence", argument(&hexagon)], &mesh[..]].concat());
    assert!(mesh.fails_with(1).contains("face class 0 is not one simple cycle"), "{mesh:?}");
    for path in [&quad, &triangle] {
        let refused =
            coface(&["congruence", argument(path), "--tolerance", "1e-6", "--collisions", "refuse"]);
        assert!(refused.fails_with(1).contains("smaller --tolerance"), "{refused:?}");
    }
}

#[test]
fn several_files_are_taken_together() {
    let folder = tempfile::tempdir().unwrap();
    let left = file(&folder, "left.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n");
    let right = file(&folder, "right.off", "OFF\n4 1 0\n1 0 0\n2 0 0\n2 1 0\n1 1 0.0001\n4 0 1 2 3\n");
    let paths = [argument(&left), argument(&right)];
    let run = |options: &[&str]| {
        coface(&[&["congruence"], &paths[..], &["--tolerance", "0.001", "--json"], options].concat())
    };
    let found = run(&["--within-blocks", "forbid"]).json();
    assert_eq!(found["f_vector"], json!([6, 7, 2]));
    assert_eq!(
        (&found["merged_within_blocks"], &found["inputs"][1]["f_vector"]),
        (&json!(0), &json!([4, 4, 1]))
    );
    assert_eq!(found["largest_class_diameter"], json!(0.0001));
    // A tolerance above the side of the squares brings vertices of one file together.
    let wide = |options: &[&str]| {
        coface(&[&["congruence"], &paths[..], &["--tolerance", "1", "--json"], options].concat())
    };
    let message = wide(&["--within-blocks", "forbid"]).fails_with(1).to_owned();
    assert!(message.contains("left.obj: vertices v0 and v1 become one"), "{message}");
    let warned = wide(&["--within-blocks", "warn"]);
    assert!(warned.stderr.contains("1 apart"), "{warned:?}");
    let warned = warned.json();
    assert_eq!(warned["merged_within_blocks"], json!(2));
    assert_eq!(warned["block_merges"][1]["vertices"], json!([0, 1, 2, 3]));
    assert_eq!(wide(&["--blocks", "none"]).json()["merged_within_blocks"], json!(null));
    let components = wide(&["--blocks", "components", "--within-blocks", "forbid"]);
    assert!(components.fails_with(1).contains("which cells connect"));
    // The page for people names what matters.
    let page = coface(&[&["congruence"], &paths[..], &["--tolerance", "0.001"]].concat());
    assert_eq!(page.status, 0);
    assert!(page.stdout.contains("6 from 8") && page.stdout.contains("2 models"), "{}", page.stdout);
}

#[test]
fn what_cannot_be_merged_is_refused() {
    let folder = tempfile::tempdir().unwrap();
    let square = file(&folder, "square.obj", TWO_SQUARES);
    let facets = file(&folder, "facets.json", "[[0, 1, 2]]");
    let flat = file(
        &folder,
        "flat.json",
        r#"{"vertices":[[0,0],[1,0]],"boundaries":[{"rows":2,"cols":1,"entries":[[0,0,-1],[1,0,1]]}]}"#,
    );
    let bare = coface(&["congruence", argument(&facets), "--tolerance", "1"]);
    assert!(bare.fails_with(1).contains("facets.json: the model has 3 vertices, but no positions"));
    let mixed = coface(&["congruence", argument(&square), argument(&flat), "--tolerance", "1"]);
    assert!(mixed.fails_with(1).contains("flat.json: its points have 2 coordinates"));
    for tolerance in ["-1", "NaN", "inf", "x"] {
        let wrong = coface(&["congruence", argument(&square), "--tolerance", tolerance]);
        assert_eq!(wrong.status, 2, "{wrong:?}");
    }
    assert_eq!(coface(&["congruence", argument(&square)]).status, 2);
    let classes = folder.path().join("classes.csv");
    let named =
        coface(&["congruence", argument(&square), "--tolerance", "1", "--classes", argument(&classes)]);
    assert!(named.fails_with(1).contains(".json or .arrow") && !classes.exists());
    // An edge whose boundary is two vertices added is no segment of a mesh, but JSON holds it.
    let twisted = file(&folder, "twisted.json", r#"{"vertices":[[0],[1]],"d0":[[0,0,1],[0,1,1]]}"#);
    let out = folder.path().join("out.obj");
    let mesh = coface(&["congruence", argument(&twisted), "--tolerance", "0", "-o", argument(&out)]);
    assert!(mesh.fails_with(1).contains("write JSON") && !out.exists());
    let nothing = file(&folder, "nothing.json", "{\"vertices\":[],\"boundaries\":[]}");
    assert_eq!(merged(&nothing, "1", &[])["classes"], json!([0]));
}

/// Class and sign of a cell, if it has one.
#[cfg(feature = "arrow")]
type Class = Option<(u32, i8)>;

#[test]
fn two_outputs_appear_both_or_not_at_all() {
    let folder = tempfile::tempdir().unwrap();
    let input = file(&folder, "a.obj", &separate_cubes(1));
    let [mesh, classes] = ["m.off", "c.json"].map(|name| folder.path().join(name));
    let [no_mesh, no_classes] = ["none/m.off", "none/c.json"].map(|name| folder.path().join(name));
    for (mesh, classes, wrong) in [(&mesh, &no_classes, &no_classes), (&no_mesh, &classes, &no_mesh)] {
        let run = coface(&[
            "congruence",
            argument(&input),
            "--tolerance",
            "1e-6",
            "-o",
            argument(mesh),
            "--classes",
            argument(classes),
        ]);
        assert_eq!(run.status, 1);
        assert!(run.stderr.contains(&wrong.display().to_string()), "{}", run.stderr);
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1, "the input alone");
    }
    let both = ["-o", argument(&mesh), "--classes", argument(&classes)];
    assert_eq!(merged(&input, "1e-6", &both)["f_vector"], json!([8, 12, 6]));
    assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 3);
}

#[cfg(not(feature = "arrow"))]
#[test]
fn a_build_without_arrow_names_the_feature() {
    let folder = tempfile::tempdir().unwrap();
    let input = file(&folder, "a.obj", &separate_cubes(1));
    let table = folder.path().join("classes.arrow");
    let run = coface(&["congruence", argument(&input), "--tolerance", "0", "--classes", argument(&table)]);
    assert!(run.fails_with(1).contains("--features arrow") && !table.exists());
}

#[cfg(feature = "arrow")]
#[test]
fn classes_are_a_table_of_arrow() {
    use arrow_array::Array;
    use arrow_array::cast::AsArray;
    use arrow_array::types::{Int8Type, UInt8Type, UInt32Type};
    let folder = tempfile::tempdir().unwrap();
    let text = format!("{TWO_SQUARES}v 9 9 9\nv 9 9 9\nl 9 10\n");
    let input = file(&folder, "squares.obj", &text);
    let [table, list] = ["classes.arrow", "classes.json"].map(|name| folder.path().join(name));
    merged(&input, "1e-9", &["--classes", argument(&table)]);
    merged(&input, "1e-9", &["--classes", argument(&list)]);
    let mut expected: Vec<(u8, u32, Class)> = Vec::new();
    let classes: Value = serde_json::from_slice(&std::fs::read(&list).unwrap()).unwrap();
    for of_degree in classes["classes"].as_array().unwrap() {
        let degree = of_degree["degree"].as_u64().unwrap() as u8;
        for (class, members) in of_degree["members"].as_array().unwrap().iter().enumerate() {
            for (i, member) in members.as_array().unwrap().iter().enumerate() {
                let sign = of_degree["signs"][class][i].as_i64().unwrap() as i8;
                expected.push((degree, member.as_u64().unwrap() as u32, Some((class as u32, sign))));
            }
        }
    }
    // The edge from a point to itself collapses.
    expected.push((1, 8, None));
    expected.sort_unstable();
    let mut found = Vec::new();
    for batch in arrow_ipc::reader::FileReader::try_new(std::fs::File::open(&table).unwrap(), None).unwrap() {
        let batch = batch.unwrap();
        let names: Vec<&str> =
            batch.schema_ref().fields().iter().map(|field| field.name().as_str()).collect();
        assert_eq!(names, ["degree", "cell", "class", "sign"]);
        let degrees = batch.column(0).as_primitive::<UInt8Type>();
        let cells = batch.column(1).as_primitive::<UInt32Type>();
        let classes = batch.column(2).as_primitive::<UInt32Type>();
        let signs = batch.column(3).as_primitive::<Int8Type>();
        for row in 0..batch.num_rows() {
            let class = classes.is_valid(row).then(|| (classes.value(row), signs.value(row)));
            found.push((degrees.value(row), cells.value(row), class));
        }
    }
    found.sort_unstable();
    assert_eq!(found, expected);
}
