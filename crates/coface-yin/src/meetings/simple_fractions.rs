//! Cubic pieces that touch, or are parts of one cubic, at parameters that are simple fractions: by exact arithmetic.

use super::common_end::{Coefficients, is_alone, power_coefficients};
use coface_geometry::predicates::Dyadic;

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

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn fraction(numerator: i32, denominator: i32) -> Fraction {
        Fraction { numerator: f64::from(numerator), denominator: f64::from(denominator) }
    }

    /// The control points of a piece between two thirds of its parameter; without rounding where coordinates are multiples of 27.
    fn part_of(piece: &[[f64; 2]; 4], [from, to]: [i32; 2]) -> [[f64; 2]; 4] {
        let between = |points: &[[f64; 2]], thirds: i32| -> Vec<[f64; 2]> {
            let [a, b] = [f64::from(3 - thirds), f64::from(thirds)];
            points.windows(2).map(|pair| [0, 1].map(|k| (a * pair[0][k] + b * pair[1][k]) / 3.0)).collect()
        };
        [0, 1, 2, 3].map(|i| {
            // The blossom: the last i steps go to the end.
            (0..3).fold(piece.to_vec(), |points, step| between(&points, if step < 3 - i { from } else { to }))
                [0]
        })
    }

    /// The cubic $x = 3 t$, $y = 3 (3 t - 1)^2 (1 + t)$, which touches the line y = 0 at 1/3.
    const TOUCHING: [[f64; 2]; 4] = [[0.0, 3.0], [1.0, -2.0], [2.0, -4.0], [3.0, 24.0]];

    fn mirrored(piece: &[[f64; 2]; 4]) -> [[f64; 2]; 4] {
        piece.map(|[x, y]| [x, -y])
    }

    fn reversed(mut piece: [[f64; 2]; 4]) -> [[f64; 2]; 4] {
        piece.reverse();
        piece
    }

    #[test]
    fn fractions_are_found_and_others_are_not() {
        assert_eq!(Fraction::near(1.0 / 3.0 + 1e-12, 1e-9), Some(fraction(1, 3)));
        assert_eq!(Fraction::near(0.0, 0.0), Some(fraction(0, 1)));
        assert_eq!(Fraction::near(1.0, 0.0), Some(fraction(1, 1)));
        assert_eq!(Fraction::near(-0.25, 0.0), Some(fraction(-1, 4)));
        assert_eq!(Fraction::near(0.999_999, 1e-3), Some(fraction(1, 1)));
        assert_eq!(Fraction::near(1.0 / 4097.0, 1e-12), None);
        assert_eq!(Fraction::near(0.5f64.sqrt(), 1e-9), None);
        assert_eq!(Fraction::near(f64::NAN, 1e-9), None);
        assert_eq!(Fraction::near(f64::INFINITY, 1e-9), None);
    }

    #[test]
    fn cubics_that_touch_once_are_proven_to() {
        let below = mirrored(&TOUCHING);
        let third = fraction(1, 3);
        assert!(meet_alone([&TOUCHING, &below], [third; 2], 0.1));
        assert!(meet_alone([&below, &TOUCHING], [third; 2], 0.1));
        assert!(meet_alone([&TOUCHING, &reversed(below)], [third, fraction(2, 3)], 0.1));
        // One of them with another speed: the half of it has the point at two thirds.
        let half = crate::curve::bernstein::split(&below, 0.5)[0];
        assert!(meet_alone([&TOUCHING, &[0, 1, 2, 3].map(|j| half[j])], [third, fraction(2, 3)], 0.1));
        // No common point there, by much and by the last digit.
        assert!(!meet_alone([&TOUCHING, &below], [fraction(1, 4); 2], 0.1));
        assert!(!meet_alone([&TOUCHING, &below], [third, fraction(2, 3)], 0.1));
        let mut moved = below;
        moved[1][1] = moved[1][1].next_up();
        assert!(!meet_alone([&TOUCHING, &moved], [third; 2], 0.1));
        // A cubic has all points in common with itself.
        assert!(!meet_alone([&TOUCHING, &TOUCHING], [third; 2], 1e-6));
    }

    #[test]
    fn a_crossing_next_to_the_touching_is_seen() {
        // y = (3 t - 1)^2 (2 t - 1) is zero at 1/2 too.
        let again = [[0.0, -3.0], [1.0, 5.0], [2.0, -8.0], [3.0, 12.0]];
        let [of_again, below] = [again, mirrored(&again)];
        assert!(meet_alone([&of_again, &below], [fraction(1, 3); 2], 0.01));
        assert!(!meet_alone([&of_again, &below], [fraction(1, 3); 2], 0.17));
        assert!(meet_alone([&of_again, &below], [fraction(1, 2); 2], 0.01));
    }

    proptest! {
        #[test]
        fn fractions_come_back(denominator in 1i32..4097, part in 0.0f64..1.0, error in -1e-9f64..1e-9) {
            let numerator = (part * f64::from(denominator)) as i32;
            let x = f64::from(numerator) / f64::from(denominator);
            // Different fractions with such denominators are 2^-24 apart at least.
            let found = Fraction::near(x + error, 2e-9);
            prop_assert_eq!(found.map(Fraction::value), Some(x));
        }

        #[test]
        fn coefficients_are_those_of_the_rest_of_the_cubic(
            controls in prop::array::uniform4(-100i32..100),
            numerator in -5i32..9,
            denominator in 1i32..8,
            step in -3i32..4,
        ) {
            // At p/q + h the sum over the coefficients is the value times q^3, in whole numbers for h = step.
            let own = controls.map(i64::from);
            let found = coefficients_from(controls.map(f64::from), fraction(numerator, denominator));
            let sum = (0..4).fold(Dyadic::from(0.0), |sum, k| {
                &sum + &(&found[k] * &power(&Dyadic::from(f64::from(step)), k))
            });
            let (q, p) = (i64::from(denominator), i64::from(numerator) + i64::from(step) * i64::from(denominator));
            let rest = q - p;
            let expected = own[0] * rest.pow(3)
                + 3 * own[1] * rest.pow(2) * p
                + 3 * own[2] * rest * p.pow(2)
                + own[3] * p.pow(3);
            prop_assert!((&sum - &Dyadic::from(expected as f64)).sign().is_eq());
        }

        #[test]
        fn parts_are_parts_and_nothing_else_is(
            points in prop::array::uniform4(prop::array::uniform2(-1000i32..1000)),
            from in 0i32..4,
            step in 1i32..4,
            corner in 0usize..4,
        ) {
            let piece = points.map(|point| point.map(|x| 27.0 * f64::from(x)));
            prop_assume!(piece.iter().any(|point| *point != piece[0]));
            let thirds = [from, (from + step) % 4];
            let ends = thirds.map(|at| fraction(at, 3));
            let part = part_of(&piece, thirds);
            prop_assert!(is_part(&piece, &part, ends));
            let [a, b] = ends;
            prop_assert!(is_part(&piece, &reversed(part), [b, a]));
            let mut moved = part;
            moved[corner][1] = moved[corner][1].next_up();
            prop_assert!(!is_part(&piece, &moved, ends));
            prop_assert!(!is_part(&piece, &part, [a, fraction(5, 3)]));
            // The whole goes on on both sides of its middle third.
            let middle = part_of(&piece, [1, 2]);
            prop_assert!(is_part(&middle, &piece, [fraction(-1, 1), fraction(2, 1)]));
        }
    }
}
