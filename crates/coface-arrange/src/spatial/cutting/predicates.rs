//! Exact decisions about the vertices of cut triangles.

use super::lines::Support;
use super::sheets::Sheets;
use super::vertices::Vertices;
use crate::spatial::SpatialPredicates;
use coface_geometry::predicates::{
    SpatialPoint, normal_sign, orientation, orientation_of_points, spatial_orientation,
};
use std::borrow::Cow;
use std::cmp::Ordering;

/// Decisions that go to given points where all are, and know planes and lines by given points.
pub(super) struct CutPredicates<'a> {
    pub(super) sheets: &'a Sheets,
    pub(super) vertices: &'a Vertices,
    /// The ends of each edge.
    pub(super) ends: &'a [[u32; 2]],
    pub(super) sheet_of_face: &'a [u32],
    pub(super) supports: &'a [Support],
}

impl CutPredicates<'_> {
    fn are_given(&self, vertices: &[u32]) -> bool {
        vertices.iter().all(|&vertex| (vertex as usize) < self.vertices.given)
    }

    fn point(&self, vertex: u32) -> Cow<'_, SpatialPoint> {
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
        normal_sign(axis, [a.as_ref(), b.as_ref(), c.as_ref()])
    }

    fn orientation(&self, points: [u32; 4]) -> Ordering {
        if self.are_given(&points) {
            let [a, b, c, d] = points.map(|vertex| self.sheets.point(vertex));
            return spatial_orientation(a, b, c, d);
        }
        let [a, b, c, d] = points.map(|vertex| self.point(vertex));
        orientation_of_points([a.as_ref(), b.as_ref(), c.as_ref(), d.as_ref()])
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

    fn knows_planes(&self) -> bool {
        true
    }

    fn axis_of_plane(&self, face: u32) -> Option<(usize, Ordering)> {
        let view = self.sheets.views[self.sheet_of_face[face as usize] as usize];
        Some((usize::from(view.axis), view.front))
    }

    fn points_of_line(&self, edge: u32) -> Option<[u32; 2]> {
        Some(match self.supports[edge as usize] {
            Support::Corners(ends) => ends,
            Support::Sheets(_) => self.ends[edge as usize],
        })
    }

    /// Where two sheets cross, what is on the left of the edge in the first comes before what is on the left in the
    /// second, less than a half turn on; what is on the right is opposite.
    fn sort_around(&self, edge: u32, sides: &mut [u32]) -> bool {
        let Support::Sheets(sheets) = self.supports[edge as usize] else { return false };
        let place = |side: u32| {
            let sheet = self.sheet_of_face[(side >> 1) as usize];
            let own = sheets.iter().position(|&other| other == sheet)?;
            Some(own + 2 * (side & 1) as usize)
        };
        let mut order = [None; 4];
        for &side in &*sides {
            match place(side) {
                Some(place) if order[place].is_none() => order[place] = Some(side),
                _ => return false,
            }
        }
        let first = sides[0];
        for (place, side) in sides.iter_mut().zip(order.into_iter().flatten()) {
            *place = side;
        }
        let start = sides.iter().position(|&side| side == first).expect("it is one of them");
        sides.rotate_left(start);
        true
    }
}
