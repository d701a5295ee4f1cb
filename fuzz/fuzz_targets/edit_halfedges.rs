//! Any sequence of edits keeps the invariants of a halfedge mesh and the surface that it is.
//!
//! The first byte says how many edges there are, as many bytes as halfedges shuffle `next`, then come three bytes an edit.
#![no_main]

use coface::complexes::surface::HalfedgeMesh;
use coface::{EdgeId, FaceId, HalfedgeId, VertexId};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
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
});
