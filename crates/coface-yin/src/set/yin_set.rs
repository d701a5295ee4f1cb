//! Yin sets.

use super::{CurveArena, HasseForest};
use crate::{Curve, Kinks, KnotIndex, Order};

/// A Yin set: a regular open set of the plane with bounded boundary, by the unique almost disjoint oriented Jordan curves that bound
/// it, the set on their left.
///
/// The empty set and the whole plane have no curves; a flag distinguishes them.
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
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Order, YinSet};
    /// assert!(YinSet::empty(Order::LINEAR).is_empty());
    /// ```
    pub fn empty(order: Order) -> Self {
        Self::from_parts(CurveArena::new(order), false, Vec::new(), Vec::new())
    }

    /// The whole plane.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Order, YinSet};
    /// assert!(YinSet::plane(Order::LINEAR).is_plane());
    /// ```
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
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Order, YinSet};
    /// assert_eq!(YinSet::empty(Order::CUBIC).order(), Order::CUBIC);
    /// ```
    pub fn order(&self) -> Order {
        self.curves.order()
    }

    /// Whether the set has no points.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Order, YinSet};
    /// assert!(!YinSet::plane(Order::LINEAR).is_empty());
    /// ```
    pub fn is_empty(&self) -> bool {
        self.curves.len() == 0 && !self.is_unbounded
    }

    /// Whether the set is the whole plane.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Order, YinSet};
    /// assert!(!YinSet::empty(Order::LINEAR).is_plane());
    /// ```
    pub fn is_plane(&self) -> bool {
        self.curves.len() == 0 && self.is_unbounded
    }

    /// Whether the set is bounded.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Order, YinSet};
    /// assert!(YinSet::empty(Order::LINEAR).is_bounded() && !YinSet::plane(Order::LINEAR).is_bounded());
    /// ```
    pub fn is_bounded(&self) -> bool {
        !self.is_unbounded
    }

    /// The number of curves of the boundary.
    ///
    /// # Examples
    /// A square of side 4 with a square hole of side 1.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let outer = Curve::polyline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]])?;
    /// let hole = Curve::polyline(&[[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0], [1.0, 1.0]])?;
    /// let ring = YinSet::new(&[outer, hole])?;
    /// assert_eq!(ring.curve_count(), 2);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn curve_count(&self) -> usize {
        self.curves.len()
    }

    /// A curve of the boundary; the set is on its left.
    ///
    /// # Panics
    /// If there is no such curve.
    ///
    /// # Examples
    /// A square of side 4 with a square hole of side 1.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let outer = Curve::polyline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]])?;
    /// let hole = Curve::polyline(&[[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0], [1.0, 1.0]])?;
    /// let ring = YinSet::new(&[outer, hole])?;
    /// assert_eq!([ring.curve(0).signed_area(), ring.curve(1).signed_area()], [16.0, -1.0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn curve(&self, curve: usize) -> Curve<'_> {
        self.curves.curve(curve)
    }

    /// Which curve lies in which.
    ///
    /// # Examples
    /// A square of side 4 with a square hole of side 1.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let outer = Curve::polyline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]])?;
    /// let hole = Curve::polyline(&[[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0], [1.0, 1.0]])?;
    /// let ring = YinSet::new(&[outer, hole])?;
    /// assert_eq!(ring.forest().parent(1), Some(0));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn forest(&self) -> &HasseForest {
        &self.forest
    }

    /// The kinks of the boundary.
    ///
    /// # Examples
    /// A square of side 4 with a square hole of side 1.
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let outer = Curve::polyline(&[[0.0, 0.0], [4.0, 0.0], [4.0, 4.0], [0.0, 4.0], [0.0, 0.0]])?;
    /// let hole = Curve::polyline(&[[1.0, 1.0], [1.0, 2.0], [2.0, 2.0], [2.0, 1.0], [1.0, 1.0]])?;
    /// let ring = YinSet::new(&[outer, hole])?;
    /// assert!(ring.kinks().is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
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
