//! Boxes along any direction.

use coface_geometry::predicates::PlanarLine;

/// Far above what rounding can do to coordinates between -1 and 1, and to boxes around boxes.
const MARGIN: f64 = 1.0 / (1u64 << 44) as f64;
/// The least sine of an angle between a side of a box and the vertical at which heights along it are accurate enough
/// for [`MARGIN`].
const LEAST_RISE: f64 = 1.0 / 16.0;

/// A rectangle in scaled coordinates: half sides along a unit vector and along the same turned left.
#[derive(Clone, Copy)]
pub(super) struct OrientedBox {
    center: [f64; 2],
    pub(super) axis: [f64; 2],
    half: [f64; 2],
}

pub(super) fn dot(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

impl OrientedBox {
    /// The box around what reaches from `low` to `high` along an axis and across it.
    pub(super) fn between(axis: [f64; 2], low: [f64; 2], high: [f64; 2]) -> Self {
        let [along, across] = [0, 1].map(|i| 0.5 * (low[i] + high[i]));
        Self {
            center: [along * axis[0] - across * axis[1], along * axis[1] + across * axis[0]],
            axis,
            half: [0, 1].map(|i| 0.5 * (high[i] - low[i]) + MARGIN),
        }
    }

    /// Whether it is no smaller than the box along the axes.
    pub(super) fn is_upright(&self) -> bool {
        self.axis == [1.0, 0.0]
    }

    /// How far the box reaches from its center along an axis and across it.
    pub(super) fn reach(&self, axis: [f64; 2]) -> [f64; 2] {
        let [cosine, sine] = [dot(self.axis, axis).abs(), cross(self.axis, axis).abs()];
        [self.half[0] * cosine + self.half[1] * sine, self.half[0] * sine + self.half[1] * cosine]
    }

    pub(super) fn area(&self) -> f64 {
        self.half[0] * self.half[1]
    }

    pub(super) fn of_points(axis: [f64; 2], points: impl Iterator<Item = [f64; 2]>) -> Self {
        let [mut low, mut high] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for point in points {
            let at = [dot(axis, point), cross(axis, point)];
            for i in 0..2 {
                low[i] = low[i].min(at[i]);
                high[i] = high[i].max(at[i]);
            }
        }
        Self::between(axis, low, high)
    }

    /// The box along an axis around two boxes.
    pub(super) fn around(axis: [f64; 2], a: &Self, b: &Self) -> Self {
        let [mut low, mut high] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for inner in [a, b] {
            let (at, reach) = ([dot(axis, inner.center), cross(axis, inner.center)], inner.reach(axis));
            for i in 0..2 {
                low[i] = low[i].min(at[i] - reach[i]);
                high[i] = high[i].max(at[i] + reach[i]);
            }
        }
        Self::between(axis, low, high)
    }

    /// Whether a line along or across the axis of one of two boxes separates them.
    pub(super) fn is_apart(&self, other: &Self) -> bool {
        let between = [other.center[0] - self.center[0], other.center[1] - self.center[1]];
        [(self, other), (other, self)].into_iter().any(|(a, b)| {
            let reach = b.reach(a.axis);
            dot(a.axis, between).abs() > a.half[0] + reach[0]
                || cross(a.axis, between).abs() > a.half[1] + reach[1]
        })
    }

    /// The lowest and the highest point on a vertical line that are in the box, or beyond it.
    pub(super) fn heights_at(&self, x: f64) -> [f64; 2] {
        let across = x - self.center[0];
        let (mut low, mut high) = (f64::NEG_INFINITY, f64::INFINITY);
        // rise y + run x is at most half in absolute value: for a side, and for one across it. Nearly vertical ones
        // tell little.
        let strips =
            [(self.axis[1], self.axis[0], self.half[0]), (self.axis[0], -self.axis[1], self.half[1])];
        for (rise, run, half) in strips.into_iter().filter(|(rise, ..)| rise.abs() >= LEAST_RISE) {
            let (middle, reach) = (-run * across / rise, half / rise.abs());
            low = low.max(middle - reach);
            high = high.min(middle + reach);
        }
        [self.center[1] + low - MARGIN, self.center[1] + high + MARGIN]
    }

    /// Whether a segment is beyond one side of the box.
    pub(super) fn misses(&self, segment: PlanarLine) -> bool {
        let at = segment.map(|point| {
            let to = [point[0] - self.center[0], point[1] - self.center[1]];
            [dot(self.axis, to), cross(self.axis, to)]
        });
        (0..2).any(|i| {
            at[0][i].min(at[1][i]) > self.half[i] + MARGIN || at[0][i].max(at[1][i]) < -self.half[i] - MARGIN
        })
    }
}
