//! A tree of boxes.

/// The bounds of something along each axis.
pub(crate) type Bounds = [[f64; 2]; 3];

/// Boxes in a tree whose node i has the children 2i + 1 and 2i + 2; a leaf has at most [`LEAF`] boxes.
pub(crate) struct Tree {
    /// The bounds of all boxes below each node.
    nodes: Vec<Bounds>,
    boxes: Vec<(Bounds, u32)>,
}

const LEAF: usize = 8;
const NOTHING: Bounds = [[f64::INFINITY, f64::NEG_INFINITY]; 3];

fn joined(a: Bounds, b: Bounds) -> Bounds {
    [0, 1, 2].map(|axis| [a[axis][0].min(b[axis][0]), a[axis][1].max(b[axis][1])])
}

fn meet(a: &Bounds, b: &Bounds) -> bool {
    (0..3).all(|axis| a[axis][0] <= b[axis][1] && b[axis][0] <= a[axis][1])
}

impl Tree {
    pub(crate) fn new(boxes: impl Iterator<Item = Bounds>) -> Self {
        let mut tree = Self { nodes: Vec::new(), boxes: boxes.zip(0..).collect() };
        let mut boxes = std::mem::take(&mut tree.boxes);
        tree.build(0, &mut boxes);
        tree.boxes = boxes;
        tree
    }

    fn build(&mut self, node: usize, boxes: &mut [(Bounds, u32)]) {
        if self.nodes.len() <= node {
            self.nodes.resize(node + 1, NOTHING);
        }
        let bounds = boxes.iter().fold(NOTHING, |all, (own, _)| joined(all, *own));
        self.nodes[node] = bounds;
        if boxes.len() <= LEAF {
            return;
        }
        let extent = |axis: usize| bounds[axis][1] - bounds[axis][0];
        let axis = (0..3).max_by(|&a, &b| extent(a).total_cmp(&extent(b))).unwrap_or(0);
        let middle = |bounds: &Bounds| bounds[axis][0] + bounds[axis][1];
        let (low, _, _) =
            boxes.select_nth_unstable_by(boxes.len() / 2, |a, b| middle(&a.0).total_cmp(&middle(&b.0)));
        let half = low.len();
        let (low, high) = boxes.split_at_mut(half);
        self.build(2 * node + 1, low);
        self.build(2 * node + 2, high);
    }

    /// Calls for each box that meets these bounds, until the call says that it has enough.
    pub(crate) fn each(&self, bounds: &Bounds, mut call: impl FnMut(u32) -> bool) {
        let mut waiting = vec![(0usize, &self.boxes[..])];
        while let Some((node, boxes)) = waiting.pop() {
            if !meet(&self.nodes[node], bounds) {
                continue;
            }
            if boxes.len() <= LEAF {
                for (own, number) in boxes {
                    if meet(own, bounds) && call(*number) {
                        return;
                    }
                }
                continue;
            }
            let (low, high) = boxes.split_at(boxes.len() / 2);
            waiting.extend([(2 * node + 1, low), (2 * node + 2, high)]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Bounds, Tree};

    #[test]
    fn all_boxes_that_meet_are_found() {
        let bounds = |i: u32| -> Bounds {
            let at = |factor: u32, modulus: u32| f64::from(i * factor % modulus);
            [[at(7, 31), at(7, 31) + 3.0], [at(11, 37), at(11, 37) + 2.0], [at(5, 29), at(5, 29) + 4.0]]
        };
        for count in [0, 1, 8, 9, 200] {
            let tree = Tree::new((0..count).map(bounds));
            for query in (0..50).map(bounds) {
                let mut found = Vec::new();
                tree.each(&query, |own| {
                    found.push(own);
                    false
                });
                found.sort_unstable();
                let expected: Vec<u32> = (0..count).filter(|&i| super::meet(&bounds(i), &query)).collect();
                assert_eq!(found, expected);
            }
        }
    }
}
