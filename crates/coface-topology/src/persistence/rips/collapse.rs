//! Edge collapse of Vietoris-Rips filtrations and flag complexes.

use super::filtration::RipsFiltration;
use super::near::{FAR, Lists, Near, Square};
use coface_algebra::progress::stage;

impl RipsFiltration {
    /// The filtration with fewer edges that has the same diagram: its flag complexes are parts of those of this one to which they collapse, at each value.
    ///
    /// An edge is dominated while a point near both of its ends is near all other points that are. The edges are looked at from the last one to enter to the
    /// first: one that is dominated enters as late as it is, or never. Births and deaths of the diagram are the same, the simplices that make and
    /// end classes need not be.
    ///
    /// # Complexity
    /// For each edge linear in the number of points near its ends, and at worst quadratic in that of the points near both; in practice few points are
    /// tried before one dominates. Memory as [`Self::persistence`] has for distances: no more than a square of the points, if most are near each other.
    ///
    /// # References
    /// J.-D. Boissonnat, S. Pritam, *Edge collapse and persistence of flag complexes* (2020); M. Glisse, S. Pritam, *Swap, shift and trim to edge
    /// collapse a filtration* (2022).
    ///
    /// # Examples
    /// Of the six distances of four points in a row, three are left.
    /// ```
    /// use coface_complexes::filtered::Distances;
    /// use coface_topology::RipsFiltration;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let line = Distances::from_lower_triangle(4, vec![1.0, 2.0, 1.0, 3.0, 2.0, 1.0])?;
    /// let filtration = RipsFiltration::new(&line, Some(3.0))?;
    /// assert_eq!((filtration.edge_count(), filtration.collapsed().edge_count()), (6, 3));
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn collapsed(&self) -> Self {
        let edges = self.edges.iter().copied();
        let mut left = match self.is_dense() {
            true => collapse(Square::new(self.count, edges), &self.edges),
            false => collapse(Lists::new(self.count, edges), &self.edges),
        };
        left.sort_unstable_by(|a, b| a.2.cmp(&b.2).then((b.0, b.1).cmp(&(a.0, a.1))));
        let (values, births) = (self.values.clone(), self.births.clone());
        Self { count: self.count, threshold: self.threshold, values, births, edges: left }
    }
}

/// The edges that are left, with the ranks at which they enter.
fn collapse<N: Near>(near: N, edges: &[(u32, u32, u32)]) -> Vec<(u32, u32, u32)> {
    let mut left = Vec::new();
    let mut search = Search { near, there: Vec::new(), seen: Vec::new(), later: Vec::new() };
    let steps = stage("collapsing edges", edges.len());
    for &(i, j, rank) in steps.each(edges.iter().rev()) {
        match search.end_of_domination(i, j, rank) {
            Some(end) => {
                if end != rank {
                    search.near.set_rank(i, j, end);
                }
                left.push((i, j, end));
            }
            None => search.near.set_rank(i, j, FAR),
        }
    }
    left
}

/// Looks for points that dominate an edge.
struct Search<N> {
    near: N,
    /// The points near both ends, first the nearest one of those that are there from the beginning.
    there: Vec<u32>,
    /// The same, first those that were too far from a point before.
    seen: Vec<u32>,
    /// The points that come later, with their ranks.
    later: Vec<(u32, u32)>,
}

impl<N: Near> Search<N> {
    /// The first rank, from that of an edge on, at which no point dominates it; `None` if one always does.
    fn end_of_domination(&mut self, i: u32, j: u32, rank: u32) -> Option<u32> {
        self.there.clear();
        self.later.clear();
        let mut least = FAR;
        self.near.common(&[i.max(j), i.min(j)], 0, |point, most| {
            if most <= rank {
                self.there.push(point);
                if most < least {
                    // In a set of points one in the middle of both ends is near all others.
                    least = most;
                    let last = self.there.len() - 1;
                    self.there.swap(0, last);
                }
            } else if most != FAR {
                self.later.push((most, point));
            }
            None::<()>
        });
        self.seen.clone_from(&self.there);
        let Some(mut dominant) = self.dominant(rank) else { return Some(rank) };
        self.later.sort_unstable();
        let later = std::mem::take(&mut self.later);
        let end = later.chunk_by(|a, b| a.0 == b.0).find_map(|come| {
            let rank = come[0].0;
            for &(_, point) in come {
                self.there.push(point);
                self.seen.push(point);
            }
            if come.iter().all(|&(_, point)| self.near.rank(dominant, point) <= rank) {
                return None;
            }
            match self.dominant(rank) {
                Some(other) => {
                    dominant = other;
                    None
                }
                None => Some(rank),
            }
        });
        self.later = later;
        end
    }

    /// One of the points near both ends that is near all others of them at a rank.
    fn dominant(&mut self, rank: u32) -> Option<u32> {
        let Self { near, there, seen, .. } = self;
        there.iter().copied().find(|&one| {
            let far = seen.iter().position(|&other| other != one && near.rank(one, other) > rank);
            // What is too far from one point is so from many.
            if let Some(far) = far {
                seen.swap(0, far);
            }
            far.is_none()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::homology::Coefficients;
    use coface_complexes::filtered::{Distances, WeightedGraph};
    use proptest::prelude::*;

    type Class = (usize, u64, Option<u64>);

    /// The classes of a diagram; values are not negative, so that their bits have their order.
    fn classes(filtration: &RipsFiltration, dimension: usize) -> Vec<Class> {
        let diagram = filtration.persistence(dimension, Coefficients::Modulo(2)).unwrap();
        let class = |pair: &super::super::RipsPair| {
            (pair.degree(), pair.birth().to_bits(), pair.death().map(f64::to_bits))
        };
        let mut classes: Vec<Class> = diagram.pairs().map(class).collect();
        classes.sort_unstable();
        classes
    }

    /// The same edges in lists and in a square collapse in the same way.
    fn check(filtration: &RipsFiltration, dimension: usize) -> Result<(), TestCaseError> {
        let collapsed = filtration.collapsed();
        prop_assert!(collapsed.edge_count() <= filtration.edge_count());
        prop_assert_eq!(classes(filtration, dimension), classes(&collapsed, dimension));
        prop_assert_eq!(classes(filtration, dimension), classes(&collapsed.collapsed(), dimension));
        let edges = filtration.edges.iter().copied();
        let square = collapse(Square::new(filtration.count, edges.clone()), &filtration.edges);
        prop_assert_eq!(square, collapse(Lists::new(filtration.count, edges), &filtration.edges));
        Ok(())
    }

    proptest! {
        #[test]
        fn diagrams_of_points_are_the_same(
            points in prop::collection::vec((0.0f64..1.0, 0.0f64..1.0, 0.0f64..1.0), 2..22),
            threshold in prop::option::of(0.1f64..2.0),
        ) {
            let mut triangle = Vec::new();
            for (i, a) in points.iter().enumerate() {
                triangle.extend(points[..i].iter().map(|b| (a.0 - b.0).hypot(a.1 - b.1).hypot(a.2 - b.2)));
            }
            let distances = Distances::from_lower_triangle(points.len(), triangle).unwrap();
            check(&RipsFiltration::new(&distances, threshold).unwrap(), 2)?;
        }

        #[test]
        fn diagrams_of_distances_with_ties_are_the_same(
            count in 2usize..14,
            lengths in prop::collection::vec(1u8..5, 91),
            threshold in prop::option::of(1u8..5),
        ) {
            let triangle = lengths[..count * (count - 1) / 2].iter().map(|&length| f64::from(length)).collect();
            let distances = Distances::from_lower_triangle(count, triangle).unwrap();
            check(&RipsFiltration::new(&distances, threshold.map(f64::from)).unwrap(), 3)?;
        }

        #[test]
        fn diagrams_of_graphs_whose_vertices_come_later_are_the_same(
            births in prop::collection::vec(0u8..4, 3..24),
            edges in prop::collection::vec((0usize..24, 0usize..24, 0u8..6), 0..80),
            threshold in prop::option::of(0u8..8),
        ) {
            let count = births.len();
            let mut seen = std::collections::BTreeSet::new();
            let value = |(i, j, length): (usize, usize, u8)| {
                let (i, j) = (i % count, j % count);
                let later = births[i].max(births[j]);
                (i.max(j), i.min(j), f64::from(later + length))
            };
            let edges: Vec<_> = edges.into_iter().map(value).filter(|&(i, j, _)| i != j && seen.insert((i, j))).collect();
            let graph = WeightedGraph::new(births.iter().map(|&birth| f64::from(birth)).collect(), edges).unwrap();
            check(&RipsFiltration::of_graph(&graph, threshold.map(f64::from)).unwrap(), 3)?;
        }
    }

    #[test]
    fn nothing_collapses_in_a_cycle_and_all_but_a_tree_in_a_clique() {
        let cycle = WeightedGraph::new(vec![0.0; 5], (0..5).map(|i| (i, (i + 1) % 5, 1.0))).unwrap();
        assert_eq!(RipsFiltration::of_graph(&cycle, None).unwrap().collapsed().edge_count(), 5);
        let clique = Distances::from_lower_triangle(6, vec![1.0; 15]).unwrap();
        assert_eq!(RipsFiltration::new(&clique, None).unwrap().collapsed().edge_count(), 5);
        let nothing = Distances::from_lower_triangle(0, Vec::new()).unwrap();
        assert_eq!(RipsFiltration::new(&nothing, None).unwrap().collapsed().edge_count(), 0);
    }
}
