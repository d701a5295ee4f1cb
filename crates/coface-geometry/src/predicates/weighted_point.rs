//! Points with weights: spheres whose squared radius may be negative.

/// A point of space with a weight, which is the squared radius of a sphere around it. Weights may be negative. The third coordinate of points of the plane is 0.
///
/// The **power** of two weighted points is $|p - q|^2 - w_p - w_q$; they are **orthogonal** if it is 0.
///
/// # Examples
/// ```
/// use coface_geometry::predicates::WeightedPoint;
/// let ball = WeightedPoint::new([1.0, 0.0, 0.0], 4.0);
/// assert_eq!((ball.point(), ball.weight()), ([1.0, 0.0, 0.0], 4.0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeightedPoint {
    pub(super) point: [f64; 3],
    pub(super) weight: f64,
}

impl WeightedPoint {
    /// The point with this weight. All numbers are finite.
    ///
    /// # Examples
    /// See [`WeightedPoint`].
    pub fn new(point: [f64; 3], weight: f64) -> Self {
        Self { point, weight }
    }

    /// The point alone.
    ///
    /// # Examples
    /// See [`WeightedPoint`].
    pub fn point(&self) -> [f64; 3] {
        self.point
    }

    /// The weight alone.
    ///
    /// # Examples
    /// See [`WeightedPoint`].
    pub fn weight(&self) -> f64 {
        self.weight
    }
}
