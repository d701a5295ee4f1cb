//! Splines of high order through points at uneven distances.

use super::bernstein;
use super::{Curve, EndCondition, Order, distance, gauss_legendre};
use coface_algebra::Error;

impl Curve<'static> {
    /// The spline of an order through points, with its own length as parameter, as nearly as its order asks for.
    ///
    /// The cumulated distance of points, the parameter of [`Self::fit`], is off the length of a smooth curve by a part of the square of the
    /// distance, and unevenly so where distances are uneven: splines of any order are then within the fourth power of the distance only.
    /// With the lengths of the pieces of that spline as parameters instead they are within the sixth, with lengths of the
    /// next one within the eighth. So this is [`Self::fit`] in orders 2 and 4; in order 6 the curve is fitted once more, in order 8 twice.
    ///
    /// # Errors
    /// As [`Self::fit`].
    ///
    /// # Complexity
    /// Linear in the points.
    ///
    /// # References
    /// M. S. Floater, T. Surazhsky, *Parameterization for curve interpolation* (2006).
    ///
    /// # Examples
    /// Points of the unit circle, every other distance twice as long.
    /// ```
    /// use coface_yin::{Curve, EndCondition, Order};
    /// let angle = |i: i32| f64::from(3 * i / 2) * std::f64::consts::TAU / 96.0;
    /// let points: Vec<[f64; 2]> = (0..=64).map(|i| angle(i % 64)).map(|t| [t.cos(), t.sin()]).collect();
    /// let order = Order::new(8)?;
    /// let miss = |curve: Curve<'_>| (curve.signed_area() - std::f64::consts::PI).abs();
    /// let by_length = miss(Curve::fit_by_length(&points, order, &EndCondition::Periodic)?);
    /// let by_chords = miss(Curve::fit(&points, order, &EndCondition::Periodic)?);
    /// assert!(by_length < 1e-9 && by_chords > 1e-6);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn fit_by_length(points: &[[f64; 2]], order: Order, ends: &EndCondition) -> Result<Self, Error> {
        let mut spline = Self::fit(points, order, ends)?;
        for _ in 4..=order.value() / 2 + 1 {
            let Some(knots) = spline.lengths_to_knots() else { break };
            spline = Self::fit_to(points, knots, order, ends)?;
        }
        Ok(spline)
    }

    /// The length of the curve up to each knot, by quadrature with eight nodes a piece; none if it does not rise.
    fn lengths_to_knots(&self) -> Option<Vec<f64>> {
        let rule = gauss_legendre();
        let mut knots = Vec::with_capacity(self.piece_count() + 1);
        let mut length = 0.0;
        knots.push(length);
        for piece in 0..self.piece_count() {
            let controls = self.piece(piece);
            let own = if bernstein::is_straight(controls) {
                distance(controls[0], controls[controls.len() - 1])
            } else {
                let velocity = bernstein::derivative(controls);
                let speed = |node: f64| distance([0.0; 2], bernstein::value(&velocity, 0.5 + 0.5 * node));
                0.5 * rule.iter().map(|&[node, weight]| weight * speed(node)).sum::<f64>()
            };
            let next = length + own;
            // Also for what is not a number.
            if !(next > length && next.is_finite()) {
                return None;
            }
            length = next;
            knots.push(length);
        }
        Some(knots)
    }
}
