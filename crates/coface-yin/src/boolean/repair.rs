//! Sets from curves that cross and overlap, by a fill rule.

use super::Combination;
use super::curved::{Regions, combine_curved};
use super::linear::combine_linear;
use crate::curve::bernstein::straight_piece;
use crate::set::CurveArena;
use crate::{Curve, KnotIndex, Order, PieceSource, YinSet};
use coface_algebra::Error;
use coface_arrange::boolean::InsideRule;
use coface_geometry::predicates::orientation;

impl YinSet {
    /// The set of what closed curves wind around so often that a rule calls it inside. They may cross and touch and overlap themselves
    /// and each other, and be of different orders. Winding numbers of all curves are added up.
    ///
    /// Pieces with all control points on one line are taken for segments: on the line they may go back and forth, around other points
    /// they wind no other way. Polylines are decided exactly; of other curves what is nearer together than the resolution is taken for one, and told in the
    /// report. The sources of the result name curves by `operand`, and have 0 for `curve`.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a curve that is not closed; as [`Self::combine`].
    ///
    /// # Complexity
    /// As [`Self::combine`].
    ///
    /// # Examples
    /// A loop with a loop inside, around which it winds twice.
    /// ```
    /// use coface_arrange::boolean::InsideRule;
    /// use coface_yin::{Curve, Order, YinSet};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let controls = vec![
    ///     [0., 0.], [4., 0.], [4., 4.], [0., 4.], [-4., 4.], [-4., 1.], [0., 1.],
    ///     [2., 1.], [2., 3.], [0., 3.], [-4., 3.], [-4., 0.], [0., 0.],
    /// ];
    /// let spiral = Curve::from_controls(Order::CUBIC, controls, vec![0., 1., 2., 3., 4.])?;
    /// let [all, once] =
    ///     [InsideRule::Nonzero, InsideRule::Odd].map(|rule| YinSet::combine_curves(&[spiral.clone()], rule));
    /// assert_eq!(all?.set().curve_counts(), [1, 0]);
    /// assert_eq!(once?.set().curve_counts(), [1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn combine_curves(curves: &[Curve<'_>], rule: InsideRule) -> Result<Combination, Error> {
        let curves: Vec<_> = curves.iter().map(|curve| (curve.clone(), Vec::new())).collect();
        Self::combine_kinked_curves(&curves, 0, rule)
    }

    /// The same for curves with kinks at some of their knots, with a winding number for what is far away.
    #[doc(hidden)]
    pub fn combine_kinked_curves(
        curves: &[(Curve<'_>, Vec<u32>)],
        around: i32,
        rule: InsideRule,
    ) -> Result<Combination, Error> {
        if let Some(open) = curves.iter().position(|(curve, _)| !curve.is_closed()) {
            return Err(Error::invalid(format!("curve {open} does not end where it begins"))
                .with_cure("end the curve in its first point"));
        }
        let order = curves.iter().map(|(curve, _)| curve.order()).max().unwrap_or(Order::LINEAR);
        let unfolded: Vec<Unfolded> = curves
            .iter()
            .zip(0..)
            .filter_map(|((curve, kinks), number)| Unfolded::of(number, curve, kinks))
            .collect();
        // All in one region: faces that many curves wind around have one winding number, not one for each.
        let mut arena = CurveArena::new(order);
        let mut kinks = Vec::new();
        for (curve, own) in (0..).zip(&unfolded) {
            arena.push(&own.curve.raised(order)?);
            kinks.extend(own.kinks.iter().map(|&knot| KnotIndex { curve, knot }));
        }
        let rings = Self::from_parts(arena, false, vec![None; unfolded.len()], kinks);
        let is_inside = |windings: &[(u32, i32)]| {
            rule.is_inside(around + windings.iter().map(|&(_, winding)| winding).sum::<i32>())
        };
        let mut found = match order {
            Order::LINEAR => combine_linear(&[&rings], is_inside)?,
            _ => combine_curved(&[&rings], Regions::Rings, is_inside)?,
        };
        let rename = |source: &mut PieceSource| {
            let own = &unfolded[source.curve as usize];
            *source = PieceSource {
                operand: own.number,
                curve: 0,
                piece: own.pieces[source.piece as usize],
                ..*source
            };
        };
        found.sources.iter_mut().for_each(rename);
        found.other_sources.iter_mut().for_each(|(_, source)| rename(source));
        found.report.iter_mut().for_each(|decision| decision.pieces.iter_mut().for_each(rename));
        Ok(found)
    }
}

/// A curve without pieces that go back and forth on a line.
struct Unfolded {
    /// The place of the curve among all.
    number: u32,
    curve: Curve<'static>,
    /// The pieces that are left, by their numbers on the curve.
    pieces: Vec<u32>,
    kinks: Vec<u32>,
}

impl Unfolded {
    /// The curve with segments for pieces with all control points on one line, and without those of them that end where they begin;
    /// none if nothing is left.
    fn of(number: u32, curve: &Curve<'_>, kinks: &[u32]) -> Option<Self> {
        let degree = curve.order().degree();
        let (mut controls, mut knots, mut pieces) = (Vec::new(), Vec::new(), Vec::new());
        for piece in 0..curve.piece_count() {
            let own = curve.piece(piece);
            let ends = [own[0], own[degree]];
            let is_on_line = is_on_line(own);
            if is_on_line && ends[0] == ends[1] {
                continue;
            }
            if is_on_line {
                controls.extend_from_slice(&straight_piece(ends, degree + 1)[..degree]);
            } else {
                controls.extend_from_slice(&own[..degree]);
            }
            knots.push(curve.knots()[piece]);
            pieces.push(piece as u32);
        }
        controls.push(*controls.first()?);
        knots.push(curve.knots()[curve.piece_count()]);
        // The knots at both ends of a piece that is left out are one.
        let count = pieces.len();
        let place = |knot: u32| (pieces.partition_point(|&piece| piece < knot) % count) as u32;
        let mut kinks: Vec<u32> = kinks.iter().map(|&knot| place(knot)).collect();
        kinks.sort_unstable();
        kinks.dedup();
        let curve = Curve::from_controls(curve.order(), controls, knots).expect("what is left is a curve");
        Some(Self { number, curve, pieces, kinks })
    }
}

/// Whether all control points are on one line.
fn is_on_line(controls: &[[f64; 2]]) -> bool {
    let Some(&other) = controls.iter().find(|&&point| point != controls[0]) else { return true };
    controls.iter().all(|&point| orientation(controls[0], other, point).is_eq())
}
