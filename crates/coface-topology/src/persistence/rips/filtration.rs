//! Vietoris-Rips filtrations, and how large they are.

use super::diagram::{RipsCochain, RipsDiagram};
use super::near::{FAR, Lists, MOST_POINTS, Near, Square};
use super::reduction::{Numbered, Reduction};
use super::simplices::{Binomials, Simplex, Simplices};
use crate::homology::Coefficients;
use crate::persistence::reduction::prime;
use coface_algebra::progress::stage;
use coface_algebra::{Binary, Error, ErrorKind, Odd};
use coface_complexes::filtered::{Distances, FilteredComplex, WeightedGraph};
use rayon::prelude::*;

/// The Vietoris-Rips filtration of points: a simplex for each set of points, which enters at the largest distance of two of them, up to a
/// threshold.
///
/// # Examples
/// Three points in a row, of which the outer ones are 3 apart.
/// ```
/// use coface_complexes::filtered::Distances;
/// use coface_topology::{Coefficients, RipsFiltration};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let line = Distances::from_lower_triangle(3, vec![1.0, 3.0, 2.0])?;
/// let filtration = RipsFiltration::new(&line, None)?;
/// // From 2 on the point in the middle is near all others: nothing happens any more.
/// assert_eq!(filtration.threshold(), 2.0);
/// let diagram = filtration.persistence(1, Coefficients::Modulo(2))?;
/// let deaths: Vec<_> = diagram.pairs().map(|pair| pair.death()).collect();
/// assert_eq!(deaths, [None, Some(1.0), Some(2.0)]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct RipsFiltration {
    pub(super) count: usize,
    pub(super) threshold: f64,
    /// The different distances up to the threshold, rising, 0 first; of a graph the values of vertices and edges.
    pub(super) values: Vec<f64>,
    /// The ranks at which points enter; [`FAR`] beyond the threshold.
    pub(super) births: Vec<u32>,
    /// Pairs of points i > j with their ranks, as they enter.
    pub(super) edges: Vec<(u32, u32, u32)>,
}

/// How many simplices a Vietoris-Rips filtration has, and how much memory their persistence takes, as far as a sample shows.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct RipsSize {
    simplices: Vec<f64>,
    bytes: f64,
}

impl RipsSize {
    /// About how many simplices there are, by degree.
    ///
    /// # Examples
    /// See [`RipsFiltration::size`].
    pub fn simplices(&self) -> &[f64] {
        &self.simplices
    }

    /// About how many bytes of memory are used.
    ///
    /// # Examples
    /// See [`RipsFiltration::size`].
    pub fn bytes(&self) -> f64 {
        self.bytes
    }
}

/// So many simplices of a degree are looked at to find how many there are.
const SAMPLE: usize = 1000;

impl RipsFiltration {
    /// The filtration up to a threshold; without one, up to the [enclosing radius](Distances::enclosing_radius), where all later simplices
    /// change nothing, or to the largest finite distance if there is none.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a threshold that is negative or no number.
    ///
    /// # Complexity
    /// n log n for n distances up to the threshold.
    ///
    /// # Examples
    /// See [`RipsFiltration`].
    pub fn new(distances: &Distances, threshold: Option<f64>) -> Result<Self, Error> {
        if let Some(threshold) = threshold.filter(|threshold| threshold.is_nan() || *threshold < 0.0) {
            return Err(Error::invalid(format!(
                "the threshold is {threshold}, and distances are not negative"
            ))
            .with_cure("give a threshold of 0 or more"));
        }
        let _steps = stage("sorting distances", 0);
        let threshold = threshold.unwrap_or_else(|| distances.whole_threshold());
        let mut pairs: Vec<(f64, u32, u32)> = Vec::with_capacity(edges_within(distances, threshold));
        distances.each(|i, j, distance| {
            if distance <= threshold && distance.is_finite() {
                pairs.push((distance, i as u32, j as u32));
            }
        });
        // Of one length the larger index first: by i, then j.
        pairs.par_sort_unstable_by(|a, b| a.0.total_cmp(&b.0).then((b.1, b.2).cmp(&(a.1, a.2))));
        // With room for the different ones: a list that grows takes three times as much for a while.
        let different = pairs.windows(2).filter(|two| two[0].0 < two[1].0).count();
        let mut values = Vec::with_capacity(different + 2);
        values.push(0.0);
        let edges = pairs.into_iter().map(|(distance, i, j)| {
            if values.last().is_some_and(|&last| distance > last) {
                values.push(distance);
            }
            (i, j, (values.len() - 1) as u32)
        });
        let edges = edges.collect();
        let count = distances.point_count();
        Ok(Self { count, threshold, values, births: vec![0; count], edges })
    }

    /// The filtration of the flag complex of a graph up to a threshold, or of all of it: a simplex for each set of vertices of which each two are joined, which
    /// enters at the largest value of an edge, a vertex at its own.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a threshold that is no number.
    ///
    /// # Complexity
    /// n log n for n vertices and edges.
    ///
    /// # Examples
    /// A cycle of four edges that come one after the other, and a vertex by itself.
    /// ```
    /// use coface_complexes::filtered::WeightedGraph;
    /// use coface_topology::{Coefficients, RipsFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = [(0, 1, 1.0), (1, 2, 2.0), (2, 3, 3.0), (3, 0, 4.0)];
    /// let graph = WeightedGraph::new(vec![-1.0, 0.0, 0.0, 0.0, 0.5], edges)?;
    /// let diagram = RipsFiltration::of_graph(&graph, None)?.persistence(1, Coefficients::Modulo(2))?;
    /// let classes: Vec<_> = diagram.pairs().map(|pair| (pair.degree(), pair.birth(), pair.death())).collect();
    /// let components = [(0, -1.0, None), (0, 0.0, Some(1.0)), (0, 0.0, Some(2.0)), (0, 0.0, Some(3.0)), (0, 0.5, None)];
    /// assert_eq!((&classes[..5], classes[5]), (&components[..], (1, 4.0, None)));
    /// # Ok(()) }
    /// ```
    pub fn of_graph(graph: &WeightedGraph, threshold: Option<f64>) -> Result<Self, Error> {
        if threshold.is_some_and(f64::is_nan) {
            return Err(Error::invalid("the threshold is NaN").with_cure("give a number"));
        }
        let _steps = stage("sorting edges", 0);
        let all = graph.births().iter().copied().chain(graph.edges().iter().map(|edge| edge.2));
        let most = threshold.unwrap_or(f64::INFINITY);
        let mut values: Vec<f64> = all.filter(|&value| value <= most).collect();
        values.par_sort_unstable_by(f64::total_cmp);
        values.dedup();
        let rank = |value: f64| match value <= most {
            true => values.partition_point(|&other| other < value) as u32,
            false => FAR,
        };
        let births = graph.births().iter().map(|&birth| rank(birth)).collect();
        let mut edges: Vec<(u32, u32, u32)> = graph
            .edges()
            .iter()
            .filter(|edge| edge.2 <= most)
            .map(|&(i, j, value)| (i, j, rank(value)))
            .collect();
        edges.par_sort_unstable_by(|a, b| a.2.cmp(&b.2).then((b.0, b.1).cmp(&(a.0, a.1))));
        let threshold = threshold.unwrap_or_else(|| values.last().copied().unwrap_or(0.0));
        Ok(Self { count: graph.vertex_count(), threshold, values, births, edges })
    }

    /// The largest diameter of its simplices.
    ///
    /// # Examples
    /// See [`RipsFiltration`].
    pub fn threshold(&self) -> f64 {
        self.threshold
    }

    /// The simplices that the classes of its diagram need for their [cycles](crate::persistent_cycles), stored: one degree more than the diagram has, and up to
    /// the last death where only one component stays, else up to the threshold. [`Self::order_of`] is the order in which they enter.
    ///
    /// # Errors
    /// Those of [`FilteredComplex::flag`].
    ///
    /// # Complexity
    /// Linear in the simplices.
    ///
    /// # Examples
    /// The outer points of three are joined by a path before they are joined by an edge.
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// use coface_topology::{Coefficients, RipsFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let line = Distances::from_lower_triangle(3, vec![1.0, 3.0, 2.0])?;
    /// let filtration = RipsFiltration::new(&line, Some(3.0))?;
    /// let diagram = filtration.persistence(1, Coefficients::Modulo(2))?;
    /// assert_eq!(filtration.complex_of(&diagram)?.complex().f_vector(), [3, 2]);
    /// # Ok(()) }
    /// ```
    pub fn complex_of(&self, diagram: &RipsDiagram) -> Result<FilteredComplex, Error> {
        let births = self.births.iter().map(|&rank| match rank {
            FAR => f64::MAX,
            rank => self.values[rank as usize],
        });
        let edges =
            self.edges.iter().map(|&(i, j, rank)| (i as usize, j as usize, self.values[rank as usize]));
        let graph = WeightedGraph::new(births.collect(), edges)?;
        FilteredComplex::flag(&graph, self.last_event(diagram), diagram.degree_count())
    }

    /// The order in which stored simplices of each degree enter in [`Self::persistence`]: by values, then points by rising numbers, and simplices of higher degree
    /// from the one whose largest points are largest. With it, [`persistence`](crate::persistence) of a stored complex has the same pairs of simplices, in the same order.
    ///
    /// # Complexity
    /// n log n for n simplices.
    ///
    /// # Examples
    /// Three points, all 1 apart: the edge of the last two comes first.
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// use coface_topology::{Coefficients, RipsFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let filtration = RipsFiltration::new(&Distances::from_lower_triangle(3, vec![1.0; 3])?, None)?;
    /// let diagram = filtration.persistence(0, Coefficients::Modulo(2))?;
    /// let stored = filtration.complex_of(&diagram)?;
    /// // The edges are 01, 02 and 12.
    /// assert_eq!(RipsFiltration::order_of(&stored), [[0, 1, 2], [2, 1, 0]]);
    /// # Ok(()) }
    /// ```
    pub fn order_of(stored: &FilteredComplex) -> Vec<Vec<u32>> {
        let of_degree = |degree: usize| {
            let (simplices, values) = (stored.complex().flat(degree), stored.values(degree));
            let points = |i: u32| simplices[i as usize * (degree + 1)..][..=degree].iter().rev();
            let mut order: Vec<u32> = (0..values.len() as u32).collect();
            order.par_sort_by(|&a, &b| {
                // Values are those of vertices and edges, without negative zeros.
                let by_value = values[a as usize].total_cmp(&values[b as usize]);
                by_value.then_with(|| match degree {
                    0 => a.cmp(&b),
                    _ => points(b).cmp(points(a)),
                })
            });
            order
        };
        (0..stored.complex().f_vector().len()).map(of_degree).collect()
    }

    /// The value from which on classes neither die nor get other cocycles: that of one component is constant, and that of another class that stays is known at the
    /// threshold.
    fn last_event(&self, diagram: &RipsDiagram) -> f64 {
        let is_connected = diagram
            .betti_numbers()
            .iter()
            .enumerate()
            .all(|(degree, &betti)| betti == usize::from(degree == 0));
        if !is_connected {
            return self.threshold;
        }
        let births = self.births.iter().filter(|&&rank| rank != FAR).map(|&rank| self.values[rank as usize]);
        births.chain(diagram.pairs().filter_map(super::RipsPair::death)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The number of edges.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// use coface_topology::RipsFiltration;
    /// let line = Distances::from_lower_triangle(3, vec![1.0, 3.0, 2.0]).expect("three distances");
    /// assert_eq!(RipsFiltration::new(&line, None).expect("a threshold").edge_count(), 2);
    /// ```
    pub fn edge_count(&self) -> usize {
        self.edges.len()
    }

    /// The persistent homology of all degrees up to `dimension`: the pairs that live longer than a moment.
    ///
    /// Points are joined by union-find. Above, coboundaries are reduced from the last simplex to the first, with clearing; apparent pairs and
    /// coboundaries are found from the distances when they are needed. Only what was added to a column is stored. Simplices are found in
    /// parallel; the result does not depend on the number of threads.
    ///
    /// # Errors
    /// [`ErrorKind::Coefficient`] unless the coefficients are modulo a prime below 2^31; [`ErrorKind::TooLarge`] if simplices have no number of
    /// 63 bits, or have more than 17 points.
    ///
    /// # Complexity
    /// Each simplex up to `dimension` is looked at once, in time proportional to the points near it; the reduction is cubic at worst.
    /// Memory: 16 bytes for each simplex below `dimension`, and some for each column that is not in an apparent pair.
    ///
    /// # References
    /// U. Bauer, *Ripser: efficient computation of Vietoris-Rips persistence barcodes* (2021).
    ///
    /// # Examples
    /// See [`RipsDiagram`].
    pub fn persistence(&self, dimension: usize, coefficients: Coefficients) -> Result<RipsDiagram, Error> {
        self.reduced(dimension, coefficients, None)
    }

    /// The same, and a proof: for each degree from 1 on the cochains of several terms. Each other simplex that ends no class is a cochain by itself. The coboundaries of
    /// all these, where they are not zero, begin with different simplices.
    ///
    /// # Errors
    /// Those of [`Self::persistence`].
    ///
    /// # Complexity
    /// That of [`Self::persistence`], and the memory of the terms.
    ///
    /// # Examples
    /// A square whose hole is not filled. The first three of its sides join its corners, and the last one is a cochain by itself.
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// use coface_topology::{Coefficients, RipsFiltration};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = Distances::from_lower_triangle(4, vec![1.0, 2.0, 1.0, 1.0, 2.0, 1.0])?;
    /// let filtration = RipsFiltration::new(&square, Some(1.5))?;
    /// let (diagram, cochains) = filtration.persistence_with_cochains(1, Coefficients::Modulo(2))?;
    /// assert_eq!(diagram.betti_numbers(), [1, 1]);
    /// assert!(cochains[0].iter().all(|cochain| cochain.terms().len() > 1));
    /// # Ok(()) }
    /// ```
    pub fn persistence_with_cochains(
        &self,
        dimension: usize,
        coefficients: Coefficients,
    ) -> Result<(RipsDiagram, Vec<Vec<RipsCochain>>), Error> {
        let mut cochains = Vec::new();
        let diagram = self.reduced(dimension, coefficients, Some(&mut cochains))?;
        Ok((diagram, cochains))
    }

    fn reduced(
        &self,
        dimension: usize,
        coefficients: Coefficients,
        cochains: Option<&mut Vec<Vec<RipsCochain>>>,
    ) -> Result<RipsDiagram, Error> {
        let prime = prime(coefficients)?;
        let binomials = self.binomials(dimension)?;
        let edges = self.simplices_of_edges();
        let degrees = if self.is_dense() {
            let near = Square::new(self.count, self.edges.iter().copied());
            self.pairs(&Simplices { near, binomials }, &edges, (dimension, prime), cochains)
        } else {
            let near = Lists::new(self.count, self.edges.iter().copied());
            self.pairs(&Simplices { near, binomials }, &edges, (dimension, prime), cochains)
        };
        Ok(RipsDiagram { prime, threshold: self.threshold, degrees })
    }

    fn pairs<N: Near>(
        &self,
        simplices: &Simplices<N>,
        edges: &[Simplex],
        (dimension, prime): (usize, u32),
        cochains: Option<&mut Vec<Vec<RipsCochain>>>,
    ) -> Vec<Vec<super::RipsPair>> {
        match prime {
            2 => self.over(&Binary, simplices, edges, dimension, cochains),
            _ => self.over(&Odd::new(prime), simplices, edges, dimension, cochains),
        }
    }

    fn over<N: Near, F: Numbered + Sync>(
        &self,
        field: &F,
        simplices: &Simplices<N>,
        edges: &[Simplex],
        dimension: usize,
        cochains: Option<&mut Vec<Vec<RipsCochain>>>,
    ) -> Vec<Vec<super::RipsPair>>
    where
        F::Unit: Send + Sync,
    {
        let (values, births) = (&self.values, &self.births);
        Reduction { simplices, field, values, births, edges }.pairs(dimension, cochains)
    }

    /// How many simplices there are up to a degree, and how much memory [`Self::persistence`] takes, as far as a sample shows, if the threshold
    /// were this one or less.
    ///
    /// # Errors
    /// As of [`Self::persistence`], but for the coefficients.
    ///
    /// # Complexity
    /// Linear in the edges.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// use coface_topology::RipsFiltration;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Ten points, all 1 apart.
    /// let filtration = RipsFiltration::new(&Distances::from_lower_triangle(10, vec![1.0; 45])?, None)?;
    /// assert_eq!(filtration.size(2, f64::INFINITY)?.simplices(), [10.0, 45.0, 120.0]);
    /// assert_eq!(filtration.size(2, 0.5)?.simplices(), [10.0, 0.0, 0.0]);
    /// assert!(filtration.size(2, 1.0)?.bytes() < 10_000.0);
    /// # Ok(()) }
    /// ```
    pub fn size(&self, dimension: usize, threshold: f64) -> Result<RipsSize, Error> {
        let binomials = self.binomials(dimension)?;
        let edges = self.edges.iter().copied();
        Ok(if self.is_dense() {
            let near = Square::new(self.count, edges);
            self.size_with(&Simplices { near, binomials }, dimension, threshold)
        } else {
            let near = Lists::new(self.count, edges);
            self.size_with(&Simplices { near, binomials }, dimension, threshold)
        })
    }

    /// The largest threshold at which, as far as a sample shows, [`Self::persistence`] takes at most these bytes; `None` if none does.
    ///
    /// # Errors
    /// As of [`Self::size`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// use coface_topology::RipsFiltration;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let filtration = RipsFiltration::new(&Distances::from_lower_triangle(3, vec![1.0, 3.0, 2.0])?, None)?;
    /// assert_eq!(filtration.threshold_within(1, 1e9)?, Some(2.0));
    /// // No edge fits.
    /// assert_eq!(filtration.threshold_within(1, 1.0)?, Some(0.0));
    /// # Ok(()) }
    /// ```
    pub fn threshold_within(&self, dimension: usize, bytes: f64) -> Result<Option<f64>, Error> {
        let binomials = self.binomials(dimension)?;
        let edges = self.edges.iter().copied();
        let fitting = if self.is_dense() {
            let near = Square::new(self.count, edges);
            self.fitting(&Simplices { near, binomials }, dimension, bytes)
        } else {
            let near = Lists::new(self.count, edges);
            self.fitting(&Simplices { near, binomials }, dimension, bytes)
        };
        Ok(fitting.checked_sub(1).map(|last| self.values[last]))
    }

    /// How many of the different distances may be thresholds.
    /// How many points and edges the filtration of distances up to a threshold would have, and the memory that these alone take, before anything is made.
    ///
    /// # Complexity
    /// Linear in the distances.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// use coface_topology::RipsFiltration;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let line = Distances::from_lower_triangle(3, vec![1.0, 3.0, 2.0])?;
    /// assert_eq!(RipsFiltration::size_of_edges(&line, Some(1.0)).simplices(), [3.0, 1.0]);
    /// // Without a threshold up to the enclosing radius.
    /// assert_eq!(RipsFiltration::size_of_edges(&line, None).simplices(), [3.0, 2.0]);
    /// # Ok(()) }
    /// ```
    pub fn size_of_edges(distances: &Distances, threshold: Option<f64>) -> RipsSize {
        let threshold = threshold.unwrap_or_else(|| distances.whole_threshold());
        let (points, edges) = (distances.point_count() as f64, edges_within(distances, threshold) as f64);
        RipsSize { simplices: vec![points, edges], bytes: bytes_of_edges(points, edges) }
    }

    /// A threshold for which the persistence of distances takes no more than this memory, where the edges up to another threshold alone would take more; of many
    /// distances not the largest one. `None` if there is none.
    ///
    /// # Errors
    /// Those of [`Self::size`].
    ///
    /// # Complexity
    /// Some passes over the distances, and as of [`Self::threshold_within`]. What is made of the distances stays within the memory.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// use coface_topology::RipsFiltration;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let line = Distances::from_lower_triangle(3, vec![1.0, 3.0, 2.0])?;
    /// assert_eq!(RipsFiltration::threshold_of(&line, 1, 1e6)?, Some(3.0));
    /// assert_eq!(RipsFiltration::threshold_of(&line, 1, 1.0)?, None);
    /// # Ok(()) }
    /// ```
    pub fn threshold_of(distances: &Distances, dimension: usize, bytes: f64) -> Result<Option<f64>, Error> {
        // Every so many distances tell which ones there are.
        const SEEN: usize = 1 << 18;
        let (mut known, mut seen) = (0usize, Vec::new());
        distances.each(|_, _, _| known += 1);
        let (step, mut place) = (known.div_ceil(SEEN).max(1), 0);
        distances.each(|_, _, distance| {
            if place % step == 0 && distance.is_finite() {
                seen.push(distance);
            }
            place += 1;
        });
        seen.sort_unstable_by(f64::total_cmp);
        let points = distances.point_count() as f64;
        let fits = |edges: usize| bytes_of_edges(points, edges as f64) <= bytes;
        let mut end = (0..seen.len()).collect::<Vec<_>>().partition_point(|&last| fits((last + 1) * step));
        while let Some(last) = end.checked_sub(1) {
            if fits(edges_within(distances, seen[last])) {
                return Self::new(distances, Some(seen[last]))?.threshold_within(dimension, bytes);
            }
            end -= end.div_ceil(20);
        }
        Ok(None)
    }

    fn fitting<N: Near>(&self, simplices: &Simplices<N>, dimension: usize, bytes: f64) -> usize {
        self.values.partition_point(|&value| self.size_with(simplices, dimension, value).bytes <= bytes)
    }

    fn size_with<N: Near>(&self, simplices: &Simplices<N>, dimension: usize, threshold: f64) -> RipsSize {
        let ranks = self.values.partition_point(|&value| value <= threshold) as u32;
        let edge_count = self.edges.partition_point(|edge| edge.2 < ranks);
        let mut counts = vec![self.count as f64, edge_count as f64];
        let mut sample: Vec<Simplex> =
            thinned(&self.edges[..edge_count]).map(|&edge| simplex(edge)).collect();
        let mut free = 0.0;
        for degree in 1..=dimension {
            let is_free = |simplex: &&Simplex| !simplices.has_apparent_cofacet(degree, **simplex);
            free = sample.iter().filter(is_free).count() as f64 / (sample.len().max(1) as f64);
            if degree == dimension {
                break;
            }
            let mut above = Vec::new();
            for &simplex in &sample {
                let points = simplices.points(degree, simplex.index());
                simplices.cofacets(simplex, &points, points[0] + 1, |cofacet, _| {
                    if cofacet.rank < ranks {
                        above.push(cofacet);
                    }
                    None::<()>
                });
            }
            let per_simplex = above.len() as f64 / sample.len().max(1) as f64;
            counts.push(counts[degree] * per_simplex);
            sample = thinned(&above).copied().collect();
        }
        counts.truncate(dimension + 1);
        // Simplices below the top; columns with their pivots.
        let mut bytes = bytes_of_edges(self.count as f64, edge_count as f64);
        bytes += counts.iter().take(dimension).skip(2).map(|count| 32.0 * count).sum::<f64>();
        bytes += counts.last().filter(|_| dimension > 0).map_or(0.0, |count| 96.0 * free * count);
        RipsSize { simplices: counts, bytes }
    }

    pub(super) fn is_dense(&self) -> bool {
        let square = self.count as f64 * self.count as f64;
        self.edges.len() as f64 * DENSE >= square
    }

    fn simplices_of_edges(&self) -> Vec<Simplex> {
        self.edges.iter().map(|&edge| simplex(edge)).collect()
    }

    /// The numbers for simplices up to the cofacets of those of this degree.
    fn binomials(&self, dimension: usize) -> Result<Binomials, Error> {
        let points = dimension.checked_add(2).filter(|&points| points < MOST_POINTS);
        let binomials = points.and_then(|points| Binomials::new(self.count, points));
        binomials.ok_or_else(|| {
            Error::new(
                ErrorKind::TooLarge,
                format!(
                    "the simplices of {} points up to degree {dimension} are too many to be numbered",
                    self.count
                ),
            )
            .with_cure("ask for a lower dimension, or take fewer points")
        })
    }
}

/// From this many edges for each n^2 points on (1 / [`DENSE`]) all ranks are kept in a square.
const DENSE: f64 = 10.0;

/// The memory of distances, of edges three times, and of who is near whom.
fn bytes_of_edges(points: f64, edges: f64) -> f64 {
    let square = points * points;
    edges * 56.0 + if edges * DENSE >= square { 4.0 * square } else { 16.0 * edges }
}

fn edges_within(distances: &Distances, threshold: f64) -> usize {
    let mut count = 0;
    distances.each(|_, _, distance| count += usize::from(distance <= threshold && distance.is_finite()));
    count
}

fn simplex((i, j, rank): (u32, u32, u32)) -> Simplex {
    let (i, j) = (u64::from(i), u64::from(j));
    Simplex::new(rank, i * i.saturating_sub(1) / 2 + j)
}

/// At most [`SAMPLE`] items, evenly spread.
fn thinned<T>(items: &[T]) -> impl Iterator<Item = &T> {
    let step = items.len().div_ceil(SAMPLE).max(1);
    items.iter().step_by(step)
}
