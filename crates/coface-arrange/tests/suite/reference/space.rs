//! Vertices, edges and faces that polygons cut each other into.

use super::drawing::{bounded_faces, winding};
use super::{Point, Vector, cross, dot, is_zero, minus, moved, number, quotient, vector};
use coface_algebra::Rational;
use std::collections::BTreeSet;

/// A flat polygon: the outer walk, then holes, which run the other way around.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Polygon {
    pub(crate) walks: Vec<Vec<[i64; 3]>>,
    /// The input that it belongs to.
    pub(crate) input: usize,
}

impl Polygon {
    pub(crate) fn sides(&self) -> impl Iterator<Item = [[i64; 3]; 2]> {
        self.walks.iter().flat_map(|walk| (0..walk.len()).map(|i| [walk[i], walk[(i + 1) % walk.len()]]))
    }

    /// The other way around.
    pub(crate) fn reversed(&self) -> Self {
        let mut walks = self.walks.clone();
        walks.iter_mut().for_each(|walk| walk.reverse());
        Self { walks, input: self.input }
    }

    /// Twice its area vector.
    pub(crate) fn normal(&self) -> [i64; 3] {
        self.sides().fold([0; 3], |sum, [p, q]| {
            let turn = integer_cross(p, q);
            [0, 1, 2].map(|i| sum[i] + turn[i])
        })
    }
}

pub(crate) fn integer_cross(p: [i64; 3], q: [i64; 3]) -> [i64; 3] {
    [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]]
}

pub(crate) fn integer_dot(p: [i64; 3], q: [i64; 3]) -> i64 {
    (0..3).map(|i| p[i] * q[i]).sum()
}

/// The plane of the points whose product with the normal is the offset. The first coordinate of the normal that is not zero
/// is positive, and what is to the left in the two coordinates after it is to the left seen from the front.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Plane {
    pub(crate) normal: [i64; 3],
    pub(crate) offset: i64,
    pub(crate) axis: usize,
}

impl Plane {
    /// The plane, and whether the polygon's front is at the plane's back; `None` without area.
    fn of(polygon: &Polygon) -> Option<(Self, i64)> {
        let normal = polygon.normal();
        let axis = (0..3).find(|&axis| normal[axis] != 0)?;
        let divisor = normal.iter().fold(0, |a, &b| gcd(a, b)) * normal[axis].signum();
        let normal = normal.map(|x| x / divisor);
        let offset = integer_dot(normal, polygon.walks[0][0]);
        assert!(polygon.sides().all(|[p, _]| integer_dot(normal, p) == offset), "polygons are flat");
        Some((Self { normal, offset, axis }, divisor.signum()))
    }

    pub(crate) fn height(&self, p: &Vector) -> Rational {
        &dot(&vector(self.normal), p) - &number(self.offset)
    }

    pub(crate) fn drawn(&self, p: &Vector) -> Point {
        [p[(self.axis + 1) % 3].clone(), p[(self.axis + 2) % 3].clone()]
    }

    pub(crate) fn lifted(&self, [u, v]: &Point) -> Vector {
        let (i, j, k) = (self.axis, (self.axis + 1) % 3, (self.axis + 2) % 3);
        let rest = &(&number(self.normal[j]) * u) + &(&number(self.normal[k]) * v);
        let mut lifted = [Rational::ZERO; 3];
        lifted[i] = quotient(&(&number(self.offset) - &rest), &number(self.normal[i]));
        (lifted[j], lifted[k]) = (u.clone(), v.clone());
        lifted
    }

    /// Whether a point of the plane is in a closed polygon of it.
    pub(crate) fn is_in(&self, p: &Vector, polygon: &Polygon) -> bool {
        winding_in(self, polygon, p).is_none_or(|number| number != 0)
    }
}

/// How often a polygon winds around a point of its plane, seen from the front of the plane; `None` on its rim.
pub(crate) fn winding_in(plane: &Plane, polygon: &Polygon, p: &Vector) -> Option<i64> {
    let p = plane.drawn(p);
    let mut sum = 0;
    for walk in &polygon.walks {
        let walk: Vec<Point> = walk.iter().map(|&corner| plane.drawn(&vector(corner))).collect();
        sum += winding(walk.iter(), &p)?;
    }
    Some(sum)
}

pub(crate) fn gcd(a: i64, b: i64) -> i64 {
    if b == 0 { a.abs() } else { gcd(b, a % b) }
}

/// A face: a connected part of a plane within the same polygons.
pub(crate) struct Face {
    pub(crate) plane: usize,
    /// Vertices around it with the face on the left seen from the front of the plane, the outer walk first.
    pub(crate) walks: Vec<Vec<usize>>,
    /// Twice the area of its drawing.
    pub(crate) doubled: Rational,
    pub(crate) inside: Vector,
    /// The polygons that it is in, with -1 for those whose front is at the plane's back.
    pub(crate) polygons: Vec<(usize, i64)>,
}

/// Everything but the cells.
pub(crate) struct Faces {
    pub(crate) planes: Vec<Plane>,
    /// The plane of each polygon, and the sign of its front; `None` without area.
    pub(crate) plane_of: Vec<Option<(usize, i64)>>,
    pub(crate) vertices: Vec<Vector>,
    pub(crate) edges: Vec<[usize; 2]>,
    pub(crate) faces: Vec<Face>,
}

/// A segment with a box around it that is surely large enough.
struct Segment {
    ends: [Vector; 2],
    low: [f64; 3],
    high: [f64; 3],
}

fn rounded(p: &Vector) -> [f64; 3] {
    [0, 1, 2].map(|i| p[i].to_f64())
}

impl Segment {
    fn new(ends: [Vector; 2]) -> Self {
        let [a, b] = [0, 1].map(|i| rounded(&ends[i]));
        let low = [0, 1, 2].map(|i| a[i].min(b[i]) - 1e-6);
        let high = [0, 1, 2].map(|i| a[i].max(b[i]) + 1e-6);
        Self { ends, low, high }
    }

    fn is_near(&self, other: &Self) -> bool {
        (0..3).all(|i| self.low[i] <= other.high[i] && other.low[i] <= self.high[i])
    }

    fn direction(&self) -> Vector {
        minus(&self.ends[1], &self.ends[0])
    }

    /// Where this segment meets another in one point, unless both are on one line.
    fn meeting(&self, other: &Self) -> Option<Vector> {
        let (s, t, offset) = (self.direction(), other.direction(), minus(&other.ends[0], &self.ends[0]));
        let normal = cross(&s, &t);
        if is_zero(&normal) || !dot(&normal, &offset).is_zero() {
            return None;
        }
        let inverse = dot(&normal, &normal).inverse().unwrap();
        let along = [&t, &s].map(|direction| &dot(&cross(&offset, direction), &normal) * &inverse);
        let is_within = along.iter().all(|x| *x >= Rational::ZERO && *x <= Rational::ONE);
        is_within.then(|| moved(&self.ends[0], &along[0], &s))
    }

    fn contains(&self, p: &Vector, near: [f64; 3]) -> bool {
        if (0..3).any(|i| near[i] < self.low[i] || near[i] > self.high[i]) {
            return false;
        }
        let (s, offset) = (self.direction(), minus(p, &self.ends[0]));
        let along = dot(&s, &offset);
        along >= Rational::ZERO && along <= dot(&s, &s) && is_zero(&cross(&s, &offset))
    }
}

/// The segments in which two polygons meet whose planes cross.
fn common_segments(polygons: [&Polygon; 2], planes: [&Plane; 2]) -> Vec<[Vector; 2]> {
    let direction = cross(&vector(planes[0].normal), &vector(planes[1].normal));
    let mut points: Vec<(Rational, Vector)> = Vec::new();
    for (polygon, plane) in polygons.into_iter().zip([planes[1], planes[0]]) {
        for [p, q] in polygon.sides() {
            let [a, b] = [p, q].map(|corner| integer_dot(plane.normal, corner) - plane.offset);
            if a == 0 || a.signum() * b.signum() < 0 {
                let t = quotient(&number(a), &number(if a == 0 { 1 } else { a - b }));
                let point = moved(&vector(p), &t, &minus(&vector(q), &vector(p)));
                points.push((dot(&direction, &point), point));
            }
        }
    }
    points.sort();
    points.dedup();
    let half = quotient(&Rational::ONE, &number(2));
    let pairs = points.windows(2).map(|pair| [pair[0].1.clone(), pair[1].1.clone()]);
    pairs
        .filter(|[p, q]| {
            let middle = moved(p, &half, &minus(q, p));
            (0..2).all(|i| planes[i].is_in(&middle, polygons[i]))
        })
        .collect()
}

/// The faces of polygons; those without area are left out.
pub(crate) fn faces(polygons: &[Polygon]) -> Faces {
    let mut planes: Vec<Plane> = Vec::new();
    let plane_of: Vec<Option<(usize, i64)>> = polygons
        .iter()
        .map(|polygon| {
            let (plane, sign) = Plane::of(polygon)?;
            let found = planes.iter().position(|known| *known == plane);
            let index = found.unwrap_or_else(|| {
                planes.push(plane);
                planes.len() - 1
            });
            Some((index, sign))
        })
        .collect();
    // Rims, and what polygons have in common.
    let mut segments: BTreeSet<[Vector; 2]> = BTreeSet::new();
    let mut insert = |[p, q]: [Vector; 2]| {
        if p != q {
            segments.insert(if p < q { [p, q] } else { [q, p] });
        }
    };
    for (i, polygon) in polygons.iter().enumerate() {
        let Some((plane, _)) = plane_of[i] else { continue };
        polygon.sides().for_each(|side| insert(side.map(vector)));
        for (j, other) in polygons[..i].iter().enumerate() {
            // In another plane that is not parallel.
            let crossing = plane_of[j].filter(|&(beside, _)| planes[beside].normal != planes[plane].normal);
            if let Some((beside, _)) = crossing {
                let common = common_segments([polygon, other], [&planes[plane], &planes[beside]]);
                common.into_iter().for_each(&mut insert);
            }
        }
    }
    let segments: Vec<Segment> = segments.into_iter().map(Segment::new).collect();
    let mut vertices: BTreeSet<Vector> = segments.iter().flat_map(|s| s.ends.clone()).collect();
    for (i, segment) in segments.iter().enumerate() {
        let near = segments[..i].iter().filter(|other| segment.is_near(other));
        vertices.extend(near.filter_map(|other| segment.meeting(other)));
    }
    let vertices: Vec<Vector> = vertices.into_iter().collect();
    let near: Vec<[f64; 3]> = vertices.iter().map(rounded).collect();
    let mut edges: BTreeSet<[usize; 2]> = BTreeSet::new();
    for segment in &segments {
        // Vertices are in lexicographic order, so those on a line are in order along it.
        let on: Vec<usize> =
            (0..vertices.len()).filter(|&v| segment.contains(&vertices[v], near[v])).collect();
        edges.extend(on.windows(2).map(|pair| [pair[0], pair[1]]));
    }
    let edges: Vec<[usize; 2]> = edges.into_iter().collect();
    let mut faces = Vec::new();
    for (index, plane) in planes.iter().enumerate() {
        let is_on: Vec<bool> = vertices.iter().map(|p| plane.height(p).is_zero()).collect();
        let own: Vec<[usize; 2]> =
            edges.iter().copied().filter(|edge| edge.iter().all(|&v| is_on[v])).collect();
        let drawn: Vec<Point> = vertices.iter().map(|p| plane.drawn(p)).collect();
        for face in bounded_faces(&drawn, &own) {
            let inside = plane.lifted(&face.inside);
            let within: Vec<(usize, i64)> = (0..polygons.len())
                .filter_map(|i| {
                    let (_, sign) = plane_of[i].filter(|&(own, _)| own == index)?;
                    let number = winding_in(plane, &polygons[i], &inside).expect("rims are edges");
                    assert!(number == 0 || number == sign, "walks of polygons run the right way");
                    (number != 0).then_some((i, sign))
                })
                .collect();
            if !within.is_empty() {
                let (walks, doubled) = (face.walks, face.doubled);
                faces.push(Face { plane: index, walks, doubled, inside, polygons: within });
            }
        }
    }
    Faces { planes, plane_of, vertices, edges, faces }
}
