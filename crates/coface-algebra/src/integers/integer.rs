//! Integers of any size, fast as long as they fit in 64 bits.

use dashu_int::IBig;
use dashu_int::ops::{DivRem, ExtendedGcd, Gcd};
use std::cmp::Ordering;
use std::fmt;
use std::ops::{Add, AddAssign, Mul, MulAssign, Neg, Sub, SubAssign};
use std::str::FromStr;

/// An integer of any size: 64 bits as long as it fits, a big integer beyond.
///
/// # Complexity
/// One checked machine operation while both operands and the result fit in 64 bits.
///
/// # Examples
/// ```
/// use coface_algebra::Integer;
/// let big = Integer::from(i64::MAX) * Integer::from(2);
/// assert_eq!(big.to_string(), "18446744073709551614");
/// assert_eq!(big.to_i64(), None);
/// assert_eq!((&big - &Integer::from(i64::MAX)).to_i64(), Some(i64::MAX));
/// ```
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Integer(Repr);

/// A value that fits in 64 bits is always `Small`.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Repr {
    Small(i64),
    Large(Box<IBig>),
}

impl Integer {
    /// 0.
    pub const ZERO: Self = Self(Repr::Small(0));
    /// 1.
    pub const ONE: Self = Self(Repr::Small(1));

    pub(super) fn from_big(value: IBig) -> Self {
        match i64::try_from(&value) {
            Ok(small) => Self(Repr::Small(small)),
            Err(_) => Self(Repr::Large(Box::new(value))),
        }
    }

    pub(super) fn into_big(self) -> IBig {
        match self.0 {
            Repr::Small(value) => IBig::from(value),
            Repr::Large(value) => *value,
        }
    }

    /// Hands the value to `f` as a big integer; a small one takes no allocation.
    fn with_big<R>(&self, f: impl FnOnce(&IBig) -> R) -> R {
        match &self.0 {
            Repr::Small(value) => f(&IBig::from(*value)),
            Repr::Large(value) => f(value),
        }
    }

    /// The value if it fits in 64 bits.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Integer;
    /// assert_eq!(Integer::from(-7).to_i64(), Some(-7));
    /// assert_eq!((Integer::from(i64::MAX) + Integer::ONE).to_i64(), None);
    /// ```
    pub fn to_i64(&self) -> Option<i64> {
        match &self.0 {
            Repr::Small(value) => Some(*value),
            Repr::Large(_) => None,
        }
    }

    /// The nearest floating-point number; infinite beyond the range.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_algebra::Integer::from(-7).to_f64(), -7.0);
    /// ```
    pub fn to_f64(&self) -> f64 {
        match &self.0 {
            Repr::Small(value) => *value as f64,
            Repr::Large(value) => value.to_f64().value(),
        }
    }

    /// Whether this is 0.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Integer;
    /// assert!((Integer::from(3) - Integer::from(3)).is_zero());
    /// ```
    pub fn is_zero(&self) -> bool {
        self.0 == Repr::Small(0)
    }

    /// Whether this is 1 or -1.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Integer;
    /// assert!(Integer::from(-1).is_unit() && !Integer::from(2).is_unit());
    /// ```
    pub fn is_unit(&self) -> bool {
        matches!(self.0, Repr::Small(1 | -1))
    }

    /// -1, 0 or 1.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_algebra::Integer::from(-12).signum(), -1);
    /// ```
    pub fn signum(&self) -> i32 {
        match &self.0 {
            Repr::Small(value) => value.signum() as i32,
            Repr::Large(value) => {
                if **value > IBig::ZERO {
                    1
                } else {
                    -1
                }
            }
        }
    }

    /// The absolute value.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Integer;
    /// assert_eq!(Integer::from(i64::MIN).abs().to_string(), "9223372036854775808");
    /// ```
    #[must_use]
    pub fn abs(&self) -> Self {
        if self.signum() < 0 { -self } else { self.clone() }
    }

    /// The value as bytes in two's complement, the lowest first; as few as there can be.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Integer;
    /// assert_eq!(Integer::from(-2).to_le_bytes(), [0xfe]);
    /// assert_eq!(Integer::from_le_bytes(&[0x00, 0x01]), Integer::from(256));
    /// ```
    pub fn to_le_bytes(&self) -> Vec<u8> {
        self.with_big(|value| value.to_le_bytes().into_vec())
    }

    /// The value of these bytes in two's complement, the lowest first; 0 for none.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Integer;
    /// assert_eq!(Integer::from_le_bytes(&[0xff]), Integer::from(-1));
    /// ```
    pub fn from_le_bytes(bytes: &[u8]) -> Self {
        Self::from_big(IBig::from_le_bytes(bytes))
    }

    /// The number of bits of the absolute value; 0 for 0.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Integer;
    /// assert_eq!([0, 1, -8].map(|n| Integer::from(n).bit_length()), [0, 1, 4]);
    /// ```
    pub fn bit_length(&self) -> usize {
        match &self.0 {
            Repr::Small(value) => (u64::BITS - value.unsigned_abs().leading_zeros()) as usize,
            Repr::Large(value) => dashu_int::ops::BitTest::bit_len(&**value),
        }
    }

    /// Quotient and remainder, rounding towards minus infinity: the remainder has the sign of the divisor.
    ///
    /// # Panics
    /// If `divisor` is zero.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Integer;
    /// let (quotient, remainder) = Integer::from(-7).div_rem_floor(&Integer::from(4));
    /// assert_eq!((quotient, remainder), (Integer::from(-2), Integer::from(1)));
    /// ```
    pub fn div_rem_floor(&self, divisor: &Self) -> (Self, Self) {
        if let (Repr::Small(a), Repr::Small(b)) = (&self.0, &divisor.0)
            && let (Some(quotient), Some(remainder)) = (a.checked_div(*b), a.checked_rem(*b))
        {
            return if remainder != 0 && (remainder < 0) != (*b < 0) {
                (Self::from(quotient - 1), Self::from(remainder + b))
            } else {
                (Self::from(quotient), Self::from(remainder))
            };
        }
        let sign_b = divisor.signum();
        let (quotient, remainder) = self.with_big(|a| divisor.with_big(|b| a.div_rem(b)));
        let (quotient, remainder) = (Self::from_big(quotient), Self::from_big(remainder));
        if !remainder.is_zero() && remainder.signum() != sign_b {
            (quotient - Self::ONE, remainder + divisor.clone())
        } else {
            (quotient, remainder)
        }
    }

    /// Quotient and remainder, rounding to the nearest: twice the remainder is at most the divisor in absolute value.
    ///
    /// # Panics
    /// If `divisor` is zero.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Integer;
    /// let (quotient, remainder) = Integer::from(7).div_rem_nearest(&Integer::from(4));
    /// assert_eq!((quotient, remainder), (Integer::from(2), Integer::from(-1)));
    /// ```
    pub fn div_rem_nearest(&self, divisor: &Self) -> (Self, Self) {
        let (quotient, remainder) = self.div_rem_floor(divisor);
        let opposite = &remainder - divisor;
        if opposite.abs() < remainder.abs() {
            (quotient + Self::ONE, opposite)
        } else {
            (quotient, remainder)
        }
    }

    /// The quotient if `divisor` divides this, else `None`. Zero divides nothing but zero, with quotient 0.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Integer;
    /// assert_eq!(Integer::from(12).exact_quotient(&Integer::from(-3)), Some(Integer::from(-4)));
    /// assert_eq!(Integer::from(12).exact_quotient(&Integer::from(5)), None);
    /// ```
    pub fn exact_quotient(&self, divisor: &Self) -> Option<Self> {
        if divisor.is_zero() {
            return self.is_zero().then_some(Self::ZERO);
        }
        let (quotient, remainder) = self.div_rem_floor(divisor);
        remainder.is_zero().then_some(quotient)
    }

    /// Whether this divides `other`. Zero divides zero only.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Integer;
    /// assert!(Integer::from(-3).divides(&Integer::from(12)));
    /// ```
    pub fn divides(&self, other: &Self) -> bool {
        other.exact_quotient(self).is_some()
    }

    /// The greatest common divisor, not negative; gcd(0, 0) = 0.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Integer;
    /// assert_eq!(Integer::from(12).gcd(&Integer::from(-18)), Integer::from(6));
    /// ```
    #[must_use]
    pub fn gcd(&self, other: &Self) -> Self {
        if let (Repr::Small(a), Repr::Small(b)) = (&self.0, &other.0) {
            let (mut a, mut b) = (a.unsigned_abs(), b.unsigned_abs());
            while b != 0 {
                (a, b) = (b, a % b);
            }
            return match i64::try_from(a) {
                Ok(gcd) => Self::from(gcd),
                Err(_) => Self::from_big(IBig::from(a)),
            };
        }
        if self.is_zero() || other.is_zero() {
            return (self + other).abs();
        }
        Self::from_big(IBig::from(self.with_big(|a| other.with_big(|b| a.gcd(b)))))
    }

    /// $(g, x, y)$ with $g = \gcd(a, b) = x a + y b$, for `self` = a and `other` = b; g is not negative.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Integer;
    /// let (a, b) = (Integer::from(12), Integer::from(18));
    /// let (g, x, y) = a.extended_gcd(&b);
    /// assert_eq!(g, Integer::from(6));
    /// assert_eq!(&x * &a + &y * &b, g);
    /// ```
    pub fn extended_gcd(&self, other: &Self) -> (Self, Self, Self) {
        if self.is_zero() {
            return (other.abs(), Self::ZERO, Self::from(i64::from(other.signum())));
        }
        if other.is_zero() {
            return (self.abs(), Self::from(i64::from(self.signum())), Self::ZERO);
        }
        let (gcd, x, y) = self.with_big(|a| other.with_big(|b| a.gcd_ext(b)));
        (Self::from_big(IBig::from(gcd)), Self::from_big(x), Self::from_big(y))
    }
}

impl From<i64> for Integer {
    fn from(value: i64) -> Self {
        Self(Repr::Small(value))
    }
}

impl From<u64> for Integer {
    fn from(value: u64) -> Self {
        Self::from_big(IBig::from(value))
    }
}

impl From<i32> for Integer {
    fn from(value: i32) -> Self {
        Self(Repr::Small(i64::from(value)))
    }
}

impl Default for Integer {
    fn default() -> Self {
        Self::ZERO
    }
}

impl FromStr for Integer {
    type Err = crate::error::Error;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        if let Ok(small) = text.parse::<i64>() {
            return Ok(Self::from(small));
        }
        IBig::from_str(text)
            .map(Self::from_big)
            .map_err(|_| crate::error::Error::parse(format!("{text:?} is not an integer")))
    }
}

impl fmt::Display for Integer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match &self.0 {
            Repr::Small(value) => fmt::Display::fmt(value, f),
            Repr::Large(value) => fmt::Display::fmt(value, f),
        }
    }
}

impl fmt::Debug for Integer {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        fmt::Display::fmt(self, f)
    }
}

impl Ord for Integer {
    fn cmp(&self, other: &Self) -> Ordering {
        match (&self.0, &other.0) {
            (Repr::Small(a), Repr::Small(b)) => a.cmp(b),
            (Repr::Large(a), Repr::Large(b)) => a.cmp(b),
            // Beyond 64 bits the sign decides.
            (Repr::Small(_), Repr::Large(_)) => 0.cmp(&other.signum()),
            (Repr::Large(_), Repr::Small(_)) => self.signum().cmp(&0),
        }
    }
}

impl PartialOrd for Integer {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

macro_rules! operator {
    ($trait:ident, $method:ident, $checked:ident, $assign_trait:ident, $assign:ident) => {
        impl $trait<&Integer> for &Integer {
            type Output = Integer;
            fn $method(self, other: &Integer) -> Integer {
                if let (Repr::Small(a), Repr::Small(b)) = (&self.0, &other.0)
                    && let Some(value) = a.$checked(*b)
                {
                    return Integer::from(value);
                }
                Integer::from_big(self.with_big(|a| other.with_big(|b| $trait::$method(a, b))))
            }
        }
        impl $trait for Integer {
            type Output = Integer;
            fn $method(self, other: Integer) -> Integer {
                $trait::$method(&self, &other)
            }
        }
        impl $assign_trait<&Integer> for Integer {
            fn $assign(&mut self, other: &Integer) {
                *self = $trait::$method(&*self, other);
            }
        }
    };
}

operator!(Add, add, checked_add, AddAssign, add_assign);
operator!(Sub, sub, checked_sub, SubAssign, sub_assign);
operator!(Mul, mul, checked_mul, MulAssign, mul_assign);

impl Neg for &Integer {
    type Output = Integer;
    fn neg(self) -> Integer {
        match &self.0 {
            Repr::Small(value) if *value != i64::MIN => Integer::from(-value),
            _ => Integer::from_big(self.with_big(|a| -a)),
        }
    }
}

impl Neg for Integer {
    type Output = Integer;
    fn neg(self) -> Integer {
        -&self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn integer(value: i128) -> Integer {
        value.to_string().parse().unwrap()
    }

    /// Values on both sides of the 64-bit limit.
    fn values() -> impl Strategy<Value = i128> {
        prop_oneof![
            -20i128..20,
            any::<i64>().prop_map(i128::from),
            (i128::from(i64::MIN) * 2)..(i128::from(i64::MAX) * 2),
            Just(i128::from(i64::MIN)),
            Just(i128::from(i64::MAX)),
        ]
    }

    proptest! {
        #[test]
        fn arithmetic_agrees_with_128_bits(a in values(), b in values()) {
            let (x, y) = (integer(a), integer(b));
            prop_assert_eq!(&x + &y, integer(a + b));
            prop_assert_eq!(&x - &y, integer(a - b));
            if let Some(product) = a.checked_mul(b) {
                prop_assert_eq!(&x * &y, integer(product));
            }
            prop_assert_eq!(-&x, integer(-a));
            prop_assert_eq!(x.cmp(&y), a.cmp(&b));
            prop_assert_eq!(x.signum(), a.signum() as i32);
            prop_assert_eq!(x.to_i64(), i64::try_from(a).ok());
            prop_assert_eq!(x.bit_length(), (128 - a.unsigned_abs().leading_zeros()) as usize);
            if b != 0 {
                let (quotient, remainder) = x.div_rem_floor(&y);
                prop_assert_eq!(&(&(&quotient * &y) + &remainder), &x);
                prop_assert!(remainder.is_zero() || remainder.signum() == y.signum());
                prop_assert!(remainder.abs() < y.abs());
                let (quotient, remainder) = x.div_rem_nearest(&y);
                prop_assert_eq!(&(&(&quotient * &y) + &remainder), &x);
                prop_assert!(&remainder.abs() + &remainder.abs() <= y.abs());
            }
            let (gcd, s, t) = x.extended_gcd(&y);
            prop_assert_eq!(&gcd, &x.gcd(&y));
            prop_assert_eq!(&(&(&s * &x) + &(&t * &y)), &gcd);
            prop_assert!(gcd.signum() >= 0 && gcd.divides(&x) && gcd.divides(&y));
        }
    }
}
