//! Boolean combinations of sets with curves of order 4 and more.

use super::Combination;
use crate::overlay::{CurvedOverlay, NEARNESS_CURE};
use crate::set::CurveArena;
use crate::{Assumption, UncertifiedDecision, YinSet};
use coface_algebra::{Error, ErrorKind};
use coface_arrange::planar::{JordanFault, JordanRings};

/// Finer resolutions, in multiples of the usual one, which are tried where that leaves something open: about as fine as floating-point
/// arithmetic tells how curves run. Curves may run apart by about the first; then another one tells.
const FINE: [f64; 4] = [1.0 / 32.0, 1.0 / 48.0, 1.0 / 16.0, 1.0 / 8.0];

/// The resolutions at which curves are brought together that these cannot tell apart.
///
/// Curves may run apart by about the resolution all along, once a little more and once a little less; then they cannot be brought
/// together everywhere nor nowhere. At another resolution they can.
const COARSE: [f64; 2] = [64.0, 4096.0];

/// What the curves of operands are.
#[derive(Clone, Copy, PartialEq)]
pub(super) enum Regions {
    /// Boundaries of sets.
    Sets,
    /// Closed curves that may cross and overlap themselves.
    Rings,
}

/// The set of the faces whose winding numbers satisfy a condition. Orders are raised to the highest.
///
/// A set that is not made of certified decisions alone is checked.
pub(super) fn combine_curved(
    sets: &[&YinSet],
    regions: Regions,
    condition: impl Fn(&[(u32, i32)]) -> bool,
) -> Result<Combination, Error> {
    let at_usual = combine_at(sets, regions, &condition, 1.0);
    match &at_usual {
        Ok(found) if found.report.is_empty() => return at_usual,
        Err(error) if error.kind() != ErrorKind::InvalidInput => return at_usual,
        _ => {}
    }
    // What is nearer together than the usual resolution may be apart.
    let finer = FINE.iter().find_map(|&fine| combine_at(sets, regions, &condition, fine).ok());
    if let Some(found) = finer {
        return Ok(found);
    }
    if at_usual.is_ok() {
        return at_usual;
    }
    for coarseness in COARSE {
        match combine_at(sets, regions, &condition, coarseness) {
            Err(error) if error.kind() == ErrorKind::InvalidInput => {}
            found => return found,
        }
    }
    at_usual
}

fn combine_at(
    sets: &[&YinSet],
    regions: Regions,
    condition: impl Fn(&[(u32, i32)]) -> bool,
    coarseness: f64,
) -> Result<Combination, Error> {
    let arenas: Vec<&CurveArena> = sets.iter().map(|set| set.arena()).collect();
    let overlay = CurvedOverlay::at_coarseness(&arenas, coarseness)?;
    let found = match regions {
        Regions::Sets => overlay.select(sets, condition)?,
        Regions::Rings => overlay.select_faces(sets, condition)?,
    };
    let is_lost = |decision: &UncertifiedDecision| decision.assumption == Assumption::SmallCurve;
    if coarseness > 1.0 && found.report.iter().any(is_lost) {
        return Err(Error::invalid("a curve is lost at a coarser resolution"));
    }
    if (!found.report.is_empty() || coarseness < 1.0)
        && let Some(fault) = found.set.validate()?
    {
        return Err(Error::invalid(format!(
            "how curves run cannot be decided at resolution {:e}: in the result {fault}",
            found.resolution
        ))
        .with_cure(NEARNESS_CURE));
    }
    Ok(found.with_area_error(sets))
}

/// How curves lie that are Jordan curves and almost disjoint, or the first fault. Curves that are nearer together than the usual resolution
/// are looked at more closely.
///
/// # Errors
/// If no resolution tells.
pub(crate) fn curved_jordan_rings(arena: &CurveArena) -> Result<Result<JordanRings, JordanFault>, Error> {
    let rings_at = |coarseness: f64| {
        CurvedOverlay::at_coarseness(&[arena], coarseness).and_then(|overlay| overlay.jordan_rings())
    };
    let found = rings_at(1.0);
    if matches!(found, Ok(Ok(_))) {
        return found;
    }
    let finer = FINE.iter().find_map(|&fine| rings_at(fine).ok().filter(|rings| rings.is_ok()));
    finer.map_or(found, Ok)
}
