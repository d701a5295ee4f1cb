//! Cycles of a diagram that lose cells.

use super::cycles::{Pairs, Terms};
use super::{Filtration, PersistencePair};
use coface_algebra::{Field, SparseMatrix};
use std::collections::{BTreeMap, HashMap, VecDeque};

/// Adds boundaries of single cells to cycles of one degree. Cells have their numbers of entrance.
pub(super) struct Shortening<'a, F, N> {
    field: &'a F,
    integer: &'a N,
    matrix: &'a SparseMatrix,
    pairs: &'a Pairs<'a>,
    /// For each cell the cofaces by their ids.
    starts: Vec<usize>,
    cofaces: Vec<u32>,
}

/// Which cells may be added, and what they are added to.
struct Class {
    birth: f64,
    birth_number: u32,
    death_number: Option<u32>,
}

impl<'a, F: Field, N: Fn(F::Unit) -> i64> Shortening<'a, F, N> {
    /// `None` where no boundary can be added: of points, which are as short as they can be, and of cells without cofaces.
    pub(super) fn new(field: &'a F, integer: &'a N, pairs: &'a Pairs<'a>) -> Option<Self> {
        let matrix = pairs.complex.boundary_matrix(pairs.degree + 1).filter(|_| pairs.degree > 0)?;
        let mut starts = vec![0; pairs.here.cells.len() + 1];
        for (face, _) in matrix.columns().flat_map(|column| column.iter()) {
            starts[pairs.here.numbers[face] as usize + 1] += 1;
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut next = starts.clone();
        let mut cofaces = vec![0; matrix.entry_count()];
        // In the order of entrance: those that enter in time come first.
        for &cell in &pairs.next.cells {
            for (face, _) in matrix.column(cell as usize).iter() {
                let at = &mut next[pairs.here.numbers[face] as usize];
                cofaces[*at] = cell;
                *at += 1;
            }
        }
        Some(Self { field, integer, matrix, pairs, starts, cofaces })
    }

    /// Makes a cycle shorter by boundaries of cells that enter no later than its class, before the cell that ends it, and whose faces enter before the
    /// cell that makes it: the class, its last cell and the coefficient of that stay. The chain that the cycle bounds gains the same cells.
    pub(super) fn shorten(
        &self,
        filtration: &Filtration,
        pair: &PersistencePair,
        cycle: &mut Terms<F::Unit>,
        bounding: Option<&mut Terms<F::Unit>>,
    ) {
        let (here, next) = (self.pairs.here, self.pairs.next);
        let class = Class {
            birth: pair.birth(),
            birth_number: here.number(pair.birth_cell()),
            death_number: pair.death_cell().map(|death| next.number(death)),
        };
        let values = filtration.values(self.pairs.degree + 1);
        let is_late = |cell: u32| {
            let value = values[cell as usize];
            if filtration.is_falling() { value < class.birth } else { value > class.birth }
        };
        let mut present: HashMap<u32, F::Unit> = cycle.iter().copied().collect();
        let mut queue: VecDeque<u32> = VecDeque::new();
        let mut is_waiting: HashMap<u32, bool> = HashMap::new();
        let offer = |face: u32, queue: &mut VecDeque<u32>, is_waiting: &mut HashMap<u32, bool>| {
            for &coface in &self.cofaces[self.starts[face as usize]..self.starts[face as usize + 1]] {
                if is_late(coface) {
                    break;
                }
                if !is_waiting.insert(coface, true).unwrap_or(false) {
                    queue.push_back(coface);
                }
            }
        };
        let mut ordered: Vec<u32> = cycle.iter().map(|&(number, _)| number).collect();
        ordered.sort_unstable();
        ordered.iter().for_each(|&face| offer(face, &mut queue, &mut is_waiting));
        let mut added: BTreeMap<u32, F::Unit> = BTreeMap::new();
        while let Some(cell) = queue.pop_front() {
            is_waiting.insert(cell, false);
            let Some(factor) = self.better_factor(cell, &class, &present) else { continue };
            for (face, x) in self.matrix.column(cell as usize).iter() {
                let Some(unit) = self.field.unit(x) else { continue };
                let number = here.numbers[face];
                let part = self.field.product(factor, unit);
                match self.sum(present.get(&number), part) {
                    Some(sum) => present.insert(number, sum),
                    None => present.remove(&number),
                };
                offer(number, &mut queue, &mut is_waiting);
            }
            self.add(&mut added, next.numbers[cell as usize], factor);
        }
        if added.is_empty() {
            return;
        }
        *cycle = present.into_iter().collect();
        // As it was: the cell that makes the class first.
        cycle.sort_unstable_by_key(|&(number, _)| std::cmp::Reverse(number));
        if let Some(bounding) = bounding {
            bounding.iter().for_each(|&(number, unit)| self.add(&mut added, number, unit));
            *bounding = added.into_iter().rev().collect();
        }
    }

    /// A coefficient after a change; `None` for zero.
    fn sum(&self, old: Option<&F::Unit>, part: F::Unit) -> Option<F::Unit> {
        old.map_or(Some(part), |&old| self.field.sum(old, part))
    }

    fn add(&self, chain: &mut BTreeMap<u32, F::Unit>, number: u32, part: F::Unit) {
        match self.sum(chain.get(&number), part) {
            Some(sum) => chain.insert(number, sum),
            None => chain.remove(&number),
        };
    }

    /// 1 or -1, if the cell may be added with it and that makes the cycle shorter.
    fn better_factor(&self, cell: u32, class: &Class, present: &HashMap<u32, F::Unit>) -> Option<F::Unit> {
        if class.death_number.is_some_and(|death| self.pairs.next.numbers[cell as usize] >= death) {
            return None;
        }
        let faces = self.matrix.column(cell as usize);
        let number = |face: usize| self.pairs.here.numbers[face];
        if faces.iter().any(|(face, _)| number(face) >= class.birth_number) {
            return None;
        }
        let size = |unit: F::Unit| (self.integer)(unit).abs();
        [1, -1].into_iter().filter_map(|factor| self.field.unit(factor)).find(|&factor| {
            let change: i64 = faces
                .iter()
                .filter_map(|(face, x)| {
                    let part = self.field.product(factor, self.field.unit(x)?);
                    let old = present.get(&number(face));
                    Some(self.sum(old, part).map_or(0, size) - old.map_or(0, |&old| size(old)))
                })
                .sum();
            change < 0
        })
    }
}
