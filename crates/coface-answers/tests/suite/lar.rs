//! Models of vertex lists made of real meshes have the chain complexes of the meshes.

#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a test says what it skips")]

use coface_algebra::chains::ChainComplex;
use coface_answers::Producer;
use coface_complexes::lar::{LarModel, TopOrientation, signed_measures};
use coface_io::read_path;
use coface_topology::homology;
use std::path::{Path, PathBuf};

/// The same cells without the facets that the mesh knows: they are found by vertices and must be the same.
fn bare(model: &LarModel) -> LarModel {
    let cells = (1..=model.dimension().unwrap()).map(|degree| model.cells(degree).into_owned()).collect();
    let bare = LarModel::new(model.vertex_count(), cells).unwrap();
    for degree in 2..=model.dimension().unwrap() {
        let (found, given) = (bare.facets_by_vertices(degree).unwrap(), model.facets(degree).unwrap());
        assert_eq!(found.len(), given.len());
        for (found, given) in found.iter().zip(given.iter()) {
            let mut given = given.to_vec();
            given.sort_unstable();
            assert_eq!(found, given);
        }
    }
    bare
}

fn same_up_to_signs(a: &ChainComplex, b: &ChainComplex) -> bool {
    a.f_vector() == b.f_vector()
        && a.boundary_matrices().iter().zip(b.boundary_matrices()).all(|(a, b)| a.abs() == b.abs())
}

#[test]
fn a_surface_has_the_complex_of_its_mesh() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../data/spot.obj");
    let producer = Producer::of(read_path(path, None).unwrap()).unwrap();
    let (mesh, model) = (producer.chain_complex().unwrap(), bare(&producer.lar_model().unwrap()));
    for top in [TopOrientation::LowestFacet, TopOrientation::Coherent] {
        let complex = model.oriented_chain_complex(top, None).unwrap();
        assert!(same_up_to_signs(&mesh, &complex), "{top:?}");
        assert_eq!(homology(&complex).betti_numbers(), [1, 0, 1]);
    }
    // A coherent orientation of a closed surface sums to a cycle: each edge is run through once each way.
    let complex = model.oriented_chain_complex(TopOrientation::Coherent, None).unwrap();
    let mut sums = vec![0; complex.cell_count(1)];
    for face in complex.boundary_matrix(2).unwrap().columns() {
        face.iter().for_each(|(edge, entry)| sums[edge] += entry);
    }
    assert!(sums.iter().all(|&sum| sum == 0));
}

/// Tetrahedra that share faces: positive volumes add up to that of the file's record.
#[test]
fn tetrahedra_of_real_files_have_positive_volumes() {
    let Some(data) = std::env::var_os("COFACE_DATA").map(PathBuf::from) else {
        println!("COFACE_DATA is not set: the test on volumes is skipped");
        return;
    };
    let manifest: serde_json::Value =
        serde_json::from_slice(&std::fs::read(data.join("MANIFEST.json")).unwrap()).unwrap();
    let mut compared = 0;
    for record in manifest["files"].as_array().unwrap() {
        let (Some(volume), Some(bytes)) = (record["tet_volume"].as_f64(), record["bytes"].as_u64()) else {
            continue;
        };
        if bytes > 3_000_000 || record["duplicate_cells"] != 0 || record["hexes"] != 0 {
            continue;
        }
        let file = record["file"].as_str().unwrap();
        let producer = Producer::of(read_path(data.join(file), None).unwrap()).unwrap();
        let model = bare(&producer.lar_model().unwrap());
        let complex =
            model.oriented_chain_complex(TopOrientation::Positive, Some(producer.positions())).unwrap();
        assert!(same_up_to_signs(&producer.chain_complex().unwrap(), &complex), "{file}");
        let volumes = signed_measures(&complex, producer.positions()).unwrap();
        assert!(volumes.iter().all(|&volume| volume > 0.0), "{file}");
        let sum: f64 = volumes.iter().sum();
        assert!((sum - volume).abs() <= 1e-7 * volume, "{file}: {sum} against {volume}");
        compared += 1;
    }
    assert!(compared > 0, "no file of tetrahedra was compared");
}
