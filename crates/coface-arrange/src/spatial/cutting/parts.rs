//! Triangles that are there in part: faces outside of the part are left out.

use super::cut_triangles::CutTriangles;
use crate::spatial::{ExactPolygons, PolygonalComplex, SpatialPredicates};
use coface_algebra::{Error, FaceId, RaggedArray, VertexId};
use coface_geometry::predicates::{SpatialPoint, plane_axis};
use rayon::prelude::*;
use std::ops::Range;
use std::sync::Arc;

const NONE: u32 = u32::MAX;

/// The outlines of the parts that triangles are there in: of all from one on.
///
/// Outlines run along edges of triangles, or where triangles meet: so they are edges when the triangles are cut.
#[derive(Clone, Debug, Default)]
pub(in crate::spatial) struct PartOutlines {
    first_triangle: usize,
    points: Vec<SpatialPoint>,
    /// The sides of each part, directed with the part on the left, as pairs of points.
    sides: RaggedArray,
}

impl PartOutlines {
    /// No part yet: the first is that of triangle `first_triangle`.
    pub(in crate::spatial) fn new(first_triangle: usize) -> Self {
        Self { first_triangle, ..Self::default() }
    }

    /// Adds the parts of polygons, one triangle each.
    pub(in crate::spatial) fn add(&mut self, polygons: &ExactPolygons) {
        let first = self.points.len() as u32;
        self.points.extend(polygons.vertex_points());
        let mut list = Vec::new();
        for part in polygons.parts() {
            list.clear();
            list.extend(part.sides().flatten().map(|vertex| first + vertex));
            self.sides.push(&list);
        }
    }
}

/// A face in a part: its number, and 1 where the triangle of the part runs the other way.
type Member = (u32, u32);

impl CutTriangles {
    /// The same without what is outside of the parts that triangles are there in. Vertices keep their numbers.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) naming a place where an outline does not run
    /// along edges.
    pub(in crate::spatial) fn within(self, parts: &PartOutlines) -> Result<Self, Error> {
        let vertices = self.vertices_at(&parts.points)?;
        let mut members: Vec<Vec<Member>> = vec![Vec::new(); parts.sides.len()];
        for face in 0..self.complex().face_count() as u32 {
            for &triangle in self.triangles_of_face(FaceId::from_u32(face)) {
                let part = ((triangle >> 1) as usize).checked_sub(parts.first_triangle);
                if let Some(own) = part.and_then(|part| members.get_mut(part)) {
                    own.push((face, triangle & 1));
                }
            }
        }
        let inside = |(part, members): (usize, &Vec<Member>)| {
            let sides = parts.sides.list(part).as_chunks::<2>().0.iter();
            let sides: Vec<[u32; 2]> = sides.map(|side| side.map(|point| vertices[point as usize])).collect();
            Part::new(&self, members).inside(&sides)
        };
        let inside: Vec<Result<Vec<u32>, Error>> = members.par_iter().enumerate().map(inside).collect();
        let inside: Vec<Vec<u32>> = inside.into_iter().collect::<Result<_, _>>()?;
        let range = parts.first_triangle..parts.first_triangle + inside.len();
        Ok(self.without_others(&inside, &range))
    }

    /// The vertex at each of some exact points.
    fn vertices_at(&self, points: &[SpatialPoint]) -> Result<Vec<u32>, Error> {
        let rounded = |vertex: u32| {
            let place = self.positions().point(VertexId::from_u32(vertex));
            [place[0], place[1], place[2]].map(|x| x + 0.0)
        };
        let compare = |a: [f64; 3], b: [f64; 3]| {
            (0..3)
                .map(|axis| a[axis].total_cmp(&b[axis]))
                .find(|order| order.is_ne())
                .unwrap_or(std::cmp::Ordering::Equal)
        };
        let mut order: Vec<u32> = (0..self.complex().vertex_count() as u32).collect();
        order.par_sort_unstable_by(|&a, &b| compare(rounded(a), rounded(b)));
        let find = |point: &SpatialPoint| {
            let place = point.rounded();
            let start = order.partition_point(|&vertex| compare(rounded(vertex), place).is_lt());
            let near = order[start..].iter().take_while(|&&vertex| rounded(vertex) == place);
            near.copied()
                .find(|&vertex| self.point(VertexId::from_u32(vertex)).compare(point).is_eq())
                .ok_or_else(|| {
                    let [x, y, z] = place;
                    broken(&format!("no edges end at the exact point near ({x}, {y}, {z})"))
                })
        };
        points.par_iter().map(find).collect()
    }

    /// The same where the triangles of a range have only these faces.
    fn without_others(mut self, inside: &[Vec<u32>], range: &Range<usize>) -> Self {
        let complex = Arc::clone(&self.complex);
        let mut kept = Vec::new();
        let mut triangles = RaggedArray::new();
        let mut own = Vec::new();
        for face in 0..complex.face_count() as u32 {
            own.clear();
            own.extend(self.triangles_of_face(FaceId::from_u32(face)).iter().filter(|&&triangle| {
                let triangle = (triangle >> 1) as usize;
                !range.contains(&triangle) || inside[triangle - range.start].binary_search(&face).is_ok()
            }));
            if !own.is_empty() {
                kept.push(face);
                triangles.push(&own);
            }
        }
        let mut is_used = vec![false; complex.edge_count()];
        let sides = complex.packed_sides();
        for &face in &kept {
            sides.list(face as usize).iter().for_each(|&side| is_used[(side >> 1) as usize] = true);
        }
        let mut number = vec![NONE; complex.edge_count()];
        let (mut ends, mut supports) = (Vec::new(), Vec::new());
        let mut has_edges = vec![false; complex.vertex_count()];
        for edge in (0..complex.edge_count()).filter(|&edge| is_used[edge]) {
            number[edge] = ends.len() as u32;
            ends.push(complex.edges()[edge]);
            supports.push(self.supports[edge]);
            complex.edges()[edge].iter().for_each(|&vertex| has_edges[vertex as usize] = true);
        }
        let renumbered = |&side: &u32| 2 * number[(side >> 1) as usize] + (side & 1);
        let lists =
            kept.iter().map(|&face| sides.list(face as usize).iter().map(renumbered).collect::<Vec<u32>>());
        let sides = RaggedArray::from_lists(lists);
        self.points_in_faces = self
            .points_in_faces
            .iter()
            .filter(|[_, vertex]| has_edges[*vertex as usize])
            .filter_map(|&[face, vertex]| Some([kept.binary_search(&face).ok()? as u32, vertex]))
            .collect();
        self.sheet_of_face = kept.iter().map(|&face| self.sheet_of_face[face as usize]).collect();
        self.triangles_of_face = triangles;
        self.supports = supports;
        self.complex = Arc::new(PolygonalComplex::from_trusted_parts(complex.vertex_count(), ends, sides));
        self
    }
}

fn broken(fault: &str) -> Error {
    Error::invalid(format!("exact polygons are not cut out of their own triangles: {fault}")).with_cure(
        "write the file again, or leave the key \"exact_polygons\" out: then rounded points are taken",
    )
}

/// The faces that a triangle was cut into, with their sides in the direction of the triangle.
struct Part<'a> {
    cut: &'a CutTriangles,
    members: &'a [Member],
    /// First and last vertex, and the place of the face; sorted.
    sides: Vec<([u32; 2], u32)>,
}

impl<'a> Part<'a> {
    fn new(cut: &'a CutTriangles, members: &'a [Member]) -> Self {
        let complex = cut.complex();
        let mut sides = Vec::new();
        for (place, &(face, against)) in (0..).zip(members) {
            let own = complex.packed_sides().list(face as usize).iter();
            sides.extend(own.map(|&side| (complex.side_ends(side ^ against), place)));
        }
        sides.sort_unstable();
        Self { cut, members, sides }
    }

    /// The sides with these ends in this direction.
    fn sides(&self, ends: [u32; 2]) -> impl Iterator<Item = u32> + '_ {
        let start = self.sides.partition_point(|side| side.0 < ends);
        self.sides[start..].iter().take_while(move |side| side.0 == ends).map(|side| side.1)
    }

    /// The vertices that a vertex has edges to.
    fn neighbors(&self, vertex: u32, neighbors: &[[u32; 2]]) -> Vec<u32> {
        let start = neighbors.partition_point(|pair| pair[0] < vertex);
        neighbors[start..].iter().take_while(|pair| pair[0] == vertex).map(|pair| pair[1]).collect()
    }

    /// The faces on the left of directed sides, which run straight along edges, and those connected with them without
    /// crossing a side; rising.
    fn inside(&self, outline: &[[u32; 2]]) -> Result<Vec<u32>, Error> {
        let Some(&(face, _)) = self.members.first() else {
            return Err(broken("the triangle has no area left"));
        };
        let mut neighbors: Vec<[u32; 2]> =
            self.sides.iter().flat_map(|&([a, b], _)| [[a, b], [b, a]]).collect();
        neighbors.sort_unstable();
        neighbors.dedup();
        let axis = plane_axis(self.cut.plane(FaceId::from_u32(face))).0;
        let predicates = self.cut.predicates();
        let mut walls: Vec<[u32; 2]> = Vec::new();
        for &[from, to] in outline {
            let mut here = from;
            while here != to {
                let next = self.neighbors(here, &neighbors).into_iter().find(|&next| {
                    next == to || next != from && is_between(&predicates, axis, [here, next, to])
                });
                let Some(next) = next else {
                    let place = self.cut.positions().point(VertexId::from_u32(here));
                    return Err(broken(&format!("its outline leaves all edges at {place:?}")));
                };
                walls.push([here, next]);
                here = next;
            }
        }
        walls.sort_unstable();
        let mut is_inside = vec![false; self.members.len()];
        let mut stack: Vec<u32> = Vec::new();
        let mut enter = |place: u32, stack: &mut Vec<u32>| {
            if !std::mem::replace(&mut is_inside[place as usize], true) {
                stack.push(place);
            }
        };
        for &wall in &walls {
            self.sides(wall).for_each(|place| enter(place, &mut stack));
        }
        let complex = self.cut.complex();
        while let Some(place) = stack.pop() {
            let (face, against) = self.members[place as usize];
            for &side in complex.packed_sides().list(face as usize) {
                let [a, b] = complex.side_ends(side ^ against);
                if walls.binary_search(&[a, b]).is_err() && walls.binary_search(&[b, a]).is_err() {
                    self.sides([b, a]).for_each(|other| enter(other, &mut stack));
                }
            }
        }
        let faces = self.members.iter().zip(is_inside).filter(|(_, inside)| *inside);
        Ok(faces.map(|(member, _)| member.0).collect())
    }
}

/// Whether `middle` is inside the segment from `from` to `to`; all three are in a plane that is not seen edge-on along
/// the axis.
fn is_between(predicates: &impl SpatialPredicates, axis: usize, [from, middle, to]: [u32; 3]) -> bool {
    let orders =
        (0..3).map(|axis| (predicates.compare(axis, from, middle), predicates.compare(axis, middle, to)));
    let mut advances = false;
    for (first, second) in orders {
        if first != second {
            return false;
        }
        advances |= first.is_ne();
    }
    advances && predicates.normal_sign(axis, [from, middle, to]).is_eq()
}
