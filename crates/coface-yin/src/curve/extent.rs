//! Turning points and bounding boxes.

use super::Curve;
use super::bernstein;
use super::roots::sign_changes;

/// The parameters in (0, 1) at which a coordinate of a piece turns from rising to falling or back, rising.
fn turning_parameters(controls: &[[f64; 2]], axis: usize) -> Vec<f64> {
    // Control points that do not turn are those of a piece that does not.
    let turns = |pair: &[[f64; 2]]| pair[1][axis] - pair[0][axis];
    if controls.windows(2).all(|pair| turns(pair) >= 0.0)
        || controls.windows(2).all(|pair| turns(pair) <= 0.0)
    {
        return Vec::new();
    }
    let derivative: Vec<f64> = bernstein::derivative(controls).iter().map(|vector| vector[axis]).collect();
    sign_changes(&derivative)
}

/// The parameters in (0, 1) between which both coordinates of a piece are monotone, rising.
pub(crate) fn monotone_breaks(controls: &[[f64; 2]]) -> Vec<f64> {
    let mut breaks = turning_parameters(controls, 0);
    breaks.append(&mut turning_parameters(controls, 1));
    breaks.sort_unstable_by(f64::total_cmp);
    breaks.dedup();
    breaks
}

impl Curve<'_> {
    /// Rising parameters, all knots among them, such that both coordinates are monotone from each to the next: between the knots
    /// there are those where a coordinate turns within a piece.
    ///
    /// # Complexity
    /// Linear in the pieces.
    ///
    /// # Examples
    /// The parabola $y = x (2 - x)$, its top at the middle.
    /// ```
    /// use coface_yin::{Curve, Order};
    /// let controls = [[0.0, 0.0], [2.0, 4.0], [4.0, 4.0], [6.0, 0.0]];
    /// let curve = Curve::from_controls(Order::CUBIC, controls.to_vec(), vec![0.0, 6.0])?;
    /// assert_eq!(curve.monotone_parameters(), [0.0, 3.0, 6.0]);
    /// assert_eq!(curve.bounding_box(), [[0.0, 0.0], [6.0, 3.0]]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn monotone_parameters(&self) -> Vec<f64> {
        let mut found = Vec::with_capacity(self.knots().len());
        for piece in 0..self.piece_count() {
            found.push(self.knots()[piece]);
            let breaks = monotone_breaks(self.piece(piece));
            found.extend(breaks.into_iter().map(|s| self.parameter(piece, s)));
        }
        found.push(self.range()[1]);
        found.dedup();
        found
    }

    /// The least and the greatest coordinates of the points of the curve.
    ///
    /// # Complexity
    /// Linear in the pieces.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Curve;
    /// let square = Curve::polyline(&[[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.0, 0.0]])?;
    /// assert_eq!(square.bounding_box(), [[0.0, 0.0], [2.0, 2.0]]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn bounding_box(&self) -> [[f64; 2]; 2] {
        let degree = self.order().degree();
        let knot_points: Vec<[f64; 2]> = self.controls().iter().step_by(degree).copied().collect();
        let mut found = bernstein::control_box(&knot_points);
        for piece in 0..self.piece_count() {
            let controls = self.piece(piece);
            let hull = bernstein::control_box(controls);
            for axis in 0..2 {
                // Only pieces that may leave the box so far.
                if hull[0][axis] < found[0][axis] || hull[1][axis] > found[1][axis] {
                    for s in turning_parameters(controls, axis) {
                        let x = bernstein::value(controls, s)[axis];
                        found[0][axis] = found[0][axis].min(x);
                        found[1][axis] = found[1][axis].max(x);
                    }
                }
            }
        }
        found
    }
}
