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

/// Whether a cubic piece comes, for certain, to a point at a parameter.
pub(super) fn comes_to(controls: &[[f64; 2]; 4], at: Fraction, point: [f64; 2]) -> bool {
    let cube = power(&at.parts()[1], 3);
    (0..2).all(|axis| {
        let own = &coefficients_from(axis_of(controls, axis), at)[0];
        (own - &(&cube * &Dyadic::from(point[axis]))).sign().is_eq()
    })
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn fractions_are_found_near_numbers() {
        let near =
            |x: f64, distance: f64| Fraction::near(x, distance).map(|at| [at.numerator, at.denominator]);
        assert_eq!(near(1.0 / 3.0 + 1e-7, 1e-6), Some([1.0, 3.0]));
        assert_eq!(near(0.625, 1e-12), Some([5.0, 8.0]));
        assert_eq!(
            (near(0.0, 1e-12), near(1.0, 1e-12), near(-0.5, 1e-12)),
            (Some([0., 1.]), Some([1., 1.]), Some([-1., 2.]))
        );
        assert_eq!(near(std::f64::consts::FRAC_1_PI, 1e-12), None);
        assert_eq!(near(f64::NAN, 1.0), None);
    }

    /// The cubic $9 (t - 1/3)^2 (t + 1)$ over the x-axis, and its mirror image run through backward.
    const UPPER: [[f64; 2]; 4] = [[0.0, 3.0], [3.0, -2.0], [6.0, -4.0], [9.0, 24.0]];

    #[test]
    fn mirror_images_touch_alone() {
        let lower = [3, 2, 1, 0].map(|j: usize| [UPPER[j][0], -UPPER[j][1]]);
        let at = |p: f64, q: f64| Fraction { numerator: p, denominator: q };
        // Heights are three times the Bernstein coefficients over three: the root is at a third.
        let [third, rest] = [at(1.0, 3.0), at(2.0, 3.0)];
        assert!(meet_alone([&UPPER, &lower], [third, rest], 1e-3));
        assert!(!meet_alone([&UPPER, &lower], [third, at(1.0, 2.0)], 1e-3));
        // One unit in the last place more, and they do not meet there.
        let moved = lower.map(|[x, y]| [x, if y == 4.0 { y.next_up() } else { y }]);
        assert!(!meet_alone([&UPPER, &moved], [third, rest], 1e-3));
        // A curve is not alone on itself.
        assert!(!meet_alone([&UPPER, &UPPER], [third, third], 1e-3));
    }

    #[test]
    fn parts_are_told_from_what_is_near() {
        let whole = UPPER.map(|point| point.map(|x| 64.0 * x));
        let middle = |p: [f64; 2], q: [f64; 2]| [0, 1].map(|k| 0.5 * (p[k] + q[k]));
        let [a, b, c] = [0, 1, 2].map(|j| middle(whole[j], whole[j + 1]));
        let half = [whole[0], a, middle(a, b), middle(middle(a, b), middle(b, c))];
        let at = |x: f64| Fraction::near(x, 0.0).expect("a simple fraction");
        assert!(is_part(&whole, &half, [at(0.0), at(0.5)]));
        assert!(is_part(&half, &whole, [at(0.0), at(2.0)]));
        let back = [3, 2, 1, 0].map(|j: usize| half[j]);
        assert!(is_part(&whole, &back, [at(0.5), at(0.0)]));
        assert!(!is_part(&whole, &half, [at(0.0), at(0.25)]));
        let moved = half.map(|[x, y]| [x, y.next_up()]);
        assert!(!is_part(&whole, &moved, [at(0.0), at(0.5)]));
    }
}
