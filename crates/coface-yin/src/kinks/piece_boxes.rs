//! Boxes around the polynomials of all curves, which can be asked for those that meet a box and changed one by one.

use crate::curve::bernstein::{control_box, rounding_bound};

/// The least and the greatest coordinates.
pub(super) type PlanarBox = [[f64; 2]; 2];

/// A complete binary tree over pieces in order, each node with the box around what is below it. Neighbors on a curve are near each
/// other, so that this order is as good as one by place.
#[derive(Clone, Debug)]
pub(super) struct PieceBoxes {
    /// The root is node 1, the children of node k are 2 k and 2 k + 1.
    nodes: Vec<PlanarBox>,
    leaf_count: usize,
}

const NOWHERE: PlanarBox = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];

impl PieceBoxes {
    pub(super) fn new(boxes: impl ExactSizeIterator<Item = PlanarBox>) -> Self {
        let leaf_count = boxes.len().next_power_of_two();
        let mut nodes = vec![NOWHERE; 2 * leaf_count];
        for (place, found) in nodes[leaf_count..].iter_mut().zip(boxes) {
            *place = found;
        }
        for node in (1..leaf_count).rev() {
            nodes[node] = united(nodes[2 * node], nodes[2 * node + 1]);
        }
        Self { nodes, leaf_count }
    }

    /// Takes another box for a piece.
    pub(super) fn set(&mut self, piece: usize, to: PlanarBox) {
        let mut node = self.leaf_count + piece;
        self.nodes[node] = to;
        while node > 1 {
            node /= 2;
            self.nodes[node] = united(self.nodes[2 * node], self.nodes[2 * node + 1]);
        }
    }

    /// Whether all pieces whose boxes meet this one pass a test, which is asked of one after the other until one fails.
    pub(super) fn all_meeting(&self, query: &PlanarBox, mut passes: impl FnMut(usize) -> bool) -> bool {
        let mut open = vec![1];
        while let Some(node) = open.pop() {
            if !do_meet(query, &self.nodes[node]) {
                continue;
            }
            if node < self.leaf_count {
                open.extend([2 * node + 1, 2 * node]);
            } else if !passes(node - self.leaf_count) {
                return false;
            }
        }
        true
    }
}

/// A box that surely contains a piece, whatever was rounded.
pub(super) fn piece_box(controls: &[[f64; 2]]) -> PlanarBox {
    let margin = rounding_bound(controls);
    let [low, high] = control_box(controls);
    [low.map(|x| x - margin), high.map(|x| x + margin)]
}

pub(super) fn united(a: PlanarBox, b: PlanarBox) -> PlanarBox {
    [[0, 1].map(|axis| a[0][axis].min(b[0][axis])), [0, 1].map(|axis| a[1][axis].max(b[1][axis]))]
}

pub(super) fn do_meet(a: &PlanarBox, b: &PlanarBox) -> bool {
    (0..2).all(|axis| a[0][axis] <= b[1][axis] && b[0][axis] <= a[1][axis])
}

#[cfg(test)]
mod tests {
    use super::*;

    fn meeting(boxes: &PieceBoxes, query: PlanarBox) -> Vec<usize> {
        let mut found = Vec::new();
        boxes.all_meeting(&query, |piece| {
            found.push(piece);
            true
        });
        found
    }

    #[test]
    fn boxes_are_found_before_and_after_a_change() {
        let unit = |at: f64| [[at, 0.0], [at + 1.0, 1.0]];
        let mut boxes = PieceBoxes::new((0..5).map(|at| unit(2.0 * f64::from(at))));
        assert_eq!(meeting(&boxes, [[3.0, 0.5], [4.5, 0.5]]), [1, 2]);
        boxes.set(4, unit(3.5));
        assert_eq!(meeting(&boxes, [[3.0, 0.5], [4.5, 0.5]]), [1, 2, 4]);
        boxes.set(1, unit(90.0));
        assert_eq!(meeting(&boxes, [[3.0, 0.5], [4.5, 0.5]]), [2, 4]);
        assert!(!boxes.all_meeting(&unit(8.0), |_| false) || meeting(&boxes, unit(8.0)).is_empty());
    }
}
