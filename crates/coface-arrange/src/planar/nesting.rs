//! What lies directly below each component: the face that it is in.
//!
//! A ray goes down from the lowest vertex of a component, turned to the right by less than any angle. It meets no
//! vertex, so what it meets first is the inside of an edge, and the component is in the face above that. All edges of
//! the lowest vertex go right or straight up, and the ray leaves it below them. Turned to the right it meets at once
//! what is alike and straight below, as in a grid of squares; to the left it would go past all of a column.

use super::faces::NONE;
use super::segment_tree::SegmentTree;
use coface_geometry::predicates::{PlanarLine, PlanarPoint, direction_turn, orientation};
use std::cmp::Ordering;

/// The ray down from a point.
pub(super) struct Ray {
    pub(super) from: PlanarPoint,
}

impl Ray {
    /// What `accept` makes of the first segment below among those that it makes something of.
    pub(super) fn first_below<T: Copy>(
        &self,
        tree: &SegmentTree,
        accept: impl Fn(u32) -> Option<T>,
    ) -> Option<T> {
        let ends = |_, line: PlanarLine| line.map(PlanarPoint::given);
        self.first_below_of(tree, |_, line| rising_line(line), ends, accept)
    }

    /// The same for segments that are parts of others: `line_of` gives the line that a segment of the tree is on, from its
    /// lower to its upper end, and `ends_of` the ends of the segment on that line, the lower first.
    pub(super) fn first_below_of<T: Copy>(
        &self,
        tree: &SegmentTree,
        line_of: impl Fn(u32, PlanarLine) -> PlanarLine,
        ends_of: impl Fn(u32, PlanarLine) -> [PlanarPoint; 2],
        accept: impl Fn(u32) -> Option<T>,
    ) -> Option<T> {
        let from = &self.from;
        let [x, y] = from.rounded();
        let is_exact = from.residues().iter().all(|side| side.is_some_and(Ordering::is_eq));
        let mut best: Option<(PlanarLine, T)> = None;
        let mut bound = None;
        tree.downward([x, y], |segment, line| {
            let line = line_of(segment, line);
            // Rounding is monotone: what the rounded x is beyond, the exact one is beyond or at.
            // Also false for vertical ones: the ray passes on their right.
            let is_across = line[0][0] < line[1][0]
                && line[0][0] <= x
                && x <= line[1][0]
                && bound.is_none_or(|bound| heights(line, x)[1] >= bound)
                && {
                    let [low, high] = ends_of(segment, line);
                    from.compare_coordinate(&low, 0).is_ge() && from.compare_coordinate(&high, 0).is_lt()
                };
            let is_below = || {
                let side = if is_exact { orientation(line[0], line[1], [x, y]) } else { from.side_of(line) };
                side.is_gt()
            };
            if is_across && is_below() {
                let higher = best.is_none_or(|(other, _)| match from.compare_heights(line, other) {
                    // Both leave one point to the right: the one that rises more is above there.
                    Ordering::Equal => direction_turn(other, line).is_gt(),
                    order => order.is_gt(),
                });
                if higher && let Some(found) = accept(segment) {
                    best = Some((line, found));
                    bound = Some(heights(line, x)[0]);
                }
            }
            bound
        });
        best.map(|(_, found)| found)
    }

    /// Of edges along a segment, which rise, the one that is directly right of the vertical line through the point, if
    /// it is there. Edges that were taken away are none.
    pub(super) fn edge_below(
        &self,
        edges: &[u32],
        ends: &[[u32; 2]],
        point: impl Fn(u32) -> PlanarPoint,
    ) -> Option<u32> {
        let starts_left = |&edge: &u32| {
            edge == NONE || point(ends[edge as usize][0]).compare_coordinate(&self.from, 0).is_le()
        };
        // Edges that were taken away have no ends to compare; the last that starts left or above is searched among the
        // others.
        let edge = if edges.contains(&NONE) {
            edges.iter().copied().rfind(|edge| *edge != NONE && starts_left(edge))
        } else {
            edges[..edges.partition_point(starts_left)].last().copied()
        };
        edge.filter(|&edge| point(ends[edge as usize][1]).compare_coordinate(&self.from, 0).is_gt())
    }
}

/// A segment from its lexicographically lower to its upper end.
pub(super) fn rising_line([a, b]: PlanarLine) -> PlanarLine {
    if (a[0], a[1]) < (b[0], b[1]) { [a, b] } else { [b, a] }
}

/// A number below and one above the height of a line at a place that is known up to rounding.
fn heights(line: PlanarLine, x: f64) -> [f64; 2] {
    let [[x0, y0], [x1, y1]] = line;
    let slack = x.abs() * f64::EPSILON;
    let at = |x: f64| {
        let part = ((x * 0.5 - x0 * 0.5) / (x1 * 0.5 - x0 * 0.5)).clamp(0.0, 1.0);
        // Both terms are in the range, whatever the coordinates are.
        y0 * (1.0 - part) + y1 * part
    };
    let ends = [at(x - slack), at(x + slack)];
    let [low, high] = [y0.min(y1), y0.max(y1)];
    // Not a number where the line is all but vertical: then only its ends are certain.
    let [below, above] = if ends.iter().any(|height| height.is_nan()) {
        [low, high]
    } else {
        [ends[0].min(ends[1]).max(low), ends[0].max(ends[1]).min(high)]
    };
    let margin = 8.0 * f64::EPSILON * low.abs().max(high.abs());
    [below - margin, above + margin]
}
