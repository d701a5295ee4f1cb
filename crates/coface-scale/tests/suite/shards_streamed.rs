//! Shards of meshes that are not kept in memory, of grids and of volumes: those of the whole.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]
#![allow(clippy::print_stdout, reason = "a skipped test says so")]

use coface_algebra::chains::Parts;
use coface_answers::Producer;
use coface_complexes::cubical::{CubicalVolume, FullVoxels, SimplicialBlocks, VoxelBoxes, Voxels};
use coface_io as io;
use coface_io::{Format, Model};
use coface_scale::shards::{
    GridShards, GridSort, Owners, ShardChains, ShardFolder, ShardRequest, ShardSource, shard_mesh_file,
};
use coface_topology::homology;
use proptest::prelude::*;
use std::collections::BTreeMap;
use std::fmt::Write;
use std::fs;
use std::path::Path;

fn merged(shards: &ShardFolder) -> coface_scale::shards::FolderSummary {
    (0..shards.manifest().part_count).for_each(|number| drop(shards.reduce(number, false).unwrap()));
    shards.merge_all(false).unwrap()
}

/// Cycles of dimension 1 by the names of their edges: each vertex is left as often as it is reached.
fn check_loops(chains: &ShardChains) {
    for chain in &chains.degrees[1] {
        let mut sum: BTreeMap<u64, i64> = BTreeMap::new();
        for term in &chain.terms {
            let [from, to] = term.name[..] else { panic!("an edge has two ends: {:?}", term.name) };
            let coefficient = term.coefficient.to_i64().unwrap();
            *sum.entry(from).or_default() -= coefficient;
            *sum.entry(to).or_default() += coefficient;
        }
        assert!(sum.values().all(|&count| count == 0), "{sum:?}");
    }
}

/// A file in shards, while it is read, against the model.
fn check_mesh(path: &Path, parts: u32, owners: &Owners) {
    let folder = tempfile::tempdir().unwrap();
    let mut request = ShardRequest::new("mesh", parts);
    request.owners = owners.clone();
    request.fan_in = 3;
    let shards = shard_mesh_file(path, None, folder.path(), &request).unwrap().expect("simplices");
    assert!(!folder.path().join(".scratch").exists());
    let complex = Producer::of(io::read_path(path, None).unwrap()).unwrap().chain_complex().unwrap();
    let found = merged(&shards);
    assert_eq!(found.cells().iter().map(|&count| count as usize).collect::<Vec<_>>(), complex.f_vector());
    assert_eq!(found.homology(), &homology(&complex), "{} in {parts} parts", path.display());
    let chains = shards.generators().unwrap();
    if chains.degrees.len() > 1 {
        check_loops(&chains);
    }
    for (degree, chains) in chains.degrees.iter().enumerate() {
        assert!(chains.iter().flat_map(|chain| &chain.terms).all(|term| term.name.len() == degree + 1));
    }
    // The same bytes again.
    let bytes = |number: u32| fs::read(shards.shard_path(number)).unwrap();
    let before: Vec<Vec<u8>> = (0..parts).map(bytes).collect();
    shard_mesh_file(path, None, folder.path(), &request).unwrap().unwrap();
    assert!(before == (0..parts).map(bytes).collect::<Vec<_>>());
}

fn mesh_text(vertices: &[[f64; 3]], elements: &[Vec<u32>]) -> String {
    let mut text = format!("MeshVersionFormatted 2\nDimension 3\nVertices {}\n", vertices.len());
    vertices.iter().for_each(|[x, y, z]| writeln!(text, "{x} {y} {z} 0").unwrap());
    for (size, name) in [(2, "Edges"), (3, "Triangles"), (4, "Tetrahedra")] {
        let own: Vec<&Vec<u32>> = elements.iter().filter(|element| element.len() == size).collect();
        if own.is_empty() {
            continue;
        }
        writeln!(text, "{name} {}", own.len()).unwrap();
        for element in own {
            element.iter().for_each(|vertex| write!(text, "{} ", vertex + 1).unwrap());
            writeln!(text, "1").unwrap();
        }
    }
    text + "End\n"
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Tetrahedra, triangles and edges, some of them faces of others, and vertices without any.
    #[test]
    fn meshes_that_stream_are_the_model(
        points in prop::collection::vec((0i8..4, 0i8..4, 0i8..4), 5..12),
        elements in prop::collection::btree_set(prop::collection::btree_set(0u32..9, 2..5), 1..12),
        parts in 1u32..7,
        is_random in any::<bool>(),
    ) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("a.mesh");
        let mut points: Vec<[f64; 3]> = points.iter().map(|&(x, y, z)| [x, y, z].map(f64::from)).collect();
        points.resize(9.max(points.len()), [0.0; 3]);
        let elements: Vec<Vec<u32>> = elements.into_iter().map(|element| element.into_iter().collect()).collect();
        fs::write(&path, mesh_text(&points, &elements)).unwrap();
        // Two tetrahedra may have one triangle with a third: no cells of a mesh in space, but fine for shards.
        prop_assume!(io::read_path(&path, None).and_then(Producer::of).is_ok());
        check_mesh(&path, parts, if is_random { &Owners::Random } else { &Owners::Automatic });
    }

    /// Random voxels, on axes that close or do not, as cubes and as simplices.
    #[test]
    fn volumes_in_shards_are_the_volume(
        shape in prop::collection::vec(1u32..5, 1..4),
        bits in any::<u64>(),
        periodic in any::<u8>(),
        parts in 1u32..9,
        is_simplicial in any::<bool>(),
    ) {
        let is_periodic: Vec<bool> = (0..shape.len()).map(|axis| periodic >> axis & 1 == 1).collect();
        let mut at = 0;
        let volume = CubicalVolume::new(&shape, &is_periodic, |_| {
            at += 1;
            bits >> (at % 64) & 1 == 1
        })
        .unwrap();
        let sort = if is_simplicial { GridSort::Simplices } else { GridSort::Cubes };
        let boxes = VoxelBoxes::at_least(&shape, &is_periodic, parts).unwrap();
        let folder = tempfile::tempdir().unwrap();
        let grid = GridShards::new(sort, boxes, 2);
        let shards = grid.shard_volume(&volume, folder.path(), ShardSource::default(), bits, false).unwrap();
        let complex = if is_simplicial { volume.simplicial_chain_complex() } else { volume.chain_complex() }.unwrap();
        let found = merged(&shards);
        prop_assert_eq!(found.cells().iter().map(|&count| count as usize).collect::<Vec<_>>(), complex.f_vector());
        prop_assert_eq!(found.homology(), &homology(&complex));
        check_loops(&shards.generators().unwrap());
    }
}

#[test]
fn grids_take_their_description_only() {
    for (sort, middle) in [(GridSort::Cubes, 3), (GridSort::Simplices, 3)] {
        let folder = tempfile::tempdir().unwrap();
        let boxes = VoxelBoxes::new(&[7, 6, 5], &[true; 3], &[2, 2, 1]).unwrap();
        let grid = GridShards::new(sort, boxes, 4);
        let shards = grid.shard_full(folder.path(), ShardSource::default(), false).unwrap();
        assert!(fs::metadata(shards.shard_path(3)).unwrap().len() < 512);
        assert_eq!(merged(&shards).homology().betti_numbers(), [1, middle, 3, 1]);
        check_loops(&shards.generators().unwrap());
    }
}

/// Simplices are named by the vertices that they have among themselves: faces by parts of the names of cells.
#[test]
fn cells_of_grids_have_the_names_of_their_corners() {
    let volume = FullVoxels::new(&[3, 3], &[false, true]).unwrap();
    let boxes = VoxelBoxes::new(&[3, 3], &[false, true], &[1, 1]).unwrap();
    let part = SimplicialBlocks::new(&volume, &[1, 1]).unwrap().part(0).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let grid = GridShards::new(GridSort::Simplices, boxes, 2);
    let shards = grid.shard_full(folder.path(), ShardSource::default(), false).unwrap();
    let found = merged(&shards);
    assert_eq!(found.homology(), &homology(part.complex()));
    // 4 x 3 points, numbered along the last axis.
    let names: Vec<Vec<u64>> =
        shards.generators().unwrap().degrees[1][0].terms.iter().map(|term| term.name.clone()).collect();
    assert!(names.iter().flatten().all(|&vertex| vertex < 12), "{names:?}");
}

#[test]
fn windows_are_written_in_any_order_and_checked() {
    let volume = CubicalVolume::full(&[4, 4], &[false; 2]).unwrap();
    let boxes = VoxelBoxes::new(&[4, 4], &[false; 2], &[2, 1]).unwrap();
    let folder = tempfile::tempdir().unwrap();
    let grid = GridShards::new(GridSort::Cubes, boxes.clone(), 2);
    let writer = grid.create(folder.path(), ShardSource::default(), 5, false).unwrap();
    let window = |number: u32| volume.window(&boxes.voxels(number)).unwrap();
    assert!(writer.write(0, &window(1)).unwrap_err().to_string().contains("part 0"));
    writer.write(1, &window(1)).unwrap();
    assert!(writer.finish().unwrap_err().to_string().contains("box 0"));
    let writer = grid.create(folder.path(), ShardSource::default(), 5, false).unwrap();
    writer.write(0, &window(0)).unwrap();
    assert_eq!(merged(&writer.finish().unwrap()).homology().betti_numbers(), [1, 0, 0]);
    // Another volume of the same shape is another complex.
    assert!(
        grid.create(folder.path(), ShardSource::default(), 6, false)
            .unwrap_err()
            .to_string()
            .contains("--force")
    );
}

#[test]
fn what_does_not_stream_is_left_to_be_read() {
    let folder = tempfile::tempdir().unwrap();
    let stream = |name: &str, text: &str| {
        let path = folder.path().join(name);
        fs::write(&path, text).unwrap();
        shard_mesh_file(&path, None, &folder.path().join("shards"), &ShardRequest::new("a", 2))
    };
    let cube = "MeshVersionFormatted 2\nDimension 3\nVertices 8\n0 0 0 0\n1 0 0 0\n1 1 0 0\n0 1 0 0\n0 0 1 0\n1 0 1 0\n1 1 1 0\n\
                0 1 1 0\nHexahedra 1\n1 2 3 4 5 6 7 8 0\nEnd\n";
    assert!(stream("cube.mesh", cube).unwrap().is_none());
    assert!(stream("a.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n").unwrap().is_none());
    let error =
        stream("bad.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices 1\n0 0 0 0\nEdges 1\n1 2 0\nEnd\n")
            .unwrap_err();
    assert!(error.file().is_some() && error.line() == Some(6), "{error}");
    assert!(stream("cut.mesh", "MeshVersionFormatted 2\nDimension 3\nVertices 5\n0 0 0 0\n").is_err());
    assert!(!folder.path().join("shards/.scratch").exists());
    // Files of nothing but vertices, of one part.
    for (parts, text) in [(1, mesh_text(&[[0.0; 3]; 4], &[])), (3, mesh_text(&[[0.0; 3]; 4], &[vec![0, 1]]))]
    {
        let path = folder.path().join("points.mesh");
        fs::write(&path, text).unwrap();
        check_mesh(&path, parts, &Owners::Automatic);
    }
}

/// Real meshes of tetrahedra, and the same by Gmsh.
#[test]
fn real_meshes_stream() {
    let Some(data) = std::env::var_os("COFACE_DATA").map(std::path::PathBuf::from) else {
        println!("COFACE_DATA is not set: real meshes are skipped");
        return;
    };
    for name in ["octopus-low.mesh", "beam_h5t12.mesh", "box.msh"] {
        let path = data.join("volumes").join(name);
        let model = io::read_path(&path, None).unwrap();
        if model.shapes().iter().any(|shape| shape.vertex_count() != 4) {
            continue;
        }
        for parts in [1, 7, 16] {
            check_mesh(&path, parts, &Owners::Automatic);
        }
        let folder = tempfile::tempdir().unwrap();
        let again: Model =
            Model::from_cells(model.positions().clone(), model.shapes().to_vec(), model.cells().clone())
                .unwrap();
        let other = folder.path().join("again.msh");
        io::write_path(&again, &other, Some(Format::Msh)).unwrap();
        check_mesh(&other, 5, &Owners::Random);
    }
}
