//! Quotients by products of the C library SuiteSparse:GraphBLAS, which share no line of arithmetic with ours: the third method
//! beside lists and matrices. With the feature `graphblas-tests`, where the library is installed.
#![allow(clippy::unwrap_used, reason = "a helper of a test that cannot go on is the test failing")]

use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, SparseMatrix};
use coface_arrange::congruence::{CellClasses, CongruenceOptions, chain_congruence};
use coface_graphblas::Matrix;
use std::collections::BTreeMap;

/// The product of two matrices, with 32-bit entries.
fn product(first: &SparseMatrix, second: &SparseMatrix) -> SparseMatrix {
    let [first, second] = [first, second].map(|matrix| {
        let (starts, rows, entries) = (matrix.column_starts(), matrix.rows(), matrix.entries());
        Matrix::from_columns(matrix.row_count(), starts, rows, entries).unwrap()
    });
    let columns = first.product(&second).unwrap().to_columns().unwrap();
    SparseMatrix::from_parts(columns.row_count, columns.starts, columns.rows, columns.entries).unwrap()
}

/// The matrix that takes cells to their classes, and the lowest cell of each class: cells with the same column of `mapped` up
/// to sign have one class, cells of `boundary` whose column vanished have none.
fn classes(mapped: &SparseMatrix, boundary: &SparseMatrix) -> (SparseMatrix, Vec<usize>) {
    let mut known: BTreeMap<(Vec<u32>, Vec<i32>), usize> = BTreeMap::new();
    let (mut entries, mut lowest) = (Vec::new(), Vec::new());
    for (cell, column) in mapped.columns().enumerate() {
        let sign = column.entries().first().map_or(1, |entry| entry.signum());
        let key = (column.rows().to_vec(), column.entries().iter().map(|entry| entry * sign).collect());
        let class = match known.get(&key).filter(|_| !column.rows().is_empty()) {
            Some(&class) => class,
            None if column.rows().is_empty() && !boundary.column(cell).rows().is_empty() => continue,
            None => {
                known.insert(key, lowest.len());
                lowest.push((cell, sign));
                lowest.len() - 1
            }
        };
        entries.push((class, cell, i64::from(sign * lowest[class].1)));
    }
    let matrix = SparseMatrix::from_entries(lowest.len(), mapped.column_count(), entries).unwrap();
    (matrix, lowest.into_iter().map(|(cell, _)| cell).collect())
}

/// Asserts that the quotient of a complex by lists is the one by products of GraphBLAS, entry by entry.
pub(crate) fn check(complex: &ChainComplex, vertices: &CellClasses) {
    let found = chain_congruence(complex, vertices.clone(), None, CongruenceOptions::default()).unwrap();
    let mut lower = vertices.matrix().unwrap();
    for (degree, matrix) in (1..).zip(complex.boundary_matrices()) {
        let mapped = product(&lower, matrix);
        let (own, lowest) = classes(&mapped, matrix);
        let selection = lowest.iter().enumerate().map(|(class, &cell)| (cell, class, 1));
        let selection = SparseMatrix::from_entries(mapped.column_count(), lowest.len(), selection).unwrap();
        assert_eq!(found.complex().boundary_matrix(degree), Some(&product(&mapped, &selection)));
        assert_eq!(found.classes()[degree].matrix().unwrap(), own);
        lower = own;
    }
}

/// A triangle whose copy runs the other way is the same triangle with the sign minus.
#[test]
fn two_triangles_become_one() {
    let edges = (0..6).flat_map(|e| [(e, e, -1), (e / 3 * 3 + (e + 1) % 3, e, 1)]);
    let edges = SparseMatrix::from_entries(6, 6, edges).unwrap();
    let faces = (0..6).map(|e| (e, e / 3, if e < 3 { 1 } else { -1 }));
    let faces = SparseMatrix::from_entries(6, 2, faces).unwrap();
    let complex = ChainComplex::new(vec![edges, faces]).unwrap();
    let vertices = CellClasses::unsigned(vec![0, 1, 2, 0, 1, 2]).unwrap();
    check(&complex, &vertices);
    let found = chain_congruence(&complex, vertices, None, CongruenceOptions::default()).unwrap();
    assert_eq!(found.complex().f_vector(), [3, 3, 1]);
    assert_eq!(
        found.classes()[2].class(CellId::new(1)).map(|(class, sign)| (class, sign.to_i32())),
        Some((0, -1))
    );
}
