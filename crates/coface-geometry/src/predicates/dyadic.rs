//! Binary fractions of any size and precision.

use coface_algebra::Rational;
use dashu_int::ops::{BitTest, DivRem, UnsignedAbs};
use dashu_int::{IBig, UBig};
use dashu_ratio::RBig;
use std::cmp::Ordering;
use std::ops::{Add, Mul, Neg, Sub};

/// The number $m 2^e$. Sums and products are exact.
#[derive(Clone, Debug)]
pub struct Dyadic {
    mantissa: IBig,
    exponent: i64,
}

impl Dyadic {
    /// The order of this number and 0.
    #[doc(hidden)]
    pub fn sign(&self) -> Ordering {
        self.mantissa.cmp(&IBig::ZERO)
    }

    /// The mantissa that goes with a lower exponent.
    fn aligned(&self, exponent: i64) -> IBig {
        &self.mantissa << usize::try_from(self.exponent - exponent).expect("the exponent is lower")
    }

    /// The fraction `self / divisor`. The divisor is positive.
    #[doc(hidden)]
    pub fn quotient(&self, divisor: &Self) -> Rational {
        let shift = self.exponent - divisor.exponent;
        let [up, down] = [shift.max(0), (-shift).max(0)]
            .map(|shift| usize::try_from(shift).expect("shifts are not negative"));
        let fraction = RBig::from_parts_signed(&self.mantissa << up, &divisor.mantissa << down);
        Rational::from_big(fraction)
    }

    /// The floating-point number that is nearest to `self / divisor`. The divisor is positive.
    #[doc(hidden)]
    pub fn rounded_ratio(&self, divisor: &Self) -> f64 {
        self.rounded_quotient(divisor).0
    }

    /// The floating-point number that is nearest to `self / divisor`, a tie to the even one, and how the quotient
    /// compares with it. The divisor is positive.
    pub(crate) fn rounded_quotient(&self, divisor: &Self) -> (f64, Ordering) {
        const SMALLEST: i64 = -1022;
        let numerator = (&self.mantissa).unsigned_abs();
        if numerator == UBig::ZERO {
            return (0.0, Ordering::Equal);
        }
        let denominator = (&divisor.mantissa).unsigned_abs();
        let shift = (66 + denominator.bit_len()).saturating_sub(numerator.bit_len());
        let (quotient, remainder) = (numerator << shift).div_rem(denominator);
        let unit = self.exponent - divisor.exponent - shift as i64;
        // The quotient has at least 66 bits; as many are kept as a number of this size has.
        let bits = quotient.bit_len() as i64;
        let precision = 53 - (SMALLEST - (unit + bits - 1)).max(0);
        let dropped = usize::try_from(bits - precision).expect("more bits are computed than are kept");
        let kept = &quotient >> dropped;
        let half = quotient.bit(dropped - 1);
        let below_half =
            remainder != UBig::ZERO || quotient.trailing_zeros().is_some_and(|z| z < dropped - 1);
        let mantissa = u64::try_from(kept).expect("at most 53 bits are kept");
        let up = half && (below_half || mantissa % 2 == 1);
        let residue = match (up, half || below_half) {
            (true, _) => Ordering::Less,
            (false, true) => Ordering::Greater,
            (false, false) => Ordering::Equal,
        };
        let magnitude = times_power_of_two((mantissa + u64::from(up)) as f64, unit + dropped as i64);
        if self.sign().is_lt() { (-magnitude, residue.reverse()) } else { (magnitude, residue) }
    }
}

/// A number of 53 bits times a power of two no smaller than $2^{-1074}$; infinite beyond the range.
fn times_power_of_two(mantissa: f64, exponent: i64) -> f64 {
    let power = |e: i64| 2f64.powi(i32::try_from(e.clamp(-2000, 2000)).expect("the exponent is clamped"));
    match exponent {
        // 2^e is no normal number below -1022, and powi goes through its reciprocal.
        ..-1000 => mantissa * power(exponent + 500) * power(-500),
        1000.. => mantissa * power(1000) * power(exponent - 1000),
        _ => mantissa * power(exponent),
    }
}

impl From<f64> for Dyadic {
    /// The exact value of a finite number.
    fn from(x: f64) -> Self {
        let bits = x.to_bits();
        let biased = (bits >> 52 & 0x7ff) as i64;
        let fraction = bits & ((1 << 52) - 1);
        let (mantissa, exponent) =
            if biased == 0 { (fraction, -1074) } else { (fraction | 1 << 52, biased - 1075) };
        if mantissa == 0 {
            return Self { mantissa: IBig::ZERO, exponent: 0 };
        }
        let zeros = mantissa.trailing_zeros();
        let odd = (mantissa >> zeros) as i64;
        Self { mantissa: IBig::from(if x < 0.0 { -odd } else { odd }), exponent: exponent + i64::from(zeros) }
    }
}

impl Add for &Dyadic {
    type Output = Dyadic;
    fn add(self, other: &Dyadic) -> Dyadic {
        if self.sign().is_eq() {
            return other.clone();
        }
        if other.sign().is_eq() {
            return self.clone();
        }
        let exponent = self.exponent.min(other.exponent);
        Dyadic { mantissa: self.aligned(exponent) + other.aligned(exponent), exponent }
    }
}

impl Sub for &Dyadic {
    type Output = Dyadic;
    fn sub(self, other: &Dyadic) -> Dyadic {
        self + &-other
    }
}

impl Mul for &Dyadic {
    type Output = Dyadic;
    fn mul(self, other: &Dyadic) -> Dyadic {
        Dyadic { mantissa: &self.mantissa * &other.mantissa, exponent: self.exponent + other.exponent }
    }
}

impl Neg for &Dyadic {
    type Output = Dyadic;
    fn neg(self) -> Dyadic {
        Dyadic { mantissa: -&self.mantissa, exponent: self.exponent }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn ends_of_the_range_are_rounded() {
        let smallest = f64::from_bits(1);
        let quotient = |a: f64, b: f64| Dyadic::from(a).rounded_quotient(&Dyadic::from(b));
        assert_eq!(quotient(smallest, 2.0), (0.0, Ordering::Greater));
        assert_eq!(quotient(3.0 * smallest, 2.0), (2.0 * smallest, Ordering::Less));
        assert_eq!(quotient(-smallest, 4.0), (-0.0, Ordering::Less));
        assert_eq!(quotient(f64::MAX, smallest).0, f64::INFINITY);
        assert_eq!(quotient(f64::MAX, f64::MAX), (1.0, Ordering::Equal));
        assert_eq!(quotient(1.0, 3.0), (1.0 / 3.0, Ordering::Greater));
    }

    proptest! {
        /// Division of the processor rounds to nearest too.
        #[test]
        fn quotients_are_those_of_the_processor(a: f64, b: f64) {
            prop_assume!(a.is_finite() && b.is_finite() && b != 0.0);
            let (found, residue) = Dyadic::from(if b < 0.0 { -a } else { a }).rounded_quotient(&Dyadic::from(b.abs()));
            prop_assert_eq!(found, a / b);
            if found.is_finite() {
                let back = &Dyadic::from(found) * &Dyadic::from(b.abs());
                let a = Dyadic::from(if b < 0.0 { -a } else { a });
                prop_assert_eq!((&a - &back).sign(), residue);
            }
        }

        #[test]
        fn arithmetic_is_that_of_integers(
            (a, b) in (-1i64 << 25..1 << 25, -1i64 << 25..1 << 25), (s, t) in (0u32..100, 0u32..100)
        ) {
            let [x, y] = [(a, s), (b, t)].map(|(m, e)| Dyadic::from(m as f64 * 2f64.powi(e as i32 - 50)));
            let (m, n) = (IBig::from(a) << s as usize, IBig::from(b) << t as usize);
            prop_assert_eq!((&x - &y).sign(), m.cmp(&n));
            prop_assert_eq!((&x + &y).sign(), (&m + &n).cmp(&IBig::ZERO));
            let square = &(&x * &x) - &(&y * &y);
            prop_assert_eq!((&(&(&x + &y) * &(&x - &y)) - &square).sign(), Ordering::Equal);
        }
    }
}
