//! On which side of a line a point lies, and which way one direction turns into another.

use super::double_double::{Approximation, is_ordinary};
use super::{Dyadic, PlanarLine};
use robust::Coord;
use std::cmp::Ordering;

/// Eight unit roundoffs: twice what a difference of products of differences can lose of the sum of the products.
const LOST: f64 = 8.0 * f64::EPSILON / 2.0;

/// On which side of the line from `a` to `b` the point `c` lies, exactly: `Greater` for left, `Less` for right, `Equal`
/// for on the line.
///
/// The sign of $(b - a) \times (c - a)$, twice the area of the triangle $a b c$. All coordinates are finite.
///
/// # Complexity
/// Constant; a few operations in floating point unless the points are nearly on one line.
///
/// # References
/// J. R. Shewchuk, *Adaptive precision floating-point arithmetic and fast robust geometric predicates* (1997).
///
/// # Examples
/// ```
/// use coface_geometry::predicates::orientation;
/// use std::cmp::Ordering;
/// assert_eq!(orientation([0.0, 0.0], [1.0, 0.0], [5.0, 1e-300]), Ordering::Greater);
/// assert_eq!(orientation([0.1, 0.1], [0.2, 0.2], [1e300, 1e300]), Ordering::Equal);
/// ```
pub fn orientation(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> Ordering {
    let [left, right] = [(a[0] - c[0]) * (b[1] - c[1]), (a[1] - c[1]) * (b[0] - c[0])];
    let determinant = left - right;
    if determinant.abs() > LOST * (left.abs() + right.abs()) + f64::MIN_POSITIVE {
        return determinant.total_cmp(&0.0);
    }
    if [a, b, c].as_flattened().iter().all(|&x| is_ordinary(x)) {
        let [a, b, c] = [a, b, c].map(|[x, y]| Coord { x, y });
        let determinant = robust::orient2d(a, b, c);
        // Not total_cmp: -0.0 is zero too.
        return determinant.partial_cmp(&0.0).expect("a determinant of ordinary numbers is a number");
    }
    exact_turn([a, b], [a, c])
}

/// Which way the direction of one line turns into that of another, exactly: `Greater` for counterclockwise (by less
/// than a half turn), `Less` for clockwise, `Equal` for the same or opposite direction.
///
/// The sign of $(s_1 - s_0) \times (t_1 - t_0)$. All coordinates are finite.
///
/// # Examples
/// ```
/// use coface_geometry::predicates::direction_turn;
/// use std::cmp::Ordering;
/// let east = [[0.1, 0.3], [0.9, 0.3]];
/// assert_eq!(direction_turn(east, [[5.0, 5.0], [4.0, 6.0]]), Ordering::Greater);
/// assert_eq!(direction_turn(east, [[7.0, 0.0], [2.0, 0.0]]), Ordering::Equal);
/// ```
pub fn direction_turn(s: PlanarLine, t: PlanarLine) -> Ordering {
    let left = (s[1][0] - s[0][0]) * (t[1][1] - t[0][1]);
    let right = (s[1][1] - s[0][1]) * (t[1][0] - t[0][0]);
    let determinant = left - right;
    if determinant.abs() > LOST * (left.abs() + right.abs()) + f64::MIN_POSITIVE {
        return determinant.total_cmp(&0.0);
    }
    if [s, t].as_flattened().as_flattened().iter().all(|&x| is_ordinary(x)) {
        let d = |line: PlanarLine, axis: usize| Approximation::difference(line[1][axis], line[0][axis]);
        if let Some(sign) = d(s, 0).times(d(t, 1)).minus(d(s, 1).times(d(t, 0))).sign() {
            return sign;
        }
    }
    exact_turn(s, t)
}

fn exact_turn(s: PlanarLine, t: PlanarLine) -> Ordering {
    let d = |line: PlanarLine, axis: usize| &Dyadic::from(line[1][axis]) - &Dyadic::from(line[0][axis]);
    (&(&d(s, 0) * &d(t, 1)) - &(&d(s, 1) * &d(t, 0))).sign()
}

#[cfg(test)]
mod tests {
    use super::super::samples::{coordinate, rational};
    use super::*;
    use coface_algebra::Rational;
    use proptest::prelude::*;

    fn plain(s: PlanarLine, t: PlanarLine) -> Ordering {
        let d = |line: PlanarLine, axis: usize| &rational(line[1][axis]) - &rational(line[0][axis]);
        (&(&d(s, 0) * &d(t, 1)) - &(&d(s, 1) * &d(t, 0))).cmp(&Rational::ZERO)
    }

    proptest! {
        #[test]
        fn signs_are_those_of_fractions(flat in prop::array::uniform8(coordinate())) {
            let [a, b, c, d] = [0, 2, 4, 6].map(|i| [flat[i], flat[i + 1]]);
            prop_assert_eq!(orientation(a, b, c), plain([a, b], [a, c]));
            prop_assert_eq!(orientation(b, c, a), orientation(a, b, c));
            prop_assert_eq!(orientation(b, a, c), orientation(a, b, c).reverse());
            prop_assert_eq!(direction_turn([a, b], [c, d]), plain([a, b], [c, d]));
            prop_assert_eq!(direction_turn([a, b], [a, c]), orientation(a, b, c));
        }
    }

    #[test]
    fn products_that_overflow_are_decided() {
        let huge = 1e300;
        assert_eq!(orientation([0.0, 0.0], [huge, huge], [huge, huge]), Ordering::Equal);
        let next = f64::from_bits(huge.to_bits() + 1);
        assert_eq!(orientation([0.0, 0.0], [huge, huge], [huge, next]), Ordering::Greater);
        assert_eq!(orientation([-f64::MAX, 0.0], [f64::MAX, 0.0], [0.0, -f64::MIN_POSITIVE]), Ordering::Less);
        assert_eq!(orientation([1e-300, 0.0], [0.0, 1e-300], [0.0, 0.0]), Ordering::Greater);
    }
}
