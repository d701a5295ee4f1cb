//! Edges of an overlay one by one, for callers that follow them.

use super::PlanarOverlay;
use super::ring_cells::RingCells;
use coface_geometry::predicates::{PlanarLine, PlanarPoint};
use rayon::prelude::*;

impl PlanarOverlay {
    /// Edges, faces and winding numbers.
    #[doc(hidden)]
    pub fn cells(&self) -> &RingCells {
        &self.cells
    }

    /// The points along an edge from node to node, rounded; corners are exact.
    #[doc(hidden)]
    pub fn edge_points(&self, edge: u32) -> Vec<[f64; 2]> {
        let parts = self.parts();
        let [from, to] = self.cells.edges.ends[edge as usize].map(|node| parts.node_point(node).rounded());
        let corners = parts.first_chain(edge).corners(&self.rings).into_iter().flatten();
        let inner = corners.map(|corner| self.rings.soup.points[corner as usize]);
        std::iter::once(from).chain(inner).chain([to]).collect()
    }

    /// The corners within an edge in order, by the places of the sides that start there in the lists of all rings
    /// together.
    #[doc(hidden)]
    pub fn edge_corners(&self, edge: u32) -> impl Iterator<Item = usize> + '_ {
        let corners = self.parts().first_chain(edge).corners(&self.rings);
        corners.into_iter().flatten().map(|corner| self.rings.places[corner as usize] as usize)
    }

    /// The nodes at corners, each with the place of the side that starts there; a node comes as often as rings have
    /// corners at it.
    #[doc(hidden)]
    pub fn node_corners(&self) -> impl Iterator<Item = (u32, usize)> + '_ {
        let at_corner = self.chains.breaks.iter().filter(|own| !own.is_within());
        at_corner.map(|own| (own.node(), self.rings.places[own.side as usize] as usize))
    }

    /// Whether a ring goes on from one halfedge into another, in its direction or against it.
    #[doc(hidden)]
    pub fn goes_on(&self, before: u32, after: u32) -> bool {
        let along = |halfedge: u32| {
            let chains = self.cells.edges.chains.list(halfedge as usize / 2);
            chains
                .iter()
                .map(move |&chain| (chain, self.cells.edges.halfedge_of_chain[chain as usize] == halfedge))
        };
        let next = |chain: u32| {
            let ring = self.chains.ring_of(&self.rings, chain) as usize;
            let [start, end] = [self.chains.starts[ring], self.chains.starts[ring + 1]];
            if chain + 1 == end { start } else { chain + 1 }
        };
        along(before).any(|(a, is_a_along)| {
            along(after).any(|(b, is_b_along)| {
                let [from, to] = if is_a_along { [a, b] } else { [b, a] };
                is_a_along == is_b_along && next(from) == to
            })
        })
    }

    /// The regions of rings that have a side along an edge which is no chord. A region comes several times where
    /// several of its rings run along the edge.
    #[doc(hidden)]
    pub fn edge_numbers(&self, edge: u32) -> impl Iterator<Item = u32> + '_ {
        let chains = self.cells.edges.chains.list(edge as usize).iter().copied();
        let is_given = |chain: &u32| {
            let own = self.chains.chain(&self.rings, *chain);
            !self.is_chord(own.sides[0])
                || own.corners(&self.rings).into_iter().flatten().any(|side| !self.is_chord(side))
        };
        chains.filter(is_given).map(|chain| self.regions[self.chains.ring_of(&self.rings, chain) as usize])
    }

    /// The first and the last straight part of an edge, in its direction: each with the side that it is on and its
    /// ends, rounded. There is one alone where the edge has no corners.
    pub(super) fn straight_parts(&self, edge: u32) -> [Option<(PlanarLine, [[f64; 2]; 2])>; 2] {
        let parts = self.parts();
        let nodes = self.cells.edges.ends[edge as usize].map(|node| parts.rounded_node(node));
        let [first, [b, a]] = [2 * edge, 2 * edge + 1].map(|halfedge| parts.departure(halfedge));
        if parts.first_chain(edge).corner_count == 0 {
            return [Some((first, nodes)), None];
        }
        [Some((first, [nodes[0], first[1]])), Some(([a, b], [a, nodes[1]]))]
    }

    /// The faces that points lie in, or that end at them; `None` for the unbounded one.
    #[doc(hidden)]
    pub fn faces_at(&self, points: &[[f64; 2]]) -> Vec<Option<u32>> {
        if points.is_empty() {
            return Vec::new();
        }
        let (tree, parts) = (self.rings.soup.tree(), self.parts());
        let face = |&point: &[f64; 2]| {
            let below = parts.halfedge_below(&tree, PlanarPoint::given(point))?;
            let face = self.cells.face(below);
            ((face as usize) < self.face_count()).then_some(face)
        };
        points.par_iter().with_min_len(16).map(face).collect()
    }
}
