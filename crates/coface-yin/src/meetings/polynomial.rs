//! One polynomial piece in the coordinates of a frame, small enough to be copied.

use crate::curve::bernstein;
use crate::curve::bernstein::Piece;
use crate::curve::roots;

/// A polynomial curve over the parameters from 0 to 1 by its control points in the Bernstein basis.
///
/// # Accuracy
/// For control points between -1 and 1 values are computed with an error of at most $2 n u$, with $n$ the degree and
/// $u = 2^{-53}$, and control points of halves of halves with at most $n u$ more for each time.
#[derive(Clone, Copy, Debug)]
pub(super) struct Polynomial(Piece);

/// Below this a difference of neighboring control points is what rounding made.
const FLAT: f64 = 1.0 / (1u64 << 50) as f64;

/// A bound on the error of differences of neighboring control points.
pub(super) const DERIVATIVE_ERROR: f64 = 1.0 / (1u64 << 45) as f64;

pub(super) fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

pub(super) fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

pub(super) fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// The sum of the sizes of both coordinates: at least the length.
pub(super) fn size(a: [f64; 2]) -> f64 {
    a[0].abs() + a[1].abs()
}

/// Whether two points are no farther apart than that on both axes.
pub(super) fn is_near(a: [f64; 2], b: [f64; 2], distance: f64) -> bool {
    (a[0] - b[0]).abs() <= distance && (a[1] - b[1]).abs() <= distance
}

/// Whether the hulls of control points of two pieces are farther apart than a distance, as boxes along the axes or along a chord.
pub(super) fn is_apart(a: &[[f64; 2]], b: &[[f64; 2]], distance: f64) -> bool {
    let [of_a, of_b] = [bernstein::control_box(a), bernstein::control_box(b)];
    (0..2).any(|k| of_a[0][k] - of_b[1][k] > distance || of_b[0][k] - of_a[1][k] > distance)
        || is_beside(a, b, distance)
        || is_beside(b, a, distance)
}

/// Whether a line along or across the chord of the first of two pieces separates it from the other.
pub(super) fn is_beside(own: &[[f64; 2]], other: &[[f64; 2]], distance: f64) -> bool {
    let origin = own[0];
    let chord = minus(own[own.len() - 1], origin);
    let gap = distance * size(chord);
    let reach = |points: &[[f64; 2]]| {
        let [mut low, mut high] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for &point in points {
            let to = minus(point, origin);
            let at = [cross(chord, to), dot(chord, to)];
            for k in 0..2 {
                low[k] = low[k].min(at[k]);
                high[k] = high[k].max(at[k]);
            }
        }
        [low, high]
    };
    let [a, b] = [reach(own), reach(other)];
    (0..2).any(|k| a[0][k] - b[1][k] > gap || b[0][k] - a[1][k] > gap)
}

impl Polynomial {
    pub(super) fn new(controls: &[[f64; 2]]) -> Self {
        Self(Piece::new(controls))
    }

    pub(super) fn controls(&self) -> &[[f64; 2]] {
        &self.0
    }

    pub(super) fn degree(&self) -> usize {
        self.0.len() - 1
    }

    pub(super) fn first(&self) -> [f64; 2] {
        self.0[0]
    }

    pub(super) fn last(&self) -> [f64; 2] {
        self.0[self.0.len() - 1]
    }

    pub(super) fn chord(&self) -> [f64; 2] {
        minus(self.last(), self.first())
    }

    /// The point at a parameter.
    pub(super) fn at(&self, t: f64) -> [f64; 2] {
        if t == 0.0 {
            return self.first();
        }
        if t == 1.0 {
            return self.last();
        }
        self.jet(t)[0]
    }

    /// The point and the first two derivatives at a parameter.
    pub(super) fn jet(&self, t: f64) -> [[f64; 2]; 3] {
        let between = |a: [f64; 2], b: [f64; 2]| {
            let u = 1.0 - t;
            [u * a[0] + t * b[0], u * a[1] + t * b[1]]
        };
        let degree = self.degree();
        let mut own = [[0.0; 2]; Piece::MOST];
        own[..=degree].copy_from_slice(&self.0);
        for left in (3..=degree).rev() {
            for i in 0..left {
                own[i] = between(own[i], own[i + 1]);
            }
        }
        let n = degree as f64;
        let mut second = [0.0; 2];
        if degree >= 2 {
            let factor = n * (n - 1.0);
            second = [0, 1].map(|k| factor * (own[2][k] - 2.0 * own[1][k] + own[0][k]));
            own[0] = between(own[0], own[1]);
            own[1] = between(own[1], own[2]);
        }
        let first = [0, 1].map(|k| n * (own[1][k] - own[0][k]));
        [between(own[0], own[1]), first, second]
    }

    /// The part before and the part after a parameter.
    pub(super) fn split(&self, t: f64) -> [Self; 2] {
        bernstein::split(&self.0, t).map(Self)
    }

    /// The part between two parameters, from the first to the second.
    pub(super) fn part(&self, range: [f64; 2]) -> Self {
        Self(bernstein::sub_range(&self.0, range))
    }

    /// The same with these ends.
    pub(super) fn with_ends(self, ends: [[f64; 2]; 2]) -> Self {
        Self(self.0.between(ends))
    }

    /// The least and the greatest coordinates of control points.
    pub(super) fn bounds(&self) -> [[f64; 2]; 2] {
        bernstein::control_box(&self.0)
    }

    /// A bound on the distance between the piece and its chord at equal parameters, and on how it bends: the largest second
    /// derivative.
    pub(super) fn largest_second_derivative(&self) -> f64 {
        let own = self.controls();
        let most = own
            .windows(3)
            .map(|at| {
                let bend = [0, 1].map(|k| at[0][k] - 2.0 * at[1][k] + at[2][k]);
                size(bend)
            })
            .fold(0.0, f64::max);
        let n = self.degree() as f64;
        n * (n - 1.0) * most
    }

    /// Whether no tangent of one piece is parallel to one of the other, for certain: then they have one common point at most.
    pub(super) fn is_transversal(&self, other: &Self) -> bool {
        let mut sign = 0.0;
        for a in self.controls().windows(2) {
            let d = minus(a[1], a[0]);
            for b in other.controls().windows(2) {
                let e = minus(b[1], b[0]);
                let turn = cross(d, e);
                // Above what rounding in control points between -1 and 1 does after forty halvings.
                if turn.abs() <= DERIVATIVE_ERROR * (size(d) + size(e)) || turn * sign < 0.0 {
                    return false;
                }
                sign = turn.signum();
            }
        }
        true
    }

    /// Adds the parameters between 0 and 1 at which one coordinate turns.
    pub(super) fn add_turns(&self, axis: usize, found: &mut Vec<f64>) {
        let mut slopes = [0.0; Piece::MOST];
        for (slope, at) in slopes.iter_mut().zip(self.0.windows(2)) {
            let step = at[1][axis] - at[0][axis];
            *slope = if step.abs() <= FLAT { 0.0 } else { step };
        }
        found.extend(roots::sign_changes(&slopes[..self.degree()]));
    }
}
