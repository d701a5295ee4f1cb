//! The numbers that coordinates are rounded to.

/// The floating-point numbers that rounded coordinates are.
///
/// # Examples
/// ```
/// use coface_arrange::CoordinatePrecision;
/// let third = CoordinatePrecision::Single.rounded(1.0 / 3.0);
/// assert!(CoordinatePrecision::Single.holds(third) && !CoordinatePrecision::Single.holds(1.0 / 3.0));
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum CoordinatePrecision {
    /// 64 bits, of which 53 are of the digits.
    #[default]
    Double,
    /// 32 bits, of which 24 are of the digits: what an STL file holds.
    Single,
}

impl CoordinatePrecision {
    /// The nearest of the numbers; the same number where none is near, since it is too large.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::CoordinatePrecision;
    /// assert_eq!(CoordinatePrecision::Single.rounded(16_777_217.0), 16_777_216.0);
    /// assert_eq!(CoordinatePrecision::Double.rounded(16_777_217.0), 16_777_217.0);
    /// ```
    pub fn rounded(self, coordinate: f64) -> f64 {
        let single = coordinate as f32;
        if self == Self::Double || !single.is_finite() { coordinate } else { f64::from(single) }
    }

    /// Whether this is one of the numbers.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::CoordinatePrecision;
    /// assert!(CoordinatePrecision::Single.holds(0.5) && !CoordinatePrecision::Single.holds(0.1));
    /// ```
    pub fn holds(self, coordinate: f64) -> bool {
        self == Self::Double || f64::from(coordinate as f32) == coordinate
    }

    /// The distance from 1 to the next number.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_arrange::CoordinatePrecision::Double.unit(), f64::EPSILON);
    /// ```
    pub fn unit(self) -> f64 {
        match self {
            Self::Double => f64::EPSILON,
            Self::Single => f64::from(f32::EPSILON),
        }
    }

    pub(crate) fn rounded_point(self, point: [f64; 3]) -> [f64; 3] {
        point.map(|x| self.rounded(x))
    }
}
