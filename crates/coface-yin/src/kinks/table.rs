//! Kinks and their names.

use super::SmoothPieces;
use crate::EndCondition;
use coface_algebra::VertexId;
use coface_complexes::simplicial::{Simplex, SimplicialComplex};
use std::collections::BTreeMap;

/// A knot of a curve of a Yin set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct KnotIndex {
    /// The curve.
    pub curve: u32,
    /// The knot on it, below the number of its pieces.
    pub knot: u32,
}

/// The kinks of a Yin set: a 0-dimensional simplicial complex whose vertices are in bijection with some knots of the boundary.
///
/// The name of a kink, its vertex, stays the same as long as the kink is there, and no other kink gets it afterwards. Two are equal
/// when the same knots have the same names.
#[derive(Clone, Debug)]
pub struct Kinks {
    by_knot: BTreeMap<KnotIndex, u32>,
    by_name: BTreeMap<u32, KnotIndex>,
    next_name: u32,
    /// How the smooth pieces between kinks come about.
    pub(super) pieces: SmoothPieces,
}

impl PartialEq for Kinks {
    fn eq(&self, other: &Self) -> bool {
        self.by_knot == other.by_knot
    }
}

impl Kinks {
    /// Kinks at knots that rise, named 0, 1, 2, ...
    pub(crate) fn new(knots: Vec<KnotIndex>) -> Self {
        let next_name = knots.len() as u32;
        let (by_name, by_knot) = rayon::join(
            || (0..).zip(knots.iter().copied()).collect(),
            || knots.iter().copied().zip(0..).collect(),
        );
        drop(knots);
        Self { by_name, by_knot, next_name, pieces: SmoothPieces::default() }
    }

    /// Kinks at knots that rise, with names of which none is twice; `next_name` is not below what they leave free.
    pub(crate) fn named(by_knot: Vec<(KnotIndex, u32)>, next_name: Option<u32>) -> Self {
        let free = by_knot.iter().map(|&(_, name)| name + 1).max().unwrap_or(0);
        Self {
            by_name: by_knot.iter().map(|&(knot, name)| (name, knot)).collect(),
            by_knot: by_knot.into_iter().collect(),
            next_name: next_name.unwrap_or(0).max(free),
            pieces: SmoothPieces::default(),
        }
    }

    /// How smooth pieces that are fitted end.
    pub(crate) fn ends(&self) -> &EndCondition {
        self.pieces.ends()
    }

    pub(crate) fn with_ends(mut self, ends: &EndCondition) -> Self {
        self.pieces.set_ends(ends);
        self
    }

    /// The first name that no kink ever had.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, Order, YinSet};
    /// let ring = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let set = YinSet::fit(&[ring], &[vec![0, 2]], Order::LINEAR, &EndCondition::NotAKnot)?;
    /// assert_eq!(set.kinks().next_name(), 2);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn next_name(&self) -> u32 {
        self.next_name
    }

    /// The number of kinks.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, Order, YinSet};
    /// let ring = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let set = YinSet::fit(&[ring], &[vec![0, 2]], Order::LINEAR, &EndCondition::NotAKnot)?;
    /// assert_eq!(set.kinks().len(), 2);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn len(&self) -> usize {
        self.by_knot.len()
    }

    /// Whether there are no kinks.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, Order, YinSet};
    /// let ring = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let set = YinSet::fit(&[ring], &[vec![0, 2]], Order::LINEAR, &EndCondition::NotAKnot)?;
    /// assert!(!set.kinks().is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn is_empty(&self) -> bool {
        self.by_knot.is_empty()
    }

    /// The knots that are kinks, rising, each with its vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, Order, YinSet};
    /// let ring = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let set = YinSet::fit(&[ring], &[vec![0, 2]], Order::LINEAR, &EndCondition::NotAKnot)?;
    /// assert_eq!(set.kinks().iter().map(|(at, _)| at.knot).collect::<Vec<_>>(), [0, 2]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn iter(&self) -> impl ExactSizeIterator<Item = (KnotIndex, VertexId)> + '_ {
        self.by_knot.iter().map(|(&knot, &name)| (knot, VertexId::from_u32(name)))
    }

    /// The knots of one curve that are kinks, rising.
    ///
    /// # Complexity
    /// $O(\log m + k)$ for k kinks on the curve and m in all.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, Order, YinSet};
    /// let ring = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let set = YinSet::fit(&[ring], &[vec![0, 2]], Order::LINEAR, &EndCondition::NotAKnot)?;
    /// assert_eq!(set.kinks().on_curve(0).collect::<Vec<_>>(), [0, 2]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn on_curve(&self, curve: u32) -> impl DoubleEndedIterator<Item = u32> + '_ {
        let [first, last] = [0, u32::MAX].map(|knot| KnotIndex { curve, knot });
        self.by_knot.range(first..=last).map(|(at, _)| at.knot)
    }

    /// The vertex of a knot that is a kink.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, KnotIndex, Order, YinSet};
    /// let ring = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let set = YinSet::fit(&[ring], &[vec![0, 2]], Order::LINEAR, &EndCondition::NotAKnot)?;
    /// let corner = KnotIndex { curve: 0, knot: 2 };
    /// assert_eq!(set.kinks().vertex(corner).map(|vertex| vertex.index()), Some(1));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn vertex(&self, knot: KnotIndex) -> Option<VertexId> {
        self.by_knot.get(&knot).map(|&name| VertexId::from_u32(name))
    }

    /// The knot of a vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, KnotIndex, Order, YinSet};
    /// let ring = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let set = YinSet::fit(&[ring], &[vec![0, 2]], Order::LINEAR, &EndCondition::NotAKnot)?;
    /// let corner = KnotIndex { curve: 0, knot: 2 };
    /// let vertex = set.kinks().vertex(corner).expect("the corner is a kink");
    /// assert_eq!(set.kinks().knot(vertex), Some(corner));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn knot(&self, vertex: VertexId) -> Option<KnotIndex> {
        self.by_name.get(&(vertex.index() as u32)).copied()
    }

    /// The kinks as a complex of their own: changes of it do not reach the set.
    ///
    /// # Complexity
    /// $O(m \log m)$ for m kinks.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{EndCondition, Order, YinSet};
    /// let square = vec![[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    /// let set = YinSet::fit(&[square], &[vec![0, 2]], Order::CUBIC, &EndCondition::NotAKnot)?;
    /// let complex = set.kinks().complex();
    /// assert_eq!((complex.dimension(), complex.f_vector()), (Some(0), vec![2]));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn complex(&self) -> SimplicialComplex {
        let vertices = self.by_name.keys().map(|&name| Simplex::from([name]));
        SimplicialComplex::from_simplices(vertices).expect("vertices alone are a complex")
    }

    /// The kinks of the curve before and after a knot of it, cyclically; the knot itself is neither unless it is the only one.
    pub(super) fn around(&self, at: KnotIndex) -> Option<[u32; 2]> {
        let on_curve = |low, high| {
            let [low, high] = [low, high].map(|knot| KnotIndex { curve: at.curve, knot });
            self.by_knot.range(low..=high).map(|(at, _)| at.knot)
        };
        let lower = || at.knot.checked_sub(1).and_then(|below| on_curve(0, below).next_back());
        let upper = || at.knot.checked_add(1).and_then(|above| on_curve(above, u32::MAX).next());
        let before = lower().or_else(|| on_curve(at.knot, u32::MAX).next_back())?;
        let after = upper().or_else(|| on_curve(0, at.knot).next())?;
        Some([before, after])
    }

    /// A new name for a knot that is no kink yet.
    pub(super) fn insert(&mut self, knot: KnotIndex) -> VertexId {
        let name = self.next_name;
        self.next_name += 1;
        self.by_knot.insert(knot, name);
        self.by_name.insert(name, knot);
        VertexId::from_u32(name)
    }

    pub(super) fn erase(&mut self, vertex: VertexId) {
        if let Some(knot) = self.by_name.remove(&(vertex.index() as u32)) {
            self.by_knot.remove(&knot);
        }
    }
}
