//! Random complexes for property tests, and checks that every producer passes, for this crate and those above it (feature `samples`).
#![allow(clippy::cast_possible_truncation, reason = "samples are small")]

use crate::CellId;
use crate::RaggedArray;
use crate::chains::{Cells, ChainComplex};
use crate::matrices::SparseMatrix;
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

/// Complexes to test algorithms with: all faces of random simplices, with signs of cells flipped at random, or two
/// such complexes glued by a degree (entries beyond units come from doubling a boundary).
pub fn random_complexes() -> impl Strategy<Value = ChainComplex> {
    let simplices = prop::collection::vec(prop::collection::btree_set(0u32..8, 1..5), 0..14);
    (simplices, any::<u64>(), any::<bool>()).prop_map(|(simplices, flips, doubled)| {
        let mut levels: Vec<BTreeSet<Vec<u32>>> = vec![BTreeSet::new(); 4];
        for simplex in simplices {
            let vertices: Vec<u32> = simplex.into_iter().collect();
            for subset in 1u32..1 << vertices.len() {
                let face: Vec<u32> =
                    (0..vertices.len()).filter(|i| subset >> i & 1 == 1).map(|i| vertices[i]).collect();
                levels[face.len() - 1].insert(face);
            }
        }
        let levels: Vec<Vec<Vec<u32>>> =
            levels.into_iter().map(|level| level.into_iter().collect()).collect();
        let flip = |k: usize, i: usize| if flips.rotate_left((7 * k + i) as u32) & 1 == 1 { -1 } else { 1 };
        let top = levels.iter().rposition(|level| !level.is_empty()).unwrap_or(0);
        let matrices = (1..levels.len()).map(|k| {
            // A factor on all boundaries of the top degree keeps boundary of boundary zero.
            let factor = if doubled && k == top { 2 } else { 1 };
            let entries = levels[k].iter().enumerate().flat_map(|(j, simplex)| {
                let below = &levels[k - 1];
                (0..=k).map(move |i| {
                    let mut face = simplex.clone();
                    face.remove(i);
                    let row = below.binary_search(&face).expect("faces of simplices are listed");
                    let sign = if i % 2 == 0 { 1 } else { -1 };
                    (row, j, factor * sign * flip(k, j) * flip(k - 1, row))
                })
            });
            SparseMatrix::from_entries(levels[k - 1].len(), levels[k].len(), entries)
                .expect("faces of simplices are listed")
        });
        ChainComplex::new(matrices.collect()).expect("faces of simplices are listed")
    })
}

/// Cells that are closed under faces: in each degree k those below a number, `sizes[k]` if there is one, all whose
/// faces are kept.
pub fn closed_cells(complex: &ChainComplex, sizes: &[usize]) -> Vec<Vec<CellId>> {
    let mut cells: Vec<Vec<CellId>> = Vec::new();
    for degree in 0..complex.degree_count() {
        let has_faces = |cell: usize| {
            complex.boundary_matrix(degree).is_none_or(|matrix| {
                let faces = matrix.column(cell).rows().iter();
                faces.map(|&row| CellId::new(row as usize)).all(|face| cells[degree - 1].contains(&face))
            })
        };
        let count = complex.cell_count(degree).min(sizes.get(degree).copied().unwrap_or(usize::MAX));
        cells.push((0..count).filter(|&cell| has_faces(cell)).map(CellId::new).collect());
    }
    cells
}

/// Checks what holds for every producer of cells; `has_paths` says whether its faces have paths around them.
///
/// * Boundary of boundary is zero, and the counts of cells are the columns of the matrices.
/// * There is a list of vertices for each cell; the lists of its facets are parts of it, and an edge is listed from its
///   source to its target.
/// * The 2-skeleton, where there is one, has the same boundary matrices, and its faces the same vertices.
///
/// # Panics
/// With the name, where something does not hold.
#[allow(clippy::unwrap_used, reason = "a check that cannot go on has failed")]
pub fn keeps_the_contract(name: &str, cells: &dyn Cells, has_paths: bool) {
    let chains = cells.chain_complex().unwrap();
    ChainComplex::new(chains.boundary_matrices().to_vec())
        .map(|again| assert_eq!(again, chains, "{name}"))
        .unwrap_or_else(|_| assert!(chains.degree_count() <= 1, "{name}"));
    let counts = cells.f_vector().unwrap();
    assert_eq!(trimmed(&counts), trimmed(chains.f_vector()), "{name}");
    let lists: Vec<RaggedArray> =
        (0..=counts.len()).map(|degree| cells.cell_vertices(degree).unwrap()).collect();
    for (degree, lists) in lists.iter().enumerate() {
        assert_eq!(lists.len(), chains.cell_count(degree), "{name} in degree {degree}");
    }
    let names = &lists[0];
    assert!(names.iter().all(|list| list.len() == 1), "{name}");
    let place: BTreeMap<u32, usize> = names.items().iter().enumerate().map(|(i, &v)| (v, i)).collect();
    assert_eq!(place.len(), names.len(), "{name}: each vertex has a name of its own");
    let set =
        |degree: usize, cell: usize| lists[degree].list(cell).iter().copied().collect::<BTreeSet<u32>>();
    for degree in 1..counts.len() {
        for cell in 0..chains.cell_count(degree) {
            let column = chains.boundary_matrix(degree).unwrap().column(cell);
            let vertices = set(degree, cell);
            // Facets that cancel, as of a loop, leave fewer in the boundary than there are.
            for &facet in column.rows() {
                assert!(
                    vertices.is_superset(&set(degree - 1, facet as usize)),
                    "{name}: cell {cell} of degree {degree}"
                );
            }
            if degree == 1 && column.rows().len() == 2 {
                let matrix = chains.boundary_matrix(1).unwrap();
                let signs: Vec<i32> =
                    lists[1].list(cell).iter().map(|end| matrix.entry(place[end], cell)).collect();
                assert_eq!(signs, [-1, 1], "{name}: edge {cell} runs from its source to its target");
            }
        }
    }
    let skeleton = cells.two_skeleton();
    assert_eq!(skeleton.is_ok(), has_paths, "{name}: {:?}", skeleton.err());
    let Ok(skeleton) = skeleton else { return };
    let low = skeleton.chain_complex().unwrap();
    for degree in 0..=2 {
        assert_eq!(low.cell_count(degree), chains.cell_count(degree), "{name}");
        if chains.cell_count(degree) > 0 {
            assert_eq!(low.boundary_matrix(degree), chains.boundary_matrix(degree), "{name}");
        }
    }
    let around = skeleton.cell_vertices(2).unwrap();
    for (face, list) in lists.get(2).into_iter().flat_map(|lists| lists.iter()).enumerate() {
        let around: BTreeSet<u32> = around.list(face).iter().map(|&v| names.items()[v as usize]).collect();
        assert_eq!(around, list.iter().copied().collect(), "{name}: face {face}");
    }
}

/// The counts up to the last degree that has a cell.
fn trimmed(counts: &[usize]) -> &[usize] {
    let end = counts.iter().rposition(|&count| count > 0).map_or(0, |last| last + 1);
    &counts[..end]
}
