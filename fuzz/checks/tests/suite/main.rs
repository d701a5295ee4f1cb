//! Every file of every corpus passes its check, within seconds and within a limit of memory: what fuzzing has found stays found.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

mod mutations;

use coface_allocator::CountingAllocator;
use coface_fuzz_checks::{CHECKS, Check};
use std::path::{Path, PathBuf};
use std::sync::mpsc::{RecvTimeoutError, channel};
use std::time::Duration;

/// All checks that run at once share this.
const MOST_BYTES: usize = 1 << 30;
/// No file takes as long as this, even on a busy machine and without optimization.
const MOST_TIME: Duration = Duration::from_secs(60);
/// Files are small, but for those that show that size alone does no harm.
const MOST_LENGTH: u64 = 64 << 10;

#[global_allocator]
static ALLOCATOR: CountingAllocator = CountingAllocator::limited(MOST_BYTES);

fn fuzz() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

fn names_in(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display()));
    let mut names: Vec<String> =
        entries.map(|entry| entry.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

fn check_named(name: &str) -> Check {
    let (_, check) = CHECKS.iter().find(|(known, _)| *known == name).expect("a check of this name");
    *check
}

/// The files of a corpus.
fn corpus(name: &str) -> Vec<(String, Vec<u8>)> {
    let folder = fuzz().join("corpus").join(name);
    names_in(&folder)
        .into_iter()
        .map(|file| {
            let bytes = std::fs::read(folder.join(&file)).unwrap();
            (file, bytes)
        })
        .collect()
}

/// Runs a check on every file of its corpus.
fn replay(name: &str) {
    let check = check_named(name);
    for (file, bytes) in corpus(name) {
        assert!(bytes.len() as u64 <= MOST_LENGTH, "{name}/{file} is too large for a corpus");
        let (done, result) = channel();
        let worker = std::thread::spawn(move || {
            check(&bytes);
            done.send(()).ok();
        });
        match result.recv_timeout(MOST_TIME) {
            Ok(()) => worker.join().expect("a check that has ended"),
            Err(RecvTimeoutError::Disconnected) => panic!("{name}/{file} breaks a promise: see above"),
            Err(RecvTimeoutError::Timeout) => {
                panic!("{name}/{file} takes longer than {} s", MOST_TIME.as_secs())
            }
        }
    }
}

macro_rules! corpora {
    ($($name:ident)*) => {
        $(
            #[test]
            fn $name() {
                replay(stringify!($name));
            }
        )*

        const REPLAYED: &[&str] = &[$(stringify!($name)),*];
    };
}

corpora! {
    arrange_plane
    arrange_space
    ask_facets
    ask_polygons
    ask_voxels
    boolean_plane
    boolean_space
    boolean_yin
    check_certificate
    edit_halfedges
    glue_simplices
    parse_words
    read_abaqus
    read_amf
    read_any
    read_chains
    read_collada
    read_compressed
    read_container
    read_factories
    read_geojson
    read_gltf
    read_isosig
    read_json
    read_lines
    read_manifest
    read_matrix_market
    read_mesh
    read_msh
    read_nifti
    read_npy
    read_nrrd
    read_obj
    read_off
    read_ply
    read_points
    read_reduced_shard
    read_shard
    read_stl
    read_svg
    read_tetgen
    read_three_mf
    read_unknown
    read_vtk
    read_vtk_appended
    read_vtk_xml
    read_wkt
    read_yin_dat
    read_yin_json
    repair_mesh
}

#[test]
fn every_check_has_a_target_and_a_corpus() {
    let checks: Vec<&str> = CHECKS.iter().map(|(name, _)| *name).collect();
    assert_eq!(checks, REPLAYED);
    assert_eq!(names_in(&fuzz().join("corpus")), checks);
    let sources: Vec<String> = checks.iter().map(|name| format!("{name}.rs")).collect();
    assert_eq!(names_in(&fuzz().join("fuzz_targets")), sources);
    let manifest = std::fs::read_to_string(fuzz().join("Cargo.toml")).unwrap();
    for name in checks {
        assert!(
            manifest.contains(&format!("path = \"fuzz_targets/{name}.rs\"")),
            "fuzz/Cargo.toml has no {name}"
        );
    }
}
