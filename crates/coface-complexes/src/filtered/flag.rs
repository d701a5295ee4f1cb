//! Flag complexes of graphs with values.

use super::{FilteredComplex, WeightedGraph};
use crate::simplicial::{FrozenComplex, FrozenLevels};
use coface_algebra::progress::stage;
use coface_algebra::{Error, ErrorKind, memory};

impl FilteredComplex {
    /// The flag complex of a graph: a simplex for each set of vertices of which each two are joined, up to a dimension and up to a value. It enters at the largest
    /// value of its edges, a vertex at its own.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a threshold that is no number. [`ErrorKind::TooLarge`] for more than 2^28 simplices, or more than the memory that is
    /// free would hold, with the threshold up to which they fit.
    ///
    /// # Complexity
    /// A simplex takes time proportional to the vertices that are joined to all of its own but the last.
    ///
    /// # References
    /// A. Zomorodian, *Fast construction of the Vietoris-Rips complex* (2010), section 4.2.
    ///
    /// # Examples
    /// Four points of which each two are joined, without the tetrahedron.
    /// ```
    /// use coface_complexes::filtered::{FilteredComplex, WeightedGraph};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = (0..4).flat_map(|i| (0..i).map(move |j| (i, j, 1.0)));
    /// let graph = WeightedGraph::new(vec![0.0; 4], edges)?;
    /// assert_eq!(FilteredComplex::flag(&graph, 2.0, 2)?.complex().f_vector(), [4, 6, 4]);
    /// assert_eq!(FilteredComplex::flag(&graph, 0.5, 2)?.complex().f_vector(), [4]);
    /// # Ok(()) }
    /// ```
    pub fn flag(graph: &WeightedGraph, threshold: f64, dimension: usize) -> Result<Self, Error> {
        let most = most_simplices(bytes_of_simplex(dimension));
        Self::flag_of_at_most(graph, threshold, dimension, most)
    }

    /// As [`Self::flag`], of at most so many simplices.
    pub(super) fn flag_of_at_most(
        graph: &WeightedGraph,
        threshold: f64,
        dimension: usize,
        most: usize,
    ) -> Result<Self, Error> {
        if threshold.is_nan() {
            return Err(Error::invalid("the threshold is NaN").with_cure("give a number"));
        }
        let _steps = stage("joining vertices", 0);
        if may_exceed(graph, threshold, dimension, most) {
            return Err(too_many(graph, threshold, dimension, most));
        }
        let mut walk = Walk::new(graph, threshold, dimension, most);
        let whole = std::mem::take(&mut walk.vertices);
        match walk.grow(0, &whole) {
            Some(()) => {
                let (complex, values) = (FrozenComplex::from_levels(walk.levels), walk.values);
                Ok(Self::from_trusted_parts(complex, values))
            }
            None => Err(too_many(graph, threshold, dimension, most)),
        }
    }
}

/// About how many bytes a simplex takes, with its boundary and what questions keep of it, as measured.
pub(super) fn bytes_of_simplex(dimension: usize) -> u64 {
    100 + 24 * (dimension as u64 + 1)
}

/// How many simplices of so many bytes there may be.
pub(super) fn most_simplices(bytes: u64) -> usize {
    let fitting = memory::free().map_or(u64::MAX, |free| free / bytes);
    fitting.min(1 << 28) as usize
}

/// The simplices in lexicographic order.
struct Walk {
    /// For each vertex the larger ones that it is joined to, rising, with the values.
    larger: Vec<Vec<(u32, f64)>>,
    vertices: Vec<(u32, f64)>,
    dimension: usize,
    most: usize,
    count: usize,
    levels: FrozenLevels,
    values: Vec<Vec<f64>>,
    path: Vec<u32>,
}

impl Walk {
    fn new(graph: &WeightedGraph, threshold: f64, dimension: usize, most: usize) -> Self {
        let mut larger = vec![Vec::new(); graph.vertex_count()];
        // Sorted by the larger vertex: lists rise.
        for &(i, j, value) in graph.edges().iter().filter(|edge| edge.2 <= threshold) {
            larger[j as usize].push((i, value));
        }
        let births = graph.births().iter().enumerate();
        let vertices =
            births.filter(|birth| *birth.1 <= threshold).map(|(vertex, &birth)| (vertex as u32, birth));
        let (levels, values, path) = (FrozenLevels::default(), Vec::new(), Vec::new());
        Self { larger, vertices: vertices.collect(), dimension, most, count: 0, levels, values, path }
    }

    /// Adds the simplices that begin with the path, each with one more vertex of `joined`, which are joined to all of the path, and the values at which
    /// they enter; `None` if there are too many.
    fn grow(&mut self, degree: usize, joined: &[(u32, f64)]) -> Option<()> {
        self.count += joined.len();
        if self.count > self.most {
            return None;
        }
        if self.values.len() == degree && !joined.is_empty() {
            self.values.push(Vec::new());
        }
        let mut next = Vec::new();
        for (place, &(vertex, value)) in joined.iter().enumerate() {
            self.path.push(vertex);
            self.levels.push(&self.path);
            self.values[degree].push(value);
            if degree < self.dimension {
                next.clear();
                let rest = &joined[place + 1..];
                common(rest, &self.larger[vertex as usize], |other, one, edge| {
                    // Values of vertices are no more than those of their edges.
                    let all = if degree == 0 { edge } else { one.max(edge).max(value) };
                    next.push((other, all));
                });
                self.grow(degree + 1, &next)?;
            }
            self.path.pop();
        }
        Some(())
    }
}

/// Calls with each vertex of both lists, which rise, and its two values.
pub(super) fn common(one: &[(u32, f64)], other: &[(u32, f64)], mut visit: impl FnMut(u32, f64, f64)) {
    let (mut i, mut j) = (0, 0);
    while let (Some(&(a, first)), Some(&(b, second))) = (one.get(i), other.get(j)) {
        match a.cmp(&b) {
            std::cmp::Ordering::Less => i += 1,
            std::cmp::Ordering::Greater => j += 1,
            std::cmp::Ordering::Equal => {
                visit(a, first, second);
                i += 1;
                j += 1;
            }
        }
    }
}

/// Whether there are more simplices than `most`: counted before any is stored, where bounds leave that open and there are few vertices. If this says no, there may
/// be more all the same.
fn may_exceed(graph: &WeightedGraph, threshold: f64, dimension: usize, most: usize) -> bool {
    let edges = || graph.edges().iter().filter(|edge| edge.2 <= threshold);
    let vertex_count = graph.vertex_count();
    let edge_count = edges().count();
    // Each simplex of degree 2 or more is an edge and others of the rest.
    let bound = (2..=dimension).map(|degree| (vertex_count as f64).powi(degree as i32 - 1)).sum::<f64>();
    if vertex_count > MOST_ROWS || edge_count as f64 * bound <= most as f64 {
        return false;
    }
    let mut near = Rows::new(vertex_count);
    let mut count = 0;
    edges().any(|&(i, j, _)| {
        count = near.with_edge(i, j, dimension, count, most);
        count > most
    })
}

/// The error of more simplices than there may be, with a threshold that fits.
fn too_many(graph: &WeightedGraph, threshold: f64, dimension: usize, most: usize) -> Error {
    let at = if threshold.is_finite() { format!(" at the threshold {threshold}") } else { String::new() };
    let message = format!(
        "the flag complex of {} vertices up to dimension {dimension} has more than {most} simplices{at}, and there is room for no more",
        graph.vertex_count()
    );
    let error = Error::new(ErrorKind::TooLarge, message);
    match FlagLimit::of(graph, dimension, most) {
        Some(FlagLimit { threshold: fitting, count }) => error.with_cure(format!(
            "ask for a threshold of {fitting} or less (--threshold {fitting}), with {count} simplices, for a lower dimension, or allow more memory"
        )),
        None => error.with_cure("ask for a lower dimension, take fewer vertices, or allow more memory"),
    }
}

/// The largest value of an edge up to which a flag complex has at most so many simplices.
pub(super) struct FlagLimit {
    pub(super) threshold: f64,
    pub(super) count: usize,
}

impl FlagLimit {
    /// The limit of a graph up to a dimension; `None` if the vertices alone are too many, or the first edges.
    pub(super) fn of(graph: &WeightedGraph, dimension: usize, most: usize) -> Option<Self> {
        if dimension == 0 {
            return None;
        }
        let mut edges: Vec<(u32, u32, f64)> = graph.edges().to_vec();
        edges.sort_by(|a, b| a.2.total_cmp(&b.2));
        if graph.vertex_count() <= MOST_ROWS {
            return Self::by_rows(&edges, graph.vertex_count(), dimension, most);
        }
        Self::by_lists(&edges, graph.vertex_count(), dimension, most)
    }

    fn by_lists(
        edges: &[(u32, u32, f64)],
        vertex_count: usize,
        dimension: usize,
        most: usize,
    ) -> Option<Self> {
        // As many vertices as there are: those that enter later are counted too.
        let mut count = vertex_count;
        let mut near: Vec<Vec<(u32, f64)>> = vec![Vec::new(); vertex_count];
        let mut fitting = None;
        for run in edges.chunk_by(|a, b| a.2 == b.2) {
            for &(i, j, value) in run {
                let mut both = Vec::new();
                common(&near[i as usize], &near[j as usize], |vertex, _, _| both.push(vertex));
                count = count.saturating_add(1);
                if dimension > 1 {
                    count = cliques(&near, &both, dimension - 1, count, most);
                }
                if count > most {
                    return fitting;
                }
                for (one, other) in [(i, j), (j, i)] {
                    let list = &mut near[one as usize];
                    let place = list.partition_point(|&(vertex, _)| vertex < other);
                    list.insert(place, (other, value));
                }
            }
            fitting = Some(Self { threshold: run[0].2, count });
        }
        fitting
    }

    /// The same with the neighbors of each vertex as bits.
    fn by_rows(
        edges: &[(u32, u32, f64)],
        vertex_count: usize,
        dimension: usize,
        most: usize,
    ) -> Option<Self> {
        let mut count = vertex_count;
        let mut near = Rows::new(vertex_count);
        let mut fitting = None;
        for run in edges.chunk_by(|a, b| a.2 == b.2) {
            for &(i, j, _) in run {
                count = near.with_edge(i, j, dimension, count, most);
                if count > most {
                    return fitting;
                }
            }
            fitting = Some(Self { threshold: run[0].2, count });
        }
        fitting
    }
}

/// Up to so many vertices their neighbors are bits: 32 MiB.
const MOST_ROWS: usize = 1 << 14;

/// The neighbors of each vertex as bits.
struct Rows {
    width: usize,
    bits: Vec<u64>,
}

impl Rows {
    fn new(vertex_count: usize) -> Self {
        let width = vertex_count.div_ceil(64);
        Self { width, bits: vec![0; width * vertex_count] }
    }

    fn row(&self, vertex: u32) -> &[u64] {
        &self.bits[vertex as usize * self.width..][..self.width]
    }

    /// Adds an edge; gives the count with the simplices that it makes, which is no more looked at once it exceeds `most`.
    fn with_edge(&mut self, i: u32, j: u32, dimension: usize, count: usize, most: usize) -> usize {
        let mut count = count.saturating_add(1);
        if dimension > 1 {
            let both: Vec<u64> = self.row(i).iter().zip(self.row(j)).map(|(a, b)| a & b).collect();
            count = self.cliques(&both, dimension - 1, count, most);
        }
        for (one, other) in [(i, j), (j, i)] {
            self.bits[one as usize * self.width + other as usize / 64] |= 1 << (other % 64);
        }
        count
    }

    /// Adds the number of sets of at most `size` of these vertices that are joined.
    fn cliques(&self, of: &[u64], size: usize, mut count: usize, most: usize) -> usize {
        count = count.saturating_add(of.iter().map(|word| word.count_ones() as usize).sum());
        if size == 1 {
            return count;
        }
        for (place, &word) in of.iter().enumerate() {
            let mut left = word;
            while left != 0 && count <= most {
                let bit = left.trailing_zeros();
                left &= left - 1;
                let row = self.row(place as u32 * 64 + bit);
                // Those behind this vertex.
                let mut rest: Vec<u64> = of.iter().zip(row).map(|(a, b)| a & b).collect();
                rest[..place].fill(0);
                rest[place] &= !0u64 << bit & !(1 << bit);
                if rest.iter().any(|&word| word != 0) {
                    count = self.cliques(&rest, size - 1, count, most);
                }
            }
        }
        count
    }
}

/// The count with the sets of at most `size` of these vertices of which each two are joined; more than `most` ends it.
fn cliques(near: &[Vec<(u32, f64)>], of: &[u32], size: usize, mut count: usize, most: usize) -> usize {
    count = count.saturating_add(of.len());
    if size == 1 {
        return count;
    }
    for (place, &vertex) in of.iter().enumerate() {
        if count > most {
            break;
        }
        let list = &near[vertex as usize];
        let joined = |other: &&u32| list.binary_search_by_key(*other, |&(vertex, _)| vertex).is_ok();
        let rest: Vec<u32> = of[place + 1..].iter().filter(joined).copied().collect();
        if !rest.is_empty() {
            count = cliques(near, &rest, size - 1, count, most);
        }
    }
    count
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn graph() -> impl Strategy<Value = WeightedGraph> {
        let births = prop::collection::vec(-2i8..3, 0..8);
        (births, prop::collection::vec(-2i8..6, 28)).prop_map(|(births, numbers)| {
            let count = births.len();
            let value =
                |i: usize, j: usize| f64::from(numbers[i * (i - 1) / 2 + j].max(births[i]).max(births[j]));
            let edges = (0..count).flat_map(|i| (0..i).map(move |j| (i, j)));
            let edges = edges.filter(|&(i, j)| value(i, j) < 5.0).map(|(i, j)| (i, j, value(i, j)));
            let edges: Vec<_> = edges.collect();
            WeightedGraph::new(births.iter().map(|&birth| birth.into()).collect(), edges).unwrap()
        })
    }

    /// Each set of vertices, looked at by itself.
    fn by_sets(graph: &WeightedGraph, threshold: f64, dimension: usize) -> Vec<(Vec<u32>, f64)> {
        let count = graph.vertex_count();
        let value = |i: usize, j: usize| match i == j {
            true => Some(graph.births()[i]),
            false => graph.edges().iter().find(|e| (e.0 as usize, e.1 as usize) == (i, j)).map(|e| e.2),
        };
        let mut found: Vec<(Vec<u32>, f64)> = Vec::new();
        for set in 1u32..1 << count {
            let members: Vec<usize> = (0..count).filter(|i| set >> i & 1 == 1).collect();
            let pairs =
                members.iter().flat_map(|&i| members.iter().map(move |&j| (i, j))).filter(|(i, j)| i >= j);
            let all: Option<Vec<f64>> = pairs.map(|(i, j)| value(i, j)).collect();
            let Some(all) = all else { continue };
            let enters = all.into_iter().fold(f64::NEG_INFINITY, f64::max);
            if members.len() <= dimension + 1 && enters <= threshold {
                found.push((members.into_iter().map(|i| i as u32).collect(), enters));
            }
        }
        found.sort_by(|a, b| a.0.len().cmp(&b.0.len()).then(a.0.cmp(&b.0)));
        found
    }

    fn listed(complex: &FilteredComplex) -> Vec<(Vec<u32>, f64)> {
        let degrees = 0..complex.complex().f_vector().len();
        let all = degrees.flat_map(|k| {
            complex
                .values(k)
                .iter()
                .enumerate()
                .map(move |(i, &value)| (complex.complex().numbers(k, i).to_vec(), value))
        });
        all.collect()
    }

    proptest! {
        #[test]
        fn flag_complexes_are_all_sets_that_are_joined(graph in graph(), threshold in -3i8..6, dimension in 0usize..5) {
            let complex = FilteredComplex::flag(&graph, threshold.into(), dimension).unwrap();
            complex.complex().check().unwrap();
            prop_assert_eq!(listed(&complex), by_sets(&graph, threshold.into(), dimension));
        }

        /// What is said to fit does.
        #[test]
        fn thresholds_of_refusals_fit(graph in graph(), dimension in 1usize..4, most in 0usize..40) {
            let whole = FilteredComplex::flag(&graph, f64::INFINITY, dimension).unwrap().complex().len();
            match FilteredComplex::flag_of_at_most(&graph, f64::INFINITY, dimension, most) {
                Ok(complex) => prop_assert!(whole <= most && complex.complex().len() == whole),
                Err(_) => {
                    prop_assert!(whole > most);
                    let mut edges = graph.edges().to_vec();
                    edges.sort_by(|a, b| a.2.total_cmp(&b.2));
                    let by_lists = FlagLimit::by_lists(&edges, graph.vertex_count(), dimension, most);
                    let found = FlagLimit::of(&graph, dimension, most);
                    let facts = |limit: &FlagLimit| (limit.threshold, limit.count);
                    prop_assert_eq!(by_lists.as_ref().map(facts), found.as_ref().map(facts));
                    if let Some(FlagLimit { threshold, count }) = found {
                        let part = FilteredComplex::flag_of_at_most(&graph, threshold, dimension, most).unwrap();
                        prop_assert!(part.complex().len() <= count && count <= most);
                    }
                }
            }
        }
    }
}
