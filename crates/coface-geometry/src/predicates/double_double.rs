//! Numbers of twice the usual precision with a bound on their error.

/// Whether products of four differences of such numbers, and the errors of those products, stay in the range of
/// ordinary numbers.
pub(super) fn is_ordinary(x: f64) -> bool {
    const SMALLEST: f64 = f64::from_bits((1023 - 150) << 52);
    const LARGEST: f64 = f64::from_bits((1023 + 150) << 52);
    x == 0.0 || (SMALLEST..=LARGEST).contains(&x.abs())
}

/// The rounded sum of two numbers and what rounding took away.
fn two_sum(a: f64, b: f64) -> [f64; 2] {
    let sum = a + b;
    let from_b = sum - a;
    [sum, (a - (sum - from_b)) + (b - from_b)]
}

/// The same for `|a| >= |b|`.
fn quick_two_sum(a: f64, b: f64) -> [f64; 2] {
    let sum = a + b;
    [sum, b - (sum - a)]
}

/// The two halves of a number, of 26 bits each.
fn split(a: f64) -> [f64; 2] {
    let shifted = a * 134_217_729.0;
    let high = shifted - (shifted - a);
    [high, a - high]
}

/// The rounded product of two numbers and what rounding took away.
fn two_product(a: f64, b: f64) -> [f64; 2] {
    let product = a * b;
    let ([a_high, a_low], [b_high, b_low]) = (split(a), split(b));
    [product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low]
}

/// A number within `error` of `high + low`. What leaves the range of numbers is not a number and has no sign.
///
/// An error of zero says that the value is exact: sums and products of small integers are.
///
/// # References
/// M. Joldes, J.-M. Muller, V. Popescu, *Tight and rigorous error bounds for basic building blocks of double-word
/// arithmetic* (2017): sums are within 3, products within 7, quotients within 15 squares of the unit roundoff 2^-53.
/// The bounds here are at least twice as wide, which covers their own rounding.
#[derive(Clone, Copy, Debug)]
pub(super) struct Approximation {
    pub(super) high: f64,
    pub(super) low: f64,
    pub(super) error: f64,
}

/// Sixteen squares of the unit roundoff.
const BOUND: f64 = f64::from_bits((1023 - 102) << 52);

/// Products below this size may lose what is too small to be a number.
const SMALL: f64 = f64::from_bits((1023 - 850) << 52);

impl Approximation {
    /// The number `high + low`, known within `error`; `high` is the nearest number to the sum.
    pub(super) fn known(high: f64, low: f64, error: f64) -> Self {
        Self { high, low, error }
    }

    /// A number that is known within `error`.
    pub(super) fn new(value: f64, error: f64) -> Self {
        Self { high: value, low: 0.0, error }
    }

    /// A number below and one above all that may be added to `high` to have the number that is meant: one number where
    /// it is known exactly. Sums of `low` and `error` may be rounded inward, so they are not enough where a half of the
    /// last digit decides.
    pub(super) fn rest(self) -> [f64; 2] {
        if self.error == 0.0 {
            return [self.low; 2];
        }
        let error = widened(self.error);
        [(self.low - error).next_down(), (self.low + error).next_up()]
    }

    /// The exact difference of two numbers.
    pub(super) fn difference(a: f64, b: f64) -> Self {
        let [high, low] = two_sum(a, -b);
        Self { high, low, error: 0.0 }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        let [sum, lost] = two_sum(self.high, other.high);
        let [low_sum, low_lost] = two_sum(self.low, other.low);
        let [lost, first_rest] = two_sum(lost, low_sum);
        let [sum, lost] = quick_two_sum(sum, lost);
        let [lost, second_rest] = two_sum(lost, low_lost);
        let [high, low] = quick_two_sum(sum, lost);
        // Nothing but the two rests is lost, so that sums of small integers stay exact.
        Self { high, low, error: widened(self.error + other.error + first_rest.abs() + second_rest.abs()) }
    }

    pub(super) fn minus(self, other: Self) -> Self {
        self.plus(Self { high: -other.high, low: -other.low, error: other.error })
    }

    pub(super) fn times(self, other: Self) -> Self {
        let [product, mut lost] = two_product(self.high, other.high);
        lost += self.high * other.low + self.low * other.high;
        let [high, low] = quick_two_sum(product, lost);
        let mut error = 0.0;
        if self.error != 0.0 || other.error != 0.0 {
            let size = |x: Self| x.high.abs() * (1.0 + f64::EPSILON);
            let inherited = size(self) * other.error + size(other) * self.error + self.error * other.error;
            error = widened(inherited) + f64::MIN_POSITIVE;
        }
        if self.low != 0.0 || other.low != 0.0 {
            error += BOUND * high.abs();
        }
        // Products that are too small for their precision.
        if high.abs() < SMALL && self.high != 0.0 && other.high != 0.0 {
            error += f64::MIN_POSITIVE;
        }
        Self { high, low, error }
    }

    /// The quotient; `None` if the divisor may be small against its error.
    pub(super) fn over(self, divisor: Self) -> Option<Self> {
        let certain = divisor.high.abs() * 0.5;
        // Also false for what is not a number.
        if divisor.error < certain {
            let first = self.high / divisor.high;
            if self.high != 0.0 && (self.high.abs() < SMALL || first.abs() < SMALL) {
                return None;
            }
            let exact = |x: f64| Self { high: x, low: 0.0, error: 0.0 };
            let rest = self.minus(divisor.times(exact(first)));
            if rest.high == 0.0 && rest.error == 0.0 {
                return Some(exact(first));
            }
            let second = rest.high / divisor.high;
            let rest = rest.minus(divisor.times(exact(second)));
            let third = rest.high / divisor.high;
            let [high, low] = quick_two_sum(first, second);
            let quotient = Self { high, low, error: 0.0 }.plus(exact(third));
            let inherited = (self.error + quotient.high.abs() * divisor.error) / certain;
            let error = widened(inherited) + 4.0 * BOUND * quotient.high.abs() + f64::MIN_POSITIVE;
            return Some(Self { error, ..quotient });
        }
        None
    }

    /// The sign, if the error leaves no doubt.
    pub(super) fn sign(self) -> Option<std::cmp::Ordering> {
        if self.error == 0.0 {
            return if (self.high + self.low).is_finite() { self.high.partial_cmp(&0.0) } else { None };
        }
        // `low` is at most half a unit of `high`; the sum has the sign of `high`.
        (self.high.abs() - self.low.abs() > self.error).then(|| self.high.total_cmp(&0.0))
    }
}

/// A bound that covers the rounding of its own computation.
pub(super) fn widened(bound: f64) -> f64 {
    bound * (1.0 + 1.0 / 1024.0)
}

#[cfg(test)]
mod tests {
    use super::super::Dyadic;
    use super::*;
    use proptest::prelude::*;

    fn exact(a: Approximation) -> Dyadic {
        &Dyadic::from(a.high) + &Dyadic::from(a.low)
    }

    fn number() -> impl Strategy<Value = f64> {
        (any::<i64>(), -40i32..40).prop_map(|(mantissa, exponent)| mantissa as f64 * 2f64.powi(exponent))
    }

    proptest! {
        #[test]
        fn values_lie_within_their_errors((a, b, c, d) in (number(), number(), number(), number())) {
            let within = |value: &Dyadic, found: Approximation| {
                let miss = &exact(found) - value;
                let miss = if miss.sign().is_lt() { -&miss } else { miss };
                !(&Dyadic::from(found.error) - &miss).sign().is_lt()
            };
            let (x, y) = (Approximation::difference(a, b), Approximation::difference(c, d));
            let (p, q) = (&Dyadic::from(a) - &Dyadic::from(b), &Dyadic::from(c) - &Dyadic::from(d));
            prop_assert!(within(&p, x) && x.error == 0.0);
            prop_assert!(within(&(&p + &q), x.plus(y)));
            prop_assert!(within(&(&p - &q), x.minus(y)));
            let product = x.times(y);
            prop_assert!(within(&(&p * &q), product));
            prop_assert!(within(&(&(&p * &q) * &(&p - &q)), product.times(x.minus(y))));
            if let Some(quotient) = product.over(y.plus(x)) {
                // |xy / (x + y) - z| <= e, multiplied out.
                let sum = &p + &q;
                let miss = &(&exact(quotient) * &sum) - &(&p * &q);
                let bound = &Dyadic::from(quotient.error) * &sum;
                prop_assert!(!(&(&bound * &bound) - &(&miss * &miss)).sign().is_lt());
            }
            if let Some(sign) = product.sign() {
                prop_assert_eq!(sign, (&p * &q).sign());
            }
        }
    }
}
