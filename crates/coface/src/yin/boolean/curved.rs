//! Boolean combinations of sets with curves of order 4 and more.

use super::Combination;
use crate::Error;
use crate::arrangement::planar::{JordanFault, JordanRings};
use crate::yin::YinSet;
use crate::yin::overlay::CurvedOverlay;
use crate::yin::set::CurveArena;

/// The set of the faces whose winding numbers satisfy a condition. Orders are raised to the highest.
pub(in crate::yin) fn combine_curved(
    sets: &[&YinSet],
    condition: impl Fn(&[(u32, i32)]) -> bool,
) -> Result<Combination, Error> {
    let arenas: Vec<&CurveArena> = sets.iter().map(|set| set.arena()).collect();
    CurvedOverlay::new(&arenas)?.select(sets, condition)
}

/// How curves lie that are Jordan curves and almost disjoint, or the first fault.
///
/// # Errors
/// If the resolution does not tell.
pub(in crate::yin) fn curved_jordan_rings(
    arena: &CurveArena,
) -> Result<Result<JordanRings, JordanFault>, Error> {
    CurvedOverlay::new(&[arena])?.jordan_rings()
}
