//! The readers of surface formats on real files: counts against the manifest.
//!
//! The files lie in the folder that the environment variable `COFACE_DATA` names; without it the tests say so and pass.
#![allow(clippy::print_stdout, reason = "a test says what it skips")]

use coface_algebra::{Error, ErrorKind, VertexId};
use coface_io::{Model, obj, off, ply, stl};
use proptest::prelude::*;
use std::fs::File;
use std::path::{Path, PathBuf};
use std::sync::OnceLock;

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
fn a_face_of_two_vertices_is_an_edge_with_its_line() {
    let Some(data) = data() else { return };
    let model = read(&data.join("tricky/notenoughindices.obj")).unwrap().unwrap();
    assert_eq!((model.polygons().len(), model.lines().len()), (1, 1));
    assert_eq!(model.remarks()[0].places[0].line, Some(9));
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

/// The bytes of the smaller real files of these formats.
fn real_files() -> &'static [Vec<u8>] {
    static FILES: OnceLock<Vec<Vec<u8>>> = OnceLock::new();
    FILES.get_or_init(|| {
        let Some(data) = data() else { return Vec::new() };
        let folders = ["surfaces", "tricky"].iter().map(|folder| data.join(folder));
        let entries = folders.flat_map(|folder| std::fs::read_dir(folder).expect("the folder is there"));
        let mut paths: Vec<PathBuf> =
            entries.map(|entry| entry.expect("the entry is readable").path()).collect();
        paths.sort();
        let files = paths.iter().map(|path| std::fs::read(path).expect("the file is readable"));
        files.filter(|bytes| bytes.len() < 200_000).collect()
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    /// Bytes changed, inserted, cut out and cut off at the end: an error or a sound model no larger than its file.
    #[test]
    fn broken_real_files_are_survived(
        file in any::<prop::sample::Index>(),
        edits in proptest::collection::vec((0..4u8, any::<prop::sample::Index>(), any::<u8>()), 1..8),
    ) {
        let files = real_files();
        if files.is_empty() {
            return Ok(());
        }
        let mut bytes = file.get(files).clone();
        for (kind, place, byte) in edits {
            let at = place.index(bytes.len() + 1);
            match kind {
                0 => bytes.insert(at, byte),
                1 if at < bytes.len() => bytes[at] ^= byte,
                2 if at < bytes.len() => drop(bytes.drain(at..bytes.len().min(at + usize::from(byte)))),
                3 if byte < 64 => bytes.truncate(at),
                _ => {}
            }
        }
        let input = &bytes[..];
        for model in [off::read(input), obj::read(input), ply::read(input), stl::read(input)].into_iter().flatten() {
            prop_assert!(model.check().is_ok());
            prop_assert!(model.vertex_count() <= input.len() && model.polygons().item_count() <= 3 * input.len());
        }
    }
}
