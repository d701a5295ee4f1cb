//! Curves as chords.

use crate::{Remark, RemarkCode};
use coface_algebra::{Error, ErrorKind};
use coface_yin::{Curve, Order};

/// More chords than these for one piece are refused.
const MOST_CHORDS: f64 = 1e6;

/// The corners of a polygon that is within a tolerance of a closed curve; the first is not repeated. The knots are corners.
///
/// Chords between points at equal steps of the parameter are within an eighth of the square of the step times the greatest second
/// derivative, which is at most d(d - 1) times the greatest second difference of the control points, for the degree d.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] if the tolerance is not positive; [`ErrorKind::TooLarge`] for a piece of more than a million chords.
///
/// # Complexity
/// Linear in the corners.
///
/// # Examples
/// ```
/// use coface_io::yin::flattened;
/// use coface_yin::{Curve, Order};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let square = Curve::polyline(&[[0., 0.], [1., 0.], [1., 1.], [0., 1.], [0., 0.]])?;
/// assert_eq!(flattened(&square.raised(Order::CUBIC)?, 1e-3)?, [[0., 0.], [1., 0.], [1., 1.], [0., 1.]]);
/// # Ok(()) }
/// ```
pub fn flattened(curve: &Curve<'_>, tolerance: f64) -> Result<Vec<[f64; 2]>, Error> {
    check_tolerance(tolerance)?;
    let mut corners = Vec::new();
    let mut level: Vec<[f64; 2]> = Vec::new();
    for piece in 0..curve.piece_count() {
        let controls = curve.piece(piece);
        corners.push(controls[0]);
        if curve.order() == Order::LINEAR {
            continue;
        }
        let degree = curve.order().degree() as f64;
        let bends = controls.windows(3).map(|p| {
            // Neither this nor the points depend on the direction: arcs that sets have in common get the same chords.
            let bend = |axis: usize| (p[0][axis] + p[2][axis]) - 2.0 * p[1][axis];
            bend(0).hypot(bend(1))
        });
        let bend = degree
            * (degree - 1.0)
            * bends.fold(0.0, |most: f64, bend| if bend <= most { most } else { bend });
        let count = (bend / (8.0 * tolerance)).sqrt().ceil().max(1.0);
        if count > MOST_CHORDS || !bend.is_finite() {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("piece {piece} takes {count:.3e} chords to be within {tolerance:e}"),
            )
            .with_cure("allow chords to be farther from the curve: a larger tolerance"));
        }
        for i in 1..count as usize {
            let [t, rest] = [i as f64, count - i as f64].map(|part| part / count);
            level.clear();
            level.extend_from_slice(controls);
            for last in (0..controls.len() - 1).rev() {
                for j in 0..=last {
                    level[j] = [0, 1].map(|axis| level[j][axis] * rest + level[j + 1][axis] * t);
                }
            }
            if corners.last() != Some(&level[0]) {
                corners.push(level[0]);
            }
        }
    }
    Ok(corners)
}

/// The box that holds nothing: its lowest corner is above its highest.
pub(crate) const NO_BOUNDS: [[f64; 2]; 2] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];

/// How far chords may be from curves where nothing is said: a thousandth of the diagonal of the box around all curves.
pub(crate) fn default_tolerance([low, high]: [[f64; 2]; 2]) -> f64 {
    let size = (high[0] - low[0]).hypot(high[1] - low[1]);
    if size.is_finite() && size > 0.0 { (size / 1000.0).max(f64::MIN_POSITIVE) } else { 1.0 }
}

/// The remark on shapes whose curves became chords without being asked.
pub(crate) fn flattening_remark(count: usize, tolerance: f64) -> Remark {
    let subject = match count {
        1 => "1 shape has curves, which".to_owned(),
        _ => format!("{count} shapes have curves, which"),
    };
    let message = format!(
        "{subject} became chords that are within {tolerance:.3e} of them, a thousandth of the drawing's size; --flatten LENGTH \
         says another length, and coface yin keeps curves"
    );
    Remark::new(RemarkCode::CurvesFlattened, message).at(count, [])
}

/// `InvalidInput` unless this is a distance of chords from curves.
pub(crate) fn check_tolerance(tolerance: f64) -> Result<(), Error> {
    if tolerance > 0.0 && tolerance.is_finite() {
        return Ok(());
    }
    Err(Error::invalid(format!("{tolerance} is no distance of chords from curves"))
        .with_cure("give a finite length above 0, in the unit of the drawing"))
}
