//! Integers modulo n.

use crate::error::{Error, ErrorKind};
use crate::integers::integer::Integer;
use std::fmt;

/// An element of Z/n: a residue from 0 to n - 1 that knows its modulus n.
///
/// Elements of different moduli do not mix: operations on them are errors.
///
/// # Examples
/// ```
/// use coface_algebra::Residue;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let (two, five) = (Residue::new(2, 6)?, Residue::new(5, 6)?);
/// assert_eq!(two.plus(five)?.to_string(), "1 mod 6");
/// assert_eq!(five.inverse(), Some(five));
/// assert_eq!(two.inverse(), None);
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Residue {
    value: u32,
    modulus: u32,
}

impl Residue {
    /// The class of `value` modulo `modulus`.
    ///
    /// # Errors
    /// [`ErrorKind::Coefficient`] for the modulus 0.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Residue;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(Residue::new(-1, 5)?.value(), 4);
    /// # Ok(()) }
    /// ```
    pub fn new(value: i64, modulus: u32) -> Result<Self, Error> {
        Self::from_integer(&Integer::from(value), modulus)
    }

    /// The class of an integer of any size.
    ///
    /// # Errors
    /// [`ErrorKind::Coefficient`] for the modulus 0.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{Integer, Residue};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let huge: Integer = "100000000000000000001".parse()?;
    /// assert_eq!(Residue::from_integer(&huge, 10)?.value(), 1);
    /// # Ok(()) }
    /// ```
    pub fn from_integer(value: &Integer, modulus: u32) -> Result<Self, Error> {
        if modulus == 0 {
            return Err(Error::new(ErrorKind::Coefficient, "there are no residues modulo 0")
                .with_cure("take a modulus of 1 or more, or integers"));
        }
        let rest = value.div_rem_floor(&Integer::from(i64::from(modulus))).1;
        let value = rest
            .to_i64()
            .and_then(|rest| u32::try_from(rest).ok())
            .expect("a remainder is below its divisor");
        Ok(Self { value, modulus })
    }

    /// The representative from 0 to the modulus less one.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(coface_algebra::Residue::new(17, 5)?.value(), 2);
    /// # Ok(()) }
    /// ```
    pub fn value(self) -> u32 {
        self.value
    }

    /// The modulus.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(coface_algebra::Residue::new(17, 5)?.modulus(), 5);
    /// # Ok(()) }
    /// ```
    pub fn modulus(self) -> u32 {
        self.modulus
    }

    /// Whether this is the class of 0.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert!(coface_algebra::Residue::new(10, 5)?.is_zero());
    /// # Ok(()) }
    /// ```
    pub fn is_zero(self) -> bool {
        self.value == 0
    }

    #[allow(clippy::cast_possible_truncation, reason = "a remainder modulo a 32-bit number has 32 bits")]
    fn with(self, value: u64) -> Self {
        Self { value: (value % u64::from(self.modulus)) as u32, ..self }
    }

    fn check(self, other: Self) -> Result<(), Error> {
        if self.modulus == other.modulus {
            return Ok(());
        }
        Err(Error::new(ErrorKind::Coefficient, format!("{self} and {other} belong to different rings")))
    }

    /// The sum.
    ///
    /// # Errors
    /// [`ErrorKind::Coefficient`] if the moduli differ.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Residue;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(Residue::new(3, 5)?.plus(Residue::new(4, 5)?)?, Residue::new(2, 5)?);
    /// assert!(Residue::new(3, 5)?.plus(Residue::new(3, 7)?).is_err());
    /// # Ok(()) }
    /// ```
    pub fn plus(self, other: Self) -> Result<Self, Error> {
        self.check(other)?;
        Ok(self.with(u64::from(self.value) + u64::from(other.value)))
    }

    /// The product.
    ///
    /// # Errors
    /// [`ErrorKind::Coefficient`] if the moduli differ.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Residue;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(Residue::new(3, 5)?.times(Residue::new(4, 5)?)?, Residue::new(2, 5)?);
    /// # Ok(()) }
    /// ```
    pub fn times(self, other: Self) -> Result<Self, Error> {
        self.check(other)?;
        Ok(self.with(u64::from(self.value) * u64::from(other.value)))
    }

    /// The opposite.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Residue;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(Residue::new(3, 5)?.negated(), Residue::new(2, 5)?);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn negated(self) -> Self {
        self.with(u64::from(self.modulus - self.value))
    }

    /// The element with which the product is 1; `None` unless the value is prime to the modulus.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Residue;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(Residue::new(3, 5)?.inverse(), Some(Residue::new(2, 5)?));
    /// # Ok(()) }
    /// ```
    pub fn inverse(self) -> Option<Self> {
        let (value, modulus) = (Integer::from(i64::from(self.value)), Integer::from(i64::from(self.modulus)));
        let (gcd, inverse, _) = value.extended_gcd(&modulus);
        if !gcd.is_unit() {
            return None;
        }
        Self::from_integer(&inverse, self.modulus).ok()
    }
}

impl fmt::Display for Residue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} mod {}", self.value, self.modulus)
    }
}

impl fmt::Debug for Residue {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn arithmetic_is_that_of_integers(a in any::<i64>(), b in any::<i64>(), modulus in 1u32..) {
            let class = |value: i128| {
                let value = value.rem_euclid(i128::from(modulus));
                Residue::new(value as i64, modulus).unwrap()
            };
            let (x, y) = (Residue::new(a, modulus).unwrap(), Residue::new(b, modulus).unwrap());
            prop_assert_eq!(x.plus(y).unwrap(), class(i128::from(a) + i128::from(b)));
            prop_assert_eq!(x.times(y).unwrap(), class(i128::from(a) * i128::from(b)));
            prop_assert_eq!(x.negated(), class(-i128::from(a)));
        }

        #[test]
        fn inverses_are_all_there(value in 0i64..60, modulus in 1u32..60) {
            let x = Residue::new(value, modulus).unwrap();
            let one = Residue::new(1, modulus).unwrap();
            let found = (0..i64::from(modulus)).map(|y| Residue::new(y, modulus).unwrap()).find(|&y| x.times(y) == Ok(one));
            prop_assert_eq!(x.inverse(), found);
        }
    }

    #[test]
    fn rings_do_not_mix() {
        let (x, y) = (Residue::new(1, 2).unwrap(), Residue::new(1, 3).unwrap());
        assert_eq!(x.plus(y).unwrap_err().message(), "1 mod 2 and 1 mod 3 belong to different rings");
        assert_eq!(Residue::new(1, 0).unwrap_err().kind(), ErrorKind::Coefficient);
    }
}
