//! Segments in the plane that are known exactly, wherever their ends are.

use super::vertices::Vertices;
use coface_algebra::{Error, ErrorKind};
use coface_geometry::predicates::{PlanarLine, PlanarPoint};
use std::cmp::Ordering;

/// Segments in the plane whose ends need not be floating-point numbers.
///
/// A **piece** is a part of a **support**, a segment between two given points. It runs from one **vertex** to another, and a
/// vertex is a given point, or where two supports cross. So segments that were cut out of others are known by the numbers that
/// those had: nothing was rounded, and the numbers do not grow however often they are cut again.
///
/// # Conventions
/// The first pieces may bound something, those after [`Self::own_count`] are **shared**: they have one thing on both sides, and
/// bound nothing. Every vertex is a point of the drawing, whether a piece ends there or not.
///
/// # Examples
/// The part of a segment to the left of another one:
/// ```
/// use coface_arrange::planar::{ExactPiece, ExactSegments, ExactVertex};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let points = vec![[0., 0.], [3., 1.], [1., 0.], [1., 5.]];
/// let vertices = vec![ExactVertex::Point(0), ExactVertex::Crossing([0, 1])];
/// let piece = ExactPiece { support: 0, ends: [0, 1] };
/// let segments = ExactSegments::new(points, vec![[0, 1], [2, 3]], vertices, vec![piece], vec![])?;
/// // The height is a third, which is no floating-point number.
/// assert_eq!(segments.vertex_points()[1].rounded(), [1., 1. / 3.]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Default)]
pub struct ExactSegments {
    points: Vec<[f64; 2]>,
    supports: Vec<[u32; 2]>,
    vertices: Vec<ExactVertex>,
    /// Those that are shared come last.
    pieces: Vec<ExactPiece>,
    own_count: usize,
}

/// What a vertex is known by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ExactVertex {
    /// The point of this number.
    Point(u32),
    /// Where these two supports meet, which are not parallel.
    Crossing([u32; 2]),
}

/// A part of a support.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ExactPiece {
    /// The support that it is part of.
    pub support: u32,
    /// The vertices where it starts and ends.
    pub ends: [u32; 2],
}

impl ExactSegments {
    /// Segments by their points, supports, vertices and pieces, those that bound something and then those that are shared.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming a point that is not finite, a support without length, a vertex whose supports do not meet in
    /// one point, and a piece that is not on its support; [`ErrorKind::NotInComplex`] naming points, supports and vertices that are
    /// not there; [`ErrorKind::TooLarge`] beyond 2^31 vertices or pieces.
    ///
    /// # Complexity
    /// Linear, in exact decisions.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::{ExactPiece, ExactSegments, ExactVertex};
    /// let segments = |end: [f64; 2]| {
    ///     let points = vec![[0., 0.], [2., 2.], end];
    ///     let piece = ExactPiece { support: 0, ends: [0, 1] };
    ///     ExactSegments::new(points, vec![[0, 1]], vec![ExactVertex::Point(0), ExactVertex::Point(2)], vec![piece], vec![])
    /// };
    /// assert!(segments([1., 1.]).is_ok());
    /// // Beside the support, and on its line beyond its end.
    /// assert!(segments([1., 0.]).is_err() && segments([3., 3.]).is_err());
    /// ```
    pub fn new(
        points: Vec<[f64; 2]>,
        supports: Vec<[u32; 2]>,
        vertices: Vec<ExactVertex>,
        pieces: Vec<ExactPiece>,
        shared: Vec<ExactPiece>,
    ) -> Result<Self, Error> {
        if points.len().max(supports.len()).max(vertices.len()).max(pieces.len() + shared.len()) >= 1 << 31 {
            return Err(Error::new(ErrorKind::TooLarge, "more than 2^31 points, vertices or pieces"));
        }
        if let Some(bad) = points.iter().position(|point| point.iter().any(|x| !x.is_finite())) {
            return Err(Error::invalid(format!("point {bad} has a coordinate that is not finite")));
        }
        let missing = |what: String, number: u32| {
            Error::new(ErrorKind::NotInComplex, format!("{what} names {number}, which is not there"))
        };
        for (number, ends) in supports.iter().enumerate() {
            if let Some(&bad) = ends.iter().find(|&&point| point as usize >= points.len()) {
                return Err(missing(format!("support {number}"), bad));
            }
            if points[ends[0] as usize] == points[ends[1] as usize] {
                return Err(Error::invalid(format!("support {number} has no length")));
            }
        }
        let own_count = pieces.len();
        let pieces = [pieces, shared].concat();
        let made = Self { points, supports, vertices, pieces, own_count };
        let mut places = Vec::with_capacity(made.vertices.len());
        for (number, vertex) in made.vertices.iter().enumerate() {
            let (named, count) = match vertex {
                ExactVertex::Point(point) => (std::slice::from_ref(point), made.points.len()),
                ExactVertex::Crossing(supports) => (&supports[..], made.supports.len()),
            };
            if let Some(&bad) = named.iter().find(|&&own| own as usize >= count) {
                return Err(missing(format!("vertex {number}"), bad));
            }
            let place = made.place(vertex).filter(|place| match vertex {
                ExactVertex::Point(_) => true,
                ExactVertex::Crossing(supports) => {
                    supports.iter().all(|&own| is_between(place, made.line(own)))
                }
            });
            places.push(place.ok_or_else(|| {
                Error::invalid(format!("the supports of vertex {number} do not meet in one point"))
            })?);
        }
        for (number, piece) in made.pieces.iter().enumerate() {
            if piece.support as usize >= made.supports.len() {
                return Err(missing(format!("piece {number}"), piece.support));
            }
            let line = made.line(piece.support);
            for end in piece.ends {
                let Some(place) = places.get(end as usize) else {
                    return Err(missing(format!("piece {number}"), end));
                };
                let is_known = match made.vertices[end as usize] {
                    ExactVertex::Point(point) => made.supports[piece.support as usize].contains(&point),
                    ExactVertex::Crossing(supports) => supports.contains(&piece.support),
                };
                let is_on = || place.side_of(line).is_eq() && is_between(place, line);
                if !is_known && !is_on() {
                    return Err(Error::invalid(format!(
                        "piece {number} ends in vertex {end}, which is not on support {}",
                        piece.support
                    )));
                }
            }
        }
        Ok(made)
    }

    /// The given points.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::ExactSegments;
    /// assert!(ExactSegments::default().points().is_empty());
    /// ```
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// The points at the ends of each support.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::ExactSegments;
    /// assert!(ExactSegments::default().supports().is_empty());
    /// ```
    pub fn supports(&self) -> &[[u32; 2]] {
        &self.supports
    }

    /// What each vertex is known by.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::ExactSegments;
    /// assert!(ExactSegments::default().vertices().is_empty());
    /// ```
    pub fn vertices(&self) -> &[ExactVertex] {
        &self.vertices
    }

    /// All pieces, those that are shared last.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::ExactSegments;
    /// assert!(ExactSegments::default().pieces().is_empty());
    /// ```
    pub fn pieces(&self) -> &[ExactPiece] {
        &self.pieces
    }

    /// The number of pieces that may bound something.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::ExactSegments;
    /// assert_eq!(ExactSegments::default().own_count(), 0);
    /// ```
    pub fn own_count(&self) -> usize {
        self.own_count
    }

    /// The ends of a support.
    ///
    /// # Panics
    /// If there is no such support.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::ExactSegments;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let segments = ExactSegments::new(vec![[0., 0.], [1., 2.]], vec![[1, 0]], vec![], vec![], vec![])?;
    /// assert_eq!(segments.line(0), [[1., 2.], [0., 0.]]);
    /// # Ok(()) }
    /// ```
    pub fn line(&self, support: u32) -> PlanarLine {
        self.supports[support as usize].map(|point| self.points[point as usize])
    }

    /// The exact place of each vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_arrange::planar::{ExactSegments, ExactVertex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let segments = ExactSegments::new(vec![[1., 2.]], vec![], vec![ExactVertex::Point(0)], vec![], vec![])?;
    /// assert_eq!(segments.vertex_points()[0].rounded(), [1., 2.]);
    /// # Ok(()) }
    /// ```
    pub fn vertex_points(&self) -> Vec<PlanarPoint> {
        self.vertices.iter().map(|vertex| self.place(vertex).expect("vertices were checked")).collect()
    }

    /// For each vertex the number of its place; vertices at one place have one number.
    #[doc(hidden)]
    pub fn place_numbers(&self) -> Vec<u32> {
        let places = self.vertex_points();
        Vertices::new(places.iter().map(PlanarPoint::rounded), |vertex| places[vertex as usize])
            .vertex_of_event
    }

    fn place(&self, vertex: &ExactVertex) -> Option<PlanarPoint> {
        match *vertex {
            ExactVertex::Point(point) => Some(PlanarPoint::given(self.points[point as usize])),
            ExactVertex::Crossing([s, t]) => PlanarPoint::crossing(self.line(s), self.line(t)),
        }
    }
}

/// Whether a point of the line of a segment is on the segment.
#[doc(hidden)]
pub fn is_between(point: &PlanarPoint, line: PlanarLine) -> bool {
    let sides = line.map(|end| point.compare(&PlanarPoint::given(end)));
    sides.contains(&Ordering::Equal) || sides[0] != sides[1]
}
