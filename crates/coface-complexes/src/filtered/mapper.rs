//! Mapper: the nerve of clusters of points over overlapping intervals of a function.

use super::{FilteredComplex, WeightedGraph};
use crate::simplicial::FrozenComplex;
use coface_algebra::{Error, ErrorKind, RaggedArray, UnionFind};

/// A cover of the range of a function by intervals of one length, each of which overlaps the next: the range is cut into equal parts, and each is made longer at both ends.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct IntervalCover {
    count: usize,
    overlap: f64,
}

impl IntervalCover {
    /// So many intervals, of which each shares a part of its length with the next: the resolution and the gain of GUDHI's `MapperComplex`.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for no interval, more than 2^20, and an overlap that is not from 0 to 0.9.
    ///
    /// # Examples
    /// See [`MapperComplex`].
    pub fn new(count: usize, overlap: f64) -> Result<Self, Error> {
        if !(1..=MOST_INTERVALS).contains(&count) {
            return Err(Error::invalid(format!("{count} intervals are to cover a range"))
                .with_cure("give a number from 1 to 1048576"));
        }
        if !(0.0..=0.9).contains(&overlap) {
            return Err(Error::invalid(format!("intervals are to overlap by {overlap} of their length"))
                .with_cure("give a number from 0 to 0.9"));
        }
        Ok(Self { count, overlap })
    }

    /// The first and the last interval that each value is in.
    fn intervals(&self, values: &[f64]) -> Vec<(usize, usize)> {
        let least = values.iter().copied().fold(f64::INFINITY, f64::min);
        let most = values.iter().copied().fold(f64::NEG_INFINITY, f64::max);
        let last = (self.count - 1) as f64;
        // The range is cut into equal lengths, and each is made longer at both ends.
        let longer = self.overlap / (2.0 - 2.0 * self.overlap);
        let within = |&value: &f64| {
            // Halves do not overflow.
            let share = (value * 0.5 - least * 0.5) / (most * 0.5 - least * 0.5);
            if share.is_nan() {
                return (0, 0);
            }
            let place = share * self.count as f64;
            let first = (place - 1.0 - longer).ceil().clamp(0.0, last);
            let end = (place + longer).floor().clamp(first, last);
            (first as usize, end as usize)
        };
        values.iter().map(within).collect()
    }
}

/// The most intervals of a cover.
const MOST_INTERVALS: usize = 1 << 20;

/// The Mapper complex of a function on the vertices of a graph: its vertices are the clusters, the connected components of the graph over each interval of a cover of
/// the function's range; a simplex is a set of clusters that have a vertex of the graph in common.
///
/// As a [`FilteredComplex`] a cluster enters at the mean of the function over it, and a simplex with its last cluster.
///
/// # References
/// G. Singh, F. Mémoli, G. Carlsson, *Topological methods for the analysis of high dimensional data sets and 3D object recognition* (2007).
///
/// # Examples
/// A circle of eight points and the height over three intervals: one cluster below, two beside each other, one above.
/// ```
/// use coface_complexes::filtered::{IntervalCover, MapperComplex, WeightedGraph};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let circle = WeightedGraph::new(vec![0.0; 8], (0..8).map(|i| (i, (i + 1) % 8, 1.0)))?;
/// let height = [-2.0, -0.5, 0.0, 0.5, 2.0, 0.5, 0.0, -0.5];
/// let mapper = MapperComplex::new(&circle, &height, &IntervalCover::new(3, 0.25)?)?;
/// assert_eq!(mapper.complex().complex().f_vector(), [4, 4]);
/// assert_eq!(mapper.clusters().iter().collect::<Vec<_>>(), [[0, 1, 7], [1, 2, 3], [5, 6, 7], [3, 4, 5]]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MapperComplex {
    clusters: RaggedArray,
    complex: FilteredComplex,
}

impl MapperComplex {
    /// The complex of a graph and the values of a function on its vertices.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there is one value for each vertex; [`ErrorKind::InvalidInput`] naming a value that is not finite; [`ErrorKind::TooLarge`] and
    /// those of [`FrozenComplex::from_facets`] where points are in too many intervals.
    ///
    /// # Complexity
    /// $O((n + m) k)$ for n vertices and m edges, where a point is in k intervals, and that of [`FrozenComplex::from_facets`] of n sets of k clusters.
    ///
    /// # Examples
    /// See [`MapperComplex`].
    pub fn new(graph: &WeightedGraph, values: &[f64], cover: &IntervalCover) -> Result<Self, Error> {
        let count = graph.vertex_count();
        if values.len() != count {
            return Err(Error::new(ErrorKind::Shape, format!("{} values for {count} points", values.len()))
                .with_cure("give one value for each point"));
        }
        if let Some(bad) = values.iter().position(|value| !value.is_finite()) {
            return Err(Error::invalid(format!("the value of point {bad} is {}", values[bad]))
                .with_cure("give finite values"));
        }
        let within = cover.intervals(values);
        // A point stands once for each of its intervals.
        let mut starts = vec![0];
        for &(first, last) in &within {
            starts.push(starts.last().expect("the first start") + last - first + 1);
        }
        let stand = |point: usize, interval: usize| starts[point] + interval - within[point].0;
        if starts[count] > u32::MAX as usize {
            let message = format!("{count} points are in {} intervals together, too many", starts[count]);
            return Err(Error::new(ErrorKind::TooLarge, message).with_cure("let intervals overlap less"));
        }
        let mut joined = UnionFind::new(starts[count]);
        for &(i, j, _) in graph.edges() {
            let [i, j] = [i, j].map(|point| point as usize);
            for interval in within[i].0.max(within[j].0)..=within[i].1.min(within[j].1) {
                joined.unite(stand(i, interval) as u32, stand(j, interval) as u32);
            }
        }
        // Clusters in the order of intervals, and of their first points.
        let mut order: Vec<(usize, usize)> = (0..count)
            .flat_map(|point| (within[point].0..=within[point].1).map(move |interval| (interval, point)))
            .collect();
        order.sort_unstable();
        let mut cluster_of: Vec<Option<usize>> = vec![None; starts[count]];
        let mut lists: Vec<Vec<u32>> = Vec::new();
        let mut sets: Vec<Vec<u32>> = vec![Vec::new(); count];
        for (interval, point) in order {
            let root = joined.find(stand(point, interval) as u32) as usize;
            let cluster = *cluster_of[root].get_or_insert_with(|| {
                lists.push(Vec::new());
                lists.len() - 1
            });
            lists[cluster].push(point as u32);
            sets[point].push(cluster as u32);
        }
        sets.sort_unstable();
        sets.dedup();
        let complex = FrozenComplex::from_facets(&RaggedArray::from_lists(&sets))?;
        let mean = |points: &Vec<u32>| {
            let share = 1.0 / points.len() as f64;
            points.iter().map(|&point| values[point as usize] * share).sum::<f64>()
        };
        let means: Vec<f64> = lists.iter().map(mean).collect();
        let degrees = 0..complex.f_vector().len();
        let entered = degrees.map(|degree| {
            let last = |simplex: &[u32]| {
                simplex.iter().map(|&cluster| means[cluster as usize]).fold(f64::NEG_INFINITY, f64::max)
            };
            complex.flat(degree).chunks(degree + 1).map(last).collect()
        });
        let entered = entered.collect();
        Ok(Self {
            clusters: RaggedArray::from_lists(&lists),
            complex: FilteredComplex::from_trusted_parts(complex, entered),
        })
    }

    /// The points of each cluster, rising; clusters in the order of their intervals, and of their first points.
    ///
    /// # Examples
    /// See [`MapperComplex`].
    pub fn clusters(&self) -> &RaggedArray {
        &self.clusters
    }

    /// The nerve, whose vertices are the clusters.
    ///
    /// # Examples
    /// See [`MapperComplex`].
    pub fn complex(&self) -> &FilteredComplex {
        &self.complex
    }

    /// The nerve by itself.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::MapperComplex;
    /// assert!(MapperComplex::default().into_complex().complex().is_empty());
    /// ```
    pub fn into_complex(self) -> FilteredComplex {
        self.complex
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    #[test]
    fn one_interval_is_the_components() {
        let graph = WeightedGraph::new(vec![0.0; 4], [(0, 2, 1.0), (1, 3, 1.0)]).unwrap();
        let one = IntervalCover::new(1, 0.0).unwrap();
        let found = MapperComplex::new(&graph, &[5.0, 1.0, 7.0, 1.0], &one).unwrap();
        assert_eq!(found.complex().complex().f_vector(), [2]);
        assert_eq!(found.complex().values(0), [6.0, 1.0]);
        // A function of one value is in all intervals that its place is in, the first.
        let three = IntervalCover::new(3, 0.25).unwrap();
        assert_eq!(MapperComplex::new(&graph, &[2.0; 4], &three).unwrap().clusters().len(), 2);
        let nothing = WeightedGraph::new(Vec::new(), []).unwrap();
        assert!(MapperComplex::new(&nothing, &[], &three).unwrap().clusters().is_empty());
    }

    #[test]
    fn faults_are_named() {
        let graph = WeightedGraph::new(vec![0.0; 2], []).unwrap();
        let cover = IntervalCover::new(2, 0.5).unwrap();
        let fault = |values: &[f64]| MapperComplex::new(&graph, values, &cover).unwrap_err().to_string();
        assert!(fault(&[1.0]).contains("1 values for 2 points"));
        assert!(fault(&[1.0, f64::NAN]).contains("the value of point 1 is NaN"));
        for (count, overlap) in [(0, 0.5), (2, 1.0), (2, -0.1), (2, f64::NAN), (1 << 21, 0.0)] {
            assert!(IntervalCover::new(count, overlap).is_err());
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(200))]
        /// Invariant 125: components over each interval, by walking; sets of clusters with a common point.
        #[test]
        fn clusters_are_components_over_intervals(
            values in prop::collection::vec(0i32..20, 1..12),
            edges in prop::collection::vec((0usize..12, 0usize..12), 0..20),
            count in 1usize..6,
            overlap in prop::sample::select(vec![0.0, 0.25, 0.5, 0.75]),
        ) {
            let n = values.len();
            let values: Vec<f64> = values.into_iter().map(f64::from).collect();
            let edges: BTreeSet<(usize, usize)> =
                edges.into_iter().map(|(i, j)| (i % n, j % n)).filter(|(i, j)| i < j).collect();
            let graph =
                WeightedGraph::new(vec![0.0; n], edges.iter().map(|&(i, j)| (i, j, 1.0))).unwrap();
            let found = MapperComplex::new(&graph, &values, &IntervalCover::new(count, overlap).unwrap()).unwrap();
            let least = values.iter().copied().fold(f64::INFINITY, f64::min);
            let range = values.iter().copied().fold(0.0, f64::max) - least;
            let part = range / count as f64;
            let longer = part * overlap / (2.0 - 2.0 * overlap);
            let mut clusters: Vec<Vec<u32>> = Vec::new();
            for interval in 0..count {
                let start = least + interval as f64 * part - longer;
                let length = part + 2.0 * longer;
                let is_in = |point: usize| {
                    let place = values[point];
                    // Where ends are rounded, this has a little more than the intervals.
                    place >= start - 1e-9 && place <= start + length + 1e-9
                };
                let at_end = |point: usize| {
                    let place = values[point];
                    (place - start).abs() < 1e-9 || (place - start - length).abs() < 1e-9
                };
                // Ends that fall on points may be either way by rounding; without overlap those of the range are inside.
                let is_either = |point: usize| {
                    at_end(point) && (overlap > 0.0 || values[point] != least && values[point] != least + range)
                };
                prop_assume!(range == 0.0 || !(0..n).any(is_either));
                if range == 0.0 && interval > 0 {
                    break;
                }
                let mut left: BTreeSet<usize> = (0..n).filter(|&point| is_in(point)).collect();
                while let Some(first) = left.pop_first() {
                    let mut cluster = vec![first];
                    let mut at = 0;
                    while at < cluster.len() {
                        let here = cluster[at];
                        at += 1;
                        let next: Vec<usize> = left
                            .iter()
                            .copied()
                            .filter(|&q| edges.contains(&(here.min(q), here.max(q))))
                            .collect();
                        for q in next {
                            left.remove(&q);
                            cluster.push(q);
                        }
                    }
                    cluster.sort_unstable();
                    clusters.push(cluster.into_iter().map(|point| point as u32).collect());
                }
            }
            prop_assert_eq!(found.clusters().iter().map(<[u32]>::to_vec).collect::<Vec<_>>(), clusters.clone());
            let complex = found.complex().complex();
            complex.check().unwrap();
            for degree in 1..complex.f_vector().len() {
                for simplex in complex.flat(degree).chunks(degree + 1) {
                    let common = |point: &u32| simplex.iter().all(|&c| clusters[c as usize].contains(point));
                    prop_assert!((0..n as u32).any(|point| common(&point)));
                }
            }
            for i in 0..clusters.len() {
                for j in 0..i {
                    let meet = clusters[i].iter().any(|point| clusters[j].contains(point));
                    prop_assert_eq!(complex.index_of(&[j as u32, i as u32]).is_some(), meet);
                }
            }
        }
    }
}
