//! Triangles of a panel that are thinner than the tolerance, along sides that nothing else has.
//!
//! A vertex that is near a side of its triangle is meant to be on that side. If the side is between two triangles of the
//! panel, it can be replaced by the other diagonal of these two: then no side runs past the vertex, where another
//! panel has two sides that end in it.

use crate::near::{NearChains, minus, plus, squared};
use coface_geometry::{cross, dot};
use std::collections::HashMap;

/// So many flips a triangle are enough for all that was seen; more would be going round in circles.
const MOST_FLIPS: usize = 16;

impl NearChains {
    /// Flips sides that are near the third corner of one of their triangles, where the two opposite angles, seen along the
    /// normal from where triangles run counterclockwise, are together more than two right ones. `fixed` has the sides that
    /// stay, rising, the lower end first.
    pub(super) fn flip_thin(
        &self,
        triangles: &mut [[u32; 3]],
        fixed: &[[u32; 2]],
        normal: [f64; 3],
        tolerance: f64,
    ) {
        if triangles.len() < 2 {
            return;
        }
        // The triangle on the left of each directed side; `None` where there are several.
        let mut left: HashMap<[u32; 2], Option<usize>> = HashMap::with_capacity(3 * triangles.len());
        for (number, &[a, b, c]) in triangles.iter().enumerate() {
            for side in [[a, b], [b, c], [c, a]] {
                left.entry(side).and_modify(|own| *own = None).or_insert(Some(number));
            }
        }
        let limit = tolerance * tolerance;
        let mut most = MOST_FLIPS * triangles.len();
        let mut due: Vec<usize> = (0..triangles.len()).rev().collect();
        while let Some(number) = due.pop() {
            let [x, y, z] = triangles[number];
            for [a, b, c] in [[x, y, z], [y, z, x], [z, x, y]] {
                // c is the corner opposite to the side from a to b.
                if fixed.binary_search(&[a.min(b), a.max(b)]).is_ok()
                    || !self.is_beside([a, b], c, normal, limit)
                {
                    continue;
                }
                let Some(&Some(other)) = left.get(&[b, a]) else { continue };
                let Some(&d) = triangles[other].iter().find(|&&d| d != a && d != b) else { continue };
                if other == number
                    || left.get(&[a, b]) != Some(&Some(number))
                    || d == c
                    || left.contains_key(&[c, d])
                    || left.contains_key(&[d, c])
                    || !self.is_flat_pair([a, b], [c, d], normal)
                    || most == 0
                {
                    continue;
                }
                most -= 1;
                left.remove(&[a, b]);
                left.remove(&[b, a]);
                (triangles[number], triangles[other]) = ([c, a, d], [d, b, c]);
                for (side, own) in [
                    ([c, a], number),
                    ([a, d], number),
                    ([d, c], number),
                    ([d, b], other),
                    ([b, c], other),
                    ([c, d], other),
                ] {
                    left.entry(side).and_modify(|known| *known = known.map(|_| own)).or_insert(Some(own));
                }
                due.extend([other, number]);
                break;
            }
        }
    }

    /// Whether a vertex is beside the inside of a side, and near, as seen along the normal.
    fn is_beside(&self, [a, b]: [u32; 2], vertex: u32, normal: [f64; 3], limit: f64) -> bool {
        let [along, to] = [b, vertex].map(|end| {
            let way = minus(self.point(end), self.point(a));
            plus(way, -dot(way, normal), normal)
        });
        let part = dot(along, to) / squared(along);
        part > 0.0 && part < 1.0 && squared(plus(to, -part, along)) <= limit
    }

    /// Whether the angles opposite to a side from a to b are together more than two right ones: the first is that of a
    /// triangle on the left, which may be turned over, the second on the right.
    fn is_flat_pair(&self, [a, b]: [u32; 2], [c, d]: [u32; 2], normal: [f64; 3]) -> bool {
        // The cosine and the sine of an angle, times the same length.
        let angle = |[from, corner, to]: [u32; 3]| {
            let [u, v] = [from, to].map(|end| minus(self.point(end), self.point(corner)));
            [dot(u, v) - dot(u, normal) * dot(v, normal), dot(cross(u, v), normal)]
        };
        let ([x, y], [z, w]) = (angle([a, c, b]), angle([b, d, a]));
        x * w + z * y < 0.0
    }
}
