//! A tree of boxes: finds the boxes that overlap.

use coface_algebra::narrow;
use rayon::prelude::*;

/// A box with its faces along the axes: the least and the greatest coordinate on each axis.
pub type AxisBox = [[f64; 2]; 3];

/// The empty box: it is in every other box.
pub(crate) const EMPTY_BOX: AxisBox = [[f64::INFINITY, f64::NEG_INFINITY]; 3];

/// The smallest box around two.
pub(crate) fn box_around(a: &AxisBox, b: &AxisBox) -> AxisBox {
    [0, 1, 2].map(|axis| [a[axis][0].min(b[axis][0]), a[axis][1].max(b[axis][1])])
}

/// Whether two boxes have a point in common; a common boundary is enough.
///
/// # Examples
/// ```
/// use coface_geometry::boxes_meet;
/// let unit = [[0.0, 1.0]; 3];
/// assert!(boxes_meet(&unit, &[[1.0, 2.0]; 3]));
/// assert!(!boxes_meet(&unit, &[[1.5, 2.0]; 3]));
/// ```
pub fn boxes_meet(a: &AxisBox, b: &AxisBox) -> bool {
    a.iter().zip(b).all(|(a, b)| a[0] <= b[1] && b[0] <= a[1])
}

/// The box around many, in parallel.
///
/// # Examples
/// ```
/// let boxes = [[[0.0, 1.0]; 3], [[3.0, 4.0]; 3]];
/// assert_eq!(coface_geometry::frame_around(2, |i| boxes[i]), [[0.0, 4.0]; 3]);
/// ```
pub fn frame_around(count: usize, box_at: impl Fn(usize) -> AxisBox + Sync) -> AxisBox {
    (0..count).into_par_iter().map(&box_at).reduce(|| EMPTY_BOX, |a, b| box_around(&a, &b))
}

/// How many boxes, and how many nodes, are under one node.
const WIDTH: usize = 4;

/// The level of the nodes that [`BoxTree::pairs_of_group`] goes by. Under a node of the lowest level are four boxes.
const GROUP_LEVEL: usize = 3;

/// Four boxes, coordinate by coordinate, so that they are compared with another one at once. Those that are not there
/// meet none.
#[derive(Clone, Copy, Debug)]
struct Four {
    low: [[f64; WIDTH]; 3],
    high: [[f64; WIDTH]; 3],
}

impl Four {
    const EMPTY: Self = Self { low: [[f64::INFINITY; WIDTH]; 3], high: [[f64::NEG_INFINITY; WIDTH]; 3] };

    fn new(boxes: impl Iterator<Item = AxisBox>) -> Self {
        let mut four = Self::EMPTY;
        for (place, own) in boxes.enumerate() {
            for (axis, [low, high]) in own.into_iter().enumerate() {
                four.low[axis][place] = low;
                four.high[axis][place] = high;
            }
        }
        four
    }

    fn get(&self, place: usize) -> AxisBox {
        [0, 1, 2].map(|axis| [self.low[axis][place], self.high[axis][place]])
    }

    fn around(&self) -> AxisBox {
        (0..WIDTH).fold(EMPTY_BOX, |whole, place| box_around(&whole, &self.get(place)))
    }

    /// A bit for each of the boxes that meets this one.
    #[inline]
    fn meeting(&self, other: &AxisBox) -> u32 {
        let mut meets = [true; WIDTH];
        for ((low, high), [least, most]) in self.low.iter().zip(&self.high).zip(other) {
            for (place, meets) in meets.iter_mut().enumerate() {
                *meets &= (low[place] <= *most) & (*least <= high[place]);
            }
        }
        (0..WIDTH).map(|place| u32::from(meets[place]) << place).sum()
    }
}

/// A tree of boxes with faces along the axes: boxes sorted along a space-filling curve, four boxes to a node.
///
/// The order of answers depends on the boxes alone.
///
/// # Examples
/// ```
/// use coface_geometry::BoxTree;
/// let boxes = [[[0.0, 1.0]; 3], [[0.5, 2.0]; 3], [[7.0, 8.0]; 3]];
/// let tree = BoxTree::new(&boxes);
/// let mut met = Vec::new();
/// tree.visit(&[[0.0, 3.0]; 3], |number| met.push(number));
/// met.sort_unstable();
/// assert_eq!(met, [0, 1]);
/// ```
#[derive(Clone, Debug)]
pub struct BoxTree {
    /// The box at each place.
    order: Vec<u32>,
    /// What is under each node, the lowest level, with the boxes themselves, first; the last level has one node.
    levels: Vec<Vec<Four>>,
}

impl BoxTree {
    /// The tree of some boxes; none of them is empty.
    ///
    /// # Complexity
    /// $O(n \log n)$ time and $O(n)$ space.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::BoxTree;
    /// let tree = BoxTree::new(&[[[0.0, 1.0]; 3]]);
    /// let mut count = 0;
    /// tree.visit(&[[0.5, 0.5]; 3], |_| count += 1);
    /// assert_eq!(count, 1);
    /// ```
    pub fn new(boxes: &[AxisBox]) -> Self {
        Self::of(boxes.len(), |i| boxes[i])
    }

    /// The tree of the boxes that a function gives.
    pub(crate) fn of(count: usize, box_at: impl Fn(usize) -> AxisBox + Sync) -> Self {
        Self::in_frame(frame_around(count, &box_at), count, box_at)
    }

    /// The tree of boxes within a frame; boxes outside of it are sorted as if they were on its boundary.
    #[doc(hidden)]
    #[allow(
        clippy::cast_possible_truncation,
        reason = "a cast of a coordinate outside of the frame is clamped"
    )]
    pub fn in_frame(whole: AxisBox, count: usize, box_at: impl Fn(usize) -> AxisBox + Sync) -> Self {
        // Halved, so that no difference leaves the range.
        let origin = whole.map(|ends| ends[0] / 2.0);
        let extent = whole.map(|ends| ends[1] / 2.0 - ends[0] / 2.0).into_iter().fold(0.0, f64::max);
        let place = |own: AxisBox| {
            let mut code = 0;
            for axis in 0..3 {
                let middle = own[axis][0] / 4.0 + own[axis][1] / 4.0;
                let part = (middle - origin[axis]) / extent;
                // Casts of what is outside, or no number, stay in the range.
                code |= spread(((part * f64::from(1u32 << 21)) as u64).min((1 << 21) - 1)) << axis;
            }
            code
        };
        let mut order: Vec<(u64, u32)> =
            (0..count).into_par_iter().map(|i| (place(box_at(i)), narrow(i))).collect();
        order.par_sort_unstable();
        let order: Vec<u32> = order.into_iter().map(|(_, i)| i).collect();
        let lowest = order.par_chunks(WIDTH).map(|own| Four::new(own.iter().map(|&i| box_at(i as usize))));
        let mut levels: Vec<Vec<Four>> = vec![lowest.collect()];
        while let Some(last) = levels.last().filter(|last| last.len() > 1) {
            levels.push(last.chunks(WIDTH).map(|own| Four::new(own.iter().map(Four::around))).collect());
        }
        Self { order, levels }
    }

    /// The boxes by their numbers, along a curve that keeps near ones near each other.
    ///
    /// # Examples
    /// ```
    /// let place = |x: f64| [[x, x]; 3];
    /// let tree = coface_geometry::BoxTree::new(&[place(0.0), place(9.0), place(1.0)]);
    /// assert_eq!(tree.order(), [0, 2, 1]);
    /// ```
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// The level of the groups: lower for few boxes.
    fn group_level(&self) -> usize {
        GROUP_LEVEL.min(self.levels.len() - 1)
    }

    /// The number of groups that [`Self::pairs_of_group`] goes by: there are up to 256 boxes in each.
    #[doc(hidden)]
    pub fn group_count(&self) -> usize {
        self.levels[self.group_level()].len()
    }

    /// Calls for pairs of boxes that meet, of which the one that comes first in the tree is in this group: over all
    /// groups, each pair once.
    #[doc(hidden)]
    pub fn pairs_of_group(&self, group: usize, mut visit: impl FnMut(u32, u32)) {
        let level = self.group_level();
        let around = self.levels[level][group].around();
        let mut others = Vec::new();
        self.visit_nodes(&around, level, group, |node| others.push(narrow(node)));
        self.join(level, group, &others, &mut vec![Vec::new(); level], &mut visit);
    }

    /// Calls for the pairs of boxes that meet, the first under this node, the second under one of these of the same
    /// level and after it. `lists` has room for each level below.
    fn join(
        &self,
        level: usize,
        node: usize,
        others: &[u32],
        lists: &mut [Vec<u32>],
        visit: &mut impl FnMut(u32, u32),
    ) {
        let nodes = &self.levels[level];
        for place in 0..WIDTH {
            let inner = node * WIDTH + place;
            let query = nodes[node].get(place);
            // Nodes come after themselves, boxes do not.
            let first = inner + usize::from(level == 0);
            let found = others.iter().flat_map(|&other| {
                let start = other as usize * WIDTH;
                let before = first.saturating_sub(start).min(WIDTH);
                Bits(nodes[other as usize].meeting(&query) >> before << before)
                    .map(move |place| start + place as usize)
            });
            let Some((list, lower)) = lists.split_last_mut() else {
                found.for_each(|other| visit(self.order[inner], self.order[other]));
                continue;
            };
            list.clear();
            list.extend(found.map(narrow));
            if !list.is_empty() {
                self.join(level - 1, inner, list, lower, visit);
            }
        }
    }

    /// Calls `visit` with the number of each box that has a point in common with this one.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::BoxTree;
    /// let tree = BoxTree::new(&[[[0.0, 1.0]; 3], [[5.0, 6.0]; 3]]);
    /// tree.visit(&[[4.0, 5.0]; 3], |number| assert_eq!(number, 1));
    /// ```
    pub fn visit(&self, query: &AxisBox, mut visit: impl FnMut(u32)) {
        self.visit_nodes(query, 0, 0, |node| {
            Bits(self.levels[0][node].meeting(query))
                .for_each(|place| visit(self.order[node * WIDTH + place as usize]));
        });
    }

    /// Calls for the nodes of a level from `first` on that may have something under them that meets this box, rising.
    fn visit_nodes(&self, query: &AxisBox, level: usize, first: usize, mut visit: impl FnMut(usize)) {
        if self.order.is_empty() {
            return;
        }
        let mut pending = vec![(self.levels.len() - 1, 0)];
        while let Some((at, node)) = pending.pop() {
            if at == level {
                visit(node);
                continue;
            }
            let meeting = self.levels[at][node].meeting(query);
            for place in (0..WIDTH).rev().filter(|place| meeting >> place & 1 != 0) {
                let inner = node * WIDTH + place;
                // The last node of the level under it.
                if ((inner + 1) << (2 * (at - 1 - level))) > first {
                    pending.push((at - 1, inner));
                }
            }
        }
    }
}

/// The positions of the bits of a number that are set, rising.
struct Bits(u32);

impl Iterator for Bits {
    type Item = u32;

    fn next(&mut self) -> Option<u32> {
        let place = self.0.trailing_zeros();
        self.0 &= self.0.wrapping_sub(1);
        (place < u32::BITS).then_some(place)
    }
}

/// The 21 lowest bits, each followed by two zeros.
fn spread(x: u64) -> u64 {
    let x = (x | x << 32) & 0x001f_0000_0000_ffff;
    let x = (x | x << 16) & 0x001f_0000_ff00_00ff;
    let x = (x | x << 8) & 0x100f_00f0_0f00_f00f;
    let x = (x | x << 4) & 0x10c3_0c30_c30c_30c3;
    (x | x << 2) & 0x1249_2492_4924_9249
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn boxes() -> impl Strategy<Value = Vec<AxisBox>> {
        let ends = prop_oneof![
            (-9i32..10, 0i32..4).prop_map(|(x, d)| [f64::from(x), f64::from(x + d)]),
            Just([-f64::MAX, f64::MAX]),
            Just([1e-300, 2e-300]),
        ];
        prop::collection::vec(prop::array::uniform3(ends), 0..300)
    }

    proptest! {
        #[test]
        fn each_pair_is_found_once(boxes in boxes()) {
            let tree = BoxTree::new(&boxes);
            let mut found = Vec::new();
            for group in 0..tree.group_count() {
                tree.pairs_of_group(group, |i, j| found.push([i.min(j), i.max(j)]));
            }
            found.sort_unstable();
            let count = boxes.len();
            let pairs = (0..count).flat_map(|i| (i + 1..count).map(move |j| [i, j]));
            let expected: Vec<[u32; 2]> = pairs
                .filter(|&[i, j]| boxes_meet(&boxes[i], &boxes[j]))
                .map(|pair| pair.map(|i| i as u32))
                .collect();
            prop_assert_eq!(found, expected);
            for (i, query) in boxes.iter().enumerate() {
                let mut found = Vec::new();
                tree.visit(query, |j| found.push(j as usize));
                found.sort_unstable();
                let expected: Vec<usize> = (0..count).filter(|&j| boxes_meet(query, &boxes[j])).collect();
                prop_assert_eq!(found, expected, "{}", i);
            }
        }
    }
}
