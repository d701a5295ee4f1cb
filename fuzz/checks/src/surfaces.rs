//! Edits and repairs of surfaces.

use coface::algebra::RaggedArray;
use coface::complexes::surface::{FacesAtEdge, GeneralizedMap, HalfedgeMesh, MeshRepair, PolygonMesh};
use coface::{EdgeId, FaceId, HalfedgeId, VertexId};

/// Any sequence of edits keeps the invariants of a halfedge mesh and the surface that it is.
///
/// The first byte says how many edges there are, as many bytes as halfedges shuffle `next`, then come three bytes an edit.
pub fn edit_halfedges(bytes: &[u8]) {
    let Some((&first, rest)) = bytes.split_first() else { return };
    let count = 2 * (1 + first as usize % 16);
    if rest.len() < count {
        return;
    }
    let (shuffle, edits) = rest.split_at(count);
    let mut next: Vec<u32> = (0..count as u32).collect();
    for (i, &byte) in shuffle.iter().enumerate() {
        next.swap(i, i + byte as usize % (count - i));
    }
    let mut mesh = HalfedgeMesh::from_next(next).expect("a permutation of an even number of halfedges");
    let invariants =
        |mesh: &HalfedgeMesh| (mesh.euler_characteristic(), mesh.component_count(), mesh.outer_face_count());
    let mut expected = invariants(&mesh);
    for edit in edits.chunks_exact(3) {
        let [kind, first, second] = [edit[0] % 14, edit[1], edit[2]].map(usize::from);
        let edge = EdgeId::new(first % mesh.edge_count());
        let [h, other] = [first, second].map(|number| HalfedgeId::new(number % mesh.halfedge_count()));
        let face = FaceId::new(first % mesh.face_count());
        let before = mesh.clone();
        let done = match kind {
            0 => mesh.split_edge(edge).map(drop),
            1 => mesh.remove_vertex(VertexId::new(first % mesh.vertex_count())).map(drop),
            2 => mesh.split_face(h, other).map(drop),
            3 => mesh.remove_edge(edge).map(drop),
            4 => mesh.split_vertex(h, other).map(drop),
            5 => mesh.collapse_edge(edge).map(drop),
            6 => mesh.remove_pendant_edge(edge).map(drop),
            7 => mesh.flip_edge(edge),
            8 => mesh.flip_edge_back(edge),
            9 => mesh.poke_face(face).map(drop),
            10 => mesh.collapse_edge_simplicially(edge).map(drop),
            // These may change the surface.
            11 => mesh.slice_edges(&[edge]).map(|slice| mesh = slice.into_surface()),
            12 => mesh.glue(&[(h, other)]).map(|glued| mesh = glued.into_surface()),
            _ => mesh.clone().with_outer_faces(&[face]).map(|opened| mesh = opened),
        };
        match done {
            Ok(()) if kind > 10 => expected = invariants(&mesh),
            Ok(()) => assert_eq!(invariants(&mesh), expected),
            Err(_) => assert!(mesh == before, "what is refused changes nothing"),
        }
        mesh.check().expect("edits keep the invariants");
    }
}

/// Any list of polygons is repaired to a surface on the same corners.
pub fn repair_mesh(bytes: &[u8]) {
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
}
