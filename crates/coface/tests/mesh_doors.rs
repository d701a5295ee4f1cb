//! The readers of surface formats on real files: counts against the manifest.
//!
//! The files lie in the folder that the environment variable `COFACE_DATA` names; without it the tests say so and pass.
#![allow(clippy::print_stdout, reason = "a test says what it skips")]

use coface::io::{Model, obj, off, ply, stl};
use coface::{Error, ErrorKind, VertexId};
use std::fs::File;
use std::path::{Path, PathBuf};

fn data() -> Option<PathBuf> {
    let folder = std::env::var_os("COFACE_DATA").map(PathBuf::from);
    if folder.is_none() {
        println!("skipped: COFACE_DATA names no folder");
    }
    folder
}

fn read(path: &Path) -> Option<Result<Model, Error>> {
    let input = File::open(path).expect("the manifest names files that are there");
    let extension = path.extension()?.to_str()?.to_ascii_lowercase();
    Some(match extension.as_str() {
        "off" => off::read(input),
        "obj" => obj::read(input),
        "ply" => ply::read(input),
        "stl" => stl::read(input),
        _ => return None,
    })
}

#[test]
fn counts_are_those_of_the_manifest() {
    let Some(data) = data() else { return };
    let manifest = std::fs::read_to_string(data.join("MANIFEST.json")).unwrap();
    let manifest: serde_json::Value = serde_json::from_str(&manifest).unwrap();
    let mut checked = 0;
    for record in manifest["files"].as_array().unwrap() {
        let file = record["file"].as_str().unwrap();
        let Some(vertices) = record["vertices"].as_u64() else { continue };
        let Some(faces) = record["faces_in_file"].as_u64().or(record["faces"].as_u64()) else { continue };
        if !file.starts_with("surfaces/") && !file.starts_with("tricky/") {
            continue;
        }
        let Some(model) = read(&data.join(file)) else { continue };
        let model = model.unwrap_or_else(|error| panic!("{file}: {error}"));
        model.check().unwrap();
        assert_eq!((model.vertex_count() as u64, model.polygons().len() as u64), (vertices, faces), "{file}");
        checked += 1;
    }
    assert!(checked >= 22, "{checked} files");
}

#[test]
fn four_coordinates_are_kept() {
    let Some(data) = data() else { return };
    let model = read(&data.join("surfaces/tetraplex.off")).unwrap().unwrap();
    assert_eq!(model.positions().point(VertexId::new(5)), [-1.0, 0.0, -0.618034, -1.61803]);
}

#[test]
fn a_face_of_two_vertices_is_refused_with_its_line() {
    let Some(data) = data() else { return };
    let error = read(&data.join("tricky/notenoughindices.obj")).unwrap().unwrap_err();
    assert_eq!(error.line(), Some(9), "{error}");
}

#[test]
fn broken_stl_files_name_their_line() {
    let Some(data) = data() else { return };
    let error = read(&data.join("tricky/invalidvertex.stl")).unwrap().unwrap_err();
    assert_eq!(
        error.to_string(),
        "line 89: \"blah\" is not a number, as a coordinate must be; write a decimal number"
    );
    let error = read(&data.join("tricky/unparseable.stl")).unwrap().unwrap_err();
    assert_eq!((error.kind(), error.line()), (ErrorKind::Parse, Some(4)), "{error}");
}

#[test]
fn a_ply_header_without_elements_is_an_empty_model() {
    let Some(data) = data() else { return };
    let model = read(&data.join("tricky/ply_empty_header.ply")).unwrap().unwrap();
    assert_eq!(model, Model::default());
}
