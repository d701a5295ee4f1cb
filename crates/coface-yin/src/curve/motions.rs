//! Curves that are moved and scaled.

use super::Curve;
use coface_geometry::{AffineMap, Angle};

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

    /// The image under an affine map of the plane. Where it is a similarity, parameters are scaled with lengths.
    pub(crate) fn mapped(&self, map: &AffineMap) -> Curve<'static> {
        let &[a, b, c, d] = map.matrix() else { unreachable!("the map is of the plane") };
        let &[x, y] = map.offset() else { unreachable!("the map is of the plane") };
        let is_similarity = a.abs() == d.abs() && b.abs() == c.abs() && a * c + b * d == 0.0;
        let stretch = if is_similarity { a.hypot(c) } else { 1.0 };
        self.moved(stretch, |point| [a * point[0] + b * point[1] + x, c * point[0] + d * point[1] + y])
    }
}
