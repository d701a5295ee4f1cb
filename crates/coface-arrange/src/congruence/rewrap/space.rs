//! A solid in space.

use super::{ends, pseudo_angle};
use coface_algebra::VertexId;
use coface_algebra::{Sign, SparseMatrix};
use coface_geometry::{Positions, cross, determinant, dot};

/// The faces of a solid with their area vectors, around edges.
///
/// Points are relative to one of them and scaled to numbers up to 1. A face that is not flat is the cone from the mean
/// of its vertices over its boundary. Orders of angles are those of rounded numbers; they can be wrong for faces that
/// meet in an angle near the rounding.
pub(super) struct Space {
    faces: Vec<Face>,
    orientation: Sign,
}

struct Face {
    face: u32,
    mean: [f64; 3],
    area: [f64; 3],
    /// Six times the volume of the cone from the origin.
    volume: f64,
    edges: Vec<Edge>,
}

struct Edge {
    edge: u32,
    tail: [f64; 3],
    head: [f64; 3],
    coefficient: i32,
}

impl Space {
    /// `None` if the positions are not in space, or an edge has not two ends.
    pub(super) fn new(
        edges: &SparseMatrix,
        faces: &SparseMatrix,
        positions: &Positions,
        rows: &[u32],
        entries: &[i32],
    ) -> Option<Self> {
        if positions.dimension() != 3 {
            return None;
        }
        let first = *faces.column(*rows.first()? as usize).rows().first()?;
        let [origin, _] = ends(edges, first)?;
        let origin = positions.point(VertexId::from_u32(origin));
        let relative = |vertex: u32| {
            let point = positions.point(VertexId::from_u32(vertex));
            [0, 1, 2].map(|axis| point[axis] - origin[axis])
        };
        let mut own: Vec<Face> = Vec::with_capacity(rows.len());
        let mut largest: f64 = 0.0;
        for &face in rows {
            let mut of_face = Vec::new();
            for (edge, coefficient) in faces.column(face as usize).iter() {
                let [tail, head] = ends(edges, edge as u32)?.map(relative);
                largest = tail.iter().chain(&head).map(|x| x.abs()).fold(largest, f64::max);
                of_face.push(Edge { edge: edge as u32, tail, head, coefficient });
            }
            own.push(Face { face, mean: [0.0; 3], area: [0.0; 3], volume: 0.0, edges: of_face });
        }
        if largest == 0.0 || !largest.is_finite() {
            return None;
        }
        own.iter_mut().for_each(|face| face.measure(largest));
        let volume: f64 = own.iter().zip(entries).map(|(face, &entry)| face.volume * f64::from(entry)).sum();
        Some(Self { faces: own, orientation: if volume < 0.0 { Sign::Minus } else { Sign::Plus } })
    }

    fn face(&self, face: u32) -> &Face {
        &self.faces[self.faces.partition_point(|other| other.face < face)]
    }

    /// Minus if the boundary runs inward.
    pub(super) fn orientation(&self) -> Sign {
        self.orientation
    }

    /// The angle of a face around an edge, counterclockwise seen against its direction. It is measured from an axis
    /// perpendicular to the edge that only the edge decides.
    pub(super) fn angle(&self, edge: u32, face: u32) -> f64 {
        let face = self.face(face);
        let Some(own) = face.edges.iter().find(|own| own.edge == edge) else { return 0.0 };
        let along = [0, 1, 2].map(|axis| own.head[axis] - own.tail[axis]);
        // The face lies to the left of its boundary.
        let inward = cross(face.area, along).map(|x| x * f64::from(own.coefficient.signum()));
        let shortest = (0..3).min_by(|&i, &j| along[i].abs().total_cmp(&along[j].abs())).unwrap_or(0);
        let mut axis = [0.0; 3];
        axis[shortest] = 1.0;
        let first = cross(along, axis);
        let second = cross(along, first);
        // The second axis is longer than the first by the length of the edge.
        let length = dot(along, along).sqrt();
        pseudo_angle(dot(inward, first) * length, dot(inward, second))
    }

    /// Six times the volume between a face and the origin, positive for what runs outward.
    pub(super) fn measure(&self, face: u32) -> f64 {
        self.face(face).volume * f64::from(self.orientation.to_i32())
    }

    /// The mean of the vertices of a face.
    pub(super) fn middle(&self, face: u32) -> [f64; 3] {
        self.face(face).mean
    }

    /// Whether a point is within a closed boundary: by the sum of the solid angles.
    pub(super) fn contains(&self, boundary: impl Iterator<Item = (u32, Sign)>, eye: [f64; 3]) -> bool {
        let mut sum = 0.0;
        for (face, sign) in boundary {
            let face = self.face(face);
            let mean = minus(face.mean, eye);
            for edge in &face.edges {
                let angle = solid_angle(mean, minus(edge.tail, eye), minus(edge.head, eye));
                sum += angle * f64::from(edge.coefficient * sign.to_i32());
            }
        }
        // The whole sphere is 4 pi.
        sum.abs() > std::f64::consts::TAU
    }
}

impl Face {
    /// Mean, area vector and volume after scaling.
    fn measure(&mut self, largest: f64) {
        let count = 2.0 * self.edges.len() as f64;
        for edge in &mut self.edges {
            edge.tail = edge.tail.map(|x| x / largest);
            edge.head = edge.head.map(|x| x / largest);
            (0..3).for_each(|axis| self.mean[axis] += (edge.tail[axis] + edge.head[axis]) / count);
        }
        for edge in &self.edges {
            let coefficient = f64::from(edge.coefficient);
            let product = cross(minus(edge.tail, self.mean), minus(edge.head, self.mean));
            (0..3).for_each(|axis| self.area[axis] += coefficient * product[axis]);
            self.volume += coefficient * determinant(self.mean, edge.tail, edge.head);
        }
    }
}

fn minus(p: [f64; 3], q: [f64; 3]) -> [f64; 3] {
    [0, 1, 2].map(|axis| p[axis] - q[axis])
}

/// The solid angle of a triangle seen from the origin, with the sign of its orientation.
///
/// # References
/// A. van Oosterom and J. Strackee, *The solid angle of a plane triangle* (1983).
fn solid_angle(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> f64 {
    let [x, y, z] = [a, b, c].map(|p| dot(p, p).sqrt());
    let denominator = x * y * z + dot(a, b) * z + dot(b, c) * x + dot(c, a) * y;
    2.0 * determinant(a, b, c).atan2(denominator)
}
