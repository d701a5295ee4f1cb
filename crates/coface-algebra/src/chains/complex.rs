//! Chain complexes with a basis of cells in each degree.

use crate::integers::Integer;
use crate::matrices::{Entry, SparseMatrix, WideMatrix};
use crate::{CellId, Error, ErrorKind, Fault};

/// A finite chain complex of free abelian groups, each with a basis of cells.
///
/// For each degree k a number of cells and, for k at least 1, the boundary matrix from k-chains to (k-1)-chains.
/// Incidences of cells are small: entries have 32 bits. What is left of a complex after a reduction can have entries of
/// any size, a [`WideComplex`].
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
    /// (use [`Self::of_points`]); [`ErrorKind::BoundaryOfBoundary`] naming the first cell whose boundary is not a
    /// cycle.
    ///
    /// # Complexity
    /// Linear in the multiplications of the products of neighboring matrices, in parallel; no product is stored.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?;
    /// assert_eq!(ChainComplex::new(vec![edge.clone()])?.f_vector(), [2, 1]);
    /// // The boundary of a face on one edge alone is no cycle.
    /// assert!(ChainComplex::new(vec![edge, SparseMatrix::identity(1)?]).is_err());
    /// # Ok(()) }
    /// ```
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

    /// The complex with boundary matrices, at least one, that are known to be valid: only debug builds multiply them.
    #[doc(hidden)]
    pub fn from_trusted_boundaries(boundaries: Vec<SparseMatrix>) -> Self {
        debug_assert!(Self::new(boundaries.clone()).is_ok(), "the boundary of a boundary is zero");
        let rows = boundaries.first().map(SparseMatrix::row_count);
        let cell_counts = rows.into_iter().chain(boundaries.iter().map(SparseMatrix::column_count)).collect();
        Self { cell_counts, boundaries }
    }

    /// The complex of `count` points: cells of degree 0 only. No point gives the empty complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::ChainComplex;
    /// assert_eq!(ChainComplex::of_points(3).f_vector(), [3]);
    /// ```
    pub fn of_points(count: usize) -> Self {
        Self { cell_counts: if count == 0 { Vec::new() } else { vec![count] }, boundaries: Vec::new() }
    }
}

impl WideComplex {
    /// The complex of this many vertices and these boundary matrices, of degrees 1, 2, ..., if any.
    ///
    /// # Errors
    /// As of [`ChainComplex::new`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::WideComplex;
    /// use coface_algebra::{Integer, WideMatrix};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let huge: Integer = "100000000000000000000".parse()?;
    /// let matrix = WideMatrix::from_integer_columns(1, [vec![(0, huge)]])?;
    /// assert_eq!(WideComplex::of_wide(1, vec![matrix])?.f_vector(), [1, 1]);
    /// # Ok(()) }
    /// ```
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
            )
            .with_fault(Fault::Shape {
                found: [matrix.row_count(), matrix.column_count()],
                expected: [Some(cell_counts[k]), None],
            }));
        }
        cell_counts.push(matrix.column_count());
    }
    Ok(cell_counts)
}

fn no_cycle(cell: usize, degree: usize) -> Error {
    let message = format!("the boundary of the boundary of cell {cell} of degree {degree} is not zero");
    Error::new(ErrorKind::BoundaryOfBoundary, message)
        .with_fault(Fault::BoundaryNotCycle { degree, cell: CellId::new(cell) })
        .with_cure("check the signs of its faces")
}

impl<E: Entry> ChainComplex<E> {
    /// The complex of this many vertices and these matrices, which are known to be valid.
    pub(super) fn from_trusted(vertex_count: usize, boundaries: Vec<SparseMatrix<E>>) -> Self {
        let has_no_degree = vertex_count == 0 && boundaries.is_empty();
        let counts = cell_counts_of(vertex_count, &boundaries).expect("the matrices fit together");
        Self { cell_counts: if has_no_degree { Vec::new() } else { counts }, boundaries }
    }

    /// The number of cells of this degree; 0 beyond the dimension.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::ChainComplex;
    /// let points = ChainComplex::of_points(3);
    /// assert_eq!((points.cell_count(0), points.cell_count(1)), (3, 0));
    /// ```
    pub fn cell_count(&self, degree: usize) -> usize {
        self.cell_counts.get(degree).copied().unwrap_or(0)
    }

    /// The numbers of cells of degrees 0, 1, ...
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = TwoSkeleton::new(3, vec![0, 1, 1, 2, 2, 0], RaggedArray::from_lists([[0, 2, 4]]))?;
    /// assert_eq!(triangle.chain_complex()?.f_vector(), [3, 3, 1]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> &[usize] {
        &self.cell_counts
    }

    /// The number of degrees: one more than the highest degree that is stored (possibly without cells).
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::ChainComplex;
    /// assert_eq!(ChainComplex::of_points(3).degree_count(), 1);
    /// ```
    pub fn degree_count(&self) -> usize {
        self.cell_counts.len()
    }

    /// The highest degree with a cell; `None` for the empty complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::ChainComplex;
    /// assert_eq!(ChainComplex::of_points(3).dimension(), Some(0));
    /// assert_eq!(ChainComplex::of_points(0).dimension(), None);
    /// ```
    pub fn dimension(&self) -> Option<usize> {
        self.cell_counts.iter().rposition(|&count| count > 0)
    }

    /// The boundary matrix from degree `degree` to `degree - 1`; `None` for degree 0 and beyond the dimension, where
    /// the map is zero.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = TwoSkeleton::new(2, vec![0, 1], RaggedArray::new())?.chain_complex()?;
    /// assert_eq!(edge.boundary_matrix(1).expect("there is an edge").entries(), [-1, 1]);
    /// assert!(edge.boundary_matrix(0).is_none());
    /// # Ok(()) }
    /// ```
    pub fn boundary_matrix(&self, degree: usize) -> Option<&SparseMatrix<E>> {
        self.boundaries.get(degree.checked_sub(1)?)
    }

    /// The coboundary matrix from degree `degree` to `degree + 1`, the transpose of the boundary matrix of
    /// `degree + 1`; `None` where that map is zero.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = TwoSkeleton::new(2, vec![0, 1], RaggedArray::new())?.chain_complex()?;
    /// let coboundary = edge.coboundary_matrix(0).expect("there is an edge");
    /// assert_eq!((coboundary.row_count(), coboundary.column_count()), (1, 2));
    /// # Ok(()) }
    /// ```
    pub fn coboundary_matrix(&self, degree: usize) -> Option<SparseMatrix<E>> {
        self.boundary_matrix(degree + 1).map(SparseMatrix::transpose)
    }

    /// All boundary matrices, of degrees 1, 2, ...
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = TwoSkeleton::new(3, vec![0, 1, 1, 2, 2, 0], RaggedArray::from_lists([[0, 2, 4]]))?;
    /// assert_eq!(triangle.chain_complex()?.boundary_matrices().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn boundary_matrices(&self) -> &[SparseMatrix<E>] {
        &self.boundaries
    }

    /// The alternating sum of the numbers of cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::TwoSkeleton;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = TwoSkeleton::new(3, vec![0, 1, 1, 2, 2, 0], RaggedArray::from_lists([[0, 2, 4]]))?;
    /// assert_eq!(triangle.chain_complex()?.euler_characteristic(), 1);
    /// # Ok(()) }
    /// ```
    pub fn euler_characteristic(&self) -> i64 {
        self.cell_counts
            .iter()
            .enumerate()
            .map(|(k, &n)| if k % 2 == 0 { n as i64 } else { -(n as i64) })
            .sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_boundary_that_is_no_cycle_is_named() {
        let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)]).unwrap();
        let face = SparseMatrix::from_entries(2, 1, [(0, 0, 1), (1, 0, 1)]).unwrap();
        let error = ChainComplex::new(vec![edges, face]).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::BoundaryOfBoundary);
        assert!(error.message().contains("cell 0 of degree 2"));
        assert_eq!(error.fault(), Some(&Fault::BoundaryNotCycle { degree: 2, cell: CellId::new(0) }));
    }

    #[test]
    fn faults_carry_their_cells_and_numbers() {
        let edge = SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)]).unwrap();
        let product = edge.product(&edge).unwrap_err();
        assert_eq!(product.fault(), Some(&Fault::Shape { found: [2, 1], expected: [Some(1), None] }));
        let faces = SparseMatrix::identity(3).unwrap();
        let misfit = ChainComplex::new(vec![edge.clone(), faces]).unwrap_err();
        assert_eq!(misfit.fault(), Some(&Fault::Shape { found: [3, 3], expected: [Some(1), None] }));
        let complex = ChainComplex::new(vec![edge]).unwrap();
        let (end, whole) = (CellId::new(1), CellId::new(0));
        let open = complex.subcomplex(&[vec![whole], vec![whole]]).unwrap_err();
        assert_eq!(open.fault(), Some(&Fault::MissingFace { degree: 1, cell: whole, face: end }));
        let absent = complex.subcomplex(&[vec![CellId::new(7)]]).unwrap_err();
        assert_eq!(absent.fault(), Some(&Fault::OutOfRange { index: 7, count: 2 }));
    }
}
