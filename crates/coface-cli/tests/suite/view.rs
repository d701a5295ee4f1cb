//! The verb `view`: pages, and what is refused.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_reading};
use serde_json::Value;
use std::path::PathBuf;

/// A folder where models and answers are made by the program itself.
struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn file(&self, name: &str, text: &str) -> String {
        std::fs::write(self.path(name), text).unwrap();
        argument(&self.path(name)).to_owned()
    }

    /// A model by `coface generate`.
    fn generated(&self, words: &[&str], name: &str) -> String {
        let path = argument(&self.path(name)).to_owned();
        let run = coface(&[&["generate"], words, &["-o", &path, "-q"]].concat());
        assert_eq!(run.status, 0, "{}", run.stderr);
        path
    }

    /// The summary of a page and the scene in it.
    #[track_caller]
    fn view(&self, words: &[&str]) -> (Value, Value) {
        let page = self.path("page.html");
        let summary = coface(&[&["view"], words, &["-o", argument(&page), "--json", "-q"]].concat()).json();
        let text = std::fs::read_to_string(&page).unwrap();
        assert_eq!(summary["bytes"], text.len());
        let place = r#"<script type="application/json" id="scene">"#;
        let start = text.find(place).unwrap() + place.len();
        let end = start + text[start..].find("</script>").unwrap();
        (summary, serde_json::from_str(&text[start..end]).unwrap())
    }

    /// Writes an answer of the program.
    fn answer(&self, name: &str, words: &[&str]) -> String {
        let answer = coface(&[words, &["--json", "-q"]].concat()).json();
        self.file(name, &answer.to_string())
    }
}

fn names(summary: &Value, group: &str) -> Vec<String> {
    let layers = summary["layers"].as_array().unwrap().iter();
    let of_group = layers.filter(|layer| layer["group"] == group);
    of_group.map(|layer| layer["name"].as_str().unwrap().to_owned()).collect()
}

#[test]
fn a_page_has_the_model_the_report_and_generators() {
    let folder = Folder::new();
    let model = folder.generated(&["genus"], "two.obj");
    let generators = folder.answer("generators.json", &["homology", &model, "--generators"]);
    let (summary, scene) = folder.view(&[&model, "--with", &generators]);
    assert_eq!(summary["triangles"], 100);
    assert_eq!(names(&summary, "homology").iter().filter(|name| name.starts_with("H1")).count(), 4);
    assert_eq!((&scene["title"], &scene["report"]["genus"]), (&Value::from("two.obj"), &Value::from(2)));
    let (_, bare) = folder.view(&[&model, "--no-report"]);
    assert!(bare["report"].is_null());
}

#[test]
fn a_page_on_standard_output_is_the_one_in_a_file() {
    let folder = Folder::new();
    let model = folder.generated(&["sphere"], "sphere.off");
    let page = coface(&["view", &model, "-q"]);
    assert_eq!(page.status, 0, "{}", page.stderr);
    folder.view(&[&model]);
    assert_eq!(page.stdout, std::fs::read_to_string(folder.path("page.html")).unwrap());
}

#[test]
fn a_cut_has_a_domain_and_a_cover_a_picture() {
    let folder = Folder::new();
    let model = folder.generated(&["genus"], "two.obj");
    let [cut, cover] = ["cut.json", "cover.json"].map(|name| argument(&folder.path(name)).to_owned());
    assert_eq!(coface(&["cut", &model, "--simplify", "-o", &cut, "-q"]).status, 0);
    assert_eq!(coface(&["cover", &model, "--radius", "1", "-o", &cover, "-q"]).status, 0);
    let (summary, scene) = folder.view(&[&model, "--with", &cut, "--with", &cover]);
    let panes = ["fundamental domain", "universal cover in the disk of Poincare"];
    assert_eq!(summary["panes"], Value::from(panes.to_vec()));
    // Each seam on the surface has the color of its two sides in the domain.
    let sides = scene["panes"][0]["layers"].as_array().unwrap();
    for (place, seam) in names(&summary, "cut").iter().enumerate() {
        let layer = scene["layers"].as_array().unwrap().iter().find(|layer| layer["name"] == seam.as_str());
        let side = sides.iter().find(|side| side["name"] == format!("seam {}", place + 1));
        assert_eq!(layer.unwrap()["color"], side.unwrap()["color"]);
    }
    // Sides of copies are arcs: they have points between their ends, all in the disk.
    let sides = scene["panes"][1]["layers"].as_array().unwrap().iter();
    let mut arcs = sides.filter(|layer| layer["name"].as_str().unwrap().starts_with("side"));
    assert!(arcs.any(|layer| layer["lines"]["starts"].is_string()));
    // Nine copies, each with its word.
    let words =
        scene["panes"][1]["layers"].as_array().unwrap().last().unwrap()["labels"].as_array().unwrap().len();
    assert_eq!(words, 9);
}

#[test]
fn cells_of_arrangements_have_notes_and_signs() {
    let folder = Folder::new();
    let cube = |name: &str, low: f64| {
        let mut text = String::new();
        for corner in 0..8u8 {
            let [x, y, z] = [0, 1, 2].map(|axis| low + 2.0 * f64::from(corner >> axis & 1));
            text += &format!("v {x} {y} {z}\n");
        }
        text += "f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 2 4 8 6\nf 4 3 7 8\nf 3 1 5 7\n";
        folder.file(name, &text)
    };
    let (a, b) = (cube("a.obj", 0.0), cube("b.obj", 1.0));
    let cells = argument(&folder.path("cells.json")).to_owned();
    let facts = folder.answer("facts.json", &["arrange", &a, &b, "-o", &cells]);
    let (summary, scene) = folder.view(&[&cells, "--with", &facts]);
    assert_eq!(scene["notes"].as_array().unwrap().len(), 3);
    assert!(scene["notes"][1].as_str().unwrap().starts_with("volume 1, inside "), "{}", scene["notes"][1]);
    assert!(summary["triangles"].as_u64().unwrap() > 12);
    assert!(!scene["signs"].as_str().unwrap().is_empty());
    // Facts about other cells are refused.
    let run = coface(&["view", &a, "--with", &facts, "-o", argument(&folder.path("x.html"))]);
    let message = run.fails_with(1);
    assert!(message.contains("3 measures") && message.contains("computed from"), "{message}");
}

#[test]
fn sets_have_curves_knots_and_a_forest() {
    let folder = Folder::new();
    let text = r#"{"order":4,"curves":[{"points":[[0,0],[4,0],[5,2],[4,4],[0,4]],"kinks":[0,4]},
        {"points":[[1,1],[1,3],[3,3],[3,1]],"kinks":[]}]}"#;
    let (summary, scene) = folder.view(&[&folder.file("set.json", text)]);
    assert_eq!(names(&summary, "curves").len(), 2);
    assert_eq!(names(&summary, "knots"), ["knots", "kinks", "control points"]);
    assert_eq!(summary["panes"][0], "Hasse forest");
    assert_eq!(scene["report"]["order"], 4);
    let (summary, _) = folder.view(&[
        &folder.file("polygon.wkt", "POLYGON ((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1))")
    ]);
    assert_eq!(names(&summary, "regions"), ["region 0"]);
}

#[test]
fn what_is_wrong_is_marked() {
    let folder = Folder::new();
    let book =
        folder.file("book.obj", "v 0 0 0\nv 0 0 1\nv 1 0 0\nv 0 1 0\nv -1 -1 0\nf 1 2 3\nf 1 2 4\nf 1 2 5\n");
    let (summary, _) = folder.view(&[&book]);
    let witness = names(&summary, "witness");
    assert!(witness.contains(&"edges in three or more faces".to_owned()), "{witness:?}");
    assert_eq!(names(&summary, "boundary").len(), 3);
    let twisted = folder.file("twisted.off", "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 3 2 0\n");
    let (summary, _) = folder.view(&[&twisted]);
    assert_eq!(names(&summary, "witness"), ["orientation conflict"]);
}

#[test]
fn answers_about_other_models_are_refused() {
    let folder = Folder::new();
    let [large, small] = [("torus", "large.obj"), ("csaszar", "small.obj")]
        .map(|(word, name)| folder.generated(&[word], name));
    let generators = folder.answer("generators.json", &["homology", &large, "--generators"]);
    let page = folder.path("page.html");
    let run = coface(&["view", &small, "--with", &generators, "-o", argument(&page)]);
    let message = run.fails_with(1);
    assert!(message.contains("the model has 7 vertices") && message.contains("generators.json"), "{message}");
    assert!(!page.exists());
    let cover = argument(&folder.path("cover.json")).to_owned();
    assert_eq!(coface(&["cover", &large, "--copies", "2", "-o", &cover, "-q"]).status, 0);
    assert!(
        coface(&["view", &small, "--with", &cover, "-o", argument(&page)]).fails_with(1).contains("vertex")
    );
}

#[test]
fn edges_that_the_model_lacks_are_refused() {
    let folder = Folder::new();
    let model = folder.generated(&["torus"], "torus.obj");
    let page = folder.path("page.html");
    for other in ["{\"simplices\":[[0,1],[1,577]]}", "[[1,[0,1]],[2.5,[1,577]]]"] {
        let other = folder.file("star.json", other);
        let message =
            coface(&["view", &model, "--with", &other, "-o", argument(&page)]).fails_with(1).to_owned();
        assert!(message.contains("the model has no edge from vertex 1 to vertex 577"), "{message}");
    }
    // Over points alone, a complex of them may have any edges.
    let points = folder.file("points.csv", "0,0\n1,0\n0,1\n");
    let edge = folder.file("edge.json", "{\"simplices\":[[0,2]]}");
    assert_eq!(coface(&["view", &points, "--with", &edge, "-o", argument(&page)]).status, 0);
}

#[test]
fn pages_are_written_into_files_of_pages() {
    let folder = Folder::new();
    let model = folder.generated(&["csaszar"], "torus.obj");
    for name in ["x.pdf", "x.png", "x.svg", "x.vtp"] {
        let path = folder.path(name);
        for words in [["view", &model, "-o", argument(&path)], ["info", &model, "--html", argument(&path)]] {
            assert!(coface(&words).fails_with(1).contains("end the name in .html"), "{name}");
        }
        assert!(!path.exists());
    }
}

#[test]
fn standard_input_may_hold_splines() {
    let folder = Folder::new();
    let text = r#"{"order":4,"curves":[{"points":[[0,0],[4,0],[5,2],[4,4],[0,4]],"kinks":[0,4]}]}"#;
    let page = folder.path("page.html");
    let words = ["view", "-", "-o", argument(&page), "--json"];
    let summary = coface_reading(&words, text.as_bytes()).json();
    assert_eq!(names(&summary, "knots"), ["knots", "kinks", "control points"]);
    let drawn = coface_reading(&["render", "-", "-q"], text.as_bytes());
    let file = coface(&["render", &folder.file("set.json", text), "-q"]);
    assert_eq!(drawn.stdout.replace("standard input", "set.json"), file.stdout);
    // What is no set is a model.
    let summary = coface_reading(&words, b"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").json();
    assert_eq!(summary["triangles"], 1);
}

#[test]
fn answers_without_numbers_are_refused() {
    let folder = Folder::new();
    let model = folder.generated(&["csaszar"], "torus.obj");
    let result = folder.file("result.json", "{\"simplices\": [[0, 1], [2, \"three\"]]}");
    for (verb, name) in [("view", "page.html"), ("render", "page.svg")] {
        let run = coface(&[verb, &model, "--with", &result, "-o", argument(&folder.path(name))]);
        let message = run.fails_with(1);
        assert!(message.contains("simplices[1][1] is \"three\", not the number of a vertex"), "{message}");
    }
}

#[test]
fn what_is_no_answer_is_refused() {
    let folder = Folder::new();
    let model = folder.generated(&["csaszar"], "torus.obj");
    for (text, said) in [
        ("{\"betti\": [1, 2, 1]}", "nothing that could be shown"),
        ("{\"generators\": ", "give the JSON that another verb of coface wrote"),
        ("[1, 2]", "write a chain as"),
    ] {
        let result = folder.file("result.json", text);
        let run = coface(&["view", &model, "--with", &result, "-o", argument(&folder.path("page.html"))]);
        let message = run.fails_with(1);
        assert!(message.contains(said) && message.contains("result.json"), "{message}");
    }
    let run = coface(&["view", &model, "--with", argument(&folder.path("missing.json"))]);
    assert!(run.fails_with(1).contains("missing.json: there is no such file"));
}

#[test]
fn no_name_ends_the_scene() {
    let folder = Folder::new();
    let model = folder.generated(&["csaszar"], "torus.obj");
    let odd = folder.path("a<!--<script>.obj");
    std::fs::rename(&model, &odd).unwrap();
    let text = r#"{"order":2,"curves":[{"points":[[0,0],[1,0],[0,1]],"name":"</script><script>alert(1)</script>"}]}"#;
    let set = folder.file("set.json", text);
    let (_, scene) = folder.view(&[&set]);
    let curve = scene["layers"].as_array().unwrap().iter().find(|layer| layer["name"] == "curve 0").unwrap();
    assert!(curve["detail"].as_str().unwrap().contains("</script>"), "{curve}");
    let (_, scene) = folder.view(&[argument(&odd)]);
    assert_eq!(scene["title"], "a<!--<script>.obj");
}

#[test]
fn a_page_goes_to_a_folder_that_is_there() {
    let folder = Folder::new();
    let model = folder.generated(&["csaszar"], "torus.obj");
    let page = folder.path("nowhere/page.html");
    let run = coface(&["view", &model, "-o", argument(&page), "-q"]);
    assert!(run.fails_with(1).contains("nowhere"), "{}", run.stderr);
}
