//! Alpha filtrations of points.

use super::Growth;
use crate::Producer;
use crate::producer::{Cells, Labels};
use coface_io::AlphaPoints;

/// Points with the simplices of their alpha complex and the values at which these enter: what a
/// [`PersistenceRequest`](super::PersistenceRequest) is put to.
///
/// # Examples
/// The corners of a square of side 2: its sides come at the squared radius 1, and its inside at 2.
/// ```
/// use coface_answers::{AlphaFiltration, PersistenceRequest};
/// use coface_io::{AlphaReading, NumberTable};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let square = NumberTable::from_rows([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
/// let alpha = AlphaFiltration::new(AlphaReading::default().points(&square)?, false);
/// let request = PersistenceRequest::new().growth(alpha.growth());
/// let answer = request.found("square.csv", alpha.producer())?.answer();
/// let hole = answer.diagram.last().expect("four points and a hole");
/// assert_eq!((hole.degree, hole.birth, hole.death), (1, 1.0, Some(2.0)));
/// # Ok(()) }
/// ```
#[derive(Debug)]
pub struct AlphaFiltration {
    producer: Producer,
    values: Vec<Vec<f64>>,
    radii: bool,
}

impl AlphaFiltration {
    /// The filtration of these points, whose values are said to be radii, or squared radii.
    ///
    /// # Examples
    /// See [`AlphaFiltration`].
    pub fn new(points: AlphaPoints, radii: bool) -> Self {
        let remarks = points.remarks().to_vec();
        let (positions, alpha) = points.into_parts();
        let (complex, values) = alpha.into_parts();
        let producer = Producer {
            cells: Cells::Simplices(complex),
            labels: Labels::default(),
            positions,
            partial_positions: None,
            remarks,
        };
        Self { producer, values, radii }
    }

    /// The points with the simplices, which have the numbers of the points.
    ///
    /// # Examples
    /// See [`AlphaFiltration`].
    pub fn producer(&self) -> &Producer {
        &self.producer
    }

    /// The values of the simplices.
    ///
    /// # Examples
    /// See [`AlphaFiltration`].
    pub fn growth(&self) -> Growth {
        let place =
            if self.radii { "radii of the alpha complex" } else { "squared radii of the alpha complex" };
        Growth::Cells { place: place.to_owned(), values: self.values.clone() }
    }
}
