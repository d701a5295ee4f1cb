//! `coface arrange` and `coface boolean` in space, as a user runs them.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{Run, argument, coface};
use serde_json::{Value, json};
use std::fmt::Write;
use std::path::{Path, PathBuf};
use tempfile::TempDir;

type Motion = fn([f64; 3]) -> [f64; 3];

const SQUARES: [[usize; 4]; 6] =
    [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];

/// A folder for files of one test.
struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn text(&self, name: &str, text: &str) -> PathBuf {
        std::fs::write(self.path(name), text).unwrap();
        self.path(name)
    }

    /// The first `count` squares of a box, moved.
    fn squares(&self, name: &str, low: [f64; 3], high: [f64; 3], count: usize, motion: Motion) -> PathBuf {
        let mut text = String::new();
        for i in 0..8 {
            let [x, y, z] =
                motion([0, 1, 2].map(|axis| if i >> axis & 1 == 0 { low[axis] } else { high[axis] }));
            writeln!(text, "v {x:?} {y:?} {z:?}").unwrap();
        }
        for [a, b, c, d] in &SQUARES[..count] {
            writeln!(text, "f {} {} {} {}", a + 1, b + 1, c + 1, d + 1).unwrap();
        }
        self.text(name, &text)
    }

    fn cuboid(&self, name: &str, low: [f64; 3], high: [f64; 3]) -> PathBuf {
        self.squares(name, low, high, 6, |point| point)
    }

    fn cube(&self, name: &str, low: [f64; 3], side: f64) -> PathBuf {
        self.cuboid(name, low, low.map(|x| x + side))
    }
}

fn run(verb: &[&str], inputs: &[&PathBuf], options: &[&str]) -> Run {
    let inputs = inputs.iter().map(|path| argument(path));
    let all: Vec<&str> = verb.iter().copied().chain(inputs).chain(options.iter().copied()).collect();
    coface(&all)
}

fn arranged(inputs: &[&PathBuf], options: &[&str]) -> Value {
    run(&["arrange", "--json", "--quiet"], inputs, options).json()
}

fn combined(operation: &str, inputs: &[&PathBuf], options: &[&str]) -> Value {
    run(&["boolean", operation, "--json", "--quiet"], inputs, options).json()
}

fn formula(text: &str, inputs: &[&PathBuf], options: &[&str]) -> Value {
    run(&["boolean", "--json", "--quiet", "--formula", text], inputs, options).json()
}

fn sorted(values: &Value) -> Vec<f64> {
    let mut values: Vec<f64> = values.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect();
    values.sort_by(f64::total_cmp);
    values
}

fn turned(axis: usize, angle: f64, mut p: [f64; 3]) -> [f64; 3] {
    let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
    let (sine, cosine) = angle.sin_cos();
    (p[i], p[j]) = (cosine * p[i] - sine * p[j], sine * p[i] + cosine * p[j]);
    p
}

fn second(p: [f64; 3]) -> [f64; 3] {
    use std::f64::consts::PI;
    let [x, y, z] = turned(0, PI / 5.0, turned(2, PI / 12.0, p));
    [x + 0.3, y + 0.4, z + 0.25]
}

fn third(p: [f64; 3]) -> [f64; 3] {
    use std::f64::consts::PI;
    let [x, y, z] = turned(1, PI / 5.0, turned(1, PI / 12.0, p));
    second([x - 0.2, y + 0.4, z - 0.2])
}

#[test]
fn cubes_that_touch_have_the_known_cells() {
    let folder = Folder::new();
    let a = folder.cube("a.obj", [0.0; 3], 1.0);
    for (low, high, counts, volumes) in [
        ([0.5, 0.5, 0.5], [1.5, 1.5, 1.5], [22, 36, 18, 3], vec![0.125, 0.875, 0.875]),
        ([1.0, 0.0, 0.0], [2.0, 1.0, 1.0], [12, 20, 11, 2], vec![1.0, 1.0]),
        ([1.0, 0.5, 0.5], [2.0, 1.5, 1.5], [18, 28, 13, 2], vec![1.0, 1.0]),
        ([1.0, 1.0, 0.0], [2.0, 2.0, 1.0], [14, 23, 12, 2], vec![1.0, 1.0]),
        ([1.0, 1.0, 1.0], [2.0, 2.0, 2.0], [15, 24, 12, 2], vec![1.0, 1.0]),
        ([3.0, 0.0, 0.0], [4.0, 1.0, 1.0], [16, 24, 12, 2], vec![1.0, 1.0]),
        ([0.25, 0.25, 0.25], [0.75, 0.75, 0.75], [16, 24, 12, 2], vec![0.125, 0.875]),
        ([0.0, 0.0, 0.0], [1.0, 1.0, 1.0], [8, 12, 6, 1], vec![1.0]),
        ([0.25, 0.25, -0.5], [0.75, 0.75, 1.5], [24, 40, 22, 4], vec![0.125, 0.125, 0.25, 0.75]),
    ] {
        let b = folder.cuboid("b.obj", low, high);
        let object = arranged(&[&a, &b], &[]);
        assert_eq!((&object["f_vector"], &object["dimension"]), (&json!(counts), &json!(3)), "{low:?}");
        assert_eq!(sorted(&object["measures"]), volumes);
        assert_eq!(object["products_zero"], json!(true));
        // Inclusion and exclusion, over four runs.
        let measure = |operation: &str| combined(operation, &[&a, &b], &[])["measure"].as_f64().unwrap();
        let own: f64 = (0..3).map(|axis| high[axis] - low[axis]).product();
        assert_eq!(1.0 + own, measure("union") + measure("intersection"));
        assert_eq!(1.0, measure("difference") + measure("intersection"));
        assert_eq!(measure("xor"), measure("union") - measure("intersection"));
    }
}

#[test]
fn three_turned_cubes_have_seven_cells() {
    let folder = Folder::new();
    let cube = |name: &str, motion: Motion| folder.squares(name, [0.0; 3], [1.0; 3], 6, motion);
    let (a, b, c) = (cube("a.obj", |p| p), cube("b.obj", second), cube("c.obj", third));
    let split = ["--non-planar", "split"];
    assert_eq!(arranged(&[&a, &b, &c], &split)["f_vector"], json!([49, 88, 47, 7]));
    for (text, volume) in [
        ("a & b", 0.3559135818),
        ("a & c", 0.1059069904),
        ("b & c", 0.1130602363),
        ("a & b & c", 0.0590344335),
        ("a | b | c", 2.4841536249),
        ("!(!a & !b) & !(a & b)", 1.2881728364),
    ] {
        let object = formula(text, &[&a, &b, &c], &split);
        assert!(
            (object["measure"].as_f64().unwrap() - volume).abs() < 2e-10,
            "{text}: {}",
            object["measure"]
        );
        assert_eq!(object["closed"], json!(true));
    }
    // Rounded vertices are told; after snapping there are none.
    let object = combined("union", &[&a, &b], &split);
    assert_eq!(object["rounding"]["exact"], json!(false));
    let out = folder.path("snapped.json");
    let snapped = combined("union", &[&a, &b], &["--non-planar", "split", "--snap", "-o", argument(&out)]);
    assert_eq!(snapped["rounding"]["exact"], json!(true));
    let again = combined("union", &[&out], &[]);
    assert_eq!(again["f_vector"], snapped["f_vector"]);
    // The same cells added up in another order.
    let [found, expected] = [&again, &snapped].map(|object| object["measure"].as_f64().unwrap());
    assert!((found - expected).abs() < 1e-15);
    // Polygons that are not quite planar are split without being asked, and refused with the deviation on request.
    assert_eq!(arranged(&[&a, &b, &c], &["--strict"])["f_vector"], json!([49, 88, 47, 7]));
    let refused = run(&["arrange"], &[&a, &b], &["--non-planar", "refuse"]);
    let message = refused.fails_with(1);
    assert!(message.contains("b.obj: polygon") && message.contains("away from a plane"), "{message}");
}

#[test]
fn warped_quadrangles_are_split_with_a_remark_and_refused_if_strict() {
    let folder = Folder::new();
    let motion = |p: [f64; 3]| if p == [1.0; 3] { [1.0, 1.0, 1.5] } else { p };
    let lifted = folder.squares("lifted.obj", [0.0; 3], [1.0; 3], 6, motion);
    let object = arranged(&[&lifted], &[]);
    assert_eq!(object["f_vector"], json!([8, 12, 6, 1]));
    assert_eq!(object["remarks"][0]["code"], json!("faces-split"));
    assert_eq!(object["remarks"][0]["places"][0]["cell"], json!([4, 5, 7, 6]));
    for options in [&["--strict"][..], &["--non-planar", "refuse"], &["--non-planar", "rounded"]] {
        let refused = run(&["boolean", "union"], &[&lifted], options);
        let message = refused.fails_with(1);
        assert!(message.contains("lifted.obj: polygon 1 is not planar"), "{message}");
    }
    assert_eq!(
        arranged(&[&lifted], &["--strict", "--non-planar", "split"])["f_vector"],
        json!([8, 12, 6, 1])
    );
}

#[test]
fn results_are_written_in_every_format_and_read_again() {
    let folder = Folder::new();
    let (a, b) = (folder.cube("a.obj", [0.0; 3], 1.0), folder.cube("b.obj", [0.5; 3], 1.0));
    for extension in ["obj", "off", "ply", "stl", "vtk", "vtu", "vtp", "mesh", "msh", "json"] {
        let out = folder.path(&format!("union.{extension}"));
        let triangles = matches!(extension, "stl" | "mesh" | "msh");
        let mut options = vec!["-o", argument(&out)];
        if triangles {
            options.push("--triangles");
        }
        let object = combined("union", &[&a, &b], &options);
        let counts = if triangles { [20, 54, 36] } else { [20, 30, 12] };
        assert_eq!(object["f_vector"], json!(counts), "{extension}");
        let again = combined("union", &[&out], &["--polygons"]);
        assert_eq!((&again["measure"], &again["area"]), (&json!(1.875), &json!(10.5)), "{extension}");
        let out = folder.path(&format!("cells.{extension}"));
        let options =
            if triangles { vec!["-o", argument(&out), "--triangles"] } else { vec!["-o", argument(&out)] };
        assert_eq!(arranged(&[&a, &b], &options)["f_vector"], json!([22, 36, 18, 3]));
        let again = arranged(&[&out], &[]);
        assert_eq!(sorted(&again["measures"]), [0.125, 0.875, 0.875], "{extension}");
        if extension == "json" {
            assert_eq!(again["inside"], json!([[0], [0], [0]]));
        }
    }
    let out = folder.path("walls.json");
    combined("union", &[&a, &b], &["--keep-walls", "-o", argument(&out)]);
    assert_eq!(arranged(&[&out], &[])["f_vector"], json!([22, 36, 18, 3]));
    let wrong = run(&["boolean", "union"], &[&a, &b], &["-o", "out.wkt"]);
    assert!(wrong.fails_with(1).contains("holds no polygons in space"));
}

#[test]
fn provenance_names_file_polygon_and_direction() {
    let folder = Folder::new();
    let (a, b) = (folder.cube("a.obj", [0.0; 3], 1.0), folder.cube("b.obj", [0.5; 3], 1.0));
    let out = folder.path("sources.json");
    let written = run(&["boolean", "difference"], &[&a, &b], &["--provenance", argument(&out)]);
    assert_eq!((written.status, written.stdout.as_str()), (0, ""));
    let wrong = run(&["arrange"], &[&a, &b], &["--provenance", "sources.csv"]);
    assert!(wrong.fails_with(1).contains("name a .json file"));
    let sources: Value = serde_json::from_str(&std::fs::read_to_string(&out).unwrap()).unwrap();
    assert_eq!(
        sources["polygons"],
        json!([
            [[0, 0, 1]],
            [[0, 1, 1]],
            [[0, 2, 1]],
            [[0, 3, 1]],
            [[0, 4, 1]],
            [[0, 5, 1]],
            [[1, 0, -1]],
            [[1, 2, -1]],
            [[1, 4, -1]]
        ])
    );
    assert_eq!(sources["files"], json!([argument(&a), argument(&b)]));
}

#[test]
fn pinches_are_told_with_coordinates_and_split_on_request() {
    let folder = Folder::new();
    let (a, b) = (folder.cube("a.obj", [0.0; 3], 1.0), folder.cube("b.obj", [1.0; 3], 1.0));
    let object = combined("union", &[&a, &b], &[]);
    assert_eq!(object["f_vector"], json!([15, 24, 12]));
    assert_eq!(object["manifold"]["verdict"], json!("no"));
    assert_eq!(object["manifold"]["witness"]["points"], json!([[[1.0, 1.0, 1.0]]]));
    assert_eq!(object["pinches"]["vertices"], json!([[1.0, 1.0, 1.0]]));
    let object = combined("union", &[&a, &b], &["--pinches", "split"]);
    assert_eq!((&object["f_vector"], &object["manifold"]["verdict"]), (&json!([16, 24, 12]), &json!("yes")));
    assert_eq!((&object["components"], &object["solids"]), (&json!(2), &json!(2)));
    // Files of meshes are manifolds without an option, chain complexes and results with walls are as they are.
    let copies = |name: &str, options: &[&str]| {
        let out = folder.path(name);
        combined("union", &[&a, &b], &[options, &["-o", argument(&out)]].concat())["pinches"]["copies"]
            .clone()
    };
    assert_eq!([copies("a.off", &[]), copies("a.json", &[])], [json!(1), json!(0)]);
    assert_eq!(copies("b.off", &["--pinches", "tell"]), json!(0));
    assert_eq!(copies("c.off", &["--keep-walls"]), json!(0));
    let verdict =
        |name: &str| coface(&["info", argument(&folder.path(name)), "--json"]).json()["manifold"].clone();
    assert_ne!(verdict("a.off"), verdict("b.off"));
    let both = run(&["boolean", "union"], &[&a, &b], &["--pinches", "split", "--keep-walls"]);
    assert!(both.fails_with(1).contains("while walls are kept"));
}

#[test]
fn pinches_inside_of_a_face_are_told_and_split() {
    let folder = Folder::new();
    let cube = folder.cube("cube.obj", [0.0; 3], 2.0);
    let base = "v 0.5 0.5 1\nv 1.5 0.5 1\nv 1.5 1.5 1\nv 0.5 1.5 1\n";
    let roof = format!("{base}v 0.5 1 2\nv 1.5 1 2\nf 4 3 2 1\nf 1 2 6 5\nf 3 4 5 6\nf 2 3 6\nf 4 1 5\n");
    let roof = folder.text("roof.obj", &roof);
    let object = combined("difference", &[&cube, &roof], &[]);
    assert_eq!((&object["measure"], &object["manifold"]["verdict"]), (&json!(7.5), &json!("no")));
    assert_eq!(object["pinches"]["edges"], json!([[[0.5, 1.0, 2.0], [1.5, 1.0, 2.0]]]));
    for extension in ["off", "stl", "obj"] {
        let out = folder.path(&format!("roof.{extension}"));
        let object = combined("difference", &[&cube, &roof], &["-o", argument(&out)]);
        assert_eq!(object["manifold"]["verdict"], json!("yes"), "{extension}");
        assert_eq!(object["pinches"]["copies"], json!(2), "{extension}");
    }
    let again = coface(&["info", argument(&folder.path("roof.off")), "--json"]).json();
    assert_eq!((&again["manifold"]["verdict"], &again["components"]), (&json!("yes"), &json!(2)));
    let pyramid = format!("{base}v 1 1 2\nf 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n");
    let pyramid = folder.text("pyramid.obj", &pyramid);
    let out = folder.path("pyramid.json");
    let object = combined("difference", &[&cube, &pyramid], &["-o", argument(&out)]);
    assert_eq!(object["pinches"]["vertices"], json!([[1.0, 1.0, 2.0]]));
    let betti = |path: &PathBuf| {
        let found = coface(&["homology", argument(path), "--json"]).json();
        let groups = found["homology"].as_array().unwrap();
        groups.iter().map(|group| group["betti"].as_u64().unwrap()).collect::<Vec<u64>>()
    };
    assert_eq!(betti(&out), [1, 0, 1, 0]);
}

#[test]
fn results_do_not_depend_on_threads_or_on_the_order_of_inputs() {
    let folder = Folder::new();
    let cube = |name: &str, motion: Motion| folder.squares(name, [0.0; 3], [1.0; 3], 6, motion);
    let (a, b, c) = (cube("a.obj", |p| p), cube("b.obj", second), cube("c.obj", third));
    let bytes = |threads: &str| {
        let out = folder.path("out.ply");
        let options = ["--non-planar", "split", "--threads", threads, "-o", argument(&out)];
        let object = combined("xor", &[&a, &b, &c], &options);
        (object, std::fs::read(&out).unwrap())
    };
    assert_eq!(bytes("1"), bytes("3"));
    let options = ["--non-planar", "split"];
    let (one, other) = (combined("xor", &[&a, &b, &c], &options), combined("xor", &[&c, &a, &b], &options));
    for key in ["f_vector", "components", "solids", "voids", "genus", "closed"] {
        assert_eq!(one[key], other[key], "{key}");
    }
}

#[test]
fn what_cannot_be_combined_is_named() {
    let folder = Folder::new();
    let a = folder.cube("a.obj", [0.0; 3], 1.0);
    let lidless = folder.squares("lidless.obj", [0.5; 3], [1.5; 3], 5, |point| point);
    let union = |other: &PathBuf, options: &[&str]| run(&["boolean", "union"], &[&a, other], options);
    let open = union(&lidless, &[]);
    let message = open.fails_with(1);
    for part in ["lidless.obj", "is open along 4 edges", "(1.5, 0.5, 0.5)", "(1.5, 1.5, 1.5)", "--open close"]
    {
        assert!(message.contains(part), "{message}");
    }
    let object = combined("union", &[&a, &lidless], &["--open", "close"]);
    assert_eq!(object["files"][1]["inside_by"], json!("closed_mouths"));
    assert_eq!(object["measure"], json!(1.875));
    // The arrangement only says so.
    let object = arranged(&[&a, &lidless], &[]);
    assert_eq!((&object["files"][1]["closed"], &object["files"][1]["rim_edges"]), (&json!(false), &json!(4)));

    let nan = folder.text("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 1\nf 1 2 3\n");
    assert!(union(&nan, &[]).fails_with(1).contains("nan.obj: coordinate 2 of v0 is NaN"));
    assert!(union(&nan, &["--strict"]).fails_with(1).contains("nan.obj:1"));
    assert!(union(&folder.path("none.obj"), &[]).fails_with(1).contains("no such file"));
    let flat = folder.text("flat.wkt", "POLYGON((0 0,1 0,1 1,0 1,0 0))\n");
    assert!(union(&flat, &[]).fails_with(1).contains("flat.wkt: the positions have 2 coordinates"));
    let facets = folder.text("facets.json", "[[0,1,2],[0,1,3],[0,2,3],[1,2,3]]\n");
    assert!(
        union(&facets, &["--dimension", "3"])
            .fails_with(1)
            .contains("facets.json: the vertices have no positions")
    );
    let lines = folder.text("lines.obj", "v 0 0 1\nv 1 0 2\nl 1 2\n");
    assert!(union(&lines, &[]).fails_with(1).contains("lines.obj: there is no polygon"));
    // The sides cross at one half.
    let bow = folder.text("bow.obj", "v 0 0 1\nv 1 0 1\nv 0 1 1\nv 1 1 1\nf 1 2 3 4\n");
    assert!(run(&["arrange"], &[&a, &bow], &[]).fails_with(1).contains("bow.obj: polygon 0"));
    let unknown = run(&["boolean", "--formula", "a - c"], &[&a, &lidless], &[]);
    assert!(unknown.fails_with(1).contains("names input 2"));
    assert!(
        run(&["arrange"], &[&a, &lidless], &["--max-cells", "20"]).fails_with(1).contains("more than 20")
    );
    assert!(run(&["boolean", "union"], &[], &[]).fails_with(2).contains("name the inputs"));
    assert!(run(&["boolean", "minus"], &[&a, &lidless], &[]).fails_with(2).contains("no operation"));
}

#[test]
fn many_solids_are_combined_at_once() {
    let folder = Folder::new();
    // Five cubes in a row, each half in the next.
    let row: Vec<PathBuf> =
        (0..5).map(|i| folder.cube(&format!("{i}.obj"), [0.5 * f64::from(i), 0.0, 0.0], 1.0)).collect();
    let row: Vec<&PathBuf> = row.iter().collect();
    for (operation, volume, solids) in
        [("union", 3.0, 1), ("xor", 1.0, 2), ("intersection", 0.0, 0), ("difference", 0.5, 1)]
    {
        let object = combined(operation, &row, &[]);
        assert_eq!((&object["measure"], &object["solids"]), (&json!(volume), &json!(solids)), "{operation}");
    }
    // Coplanar faces of one result are one face, unless they are to be kept apart.
    let whole = combined("union", &row, &["--triangles"]);
    assert_eq!((&whole["measure"], &whole["f_vector"]), (&json!(3.0), &json!([8, 18, 12])));
    let apart = combined("union", &row, &["--triangles", "--keep-coplanar"]);
    assert_eq!(apart["measure"], json!(3.0));
    assert_eq!(apart["f_vector"], json!([28, 78, 52]));
    assert_eq!(run(&["boolean", "union"], &row, &["--merge-coplanar", "--keep-coplanar"]).status, 2);
    let deep = formula("(a ^ b) & !(c | d) | e - d", &row, &[]);
    assert_eq!(deep["measure"], json!(1.0));
}

/// The Betti numbers that `info` says of a file, without zeros at the end, and its remarks.
fn betti(path: &Path) -> (Vec<u64>, Vec<String>) {
    let report = coface(&["info", argument(path), "--json"]).json();
    let mut betti: Vec<u64> =
        report["homology"].as_array().unwrap().iter().map(|group| group["betti"].as_u64().unwrap()).collect();
    while betti.last() == Some(&0) {
        betti.pop();
    }
    let codes = report["remarks"].as_array().unwrap().iter();
    (betti, codes.map(|remark| remark["code"].as_str().unwrap().to_owned()).collect())
}

#[test]
fn a_result_as_json_has_the_homology_of_the_solid() {
    let folder = Folder::new();
    let cube = folder.cube("cube.obj", [0.0; 3], 4.0);
    let rod = folder.cuboid("rod.obj", [1.0, 1.0, -1.0], [2.0, 2.0, 5.0]);
    let void = folder.cube("void.obj", [1.0, 1.0, 1.0], 2.0);
    for (other, expected) in [(&rod, vec![1, 1]), (&void, vec![1, 0, 1])] {
        for option in [&[][..], &["--triangles"]] {
            let out = folder.path("result.json");
            assert_eq!(run(&["boolean", "difference"], &[&cube, other], &["-o", argument(&out)]).status, 0);
            let options: Vec<&str> = ["-o", argument(&out)].iter().chain(option).copied().collect();
            assert_eq!(run(&["boolean", "difference"], &[&cube, other], &options).status, 0);
            assert_eq!(betti(&out), (expected.clone(), vec![]), "{option:?}");
            // The file is an input that means the same.
            let again = run(&["boolean", "union"], &[&out], &["--json"]).json();
            let once = run(&["boolean", "difference"], &[&cube, other], &["--json"]).json();
            assert_eq!(again["measure"], once["measure"]);
            assert_eq!(again["f_vector"].as_array().unwrap().len(), 3);
            if option.is_empty() {
                assert_eq!(again["f_vector"], once["f_vector"]);
            } else {
                let text = std::fs::read_to_string(&out).unwrap();
                let file: Value = serde_json::from_str(&text).unwrap();
                let faces = file["boundaries"][1]["entries"].as_array().unwrap().len();
                assert_eq!(faces, 3 * file["boundaries"][1]["cols"].as_u64().unwrap() as usize);
            }
        }
    }
}

#[test]
fn nested_squares_as_json_are_one_piece() {
    let folder = Folder::new();
    let squares =
        folder.text("squares.wkt", "POLYGON((0 0,4 0,4 4,0 4,0 0))\nPOLYGON((1 1,3 1,3 3,1 3,1 1))\n");
    let out = folder.path("nested.json");
    let once = run(&["arrange"], &[&squares], &["-o", argument(&out), "--json"]).json();
    assert_eq!(once["f_vector"], json!([8, 8, 2]));
    assert_eq!(betti(&out), (vec![1], vec![]));
    let again = run(&["arrange"], &[&out], &["--json"]).json();
    assert_eq!((&again["f_vector"], &again["measures"]), (&once["f_vector"], &once["measures"]));
    let group = coface(&["pi1", argument(&out), "--json"]).json();
    assert_eq!(group["components"][0]["generators"], json!(0));
}

#[test]
fn cells_that_are_no_balls_are_a_remark() {
    let folder = Folder::new();
    // A square with a square hole, as the matrices of a face with two rims.
    let ends = [[0, 1], [1, 2], [2, 3], [3, 0], [4, 5], [5, 6], [6, 7], [7, 4]];
    let sides: Vec<[i64; 3]> =
        ends.iter().zip(0..).flat_map(|(&[a, b], edge)| [[a, edge, -1], [b, edge, 1]]).collect();
    let rims: Vec<[i64; 3]> = (0..8).map(|edge| [edge, 0, if edge < 4 { 1 } else { -1 }]).collect();
    let file = json!({"boundaries": [
        {"rows": 8, "cols": 8, "entries": sides},
        {"rows": 8, "cols": 1, "entries": rims},
    ]});
    let path = folder.text("frame.json", &file.to_string());
    assert_eq!(betti(&path), (vec![2, 1], vec!["cells-not-balls".to_owned()]));
    let text = coface(&["info", argument(&path)]).stdout;
    assert!(!text.contains("No problems found"), "{text}");
}

/// A chain through files stays small, each step can be input again, and it means what the formula means.
#[test]
fn a_chain_of_booleans_through_files_is_the_formula() {
    let folder = Folder::new();
    let mut state = 7u64;
    let mut random = || {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let mut solid = |name: &str, is_first: bool| {
        let angles: Vec<f64> = (0..3).map(|_| 6.0 * random()).collect();
        let half = [0; 3].map(|_| if is_first { 1.0 } else { 0.15 + 0.45 * random() });
        let by = [0; 3].map(|_| if is_first { 0.0 } else { 2.0 * random() - 1.0 });
        let mut text = String::new();
        for i in 0..8 {
            let corner = [0, 1, 2].map(|axis| if i >> axis & 1 == 0 { -half[axis] } else { half[axis] });
            let turned = angles.iter().enumerate().fold(corner, |p, (axis, &angle)| turned(axis, angle, p));
            let [x, y, z] = [0, 1, 2].map(|axis| turned[axis] + by[axis]);
            writeln!(text, "v {x:?} {y:?} {z:?}").unwrap();
        }
        for [a, b, c, d] in SQUARES.map(|square| square.map(|corner| corner + 1)) {
            writeln!(text, "f {a} {b} {c}\nf {a} {c} {d}").unwrap();
        }
        folder.text(name, &text)
    };
    let mut inputs = vec![solid("0.obj", true)];
    let mut last = inputs[0].clone();
    let mut text = "0".to_owned();
    let mut answer = Value::Null;
    for step in 1..=14 {
        inputs.push(solid(&format!("{step}.obj"), false));
        let (operation, sign) = if step % 3 == 0 { ("union", '|') } else { ("difference", '-') };
        let result = folder.path(&format!("result{step}.off"));
        answer = combined(operation, &[&last, &inputs[step]], &["-o", argument(&result)]);
        assert_eq!(answer["rounding"]["valid"], true, "{answer}");
        let codes: Vec<&str> =
            answer["remarks"].as_array().unwrap().iter().map(|r| r["code"].as_str().unwrap()).collect();
        assert!(codes.iter().all(|&code| code == "features-joined"), "{codes:?}");
        (last, text) = (result, format!("({text} {sign} {step})"));
    }
    let whole = formula(&text, &inputs.iter().collect::<Vec<_>>(), &[]);
    let volume = |answer: &Value| answer["measure"].as_f64().unwrap();
    assert!((volume(&answer) - volume(&whole)).abs() < 1e-12, "{answer}");
    let faces = |answer: &Value| answer["f_vector"][2].as_u64().unwrap();
    assert!(faces(&answer) <= 2 * faces(&whole), "{} {}", faces(&answer), faces(&whole));
}

/// Walls turned by an angle that is no multiple of a right one: cells without thickness are told of, and vanish within a
/// tolerance.
#[test]
fn a_tolerance_puts_together_what_nearly_coincides() {
    let folder = Folder::new();
    let turn: Motion = |p| turned(2, 0.3, p);
    let whole = folder.squares("whole.obj", [0.0; 3], [2.0, 1.0, 1.0], 6, turn);
    let beside = folder.squares("beside.obj", [0.1, 1.0, 0.0], [1.0, 2.0, 1.0], 6, turn);
    let answer = arranged(&[&whole, &beside], &["--tolerance", "1e-9"]);
    assert_eq!(answer["f_vector"][3], 2, "{answer}");
    assert_eq!(answer["joined"]["tolerance"], 1e-9);
    assert!(answer["joined"]["largest_movement"].as_f64().unwrap() <= 1e-9);
    // A gap of a thousandth is closed, and the remark says so.
    let moved = folder
        .squares("moved.obj", [0.0; 3], [2.0, 1.0, 1.0], 6, |p| turned(2, 0.3, [p[0], p[1] + 1.001, p[2]]));
    let apart = arranged(&[&whole, &moved], &[]);
    assert_eq!((&apart["f_vector"], &apart["joined"]), (&json!([16, 24, 12, 2]), &Value::Null));
    let near = arranged(&[&whole, &moved], &["--tolerance", "0.01"]);
    assert_eq!(near["f_vector"], json!([12, 20, 11, 2]));
    assert_eq!(near["remarks"][0]["code"], "features-joined");
    // A cell thinner than a part in 10^9 is told of, with the tolerance that it vanishes in.
    let thin = folder.cuboid("thin.obj", [0.0, 0.0, -1e-12], [1.0, 1.0, 0.0]);
    let cube = folder.cuboid("cube.obj", [0.0; 3], [1.0; 3]);
    let answer = arranged(&[&thin, &cube], &[]);
    assert_eq!((&answer["f_vector"][3], &answer["remarks"][0]["code"]), (&json!(2), &json!("thin-cells")));
    let message = answer["remarks"][0]["message"].as_str().unwrap().to_owned();
    let tolerance = message.split("--tolerance ").nth(1).unwrap().split(' ').next().unwrap();
    let answer = arranged(&[&thin, &cube], &["--tolerance", tolerance]);
    assert_eq!((&answer["f_vector"][3], &answer["joined"]["vanished_cells"]), (&json!(1), &json!(1)));
}

#[test]
fn a_tolerance_that_is_none_is_refused() {
    let folder = Folder::new();
    let cube = folder.cube("cube.obj", [0.0; 3], 1.0);
    let square = folder.text("square.wkt", "POLYGON((0 0,1 0,1 1,0 1,0 0))");
    for bad in ["-1", "nan", "a"] {
        for input in [&cube, &square] {
            let ran = run(&["arrange"], &[input], &["--tolerance", bad]);
            assert!(ran.fails_with(2).contains("give a finite length that is not negative"));
        }
    }
    let ran = run(&["arrange"], &[&square], &["--tolerance", "1", "--grid", "1"]);
    assert!(ran.fails_with(2).contains("--grid"));
}

/// Drawings within a tolerance: a border that two files digitized apart has no slivers, and the result is input again.
#[test]
fn a_tolerance_closes_the_gaps_of_drawings() {
    let folder = Folder::new();
    let west = folder.text("west.wkt", "POLYGON((0 0,1 0,1.0004 0.5,1 1,0 1,0 0))");
    let east = folder.text("east.wkt", "POLYGON((0.9997 0,2 0,2 1,1.0003 1,0.9997 0))");
    let apart = coface(&["arrange", argument(&west), argument(&east), "--json"]).json();
    assert_eq!(apart["f_vector"][2], json!(3));
    let arguments = ["arrange", argument(&west), argument(&east), "--tolerance", "0.002", "--json"];
    let joined = coface(&arguments).json();
    assert_eq!(joined["f_vector"], json!([7, 8, 2]));
    assert_eq!(joined["inside"], json!([[0], [1]]));
    assert_eq!((&joined["joined"]["vanished_cells"], &joined["joined"]["vertices"]), (&json!(1), &json!(2)));
    assert!(joined["joined"]["largest_movement"].as_f64().unwrap() <= 0.002);
    let remark = &joined["remarks"][0];
    assert_eq!((&remark["code"], &remark["count"]), (&json!("features-joined"), &json!(3)));
    assert!(remark["message"].as_str().unwrap().contains("1 face vanished"));
    // The union is one polygon without a hole, and so is it read again.
    let union = folder.path("union.wkt");
    let arguments = [
        "boolean",
        "union",
        argument(&west),
        argument(&east),
        "--tolerance",
        "0.002",
        "-o",
        argument(&union),
    ];
    coface(&[&arguments[..], &["--json"]].concat()).json();
    let again = coface(&["boolean", "union", argument(&union), "--json"]).json();
    assert_eq!((&again["polygons"], &again["holes"]), (&json!(1), &json!(0)));
    assert!((again["measure"].as_f64().unwrap() - 2.0).abs() < 1e-3);
    // A sliver that nobody means is told of, with the tolerance that it vanishes in.
    let sliver = folder.text("sliver.wkt", "POLYGON((0.9999999999999 0,2 0,2 1,1 1,0.9999999999999 0))");
    let square = folder.text("square.wkt", "POLYGON((0 0,1 0,1 1,0 1,0 0))");
    let answer = coface(&["arrange", argument(&square), argument(&sliver), "--json"]).json();
    let thin = &answer["remarks"][0];
    assert_eq!((&answer["f_vector"][2], &thin["code"]), (&json!(3), &json!("thin-cells")), "{answer}");
    let tolerance =
        thin["message"].as_str().unwrap().split("--tolerance ").nth(1).unwrap().split(' ').next().unwrap();
    let answer =
        coface(&["arrange", argument(&square), argument(&sliver), "--tolerance", tolerance, "--json"]).json();
    assert_eq!(answer["f_vector"], json!([6, 7, 2]));
}

/// Results in the plane are one valid geometry, on a grid if that is asked for; in space there is neither.
#[test]
fn results_in_the_plane_are_valid_and_on_grids() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name).display().to_string();
    let (a, b, out) = (path("a.wkt"), path("b.wkt"), path("out.wkt"));
    std::fs::write(
        &a,
        "POLYGON((-1120500.000000126 850931.058865365,-1120500.0000001257 851343.3885007716,\
         -1120500.0000001257 851342.2386007707,-1120399.762684411 851199.4941312922,-1120500.000000126 850931.058865365))",
    )
    .unwrap();
    std::fs::write(
        &b,
        "POLYGON((-1120500.000000126 851253.4627870625,-1120500.0000001257 851299.8179383819,\
         -1120492.1498410008 851293.8417889411,-1120500.000000126 851253.4627870625))",
    )
    .unwrap();
    let union = |options: &[&str]| {
        let run = coface(&[&["boolean", "union", &a, &b, "-o", &out, "--json", "--quiet"], options].concat());
        assert_eq!(run.status, 0, "{}", run.stderr);
        (run.json(), coface(&["info", &out, "--json"]).json(), std::fs::read_to_string(&out).unwrap())
    };
    let (exact, checked, _) = union(&["--exact"]);
    assert_eq!((&exact["rounding"]["valid"], &checked["polygons"]["valid"]), (&json!(false), &json!(false)));
    let (valid, checked, text) = union(&[]);
    assert_eq!((&valid["rounding"]["valid"], &checked["polygons"]["valid"]), (&json!(true), &json!(true)));
    assert_eq!(text.lines().count(), 1);
    let (_, checked, text) = union(&["--grid", "0.01"]);
    assert_eq!(checked["polygons"]["valid"], json!(true));
    let words: Vec<&str> =
        text.split(|c: char| !c.is_ascii_digit() && c != '.').filter(|word| !word.is_empty()).collect();
    assert!(words.len() > 6);
    assert!(
        words.iter().all(|word| word.split_once('.').is_none_or(|(_, digits)| digits.len() <= 2)),
        "{text}"
    );
    let cube = path("cube.off");
    assert_eq!(coface(&["generate", "box", "--boundary", "-o", &cube]).status, 0);
    let run = coface(&["boolean", "union", &cube, "--grid", "0.1"]);
    assert!(run.status == 1 && run.stderr.contains("for drawings in the plane"), "{}", run.stderr);
    assert_eq!(coface(&["boolean", "union", &a, &b, "--exact", "--snap"]).status, 2);
    assert!(coface(&["boolean", "union", &a, &b, "--grid", "0"]).stderr.contains("0 is no step of a grid"));
}

/// Both parts of a cut cube put together again: the cube, bit by bit.
#[test]
fn exact_results_are_input_again() {
    let folder = Folder::new();
    let turned: Motion = |[x, y, z]| [0.8 * x - 0.6 * y, 0.6 * x + 0.8 * y, z + 0.1 * x];
    let cube = argument(&folder.squares("cube.obj", [0.0; 3], [1.0; 3], 6, turned)).to_owned();
    let knife: Motion = |[x, y, z]| [x + 0.3 * z, y - 0.2 * z, z + 0.37 * x - 0.21 * y];
    let knife =
        argument(&folder.squares("knife.obj", [-5.0, -5.0, 0.4], [5.0, 5.0, 4.0], 6, knife)).to_owned();
    let path = |name: &str| argument(&folder.path(name)).to_owned();
    let [below, above, xor] = ["below.json", "above.json", "xor.json"].map(path);
    for (operation, output) in [("difference", &below), ("intersection", &above)] {
        let run = coface(&["boolean", operation, &cube, &knife, "--exact", "-o", output]);
        assert_eq!(run.status, 0, "{}", run.stderr);
        assert!(std::fs::read_to_string(output).unwrap().contains("\"exact_polygons\""));
        let found = coface(&["homology", output, "--json"]).json();
        let betti: Vec<i64> =
            found["homology"].as_array().unwrap().iter().map(|own| own["betti"].as_i64().unwrap()).collect();
        assert_eq!(betti, [1, 0, 0, 0], "{output}");
    }
    let formula = ["boolean", "--formula", "a ^ (b | c)", &cube, &below, &above, "--exact", "--json"];
    let answer = coface(&formula).json();
    assert_eq!((&answer["measure"], &answer["f_vector"]), (&json!(0.0), &json!([0, 0, 0])));
    // With rounded points that is not so.
    let rounded = coface(&[&formula[..6], &["--tolerance", "1e-20", "--json"]].concat());
    assert_eq!(rounded.status, 0, "{}", rounded.stderr);
    // What was cut out of a result is exact again.
    assert_eq!(coface(&["boolean", "xor", &below, &cube, "--exact", "-o", &xor]).status, 0);
    let again = coface(&["boolean", "xor", &xor, &above, "--json", "--exact"]).json();
    assert_eq!(again["measure"], json!(0.0));
    // All of an arrangement, walls included.
    let cells = path("cells.json");
    assert_eq!(coface(&["arrange", &cube, &knife, "--exact", "-o", &cells]).status, 0);
    let first = coface(&["arrange", &cube, &knife, "--exact", "--json"]).json();
    let second = coface(&["arrange", &cells, "--exact", "--json"]).json();
    assert_eq!(first["measures"].as_array().unwrap().len(), second["measures"].as_array().unwrap().len());
    // The parts of a file as inputs have rounded points, and a remark says so.
    let parts = coface(&["arrange", &cells, "--inputs", "components"]);
    assert!(parts.stderr.contains("its points are rounded, since its parts are inputs"), "{}", parts.stderr);
    // Damaged files are refused with the place.
    let text = std::fs::read_to_string(&below).unwrap();
    let at = text.find("\"exact_polygons\"").unwrap();
    let places = text[at..].replacen("\"walks\":[[0,", "\"walks\":[[1,", 1);
    let damaged = folder.text("damaged.json", &format!("{}{places}", &text[..at]));
    let run = coface(&["boolean", "union", argument(&damaged)]);
    assert_eq!(run.status, 1, "{}", run.stdout);
    assert!(run.stderr.contains("exact"), "{}", run.stderr);
}

/// A tube of 2,400 triangles that runs around an axis three times, and wobbles: rounding its crossings makes more of them in each round.
#[test]
fn a_tube_that_lies_on_itself_three_times_ends_with_a_remark() {
    let [steps, around] = [60, 20];
    let mut text = format!("OFF\n{} {} 0\n", steps * around, 2 * steps * around);
    let angle = |i: usize, count: usize| std::f64::consts::TAU * i as f64 / count as f64;
    for i in 0..steps {
        let (s, c) = (3.0 * angle(i, steps)).sin_cos();
        let wobble = 0.05 * angle(i, steps).sin();
        for j in 0..around {
            let (v, u) = angle(j, around).sin_cos();
            let radius = 2.0 + wobble + 0.5 * u;
            text += &format!("{} {} {}\n", radius * c, radius * s, 0.5 * v + wobble);
        }
    }
    for i in 0..steps {
        for j in 0..around {
            let at = |i: usize, j: usize| i % steps * around + j % around;
            let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
            text += &format!("3 {a} {b} {c}\n3 {a} {c} {d}\n");
        }
    }
    let folder = Folder::new();
    let tube = folder.text("tube.off", &text);
    let union = |more: &[&str]| {
        let words = ["boolean", "union", argument(&tube), "--rule", "positive", "--json"];
        coface(&[&words[..], more].concat()).json()
    };
    let (rounded, exact) = (union(&[]), union(&["--exact"]));
    for answer in [&rounded, &exact] {
        let volume = answer["measure"].as_f64().unwrap();
        assert!((volume - 10.975_684_385_942_976).abs() < 1e-9, "{volume}");
    }
    // Whether it is valid is told, whatever it is.
    let is_told =
        rounded["remarks"].as_array().unwrap().iter().any(|remark| remark["code"] == "rounded-invalid");
    assert_eq!(rounded["rounding"]["valid"] == json!(false), is_told, "{}", rounded["remarks"]);
}

#[test]
fn cures_for_an_open_input_are_small_beside_it_and_not_beside_others() {
    let folder = Folder::new();
    let open = folder.path("open.off");
    assert_eq!(coface(&["generate", "cylinder", "-o", argument(&open)]).status, 0);
    let large = folder.cube("large.obj", [0.0; 3], 90_000.0);
    let run = run(&["boolean", "union"], &[&open, &large], &["-o", argument(&folder.path("out.off"))]);
    let said = run.fails_with(1);
    assert!(said.contains("(--open close)") && !said.contains("--weld"), "{said}");
}
