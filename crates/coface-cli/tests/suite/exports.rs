//! Files for other programs: VTK XML, glTF, colors; the report as a page; and what an interrupt leaves behind.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface};
use serde_json::{Value, json};
use std::path::PathBuf;
use tempfile::TempDir;

/// Two triangles with a common side, and one apart.
const SHEETS: &str =
    "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 5 0 0\nv 6 0 0\nv 5 1 0\nf 1 2 3\nf 1 3 4\nf 5 6 7\n";

fn file(folder: &TempDir, name: &str, text: &str) -> PathBuf {
    let path = folder.path().join(name);
    std::fs::write(&path, text).unwrap();
    path
}

fn converted(folder: &TempDir, name: &str, options: &[&str]) -> Vec<u8> {
    let input = file(folder, "sheets.obj", SHEETS);
    let out = folder.path().join(name);
    let run = coface(&[&["convert", argument(&input), "-o", argument(&out)], options].concat());
    assert_eq!((run.status, run.stdout.as_str(), run.stderr.as_str()), (0, "", ""), "{name} {options:?}");
    std::fs::read(&out).unwrap()
}

#[test]
fn vertices_have_the_color_of_their_component() {
    let folder = tempfile::tempdir().unwrap();
    let text = String::from_utf8(converted(&folder, "a.obj", &["--color-by", "component"])).unwrap();
    let blue = "0 0.4471 0.698";
    let orange = "0.8353 0.3686 0";
    assert!(
        text.contains(&format!("v 0 1 0 {blue}\n")) && text.contains(&format!("v 5 0 0 {orange}\n")),
        "{text}"
    );
    let ply = folder.path().join("a.ply");
    converted(&folder, "a.ply", &["--color-by", "component"]);
    let back = coface(&["info", argument(&ply), "--json"]).json();
    let names: Vec<&str> =
        back["data"].as_array().unwrap().iter().map(|data| data["name"].as_str().unwrap()).collect();
    assert_eq!(names, ["red", "green", "blue"]);
    assert_eq!(back["data"][2]["range"], serde_json::json!([0.0, 178.0]));
    let off = folder.path().join("a.off");
    let input = folder.path().join("sheets.obj");
    let arguments = ["convert", argument(&input), "-o", argument(&off), "--color-by", "component"];
    assert!(coface(&arguments).fails_with(1).contains("holds no colors; write obj"));
    assert!(!off.exists());
}

#[test]
fn boundaries_and_generators_are_colored() {
    let folder = tempfile::tempdir().unwrap();
    // A fan around vertex 1, which alone is not on the boundary.
    let fan = file(&folder, "fan.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv -1 -1 0\nf 1 2 3\nf 1 3 4\nf 1 4 2\n");
    let red = "0.8157 0.0078 0.1059";
    let colors = |how: &str| {
        let run = coface(&["convert", argument(&fan), "--to", "obj", "--color-by", how]);
        assert_eq!(run.status, 0, "{}", run.stderr);
        run.stdout
    };
    assert_eq!(colors("boundary").matches(red).count(), 3);
    let result = file(&folder, "r.json", r#"{"generators":[[],[{"order":0,"chain":[[1,[1,2]]]}]]}"#);
    assert_eq!(colors(argument(&result)).matches("0 0.4471 0.698").count(), 2);
}

#[test]
fn vtk_xml_is_written_and_read_by_every_door() {
    let folder = tempfile::tempdir().unwrap();
    for (name, kind) in [("a.vtu", "UnstructuredGrid"), ("a.vtp", "PolyData")] {
        let text = String::from_utf8(converted(&folder, name, &[])).unwrap();
        assert!(text.contains(&format!("<VTKFile type=\"{kind}\"")) && text.ends_with("</VTKFile>\n"));
        assert!(text.contains("NumberOfPoints=\"7\""));
        let path = folder.path().join(name);
        let object = coface(&["info", argument(&path), "--json"]).json();
        assert_eq!((&object["f_vector"], &object["format"]), (&json!([7, 8, 3]), &json!(&name[2..])));
    }
    let input = folder.path().join("sheets.obj");
    let out = folder.path().join("g.vtp");
    let run = coface(&["homology", argument(&input), "--generators", argument(&out), "--quiet"]);
    assert_eq!(run.status, 0, "{}", run.stderr);
    assert!(std::fs::read_to_string(&out).unwrap().contains("NumberOfVerts=\"2\""));
}

#[test]
fn gltf_holds_triangles_and_generators() {
    let folder = tempfile::tempdir().unwrap();
    let bytes = converted(&folder, "a.glb", &[]);
    assert_eq!(u32::from_le_bytes(bytes[8..12].try_into().unwrap()) as usize, bytes.len());
    let result = file(&folder, "r.json", r#"{"generators":[[],[{"order":0,"chain":[[1,[1,2]]]}]]}"#);
    let text = converted(&folder, "a.gltf", &["--color-by", argument(&result)]);
    let document: Value = serde_json::from_slice(&text).unwrap();
    assert_eq!(document["nodes"][1]["name"], "H1 generator 1");
    assert_eq!(document["meshes"][1]["primitives"][0]["mode"], 1);
    let colored = converted(&folder, "a.gltf", &["--color-by", "component"]);
    let document: Value = serde_json::from_slice(&colored).unwrap();
    assert!(document["meshes"][0]["primitives"][0]["attributes"]["COLOR_0"].is_u64());
    let input = folder.path().join("sheets.obj");
    let out = folder.path().join("b.glb");
    let object = coface(&["convert", argument(&input), "-o", argument(&out), "--json"]).json();
    assert_eq!(object["output_format"], "glb");
}

#[test]
fn a_report_is_a_page_with_pictures() {
    let folder = tempfile::tempdir().unwrap();
    let input = file(&folder, "a <b>.obj", SHEETS);
    let out = folder.path().join("page.html");
    let run = coface(&["info", argument(&input), "--html", argument(&out)]);
    assert_eq!((run.status, run.stdout.as_str()), (0, ""), "{}", run.stderr);
    let page = std::fs::read_to_string(&out).unwrap();
    assert_eq!(page.matches("<svg ").count(), 2);
    assert!(page.contains("a &lt;b&gt;.obj") && !page.contains("a <b>"));
    assert!(page.contains("<th scope=\"row\">Euler char.</th><td class=\"plain\">2</td>"));
    assert!(page.contains("#d0021b"), "the boundary is red");
    for address in ["http://", "https://"] {
        let own = page.matches("http://www.w3.org/2000/svg").count();
        let others = page.matches(address).count() - if address == "http://" { own } else { 0 };
        assert_eq!(others, 0, "{address}");
    }
    let again = folder.path().join("again.html");
    let object = coface(&["info", argument(&input), "-o", argument(&again), "--json"]).json();
    assert_eq!((object["components"].as_u64(), std::fs::read_to_string(&again).unwrap()), (Some(2), page));
    let both = folder.path().join("both.html");
    let run = coface(&["info", argument(&input), argument(&input), "-o", argument(&both)]);
    assert_eq!(run.status, 0);
    assert_eq!(std::fs::read_to_string(&both).unwrap().matches("<article>").count(), 2);
}

/// Sends a signal (that of Ctrl-C is INT) to a program that makes a large file, as soon as `is_time` says, which is told since when it runs;
/// gives how it ended.
#[cfg(unix)]
fn ended_by(
    signal: &str,
    out: &std::path::Path,
    is_time: &dyn Fn(std::time::Instant) -> bool,
) -> std::process::ExitStatus {
    use std::process::{Command, Stdio};
    let begin = std::time::Instant::now();
    let mut child = Command::new(env!("CARGO_BIN_EXE_coface"))
        .args([
            "generate",
            "torus",
            "--columns",
            "1800",
            "--rows",
            "1200",
            "--to",
            "obj",
            "-o",
            argument(out),
        ])
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    while !is_time(begin) {
        if let Some(ended) = child.try_wait().unwrap() {
            return ended;
        }
        std::thread::sleep(std::time::Duration::from_millis(1));
    }
    assert!(Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap().success());
    child.wait().unwrap()
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_no_file() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("torus.obj");
    let files = || std::fs::read_dir(folder.path()).unwrap().count();
    // A busy machine may start the program later than it is looked for, or look too late: then there is another try.
    let ended = |signal: &str, is_time: &dyn Fn(std::time::Instant) -> bool| {
        let again = || {
            let _ = std::fs::remove_file(&out);
            ended_by(signal, &out, is_time).code().filter(|&code| code != 0)
        };
        (0..5).find_map(|_| again()).expect("one of five is in time")
    };
    // What was started by nohup is not ended by a terminal that is closed, and neither is what it starts.
    let own = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let outlives = own
        .lines()
        .find_map(|line| line.strip_prefix("SigIgn:"))
        .is_none_or(|mask| !mask.ends_with(['0', '2', '4', '6', '8', 'a', 'c', 'e']));
    let signals = [("-INT", 130), ("-TERM", 143), ("-HUP", 129)];
    for (signal, status) in &signals[..if outlives { 2 } else { 3 }] {
        // While it computes, and while it writes: then there is a temporary file.
        let computes = |begin: std::time::Instant| begin.elapsed().as_millis() > 300;
        assert_eq!((ended(signal, &computes), files()), (*status, 0));
        assert_eq!((ended(signal, &|_| files() > 0), files()), (*status, 0));
    }
}

/// What a format rounds, joins or leaves out is said in a remark, and what it keeps comes back.
#[test]
fn what_is_written_is_kept_or_said() {
    let folder = tempfile::tempdir().unwrap();
    let codes = |name: &str, text: &str, to: &str| -> Vec<String> {
        let (input, out) = (file(&folder, name, text), folder.path().join(to));
        let answer = coface(&["convert", argument(&input), "-o", argument(&out), "--json"]).json();
        let code = |remark: &Value| remark["code"].as_str().unwrap().to_owned();
        answer["remarks"].as_array().unwrap().iter().map(code).collect()
    };
    let far = "v 10000000 0 0\nv 10000000.5 0 0\nv 10000000 1 0\nv 10000000 0 1\nv 0 0 0\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    assert_eq!(codes("far.obj", far, "far.stl"), ["numbers-rounded", "rounded-invalid", "format-keeps-less"]);
    assert_eq!(
        codes("square.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n", "square.stl"),
        ["faces-triangulated"]
    );
    let area =
        |name: &str| coface(&["info", argument(&folder.path().join(name)), "--json"]).json()["area"].clone();
    assert_eq!(area("square.stl"), json!(1.0));
    // Positions are in JSON beside facets.
    assert!(codes("sheets.obj", SHEETS, "sheets.json").is_empty());
    assert_eq!(area("sheets.json"), area("sheets.obj"));
    // Faces of a mesh are one surface whatever their groups.
    let grouped = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\ng a\nf 1 3 2\ng b\nf 1 2 4\ng c\nf 2 3 4\nf 3 1 4\n";
    for format in ["wkt", "wkb", "hex"] {
        let name = format!("grouped.{format}");
        assert_eq!(codes("grouped.obj", grouped, &name), ["format-keeps-less"]);
        let info = coface(&["info", argument(&folder.path().join(&name)), "--json"]).json();
        assert_eq!((&info["name"], &info["f_vector"]), (&json!("sphere"), &json!([4, 6, 4])), "{name}");
    }
    let empty = file(&folder, "empty.off", "OFF\n0 0 0\n");
    let out = folder.path().join("empty.glb");
    let run = coface(&["convert", argument(&empty), "-o", argument(&out)]);
    assert!(run.fails_with(1).contains("nothing in it") && !out.exists());
}

/// Voxels are as large as the header of their file says.
#[test]
fn voxels_have_their_size() {
    let folder = tempfile::tempdir().unwrap();
    let text = "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 3 1\nspacings: 0.5 2 3\nencoding: ascii\n\n1 1 1 1 1 1\n";
    let input = file(&folder, "a.nrrd", text);
    let out = folder.path().join("a.off");
    let run = coface(&["convert", argument(&input), "-o", argument(&out)]);
    assert!(run.stderr.contains("0.5 x 2 x 3 each"), "{}", run.stderr);
    let info = coface(&["info", argument(&out), "--json"]).json();
    assert_eq!((&info["signed_volume"], &info["f_vector"]), (&json!(18.0), &json!([24, 44, 22])));
}
