//! Polygons with holes by the vertices of their rings.

use coface_algebra::RaggedArray;

/// Polygons with holes. All rings are simple, with the polygon on their left: outer ones run counterclockwise, holes clockwise. A ring
/// begins with its lowest vertex.
#[derive(Clone, Debug, Default)]
pub(super) struct Outline {
    /// Vertices of rings; of each polygon the outer ring, then the holes.
    pub(super) rings: RaggedArray,
    /// The rings of each polygon.
    pub(super) polygons: RaggedArray,
}

impl Outline {
    /// The rings of a polygon, the outer one first.
    pub(super) fn rings_of(&self, polygon: usize) -> impl ExactSizeIterator<Item = &[u32]> {
        self.polygons.list(polygon).iter().map(|&ring| self.rings.list(ring as usize))
    }

    pub(super) fn polygon_count(&self) -> usize {
        self.polygons.len()
    }

    pub(super) fn hole_count(&self) -> usize {
        self.rings.len() - self.polygon_count()
    }
}
