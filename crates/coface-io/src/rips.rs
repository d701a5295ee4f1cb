//! Points, distances and graphs that are read as flag complexes.

use crate::filtered_model::{model_of, model_with_numbers};
use crate::graph::FileGraph;
use crate::points_table::vertices_of_path;
use crate::readers::ReadOptions;
use crate::{Model, ModelParts, NumberTable, Remark, RemarkCode, Structure, TableForm};
use coface_algebra::Error;
use coface_complexes::filtered::{DirectedFlagComplex, Distances, FilteredComplex};
use coface_geometry::Positions;
use std::io::Read;
use std::path::Path;

/// How points or distances become a Vietoris-Rips complex.
///
/// # Examples
/// The corners of a square without its diagonals.
/// ```
/// use coface_io::{ReadOptions, RipsReading, read_with};
/// let rips = RipsReading { threshold: Some(1.0), ..RipsReading::default() };
/// let model = read_with(&b"0 0\n1 0\n1 1\n0 1\n"[..], &ReadOptions::new().rips(rips))?;
/// assert_eq!((model.lines().len(), model.polygons().len()), (4, 0));
/// # Ok::<(), coface_algebra::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct RipsReading {
    /// What the numbers of a table are; by default what they look like.
    pub form: Option<TableForm>,
    /// Of a time series, how far the rows of a point are from each other, and how many there are.
    pub delay: Option<(usize, usize)>,
    /// The largest diameter of simplices; the enclosing radius without it.
    pub threshold: Option<f64>,
    /// The highest dimension of simplices; 2 without it.
    pub dimension: Option<usize>,
}

/// The highest dimension of simplices that are made if nothing else is said.
pub(crate) const DIMENSION: usize = 2;

impl RipsReading {
    /// The distances in a file: of a table, or of the vertices of a model.
    ///
    /// # Errors
    /// As of [`Self::distances`] and [`crate::read_path_with`].
    ///
    /// # Examples
    /// ```
    /// use coface_io::{ReadOptions, RipsReading};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = std::env::temp_dir().join("coface-rips.lower_distance_matrix");
    /// std::fs::write(&path, "3\n5 4\n")?;
    /// let points = RipsReading::default().distances_of_path(&path, &ReadOptions::new())?;
    /// assert_eq!(points.distances().enclosing_radius(), Some(4.0));
    /// # std::fs::remove_file(&path)?;
    /// # Ok(()) }
    /// ```
    pub fn distances_of_path(
        &self,
        path: impl AsRef<Path>,
        options: &ReadOptions,
    ) -> Result<RipsPoints, Error> {
        let path = path.as_ref();
        let named = |error: Error| error.in_file(path.display().to_string());
        let reading = Self { form: self.form.or_else(|| form_of_extension(path)), ..*self };
        if matches!(reading.form, None | Some(TableForm::Points))
            && self.delay.is_none()
            && let Some((vertices, remarks)) = vertices_of_path(path, options)?
        {
            let points = Self { form: Some(TableForm::Points), ..reading };
            let mut found = points.distances(&vertices).map_err(named)?;
            found.remarks.extend(remarks);
            return Ok(found);
        }
        reading.distances(&NumberTable::read_distances_of_path(path)?).map_err(named)
    }

    /// The distances in a table, or those of its points.
    ///
    /// # Errors
    /// Those of [`TableForm::distances`] and [`NumberTable::delayed`].
    ///
    /// # Examples
    /// ```
    /// use coface_io::{NumberTable, RipsReading};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let series = NumberTable::from_rows([[0.0], [3.0], [4.0]]);
    /// let points = RipsReading { delay: Some((1, 2)), ..RipsReading::default() }.distances(&series)?;
    /// assert_eq!(points.distances().enclosing_radius(), Some(10f64.sqrt()));
    /// # Ok(()) }
    /// ```
    pub fn distances(&self, table: &NumberTable) -> Result<RipsPoints, Error> {
        let (delayed, (form, said)) = match (self.delay, self.form) {
            (Some((delay, embedding)), _) => {
                (Some(table.delayed(delay, embedding)?), (TableForm::Points, None))
            }
            (None, Some(form)) => (None, (form, None)),
            (None, None) => (None, TableForm::of(table)),
        };
        let own = table.remarks();
        let table = delayed.as_ref().unwrap_or(table);
        table.require_points(form)?;
        let distances = form.distances(table)?;
        let evened = said.is_none().then(|| form.evened(table)).flatten();
        let columns = if table.row_count() == 0 { 0 } else { table.row(0).len() };
        let positions = match form {
            TableForm::Points if columns <= 3 => {
                let flat = table.numbers().to_vec();
                Positions::from_flat(columns, flat)?
            }
            _ => Positions::default(),
        };
        Ok(RipsPoints { distances, positions, remarks: said.into_iter().chain(evened).chain(own).collect() })
    }

    /// The complex of points as a model, as [`ReadOptions::rips`] says.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a negative threshold, and those of [`FilteredComplex::flag`].
    ///
    /// # Examples
    /// ```
    /// use coface_io::{NumberTable, RipsReading};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let table = NumberTable::from_rows([[0.0, 0.0], [3.0, 0.0], [0.0, 4.0]]);
    /// let rips = RipsReading { threshold: Some(4.5), ..RipsReading::default() };
    /// assert_eq!(rips.model(rips.distances(&table)?)?.lines().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn model(&self, points: RipsPoints) -> Result<Model, Error> {
        let threshold = match self.threshold {
            Some(threshold) if threshold.is_nan() || threshold < 0.0 => {
                let message = format!("the threshold is {threshold}, and distances are not negative");
                return Err(Error::invalid(message).with_cure("give a threshold of 0 or more"));
            }
            Some(threshold) => threshold,
            None => points.distances.whole_threshold(),
        };
        let graph = points.distances.graph_within(threshold);
        let complex = FilteredComplex::flag(&graph, threshold, self.dimension.unwrap_or(DIMENSION))?;
        let mut remarks = points.remarks;
        remarks.extend(skeleton_remark(self.dimension, complex.complex().dimension()));
        Ok(model_of(&points.positions, &complex, remarks))
    }
}

/// Points with their distances.
#[derive(Clone, Debug)]
pub struct RipsPoints {
    distances: Distances,
    /// Empty where there are none, or more than three coordinates.
    positions: Positions,
    remarks: Vec<Remark>,
}

impl RipsPoints {
    /// The distances.
    ///
    /// # Examples
    /// See [`RipsReading::distances`].
    pub fn distances(&self) -> &Distances {
        &self.distances
    }

    /// The coordinates; none where there are distances alone, or more than three coordinates.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{NumberTable, RipsReading};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let line = NumberTable::from_rows([[0.0, 1.0], [0.0, 5.0]]);
    /// assert_eq!(RipsReading::default().distances(&line)?.positions().len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self) -> &Positions {
        &self.positions
    }

    /// What the reader assumed.
    ///
    /// # Examples
    /// ```
    /// use coface_io::{NumberTable, RipsReading};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = NumberTable::from_rows([[0.0, 3.0, 5.0], [3.0, 0.0, 4.0], [5.0, 4.0, 0.0]]);
    /// assert!(RipsReading::default().distances(&square)?.remarks()[0].message.contains("--distances points"));
    /// # Ok(()) }
    /// ```
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }
}

/// How a graph with values becomes a flag complex.
///
/// # Examples
/// A triangle and one more edge.
/// ```
/// use coface_io::{FlagReading, ReadOptions, Structure, read_with};
/// let model = read_with(&b"0 1\n1 2\n2 0\n2 3\n"[..], &ReadOptions::new().flag(FlagReading::default()))?;
/// let Some(Structure::Facets(facets)) = model.structure() else { panic!("simplices") };
/// assert_eq!(facets.iter().collect::<Vec<_>>(), [&[0, 1, 2][..], &[2, 3]]);
/// # Ok::<(), coface_algebra::Error>(())
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FlagReading {
    /// Whether edges have directions: simplices are lists of vertices with an edge from each to each later one.
    pub directed: bool,
    /// The largest value of simplices; all without it.
    pub threshold: Option<f64>,
    /// The highest dimension of simplices; 2 without it.
    pub dimension: Option<usize>,
}

impl FlagReading {
    /// The graph in a file, as [`Self::graph`] reads it.
    ///
    /// # Errors
    /// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) where the file cannot be read, and those of [`Self::graph`]. All name the file.
    ///
    /// # Examples
    /// ```
    /// use coface_io::FlagReading;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = std::env::temp_dir().join("coface-graph.csv");
    /// std::fs::write(&path, "u,v,weight\n7,9,3\n")?;
    /// assert_eq!(FlagReading::default().graph_of_path(&path)?.numbers(), [7, 9]);
    /// # std::fs::remove_file(&path)?;
    /// # Ok(()) }
    /// ```
    pub fn graph_of_path(&self, path: impl AsRef<Path>) -> Result<FileGraph, Error> {
        let path = path.as_ref();
        let named = |error: Error| error.in_file(path.display().to_string());
        let file = crate::files::open_regular(path).map_err(named)?;
        let size = file.metadata().map_or(0, |metadata| metadata.len());
        let name = crate::counted_stream::name_of(path);
        self.graph(crate::counted_stream::reading(&name, file, size)).map_err(named)
    }

    /// The graph of a stream: GraphML, a NumPy array, a matrix in the coordinate format of Matrix Market, or text of lines `u v value` with blanks, tabs, commas or semicolons between them.
    ///
    /// A line `u v` is an edge that enters at 1, `u u value` gives the value at which a vertex enters, and `u` is a vertex by itself. Vertices are whole
    /// numbers from 0 on, or names, in quotes where separators are in them. A vertex without a value enters at 0, or with its first edge if that is sooner. An
    /// edge that is given twice enters at the smaller value, and a remark says so. A first line of words is a header, whose column `weight`, `value`, `distance`
    /// or `length` has the values. Lines that begin with `#`, `%` or `//` are passed over. Behind a line `dim 0` stand the values of vertices, and behind `dim
    /// 1` edges, as in files of flagser.
    ///
    /// A matrix is square, of numbers or a pattern. Row i is vertex i - 1, since vertices count from 0 here; an entry is an edge from its row to its column, in
    /// both directions in a symmetric matrix, and the diagonal has the values of vertices.
    ///
    /// # Errors
    /// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) or [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) with the line of what is no
    /// edge, of a value that is not finite, of a second value of a vertex, or of an edge that enters before one of its vertices.
    ///
    /// # Complexity
    /// $O(n \log n)$ for n lines.
    ///
    /// # References
    /// U. Brandes, M. Eiglsperger, J. Lerner, *GraphML Primer*; D. Luetgehetmann, *Documentation of flagser* (2019), for lines `dim`.
    ///
    /// # Examples
    /// See [`FileGraph`].
    pub fn graph(&self, input: impl Read) -> Result<FileGraph, Error> {
        FileGraph::read(input, self.directed)
    }

    /// The graph of a table with rows `u v value`, `u v`, `u u value` and `u`.
    ///
    /// # Errors
    /// As of [`Self::graph`].
    ///
    /// # Examples
    /// ```
    /// use coface_io::{FlagReading, NumberTable};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let graph = FlagReading::default().graph_of_table(&NumberTable::from_rows([[5.0, 6.0]]))?;
    /// assert_eq!(graph.graph().edges(), [(1, 0, 1.0)]);
    /// # Ok(()) }
    /// ```
    pub fn graph_of_table(&self, table: &NumberTable) -> Result<FileGraph, Error> {
        FileGraph::of_table(table, self.directed)
    }

    /// The flag complex of a graph as a model, as [`ReadOptions::flag`] says.
    ///
    /// # Errors
    /// Those of [`FilteredComplex::flag`].
    ///
    /// # Examples
    /// See [`FlagReading`].
    pub fn model(&self, graph: &FileGraph) -> Result<Model, Error> {
        let threshold = self.threshold.unwrap_or(f64::INFINITY);
        let dimension = self.dimension.unwrap_or(DIMENSION);
        let mut remarks = graph.remarks().to_vec();
        if self.directed {
            let complex = DirectedFlagComplex::new(&graph.digraph(), threshold, dimension)?;
            remarks.extend(skeleton_remark(self.dimension, complex.complex().dimension()));
            let structure = Some(Structure::Chains(complex.complex().chain_complex()?));
            return Ok(ModelParts { structure, remarks, ..ModelParts::default() }.into_model());
        }
        let complex = FilteredComplex::flag(&graph.graph(), threshold, dimension)?;
        remarks.extend(skeleton_remark(self.dimension, complex.complex().dimension()));
        let numbers = graph.numbers();
        Ok(model_with_numbers(&complex, &numbers, remarks))
    }
}

/// A remark on simplices that are left out because no dimension was given.
pub(crate) fn skeleton_remark(given: Option<usize>, found: Option<usize>) -> Option<Remark> {
    let is_assumed = given.is_none() && found == Some(DIMENSION);
    let message = format!(
        "simplices up to dimension {DIMENSION} were taken, so groups of degree {DIMENSION} are those of this skeleton: --dimension K takes those up to K"
    );
    is_assumed.then(|| Remark::new(RemarkCode::InputReading, message))
}

/// Files of Ripser are named by what they hold.
fn form_of_extension(path: &Path) -> Option<TableForm> {
    match path.extension().and_then(|extension| extension.to_str()) {
        Some("lower_distance_matrix") => Some(TableForm::Lower),
        Some("upper_distance_matrix") => Some(TableForm::Upper),
        Some("distance_matrix") => Some(TableForm::Square),
        _ => None,
    }
}
