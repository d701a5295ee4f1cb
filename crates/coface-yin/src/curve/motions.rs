//! Curves that are moved and scaled.

use super::Curve;
use coface_geometry::Angle;

impl Curve<'_> {
    /// The curve moved by a vector.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Curve;
    /// let curve = Curve::polyline(&[[0.0, 0.0], [1.0, 0.0]])?.translated([2.0, 3.0]);
    /// assert_eq!(curve.controls(), [[2.0, 3.0], [3.0, 3.0]]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn translated(&self, [x, y]: [f64; 2]) -> Curve<'static> {
        self.moved(1.0, |point| [point[0] + x, point[1] + y])
    }

    /// The curve turned counterclockwise around a center; exact for multiples of a quarter turn around the origin.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::Angle;
    /// use coface_yin::Curve;
    /// let curve = Curve::polyline(&[[1.0, 0.0], [2.0, 0.0]])?.rotated(Angle::turns(1, 4), [0.0, 0.0]);
    /// assert_eq!(curve.controls(), [[0.0, 1.0], [0.0, 2.0]]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn rotated(&self, angle: Angle, center: [f64; 2]) -> Curve<'static> {
        let (cosine, sine) = angle.cosine_and_sine();
        self.moved(1.0, |point| {
            let [x, y] = [point[0] - center[0], point[1] - center[1]];
            [center[0] + (cosine * x - sine * y), center[1] + (sine * x + cosine * y)]
        })
    }

    /// The curve scaled by a factor from a center; a negative factor turns it by half a turn. Its parameters are scaled too.
    ///
    /// # Panics
    /// If the factor is zero or not finite.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Curve;
    /// let curve = Curve::polyline(&[[0.0, 0.0], [1.0, 0.0]])?.scaled(2.0, [1.0, 1.0]);
    /// assert_eq!(curve.controls(), [[-1.0, -1.0], [1.0, -1.0]]);
    /// assert_eq!(curve.knots(), [0.0, 2.0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn scaled(&self, factor: f64, center: [f64; 2]) -> Curve<'static> {
        assert!(factor != 0.0 && factor.is_finite(), "a curve cannot be scaled by {factor}");
        self.moved(factor.abs(), |point| {
            [0, 1].map(|axis| center[axis] + factor * (point[axis] - center[axis]))
        })
    }
}
