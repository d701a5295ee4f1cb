//! Triangles of a polygon made less thin.

use crate::measure::{cross, dot};
use coface_algebra::narrow;
use std::cmp::Ordering;

/// No side of a triangle of the same polygon.
const NONE: u32 = u32::MAX;
/// The sine of the sum of two opposite angles has to be so far below zero: nearer to it rounding could let a side be flipped to and fro.
const MARGIN: f64 = 1e-9;
/// So many flips a triangle are enough for ordinary polygons; what is left then is a triangulation too.
const MOST_FLIPS: usize = 16;

/// Flips sides between two triangles of a polygon, as [`triangulate_sides`](super::triangulate_sides) gives them, while the two angles opposite to
/// one are together more than two right ones: what is left is the constrained Delaunay triangulation, but for sides whose angles are two right ones
/// within rounding.
///
/// `sides` are those of the polygon, which stay. `turn` is that of the triangulation; a side is only flipped where both new triangles turn
/// counterclockwise. `point` gives places in the plane of the polygon, which may be rounded: they decide which sides are flipped, and nothing else.
///
/// # Complexity
/// $O(n \log n)$ for n triangles, and at most $16 n$ flips.
///
/// C. L. Lawson, *Software for C1 surface interpolation* (1977).
///
/// # Examples
/// A rhombus, which is three times as wide as it is high, with its long diagonal:
/// ```
/// use coface_geometry::predicates::orientation;
/// use coface_geometry::triangulation::flip_to_delaunay;
/// let points = [[-3., 0.], [0., -1.], [3., 0.], [0., 1.]];
/// let at = |vertex: u32| points[vertex as usize];
/// let mut triangles = vec![[0, 1, 2], [0, 2, 3]];
/// flip_to_delaunay(
///     &mut triangles,
///     &[[0, 1], [1, 2], [2, 3], [3, 0]],
///     |vertex| [at(vertex)[0], at(vertex)[1], 0.],
///     |a, b, c| orientation(at(a), at(b), at(c)),
/// );
/// assert_eq!(triangles, [[1, 2, 3], [3, 0, 1]]);
/// ```
pub fn flip_to_delaunay(
    triangles: &mut [[u32; 3]],
    sides: &[[u32; 2]],
    point: impl Fn(u32) -> [f64; 3],
    turn: impl Fn(u32, u32, u32) -> Ordering,
) {
    if triangles.len() < 2 {
        return;
    }
    let mut flipping = Flipping { across: across(triangles, sides), triangles };
    let mut due: Vec<u32> = (0..narrow(flipping.across.len())).rev().collect();
    let mut left = MOST_FLIPS * flipping.triangles.len();
    while let Some(side) = due.pop() {
        let other = flipping.across[side as usize];
        if other == NONE || !flipping.is_better_flipped(side, other, &point, &turn) {
            continue;
        }
        if left == 0 {
            return;
        }
        left -= 1;
        due.extend(flipping.flip(side, other));
    }
}

/// For each side of triangles the number of that side in the other triangle. Side `3 t + k` of triangle t is opposite to its corner k.
fn across(triangles: &[[u32; 3]], sides: &[[u32; 2]]) -> Vec<u32> {
    let mut fixed = sides.to_vec();
    fixed.sort_unstable();
    let mut ends: Vec<([u32; 2], u32)> = Vec::with_capacity(3 * triangles.len());
    for (first, &[a, b, c]) in (0..).step_by(3).zip(triangles) {
        ends.extend([([b, c], first), ([c, a], first + 1), ([a, b], first + 2)]);
    }
    ends.retain(|(ends, _)| fixed.binary_search(ends).is_err());
    ends.sort_unstable();
    let mut across = vec![NONE; 3 * triangles.len()];
    for &([a, b], side) in &ends {
        if let Ok(other) = ends.binary_search_by_key(&[b, a], |other| other.0) {
            across[side as usize] = ends[other].1;
        }
    }
    across
}

struct Flipping<'a> {
    triangles: &'a mut [[u32; 3]],
    across: Vec<u32>,
}

/// The side of the same triangle that comes so many places later.
fn later(side: u32, places: u32) -> u32 {
    side - side % 3 + (side + places) % 3
}

impl Flipping<'_> {
    fn corner(&self, side: u32) -> u32 {
        self.triangles[(side / 3) as usize][(side % 3) as usize]
    }

    fn is_better_flipped(
        &self,
        side: u32,
        other: u32,
        point: &impl Fn(u32) -> [f64; 3],
        turn: &impl Fn(u32, u32, u32) -> Ordering,
    ) -> bool {
        let [c, a, b] = [0, 1, 2].map(|places| self.corner(later(side, places)));
        let d = self.corner(other);
        let places = [a, b, c, d].map(point);
        let [x, y] = angle(places[0], places[2], places[1]);
        let [z, w] = angle(places[1], places[3], places[0]);
        let lengths = (x * x + y * y).sqrt() * (z * z + w * w).sqrt();
        x * w + z * y < -MARGIN * lengths && turn(c, a, d).is_gt() && turn(d, b, c).is_gt()
    }

    /// Replaces a side by the other diagonal; the sides that may be flipped now.
    fn flip(&mut self, side: u32, other: u32) -> [u32; 4] {
        let [c, a, b] = [0, 1, 2].map(|places| self.corner(later(side, places)));
        let d = self.corner(other);
        // Opposite to a and b, in the triangles of c and of d.
        let [of_a, of_b] = [later(side, 1), later(side, 2)].map(|own| self.across[own as usize]);
        let [beside_b, beside_a] = [later(other, 1), later(other, 2)].map(|own| self.across[own as usize]);
        let (first, second) = (side - side % 3, other - other % 3);
        // Of the corners c, a, d and d, b, c.
        self.triangles[(first / 3) as usize] = [c, a, d];
        self.triangles[(second / 3) as usize] = [d, b, c];
        let mut join = |own: u32, beside: u32| {
            self.across[own as usize] = beside;
            if beside != NONE {
                self.across[beside as usize] = own;
            }
        };
        join(first, beside_b);
        join(first + 1, second + 1);
        join(first + 2, of_b);
        join(second, of_a);
        join(second + 2, beside_a);
        [first, first + 2, second, second + 2]
    }
}

/// The cosine and the sine of the angle at a corner of a triangle, times the same length.
fn angle(from: [f64; 3], corner: [f64; 3], to: [f64; 3]) -> [f64; 2] {
    let way = |end: [f64; 3]| [0, 1, 2].map(|axis| end[axis] - corner[axis]);
    let (u, v) = (way(from), way(to));
    let normal = cross(u, v);
    [dot(u, v), dot(normal, normal).sqrt()]
}
