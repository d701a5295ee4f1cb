//! Selections: chains with the coefficients -1, 0 and 1 only.

use super::{Chain, ChainComplex, Coefficient};
use crate::Sign;
use crate::integers::Integer;
use crate::{CellId, Error, ErrorKind};
use std::fmt;

/// Cells of one degree, each chosen once with a sign: a chain over {-1, 0, 1}.
///
/// These three numbers are no group under addition of integers, since 1 + 1 is not among them. So a sum that would
/// choose a cell twice is refused, and the boundary is a chain of integers. With 1 + 1 = -1 they would be Z/3: take a
/// [`Chain`] of [`Residue`](crate::integers::Residue)s for that.
///
/// # Examples
/// The path 0 1 2 and the way back from 2 to 1 on a rim of three edges:
/// ```
/// use coface_algebra::CellId;
/// use coface_algebra::{Sign, SparseMatrix};
/// use coface_algebra::chains::{ChainComplex, Selection};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let boundary =
///     SparseMatrix::from_entries(3, 3, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)])?;
/// let circle = ChainComplex::new(vec![boundary])?;
/// let path = Selection::new(&circle, 1, [0, 1].map(|edge| (CellId::new(edge), Sign::Plus)))?;
/// assert_eq!(path.boundary(&circle)?.to_string(), "-c0 + c2");
/// let back = Selection::new(&circle, 1, [(CellId::new(1), Sign::Minus)])?;
/// assert_eq!(path.plus(&back)?.to_string(), "c0");
/// assert!(path.plus(&path).is_err());
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Selection {
    degree: usize,
    /// The chosen cells, rising.
    terms: Vec<(CellId, Sign)>,
}

impl Selection {
    /// The selection of these cells, in any order.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] for a cell that the complex does not have; [`ErrorKind::InvalidInput`] for one that
    /// is chosen twice.
    ///
    /// # Complexity
    /// $O(m \log m)$ for m cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, Selection};
    /// use coface_algebra::{CellId, Sign};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(3);
    /// let selection = Selection::new(&points, 0, [(CellId::new(2), Sign::Minus), (CellId::new(0), Sign::Plus)])?;
    /// assert_eq!(selection.to_string(), "c0 - c2");
    /// # Ok(()) }
    /// ```
    pub fn new(
        complex: &ChainComplex,
        degree: usize,
        terms: impl IntoIterator<Item = (CellId, Sign)>,
    ) -> Result<Self, Error> {
        let mut terms: Vec<(CellId, Sign)> = terms.into_iter().collect();
        terms.sort_unstable();
        if let Some(pair) = terms.windows(2).find(|pair| pair[0].0 == pair[1].0) {
            return Err(Error::invalid(format!("cell {} of degree {degree} is chosen twice", pair[0].0)));
        }
        let count = complex.cell_count(degree);
        match terms.last() {
            Some((cell, _)) if cell.index() >= count => Err(Error::new(
                ErrorKind::NotInComplex,
                format!("there is no cell {cell} of degree {degree}: there are {count} such cells"),
            )),
            _ => Ok(Self { degree, terms }),
        }
    }

    /// The selection of no cell.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_algebra::chains::Selection::zero(1).to_string(), "0");
    /// ```
    pub fn zero(degree: usize) -> Self {
        Self { degree, terms: Vec::new() }
    }

    /// The degree of the cells.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_algebra::chains::Selection::zero(1).degree(), 1);
    /// ```
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The chosen cells with their signs, rising.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, Selection};
    /// use coface_algebra::{CellId, Sign};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let term = (CellId::new(1), Sign::Minus);
    /// assert_eq!(Selection::new(&ChainComplex::of_points(2), 0, [term])?.terms(), [term]);
    /// # Ok(()) }
    /// ```
    pub fn terms(&self) -> &[(CellId, Sign)] {
        &self.terms
    }

    /// The sign of a cell; `None` for one that is not chosen.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, Selection};
    /// use coface_algebra::{CellId, Sign};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let selection = Selection::new(&ChainComplex::of_points(2), 0, [(CellId::new(1), Sign::Minus)])?;
    /// assert_eq!(selection.sign(CellId::new(1)), Some(Sign::Minus));
    /// assert_eq!(selection.sign(CellId::new(0)), None);
    /// # Ok(()) }
    /// ```
    pub fn sign(&self, cell: CellId) -> Option<Sign> {
        let at = self.terms.binary_search_by_key(&cell, |term| term.0).ok()?;
        Some(self.terms[at].1)
    }

    /// Whether no cell is chosen.
    ///
    /// # Examples
    /// ```
    /// assert!(coface_algebra::chains::Selection::zero(1).is_zero());
    /// ```
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    /// The same cells with the opposite signs.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, Selection};
    /// use coface_algebra::{CellId, Sign};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let selection = Selection::new(&ChainComplex::of_points(1), 0, [(CellId::new(0), Sign::Minus)])?;
    /// assert_eq!(selection.negated().to_string(), "c0");
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn negated(&self) -> Self {
        let terms = self.terms.iter().map(|&(cell, sign)| (cell, sign.opposite())).collect();
        Self { degree: self.degree, terms }
    }

    /// The sum: cells chosen with opposite signs cancel.
    ///
    /// # Errors
    /// [`ErrorKind::Coefficient`] naming the first cell that both choose with the same sign; [`ErrorKind::Shape`] if
    /// the degrees differ.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, Selection};
    /// use coface_algebra::{CellId, Sign};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(2);
    /// let one = |cell: usize, sign: Sign| Selection::new(&points, 0, [(CellId::new(cell), sign)]);
    /// assert_eq!(one(0, Sign::Plus)?.plus(&one(1, Sign::Minus)?)?.to_string(), "c0 - c1");
    /// assert!(one(0, Sign::Plus)?.plus(&one(0, Sign::Minus)?)?.is_zero());
    /// # Ok(()) }
    /// ```
    pub fn plus(&self, other: &Self) -> Result<Self, Error> {
        if self.degree != other.degree {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("the degrees {} and {} do not fit together", self.degree, other.degree),
            ));
        }
        let mut terms = Vec::with_capacity(self.terms.len() + other.terms.len());
        let (mut left, mut right) = (self.terms.iter().peekable(), other.terms.iter().peekable());
        while let (Some(&&(a, sign)), Some(&&(b, other_sign))) = (left.peek(), right.peek()) {
            if a == b && sign == other_sign {
                return Err(Error::new(
                    ErrorKind::Coefficient,
                    format!("cell {a} would be chosen twice: {sign}1 {sign} 1 is none of -1, 0, 1"),
                )
                .with_cure("add chains of integers, made by Selection::to_chain"));
            }
            if a < b {
                terms.push((a, sign));
            } else if b < a {
                terms.push((b, other_sign));
            }
            if a <= b {
                left.next();
            }
            if b <= a {
                right.next();
            }
        }
        terms.extend(left.chain(right));
        Ok(Self { degree: self.degree, terms })
    }

    /// The chain whose coefficients are `one` and its opposite: over the integers, the rationals, residues or reals.
    ///
    /// # Errors
    /// [`ErrorKind::Coefficient`] if `one` is not a finite number.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_algebra::{Residue, Sign};
    /// use coface_algebra::chains::{ChainComplex, Selection};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(1);
    /// let chain = Selection::new(&points, 0, [(CellId::new(0), Sign::Minus)])?.to_chain(&Residue::new(1, 3)?)?;
    /// assert_eq!(chain.coefficient(CellId::new(0)), Some(&Residue::new(2, 3)?));
    /// # Ok(()) }
    /// ```
    pub fn to_chain<C: Coefficient>(&self, one: &C) -> Result<Chain<C>, Error> {
        let one = one.clone().checked()?;
        let minus = one.negated();
        let coefficient = |sign| if sign == Sign::Plus { one.clone() } else { minus.clone() };
        Chain::of_cells(self.degree, self.terms.iter().map(|&(cell, sign)| (cell, coefficient(sign))))
    }

    /// The boundary, as a chain of integers: a cell one degree below may lie at several of the cells chosen.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] if the selection has a cell that is not in the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{Selection, TwoSkeleton};
    /// use coface_algebra::{CellId, RaggedArray, Sign};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = TwoSkeleton::new(2, vec![0, 1], RaggedArray::new())?.chain_complex()?;
    /// let backward = Selection::new(&edge, 1, [(CellId::new(0), Sign::Minus)])?;
    /// assert_eq!(backward.boundary(&edge)?.to_string(), "c0 - c1");
    /// # Ok(()) }
    /// ```
    pub fn boundary(&self, complex: &ChainComplex) -> Result<Chain<Integer>, Error> {
        complex.boundary(&self.to_chain(&Integer::ONE)?)
    }
}

impl TryFrom<&Chain<Integer>> for Selection {
    type Error = Error;

    /// # Errors
    /// [`ErrorKind::Coefficient`] naming the first cell whose coefficient is neither 1 nor -1.
    fn try_from(chain: &Chain<Integer>) -> Result<Self, Error> {
        let terms = chain.terms().iter().map(|(cell, coefficient)| {
            if !coefficient.is_unit() {
                return Err(Error::new(
                    ErrorKind::Coefficient,
                    format!("cell {cell} has the coefficient {coefficient}, which is none of -1, 0, 1"),
                ));
            }
            Ok((*cell, if coefficient.signum() > 0 { Sign::Plus } else { Sign::Minus }))
        });
        Ok(Self { degree: chain.degree(), terms: terms.collect::<Result<_, Error>>()? })
    }
}

impl fmt::Display for Selection {
    /// A sum such as `c0 - c3`; `0` for no cell.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (at, (cell, sign)) in self.terms.iter().enumerate() {
            match (at, sign) {
                (0, Sign::Plus) => write!(f, "{cell}")?,
                (0, Sign::Minus) => write!(f, "-{cell}")?,
                _ => write!(f, " {sign} {cell}")?,
            }
        }
        if self.terms.is_empty() { f.write_str("0") } else { Ok(()) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::integers::{Rational, Residue};
    use crate::matrices::SparseMatrix;
    use crate::samples::random_complexes;
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    /// A complex and two selections of one degree.
    fn selections() -> impl Strategy<Value = (ChainComplex, Selection, Selection)> {
        let terms = || prop::collection::btree_map(0usize..30, any::<bool>(), 0..8);
        (random_complexes(), 0usize..4, terms(), terms()).prop_map(|(complex, degree, a, b)| {
            let count = complex.cell_count(degree);
            let [a, b] = [a, b].map(|terms: BTreeMap<usize, bool>| {
                let sign = |plus| if plus { Sign::Plus } else { Sign::Minus };
                let terms = terms.into_iter().filter(|&(cell, _)| cell < count);
                Selection::new(&complex, degree, terms.map(|(cell, plus)| (CellId::new(cell), sign(plus))))
                    .unwrap()
            });
            (complex, a, b)
        })
    }

    /// The complex with some cells turned around: their columns, and their rows one degree higher, change sign.
    fn turned(complex: &ChainComplex, is_turned: impl Fn(usize, usize) -> bool) -> ChainComplex {
        let matrices = complex.boundary_matrices().iter().enumerate().map(|(below, matrix)| {
            let entries = matrix.columns().enumerate().flat_map(|(j, column)| {
                let is_turned = &is_turned;
                column.iter().map(move |(i, entry)| {
                    let changes = is_turned(below, i) != is_turned(below + 1, j);
                    (i, j, i64::from(if changes { -entry } else { entry }))
                })
            });
            SparseMatrix::from_entries(matrix.row_count(), matrix.column_count(), entries).unwrap()
        });
        ChainComplex::new(matrices.collect()).unwrap()
    }

    proptest! {
        #[test]
        fn sums_are_those_of_integers_or_refused((complex, a, b) in selections()) {
            let [x, y] = [&a, &b].map(|s| s.to_chain(&Integer::ONE).unwrap());
            let sum = x.plus(&y).unwrap();
            match a.plus(&b) {
                Ok(selection) => {
                    prop_assert_eq!(&selection.to_chain(&Integer::ONE).unwrap(), &sum);
                    prop_assert_eq!(selection.to_string(), sum.to_string());
                    prop_assert_eq!(Selection::try_from(&sum).unwrap(), selection);
                }
                Err(error) => {
                    prop_assert_eq!(error.kind(), ErrorKind::Coefficient);
                    prop_assert!(Selection::try_from(&sum).is_err());
                }
            }
            prop_assert!(a.plus(&a.negated()).unwrap().is_zero());
            prop_assert_eq!(a.negated().boundary(&complex).unwrap(), a.boundary(&complex).unwrap().negated());
            prop_assert!(complex.is_cycle(&a.boundary(&complex).unwrap()).unwrap());
            let one = Residue::new(1, 3).unwrap();
            let modulo = a.to_chain(&one).unwrap().plus(&b.to_chain(&one).unwrap()).unwrap();
            prop_assert_eq!(complex.boundary(&modulo).unwrap().degree(), a.degree().saturating_sub(1));
            prop_assert_eq!(a.to_chain(&1.0).unwrap().terms().len(), a.terms().len());
        }

        /// c(-s) = -c(s): with cells turned around and their coefficients negated the boundary is the same, over all
        /// rings.
        #[test]
        fn a_cell_turned_around_has_the_opposite_coefficient((complex, a, _) in selections(), turns in any::<u64>()) {
            let is_turned = |degree: usize, cell: usize| turns.rotate_left((11 * degree + cell) as u32) & 1 == 1;
            let other = turned(&complex, is_turned);
            let across = |degree: usize, chain: &Chain<Rational>| {
                let terms = chain.terms().iter().map(|(cell, value)| {
                    (*cell, if is_turned(degree, cell.index()) { value.negated() } else { value.clone() })
                });
                Chain::new(&complex, chain.degree(), terms.collect::<Vec<_>>()).unwrap()
            };
            let chain = a.to_chain(&"2/3".parse::<Rational>().unwrap()).unwrap();
            let boundary = complex.boundary(&chain).unwrap();
            let lower = a.degree().saturating_sub(1);
            prop_assert_eq!(other.boundary(&across(a.degree(), &chain)).unwrap(), across(lower, &boundary));
        }
    }

    #[test]
    fn faults_are_named() {
        let points = ChainComplex::of_points(2);
        let cell = CellId::new(1);
        let twice = Selection::new(&points, 0, [(cell, Sign::Plus), (cell, Sign::Minus)]).unwrap_err();
        assert_eq!(twice.message(), "cell c1 of degree 0 is chosen twice");
        let absent = Selection::new(&points, 0, [(CellId::new(2), Sign::Plus)]).unwrap_err();
        assert_eq!(absent.kind(), ErrorKind::NotInComplex);
        let one = Selection::new(&points, 0, [(cell, Sign::Minus)]).unwrap();
        assert_eq!(
            one.plus(&one).unwrap_err().message(),
            "cell c1 would be chosen twice: -1 - 1 is none of -1, 0, 1"
        );
        assert_eq!(one.plus(&Selection::zero(1)).unwrap_err().kind(), ErrorKind::Shape);
        assert_eq!((one.sign(cell), one.sign(CellId::new(0))), (Some(Sign::Minus), None));
        assert!(one.to_chain(&f64::NAN).is_err());
        assert_eq!(Selection::zero(2).to_string(), "0");
    }
}
