//! Cycles of a diagram that lose cells.

use super::cycles::{Pairs, Terms};
use super::reduction::Columns;
use super::{Filtration, PersistencePair};
use coface_algebra::{Field, SparseMatrix};
use std::collections::VecDeque;

/// Adds boundaries of single cells to cycles of one degree. Cells have their numbers of entrance.
pub(super) struct Shortening<'a, F: Field, N> {
    field: &'a F,
    integer: &'a N,
    matrix: &'a SparseMatrix,
    pairs: &'a Pairs<'a>,
    cofaces: &'a Columns<F::Unit>,
    values: &'a [f64],
    is_falling: bool,
    /// 1 and -1, which are one over two elements.
    factors: Vec<F::Unit>,
    cycle: Workspace<F::Unit>,
    added: Workspace<F::Unit>,
    /// The cells to be tried, and whether a cell is among them.
    queue: VecDeque<u32>,
    is_waiting: Vec<bool>,
}

/// A cycle and the chain that it bounds, or what was added to that.
type Shorter<U> = (Terms<U>, Terms<U>);

/// A chain with a place for each cell.
struct Workspace<U> {
    terms: Vec<Option<U>>,
    /// The cells whose place was written to, some of them more than once.
    touched: Vec<u32>,
}

impl<U: Copy> Workspace<U> {
    fn new(count: usize) -> Self {
        Self { terms: vec![None; count], touched: Vec::new() }
    }

    fn add<F: Field<Unit = U>>(&mut self, field: &F, number: u32, part: U) {
        let place = &mut self.terms[number as usize];
        *place = match *place {
            Some(old) => field.sum(old, part),
            None => {
                self.touched.push(number);
                Some(part)
            }
        };
    }

    fn clear(&mut self) {
        for number in self.touched.drain(..) {
            self.terms[number as usize] = None;
        }
    }

    /// Takes the chain out.
    fn take(&mut self) -> Terms<U> {
        let terms = &mut self.terms;
        self.touched.drain(..).filter_map(|number| Some((number, terms[number as usize].take()?))).collect()
    }
}

impl<'a, F: Field, N: Fn(F::Unit) -> i64> Shortening<'a, F, N> {
    /// `None` where no boundary can be added: of points, which are as short as they can be, and of cells without cofaces.
    pub(super) fn new(
        field: &'a F,
        integer: &'a N,
        filtration: &'a Filtration,
        pairs: &'a Pairs<'a>,
        cofaces: Option<&'a Columns<F::Unit>>,
    ) -> Option<Self> {
        let matrix = pairs.complex.boundary_matrix(pairs.degree + 1).filter(|_| pairs.degree > 0)?;
        let mut factors: Vec<F::Unit> = [1, -1].into_iter().filter_map(|factor| field.unit(factor)).collect();
        factors.dedup();
        Some(Self {
            field,
            integer,
            matrix,
            pairs,
            cofaces: cofaces?,
            values: filtration.values(pairs.degree + 1),
            is_falling: filtration.is_falling(),
            factors,
            cycle: Workspace::new(pairs.here.cells.len()),
            added: Workspace::new(pairs.next.cells.len()),
            queue: VecDeque::new(),
            is_waiting: vec![false; pairs.next.cells.len()],
        })
    }

    /// A cycle made shorter by boundaries of cells that enter no later than its class, before the cell that ends it, and whose faces enter before the
    /// cell that makes it: the class, its last cell and the coefficient of that stay. The chain that the cycle bounds gains the same cells; without
    /// one, they are given alone. `None` if the cycle stays. Its cells are given from the last one to enter to the first.
    pub(super) fn shorter(
        &mut self,
        pair: &PersistencePair,
        cycle: &[(u32, F::Unit)],
        bounding: Option<&[(u32, F::Unit)]>,
    ) -> Option<Shorter<F::Unit>> {
        let (here, next) = (self.pairs.here, self.pairs.next);
        let birth_number = here.number(pair.birth_cell());
        // The number of cells that enter in time.
        let in_time = next.cells.partition_point(|&cell| {
            let value = self.values[cell as usize];
            if self.is_falling { value >= pair.birth() } else { value <= pair.birth() }
        }) as u32;
        let end = pair.death_cell().map_or(in_time, |death| in_time.min(next.number(death)));
        cycle.iter().rev().for_each(|&(number, _)| self.offer(number, end));
        if self.queue.is_empty() {
            return None;
        }
        cycle.iter().for_each(|&(number, unit)| self.cycle.add(self.field, number, unit));
        while let Some(cell) = self.queue.pop_front() {
            self.is_waiting[cell as usize] = false;
            let Some(factor) = self.better_factor(cell, birth_number) else { continue };
            for (face, x) in self.matrix.column(next.cells[cell as usize] as usize).iter() {
                let Some(unit) = self.field.unit(x) else { continue };
                let number = here.numbers[face];
                self.cycle.add(self.field, number, self.field.product(factor, unit));
                self.offer(number, end);
            }
            self.added.add(self.field, cell, factor);
        }
        if self.added.touched.is_empty() {
            self.cycle.clear();
            return None;
        }
        for &(number, unit) in bounding.into_iter().flatten() {
            self.added.add(self.field, number, unit);
        }
        Some((self.cycle.take(), self.added.take()))
    }

    /// The cofaces of a cell that enter before the end are to be tried.
    fn offer(&mut self, face: u32, end: u32) {
        for &(coface, _) in self.cofaces.column(face as usize).iter().take_while(|&&(coface, _)| coface < end)
        {
            if !std::mem::replace(&mut self.is_waiting[coface as usize], true) {
                self.queue.push_back(coface);
            }
        }
    }

    /// 1 or -1, if the cell may be added with it and that makes the cycle shorter.
    fn better_factor(&self, cell: u32, birth_number: u32) -> Option<F::Unit> {
        let faces = self.matrix.column(self.pairs.next.cells[cell as usize] as usize);
        let number = |face: usize| self.pairs.here.numbers[face];
        if faces.iter().any(|(face, _)| number(face) >= birth_number) {
            return None;
        }
        let size = |unit: Option<F::Unit>| unit.map_or(0, |unit| (self.integer)(unit).abs());
        self.factors.iter().copied().find(|&factor| {
            let change: i64 = faces
                .iter()
                .filter_map(|(face, x)| {
                    let part = self.field.product(factor, self.field.unit(x)?);
                    let old = self.cycle.terms[number(face) as usize];
                    let new = old.map_or(Some(part), |old| self.field.sum(old, part));
                    Some(size(new) - size(old))
                })
                .sum();
            change < 0
        })
    }
}
