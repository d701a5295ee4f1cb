//! Some of exact polygons, without the sides at which only others ended.

use super::exact_polygons::{ExactPart, ExactPolygons};
use coface_algebra::{RaggedArray, UnionFind};
use coface_geometry::predicates::{SpatialPoint, normal_sign, plane_axis};

const NONE: u32 = u32::MAX;

/// Parts, of which those that share a side in one triangle are one.
pub(super) struct WantedParts<'a> {
    /// For each new part one of the old ones.
    samples: Vec<&'a ExactPart>,
    /// The directed sides of each new part, rising.
    sides: Vec<Vec<[u32; 2]>>,
    /// The number of the polygon of each new part.
    polygons: Vec<u32>,
    is_shared: Vec<bool>,
}

impl<'a> WantedParts<'a> {
    pub(super) fn new(all: &'a ExactPolygons, is_wanted: &[bool]) -> Self {
        let parts: Vec<&ExactPart> =
            all.parts().iter().filter(|part| is_wanted[part.polygon as usize]).collect();
        // The triangle from its lowest corner on, so that its direction is kept.
        let key = |part: &ExactPart| {
            let mut triangle = part.triangle;
            let lowest = (0..3).min_by_key(|&i| triangle[i]).unwrap_or(0);
            triangle.rotate_left(lowest);
            (triangle, all.shared()[part.polygon as usize])
        };
        let mut order: Vec<u32> = (0..parts.len() as u32).collect();
        order.sort_by_key(|&number| key(parts[number as usize]));
        let mut classes = UnionFind::new(parts.len());
        let mut polygon_classes = UnionFind::new(is_wanted.len());
        for own in order.chunk_by(|&x, &y| key(parts[x as usize]) == key(parts[y as usize])) {
            let mut sides: Vec<([u32; 2], u32)> = own
                .iter()
                .flat_map(|&number| parts[number as usize].sides().map(move |side| (side, number)))
                .collect();
            sides.sort_unstable();
            for &([a, b], number) in &sides {
                if let Ok(other) = sides.binary_search_by_key(&[b, a], |side| side.0) {
                    let other = sides[other].1;
                    classes.unite(number, other);
                    let [x, y] = [number, other].map(|part| parts[part as usize].polygon);
                    polygon_classes.unite(x, y);
                }
            }
        }
        let numbers = classes.class_numbers();
        let mut samples: Vec<Option<&ExactPart>> = vec![None; classes.class_count()];
        let mut sides: Vec<Vec<[u32; 2]>> = vec![Vec::new(); classes.class_count()];
        for (&part, &class) in parts.iter().zip(&numbers) {
            samples[class as usize].get_or_insert(part);
            sides[class as usize].extend(part.sides());
        }
        for own in &mut sides {
            own.sort_unstable();
            let back = own.clone();
            own.retain(|&[a, b]| back.binary_search(&[b, a]).is_err());
        }
        let polygon_numbers = polygon_classes.class_numbers();
        let (mut number, mut is_shared) = (vec![NONE; polygon_classes.class_count()], Vec::new());
        for polygon in (0..is_wanted.len()).filter(|&polygon| is_wanted[polygon]) {
            let own = &mut number[polygon_numbers[polygon] as usize];
            if *own == NONE {
                *own = is_shared.len() as u32;
                is_shared.push(all.shared()[polygon]);
            }
        }
        let samples: Vec<&ExactPart> = samples.into_iter().flatten().collect();
        let polygon = |part: &&ExactPart| number[polygon_numbers[part.polygon as usize] as usize];
        let polygons = samples.iter().map(polygon).collect();
        Self { samples, sides, polygons, is_shared }
    }

    /// The polygons, with the vertices that are corners of some part.
    pub(super) fn polygons(self, all: &ExactPolygons) -> ExactPolygons {
        let points = all.vertex_points();
        let mut is_corner = vec![false; points.len()];
        for (part, sides) in self.samples.iter().zip(&self.sides) {
            mark_corners(&points, plane_axis(all.plane(part)).0, sides, &mut is_corner);
        }
        let mut number = vec![NONE; points.len()];
        let mut vertices = RaggedArray::new();
        let mut parts = Vec::with_capacity(self.samples.len());
        for ((sample, sides), &polygon) in self.samples.iter().zip(&self.sides).zip(&self.polygons) {
            let mut walks = walks(sides, &is_corner);
            for vertex in walks.iter_mut().flatten() {
                let own = &mut number[*vertex as usize];
                if *own == NONE {
                    *own = vertices.len() as u32;
                    vertices.push(all.vertices().list(*vertex as usize));
                }
                *vertex = *own;
            }
            parts.push(ExactPart { polygon, triangle: sample.triangle, walks });
        }
        ExactPolygons::from_trusted_parts(all.points().to_vec(), vertices, parts, self.is_shared)
    }
}

/// Marks vertices at which sides, sorted by where they begin, bend or meet.
fn mark_corners(points: &[SpatialPoint], axis: usize, sides: &[[u32; 2]], is_corner: &mut [bool]) {
    let mut back: Vec<[u32; 2]> = sides.iter().map(|&[a, b]| [b, a]).collect();
    back.sort_unstable();
    let at = |vertex: u32| &points[vertex as usize];
    for (&[vertex, next], &[end, before]) in sides.iter().zip(&back) {
        let is_straight = || normal_sign(axis, [at(before), at(vertex), at(next)]).is_eq();
        is_corner[vertex as usize] |= vertex != end || !is_straight();
    }
    for pair in sides.windows(2).filter(|pair| pair[0][0] == pair[1][0]) {
        is_corner[pair[0][0] as usize] = true;
    }
}

/// Closed walks along sides that are sorted by where they begin, through corners alone.
pub(super) fn walks(sides: &[[u32; 2]], is_corner: &[bool]) -> Vec<Vec<u32>> {
    let mut is_used = vec![false; sides.len()];
    let mut walks = Vec::new();
    for first in 0..sides.len() {
        let mut walk = Vec::new();
        let mut next = Some(first).filter(|&first| !is_used[first]);
        while let Some(side) = next {
            is_used[side] = true;
            let [from, to] = sides[side];
            if is_corner[from as usize] {
                walk.push(from);
            }
            let start = sides.partition_point(|other| other[0] < to);
            let going_on = (start..sides.len()).take_while(|&i| sides[i][0] == to);
            next = going_on.into_iter().find(|&i| !is_used[i]);
        }
        if !walk.is_empty() {
            walks.push(walk);
        }
    }
    walks
}
