//! The canonical form of a set: which curve comes first, and where it begins.

use super::{CurveArena, YinSet};
use crate::{KnotIndex, Order};
use coface_algebra::RaggedArray;
use coface_geometry::predicates::orientation;
use rayon::prelude::*;
use std::cmp::Ordering;

/// Curves breadth first through their forest, those with one parent by rising lowest points.
pub(crate) struct CanonicalOrder {
    order: Vec<u32>,
    /// The place of each curve.
    places: Vec<u32>,
}

impl CanonicalOrder {
    /// The order of curves, given the parent and the lowest point of each, and a comparison of those with one lowest point.
    pub(crate) fn new(
        parents: &[Option<u32>],
        lowest: impl Fn(u32) -> [f64; 2] + Sync,
        compare: impl Fn(u32, u32) -> Ordering + Sync,
    ) -> Self {
        let forest = super::HasseForest::new(parents.to_vec());
        let depths = (0..parents.len()).map(|curve| forest.depth(curve) as u32);
        let depth_count = depths.clone().max().map_or(0, |depth| depth as usize + 1);
        let levels = RaggedArray::grouped(depth_count, depths);
        let mut found = Self { order: Vec::with_capacity(parents.len()), places: vec![0; parents.len()] };
        for level in levels.iter() {
            let mut keyed: Vec<(u32, [f64; 2], u32)> = level
                .par_iter()
                .map(|&curve| {
                    let parent = parents[curve as usize].map_or(0, |parent| found.places[parent as usize]);
                    (parent, lowest(curve), curve)
                })
                .collect();
            keyed.par_sort_unstable_by(|a, b| {
                a.0.cmp(&b.0)
                    .then_with(|| a.1.partial_cmp(&b.1).unwrap_or(Ordering::Equal))
                    .then_with(|| compare(a.2, b.2))
                    .then(a.2.cmp(&b.2))
            });
            for (_, _, curve) in keyed {
                found.places[curve as usize] = found.order.len() as u32;
                found.order.push(curve);
            }
        }
        found
    }

    /// The curves in order.
    pub(crate) fn items(&self) -> &[u32] {
        &self.order
    }

    /// The parents of the curves in order, by places in the order.
    pub(crate) fn parents(&self, parents: &[Option<u32>]) -> Vec<Option<u32>> {
        let place = |curve: u32| self.places[curve as usize];
        self.order.iter().map(|&curve| parents[curve as usize].map(place)).collect()
    }
}

impl YinSet {
    /// The same set with its curves in canonical form: each begins at its lexicographically lowest knot, and they come breadth first
    /// through the forest, those in one curve by rising first knots. Kinks stay where they are and get new names.
    ///
    /// Boolean combinations are in this form. Equal sets with equal knots and kinks are equal then.
    ///
    /// # Complexity
    /// $O(n + N \log N)$ for n pieces of N curves.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = |at: usize| {
    ///     let mut corners = vec![[0., 0.], [1., 0.], [1., 1.], [0., 1.]];
    ///     corners.rotate_left(at);
    ///     corners.push(corners[0]);
    ///     YinSet::new(&[Curve::polyline(&corners)?])
    /// };
    /// assert_ne!(square(0)?, square(2)?);
    /// assert_eq!(square(0)?, square(2)?.canonical());
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn canonical(&self) -> Self {
        let arena = self.arena();
        let degree = arena.order().degree();
        let first_knots: Vec<u32> = arena
            .iter()
            .map(|curve| {
                let knots = 0..curve.piece_count();
                let lowest =
                    knots.reduce(|a, b| if curve.knot_point(b) < curve.knot_point(a) { b } else { a });
                lowest.unwrap_or(0) as u32
            })
            .collect();
        let walk = |curve: u32| {
            let first = first_knots[curve as usize] as usize;
            let controls = arena.curve(curve as usize).controls().len() - 1;
            let start = arena.first_piece(curve as usize) * degree + curve as usize;
            (first * degree..controls).chain(0..first * degree).map(move |at| arena.controls()[start + at])
        };
        let parents: Vec<Option<u32>> =
            (0..arena.len()).map(|curve| self.forest().parent(curve).map(|parent| parent as u32)).collect();
        let order = CanonicalOrder::new(
            &parents,
            |curve| arena.curve(curve as usize).knot_point(first_knots[curve as usize] as usize),
            |a, b| walk(a).partial_cmp(walk(b)).unwrap_or(Ordering::Equal),
        );
        let mut curves = CurveArena::with_capacity(arena.order(), arena.piece_count(), arena.len());
        for &curve in order.items() {
            curves.push_turned(&arena.curve(curve as usize), first_knots[curve as usize] as usize);
        }
        let mut kinks: Vec<KnotIndex> = self
            .kinks()
            .iter()
            .map(|(index, _)| {
                let count = arena.curve(index.curve as usize).piece_count() as u32;
                let first = first_knots[index.curve as usize];
                let knot = if index.knot < first { index.knot + count - first } else { index.knot - first };
                KnotIndex { curve: order.places[index.curve as usize], knot }
            })
            .collect();
        kinks.sort_unstable();
        Self::from_parts(curves, !self.is_bounded(), order.parents(&parents), kinks)
    }

    /// The same set without the knots at which a polyline goes straight on, exactly, and without kinks, which do not change a
    /// polyline. Sets of higher orders stay as they are.
    ///
    /// With [`Self::canonical`] that is the unique form of a set of order 2: two sets have the same points if and only if these forms
    /// are equal, bit for bit.
    ///
    /// # Complexity
    /// Linear in the pieces.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, YinSet};
    /// let square = YinSet::new(&[Curve::polyline(&[[0., 0.], [1., 0.], [2., 0.], [2., 2.], [0., 2.], [0., 0.]])?])?;
    /// assert_eq!(square.straightened().curve(0).piece_count(), 4);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    #[must_use]
    pub fn straightened(&self) -> Self {
        let arena = self.arena();
        if arena.order() != Order::LINEAR {
            return self.clone();
        }
        let mut curves = CurveArena::new(Order::LINEAR);
        for curve in arena.iter() {
            let points = &curve.controls()[..curve.piece_count()];
            let count = points.len();
            let turns = |&knot: &usize| {
                let [a, b, c] =
                    [points[(knot + count - 1) % count], points[knot], points[(knot + 1) % count]];
                // What turns back by half a turn is no Jordan curve, and is left alone.
                let is_between = (0..2).all(|axis| {
                    (a[axis] <= b[axis] && b[axis] <= c[axis]) || (a[axis] >= b[axis] && b[axis] >= c[axis])
                });
                orientation(a, b, c).is_ne() || !is_between
            };
            let kept: Vec<usize> = (0..count).filter(turns).collect();
            curves.push_polyline(kept.into_iter().map(|knot| points[knot]));
        }
        let parents = (0..arena.len()).map(|curve| self.forest().parent(curve).map(|parent| parent as u32));
        Self::from_parts(curves, !self.is_bounded(), parents.collect(), Vec::new())
    }
}
