//! Halfedge meshes, what they are made from and what they are exported to: all have the same homology.

use coface_algebra::FaceId;
use coface_algebra::chains::ChainComplex;
use coface_complexes::known_spaces;
use coface_complexes::simplicial::SimplicialComplex;
use coface_complexes::surface::HalfedgeMesh;
use coface_topology::{AbelianGroup, homology};
use proptest::prelude::*;

fn groups(complex: &ChainComplex) -> Vec<AbelianGroup> {
    homology(complex).groups().to_vec()
}

#[test]
fn surfaces_of_simplices_keep_their_homology() {
    let spaces: [SimplicialComplex; 6] = [
        known_spaces::simplex_boundary(2).unwrap(),
        known_spaces::cross_polytope_boundary(2).unwrap(),
        known_spaces::cyclic_torus(2).unwrap(),
        known_spaces::torus_grid(&[4, 5]).unwrap(),
        known_spaces::simplex(2).unwrap(),
        known_spaces::triangle_strip(6).unwrap(),
    ];
    for space in spaces {
        let complex = space.chain_complex().unwrap();
        let mesh = HalfedgeMesh::from_simplicial_complex(&space).unwrap();
        assert_eq!(groups(&mesh.chain_complex().unwrap()), groups(&complex));
        let through_matrices = HalfedgeMesh::from_chain_complex(&complex).unwrap();
        assert_eq!(groups(&through_matrices.chain_complex().unwrap()), groups(&complex));
    }
}

proptest! {
    #[test]
    fn subdivisions_keep_homology(
        next in Just((0u32..8).collect::<Vec<_>>()).prop_shuffle(),
        outer in 0usize..8,
    ) {
        let mesh = HalfedgeMesh::from_next(next).unwrap();
        let face = FaceId::new(outer % mesh.face_count());
        let mesh = mesh.clone().with_outer_faces(&[face]).unwrap_or(mesh);
        let expected = groups(&mesh.chain_complex().unwrap());
        let once = mesh.barycentric_subdivision().unwrap();
        prop_assert_eq!(&groups(&once.complex().chain_complex().unwrap()), &expected);
        let simplicial = once.subdivided().unwrap().complex().to_simplicial_complex().unwrap();
        prop_assert_eq!(&groups(&simplicial.chain_complex().unwrap()), &expected);
    }
}
