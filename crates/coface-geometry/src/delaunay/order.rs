//! The order in which points are inserted.

use crate::pair_tree::hilbert;
use crate::predicates::WeightedPoint;
use rayon::prelude::*;
use std::cmp::Reverse;

/// The numbers of the points, without those that equal another one of more weight or, with no more weight, of a smaller number; in rounds that grow eight
/// times each, along a Hilbert curve in each round.
///
/// # References
/// N. Amenta, S. Choi, G. Rote, *Incremental constructions con BRIO* (2003).
pub(super) fn insertion_order(points: &[WeightedPoint], is_planar: bool) -> Vec<u32> {
    let frame = Frame::around(points);
    let mut keys: Vec<(Reverse<u32>, u64, u32)> = (0..points.len() as u32)
        .into_par_iter()
        .map(|id| {
            let place = frame.place(points[id as usize].point(), is_planar);
            (Reverse(round(id)), place, id)
        })
        .collect();
    // Equal points are neighbors by place, whatever their rounds.
    keys.par_sort_unstable_by(|a, b| {
        let [p, q] = [a.2, b.2].map(|id| points[id as usize]);
        (a.1.cmp(&b.1))
            .then_with(|| compared(p.point(), q.point()))
            .then_with(|| q.weight().total_cmp(&p.weight()))
            .then(a.2.cmp(&b.2))
    });
    keys.dedup_by(|later, earlier| points[later.2 as usize].point() == points[earlier.2 as usize].point());
    keys.par_sort_unstable();
    keys.into_iter().map(|(.., id)| id).collect()
}

fn compared(p: [f64; 3], q: [f64; 3]) -> std::cmp::Ordering {
    p.partial_cmp(&q).expect("coordinates are numbers")
}

/// The round of a point, counted from the last one: an eighth of the points is in an earlier round than the others.
fn round(id: u32) -> u32 {
    let mixed = (u64::from(id) + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    let mixed = (mixed ^ (mixed >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
    (mixed ^ (mixed >> 27)).leading_zeros() / 3
}

/// The box of the points.
struct Frame {
    least: [f64; 3],
    /// Twice the longest side, from half coordinates.
    side: f64,
}

impl Frame {
    fn around(points: &[WeightedPoint]) -> Self {
        let (mut least, mut most) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for point in points {
            for (axis, x) in point.point().into_iter().enumerate() {
                least[axis] = least[axis].min(x);
                most[axis] = most[axis].max(x);
            }
        }
        // Halves do not overflow.
        let side = (0..3).map(|axis| most[axis] * 0.5 - least[axis] * 0.5).fold(0.0, f64::max);
        Self { least, side }
    }

    /// The place of a point on the curve.
    fn place(&self, point: [f64; 3], is_planar: bool) -> u64 {
        let bits = if is_planar { 32 } else { SPATIAL_BITS };
        let most = ((1u64 << bits) - 1) as f64;
        let [x, y, z] = [0, 1, 2].map(|axis| {
            let share = (point[axis] * 0.5 - self.least[axis] * 0.5) / self.side;
            // Not a number where all points are at one place.
            (share * most).clamp(0.0, most) as u32
        });
        if is_planar { hilbert(x, y) } else { spatial_hilbert([x, y, z]) }
    }
}

/// The bits of a coordinate in a place of 63 bits.
const SPATIAL_BITS: u32 = 21;

/// The place of a point of the cube of side 2^21 on the Hilbert curve.
///
/// # References
/// J. Skilling, *Programming the Hilbert curve* (2004).
fn spatial_hilbert(mut x: [u32; 3]) -> u64 {
    let levels = || (1..SPATIAL_BITS).rev().map(|level| 1u32 << level);
    for bit in levels() {
        for axis in 0..3 {
            if x[axis] & bit != 0 {
                x[0] ^= bit - 1;
            } else {
                let swap = (x[0] ^ x[axis]) & (bit - 1);
                x[0] ^= swap;
                x[axis] ^= swap;
            }
        }
    }
    x[1] ^= x[0];
    x[2] ^= x[1];
    let turn = levels().filter(|bit| x[2] & bit != 0).fold(0, |turn, bit| turn ^ (bit - 1));
    let x = x.map(|x| x ^ turn);
    (0..SPATIAL_BITS)
        .rev()
        .fold(0, |place, level| x.iter().fold(place, |place, x| place << 1 | u64::from(x >> level & 1)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_of_the_curve_are_steps_of_the_grid() {
        // The first 8^3 places are those of a cube of side 8.
        let mut cube: Vec<(u64, [u32; 3])> =
            (0..512).map(|i| [i >> 6, i >> 3 & 7, i & 7]).map(|x| (spatial_hilbert(x), x)).collect();
        cube.sort_unstable();
        assert!(cube.iter().enumerate().all(|(i, &(place, _))| place == i as u64));
        for two in cube.windows(2) {
            let steps: u32 = (0..3).map(|axis| two[0].1[axis].abs_diff(two[1].1[axis])).sum();
            assert_eq!(steps, 1, "{two:?}");
        }
    }

    #[test]
    fn of_equal_points_the_first_one_of_the_most_weight_stays() {
        let at = |x: f64, weight: f64| WeightedPoint::new([x, 0.0, 0.0], weight);
        let points = [at(1.0, 0.0), at(0.0, 1.0), at(-0.0, 2.0), at(0.0, 2.0), at(1.0, 0.0)];
        let mut order = insertion_order(&points, true);
        order.sort_unstable();
        assert_eq!(order, [0, 2]);
        assert!(insertion_order(&[], false).is_empty());
    }
}
