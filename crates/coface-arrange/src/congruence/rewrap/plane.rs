//! A face in the plane.

use super::{ends, pseudo_angle};
use coface_algebra::VertexId;
use coface_algebra::{Sign, SparseMatrix};
use coface_geometry::Positions;

/// The edges of a face in the coordinate plane where its shadow is largest, turned so that the area is positive.
///
/// Points are relative to one of them and scaled to numbers up to 1. Orders of angles are those of rounded numbers;
/// they can be wrong for edges that meet in an angle near the rounding.
pub(super) struct Plane {
    /// Edges, rising, with the points of their ends.
    edges: Vec<u32>,
    ends: Vec<[u32; 2]>,
    points: Vec<([f64; 2], [f64; 2])>,
}

impl Plane {
    /// `None` if an edge has not two ends, or the face has no area.
    pub(super) fn new(
        edges: &SparseMatrix,
        positions: &Positions,
        rows: &[u32],
        entries: &[i32],
    ) -> Option<Self> {
        let ends: Vec<[u32; 2]> = rows.iter().map(|&edge| ends(edges, edge)).collect::<Option<_>>()?;
        let dimension = positions.dimension();
        let point = |vertex: u32| positions.point(VertexId::from_u32(vertex));
        let origin = point(ends[0][0]);
        let vertices = || ends.iter().flatten().map(|&vertex| point(vertex));
        let largest =
            vertices().flat_map(|p| p.iter().zip(origin).map(|(x, o)| (x - o).abs())).fold(0.0, f64::max);
        if largest == 0.0 || !largest.is_finite() {
            return None;
        }
        let mut best = (0.0, [0, 0]);
        for i in 0..dimension {
            for j in 0..i {
                let place = |vertex: u32| [i, j].map(|axis| (point(vertex)[axis] - origin[axis]) / largest);
                let area: f64 = ends
                    .iter()
                    .zip(entries)
                    .map(|(&[tail, head], &entry)| cross(place(tail), place(head)) * f64::from(entry))
                    .sum();
                if area.abs() > best.0 {
                    best = (area.abs(), if area > 0.0 { [i, j] } else { [j, i] });
                }
            }
        }
        let (area, axes) = best;
        if area == 0.0 {
            return None;
        }
        let place = |vertex: u32| axes.map(|axis| (point(vertex)[axis] - origin[axis]) / largest);
        let points = ends.iter().map(|&[tail, head]| (place(tail), place(head))).collect();
        Some(Self { edges: rows.to_vec(), ends, points })
    }

    fn index(&self, edge: u32) -> usize {
        self.edges.partition_point(|&other| other < edge)
    }

    /// The angle of an edge as it leaves a vertex.
    pub(super) fn angle(&self, vertex: u32, edge: u32) -> f64 {
        let i = self.index(edge);
        let (tail, head) = self.points[i];
        let [x, y] = [head[0] - tail[0], head[1] - tail[1]];
        if self.ends[i][0] == vertex { pseudo_angle(x, y) } else { pseudo_angle(-x, -y) }
    }

    /// Twice the area between an edge and the origin.
    pub(super) fn measure(&self, edge: u32) -> f64 {
        let (tail, head) = self.points[self.index(edge)];
        cross(tail, head)
    }

    /// The midpoint of an edge.
    pub(super) fn middle(&self, edge: u32) -> [f64; 3] {
        let (tail, head) = self.points[self.index(edge)];
        [(tail[0] + head[0]) / 2.0, (tail[1] + head[1]) / 2.0, 0.0]
    }

    /// Whether a point is within a closed boundary, by counting the edges above it.
    pub(super) fn contains(&self, boundary: impl Iterator<Item = (u32, Sign)>, [x, y, _]: [f64; 3]) -> bool {
        let mut winding = 0;
        for (edge, sign) in boundary {
            let (tail, head) = self.points[self.index(edge)];
            if (tail[0] <= x) == (head[0] <= x) {
                continue;
            }
            let above = tail[1] + (head[1] - tail[1]) * ((x - tail[0]) / (head[0] - tail[0])) > y;
            if above {
                winding += sign.to_i32() * if head[0] <= x { 1 } else { -1 };
            }
        }
        winding != 0
    }
}

fn cross(p: [f64; 2], q: [f64; 2]) -> f64 {
    p[0] * q[1] - p[1] * q[0]
}
