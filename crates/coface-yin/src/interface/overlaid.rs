//! Sets laid over each other, polylines exactly and curves within the resolution, as their interface needs it.

use crate::boolean::linear_overlay;
use crate::curve::chord_lengths;
use crate::overlay::CurvedOverlay;
use crate::set::CurveArena;
use crate::{Curve, KnotIndex, Order, YinSet};
use coface_algebra::Error;
use coface_arrange::planar::{PlanarOverlay, RingCells};

/// Sets of order 2, or of which some have a higher order.
pub(super) enum Overlaid<'a> {
    Linear { overlay: PlanarOverlay, is_kink: Vec<bool> },
    Curved { overlay: CurvedOverlay<'a>, sets: &'a [&'a YinSet] },
}

impl<'a> Overlaid<'a> {
    /// # Errors
    /// If the boundaries cannot be laid over each other.
    pub(super) fn new(sets: &'a [&'a YinSet]) -> Result<Self, Error> {
        let arenas: Vec<&CurveArena> = sets.iter().map(|set| set.arena()).collect();
        if sets.iter().any(|set| set.order() != Order::LINEAR) {
            let overlay = CurvedOverlay::new(&arenas)?;
            let is_unbounded: Vec<bool> = sets.iter().map(|set| !set.is_bounded()).collect();
            overlay.check_regions(&is_unbounded)?;
            return Ok(Self::Curved { overlay, sets });
        }
        // The knots of all sets one after the other, as the sides of the overlay are.
        let mut is_kink = Vec::with_capacity(arenas.iter().map(|arena| arena.piece_count()).sum());
        for set in sets {
            let first = is_kink.len();
            is_kink.resize(first + set.arena().piece_count(), false);
            for (KnotIndex { curve, knot }, _) in set.kinks().iter() {
                is_kink[first + set.arena().first_piece(curve as usize) + knot as usize] = true;
            }
        }
        Ok(Self::Linear { overlay: linear_overlay(&arenas)?, is_kink })
    }

    pub(super) fn cells(&self) -> &RingCells {
        match self {
            Self::Linear { overlay, .. } => overlay.cells(),
            Self::Curved { overlay, .. } => overlay.cells(),
        }
    }

    /// The curve along an edge from node to node, and those of its inner knots that are kinks.
    pub(super) fn arc(&self, edge: u32) -> (Curve<'static>, Vec<usize>) {
        match self {
            Self::Linear { overlay, is_kink } => {
                let points = overlay.edge_points(edge);
                let knots = chord_lengths(&points);
                let kinks = (1..).zip(overlay.edge_corners(edge)).filter(|&(_, corner)| is_kink[corner]);
                (Curve::from_trusted(Order::LINEAR, points, knots), kinks.map(|(at, _)| at).collect())
            }
            Self::Curved { overlay, sets } => (overlay.arc(edge), overlay.arc_kinks(edge, sets)),
        }
    }

    /// The nodes at which a set has a kink.
    pub(super) fn kink_nodes(&self) -> Vec<bool> {
        match self {
            Self::Linear { overlay, is_kink } => {
                let mut found = vec![false; overlay.cells().orbits().rotation().len()];
                for (node, corner) in overlay.node_corners() {
                    found[node as usize] |= is_kink[corner];
                }
                found
            }
            Self::Curved { overlay, sets } => overlay.kink_nodes(sets),
        }
    }

    /// Whether the boundary of a set goes on from one halfedge into another.
    pub(super) fn goes_on(&self, before: u32, after: u32) -> bool {
        match self {
            Self::Linear { overlay, .. } => overlay.goes_on(before, after),
            Self::Curved { overlay, .. } => overlay.goes_on(before, after),
        }
    }
}
