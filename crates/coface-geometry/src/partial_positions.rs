//! Points of which some have a coordinate that is not finite.

use coface_algebra::{Error, ErrorKind, VertexId};

/// The positions of vertices of which some are not known: files write NaN or an infinite number for their coordinates.
/// [`Positions`](crate::Positions) has no such points, so nothing computes with them by mistake.
///
/// Two of them are equal when their coordinates are; NaN is equal to NaN.
///
/// # Examples
/// ```
/// use coface_algebra::VertexId;
/// use coface_geometry::PartialPositions;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let partial = PartialPositions::from_flat(2, vec![0.0, 0.0, f64::NAN, 4.0])?;
/// assert_eq!(partial.unplaced(), [VertexId::new(1)]);
/// assert_eq!(partial.point(VertexId::new(0)), Some(&[0.0, 0.0][..]));
/// assert_eq!(partial.point(VertexId::new(1)), None);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct PartialPositions {
    dimension: usize,
    coordinates: Vec<f64>,
    /// The vertices with a coordinate that is not finite, rising.
    unplaced: Vec<VertexId>,
}

impl PartialPositions {
    /// Points of `dimension` coordinates each, one after the other; the coordinates need not be finite.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] if the coordinates cannot be cut into points; [`ErrorKind::TooLarge`] beyond 2^32 - 1 points.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::PartialPositions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(PartialPositions::from_flat(3, vec![f64::INFINITY; 12])?.len(), 4);
    /// assert!(PartialPositions::from_flat(3, vec![0.0; 4]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn from_flat(dimension: usize, coordinates: Vec<f64>) -> Result<Self, Error> {
        if dimension == 0 || !coordinates.len().is_multiple_of(dimension) {
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "{} coordinates cannot be cut into points of dimension {dimension}",
                    coordinates.len()
                ),
            ));
        }
        if u32::try_from(coordinates.len() / dimension).is_err() {
            return Err(Error::new(ErrorKind::TooLarge, "more than 2^32 - 1 points"));
        }
        let points = coordinates.chunks_exact(dimension).enumerate();
        let unplaced = points.filter(|(_, point)| !point.iter().all(|x| x.is_finite()));
        let unplaced = unplaced.map(|(vertex, _)| VertexId::new(vertex)).collect();
        Ok(Self { dimension, coordinates, unplaced })
    }

    /// The number of coordinates of a point.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(coface_geometry::PartialPositions::from_flat(2, vec![f64::NAN; 6])?.dimension(), 2);
    /// # Ok(()) }
    /// ```
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The number of points, those that are not known included.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(coface_geometry::PartialPositions::from_flat(2, vec![f64::NAN; 6])?.len(), 3);
    /// # Ok(()) }
    /// ```
    pub fn len(&self) -> usize {
        self.coordinates.len() / self.dimension
    }

    /// Whether there is no point.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert!(!coface_geometry::PartialPositions::from_flat(2, vec![f64::NAN; 6])?.is_empty());
    /// # Ok(()) }
    /// ```
    pub fn is_empty(&self) -> bool {
        self.coordinates.is_empty()
    }

    /// The vertices with a coordinate that is not finite, rising.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let partial = coface_geometry::PartialPositions::from_flat(1, vec![1.0, f64::INFINITY, f64::NAN])?;
    /// assert_eq!(format!("{:?}", partial.unplaced()), "[v1, v2]");
    /// # Ok(()) }
    /// ```
    pub fn unplaced(&self) -> &[VertexId] {
        &self.unplaced
    }

    /// The coordinates of one point; `None` if one of them is not finite.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let partial = coface_geometry::PartialPositions::from_flat(1, vec![1.0, f64::NAN])?;
    /// let point = |vertex| partial.point(VertexId::new(vertex));
    /// assert_eq!((point(0), point(1)), (Some(&[1.0][..]), None));
    /// # Ok(()) }
    /// ```
    pub fn point(&self, vertex: VertexId) -> Option<&[f64]> {
        let start = vertex.index() * self.dimension;
        let point = &self.coordinates[start..start + self.dimension];
        point.iter().all(|x| x.is_finite()).then_some(point)
    }

    /// All coordinates as they were given, point after point.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let partial = coface_geometry::PartialPositions::from_flat(1, vec![1.0, f64::INFINITY])?;
    /// assert_eq!(partial.as_flat(), [1.0, f64::INFINITY]);
    /// # Ok(()) }
    /// ```
    pub fn as_flat(&self) -> &[f64] {
        &self.coordinates
    }

    /// What is wrong for whoever needs all positions: the first coordinate that is not finite. `None` if there is none.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let partial = coface_geometry::PartialPositions::from_flat(2, vec![1.0, 2.0, 3.0, f64::NAN])?;
    /// assert_eq!(partial.fault().unwrap().message(), "coordinate 1 of v1 is NaN, not a finite number");
    /// # Ok(()) }
    /// ```
    pub fn fault(&self) -> Option<Error> {
        let at = self.coordinates.iter().position(|x| !x.is_finite())?;
        Some(
            Error::invalid(format!(
                "coordinate {} of v{} is {}, not a finite number",
                at % self.dimension,
                at / self.dimension,
                self.coordinates[at]
            ))
            .with_cure("remove the point or give it finite coordinates"),
        )
    }
}

impl PartialEq for PartialPositions {
    fn eq(&self, other: &Self) -> bool {
        let equal = |(a, b): (&f64, &f64)| a == b || (a.is_nan() && b.is_nan());
        self.dimension == other.dimension
            && self.coordinates.len() == other.coordinates.len()
            && self.coordinates.iter().zip(&other.coordinates).all(equal)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Positions;

    #[test]
    fn what_positions_refuse_partial_positions_name() {
        let flat = vec![0.0, 1.0, f64::NEG_INFINITY, 2.0, 3.0, f64::NAN, f64::NAN, f64::NAN];
        let refused = Positions::from_flat(2, flat.clone()).unwrap_err();
        let partial = PartialPositions::from_flat(2, flat).unwrap();
        assert_eq!(partial.fault().unwrap(), refused);
        assert_eq!(partial.unplaced().iter().map(|v| v.index()).collect::<Vec<_>>(), [1, 2, 3]);
        assert!(PartialPositions::from_flat(1, vec![0.0]).unwrap().fault().is_none());
        assert!(PartialPositions::from_flat(0, vec![]).is_err());
    }

    #[test]
    fn unknown_coordinates_are_equal_and_others_are_not() {
        let of = |x: f64| PartialPositions::from_flat(1, vec![0.0, x]).unwrap();
        assert_eq!(of(f64::NAN), of(-f64::NAN));
        assert_ne!(of(f64::NAN), of(f64::INFINITY));
        assert_ne!(of(f64::NEG_INFINITY), of(f64::INFINITY));
    }
}
