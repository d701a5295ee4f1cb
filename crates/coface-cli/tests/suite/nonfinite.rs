//! Coordinates that are NaN or infinite: topology does without them, measures are null, pictures leave them out, and whatever needs
//! all of them names the first one.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// A torus of 3 by 3 squares, each cut in two, one of whose vertices has this place.
fn torus(point: &str) -> String {
    let mut text = String::new();
    for (i, j) in (0..9).map(|vertex| (vertex / 3, vertex % 3)) {
        text += &match (i, j) {
            (1, 1) => format!("v {point}\n"),
            _ => format!("v {} {} {}\n", i * i, 3 * j + i, (i + j) % 2),
        };
    }
    for (i, j) in (0..9).map(|vertex| (vertex / 3, vertex % 3)) {
        let at = |i: usize, j: usize| 3 * (i % 3) + j % 3 + 1;
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        text += &format!("f {a} {b} {c}\nf {a} {c} {d}\n");
    }
    text
}

struct Files {
    folder: TempDir,
    broken: PathBuf,
    whole: PathBuf,
}

impl Files {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let [broken, whole] = ["broken.obj", "whole.obj"].map(|name| folder.path().join(name));
        std::fs::write(&broken, torus("1 nan -inf")).unwrap();
        std::fs::write(&whole, torus("1 4 0")).unwrap();
        Self { folder, broken, whole }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }
}

fn answer(verb: &[&str], file: &Path) -> Value {
    coface(&[&[verb[0], argument(file)], &verb[1..], &["--json"]].concat()).json()
}

fn codes(answer: &Value) -> Vec<&str> {
    answer["remarks"].as_array().unwrap().iter().map(|one| one["code"].as_str().unwrap()).collect()
}

#[test]
fn topology_is_that_of_the_whole_and_measures_are_null() {
    let files = Files::new();
    let [mut broken, mut whole] =
        [&files.broken, &files.whole].map(|file| answer(&["info", "--moment", "1,0,0"], file));
    assert_eq!(codes(&broken), ["nonfinite-coordinate"]);
    let remark = &broken["remarks"][0];
    assert_eq!((&remark["count"], &remark["places"]), (&json!(1), &json!([{"cell": [4], "line": 5}])));
    for key in ["area", "signed_volume", "mass", "surface_centroid"] {
        assert!(broken[key].is_null(), "{key}: {}", broken[key]);
        assert!(!whole[key].is_null(), "{key}");
    }
    let moment = json!([{"exponents": [1, 0, 0], "surface": null, "volume": null}]);
    assert_eq!(broken["moments"], moment);
    assert_ne!(whole["moments"], moment);
    assert_eq!(broken["geometry"]["reason"], "some coordinates are not finite");
    assert_eq!(whole["geometry"]["checked"], true);
    let of_places = ["area", "signed_volume", "mass", "surface_centroid", "moments", "geometry", "problems"];
    for key in of_places.into_iter().chain(["file", "remarks", "warnings"]) {
        broken.as_object_mut().unwrap().remove(key);
        whole.as_object_mut().unwrap().remove(key);
    }
    assert_eq!(broken, whole);
    assert_eq!(broken["name"], "torus");

    for verb in [
        &["homology"][..],
        &["homology", "--coefficients", "f2", "--cohomology"],
        &["pi1"],
        &["cut"],
        &["cover", "--radius", "1"],
        &["cocycles", "--harmonic", "--weights", "uniform"],
        &["link", "--simplices", "4"],
        &["incidence", "--operator", "FE"],
        &["subgroups"],
    ] {
        let [mut broken, mut whole] = [&files.broken, &files.whole].map(|file| answer(verb, file));
        assert!(codes(&broken).contains(&"nonfinite-coordinate"), "{verb:?}");
        for key in ["file", "remarks", "seconds"] {
            broken.as_object_mut().unwrap().remove(key);
            whole.as_object_mut().unwrap().remove(key);
        }
        let seams = "/components/0/seams";
        for seam in broken.pointer(seams).and_then(Value::as_array).into_iter().flatten() {
            assert!(seam["length"].is_null(), "{seam}");
        }
        for seam in whole.pointer_mut(seams).and_then(Value::as_array_mut).into_iter().flatten() {
            assert!(seam["length"].take().is_number(), "{seam}");
        }
        if verb[0] == "cocycles" {
            // The whole has lengths, by which it chooses other loops.
            assert_eq!((&broken["rank"], &broken["determinant"]), (&whole["rank"], &whole["determinant"]));
            continue;
        }
        assert_eq!(broken, whole, "{verb:?}");
    }
}

#[test]
fn strict_reading_refuses_the_file_with_its_line() {
    let files = Files::new();
    for verb in [&["info"][..], &["homology"], &["render", "-o", "never.png"], &["batch", "-o", "never.csv"]]
    {
        let command = [&[verb[0], argument(&files.broken)], &verb[1..], &["--strict"]].concat();
        if verb[0] == "batch" {
            continue;
        }
        let run = coface(&command);
        let message = run.fails_with(1);
        assert!(
            message.contains("a coordinate that is not finite") && message.contains("on line 5"),
            "{message}"
        );
    }
    assert_eq!(coface(&["info", argument(&files.whole), "--strict"]).status, 0);
}

#[test]
fn whatever_needs_all_coordinates_names_the_first_that_is_none() {
    let files = Files::new();
    let [model, svg, wkt, json] = ["g.obj", "c.vtk", "o.wkt", "o.geojson"].map(|name| files.path(name));
    let (file, whole) = (argument(&files.broken), argument(&files.whole));
    let shards = files.path("shards");
    for command in [
        &["arrange", file][..],
        &["boolean", "union", whole, file],
        &["congruence", file, "--tolerance", "0.1"],
        &["pi1", file, "--shortest"],
        &["loops", file, "--shortest"],
        &["cycles", file],
        &["cocycles", file, "--harmonic"],
        &["cocycles", file, "-o", argument(&svg)],
        &["homology", file, "--generators", argument(&model)],
        &["persistence", file],
        &["convert", file, "-o", argument(&wkt)],
        &["convert", file, "-o", argument(&json)],
        &["convert", file, "-o", argument(&model), "--color-by", "component"],
        &["shard", file, "--parts", "2", "--owners", "positions", "-o", argument(&shards)],
        &["generate", "extrude", file, "-o", argument(&model)],
        &["yin", "info", file],
    ] {
        let run = coface(&[command, &["--json"]].concat());
        let message = run.fails_with(1);
        assert!(message.contains("coordinate 1 of v4 is NaN, not a finite number"), "{command:?}: {message}");
    }
    for path in [model, svg, wkt, json] {
        assert!(!path.exists(), "{}", path.display());
    }
}

/// The group and its loops need no coordinates; lengths count edges then, and a remark says so.
#[test]
fn loops_count_edges() {
    let files = Files::new();
    let loops = answer(&["loops"], &files.broken);
    assert!(codes(&loops).contains(&"unit-lengths"), "{loops}");
    for path in
        loops["components"].as_array().unwrap().iter().flat_map(|one| one["loops"].as_array().unwrap())
    {
        assert_eq!(path["length"].as_f64().unwrap(), path["vertices"].as_array().unwrap().len() as f64 - 1.0);
    }
}

#[test]
fn pictures_leave_the_vertex_out_and_say_so() {
    let files = Files::new();
    for (verb, name) in [
        ("render", "a.png"),
        ("render", "a.svg"),
        ("view", "a.html"),
        ("convert", "a.glb"),
        ("convert", "a.gltf"),
    ] {
        let target = files.path(name);
        let answer = answer(&[verb, "-o", argument(&target)], &files.broken);
        assert_eq!(codes(&answer), ["nonfinite-coordinate", "not-drawn"], "{name}");
        let remark = &answer["remarks"][1];
        assert_eq!(remark["places"], json!([{"cell": [4]}]));
        let message = remark["message"].as_str().unwrap();
        assert!(message.ends_with("and 6 cells there"), "{message}");
        let bytes = std::fs::read(&target).unwrap();
        // A page has a program in which the word stands.
        assert!(verb == "view" || !bytes.windows(3).any(|word| word == b"NaN"), "{name}");
        let run = coface(&[verb, argument(&files.broken), "-o", argument(&target)]);
        assert!(run.status == 0 && run.stderr.contains("not drawn: 1 vertex"), "{}", run.stderr);
        let whole = coface(&[verb, argument(&files.whole), "-o", argument(&target)]);
        assert!(!whole.stderr.contains("not drawn"), "{}", whole.stderr);
    }
    let page = files.path("report.html");
    assert_eq!(coface(&["info", argument(&files.broken), "--html", argument(&page)]).status, 0);
    let page = std::fs::read_to_string(page).unwrap();
    assert!(page.contains("The model; not drawn: 1 vertex that has a coordinate that is not finite"));
    let view = answer(&["view", "-o", argument(&files.path("b.html"))], &files.broken);
    assert_eq!(view["triangles"], 18 - 6);
}

#[test]
fn results_that_keep_the_vertex_keep_its_coordinates() {
    let files = Files::new();
    let made = |name: &str, verb: &[&str]| {
        let target = files.path(name);
        let run =
            coface(&[&[verb[0], argument(&files.broken)], &verb[1..], &["-o", argument(&target)]].concat());
        assert_eq!(run.status, 0, "{}", run.stderr);
        std::fs::read_to_string(target).unwrap()
    };
    let vertex = "v 1 NaN -inf\n";
    assert!(made("copy.obj", &["convert"]).contains(vertex));
    assert!(made("cut.obj", &["cut"]).contains(vertex));
    assert!(made("star.obj", &["closure", "--simplices", "0 4"]).contains(vertex));
    assert!(!made("link.obj", &["link", "--simplices", "4"]).contains("NaN"));
    assert!(
        !made("cover.obj", &["cover", "--radius", "1"]).contains("NaN"),
        "copies have places of their own"
    );
    // Vertices 0 and 8 are merged, the one without a place stays what it is.
    let welded = made("welded.obj", &["convert", "--repair", "--weld", "1e-3"]);
    assert_eq!(welded.matches(vertex).count(), 1);
    assert_eq!(welded.lines().filter(|line| line.starts_with("v ")).count(), 9);
}

#[test]
fn welding_merges_finite_vertices_alone() {
    let files = Files::new();
    let path = files.path("seam.obj");
    // Two triangles along a seam whose vertices are there twice; two vertices have no place, and are not one vertex for that.
    std::fs::write(&path, "v 0 0 0\nv 0 1 0\nv nan 0 0\nv 0 0 0\nv 0 1 0\nv nan 0 0\nf 1 2 3\nf 5 4 6\n")
        .unwrap();
    let out = files.path("welded.off");
    let run =
        coface(&["convert", argument(&path), "--repair", "--weld", "0", "-o", argument(&out), "--json"]);
    let answer = run.json();
    assert_eq!(answer["counts"]["vertices"], 4, "{answer}");
    let text = std::fs::read_to_string(&out).unwrap();
    assert_eq!(text, "OFF\n4 2 0\n0 0 0\n0 1 0\nNaN 0 0\nNaN 0 0\n3 0 1 2\n3 1 0 3\n");
    // The hole, a triangle, is closed without looking at places.
    let closed =
        coface(&["convert", argument(&path), "--repair", "closed", "-o", argument(&out), "--json"]).json();
    assert_eq!(closed["output_format"], "off");
    let info = answer_of(&out);
    assert_eq!((&info["manifold"]["closed"], &info["area"]), (&json!(true), &Value::Null));
}

fn answer_of(path: &Path) -> Value {
    answer(&["info"], path)
}

#[test]
fn rows_of_a_batch_are_rows_of_reports() {
    let files = Files::new();
    let rows = files.path("rows.jsonl");
    let run =
        coface(&["batch", argument(&files.broken), argument(&files.whole), "-o", argument(&rows), "--quiet"]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    let text = std::fs::read_to_string(&rows).unwrap();
    let rows: Vec<Value> = text.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let of = |name: &str| rows.iter().find(|row| row["path"].as_str().unwrap().ends_with(name)).unwrap();
    let (broken, whole) = (of("broken.obj"), of("whole.obj"));
    assert!(broken["error"].is_null() && broken["area"].is_null() && !whole["area"].is_null());
    assert_eq!((&broken["f_vector"], &broken["homology"]), (&whole["f_vector"], &whole["homology"]));
    assert!(broken["warnings"][0].as_str().unwrap().contains("not finite"), "{broken}");
}
