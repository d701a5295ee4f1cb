//! Linear combinations of cells of one degree: what chains and cochains have in common.

use super::{ChainComplex, Coefficient};
use crate::{CellId, Error, ErrorKind, Fault};
use std::fmt;

/// A combination of cells of one degree: cells rising, no coefficient zero.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Combination<C> {
    pub(super) degree: usize,
    pub(super) terms: Vec<(CellId, C)>,
}

impl<C: Coefficient> Combination<C> {
    /// The combination of these terms in any order; those of one cell are added.
    pub(super) fn from_terms(degree: usize, mut terms: Vec<(CellId, C)>) -> Result<Self, Error> {
        terms.sort_by_key(|&(cell, _)| cell);
        if terms.is_sorted_by(|a, b| a.0 < b.0) && terms.iter().all(|(_, coefficient)| !coefficient.is_zero())
        {
            return Ok(Self { degree, terms });
        }
        let mut sum: Vec<(CellId, C)> = Vec::with_capacity(terms.len());
        for (cell, coefficient) in terms {
            match sum.last_mut() {
                Some((last, total)) if *last == cell => *total = total.plus(&coefficient)?,
                _ => {
                    sum.pop_if(|(_, total)| total.is_zero());
                    sum.push((cell, coefficient));
                }
            }
        }
        sum.pop_if(|(_, total)| total.is_zero());
        Ok(Self { degree, terms: sum })
    }

    pub(super) fn of_complex(
        complex: &ChainComplex,
        degree: usize,
        terms: impl IntoIterator<Item = (CellId, C)>,
    ) -> Result<Self, Error> {
        let mut checked = Vec::new();
        for (cell, coefficient) in terms {
            checked.push((cell, coefficient.checked()?));
        }
        check_cells(complex, degree, checked.iter().map(|&(cell, _)| cell).max())?;
        Self::from_terms(degree, checked)
    }

    /// Checks that all cells exist.
    pub(super) fn check(&self, complex: &ChainComplex) -> Result<(), Error> {
        check_cells(complex, self.degree, self.terms.last().map(|&(cell, _)| cell))
    }

    pub(super) fn check_degree(&self, degree: usize) -> Result<(), Error> {
        if self.degree == degree {
            return Ok(());
        }
        Err(Error::new(
            ErrorKind::Shape,
            format!("the degrees {} and {degree} do not fit together", self.degree),
        ))
    }

    pub(super) fn coefficient(&self, cell: CellId) -> Option<&C> {
        let at = self.terms.binary_search_by_key(&cell, |&(present, _)| present).ok()?;
        Some(&self.terms[at].1)
    }

    pub(super) fn plus(&self, other: &Self) -> Result<Self, Error> {
        self.check_degree(other.degree)?;
        Self::from_terms(self.degree, self.terms.iter().chain(&other.terms).cloned().collect())
    }

    pub(super) fn negated(&self) -> Self {
        let terms = self.terms.iter().map(|(cell, coefficient)| (*cell, coefficient.negated())).collect();
        Self { degree: self.degree, terms }
    }

    pub(super) fn scaled(&self, factor: &C) -> Result<Self, Error> {
        let multiply = |(cell, coefficient): &(CellId, C)| Ok((*cell, factor.times(coefficient)?));
        // Products of residues can be zero where no factor is.
        Self::from_terms(self.degree, self.terms.iter().map(multiply).collect::<Result<_, Error>>()?)
    }

    /// The sum of products over common cells; `None` for zero.
    pub(super) fn inner_product(&self, other: &Self) -> Result<Option<C>, Error> {
        self.check_degree(other.degree)?;
        let mut products = Vec::new();
        for (cell, coefficient) in &self.terms {
            if let Some(factor) = other.coefficient(*cell) {
                products.push(coefficient.times(factor)?);
            }
        }
        total(products)
    }
}

/// Checks that the last cell, and so all of them, exist.
fn check_cells(complex: &ChainComplex, degree: usize, last: Option<CellId>) -> Result<(), Error> {
    let count = complex.cell_count(degree);
    match last {
        Some(cell) if cell.index() >= count => Err(Error::new(
            ErrorKind::NotInComplex,
            format!("there is no cell {cell} of degree {degree}: there are {count} such cells"),
        )
        .with_fault(Fault::OutOfRange { index: cell.index(), count })),
        _ => Ok(()),
    }
}

/// The sum; `None` for zero.
pub(super) fn total<C: Coefficient>(values: impl IntoIterator<Item = C>) -> Result<Option<C>, Error> {
    let mut sum: Option<C> = None;
    for value in values {
        sum = Some(match sum {
            Some(sum) => sum.plus(&value)?,
            None => value,
        });
    }
    Ok(sum.filter(|sum| !sum.is_zero()))
}

impl<C: Coefficient> fmt::Display for Combination<C> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.terms.is_empty() {
            return f.write_str("0");
        }
        for (at, (cell, coefficient)) in self.terms.iter().enumerate() {
            let text = coefficient.to_string();
            let (is_negative, size) = match text.strip_prefix('-') {
                Some(size) => (true, size),
                None => (false, text.as_str()),
            };
            f.write_str(match (at, is_negative) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            })?;
            match size {
                "1" => write!(f, "{cell}")?,
                size if size.contains(' ') => write!(f, "({size}) {cell}")?,
                size => write!(f, "{size} {cell}")?,
            }
        }
        Ok(())
    }
}

/// The methods that chains and cochains share.
macro_rules! combination {
    ($type:ident, $noun:literal) => {
        impl<C: Coefficient> $type<C> {
            #[doc = concat!("The ", $noun, " of these terms, in any order; terms of one cell are added.")]
            ///
            /// # Errors
            /// [`ErrorKind::NotInComplex`](crate::ErrorKind::NotInComplex) for a cell that the complex does not have;
            /// [`ErrorKind::Coefficient`](crate::ErrorKind::Coefficient) for coefficients of different rings and for
            /// floating-point values that are not finite.
            ///
            /// # Complexity
            /// $O(m \log m)$ for m terms.
            ///
            /// # Examples
            /// ```
            /// use coface_algebra::chains::ChainComplex;
            #[doc = concat!("use coface_algebra::chains::", stringify!($type), ";")]
            /// use coface_algebra::{CellId, Integer};
            /// # fn main() -> Result<(), coface_algebra::Error> {
            /// let points = ChainComplex::of_points(3);
            /// let terms = [(2, 5), (0, 1), (2, -3)].map(|(cell, x)| (CellId::new(cell), Integer::from(x)));
            #[doc = concat!("assert_eq!(", stringify!($type), "::new(&points, 0, terms)?.to_string(), \"c0 + 2 c2\");")]
            /// # Ok(()) }
            /// ```
            pub fn new(
                complex: &ChainComplex,
                degree: usize,
                terms: impl IntoIterator<Item = (CellId, C)>,
            ) -> Result<Self, Error> {
                Combination::of_complex(complex, degree, terms).map(Self)
            }

            #[doc = concat!("The ", $noun, " of these terms, whose cells are known to be there, in any order.")]
            #[doc(hidden)]
            pub fn of_cells(
                degree: usize,
                terms: impl IntoIterator<Item = (CellId, C)>,
            ) -> Result<Self, Error> {
                Combination::from_terms(degree, terms.into_iter().collect()).map(Self)
            }

            #[doc = concat!("The ", $noun, " without terms.")]
            ///
            /// # Examples
            /// ```
            #[doc = concat!("use coface_algebra::chains::", stringify!($type), ";")]
            #[doc = concat!("assert!(", stringify!($type), "::<coface_algebra::Integer>::zero(2).is_zero());")]
            /// ```
            pub fn zero(degree: usize) -> Self {
                Self(Combination { degree, terms: Vec::new() })
            }

            #[doc = concat!("The degree of the cells of this ", $noun, ".")]
            ///
            /// # Examples
            /// ```
            #[doc = concat!("use coface_algebra::chains::", stringify!($type), ";")]
            #[doc = concat!("assert_eq!(", stringify!($type), "::<coface_algebra::Integer>::zero(2).degree(), 2);")]
            /// ```
            pub fn degree(&self) -> usize {
                self.0.degree
            }

            /// The cells with their coefficients, which are not zero, in rising order.
            ///
            /// # Examples
            /// ```
            /// use coface_algebra::chains::ChainComplex;
            #[doc = concat!("use coface_algebra::chains::", stringify!($type), ";")]
            /// use coface_algebra::{CellId, Integer};
            /// # fn main() -> Result<(), coface_algebra::Error> {
            /// let (points, term) = (ChainComplex::of_points(2), (CellId::new(1), Integer::from(4)));
            #[doc = concat!("assert_eq!(", stringify!($type), "::new(&points, 0, [term.clone()])?.terms(), [term]);")]
            /// # Ok(()) }
            /// ```
            pub fn terms(&self) -> &[(CellId, C)] {
                &self.0.terms
            }

            /// The cells whose coefficient is not zero, in rising order.
            ///
            /// # Examples
            /// ```
            /// use coface_algebra::chains::ChainComplex;
            #[doc = concat!("use coface_algebra::chains::", stringify!($type), ";")]
            /// use coface_algebra::{CellId, Integer};
            /// # fn main() -> Result<(), coface_algebra::Error> {
            /// let term = (CellId::new(1), Integer::from(4));
            #[doc = concat!("let one = ", stringify!($type), "::new(&ChainComplex::of_points(2), 0, [term])?;")]
            /// assert!(one.support().eq([CellId::new(1)]));
            /// # Ok(()) }
            /// ```
            pub fn support(&self) -> impl ExactSizeIterator<Item = CellId> + '_ {
                self.0.terms.iter().map(|&(cell, _)| cell)
            }

            /// The coefficient of a cell; `None` stands for zero.
            ///
            /// # Examples
            /// ```
            /// use coface_algebra::chains::ChainComplex;
            #[doc = concat!("use coface_algebra::chains::", stringify!($type), ";")]
            /// use coface_algebra::{CellId, Integer};
            /// # fn main() -> Result<(), coface_algebra::Error> {
            /// let (points, term) = (ChainComplex::of_points(2), (CellId::new(1), Integer::from(4)));
            #[doc = concat!("let one = ", stringify!($type), "::new(&points, 0, [term])?;")]
            /// assert_eq!(one.coefficient(CellId::new(1)), Some(&4.into()));
            /// assert_eq!(one.coefficient(CellId::new(0)), None);
            /// # Ok(()) }
            /// ```
            pub fn coefficient(&self, cell: CellId) -> Option<&C> {
                self.0.coefficient(cell)
            }

            /// Whether every coefficient is zero.
            ///
            /// # Examples
            /// ```
            #[doc = concat!("use coface_algebra::chains::", stringify!($type), ";")]
            #[doc = concat!("assert!(", stringify!($type), "::<coface_algebra::Integer>::zero(0).is_zero());")]
            /// ```
            pub fn is_zero(&self) -> bool {
                self.0.terms.is_empty()
            }

            /// The sum.
            ///
            /// # Errors
            /// [`ErrorKind::Shape`](crate::ErrorKind::Shape) if the degrees differ,
            /// [`ErrorKind::Coefficient`](crate::ErrorKind::Coefficient) if the rings do.
            ///
            /// # Examples
            /// ```
            /// use coface_algebra::chains::ChainComplex;
            #[doc = concat!("use coface_algebra::chains::", stringify!($type), ";")]
            /// use coface_algebra::{CellId, Integer};
            /// # fn main() -> Result<(), coface_algebra::Error> {
            /// let points = ChainComplex::of_points(2);
            /// let terms = [0, 1].map(|cell| (CellId::new(cell), Integer::ONE));
            #[doc = concat!("let [a, b] = terms.map(|term| ", stringify!($type), "::new(&points, 0, [term]));")]
            /// assert_eq!(a?.plus(&b?)?.to_string(), "c0 + c1");
            /// # Ok(()) }
            /// ```
            pub fn plus(&self, other: &Self) -> Result<Self, Error> {
                self.0.plus(&other.0).map(Self)
            }

            /// The difference `self - other`.
            ///
            /// # Errors
            /// As [`Self::plus`].
            ///
            /// # Examples
            /// ```
            /// use coface_algebra::chains::ChainComplex;
            #[doc = concat!("use coface_algebra::chains::", stringify!($type), ";")]
            /// use coface_algebra::{CellId, Integer};
            /// # fn main() -> Result<(), coface_algebra::Error> {
            /// let points = ChainComplex::of_points(2);
            /// let terms = [0, 1].map(|cell| (CellId::new(cell), Integer::ONE));
            #[doc = concat!("let [a, b] = terms.map(|term| ", stringify!($type), "::new(&points, 0, [term]));")]
            /// assert_eq!(a?.minus(&b?)?.to_string(), "c0 - c1");
            /// # Ok(()) }
            /// ```
            pub fn minus(&self, other: &Self) -> Result<Self, Error> {
                self.plus(&other.negated())
            }

            #[doc = concat!("The ", $noun, " with the opposite coefficients.")]
            ///
            /// # Examples
            /// ```
            /// use coface_algebra::chains::ChainComplex;
            #[doc = concat!("use coface_algebra::chains::", stringify!($type), ";")]
            /// use coface_algebra::{CellId, Integer};
            /// # fn main() -> Result<(), coface_algebra::Error> {
            /// let (point, term) = (ChainComplex::of_points(1), (CellId::new(0), Integer::from(4)));
            #[doc = concat!("let one = ", stringify!($type), "::new(&point, 0, [term])?;")]
            /// assert_eq!(one.negated().to_string(), "-4 c0");
            /// # Ok(()) }
            /// ```
            #[must_use]
            pub fn negated(&self) -> Self {
                Self(self.0.negated())
            }

            #[doc = concat!("The ", $noun, " with each coefficient multiplied by `factor`.")]
            ///
            /// # Errors
            /// [`ErrorKind::Coefficient`](crate::ErrorKind::Coefficient) if the factor is of another ring.
            ///
            /// # Examples
            /// ```
            /// use coface_algebra::chains::ChainComplex;
            #[doc = concat!("use coface_algebra::chains::", stringify!($type), ";")]
            /// use coface_algebra::{CellId, Integer};
            /// # fn main() -> Result<(), coface_algebra::Error> {
            /// let (point, term) = (ChainComplex::of_points(1), (CellId::new(0), Integer::from(4)));
            #[doc = concat!("let one = ", stringify!($type), "::new(&point, 0, [term])?;")]
            /// assert_eq!(one.scaled(&3.into())?.to_string(), "12 c0");
            /// # Ok(()) }
            /// ```
            pub fn scaled(&self, factor: &C) -> Result<Self, Error> {
                self.0.scaled(factor).map(Self)
            }
        }

        impl<C: Coefficient> std::fmt::Display for $type<C> {
            /// A sum such as `c0 - 2 c3`; `0` without terms.
            fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                std::fmt::Display::fmt(&self.0, f)
            }
        }
    };
}

pub(super) use combination;
