//! Random complexes for property tests, of this crate and of those above it (feature `samples`).
#![allow(clippy::cast_possible_truncation, reason = "samples are small")]

use crate::CellId;
use crate::chains::ChainComplex;
use crate::matrices::SparseMatrix;
use proptest::prelude::*;
use std::collections::BTreeSet;

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
