//! A binary tree of bounds over things in an order: finds the pairs of things that come near each other.
//!
//! What bounds are is up to whoever has the things: boxes along the axes, boxes along a direction of their own, or both.

use coface_algebra::narrow;
use rayon::prelude::*;
use std::ops::Range;

/// What a node of a [`PairTree`] knows of the things below it.
pub trait Bounds: Copy + Send + Sync {
    /// Bounds around all that is within two of them.
    fn around(a: &Self, b: &Self) -> Self;

    /// Whether nothing within these bounds comes near what is within those; `false` says nothing.
    fn is_apart(&self, other: &Self) -> bool;
}

/// A node by its level and its number on it; leaves have the level 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct PairNode {
    level: u32,
    index: u32,
}

impl PairNode {
    /// Whether there are things below the node, and no nodes.
    pub fn is_leaf(self) -> bool {
        self.level == 0
    }

    /// The number of the node on its level.
    pub fn index(self) -> usize {
        self.index as usize
    }
}

/// A part of a search: all pairs with one thing below each of two nodes.
pub type PairTask = [PairNode; 2];

/// A binary tree over things in an order in which near ones mostly follow each other, such as that of [`hilbert`].
#[derive(Clone, Debug)]
pub struct PairTree<B> {
    count: usize,
    leaf_size: usize,
    /// The bounds of leaves, then around two bounds each, up to one.
    levels: Vec<Vec<B>>,
}

impl<B: Bounds> PairTree<B> {
    /// The tree of `count` things, of which each leaf but the last has `leaf_size`, given the bounds of the leaves.
    ///
    /// # Panics
    /// If there is not one for each leaf.
    pub fn new(count: usize, leaf_size: usize, leaves: Vec<B>) -> Self {
        assert_eq!(leaves.len(), count.div_ceil(leaf_size), "each leaf has bounds");
        let mut levels = vec![leaves];
        while let Some(below) = levels.last().filter(|below| below.len() > 1) {
            let above = below.par_chunks(2).with_min_len(256).map(|pair| match pair {
                [a, b] => B::around(a, b),
                _ => pair[0],
            });
            let above = above.collect();
            levels.push(above);
        }
        Self { count, leaf_size, levels }
    }

    /// The bounds of a node.
    #[inline]
    pub fn bounds(&self, node: PairNode) -> &B {
        &self.levels[node.level as usize][node.index as usize]
    }

    /// The node above all others; `None` if there is no thing.
    pub fn root(&self) -> Option<PairNode> {
        (self.count > 0).then(|| PairNode { level: narrow(self.levels.len() - 1), index: 0 })
    }

    /// The one or two nodes below a node that is no leaf.
    #[inline]
    pub fn children(&self, node: PairNode) -> impl Iterator<Item = PairNode> + Clone + use<B> {
        let level = node.level - 1;
        let end = (2 * node.index + 2).min(narrow(self.levels[level as usize].len()));
        (2 * node.index..end).map(move |index| PairNode { level, index })
    }

    /// The places in the order of the things in a leaf.
    #[inline]
    pub fn leaf(&self, node: PairNode) -> Range<usize> {
        let first = node.index as usize * self.leaf_size;
        first..(first + self.leaf_size).min(self.count)
    }

    /// Calls `found` with the pairs that a pair of nodes falls into; nothing when their bounds are apart. `false` for
    /// leaves that are not.
    #[inline]
    pub fn split(&self, [a, b]: PairTask, mut found: impl FnMut(PairTask)) -> bool {
        if a == b {
            if a.is_leaf() {
                return false;
            }
            let inner = self.children(a);
            for (i, c) in inner.clone().enumerate() {
                inner.clone().skip(i).for_each(|d| found([c, d]));
            }
            return true;
        }
        if self.bounds(a).is_apart(self.bounds(b)) {
            return true;
        }
        if a.is_leaf() && b.is_leaf() {
            return false;
        }
        if a.level >= b.level {
            self.children(a).for_each(|c| found([c, b]));
        } else {
            self.children(b).for_each(|c| found([a, c]));
        }
        true
    }

    /// The parts of the search for all pairs, at least so many if there is that much to do. They do not depend on the
    /// number of threads.
    pub fn tasks(&self, least: usize) -> Vec<PairTask> {
        let mut tasks: Vec<PairTask> = self.root().map(|root| [root, root]).into_iter().collect();
        while tasks.len() < least {
            let mut finer = Vec::with_capacity(3 * tasks.len());
            let mut is_final = true;
            for &task in &tasks {
                if self.split(task, |inner| finer.push(inner)) {
                    is_final = false;
                } else {
                    finer.push(task);
                }
            }
            tasks = finer;
            if is_final {
                break;
            }
        }
        tasks
    }

    /// Calls `meet` for the pairs of leaves of a task that are not apart, each leaf with itself among them; in all tasks
    /// each pair once.
    #[inline]
    pub fn search(&self, task: PairTask, mut meet: impl FnMut(PairTask)) {
        let mut stack = vec![task];
        while let Some(pair) = stack.pop() {
            if !self.split(pair, |inner| stack.push(inner)) {
                meet(pair);
            }
        }
    }
}

/// The place of a point of the square of side $2^{32}$ on the Hilbert curve. Points of the square of side $2^{16}$ have
/// the places that they have on the curve of that square.
pub fn hilbert(mut x: u32, mut y: u32) -> u64 {
    let mut place = 0;
    for level in (0..32).rev() {
        let [right, up] = [x >> level & 1, y >> level & 1];
        place = place << 2 | u64::from((3 * right) ^ up);
        // In the lower half the curve is turned, in the lower right one the other way.
        let flip = (right & !up & 1).wrapping_neg();
        (x, y) = (x ^ flip, y ^ flip);
        let swap = (x ^ y) & (!up & 1).wrapping_neg();
        (x, y) = (x ^ swap, y ^ swap);
    }
    place
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[derive(Clone, Copy, Debug)]
    struct Interval([i32; 2]);

    impl Bounds for Interval {
        fn around(a: &Self, b: &Self) -> Self {
            Self([a.0[0].min(b.0[0]), a.0[1].max(b.0[1])])
        }

        fn is_apart(&self, other: &Self) -> bool {
            self.0[1] < other.0[0] || other.0[1] < self.0[0]
        }
    }

    proptest! {
        #[test]
        fn each_pair_that_is_not_apart_is_found_once(
            ends in prop::collection::vec((-40i32..40, 0i32..5), 0..120),
            leaf_size in 1usize..6,
            least in 1usize..200,
        ) {
            let intervals: Vec<Interval> = ends.iter().map(|&(x, d)| Interval([x, x + d])).collect();
            let leaf = |own: &[Interval]| own[1..].iter().fold(own[0], |whole, own| Interval::around(&whole, own));
            let tree =
                PairTree::new(intervals.len(), leaf_size, intervals.chunks(leaf_size).map(leaf).collect());
            let mut found = Vec::new();
            for task in tree.tasks(least) {
                tree.search(task, |[a, b]| {
                    for i in tree.leaf(a) {
                        let first = if a == b { i + 1 } else { tree.leaf(b).start };
                        for j in first..tree.leaf(b).end {
                            if !intervals[i].is_apart(&intervals[j]) {
                                found.push([i.min(j), i.max(j)]);
                            }
                        }
                    }
                });
            }
            found.sort_unstable();
            let count = intervals.len();
            let pairs = (0..count).flat_map(|i| (i + 1..count).map(move |j| [i, j]));
            let expected: Vec<[usize; 2]> =
                pairs.filter(|&[i, j]| !intervals[i].is_apart(&intervals[j])).collect();
            prop_assert_eq!(found, expected);
        }
    }

    #[test]
    fn points_that_follow_each_other_on_the_curve_are_neighbors() {
        let mut places: Vec<(u64, [i32; 2])> =
            (0..64).flat_map(|x| (0..64).map(move |y| (hilbert(x, y), [x as i32, y as i32]))).collect();
        places.sort_unstable();
        for (step, pair) in places.windows(2).enumerate() {
            assert_eq!(pair[0].0, step as u64);
            let [[a, b], [c, d]] = [pair[0].1, pair[1].1];
            assert_eq!((a - c).abs() + (b - d).abs(), 1);
        }
    }
}
