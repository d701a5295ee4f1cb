//! Whether boundaries surely stay apart while they move from one shape to another over the same knots.
//!
//! A **tube** is what the polynomial between two knots passes over when its control points move along straight lines: it lies in the
//! hull of the old and the new ones. Where all tubes are apart but for neighbors, which only share their knot, no curve meets
//! itself or another at any time: then curves that bounded a set before bound one afterwards, with the same Hasse forest. Being apart is
//! proven here by boxes and half-planes with margins for what is rounded. When the proof fails nothing is said.

use super::piece_boxes::{PlanarBox, do_meet, piece_box, united};
use crate::curve::bernstein::{Piece, rounding_bound, split};

/// How often tubes are halved before the proof is given up.
const DEPTH: u32 = 10;

/// The old and the new polynomial between two knots.
#[derive(Clone, Copy)]
pub(super) struct Tube([Piece; 2]);

impl Tube {
    pub(super) fn new(old: &[[f64; 2]], new: &[[f64; 2]]) -> Self {
        Self([Piece::new(old), Piece::new(new)])
    }

    pub(super) fn bounds(&self) -> PlanarBox {
        let [old, new] = &self.0;
        united(piece_box(old), piece_box(new))
    }

    /// The same from its end to its beginning.
    pub(super) fn reversed(&self) -> Self {
        Self(self.0.map(Piece::reversed))
    }

    fn halves(&self) -> [Self; 2] {
        let [[a, b], [c, d]] = self.0.map(|piece| split(&piece, 0.5));
        [Self([a, c]), Self([b, d])]
    }

    fn ends(&self, which: usize) -> [[f64; 2]; 2] {
        let piece = &self.0[which];
        [piece[0], piece[piece.len() - 1]]
    }

    /// The direction from end to end, old and new one after the other.
    fn chord(&self) -> [f64; 2] {
        let [a, b] = [0, 1].map(|which| unit(self.ends(which)));
        [a[0] + b[0], a[1] + b[1]]
    }

    /// Whether all polynomials of the tube surely meet themselves nowhere.
    pub(super) fn is_simple(&self) -> bool {
        is_simple(self, DEPTH)
    }
}

fn is_simple(tube: &Tube, depth: u32) -> bool {
    let direction = tube.chord();
    let runs_on = tube.0.iter().all(|piece| {
        let margin = margin(piece, direction);
        piece.windows(2).all(|pair| dot(direction, way(pair[0], pair[1])) > margin)
    });
    runs_on
        || depth > 0 && {
            let [first, last] = tube.halves();
            is_simple(&first, depth - 1)
                && is_simple(&last, depth - 1)
                && are_neighbors(&first, &last, depth - 1)
        }
}

/// Whether two tubes of which one ends where the other begins surely share that point only.
pub(super) fn share_one_knot(before: &Tube, after: &Tube) -> bool {
    are_neighbors(before, after, DEPTH)
}

fn are_neighbors(before: &Tube, after: &Tube, depth: u32) -> bool {
    let [a, b] = [before.chord(), after.chord()].map(|way| unit([[0.0; 2], way]));
    let direction = [a[0] + b[0], a[1] + b[1]];
    // All but the common knot lies strictly on one side of a line through it or the other. A knot that moves (in the middle of a
    // tube) has a line of its own at each time.
    let is_split = (0..2).all(|which| {
        let (first, last) = (&before.0[which], &after.0[which]);
        let margin = margin(first, direction).max(margin(last, direction));
        let knot = last[0];
        first[..first.len() - 1].iter().all(|&point| dot(direction, way(point, knot)) > margin)
            && last[1..].iter().all(|&point| dot(direction, way(knot, point)) > margin)
    });
    is_split
        || depth > 0 && {
            let [[far_before, near_before], [near_after, far_after]] = [before.halves(), after.halves()];
            are_apart(&far_before, &near_after, depth - 1)
                && are_apart(&far_before, &far_after, depth - 1)
                && are_apart(&near_before, &far_after, depth - 1)
                && are_neighbors(&near_before, &near_after, depth - 1)
        }
}

/// Whether two tubes surely have no point in common.
pub(super) fn share_nothing(a: &Tube, b: &Tube) -> bool {
    are_apart(a, b, DEPTH)
}

fn are_apart(a: &Tube, b: &Tube, depth: u32) -> bool {
    !do_meet(&a.bounds(), &b.bounds())
        || depth > 0 && {
            let (a, b) = (a.halves(), b.halves());
            a.iter().all(|a| b.iter().all(|b| are_apart(a, b, depth - 1)))
        }
}

/// More than what rounding does to how far differences of control points go in a direction.
fn margin(controls: &[[f64; 2]], direction: [f64; 2]) -> f64 {
    4.0 * rounding_bound(controls) * (direction[0].abs() + direction[1].abs())
}

fn way(from: [f64; 2], to: [f64; 2]) -> [f64; 2] {
    [to[0] - from[0], to[1] - from[1]]
}

fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// The direction from one point to another with length 1; nothing where they are equal.
fn unit([from, to]: [[f64; 2]; 2]) -> [f64; 2] {
    let [x, y] = way(from, to);
    let length = x.hypot(y);
    if length > 0.0 { [x / length, y / length] } else { [0.0; 2] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::bernstein::straight_piece;

    fn straight(a: [f64; 2], b: [f64; 2]) -> Tube {
        let piece = straight_piece([a, b], 4);
        Tube::new(&piece, &piece)
    }

    #[test]
    fn what_is_apart_is_told_from_what_crosses() {
        let low = straight([0.0, 0.0], [4.0, 0.0]);
        assert!(share_nothing(&low, &straight([0.0, 0.1], [4.0, 2.0])));
        assert!(!share_nothing(&low, &straight([0.0, -0.1], [4.0, 2.0])));
        assert!(share_one_knot(&low, &straight([4.0, 0.0], [0.0, 0.5])));
        assert!(!share_one_knot(&low, &straight([4.0, 0.0], [0.0, 0.0])));
        // The old one is above what stays, the new one below it.
        let [old, new] =
            [[[0.0, 1.0], [4.0, 1.0]], [[0.0, -1.0], [4.0, -1.0]]].map(|ends| straight_piece(ends, 4));
        assert!(!share_nothing(&low, &Tube::new(&old, &new)));
        assert!(share_nothing(&low, &Tube::new(&old, &old)));
    }

    #[test]
    fn loops_are_not_simple() {
        let arch = [[0.0, 0.0], [0.0, 3.0], [4.0, 3.0], [4.0, 0.0]];
        let looped = [[0.0, 0.0], [6.0, 4.0], [-2.0, 4.0], [4.0, 0.0]];
        let line = straight_piece([[0.0, 0.0], [4.0, 0.0]], 4);
        assert!(Tube::new(&line, &arch).is_simple());
        assert!(!Tube::new(&looped, &looped).is_simple());
    }
}
