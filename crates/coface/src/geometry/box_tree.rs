//! Boxes in a tree: which of many boxes overlap.

use rayon::prelude::*;

/// A box with its faces along the axes: the least and the greatest coordinate on each axis.
pub(crate) type AxisBox = [[f64; 2]; 3];

/// The box that is in every other box.
pub(crate) const EMPTY_BOX: AxisBox = [[f64::INFINITY, f64::NEG_INFINITY]; 3];

/// The smallest box around two.
pub(crate) fn box_around(a: &AxisBox, b: &AxisBox) -> AxisBox {
    [0, 1, 2].map(|axis| [a[axis][0].min(b[axis][0]), a[axis][1].max(b[axis][1])])
}

/// Whether two boxes have a point in common; a common boundary is enough.
pub(crate) fn boxes_meet(a: &AxisBox, b: &AxisBox) -> bool {
    a.iter().zip(b).all(|(a, b)| a[0] <= b[1] && b[0] <= a[1])
}

/// How many boxes, and how many nodes, are under one node.
const WIDTH: usize = 4;

/// Boxes sorted along a space-filling curve, with the boxes around each four of them, around each four of those, and so on.
///
/// The order of answers depends on the boxes alone.
#[derive(Clone, Debug)]
pub(crate) struct BoxTree {
    /// The box at each place.
    order: Vec<u32>,
    boxes: Vec<AxisBox>,
    /// Boxes around four, the lowest level first; the last level has one.
    levels: Vec<Vec<AxisBox>>,
}

impl BoxTree {
    /// The tree of some boxes; none of them is empty.
    ///
    /// # Complexity
    /// $O(n \log n)$ time and $O(n)$ space.
    pub(crate) fn new(boxes: &[AxisBox]) -> Self {
        let whole = boxes.iter().fold(EMPTY_BOX, |whole, own| box_around(&whole, own));
        // Halved, so that no difference leaves the range.
        let origin = whole.map(|ends| ends[0] / 2.0);
        let extent = whole.map(|ends| ends[1] / 2.0 - ends[0] / 2.0).into_iter().fold(0.0, f64::max);
        let place = |own: &AxisBox| {
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
            boxes.par_iter().enumerate().map(|(i, own)| (place(own), i as u32)).collect();
        order.par_sort_unstable();
        let order: Vec<u32> = order.into_iter().map(|(_, i)| i).collect();
        let boxes: Vec<AxisBox> = order.iter().map(|&i| boxes[i as usize]).collect();
        let around = |inner: &[AxisBox]| -> Vec<AxisBox> {
            inner
                .chunks(WIDTH)
                .map(|own| own.iter().fold(EMPTY_BOX, |whole, own| box_around(&whole, own)))
                .collect()
        };
        let mut levels = vec![around(&boxes)];
        while let Some(last) = levels.last().filter(|last| last.len() > 1) {
            levels.push(around(last));
        }
        Self { order, boxes, levels }
    }

    /// The number of groups that [`Self::pairs_of_group`] goes by.
    pub(crate) fn group_count(&self) -> usize {
        self.levels[0].len()
    }

    /// Calls for pairs of boxes that meet, of which the one that comes first in the tree is in this group: over all groups, each
    /// pair once.
    pub(crate) fn pairs_of_group(&self, group: usize, mut visit: impl FnMut(u32, u32)) {
        let own = group * WIDTH..((group + 1) * WIDTH).min(self.boxes.len());
        let around = &self.levels[0][group];
        self.visit_groups(around, group, |other| {
            for j in other * WIDTH..((other + 1) * WIDTH).min(self.boxes.len()) {
                if !boxes_meet(around, &self.boxes[j]) {
                    continue;
                }
                for i in own.start..own.end.min(j) {
                    if boxes_meet(&self.boxes[i], &self.boxes[j]) {
                        visit(self.order[i], self.order[j]);
                    }
                }
            }
        });
    }

    /// Calls for each box that meets this one.
    pub(crate) fn visit(&self, query: &AxisBox, mut visit: impl FnMut(u32)) {
        self.visit_groups(query, 0, |group| {
            for i in group * WIDTH..((group + 1) * WIDTH).min(self.boxes.len()) {
                if boxes_meet(query, &self.boxes[i]) {
                    visit(self.order[i]);
                }
            }
        });
    }

    /// Calls for the groups from `first` on whose boxes meet this one.
    fn visit_groups(&self, query: &AxisBox, first: usize, mut visit: impl FnMut(usize)) {
        let mut pending = vec![(self.levels.len() - 1, 0)];
        while let Some((level, node)) = pending.pop() {
            if !self.levels[level].get(node).is_some_and(|around| boxes_meet(query, around)) {
                continue;
            }
            if level == 0 {
                visit(node);
                continue;
            }
            for inner in (node * WIDTH..((node + 1) * WIDTH).min(self.levels[level - 1].len())).rev() {
                // The last group under the node.
                if ((inner + 1) << (2 * (level - 1))) > first {
                    pending.push((level - 1, inner));
                }
            }
        }
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
        prop::collection::vec(prop::array::uniform3(ends), 0..80)
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
