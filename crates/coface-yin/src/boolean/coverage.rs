//! Where sets lie over each other in a way that they should not.

use super::linear::linear_overlay;
use crate::overlay::CurvedOverlay;
use crate::set::CurveArena;
use crate::{Order, YinSet};
use coface_algebra::Error;
use std::cell::RefCell;

/// A place around which sets wind in some way.
#[derive(Clone, Debug)]
pub(crate) struct Covering {
    /// The sets with a winding number that is not zero, with it.
    pub(crate) windings: Vec<(u32, i32)>,
    /// A point of its boundary, or none for the whole plane.
    pub(crate) point: Option<[f64; 2]>,
    /// The area of all places with the same winding numbers; none if it is infinite.
    pub(crate) area: Option<f64>,
}

/// A place with winding numbers that satisfy a condition, if there is one. Curves may cross and overlap, within a set as well.
///
/// # Errors
/// If the curves cannot be laid over each other.
pub(crate) fn first_covering(
    sets: &[&YinSet],
    is_wanted: impl Fn(&[(u32, i32)]) -> bool,
) -> Result<Option<Covering>, Error> {
    let arenas: Vec<&CurveArena> = sets.iter().map(|set| set.arena()).collect();
    let first: RefCell<Option<Vec<(u32, i32)>>> = RefCell::new(None);
    let probe = |windings: &[(u32, i32)]| {
        if first.borrow().is_none() && is_wanted(windings) {
            *first.borrow_mut() = Some(windings.to_vec());
        }
        false
    };
    if sets.iter().all(|set| set.order() == Order::LINEAR) {
        let overlay = linear_overlay(&arenas)?;
        overlay.cells().faces_where(probe);
        let Some(windings) = first.into_inner() else { return Ok(None) };
        let polygons = overlay.select(|own| own == windings)?;
        let point = if polygons.rings().is_empty() { None } else { polygons.ring_positions(0).next() };
        let area = (!polygons.has_exterior()).then(|| polygons.area());
        return Ok(Some(Covering { windings, point, area }));
    }
    let overlay = CurvedOverlay::new(&arenas)?;
    overlay.cells().faces_where(probe);
    let Some(windings) = first.into_inner() else { return Ok(None) };
    let found = overlay.select_faces(sets, |own| own == windings)?.into_set();
    let point = (found.curve_count() > 0).then(|| found.curve(0).knot_point(0));
    Ok(Some(Covering { windings, point, area: found.area() }))
}
