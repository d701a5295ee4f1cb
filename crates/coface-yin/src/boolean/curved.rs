//! Boolean combinations of sets with curves of order 4 and more.

use super::Combination;
use crate::overlay::{CurvedOverlay, NEARNESS_CURE};
use crate::set::CurveArena;
use crate::{Assumption, UncertifiedDecision, YinSet};
use coface_algebra::{Error, ErrorKind};
use coface_arrange::planar::{JordanFault, JordanRings};

/// The resolutions that are tried one after the other, in multiples of the usual one.
///
/// Curves may run apart by about the resolution all along, once a little more and once a little less; then they cannot be brought
/// together everywhere nor nowhere. At another resolution they can.
const COARSENESS: [f64; 3] = [1.0, 64.0, 4096.0];

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
    let mut first_error = None;
    for coarseness in COARSENESS {
        match combine_at(sets, regions, &condition, coarseness) {
            Err(error) if error.kind() == ErrorKind::InvalidInput => {
                first_error.get_or_insert(error);
            }
            found => return found,
        }
    }
    Err(first_error.expect("there is more than one resolution"))
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
    if coarseness > COARSENESS[0] && found.report.iter().any(is_lost) {
        return Err(Error::invalid("a curve is lost at a coarser resolution"));
    }
    if !found.report.is_empty()
        && let Some(fault) = found.set.validate()?
    {
        return Err(Error::invalid(format!(
            "how curves run cannot be decided at resolution {:e}: in the result {fault}",
            found.resolution
        ))
        .with_cure(NEARNESS_CURE));
    }
    Ok(found)
}

/// How curves lie that are Jordan curves and almost disjoint, or the first fault.
///
/// # Errors
/// If the resolution does not tell.
pub(crate) fn curved_jordan_rings(arena: &CurveArena) -> Result<Result<JordanRings, JordanFault>, Error> {
    CurvedOverlay::new(&[arena])?.jordan_rings()
}
