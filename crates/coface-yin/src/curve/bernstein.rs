//! Polynomials of any odd degree up to seven in the Bernstein basis on the interval [0, 1].
//!
//! A piece with control points $b_0, \dots, b_d$ is $\sum_j \binom{d}{j} s^j (1 - s)^{d - j} b_j$. It lies in the convex hull of
//! its control points. Whatever is computed here from control points is off by at most [`rounding_bound`] in each coordinate, and
//! exact where it is a control point at an end.

use super::Order;
use std::ops::Deref;

/// The control points of one polynomial, by value; or those of a derivative of one, which are vectors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Piece {
    points: [[f64; 2]; Piece::MOST],
    count: usize,
}

impl Piece {
    /// The most control points that a piece has.
    pub(crate) const MOST: usize = 8;

    pub(crate) fn new(controls: &[[f64; 2]]) -> Self {
        Self::with(controls.len(), |j| controls[j])
    }

    /// `count` control points by number.
    pub(crate) fn with(count: usize, point: impl Fn(usize) -> [f64; 2]) -> Self {
        let mut points = [[0.0; 2]; Piece::MOST];
        for (j, place) in points[..count].iter_mut().enumerate() {
            *place = point(j);
        }
        Self { points, count }
    }

    /// The same with these ends.
    pub(crate) fn between(mut self, [first, last]: [[f64; 2]; 2]) -> Self {
        self.points[0] = first;
        self.points[self.count - 1] = last;
        self
    }

    /// The same from the end to the beginning.
    pub(crate) fn reversed(mut self) -> Self {
        self.points[..self.count].reverse();
        self
    }
}

impl Deref for Piece {
    type Target = [[f64; 2]];

    fn deref(&self) -> &[[f64; 2]] {
        &self.points[..self.count]
    }
}

/// The part of the way from a to b; a and b themselves at 0 and 1.
fn between([a, b]: [[f64; 2]; 2], s: f64) -> [f64; 2] {
    let rest = 1.0 - s;
    [rest * a[0] + s * b[0], rest * a[1] + s * b[1]]
}

/// How far what is computed from control points is off at most, in each coordinate: each of the `degree` steps of de Casteljau's
/// scheme multiplies by at most $(1 + 2^{-53})^3$.
pub(crate) fn rounding_bound(controls: &[[f64; 2]]) -> f64 {
    let largest = controls.as_flattened().iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    2.0 * controls.len() as f64 * f64::EPSILON * largest
}

/// The point at a parameter, by de Casteljau's scheme.
pub(crate) fn value(controls: &[[f64; 2]], s: f64) -> [f64; 2] {
    polar_value(controls, |_| s)
}

/// The symmetric multiaffine form (blossom) of a polynomial at as many parameters as its degree.
fn polar_value(controls: &[[f64; 2]], parameter: impl Fn(usize) -> f64) -> [f64; 2] {
    let mut points = [[0.0; 2]; Piece::MOST];
    points[..controls.len()].copy_from_slice(controls);
    for (step, left) in (1..controls.len()).rev().enumerate() {
        let s = parameter(step);
        for j in 0..left {
            points[j] = between([points[j], points[j + 1]], s);
        }
    }
    points[0]
}

/// The parts before and after a parameter; they share their common end.
pub(crate) fn split(controls: &[[f64; 2]], s: f64) -> [Piece; 2] {
    let mut last = Piece::new(controls);
    let mut first = last;
    for step in 1..controls.len() {
        for j in 0..controls.len() - step {
            last.points[j] = between([last.points[j], last.points[j + 1]], s);
        }
        first.points[step] = last.points[0];
    }
    [first, last]
}

/// The part from one parameter to another, which may be the smaller one: then it runs against the piece. Its ends are the
/// [`value`]s there; parts of straight pieces are straight.
pub(crate) fn sub_range(controls: &[[f64; 2]], [from, to]: [f64; 2]) -> Piece {
    let degree = controls.len() - 1;
    if is_straight(controls) {
        return straight_piece([value(controls, from), value(controls, to)], controls.len());
    }
    if [from, to] == [0.0, 1.0] {
        return Piece::new(controls);
    }
    Piece::with(controls.len(), |j| polar_value(controls, |step| if step < degree - j { from } else { to }))
}

/// The part from one parameter to another as [`sub_range`] says, with given ends, which are those of the part up to rounding.
pub(crate) fn sub_range_between(controls: &[[f64; 2]], range: [f64; 2], ends: [[f64; 2]; 2]) -> Piece {
    if is_straight(controls) {
        straight_piece(ends, controls.len())
    } else {
        sub_range(controls, range).between(ends)
    }
}

/// The derivative by the parameter in [0, 1]: one control point less.
pub(crate) fn derivative(controls: &[[f64; 2]]) -> Piece {
    let degree = (controls.len() - 1) as f64;
    Piece::with(controls.len() - 1, |j| {
        [0, 1].map(|axis| degree * (controls[j + 1][axis] - controls[j][axis]))
    })
}

/// The same polynomial with `count` control points, not less than it has; straight pieces become straight ones.
pub(crate) fn raised(controls: &[[f64; 2]], count: usize) -> Piece {
    if is_straight(controls) {
        return straight_piece([controls[0], controls[controls.len() - 1]], count);
    }
    raised_as_it_is(controls, count)
}

/// The same polynomial with `count` control points, from any number of them up to that.
pub(crate) fn raised_as_it_is(controls: &[[f64; 2]], count: usize) -> Piece {
    let mut piece = Piece::new(controls);
    while piece.count < count {
        let degree = piece.count;
        piece = Piece::with(degree + 1, |j| match j {
            0 => piece.points[0],
            j if j == degree => piece.points[degree - 1],
            j => between([piece.points[j], piece.points[j - 1]], j as f64 / degree as f64),
        });
    }
    piece
}

/// The straight piece between two points with `count` control points: the only one that counts as straight. Its reverse is that of
/// the reversed ends.
///
/// Control point j is $((d - j) a + j b) / d$, rounded.
pub(crate) fn straight_piece([a, b]: [[f64; 2]; 2], count: usize) -> Piece {
    let degree = (count - 1) as f64;
    Piece::with(count, |j| match j {
        0 => a,
        j if j == count - 1 => b,
        j => [0, 1].map(|axis| {
            let [behind, ahead] = [degree - j as f64, j as f64];
            let sum = behind * a[axis] + ahead * b[axis];
            if a[axis] == b[axis] {
                a[axis]
            } else if sum.is_finite() {
                sum / degree
            } else {
                behind / degree * a[axis] + ahead / degree * b[axis]
            }
        }),
    })
}

/// Whether a piece is the [`straight_piece`] between its ends: all pieces of order 2 are.
pub(crate) fn is_straight(controls: &[[f64; 2]]) -> bool {
    let count = controls.len();
    count == Order::LINEAR.value() || {
        let [first, last] = [controls[0], controls[count - 1]];
        controls[1..count - 1] == straight_piece([first, last], count)[1..count - 1]
    }
}

/// The least and the greatest coordinates of the control points: a box around the piece.
pub(crate) fn control_box(controls: &[[f64; 2]]) -> [[f64; 2]; 2] {
    let mut found = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    for point in controls {
        for axis in 0..2 {
            found[0][axis] = found[0][axis].min(point[axis]);
            found[1][axis] = found[1][axis].max(point[axis]);
        }
    }
    found
}

/// A box that surely contains the exact piece over a range of parameters in [0, 1].
pub(crate) fn range_box(controls: &[[f64; 2]], range: [f64; 2]) -> [[f64; 2]; 2] {
    let bound = rounding_bound(controls);
    let [low, high] = control_box(&sub_range(controls, range));
    // A straight piece is taken for the segment between its ends, of which its controls stray by rounding.
    [low.map(|x| (x - bound).next_down()), high.map(|x| (x + bound).next_up())]
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::Rational;
    use coface_geometry::predicates::Dyadic;
    use proptest::prelude::*;

    fn piece() -> impl Strategy<Value = Vec<[f64; 2]>> {
        let point = prop::array::uniform2(-1.0..1.0f64);
        prop::sample::select(vec![2, 4, 6, 8])
            .prop_flat_map(move |count| prop::collection::vec(point.clone(), count))
    }

    fn exact(controls: &[[f64; 2]], s: f64) -> [Rational; 2] {
        let number = |x: f64| Dyadic::from(x).quotient(&Dyadic::from(1.0));
        let (s, rest) = (number(s), &number(1.0) - &number(s));
        [0, 1].map(|axis| {
            let mut points: Vec<_> = controls.iter().map(|point| number(point[axis])).collect();
            while points.len() > 1 {
                points = points.windows(2).map(|pair| &(&rest * &pair[0]) + &(&s * &pair[1])).collect();
            }
            points.swap_remove(0)
        })
    }

    fn miss(found: [f64; 2], right: &[Rational; 2]) -> f64 {
        [0, 1].into_iter().fold(0.0, |miss: f64, axis| {
            let found = Dyadic::from(found[axis]).quotient(&Dyadic::from(1.0));
            miss.max((&found - &right[axis]).to_f64().abs())
        })
    }

    proptest! {
        #[test]
        fn values_and_parts_are_within_the_bound((controls, s, t) in (piece(), 0.0..1.0f64, 0.0..1.0f64)) {
            let bound = rounding_bound(&controls);
            prop_assert!(miss(value(&controls, s), &exact(&controls, s)) <= bound);
            let [first, last] = split(&controls, s);
            prop_assert_eq!(first[controls.len() - 1], last[0]);
            prop_assert!(miss(value(&first, t), &exact(&controls, s * t)) <= 3.0 * bound);
            let part = sub_range(&controls, [s, t]);
            prop_assert!(miss(value(&part, 0.5), &exact(&controls, 0.5 * (s + t))) <= 3.0 * bound);
            let whole = sub_range(&controls, [1.0, 0.0]).reversed();
            prop_assert_eq!(&whole[..], &controls[..]);
            for count in [4, 6, 8] {
                if count >= controls.len() {
                    prop_assert!(miss(value(&raised(&controls, count), s), &exact(&controls, s)) <= 3.0 * bound);
                }
            }
            let [low, high] = range_box(&controls, [s.min(t), s.max(t)]);
            let inside = value(&controls, 0.5 * (s + t));
            prop_assert!((0..2).all(|axis| low[axis] <= inside[axis] && inside[axis] <= high[axis]));
        }

        #[test]
        fn straight_pieces_are_known_in_either_direction(ends in prop::array::uniform2(prop::array::uniform2(-9.0..9.0f64))) {
            for count in [2, 4, 6, 8] {
                let straight = straight_piece(ends, count);
                prop_assert!(is_straight(&straight));
                prop_assert_eq!(straight.reversed(), straight_piece([ends[1], ends[0]], count));
                prop_assert!(is_straight(&raised(&ends, count)));
                prop_assert!(is_straight(&sub_range(&straight, [0.7, 0.2])));
            }
        }
    }

    #[test]
    fn the_derivative_of_a_parabola_is_a_line() {
        let slope = derivative(&[[0.0, 0.0], [0.5, 0.0], [1.0, 1.0]]);
        assert_eq!(value(&slope, 0.25), [1.0, 0.5]);
        let huge = straight_piece([[-f64::MAX, 1.0], [f64::MAX, 1.0]], 8);
        assert!(huge.as_flattened().iter().all(|x| x.is_finite()) && huge[3][1] == 1.0);
    }
}
