//! Triangles made ready to be cut: equal points are one vertex, equal triangles one sheet, and edges have numbers.

use super::fans::plain_corners;
use crate::spatial::axis_view::PlaneView;
use coface_algebra::RaggedArray;
use coface_geometry::predicates::{SpatialLine, SpatialPlane, plane_axis};
use coface_geometry::{AxisBox, BoxTree, Positions, frame_around};
use rayon::prelude::*;
use std::cmp::Ordering;

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
    pub(super) views: Vec<PlaneView>,
    /// The triangles of each sheet as `2 * triangle + against`, rising.
    pub(super) sources: RaggedArray,
    /// The lower and the higher end of each edge, rising.
    pub(super) edges: Vec<[u32; 2]>,
    /// The edges of each sheet: edge i goes from corner i to the next.
    pub(super) edges_of: Vec<[u32; 3]>,
    /// Triangles without area, rising.
    pub(super) degenerate: Vec<u32>,
    /// For each sheet a bit for each corner around which sheets lie side by side.
    pub(super) plain_corners: Vec<u8>,
}

impl Sheets {
    /// The sheets of triangles whose corners are points in space, and the boxes around them.
    pub(super) fn new(positions: &Positions, triangles: &[[u32; 3]]) -> (Self, BoxTree) {
        let welded = Welded::new(positions);
        let (points, vertex_of_point) = (&welded.points, &welded.vertex_of_point);
        let triangles: Vec<[u32; 3]> =
            triangles.par_iter().map(|own| own.map(|point| vertex_of_point[point as usize])).collect();
        let views: Vec<Option<PlaneView>> = triangles
            .par_iter()
            .map(|&[a, b, c]| {
                if a == b || b == c || a == c {
                    return None;
                }
                let (axis, front) = plane_axis([a, b, c].map(|vertex| points[vertex as usize]));
                front.is_ne().then_some(PlaneView { axis: axis as u8, front })
            })
            .collect();
        // The triangles with area.
        let mut numbers: Vec<u32> = Vec::with_capacity(triangles.len());
        let (mut corners, mut own_views) = (Vec::with_capacity(triangles.len()), Vec::new());
        own_views.reserve(triangles.len());
        let mut degenerate = Vec::new();
        for ((number, view), own) in (0..).zip(views).zip(triangles) {
            match view {
                None => degenerate.push(number),
                Some(view) => {
                    numbers.push(number);
                    corners.push(own);
                    own_views.push(view);
                }
            }
        }
        let tree = |corners: &[[u32; 3]]| {
            // About where the triangles are: one corner of each.
            let place = |i: usize| points[corners[i][0] as usize].map(|x| [x, x]);
            BoxTree::in_frame(frame_around(corners.len(), place), corners.len(), |i| {
                box_around(points, corners[i])
            })
        };
        let plain = |views: &[PlaneView], corners: &[[u32; 3]], edges: &[[u32; 2]], edges_of: &[[u32; 3]]| {
            plain_corners(points, corners, views, edges, edges_of)
        };
        let ((found, mut plain_corners), mut boxes) = rayon::join(
            || {
                let found = Edges::new(points.len(), &corners);
                let plain = match found.twins.is_empty() {
                    true => plain(&own_views, &corners, &found.ends, &found.of),
                    false => Vec::new(),
                };
                (found, plain)
            },
            || tree(&corners),
        );
        let Edges { ends: edges, of: mut edges_of, twins } = found;
        let sources = if twins.is_empty() {
            let packed = numbers.into_iter().map(|number| number << 1).collect();
            RaggedArray::uniform(1, packed).expect("triangles are fewer than 2^29")
        } else {
            let mut first: Vec<u32> = (0..corners.len() as u32).collect();
            twins.iter().for_each(|&[later, earlier]| first[later as usize] = earlier);
            let mut sheet_of = vec![0; corners.len()];
            let (mut keys, mut packed) = (Vec::new(), Vec::new());
            let mut count = 0;
            for i in 0..corners.len() {
                let earlier = first[i] as usize;
                if earlier == i {
                    sheet_of[i] = count as u32;
                    (corners[count], own_views[count], edges_of[count]) =
                        (corners[i], own_views[i], edges_of[i]);
                    count += 1;
                }
                let sheet = sheet_of[earlier];
                keys.push(sheet);
                let against = !is_rotated(corners[sheet as usize], corners[i]);
                packed.push(numbers[i] << 1 | u32::from(against));
            }
            corners.truncate(count);
            own_views.truncate(count);
            edges_of.truncate(count);
            boxes = tree(&corners);
            plain_corners = plain(&own_views, &corners, &edges, &edges_of);
            let mut sources = RaggedArray::grouped(count, keys.iter().copied());
            sources.items_mut().iter_mut().for_each(|item| *item = packed[*item as usize]);
            sources
        };
        let Welded { points, first_points, vertex_of_point, by_place } = welded;
        let sheets = Self {
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
            plain_corners,
        };
        (sheets, boxes)
    }

    pub(super) fn count(&self) -> usize {
        self.corners.len()
    }

    pub(super) fn point(&self, vertex: u32) -> [f64; 3] {
        self.points[vertex as usize]
    }

    /// Whether two sheets are known to have nothing in common but a corner or an edge of both.
    pub(super) fn are_beside(&self, f: u32, g: u32) -> bool {
        let (own, plain) = (&self.corners[f as usize], self.plain_corners[f as usize]);
        let other = &self.corners[g as usize];
        plain != 0 && (0..3).any(|i| plain >> i & 1 == 1 && other.contains(&own[i]))
    }

    pub(super) fn plane(&self, sheet: u32) -> SpatialPlane {
        self.corners[sheet as usize].map(|corner| self.point(corner))
    }

    /// The line of an edge, from its lower to its higher end.
    pub(super) fn line(&self, edge: u32) -> SpatialLine {
        self.edges[edge as usize].map(|end| self.point(end))
    }

    /// The vertex at a place, if there is one.
    pub(super) fn vertex_at(&self, place: [f64; 3]) -> Option<u32> {
        let found =
            self.by_place.binary_search_by(|&vertex| compare_places(&self.point(vertex), &place)).ok()?;
        Some(self.by_place[found])
    }
}

/// The box around a triangle.
pub(super) fn box_around(points: &[[f64; 3]], corners: [u32; 3]) -> AxisBox {
    let [a, b, c] = corners.map(|corner| points[corner as usize]);
    [0, 1, 2].map(|axis| [a[axis].min(b[axis]).min(c[axis]), a[axis].max(b[axis]).max(c[axis])])
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

/// Whether two orders of the same three corners run the same way.
fn is_rotated(a: [u32; 3], b: [u32; 3]) -> bool {
    let at = a.iter().position(|&corner| corner == b[0]).expect("the corners are the same");
    a[(at + 1) % 3] == b[1]
}

/// The edges of triangles.
struct Edges {
    /// The lower and the higher end of each, rising.
    ends: Vec<[u32; 2]>,
    /// The edges of each triangle: edge i goes from corner i to the next.
    of: Vec<[u32; 3]>,
    /// Triangles that have the same corners as earlier ones, each with the first of those.
    twins: Vec<[u32; 2]>,
}

/// Sides at so many vertices are sorted at a time.
const VERTICES: usize = 1 << 10;

impl Edges {
    /// The edges of triangles with three different corners.
    fn new(vertex_count: usize, corners: &[[u32; 3]]) -> Self {
        // Sides by their lower ends, then by their higher ends.
        let mut starts = vec![0usize; vertex_count + 1];
        let sides = |own: &[u32; 3]| {
            let [a, b, c] = *own;
            [[a, b], [b, c], [c, a]].map(|[from, to]| [from.min(to), from.max(to)])
        };
        for [low, _] in corners.iter().flat_map(sides) {
            starts[low as usize + 1] += 1;
        }
        for vertex in 0..vertex_count {
            starts[vertex + 1] += starts[vertex];
        }
        let mut next = starts.clone();
        let mut keys = vec![0u64; 3 * corners.len()];
        for (side, [low, high]) in (0u64..).zip(corners.iter().flat_map(sides)) {
            let place = &mut next[low as usize];
            keys[*place] = u64::from(high) << 32 | side;
            *place += 1;
        }
        drop(next);
        let mut rest = &mut keys[..];
        let mut blocks = Vec::new();
        for block in starts.windows(VERTICES + 1).step_by(VERTICES) {
            let (own, after) = rest.split_at_mut(block[VERTICES] - block[0]);
            blocks.push((block, own));
            rest = after;
        }
        blocks.push((&starts[vertex_count / VERTICES * VERTICES..], rest));
        blocks.into_par_iter().for_each(|(block, own)| {
            for ends in block.windows(2) {
                own[ends[0] - block[0]..ends[1] - block[0]].sort_unstable();
            }
        });
        let mut edges = Self {
            ends: Vec::with_capacity(3 * corners.len() / 2),
            of: vec![[0; 3]; corners.len()],
            twins: Vec::new(),
        };
        let mut thirds = Vec::new();
        for (low, range) in (0..).zip(starts.windows(2)) {
            for same in keys[range[0]..range[1]].chunk_by(|a, b| a >> 32 == b >> 32) {
                let high = (same[0] >> 32) as u32;
                let edge = edges.ends.len() as u32;
                edges.ends.push([low, high]);
                thirds.clear();
                for &key in same {
                    let (triangle, side) = (key as u32 / 3, key as u32 % 3);
                    edges.of[triangle as usize][side as usize] = edge;
                    let third = corners[triangle as usize][(side as usize + 2) % 3];
                    if third > high {
                        thirds.push((third, triangle));
                    }
                }
                // Each triangle comes up at one of its edges: the one opposite to its last corner.
                if thirds.len() > 1 {
                    thirds.sort_unstable();
                    for alike in thirds.chunk_by(|a, b| a.0 == b.0) {
                        edges.twins.extend(alike[1..].iter().map(|&(_, later)| [later, alike[0].1]));
                    }
                }
            }
        }
        edges
    }
}
