//! Edges of an overlay one by one, for callers that follow them.

use super::PlanarOverlay;
use super::ring_cells::RingCells;

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
}
