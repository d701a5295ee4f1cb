//! Chain complexes with a basis of cells in each degree.

use crate::{Entry, Integer, SparseMatrix, WideMatrix};
use crate::{Error, ErrorKind};

/// A finite chain complex of free abelian groups, each with a basis of cells.
///
/// For each degree k a number of cells and, for k at least 1, the boundary matrix from k-chains to (k-1)-chains.
/// Incidences of cells are small: entries have 32 bits. What is left of a complex after a reduction can have entries of any size, a
/// [`WideComplex`].
///
/// # Examples
/// A triangle's rim: three vertices and three edges.
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::ChainComplex;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let boundary =
///     SparseMatrix::from_entries(3, 3, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)])?;
/// let circle = ChainComplex::new(vec![boundary])?;
/// assert_eq!(circle.euler_characteristic(), 0);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChainComplex<E: Entry = i32> {
    cell_counts: Vec<usize>,
    /// The matrix of degree k is at position k - 1.
    boundaries: Vec<SparseMatrix<E>>,
}

/// A chain complex with incidences of any size.
pub type WideComplex = ChainComplex<Integer>;

impl ChainComplex {
    /// The complex with these boundary matrices, of degrees 1, 2, ...; column j of the matrix of degree k is the
    /// boundary of k-cell j.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless each matrix has as many rows as the one before has columns, and for an empty list
    /// (use [`Self::of_points`]); [`ErrorKind::BoundaryOfBoundary`] naming the first cell whose boundary is no cycle.
    ///
    /// # Complexity
    /// Linear in the multiplications of the products of neighboring matrices, in parallel; no product is stored.
    pub fn new(boundaries: Vec<SparseMatrix>) -> Result<Self, Error> {
        let Some(first) = boundaries.first() else {
            return Err(Error::new(ErrorKind::Shape, "a chain complex needs a boundary matrix")
                .with_cure("make a complex without cells of positive degree by ChainComplex::of_points"));
        };
        let cell_counts = cell_counts_of(first.row_count(), &boundaries)?;
        for (k, pair) in boundaries.windows(2).enumerate() {
            if let Some(cell) = pair[0].first_nonzero_product_column(&pair[1])? {
                return Err(no_cycle(cell, k + 2));
            }
        }
        Ok(Self { cell_counts, boundaries })
    }

    /// The same for matrices, at least one, that fit together and whose products are zero by the way they were made: only debug builds
    /// multiply them.
    #[doc(hidden)]
    pub fn from_trusted_boundaries(boundaries: Vec<SparseMatrix>) -> Self {
        debug_assert!(Self::new(boundaries.clone()).is_ok(), "the boundary of a boundary is zero");
        let rows = boundaries.first().map(SparseMatrix::row_count);
        let cell_counts = rows.into_iter().chain(boundaries.iter().map(SparseMatrix::column_count)).collect();
        Self { cell_counts, boundaries }
    }

    /// The complex of `count` points: cells of degree 0 only. No point gives the empty complex.
    pub fn of_points(count: usize) -> Self {
        Self { cell_counts: if count == 0 { Vec::new() } else { vec![count] }, boundaries: Vec::new() }
    }
}

impl WideComplex {
    /// The complex of this many vertices and these boundary matrices, of degrees 1, 2, ..., if any.
    ///
    /// # Errors
    /// As of [`ChainComplex::new`].
    pub fn of_wide(vertex_count: usize, boundaries: Vec<WideMatrix>) -> Result<Self, Error> {
        cell_counts_of(vertex_count, &boundaries)?;
        for (k, pair) in boundaries.windows(2).enumerate() {
            let product = pair[0].product(&pair[1])?.into_wide();
            if let Some(cell) = product.columns().position(|column| !column.rows().is_empty()) {
                return Err(no_cycle(cell, k + 2));
            }
        }
        Ok(Self::from_trusted(vertex_count, boundaries))
    }
}

/// The numbers of cells of matrices that fit together.
fn cell_counts_of<E: Entry>(
    vertex_count: usize,
    boundaries: &[SparseMatrix<E>],
) -> Result<Vec<usize>, Error> {
    let mut cell_counts = vec![vertex_count];
    for (k, matrix) in boundaries.iter().enumerate() {
        if matrix.row_count() != cell_counts[k] {
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "the boundary matrix of degree {} has {} rows, but there are {} cells of degree {k}",
                    k + 1,
                    matrix.row_count(),
                    cell_counts[k]
                ),
            ));
        }
        cell_counts.push(matrix.column_count());
    }
    Ok(cell_counts)
}

fn no_cycle(cell: usize, degree: usize) -> Error {
    let message = format!("the boundary of the boundary of cell {cell} of degree {degree} is not zero");
    Error::new(ErrorKind::BoundaryOfBoundary, message).with_cure("check the signs of its faces")
}

impl<E: Entry> ChainComplex<E> {
    /// The complex of this many vertices and these matrices, which fit together and whose products are zero by the way they were made.
    pub(super) fn from_trusted(vertex_count: usize, boundaries: Vec<SparseMatrix<E>>) -> Self {
        let has_no_degree = vertex_count == 0 && boundaries.is_empty();
        let counts = cell_counts_of(vertex_count, &boundaries).expect("the matrices fit together");
        Self { cell_counts: if has_no_degree { Vec::new() } else { counts }, boundaries }
    }

    /// The number of cells of this degree; 0 beyond the dimension.
    pub fn cell_count(&self, degree: usize) -> usize {
        self.cell_counts.get(degree).copied().unwrap_or(0)
    }

    /// The numbers of cells of degrees 0, 1, ...
    pub fn f_vector(&self) -> &[usize] {
        &self.cell_counts
    }

    /// The number of degrees: one more than the highest degree that is stored (possibly without cells).
    pub fn degree_count(&self) -> usize {
        self.cell_counts.len()
    }

    /// The highest degree with a cell; `None` for the empty complex.
    pub fn dimension(&self) -> Option<usize> {
        self.cell_counts.iter().rposition(|&count| count > 0)
    }

    /// The boundary matrix from degree `degree` to `degree - 1`; `None` for degree 0 and beyond the dimension, where
    /// the map is zero.
    pub fn boundary_matrix(&self, degree: usize) -> Option<&SparseMatrix<E>> {
        self.boundaries.get(degree.checked_sub(1)?)
    }

    /// The coboundary matrix from degree `degree` to `degree + 1`, the transpose of the boundary matrix of
    /// `degree + 1`; `None` where that map is zero.
    pub fn coboundary_matrix(&self, degree: usize) -> Option<SparseMatrix<E>> {
        self.boundary_matrix(degree + 1).map(SparseMatrix::transpose)
    }

    /// All boundary matrices, of degrees 1, 2, ...
    pub fn boundary_matrices(&self) -> &[SparseMatrix<E>] {
        &self.boundaries
    }

    /// The alternating sum of the numbers of cells.
    pub fn euler_characteristic(&self) -> i64 {
        self.cell_counts
            .iter()
            .enumerate()
            .map(|(k, &n)| if k % 2 == 0 { n as i64 } else { -(n as i64) })
            .sum()
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::CellId;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    /// Complexes to test algorithms with: all faces of random simplices, with signs of cells flipped at random, or two
    /// such complexes glued by a degree (entries beyond units come from doubling a boundary).
    pub(crate) fn random_complexes() -> impl Strategy<Value = ChainComplex> {
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
            let flip =
                |k: usize, i: usize| if flips.rotate_left((7 * k + i) as u32) & 1 == 1 { -1 } else { 1 };
            let top = levels.iter().rposition(|level| !level.is_empty()).unwrap_or(0);
            let matrices = (1..levels.len()).map(|k| {
                // A factor on all boundaries of the top degree keeps boundary of boundary zero.
                let factor = if doubled && k == top { 2 } else { 1 };
                let entries = levels[k].iter().enumerate().flat_map(|(j, simplex)| {
                    let below = &levels[k - 1];
                    (0..=k).map(move |i| {
                        let mut face = simplex.clone();
                        face.remove(i);
                        let row = below.binary_search(&face).unwrap();
                        let sign = if i % 2 == 0 { 1 } else { -1 };
                        (row, j, factor * sign * flip(k, j) * flip(k - 1, row))
                    })
                });
                SparseMatrix::from_entries(levels[k - 1].len(), levels[k].len(), entries).unwrap()
            });
            ChainComplex::new(matrices.collect()).unwrap()
        })
    }

    /// Cells that are closed under faces: in each degree k those below a number, `sizes[k]` if there is one, all whose
    /// faces are kept.
    pub(crate) fn closed_cells(complex: &ChainComplex, sizes: &[usize]) -> Vec<Vec<CellId>> {
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

    #[test]
    fn a_boundary_that_is_no_cycle_is_named() {
        let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)]).unwrap();
        let face = SparseMatrix::from_entries(2, 1, [(0, 0, 1), (1, 0, 1)]).unwrap();
        let error = ChainComplex::new(vec![edges, face]).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::BoundaryOfBoundary);
        assert!(error.message().contains("cell 0 of degree 2"));
    }
}
