//! Guide 19: operators between cells as products of matrices, and pieces that are merged with a tolerance.
//!
//! Run with `cargo run -p coface --example 19_operators_and_congruence`.

use coface::algebra::RaggedArray;
use coface::arrange::congruence::{
    BlockPolicy, CellClasses, ClassRule, CongruenceOptions, Representative, blocks_of, chain_congruence,
    check_blocks, vertex_congruence,
};
use coface::complexes::lar::{LarModel, Shared, oriented_boundary};
use coface::complexes::surface::PolygonMesh;
use coface::{Positions, homology};

fn main() -> Result<(), coface::Error> {
    // Two triangles with a common edge. The product of the characteristic matrices counts shared vertices: a face has 3 in common with itself and 2
    // with its neighbor.
    let edges = RaggedArray::from_lists([[0, 1], [0, 2], [1, 2], [1, 3], [2, 3]]);
    let faces = RaggedArray::from_lists([[0, 1, 2], [1, 2, 3]]);
    let model = LarModel::new(4, vec![edges, faces])?;
    let shared = model.shared_vertices("FF".parse()?)?;
    assert_eq!((shared.entry(0, 0), shared.entry(0, 1)), (3, 2));
    let characteristic = model.characteristic_matrix(2)?;
    assert_eq!(characteristic.checked_product(&characteristic.transpose())?, shared);

    // The other operators follow by a threshold. Which edges lie in the first face? Those that share both of their vertices with it.
    assert_eq!(model.related("FE".parse()?, Shared::AllOfColumn)?.list(0), [0, 1, 2]);
    assert_eq!(model.incident("VF".parse()?)?.list(1), [0, 1]);
    assert_eq!(model.incident("VV".parse()?)?.list(1), [0, 2, 3]);

    // Signs: each face is oriented by its first edge. The two do not agree on the common edge until one of them is turned.
    let corners = model.facets(2)?;
    let oriented = oriented_boundary(&model.edge_boundaries()?, &corners)?;
    assert_eq!(oriented.coherence()?.is_coherent(), Some(false));
    let coherent = oriented.coherent()?;
    assert_eq!(coherent.coherence()?.is_coherent(), Some(true));
    // Now the sum of both faces has the rim as its boundary: the common edge, number 2, cancels.
    let sum: i64 = (0..2).map(|face| i64::from(coherent.boundary().entry(2, face))).sum();
    assert_eq!(sum, 0);

    // The same two triangles as two pieces, each with vertices of its own, measured with an error of 0.001: nothing is common to them.
    let places = vec![0.0, 0.0, 1.0, 0.0, 0.0, 1.0, 1.001, 0.0, 0.0, 1.0, 1.0, 1.0];
    let positions = Positions::from_flat(2, places)?;
    let pieces =
        PolygonMesh::new(6, RaggedArray::from_lists([[0, 1, 2], [3, 5, 4]]), &[])?.chain_complex()?;
    assert_eq!(homology(&pieces).betti_numbers(), [2, 0, 0]);

    // Vertices within the tolerance are one class: 6 vertices become 4, at the mean of their members.
    let near = vertex_congruence(&positions, 0.01, ClassRule::Transitive, Representative::Mean)?;
    assert_eq!(near.class_of(), [0, 1, 2, 1, 2, 3]);
    assert!((near.largest_diameter() - 0.001).abs() < 1e-9);
    // A class with two vertices of one piece would shrink a cell: the tolerance is too large then, and the policy refuses it.
    let blocks = blocks_of(&pieces);
    assert!(check_blocks(&near, &positions, &blocks, BlockPolicy::Forbid)?.is_empty());
    let wide = vertex_congruence(&positions, 2.0, ClassRule::Transitive, Representative::Mean)?;
    assert!(check_blocks(&wide, &positions, &blocks, BlockPolicy::Forbid).is_err());

    // The congruence of vertices carries over to edges and faces: 6 edges become 5, and the boundary of a boundary stays zero.
    let classes = CellClasses::unsigned(near.class_of().to_vec())?;
    let merged = chain_congruence(&pieces, classes, Some(near.positions()), CongruenceOptions::default())?;
    assert_eq!(merged.complex().f_vector(), [4, 5, 2]);
    assert_eq!(homology(merged.complex()).betti_numbers(), [1, 0, 0]);
    assert_eq!(merged.collapsed_counts(), [0, 0, 0]);
    Ok(())
}
