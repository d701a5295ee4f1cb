//! Circles and helices.

use super::lattice::{Lattice, apart, check_count, check_length, upward};
use super::{CellKind, PlacedCells};
use coface_algebra::Error;
use coface_geometry::Angle;

/// The circle of this radius about the origin of the plane, counterclockwise: $r (\cos t, \sin t)$ at `segments` equal steps.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless the radius is positive and there are 3 segments or more;
/// [`coface_algebra::ErrorKind::TooLarge`] from $2^{31}$ points on.
///
/// # Examples
/// ```
/// let square = coface_complexes::shapes::circle(1.0, 4)?;
/// assert_eq!(square.positions().as_flat(), [1.0, 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, -1.0]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn circle(radius: f64, segments: u32) -> Result<PlacedCells, Error> {
    check_length("radius", radius)?;
    check_count("segments", segments, 3)?;
    let place = |place: &[u32], out: &mut Vec<f64>| {
        let (c, s) = Angle::turns(place[0].into(), segments).cosine_and_sine();
        out.extend([radius * c, radius * s]);
    };
    let glue = |place: &mut [u32]| place[0] %= segments;
    Lattice { shape: &[segments], space: 2, glue: &glue, is_downward: &upward, place: &place }
        .cells(CellKind::Simplex)
}

/// The helix $(r \cos t, r \sin t, p\, t / 2 \pi)$ for t from 0 to $2 \pi$ times the number of turns, in equal steps. It is right-handed;
/// with negative turns it is left-handed and goes down.
///
/// # Errors
/// [`coface_algebra::ErrorKind::InvalidInput`] unless the radius is positive, the pitch finite, the number of turns finite and not
/// zero, and there is a segment.
///
/// # Examples
/// ```
/// let helix = coface_complexes::shapes::helix(1.0, 8.0, 1.0, 4)?;
/// assert_eq!(helix.positions().as_flat()[3..6], [0.0, 1.0, 2.0]);
/// assert_eq!((helix.vertex_count(), helix.cell_count()), (5, 4));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn helix(radius: f64, pitch: f64, turns: f64, segments: u32) -> Result<PlacedCells, Error> {
    check_length("radius", radius)?;
    check_winding(pitch, turns)?;
    check_count("segments", segments, 1)?;
    let steps = turned_steps(turns, segments)?;
    let place = |place: &[u32], out: &mut Vec<f64>| {
        let (c, s) = steps[place[0] as usize];
        out.extend([radius * c, radius * s, pitch * (turns * f64::from(place[0]) / f64::from(segments))]);
    };
    Lattice { shape: &[segments], space: 3, glue: &apart, is_downward: &upward, place: &place }
        .cells(CellKind::Simplex)
}

/// That a helix winds.
pub(super) fn check_winding(pitch: f64, turns: f64) -> Result<(), Error> {
    if !(turns.is_finite() && turns != 0.0) {
        return Err(Error::invalid(format!("the number of turns is {turns}"))
            .with_cure("give a number that is not zero; negative ones wind the other way"));
    }
    if !pitch.is_finite() {
        return Err(Error::invalid(format!("the pitch is {pitch}")).with_cure("give a finite rise a turn"));
    }
    Ok(())
}

/// Cosine and sine of `steps + 1` equal steps through so many turns.
pub(super) fn turned_steps(turns: f64, steps: u32) -> Result<Vec<(f64, f64)>, Error> {
    super::lattice::check_size(&[steps], CellKind::Simplex)?;
    let angle = |i: u32| Angle::degrees(360.0 * (turns * f64::from(i) / f64::from(steps)));
    (0..=steps).map(|i| Ok(angle(i)?.cosine_and_sine())).collect()
}
