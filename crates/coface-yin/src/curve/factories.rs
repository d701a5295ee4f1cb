//! Circles, ellipses and rectangles.

use super::{Curve, EndCondition, Order};
use coface_algebra::Error;
use coface_geometry::Angle;

impl Curve<'static> {
    /// The periodic spline through points of a circle, equally spaced, counterclockwise from angle zero.
    ///
    /// Cubic splines through n points of the unit circle leave it by $(\pi^4 / 24) n^{-4}$ and enclose an area that is off by
    /// $(2 \pi^5 / 45) n^{-4}$ for large n.
    ///
    /// # Errors
    /// As [`Curve::fit`]; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for less than three pieces and a radius that is not positive.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Order};
    /// let circle = Curve::circle([1.0, 0.0], 2.0, 64, Order::CUBIC)?;
    /// assert_eq!(circle.knot_point(16), [1.0, 2.0]);
    /// assert!((circle.signed_area() - 4.0 * std::f64::consts::PI).abs() < 4e-6);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn circle(center: [f64; 2], radius: f64, piece_count: usize, order: Order) -> Result<Self, Error> {
        Self::ellipse(center, [radius; 2], piece_count, order)
    }

    /// The periodic spline through points of an ellipse with axes parallel to those of coordinates, at equally spaced angles t of
    /// $(a \cos t, b \sin t)$, counterclockwise from angle zero.
    ///
    /// # Errors
    /// As [`Self::circle`].
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Order};
    /// let diamond = Curve::ellipse([0.0, 0.0], [2.0, 1.0], 4, Order::LINEAR)?;
    /// assert_eq!(diamond.signed_area(), 4.0);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn ellipse(
        center: [f64; 2],
        axes: [f64; 2],
        piece_count: usize,
        order: Order,
    ) -> Result<Self, Error> {
        if axes.iter().any(|&axis| axis.is_nan() || axis <= 0.0) {
            return Err(Error::invalid(format!(
                "there are no ellipses with half axes {} and {}",
                axes[0], axes[1]
            ))
            .with_cure("give positive lengths"));
        }
        let denominator = u32::try_from(piece_count).ok().filter(|&count| count >= 3).ok_or_else(|| {
            Error::invalid(format!("{piece_count} pieces make no ellipse"))
                .with_cure("give three pieces or more")
        })?;
        let points: Vec<[f64; 2]> = (0..=piece_count)
            .map(|i| {
                let (cosine, sine) = Angle::turns((i % piece_count) as i64, denominator).cosine_and_sine();
                [center[0] + axes[0] * cosine, center[1] + axes[1] * sine]
            })
            .collect();
        Self::fit(&points, order, &EndCondition::Periodic)
    }

    /// A rectangle, counterclockwise from its lower left corner, turned by an angle around the origin, with so many straight pieces on
    /// its lower and upper and on its other sides. Knots 0, u, u + v and 2u + v are its corners, for counts u and v.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) unless the upper corner is above and to the right of the lower one and there are
    /// pieces on each side.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::Angle;
    /// use coface_yin::{Curve, Order};
    /// let curve = Curve::rectangle([[0.0, 0.0], [3.0, 1.0]], Angle::ZERO, [3, 1], Order::CUBIC)?;
    /// assert_eq!(curve.piece_count(), 8);
    /// assert_eq!((curve.signed_area(), curve.knot_point(4)), (3.0, [3.0, 1.0]));
    /// assert_eq!(curve.derivative(0.3, 2), [0.0, 0.0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn rectangle(
        [lower, upper]: [[f64; 2]; 2],
        angle: Angle,
        piece_counts: [usize; 2],
        order: Order,
    ) -> Result<Self, Error> {
        if !(lower[0] < upper[0] && lower[1] < upper[1]) || piece_counts.contains(&0) {
            return Err(Error::invalid("a rectangle is empty or has a side without pieces")
                .with_cure("give the lower left and the upper right corner, and counts of one or more"));
        }
        let corners = [lower, [upper[0], lower[1]], upper, [lower[0], upper[1]]];
        let mut points = Vec::with_capacity(2 * (piece_counts[0] + piece_counts[1]) + 1);
        for side in 0..4 {
            let [a, b] = [corners[side], corners[(side + 1) % 4]];
            let count = piece_counts[side % 2];
            points.extend((0..count).map(|i| {
                let s = i as f64 / count as f64;
                [0, 1]
                    .map(|axis| if a[axis] == b[axis] { a[axis] } else { a[axis] + s * (b[axis] - a[axis]) })
            }));
        }
        points.push(lower);
        let (cosine, sine) = angle.cosine_and_sine();
        let turned: Vec<[f64; 2]> =
            points.iter().map(|[x, y]| [cosine * x - sine * y, sine * x + cosine * y]).collect();
        Self::polyline(&turned)?.raised(order)
    }
}
