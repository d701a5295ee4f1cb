//! Kinks and their names.

use crate::simplicial::{Simplex, SimplicialComplex};
use crate::{Error, VertexId};

/// A knot of a curve of a Yin set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct KnotIndex {
    /// The curve.
    pub curve: u32,
    /// The knot on it, below the number of its pieces.
    pub knot: u32,
}

/// The kinks of a Yin set: a 0-dimensional simplicial complex whose vertices are in bijection with some knots of the boundary.
#[derive(Clone, Debug, PartialEq)]
pub struct Kinks {
    /// By rising knots.
    by_knot: Vec<(KnotIndex, u32)>,
    next_name: u32,
}

impl Kinks {
    /// Kinks at knots that rise, named 0, 1, 2, ...
    pub(in crate::yin) fn new(knots: Vec<KnotIndex>) -> Self {
        let next_name = knots.len() as u32;
        Self { by_knot: knots.into_iter().zip(0..).collect(), next_name }
    }

    /// The number of kinks.
    pub fn len(&self) -> usize {
        self.by_knot.len()
    }

    /// Whether there are no kinks.
    pub fn is_empty(&self) -> bool {
        self.by_knot.is_empty()
    }

    /// The knots that are kinks, rising, each with its vertex.
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (KnotIndex, VertexId)> + '_ {
        self.by_knot.iter().map(|&(knot, name)| (knot, VertexId::from_u32(name)))
    }

    /// The vertex of a knot that is a kink.
    pub fn vertex(&self, knot: KnotIndex) -> Option<VertexId> {
        let at = self.by_knot.binary_search_by_key(&knot, |&(knot, _)| knot).ok()?;
        Some(VertexId::from_u32(self.by_knot[at].1))
    }
}
