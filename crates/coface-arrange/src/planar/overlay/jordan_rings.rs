//! Rings as Jordan curves: whether they are simple and almost disjoint, and how they lie in each other.

use super::PlanarOverlay;
use super::ring_nesting::{RingFault, RingNesting};
use crate::planar::faces::NONE;
use coface_algebra::RaggedArray;

/// How simple rings that are almost disjoint lie, by their numbers.
#[derive(Clone, Debug)]
pub struct JordanRings {
    pub(crate) nesting: RingNesting,
    /// The rings through each point that more than one comes to, rising.
    pub(crate) touching: RaggedArray,
}

/// Where rings are not simple or not almost disjoint: the rings and the rounded point, or both ends of what they share.
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(hidden)]
pub enum JordanFault {
    Overlap { rings: [u32; 2], ends: [[f64; 2]; 2] },
    SelfMeeting { ring: u32, point: [f64; 2] },
    Crossing { rings: [u32; 2], point: [f64; 2] },
}

impl JordanRings {
    /// Rings that lie in each other like this, and the rings through each point that more than one comes to, rising.
    #[doc(hidden)]
    pub fn new(nesting: RingNesting, touching: RaggedArray) -> Self {
        Self { nesting, touching }
    }

    /// The smallest ring around each ring, whether each ring has what it encloses on its left, and the rings through
    /// each point that more than one comes to, rising.
    #[doc(hidden)]
    pub fn into_parts(self) -> (Vec<Option<u32>>, Vec<bool>, RaggedArray) {
        let RingNesting { parents, is_counterclockwise } = self.nesting;
        let parents = parents.into_iter().map(|parent| (parent != NONE).then_some(parent)).collect();
        (parents, is_counterclockwise, self.touching)
    }
}

impl PlanarOverlay {
    /// How rings lie that are Jordan curves and almost disjoint. None of them may be without three corners.
    ///
    /// # Errors
    /// The first fault.
    ///
    /// # Complexity
    /// Linear in the halfedges.
    #[doc(hidden)]
    pub fn jordan_rings(&self) -> Result<JordanRings, JordanFault> {
        let ring_of_chain = |chain: u32| self.chains.ring_of(&self.rings, chain);
        let number = |ring: u32| self.rings.numbers[ring as usize];
        let parts = self.parts();
        let point = |node: u32| parts.node_point(node).rounded();
        match self.cells.ring_fault(ring_of_chain) {
            Some(RingFault::Overlap { edge, rings }) => Err(JordanFault::Overlap {
                rings: rings.map(number),
                ends: self.cells.edges.ends[edge as usize].map(point),
            }),
            Some(RingFault::SelfMeeting { node, ring }) => {
                Err(JordanFault::SelfMeeting { ring: number(ring), point: point(node) })
            }
            Some(RingFault::Crossing { node, rings }) => {
                Err(JordanFault::Crossing { rings: rings.map(number), point: point(node) })
            }
            None => {
                let ring_of_halfedge = self.cells.ring_of_halfedge(ring_of_chain);
                let nesting = self.cells.nesting(&ring_of_halfedge, self.rings.numbers.len());
                Ok(JordanRings {
                    nesting: nesting.expect("rings that do not cross are nested"),
                    touching: self.cells.touching_rings(&ring_of_halfedge),
                })
            }
        }
    }

    /// Whether the winding numbers around some face satisfy a condition; the unbounded face has none that is not zero.
    #[doc(hidden)]
    pub fn has_face_where(&self, condition: impl Fn(&[(u32, i32)]) -> bool) -> bool {
        self.cells.faces_where(condition).contains(&true)
    }
}
