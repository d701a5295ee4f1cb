//! Zigzag persistence against the ranks of its module.

use super::{Filtration, ZigzagFiltration, ZigzagStep, persistence};
use crate::Coefficients;
use coface_complexes::simplicial::{Simplex, SimplicialComplex};
use proptest::prelude::*;
use std::collections::BTreeSet;

type Row = Vec<i64>;

/// Echelon forms over the field of p elements.
#[derive(Clone)]
struct Span {
    p: i64,
    rows: Vec<Row>,
}

impl Span {
    fn inverse(&self, x: i64) -> i64 {
        (1..self.p).find(|y| x * y % self.p == 1).unwrap()
    }

    /// Whether the row is new.
    fn add(&mut self, mut row: Row) -> bool {
        for old in &self.rows {
            let lead = old.iter().position(|&x| x != 0).unwrap();
            let factor = row[lead];
            row.iter_mut().zip(old).for_each(|(x, y)| *x = (*x - factor * y).rem_euclid(self.p));
        }
        let Some(lead) = row.iter().position(|&x| x != 0) else { return false };
        let inverse = self.inverse(row[lead]);
        row.iter_mut().for_each(|x| *x = *x * inverse % self.p);
        self.rows.push(row);
        true
    }

    fn rank(p: i64, rows: impl IntoIterator<Item = Row>) -> usize {
        let mut span = Self { p, rows: Vec::new() };
        rows.into_iter().filter(|row| span.add(row.clone())).count()
    }
}

/// The kernel of a matrix of rows: combinations of the rows with the sum zero.
fn kernel(p: i64, rows: &[Row]) -> Vec<Row> {
    let width = rows.first().map_or(0, Vec::len);
    let mut span = Span { p, rows: Vec::new() };
    let mut found = Vec::new();
    for (place, row) in rows.iter().enumerate() {
        let mut whole = row.clone();
        whole.extend((0..rows.len()).map(|other| i64::from(other == place)));
        // Rows are reduced by leads in the first part alone.
        for old in &span.rows {
            let lead = old.iter().position(|&x| x != 0).unwrap();
            let factor = whole[lead];
            whole.iter_mut().zip(old).for_each(|(x, y)| *x = (*x - factor * y).rem_euclid(p));
        }
        match whole[..width].iter().position(|&x| x != 0) {
            None => found.push(whole[width..].to_vec()),
            Some(lead) => {
                let inverse = span.inverse(whole[lead]);
                whole.iter_mut().for_each(|x| *x = *x * inverse % p);
                span.rows.push(whole);
            }
        }
    }
    found
}

/// The complexes of a zigzag, one behind each step, and before the first one the empty one.
fn complexes(steps: &[ZigzagStep]) -> Vec<BTreeSet<Simplex>> {
    let mut all = vec![BTreeSet::new()];
    for step in steps {
        let mut next = all.last().unwrap().clone();
        if step.is_insertion() {
            next.insert(step.simplex().clone());
        } else {
            next.remove(step.simplex());
        }
        all.push(next);
    }
    all
}

/// The second method: the number of intervals that contain the complexes from b to d is the rank of the map from the limit to the colimit of the homology of
/// these complexes. Both are found from cycles and boundaries alone.
struct Module {
    p: i64,
    complexes: Vec<BTreeSet<Simplex>>,
    simplices: Vec<Simplex>,
}

impl Module {
    fn of(p: i64, steps: &[ZigzagStep]) -> Self {
        let complexes = complexes(steps);
        let simplices: BTreeSet<Simplex> = complexes.iter().flatten().cloned().collect();
        Self { p, complexes, simplices: simplices.into_iter().collect() }
    }

    fn boundary(&self, simplex: &Simplex) -> Row {
        let mut row = vec![0; self.simplices.len()];
        if simplex.dimension() > 0 {
            for (sign, facet) in simplex.facets() {
                let place = self.simplices.binary_search(&facet).unwrap();
                row[place] = if sign == coface_algebra::Sign::Plus { 1 } else { self.p - 1 };
            }
        }
        row
    }

    fn of_degree(&self, complex: &BTreeSet<Simplex>, degree: usize) -> Vec<Simplex> {
        complex.iter().filter(|simplex| simplex.dimension() == degree).cloned().collect()
    }

    fn cycles(&self, complex: &BTreeSet<Simplex>, degree: usize) -> Vec<Row> {
        let cells = self.of_degree(complex, degree);
        let rows: Vec<Row> = cells.iter().map(|cell| self.boundary(cell)).collect();
        let spread = |combination: Row| {
            let mut row = vec![0; self.simplices.len()];
            for (cell, x) in cells.iter().zip(combination) {
                row[self.simplices.binary_search(cell).unwrap()] = x;
            }
            row
        };
        kernel(self.p, &rows).into_iter().map(spread).collect()
    }

    fn boundaries(&self, complex: &BTreeSet<Simplex>, degree: usize) -> Vec<Row> {
        self.of_degree(complex, degree + 1).iter().map(|cell| self.boundary(cell)).collect()
    }

    /// How many intervals of a degree contain all complexes from b to d.
    fn rank(&self, degree: usize, b: usize, d: usize) -> usize {
        let part = &self.complexes[b..=d];
        let width = self.simplices.len();
        let slot = |place: usize, row: &Row, factor: i64| {
            let mut whole = vec![0; part.len() * width];
            let there = &mut whole[place * width..(place + 1) * width];
            there.iter_mut().zip(row).for_each(|(x, y)| *x = (factor * y).rem_euclid(self.p));
            whole
        };
        let sum = |a: Row, b: Row| a.iter().zip(&b).map(|(x, y)| (x + y) % self.p).collect::<Row>();
        let larger = |place: usize| match part[place].len() > part[place + 1].len() {
            true => (&part[place + 1], &part[place]),
            false => (&part[place], &part[place + 1]),
        };
        // The limit: cycles whose differences bound in the larger complex. Unknowns are cycles of all places and chains that differences bound.
        let (mut unknowns, mut first) = (Vec::new(), Vec::new());
        for (place, complex) in part.iter().enumerate() {
            for cycle in self.cycles(complex, degree) {
                let mut equations = vec![0; (part.len() - 1) * width];
                for (at, factor) in [(place.checked_sub(1), self.p - 1), (Some(place), 1)] {
                    let Some(at) = at.filter(|&at| at + 1 < part.len()) else { continue };
                    let there = &mut equations[at * width..(at + 1) * width];
                    there.iter_mut().zip(&cycle).for_each(|(x, y)| *x = factor * y % self.p);
                }
                unknowns.push(equations);
                first.push(if place == 0 { Some(cycle) } else { None });
            }
        }
        for place in 0..part.len() - 1 {
            for boundary in self.boundaries(larger(place).1, degree) {
                let mut equations = vec![0; (part.len() - 1) * width];
                equations[place * width..(place + 1) * width].copy_from_slice(&boundary);
                unknowns.push(equations);
                first.push(None);
            }
        }
        let from_limit = kernel(self.p, &unknowns).into_iter().map(|combination| {
            let mut row = vec![0; width];
            for (x, cycle) in combination.iter().zip(&first) {
                if let Some(cycle) = cycle {
                    row.iter_mut().zip(cycle).for_each(|(a, y)| *a = (*a + x * y) % self.p);
                }
            }
            slot(0, &row, 1)
        });
        // The colimit: cycles of all places modulo boundaries, a cycle of the smaller complex being the same at both places.
        let mut relations = Vec::new();
        for (place, complex) in part.iter().enumerate() {
            relations.extend(self.boundaries(complex, degree).iter().map(|row| slot(place, row, 1)));
            if place + 1 < part.len() {
                let cycles = self.cycles(larger(place).0, degree);
                relations.extend(cycles.iter().map(|row| sum(slot(place, row, 1), slot(place + 1, row, -1))));
            }
        }
        let whole: Vec<Row> = relations.iter().cloned().chain(from_limit).collect();
        Span::rank(self.p, whole) - Span::rank(self.p, relations)
    }

    /// All intervals: degree, the first and the last complex.
    fn intervals(&self) -> Vec<(usize, usize, usize)> {
        let last = self.complexes.len() - 1;
        let top = self.simplices.iter().map(Simplex::dimension).max().unwrap_or(0);
        let mut found = Vec::new();
        for degree in 0..=top {
            let table: Vec<Vec<usize>> = (0..=last)
                .map(|b| (0..=last).map(|d| if b <= d { self.rank(degree, b, d) } else { 0 }).collect())
                .collect();
            let rank = |b: Option<usize>, d: usize| b.filter(|_| d <= last).map_or(0, |b| table[b][d]);
            for b in 0..=last {
                for d in b..=last {
                    let before = b.checked_sub(1);
                    let count =
                        rank(Some(b), d) + rank(before, d + 1) - rank(before, d) - rank(Some(b), d + 1);
                    found.extend(std::iter::repeat_n((degree, b, d), count));
                }
            }
        }
        found.sort_unstable();
        found
    }
}

/// Steps as they can be made: each number chooses a simplex that may enter or leave.
fn steps(choices: &[(u8, bool)], most: u32) -> Vec<ZigzagStep> {
    let all: Vec<Simplex> = (1u32..1 << most)
        .map(|set| (0..most).filter(|v| set >> v & 1 == 1).collect::<Vec<_>>())
        .filter(|numbers| numbers.len() <= 3)
        .map(|numbers| Simplex::from_numbers(&numbers).unwrap())
        .collect();
    let mut there: BTreeSet<Simplex> = BTreeSet::new();
    let mut steps = Vec::new();
    for &(choice, prefers_deletion) in choices {
        let may_enter = |simplex: &Simplex| {
            !there.contains(simplex)
                && (simplex.dimension() == 0 || simplex.facets().all(|(_, facet)| there.contains(&facet)))
        };
        let may_leave =
            |simplex: &Simplex| there.iter().all(|other| other == simplex || !simplex.is_face_of(other));
        let entering: Vec<Simplex> = all.iter().filter(|simplex| may_enter(simplex)).cloned().collect();
        let leaving: Vec<Simplex> = there.iter().filter(|simplex| may_leave(simplex)).cloned().collect();
        let time = (steps.len() / 2) as f64;
        if entering.is_empty() || prefers_deletion && !leaving.is_empty() {
            let simplex = leaving[choice as usize % leaving.len()].clone();
            there.remove(&simplex);
            steps.push(ZigzagStep::deletion(simplex, time));
        } else {
            // Large simplices first, so that there are classes of higher degree.
            let simplex = entering[entering.len() - 1 - choice as usize % entering.len()].clone();
            there.insert(simplex.clone());
            steps.push(ZigzagStep::insertion(simplex, time));
        }
    }
    steps
}

fn found(steps: &[ZigzagStep], p: i64) -> Vec<(usize, usize, usize)> {
    let pairs =
        ZigzagFiltration::new(steps.to_vec()).unwrap().persistence(Coefficients::Modulo(p as u64)).unwrap();
    let last = steps.len();
    let mut found: Vec<_> = pairs
        .iter()
        .map(|pair| {
            let (born, dead) = (&steps[pair.birth_step()], pair.death_step().map(|step| &steps[step]));
            assert_eq!((pair.birth(), pair.death()), (born.time(), dead.map(ZigzagStep::time)));
            assert_eq!(pair.is_birth_closed(), born.is_insertion());
            assert_eq!(pair.is_death_closed(), dead.is_some_and(|step| !step.is_insertion()));
            (pair.degree(), pair.birth_step() + 1, pair.death_step().unwrap_or(last))
        })
        .collect();
    found.sort_unstable();
    found
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(150))]

    /// Invariant 114.
    #[test]
    fn intervals_are_those_of_the_zigzag_module(
        choices in prop::collection::vec((any::<u8>(), prop::bool::weighted(0.4)), 0..14),
        p in prop_oneof![Just(2i64), Just(3)],
    ) {
        let steps = steps(&choices, 4);
        prop_assert_eq!(found(&steps, p), Module::of(p, &steps).intervals(), "{:?}", steps);
    }
}

proptest! {
    #[test]
    fn insertions_alone_are_a_filtration(
        choices in prop::collection::vec((any::<u8>(), Just(false)), 0..26),
        p in prop_oneof![Just(2u64), Just(5)],
    ) {
        let steps = steps(&choices, 5);
        let pairs = ZigzagFiltration::new(steps.clone()).unwrap().persistence(Coefficients::Modulo(p)).unwrap();
        let mut found: Vec<_> = pairs
            .iter()
            .map(|pair| (pair.degree(), pair.birth_step(), pair.death_step()))
            .collect();
        let complex = SimplicialComplex::from_simplices(steps.iter().map(|step| step.simplex().clone())).unwrap();
        let place = |simplex: &Simplex| steps.iter().position(|step| step.simplex() == simplex).unwrap() as f64;
        let degrees = 0..complex.f_vector().len();
        let values = degrees.map(|degree| complex.simplices(degree).map(|simplex| place(&simplex)).collect()).collect();
        let chains = complex.chain_complex().unwrap();
        let filtration = Filtration::new(&chains, values).unwrap();
        let diagram = persistence(&chains, &filtration, Coefficients::Modulo(p)).unwrap();
        let mut expected: Vec<_> = diagram
            .pairs()
            .iter()
            .map(|pair| (pair.degree(), pair.birth() as usize, pair.death().map(|death| death as usize)))
            .collect();
        found.sort_unstable();
        expected.sort_unstable();
        prop_assert_eq!(found, expected);
    }

    /// Up and down again the same way: what is born by a simplex dies by it.
    #[test]
    fn the_way_back_mirrors_the_way(choices in prop::collection::vec((any::<u8>(), Just(false)), 1..26)) {
        let up = steps(&choices, 5);
        let down = up.iter().rev().map(|step| ZigzagStep::deletion(step.simplex().clone(), 100.0));
        let both: Vec<ZigzagStep> = up.iter().cloned().chain(down).collect();
        let pairs = ZigzagFiltration::new(both).unwrap().persistence(Coefficients::Modulo(3)).unwrap();
        let last = 2 * up.len() - 1;
        for pair in pairs {
            let mirrored = last - pair.birth_step();
            prop_assert!(pair.death_step() == Some(mirrored) || pair.is_birth_closed() != pair.is_death_closed());
        }
    }
}

/// The example of the guide of Dionysus, with its answer.
#[test]
fn diagrams_are_those_of_dionysus() {
    let insertion =
        |numbers: &[u32], time: f64| ZigzagStep::insertion(Simplex::from_numbers(numbers).unwrap(), time);
    let steps = vec![
        insertion(&[1], 0.1),
        insertion(&[0], 0.4),
        ZigzagStep::deletion(Simplex::from([0]), 0.6),
        insertion(&[0], 0.7),
        insertion(&[0, 1], 0.9),
        insertion(&[2], 0.9),
        insertion(&[0, 2], 0.9),
        insertion(&[1, 2], 0.9),
    ];
    let pairs = ZigzagFiltration::new(steps).unwrap().persistence(Coefficients::Modulo(2)).unwrap();
    let long = pairs.iter().filter(|pair| pair.persistence() > 0.0);
    let found: Vec<_> = long.map(|pair| (pair.degree(), pair.birth(), pair.death())).collect();
    assert_eq!(found, [(0, 0.1, None), (0, 0.4, Some(0.6)), (0, 0.7, Some(0.9)), (1, 0.9, None)]);
}

#[test]
fn wrong_steps_are_named() {
    let [a, ab] = [Simplex::from([0]), Simplex::from([0, 1])];
    let fault = |steps: Vec<ZigzagStep>| ZigzagFiltration::new(steps).unwrap_err().message().to_owned();
    let enter = |simplex: &Simplex| ZigzagStep::insertion(simplex.clone(), 0.0);
    let b = Simplex::from([1]);
    assert_eq!(fault(vec![enter(&a), enter(&a)]), "step 2: {0} enters and is there");
    assert_eq!(fault(vec![enter(&a), enter(&ab)]), "step 2: {0, 1} enters before its face {1}");
    assert_eq!(fault(vec![ZigzagStep::deletion(a.clone(), 0.0)]), "step 1: {0} leaves and is not there");
    let early = vec![enter(&a), enter(&b), enter(&ab), ZigzagStep::deletion(b.clone(), 0.0)];
    assert_eq!(fault(early), "step 4: {1} leaves before its coface {0, 1}");
    let falling = vec![ZigzagStep::insertion(a.clone(), 2.0), ZigzagStep::insertion(b, 1.0)];
    assert_eq!(fault(falling), "step 2: the time falls from 2 to 1");
    assert_eq!(fault(vec![ZigzagStep::insertion(a, f64::NAN)]), "step 1: the time is NaN");
    let nothing = ZigzagFiltration::default();
    assert!(nothing.persistence(Coefficients::Modulo(2)).unwrap().is_empty());
    assert!(nothing.persistence(Coefficients::Modulo(4)).is_err());
}
