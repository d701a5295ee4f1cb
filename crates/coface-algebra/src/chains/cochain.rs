//! Cochains: functions on cells, and their coboundaries.

use super::combination::{Combination, combination};
use super::{Chain, ChainComplex, Coefficient};
use crate::{CellId, Error};

/// A cochain: a linear function on the chains of one degree, given by its values on cells.
///
/// # Examples
/// On a path of two edges the heights of three vertices are a 0-cochain w; the coboundary says how much each edge
/// climbs, and $(\delta w)(c) = w(\partial c)$.
/// ```
/// use coface_algebra::CellId;
/// use coface_algebra::{Integer, SparseMatrix};
/// use coface_algebra::chains::{Chain, ChainComplex, Cochain};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let boundary = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
/// let path = ChainComplex::new(vec![boundary])?;
/// let heights = [(0, 10), (1, 13), (2, 12)].map(|(vertex, z)| (CellId::new(vertex), Integer::from(z)));
/// let climb = path.coboundary(&Cochain::new(&path, 0, heights)?)?;
/// assert_eq!(climb.to_string(), "3 c0 - c1");
/// let both = Chain::new(&path, 1, [0, 1].map(|edge| (CellId::new(edge), Integer::ONE)))?;
/// assert_eq!(climb.pairing(&both)?, Some(Integer::from(2)));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Cochain<C>(Combination<C>);

combination!(Cochain, "cochain");

impl<C: Coefficient> Cochain<C> {
    /// The value of the cochain on a chain: the sum over cells of value times coefficient; `None` stands for zero.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`](crate::ErrorKind::Shape) if the degrees differ,
    /// [`ErrorKind::Coefficient`](crate::ErrorKind::Coefficient) if the rings do.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{Chain, ChainComplex, Cochain};
    /// use coface_algebra::{CellId, Integer};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(2);
    /// let terms = |values: [i64; 2]| [0, 1].map(|i| (CellId::new(i), Integer::from(values[i])));
    /// let cochain = Cochain::new(&points, 0, terms([2, 3]))?;
    /// assert_eq!(cochain.pairing(&Chain::new(&points, 0, terms([10, 1]))?)?, Some(23.into()));
    /// # Ok(()) }
    /// ```
    pub fn pairing(&self, chain: &Chain<C>) -> Result<Option<C>, Error> {
        self.0.inner_product(&chain.0)
    }
}

impl ChainComplex {
    /// The coboundary of a cochain, one degree above: $(\delta w)(c) = w(\partial c)$.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`](crate::ErrorKind::NotInComplex) if the cochain has a cell that is not here.
    ///
    /// # Complexity
    /// Linear in the boundary matrix of the degree above.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{Cochain, TwoSkeleton};
    /// use coface_algebra::{CellId, Integer, RaggedArray};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = TwoSkeleton::new(2, vec![0, 1], RaggedArray::new())?.chain_complex()?;
    /// let end = Cochain::new(&edge, 0, [(CellId::new(1), Integer::ONE)])?;
    /// assert_eq!(edge.coboundary(&end)?.to_string(), "c0");
    /// # Ok(()) }
    /// ```
    pub fn coboundary<C: Coefficient>(&self, cochain: &Cochain<C>) -> Result<Cochain<C>, Error> {
        cochain.0.check(self)?;
        let degree = cochain.degree() + 1;
        let mut terms = Vec::new();
        if let Some(matrix) = self.boundary_matrix(degree)
            && !cochain.is_zero()
        {
            let mut value_of: Vec<Option<&C>> = vec![None; matrix.row_count()];
            for (cell, value) in cochain.terms() {
                value_of[cell.index()] = Some(value);
            }
            for (j, column) in matrix.columns().enumerate() {
                let values =
                    column.iter().filter_map(|(row, entry)| Some(value_of[row]?.times_integer(entry)));
                terms.extend(values.map(|value| (CellId::new(j), value)));
            }
        }
        Combination::from_terms(degree, terms).map(Cochain)
    }

    /// Whether the coboundary of a cochain is zero: whether it vanishes on all boundaries.
    ///
    /// # Errors
    /// As [`Self::coboundary`].
    ///
    /// # Examples
    /// A function on vertices is closed if it is constant on each component:
    /// ```
    /// use coface_algebra::chains::{Cochain, TwoSkeleton};
    /// use coface_algebra::{CellId, Integer, RaggedArray};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = TwoSkeleton::new(2, vec![0, 1], RaggedArray::new())?.chain_complex()?;
    /// let constant = [0, 1].map(|vertex| (CellId::new(vertex), Integer::from(7)));
    /// assert!(edge.is_closed(&Cochain::new(&edge, 0, constant)?)?);
    /// # Ok(()) }
    /// ```
    pub fn is_closed<C: Coefficient>(&self, cochain: &Cochain<C>) -> Result<bool, Error> {
        Ok(self.coboundary(cochain)?.is_zero())
    }
}

#[cfg(test)]
mod tests {
    use super::super::chain::tests::{complexes_with_chain, disk_of_four_triangles};
    use super::*;
    use crate::ErrorKind;
    use crate::integers::{Integer, Residue};
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn the_coboundary_is_dual_to_the_boundary(
            (complex, chain) in complexes_with_chain(),
            values in prop::collection::vec(-9i64..9, 80),
        ) {
            // Stokes: the coboundary of w on c is w on the boundary of c.
            let Some(below) = chain.degree().checked_sub(1) else { return Ok(()) };
            let terms = values.iter().take(complex.cell_count(below)).enumerate();
            let terms = terms.map(|(cell, &value)| (CellId::new(cell), Integer::from(value)));
            let cochain = Cochain::new(&complex, below, terms).unwrap();
            let coboundary = complex.coboundary(&cochain).unwrap();
            prop_assert_eq!(coboundary.degree(), chain.degree());
            prop_assert_eq!(
                coboundary.pairing(&chain).unwrap(),
                cochain.pairing(&complex.boundary(&chain).unwrap()).unwrap()
            );
            prop_assert!(complex.is_closed(&coboundary).unwrap());
            // And the same modulo 4.
            let modulo = |terms: &[(CellId, Integer)]| {
                let terms = terms.iter();
                terms.map(|(cell, value)| (*cell, Residue::from_integer(value, 4).unwrap())).collect::<Vec<_>>()
            };
            let chain = Chain::new(&complex, chain.degree(), modulo(chain.terms())).unwrap();
            let cochain = Cochain::new(&complex, below, modulo(cochain.terms())).unwrap();
            prop_assert_eq!(
                complex.coboundary(&cochain).unwrap().pairing(&chain).unwrap(),
                cochain.pairing(&complex.boundary(&chain).unwrap()).unwrap()
            );
        }
    }

    #[test]
    fn constants_are_closed_and_a_single_vertex_is_not() {
        let disk = disk_of_four_triangles();
        let constant = Cochain::new(&disk, 0, (0..6).map(|v| (CellId::new(v), 1.5))).unwrap();
        assert!(disk.is_closed(&constant).unwrap());
        // The edges at the third vertex: edge 2 starts there, edge 3 ends there.
        let vertex = Cochain::new(&disk, 0, [(CellId::new(2), Integer::ONE)]).unwrap();
        let coboundary = disk.coboundary(&vertex).unwrap();
        assert_eq!(coboundary.to_string(), "-c1 + c2");
        assert!(!disk.is_closed(&vertex).unwrap() && disk.is_closed(&coboundary).unwrap());
        // Above the dimension there is nothing, and every cochain of top degree is closed.
        let face = Cochain::new(&disk, 2, [(CellId::new(0), Integer::ONE)]).unwrap();
        assert_eq!(disk.coboundary(&face).unwrap(), Cochain::zero(3));
        let chain = Chain::new(&disk, 1, [(CellId::new(0), Integer::ONE)]).unwrap();
        assert_eq!(face.pairing(&chain).unwrap_err().kind(), ErrorKind::Shape);
    }
}
