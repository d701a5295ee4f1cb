//! Curves as Jordan curves: whether they are simple and almost disjoint, and how they lie in each other.

use super::CurvedOverlay;
use super::chains::undecided;
use coface_algebra::Error;
use coface_arrange::planar::{JordanFault, JordanRings, RingFault};

impl CurvedOverlay<'_> {
    /// How the curves of all arenas lie, numbered one after the other, if they are Jordan curves and almost disjoint; or the first
    /// fault.
    ///
    /// # Errors
    /// If that cannot be decided, as for a curve that is smaller than the resolution.
    pub(crate) fn jordan_rings(&self) -> Result<Result<JordanRings, JordanFault>, Error> {
        let chains = self.chains();
        let curve_count = self.boundaries.curve_count() as u32;
        if let Some(curve) = (0..curve_count).find(|&curve| self.nodes.breaks_of(curve).is_empty()) {
            let piece = self.boundaries.pieces(curve).start;
            let place = self.boundaries.controls(piece)[0];
            return Err(undecided(&self.boundaries, "the form of a curve", place, [piece]));
        }
        let point = |node: u32| self.nodes.points[node as usize];
        let ring_of_chain = |chain: u32| chains.curve_of(chain);
        let fault = match self.cells.ring_fault(ring_of_chain) {
            Some(RingFault::Overlap { edge, rings }) => {
                JordanFault::Overlap { rings, ends: self.cells.edges().ends()[edge as usize].map(point) }
            }
            Some(RingFault::SelfMeeting { node, ring }) => {
                JordanFault::SelfMeeting { ring, point: point(node) }
            }
            Some(RingFault::Crossing { node, rings }) => JordanFault::Crossing { rings, point: point(node) },
            None => {
                let ring_of_halfedge = self.cells.ring_of_halfedge(ring_of_chain);
                let touching = self.cells.touching_rings(&ring_of_halfedge);
                return match self.cells.nesting(&ring_of_halfedge, curve_count as usize) {
                    Ok(nesting) => Ok(Ok(JordanRings::new(nesting, touching))),
                    Err(halfedge) => Err(self.contradiction("how curves lie in each other", halfedge)),
                };
            }
        };
        Ok(Err(fault))
    }
}
