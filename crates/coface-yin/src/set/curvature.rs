//! How curves of a boundary bend.

use super::YinSet;
use crate::Curve;
use crate::curve::bernstein;
use coface_algebra::Error;

/// At how many places of a piece curvatures are taken, its ends among them.
const PLACES: usize = 32;

/// How often the way around a place of extreme curvature is narrowed.
const NARROWINGS: u32 = 48;

/// A place on a curve, with a number that is known there.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct CurvePlace {
    /// The piece of the curve.
    pub piece: usize,
    /// The parameter in [0, 1] on that piece.
    pub parameter: f64,
    /// The point.
    pub point: [f64; 2],
    /// What is known there: a curvature, or an angle in radians.
    pub value: f64,
}

/// How a curve of a boundary bends.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct CurveBend {
    /// Where its curvature is least; curvatures are positive where the curve turns left, in units of one over the length unit.
    pub least: CurvePlace,
    /// Where its curvature is greatest.
    pub greatest: CurvePlace,
    /// The knot at which the direction turns most at once, and by how much, in radians, positive to the left.
    pub sharpest: CurvePlace,
    /// The same among knots that are no kinks; none if all are. For splines of order 4 and more it is zero but for rounding where they are
    /// smooth.
    pub roughest: Option<CurvePlace>,
}

impl YinSet {
    /// How each curve bends: its least and its greatest curvature, and where it turns most at a knot. Curvatures are those of places that
    /// were found, by looking at 33 places of each piece and narrowing down the extreme ones.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a curve without a direction, at a point.
    ///
    /// # Complexity
    /// Linear in the pieces.
    ///
    /// # Examples
    /// An ellipse with axes 2 and 1 has curvatures from 1/4 to 2.
    /// ```
    /// use coface_yin::{Curve, Order, YinSet};
    /// let set = YinSet::new(&[Curve::ellipse([0.0, 0.0], [2.0, 1.0], 256, Order::CUBIC)?])?;
    /// let found = set.bends()?[0];
    /// assert!((found.least.value - 0.25).abs() < 1e-3 && (found.greatest.value - 2.0).abs() < 2e-3);
    /// assert!((found.greatest.point[0].abs() - 2.0).abs() < 1e-3 && found.sharpest.value.abs() < 1e-9);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn bends(&self) -> Result<Vec<CurveBend>, Error> {
        (0..self.curve_count()).map(|number| self.bend(number)).collect()
    }

    fn bend(&self, number: usize) -> Result<CurveBend, Error> {
        let curve = self.curve(number);
        let [least, greatest] = extreme_curvatures(&curve);
        let mut sharpest: Option<CurvePlace> = None;
        let mut roughest: Option<CurvePlace> = None;
        let kinks: Vec<u32> = self.kinks().on_curve(number as u32).collect();
        for knot in 0..curve.piece_count() {
            let place = turn_at(&curve, knot).ok_or_else(|| {
                Error::invalid(format!("curve {number} has no direction at knot {knot}"))
                    .with_cure("fit the curve again through its knots")
            })?;
            if is_more(&place, sharpest.as_ref()) {
                sharpest = Some(place);
            }
            if kinks.binary_search(&(knot as u32)).is_err() && is_more(&place, roughest.as_ref()) {
                roughest = Some(place);
            }
        }
        let sharpest = sharpest.expect("a closed curve has pieces");
        Ok(CurveBend { least, greatest, sharpest, roughest })
    }
}

/// Whether a curve turns more at a place than at another, if there is one.
pub(crate) fn is_more(place: &CurvePlace, known: Option<&CurvePlace>) -> bool {
    known.is_none_or(|known| place.value.abs() > known.value.abs())
}

/// How much a curve turns at a knot, from the piece before it to the one that begins there: at its start from its last piece. None without
/// a direction.
pub(crate) fn turn_at(curve: &Curve<'_>, knot: usize) -> Option<CurvePlace> {
    let before = (knot + curve.piece_count() - 1) % curve.piece_count();
    let from = curve.sample(0, before, 1.0, 0.0).tangent?;
    let found = curve.sample(0, knot, 0.0, 0.0);
    let to = found.tangent?;
    let turn = (from[0] * to[1] - from[1] * to[0]).atan2(from[0] * to[0] + from[1] * to[1]);
    Some(CurvePlace { piece: knot, parameter: 0.0, point: found.point, value: turn })
}

/// The least and the greatest curvature of a curve.
pub(crate) fn extreme_curvatures(curve: &Curve<'_>) -> [CurvePlace; 2] {
    let value = |piece: usize, s: f64| {
        let found = curve.sample(0, piece, s, 0.0);
        CurvePlace { piece, parameter: s, point: found.point, value: found.curvature.unwrap_or(0.0) }
    };
    let [mut least, mut greatest] = [value(0, 0.0); 2];
    for piece in 0..curve.piece_count() {
        if bernstein::is_straight(curve.piece(piece)) {
            let middle = CurvePlace { value: 0.0, ..value(piece, 0.5) };
            least = if middle.value < least.value { middle } else { least };
            greatest = if middle.value > greatest.value { middle } else { greatest };
            continue;
        }
        let places: Vec<CurvePlace> =
            (0..=PLACES).map(|at| value(piece, at as f64 / PLACES as f64)).collect();
        for at in 0..=PLACES {
            let around = [at.saturating_sub(1), (at + 1).min(PLACES)];
            for sign in [-1.0, 1.0] {
                let own = sign * places[at].value;
                if around.iter().any(|&other| sign * places[other].value > own) {
                    continue;
                }
                let found =
                    narrowed(places[at], around.map(|at| places[at].parameter), sign, |s| value(piece, s));
                if sign < 0.0 && found.value < least.value {
                    least = found;
                } else if sign > 0.0 && found.value > greatest.value {
                    greatest = found;
                }
            }
        }
    }
    [least, greatest]
}

/// The place of the greatest value near a place, by thirds of the way around it.
fn narrowed(
    known: CurvePlace,
    [mut low, mut high]: [f64; 2],
    sign: f64,
    value: impl Fn(f64) -> CurvePlace,
) -> CurvePlace {
    let mut best = known;
    for _ in 0..NARROWINGS {
        let third = (high - low) / 3.0;
        let [a, b] = [value(low + third), value(high - third)];
        for place in [a, b] {
            if sign * place.value > sign * best.value {
                best = place;
            }
        }
        if sign * a.value < sign * b.value {
            low += third;
        } else {
            high -= third;
        }
    }
    best
}
