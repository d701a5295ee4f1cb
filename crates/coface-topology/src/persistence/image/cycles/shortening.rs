//! Cycles of an image that lose cells.

use super::super::gradient::{Cell, Gradient};
use super::flow::Terms;
use coface_algebra::{Field, SpreadMap};
use std::collections::VecDeque;

/// Adds boundaries of single cells to cycles: of a dual image coboundaries, as cells have opposite roles there.
pub(super) struct Shortening<'a, F: Field, N> {
    pub(super) field: &'a F,
    pub(super) integer: &'a N,
    pub(super) gradient: &'a Gradient,
    pub(super) is_dual: bool,
}

impl<F: Field, N: Fn(F::Unit) -> i64> Shortening<'_, F, N> {
    /// The cells that a cell is a face of, in the image.
    fn cofaces(&self, cell: Cell, mut found: impl FnMut(Cell)) {
        match self.is_dual {
            false => self.gradient.cofacets(cell).for_each(|(coface, _)| found(coface)),
            true => self.gradient.facets(cell).for_each(|(coface, _)| found(coface)),
        }
    }

    /// The boundary of a cell in the image.
    fn boundary(&self, cell: Cell, terms: &mut Terms<F::Unit>) {
        let unit = |is_negative: bool| {
            self.field.unit(if is_negative { -1 } else { 1 }).expect("1 and -1 are not 0 in a field")
        };
        terms.clear();
        match self.is_dual {
            false => terms.extend(self.gradient.facets(cell).map(|(face, x)| (face, unit(x)))),
            true => terms.extend(self.gradient.cofacets(cell).map(|(face, x)| (face, unit(x)))),
        }
    }

    /// Makes a cycle shorter by boundaries of cells that enter no later than the rank of its class, and whose faces enter before the cell that makes it. Cells of
    /// lower ranks enter first, of a dual image those of higher ones. Gives these cells.
    pub(super) fn shorten(&self, birth: Cell, last: u32, cycle: &mut Terms<F::Unit>) -> Terms<F::Unit> {
        let is_in_time = |cell: Cell| match self.is_dual {
            false => cell.rank() <= last,
            true => cell.rank() >= last,
        };
        let is_before = |cell: Cell| if self.is_dual { cell > birth } else { cell < birth };
        let size = |unit: Option<F::Unit>| unit.map_or(0, |unit| (self.integer)(unit).abs());
        let mut factors: Vec<F::Unit> = [1, -1].into_iter().filter_map(|x| self.field.unit(x)).collect();
        factors.dedup();
        let mut terms: SpreadMap<Cell, F::Unit> = cycle.iter().copied().collect();
        let mut waiting: SpreadMap<Cell, bool> = SpreadMap::default();
        let mut queue = VecDeque::new();
        let offer = |face: Cell, waiting: &mut SpreadMap<Cell, bool>, queue: &mut VecDeque<Cell>| {
            self.cofaces(face, |coface| {
                if is_in_time(coface) && waiting.insert(coface, true) != Some(true) {
                    queue.push_back(coface);
                }
            });
        };
        cycle.iter().for_each(|&(cell, _)| offer(cell, &mut waiting, &mut queue));
        let (mut boundary, mut added) = (Vec::new(), Vec::new());
        while let Some(cell) = queue.pop_front() {
            waiting.insert(cell, false);
            self.boundary(cell, &mut boundary);
            if !boundary.iter().all(|&(face, _)| is_before(face)) {
                continue;
            }
            let with = |factor: F::Unit, &(face, x): &(Cell, F::Unit)| {
                let part = self.field.product(factor, x);
                let old = terms.get(&face).copied();
                (old, old.map_or(Some(part), |old| self.field.sum(old, part)))
            };
            let better = factors.iter().copied().find(|&factor| {
                let change = |term| {
                    let (old, new) = with(factor, term);
                    size(new) - size(old)
                };
                boundary.iter().map(change).sum::<i64>() < 0
            });
            let Some(factor) = better else { continue };
            let new: Vec<(Cell, Option<F::Unit>)> =
                boundary.iter().map(|term| (term.0, with(factor, term).1)).collect();
            for (face, unit) in new {
                match unit {
                    Some(unit) => terms.insert(face, unit),
                    None => terms.remove(&face),
                };
                offer(face, &mut waiting, &mut queue);
            }
            added.push((cell, factor));
        }
        if !added.is_empty() {
            *cycle = terms.into_iter().collect();
        }
        added
    }
}
