//! Floating-point numbers with a bound on their error.

use std::cmp::Ordering;

/// The unit roundoff 2^-53.
const ROUNDOFF: f64 = f64::EPSILON / 2.0;

/// A number within `error` of `value`, as long as some hundred operations led to it. What leaves the range of numbers
/// has no sign.
#[derive(Clone, Copy, Debug)]
pub(super) struct Estimate {
    value: f64,
    error: f64,
}

impl Estimate {
    pub(super) fn new(value: f64, error: f64) -> Self {
        Self { value, error }
    }

    pub(super) fn difference(a: f64, b: f64) -> Self {
        let value = a - b;
        Self { value, error: ROUNDOFF * value.abs() }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        let value = self.value + other.value;
        Self { value, error: self.error + other.error + ROUNDOFF * value.abs() }
    }

    pub(super) fn minus(self, other: Self) -> Self {
        self.plus(Self { value: -other.value, ..other })
    }

    pub(super) fn times(self, other: Self) -> Self {
        let value = self.value * other.value;
        let inherited =
            self.value.abs() * other.error + self.error * other.value.abs() + self.error * other.error;
        // The last term is for products that are too small for their precision.
        Self { value, error: inherited + ROUNDOFF * value.abs() + f64::MIN_POSITIVE }
    }

    pub(super) fn value(self) -> f64 {
        self.value
    }

    /// A bound on the error that covers the rounding of the error.
    pub(super) fn bound(self) -> f64 {
        self.error * (1.0 + 1.0 / 1_099_511_627_776.0)
    }

    /// The sign, if the error leaves no doubt.
    pub(super) fn sign(self) -> Option<Ordering> {
        // Also false for what is not a number.
        (self.value.abs() > self.bound()).then(|| self.value.total_cmp(&0.0))
    }
}

#[cfg(test)]
mod tests {
    use super::super::Dyadic;
    use super::super::samples::coordinate;
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn values_lie_within_their_errors(numbers in prop::array::uniform4(coordinate())) {
            let [a, b, c, d] = numbers;
            let within = |exact: &Dyadic, found: Estimate| {
                if !found.value.is_finite() || !found.error.is_finite() {
                    return found.sign().is_none() || exact.sign() == found.sign().unwrap();
                }
                let miss = &Dyadic::from(found.value) - exact;
                let miss = if miss.sign().is_lt() { -&miss } else { miss };
                let bound = &Dyadic::from(found.error) * &Dyadic::from(1.0 + 1.0 / 1_099_511_627_776.0);
                !(&bound - &miss).sign().is_lt() && found.sign().is_none_or(|sign| sign == exact.sign())
            };
            let (x, y) = (Estimate::difference(a, b), Estimate::difference(c, d));
            let (p, q) = (&Dyadic::from(a) - &Dyadic::from(b), &Dyadic::from(c) - &Dyadic::from(d));
            prop_assert!(within(&p, x));
            prop_assert!(within(&(&p + &q), x.plus(y)));
            prop_assert!(within(&(&p - &q), x.minus(y)));
            prop_assert!(within(&(&p * &q), x.times(y)));
            prop_assert!(within(&(&(&p * &q) * &(&p - &q)), x.times(y).times(x.minus(y))));
        }
    }
}
