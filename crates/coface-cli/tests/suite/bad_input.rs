//! What cannot be served: one clear message, exit status 1, nothing on standard output, no file left behind.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use crate::program::{argument, coface, coface_reading};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The model that is shipped in `data/`.
fn spot() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/spot.obj")
}

/// A file of this name with these bytes, and the message of `coface info` on it.
fn message(name: &str, bytes: &[u8]) -> String {
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join(name);
    std::fs::write(&path, bytes).unwrap();
    let message = coface(&["info", "--json", argument(&path)]).fails_with(1).to_owned();
    assert!(message.contains(name), "the file is named: {message}");
    message
}

#[test]
fn files_that_are_none() {
    let folder = tempfile::tempdir().unwrap();
    let missing = folder.path().join("missing.obj");
    assert!(coface(&["info", argument(&missing)]).fails_with(1).contains("missing.obj"));
    assert!(coface(&["info", argument(folder.path())]).fails_with(1).contains("directory"));
    assert!(coface(&["info", ""]).status != 0);
    message("empty.off", b"");
    message("blank.obj", b"  \n\n  \n");
    message("zeros.ply", &[0; 4096]);
}

#[test]
fn garbage_and_wrong_names() {
    let noise: Vec<u8> = (0..5000_u32).map(|i| (i.wrapping_mul(2_654_435_761) >> 13) as u8).collect();
    for name in ["a.off", "a.obj", "a.ply", "a.stl", "a.mesh", "a.msh", "a.vtk", "a.json", "a.weather"] {
        message(name, &noise);
        message(name, b"It was a dark and stormy night;\nthe rain fell in torrents.\n");
    }
}

#[test]
fn faults_are_named_with_their_line() {
    let text = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 one 0\n3 0 1 2\n";
    assert!(message("a.off", text.as_bytes()).contains(":5:"), "not a number");
    let text = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n";
    assert!(message("a.off", text.as_bytes()).contains(":6:"), "an index out of range");
    let text = "v 0 0 0\nv 1 0 0\nv 0 1e 0\nf 1 2 3\n";
    assert!(message("a.obj", text.as_bytes()).contains(":3:"), "a number without its exponent");
    let text = "OFF\n4000000000 1 0\n0 0 0\n";
    message("a.off", text.as_bytes());
    message("a.json", br#"{"facets":[[0,1,1]]}"#);
    message("a.json", br#"{"facets":[[0,-1]]}"#);
    message("a.json", br#"{"facets":[[0,1],"#);
    message("a.json", br#"{"boundaries":[{"rows":1,"cols":1,"entries":[[0,0,1]]},{"rows":1,"cols":1,"entries":[[0,0,1]]}]}"#);
}

#[test]
fn a_truncated_file_is_refused_at_every_length() {
    let whole = std::fs::read(spot()).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("spot.ply");
    let written = coface(&["convert", argument(&spot()), "--json", "-o", argument(&path)]).json();
    assert_eq!(written["counts"]["polygons"], 5856);
    let binary = std::fs::read(&path).unwrap();
    for part in [10, 300, binary.len() / 2, binary.len() - 1] {
        message("part.ply", &binary[..part]);
    }
    // The vertices and half of the faces of a text file are a valid file; a broken last word is not.
    let line_start = whole.windows(3).rposition(|window| window == b"\nf ").unwrap();
    message("part.obj", &whole[..line_start + 3]);
}

#[test]
fn standard_input_is_named() {
    assert!(coface_reading(&["info", "-"], b"").fails_with(1).contains("standard input"));
    assert!(
        coface_reading(&["info", "-", "--format", "off"], b"OFF\n1 0 0\n0 0\n")
            .fails_with(1)
            .contains("standard input")
    );
}

#[test]
fn requests_that_cannot_be_served() {
    let disk = br#"[[0,1,2]]"#;
    for verb in ["star", "closure", "link", "boundary", "interior"] {
        let run = coface_reading(&[verb, "-", "--json", "--simplices", "0 1; 1 5"], disk);
        assert!(run.fails_with(1).contains('5'), "{verb}: {}", run.stderr);
        let run = coface_reading(&[verb, "-", "--json", "--simplices", "1 1"], disk);
        run.fails_with(1);
    }
    let square = b"OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
    let run = coface_reading(&["star", "-", "--simplices", "0"], square);
    assert!(run.fails_with(1).contains("triangulate"), "{}", run.stderr);
    let mixed = br#"[[0,1,2],[2,3]]"#;
    coface_reading(&["boundary", "-", "--json"], mixed).fails_with(1);
    let run = coface_reading(&["homology", "-", "--generators", "loops.vtk"], disk);
    assert!(run.fails_with(1).contains("positions"), "{}", run.stderr);
    assert!(coface_reading(&["convert", "-"], disk).fails_with(1).contains("--to"));
    coface_reading(&["convert", "-", "--to", "stl"], disk).fails_with(1);
}

#[test]
fn wrong_usage_is_status_2() {
    for arguments in [
        &["frobnicate"][..],
        &[],
        &["info"],
        &["info", "a.off", "--frobnicate"],
        &["info", "a.off", "--threads", "0"],
        &["info", "a.off", "--format", "docx"],
        &["homology", "a.off", "--coefficients", "f4"],
        &["star", "a.off"],
        &["star", "a.off", "--simplices", "zero"],
        &["skeleton", "a.off"],
        &["skeleton", "a.off", "--dimension", "-1"],
        &["completions", "tcsh"],
    ] {
        let run = coface(arguments);
        assert_eq!((run.status, run.stdout.as_str()), (2, ""), "{arguments:?}: {}", run.stderr);
        assert!(run.stderr.contains("--help") || arguments.is_empty(), "{}", run.stderr);
    }
}

#[test]
fn a_failed_output_leaves_what_was_there() {
    let folder = tempfile::tempdir().unwrap();
    let input = folder.path().join("a.json");
    std::fs::write(&input, br#"[[0,1,2],[2,3]]"#).unwrap();
    let out = folder.path().join("out.stl");
    std::fs::write(&out, b"precious").unwrap();
    coface(&["convert", argument(&input), "-o", argument(&out)]).fails_with(1);
    assert_eq!(std::fs::read(&out).unwrap(), b"precious");
    coface(&["convert", argument(&input), "-o", argument(&folder.path().join("no/such/folder.json"))])
        .fails_with(1);
    coface(&["convert", argument(&input), "-o", argument(folder.path())]).fails_with(1);
    let mut names: Vec<_> =
        std::fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(names, ["a.json", "out.stl"], "no temporary file is left");
}

#[test]
fn a_reader_that_goes_away_is_no_fault() {
    // A facet list whose star is far larger than a pipe holds.
    let facets: Vec<String> = (1..40_000).map(|i| format!("[0,{i}]")).collect();
    let folder = tempfile::tempdir().unwrap();
    let path = folder.path().join("star.json");
    std::fs::write(&path, format!("[{}]", facets.join(","))).unwrap();
    let mut child = Command::new(env!("CARGO_BIN_EXE_coface"))
        .args(["star", argument(&path), "--simplices", "0", "--json"])
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let output = child.wait_with_output().unwrap();
    assert_eq!(String::from_utf8(output.stderr).unwrap(), "");
    assert_eq!(output.status.code(), Some(0));
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_device_is_said() {
    let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
    let output = Command::new(env!("CARGO_BIN_EXE_coface"))
        .args(["info", argument(&spot())])
        .stdout(full)
        .stderr(Stdio::piped())
        .output()
        .unwrap();
    assert_eq!(output.status.code(), Some(1));
    assert!(String::from_utf8(output.stderr).unwrap().starts_with("error: standard output"));
}
