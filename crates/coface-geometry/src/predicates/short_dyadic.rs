//! Binary fractions of bounded length, which are faster than those of any size.

use std::cmp::Ordering;

/// 1024 bits: the product of some fifteen coordinates of one model.
const LIMBS: usize = 16;

/// The number $\pm m 2^e$, where m has up to 1024 bits; sums and products are exact. What gets longer is lost and has
/// no sign.
#[derive(Clone, Copy, Debug)]
pub(super) struct ShortDyadic {
    /// The mantissa, lowest limb first. Limbs from `length` on are zero, the one before is not.
    limbs: [u64; LIMBS],
    length: usize,
    exponent: i64,
    negative: bool,
}

const ZERO: ShortDyadic = ShortDyadic { limbs: [0; LIMBS], length: 0, exponent: 0, negative: false };

/// A number that was too long.
const LOST: ShortDyadic = ShortDyadic { length: usize::MAX, ..ZERO };

impl ShortDyadic {
    fn is_lost(&self) -> bool {
        self.length == usize::MAX
    }

    /// The number with this magnitude of at most 128 bits.
    #[allow(clippy::cast_possible_truncation, reason = "the low half of a 128-bit number is taken")]
    fn from_magnitude(magnitude: u128, exponent: i64, negative: bool) -> Self {
        let [low, high] = [magnitude as u64, (magnitude >> 64) as u64];
        let length = usize::from(magnitude != 0) + usize::from(high != 0);
        let mut number = Self { length, exponent, negative, ..ZERO };
        (number.limbs[0], number.limbs[1]) = (low, high);
        number
    }

    /// The sum of two numbers, the second with the sign that is given.
    #[allow(clippy::cast_possible_truncation, reason = "a remainder of 64 fits")]
    fn sum(&self, other: &Self, other_negative: bool) -> Self {
        if self.is_lost() || other.is_lost() {
            return LOST;
        }
        if other.length == 0 {
            return *self;
        }
        if self.length == 0 {
            return Self { negative: other_negative, ..*other };
        }
        // The one of the larger exponent is moved, and comes second.
        let ((still, negative), (moved, moved_negative)) = if self.exponent <= other.exponent {
            ((self, self.negative), (other, other_negative))
        } else {
            ((other, other_negative), (self, self.negative))
        };
        let shift = moved.exponent - still.exponent;
        let (whole, bits) = (usize::try_from(shift / 64).unwrap_or(LIMBS), (shift % 64) as u32);
        let length = still.length.max(moved.length.saturating_add(whole + usize::from(bits > 0)));
        if length > LIMBS {
            return LOST;
        }
        let mut found = Self { length, exponent: still.exponent, negative, ..ZERO };
        found.limbs[..still.length].copy_from_slice(&still.limbs[..still.length]);
        let carry = if negative == moved_negative {
            found.add(&moved.limbs[..moved.length], whole, bits)
        } else {
            let borrow = found.subtract(&moved.limbs[..moved.length], whole, bits);
            if borrow {
                found.negate();
            }
            false
        };
        if carry {
            if length == LIMBS {
                return LOST;
            }
            found.limbs[length] = 1;
            found.length += 1;
        }
        while found.length > 0 && found.limbs[found.length - 1] == 0 {
            found.length -= 1;
        }
        found
    }

    /// Adds shifted limbs to the first `length`; whether a one is carried out of these.
    #[allow(clippy::cast_possible_truncation, reason = "the low half of a 128-bit number is taken")]
    fn add(&mut self, limbs: &[u64], whole: usize, bits: u32) -> bool {
        let (mut carry, mut left_over) = (false, 0);
        let rest = &mut self.limbs[whole..self.length];
        for (i, limb) in rest.iter_mut().enumerate() {
            let wide = u128::from(limbs.get(i).copied().unwrap_or(0)) << bits;
            let (sum, first) = limb.overflowing_add(wide as u64 | left_over);
            let (sum, second) = sum.overflowing_add(u64::from(carry));
            (*limb, carry, left_over) = (sum, first || second, (wide >> 64) as u64);
        }
        carry
    }

    /// Subtracts shifted limbs from the first `length`; whether one is borrowed from beyond these.
    #[allow(clippy::cast_possible_truncation, reason = "the low half of a 128-bit number is taken")]
    fn subtract(&mut self, limbs: &[u64], whole: usize, bits: u32) -> bool {
        let (mut borrow, mut left_over) = (false, 0);
        let rest = &mut self.limbs[whole..self.length];
        for (i, limb) in rest.iter_mut().enumerate() {
            let wide = u128::from(limbs.get(i).copied().unwrap_or(0)) << bits;
            let (difference, first) = limb.overflowing_sub(wide as u64 | left_over);
            let (difference, second) = difference.overflowing_sub(u64::from(borrow));
            (*limb, borrow, left_over) = (difference, first || second, (wide >> 64) as u64);
        }
        borrow
    }

    /// The negative of a mantissa that wrapped.
    fn negate(&mut self) {
        let mut carry = true;
        for limb in &mut self.limbs[..self.length] {
            (*limb, carry) = (!*limb).overflowing_add(u64::from(carry));
        }
        self.negative = !self.negative;
    }
}

/// The odd mantissa, exponent and sign of a finite number: those with few digits stay short.
fn parts(x: f64) -> (u64, i64, bool) {
    let bits = x.to_bits();
    let biased = (bits >> 52 & 0x7ff) as i64;
    let fraction = bits & ((1 << 52) - 1);
    let (mantissa, exponent) =
        if biased == 0 { (fraction, -1074) } else { (fraction | 1 << 52, biased - 1075) };
    if mantissa == 0 {
        return (0, 0, false);
    }
    let zeros = mantissa.trailing_zeros();
    (mantissa >> zeros, exponent + i64::from(zeros), x < 0.0)
}

impl From<f64> for ShortDyadic {
    /// The exact value of a finite number.
    fn from(x: f64) -> Self {
        let (mantissa, exponent, negative) = parts(x);
        Self::from_magnitude(u128::from(mantissa), exponent, negative)
    }
}

impl ShortDyadic {
    /// The exact difference of two numbers.
    pub(super) fn difference(a: f64, b: f64) -> Self {
        let ((m, e, a_negative), (n, f, b_negative)) = (parts(a), parts(b));
        if n == 0 || m == 0 || (e - f).abs() > 72 {
            return Self::from(a).minus(&Self::from(b));
        }
        let exponent = e.min(f);
        let signed = |mantissa: u64, shift: i64, negative: bool| {
            let magnitude = i128::from(mantissa) << shift;
            if negative { -magnitude } else { magnitude }
        };
        let difference = signed(m, e - exponent, a_negative) - signed(n, f - exponent, b_negative);
        Self::from_magnitude(difference.unsigned_abs(), exponent, difference < 0)
    }

    pub(super) fn plus(&self, other: &Self) -> Self {
        self.sum(other, other.negative)
    }

    pub(super) fn minus(&self, other: &Self) -> Self {
        self.sum(other, !other.negative)
    }

    #[allow(clippy::cast_possible_truncation, reason = "the low half of a 128-bit number is taken")]
    pub(super) fn times(&self, other: &Self) -> Self {
        if self.is_lost() || other.is_lost() {
            return LOST;
        }
        if self.length == 0 || other.length == 0 {
            return ZERO;
        }
        let length = self.length + other.length;
        if length > LIMBS {
            return LOST;
        }
        let mut product = Self {
            length,
            exponent: self.exponent + other.exponent,
            negative: self.negative != other.negative,
            ..ZERO
        };
        for (i, &a) in self.limbs[..self.length].iter().enumerate() {
            let mut carry = 0;
            let row = &mut product.limbs[i..=i + other.length];
            for (limb, &b) in row.iter_mut().zip(&other.limbs[..other.length]) {
                let wide = u128::from(a) * u128::from(b) + u128::from(*limb) + u128::from(carry);
                *limb = wide as u64;
                carry = (wide >> 64) as u64;
            }
            row[other.length] = carry;
        }
        if product.limbs[length - 1] == 0 {
            product.length -= 1;
        }
        product
    }

    /// The order of this number and 0; `None` for a number that is lost.
    pub(super) fn certain_sign(&self) -> Option<Ordering> {
        match (self.length, self.negative) {
            (usize::MAX, _) => None,
            (0, _) => Some(Ordering::Equal),
            (_, true) => Some(Ordering::Less),
            (_, false) => Some(Ordering::Greater),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::Dyadic;
    use super::super::samples::coordinate;
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(1000))]
        /// A long way through sums and products gives the same number, seen by what is left of it without the exact
        /// one.
        #[test]
        fn arithmetic_is_that_of_numbers_of_any_size(
            numbers in prop::collection::vec((coordinate(), coordinate(), 0usize..4, 0usize..6), 1..12)
        ) {
            let mut here = vec![ShortDyadic::difference(1.0, 0.0)];
            let mut plain = vec![Dyadic::from(1.0)];
            for (a, b, operation, back) in numbers {
                let (x, p) = (ShortDyadic::difference(a, b), &Dyadic::from(a) - &Dyadic::from(b));
                prop_assert_eq!(x.certain_sign().unwrap_or(p.sign()), p.sign());
                let (y, q) = (here[here.len() - 1], plain[plain.len() - 1].clone());
                let from = here.len() - 1 - back.min(here.len() - 1);
                let (z, r) = (here[from], plain[from].clone());
                let (found, exact) = match operation {
                    0 => (y.plus(&x), &q + &p),
                    1 => (x.minus(&y), &p - &q),
                    2 => (y.times(&x).minus(&z), &(&q * &p) - &r),
                    _ => (y.times(&z).plus(&x), &(&q * &r) + &p),
                };
                prop_assert!(found.certain_sign().is_none_or(|sign| sign == exact.sign()));
                if !found.is_lost() {
                    prop_assert!(found.length == 0 || found.limbs[found.length - 1] != 0);
                    prop_assert!(found.limbs[found.length..].iter().all(|&limb| limb == 0));
                    prop_assert_eq!(found.to_dyadic().compare(&exact), Ordering::Equal);
                }
                here.push(found);
                plain.push(exact);
            }
        }
    }

    impl ShortDyadic {
        fn to_dyadic(self) -> Dyadic {
            let power = |e: i64| {
                // A power of two in steps that are numbers.
                let step = Dyadic::from(2f64.powi(if e < 0 { -500 } else { 500 }));
                let rest = Dyadic::from(2f64.powi((e % 500) as i32));
                (0..e.abs() / 500).fold(rest, |power, _| &power * &step)
            };
            let magnitude = (0..self.length).fold(Dyadic::from(0.0), |sum, i| {
                let halves = [self.limbs[i] >> 32, self.limbs[i] & 0xffff_ffff];
                let at = self.exponent + 64 * i as i64;
                let [high, low] = halves.map(|half| Dyadic::from(half as f64));
                &sum + &(&(&high * &power(at + 32)) + &(&low * &power(at)))
            });
            if self.negative { -&magnitude } else { magnitude }
        }
    }

    impl Dyadic {
        fn compare(&self, other: &Self) -> Ordering {
            (self - other).sign()
        }
    }

    #[test]
    fn what_is_too_long_has_no_sign() {
        let wide = ShortDyadic::difference(1e300, 1e-300);
        assert_eq!(wide.certain_sign(), None);
        let long = (0..40).fold(ShortDyadic::from(0.1), |power, _| power.times(&ShortDyadic::from(0.1)));
        assert_eq!(long.certain_sign(), None);
        assert_eq!(long.times(&ZERO).certain_sign(), None);
    }
}
