//! What lies directly below each component: the face that it is in.
//!
//! A ray goes down from the lowest vertex of a component, turned to the left by less than any angle. It meets no vertex, so what
//! it meets first is the inside of an edge, and the component is in the face above that.

use super::crossings::Soup;
use super::faces::{NONE, Orbits};
use super::segment_grid::SegmentGrid;
use crate::algebra::RaggedArray;
use crate::geometry::predicates::{PlanarLine, PlanarPoint, direction_turn};
use rayon::prelude::*;
use std::cmp::Ordering;

/// The parts of an arrangement that rays are sent through.
pub(super) struct Below<'a> {
    pub(super) soup: &'a Soup,
    pub(super) grid: &'a SegmentGrid,
    pub(super) ends: &'a [[u32; 2]],
    /// The edges along each segment; none where an edge has been taken away.
    pub(super) edges_of_segment: &'a RaggedArray,
}

impl Below<'_> {
    /// For each component the halfedge directly below its lowest vertex, with the component on its left.
    pub(super) fn components(
        &self,
        orbits: &Orbits,
        point: impl Fn(u32) -> PlanarPoint + Sync,
    ) -> Vec<Option<u32>> {
        let find = |&vertex: &u32| self.halfedge_below(vertex, &point);
        // There is nothing to the left of the lowest vertex of all.
        let mut below: Vec<Option<u32>> =
            orbits.lowest_vertices.par_iter().skip(1).with_min_len(16).map(find).collect();
        if !orbits.lowest_vertices.is_empty() {
            below.insert(0, None);
        }
        below
    }

    fn halfedge_below(&self, vertex: u32, point: &(impl Fn(u32) -> PlanarPoint + Sync)) -> Option<u32> {
        let from = point(vertex);
        let mut best: Option<(PlanarLine, u32)> = None;
        self.grid.downward(from.rounded(), |list| {
            for &segment in list {
                let [a, b] = self.soup.lines[segment as usize];
                let line = if a[0] < b[0] { [a, b] } else { [b, a] };
                // Rounding is monotone: what the rounded x is beyond, the exact one is beyond or at.
                let x = from.rounded()[0];
                // Also false for vertical ones: the ray passes on their left.
                let is_across = line[0][0] < line[1][0]
                    && line[0][0] <= x
                    && x <= line[1][0]
                    && from.compare_coordinate(&PlanarPoint::given(line[0]), 0).is_gt()
                    && from.compare_coordinate(&PlanarPoint::given(line[1]), 0).is_le();
                if !is_across || from.side_of(line).is_le() {
                    continue;
                }
                let higher = best.is_none_or(|(other, _)| match from.compare_heights(line, other) {
                    // Both come to one point from the left: the one that falls more is above there.
                    Ordering::Equal => direction_turn(line, other).is_gt(),
                    order => order.is_gt(),
                });
                if higher && let Some(edge) = self.edge_below(segment, &from, point) {
                    best = Some((line, edge));
                }
            }
            best.map(|(line, _)| lower_bound(line, from.rounded()[0]))
        });
        best.map(|(_, edge)| 2 * edge)
    }

    /// The edge along a segment that is directly left of the vertical line through a point, if it is there.
    fn edge_below(
        &self,
        segment: u32,
        from: &PlanarPoint,
        point: &(impl Fn(u32) -> PlanarPoint + Sync),
    ) -> Option<u32> {
        let edges = self.edges_of_segment.list(segment as usize);
        let starts_left = |&edge: &u32| {
            edge == NONE || point(self.ends[edge as usize][0]).compare_coordinate(from, 0).is_lt()
        };
        // Edges that were taken away have no ends to compare; the last that starts left is searched among the others.
        let edge = if edges.contains(&NONE) {
            edges.iter().copied().rfind(|edge| *edge != NONE && starts_left(edge))
        } else {
            edges[..edges.partition_point(starts_left)].last().copied()
        };
        edge.filter(|&edge| point(self.ends[edge as usize][1]).compare_coordinate(from, 0).is_ge())
    }
}

/// A number below the height of a line at a place that is known up to rounding.
fn lower_bound(line: PlanarLine, x: f64) -> f64 {
    let [[x0, y0], [x1, y1]] = line;
    let slack = x.abs() * f64::EPSILON;
    let at = |x: f64| {
        let part = ((x * 0.5 - x0 * 0.5) / (x1 * 0.5 - x0 * 0.5)).clamp(0.0, 1.0);
        // Both terms are in the range, whatever the coordinates are.
        y0 * (1.0 - part) + y1 * part
    };
    let height = at(x - slack).min(at(x + slack)).max(y0.min(y1));
    // Not a number where the line is all but vertical: then only its lower end is certain.
    let height = if height.is_nan() { y0.min(y1) } else { height };
    height - 8.0 * f64::EPSILON * y0.abs().max(y1.abs())
}
