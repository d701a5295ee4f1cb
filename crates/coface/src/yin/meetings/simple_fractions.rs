//! Cubic pieces that touch, or are parts of one cubic, at parameters that are simple fractions: by exact arithmetic.

use super::common_end::{Coefficients, is_alone, power_coefficients};
use crate::geometry::predicates::Dyadic;

/// Fractions have denominators up to this one.
const LARGEST_DENOMINATOR: f64 = 4096.0;

/// A fraction of whole numbers.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Fraction {
    numerator: f64,
    denominator: f64,
}

impl Fraction {
    /// The first convergent of the continued fraction of a number that is within a distance of it, if its denominator is small. Any
    /// fraction with denominator q that is nearer than $1 / (2 q^2)$ is a convergent.
    pub(super) fn near(x: f64, distance: f64) -> Option<Self> {
        let [mut before, mut last] = [[0.0, 1.0], [1.0, 0.0]];
        let mut rest = x;
        loop {
            let whole = rest.floor();
            [before, last] = [last, [0, 1].map(|k| whole * last[k] + before[k])];
            let [numerator, denominator] = last;
            // Also for what is not a number.
            if !(denominator.abs() <= LARGEST_DENOMINATOR && numerator.abs() <= 2.0 * LARGEST_DENOMINATOR) {
                return None;
            }
            if (numerator / denominator - x).abs() <= distance {
                return Some(Self { numerator, denominator });
            }
            rest = 1.0 / (rest - whole);
        }
    }

    /// The nearest number.
    pub(super) fn value(self) -> f64 {
        self.numerator / self.denominator
    }

    fn parts(self) -> [Dyadic; 2] {
        [self.numerator, self.denominator].map(Dyadic::from)
    }
}

/// A number to a power.
fn power(x: &Dyadic, exponent: usize) -> Dyadic {
    (0..exponent).fold(Dyadic::from(1.0), |product, _| &product * x)
}

/// The power coefficients of a coordinate of a cubic in the parameter from p/q on, times the cube of q.
fn coefficients_from(controls: [f64; 4], at: Fraction) -> Coefficients {
    let [p, q] = at.parts();
    let own = power_coefficients(controls, 0.0);
    (0..4usize)
        .map(|k| {
            (k..4).fold(Dyadic::from(0.0), |sum, j| {
                let binomial =
                    Dyadic::from((0..k).fold(1.0, |product, i| product * (j - i) as f64 / (i + 1) as f64));
                let factor = &power(&p, j - k) * &power(&q, 3 + k - j);
                &sum + &(&(&binomial * &factor) * &own[j])
            })
        })
        .collect()
}

fn scaled(coefficients: &[Dyadic], factor: &Dyadic) -> Coefficients {
    coefficients.iter().map(|c| c * factor).collect()
}

fn axis_of(controls: &[[f64; 2]; 4], axis: usize) -> [f64; 4] {
    controls.map(|point| point[axis])
}

/// Whether two cubic pieces have, for certain, the point with these parameters in common, and no other one whose parameter on the first
/// differs from this by up to `reach`.
///
/// Whether the points are one is decided exactly; then the resultant, with the multiple root divided out, has none so near.
pub(super) fn meet_alone([a, b]: [&[[f64; 2]; 4]; 2], [at_a, at_b]: [Fraction; 2], reach: f64) -> bool {
    let cubes = [at_a, at_b].map(|at| power(&at.parts()[1], 3));
    let of = |controls: &[[f64; 2]; 4], at: Fraction, factor: &Dyadic| {
        [0, 1].map(|axis| scaled(&coefficients_from(axis_of(controls, axis), at), factor))
    };
    // Both are scaled alike.
    let mut of_a = of(a, at_a, &cubes[1]);
    let mut of_b = of(b, at_b, &cubes[0]);
    let is_common = (0..2).all(|axis| (&of_a[axis][0] - &of_b[axis][0]).sign().is_eq());
    if !is_common {
        return false;
    }
    for own in of_a.iter_mut().chain(&mut of_b) {
        own[0] = Dyadic::from(0.0);
    }
    is_alone(&of_a, &of_b, reach)
}

/// Whether the second cubic piece is, for certain, the part of the first between two parameters: $B(s) = A(p + s (q - p))$ for all s.
pub(super) fn is_part(a: &[[f64; 2]; 4], b: &[[f64; 2]; 4], [from, to]: [Fraction; 2]) -> bool {
    // Over one denominator the step from one to the other is a whole number of units.
    let denominator = from.denominator * to.denominator;
    let start = Fraction { numerator: from.numerator * to.denominator, denominator };
    let step = Dyadic::from(to.numerator * from.denominator - start.numerator);
    let unit = Dyadic::from(denominator);
    (0..2).all(|axis| {
        let of_a = coefficients_from(axis_of(a, axis), start);
        let of_b = power_coefficients(axis_of(b, axis), 0.0);
        (0..4).all(|k| {
            let [left, right] = [&of_b[k] * &power(&unit, 3 + k), &of_a[k] * &power(&step, k)];
            (&left - &right).sign().is_eq()
        })
    })
}
