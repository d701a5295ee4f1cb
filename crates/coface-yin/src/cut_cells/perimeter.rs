//! Places on the sides of a cell, counterclockwise from its lower left corner.

use std::cmp::Ordering;

/// A place on the sides of a cell at which a chain begins or ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Place {
    /// 0 below, 1 on the right, 2 above, 3 on the left. A corner belongs to the side that begins there.
    pub(super) side: usize,
    /// Rises along the side.
    along: f64,
    /// The angle from the way on along the side to the chain, counterclockwise, in radians.
    angle: f64,
}

impl Place {
    /// The place of a point on a side of a cell; `direction` points from it along the chain.
    pub(super) fn new([low, high]: [[f64; 2]; 2], [x, y]: [f64; 2], direction: [f64; 2]) -> Self {
        let (side, along) = if y == low[1] && x < high[0] {
            (0, x)
        } else if x == high[0] && y < high[1] {
            (1, y)
        } else if y == high[1] && x > low[0] {
            (2, -x)
        } else {
            (3, -y)
        };
        let [forward, inward] = match (side, direction) {
            (0, [x, y]) => [x, y],
            (1, [x, y]) => [y, -x],
            (2, [x, y]) => [-x, -y],
            (_, [x, y]) => [-y, x],
        };
        // Rounding can take a direction along a side out of the cell.
        Self { side, along: along + 0.0, angle: inward.max(0.0).atan2(forward) }
    }

    /// The order counterclockwise; at one place clockwise by direction, from that back along the sides to that on along them.
    pub(super) fn compare(&self, other: &Self) -> Ordering {
        let by_side = self.side.cmp(&other.side);
        by_side.then(self.along.total_cmp(&other.along)).then(other.angle.total_cmp(&self.angle))
    }
}

/// The corners of a cell in the order of the sides that begin there.
pub(super) fn corners([low, high]: [[f64; 2]; 2]) -> [[f64; 2]; 4] {
    [low, [high[0], low[1]], high, [low[0], high[1]]]
}
