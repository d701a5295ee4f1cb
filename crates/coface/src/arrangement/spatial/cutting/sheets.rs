//! Triangles made ready to be cut: equal points are one vertex, equal triangles one sheet, and edges have numbers.

use crate::algebra::RaggedArray;
use crate::geometry::predicates::{SpatialLine, SpatialPlane, plane_axis};
use crate::geometry::{AxisBox, Positions};
use rayon::prelude::*;
use std::cmp::Ordering;

/// How the plane of a sheet is seen: along an axis that is not in it.
#[derive(Clone, Copy, Debug)]
pub(super) struct View {
    pub(super) axis: u8,
    /// The sign of the normal along the axis.
    pub(super) front: Ordering,
}

impl View {
    /// Two coordinates of a point as it is seen from the far end of the axis.
    pub(super) fn seen(self, point: [f64; 3]) -> [f64; 2] {
        self.other_axes().map(|axis| point[axis])
    }

    /// The axes to the right and up.
    pub(super) fn other_axes(self) -> [usize; 2] {
        let axis = usize::from(self.axis);
        [(axis + 1) % 3, (axis + 2) % 3]
    }

    /// A turn as it is seen from the front of the sheet, given that seen from the far end of the axis, or back.
    pub(super) fn seen_from_front(self, turn: Ordering) -> Ordering {
        if self.front.is_gt() { turn } else { turn.reverse() }
    }
}

/// Triangles with area, none twice, their vertices and edges.
#[derive(Clone, Debug)]
pub(super) struct Sheets {
    /// The position of each vertex; vertices are numbered by their first points.
    pub(super) points: Vec<[f64; 3]>,
    /// The first point of the input at each vertex.
    pub(super) first_points: Vec<u32>,
    pub(super) vertex_of_point: Vec<u32>,
    /// The vertices in the lexicographic order of their positions.
    pub(super) by_place: Vec<u32>,
    /// The corners of each sheet, as in the first of its triangles; sheets are numbered by their first triangles.
    pub(super) corners: Vec<[u32; 3]>,
    pub(super) views: Vec<View>,
    /// The triangles of each sheet as `2 * triangle + against`, rising.
    pub(super) sources: RaggedArray,
    /// The lower and the higher end of each edge, rising.
    pub(super) edges: Vec<[u32; 2]>,
    /// The edges of each sheet: edge i goes from corner i to the next.
    pub(super) edges_of: Vec<[u32; 3]>,
    /// Triangles without area, rising.
    pub(super) degenerate: Vec<u32>,
}

impl Sheets {
    /// The sheets of triangles whose corners are points in space.
    pub(super) fn new(positions: &Positions, triangles: &[[u32; 3]]) -> Self {
        let welded = Welded::new(positions);
        let (points, vertex_of_point) = (&welded.points, &welded.vertex_of_point);
        let triangles: Vec<[u32; 3]> =
            triangles.iter().map(|triangle| triangle.map(|point| vertex_of_point[point as usize])).collect();
        let views: Vec<Option<View>> = triangles
            .par_iter()
            .map(|&[a, b, c]| {
                if a == b || b == c || a == c {
                    return None;
                }
                let (axis, front) = plane_axis([a, b, c].map(|vertex| points[vertex as usize]));
                front.is_ne().then_some(View { axis: axis as u8, front })
            })
            .collect();
        let first = first_alike(points.len(), &triangles);
        let mut sheet_of = vec![0; triangles.len()];
        let (mut corners, mut own_views, mut degenerate) = (Vec::new(), Vec::new(), Vec::new());
        let (mut keys, mut packed) = (Vec::new(), Vec::new());
        for (triangle, view) in views.into_iter().enumerate() {
            let Some(view) = view else {
                degenerate.push(triangle as u32);
                continue;
            };
            let representative = first[triangle] as usize;
            if representative == triangle {
                sheet_of[triangle] = corners.len() as u32;
                corners.push(triangles[triangle]);
                own_views.push(view);
            }
            keys.push(sheet_of[representative]);
            let against = !is_rotated(triangles[representative], triangles[triangle]);
            packed.push((triangle as u32) << 1 | u32::from(against));
        }
        let mut sources = RaggedArray::grouped(corners.len(), keys.iter().copied());
        sources.items_mut().iter_mut().for_each(|item| *item = packed[*item as usize]);
        let (edges, edges_of) = edges(points.len(), &corners);
        let Welded { points, first_points, vertex_of_point, by_place } = welded;
        Self {
            points,
            first_points,
            vertex_of_point,
            by_place,
            corners,
            views: own_views,
            sources,
            edges,
            edges_of,
            degenerate,
        }
    }

    pub(super) fn count(&self) -> usize {
        self.corners.len()
    }

    pub(super) fn point(&self, vertex: u32) -> [f64; 3] {
        self.points[vertex as usize]
    }

    pub(super) fn plane(&self, sheet: u32) -> SpatialPlane {
        self.corners[sheet as usize].map(|corner| self.point(corner))
    }

    /// The line of an edge, from its lower to its higher end.
    pub(super) fn line(&self, edge: u32) -> SpatialLine {
        self.edges[edge as usize].map(|end| self.point(end))
    }

    pub(super) fn box_of(&self, sheet: usize) -> AxisBox {
        let [a, b, c] = self.corners[sheet].map(|corner| self.point(corner));
        [0, 1, 2].map(|axis| [a[axis].min(b[axis]).min(c[axis]), a[axis].max(b[axis]).max(c[axis])])
    }

    /// The vertex at a place, if there is one.
    pub(super) fn vertex_at(&self, place: [f64; 3]) -> Option<u32> {
        let found =
            self.by_place.binary_search_by(|&vertex| compare_places(&self.point(vertex), &place)).ok()?;
        Some(self.by_place[found])
    }
}

/// The lexicographic order of coordinates; both zeros are one.
pub(super) fn compare_places(a: &[f64; 3], b: &[f64; 3]) -> Ordering {
    a.partial_cmp(b).expect("coordinates are numbers")
}

/// Points of which equal ones are one vertex.
struct Welded {
    points: Vec<[f64; 3]>,
    first_points: Vec<u32>,
    vertex_of_point: Vec<u32>,
    by_place: Vec<u32>,
}

impl Welded {
    fn new(positions: &Positions) -> Self {
        // Adding zero makes the negative zero positive.
        let given: Vec<[f64; 3]> =
            positions.as_flat().as_chunks::<3>().0.iter().map(|point| point.map(|x| x + 0.0)).collect();
        let mut order: Vec<(f64, u32)> = (0..).zip(&given).map(|(i, point)| (point[0], i)).collect();
        order.par_sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let place = |entry: &(f64, u32)| &given[entry.1 as usize];
        for column in order.chunk_by_mut(|a, b| a.0 == b.0).filter(|column| column.len() > 1) {
            column.par_sort_unstable_by(|a, b| compare_places(place(a), place(b)).then(a.1.cmp(&b.1)));
        }
        let mut first = vec![0; given.len()];
        for same in order.chunk_by(|a, b| place(a) == place(b)) {
            same.iter().for_each(|entry| first[entry.1 as usize] = same[0].1);
        }
        let mut vertex_of_point = vec![0; given.len()];
        let (mut points, mut first_points) = (Vec::new(), Vec::new());
        for point in 0..given.len() {
            let representative = first[point] as usize;
            if representative == point {
                vertex_of_point[point] = points.len() as u32;
                points.push(given[point]);
                first_points.push(point as u32);
            } else {
                vertex_of_point[point] = vertex_of_point[representative];
            }
        }
        let by_place = order
            .iter()
            .filter(|entry| first[entry.1 as usize] == entry.1)
            .map(|entry| vertex_of_point[entry.1 as usize])
            .collect();
        Self { points, first_points, vertex_of_point, by_place }
    }
}

/// For each triangle the first with the same corners.
fn first_alike(vertex_count: usize, triangles: &[[u32; 3]]) -> Vec<u32> {
    let sorted = |triangle: u32| {
        let mut corners = triangles[triangle as usize];
        corners.sort_unstable();
        corners
    };
    let least = triangles.iter().map(|&[a, b, c]| a.min(b).min(c));
    let mut groups = RaggedArray::grouped(vertex_count, least);
    let mut first: Vec<u32> = (0..triangles.len() as u32).collect();
    let ends: Vec<usize> = (0..=vertex_count).map(|vertex| groups.start(vertex)).collect();
    let items = groups.items_mut();
    for own in ends.windows(2).filter(|own| own[1] - own[0] > 1) {
        let own = &mut items[own[0]..own[1]];
        own.sort_unstable_by_key(|&triangle| (sorted(triangle), triangle));
        for pair in 1..own.len() {
            if sorted(own[pair - 1]) == sorted(own[pair]) {
                first[own[pair] as usize] = first[own[pair - 1] as usize];
            }
        }
    }
    first
}

/// Whether two orders of the same three corners run the same way.
fn is_rotated(a: [u32; 3], b: [u32; 3]) -> bool {
    let at = a.iter().position(|&corner| corner == b[0]).expect("the corners are the same");
    a[(at + 1) % 3] == b[1]
}

/// The edges of sheets by rising ends, and those of each sheet.
fn edges(vertex_count: usize, corners: &[[u32; 3]]) -> (Vec<[u32; 2]>, Vec<[u32; 3]>) {
    let ends = |side: u32| {
        let own = corners[side as usize / 3];
        let [a, b] = [own[side as usize % 3], own[(side as usize + 1) % 3]];
        [a.min(b), a.max(b)]
    };
    let sides = 0..3 * corners.len() as u32;
    let mut groups = RaggedArray::grouped(vertex_count, sides.map(|side| ends(side)[0]));
    let starts: Vec<usize> = (0..=vertex_count).map(|vertex| groups.start(vertex)).collect();
    let mut edges: Vec<[u32; 2]> = Vec::with_capacity(3 * corners.len() / 2);
    let mut edges_of = vec![[0; 3]; corners.len()];
    let items = groups.items_mut();
    for own in starts.windows(2) {
        let own = &mut items[own[0]..own[1]];
        own.sort_unstable_by_key(|&side| (ends(side)[1], side));
        for &side in &*own {
            if edges.last() != Some(&ends(side)) {
                edges.push(ends(side));
            }
            edges_of[side as usize / 3][side as usize % 3] = edges.len() as u32 - 1;
        }
    }
    (edges, edges_of)
}
