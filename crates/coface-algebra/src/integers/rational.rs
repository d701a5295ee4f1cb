//! Fractions of integers of any size.

use crate::error::{Error, ErrorKind};
use crate::integers::integer::Integer;
use dashu_ratio::RBig;
use std::fmt;
use std::ops::{Add, AddAssign, Mul, Neg, Sub};
use std::str::FromStr;

/// A rational number, always in lowest terms with a positive denominator.
///
/// # Examples
/// ```
/// use coface_algebra::{Integer, Rational};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let half = Rational::new(Integer::from(3), Integer::from(6))?;
/// assert_eq!((&half + &"1/3".parse()?).to_string(), "5/6");
/// assert_eq!(half.inverse(), Some(Rational::from(2)));
/// # Ok(()) }
/// ```
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Rational(RBig);

impl Rational {
    /// 0.
    pub const ZERO: Self = Self(RBig::ZERO);
    /// 1.
    pub const ONE: Self = Self(RBig::ONE);

    /// The fraction `numerator / denominator`.
    ///
    /// # Errors
    /// [`ErrorKind::Coefficient`] if the denominator is 0.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{Integer, Rational};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(Rational::new(Integer::from(4), Integer::from(-6))?.to_string(), "-2/3");
    /// assert!(Rational::new(Integer::ONE, Integer::ZERO).is_err());
    /// # Ok(()) }
    /// ```
    pub fn new(numerator: Integer, denominator: Integer) -> Result<Self, Error> {
        if denominator.is_zero() {
            return Err(Error::new(ErrorKind::Coefficient, format!("{numerator}/0 is not a number")));
        }
        Ok(Self(RBig::from_parts_signed(numerator.into_big(), denominator.into_big())))
    }

    #[doc(hidden)]
    pub fn from_big(value: RBig) -> Self {
        Self(value)
    }

    /// The numerator in lowest terms; it has the sign.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Rational;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!("-4/6".parse::<Rational>()?.numerator(), (-2).into());
    /// # Ok(()) }
    /// ```
    pub fn numerator(&self) -> Integer {
        Integer::from_big(self.0.numerator().clone())
    }

    /// The denominator in lowest terms, positive.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Rational;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!("-4/6".parse::<Rational>()?.denominator(), 3.into());
    /// # Ok(()) }
    /// ```
    pub fn denominator(&self) -> Integer {
        Integer::from_big(self.0.denominator().clone().into())
    }

    /// Whether this is 0.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Rational;
    /// assert!((Rational::from(2) - Rational::from(2)).is_zero());
    /// ```
    pub fn is_zero(&self) -> bool {
        self.0.is_zero()
    }

    /// The value if it is an integer.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Rational;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!("6/3".parse::<Rational>()?.to_integer(), Some(2.into()));
    /// assert_eq!("7/3".parse::<Rational>()?.to_integer(), None);
    /// # Ok(()) }
    /// ```
    pub fn to_integer(&self) -> Option<Integer> {
        self.0.is_int().then(|| self.numerator())
    }

    /// A floating-point number within one unit in the last place; infinite beyond the range.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Rational;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!("3/4".parse::<Rational>()?.to_f64(), 0.75);
    /// # Ok(()) }
    /// ```
    pub fn to_f64(&self) -> f64 {
        self.0.to_f64().value()
    }

    /// The number with which the product is 1; `None` for 0.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Rational;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!("3/4".parse::<Rational>()?.inverse(), Some("4/3".parse()?));
    /// assert_eq!(Rational::ZERO.inverse(), None);
    /// # Ok(()) }
    /// ```
    pub fn inverse(&self) -> Option<Self> {
        (!self.is_zero()).then(|| Self(&RBig::ONE / &self.0))
    }
}

impl Default for Rational {
    fn default() -> Self {
        Self::ZERO
    }
}

impl From<Integer> for Rational {
    fn from(value: Integer) -> Self {
        Self(RBig::from(value.into_big()))
    }
}

impl From<i64> for Rational {
    fn from(value: i64) -> Self {
        Self(RBig::from(value))
    }
}

impl FromStr for Rational {
    type Err = Error;

    /// `n` or `n/d` with decimal integers.
    fn from_str(text: &str) -> Result<Self, Error> {
        match text.split_once('/') {
            Some((numerator, denominator)) => Self::new(numerator.parse()?, denominator.parse()?),
            None => Ok(Self::from(text.parse::<Integer>()?)),
        }
    }
}

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(&self.0, f)
    }
}

impl fmt::Debug for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident) => {
        impl $trait<&Rational> for &Rational {
            type Output = Rational;
            fn $method(self, other: &Rational) -> Rational {
                Rational($trait::$method(&self.0, &other.0))
            }
        }
        impl $trait for Rational {
            type Output = Rational;
            fn $method(self, other: Rational) -> Rational {
                Rational($trait::$method(self.0, other.0))
            }
        }
    };
}

operator!(Add, add);
operator!(Sub, sub);
operator!(Mul, mul);

impl AddAssign<&Rational> for Rational {
    fn add_assign(&mut self, other: &Rational) {
        self.0 += &other.0;
    }
}

impl Neg for &Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        Rational(-&self.0)
    }
}

impl Neg for Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        Rational(-self.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn arithmetic_is_that_of_cross_products(
            (a, b, c, d) in (-50i64..50, 1i64..50, -50i64..50, 1i64..50),
        ) {
            let fraction = |n: i64, d: i64| Rational::new(n.into(), d.into()).unwrap();
            let (x, y) = (fraction(a, b), fraction(c, d));
            prop_assert_eq!(&x + &y, fraction(a * d + c * b, b * d));
            prop_assert_eq!(&x - &y, fraction(a * d - c * b, b * d));
            prop_assert_eq!(&x * &y, fraction(a * c, b * d));
            prop_assert_eq!(-&x, fraction(a, -b));
            prop_assert_eq!(x.cmp(&y), (a * d).cmp(&(c * b)));
            prop_assert_eq!(x.inverse(), (a != 0).then(|| fraction(b, a)));
            prop_assert!(x.denominator().signum() > 0 && x.numerator().gcd(&x.denominator()).is_unit());
            prop_assert_eq!(x.to_integer().is_some(), a % b == 0);
            prop_assert!((x.to_f64() - a as f64 / b as f64).abs() < 1e-12);
            prop_assert_eq!(x.to_string().parse::<Rational>().unwrap(), x);
        }
    }

    #[test]
    fn no_denominator_is_zero() {
        assert_eq!(Rational::new(Integer::ONE, Integer::ZERO).unwrap_err().kind(), ErrorKind::Coefficient);
        assert_eq!("1/0".parse::<Rational>().unwrap_err().kind(), ErrorKind::Coefficient);
        assert_eq!("1/x".parse::<Rational>().unwrap_err().kind(), ErrorKind::Parse);
    }
}
