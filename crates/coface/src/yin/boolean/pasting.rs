//! What curves bound that have come to meet, by a fill rule.

use super::Combination;
use super::linear::combine_linear;
use crate::Error;
use crate::arrangement::boolean::InsideRule;
use crate::yin::overlay::CurvedOverlay;
use crate::yin::set::CurveArena;
use crate::yin::{Curve, KnotIndex, Order, YinSet};

/// The set that closed curves of one order, each with its kinks, bound by a rule, with where its pieces come from: operand i is curve i.
/// Winding numbers are one higher everywhere if the curves bound what is unbounded.
///
/// # Errors
/// If the curves cannot be laid over each other.
pub(in crate::yin) fn repaired(
    curves: &[(Curve<'_>, Vec<u32>)],
    is_unbounded: bool,
    rule: InsideRule,
) -> Result<Combination, Error> {
    let order = curves.iter().map(|(curve, _)| curve.order()).max().unwrap_or(Order::LINEAR);
    let rings: Vec<YinSet> = curves
        .iter()
        .map(|(curve, kinks)| {
            let mut arena = CurveArena::new(order);
            arena.push(&curve.raised(order)?);
            let kinks = kinks.iter().map(|&knot| KnotIndex { curve: 0, knot }).collect();
            Ok(YinSet::from_parts(arena, false, vec![None], kinks))
        })
        .collect::<Result<_, Error>>()?;
    let operands: Vec<&YinSet> = rings.iter().collect();
    let around = i32::from(is_unbounded);
    let is_inside = |windings: &[(u32, i32)]| {
        rule.is_inside(around + windings.iter().map(|&(_, winding)| winding).sum::<i32>())
    };
    if order == Order::LINEAR {
        return combine_linear(&operands, is_inside);
    }
    let arenas: Vec<&CurveArena> = rings.iter().map(YinSet::arena).collect();
    CurvedOverlay::new(&arenas)?.select_faces(&operands, is_inside)
}
