//! Chains: combinations of cells, and their boundaries.

use super::combination::{Combination, combination, total};
use super::{ChainComplex, Coefficient};
use crate::{CellId, Error};

/// A chain: a linear combination of cells of one degree.
///
/// # Examples
/// The rim of a triangle with the edges 01, 12 and 02: the last one runs against the others.
/// ```
/// use coface_algebra::CellId;
/// use coface_algebra::{Integer, SparseMatrix};
/// use coface_algebra::chains::{Chain, ChainComplex};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let boundary =
///     SparseMatrix::from_entries(3, 3, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)])?;
/// let circle = ChainComplex::new(vec![boundary])?;
/// let path = Chain::new(&circle, 1, [0, 1].map(|edge| (CellId::new(edge), Integer::ONE)))?;
/// assert_eq!(circle.boundary(&path)?.to_string(), "-c0 + c2");
/// let last = Chain::new(&circle, 1, [(CellId::new(2), Integer::ONE)])?;
/// assert!(circle.is_cycle(&path.minus(&last)?)?);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Chain<C>(pub(super) Combination<C>);

combination!(Chain, "chain");

impl ChainComplex {
    /// The boundary of a chain, one degree below.
    ///
    /// Below degree 0 all groups are zero: the boundary of a 0-chain is the zero chain, given as one of degree 0.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`](crate::ErrorKind::NotInComplex) if the chain has a cell that is not here.
    ///
    /// # Complexity
    /// $O(m \log m)$ for m entries in the boundaries of its cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{Chain, TwoSkeleton};
    /// use coface_algebra::{CellId, Integer, RaggedArray};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = TwoSkeleton::new(2, vec![0, 1], RaggedArray::new())?.chain_complex()?;
    /// let chain = Chain::new(&edge, 1, [(CellId::new(0), Integer::from(3))])?;
    /// assert_eq!(edge.boundary(&chain)?.to_string(), "-3 c0 + 3 c1");
    /// # Ok(()) }
    /// ```
    pub fn boundary<C: Coefficient>(&self, chain: &Chain<C>) -> Result<Chain<C>, Error> {
        chain.0.check(self)?;
        let degree = chain.degree();
        let mut terms = Vec::new();
        if let Some(matrix) = self.boundary_matrix(degree) {
            for (cell, coefficient) in chain.terms() {
                let column = matrix.column(cell.index());
                terms.extend(
                    column.iter().map(|(row, entry)| (CellId::new(row), coefficient.times_integer(entry))),
                );
            }
        }
        Combination::from_terms(degree.saturating_sub(1), terms).map(Chain)
    }

    /// Whether the boundary of a chain is zero. Every 0-chain is a cycle.
    ///
    /// # Errors
    /// As [`Self::boundary`].
    ///
    /// # Examples
    /// The edges from 0 to 1 and from 1 back to 0 are a cycle:
    /// ```
    /// use coface_algebra::chains::{Chain, TwoSkeleton};
    /// use coface_algebra::{CellId, Integer, RaggedArray};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = TwoSkeleton::new(2, vec![0, 1, 1, 0], RaggedArray::new())?.chain_complex()?;
    /// let [first, second] = [0, 1].map(|edge| (CellId::new(edge), Integer::ONE));
    /// assert!(circle.is_cycle(&Chain::new(&circle, 1, [first.clone(), second])?)?);
    /// assert!(!circle.is_cycle(&Chain::new(&circle, 1, [first])?)?);
    /// # Ok(()) }
    /// ```
    pub fn is_cycle<C: Coefficient>(&self, chain: &Chain<C>) -> Result<bool, Error> {
        Ok(self.boundary(chain)?.is_zero())
    }

    /// The augmentation of a 0-chain: the sum of its coefficients; `None` stands for zero.
    ///
    /// It vanishes on boundaries where each edge has one end of each sign; see [`Self::augmented`].
    ///
    /// # Errors
    /// [`ErrorKind::Shape`](crate::ErrorKind::Shape) for a chain of another degree,
    /// [`ErrorKind::NotInComplex`](crate::ErrorKind::NotInComplex) if it has a cell that is not here.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_algebra::Integer;
    /// use coface_algebra::chains::{Chain, ChainComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(2);
    /// let chain = Chain::new(&points, 0, [(CellId::new(0), Integer::from(5)), (CellId::new(1), Integer::from(-3))])?;
    /// assert_eq!(points.augmentation(&chain)?, Some(Integer::from(2)));
    /// # Ok(()) }
    /// ```
    pub fn augmentation<C: Coefficient>(&self, chain: &Chain<C>) -> Result<Option<C>, Error> {
        chain.0.check(self)?;
        chain.0.check_degree(0)?;
        total(chain.terms().iter().map(|(_, coefficient)| coefficient.clone()))
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use crate::integers::{Integer, Rational, Residue};
    use crate::matrices::SparseMatrix;
    use crate::samples::random_complexes;
    use crate::{CellId, ErrorKind};
    use proptest::prelude::*;

    /// The disk of four triangles in the first figure of the third source text: nine edges, each with the direction
    /// of its first halfedge; vertices, edges and faces are counted from 0 here and from 1 there.
    pub(crate) fn disk_of_four_triangles() -> ChainComplex {
        let ends = [(2, 1), (3, 2), (4, 3), (5, 4), (6, 5), (1, 6), (2, 6), (4, 2), (6, 4)];
        let edges = ends
            .iter()
            .enumerate()
            .flat_map(|(e, &(source, target))| [(source - 1, e, -1), (target - 1, e, 1)]);
        // Halfedges 10, 11 and 12 are 7, 8 and 9 backwards.
        let faces = [[1, 6, 10], [2, 11, 3], [4, 12, 5], [8, 7, 9]];
        let sides = faces.iter().enumerate().flat_map(|(f, halfedges)| {
            halfedges.iter().map(move |&h| if h > 9 { (h - 4, f, -1) } else { (h - 1, f, 1) })
        });
        ChainComplex::new(vec![
            SparseMatrix::from_entries(6, 9, edges).unwrap(),
            SparseMatrix::from_entries(9, 4, sides).unwrap(),
        ])
        .unwrap()
    }

    fn integer_chain(complex: &ChainComplex, degree: usize, terms: &[(usize, i64)]) -> Chain<Integer> {
        let terms = terms.iter().map(|&(cell, coefficient)| (CellId::new(cell), Integer::from(coefficient)));
        Chain::new(complex, degree, terms).unwrap()
    }

    #[test]
    fn the_disk_of_four_triangles_has_the_boundaries_of_the_text() {
        let disk = disk_of_four_triangles();
        assert_eq!((disk.f_vector(), disk.euler_characteristic()), (&[6, 9, 4][..], 1));
        // d f2 = h2 + h11 + h3, d h1 = v1 - v2.
        let second = integer_chain(&disk, 2, &[(1, 1)]);
        let rim = disk.boundary(&second).unwrap();
        assert_eq!(rim, integer_chain(&disk, 1, &[(1, 1), (7, -1), (2, 1)]));
        assert_eq!(rim.to_string(), "c1 + c2 - c7");
        assert!(disk.is_cycle(&rim).unwrap() && !disk.is_cycle(&second).unwrap());
        let edge = integer_chain(&disk, 1, &[(0, 1)]);
        assert_eq!(disk.boundary(&edge).unwrap(), integer_chain(&disk, 0, &[(0, 1), (1, -1)]));
        // The boundary of all faces is h1 + ... + h6.
        let all = integer_chain(&disk, 2, &[(0, 1), (1, 1), (2, 1), (3, 1)]);
        let around: Vec<(usize, i64)> = (0..6).map(|edge| (edge, 1)).collect();
        assert_eq!(disk.boundary(&all).unwrap(), integer_chain(&disk, 1, &around));
    }

    /// A chain in each degree of a random complex.
    pub(crate) fn complexes_with_chain() -> impl Strategy<Value = (ChainComplex, Chain<Integer>)> {
        (random_complexes(), 0usize..4, prop::collection::vec((any::<u32>(), -5i64..5), 0..8)).prop_map(
            |(complex, degree, terms)| {
                let count = complex.cell_count(degree);
                let terms = terms.into_iter().filter(|_| count > 0);
                let terms =
                    terms.map(|(cell, value)| (CellId::new(cell as usize % count), Integer::from(value)));
                let chain = Chain::new(&complex, degree, terms.collect::<Vec<_>>()).unwrap();
                (complex, chain)
            },
        )
    }

    proptest! {
        #[test]
        fn boundary_of_boundary_is_zero((complex, chain) in complexes_with_chain()) {
            prop_assert!(complex.is_cycle(&complex.boundary(&chain).unwrap()).unwrap());
        }

        #[test]
        fn the_boundary_is_linear((complex, chain) in complexes_with_chain(), factor in -4i64..4) {
            let factor = Integer::from(factor);
            let boundary = complex.boundary(&chain).unwrap();
            prop_assert_eq!(complex.boundary(&chain.scaled(&factor).unwrap()).unwrap(), boundary.scaled(&factor).unwrap());
            prop_assert_eq!(complex.boundary(&chain.negated()).unwrap(), boundary.negated());
            prop_assert!(chain.minus(&chain).unwrap().is_zero());
            // The second method: the matrix applied to the coefficients.
            let coefficients: Vec<Integer> = (0..complex.cell_count(chain.degree()))
                .map(|cell| chain.coefficient(CellId::new(cell)).cloned().unwrap_or_default())
                .collect();
            if let Some(matrix) = complex.boundary_matrix(chain.degree()) {
                for (cell, value) in matrix.times_vector(&coefficients).unwrap().into_iter().enumerate() {
                    prop_assert_eq!(boundary.coefficient(CellId::new(cell)).cloned().unwrap_or_default(), value);
                }
            }
        }
    }

    #[test]
    fn coefficients_are_those_of_the_ring() {
        // One vertex, one loop, one disk that runs twice along it.
        let plane = ChainComplex::new(vec![
            SparseMatrix::zero(1, 1).unwrap(),
            SparseMatrix::from_entries(1, 1, [(0, 0, 2)]).unwrap(),
        ])
        .unwrap();
        let cell = CellId::new(0);
        assert!(!plane.is_cycle(&Chain::new(&plane, 2, [(cell, Integer::ONE)]).unwrap()).unwrap());
        assert!(!plane.is_cycle(&Chain::new(&plane, 2, [(cell, Rational::ONE)]).unwrap()).unwrap());
        assert!(!plane.is_cycle(&Chain::new(&plane, 2, [(cell, 0.5)]).unwrap()).unwrap());
        let modulo =
            |value, modulus| Chain::new(&plane, 2, [(cell, Residue::new(value, modulus).unwrap())]).unwrap();
        assert!(plane.is_cycle(&modulo(1, 2)).unwrap());
        assert_eq!(plane.boundary(&modulo(2, 5)).unwrap().to_string(), "(4 mod 5) c0");
        // 2 times 3 is zero modulo 6.
        assert!(modulo(2, 6).scaled(&Residue::new(3, 6).unwrap()).unwrap().is_zero());
        assert_eq!(modulo(1, 2).plus(&modulo(1, 3)).unwrap_err().kind(), ErrorKind::Coefficient);
    }

    #[test]
    fn faults_are_named() {
        let disk = disk_of_four_triangles();
        let error = Chain::new(&disk, 2, [(CellId::new(4), Integer::ONE)]).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::NotInComplex);
        assert_eq!(error.message(), "there is no cell c4 of degree 2: there are 4 such cells");
        assert!(Chain::new(&disk, 9, [(CellId::new(0), Integer::ONE)]).is_err());
        assert!(Chain::new(&disk, 2, [(CellId::new(4), Integer::ZERO)]).is_err());
        assert!(Chain::new(&disk, 0, [(CellId::new(0), f64::NAN)]).is_err());
        let (edge, face) = (integer_chain(&disk, 1, &[(8, 1)]), integer_chain(&disk, 2, &[(0, 1)]));
        assert_eq!(edge.plus(&face).unwrap_err().kind(), ErrorKind::Shape);
        assert_eq!(disk.augmentation(&edge).unwrap_err().kind(), ErrorKind::Shape);
        // A chain of one complex is checked when another one takes it.
        assert_eq!(ChainComplex::of_points(1).boundary(&edge).unwrap_err().kind(), ErrorKind::NotInComplex);
    }

    #[test]
    fn terms_of_one_cell_are_added() {
        let points = ChainComplex::of_points(3);
        let chain = integer_chain(&points, 0, &[(2, 1), (0, 3), (2, -1), (1, 0), (0, -5)]);
        assert_eq!(chain.to_string(), "-2 c0");
        assert_eq!(chain.support().collect::<Vec<_>>(), [CellId::new(0)]);
        assert_eq!(points.augmentation(&chain).unwrap(), Some(Integer::from(-2)));
        assert_eq!(points.augmentation(&Chain::<Integer>::zero(0)).unwrap(), None);
        assert_eq!(Chain::<Integer>::zero(3).to_string(), "0");
    }
}
