//! Chain maps: linear maps between chain complexes that commute with boundaries.

use super::{Chain, ChainComplex, Coefficient};
use crate::matrices::SparseMatrix;
use crate::{CellId, Error, ErrorKind, Fault};

/// A chain map: in each degree k an integer matrix $f_k$ from the k-chains of a source to those of a target, with
/// $\partial f_k = f_{k-1} \partial$. Column j of the matrix of degree k is the image of the k-cell j of the source.
///
/// # References
/// J. R. Munkres, *Elements of Algebraic Topology* (1984), section 13.
///
/// # Examples
/// A circle of two edges runs twice around a circle of one edge:
/// ```
/// use coface_algebra::chains::{ChainMap, TwoSkeleton};
/// use coface_algebra::{RaggedArray, SparseMatrix};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let two = TwoSkeleton::new(2, vec![0, 1, 1, 0], RaggedArray::new())?.chain_complex()?;
/// let one = TwoSkeleton::new(1, vec![0, 0], RaggedArray::new())?.chain_complex()?;
/// let both = SparseMatrix::from_entries(1, 2, [(0, 0, 1), (0, 1, 1)])?;
/// let twice = ChainMap::new(&two, &one, vec![both.clone(), both])?;
/// // The cycle of both edges goes to two times the loop.
/// assert_eq!(twice.matrix(1).expect("there are edges").times_vector(&[1.into(), 1.into()])?, [2.into()]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChainMap {
    /// The matrix of degree k at position k.
    matrices: Vec<SparseMatrix>,
}

impl ChainMap {
    /// The map with these matrices, of degrees 0, 1, ... of the source.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there is a matrix for each degree of the source, with as many columns as the source
    /// has cells and as many rows as the target has; [`ErrorKind::InvalidInput`] naming a cell where the map does not
    /// commute with the boundary.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::{ChainComplex, ChainMap};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let (source, target) = (ChainComplex::of_points(1), ChainComplex::of_points(2));
    /// let second = SparseMatrix::from_entries(2, 1, [(1, 0, 1)])?;
    /// assert!(ChainMap::new(&source, &target, vec![second.clone()]).is_ok());
    /// assert!(ChainMap::new(&target, &source, vec![second]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn new(
        source: &ChainComplex,
        target: &ChainComplex,
        matrices: Vec<SparseMatrix>,
    ) -> Result<Self, Error> {
        if matrices.len() != source.degree_count() {
            let message = format!("{} matrices for {} degrees", matrices.len(), source.degree_count());
            return Err(Error::new(ErrorKind::Shape, message)
                .with_fault(Fault::Length { found: matrices.len(), expected: source.degree_count() })
                .with_cure("give a matrix for each degree of the source"));
        }
        for (degree, matrix) in matrices.iter().enumerate() {
            let expected = (target.cell_count(degree), source.cell_count(degree));
            if (matrix.row_count(), matrix.column_count()) != expected {
                return Err(Error::new(
                    ErrorKind::Shape,
                    format!(
                        "the matrix of degree {degree} is {} by {}, not {} by {}",
                        matrix.row_count(),
                        matrix.column_count(),
                        expected.0,
                        expected.1
                    ),
                )
                .with_fault(Fault::Shape {
                    found: [matrix.row_count(), matrix.column_count()],
                    expected: [Some(expected.0), Some(expected.1)],
                }));
            }
            let Some(own) = source.boundary_matrix(degree) else { continue };
            let around = matrices[degree - 1].product(own)?.into_wide();
            let difference = match target.boundary_matrix(degree) {
                Some(boundary) => boundary.product(matrix)?.into_wide().difference(&around)?.into_wide(),
                None => around,
            };
            if let Some(cell) =
                (0..difference.column_count()).find(|&j| !difference.column(j).rows().is_empty())
            {
                return Err(Error::invalid(format!(
                    "the map does not commute with the boundary on cell {cell} of degree {degree}"
                ))
                .with_cure("the boundary of the image of a cell must be the image of its boundary"));
            }
        }
        Ok(Self { matrices })
    }

    /// The identity of a complex.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 32 bits.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::{ChainComplex, ChainMap};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let identity = ChainMap::identity(&ChainComplex::of_points(2))?;
    /// assert_eq!(identity.matrix(0), Some(&SparseMatrix::identity(2)?));
    /// # Ok(()) }
    /// ```
    pub fn identity(complex: &ChainComplex) -> Result<Self, Error> {
        let matrices = complex.f_vector().iter().map(|&count| SparseMatrix::identity(count));
        Ok(Self { matrices: matrices.collect::<Result<_, Error>>()? })
    }

    /// The inclusion of a subcomplex into a complex; `cells` are those that [`ChainComplex::subcomplex`] was given.
    ///
    /// # Errors
    /// Those of [`ChainComplex::subcomplex`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_algebra::chains::{ChainComplex, ChainMap};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(3);
    /// let inclusion = ChainMap::inclusion(&points, &[vec![CellId::new(2)]])?;
    /// assert_eq!(inclusion.matrix(0).expect("there is a point").column(0).rows(), [2]);
    /// # Ok(()) }
    /// ```
    pub fn inclusion(complex: &ChainComplex, cells: &[Vec<CellId>]) -> Result<Self, Error> {
        let part = complex.subcomplex(cells)?;
        let matrices = (0..part.degree_count()).map(|degree| {
            let columns: Vec<usize> =
                cells.get(degree).into_iter().flatten().map(|cell| cell.index()).collect();
            SparseMatrix::identity(complex.cell_count(degree))?.select_columns(&columns)
        });
        Self::new(&part, complex, matrices.collect::<Result<_, Error>>()?)
    }

    /// The projection of a complex onto the one relative to a subcomplex, as [`ChainComplex::relative`] makes it.
    ///
    /// # Errors
    /// Those of [`ChainComplex::relative`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_algebra::chains::{ChainComplex, ChainMap};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(2);
    /// // Point 0 goes to zero, point 1 to the only point that is left.
    /// let projection = ChainMap::projection(&points, &[vec![CellId::new(0)]])?;
    /// let matrix = projection.matrix(0).expect("there are points");
    /// assert_eq!((matrix.row_count(), matrix.entry(0, 0), matrix.entry(0, 1)), (1, 0, 1));
    /// # Ok(()) }
    /// ```
    pub fn projection(complex: &ChainComplex, cells: &[Vec<CellId>]) -> Result<Self, Error> {
        let relative = complex.relative(cells)?;
        let kept = complex.complement(cells)?;
        let matrices = (0..complex.degree_count()).map(|degree| {
            let rows: Vec<usize> = kept[degree].iter().map(|cell| cell.index()).collect();
            SparseMatrix::identity(complex.cell_count(degree))?.select_rows(&rows)
        });
        Self::new(complex, &relative, matrices.collect::<Result<_, Error>>()?)
    }

    /// The matrix of a degree: a row for each cell of the target, a column for each cell of the source. `None` beyond
    /// the degrees of the source.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, ChainMap};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let identity = ChainMap::identity(&ChainComplex::of_points(2))?;
    /// assert_eq!(identity.matrix(0).map(|matrix| matrix.entry_count()), Some(2));
    /// assert!(identity.matrix(1).is_none());
    /// # Ok(()) }
    /// ```
    pub fn matrix(&self, degree: usize) -> Option<&SparseMatrix> {
        self.matrices.get(degree)
    }

    /// This map, then another one.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] if the source of the other is not the target of this, [`ErrorKind::TooLarge`] for entries
    /// beyond 32 bits.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::{ChainComplex, ChainMap};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(2);
    /// let swap = SparseMatrix::from_entries(2, 2, [(0, 1, 1), (1, 0, 1)])?;
    /// let swap = ChainMap::new(&points, &points, vec![swap])?;
    /// assert_eq!(swap.then(&swap)?, ChainMap::identity(&points)?);
    /// # Ok(()) }
    /// ```
    pub fn then(&self, next: &Self) -> Result<Self, Error> {
        let matrices = self.matrices.iter().enumerate().map(|(degree, matrix)| match next.matrix(degree) {
            Some(other) => other.checked_product(matrix),
            None => SparseMatrix::zero(0, matrix.column_count()),
        });
        Ok(Self { matrices: matrices.collect::<Result<_, Error>>()? })
    }

    /// The image of a chain.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] if the chain has a cell that the source has not.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{Chain, ChainComplex, ChainMap};
    /// use coface_algebra::{CellId, Integer, SparseMatrix};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(2);
    /// let swap = SparseMatrix::from_entries(2, 2, [(0, 1, 1), (1, 0, 1)])?;
    /// let swap = ChainMap::new(&points, &points, vec![swap])?;
    /// let chain = Chain::new(&points, 0, [(CellId::new(0), Integer::from(5))])?;
    /// assert_eq!(swap.image(&chain)?.to_string(), "5 c1");
    /// # Ok(()) }
    /// ```
    pub fn image<C: Coefficient>(&self, chain: &Chain<C>) -> Result<Chain<C>, Error> {
        let degree = chain.degree();
        let Some(matrix) = self.matrix(degree).filter(|_| !chain.is_zero()) else {
            return Ok(Chain::zero(degree));
        };
        let mut terms = Vec::new();
        for (cell, coefficient) in chain.terms() {
            if cell.index() >= matrix.column_count() {
                let message = format!("there is no cell {cell} of degree {degree} in the source of the map");
                return Err(Error::new(ErrorKind::NotInComplex, message));
            }
            let column = matrix.column(cell.index());
            terms.extend(column.iter().map(|(row, x)| (CellId::new(row), coefficient.times_integer(x))));
        }
        super::combination::Combination::from_terms(degree, terms).map(Chain)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integers::Integer;
    use crate::samples::{closed_cells, random_complexes};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn inclusions_and_projections_are_chain_maps(
            complex in random_complexes(),
            sizes in prop::collection::vec(0usize..40, 4),
        ) {
            let cells = closed_cells(&complex, &sizes);
            let inclusion = ChainMap::inclusion(&complex, &cells).unwrap();
            let projection = ChainMap::projection(&complex, &cells).unwrap();
            let both = inclusion.then(&projection).unwrap();
            prop_assert!((0..complex.degree_count()).all(|degree| both.matrix(degree).is_none_or(SparseMatrix::is_zero)));
            let identity = ChainMap::identity(&complex).unwrap();
            prop_assert_eq!(&inclusion.then(&identity).unwrap(), &inclusion);
        }
    }

    #[test]
    fn maps_that_tear_are_refused() {
        let edge =
            ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)]).unwrap()])
                .unwrap();
        let flip = SparseMatrix::from_entries(2, 2, [(1, 0, 1), (0, 1, 1)]).unwrap();
        let same = SparseMatrix::identity(1).unwrap();
        let error = ChainMap::new(&edge, &edge, vec![flip.clone(), same.clone()]).unwrap_err();
        assert!(error.message().contains("cell 0 of degree 1"), "{error}");
        let flipped = ChainMap::new(&edge, &edge, vec![flip, same.negated()]).unwrap();
        let chain = Chain::new(&edge, 1, [(CellId::new(0), Integer::from(3))]).unwrap();
        assert_eq!(flipped.image(&chain).unwrap().to_string(), "-3 c0");
        assert_eq!(ChainMap::new(&edge, &edge, vec![same]).unwrap_err().kind(), ErrorKind::Shape);
    }
}
