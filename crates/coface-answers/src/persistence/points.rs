//! Vietoris-Rips persistence of points and distances.

use super::diagram::{DiagramFormat, Line, write_lines};
use crate::answer::{PersistenceAnswer, PersistencePairAnswer};
use crate::producer::Labels;
use crate::text;
use crate::{PersistenceRequest, PointFiltration};
use coface_algebra::{Error, VertexId, memory};
use coface_complexes::filtered::{Distances, FilteredComplex};
use coface_geometry::Positions;
use coface_io::FileGraph;
use coface_topology::{Coefficients, RipsDiagram, RipsFiltration, RipsPair, RipsSize};
use std::io::Write;

/// Asks for persistent homology of the Vietoris-Rips filtration of points.
///
/// # Examples
/// ```
/// use coface_answers::RipsRequest;
/// use coface_io::{NumberTable, TableForm};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let square = NumberTable::read(&b"0 0\n1 0\n1 1\n0 1\n"[..])?;
/// let distances = TableForm::Points.distances(&square)?;
/// let answer = RipsRequest::new().found("square.csv", &distances)?.answer();
/// let hole = answer.diagram.last().expect("four points and a hole");
/// assert_eq!((hole.degree, hole.birth, hole.death), (1, 1.0, Some(2f64.sqrt())));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct RipsRequest {
    coefficients: Coefficients,
    dimension: usize,
    threshold: Option<f64>,
    min_persistence: f64,
    collapse: bool,
}

impl Default for RipsRequest {
    fn default() -> Self {
        let coefficients = Coefficients::Modulo(2);
        Self { coefficients, dimension: 1, threshold: None, min_persistence: 0.0, collapse: false }
    }
}

impl RipsRequest {
    /// Asks for the degrees 0 and 1 over two elements, up to the enclosing radius.
    ///
    /// # Examples
    /// See [`RipsRequest`].
    pub fn new() -> Self {
        Self::default()
    }

    /// The field of coefficients.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::RipsRequest;
    /// use coface_complexes::filtered::Distances;
    /// use coface_topology::Coefficients;
    /// let two = Distances::from_lower_triangle(2, vec![3.0])?;
    /// assert_eq!(RipsRequest::new().coefficients(Coefficients::Modulo(3)).found("two", &two)?.answer().field, 3);
    /// # Ok(()) }
    /// ```
    pub fn coefficients(mut self, coefficients: Coefficients) -> Self {
        self.coefficients = coefficients;
        self
    }

    /// The highest degree that is asked for.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::RipsRequest;
    /// use coface_complexes::filtered::Distances;
    /// let two = Distances::from_lower_triangle(2, vec![3.0])?;
    /// assert_eq!(RipsRequest::new().dimension(2).found("two", &two)?.answer().betti, [1, 0, 0]);
    /// # Ok(()) }
    /// ```
    pub fn dimension(mut self, dimension: usize) -> Self {
        self.dimension = dimension;
        self
    }

    /// The largest diameter of simplices; `None` is the enclosing radius.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::RipsRequest;
    /// use coface_complexes::filtered::Distances;
    /// let two = Distances::from_lower_triangle(2, vec![3.0])?;
    /// assert_eq!(RipsRequest::new().threshold(Some(2.0)).found("two", &two)?.answer().betti, [2, 0]);
    /// # Ok(()) }
    /// ```
    pub fn threshold(mut self, threshold: Option<f64>) -> Self {
        self.threshold = threshold;
        self
    }

    /// Leaves out the pairs whose persistence is not greater. Pairs of persistence 0 are never listed: they are not computed one by one.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::RipsRequest;
    /// use coface_complexes::filtered::Distances;
    /// let two = Distances::from_lower_triangle(2, vec![3.0])?;
    /// assert_eq!(RipsRequest::new().min_persistence(3.0).found("two", &two)?.answer().diagram.len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn min_persistence(mut self, least: f64) -> Self {
        self.min_persistence = least;
        self
    }

    /// Whether edges are collapsed before: the diagram is the same, of fewer simplices, and the simplices of its classes are among those that are left.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::RipsRequest;
    /// use coface_complexes::filtered::Distances;
    /// let line = Distances::from_lower_triangle(4, vec![1.0, 2.0, 1.0, 3.0, 2.0, 1.0])?;
    /// let answer = RipsRequest::new().threshold(Some(3.0)).collapse(true).found("line", &line)?.answer();
    /// assert_eq!(answer.collapsed, Some((6, 3)));
    /// # Ok(()) }
    /// ```
    pub fn collapse(mut self, collapse: bool) -> Self {
        self.collapse = collapse;
        self
    }

    /// Finds the diagram of points with these distances.
    ///
    /// # Errors
    /// Those of [`RipsFiltration::new`] and [`RipsFiltration::persistence`]; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a
    /// negative [`Self::min_persistence`]; [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) where the
    /// memory that is free would not do, with a threshold for which it would.
    ///
    /// # Examples
    /// See [`RipsRequest`].
    pub fn found(&self, name: &str, distances: &Distances) -> Result<FoundRips, Error> {
        let in_file = |error: Error| error.in_file(name);
        let held = bytes_of(distances);
        self.require_edges(distances, held).map_err(in_file)?;
        let filtration = RipsFiltration::new(distances, self.threshold).map_err(in_file)?;
        self.of_filtration(name, filtration, None, held)
    }

    /// Finds the diagram of the flag complex of a graph.
    ///
    /// # Errors
    /// Those of [`RipsFiltration::of_graph`], and as of [`Self::found`].
    ///
    /// # Examples
    /// A cycle of four vertices.
    /// ```
    /// use coface_answers::RipsRequest;
    /// use coface_io::FlagReading;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let cycle = FlagReading::default().graph(&b"2 3\n3 5\n5 9\n9 2\n"[..])?;
    /// let answer = RipsRequest::new().found_of_graph("cycle", &cycle)?.answer();
    /// assert_eq!((answer.betti, answer.function.as_str()), (vec![1, 1], "flag complex"));
    /// # Ok(()) }
    /// ```
    pub fn found_of_graph(&self, name: &str, graph: &FileGraph) -> Result<FoundRips, Error> {
        let filtration =
            RipsFiltration::of_graph(&graph.graph(), self.threshold).map_err(|error| error.in_file(name))?;
        self.of_filtration(name, filtration, Some(graph), 0.0)
    }

    fn of_filtration(
        &self,
        name: &str,
        mut filtration: RipsFiltration,
        graph: Option<&FileGraph>,
        held: f64,
    ) -> Result<FoundRips, Error> {
        let in_file = |error: Error| error.in_file(name);
        if self.min_persistence < 0.0 {
            let message =
                "pairs of persistence 0 of a Vietoris-Rips or flag complex are not computed one by one";
            return Err(in_file(
                Error::invalid(message).with_cure("give 0 or more as the least persistence"),
            ));
        }
        let collapsed = self.collapse.then(|| {
            let before = filtration.edge_count();
            filtration = filtration.collapsed();
            (before, filtration.edge_count())
        });
        self.require_memory(&filtration, held).map_err(in_file)?;
        let diagram = filtration.persistence(self.dimension, self.coefficients).map_err(in_file)?;
        let pairs = diagram.pairs().filter(|pair| length(pair) > self.min_persistence).cloned().collect();
        let labels = graph.map(Labels::of_graph);
        let (name, min_persistence) = (name.to_owned(), self.min_persistence);
        Ok(FoundRips { name, filtration, diagram, pairs, labels, min_persistence, collapsed })
    }

    /// That the edges alone fit beside the distances, before they are made.
    fn require_edges(&self, distances: &Distances, held: f64) -> Result<(), Error> {
        if memory::free().is_none() {
            return Ok(());
        }
        let size = RipsFiltration::size_of_edges(distances, self.threshold);
        let least = if self.dimension > 1 { "at least" } else { "about" };
        let what = || format!("persistence of {least} {} to 1", counted(&size));
        let fitting = |bytes| RipsFiltration::threshold_of(distances, self.dimension, bytes);
        require(size.bytes(), held, what, fitting)
    }

    /// That the rest fits too.
    fn require_memory(&self, filtration: &RipsFiltration, held: f64) -> Result<(), Error> {
        let size = filtration.size(self.dimension, f64::INFINITY)?;
        let what = || format!("persistence of about {} to {}", counted(&size), self.dimension);
        require(size.bytes(), held, what, |bytes| filtration.threshold_within(self.dimension, bytes))
    }
}

/// That so many bytes fit beside those that are held; if not, the error has the threshold that fits, if there is one.
fn require(
    bytes: f64,
    held: f64,
    what: impl FnOnce() -> String,
    fitting: impl FnOnce(f64) -> Result<Option<f64>, Error>,
) -> Result<(), Error> {
    memory::require((bytes + held) as u64, what).map_err(|error| {
        let free = memory::free().unwrap_or(0) as f64 - held;
        match fitting(free).ok().flatten() {
            Some(fitting) if fitting > 0.0 => error.with_cure(format!(
                "ask for a threshold of {fitting} or less (--threshold {fitting}), a lower dimension, or allow more memory"
            )),
            _ => error.with_cure("ask for a lower dimension, take fewer points, or allow more memory"),
        }
    })
}

/// The memory that distances take.
fn bytes_of(distances: &Distances) -> f64 {
    let mut count = 0usize;
    distances.each(|_, _, _| count += 1);
    count as f64 * if distances.is_sparse() { 16.0 } else { 8.0 }
}

/// The numbers of simplices, as far as the lowest of their degrees.
fn counted(size: &RipsSize) -> String {
    let counts = size.simplices().iter().map(|&count| text::grouped(count.round() as usize));
    format!("{} simplices of degrees 0", counts.collect::<Vec<_>>().join(" + "))
}

fn length(pair: &RipsPair) -> f64 {
    pair.death().map_or(f64::INFINITY, |death| death - pair.birth())
}

/// A persistence diagram of points.
#[derive(Clone, Debug)]
pub struct FoundRips {
    name: String,
    pub(super) filtration: RipsFiltration,
    pub(super) diagram: RipsDiagram,
    pairs: Vec<RipsPair>,
    /// Of a graph, what the vertices are called in the file.
    pub(super) labels: Option<Labels>,
    pub(super) min_persistence: f64,
    /// The numbers of edges before and after their collapse.
    collapsed: Option<(usize, usize)>,
}

impl FoundRips {
    /// The whole diagram.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::RipsRequest;
    /// use coface_complexes::filtered::Distances;
    /// let two = Distances::from_lower_triangle(2, vec![3.0])?;
    /// assert_eq!(RipsRequest::new().found("two", &two)?.diagram().pairs().count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn diagram(&self) -> &RipsDiagram {
        &self.diagram
    }

    /// The pairs that are long enough, by degree.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::RipsRequest;
    /// use coface_complexes::filtered::Distances;
    /// let two = Distances::from_lower_triangle(2, vec![3.0])?;
    /// assert_eq!(RipsRequest::new().found("two", &two)?.pairs().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn pairs(&self) -> &[RipsPair] {
        &self.pairs
    }

    /// The same without the pairs whose persistence is not greater.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::RipsRequest;
    /// use coface_complexes::filtered::Distances;
    /// let two = Distances::from_lower_triangle(2, vec![3.0])?;
    /// assert_eq!(RipsRequest::new().found("two", &two)?.longer_than(3.0).pairs().len(), 1);
    /// # Ok(()) }
    /// ```
    pub fn longer_than(&self, least: f64) -> Self {
        let pairs = self.pairs.iter().filter(|pair| length(pair) > least).cloned().collect();
        Self { pairs, min_persistence: self.min_persistence.max(least), ..self.clone() }
    }

    /// Classes that live no longer were left out.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::RipsRequest;
    /// use coface_complexes::filtered::Distances;
    /// let two = Distances::from_lower_triangle(2, vec![3.0])?;
    /// assert_eq!(RipsRequest::new().found("two", &two)?.longer_than(1.0).min_persistence(), 1.0);
    /// # Ok(()) }
    /// ```
    pub fn min_persistence(&self) -> f64 {
        self.min_persistence
    }

    /// The simplices that the classes need for cycles, with the question for these: it has the same pairs. Positions, where points have some, are for
    /// pictures.
    ///
    /// # Errors
    /// Those of [`RipsFiltration::complex_of`]; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if edges were collapsed.
    ///
    /// # Examples
    /// A square, whose hole has its four sides as a cycle.
    /// ```
    /// use coface_answers::RipsRequest;
    /// use coface_io::FlagReading;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = FlagReading::default().graph(&b"2 3\n3 5\n5 9\n9 2\n2 5 4\n"[..])?;
    /// let found = RipsRequest::new().found_of_graph("square", &square)?;
    /// let (points, request) = found.with_simplices(Default::default())?;
    /// let answer = request.cycles(true).found("square", points.producer())?.answer();
    /// let hole = answer.diagram.last().expect("four vertices and a hole");
    /// assert_eq!((hole.birth, hole.death), (1.0, Some(4.0)));
    /// assert_eq!(hole.cycle.as_ref().map(Vec::len), Some(4));
    /// # Ok(()) }
    /// ```
    pub fn with_simplices(
        &self,
        positions: Positions,
    ) -> Result<(PointFiltration, PersistenceRequest), Error> {
        let complex = self.simplices()?;
        let order = RipsFiltration::order_of(&complex);
        let labels = self.labels.clone().unwrap_or_default();
        let points = PointFiltration::of_flag(positions, labels, complex, self.function());
        let request = PersistenceRequest::new()
            .coefficients(Coefficients::Modulo(self.diagram.prime().into()))
            .growth(points.growth())
            .in_order(order)
            .up_to_degree(self.diagram.degree_count() - 1)
            .threshold(self.diagram.threshold())
            .min_persistence(self.min_persistence.max(0.0));
        Ok((points, request))
    }

    /// The simplices that the classes need for cycles, by the places of the points.
    ///
    /// # Errors
    /// Those of [`RipsFiltration::complex_of`]; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) if edges were collapsed.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::RipsRequest;
    /// use coface_complexes::filtered::Distances;
    /// let two = Distances::from_lower_triangle(2, vec![3.0])?;
    /// assert_eq!(RipsRequest::new().found("two", &two)?.simplices()?.complex().f_vector(), [2, 1]);
    /// # Ok(()) }
    /// ```
    pub fn simplices(&self) -> Result<FilteredComplex, Error> {
        self.require_all_edges("cycles and cocycles")?;
        self.filtration.complex_of(&self.diagram).map_err(|error| error.in_file(&self.name))
    }

    /// That no edges are left out, of which a proof would have to speak.
    pub(super) fn require_all_edges(&self, what: &str) -> Result<(), Error> {
        if self.collapsed.is_none() {
            return Ok(());
        }
        let error = Error::invalid(format!("there are no {what} of a complex whose edges were collapsed"));
        Err(error.with_cure("ask for them without the collapse of edges").in_file(&self.name))
    }

    /// The numbers of edges before and after their collapse; `None` if they were not collapsed.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::RipsRequest;
    /// use coface_complexes::filtered::Distances;
    /// let two = Distances::from_lower_triangle(2, vec![3.0])?;
    /// assert_eq!(RipsRequest::new().collapse(true).found("two", &two)?.collapsed(), Some((1, 1)));
    /// # Ok(()) }
    /// ```
    pub fn collapsed(&self) -> Option<(usize, usize)> {
        self.collapsed
    }

    /// What grows.
    fn function(&self) -> &'static str {
        if self.labels.is_some() { "flag complex" } else { "vietoris-rips" }
    }

    /// The answer as plain data.
    ///
    /// # Examples
    /// See [`RipsRequest`].
    pub fn answer(&self) -> PersistenceAnswer {
        let points = |simplex: &[VertexId]| self.numbers(simplex);
        let pair = |pair: &RipsPair| PersistencePairAnswer {
            degree: pair.degree(),
            kind: None,
            birth: pair.birth(),
            death: pair.death(),
            birth_cell: points(pair.birth_simplex()),
            death_cell: pair.death_simplex().map(points),
            cycle: None,
            bounding_chain: None,
            cocycle: None,
        };
        PersistenceAnswer {
            file: self.name.clone(),
            field: self.diagram.prime(),
            function: self.function().to_owned(),
            star: None,
            threshold: Some(self.diagram.threshold()),
            diagram: self.pairs.iter().map(pair).collect(),
            betti: self.diagram.betti_numbers(),
            torsion_primes: None,
            collapsed: self.collapsed,
            relative_to: None,
            image_of: None,
            vertex_names: self.vertex_names().map(<[String]>::to_vec),
            remarks: Vec::new(),
        }
    }

    /// The names of the vertices by their numbers, of a graph whose vertices have names.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::RipsRequest;
    /// use coface_io::FlagReading;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let graph = FlagReading::default().graph(&b"Bern Thun 3\n"[..])?;
    /// let found = RipsRequest::new().found_of_graph("roads", &graph)?;
    /// assert_eq!(found.vertex_names(), Some(&["Bern".to_owned(), "Thun".to_owned()][..]));
    /// # Ok(()) }
    /// ```
    pub fn vertex_names(&self) -> Option<&[String]> {
        self.labels.as_ref().and_then(Labels::names)
    }

    /// The points of a simplex by their numbers in the file.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::RipsRequest;
    /// use coface_complexes::filtered::Distances;
    /// let found = RipsRequest::new().found("two", &Distances::from_lower_triangle(2, vec![3.0])?)?;
    /// assert_eq!(found.numbers(found.pairs()[1].death_simplex().expect("an edge")), [0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn numbers(&self, simplex: &[VertexId]) -> Vec<u32> {
        let points = simplex.iter().map(|point| point.index() as u32).collect();
        match &self.labels {
            Some(labels) => labels.of_all(points),
            None => points,
        }
    }

    /// Writes the diagram as [`write_diagram`](crate::write_diagram) does; cells are given by their points, with blanks between them.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::Io`] if the stream cannot be written.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{DiagramFormat, RipsRequest};
    /// use coface_complexes::filtered::Distances;
    /// let two = Distances::from_lower_triangle(2, vec![3.0])?;
    /// let mut text = Vec::new();
    /// RipsRequest::new().dimension(0).found("two", &two)?.write(&mut text, DiagramFormat::Gudhi)?;
    /// assert_eq!(text, b"2 0 0 inf\n2 0 0 3\n");
    /// # Ok(()) }
    /// ```
    pub fn write(&self, out: impl Write, format: DiagramFormat) -> Result<(), Error> {
        let name = |simplex: &[VertexId]| {
            let points: Vec<String> = self.numbers(simplex).iter().map(u32::to_string).collect();
            points.join(" ")
        };
        let lines = self.pairs.iter().map(|pair| Line {
            degree: pair.degree(),
            birth: pair.birth(),
            death: pair.death(),
            birth_cell: name(pair.birth_simplex()),
            death_cell: pair.death_simplex().map(name),
        });
        write_lines(self.diagram.prime(), f64::INFINITY, self.diagram.degree_count(), lines, out, format)
    }
}
