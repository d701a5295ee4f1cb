//! Complexes of points whose simplices have values.

use super::Growth;
use crate::Producer;
use crate::producer::{Cells, Labels, OrderedCells};
use coface_complexes::filtered::{DirectedFlagComplex, FilteredComplex};
use coface_geometry::Positions;
use coface_io::{AlphaCells, AlphaPoints, CechPoints, FileGraph, MapperPoints, Remark, WitnessPoints};

/// Points with the simplices of a complex that they make and the values at which these enter: what a
/// [`PersistenceRequest`](super::PersistenceRequest) is put to.
///
/// # Examples
/// The corners of a square of side 2: its sides come at the squared radius 1, and its inside at 2.
/// ```
/// use coface_answers::{PointFiltration, PersistenceRequest};
/// use coface_io::{AlphaReading, NumberTable};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let square = NumberTable::from_rows([[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
/// let alpha = PointFiltration::of_alpha(AlphaReading::default().points(&square)?, false);
/// let request = PersistenceRequest::new().growth(alpha.growth());
/// let answer = request.found("square.csv", alpha.producer())?.answer();
/// let hole = answer.diagram.last().expect("four points and a hole");
/// assert_eq!((hole.degree, hole.birth, hole.death), (1, 1.0, Some(2.0)));
/// # Ok(()) }
/// ```
#[derive(Debug)]
pub struct PointFiltration {
    producer: Producer,
    values: Vec<Vec<f64>>,
    /// What the values are.
    place: &'static str,
}

impl PointFiltration {
    /// The alpha complex of points, whose values are said to be radii, or squared radii. Of points that repeat it has no positions.
    ///
    /// # Examples
    /// See [`PointFiltration`].
    pub fn of_alpha(points: AlphaPoints, radii: bool) -> Self {
        let remarks = points.remarks().to_vec();
        let (positions, alpha) = points.into_parts();
        let place = if radii { "radii of the alpha complex" } else { "squared radii of the alpha complex" };
        let alpha = match alpha {
            AlphaCells::Plain(alpha) => {
                return Self::new(positions, alpha.into_filtered(), remarks, place);
            }
            AlphaCells::Periodic(alpha) => alpha,
        };
        // Simplices reach across the sides of the box, so that positions tell nothing of them.
        if let Some(complex) = alpha.simplicial() {
            return Self::new(Positions::default(), complex, remarks, place);
        }
        let degrees = 0..alpha.complex().f_vector().len();
        let values = degrees.map(|degree| alpha.values(degree).to_vec()).collect();
        Self::of_ordered(OrderedCells::Periodic(alpha), values, Labels::default(), remarks, place)
    }

    /// The Čech complex of points, whose values are radii.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{PersistenceRequest, PointFiltration};
    /// use coface_io::{CechReading, NumberTable};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = NumberTable::from_rows([[0.0, 0.0], [6.0, 0.0], [6.0, 8.0], [0.0, 8.0]]);
    /// let cech = PointFiltration::of_cech(CechReading::default().points(&square)?);
    /// let request = PersistenceRequest::new().growth(cech.growth()).up_to_degree(1);
    /// let answer = request.found("square.csv", cech.producer())?.answer();
    /// let hole = answer.diagram.last().expect("four points and a hole");
    /// assert_eq!((hole.degree, hole.birth, hole.death), (1, 4.0, Some(5.0)));
    /// # Ok(()) }
    /// ```
    pub fn of_cech(points: CechPoints) -> Self {
        let remarks = points.remarks().to_vec();
        let (positions, complex) = points.into_parts();
        Self::new(positions, complex, remarks, "radii of the Čech complex")
    }

    /// The witness complex of landmarks, which are numbered from 0 on and whose values are squared distances.
    ///
    /// # Examples
    /// Two landmarks, with a witness between them.
    /// ```
    /// use coface_answers::{PersistenceRequest, PointFiltration};
    /// use coface_io::{NumberTable, WitnessReading};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let line = NumberTable::from_rows([[0.0], [1.0], [4.0]]);
    /// let witness = PointFiltration::of_witness(WitnessReading::of_count(2).points(&line)?);
    /// let request = PersistenceRequest::new().growth(witness.growth());
    /// assert_eq!(request.found("line.csv", witness.producer())?.answer().betti, [1, 0]);
    /// # Ok(()) }
    /// ```
    pub fn of_witness(points: WitnessPoints) -> Self {
        let remarks = points.remarks().to_vec();
        let (positions, complex) = points.into_parts();
        Self::new(positions, complex, remarks, "squared distances of the witness complex")
    }

    /// The Mapper complex of points, whose vertices are clusters and whose values are means of the function.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{PersistenceRequest, PointFiltration};
    /// use coface_io::{MapperReading, NumberTable};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let line = NumberTable::from_rows([[0.0], [1.0], [2.0]]);
    /// let mapper = PointFiltration::of_mapper(MapperReading::of_count(2)?.points(&line)?);
    /// let request = PersistenceRequest::new().growth(mapper.growth());
    /// assert_eq!(request.found("line.csv", mapper.producer())?.answer().diagram[0].birth, 0.5);
    /// # Ok(()) }
    /// ```
    pub fn of_mapper(points: MapperPoints) -> Self {
        let remarks = points.remarks().to_vec();
        let (positions, complex) = points.into_parts();
        Self::new(positions, complex, remarks, "means of the function over clusters")
    }

    /// The directed flag complex of a graph, whose simplices are named by the numbers of their vertices, each before those that it has an edge to.
    ///
    /// # Examples
    /// Two edges that lead from one vertex to another and back make a loop.
    /// ```
    /// use coface_answers::{PersistenceRequest, PointFiltration};
    /// use coface_complexes::filtered::DirectedFlagComplex;
    /// use coface_io::FlagReading;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let reading = FlagReading { directed: true, ..FlagReading::default() };
    /// let graph = reading.graph(&b"7 9 1\n9 7 2\n"[..])?;
    /// let complex = DirectedFlagComplex::new(&graph.digraph(), f64::INFINITY, 2)?;
    /// let loops = PointFiltration::of_directed(&graph, complex);
    /// let request = PersistenceRequest::new().growth(loops.growth());
    /// let answer = request.found("graph.txt", loops.producer())?.answer();
    /// assert_eq!((&answer.betti[..], &answer.diagram[2].birth_cell[..]), (&[1, 1][..], &[9, 7][..]));
    /// # Ok(()) }
    /// ```
    pub fn of_directed(graph: &FileGraph, complex: DirectedFlagComplex) -> Self {
        let degrees = 0..complex.complex().f_vector().len();
        let values = degrees.map(|degree| complex.values(degree).to_vec()).collect();
        let (cells, remarks) = (OrderedCells::Directed(complex), graph.remarks().to_vec());
        Self::of_ordered(cells, values, Labels::of_graph(graph), remarks, "directed flag complex")
    }

    fn of_ordered(
        cells: OrderedCells,
        values: Vec<Vec<f64>>,
        labels: Labels,
        remarks: Vec<Remark>,
        place: &'static str,
    ) -> Self {
        let (cells, positions) = (Cells::Ordered(Box::new(cells)), Positions::default());
        Self {
            producer: Producer { cells, labels, positions, partial_positions: None, remarks },
            values,
            place,
        }
    }

    /// The simplices of a Vietoris-Rips filtration, or of the flag complex of a graph, that are needed for the cycles of its diagram.
    pub(super) fn of_flag(
        positions: Positions,
        labels: Labels,
        complex: FilteredComplex,
        place: &'static str,
    ) -> Self {
        let mut made = Self::new(positions, complex, Vec::new(), place);
        made.producer.labels = labels;
        made
    }

    fn new(
        positions: Positions,
        complex: FilteredComplex,
        remarks: Vec<Remark>,
        place: &'static str,
    ) -> Self {
        let (complex, values) = complex.into_parts();
        let cells = Cells::Simplices(complex);
        let labels = Labels::default();
        Self {
            producer: Producer { cells, labels, positions, partial_positions: None, remarks },
            values,
            place,
        }
    }

    /// The points with the simplices, which have the numbers of the points.
    ///
    /// # Examples
    /// See [`PointFiltration`].
    pub fn producer(&self) -> &Producer {
        &self.producer
    }

    /// The values of the simplices.
    ///
    /// # Examples
    /// See [`PointFiltration`].
    pub fn growth(&self) -> Growth {
        Growth::Cells { place: self.place.to_owned(), values: self.values.clone() }
    }
}
