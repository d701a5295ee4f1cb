//! A tree of arcs: which come near each other, and which come near a place.
//!
//! A binary tree of bounds stands on arcs, which are in the order of a Hilbert curve. Bounds are boxes at first, which is enough for most
//! sets. Where many arcs run side by side, each is cut where it turns from running along one axis to running along the other, and has a
//! [`Strip`] over the axis that it runs along; arcs over the same axis follow each other. Halves of arcs have strips that are thinner by
//! the fourth power of that. All bounds are wider than they must be by a margin far above rounding.

use super::strip::{Axis, Strip, Window};
use crate::curve::{bernstein, roots};
use coface_geometry::{Bounds, PairTask, PairTree, hilbert};
use rayon::prelude::*;
use std::ops::ControlFlow;

const LEAF: usize = 4;
/// Into how many parts a search is cut at least, when there is that much to do.
const TASKS: usize = 512;

/// Arcs run along an axis up to this slope. Not 1, as lines along diagonals are frequent and would run now along the one axis, now along the other.
const TURN: f64 = 1.37;

/// A tree on the arcs of polynomials.
pub(crate) struct ArcTree {
    /// The polynomial that the arc at each place is from.
    order: Vec<u32>,
    /// The strips of single arcs.
    strips: Vec<Strip>,
    /// The strips around leaves, and around nodes.
    tree: PairTree<Strip>,
}

/// Adds the strips of the arcs of a polynomial: its box for the depth 0, and else $2^{d - 1}$ for each arc that runs along an axis.
fn add_strips(controls: &[[f64; 2]], depth: u32, margin: f64, largest: f64, mut add: impl FnMut(Strip)) {
    let Some(halvings) = depth.checked_sub(1) else { return add(Strip::boxed(controls, margin, largest)) };
    let is_along_x = |step: [f64; 2]| step[1].abs() <= TURN * step[0].abs();
    let axis = |step: [f64; 2]| if is_along_x(step) { Axis::X } else { Axis::Y };
    let chord = |own: &[[f64; 2]]| [0, 1].map(|k| own[own.len() - 1][k] - own[0][k]);
    if bernstein::is_straight(controls) {
        return add(Strip::of_arc(controls, axis(chord(controls)), margin, largest));
    }
    let mut ends = vec![0.0];
    for slope in [TURN, -TURN] {
        let mut turns = [0.0; bernstein::Piece::MOST];
        for (turn, pair) in turns.iter_mut().zip(controls.windows(2)) {
            *turn = (pair[1][1] - pair[0][1]) - slope * (pair[1][0] - pair[0][0]);
        }
        ends.extend(roots::sign_changes(&turns[..controls.len() - 1]));
    }
    ends.push(1.0);
    ends.sort_unstable_by(f64::total_cmp);
    ends.dedup();
    let count = 1 << halvings;
    for range in ends.windows(2) {
        for part in 0..count {
            let at = |part: i32| range[0] + (range[1] - range[0]) * f64::from(part) / f64::from(count);
            let to = if part + 1 == count { range[1] } else { at(part + 1) };
            let arc = bernstein::sub_range(controls, [at(part), to]);
            add(Strip::of_arc(&arc, axis(chord(&arc)), margin, largest));
        }
    }
}

impl ArcTree {
    /// The tree of so many polynomials by their control points: of their boxes for the depth 0, and of ever thinner strips around ever
    /// shorter arcs for higher ones. Arcs within the margin of each other count as near.
    pub(crate) fn new<'a>(
        count: usize,
        controls: impl Fn(u32) -> &'a [[f64; 2]] + Sync,
        depth: u32,
        margin: f64,
    ) -> Self {
        let boxes = (0..count as u32)
            .into_par_iter()
            .with_min_len(4096)
            .map(|own| bernstein::control_box(controls(own)));
        let [low, high] = boxes.reduce(
            || [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]],
            |a, b| [[0, 1].map(|k| a[0][k].min(b[0][k])), [0, 1].map(|k| a[1][k].max(b[1][k]))],
        );
        let largest = low.iter().chain(&high).fold(0.0, |largest: f64, x| largest.max(x.abs()));
        // Places on the Hilbert curve have 32 bits an axis.
        let scale =
            f64::from(u32::MAX) / (0..2).fold(f64::MIN_POSITIVE, |most, k| (high[k] - low[k]).max(most));
        let arcs: Vec<Vec<(u32, Strip)>> = (0..count as u32)
            .into_par_iter()
            .with_min_len(512)
            .fold(Vec::new, |mut arcs, own| {
                add_strips(controls(own), depth, margin, largest, |strip| arcs.push((own, strip)));
                arcs
            })
            .collect();
        let arcs = arcs.concat();
        let mut places: Vec<(Axis, u64, u32)> = arcs
            .par_iter()
            .with_min_len(512)
            .enumerate()
            .map(|(number, (_, strip))| {
                let center = strip.center();
                let [x, y] = [0, 1].map(|k| ((center[k] - low[k]) * scale) as u32);
                (strip.axis(), hilbert(x, y), number as u32)
            })
            .collect();
        places.par_sort_unstable();
        let (order, strips): (Vec<u32>, Vec<Strip>) =
            places.iter().map(|&(.., number)| arcs[number as usize]).unzip();
        drop(arcs);
        let around =
            |inner: &[Strip]| inner[1..].iter().fold(inner[0], |whole, own| Bounds::around(&whole, own));
        let leaves = strips.par_chunks(LEAF).with_min_len(256).map(around).collect();
        let tree = PairTree::new(strips.len(), LEAF, leaves);
        Self { order, strips, tree }
    }

    /// The tasks of the search for all pairs; they do not depend on the number of threads.
    pub(super) fn tasks(&self) -> Vec<PairTask> {
        self.tree.tasks(TASKS)
    }

    /// Calls `found` for the pairs of different polynomials of a task with arcs whose bounds meet, the lower number first, until it says to
    /// stop; in all tasks once for each pair of their arcs.
    pub(super) fn search(
        &self,
        task: PairTask,
        mut found: impl FnMut(u32, u32) -> ControlFlow<()>,
    ) -> ControlFlow<()> {
        let mut pending = vec![task];
        while let Some([a, b]) = pending.pop() {
            if self.tree.split([a, b], |inner| pending.push(inner)) {
                continue;
            }
            for i in self.tree.leaf(a) {
                let first = if a == b { i + 1 } else { self.tree.leaf(b).start };
                for j in first..self.tree.leaf(b).end {
                    let [p, q] = [self.order[i], self.order[j]];
                    if p != q && !self.strips[i].is_apart(&self.strips[j]) {
                        found(p.min(q), p.max(q))?;
                    }
                }
            }
        }
        ControlFlow::Continue(())
    }

    /// A window around everything.
    pub(crate) fn window(&self) -> Window {
        self.tree.root().map_or([[0.0; 2]; 2], |root| self.tree.bounds(root).window())
    }

    /// Calls `found` for the polynomials with arcs whose bounds meet a window, once for each such arc.
    pub(crate) fn visit(&self, window: &Window, mut found: impl FnMut(u32)) {
        let mut pending: Vec<_> = self.tree.root().into_iter().collect();
        while let Some(node) = pending.pop() {
            if self.tree.bounds(node).misses(window) {
                continue;
            }
            if node.is_leaf() {
                let places = self.tree.leaf(node);
                places.filter(|&at| !self.strips[at].misses(window)).for_each(|at| found(self.order[at]));
            } else {
                pending.extend(self.tree.children(node));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::curve::bernstein::control_box;
    use proptest::prelude::*;

    const MARGIN: f64 = 1e-3;

    fn sampled(controls: &[[f64; 2]]) -> Vec<[f64; 2]> {
        (0..=24).map(|at| bernstein::value(controls, f64::from(at) / 24.0)).collect()
    }

    proptest! {
        /// Against brute force: pairs with points near each other are found, each pair of arcs once, and so is what crosses a window.
        #[test]
        fn what_comes_near_is_found(
            arcs in prop::collection::vec((prop::array::uniform4(prop::array::uniform2(-0.2..0.2f64)), prop::array::uniform2(-1.0..1.0f64)), 0..40),
            depth in 0..3u32,
            place in prop::array::uniform2(-1.0..1.0f64),
        ) {
            let arcs: Vec<Vec<[f64; 2]>> = arcs
                .into_iter()
                .map(|(own, [x, y])| own.iter().map(|point| [point[0] + x, point[1] + y]).collect())
                .collect();
            let tree = ArcTree::new(arcs.len(), |own| &arcs[own as usize], depth, MARGIN);
            let mut found = Vec::new();
            for task in tree.tasks() {
                let flow = tree.search(task, |a, b| {
                    found.push([a, b]);
                    ControlFlow::Continue(())
                });
                prop_assert!(flow.is_continue());
            }
            found.sort_unstable();
            found.dedup();
            let window = [[place[0], place[0] + 0.1], [place[1], place[1] + 0.3]];
            let mut inside = Vec::new();
            tree.visit(&window, |own| inside.push(own));
            for (i, a) in arcs.iter().enumerate() {
                let of_a = sampled(a);
                let is_inside = |p: &[f64; 2]| (0..2).all(|k| window[k][0] <= p[k] && p[k] <= window[k][1]);
                prop_assert!(!of_a.iter().any(is_inside) || inside.contains(&(i as u32)));
                for (j, b) in arcs.iter().enumerate().skip(i + 1) {
                    let of_b = sampled(b);
                    let is_near = |p: &[f64; 2], q: &[f64; 2]| (0..2).all(|k| (p[k] - q[k]).abs() <= MARGIN);
                    let are_near = of_a.iter().any(|p| of_b.iter().any(|q| is_near(p, q)));
                    let is_found = found.binary_search(&[i as u32, j as u32]).is_ok();
                    prop_assert!(!are_near || is_found, "{} {}", i, j);
                    // Boxes that are far apart are told apart.
                    let [of_a, of_b] = [control_box(a), control_box(b)];
                    let is_far = (0..2).any(|k| of_a[1][k] + 3.0 * MARGIN < of_b[0][k] || of_b[1][k] + 3.0 * MARGIN < of_a[0][k]);
                    prop_assert!(!(is_far && is_found), "{} {}", i, j);
                }
            }
            let [x, y] = tree.window();
            prop_assert!(arcs.iter().flat_map(|arc| sampled(arc)).all(|p| x[0] <= p[0] && p[0] <= x[1] && y[0] <= p[1] && p[1] <= y[1]));
        }
    }
}
