//! Cells of faces that are flat up to rounding, by gift wrapping.

use super::sheet::{Point, components, length, minus, unit};
use crate::spatial::gift_wrapped_shells;
use coface_algebra::{Error, VertexId};
use coface_algebra::{RaggedArray, SparseMatrix};
use coface_geometry::{Positions, Sum, cross, determinant, dot};

/// Directions that are parallel to few planes.
const DIRECTIONS: [Point; 12] = [
    [0.811, 0.493, 0.315],
    [-0.331, 0.829, 0.451],
    [0.577, -0.293, 0.763],
    [0.419, 0.307, -0.853],
    [-0.701, -0.463, 0.541],
    [0.113, -0.947, -0.301],
    [-0.863, 0.229, -0.449],
    [-0.257, -0.389, -0.884],
    [0.967, -0.181, 0.179],
    [0.163, 0.971, -0.175],
    [-0.613, 0.599, 0.515],
    [0.487, -0.653, -0.580],
];

/// Faces with rounded vertices.
pub(super) struct FlatFaces<'a> {
    pub(super) positions: &'a Positions,
    /// Boundary matrices of edges and of faces.
    pub(super) edges: &'a SparseMatrix,
    pub(super) faces: &'a SparseMatrix,
    /// Unit normals: to the left of its sides is the face, seen from the tip of its normal.
    pub(super) normals: &'a [Point],
    /// Faces with edges inside of them.
    pub(super) slits: &'a [[u32; 2]],
    pub(super) tolerance: f64,
}

/// The cells of faces.
pub(super) struct WrappedCells {
    /// Rows are faces.
    pub(super) boundaries: SparseMatrix,
    pub(super) volumes: Vec<f64>,
    pub(super) void_count: usize,
}

impl FlatFaces<'_> {
    fn point(&self, vertex: u32) -> Point {
        let point = self.positions.point(VertexId::from_u32(vertex));
        [point[0], point[1], point[2]]
    }

    /// Tail and head of an edge.
    fn ends(&self, edge: usize) -> [Point; 2] {
        let column = self.edges.column(edge);
        let (rows, entries) = (column.rows(), column.entries());
        let ends = if entries[0] < 0 { [rows[0], rows[1]] } else { [rows[1], rows[0]] };
        ends.map(|vertex| self.point(vertex))
    }

    /// The packed sides of faces around each edge, by angle.
    fn radial_order(&self) -> RaggedArray {
        let mut sides: Vec<Vec<u32>> = vec![Vec::new(); self.edges.column_count()];
        for (face, column) in (0u32..).zip(self.faces.columns()) {
            for (edge, sign) in column.iter() {
                sides[edge].push(2 * face + u32::from(sign < 0));
            }
        }
        for &[face, edge] in self.slits {
            sides[edge as usize].extend([2 * face, 2 * face + 1]);
        }
        for (edge, own) in sides.iter_mut().enumerate() {
            let [tail, head] = self.ends(edge);
            let along = unit(minus(head, tail));
            let wing = |side: u32| {
                let wing = cross(self.normals[side as usize / 2], along);
                if side.is_multiple_of(2) { wing } else { wing.map(|x| -x) }
            };
            let Some(&first) = own.first() else { continue };
            let first = wing(first);
            let second = cross(along, first);
            let angle = |side: u32| pseudo_angle(dot(wing(side), first), dot(wing(side), second));
            own.sort_by(|&p, &q| angle(p).total_cmp(&angle(q)).then(p.cmp(&q)));
        }
        RaggedArray::from_lists(sides)
    }

    /// A sixth of this is the volume of the cone over a face.
    fn cone(&self, face: usize, origin: Point) -> f64 {
        let column = self.faces.column(face);
        let Some((first, _)) = column.iter().next() else { return 0.0 };
        let top = minus(self.ends(first)[0], origin);
        let mut sum = Sum::default();
        for (edge, sign) in column.iter() {
            let [a, b] = self.ends(edge).map(|end| minus(end, origin));
            sum.add(f64::from(sign) * determinant(top, a, b));
        }
        sum.value()
    }

    fn origin(&self, face: usize) -> Point {
        self.faces.column(face).iter().next().map_or([0.0; 3], |(edge, _)| self.ends(edge)[0])
    }

    /// The cells, by gift wrapping.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] for a component of which it is not clear where it lies.
    pub(super) fn cells(&self) -> Result<WrappedCells, Error> {
        let around = self.radial_order();
        let face_count = self.faces.column_count();
        let shells = gift_wrapped_shells(face_count, &around)?;
        let component_of = components(face_count, &around);
        let volumes: Vec<f64> = shells
            .columns()
            .map(|shell| {
                let mut sum = Sum::default();
                let Some(&first) = shell.rows().first() else { return 0.0 };
                let origin = self.origin(first as usize);
                shell.iter().for_each(|(face, sign)| sum.add(f64::from(sign) * self.cone(face, origin)));
                sum.value() / 6.0
            })
            .collect();
        // Shells that enclose something are cells. The others look outward; those without faces are of sheets that
        // enclose nothing.
        let outer: Vec<usize> = (0..volumes.len()).filter(|&shell| volumes[shell] > 0.0).collect();
        let mut own_shells: Vec<Vec<usize>> = outer.iter().map(|&shell| vec![shell]).collect();
        let boxes: Vec<[Point; 2]> = outer.iter().map(|&shell| self.bounds(&shells, shell)).collect();
        let mut void_count = 0;
        for shell in (0..volumes.len()).filter(|&shell| volumes[shell] <= 0.0) {
            let Some(&face) = shells.column(shell).rows().first() else { continue };
            let component = component_of[face as usize];
            let Some((edge, _)) = self.faces.column(face as usize).iter().next() else { continue };
            let [tail, head] = self.ends(edge);
            let place = [0, 1, 2].map(|axis| tail[axis] + 0.5 * (head[axis] - tail[axis]));
            let mut parent: Option<usize> = None;
            for (cell, &around) in outer.iter().enumerate() {
                let [low, high] = boxes[cell];
                let is_near = (0..3).all(|axis| low[axis] <= place[axis] && place[axis] <= high[axis]);
                let is_other = component_of[shells.column(around).rows()[0] as usize] != component;
                if is_near
                    && is_other
                    && parent.is_none_or(|best| volumes[around] < volumes[outer[best]])
                    && self.encloses(&shells, around, place)?
                {
                    parent = Some(cell);
                }
            }
            if let Some(cell) = parent {
                own_shells[cell].push(shell);
                void_count += 1;
            }
        }
        let mut entries = Vec::new();
        for (cell, own) in own_shells.iter().enumerate() {
            for &shell in own {
                entries.extend(shells.column(shell).iter().map(|(face, sign)| (face, cell, i64::from(sign))));
            }
        }
        let boundaries = SparseMatrix::from_entries(face_count, own_shells.len(), entries)?;
        let volumes = own_shells.iter().map(|own| own.iter().map(|&shell| volumes[shell]).sum()).collect();
        Ok(WrappedCells { boundaries, volumes, void_count })
    }

    fn bounds(&self, shells: &SparseMatrix, shell: usize) -> [Point; 2] {
        let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
        for &face in shells.column(shell).rows() {
            for end in self.faces.column(face as usize).iter().flat_map(|(edge, _)| self.ends(edge)) {
                for axis in 0..3 {
                    low[axis] = low[axis].min(end[axis]);
                    high[axis] = high[axis].max(end[axis]);
                }
            }
        }
        [low, high]
    }

    /// Whether a shell winds around a point, by the faces that a ray crosses.
    fn encloses(&self, shells: &SparseMatrix, shell: usize, place: Point) -> Result<bool, Error> {
        'directions: for ray in DIRECTIONS {
            let mut winding = 0;
            for (face, sign) in shells.column(shell).iter() {
                match self.crossing(face, place, ray) {
                    Some(direction) => winding += sign * direction,
                    None => continue 'directions,
                }
            }
            return Ok(winding != 0);
        }
        Err(Error::invalid(format!(
            "it is not clear on which side of other faces the component at ({}, {}, {}) lies",
            place[0], place[1], place[2]
        ))
        .with_cure("choose a smaller tolerance"))
    }

    /// 1 if a ray crosses a face from behind, -1 from its front, 0 if it misses it; `None` if it comes near to an edge
    /// of it.
    fn crossing(&self, face: usize, place: Point, ray: Point) -> Option<i32> {
        let normal = self.normals[face];
        let slope = dot(normal, ray);
        let height = dot(normal, minus(self.origin(face), place));
        if slope.abs() < 1e-6 {
            return None;
        }
        let t = height / slope;
        if height.abs() > self.tolerance && t < 0.0 {
            return Some(0);
        }
        let at = [0, 1, 2].map(|axis| place[axis] + t * ray[axis]);
        // In the plane of two axes that the face is not seen edge-on along.
        let axis = (0..3).max_by(|&i, &j| normal[i].abs().total_cmp(&normal[j].abs())).unwrap_or(0);
        let (i, j) = ((axis + 1) % 3, (axis + 2) % 3);
        let mut parity = false;
        for (edge, sign) in self.faces.column(face).iter() {
            let [p, q] = self.ends(edge).map(|end| minus(end, at));
            if distance_from_origin(p, q) <= self.tolerance {
                return None;
            }
            let crosses = (p[j] > 0.0) != (q[j] > 0.0) && p[i] - p[j] * (q[i] - p[i]) / (q[j] - p[j]) > 0.0;
            parity ^= crosses && sign % 2 != 0;
        }
        if !parity {
            return Some(0);
        }
        if height.abs() <= self.tolerance {
            return None;
        }
        Some(if slope > 0.0 { 1 } else { -1 })
    }
}

/// The distance of a segment from the origin.
fn distance_from_origin(p: Point, q: Point) -> f64 {
    let side = minus(q, p);
    let square = dot(side, side);
    let t = if square > 0.0 { (-dot(p, side) / square).clamp(0.0, 1.0) } else { 0.0 };
    length([0, 1, 2].map(|axis| p[axis] + t * side[axis]))
}

/// A number that grows with the angle of a vector, counterclockwise from the first axis: 0 to 4, and -0 to 0 counts as
/// 0.
fn pseudo_angle(x: f64, y: f64) -> f64 {
    let slope = x / (x.abs() + y.abs());
    if y < 0.0 { 3.0 + slope } else { 1.0 - slope }
}
