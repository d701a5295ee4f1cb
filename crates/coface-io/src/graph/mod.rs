//! Graphs with values: edge lists and GraphML.
//!
//! * A [`FileGraph`] has the edges, and the numbers or names that vertices have in the file.
//! * An edge list is text, or a NumPy array. A square matrix of Matrix Market has an edge for each entry. GraphML is XML: the `id`s of its nodes are names, and the data of the key whose `attr.name` is `weight` are values.
//! * [`FlagReading`](crate::FlagReading) reads them.

mod edge_list;
#[cfg(feature = "xml")]
mod graphml;
mod rows;

use crate::matrix_market::{self, Relation};
use crate::stream_start::plain_bytes;
use crate::volume::NPY_MAGIC;
use crate::{NumberTable, Remark};
use coface_algebra::Error;
use coface_complexes::filtered::{WeightedDigraph, WeightedGraph};
use rows::Rows;
use std::io::Read;

/// A graph whose vertices and edges have values, with what vertices are called in the file.
///
/// # Examples
/// Three edges, one of them without a value, and the value of a vertex.
/// ```
/// use coface_io::FlagReading;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let graph = FlagReading::default().graph(&b"10 20 0.5\n20 30 2\n10 30\n30 30 0.25\n"[..])?;
/// assert_eq!(graph.numbers(), [10, 20, 30]);
/// assert_eq!(graph.graph().births(), [0.0, 0.0, 0.25]);
/// assert_eq!(graph.graph().edges(), [(1, 0, 0.5), (2, 0, 1.0), (2, 1, 2.0)]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct FileGraph {
    births: Vec<f64>,
    /// Each once: from, to and value.
    edges: Vec<(u32, u32, f64)>,
    labels: Labels,
    remarks: Vec<Remark>,
}

/// What vertices are called.
#[derive(Clone, Debug, PartialEq)]
enum Labels {
    Numbers(Vec<u32>),
    Names(Vec<String>),
}

impl FileGraph {
    /// The graph without directions.
    ///
    /// # Examples
    /// See [`FileGraph`].
    pub fn graph(&self) -> WeightedGraph {
        let mut edges: Vec<(usize, usize, f64)> =
            self.edges.iter().map(|&(i, j, value)| (i.max(j) as usize, i.min(j) as usize, value)).collect();
        // Of two directions the first.
        edges.sort_by(|a, b| (a.0, a.1).cmp(&(b.0, b.1)).then(a.2.total_cmp(&b.2)));
        edges.dedup_by_key(|edge| (edge.0, edge.1));
        WeightedGraph::new(self.births.clone(), edges).expect("edges that the reader has checked")
    }

    /// The graph with the directions of its edges.
    ///
    /// # Examples
    /// ```
    /// use coface_io::FlagReading;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let graph = FlagReading { directed: true, ..FlagReading::default() }.graph(&b"0 1 2\n1 0 3\n"[..])?;
    /// assert_eq!(graph.digraph().edges(), [(0, 1, 2.0), (1, 0, 3.0)]);
    /// # Ok(()) }
    /// ```
    pub fn digraph(&self) -> WeightedDigraph {
        let edges = self.edges.iter().map(|&(from, to, value)| (from as usize, to as usize, value));
        WeightedDigraph::new(self.births.clone(), edges).expect("edges that the reader has checked")
    }

    /// The numbers of the vertices in the file, rising; from 0 on where vertices have names.
    ///
    /// # Examples
    /// See [`FileGraph`].
    pub fn numbers(&self) -> Vec<u32> {
        match &self.labels {
            Labels::Numbers(numbers) => numbers.clone(),
            Labels::Names(names) => (0..names.len() as u32).collect(),
        }
    }

    /// The names of the vertices, in the order of the file; `None` where vertices have numbers.
    ///
    /// # Examples
    /// ```
    /// use coface_io::FlagReading;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let graph = FlagReading::default().graph(&b"source,target,weight\nBern,Thun,3\n"[..])?;
    /// assert_eq!(graph.names(), Some(&["Bern".to_owned(), "Thun".to_owned()][..]));
    /// # Ok(()) }
    /// ```
    pub fn names(&self) -> Option<&[String]> {
        match &self.labels {
            Labels::Numbers(_) => None,
            Labels::Names(names) => Some(names),
        }
    }

    /// What the reader assumed.
    ///
    /// # Examples
    /// ```
    /// use coface_io::FlagReading;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let graph = FlagReading::default().graph(&b"0 1 2\n1 0 3\n"[..])?;
    /// assert_eq!(graph.graph().edges(), [(1, 0, 2.0)]);
    /// assert!(graph.remarks()[0].message.contains("the smaller value"));
    /// # Ok(()) }
    /// ```
    pub fn remarks(&self) -> &[Remark] {
        &self.remarks
    }

    /// The graph of a stream, which may be compressed or in UTF-16.
    pub(crate) fn read(input: impl Read, directed: bool) -> Result<Self, Error> {
        let mut input = plain_bytes(input)?;
        let mut start = Vec::new();
        input.by_ref().take(matrix_market::START).read_to_end(&mut start)?;
        let is_array = start.starts_with(NPY_MAGIC);
        let is_matrix = matrix_market::is_matrix_market(&start);
        let first = start.trim_ascii_start().first().copied();
        let whole = std::io::Cursor::new(start).chain(input);
        if is_array {
            return Self::of_table(&NumberTable::read(whole)?.of_numbers_only()?, directed);
        }
        if is_matrix {
            return Self::of_matrix(&Relation::read(whole)?, directed);
        }
        if first == Some(b'<') {
            return graph_of_xml(whole, directed);
        }
        edge_list::rows(whole)?.graph(directed)
    }

    /// The graph of a square matrix: a vertex for each row, an edge for each entry beside the diagonal, on which the values of vertices stand.
    fn of_matrix(matrix: &Relation, directed: bool) -> Result<Self, Error> {
        let mut rows = Rows::default();
        for vertex in 0..matrix.count {
            rows.vertex(&vertex.to_string());
        }
        for entry in &matrix.entries {
            let (from, to) = (entry.row as u32, entry.column as u32);
            if from == to {
                rows.push_row(from, to, entry.value, Some(entry.line))?;
            } else {
                let value = entry.value.unwrap_or(1.0);
                rows.push_edge((from, to), value, Some(entry.line), matrix.is_symmetric)?;
            }
        }
        rows.graph(directed)
    }

    /// The graph of a table with rows `u v value`, `u v`, `u u value` and `u`.
    pub(crate) fn of_table(table: &NumberTable, directed: bool) -> Result<Self, Error> {
        let mut rows = Rows::default();
        for row in 0..table.row_count() {
            rows.push_numbers(table.row(row), table.line(row))?;
        }
        rows.graph(directed)
    }
}

#[cfg(feature = "xml")]
fn graph_of_xml(input: impl Read, directed: bool) -> Result<FileGraph, Error> {
    graphml::rows(input)?.graph(directed)
}

#[cfg(not(feature = "xml"))]
fn graph_of_xml(_input: impl Read, _directed: bool) -> Result<FileGraph, Error> {
    Err(crate::features::without_feature("GraphML", "xml"))
}
