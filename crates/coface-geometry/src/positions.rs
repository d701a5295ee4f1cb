//! Points with coordinates in one flat array.

use coface_algebra::{Error, ErrorKind, Fault, VertexId};

/// The positions of vertices: points of one dimension, flat.
///
/// # Examples
/// ```
/// use coface_geometry::Positions;
/// use coface_algebra::VertexId;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let positions = Positions::from_flat(2, vec![0.0, 0.0, 3.0, 4.0])?;
/// assert_eq!(positions.point(VertexId::new(1)), [3.0, 4.0]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Positions {
    dimension: usize,
    coordinates: Vec<f64>,
}

impl Positions {
    /// Points of `dimension` coordinates each, one after the other. Dimension 0 means that there are no positions.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] if the coordinates cannot be cut into points; [`ErrorKind::InvalidInput`] naming the first
    /// point with a coordinate that is not finite; [`ErrorKind::TooLarge`] beyond 2^32 - 1 points.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(Positions::from_flat(3, vec![0.0; 12])?.len(), 4);
    /// assert!(Positions::from_flat(3, vec![0.0; 4]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn from_flat(dimension: usize, coordinates: Vec<f64>) -> Result<Self, Error> {
        let fits =
            if dimension == 0 { coordinates.is_empty() } else { coordinates.len().is_multiple_of(dimension) };
        if !fits {
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "{} coordinates cannot be cut into points of dimension {dimension}",
                    coordinates.len()
                ),
            ));
        }
        if let Some(bad) = coordinates.iter().position(|x| !x.is_finite()) {
            return Err(Error::invalid(format!(
                "coordinate {} of v{} is {}, not a finite number",
                bad % dimension,
                bad / dimension,
                coordinates[bad]
            ))
            .with_cure("remove the point or give it finite coordinates"));
        }
        if dimension > 0 && u32::try_from(coordinates.len() / dimension).is_err() {
            return Err(Error::new(ErrorKind::TooLarge, "more than 2^32 - 1 points"));
        }
        Ok(Self { dimension, coordinates })
    }

    /// The number of coordinates of a point; 0 if there are no positions.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(coface_geometry::Positions::from_flat(2, vec![0.0; 6])?.dimension(), 2);
    /// # Ok(()) }
    /// ```
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// The number of points.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(coface_geometry::Positions::from_flat(2, vec![0.0; 6])?.len(), 3);
    /// # Ok(()) }
    /// ```
    pub fn len(&self) -> usize {
        self.coordinates.len().checked_div(self.dimension).unwrap_or(0)
    }

    /// Whether there is no point.
    ///
    /// # Examples
    /// ```
    /// assert!(coface_geometry::Positions::default().is_empty());
    /// ```
    pub fn is_empty(&self) -> bool {
        self.coordinates.is_empty()
    }

    /// The coordinates of one point.
    ///
    /// # Panics
    /// If there is no such point.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let positions = Positions::from_flat(2, vec![0.0, 0.0, 3.0, 4.0])?;
    /// assert_eq!(positions.point(VertexId::new(1)), [3.0, 4.0]);
    /// # Ok(()) }
    /// ```
    pub fn point(&self, vertex: VertexId) -> &[f64] {
        &self.coordinates[vertex.index() * self.dimension..(vertex.index() + 1) * self.dimension]
    }

    /// The distance between the points `ends[2 * i]` and `ends[2 * i + 1]`, for each i.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] without positions; [`ErrorKind::NotInComplex`] naming a point that is not there.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::Positions;
    /// let positions = Positions::from_flat(2, vec![0.0, 0.0, 3.0, 4.0])?;
    /// assert_eq!(positions.distances(&[0, 1, 1, 1])?, [5.0, 0.0]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn distances(&self, ends: &[u32]) -> Result<Vec<f64>, Error> {
        if self.dimension == 0 {
            return Err(Error::invalid("there are no positions to measure lengths with")
                .with_cure("give positions, or take the length 1 for each edge"));
        }
        if let Some(&end) = ends.iter().find(|&&end| end as usize >= self.len()) {
            return Err(Error::new(
                ErrorKind::NotInComplex,
                format!("there is no point v{end}; there are {}", self.len()),
            )
            .with_fault(Fault::OutOfRange { index: end as usize, count: self.len() }));
        }
        let distance = |&[a, b]: &[u32; 2]| {
            let [a, b] = [a, b].map(|end| self.point(VertexId::from_u32(end)));
            a.iter().zip(b).fold(0.0, |sum: f64, (x, y)| sum.hypot(x - y))
        };
        Ok(ends.as_chunks::<2>().0.iter().map(distance).collect())
    }

    /// All coordinates, point after point.
    ///
    /// # Examples
    /// ```
    /// use coface_geometry::Positions;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(Positions::from_flat(2, vec![3.0, 4.0])?.as_flat(), [3.0, 4.0]);
    /// # Ok(()) }
    /// ```
    pub fn as_flat(&self) -> &[f64] {
        &self.coordinates
    }
}
