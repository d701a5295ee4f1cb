//! Coordinates in which everything has size one.

use coface_algebra::Error;

/// The largest exponent that a scale may have, so that it and its inverse are ordinary numbers.
const LARGEST_EXPONENT: i32 = 1000;

/// A translation and a scaling by a power of two that bring everything into the square between -1/2 and 1/2 (a little more where
/// the center is rounded).
///
/// Scaling is exact, and the translation of a number makes an error of at most 2^-53 of its result: so a change of scale by powers of
/// two changes nothing, and neither does a translation that does not round.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Frame {
    /// The center, scaled.
    center: [f64; 2],
    factor: f64,
    /// The resolution in coordinates of the frame.
    pub(super) resolution: f64,
    /// Distances in coordinates of the frame that are well above what rounding does to results.
    pub(super) finest: f64,
    /// Whether the resolution is finer than the usual one: then exact arithmetic tells cubic pieces apart that run side by side.
    pub(super) is_fine: bool,
    /// What rounding of points makes in coordinates of the frame, and a little more.
    pub(super) rounding: f64,
}

/// What is nearer than this is not told apart: so many times 2^-40 of the largest extent, and at least as many times 2^-48 of the
/// largest coordinate, and once that if it is less: that is above what rounding does to control points of parts of pieces.
pub(crate) fn resolution(extent: [f64; 2], largest: f64, coarseness: f64) -> f64 {
    let [of_extent, of_coordinates] = [40, 48].map(|bits| 1.0 / (1u64 << bits) as f64);
    (coarseness * extent[0].max(extent[1]) * of_extent).max(coarseness.max(1.0) * largest * of_coordinates)
}

impl Frame {
    /// The frame of points, with so many times the usual resolution.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) naming a point that is not finite.
    pub(super) fn of_points<'a>(
        points: impl Iterator<Item = &'a [f64; 2]>,
        coarseness: f64,
    ) -> Result<Self, Error> {
        let [mut low, mut high] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        for (at, point) in points.enumerate() {
            if !point.iter().all(|x| x.is_finite()) {
                return Err(Error::invalid(format!("control point {at} is not finite")));
            }
            for axis in 0..2 {
                low[axis] = low[axis].min(point[axis]);
                high[axis] = high[axis].max(point[axis]);
            }
        }
        if low[0] > high[0] {
            [low, high] = [[0.0; 2]; 2];
        }
        let half = [0, 1].map(|axis| high[axis] / 2.0 - low[axis] / 2.0);
        let largest = half[0].max(half[1]);
        // The least power of two that is at least the extent.
        let exponent = if largest > 0.0 { largest.log2().ceil() as i32 + 1 } else { 0 };
        let factor = 2f64.powi(-exponent.clamp(-LARGEST_EXPONENT, LARGEST_EXPONENT));
        let center = [0, 1].map(|axis| low[axis] * factor / 2.0 + high[axis] * factor / 2.0);
        let extent = if largest > 0.0 { 2.0 * largest * factor } else { 1.0 };
        let farthest = low.iter().chain(&high).fold(0.0, |farthest: f64, x| farthest.max(x.abs()));
        let resolution = resolution([extent; 2], farthest * factor, coarseness);
        let finest = (resolution / 32.0).max(farthest * factor / (1u64 << 46) as f64);
        let rounding = farthest * factor * 4.0 * f64::EPSILON;
        Ok(Self { center, factor, resolution, finest, is_fine: coarseness < 1.0, rounding })
    }

    /// A point in this frame.
    pub(super) fn to_local(self, point: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| point[axis] * self.factor - self.center[axis])
    }

    /// A length of the frame in the unit of the input.
    pub(super) fn world_length(self, length: f64) -> f64 {
        length / self.factor
    }

    /// A point of this frame in coordinates of the input.
    pub(super) fn to_world(self, point: [f64; 2]) -> [f64; 2] {
        [0, 1].map(|axis| (point[axis] + self.center[axis]) / self.factor)
    }
}
