//! Coefficients of chains and cochains: integers, fractions, residues and real numbers.

use crate::integers::{Integer, Rational, Residue};
use crate::{Error, ErrorKind};
use std::fmt;

/// An element of a commutative ring, as chains and cochains need it: Z ([`Integer`]), Q ([`Rational`]), Z/n
/// ([`Residue`]) and, for measured quantities, R (`f64`).
///
/// There is no common zero: that of Z/n depends on n. Where a result can be zero, `None` stands for it.
///
/// # Examples
/// ```
/// use coface_algebra::{Integer, Residue};
/// use coface_algebra::chains::Coefficient;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// assert_eq!(Coefficient::plus(&Integer::from(2), &Integer::from(3))?, Integer::from(5));
/// assert_eq!(Residue::new(2, 5)?.times_integer(-1), Residue::new(3, 5)?);
/// # Ok(()) }
/// ```
pub trait Coefficient: Clone + PartialEq + fmt::Debug + fmt::Display {
    /// Whether this is 0.
    fn is_zero(&self) -> bool;

    /// The sum.
    ///
    /// # Errors
    /// [`ErrorKind::Coefficient`] if the two belong to different rings.
    fn plus(&self, other: &Self) -> Result<Self, Error>;

    /// The product.
    ///
    /// # Errors
    /// [`ErrorKind::Coefficient`] if the two belong to different rings.
    fn times(&self, other: &Self) -> Result<Self, Error>;

    /// This added to itself `factor` times.
    #[must_use]
    fn times_integer(&self, factor: i32) -> Self;

    /// The opposite.
    #[must_use]
    fn negated(&self) -> Self;

    /// The value itself if it is a finite number.
    ///
    /// # Errors
    /// [`ErrorKind::Coefficient`] for an infinite or undefined floating-point value.
    fn checked(self) -> Result<Self, Error> {
        Ok(self)
    }
}

impl Coefficient for Integer {
    fn is_zero(&self) -> bool {
        Integer::is_zero(self)
    }

    fn plus(&self, other: &Self) -> Result<Self, Error> {
        Ok(self + other)
    }

    fn times(&self, other: &Self) -> Result<Self, Error> {
        Ok(self * other)
    }

    fn times_integer(&self, factor: i32) -> Self {
        self * &Integer::from(factor)
    }

    fn negated(&self) -> Self {
        -self
    }
}

impl Coefficient for Rational {
    fn is_zero(&self) -> bool {
        Rational::is_zero(self)
    }

    fn plus(&self, other: &Self) -> Result<Self, Error> {
        Ok(self + other)
    }

    fn times(&self, other: &Self) -> Result<Self, Error> {
        Ok(self * other)
    }

    fn times_integer(&self, factor: i32) -> Self {
        self * &Rational::from(i64::from(factor))
    }

    fn negated(&self) -> Self {
        -self
    }
}

impl Coefficient for Residue {
    fn is_zero(&self) -> bool {
        Residue::is_zero(*self)
    }

    fn plus(&self, other: &Self) -> Result<Self, Error> {
        Residue::plus(*self, *other)
    }

    fn times(&self, other: &Self) -> Result<Self, Error> {
        Residue::times(*self, *other)
    }

    fn times_integer(&self, factor: i32) -> Self {
        let factor =
            Residue::new(i64::from(factor), self.modulus()).expect("the modulus of a residue is not zero");
        Residue::times(*self, factor).expect("the moduli agree")
    }

    fn negated(&self) -> Self {
        Residue::negated(*self)
    }
}

/// Real numbers, rounded: a cycle with such coefficients is one only if its boundary is zero after rounding.
impl Coefficient for f64 {
    fn is_zero(&self) -> bool {
        *self == 0.0
    }

    fn plus(&self, other: &Self) -> Result<Self, Error> {
        Ok(self + other)
    }

    fn times(&self, other: &Self) -> Result<Self, Error> {
        Ok(self * other)
    }

    fn times_integer(&self, factor: i32) -> Self {
        self * f64::from(factor)
    }

    fn negated(&self) -> Self {
        -self
    }

    fn checked(self) -> Result<Self, Error> {
        if self.is_finite() {
            Ok(self)
        } else {
            Err(Error::new(ErrorKind::Coefficient, format!("the coefficient {self} is not a number")))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The laws that chains rely on, for three elements of one ring.
    fn check_laws<C: Coefficient>(a: &C, b: &C, c: &C) {
        assert_eq!(a.plus(b), b.plus(a));
        assert_eq!(a.plus(b).unwrap().plus(c), a.plus(&b.plus(c).unwrap()));
        assert_eq!(a.times(b), b.times(a));
        assert_eq!(a.times(&b.plus(c).unwrap()), a.times(b).unwrap().plus(&a.times(c).unwrap()));
        assert!(a.plus(&a.negated()).unwrap().is_zero());
        assert!(a.times_integer(0).is_zero());
        assert_eq!(a.times_integer(3), a.plus(a).unwrap().plus(a).unwrap());
        assert_eq!(a.times_integer(-1), a.negated());
    }

    #[test]
    fn the_four_rings_obey_the_laws() {
        check_laws(&Integer::from(i64::MAX), &Integer::from(-7), &Integer::from(12));
        let [a, b, c] = ["1/3", "-2/5", "7"].map(|text| text.parse::<Rational>().unwrap());
        check_laws(&a, &b, &c);
        let [a, b, c] = [4, 5, 11].map(|value| Residue::new(value, 12).unwrap());
        check_laws(&a, &b, &c);
        check_laws(&0.5, &-2.25, &8.0);
    }

    #[test]
    fn rings_do_not_mix() {
        let (a, b) = (Residue::new(1, 2).unwrap(), Residue::new(1, 4).unwrap());
        assert_eq!(Coefficient::plus(&a, &b).unwrap_err().kind(), ErrorKind::Coefficient);
        assert_eq!(f64::NAN.checked().unwrap_err().kind(), ErrorKind::Coefficient);
        assert_eq!(f64::INFINITY.checked().unwrap_err().kind(), ErrorKind::Coefficient);
    }
}
