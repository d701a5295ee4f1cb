//! Which ring lies in which, and which rings touch, without coordinates.

use super::ring_cells::RingCells;
use crate::planar::faces::NONE;
use coface_algebra::RaggedArray;

/// How rings that neither cross nor overlap lie in each other.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct RingNesting {
    /// The smallest ring around each; [`NONE`] where there is none.
    pub(crate) parents: Vec<u32>,
    /// Whether each ring has what it encloses on its left.
    pub(crate) is_counterclockwise: Vec<bool>,
}

/// What keeps closed rings from being simple and almost disjoint.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[doc(hidden)]
pub enum RingFault {
    /// Two parts of rings, or of one, run along an edge.
    Overlap { edge: u32, rings: [u32; 2] },
    /// A ring comes to a node more than once.
    SelfMeeting { node: u32, ring: u32 },
    /// Two rings cross in a node.
    Crossing { node: u32, rings: [u32; 2] },
}

/// A ring that has not been met, a face that has not been seen.
const UNKNOWN: u32 = NONE - 1;

impl RingCells {
    /// The nesting of closed rings, given the ring that runs along each halfedge, [`NONE`] for most.
    ///
    /// Faces are flooded from the outside. Each knows the smallest ring around it: coming over a ring from the outside
    /// makes that the smallest one, with the one before as its parent; coming back makes its parent the smallest again.
    ///
    /// # Errors
    /// A halfedge at which this is contradictory, as rings cross or run along each other.
    ///
    /// # Complexity
    /// Linear in the halfedges.
    #[doc(hidden)]
    pub fn nesting(&self, ring_of_halfedge: &[u32], ring_count: usize) -> Result<RingNesting, u32> {
        let mut found =
            RingNesting { parents: vec![UNKNOWN; ring_count], is_counterclockwise: vec![false; ring_count] };
        let face_count = self.faces.orbits.len();
        let mut smallest = vec![UNKNOWN; face_count + 1];
        smallest[face_count] = NONE;
        let mut stack = vec![NONE];
        while let Some(face) = stack.pop() {
            let here = smallest[(face as usize).min(face_count)];
            let around = match face {
                NONE => &self.faces.unbounded_orbits[..],
                face => self.faces.orbits.list(face as usize),
            };
            for &halfedge in around.iter().flat_map(|&orbit| self.orbits.orbits.list(orbit as usize)) {
                let across = match [halfedge, halfedge ^ 1].map(|h| ring_of_halfedge[h as usize]) {
                    [NONE, NONE] => here,
                    [along, NONE] => found.cross(along, true, here).ok_or(halfedge)?,
                    [NONE, against] => found.cross(against, false, here).ok_or(halfedge)?,
                    _ => return Err(halfedge),
                };
                let face = self.face(halfedge ^ 1);
                let known = &mut smallest[(face as usize).min(face_count)];
                if *known == UNKNOWN {
                    *known = across;
                    stack.push(face);
                } else if *known != across {
                    return Err(halfedge);
                }
            }
        }
        Ok(found)
    }

    /// The smallest ring around each of some rings, given their halfedges, and where each begins and the last ends;
    /// rings are numbered in a new order. They neither cross nor overlap, and what is on the sides of their edges is
    /// not the same.
    ///
    /// Each face but the unbounded one was entered across one edge when winding numbers were found; going these ways
    /// again crosses each ring.
    #[doc(hidden)]
    pub fn parents_in_order(&self, halfedges: &[u32], starts: &[usize], order: &[u32]) -> Vec<Option<u32>> {
        // Twice the ring along each edge, and one more if it runs against the edge.
        let mut ring_of_edge = vec![NONE; self.edges.ends.len()];
        for (number, &ring) in (0u32..).zip(order) {
            for &halfedge in &halfedges[starts[ring as usize]..starts[ring as usize + 1]] {
                ring_of_edge[halfedge as usize / 2] = 2 * number + halfedge % 2;
            }
        }
        let mut nesting = RingNesting {
            parents: vec![UNKNOWN; order.len()],
            is_counterclockwise: vec![false; order.len()],
        };
        let mut smallest = vec![NONE; self.faces.orbits.len()];
        for &entry in self.windings.entries() {
            let before = self.face(entry ^ 1);
            let here = if before == NONE { NONE } else { smallest[before as usize] };
            let known = ring_of_edge[entry as usize / 2];
            smallest[self.face(entry) as usize] = if known == NONE {
                here
            } else {
                let is_before_left = known % 2 != entry % 2;
                nesting.cross(known / 2, is_before_left, here).expect("rings around faces do not cross")
            };
        }
        debug_assert!(!nesting.parents.contains(&UNKNOWN), "each ring is crossed on the way to a face");
        nesting.parents.into_iter().map(|parent| (parent != NONE).then_some(parent)).collect()
    }

    /// What keeps rings from being simple and almost disjoint, the first along edges and then at nodes, given the ring
    /// that each chain is on.
    ///
    /// # Complexity
    /// Linear in the halfedges.
    #[doc(hidden)]
    pub fn ring_fault(&self, ring_of_chain: impl Fn(u32) -> u32) -> Option<RingFault> {
        for (edge, chains) in (0..).zip(self.edges.chains.iter()) {
            if let &[a, b, ..] = chains {
                return Some(RingFault::Overlap { edge, rings: [ring_of_chain(a), ring_of_chain(b)] });
            }
        }
        let (mut rings, mut sorted) = (Vec::new(), Vec::new());
        for (node, leaving) in (0..).zip(self.orbits.rotation.iter()) {
            if leaving.len() <= 2 {
                continue;
            }
            rings.clear();
            // What comes twice in a row turns back without crossing.
            for &halfedge in leaving {
                let ring = ring_of_chain(self.edges.first_chain(halfedge / 2));
                if rings.last() == Some(&ring) {
                    rings.pop();
                } else {
                    rings.push(ring);
                }
            }
            sorted.clear();
            sorted
                .extend(leaving.iter().map(|&halfedge| ring_of_chain(self.edges.first_chain(halfedge / 2))));
            sorted.sort_unstable();
            if let Some(more) = sorted.windows(3).find(|own| own[0] == own[2]) {
                return Some(RingFault::SelfMeeting { node, ring: more[0] });
            }
            // Between the two places of a ring that are nearest to each other each other ring comes once.
            let again = |at: usize| rings[at + 1..].iter().position(|&other| other == rings[at]);
            let nearest = (0..rings.len()).filter_map(|at| Some((again(at)?, at))).min();
            if let Some((_, at)) = nearest {
                return Some(RingFault::Crossing {
                    node,
                    rings: [rings[at].min(rings[at + 1]), rings[at].max(rings[at + 1])],
                });
            }
        }
        None
    }

    /// The ring along each halfedge, given the ring that each chain is on; for rings that do not overlap.
    #[doc(hidden)]
    pub fn ring_of_halfedge(&self, ring_of_chain: impl Fn(u32) -> u32) -> Vec<u32> {
        let mut found = vec![NONE; self.orbits.next.len()];
        for (chain, &halfedge) in (0..).zip(&self.edges.halfedge_of_chain) {
            found[halfedge as usize] = ring_of_chain(chain);
        }
        found
    }

    /// The rings through each node that more than one ring runs through, without repetition, each list rising.
    #[doc(hidden)]
    pub fn touching_rings(&self, ring_of_halfedge: &[u32]) -> RaggedArray {
        let mut groups = RaggedArray::new();
        let mut rings = Vec::new();
        for leaving in self.orbits.rotation.iter().filter(|leaving| leaving.len() > 2) {
            rings.clear();
            rings.extend(leaving.iter().map(|&h| ring_of_halfedge[h as usize]).filter(|&ring| ring != NONE));
            rings.sort_unstable();
            rings.dedup();
            if rings.len() > 1 {
                groups.push(&rings);
            }
        }
        groups
    }
}

impl RingNesting {
    /// The smallest ring on the far side of one that is crossed where `here` is the smallest; none if that cannot be.
    /// The ring has the near side on its left or not.
    fn cross(&mut self, ring: u32, is_near_left: bool, here: u32) -> Option<u32> {
        let (parent, is_counterclockwise) =
            (self.parents[ring as usize], self.is_counterclockwise[ring as usize]);
        if here == ring {
            return (is_near_left == is_counterclockwise).then_some(parent);
        }
        if parent == UNKNOWN {
            self.parents[ring as usize] = here;
            self.is_counterclockwise[ring as usize] = !is_near_left;
        } else if parent != here || is_near_left == is_counterclockwise {
            return None;
        }
        Some(ring)
    }
}
