//! Any list of polygons is repaired to a surface on the same corners.
#![no_main]

use coface::algebra::RaggedArray;
use coface::complexes::surface::{FacesAtEdge, GeneralizedMap, MeshRepair, PolygonMesh};
use coface::{FaceId, VertexId};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let Some((&first, rest)) = bytes.split_first() else { return };
    // Polygons of three to six of sixteen vertices, one a byte; what repeats a vertex is no polygon.
    let polygons = rest.chunks(7).filter(|chunk| chunk.len() == 7).map(|chunk| {
        let size = 3 + chunk[0] as usize % 4;
        chunk[1..=size].iter().map(|byte| u32::from(byte % 16)).collect::<Vec<u32>>()
    });
    let Ok(given) = PolygonMesh::new(16, RaggedArray::from_lists(polygons), &[]) else { return };
    let together = if first % 2 == 0 { FacesAtEdge::Apart } else { FacesAtEdge::CoherentPairs };
    let mut repair = MeshRepair::new(given.clone());
    repair.split_edges(together).expect("small meshes have room");
    repair.split_vertices().expect("small meshes have room");
    assert!(repair.mesh().manifold_verdict().is_manifold());
    for face in (0..given.face_count()).map(FaceId::new) {
        let corners =
            repair.mesh().face(face).iter().map(|&v| repair.vertex_sources()[VertexId::from_u32(v)].to_u32());
        assert!(corners.eq(given.face(face).iter().copied()));
    }
    let skeleton = repair.mesh().two_skeleton().expect("a mesh has edges and faces");
    GeneralizedMap::new(skeleton).expect("a repaired mesh is a surface");
    let is_orientable = repair.mesh().orientation().is_orientable() == Some(true);
    assert_eq!(repair.orient().is_ok(), is_orientable);
    assert_eq!(repair.mesh().halfedges().is_ok(), is_orientable);
});
