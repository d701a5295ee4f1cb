//! Points that go further and further, from one feature to the next, are held at a bound.

use super::{NearChains, minus, squared};

/// The longest way that points may go, and the longest way of those that became each vertex.
#[derive(Clone, Debug)]
pub(super) struct MovementBound {
    most: f64,
    pub(super) ways: Vec<f64>,
}

impl NearChains {
    /// Puts no vertex further than `most` away from where any of its points was first: `ways` has how far the points at
    /// each vertex went before.
    pub(crate) fn bound_movements(&mut self, most: f64, ways: Vec<f64>) {
        self.bound = Some(MovementBound { most, ways });
    }

    /// Whether a vertex may go to another one.
    pub(super) fn may_go(&self, own: u32, target: u32) -> bool {
        self.bound.as_ref().is_none_or(|bound| self.way(bound, own, target) <= bound.most)
    }

    /// Notes that a vertex goes to another one.
    pub(super) fn note_way(&mut self, own: u32, target: u32) {
        let Some(mut bound) = self.bound.take() else { return };
        let way = self.way(&bound, own, target);
        let longest = &mut bound.ways[target as usize];
        *longest = longest.max(way);
        self.bound = Some(bound);
    }

    fn way(&self, bound: &MovementBound, own: u32, target: u32) -> f64 {
        bound.ways[own as usize] + squared(minus(self.point(own), self.point(target))).sqrt()
    }
}
