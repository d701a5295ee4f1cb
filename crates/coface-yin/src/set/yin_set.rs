//! Yin sets.

use super::{CurveArena, HasseForest};
use crate::{Curve, Kinks, KnotIndex, Order};

/// A Yin set: a regular open set of the plane with bounded boundary, by the unique almost disjoint oriented Jordan curves that bound
/// it, the set on their left.
///
/// The empty set and the whole plane have no curves and are told apart.
#[derive(Clone, Debug, PartialEq)]
pub struct YinSet {
    curves: CurveArena,
    /// Whether the set reaches to infinity.
    is_unbounded: bool,
    forest: HasseForest,
    kinks: Kinks,
}

impl YinSet {
    /// The set without points.
    pub fn empty(order: Order) -> Self {
        Self::from_parts(CurveArena::new(order), false, Vec::new(), Vec::new())
    }

    /// The whole plane.
    pub fn plane(order: Order) -> Self {
        Self::from_parts(CurveArena::new(order), true, Vec::new(), Vec::new())
    }

    /// A set of curves that are known to be the unique ones, with the parent of each and its kinks, rising.
    pub(crate) fn from_parts(
        curves: CurveArena,
        is_unbounded: bool,
        parents: Vec<Option<u32>>,
        kinks: Vec<KnotIndex>,
    ) -> Self {
        Self { curves, is_unbounded, forest: HasseForest::new(parents), kinks: Kinks::new(kinks) }
    }

    /// The number of coefficients of the polynomials of the boundary.
    pub fn order(&self) -> Order {
        self.curves.order()
    }

    /// Whether the set has no points.
    pub fn is_empty(&self) -> bool {
        self.curves.len() == 0 && !self.is_unbounded
    }

    /// Whether the set is the whole plane.
    pub fn is_plane(&self) -> bool {
        self.curves.len() == 0 && self.is_unbounded
    }

    /// Whether the set is bounded.
    pub fn is_bounded(&self) -> bool {
        !self.is_unbounded
    }

    /// The number of curves of the boundary.
    pub fn curve_count(&self) -> usize {
        self.curves.len()
    }

    /// A curve of the boundary; the set is on its left.
    ///
    /// # Panics
    /// If there is no such curve.
    pub fn curve(&self, curve: usize) -> Curve<'_> {
        self.curves.curve(curve)
    }

    /// Which curve lies in which.
    pub fn forest(&self) -> &HasseForest {
        &self.forest
    }

    /// The kinks of the boundary.
    pub fn kinks(&self) -> &Kinks {
        &self.kinks
    }

    pub(crate) fn arena(&self) -> &CurveArena {
        &self.curves
    }

    /// The curves, for changes that leave their forest.
    pub(crate) fn arena_mut(&mut self) -> &mut CurveArena {
        &mut self.curves
    }

    pub(crate) fn kinks_mut(&mut self) -> &mut Kinks {
        &mut self.kinks
    }

    /// Takes over how the curves of another set lie, which are those of this one.
    pub(crate) fn take_forest(&mut self, from: Self) {
        self.forest = from.forest;
    }
}
