//! Points, derivatives, directions and curvature along a curve.

use super::bernstein::{self, Piece};
use super::{Curve, distance};

impl Curve<'_> {
    /// The piece to which a parameter belongs, and the parameter on it, in [0, 1] within the knots. A knot belongs to the piece that
    /// begins there, the last one to the last piece; beyond the ends the first and the last piece go on.
    pub(crate) fn place(&self, parameter: f64) -> (usize, f64) {
        let knots = self.knots();
        let piece = knots[1..knots.len() - 1].partition_point(|&knot| knot <= parameter);
        (piece, (parameter - knots[piece]) / self.piece_length(piece))
    }

    /// The length of a piece in the parameter.
    pub(crate) fn piece_length(&self, piece: usize) -> f64 {
        self.knots()[piece + 1] - self.knots()[piece]
    }

    /// The parameter of a place on a piece: the knots at 0 and 1.
    pub(crate) fn parameter(&self, piece: usize, s: f64) -> f64 {
        if s == 1.0 { self.knots()[piece + 1] } else { self.knots()[piece] + s * self.piece_length(piece) }
    }

    /// The point at a parameter; at a knot its point, bit for bit. Beyond the knots the first and the last polynomial go on.
    ///
    /// # Complexity
    /// Logarithmic in the pieces, quadratic in the order.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Curve;
    /// let curve = Curve::polyline(&[[0.0, 0.0], [1.0, 0.0], [1.0, 1.0]])?;
    /// assert_eq!(curve.point(1.5), [1.0, 0.5]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn point(&self, parameter: f64) -> [f64; 2] {
        let (piece, s) = self.place(parameter);
        bernstein::value(self.piece(piece), s)
    }

    /// The derivative of a degree by the parameter; at a knot that of the piece that begins there.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Curve;
    /// let curve = Curve::polyline(&[[0.0, 0.0], [3.0, 4.0]])?;
    /// assert_eq!(curve.derivative(1.0, 1), [0.6, 0.8]);
    /// assert_eq!(curve.derivative(1.0, 2), [0.0, 0.0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn derivative(&self, parameter: f64, degree: usize) -> [f64; 2] {
        let (piece, s) = self.place(parameter);
        self.derivative_at(piece, s, degree)
    }

    /// The derivative of a degree by the parameter, at a place on a piece.
    pub(crate) fn derivative_at(&self, piece: usize, s: f64, degree: usize) -> [f64; 2] {
        if degree > self.order().degree() {
            return [0.0; 2];
        }
        let mut vectors = Piece::new(self.piece(piece));
        for _ in 0..degree {
            vectors = bernstein::derivative(&vectors);
        }
        let length = self.piece_length(piece);
        bernstein::value(&vectors, s).map(|x| (0..degree).fold(x, |x, _| x / length))
    }

    /// Whether the velocity is the same on both sides of each knot that is no kink, but for rounding.
    pub(crate) fn has_smooth_parameter(&self, is_kink: impl Fn(usize) -> bool) -> bool {
        let count = self.piece_count();
        (usize::from(!self.is_closed())..count).filter(|&knot| !is_kink(knot)).all(|knot| {
            let before = if knot == 0 { count - 1 } else { knot - 1 };
            is_one_velocity(self.derivative_at(before, 1.0, 1), self.derivative_at(knot, 0.0, 1))
        })
    }

    /// The direction in which the curve goes, of length one; `None` where the derivative is zero.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::Curve;
    /// let curve = Curve::polyline(&[[0.0, 0.0], [0.0, 2.0]])?;
    /// assert_eq!(curve.tangent(0.5), Some([0.0, 1.0]));
    /// assert_eq!(curve.normal(0.5), Some([-1.0, 0.0]));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn tangent(&self, parameter: f64) -> Option<[f64; 2]> {
        let [x, y] = self.derivative(parameter, 1);
        let length = x.hypot(y);
        (length > 0.0).then(|| [x / length, y / length])
    }

    /// The direction to the left of the curve, of length one: for the boundary of a Yin set the direction into the set. `None` where
    /// the derivative is zero.
    pub fn normal(&self, parameter: f64) -> Option<[f64; 2]> {
        self.tangent(parameter).map(|[x, y]| [-y, x])
    }

    /// The signed curvature $(x' y'' - y' x'') / |(x', y')|^3$, positive where the curve turns left; `None` where the derivative is zero.
    ///
    /// # Examples
    /// ```
    /// use coface_yin::{Curve, Order};
    /// let circle = Curve::circle([0.0, 0.0], 2.0, 100, Order::CUBIC)?;
    /// assert!((circle.curvature(1.0).expect("circles are smooth") - 0.5).abs() < 1e-3);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn curvature(&self, parameter: f64) -> Option<f64> {
        let [first, second] = [1, 2].map(|degree| self.derivative(parameter, degree));
        let speed = first[0].hypot(first[1]);
        let [tx, ty] = first.map(|x| x / speed);
        (speed > 0.0).then(|| (tx * second[1] - ty * second[0]) / speed / speed)
    }
}

/// Whether two velocities are the same but for rounding.
pub(crate) fn is_one_velocity(a: [f64; 2], b: [f64; 2]) -> bool {
    const ROUNDING: f64 = 1e-3;
    distance(a, b) <= ROUNDING * distance([0.0; 2], a).max(distance([0.0; 2], b))
}
