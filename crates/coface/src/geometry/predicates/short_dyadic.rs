//! Binary fractions of bounded length, quicker than those of any size.

use super::arithmetic::Arithmetic;
use std::cmp::Ordering;

/// 1536 bits: the product of some twenty coordinates of one model.
const LIMBS: usize = 24;

/// The number $\pm m 2^e$, where m has up to 1536 bits; sums and products are exact. What gets longer is lost and has no sign.
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

    /// The mantissa that goes with a lower exponent; `None` if it is too long.
    fn aligned(&self, exponent: i64) -> Option<Self> {
        let shift = self.exponent - exponent;
        if shift == 0 {
            return Some(*self);
        }
        let (whole, bits) = ((shift / 64) as usize, (shift % 64) as u32);
        if self.length + whole >= LIMBS {
            return None;
        }
        let mut moved = Self { exponent, negative: self.negative, ..ZERO };
        let mut carry = 0;
        for (i, &limb) in self.limbs[..self.length].iter().enumerate() {
            let wide = u128::from(limb) << bits;
            moved.limbs[i + whole] = wide as u64 | carry;
            carry = (wide >> 64) as u64;
        }
        moved.limbs[self.length + whole] = carry;
        moved.length = self.length + whole + usize::from(carry != 0);
        Some(moved)
    }

    /// The sum of two numbers, the second with the sign that is given.
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
        let exponent = self.exponent.min(other.exponent);
        let (Some(a), Some(b)) = (self.aligned(exponent), other.aligned(exponent)) else { return LOST };
        if a.negative == other_negative {
            return a.plus_magnitude(&b);
        }
        match a.compare_magnitude(&b) {
            Ordering::Equal => ZERO,
            Ordering::Greater => a.minus_magnitude(&b),
            Ordering::Less => Self { negative: other_negative, ..b }.minus_magnitude(&a),
        }
    }

    fn compare_magnitude(&self, other: &Self) -> Ordering {
        self.length.cmp(&other.length).then_with(|| {
            self.limbs[..self.length].iter().rev().cmp(other.limbs[..other.length].iter().rev())
        })
    }

    fn plus_magnitude(mut self, other: &Self) -> Self {
        let length = self.length.max(other.length);
        let mut carry = false;
        for (limb, &more) in self.limbs[..length].iter_mut().zip(&other.limbs[..length]) {
            let (sum, first) = limb.overflowing_add(more);
            let (sum, second) = sum.overflowing_add(u64::from(carry));
            (*limb, carry) = (sum, first || second);
        }
        self.length = length;
        if carry {
            if length == LIMBS {
                return LOST;
            }
            self.limbs[length] = 1;
            self.length += 1;
        }
        self
    }

    /// The difference to a number that is not larger.
    fn minus_magnitude(mut self, other: &Self) -> Self {
        let mut borrow = false;
        let length = self.length;
        for (limb, &less) in self.limbs[..length].iter_mut().zip(&other.limbs[..length]) {
            let (rest, first) = limb.overflowing_sub(less);
            let (rest, second) = rest.overflowing_sub(u64::from(borrow));
            (*limb, borrow) = (rest, first || second);
        }
        while self.length > 0 && self.limbs[self.length - 1] == 0 {
            self.length -= 1;
        }
        self
    }
}

impl From<f64> for ShortDyadic {
    /// The exact value of a finite number.
    fn from(x: f64) -> Self {
        let bits = x.to_bits();
        let biased = (bits >> 52 & 0x7ff) as i64;
        let fraction = bits & ((1 << 52) - 1);
        let (mantissa, exponent) =
            if biased == 0 { (fraction, -1074) } else { (fraction | 1 << 52, biased - 1075) };
        if mantissa == 0 {
            return ZERO;
        }
        // Integers and other numbers with few digits stay short.
        let zeros = mantissa.trailing_zeros();
        let mut number = Self { length: 1, exponent: exponent + i64::from(zeros), negative: x < 0.0, ..ZERO };
        number.limbs[0] = mantissa >> zeros;
        number
    }
}

impl Arithmetic for ShortDyadic {
    fn difference(a: f64, b: f64) -> Self {
        Self::from(a).minus(&Self::from(b))
    }

    fn plus(&self, other: &Self) -> Self {
        self.sum(other, other.negative)
    }

    fn minus(&self, other: &Self) -> Self {
        self.sum(other, !other.negative)
    }

    fn times(&self, other: &Self) -> Self {
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

    fn certain_sign(&self) -> Option<Ordering> {
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
        /// A long way through sums and products gives the same number, seen by what is left of it without the exact one.
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
