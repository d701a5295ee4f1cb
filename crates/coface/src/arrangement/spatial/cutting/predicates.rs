//! Exact decisions about the vertices of cut triangles.

use super::sheets::Sheets;
use super::vertices::Vertices;
use crate::arrangement::spatial::SpatialPredicates;
use crate::geometry::predicates::{
    SpatialPoint, normal_sign, orientation, orientation_of_points, spatial_orientation,
};
use std::cmp::Ordering;

/// Decisions that go to given points where all are, and know planes and lines by given points.
pub(super) struct CutPredicates<'a> {
    sheets: &'a Sheets,
    vertices: &'a Vertices,
    sheet_of_face: &'a [u32],
    supports: &'a [[u32; 2]],
}

impl<'a> CutPredicates<'a> {
    pub(super) fn new(
        sheets: &'a Sheets,
        vertices: &'a Vertices,
        sheet_of_face: &'a [u32],
        supports: &'a [[u32; 2]],
    ) -> Self {
        Self { sheets, vertices, sheet_of_face, supports }
    }

    fn are_given(&self, vertices: &[u32]) -> bool {
        vertices.iter().all(|&vertex| (vertex as usize) < self.vertices.given)
    }

    fn point(&self, vertex: u32) -> SpatialPoint {
        self.vertices.point(self.sheets, vertex)
    }
}

impl SpatialPredicates for CutPredicates<'_> {
    fn compare(&self, axis: usize, a: u32, b: u32) -> Ordering {
        if self.are_given(&[a, b]) {
            let [a, b] = [a, b].map(|vertex| self.sheets.point(vertex)[axis]);
            return a.partial_cmp(&b).expect("coordinates are numbers");
        }
        self.point(a).compare_coordinate(&self.point(b), axis)
    }

    fn normal_sign(&self, axis: usize, triangle: [u32; 3]) -> Ordering {
        if self.are_given(&triangle) {
            let [a, b, c] = triangle.map(|vertex| {
                let point = self.sheets.point(vertex);
                [point[(axis + 1) % 3], point[(axis + 2) % 3]]
            });
            return orientation(a, b, c);
        }
        let [a, b, c] = triangle.map(|vertex| self.point(vertex));
        normal_sign(axis, [&a, &b, &c])
    }

    fn orientation(&self, points: [u32; 4]) -> Ordering {
        if self.are_given(&points) {
            let [a, b, c, d] = points.map(|vertex| self.sheets.point(vertex));
            return spatial_orientation(a, b, c, d);
        }
        let [a, b, c, d] = points.map(|vertex| self.point(vertex));
        orientation_of_points([&a, &b, &c, &d])
    }

    fn range(&self, axis: usize, vertex: u32) -> [f64; 2] {
        match self.vertices.new_point(vertex) {
            None => [self.sheets.point(vertex)[axis]; 2],
            Some(point) => point.range(axis),
        }
    }

    fn corners_of_plane(&self, face: u32) -> Option<[u32; 3]> {
        Some(self.sheets.corners[self.sheet_of_face[face as usize] as usize])
    }

    fn points_of_line(&self, edge: u32) -> Option<[u32; 2]> {
        Some(self.supports[edge as usize])
    }
}
