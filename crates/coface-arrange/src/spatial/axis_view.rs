//! Faces seen along an axis.

use super::predicates::SpatialPredicates;
use coface_algebra::Sign;
use std::cmp::Ordering;

/// The picture of space seen along an axis: from its far end with plus, from its near end with minus.
///
/// No coordinate is computed for it: the two others are those of the picture, in one order or the other.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct AxisView {
    pub(super) axis: u8,
    pub(super) from: Sign,
}

impl AxisView {
    /// The lexicographic order of vertices in the picture.
    pub(super) fn compare(self, predicates: &impl SpatialPredicates, a: u32, b: u32) -> Ordering {
        let axis = usize::from(self.axis);
        let (first, second) = ((axis + 1) % 3, (axis + 2) % 3);
        let (first, second) = if self.from == Sign::Plus { (first, second) } else { (second, first) };
        predicates.compare(first, a, b).then_with(|| predicates.compare(second, a, b))
    }

    /// Which way three vertices turn in the picture.
    pub(super) fn turn(self, predicates: &impl SpatialPredicates, triangle: [u32; 3]) -> Ordering {
        let turn = predicates.normal_sign(usize::from(self.axis), triangle);
        if self.from == Sign::Plus { turn } else { turn.reverse() }
    }

    /// The same seen from the other end.
    pub(super) fn behind(self) -> Self {
        Self { axis: self.axis, from: self.from.opposite() }
    }
}

/// How the plane of a sheet is seen: along an axis that is not in it.
#[derive(Clone, Copy, Debug)]
pub(in crate::spatial) struct PlaneView {
    pub(in crate::spatial) axis: u8,
    /// The sign of the normal along the axis.
    pub(in crate::spatial) front: Ordering,
}

impl PlaneView {
    /// Two coordinates of a point as it is seen from the far end of the axis.
    pub(in crate::spatial) fn seen(self, point: [f64; 3]) -> [f64; 2] {
        self.other_axes().map(|axis| point[axis])
    }

    /// The axes to the right and up.
    pub(in crate::spatial) fn other_axes(self) -> [usize; 2] {
        let axis = usize::from(self.axis);
        [(axis + 1) % 3, (axis + 2) % 3]
    }

    /// A turn as it is seen from the front of the sheet, given that seen from the far end of the axis, or back.
    pub(in crate::spatial) fn seen_from_front(self, turn: Ordering) -> Ordering {
        if self.front.is_gt() { turn } else { turn.reverse() }
    }
}
