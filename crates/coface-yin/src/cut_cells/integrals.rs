//! Areas beside arcs and lengths of arcs.

use super::CutArc;
use crate::YinSet;
use crate::curve::bernstein::{Piece, derivative, is_straight, split, sub_range_between, value};
use crate::curve::gauss_legendre;

/// Weights and nodes for all arcs of one order.
pub(super) struct Integrals {
    /// The integrals of $B_i B_j'$ over [0, 1], row by row, for Bernstein polynomials of one degree.
    products: Vec<f64>,
    nodes: [[f64; 2]; 8],
}

impl Integrals {
    pub(super) fn new(degree: usize) -> Self {
        let binomial =
            |n: usize, k: usize| (0..k).fold(1.0, |product, i| product * (n - i) as f64 / (i + 1) as f64);
        let product = |i: usize, j: usize| {
            // B_j' is the degree times the difference of two polynomials of one degree less.
            let with = |k: usize| binomial(degree - 1, k) / binomial(2 * degree - 1, i + k);
            let [below, above] = [(j > 0).then(|| with(j - 1)), (j < degree).then(|| with(j))];
            0.5 * binomial(degree, i) * (below.unwrap_or(0.0) - above.unwrap_or(0.0))
        };
        let nodes = gauss_legendre().map(|[node, weight]| [0.5 + 0.5 * node, 0.5 * weight]);
        let pairs = (0..=degree).flat_map(|i| (0..=degree).map(move |j| (i, j)));
        Self { products: pairs.map(|(i, j)| product(i, j)).collect(), nodes }
    }

    /// $\int (x_0 - x) \, dy$ along an arc with these control points.
    pub(super) fn left_of(&self, right: f64, controls: &[[f64; 2]]) -> f64 {
        if is_straight(controls) {
            let [a, b] = [controls[0], controls[controls.len() - 1]];
            return 0.5 * ((right - a[0]) + (right - b[0])) * (b[1] - a[1]);
        }
        let count = controls.len();
        let mut sum = 0.0;
        for (i, point) in controls.iter().enumerate() {
            let weights = &self.products[i * count..(i + 1) * count];
            // Heights from the first control point: what is constant adds nothing.
            let height: f64 = weights
                .iter()
                .zip(controls)
                .map(|(weight, other)| weight * (other[1] - controls[0][1]))
                .sum();
            sum += (right - point[0]) * height;
        }
        sum
    }

    /// The length of an arc with these control points, to about 15 digits.
    pub(super) fn length(&self, controls: &[[f64; 2]]) -> f64 {
        if is_straight(controls) {
            let [a, b] = [controls[0], controls[controls.len() - 1]];
            return (b[0] - a[0]).hypot(b[1] - a[1]);
        }
        // Halves of the velocity do not depend on where the arc is: parts of the arc would be rounded like its coordinates.
        let velocity = derivative(controls);
        let whole = self.one_length(&velocity);
        self.halved_length(&velocity, whole, 12)
    }

    fn halved_length(&self, velocity: &[[f64; 2]], whole: f64, depth: u32) -> f64 {
        let halves = split(velocity, 0.5);
        // Each half is run through in half the time.
        let parts = [0, 1].map(|at| 0.5 * self.one_length(&halves[at]));
        let sum = parts[0] + parts[1];
        if depth == 0 || (sum - whole).abs() <= 4.0 * f64::EPSILON * sum {
            return sum;
        }
        0.5 * (self.halved_length(&halves[0], 2.0 * parts[0], depth - 1)
            + self.halved_length(&halves[1], 2.0 * parts[1], depth - 1))
    }

    fn one_length(&self, velocity: &[[f64; 2]]) -> f64 {
        self.nodes
            .iter()
            .map(|&[node, weight]| {
                let [x, y] = value(velocity, node);
                weight * x.hypot(y)
            })
            .sum()
    }
}

impl CutArc {
    /// The control points of the arc.
    pub(super) fn controls(&self, set: &YinSet) -> Piece {
        let curve = set.curve(self.curve as usize);
        sub_range_between(curve.piece(self.piece as usize), self.range, self.ends)
    }
}
