//! Graphs whose vertices and edges have values.

use coface_algebra::Error;

/// A graph whose vertices and edges enter at values: an edge no sooner than its ends. Vertices are numbered from 0 on.
///
/// # Examples
/// A path of two edges, whose middle vertex comes last.
/// ```
/// use coface_complexes::filtered::WeightedGraph;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let path = WeightedGraph::new(vec![0.0, 2.0, 0.0], [(0, 1, 2.0), (1, 2, 3.0)])?;
/// assert_eq!((path.vertex_count(), path.edge_count()), (3, 2));
/// assert!(WeightedGraph::new(vec![0.0, 2.0], [(0, 1, 1.0)]).is_err());
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct WeightedGraph {
    births: Vec<f64>,
    /// Vertices i > j with the value, sorted.
    edges: Vec<(u32, u32, f64)>,
}

impl WeightedGraph {
    /// The graph with the values of its vertices, and edges as two vertices with a value.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) naming a value that is not finite, an edge with a vertex that there is not, from a
    /// vertex to itself, that enters before one of its ends, or that is given with two values.
    ///
    /// # Examples
    /// See [`WeightedGraph`].
    pub fn new(
        births: Vec<f64>,
        edges: impl IntoIterator<Item = (usize, usize, f64)>,
    ) -> Result<Self, Error> {
        let larger_first = |(i, j, value): (usize, usize, f64)| (i.max(j), i.min(j), value);
        let (births, edges) = checked(births, edges.into_iter().map(larger_first))?;
        Ok(Self { births, edges })
    }

    /// The graph of distances, in their order.
    pub(super) fn from_trusted_parts(births: Vec<f64>, edges: Vec<(u32, u32, f64)>) -> Self {
        Self { births, edges }
    }

    /// The number of vertices.
    ///
    /// # Examples
    /// See [`WeightedGraph`].
    pub fn vertex_count(&self) -> usize {
        self.births.len()
    }

    /// The number of edges.
    ///
    /// # Examples
    /// See [`WeightedGraph`].
    pub fn edge_count(&self) -> usize {
        self.edges.len()
    }

    /// The values at which the vertices enter.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::WeightedGraph;
    /// let graph = WeightedGraph::new(vec![0.0, 2.0], [(0, 1, 3.0)]).expect("an edge");
    /// assert_eq!((graph.births(), graph.edges()), (&[0.0, 2.0][..], &[(1, 0, 3.0)][..]));
    /// ```
    pub fn births(&self) -> &[f64] {
        &self.births
    }

    /// The edges, each with its larger vertex first, and the value at which it enters; in the order of the vertices.
    ///
    /// # Examples
    /// See [`Self::births`].
    pub fn edges(&self) -> &[(u32, u32, f64)] {
        &self.edges
    }
}

/// A graph whose edges have directions, and whose vertices and edges enter at values: an edge no sooner than its ends. Vertices are numbered from 0 on.
///
/// # Examples
/// Two vertices with edges in both directions.
/// ```
/// use coface_complexes::filtered::WeightedDigraph;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let both = WeightedDigraph::new(vec![0.0, 0.5], [(1, 0, 2.0), (0, 1, 3.0)])?;
/// assert_eq!((both.vertex_count(), both.births()), (2, &[0.0, 0.5][..]));
/// assert_eq!(both.edges(), [(0, 1, 3.0), (1, 0, 2.0)]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct WeightedDigraph {
    births: Vec<f64>,
    /// From, to and value, sorted.
    edges: Vec<(u32, u32, f64)>,
}

impl WeightedDigraph {
    /// The graph with the values of its vertices, and edges from a vertex to another with a value.
    ///
    /// # Errors
    /// As of [`WeightedGraph::new`].
    ///
    /// # Examples
    /// See [`WeightedDigraph`].
    pub fn new(
        births: Vec<f64>,
        edges: impl IntoIterator<Item = (usize, usize, f64)>,
    ) -> Result<Self, Error> {
        let (births, edges) = checked(births, edges)?;
        Ok(Self { births, edges })
    }

    /// The number of vertices.
    ///
    /// # Examples
    /// See [`WeightedDigraph`].
    pub fn vertex_count(&self) -> usize {
        self.births.len()
    }

    /// The values at which the vertices enter.
    ///
    /// # Examples
    /// See [`WeightedDigraph`].
    pub fn births(&self) -> &[f64] {
        &self.births
    }

    /// The edges, from a vertex to another, with the values at which they enter; in the order of the vertices.
    ///
    /// # Examples
    /// See [`WeightedDigraph`].
    pub fn edges(&self) -> &[(u32, u32, f64)] {
        &self.edges
    }
}

/// Values of vertices, and edges in their order, with one value each.
type CheckedGraph = (Vec<f64>, Vec<(u32, u32, f64)>);

fn checked(
    mut births: Vec<f64>,
    edges: impl IntoIterator<Item = (usize, usize, f64)>,
) -> Result<CheckedGraph, Error> {
    let finite = "give finite values";
    if let Some(vertex) = births.iter().position(|birth| !birth.is_finite()) {
        let message = format!("the value of vertex {vertex} is {}", births[vertex]);
        return Err(Error::invalid(message).with_cure(finite));
    }
    // A negative zero becomes a zero.
    births.iter_mut().for_each(|birth| *birth += 0.0);
    let mut known = Vec::new();
    for (i, j, value) in edges {
        let fault = |what: String, cure: &str| {
            Err(Error::invalid(format!("the edge of {i} and {j} {what}")).with_cure(cure))
        };
        if i.max(j) >= births.len() {
            return fault(format!("is of {} vertices", births.len()), "number vertices from 0 on");
        }
        if i == j {
            return fault("is a loop".to_owned(), "leave it out");
        }
        if !value.is_finite() {
            return fault(format!("has the value {value}"), finite);
        }
        let last = if births[i] < births[j] { j } else { i };
        if value < births[last] {
            return fault(
                format!("enters at {value}, before vertex {last}, at {}", births[last]),
                "give each edge at least the values of its vertices",
            );
        }
        known.push((i as u32, j as u32, value + 0.0));
    }
    known.sort_by(|a: &(u32, u32, f64), b| (a.0, a.1).cmp(&(b.0, b.1)).then(a.2.total_cmp(&b.2)));
    known.dedup();
    if let Some(two) = known.windows(2).find(|two| (two[0].0, two[0].1) == (two[1].0, two[1].1)) {
        let (i, j, value) = two[0];
        let message = format!("the edge of {i} and {j} has two values, {value} and {}", two[1].2);
        return Err(Error::invalid(message).with_cure("give each edge one value"));
    }
    Ok((births, known))
}
