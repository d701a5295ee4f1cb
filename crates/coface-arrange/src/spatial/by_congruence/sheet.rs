//! One polygon, cut in its own plane.

use crate::congruence::{ClassRule, Representative, vertex_congruence};
use crate::planar::{PlanarArrangement, VertexSource};
use coface_algebra::UnionFind;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, HalfedgeId};
use coface_geometry::{Positions, cross, dot};

pub(super) type Point = [f64; 3];

pub(super) fn minus(p: Point, q: Point) -> Point {
    [p[0] - q[0], p[1] - q[1], p[2] - q[2]]
}

pub(super) fn length(p: Point) -> f64 {
    // Scaled, so that squares stay in the range of numbers.
    let most = p.iter().fold(0.0f64, |most, x| most.max(x.abs()));
    if most == 0.0 { 0.0 } else { most * p.map(|x| x / most).iter().map(|x| x * x).sum::<f64>().sqrt() }
}

pub(super) fn unit(p: Point) -> Point {
    let length = length(p);
    p.map(|x| x / length)
}

/// A polygon and its plane as the plane of the first two coordinates.
pub(super) struct Sheet {
    /// The corners of each walk.
    walks: Vec<Vec<Point>>,
    origin: Point,
    /// Two unit vectors along the plane and the normal: the side from which the outer walk runs counterclockwise.
    axes: [Point; 3],
    pub(super) low: Point,
    pub(super) high: Point,
}

/// What a sheet is cut into.
#[derive(Default)]
pub(super) struct CutSheet {
    pub(super) vertices: Vec<Point>,
    /// The ends of each edge.
    pub(super) edges: Vec<[u32; 2]>,
    /// The edges of each face, rising, with 1 where the face is on the left seen from the front of the polygon.
    pub(super) faces: Vec<Vec<(u32, i32)>>,
    /// Faces with edges inside of them.
    pub(super) slits: Vec<[u32; 2]>,
}

/// Points and segments in the plane of a sheet.
struct Traces {
    flat: Vec<f64>,
    places: Vec<Point>,
    segments: Vec<[u32; 2]>,
}

impl Traces {
    fn point(&mut self, sheet: &Sheet, place: Point) -> u32 {
        let [x, y, _] = sheet.flattened(place);
        self.flat.extend([x, y]);
        self.places.push(place);
        self.places.len() as u32 - 1
    }
}

impl Sheet {
    /// The sheet of walks around a polygon; `None` if it is nowhere wider than the tolerance.
    ///
    /// # Errors
    /// The distance of a corner from the plane, and the corner as walk and place, if it is above the tolerance.
    pub(super) fn new(walks: Vec<Vec<Point>>, tolerance: f64) -> Result<Option<Self>, (f64, usize, usize)> {
        let corners = || walks.iter().flatten().copied();
        let Some(origin) = corners().next() else { return Ok(None) };
        let (mut low, mut high) = (origin, origin);
        for corner in corners() {
            for axis in 0..3 {
                low[axis] = low[axis].min(corner[axis]);
                high[axis] = high[axis].max(corner[axis]);
            }
        }
        let size = length(minus(high, low));
        if size <= tolerance {
            return Ok(None);
        }
        let mut normal = [0.0; 3];
        for walk in &walks {
            for (i, &p) in walk.iter().enumerate() {
                let q = walk[(i + 1) % walk.len()];
                let [p, q] = [p, q].map(|corner| minus(corner, origin).map(|x| x / size));
                let turn = cross(p, q);
                normal = [0, 1, 2].map(|axis| normal[axis] + turn[axis]);
            }
        }
        if length(normal) * size <= tolerance {
            return Ok(None);
        }
        let normal = unit(normal);
        // The axis that the normal is farthest from: planes along the axes get axes without rounding.
        let least = (0..3).min_by(|&i, &j| normal[i].abs().total_cmp(&normal[j].abs())).unwrap_or(0);
        let mut axis = [0.0; 3];
        axis[least] = 1.0;
        let second = unit(cross(normal, axis));
        let first = cross(second, normal);
        let sheet = Self { walks, origin, axes: [first, second, normal], low, high };
        for (i, walk) in sheet.walks.iter().enumerate() {
            for (j, &corner) in walk.iter().enumerate() {
                let height = sheet.flattened(corner)[2].abs();
                if height > tolerance {
                    return Err((height, i, j));
                }
            }
        }
        Ok(Some(sheet))
    }

    pub(super) fn normal(&self) -> Point {
        self.axes[2]
    }

    pub(super) fn corners(&self) -> impl Iterator<Item = Point> + '_ {
        self.walks.iter().flatten().copied()
    }

    fn flattened(&self, p: Point) -> Point {
        let offset = minus(p, self.origin);
        self.axes.map(|axis| dot(axis, offset))
    }

    fn lifted(&self, [x, y]: [f64; 2]) -> Point {
        [0, 1, 2].map(|i| self.origin[i] + x * self.axes[0][i] + y * self.axes[1][i])
    }

    fn sides(&self) -> impl Iterator<Item = [Point; 2]> + '_ {
        self.walks.iter().flat_map(|walk| (0..walk.len()).map(|i| [walk[i], walk[(i + 1) % walk.len()]]))
    }

    /// Whether a point of the plane is inside: how many sides are to the right of it.
    fn contains(&self, p: Point) -> bool {
        let [x, y, _] = self.flattened(p);
        let crosses = |[a, b]: [Point; 2]| {
            let ([ax, ay, _], [bx, by, _]) = (self.flattened(a), self.flattened(b));
            (ay > y) != (by > y) && (bx - ax) * (y - ay) / (by - ay) > x - ax
        };
        self.sides().filter(|&side| crosses(side)).count() % 2 == 1
    }

    /// Adds what another polygon leaves in the plane of this one: all its sides if it lies there, else the segments
    /// that it is crossed in, and the points where it only touches.
    fn trace(&self, other: &Self, tolerance: f64, traces: &mut Traces) {
        let height = |p: Point| {
            let height = self.flattened(p)[2];
            if height.abs() <= tolerance { 0.0 } else { height }
        };
        let along = cross(self.normal(), other.normal());
        let mut crossings: Vec<(f64, Point)> = Vec::new();
        for [p, q] in other.sides() {
            let [from, to] = [p, q].map(height);
            if from == 0.0 {
                crossings.push((dot(along, minus(p, self.origin)), p));
                if to == 0.0 {
                    let ends = [p, q].map(|end| traces.point(self, end));
                    traces.segments.push(ends);
                }
            } else if from * to < 0.0 {
                let part = from / (from - to);
                let place = [0, 1, 2].map(|axis| p[axis] + part * (q[axis] - p[axis]));
                crossings.push((dot(along, minus(place, self.origin)), place));
            }
        }
        if other.corners().all(|corner| height(corner) == 0.0) {
            return;
        }
        crossings.sort_by(|p, q| p.0.total_cmp(&q.0));
        let points: Vec<u32> = crossings.iter().map(|&(_, place)| traces.point(self, place)).collect();
        for (i, pair) in crossings.windows(2).enumerate() {
            let [p, q] = [pair[0].1, pair[1].1];
            let middle = [0, 1, 2].map(|axis| p[axis] + 0.5 * (q[axis] - p[axis]));
            if length(minus(p, q)) > tolerance && other.contains(middle) {
                traces.segments.push([points[i], points[i + 1]]);
            }
        }
    }

    /// The polygon cut by others.
    ///
    /// Points within the tolerance of each other are brought together before segments are arranged, and segments run
    /// through the points within the tolerance of them: what comes out differently in rounded numbers is one in the
    /// drawing.
    pub(super) fn cut<'a>(
        &self,
        others: impl Iterator<Item = &'a Self>,
        tolerance: f64,
    ) -> Result<CutSheet, Error> {
        let mut traces = Traces { flat: Vec::new(), places: Vec::new(), segments: Vec::new() };
        for walk in &self.walks {
            let points: Vec<u32> = walk.iter().map(|&corner| traces.point(self, corner)).collect();
            traces.segments.extend((0..points.len()).map(|i| [points[i], points[(i + 1) % points.len()]]));
        }
        let own_count = traces.segments.len();
        others.for_each(|other| self.trace(other, tolerance, &mut traces));
        let Traces { flat, places, segments } = traces;
        let positions = Positions::from_flat(2, flat).map_err(|_| too_large())?;
        let classes =
            vertex_congruence(&positions, tolerance, ClassRule::Transitive, Representative::Lowest)?;
        let points: &[[f64; 2]] = classes.positions().as_flat().as_chunks::<2>().0;
        // Pieces of segments, and whether they are of the rim.
        let (mut pieces, mut is_rim) = (Vec::new(), Vec::new());
        let mut on = Vec::new();
        for (i, ends) in segments.iter().enumerate() {
            let [a, b] = ends.map(|end| classes.class_of()[end as usize]);
            if a == b {
                continue;
            }
            points_along(points, [a, b], tolerance, &mut on);
            pieces.extend(on.windows(2).map(|pair| [pair[0].1, pair[1].1]));
            is_rim.resize(pieces.len(), i < own_count);
        }
        let arrangement = PlanarArrangement::new(classes.positions(), &pieces)?;
        let place = |vertex: usize| match arrangement.source(coface_algebra::VertexId::new(vertex)) {
            VertexSource::Given(class) => places[classes.members().list(class)[0] as usize],
            VertexSource::Crossing(_) => {
                let [x, y] = [0, 1]
                    .map(|axis| arrangement.positions().point(coface_algebra::VertexId::new(vertex))[axis]);
                self.lifted([x, y])
            }
        };
        Ok(inside(&arrangement, &is_rim, place))
    }
}

fn too_large() -> Error {
    Error::new(ErrorKind::TooLarge, "coordinates leave the range of numbers")
        .with_cure("scale the polygons down")
}

/// The points within the tolerance of a segment, in order along it, with their places on it: its ends first and last.
fn points_along(points: &[[f64; 2]], [a, b]: [u32; 2], tolerance: f64, on: &mut Vec<(f64, u32)>) {
    let [p, q] = [a, b].map(|end| points[end as usize]);
    let [x, y] = [q[0] - p[0], q[1] - p[1]];
    let size = x.hypot(y);
    let [x, y] = [x / size, y / size];
    on.clear();
    on.extend([(0.0, a), (size, b)]);
    for (i, point) in (0..).zip(points) {
        let [u, v] = [point[0] - p[0], point[1] - p[1]];
        let (along, beside) = (u * x + v * y, u * y - v * x);
        if i != a && i != b && beside.abs() <= tolerance && along > 0.0 && along < size {
            on.push((along, i));
        }
    }
    on.sort_by(|s, t| s.0.total_cmp(&t.0).then(s.1.cmp(&t.1)));
}

/// The part of an arrangement within its rim.
fn inside(arrangement: &PlanarArrangement, is_rim: &[bool], place: impl Fn(usize) -> Point) -> CutSheet {
    let rim_count = |edge: usize| {
        arrangement.segments_of_edges().list(edge).iter().filter(|&&piece| is_rim[piece as usize]).count()
    };
    // Across an odd number of rims one gets in or out.
    let mut is_in: Vec<Option<bool>> = vec![None; arrangement.face_count()];
    let mut queue = vec![(None, false)];
    while let Some((face, here)) = queue.pop() {
        for &halfedge in arrangement.walks(face).flatten() {
            let Some(across) = arrangement.face_of(HalfedgeId::from_u32(halfedge ^ 1)) else { continue };
            let there = here ^ (rim_count(halfedge as usize / 2) % 2 == 1);
            if is_in[across.index()].is_none() {
                is_in[across.index()] = Some(there);
                queue.push((Some(across), there));
            }
        }
    }
    let is_inside = |face: Option<FaceId>| face.is_some_and(|face| is_in[face.index()] == Some(true));
    let mut cut = CutSheet::default();
    let mut number_of_vertex: Vec<Option<u32>> = vec![None; arrangement.vertex_count()];
    let mut number_of_edge: Vec<Option<u32>> = vec![None; arrangement.edge_count()];
    for (edge, number) in number_of_edge.iter_mut().enumerate() {
        if [0, 1].iter().any(|side| is_inside(arrangement.face_of(HalfedgeId::new(2 * edge + side)))) {
            let ends = arrangement.ends(EdgeId::new(edge)).map(|end| {
                *number_of_vertex[end.index()].get_or_insert_with(|| {
                    cut.vertices.push(place(end.index()));
                    cut.vertices.len() as u32 - 1
                })
            });
            *number = Some(cut.edges.len() as u32);
            cut.edges.push(ends);
        }
    }
    for face in (0..arrangement.face_count()).map(FaceId::new).filter(|&face| is_inside(Some(face))) {
        let halfedges = arrangement.walks(Some(face)).flatten().map(|&halfedge| {
            let edge = number_of_edge[halfedge as usize / 2].expect("sides of inner faces are inside");
            (edge, if halfedge.is_multiple_of(2) { 1 } else { -1 })
        });
        let mut sides: Vec<(u32, i32)> = halfedges.collect();
        sides.sort_unstable();
        let number = cut.faces.len() as u32;
        let mut own = Vec::with_capacity(sides.len());
        for pair in sides.chunk_by(|x, y| x.0 == y.0) {
            match pair {
                [side] => own.push(*side),
                _ => cut.slits.push([number, pair[0].0]),
            }
        }
        cut.faces.push(own);
    }
    cut
}

/// Which faces are joined by edges, as class numbers.
pub(super) fn components(face_count: usize, around: &coface_algebra::RaggedArray) -> Vec<u32> {
    let mut partition = UnionFind::new(face_count);
    for sides in around.iter() {
        for pair in sides.windows(2) {
            partition.unite(pair[0] >> 1, pair[1] >> 1);
        }
    }
    partition.class_numbers()
}
