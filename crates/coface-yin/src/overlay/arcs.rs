//! Edges of an overlay one by one, for those who follow them.

use super::CurvedOverlay;
use crate::{Curve, YinSet};
use coface_arrange::planar::RingCells;

impl CurvedOverlay<'_> {
    /// Edges, faces and winding numbers.
    pub(crate) fn cells(&self) -> &RingCells {
        &self.cells
    }

    /// The curve along an edge from node to node: parts of pieces of the first curve that runs along it.
    pub(crate) fn arc(&self, edge: u32) -> Curve<'static> {
        let order = self.boundaries.order();
        let parts: Vec<(u32, [f64; 2])> = self.chains().parts(self.cells.edges().first_chain(edge)).collect();
        let [from, to] = self.cells.edges().ends()[edge as usize].map(|node| self.node_point(node));
        let (mut controls, mut knots) = (Vec::with_capacity(parts.len() * order.degree() + 1), vec![0.0]);
        let (mut knot, mut carriers) = (0.0f64, Vec::new());
        for (at, &(piece, range)) in parts.iter().enumerate() {
            let own = self.boundaries.controls(piece);
            let start = if at == 0 { from } else { own[0] };
            let end = if at + 1 == parts.len() { to } else { own[own.len() - 1] };
            let carrier = self.boundaries.carriers.of_piece(piece);
            let carried = range.map(|way| self.boundaries.carriers.on_carrier(piece, way));
            let (part, source) = self.boundaries.cut_out(carrier, carried, [start, end]);
            carriers.extend(source.map(|source| source.of_piece(at as u32)));
            controls.extend_from_slice(&part[..part.len() - 1]);
            let growth = self.boundaries.carriers.growth(carrier) * (range[1] - range[0]);
            knot = (knot + growth).max(knot.next_up());
            knots.push(knot);
        }
        controls.push(to);
        Curve::from_trusted(order, controls, knots).carried_by(carriers)
    }

    /// Of the knots within an edge those that are kinks of their set: their numbers on its curve.
    pub(crate) fn arc_kinks(&self, edge: u32, sets: &[&YinSet]) -> Vec<usize> {
        let chains = self.chains();
        let parts = chains.parts(self.cells.edges().first_chain(edge));
        let inner = parts.enumerate().skip(1);
        inner.filter(|&(_, (piece, _))| self.is_source_kink(piece, sets)).map(|(at, _)| at).collect()
    }

    /// The nodes at which a set has a kink.
    pub(crate) fn kink_nodes(&self, sets: &[&YinSet]) -> Vec<bool> {
        let mut found = vec![false; self.nodes.points.len()];
        for own in &self.nodes.breaks {
            found[own.node as usize] |= [own.arrive, own.leave]
                .iter()
                .any(|position| position.parameter == 0.0 && self.is_source_kink(position.piece, sets));
        }
        found
    }

    /// Whether a curve goes on from one halfedge into another, in its direction or against it.
    pub(crate) fn goes_on(&self, before: u32, after: u32) -> bool {
        let chains = self.chains();
        let along = |halfedge: u32| {
            let list = self.cells.edges().chains().list(halfedge as usize / 2);
            list.iter().map(move |&chain| {
                (chain, self.cells.edges().halfedge_of_chain()[chain as usize] == halfedge)
            })
        };
        along(before).any(|(a, is_a_along)| {
            along(after).any(|(b, is_b_along)| {
                let [from, to] = if is_a_along { [a, b] } else { [b, a] };
                is_a_along == is_b_along && chains.end(from) == to
            })
        })
    }
}
