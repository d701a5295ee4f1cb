//! Numbers of twice the usual precision that know how wrong they can be.

/// Whether products of four differences of such numbers, and the errors of those products, stay in the range of ordinary
/// numbers.
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

/// A number within `error` of `high + low`.
///
/// All inputs must be ordinary ([`is_ordinary`]) and at most four of them multiplied.
///
/// # References
/// M. Joldes, J.-M. Muller, V. Popescu, *Tight and rigorous error bounds for basic building blocks of double-word
/// arithmetic* (2017): sums are within 3, products within 7, quotients within 15 squares of the unit roundoff 2^-53. The
/// bounds here are at least twice as wide, which covers their own rounding.
#[derive(Clone, Copy, Debug)]
pub(super) struct Approximation {
    pub(super) high: f64,
    pub(super) low: f64,
    pub(super) error: f64,
}

/// Sixteen squares of the unit roundoff.
const BOUND: f64 = f64::from_bits((1023 - 102) << 52);

impl Approximation {
    /// A number that is known within `error`.
    pub(super) fn new(value: f64, error: f64) -> Self {
        Self { high: value, low: 0.0, error }
    }

    /// The exact difference of two numbers.
    pub(super) fn difference(a: f64, b: f64) -> Self {
        let [high, low] = two_sum(a, -b);
        Self { high, low, error: 0.0 }
    }

    pub(super) fn plus(self, other: Self) -> Self {
        let [sum, mut lost] = two_sum(self.high, other.high);
        let [low_sum, low_lost] = two_sum(self.low, other.low);
        lost += low_sum;
        let [sum, mut lost] = quick_two_sum(sum, lost);
        lost += low_lost;
        let [high, low] = quick_two_sum(sum, lost);
        Self { high, low, error: widened(self.error + other.error) + BOUND * high.abs() }
    }

    pub(super) fn minus(self, other: Self) -> Self {
        self.plus(Self { high: -other.high, low: -other.low, error: other.error })
    }

    pub(super) fn times(self, other: Self) -> Self {
        let [product, mut lost] = two_product(self.high, other.high);
        lost += self.high * other.low + self.low * other.high;
        let [high, low] = quick_two_sum(product, lost);
        let inherited =
            self.high.abs() * other.error + other.high.abs() * self.error + self.error * other.error;
        Self { high, low, error: widened(inherited) + BOUND * high.abs() }
    }

    /// The quotient; `None` if the divisor may be small against its error.
    pub(super) fn over(self, divisor: Self) -> Option<Self> {
        let certain = divisor.high.abs() * 0.5;
        // Also false for what is not a number.
        if divisor.error < certain {
            let first = self.high / divisor.high;
            let exact = |x: f64| Self { high: x, low: 0.0, error: 0.0 };
            let rest = self.minus(divisor.times(exact(first)));
            let second = rest.high / divisor.high;
            let rest = rest.minus(divisor.times(exact(second)));
            let third = rest.high / divisor.high;
            let [high, low] = quick_two_sum(first, second);
            let quotient = Self { high, low, error: 0.0 }.plus(exact(third));
            let inherited = (self.error + quotient.high.abs() * divisor.error) / certain;
            return Some(Self { error: widened(inherited) + 4.0 * BOUND * quotient.high.abs(), ..quotient });
        }
        None
    }

    /// The sign, if the error leaves no doubt.
    pub(super) fn sign(self) -> Option<std::cmp::Ordering> {
        // `low` is at most half a unit of `high`; the sum has the sign of `high`.
        (self.high.abs() - self.low.abs() > self.error).then(|| self.high.total_cmp(&0.0))
    }
}

/// A bound that covers the rounding of its own computation.
fn widened(bound: f64) -> f64 {
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
