//! What the polynomials between two kinks are.

use super::piece_boxes::PieceBoxes;
use crate::{Curve, EndCondition, Order};
use coface_algebra::Error;
use std::collections::BTreeMap;

/// A smooth piece of a curve: from a kink to the next one, or all of a curve without kinks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Span {
    pub(super) curve: u32,
    /// The kinks at its ends, which may be one.
    pub(super) ends: Option<[u32; 2]>,
}

impl Span {
    /// The knot it begins at.
    pub(super) fn first(&self) -> usize {
        self.ends.map_or(0, |[first, _]| first as usize)
    }

    /// The number of its polynomials, on a curve that has so many.
    pub(super) fn length(&self, count: usize) -> usize {
        self.ends.map_or(count, |[first, last]| piece_length(first as usize, last as usize, count))
    }

    /// Its control points as they are, those at both ends included.
    pub(super) fn controls(&self, curve: &Curve<'_>) -> Vec<[f64; 2]> {
        let degree = curve.order().degree();
        let all = &curve.controls()[..curve.piece_count() * degree];
        let [first, length] = [self.first(), self.length(curve.piece_count())].map(|count| count * degree);
        all[first..].iter().chain(all).copied().chain(all.iter().copied()).take(length + 1).collect()
    }

    /// The control points of the spline through its knots.
    pub(super) fn fit(&self, curve: &Curve<'_>, ends: &EndCondition) -> Result<Vec<[f64; 2]>, Error> {
        let count = curve.piece_count();
        let [first, length] = [self.first(), self.length(count)];
        let points: Vec<_> = (first..=first + length).map(|knot| curve.knot_point(knot % count)).collect();
        fitted(&points, curve.order(), if self.ends.is_some() { ends } else { &EndCondition::Periodic })
    }
}

/// How the smooth pieces of a set come about.
#[derive(Clone, Debug)]
pub(crate) struct SmoothPieces {
    ends: EndCondition,
    /// The control points of smooth pieces that are no more and that were not the fits of their knots.
    remembered: BTreeMap<Span, Vec<[f64; 2]>>,
    /// Made by the first edit.
    pub(super) boxes: Option<PieceBoxes>,
}

impl Default for SmoothPieces {
    fn default() -> Self {
        Self { ends: EndCondition::NotAKnot, remembered: BTreeMap::new(), boxes: None }
    }
}

impl SmoothPieces {
    /// The condition at the ends of pieces that will be fitted. Derivatives that were given belong to no other piece.
    pub(super) fn set_ends(&mut self, ends: &EndCondition) {
        self.ends = match ends {
            EndCondition::Natural => EndCondition::Natural,
            _ => EndCondition::NotAKnot,
        };
    }

    pub(super) fn ends(&self) -> &EndCondition {
        &self.ends
    }

    /// The control points of a smooth piece that comes to be.
    pub(super) fn shape(&self, span: &Span, curve: &Curve<'_>) -> Result<Vec<[f64; 2]>, Error> {
        match self.remembered.get(span) {
            Some(controls) => Ok(controls.clone()),
            None => span.fit(curve, &self.ends),
        }
    }

    /// Whether a smooth piece is not what a fit would give again.
    pub(super) fn is_own(&self, span: &Span, curve: &Curve<'_>, controls: &[[f64; 2]]) -> bool {
        span.fit(curve, &self.ends).map_or(true, |fit| fit != controls)
    }

    pub(super) fn remember(&mut self, span: Span, controls: Vec<[f64; 2]>) {
        self.remembered.insert(span, controls);
    }

    pub(super) fn forget(&mut self, span: &Span) {
        self.remembered.remove(span);
    }
}

/// The control points of the spline through points.
pub(super) fn fitted(points: &[[f64; 2]], order: Order, ends: &EndCondition) -> Result<Vec<[f64; 2]>, Error> {
    Ok(Curve::fit(points, order, ends)?.controls().to_vec())
}

/// The number of polynomials from one kink to the next of a closed curve; from a kink to itself they are all.
pub(super) fn piece_length(first: usize, last: usize, count: usize) -> usize {
    if last > first { last - first } else { last + count - first }
}
