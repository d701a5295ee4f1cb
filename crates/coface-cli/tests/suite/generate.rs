//! Models made by rule, asked about by the program itself.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_reading};
use serde_json::{Value, json};

/// Runs `coface generate` with these words and lets `coface info` read what comes out, through a pipe where it is text.
fn made(words: &str, format: &str) -> Value {
    let folder = tempfile::tempdir().unwrap();
    let target = folder.path().join(format!("model.{format}"));
    let mut arguments = vec!["generate"];
    arguments.extend(words.split(' '));
    let is_text = !["ply", "stl"].contains(&format);
    arguments.extend(if is_text { ["--to", format] } else { ["-o", argument(&target)] });
    let model = coface(&arguments);
    assert_eq!((model.status, model.stderr.as_str()), (0, ""), "{words}");
    if is_text {
        return coface_reading(&["info", "--json", "-"], model.stdout.as_bytes()).json();
    }
    coface(&["info", "--json", argument(&target)]).json()
}

fn betti(report: &Value) -> Vec<u64> {
    report["homology"].as_array().unwrap().iter().map(|group| group["betti"].as_u64().unwrap()).collect()
}

#[test]
fn surfaces_are_what_they_are_called() {
    // Words, format, f-vector, name, genus, orientable, boundary loops.
    let table = [
        ("sphere --subdivisions 2", "off", json!([42, 120, 80]), "sphere", json!(0), true, 0),
        (
            "sphere --kind latitude --meridians 6 --bands 3",
            "obj",
            json!([14, 36, 24]),
            "sphere",
            json!(0),
            true,
            0,
        ),
        ("sphere --subdivisions 2 --cuboids", "ply", json!([26, 48, 24]), "sphere", json!(0), true, 0),
        ("torus --columns 6 --rows 5", "off", json!([30, 90, 60]), "torus", json!(1), true, 0),
        ("genus --genus 3 --cuboids", "off", json!([64, 136, 68]), "genus-3 surface", json!(3), true, 0),
        ("genus --genus 0", "stl", json!([16, 42, 28]), "sphere", json!(0), true, 0),
        ("csaszar", "off", json!([7, 21, 14]), "torus", json!(1), true, 0),
        ("klein --columns 8 --rows 7", "off", json!([56, 168, 112]), "Klein bottle", json!(2), false, 0),
        (
            "klein --space 4 --columns 8 --rows 7 --cuboids",
            "off",
            json!([56, 112, 56]),
            "Klein bottle",
            json!(2),
            false,
            0,
        ),
        (
            "moebius --columns 8 --rows 1 --cuboids",
            "obj",
            json!([16, 24, 8]),
            "Moebius band",
            json!(1),
            false,
            1,
        ),
        ("disk --rings 1 --sectors 6", "off", json!([7, 12, 6]), "disk", json!(0), true, 1),
        (
            "disk --kind square --subdivisions 2 --cuboids",
            "off",
            json!([9, 12, 4]),
            "disk",
            json!(0),
            true,
            1,
        ),
        ("ring --rings 1 --sectors 8", "off", json!([16, 32, 16]), "annulus", json!(0), true, 2),
        (
            "cylinder --sectors 6 --layers 1 --cuboids",
            "off",
            json!([12, 18, 6]),
            "annulus",
            json!(0),
            true,
            2,
        ),
        ("crown --columns 6 --rows 2 --cuboids", "off", json!([18, 30, 12]), "annulus", json!(0), true, 2),
        ("cone --sectors 6 --layers 1", "off", json!([7, 12, 6]), "disk", json!(0), true, 1),
        ("helicoid --rings 1 --segments 5 --cuboids", "off", json!([12, 16, 5]), "disk", json!(0), true, 1),
        ("grid --shape 10,10", "off", json!([121, 320, 200]), "disk", json!(0), true, 1),
        (
            "box --shape 2,1,1 --sizes 2,1,1 --cuboids --boundary",
            "off",
            json!([12, 20, 10]),
            "sphere",
            json!(0),
            true,
            0,
        ),
        ("rp2", "json", json!([6, 15, 10]), "projective plane", json!(1), false, 0),
        ("small-klein", "json", json!([8, 24, 16]), "Klein bottle", json!(2), false, 0),
        ("klein-grid", "json", json!([25, 75, 50]), "Klein bottle", json!(2), false, 0),
        ("strip", "json", json!([5, 10, 5]), "Moebius band", json!(1), false, 1),
        ("cyclic-torus", "json", json!([7, 21, 14]), "torus", json!(1), true, 0),
        ("torus-grid --shape 3,4", "json", json!([12, 36, 24]), "torus", json!(1), true, 0),
        ("simplex-boundary", "json", json!([4, 6, 4]), "sphere", json!(0), true, 0),
        ("cross-polytope", "json", json!([6, 12, 8]), "sphere", json!(0), true, 0),
        ("simplex --boundary", "off", json!([4, 6, 4]), "sphere", json!(0), true, 0),
    ];
    for (words, format, f_vector, name, genus, orientable, loops) in table {
        let report = made(words, format);
        assert_eq!(report["f_vector"], f_vector, "{words}");
        assert_eq!(report["name"], name, "{words}");
        assert_eq!(report["genus"], genus, "{words}");
        assert_eq!(report["orientable"], orientable, "{words}");
        assert_eq!(report["boundary_loops"], loops, "{words}");
        assert_eq!(report["manifold"]["verdict"], "yes", "{words}");
        if format != "json" {
            assert_eq!(report["coherently_oriented"], orientable, "{words}");
        }
    }
}

#[test]
fn solids_curves_and_spaces_have_their_homology() {
    let table: [(&str, &str, Value, &[u64]); 28] = [
        ("simplex", "vtk", json!([4, 6, 4, 1]), &[1, 0, 0, 0]),
        ("simplex --dimension 5", "json", json!([6, 15, 20, 15, 6, 1]), &[1, 0, 0, 0, 0, 0]),
        ("grid --shape 10,10,1", "mesh", json!([242, 1081, 1440, 600]), &[1, 0, 0, 0]),
        ("grid --shape 1,1,1,1", "json", json!([16, 65, 110, 84, 24]), &[1, 0, 0, 0, 0]),
        ("cuboids --shape 4,4,4", "msh", json!([125, 300, 240, 64]), &[1, 0, 0, 0]),
        ("cuboids --lengths 1,-1,1 --lengths 2", "off", json!([8, 8, 2]), &[2, 0, 0]),
        ("cuboids --shape 2,2,2,1", "json", json!([54, 135, 126, 52, 8]), &[1, 0, 0, 0, 0]),
        ("cuboids --shape 2,2 --skeleton 1", "vtk", json!([9, 12]), &[1, 4]),
        ("cuboids --shape 2,2,2 --boundary", "off", json!([26, 48, 24]), &[1, 0, 1]),
        ("box --shape 2,2,1", "mesh", json!([18, 57, 64, 24]), &[1, 0, 0, 0]),
        ("ball --subdivisions 2 --cuboids", "vtk", json!([27, 54, 36, 8]), &[1, 0, 0, 0]),
        ("rod --subdivisions 2 --layers 1 --cuboids", "vtk", json!([18, 33, 20, 4]), &[1, 0, 0, 0]),
        ("solid-torus --subdivisions 1 --sectors 3 --cuboids", "vtk", json!([12, 24, 15, 3]), &[1, 1, 0, 0]),
        (
            "hollow-cylinder --shells 1 --sectors 3 --layers 1 --cuboids",
            "vtk",
            json!([12, 24, 15, 3]),
            &[1, 1, 0, 0],
        ),
        ("hollow-ball --subdivisions 1 --shells 1 --cuboids", "vtk", json!([16, 32, 24, 6]), &[1, 0, 1, 0]),
        ("genus --genus 2 --solid --cuboids", "vtk", json!([48, 100, 64, 13]), &[1, 2, 0, 0]),
        ("circle --segments 5", "vtk", json!([5, 5]), &[1, 1]),
        ("helix --segments 5", "vtk", json!([6, 5]), &[1, 0]),
        ("pinched-torus", "json", json!([35, 108, 72]), &[1, 3, 1]),
        ("cp2", "json", json!([9, 36, 84, 90, 36]), &[1, 0, 1, 0, 1]),
        ("k3", "json", json!([16, 120, 560, 720, 288]), &[1, 0, 22, 0, 1]),
        ("dunce-hat", "json", json!(null), &[1, 0, 0]),
        ("house", "json", json!(null), &[1, 0, 0]),
        ("torus-bundle --matrix 2,1,1,1", "json", json!(null), &[1, 1, 1, 1]),
        ("flat --manifold g6", "json", json!([128, 896, 1536, 768]), &[1, 0, 0, 1]),
        ("book --pages 4", "json", json!([6, 9, 4]), &[1, 0, 0]),
        ("barnette", "json", json!([8, 27, 38, 19]), &[1, 0, 0, 1]),
        ("sphere-bundle", "json", json!([9, 36, 54, 27]), &[1, 1, 0, 0]),
    ];
    for (words, format, f_vector, expected) in table {
        let report = made(words, format);
        if !f_vector.is_null() {
            assert_eq!(report["f_vector"], f_vector, "{words}");
        }
        assert_eq!(betti(&report), expected, "{words}");
    }
}

#[test]
fn torsion_comes_from_the_parameters() {
    let table = [
        ("lens --p 7 --q 3", json!(["7"])),
        ("moore --order 4", json!(["4"])),
        ("rp --dimension 3", json!(["2"])),
        ("poincare", json!([])),
        ("weber-seifert", json!(["5", "5", "5"])),
        ("glued-solid --solid cube --steps 1", json!(["2", "2"])),
        ("prism-manifold --n 3", json!(["4"])),
        ("truncated-cube", json!(["2"])),
        ("presentation --generators 1 --relator 1,1,1", json!(["3"])),
        ("presentation --generators 2 --relator 1,2,-1,-2 --relator=-2,-2", json!(["2"])),
    ];
    for (words, torsion) in table {
        let report = made(words, "json");
        let found: Vec<String> = report["homology"][1]["torsion"]
            .as_array()
            .unwrap()
            .iter()
            .map(|order| order.to_string().trim_matches('"').to_owned())
            .collect();
        assert_eq!(json!(found), torsion, "{words}");
    }
}

#[test]
fn other_families_answer_too() {
    for words in
        ["hp2", "chessboard", "matching --count 5", "sum-complex", "bruckner", "rudin-ball", "ziegler-ball"]
    {
        let mut arguments = vec!["generate", "--json"];
        arguments.extend(words.split(' '));
        let object = coface(&arguments).json();
        assert!(object["f_vector"].as_array().unwrap().len() >= 2, "{words}");
    }
}

#[test]
fn a_summary_is_printed_without_a_file() {
    let object = coface(&["generate", "box", "--sizes", "1,2,3", "--json"]).json();
    assert_eq!(object["bounding_box"], json!([[0.0, 0.0, 0.0], [1.0, 2.0, 3.0]]));
    assert_eq!(
        (object["f_vector"].clone(), object["euler_characteristic"].clone()),
        (json!([8, 19, 18, 6]), json!(1))
    );
    let page = coface(&["generate", "box", "--sizes", "1,2,3"]);
    assert_eq!(page.status, 0);
    assert!(
        page.stdout.contains("8 19 18 6") && page.stdout.contains("(0 0 0) to (1 2 3)"),
        "{}",
        page.stdout
    );
    let huge = coface(&["generate", "circle", "--radius", "1e300", "--segments", "4"]);
    assert!(huge.stdout.contains("to (1.00000e300 1.00000e300)"), "{}", huge.stdout);
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("a.off");
    let run = coface(&["generate", "torus", "-o", argument(&path)]);
    assert_eq!((run.status, run.stdout.as_str()), (0, ""));
    let object = coface(&["generate", "torus", "-o", argument(&path), "--json"]).json();
    assert_eq!(object["output_format"], "off");
    assert_eq!(object["f_vector"], coface(&["info", "--json", argument(&path)]).json()["f_vector"]);
}

#[test]
fn prisms_and_products_of_files() {
    let folder = tempfile::tempdir().unwrap();
    let path = |name: &str| folder.path().join(name);
    for (name, words) in [
        ("square.off", "grid --shape 1,1"),
        ("circle.vtk", "circle --segments 4"),
        ("cube.mesh", "cuboids --shape 1,1,1"),
        ("tetrahedron.json", "simplex-boundary"),
    ] {
        let target = path(name);
        let mut arguments = vec!["generate", "-o", argument(&target)];
        arguments.extend(words.split(' '));
        assert_eq!(coface(&arguments).status, 0);
    }
    let run = |words: &[&str]| coface(&[&["generate", "--json"], words].concat()).json();
    let square = path("square.off");
    let object = run(&["prism", argument(&square), "--layers", "1,-1,1"]);
    assert_eq!(object["f_vector"], json!([16, 38, 36, 12]));
    assert_eq!(object["bounding_box"], json!([[0.0, 0.0, 0.0], [1.0, 1.0, 3.0]]));
    let solid = path("solid.mesh");
    coface(&["generate", "extrude", argument(&square), "-o", argument(&solid)]);
    let report = coface(&["info", "--json", argument(&solid)]).json();
    assert_eq!((report["signed_volume"].as_f64(), &report["coherently_oriented"]), (Some(1.0), &json!(true)));
    let (circle, tetrahedron, cube) = (path("circle.vtk"), path("tetrahedron.json"), path("cube.mesh"));
    let tube = path("tube.off");
    coface(&["generate", "prism", argument(&circle), "--direction", "0,1,5", "-o", argument(&tube)]);
    let report = coface(&["info", "--json", argument(&tube)]).json();
    assert_eq!((&report["name"], &report["f_vector"]), (&json!("annulus"), &json!([8, 16, 8])));
    assert_eq!(run(&["prism", argument(&tetrahedron)])["f_vector"], json!([8, 22, 28, 12]));
    assert_eq!(run(&["product", argument(&circle), argument(&circle)])["f_vector"], json!([16, 48, 32]));
    let product = run(&["product", argument(&circle), argument(&circle), "--chains"]);
    assert_eq!(product["f_vector"], json!([16, 32, 16]));
    let product = run(&["product", argument(&cube), argument(&circle)]);
    assert_eq!(product["f_vector"], json!([32, 80, 72, 28, 4]));
    let message = coface(&["generate", "prism", argument(&cube)]).fails_with(1).to_owned();
    assert!(message.contains("cube.mesh: only points, segments and triangles"), "{message}");
    let message = coface(&["generate", "prism", argument(&square), "--layers", "0"]).fails_with(1).to_owned();
    assert!(message.contains("square.off"), "{message}");
}

#[test]
fn families_have_other_names() {
    for (other, name) in [("cube", "box"), ("annulus", "ring"), ("projective-plane", "rp2")] {
        let [found, expected] =
            [other, name].map(|family| coface(&["generate", family, "--to", "json"]).stdout);
        assert!(!found.is_empty() && found == expected, "{other}");
    }
    let (run, report) = scene(r#"[{"shape":"cube","sizes":[1,2,3]}]"#, "cube.vtk");
    assert_eq!((run.status, report["signed_volume"].clone()), (0, json!(6.0)), "{}", run.stderr);
    let help = coface(&["generate", "--help"]);
    assert!(help.stdout.contains("cube"), "{}", help.stdout);
}

/// Writes a scene beside a file that it names, and makes a model of it.
fn scene(text: &str, target: &str) -> (crate::program::Run, Value) {
    let folder = tempfile::tempdir().unwrap();
    let (scene, part) = (folder.path().join("scene.json"), folder.path().join("part.obj"));
    std::fs::write(&scene, text).unwrap();
    std::fs::write(&part, "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 2 0 0\nf 1 2 3 4\nf 2 5 3\n").unwrap();
    let target = folder.path().join(target);
    let run = coface(&["generate", "assembly", argument(&scene), "-o", argument(&target)]);
    let report =
        if run.status == 0 { coface(&["info", "--json", argument(&target)]).json() } else { Value::Null };
    (run, report)
}

#[test]
fn scenes_put_things_in_their_places() {
    let (run, report) = scene(
        r#"{"assembly":[{"shape":"sphere","subdivisions":1},
            [{"translate":[5,0,0]},{"rotate":{"axis":[1,1,1],"degrees":120}},{"shape":"torus","columns":4,"rows":3}],
            {"scale":[1,1,-1]},{"translate":[0,0,9]},{"shape":"box","sizes":[1,2,3],"cuboids":true,"boundary":false}]}"#,
        "a.vtk",
    );
    // "boundary" belongs to the verb, not to shapes; false leaves a switch out.
    assert_eq!(run.status, 0, "{}", run.stderr);
    assert_eq!((report["components"].clone(), report["signed_volume"].clone()), (json!(3), json!(6.0)));
    let (run, report) = scene(
        r#"[{"file":"part.obj"},{"matrix":[[0,-1,0,4],[1,0,0,0],[0,0,1,0]]},{"file":"part.obj"}]"#,
        "b.obj",
    );
    assert_eq!(run.status, 0, "{}", run.stderr);
    assert_eq!((report["f_vector"].clone(), report["area"].as_f64()), (json!([10, 12, 4]), Some(3.0)));
    assert_eq!(report["components"], 2);
    let (run, report) = scene(
        r#"{"dimension":2,"assembly":[{"scale":[-1,1]},{"rotate":{"plane":[0,1],"degrees":45}},{"shape":"disk"}]}"#,
        "c.off",
    );
    assert_eq!(run.status, 0, "{}", run.stderr);
    assert_eq!((&report["name"], &report["coherently_oriented"]), (&json!("disk"), &json!(true)));
}

#[test]
fn faults_in_scenes_are_named_by_their_place() {
    let table = [
        ("[1]", "item 0: 1 is no item of a scene"),
        ("{}", "a scene is a list of items"),
        ("[", "scene.json:1: this is no JSON"),
        (r#"{"assembly":[],"scale":2}"#, "no key \"scale\""),
        (r#"{"dimension":0,"assembly":[]}"#, "0 is no dimension of a space"),
        (r#"[{"shape":"sphere"},[{"translate":[1,2]}]]"#, "item 1.0: [1,2] is no list of 3 numbers"),
        (r#"[{"scale":[1,0,1]}]"#, "item 0: the map flattens the space"),
        (r#"[{"shape":"spere"}]"#, "item 0: the shape \"spere\": unrecognized subcommand 'spere'"),
        (r#"[{"shape":"sphere","radius":-1}]"#, "item 0: the radius is -1; give a positive number"),
        (
            r#"[{"shape":"sphere","radius":"big"}]"#,
            "item 0: the shape \"sphere\": invalid value 'big' for '--radius",
        ),
        (r#"[{"shape":"sphere","diameter":1}]"#, "unexpected argument '--diameter' found"),
        (r#"[{"turn":90}]"#, "item 0: no item of a scene has the key \"turn\""),
        (r#"[{"rotate":{"degrees":90}}]"#, "item 0: {\"degrees\":90} is no rotation"),
        (
            r#"[{"rotate":{"plane":[0,3],"degrees":90}}]"#,
            "item 0: the axes 0 and 3 span no plane of dimension 3",
        ),
        (r#"[{"matrix":[[1,0],[0,1]]}]"#, "item 0: this is no matrix of an affine map of dimension 3"),
        (r#"[{"file":"none.obj"}]"#, "none.obj"),
        (r#"[[[{"file":3}]]]"#, "item 0.0.0: 3 is no name of a file"),
        (
            r#"{"dimension":2,"assembly":[{"shape":"ball"}]}"#,
            "item 0: positions of dimension 3 in a scene of dimension 2",
        ),
        (
            r#"{"dimension":4,"assembly":[{"shape":"simplex","dimension":4}]}"#,
            "item 0 has cells of dimension 4",
        ),
        (r#"[{"translate":[1,2,3],"scale":[1,1,1]}]"#, "item 0: an item has one key, this one 2"),
    ];
    for (text, expected) in table {
        let (run, _) = scene(text, "a.off");
        let message = run.fails_with(1);
        assert!(message.contains(expected) && message.contains("scene.json"), "{text}: {message}");
    }
}

#[test]
fn wrong_parameters_say_what_is_possible() {
    let table: [(&[&str], i32, &str); 16] = [
        (&["sphere", "--radius", "-1"], 1, "the radius is -1; give a positive number"),
        (&["sphere", "--radius", "nan"], 1, "the radius is NaN"),
        (&["sphere", "--kind", "ico", "--cuboids"], 1, "take triangles, or the grid of a cube"),
        (&["torus", "--columns", "2"], 1, "the number of columns is 2; take 3 or more"),
        (&["torus", "--columns", "many"], 2, "invalid value 'many'"),
        (&["torus", "--boundary"], 1, "the model has no boundary"),
        (&["rp2", "--boundary"], 1, "no boundary"),
        (&["grid", "--shape", "2,2", "--skeleton", "3"], 1, "no skeleton of dimension 3"),
        (&["grid", "--shape", "100000,100000"], 1, "2^32 - 1"),
        (&["lens", "--p", "4", "--q", "2"], 1, "coprime"),
        (&["torus-bundle", "--matrix", "1,2"], 1, "four integers"),
        (&["cuboids", "--lengths=-1"], 1, "the grid is empty"),
        (&["strip", "--vertices", "4294967295"], 1, "5 to 2^24"),
        (&["book", "--pages", "2000000000"], 1, "up to 2^24"),
        (&["simplex", "--dimension", "24"], 2, "0..=20"),
        (&["dodo"], 2, "unrecognized subcommand"),
    ];
    for (words, status, expected) in table {
        let run = coface(&[&["generate"], words].concat());
        assert_eq!((run.status, run.stdout.as_str()), (status, ""), "{words:?}: {}", run.stderr);
        assert!(run.stderr.contains(expected), "{words:?}: {}", run.stderr);
    }
    for direction in ["0,0,-0", "0,nan,1"] {
        let words = ["generate", "prism", "-", "--direction", direction];
        let run = coface_reading(&words, b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        assert!(run.fails_with(1).contains("is no direction; give finite numbers"), "{}", run.stderr);
    }
    let missing = coface(&["generate", "assembly", "no/such.json"]);
    assert!(missing.fails_with(1).contains("the scene cannot be read"), "{}", missing.stderr);
    let both = coface(&["generate", "torus", "--to", "off", "--json"]);
    assert!(both.fails_with(1).contains("cannot hold both"));
    let unknown = coface(&["generate", "torus", "-o", "a.docx"]);
    assert!(unknown.fails_with(1).contains("is no format known here; end it in one of off, obj"));
}

/// The boundary of cells of several kinds: triangles of tetrahedra and squares of cuboids.
#[test]
fn assemblies_have_a_boundary_and_skeletons() {
    let folder = tempfile::tempdir().unwrap();
    let (scene, target) = (folder.path().join("scene.json"), folder.path().join("out.obj"));
    std::fs::write(
        &scene,
        r#"[{"shape":"box","cuboids":true},{"translate":[5,0,0]},{"shape":"box","cuboids":false}]"#,
    )
    .unwrap();
    let report = |options: &[&str]| {
        let words = ["generate", "assembly", argument(&scene), "-o", argument(&target)];
        let run = coface(&[&words[..], options].concat());
        assert_eq!(run.status, 0, "{}", run.stderr);
        coface(&["info", "--json", argument(&target)]).json()
    };
    let surface = report(&["--boundary"]);
    assert_eq!((&surface["components"], &surface["boundary_loops"]), (&json!(2), &json!(0)));
    assert_eq!((&surface["euler_characteristic"], &surface["signed_volume"]), (&json!(4), &json!(2.0)));
    let edges = report(&["--skeleton", "1"]);
    assert_eq!((&edges["dimension"], &edges["components"]), (&json!(1), &json!(2)));
}
