//! Directed flag complexes of directed graphs.

use super::WeightedDigraph;
use super::flag::{bytes_of_simplex, common, most_simplices};
use crate::simplicial::DeltaComplex;
use coface_algebra::progress::stage;
use coface_algebra::{Error, ErrorKind};

/// The directed flag complex of a directed graph: a k-simplex for each list of k + 1 vertices that has an edge from each of them to each later one. It enters at the
/// largest value of its edges, a vertex at its own.
///
/// Several simplices may have the same vertices: two vertices with edges in both directions have two 1-simplices, which make a loop.
///
/// # Examples
/// Two edges in opposite directions are a circle; an edge from each vertex of it to a third one makes a cone.
/// ```
/// use coface_complexes::filtered::{DirectedFlagComplex, WeightedDigraph};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let graph = WeightedDigraph::new(vec![0.0; 3], [(0, 1, 1.0), (1, 0, 2.0), (0, 2, 3.0), (1, 2, 3.0)])?;
/// let circle = DirectedFlagComplex::new(&graph, 2.0, 2)?;
/// assert_eq!(circle.complex().f_vector(), [3, 2]);
/// let cone = DirectedFlagComplex::new(&graph, f64::INFINITY, 2)?;
/// assert_eq!((cone.simplex(2, 0), cone.simplex(2, 1)), (&[0, 1, 2][..], &[1, 0, 2][..]));
/// assert_eq!(cone.complex().chain_complex()?.euler_characteristic(), 1);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DirectedFlagComplex {
    complex: DeltaComplex,
    /// The simplices of each degree in lexicographic order.
    levels: Vec<Level>,
}

#[derive(Clone, Debug, Default, PartialEq)]
struct Level {
    /// The vertices of all simplices, one simplex after the other.
    tuples: Vec<u32>,
    values: Vec<f64>,
    /// Where the simplices of the next degree begin that begin with each.
    child_starts: Vec<u32>,
}

impl DirectedFlagComplex {
    /// The complex of a directed graph up to a value and a dimension.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a threshold that is no number; [`ErrorKind::TooLarge`] for more than 2^28 simplices, or more than the memory that is free would hold, with
    /// the threshold up to which they fit.
    ///
    /// # Complexity
    /// A simplex takes time proportional to the edges from its last vertex, and $O(k^2 \log n)$ for its faces.
    ///
    /// # References
    /// D. Luetgehetmann, D. Govc, J. Smith, R. Levi, *Computing persistent homology of directed flag complexes* (2020).
    ///
    /// # Examples
    /// See [`DirectedFlagComplex`].
    pub fn new(graph: &WeightedDigraph, threshold: f64, dimension: usize) -> Result<Self, Error> {
        Self::of_at_most(graph, threshold, dimension, most_simplices(bytes_of_simplex(dimension)))
    }

    /// As [`Self::new`], of at most so many simplices.
    fn of_at_most(
        graph: &WeightedDigraph,
        threshold: f64,
        dimension: usize,
        most: usize,
    ) -> Result<Self, Error> {
        if threshold.is_nan() {
            return Err(Error::invalid("the threshold is NaN").with_cure("give a number"));
        }
        let _steps = stage("joining vertices", 0);
        let Some(mut levels) = Walk::new(graph, threshold, dimension, most, true).levels() else {
            return Err(too_many(graph, threshold, dimension, most));
        };
        for k in 0..levels.len() {
            let children = levels.get(k + 1).map_or(0, |level| level.values.len());
            levels[k].child_starts.push(children as u32);
        }
        let mut made = Self { complex: DeltaComplex::default(), levels };
        let faces = (1..made.levels.len()).map(|degree| made.faces(degree)).collect();
        let vertex_count = made.levels.first().map_or(0, |level| level.values.len());
        made.complex = DeltaComplex::from_trusted_faces(vertex_count, faces);
        Ok(made)
    }

    /// The simplices with their faces: face i lacks vertex i.
    ///
    /// # Examples
    /// See [`DirectedFlagComplex`].
    pub fn complex(&self) -> &DeltaComplex {
        &self.complex
    }

    /// The vertices of a simplex in their order: there is an edge from each to each later one. Simplices are in lexicographic order.
    ///
    /// # Panics
    /// If there is no such simplex.
    ///
    /// # Examples
    /// See [`DirectedFlagComplex`].
    pub fn simplex(&self, degree: usize, i: usize) -> &[u32] {
        &self.levels[degree].tuples[i * (degree + 1)..][..=degree]
    }

    /// The values of the simplices of a degree. Empty beyond the dimension.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::{DirectedFlagComplex, WeightedDigraph};
    /// let edge = WeightedDigraph::new(vec![0.0, 0.5], [(0, 1, 1.0)]).expect("an edge");
    /// let edge = DirectedFlagComplex::new(&edge, f64::INFINITY, 3).expect("a small complex");
    /// assert_eq!((edge.values(0), edge.values(1), edge.values(2)), (&[0.0, 0.5][..], &[1.0][..], &[][..]));
    /// ```
    pub fn values(&self, degree: usize) -> &[f64] {
        self.levels.get(degree).map_or(&[], |level| &level.values)
    }

    /// The faces of all simplices of a degree, one simplex after the other.
    fn faces(&self, degree: usize) -> Vec<u32> {
        let mut faces = Vec::with_capacity(self.levels[degree].tuples.len());
        let mut face = Vec::with_capacity(degree);
        for tuple in self.levels[degree].tuples.chunks_exact(degree + 1) {
            for left in 0..=degree {
                face.clear();
                face.extend(
                    tuple.iter().enumerate().filter(|&(at, _)| at != left).map(|(_, &vertex)| vertex),
                );
                faces.push(self.place(&face) as u32);
            }
        }
        faces
    }

    /// The place of a simplex that there is.
    fn place(&self, tuple: &[u32]) -> usize {
        let vertices = &self.levels[0].tuples;
        let mut at = vertices.binary_search(&tuple[0]).expect("a vertex of a simplex");
        for (degree, &vertex) in tuple.iter().enumerate().skip(1) {
            let starts = &self.levels[degree - 1].child_starts;
            let (start, end) = (starts[at] as usize, starts[at + 1] as usize);
            let level = &self.levels[degree];
            let last = |i: usize| level.tuples[i * (degree + 1) + degree];
            let (mut low, mut high) = (start, end);
            while low < high {
                let middle = low.midpoint(high);
                if last(middle) < vertex {
                    low = middle + 1;
                } else {
                    high = middle;
                }
            }
            at = low;
        }
        at
    }
}

/// Goes through the simplices in lexicographic order.
struct Walk {
    /// For each vertex those that it has an edge to, rising, with the values.
    next: Vec<Vec<(u32, f64)>>,
    vertices: Vec<(u32, f64)>,
    dimension: usize,
    most: usize,
    count: usize,
    is_kept: bool,
    levels: Vec<Level>,
    path: Vec<u32>,
}

impl Walk {
    fn new(graph: &WeightedDigraph, threshold: f64, dimension: usize, most: usize, is_kept: bool) -> Self {
        let mut next = vec![Vec::new(); graph.vertex_count()];
        for &(from, to, value) in graph.edges().iter().filter(|edge| edge.2 <= threshold) {
            next[from as usize].push((to, value));
        }
        let births = graph.births().iter().enumerate();
        let vertices =
            births.filter(|birth| *birth.1 <= threshold).map(|(vertex, &birth)| (vertex as u32, birth));
        let vertices = vertices.collect();
        Self { next, vertices, dimension, most, count: 0, is_kept, levels: Vec::new(), path: Vec::new() }
    }

    /// The simplices; `None` if there are too many.
    fn levels(mut self) -> Option<Vec<Level>> {
        let vertices = std::mem::take(&mut self.vertices);
        self.grow(&vertices)?;
        Some(self.levels)
    }

    /// Adds the simplices that begin with the path, each with one more vertex of `joined`, and the values at which they enter.
    fn grow(&mut self, joined: &[(u32, f64)]) -> Option<()> {
        let degree = self.path.len();
        self.count += joined.len();
        if self.count > self.most {
            return None;
        }
        let mut behind = Vec::new();
        for &(vertex, value) in joined {
            self.path.push(vertex);
            if self.is_kept {
                self.keep(value);
            }
            if degree < self.dimension {
                behind.clear();
                if degree == 0 {
                    behind.extend_from_slice(&self.next[vertex as usize]);
                } else {
                    common(joined, &self.next[vertex as usize], |other, one, edge| {
                        behind.push((other, one.max(edge).max(value)));
                    });
                }
                self.grow(&behind)?;
            }
            self.path.pop();
        }
        Some(())
    }

    /// Keeps the path as a simplex.
    fn keep(&mut self, value: f64) {
        let degree = self.path.len() - 1;
        if self.levels.len() == degree {
            self.levels.push(Level::default());
        }
        let children = self.levels.get(degree + 1).map_or(0, |level| level.values.len());
        let level = &mut self.levels[degree];
        level.tuples.extend_from_slice(&self.path);
        level.values.push(value);
        level.child_starts.push(children as u32);
    }
}

/// How many thresholds are tried for one that fits.
const TRIES: usize = 12;

/// The error of more simplices than there may be, with a threshold that fits.
fn too_many(graph: &WeightedDigraph, threshold: f64, dimension: usize, most: usize) -> Error {
    let at = if threshold.is_finite() { format!(" at the threshold {threshold}") } else { String::new() };
    let message = format!(
        "the directed flag complex of {} vertices up to dimension {dimension} has more than {most} simplices{at}, and there is room for no more",
        graph.vertex_count()
    );
    let error = Error::new(ErrorKind::TooLarge, message);
    let mut values: Vec<f64> = graph.edges().iter().map(|edge| edge.2).collect();
    values.sort_by(f64::total_cmp);
    values.dedup();
    let (mut low, mut high) = (0, values.len());
    for _ in 0..TRIES {
        if low == high {
            break;
        }
        let middle = low.midpoint(high);
        let walk = Walk::new(graph, values[middle], dimension, most, false);
        if walk.levels().is_some() {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    match low.checked_sub(1) {
        Some(last) => {
            let fitting = values[last];
            error.with_cure(format!(
                "ask for a threshold of {fitting} or less (--threshold {fitting}), for a lower dimension, or allow more memory"
            ))
        }
        None => error.with_cure("ask for a lower dimension, take fewer vertices, or allow more memory"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Every list of different vertices, looked at by itself.
    fn by_lists(graph: &WeightedDigraph, threshold: f64, dimension: usize) -> Vec<(Vec<u32>, f64)> {
        let value = |from: u32, to: u32| graph.edges().iter().find(|e| (e.0, e.1) == (from, to)).map(|e| e.2);
        let mut found: Vec<(Vec<u32>, f64)> = Vec::new();
        let mut lists: Vec<Vec<u32>> = vec![Vec::new()];
        for _ in 0..=dimension {
            let longer = |list: &Vec<u32>| -> Vec<Vec<u32>> {
                (0..graph.vertex_count() as u32).map(|vertex| [&list[..], &[vertex]].concat()).collect()
            };
            lists = lists.iter().flat_map(longer).collect();
            lists.retain(|list| {
                let pairs = (0..list.len()).flat_map(|i| (i + 1..list.len()).map(move |j| (i, j)));
                let edges: Option<Vec<f64>> = pairs.map(|(i, j)| value(list[i], list[j])).collect();
                let births = list.iter().map(|&vertex| graph.births()[vertex as usize]);
                let all =
                    edges.map(|edges| edges.into_iter().chain(births).fold(f64::NEG_INFINITY, f64::max));
                match all.filter(|&all| all <= threshold) {
                    Some(all) => {
                        found.push((list.clone(), all));
                        true
                    }
                    None => false,
                }
            });
        }
        found
    }

    fn digraph() -> impl Strategy<Value = WeightedDigraph> {
        (1usize..6, prop::collection::vec(0u8..6, 30), prop::collection::vec(0u8..2, 6)).prop_map(
            |(count, numbers, births)| {
                let births: Vec<f64> = births[..count].iter().map(|&birth| birth.into()).collect();
                let pairs = (0..count).flat_map(|i| (0..count).filter(move |&j| i != j).map(move |j| (i, j)));
                let edges: Vec<(usize, usize, f64)> = pairs
                    .zip(&numbers)
                    .filter(|(_, number)| **number < 5)
                    .map(|((i, j), &number)| (i, j, f64::from(number).max(births[i]).max(births[j])))
                    .collect();
                WeightedDigraph::new(births, edges).unwrap()
            },
        )
    }

    proptest! {
        #[test]
        fn simplices_are_all_lists_that_are_joined(graph in digraph(), threshold in 0u8..6, dimension in 0usize..4) {
            let complex = DirectedFlagComplex::new(&graph, threshold.into(), dimension).unwrap();
            complex.complex().check().unwrap();
            let mut expected = by_lists(&graph, threshold.into(), dimension);
            expected.sort_by(|a, b| a.0.len().cmp(&b.0.len()).then(a.0.cmp(&b.0)));
            let degrees = 0..complex.levels.len();
            let found: Vec<(Vec<u32>, f64)> = degrees
                .flat_map(|k| complex.values(k).iter().enumerate().map(move |(i, &value)| (k, i, value)))
                .map(|(k, i, value)| (complex.simplex(k, i).to_vec(), value))
                .collect();
            prop_assert_eq!(found, expected);
            // Faces lack one vertex each.
            for degree in 1..complex.levels.len() {
                for i in 0..complex.values(degree).len() {
                    let faces = complex.complex().faces(degree, coface_algebra::CellId::new(i));
                    for (left, &face) in faces.iter().enumerate() {
                        let mut rest = complex.simplex(degree, i).to_vec();
                        rest.remove(left);
                        prop_assert_eq!(complex.simplex(degree - 1, face as usize), &rest[..]);
                        prop_assert!(complex.values(degree - 1)[face as usize] <= complex.values(degree)[i]);
                    }
                }
            }
        }

        /// What is said to fit does.
        #[test]
        fn too_large_complexes_are_refused(graph in digraph(), most in 0usize..30) {
            let whole: usize = DirectedFlagComplex::new(&graph, f64::INFINITY, 3).unwrap().complex().f_vector().iter().sum();
            let found = DirectedFlagComplex::of_at_most(&graph, f64::INFINITY, 3, most);
            prop_assert_eq!(found.is_ok(), whole <= most);
        }
    }

    #[test]
    fn complete_digraphs_have_all_lists() {
        let edges = (0..3).flat_map(|i| (0..3).filter(move |&j| i != j).map(move |j| (i, j, 1.0)));
        let graph = WeightedDigraph::new(vec![0.0; 3], edges).unwrap();
        let complex = DirectedFlagComplex::new(&graph, 1.0, 5).unwrap();
        assert_eq!(complex.complex().f_vector(), [3, 6, 6]);
        // Injective words on three letters: a wedge of two 2-spheres (F. D. Farmer, Cellular homology for posets, 1978).
        assert_eq!(complex.complex().chain_complex().unwrap().euler_characteristic(), 3);
    }
}
