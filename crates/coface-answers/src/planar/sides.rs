//! The segments along edges, and which way they run.

use super::drawing::{NO_RING, PlanarDrawing};
use coface_algebra::RaggedArray;
use coface_algebra::{EdgeId, VertexId};
use coface_arrange::planar::PlanarArrangement;

/// The segments of a drawing along the edges of its arrangement, exact or snapped.
pub(super) struct Sides<'a> {
    pub(super) drawing: &'a PlanarDrawing,
    pub(super) arrangement: &'a PlanarArrangement,
    /// The segments along each edge.
    pub(super) segments: &'a RaggedArray,
    /// Whether edges lie on their segments exactly, and the arrangement is of these segments.
    pub(super) is_exact: bool,
    /// Whether each of the segments along edges runs up, if that is known.
    pub(super) runs_up: Option<&'a [bool]>,
}

impl Sides<'_> {
    /// Whether the i-th segment along an edge runs from its lower to its upper end.
    ///
    /// Edges go up in lexicographic order. Exact edges lie on their segments. Rounding moves vertices, but never turns a
    /// coordinate's order around: a piece of a segment goes its way on both axes, or stands still on one.
    fn runs_up(&self, i: usize, segment: u32, edge: u32) -> bool {
        if let Some(known) = self.runs_up {
            return known[self.segments.start(edge as usize) + i];
        }
        if self.is_exact {
            return self.arrangement.rises(segment as usize);
        }
        let [from, to] = self.drawing.segments[segment as usize].map(|vertex| self.drawing.place(vertex));
        let [lower, upper] = self.arrangement.ends(EdgeId::from_u32(edge)).map(|v| self.place(v));
        let way = |a: f64, b: f64| i32::from(b > a) - i32::from(b < a);
        (0..2).map(|axis| way(from[axis], to[axis]) * way(lower[axis], upper[axis])).sum::<i32>() > 0
    }

    fn place(&self, vertex: VertexId) -> [f64; 2] {
        let point = self.arrangement.positions().point(vertex);
        [point[0], point[1]]
    }

    /// How much more each ring winds around what is on the left of a halfedge than around what is on its right. A ring that has
    /// several sides here comes several times.
    pub(super) fn across(&self, halfedge: u32, mut wind: impl FnMut(u32, i32)) {
        let (edge, is_up) = (halfedge / 2, halfedge.is_multiple_of(2));
        for (i, &segment) in self.segments.list(edge as usize).iter().enumerate() {
            let ring = self.drawing.ring_of_segment[segment as usize];
            if ring != NO_RING {
                wind(ring, if self.runs_up(i, segment, edge) == is_up { 1 } else { -1 });
            }
        }
    }
}
