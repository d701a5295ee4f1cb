//! Boolean combinations of sets with curves of order 4 and more.

use super::Combination;
use super::welding::{Welded, welded};
use crate::PieceSource;
use crate::curve::{bernstein, distance_to};
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

/// What measures how far two sets are apart where how their curves cross cannot be decided.
const COMPARISON_CURE: &str =
    "coface yin compare A B measures how far two sets are apart without such decisions";

/// The set of the faces whose winding numbers satisfy a condition. Orders are raised to the highest.
///
/// A set that is not made of certified decisions alone is checked.
pub(super) fn combine_curved(
    sets: &[&YinSet],
    regions: Regions,
    condition: impl Fn(&[(u32, i32)]) -> bool,
) -> Result<Combination, Error> {
    combine_closely(sets, regions, condition).map_err(|error| match error.cure() {
        Some(cure) if sets.len() == 2 && regions == Regions::Sets && cure == NEARNESS_CURE => {
            let cure = format!("{cure}; {COMPARISON_CURE}");
            Error::new(error.kind(), error.message()).with_cure(cure)
        }
        _ => error,
    })
}

/// The combination of sets as they are; or where that fails, with pieces that are one but for rounding made one.
fn combine_closely(
    sets: &[&YinSet],
    regions: Regions,
    condition: impl Fn(&[(u32, i32)]) -> bool,
) -> Result<Combination, Error> {
    let error = match combine_as_they_are(sets, regions, &condition) {
        Err(error) if error.kind() == ErrorKind::InvalidInput => error,
        found => return found,
    };
    let Some(Welded { sets: welded, decisions }) = welded(sets, rounding_limit(sets)) else {
        return Err(error);
    };
    let welded: Vec<&YinSet> = welded.iter().collect();
    let Ok(mut found) = combine_as_they_are(&welded, regions, &condition) else { return Err(error) };
    let report = std::mem::replace(&mut found.report, decisions);
    found = found.with_area_error(sets);
    found.report.extend(report);
    Ok(found)
}

fn combine_as_they_are(
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
    // What is taken for one has to be one but for rounding: else something would be lost in silence.
    let limit = rounding_limit(sets);
    let lossy = |found: &Combination| {
        found
            .report
            .iter()
            .find(|decision| is_lossy(sets, decision, limit))
            .map(|decision| lost(found, decision))
    };
    let is_lossless = |found: &Combination| lossy(found).is_none();
    // What is nearer together than the usual resolution may be apart.
    let mut at_fine = None;
    for fine in FINE {
        match combine_at(sets, regions, &condition, fine)
            .and_then(|found| lossy(&found).map_or(Ok(found), Err))
        {
            Ok(found) => return Ok(found),
            Err(error) => _ = at_fine.get_or_insert(error),
        }
    }
    match at_usual {
        Ok(found) if is_lossless(&found) => return Ok(found),
        Ok(_) => return Err(at_fine.expect("finer resolutions have failed")),
        Err(_) => {}
    }
    for coarseness in COARSE {
        match combine_at(sets, regions, &condition, coarseness) {
            Err(error) if error.kind() == ErrorKind::InvalidInput => {}
            Ok(found) if !is_lossless(&found) => {}
            found => return found,
        }
    }
    at_usual
}

/// How far coordinates of results are off at most: so many times the last digit of the largest, for each degree of freedom of a piece.
fn rounding_limit(sets: &[&YinSet]) -> f64 {
    const ROUNDING: f64 = 16.0;
    let corners = sets.iter().filter_map(|set| set.bounding_box()).flatten().flatten();
    let largest = corners.fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let order = sets.iter().map(|set| set.order().value()).max().unwrap_or(0);
    ROUNDING * order as f64 * f64::EPSILON * largest
}

/// The error for what was taken for one although double coordinates tell it apart.
fn lost(found: &Combination, decision: &UncertifiedDecision) -> Error {
    let [x, y] = decision.point;
    let what = match decision.assumption {
        Assumption::SmallCurve => "whether a curve is more than a point",
        _ => "which arcs curves have in common",
    };
    Error::invalid(format!("{what} near ({x}, {y}) cannot be decided at resolution {:e}", found.resolution))
        .with_cure(NEARNESS_CURE)
}

/// Whether two arcs were taken for one that are farther apart than double coordinates tell, or a curve for a point.
fn is_lossy(sets: &[&YinSet], decision: &UncertifiedDecision, limit: f64) -> bool {
    /// How many places of an arc are looked at.
    const PLACES: usize = 8;
    let [a, b] = decision.pieces();
    let curve = |source: &PieceSource| sets[source.operand as usize].curve(source.curve as usize);
    match decision.assumption() {
        Assumption::SamePoint | Assumption::ArcOrder => false,
        Assumption::SmallCurve => {
            let own = curve(&a);
            let [low, high] = bernstein::control_box(own.controls());
            (0..2).any(|axis| high[axis] - low[axis] > limit)
        }
        Assumption::SameArc => {
            let [own, other] = [curve(&a), curve(&b)];
            let own = own.piece(a.piece as usize);
            // The arc may go on along other pieces of the curve.
            let is_near = |piece: usize, point| distance_to(other.piece(piece), point, 2.0 * limit) <= limit;
            (0..=PLACES).any(|place| {
                let part = place as f64 / PLACES as f64;
                let point = bernstein::value(own, a.range[0] + part * (a.range[1] - a.range[0]));
                !is_near(b.piece as usize, point)
                    && !(0..other.piece_count()).any(|piece| is_near(piece, point))
            })
        }
    }
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
    if let Some([x, y]) = doubled_piece(&found) {
        // Points that became one took what was between two straight pieces.
        return Err(Error::invalid(format!(
            "which arcs curves have in common near ({x}, {y}) cannot be decided at resolution {:e}",
            found.resolution
        ))
        .with_cure(NEARNESS_CURE));
    }
    Ok(found.with_area_error(sets))
}

/// Where two pieces of a result have the same control points, in one order or the other: the boundary of a set has none twice.
fn doubled_piece(found: &Combination) -> Option<[f64; 2]> {
    let curves = (0..found.set.curve_count()).map(|curve| found.set.curve(curve));
    let mut pieces: Vec<Vec<[f64; 2]>> = Vec::new();
    for curve in curves {
        for piece in 0..curve.piece_count() {
            let mut own = curve.piece(piece).to_vec();
            if own.iter().rev().partial_cmp(own.iter()) == Some(std::cmp::Ordering::Less) {
                own.reverse();
            }
            pieces.push(own);
        }
    }
    pieces.sort_by(|a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
    pieces.windows(2).find(|pair| pair[0] == pair[1]).map(|pair| pair[0][0])
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
