//! One polynomial piece, small enough to be copied.

use crate::yin::Order;

const MOST: usize = 8;

/// A polynomial curve over the parameters from 0 to 1 by its control points in the Bernstein basis.
///
/// # Accuracy
/// For control points between -1 and 1 values are computed with an error of at most $2 n u$, with $n$ the degree and
/// $u = 2^{-53}$, and control points of halves of halves with at most $n u$ more for each time.
#[derive(Clone, Copy, Debug)]
pub(in crate::yin) struct Polynomial {
    count: usize,
    controls: [[f64; 2]; MOST],
}

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

fn between(a: [f64; 2], b: [f64; 2], t: f64) -> [f64; 2] {
    let u = 1.0 - t;
    [u * a[0] + t * b[0], u * a[1] + t * b[1]]
}

impl Polynomial {
    /// # Panics
    /// If there are fewer than two control points, or more than an [`Order`] can have.
    pub(in crate::yin) fn new(controls: &[[f64; 2]]) -> Self {
        debug_assert_eq!(MOST, Order::HIGHEST.value());
        assert!(controls.len() >= 2, "a piece has two ends");
        let mut own = [[0.0; 2]; MOST];
        own[..controls.len()].copy_from_slice(controls);
        Self { count: controls.len(), controls: own }
    }

    pub(in crate::yin) fn controls(&self) -> &[[f64; 2]] {
        &self.controls[..self.count]
    }

    pub(super) fn controls_mut(&mut self) -> &mut [[f64; 2]] {
        &mut self.controls[..self.count]
    }

    pub(in crate::yin) fn degree(&self) -> usize {
        self.count - 1
    }

    pub(in crate::yin) fn first(&self) -> [f64; 2] {
        self.controls[0]
    }

    pub(in crate::yin) fn last(&self) -> [f64; 2] {
        self.controls[self.count - 1]
    }

    pub(in crate::yin) fn chord(&self) -> [f64; 2] {
        minus(self.last(), self.first())
    }

    /// The point at a parameter.
    pub(in crate::yin) fn at(&self, t: f64) -> [f64; 2] {
        if t == 0.0 {
            return self.first();
        }
        if t == 1.0 {
            return self.last();
        }
        self.jet(t)[0]
    }

    /// The point and the first two derivatives at a parameter.
    pub(in crate::yin) fn jet(&self, t: f64) -> [[f64; 2]; 3] {
        let mut own = self.controls;
        let degree = self.degree();
        for left in (3..=degree).rev() {
            for i in 0..left {
                own[i] = between(own[i], own[i + 1], t);
            }
        }
        let n = degree as f64;
        let mut second = [0.0; 2];
        if degree >= 2 {
            let factor = n * (n - 1.0);
            second = [0, 1].map(|k| factor * (own[2][k] - 2.0 * own[1][k] + own[0][k]));
            own[0] = between(own[0], own[1], t);
            own[1] = between(own[1], own[2], t);
        }
        let first = [0, 1].map(|k| n * (own[1][k] - own[0][k]));
        [between(own[0], own[1], t), first, second]
    }

    /// The part before and the part after a parameter.
    pub(in crate::yin) fn split(&self, t: f64) -> [Self; 2] {
        let (mut before, mut after) = (*self, *self);
        let degree = self.degree();
        for level in 1..=degree {
            for i in 0..=degree - level {
                after.controls[i] = between(after.controls[i], after.controls[i + 1], t);
            }
            before.controls[level] = after.controls[0];
        }
        [before, after]
    }

    /// The part between two parameters, from the first to the second.
    pub(in crate::yin) fn part(&self, [from, to]: [f64; 2]) -> Self {
        if from > to {
            return self.part([to, from]).reversed();
        }
        let mut own = *self;
        if to < 1.0 {
            own = own.split(to)[0];
        }
        if from > 0.0 && to > 0.0 {
            own = own.split((from / to).min(1.0))[1];
        }
        own
    }

    /// The same way backward.
    pub(in crate::yin) fn reversed(&self) -> Self {
        let mut own = *self;
        own.controls_mut().reverse();
        own
    }

    /// The least and the greatest coordinates of control points.
    pub(in crate::yin) fn bounds(&self) -> [[f64; 2]; 2] {
        let [mut low, mut high] = [self.first(); 2];
        for point in &self.controls()[1..] {
            for axis in 0..2 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        [low, high]
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

    /// Whether the hulls of two pieces are farther apart than a distance, as boxes along the axes or along a chord.
    pub(super) fn is_apart(&self, other: &Self, distance: f64) -> bool {
        let [a, b] = [self.bounds(), other.bounds()];
        if (0..2).any(|k| a[0][k] - b[1][k] > distance || b[0][k] - a[1][k] > distance) {
            return true;
        }
        self.is_beside(other, distance) || other.is_beside(self, distance)
    }

    /// Whether a line along or across the chord of this piece separates it from another.
    pub(super) fn is_beside(&self, other: &Self, distance: f64) -> bool {
        let origin = self.first();
        let chord = self.chord();
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
        let [a, b] = [reach(self.controls()), reach(other.controls())];
        (0..2).any(|k| a[0][k] - b[1][k] > gap || b[0][k] - a[1][k] > gap)
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

    /// The parameters between 0 and 1 at which one coordinate turns.
    pub(super) fn turning_parameters(&self, axis: usize, found: &mut Vec<f64>) {
        let mut slopes = [0.0; MOST - 1];
        for (slope, at) in slopes.iter_mut().zip(self.controls().windows(2)) {
            *slope = at[1][axis] - at[0][axis];
        }
        roots_between(&slopes[..self.degree()], [0.0, 1.0], 0, found);
    }
}

/// A bound on the error of differences of neighboring control points.
pub(super) const DERIVATIVE_ERROR: f64 = 1.0 / (1u64 << 45) as f64;

/// Below this the coefficients of a derivative are what rounding made.
const FLAT: f64 = 1.0 / (1u64 << 50) as f64;

/// The roots of a polynomial in the Bernstein basis at which its sign changes, within rounding; `range` are its parameters.
fn roots_between(coefficients: &[f64], range: [f64; 2], depth: usize, found: &mut Vec<f64>) {
    if coefficients.iter().all(|x| x.abs() <= FLAT) {
        return;
    }
    let signs = coefficients.iter().filter(|x| **x != 0.0).map(|x| x.signum());
    let changes = signs.clone().zip(signs.skip(1)).filter(|(a, b)| a != b).count();
    if changes == 0 {
        return;
    }
    let ends = [coefficients[0], coefficients[coefficients.len() - 1]];
    if changes == 1 && ends[0] * ends[1] < 0.0 {
        let t = bracketed_root(coefficients);
        let at = range[0] + t * (range[1] - range[0]);
        if 0.0 < at && at < 1.0 {
            found.push(at);
        }
        return;
    }
    let middle = range[0] + 0.5 * (range[1] - range[0]);
    if depth == 50 {
        found.push(middle);
        return;
    }
    let mut before = [0.0; MOST - 1];
    let mut after = [0.0; MOST - 1];
    let last = coefficients.len() - 1;
    after[..=last].copy_from_slice(coefficients);
    before[0] = after[0];
    for level in 1..=last {
        for i in 0..=last - level {
            after[i] = 0.5 * (after[i] + after[i + 1]);
        }
        before[level] = after[0];
    }
    roots_between(&before[..=last], [range[0], middle], depth + 1, found);
    if after[0] == 0.0 && middle > 0.0 {
        found.push(middle);
    }
    roots_between(&after[..=last], [middle, range[1]], depth + 1, found);
}

fn value(coefficients: &[f64], t: f64) -> f64 {
    let mut own = [0.0; MOST - 1];
    own[..coefficients.len()].copy_from_slice(coefficients);
    for left in (1..coefficients.len()).rev() {
        for i in 0..left {
            own[i] = (1.0 - t) * own[i] + t * own[i + 1];
        }
    }
    own[0]
}

/// The one root between 0 and 1 of a polynomial whose ends have different signs.
fn bracketed_root(coefficients: &[f64]) -> f64 {
    let [mut low, mut high] = [0.0, 1.0];
    let [mut at_low, mut at_high] = [coefficients[0], coefficients[coefficients.len() - 1]];
    let mut side = 0;
    for step in 0..80 {
        // False position with the Illinois rule, and a bisection every fourth time.
        let mut t = (low * at_high - high * at_low) / (at_high - at_low);
        if step % 4 == 3 || !(low < t && t < high) {
            t = 0.5 * (low + high);
        }
        if !(low < t && t < high) {
            break;
        }
        let x = value(coefficients, t);
        if x == 0.0 {
            return t;
        }
        if (x < 0.0) == (at_low < 0.0) {
            (low, at_low) = (t, x);
            if side == 1 {
                at_high *= 0.5;
            }
            side = 1;
        } else {
            (high, at_high) = (t, x);
            if side == 2 {
                at_low *= 0.5;
            }
            side = 2;
        }
        if high - low <= f64::EPSILON * high {
            break;
        }
    }
    0.5 * (low + high)
}
