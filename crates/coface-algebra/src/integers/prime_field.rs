//! Arithmetic of prime fields on the entries of sparse columns, where zero is never stored.

use crate::integers::integer::Integer;

/// A prime field, by what elimination needs of its nonzero elements.
pub trait Field {
    /// A nonzero element. For the field of two elements there is just one, which takes no memory.
    type Unit: Copy + Ord;

    /// The class of an integer; `None` for zero.
    fn unit(&self, value: i32) -> Option<Self::Unit>;

    /// The sum; `None` for zero.
    fn sum(&self, a: Self::Unit, b: Self::Unit) -> Option<Self::Unit>;

    /// The product.
    fn product(&self, a: Self::Unit, b: Self::Unit) -> Self::Unit;

    /// The factor x with a + x b = 0.
    fn eliminator(&self, a: Self::Unit, b: Self::Unit) -> Self::Unit;
}

/// The field of two elements.
#[derive(Clone, Copy, Debug)]
pub struct Binary;

impl Field for Binary {
    type Unit = ();

    fn unit(&self, value: i32) -> Option<()> {
        (value % 2 != 0).then_some(())
    }

    fn sum(&self, (): (), (): ()) -> Option<()> {
        None
    }

    fn product(&self, (): (), (): ()) {}

    fn eliminator(&self, (): (), (): ()) {}
}

/// The field of p elements, p an odd prime below 2^31.
#[derive(Clone, Copy, Debug)]
pub struct Odd {
    prime: u32,
}

impl Odd {
    /// The field of this prime.
    #[doc(hidden)]
    pub fn new(prime: u32) -> Self {
        Self { prime }
    }

    /// The class of an integer of any size; `None` for zero.
    #[doc(hidden)]
    #[allow(clippy::cast_possible_truncation, reason = "residues are below the prime, which has 31 bits")]
    pub fn class(&self, value: &Integer) -> Option<u32> {
        let rest = value.div_rem_floor(&Integer::from(i64::from(self.prime))).1.to_i64();
        rest.map(|rest| rest as u32).filter(|&rest| rest != 0)
    }

    /// The inverse.
    #[allow(clippy::cast_possible_truncation, reason = "residues are below the prime, which has 31 bits")]
    pub(crate) fn inverse(&self, a: u32) -> u32 {
        // Almost all entries of boundary matrices are units of Z.
        if a == 1 || a == self.prime - 1 {
            return a;
        }
        // Invariant of Euclid's algorithm: x a = r and y a = s modulo p.
        let (mut r, mut s) = (i64::from(a), i64::from(self.prime));
        let (mut x, mut y) = (1, 0);
        while s != 0 {
            let quotient = r / s;
            (r, s) = (s, r - quotient * s);
            (x, y) = (y, x - quotient * y);
        }
        x.rem_euclid(i64::from(self.prime)) as u32
    }
}

impl Field for Odd {
    type Unit = u32;

    #[allow(clippy::cast_possible_truncation, reason = "residues are below the prime, which has 31 bits")]
    fn unit(&self, value: i32) -> Option<u32> {
        let rest = i64::from(value).rem_euclid(i64::from(self.prime));
        (rest != 0).then_some(rest as u32)
    }

    fn sum(&self, a: u32, b: u32) -> Option<u32> {
        // Below 2^32, as the prime is below 2^31.
        let sum = a + b;
        let sum = if sum >= self.prime { sum - self.prime } else { sum };
        (sum != 0).then_some(sum)
    }

    #[allow(clippy::cast_possible_truncation, reason = "residues are below the prime, which has 31 bits")]
    fn product(&self, a: u32, b: u32) -> u32 {
        (u64::from(a) * u64::from(b) % u64::from(self.prime)) as u32
    }

    fn eliminator(&self, a: u32, b: u32) -> u32 {
        self.product(self.prime - a, self.inverse(b))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn an_eliminator_eliminates(
            a in 1i32.., b in 1i32.., prime in prop::sample::select(vec![3u32, 5, 65_537, 2_147_483_647]),
        ) {
            let field = Odd::new(prime);
            let (Some(a), Some(b)) = (field.unit(a), field.unit(-b)) else { return Ok(()) };
            prop_assert_eq!(field.sum(a, field.product(field.eliminator(a, b), b)), None);
            prop_assert_eq!(field.product(b, field.inverse(b)), 1);
        }
    }

    #[test]
    fn even_entries_vanish_over_two_elements() {
        assert_eq!([-2, -1, 0, 3].map(|x| Binary.unit(x).is_some()), [false, true, false, true]);
    }
}
