//! Generators, cocycles and classes: what a basis of homology is asked for.

use coface_algebra::Integer;
use coface_algebra::chains::{Chain, Cochain};

/// A cycle whose class generates a cyclic summand of homology.
///
/// # Examples
/// See [`generators`](crate::homology::generators).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Generator {
    pub(super) order: Option<Integer>,
    pub(super) chain: Chain<Integer>,
}

impl Generator {
    /// The order of its class: `None` when no multiple bounds. Over a field or Z/n, `None` when the summand is the
    /// whole ring.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::HomologyBasis;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// assert_eq!(basis.generators(1)[0].order(), Some(&2.into()));
    /// assert_eq!(basis.generators(0)[0].order(), None);
    /// # Ok(()) }
    /// ```
    pub fn order(&self) -> Option<&Integer> {
        self.order.as_ref()
    }

    /// The cycle, on the cells of the complex. Over Z/n its coefficients are read modulo n.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::HomologyBasis;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// assert_eq!(basis.generators(1)[0].chain().to_string(), "c0");
    /// # Ok(()) }
    /// ```
    pub fn chain(&self) -> &Chain<Integer> {
        &self.chain
    }

    /// The sum of the absolute values of the coefficients: the number of cells, counted as often as the cycle runs
    /// through them.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::HomologyBasis;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// assert_eq!(basis.generators(1)[0].length(), 1.into());
    /// # Ok(()) }
    /// ```
    pub fn length(&self) -> Integer {
        let mut length = Integer::ZERO;
        for (_, coefficient) in self.chain.terms() {
            length += &coefficient.abs();
        }
        length
    }
}

/// A closed cochain whose class generates a cyclic summand of cohomology.
///
/// # Examples
/// See [`HomologyBasis::cocycles`](crate::homology::basis::HomologyBasis::cocycles).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Cocycle {
    pub(super) order: Option<Integer>,
    pub(super) cochain: Cochain<Integer>,
}

impl Cocycle {
    /// The order of its class: `None` when no multiple is a coboundary. Over a field or Z/n, `None` when the summand is
    /// the whole ring.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::HomologyBasis;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// assert_eq!(basis.cocycles(2)[0].order(), Some(&2.into()));
    /// # Ok(()) }
    /// ```
    pub fn order(&self) -> Option<&Integer> {
        self.order.as_ref()
    }

    /// The cochain, on the cells of the complex. Over Z/n its values are read modulo n.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::HomologyBasis;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// assert_eq!(basis.cocycles(2)[0].cochain().to_string(), "c0");
    /// # Ok(()) }
    /// ```
    pub fn cochain(&self) -> &Cochain<Integer> {
        &self.cochain
    }
}

/// The class of a cycle: its coefficients on the generators of its degree.
///
/// # Examples
/// See [`HomologyBasis::class_of`](crate::homology::basis::HomologyBasis::class_of).
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct HomologyClass {
    pub(super) coefficients: Vec<Integer>,
    pub(super) orders: Vec<Option<Integer>>,
}

impl HomologyClass {
    /// The coefficient of each generator, in their order: from 0 to m - 1 for a generator of finite order m, any
    /// integer for a free one.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, Integer, SparseMatrix};
    /// use coface_algebra::chains::{Chain, ChainComplex};
    /// use coface_topology::HomologyBasis;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// let three = Chain::new(&plane, 1, [(CellId::new(0), Integer::from(3))])?;
    /// assert_eq!(basis.class_of(&three)?.coefficients(), [1.into()]);
    /// # Ok(()) }
    /// ```
    pub fn coefficients(&self) -> &[Integer] {
        &self.coefficients
    }

    /// Whether the class is zero: whether the cycle bounds.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, Integer, SparseMatrix};
    /// use coface_algebra::chains::{Chain, ChainComplex};
    /// use coface_topology::HomologyBasis;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// let twice = Chain::new(&plane, 1, [(CellId::new(0), Integer::from(2))])?;
    /// assert!(basis.class_of(&twice)?.is_zero());
    /// # Ok(()) }
    /// ```
    pub fn is_zero(&self) -> bool {
        self.coefficients.iter().all(Integer::is_zero)
    }

    /// The least positive number whose product with the class is zero; `None` if there is none.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, Integer, SparseMatrix};
    /// use coface_algebra::chains::{Chain, ChainComplex};
    /// use coface_topology::HomologyBasis;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// let once = Chain::new(&plane, 1, [(CellId::new(0), Integer::from(1))])?;
    /// assert_eq!(basis.class_of(&once)?.order(), Some(2.into()));
    /// # Ok(()) }
    /// ```
    pub fn order(&self) -> Option<Integer> {
        let mut multiple = Integer::ONE;
        for (coefficient, order) in self.coefficients.iter().zip(&self.orders) {
            match order {
                _ if coefficient.is_zero() => {}
                None => return None,
                Some(order) => {
                    let own = order.exact_quotient(&order.gcd(coefficient)).expect("a gcd divides");
                    let gcd = multiple.gcd(&own);
                    multiple *= &own.exact_quotient(&gcd).expect("a gcd divides");
                }
            }
        }
        Some(multiple)
    }
}

/// Whether a cycle bounds, with the proof.
///
/// # Examples
/// See [`HomologyBasis::bounding`](crate::homology::basis::HomologyBasis::bounding).
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Bounding {
    /// It does: it is the boundary of this chain.
    Bounds(Chain<Integer>),
    /// It does not, but a multiple does.
    MultipleBounds {
        /// The least positive multiple that bounds, at least 2.
        multiple: Integer,
        /// The chain whose boundary is that multiple.
        chain: Chain<Integer>,
    },
    /// No multiple bounds.
    Never {
        /// A closed cochain, which vanishes on all boundaries.
        cocycle: Cochain<Integer>,
        /// Its value on the cycle, not zero.
        value: Integer,
    },
}
