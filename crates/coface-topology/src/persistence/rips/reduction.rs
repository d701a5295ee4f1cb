//! The coboundaries of a Vietoris-Rips filtration, reduced without being stored.

use super::diagram::{RipsCochain, RipsPair};
use super::near::{FAR, Near};
use super::simplices::{Simplex, Simplices};
use coface_algebra::progress::stage;
use coface_algebra::{Binary, Field, Odd, SpreadMap, UnionFind, VertexId};
use rayon::prelude::*;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// The simplices that end a class, by their index: which column has them as its first, and with which coefficient.
type Pivots<U> = SpreadMap<u64, (u32, U)>;

/// Fields whose elements are integers modulo a prime.
pub(super) trait Numbered: Field {
    /// The least positive integer of a class.
    fn number(a: Self::Unit) -> u32;
}

impl Numbered for Binary {
    fn number((): ()) -> u32 {
        1
    }
}

impl Numbered for Odd {
    fn number(a: u32) -> u32 {
        a
    }
}

pub(super) struct Reduction<'a, N, F> {
    pub(super) simplices: &'a Simplices<N>,
    pub(super) field: &'a F,
    /// The different distances, rising.
    pub(super) values: &'a [f64],
    /// The ranks at which points enter; [`FAR`] for those that do not.
    pub(super) births: &'a [u32],
    /// The edges as they enter.
    pub(super) edges: &'a [Simplex],
}

impl<N: Near, F: Numbered + Sync> Reduction<'_, N, F>
where
    F::Unit: Send + Sync,
{
    /// The pairs of all degrees up to this one, and of each degree from 1 on the cochains that are sums of several simplices, if they are wanted.
    pub(super) fn pairs(
        &self,
        dimension: usize,
        mut cochains: Option<&mut Vec<Vec<RipsCochain>>>,
    ) -> Vec<Vec<RipsPair>> {
        let (points, mut columns) = self.merge(dimension > 0);
        let mut degrees = vec![points];
        let mut list: Vec<Simplex> = if dimension > 1 { self.edges.to_vec() } else { Vec::new() };
        for degree in 1..=dimension {
            let mut own = Vec::new();
            let wanted = cochains.is_some().then_some(&mut own);
            let (pairs, pivots) = self.reduce(degree, columns, degree < dimension, wanted);
            degrees.push(pairs);
            if let Some(cochains) = cochains.as_deref_mut() {
                cochains.push(own);
            }
            columns = Vec::new();
            if degree < dimension {
                (list, columns) = self.next(degree, list, &pivots, degree + 1 < dimension);
            }
        }
        degrees
    }

    /// The pairs of the points, and the edges that make loops.
    fn merge(&self, with_loops: bool) -> (Vec<RipsPair>, Vec<Simplex>) {
        let point_count = self.births.len();
        let mut trees = UnionFind::new(point_count);
        // The first point of the tree of each root.
        let mut oldest: Vec<u32> = (0..point_count as u32).collect();
        let mut killer: Vec<Option<Simplex>> = vec![None; point_count];
        // With room for all: a list that grows takes three times as much for a while.
        let mut loops = Vec::with_capacity(if with_loops { self.edges.len() } else { 0 });
        let steps = stage("merging components", self.edges.len());
        for &edge in steps.each(self.edges.iter()) {
            let ends = self.simplices.points(1, edge.index());
            let (a, b) = (oldest[trees.find(ends[0]) as usize], oldest[trees.find(ends[1]) as usize]);
            if trees.unite(a, b) {
                let age = |point: u32| (self.births[point as usize], point);
                let (older, younger) = if age(a) < age(b) { (a, b) } else { (b, a) };
                oldest[trees.find(a) as usize] = older;
                killer[younger as usize] = Some(edge);
            } else if with_loops {
                loops.push(edge);
            }
        }
        drop(steps);
        loops = loops.into_par_iter().filter(|&edge| !self.simplices.has_apparent_cofacet(1, edge)).collect();
        let mut points: Vec<usize> = (0..point_count).filter(|&point| self.births[point] != FAR).collect();
        points.sort_by_key(|&point| self.births[point]);
        let pairs = points.into_iter().filter_map(|point| {
            let (birth, killer) = (self.births[point], killer[point]);
            killer.is_none_or(|edge| edge.rank > birth).then(|| RipsPair {
                degree: 0,
                birth: self.values[birth as usize],
                death: killer.map(|edge| self.values[edge.rank as usize]),
                birth_simplex: vec![VertexId::new(point)],
                death_simplex: killer.map(|edge| self.vertices(1, edge)),
            })
        });
        (pairs.collect(), loops)
    }

    fn vertices(&self, degree: usize, simplex: Simplex) -> Vec<VertexId> {
        let points = self.simplices.points(degree, simplex.index());
        points.iter().rev().map(|&point| VertexId::new(point as usize)).collect()
    }

    /// The simplices of the degree above this one: all of them if they are wanted, and those whose coboundaries are to be reduced.
    fn next(
        &self,
        degree: usize,
        list: Vec<Simplex>,
        pivots: &Pivots<F::Unit>,
        with_all: bool,
    ) -> (Vec<Simplex>, Vec<Simplex>) {
        let _steps = stage("finding simplices", 0);
        let chunk = |simplices: &[Simplex]| {
            let (mut all, mut columns) = (Vec::new(), Vec::new());
            for &simplex in simplices {
                let points = self.simplices.points(degree, simplex.index());
                self.simplices.cofacets(simplex, &points, points[0] + 1, |cofacet, _| {
                    if with_all {
                        all.push(cofacet);
                    }
                    if !pivots.contains_key(&cofacet.index())
                        && !self.simplices.has_apparent_cofacet(degree + 1, cofacet)
                        && self.simplices.apparent_facet(degree + 1, cofacet).is_none()
                    {
                        columns.push(cofacet);
                    }
                    None::<()>
                });
            }
            (all, columns)
        };
        let parts: Vec<(Vec<Simplex>, Vec<Simplex>)> = list.par_chunks(1 << 10).map(chunk).collect();
        drop(list);
        let mut all = Vec::with_capacity(parts.iter().map(|part| part.0.len()).sum());
        let mut columns = Vec::with_capacity(parts.iter().map(|part| part.1.len()).sum());
        for (some, others) in parts {
            all.extend(some);
            columns.extend(others);
        }
        columns.par_sort_unstable();
        (all, columns)
    }

    /// Reduces the coboundaries of these simplices, which are sorted as they enter, from the last one on.
    fn reduce(
        &self,
        degree: usize,
        columns: Vec<Simplex>,
        with_pivots: bool,
        mut cochains: Option<&mut Vec<RipsCochain>>,
    ) -> (Vec<RipsPair>, Pivots<F::Unit>) {
        let mut pivots: Pivots<F::Unit> = SpreadMap::default();
        let mut sums = Summands { starts: vec![0], terms: Vec::new() };
        let mut pairs = Vec::new();
        let steps = stage("pairing simplices", columns.len());
        let order: Vec<Simplex> = columns.into_iter().rev().collect();
        let mut column = Column { heap: BinaryHeap::new() };
        let mut summands: Vec<(Simplex, F::Unit)> = Vec::new();
        for (number, &simplex) in steps.each(order.iter().enumerate()) {
            column.heap.clear();
            summands.clear();
            let death = match self.begin(degree, simplex, &pivots, &mut column) {
                Some((pivot, coefficient)) => {
                    pivots.insert(pivot.index(), (number as u32, coefficient));
                    Some(pivot)
                }
                None => loop {
                    // One coboundary may take long.
                    steps.advance(0);
                    let Some((pivot, coefficient)) = column.pop(self.field) else { break None };
                    if let Some(&(other, at_pivot)) = pivots.get(&pivot.index()) {
                        let factor = self.field.eliminator(coefficient, at_pivot);
                        column.heap.push(Reverse((pivot, coefficient)));
                        let own = (order[other as usize], self.unit(false));
                        for &(summand, x) in std::iter::once(&own).chain(sums.of(other as usize)) {
                            let x = self.field.product(factor, x);
                            summands.push((summand, x));
                            self.add(degree, summand, x, &mut column);
                        }
                    } else if let Some((facet, place)) = self.simplices.apparent_facet(degree + 1, pivot) {
                        let factor = self.field.eliminator(coefficient, self.unit(place % 2 == 1));
                        column.heap.push(Reverse((pivot, coefficient)));
                        summands.push((facet, factor));
                        self.add(degree, facet, factor, &mut column);
                    } else {
                        pivots.insert(pivot.index(), (number as u32, coefficient));
                        break Some(pivot);
                    }
                },
            };
            sums.push(self.field, &mut summands);
            if let Some(cochains) = cochains.as_deref_mut()
                && !sums.of(number).is_empty()
            {
                let own = (simplex, self.unit(false));
                let term =
                    |&(simplex, x): &(Simplex, F::Unit)| (F::number(x), self.vertices(degree, simplex));
                cochains.push(RipsCochain {
                    terms: std::iter::once(&own).chain(sums.of(number)).map(term).collect(),
                });
            }
            if death.is_none_or(|death| death.rank > simplex.rank) {
                let value = |simplex: Simplex| self.values[simplex.rank as usize];
                pairs.push(RipsPair {
                    degree,
                    birth: value(simplex),
                    death: death.map(value),
                    birth_simplex: self.vertices(degree, simplex),
                    death_simplex: death.map(|death| self.vertices(degree + 1, death)),
                });
            }
        }
        pairs.reverse();
        if !with_pivots {
            pivots = SpreadMap::default();
        }
        (pairs, pivots)
    }

    /// Begins with the coboundary of a simplex; gives its first simplex at once if it is free and has the same diameter.
    fn begin(
        &self,
        degree: usize,
        simplex: Simplex,
        pivots: &Pivots<F::Unit>,
        column: &mut Column<F::Unit>,
    ) -> Option<(Simplex, F::Unit)> {
        let points = self.simplices.points(degree, simplex.index());
        let mut may_be_first = true;
        self.simplices.cofacets(simplex, &points, 0, |cofacet, place| {
            let unit = self.unit(place % 2 == 1);
            if may_be_first && cofacet.rank == simplex.rank {
                may_be_first = false;
                if !pivots.contains_key(&cofacet.index())
                    && self.simplices.apparent_facet(degree + 1, cofacet).is_none()
                {
                    return Some((cofacet, unit));
                }
            }
            column.heap.push(Reverse((cofacet, unit)));
            None
        })
    }

    /// Adds a multiple of the coboundary of a simplex.
    fn add(&self, degree: usize, simplex: Simplex, factor: F::Unit, column: &mut Column<F::Unit>) {
        let points = self.simplices.points(degree, simplex.index());
        self.simplices.cofacets(simplex, &points, 0, |cofacet, place| {
            let unit = self.field.product(factor, self.unit(place % 2 == 1));
            column.heap.push(Reverse((cofacet, unit)));
            None::<()>
        });
    }

    /// One, or minus one.
    fn unit(&self, is_negative: bool) -> F::Unit {
        let number = if is_negative { -1 } else { 1 };
        self.field.unit(number).expect("1 and -1 are not 0 in a field")
    }
}

/// A sum of coboundaries whose terms are only added up when they are taken out.
struct Column<U> {
    heap: BinaryHeap<Reverse<(Simplex, U)>>,
}

impl<U: Copy + Ord> Column<U> {
    /// Takes the first term out whose coefficient is not zero.
    fn pop<F: Field<Unit = U>>(&mut self, field: &F) -> Option<(Simplex, U)> {
        while let Some(Reverse((simplex, first))) = self.heap.pop() {
            let mut total = Some(first);
            while let Some(&Reverse((next, x))) = self.heap.peek()
                && next == simplex
            {
                self.heap.pop();
                total = match total {
                    Some(sum) => field.sum(sum, x),
                    None => Some(x),
                };
            }
            if let Some(total) = total {
                return Some((simplex, total));
            }
        }
        None
    }
}

/// For each column that has been reduced the simplices, but its own, whose coboundaries were added, with their coefficients.
struct Summands<U> {
    starts: Vec<usize>,
    terms: Vec<(Simplex, U)>,
}

impl<U: Copy + Ord> Summands<U> {
    fn of(&self, column: usize) -> &[(Simplex, U)] {
        &self.terms[self.starts[column]..self.starts[column + 1]]
    }

    /// Keeps what was added to the next column.
    fn push<F: Field<Unit = U>>(&mut self, field: &F, terms: &mut [(Simplex, U)]) {
        terms.sort_unstable();
        for run in terms.chunk_by(|a, b| a.0 == b.0) {
            let mut total = None;
            for &(_, x) in run {
                total = match total {
                    Some(sum) => field.sum(sum, x),
                    None => Some(x),
                };
            }
            self.terms.extend(total.map(|total| (run[0].0, total)));
        }
        self.starts.push(self.terms.len());
    }
}
