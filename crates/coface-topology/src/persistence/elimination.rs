//! Columns that are reduced only when they are asked for, with a record of what was added to them.

use super::cycles::Terms;
use super::reduction::{Columns, NONE};
use super::sum::Sum;
use coface_algebra::Field;
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// Reduces columns of a matrix whose pairs of column and leading row are known.
///
/// A column is reduced by those that own its leading rows, until the lead is its own or nothing is left. What has its own lead from the start is
/// taken as it is and not stored.
pub(super) struct Elimination<'a, F: Field, C> {
    field: &'a F,
    /// Writes a column, its rows rising.
    column: C,
    /// The column that was written last.
    written: Terms<F::Unit>,
    /// For each row the column that has it as its lead in the end, or [`NONE`].
    owners: Vec<u32>,
    /// Where the columns are that were reduced, or [`NONE`].
    places: Vec<u32>,
    reduced: Columns<F::Unit>,
    /// For each of them the columns that were added, and how often.
    added: Columns<F::Unit>,
    /// The column at hand.
    sum: Sum<F::Unit>,
    /// The combination at hand, from the last column to the first.
    combination: Sum<F::Unit>,
}

/// A column that waits for another one.
struct Waiting<U> {
    column: u32,
    /// The terms that were there when it began to wait, those of equal rows not yet added up.
    parked: BinaryHeap<Reverse<(u32, U)>>,
    added: Terms<U>,
}

impl<'a, F: Field, C: Fn(u32, &mut Terms<F::Unit>)> Elimination<'a, F, C> {
    pub(super) fn new(field: &'a F, count: usize, column: C, owners: Vec<u32>) -> Self {
        let sum = Sum::new(owners.len());
        Self {
            field,
            column,
            written: Vec::new(),
            owners,
            places: vec![NONE; count],
            reduced: Columns::new(),
            added: Columns::new(),
            sum,
            combination: Sum::new(count),
        }
    }

    /// Writes a column as it is, and says whether it needs no reduction.
    fn write(&mut self, column: u32) -> bool {
        self.written.clear();
        (self.column)(column, &mut self.written);
        self.written.first().is_some_and(|&(row, _)| self.owners[row as usize] == column)
    }

    /// Takes the column that was written last, to be reduced.
    fn begin(&mut self, column: u32) -> Waiting<F::Unit> {
        self.written.iter().for_each(|&(row, x)| self.sum.add(self.field, row, x));
        Waiting { column, parked: BinaryHeap::new(), added: Vec::new() }
    }

    /// Takes the first term out of a column.
    fn pop(&mut self, column: &mut Waiting<F::Unit>) -> Option<(u32, F::Unit)> {
        loop {
            while let Some(&Reverse((row, x))) = column.parked.peek()
                && self.sum.least_row().is_none_or(|least| row <= least)
            {
                column.parked.pop();
                self.sum.add(self.field, row, x);
            }
            let least = self.sum.least_row()?;
            if let Some(coefficient) = self.sum.take(least) {
                return Some((least, coefficient));
            }
        }
    }

    /// The reduced column, its rows rising; empty for a column that owns no row.
    pub(super) fn reduced(&mut self, column: u32) -> &[(u32, F::Unit)] {
        self.reduce(column);
        match self.places[column as usize] {
            NONE => &self.written,
            place => self.reduced.column(place as usize),
        }
    }

    /// Reduces a column; it is the one that was written last if it needs no reduction.
    pub(super) fn reduce(&mut self, column: u32) {
        if self.places[column as usize] != NONE || self.write(column) {
            return;
        }
        let mut waiting = vec![self.begin(column)];
        while let Some(mut top) = waiting.pop() {
            // The column that the top waits for.
            let mut wanted = None;
            while let Some((row, coefficient)) = self.pop(&mut top) {
                let owner = self.owners[row as usize];
                if owner == top.column || owner == NONE {
                    self.reduced.entries.push((row, coefficient));
                    while let Some(term) = self.pop(&mut top) {
                        self.reduced.entries.push(term);
                    }
                    break;
                }
                let place = self.places[owner as usize];
                if place == NONE && !self.write(owner) {
                    top.parked.push(Reverse((row, coefficient)));
                    while let Some(term) = self.sum.pop() {
                        top.parked.push(Reverse(term));
                    }
                    wanted = Some(self.begin(owner));
                    break;
                }
                let other = if place == NONE { &self.written } else { self.reduced.column(place as usize) };
                let factor = self.field.eliminator(coefficient, other[0].1);
                top.added.push((owner, factor));
                for &(row, x) in &other[1..] {
                    self.sum.add(self.field, row, self.field.product(factor, x));
                }
            }
            if let Some(wanted) = wanted {
                waiting.push(top);
                waiting.push(wanted);
                continue;
            }
            self.places[top.column as usize] = self.added.starts.len() as u32 - 1;
            self.reduced.end_column();
            self.added.entries.extend(top.added);
            self.added.end_column();
        }
    }

    /// Appends the combination of columns that a multiple of the reduced column is: the columns with their coefficients, that of the column itself first.
    /// What was added to a column has lower numbers than the column.
    pub(super) fn combination(&mut self, column: u32, factor: F::Unit, all: &mut Terms<F::Unit>) {
        self.reduce(column);
        let last = self.places.len() as u32 - 1;
        self.combination.add(self.field, last - column, factor);
        while let Some((from_last, coefficient)) = self.combination.pop() {
            let column = last - from_last;
            all.push((column, coefficient));
            let place = self.places[column as usize];
            if place == NONE {
                continue;
            }
            for &(added, factor) in self.added.column(place as usize) {
                let part = self.field.product(coefficient, factor);
                self.combination.add(self.field, last - added, part);
            }
        }
    }
}
