//! Every verb, on small models that are made here and on the model shipped in `data/`.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_in, coface_reading};
use serde_json::{Value, json};
use std::path::{Path, PathBuf};

/// The model that is shipped in `data/`.
fn spot() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/spot.obj")
}

/// The projective plane with six vertices.
const PLANE: &str =
    r#"{"facets":[[0,1,2],[0,1,5],[0,2,4],[0,3,4],[0,3,5],[1,2,3],[1,3,4],[1,4,5],[2,3,5],[2,4,5]]}"#;
/// Three triangles on the edge 0 1, and the isolated vertex 9.
const BOOK: &str = r#"{"facets":[[0,1,2],[0,1,3],[0,1,4],[9]]}"#;
/// A square of two triangles as OFF, the second triangle running against the first.
const SQUARE: &str = "OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 3 2 0\n";
/// A unit cube of one hexahedron as MEDIT.
const CUBE: &str = "MeshVersionFormatted 2\nDimension 3\nVertices\n8\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n0 0 1 0\n\
    1 0 1 0\n1 1 1 0\n0 1 1 0\nHexahedra\n1\n1 2 3 4 5 6 7 8 0\nEnd\n";
/// The torus of one vertex, three edges and two triangles.
const TORUS: &str = r#"{"next":[2,3,4,5,0,1]}"#;

fn reading(arguments: &[&str], input: &str) -> Value {
    coface_reading(arguments, input.as_bytes()).json()
}

fn groups(groups: &Value) -> Vec<String> {
    let one = |group: &Value| format!("{}{}", group["betti"], group["torsion"]);
    groups.as_array().unwrap().iter().map(one).collect()
}

/// A folder with a file in it.
fn file(name: &str, text: &str) -> (tempfile::TempDir, PathBuf) {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    (folder, path)
}

#[test]
fn info_has_every_key_with_its_type() {
    let report = coface(&["info", argument(&spot()), "--json"]).json();
    for key in ["file", "format", "kind", "name"] {
        assert!(report[key].is_string(), "{key}");
    }
    for key in ["dimension", "components", "euler_characteristic", "boundary_loops", "genus"] {
        assert!(report[key].is_i64(), "{key}");
    }
    for key in ["pure", "orientable", "coherently_oriented"] {
        assert!(report[key].is_boolean(), "{key}");
    }
    for key in ["f_vector", "homology", "warnings"] {
        assert!(report[key].is_array(), "{key}");
    }
    for key in ["area", "signed_volume"] {
        assert!(report[key].is_f64(), "{key}");
    }
    assert_eq!(report["manifold"], json!({"verdict": "yes", "closed": true, "witness": null}));
    assert_eq!(report["homology"][2], json!({"degree": 2, "betti": 1, "torsion": []}));
    assert_eq!(
        (&report["format"], &report["kind"], &report["name"]),
        (&json!("obj"), &json!("surface"), &json!("sphere"))
    );
    assert_eq!(report["f_vector"], json!([2930, 8784, 5856]));
}

#[test]
fn info_names_what_is_wrong() {
    let report = reading(&["info", "--json", "-"], BOOK);
    assert_eq!(report["file"], "standard input");
    assert_eq!(
        (&report["f_vector"], &report["pure"], &report["components"]),
        (&json!([6, 7, 3]), &json!(false), &json!(2))
    );
    assert_eq!(report["manifold"]["verdict"], "no");
    assert_eq!(report["manifold"]["witness"]["cells"], json!([[0, 1]]));
    assert_eq!(
        (&report["orientable"], &report["genus"], &report["name"]),
        (&Value::Null, &Value::Null, &Value::Null)
    );
    let warnings = report["warnings"].to_string();
    assert!(warnings.contains("1 edge lies in three or more faces"), "{warnings}");
    let text = coface_reading(&["info", "-"], BOOK.as_bytes()).stdout;
    assert!(text.contains("{v0 v1} in f0 f1 f2") && text.contains("v9"), "{text}");
}

#[test]
fn info_tells_orientable_from_oriented() {
    let report = reading(&["info", "--json", "-", "--format", "off"], SQUARE);
    assert_eq!((&report["orientable"], &report["coherently_oriented"]), (&json!(true), &json!(false)));
    assert_eq!((&report["area"], &report["signed_volume"]), (&json!(1.0), &Value::Null));
    assert_eq!((&report["name"], &report["boundary_loops"]), (&json!("disk"), &json!(1)));
    let plane = reading(&["info", "--json", "-"], PLANE);
    assert_eq!((&plane["orientable"], &plane["genus"]), (&json!(false), &json!(1)));
    assert_eq!(
        (&plane["name"], groups(&plane["homology"])),
        (&json!("projective plane"), vec!["1[]".into(), "0[2]".into(), "0[]".into()])
    );
}

#[test]
fn info_of_a_volume() {
    let report = reading(&["info", "--json", "-"], CUBE);
    assert_eq!((&report["kind"], &report["f_vector"]), (&json!("volume"), &json!([8, 12, 6, 1])));
    assert_eq!(report["manifold"], json!({"verdict": "yes", "closed": false, "witness": null}));
    assert_eq!(
        (&report["signed_volume"], &report["boundary_loops"], &report["genus"]),
        (&json!(1.0), &Value::Null, &Value::Null)
    );
}

#[test]
fn info_of_halfedge_permutations() {
    let report = reading(&["info", "--json", "-"], TORUS);
    assert_eq!(
        (&report["kind"], &report["f_vector"], &report["name"]),
        (&json!("surface"), &json!([1, 3, 2]), &json!("torus"))
    );
    assert_eq!(
        (&report["genus"], groups(&report["homology"])),
        (&json!(1), vec!["1[]".into(), "2[]".into(), "1[]".into()])
    );
}

#[test]
fn info_of_several_files_is_one_object() {
    let (folder, good) = file("plane.json", PLANE);
    let bad = folder.path().join("missing.off");
    let both = coface(&["info", "--json", argument(&good), argument(&good)]).json();
    assert_eq!(both["reports"].as_array().unwrap().len(), 2);
    let run = coface(&["info", "--json", argument(&bad), argument(&good)]);
    assert_eq!(run.status, 1);
    let object: Value = serde_json::from_str(&run.stdout).unwrap();
    assert!(object["reports"][0]["error"].as_str().unwrap().contains("missing.off"));
    assert_eq!(object["reports"][1]["name"], "projective plane");
    assert!(run.stderr.starts_with("error: "), "{}", run.stderr);
}

#[test]
fn info_writes_its_report() {
    let (folder, input) = file("plane.json", PLANE);
    let text = folder.path().join("report.txt");
    let run = coface(&["info", argument(&input), "-o", argument(&text)]);
    assert_eq!((run.status, run.stdout.as_str()), (0, ""));
    let page = std::fs::read_to_string(&text).unwrap();
    assert!(page.contains("projective plane") && !page.contains('\u{1b}'), "{page}");
    let object = folder.path().join("report.json");
    let printed = coface(&["info", argument(&input), "--json", "-o", argument(&object)]).json();
    let written: Value = serde_json::from_str(&std::fs::read_to_string(&object).unwrap()).unwrap();
    assert_eq!(printed, written);
}

#[test]
fn the_page_fits_and_has_no_colors_in_a_pipe() {
    let page = coface(&["info", argument(&spot())]).stdout;
    assert!(page.lines().skip(1).all(|line| line.chars().count() <= 80), "{page}");
    assert!(!page.contains('\u{1b}'), "{page}");
    for word in ["sphere", "Euler", "V - E + F", "handles", "No problems"] {
        assert!(page.contains(word), "{word}: {page}");
    }
}

#[test]
fn the_answer_does_not_depend_on_threads() {
    let path = spot();
    let run = |threads| coface(&["info", argument(&path), "--json", "--threads", threads]).json();
    assert_eq!(run("1"), run("4"));
    let generators = |threads| {
        coface(&["homology", argument(&path), "--json", "--threads", threads, "--generators"]).json()
    };
    assert_eq!(generators("1"), generators("3"));
}

#[test]
fn homology_over_rings() {
    for (ring, expected) in [
        ("z", ["1[]", "0[2]", "0[]"]),
        ("q", ["1[]", "0[]", "0[]"]),
        ("f2", ["1[]", "1[]", "1[]"]),
        ("f3", ["1[]", "0[]", "0[]"]),
        ("z6", ["1[]", "0[2]", "0[2]"]),
    ] {
        let answer = reading(&["homology", "--json", "-", "--coefficients", ring], PLANE);
        assert_eq!(groups(&answer["homology"]), expected, "{ring}");
    }
    let answer = reading(&["homology", "--json", "-", "--cohomology"], PLANE);
    assert_eq!(groups(&answer["homology"]), ["1[]", "0[]", "0[2]"]);
    let text = coface_reading(&["homology", "-", "--coefficients", "f2"], PLANE.as_bytes()).stdout;
    assert!(text.contains("H_2 = Z/2"), "{text}");
}

#[test]
fn homology_relative_to_the_boundary_and_to_a_file() {
    let (_folder, part) = file("part.json", "[[0,1],[1,2],[0,2]]");
    let disk = "[[0,1,2]]";
    for relative in ["boundary", argument(&part)] {
        let answer = reading(&["homology", "--json", "-", "--relative", relative], disk);
        assert_eq!(groups(&answer["homology"]), ["0[]", "0[]", "1[]"], "{relative}");
    }
    let (_folder, stranger) = file("part.json", "[[0,7]]");
    let run = coface_reading(&["homology", "-", "--relative", argument(&stranger)], disk.as_bytes());
    assert!(run.fails_with(1).contains("[0, 7]"));
}

/// The boundary of a chain of edges, as the vertices with nonzero coefficients.
fn boundary(chain: &Value) -> Vec<(u64, i64)> {
    let mut sums = std::collections::BTreeMap::new();
    for term in chain.as_array().unwrap() {
        let (coefficient, ends) = (term[0].as_i64().unwrap(), term[1].as_array().unwrap());
        *sums.entry(ends[0].as_u64().unwrap()).or_insert(0) -= coefficient;
        *sums.entry(ends[1].as_u64().unwrap()).or_insert(0) += coefficient;
    }
    sums.into_iter().filter(|&(_, sum)| sum != 0).collect()
}

#[test]
fn generators_are_cycles_by_vertices() {
    let answer = reading(&["homology", "-", "--json", "--generators"], PLANE);
    let loops = answer["generators"][1].as_array().unwrap();
    assert_eq!((loops.len(), &loops[0]["order"]), (1, &json!(2)));
    assert_eq!(boundary(&loops[0]["chain"]), []);
    let edges = loops[0]["chain"].as_array().unwrap().len();
    assert!(
        edges >= 3 && edges % 2 == 1,
        "the loop of the six-vertex plane runs through an odd number of edges"
    );
    assert_eq!(answer["generators"][0][0]["order"], 0);
    let (folder, input) = file("plane.json", PLANE);
    let out = folder.path().join("generators.json");
    let run = coface(&["homology", argument(&input), "--generators", argument(&out)]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    let written: Value = serde_json::from_str(&std::fs::read_to_string(out).unwrap()).unwrap();
    assert_eq!(written["generators"], answer["generators"]);
}

#[test]
fn homology_of_a_chain_complex() {
    // A circle with a disk that runs along it three times.
    let chains =
        r#"{"boundaries":[{"rows":1,"cols":1,"entries":[]},{"rows":1,"cols":1,"entries":[[0,0,3]]}]}"#;
    let answer = reading(&["homology", "--json", "-"], chains);
    assert_eq!(groups(&answer["homology"]), ["1[]", "0[3]", "0[]"]);
    let report = reading(&["info", "--json", "-"], chains);
    assert_eq!((&report["kind"], &report["manifold"]["verdict"]), (&json!("complex"), &json!("unknown")));
}

#[test]
fn neighborhoods_in_the_book() {
    let ask = |verb: &str, simplices: &str| reading(&[verb, "-", "--json", "--simplices", simplices], BOOK);
    let star = ask("star", "0 1");
    assert_eq!(star["simplices"], json!([[0, 1], [0, 1, 2], [0, 1, 3], [0, 1, 4]]));
    assert_eq!((&star["f_vector"], &star["is_complex"]), (&json!([0, 1, 3]), &json!(false)));
    let link = ask("link", "0 1");
    assert_eq!((&link["simplices"], &link["is_complex"]), (&json!([[2], [3], [4]]), &json!(true)));
    let closure = ask("closure", "0 1; 9");
    assert_eq!(closure["simplices"], json!([[0], [1], [9], [0, 1]]));
    let boundary = ask("boundary", "0 1 2; 0 1 3");
    assert_eq!(boundary["f_vector"], json!([4, 4]));
    assert_eq!(
        boundary["simplices"].as_array().unwrap()[4..],
        [json!([0, 2]), json!([0, 3]), json!([1, 2]), json!([1, 3])]
    );
    let interior = ask("interior", "0 1 2; 0 1 3");
    assert_eq!(
        (&interior["simplices"], &interior["is_complex"]),
        (&json!([[0, 1], [0, 1, 2], [0, 1, 3]]), &json!(false))
    );
    let skeleton = reading(&["skeleton", "-", "--json", "--dimension", "1"], BOOK);
    assert_eq!((&skeleton["f_vector"], &skeleton["is_complex"]), (&json!([6, 7]), &json!(true)));
}

#[test]
fn the_link_in_a_closed_surface_is_a_cycle() {
    let path = spot();
    let link = coface(&["link", argument(&path), "--simplices", "17", "--json"]).json();
    let counts = link["f_vector"].as_array().unwrap();
    assert_eq!((counts.len(), &counts[0]), (2, &counts[1]));
    let nothing = coface(&["boundary", argument(&path), "--json"]).json();
    assert_eq!((&nothing["simplices"], &nothing["is_complex"]), (&json!([]), &json!(true)));
    let text = coface(&["star", argument(&path), "--simplices", "17"]).stdout;
    assert!(text.contains("not a complex"), "{text}");
}

#[test]
fn a_set_of_simplices_can_be_written() {
    let (folder, input) = file("square.off", SQUARE);
    let out = folder.path().join("part.off");
    let run = coface(&["closure", argument(&input), "--simplices", "0 2 3", "-o", argument(&out)]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    let part = coface(&["info", "--json", argument(&out)]).json();
    assert_eq!((&part["f_vector"], &part["area"]), (&json!([3, 3, 1]), &json!(0.5)));
    let facets = folder.path().join("part.json");
    coface(&["closure", argument(&input), "--simplices", "0 2 3", "-o", argument(&facets)]);
    assert!(std::fs::read_to_string(&facets).unwrap().replace(' ', "").contains("[0,2,3]"));
    let open = folder.path().join("open.off");
    let run = coface(&["star", argument(&input), "--simplices", "0", "-o", argument(&open)]);
    assert!(run.fails_with(1).contains("no complex"));
    assert!(!open.exists());
}

#[test]
fn drawings_keep_their_rings() {
    let map = r#"{"type":"Feature","properties":{"name":"isle"},"geometry":{"type":"Polygon","coordinates":
        [[[0,0],[9,0],[0,9],[0,0]],[[1,1],[1,2],[2,1],[1,1]]]}}"#;
    let (folder, input) = file("isle.json", map);
    let report = coface(&["info", "--json", argument(&input)]).json();
    assert_eq!((&report["format"], &report["kind"]), (&json!("geojson"), &json!("planar")));
    let mut from = input;
    // Only GeoJSON keeps names.
    for (name, remark) in [
        ("a.geojson", ""),
        ("b.wkt", "remark: a file of WKT does not keep groups: 1 left out\n"),
        ("c.geojson", ""),
        ("d.lines", "remark: a file of line segments does not keep data on cells: 2 left out\n"),
    ] {
        let to = folder.path().join(name);
        let run = coface(&["convert", argument(&from), "-o", argument(&to)]);
        assert_eq!((run.status, run.stderr.as_str()), (0, remark), "{name}");
        let report = coface(&["info", "--json", argument(&to)]).json();
        assert_eq!((&report["f_vector"], &report["components"]), (&json!([6, 6]), &json!(2)), "{name}");
        from = to;
    }
}

#[test]
fn convert_there_and_back() {
    let (folder, input) = file("square.off", SQUARE);
    let mut from = input;
    for extension in ["obj", "ply", "mesh", "msh", "vtk", "off"] {
        let to = folder.path().join(format!("copy.{extension}"));
        let run = coface(&["convert", argument(&from), "-o", argument(&to)]);
        assert_eq!((run.status, run.stdout.as_str()), (0, ""), "{extension}: {}", run.stderr);
        let report = coface(&["info", "--json", argument(&to)]).json();
        assert_eq!((&report["f_vector"], &report["area"]), (&json!([4, 5, 2]), &json!(1.0)), "{extension}");
        from = to;
    }
    let printed = coface(&["convert", argument(&from), "--to", "obj"]).stdout;
    assert_eq!(printed.lines().filter(|line| line.starts_with("f ")).count(), 2, "{printed}");
    let object =
        coface(&["convert", argument(&from), "--json", "-o", argument(&folder.path().join("x.stl"))]).json();
    assert_eq!((&object["output_format"], &object["counts"]["polygons"]), (&json!("stl"), &json!(2)));
}

#[test]
fn completions_and_manual_pages_are_made() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let script = coface(&["completions", shell]).stdout;
        assert!(script.contains("coface") && script.contains("homology"), "{shell}");
        // Not a verb for people.
        assert!(!script.contains("worker)") && !script.contains("'worker'"), "{shell}");
    }
    let page = coface(&["man"]).stdout;
    assert!(page.contains(".TH coface") && page.contains("homology"), "{page}");
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path().join("man1");
    assert_eq!(coface(&["man", "-o", argument(&place)]).status, 0);
    assert!(std::fs::read_to_string(place.join("coface-info.1")).unwrap().contains("coface\\-info"));
    assert!(place.join("coface-batch.1").exists() && !place.join("coface-worker.1").exists());
}

#[test]
fn help_lists_the_verbs_that_exist() {
    let run = coface(&["--help"]);
    assert_eq!(run.status, 0);
    for verb in ["info", "homology", "star", "closure", "link", "boundary", "interior", "skeleton", "convert"]
    {
        assert!(run.stdout.contains(&format!("\n  {verb} ")), "{verb}");
        assert_eq!(coface(&[verb, "--help"]).status, 0);
    }
    assert!(coface(&["--version"]).stdout.starts_with("coface "));
}

#[test]
fn convert_says_which_groups_it_leaves_out() {
    let (folder, path) = file("named.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\ng left\nf 1 2 3\n");
    let remarks = |name: &str| {
        let target = folder.path().join(name);
        let output = std::process::Command::new(env!("CARGO_BIN_EXE_coface"))
            .args(["convert", argument(&path), "-o", argument(&target)])
            .output()
            .unwrap();
        assert!(output.status.success());
        String::from_utf8(output.stderr).unwrap()
    };
    assert_eq!(remarks("named.off"), "remark: a file of OFF does not keep groups: 1 left out\n");
    assert_eq!(remarks("again.obj"), "");
}

#[test]
fn convert_repairs_on_request_and_says_what_it_did() {
    // A book of three pages, and at vertex 2 (counted from 1) a triangle that touches in it alone.
    let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 2 0\nv 0 3 0\nv 2 0 0\nv 2 1 0\n\
                g pages\nf 1 2 3\nf 1 2 4\nf 2 1 5\ng tip\nf 2 6 7\n";
    let (folder, path) = file("book.obj", text);
    let target = folder.path().join("repaired.obj");
    let convert = |options: &[&str]| {
        let arguments = [&["convert", argument(&path), "--json", "-o", argument(&target)], options].concat();
        coface(&arguments)
    };
    assert_eq!(convert(&[]).json().get("repair"), None);
    assert!(convert(&["--orient"]).fails_with(1).contains("lies in 3 faces"));
    let object = convert(&["--split-edges", "pairs", "--orient"]).json();
    let expected = json!({"edges_split": [[0, 1]], "vertices_split": [0, 1], "faces_turned": [],
                          "copies": [[7, 0], [8, 1], [9, 1]]});
    assert_eq!(object["repair"], expected);
    let report = coface(&["info", "--json", argument(&target)]).json();
    assert_eq!((&report["f_vector"], &report["components"]), (&json!([10, 11, 4]), &json!(3)));
    assert_eq!(report["manifold"]["verdict"], "yes");
    assert!(std::fs::read_to_string(&target).unwrap().contains("g tip"));
    let object = convert(&["--split-vertices"]).json();
    assert_eq!(object["repair"]["vertices_split"], json!([1]));
    let object = convert(&["--split-edges", "apart", "--split-vertices"]).json();
    assert_eq!(object["repair"]["copies"].as_array().unwrap().len(), 5);
    // On standard output the model stands alone; what was done is a remark.
    let printed = coface(&["convert", argument(&path), "--split-vertices", "--to", "off"]);
    assert!(printed.stdout.starts_with("OFF"), "{}", printed.stdout);
    assert!(printed.stderr.contains("vertices split: 1"), "{}", printed.stderr);
    coface(&["convert", argument(&path), "--split-edges", "some", "--to", "off"]).fails_with(2);
}

#[test]
fn what_is_inside_out_is_turned_by_orienting_and_repair() {
    let folder = tempfile::tempdir().unwrap();
    let place = folder.path();
    // Inside out; and with one face turned, which is outwards then.
    for (name, faces) in
        [("all", "3 0 1 2\n3 0 3 1\n3 1 3 2\n3 2 3 0\n"), ("one", "3 0 2 1\n3 0 3 1\n3 1 3 2\n3 2 3 0\n")]
    {
        let text = format!("OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 6\n{faces}");
        std::fs::write(place.join(format!("{name}.off")), text).unwrap();
        for option in ["--orient", "--repair=closed", "--repair"] {
            let (file, out) = (format!("{name}.off"), format!("{name}.ply"));
            let run = coface_in(place, &["convert", &file, option, "-o", &out]);
            assert_eq!(run.status, 0, "{}", run.stderr);
            let report = coface_in(place, &["info", &out, "--json"]).json();
            assert_eq!(report["signed_volume"], 1.0, "{name} {option}");
        }
    }
}
