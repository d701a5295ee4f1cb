//! Which parts come near each other: a tree of boxes along the axes and along chords.
//!
//! Parts that follow each other stay together in runs of four; runs are in the order of a Hilbert curve, and a binary tree stands on
//! them. Each node has a box along the axes and one along a direction of its own, so that long thin parts side by side are told
//! apart. Boxes are wider than they must be by a margin far above rounding. Where many bent parts run side by side, each is cut into
//! shorter arcs, whose boxes are thinner by the square of that.

use super::Pieces;
use super::polynomial::{cross, dot, minus};
use coface_geometry::{Bounds, PairTask, PairTree, hilbert};
use rayon::prelude::*;

const LEAF: usize = 4;
/// Into how many parts a search is cut at least, when there is that much to do.
const TASKS: usize = 512;

/// Two boxes around the same points.
#[derive(Clone, Copy)]
struct TwoBoxes {
    low: [f64; 2],
    high: [f64; 2],
    /// A unit vector.
    axis: [f64; 2],
    /// The least and greatest coordinates along the axis, and across it to the left.
    along: [f64; 2],
    across: [f64; 2],
}

/// A tree on the parts of pieces.
pub(super) struct PartTree {
    /// The part at each place, of which there is one arc or several.
    order: Vec<u32>,
    /// The boxes of single arcs.
    boxes: Vec<TwoBoxes>,
    /// The boxes around leaves, and around nodes.
    tree: PairTree<TwoBoxes>,
}

const UP: [f64; 2] = [1.0, 0.0];

impl TwoBoxes {
    fn along_axis(axis: [f64; 2], points: impl Iterator<Item = [f64; 2]>) -> [[f64; 2]; 2] {
        let [mut low, mut high] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for point in points {
            let at = [dot(axis, point), cross(axis, point)];
            for k in 0..2 {
                low[k] = low[k].min(at[k]);
                high[k] = high[k].max(at[k]);
            }
        }
        [0, 1].map(|k| [low[k], high[k]])
    }

    fn of_points(points: &[[f64; 2]], margin: f64) -> Self {
        let [x, y] = Self::along_axis(UP, points.iter().copied());
        let chord = minus(points[points.len() - 1], points[0]);
        let length = chord[0].hypot(chord[1]);
        let axis = if length > 1e-12 { chord.map(|x| x / length) } else { UP };
        let [along, across] = Self::along_axis(axis, points.iter().copied());
        Self {
            low: [x[0] - margin, y[0] - margin],
            high: [x[1] + margin, y[1] + margin],
            axis,
            along: [along[0] - margin, along[1] + margin],
            across: [across[0] - margin, across[1] + margin],
        }
    }

    fn corners(&self) -> impl Iterator<Item = [f64; 2]> {
        let Self { axis, along, across, .. } = *self;
        [[0, 0], [0, 1], [1, 1], [1, 0]].into_iter().map(move |[i, j]| {
            let [x, y] = [along[i], across[j]];
            [x * axis[0] - y * axis[1], x * axis[1] + y * axis[0]]
        })
    }

    /// Whether a side of the turned box separates it from the other.
    fn is_beside(&self, other: &Self) -> bool {
        let [along, across] = Self::along_axis(self.axis, other.corners());
        along[0] > self.along[1]
            || along[1] < self.along[0]
            || across[0] > self.across[1]
            || across[1] < self.across[0]
    }
}

impl Bounds for TwoBoxes {
    fn around(a: &Self, b: &Self) -> Self {
        let mut best: Option<(f64, [f64; 2], [[f64; 2]; 2])> = None;
        for axis in [UP, a.axis, b.axis] {
            let [along, across] = Self::along_axis(axis, a.corners().chain(b.corners()));
            let area = (along[1] - along[0]) * (across[1] - across[0]);
            if best.as_ref().is_none_or(|best| area < best.0) {
                best = Some((area, axis, [along, across]));
            }
        }
        let (_, axis, [along, across]) = best.expect("there are three axes");
        Self {
            low: [0, 1].map(|k| a.low[k].min(b.low[k])),
            high: [0, 1].map(|k| a.high[k].max(b.high[k])),
            axis,
            along,
            across,
        }
    }

    fn is_apart(&self, other: &Self) -> bool {
        (0..2).any(|k| self.high[k] < other.low[k] || other.high[k] < self.low[k])
            || self.is_beside(other)
            || other.is_beside(self)
    }
}

impl PartTree {
    /// The tree of all parts, each bent one cut into $2^d$ arcs for a depth d; boxes within the resolution of each other count as near.
    pub(super) fn new(pieces: &Pieces<'_>, depth: u32) -> Self {
        let margin = pieces.frame.resolution;
        let arcs: Vec<(u32, TwoBoxes)> = (0..pieces.parts().len() as u32)
            .into_par_iter()
            .with_min_len(512)
            .flat_map_iter(|part| {
                let piece = pieces.parts()[part as usize].piece as usize;
                let own = pieces.part_polynomial(part as usize);
                let mut arcs = vec![own];
                for _ in 0..if pieces.is_straight(piece) { 0 } else { depth } {
                    arcs = arcs.iter().flat_map(|arc| arc.split(0.5)).collect();
                }
                arcs.into_iter().map(move |arc| (part, TwoBoxes::of_points(arc.controls(), margin)))
            })
            .collect();
        let count = arcs.len();
        let mut runs: Vec<(u64, u32)> = (0..count.div_ceil(LEAF))
            .into_par_iter()
            .with_min_len(512)
            .map(|run| {
                let TwoBoxes { low, high, .. } = arcs[(run * LEAF + LEAF / 2).min(count - 1)].1;
                let [x, y] = [0, 1].map(|k| ((0.5 * (low[k] + high[k]) + 0.5) * 65535.0) as u32);
                (hilbert(x.min(65535), y.min(65535)), run as u32)
            })
            .collect();
        runs.par_sort_unstable();
        let (mut order, mut boxes) = (Vec::with_capacity(count), Vec::with_capacity(count));
        for (_, run) in runs {
            let first = run as usize * LEAF;
            for &(part, own) in &arcs[first..(first + LEAF).min(count)] {
                order.push(part);
                boxes.push(own);
            }
        }
        let around =
            |inner: &[TwoBoxes]| inner[1..].iter().fold(inner[0], |whole, own| TwoBoxes::around(&whole, own));
        let leaves = boxes.par_chunks(LEAF).with_min_len(256).map(around).collect();
        let tree = PairTree::new(count, LEAF, leaves);
        Self { order, boxes, tree }
    }

    /// The tasks of the search for all pairs; they do not depend on the number of threads.
    pub(super) fn tasks(&self) -> Vec<PairTask> {
        self.tree.tasks(TASKS)
    }

    /// Calls `found` for the pairs of different parts of a task whose boxes meet, the lower number first; in all tasks each
    /// once for each pair of their arcs.
    pub(super) fn search(&self, task: PairTask, mut found: impl FnMut(u32, u32)) {
        self.tree.search(task, |[a, b]| {
            for i in self.tree.leaf(a) {
                let first = if a == b { i + 1 } else { self.tree.leaf(b).start };
                for j in first..self.tree.leaf(b).end {
                    let [p, q] = [self.order[i], self.order[j]];
                    if p != q && !self.boxes[i].is_apart(&self.boxes[j]) {
                        found(p.min(q), p.max(q));
                    }
                }
            }
        });
    }
}
