//! Polygons that are not flat within a tolerance, cut into triangles.

use super::SpatialScene;
use super::congruent::triangulated;
use crate::answer::{Place, Remark, RemarkCode};
use coface_algebra::{Error, RaggedArray, VertexId};
use coface_geometry::{Positions, cross, dot};

impl SpatialScene {
    /// Cuts the polygons into triangles that have a corner farther than a distance from their plane; says how many these are.
    /// Those that are no polygon as they are seen stay as they are.
    pub(super) fn cut_bent_polygons(
        &mut self,
        positions: &Positions,
        tolerance: f64,
    ) -> Result<Option<Remark>, Error> {
        let walks_of_polygon =
            RaggedArray::grouped(self.polygon_count(), self.polygon_of_walk.iter().copied());
        let walks = |polygon: usize| {
            RaggedArray::from_lists(
                walks_of_polygon.list(polygon).iter().map(|&walk| self.walks.list(walk as usize)),
            )
        };
        let mut pieces: Vec<(u32, Vec<[u32; 3]>)> = Vec::new();
        let mut largest = 0.0f64;
        for polygon in (0..self.polygon_count()).filter(|&polygon| !walks_of_polygon.list(polygon).is_empty())
        {
            let own = walks(polygon);
            let height = height(positions, &own);
            if own.item_count() > 3
                && height > tolerance
                && let Some(triangles) = triangulated(positions, &own)
            {
                largest = largest.max(height);
                pieces.push((polygon as u32, triangles));
            }
        }
        if pieces.is_empty() {
            return Ok(None);
        }
        let places = pieces.iter().map(|&(polygon, _)| {
            let mut place = Place::cell(&self.corners(polygon));
            place.file = Some(self.label(self.input_of_polygon[polygon as usize] as usize));
            place
        });
        let count = pieces.len();
        let subject = match count {
            1 => "1 polygon is not flat within the tolerance and was".to_owned(),
            count => format!("{count} polygons are not flat within the tolerance and were"),
        };
        let message =
            format!("{subject} split into triangles; points are up to {largest:e} away from a plane");
        let remark = Remark::new(RemarkCode::FacesSplit, message).at(count, places);
        let (mut all, mut polygon_of_walk) = (RaggedArray::new(), Vec::new());
        let (mut inputs, mut sources, mut is_wall) = (Vec::new(), Vec::new(), Vec::new());
        let mut first_patch = self.first_patch;
        for polygon in 0..self.polygon_count() {
            if self.first_patch == Some(polygon) {
                first_patch = Some(inputs.len());
            }
            let mut push = |own: &mut dyn Iterator<Item = &[u32]>| {
                own.for_each(|walk| {
                    all.push(walk);
                    polygon_of_walk.push(inputs.len() as u32);
                });
                inputs.push(self.input_of_polygon[polygon]);
                sources.push(self.source_of_polygon[polygon]);
                is_wall.push(self.is_wall[polygon]);
            };
            match pieces.binary_search_by_key(&(polygon as u32), |piece| piece.0) {
                Ok(at) => pieces[at].1.iter().for_each(|triangle| push(&mut std::iter::once(&triangle[..]))),
                Err(_) => push(&mut walks(polygon).iter()),
            }
        }
        (self.walks, self.polygon_of_walk, self.first_patch) = (all, polygon_of_walk, first_patch);
        (self.input_of_polygon, self.source_of_polygon, self.is_wall) = (inputs, sources, is_wall);
        Ok(Some(remark))
    }
}

/// How far the farthest corner is from the plane through the first corner with the mean normal; 0 without an area.
fn height(positions: &Positions, walks: &RaggedArray) -> f64 {
    let point = |vertex: u32| {
        let point = positions.point(VertexId::from_u32(vertex));
        [point[0], point[1], point[2]]
    };
    let Some(&first) = walks.items().first() else { return 0.0 };
    let origin = point(first);
    let relative = |vertex: u32| {
        let point = point(vertex);
        [0, 1, 2].map(|axis| point[axis] - origin[axis])
    };
    let mut normal = [0.0; 3];
    for walk in walks.iter() {
        for (i, &from) in walk.iter().enumerate() {
            let turn = cross(relative(from), relative(walk[(i + 1) % walk.len()]));
            normal = [0, 1, 2].map(|axis| normal[axis] + turn[axis]);
        }
    }
    let length = dot(normal, normal).sqrt();
    if length <= 0.0 {
        return 0.0;
    }
    walks.items().iter().map(|&vertex| (dot(relative(vertex), normal) / length).abs()).fold(0.0, f64::max)
}
