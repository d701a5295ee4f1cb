//! Vietoris-Rips persistence of points and distances.

use super::diagram::{DiagramFormat, Line, write_lines};
use crate::answer::{PersistenceAnswer, PersistencePairAnswer};
use crate::text;
use coface_algebra::{Error, VertexId, memory};
use coface_complexes::filtered::Distances;
use coface_io::FileGraph;
use coface_topology::{Coefficients, RipsDiagram, RipsFiltration, RipsPair};
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
}

impl Default for RipsRequest {
    fn default() -> Self {
        Self { coefficients: Coefficients::Modulo(2), dimension: 1, threshold: None, min_persistence: 0.0 }
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

    /// Finds the diagram of points with these distances.
    ///
    /// # Errors
    /// Those of [`RipsFiltration::new`] and [`RipsFiltration::persistence`]; [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) where the
    /// memory that is free would not do, with a threshold for which it would.
    ///
    /// # Examples
    /// See [`RipsRequest`].
    pub fn found(&self, name: &str, distances: &Distances) -> Result<FoundRips, Error> {
        let filtration =
            RipsFiltration::new(distances, self.threshold).map_err(|error| error.in_file(name))?;
        self.of_filtration(name, &filtration, None)
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
        self.of_filtration(name, &filtration, Some(graph))
    }

    fn of_filtration(
        &self,
        name: &str,
        filtration: &RipsFiltration,
        graph: Option<&FileGraph>,
    ) -> Result<FoundRips, Error> {
        let in_file = |error: Error| error.in_file(name);
        self.require_memory(filtration).map_err(in_file)?;
        let diagram = filtration.persistence(self.dimension, self.coefficients).map_err(in_file)?;
        let pairs = diagram.pairs().filter(|pair| length(pair) > self.min_persistence).cloned().collect();
        let vertices = graph.map(FileGraph::numbers);
        let names = graph.and_then(FileGraph::names).map(<[String]>::to_vec);
        Ok(FoundRips { name: name.to_owned(), diagram, pairs, vertices, names })
    }

    fn require_memory(&self, filtration: &RipsFiltration) -> Result<(), Error> {
        let size = filtration.size(self.dimension, f64::INFINITY)?;
        let what = || {
            let counts: Vec<String> =
                size.simplices().iter().map(|&count| text::grouped(count.round() as usize)).collect();
            format!(
                "persistence of about {} simplices of degrees 0 to {}",
                counts.join(" + "),
                self.dimension
            )
        };
        memory::require(size.bytes() as u64, what).map_err(|error| {
            let free = memory::free().unwrap_or(0) as f64;
            match filtration.threshold_within(self.dimension, free).ok().flatten() {
                Some(fitting) if fitting > 0.0 => error.with_cure(format!(
                    "ask for a threshold of {fitting} or less (--threshold {fitting}), a lower dimension, or allow more memory"
                )),
                _ => error.with_cure("ask for a lower dimension, take fewer points, or allow more memory"),
            }
        })
    }
}

fn length(pair: &RipsPair) -> f64 {
    pair.death().map_or(f64::INFINITY, |death| death - pair.birth())
}

/// A persistence diagram of points.
#[derive(Clone, Debug)]
pub struct FoundRips {
    name: String,
    diagram: RipsDiagram,
    pairs: Vec<RipsPair>,
    /// Of a graph, the numbers of the vertices in the file.
    vertices: Option<Vec<u32>>,
    /// Of a graph whose vertices have names, these.
    names: Option<Vec<String>>,
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
        Self { pairs, ..self.clone() }
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
            function: if self.vertices.is_some() { "flag complex" } else { "vietoris-rips" }.to_owned(),
            star: None,
            threshold: Some(self.diagram.threshold()),
            diagram: self.pairs.iter().map(pair).collect(),
            betti: self.diagram.betti_numbers(),
            torsion_primes: None,
            vertex_names: self.names.clone(),
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
        self.names.as_deref()
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
        let number = |point: &VertexId| match &self.vertices {
            Some(vertices) => vertices[point.index()],
            None => point.index() as u32,
        };
        simplex.iter().map(number).collect()
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
