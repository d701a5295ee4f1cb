//! Points along a boundary, with directions and curvatures.

use super::YinSet;
use crate::Curve;
use crate::curve::{bernstein, length_between};
use coface_algebra::Error;

/// The part of a curve's length that lengths along it are known to.
const PRECISION: f64 = 1e-14;

/// Samples of a boundary are so many at most.
const MOST: usize = 1 << 27;

/// Where a boundary is sampled.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Sampling {
    /// At so many equally spaced parameters of each piece, its beginning the first.
    PerPiece(usize),
    /// At so many points of each curve, at equal distances along it, its beginning the first.
    PerCurve(usize),
    /// At equal distances along each curve, the greatest that are not above this length and fit into the curve a whole number of times.
    Spacing(f64),
}

/// A point of a boundary.
///
/// # Examples
/// ```
/// use coface_yin::{Curve, Sampling, YinSet};
/// let square = YinSet::new(&[Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?])?;
/// let found = square.samples(Sampling::PerCurve(8))?;
/// assert_eq!((found[3].point, found[3].length, found[3].tangent), ([2.0, 1.0], 3.0, Some([0.0, 1.0])));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Sample {
    /// The curve.
    pub curve: usize,
    /// The piece of the curve.
    pub piece: usize,
    /// The parameter in [0, 1) on that piece.
    pub parameter: f64,
    /// The length of the curve from its beginning to the point.
    pub length: f64,
    /// The point.
    pub point: [f64; 2],
    /// The direction of the curve, of length one; the set is on its left. None where the curve stands still.
    pub tangent: Option<[f64; 2]>,
    /// The signed curvature, positive where the curve turns left; none where the curve stands still.
    pub curvature: Option<f64>,
}

impl Curve<'_> {
    /// What is known of a place on a piece.
    pub(crate) fn sample(&self, curve: usize, piece: usize, parameter: f64, length: f64) -> Sample {
        let [first, second] = [1, 2].map(|degree| self.derivative_at(piece, parameter, degree));
        let speed = first[0].hypot(first[1]);
        let [x, y] = first.map(|v| v / speed);
        let curvature = (x * second[1] - y * second[0]) / speed / speed;
        Sample {
            curve,
            piece,
            parameter,
            length,
            point: bernstein::value(self.piece(piece), parameter),
            tangent: (speed > 0.0).then_some([x, y]),
            curvature: (speed > 0.0 && curvature.is_finite()).then_some(curvature),
        }
    }

    /// The lengths of the curve from its beginning to each knot.
    fn lengths_at_knots(&self, tolerance: f64) -> Vec<f64> {
        let mut lengths = vec![0.0];
        let mut sum = coface_geometry::Sum::default();
        for piece in 0..self.piece_count() {
            sum.add(length_between(self.piece(piece), [0.0, 1.0], tolerance));
            lengths.push(sum.value());
        }
        lengths
    }

    /// The parameter on a piece up to which it has this length, by Newton's iteration between bounds that halve.
    fn parameter_at_length(&self, piece: usize, length: f64, whole: f64, tolerance: f64) -> f64 {
        let controls = self.piece(piece);
        let mut s = if whole > 0.0 { (length / whole).clamp(0.0, 1.0) } else { 0.0 };
        if bernstein::is_straight(controls) {
            return s;
        }
        let velocity = bernstein::derivative(controls);
        let [mut low, mut high] = [0.0, 1.0];
        for _ in 0..64 {
            let miss = length_between(controls, [0.0, s], tolerance) - length;
            if miss.abs() <= tolerance {
                break;
            }
            if miss > 0.0 {
                high = s;
            } else {
                low = s;
            }
            let [x, y] = bernstein::value(&velocity, s);
            let step = s - miss / x.hypot(y);
            let next = if low < step && step < high { step } else { 0.5 * (low + high) };
            if (next - s).abs() <= f64::EPSILON || next <= low || next >= high {
                break;
            }
            s = next;
        }
        s
    }
}

impl YinSet {
    /// Points along the boundary, curve by curve, with lengths, directions and curvatures. At a knot direction and curvature are those of
    /// the piece that begins there.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for no points, for a distance that is not positive, and for more
    /// than 2^27 points.
    ///
    /// # Complexity
    /// Linear in the pieces and points.
    ///
    /// # Examples
    /// The points of a circle at equal distances.
    /// ```
    /// use coface_yin::{Curve, Order, Sampling, YinSet};
    /// let disk = YinSet::new(&[Curve::circle([0.0, 0.0], 2.0, 100, Order::CUBIC)?])?;
    /// let found = disk.samples(Sampling::Spacing(0.1))?;
    /// assert_eq!(found.len(), 126);
    /// assert!(found.iter().all(|sample| (sample.curvature.expect("it moves") - 0.5).abs() < 1e-3));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn samples(&self, sampling: Sampling) -> Result<Vec<Sample>, Error> {
        samples_along((0..self.curve_count()).map(|number| self.curve(number)), sampling)
    }
}

/// Points along curves, one curve after the other; of a curve that is not closed its end too.
pub(crate) fn samples_along<'a>(
    curves: impl Iterator<Item = Curve<'a>>,
    sampling: Sampling,
) -> Result<Vec<Sample>, Error> {
    match sampling {
        Sampling::PerPiece(0) | Sampling::PerCurve(0) => {
            return Err(Error::invalid("no points are asked for").with_cure("ask for one or more"));
        }
        Sampling::Spacing(spacing) if !(spacing > 0.0 && spacing.is_finite()) => {
            return Err(Error::invalid(format!("points cannot be {spacing} apart"))
                .with_cure("give a positive length"));
        }
        _ => {}
    }
    let mut samples = Vec::new();
    for (number, curve) in curves.enumerate() {
        let [low, high] = curve.bounding_box();
        let extent = (high[0] - low[0]).max(high[1] - low[1]);
        let tolerance = PRECISION * extent;
        let lengths = curve.lengths_at_knots(tolerance);
        let whole = lengths[lengths.len() - 1];
        let count = match sampling {
            Sampling::PerPiece(count) => count.saturating_mul(curve.piece_count()),
            Sampling::PerCurve(count) => count,
            // A curve that is a whole number of distances long but for rounding is not given one more.
            Sampling::Spacing(spacing) => {
                let parts = whole / spacing;
                (if (parts - parts.round()).abs() <= 1e-12 * parts { parts.round() } else { parts.ceil() })
                    .max(1.0) as usize
            }
        };
        if samples.len().saturating_add(count) > MOST {
            return Err(Error::invalid("these are more than 2^27 points")
                .with_cure("ask for fewer, or for a greater distance"));
        }
        if let Sampling::PerPiece(count) = sampling {
            for (piece, &before) in lengths.iter().enumerate().take(curve.piece_count()) {
                for at in 0..count {
                    let s = at as f64 / count as f64;
                    let length = before + length_between(curve.piece(piece), [0.0, s], tolerance);
                    samples.push(curve.sample(number, piece, s, length));
                }
            }
        } else {
            for at in 0..count {
                let length = whole * (at as f64 / count as f64);
                let piece = lengths[1..curve.piece_count()].partition_point(|&to| to <= length);
                let own = lengths[piece + 1] - lengths[piece];
                let s = curve.parameter_at_length(piece, length - lengths[piece], own, tolerance);
                samples.push(curve.sample(number, piece, s, length));
            }
        }
        let last = curve.piece_count() - 1;
        if curve.knot_point(0) != curve.knot_point(last + 1) {
            samples.push(curve.sample(number, last, 1.0, whole));
        }
    }
    Ok(samples)
}
