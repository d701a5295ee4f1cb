//! Columns that are reduced only when they are asked for, with a record of what was added to them.

use super::reduction::{Columns, NONE, Sum};
use coface_algebra::Field;
use std::cmp::Reverse;
use std::collections::{BinaryHeap, HashMap};

/// Reduces columns of a matrix whose pairs of column and leading row are known.
///
/// A column is reduced by those that own its leading rows, until the lead is its own or nothing is left. What has its own lead from the start is
/// taken as it is and not stored.
pub(super) struct Elimination<'a, F: Field> {
    field: &'a F,
    columns: Columns<F::Unit>,
    /// For each row the column that has it as its lead in the end, or [`NONE`].
    owners: Vec<u32>,
    /// Where the columns are that were reduced.
    places: HashMap<u32, usize>,
    reduced: Columns<F::Unit>,
    /// For each of them the columns that were added, and how often.
    added: Columns<F::Unit>,
    unit: F::Unit,
}

/// A column that waits for another one.
struct Waiting<'a, F: Field> {
    column: u32,
    sum: Sum<'a, F>,
    added: Vec<(u32, F::Unit)>,
}

impl<'a, F: Field> Elimination<'a, F> {
    pub(super) fn new(field: &'a F, unit: F::Unit, columns: Columns<F::Unit>, owners: Vec<u32>) -> Self {
        let [reduced, added] = [(); 2].map(|()| Columns { starts: vec![0], entries: Vec::new() });
        Self { field, columns, owners, places: HashMap::new(), reduced, added, unit }
    }

    /// Whether the column needs no reduction.
    fn is_reduced_by_itself(&self, column: u32) -> bool {
        self.columns
            .column(column as usize)
            .first()
            .is_some_and(|&(row, _)| self.owners[row as usize] == column)
    }

    fn begun(&self, column: u32) -> Waiting<'a, F> {
        let terms = self.columns.column(column as usize).iter().map(|&term| Reverse(term)).collect();
        Waiting { column, sum: Sum { field: self.field, terms }, added: Vec::new() }
    }

    /// The reduced column, its rows rising; empty for a column that owns no row.
    pub(super) fn reduced(&mut self, column: u32) -> &[(u32, F::Unit)] {
        self.reduce(column);
        self.known(column)
    }

    fn known(&self, column: u32) -> &[(u32, F::Unit)] {
        match self.places.get(&column) {
            Some(&place) => self.reduced.column(place),
            None => self.columns.column(column as usize),
        }
    }

    fn reduce(&mut self, column: u32) {
        let mut waiting = Vec::new();
        if !self.places.contains_key(&column) && !self.is_reduced_by_itself(column) {
            waiting.push(self.begun(column));
        }
        while let Some(mut top) = waiting.pop() {
            // The column that the top waits for.
            let mut wanted = None;
            while let Some((row, coefficient)) = top.sum.pop() {
                let owner = self.owners[row as usize];
                if owner == top.column || owner == NONE {
                    self.reduced.entries.push((row, coefficient));
                    while let Some(term) = top.sum.pop() {
                        self.reduced.entries.push(term);
                    }
                    break;
                }
                if !self.places.contains_key(&owner) && !self.is_reduced_by_itself(owner) {
                    top.sum.terms.push(Reverse((row, coefficient)));
                    wanted = Some(owner);
                    break;
                }
                let other = self.known(owner);
                let factor = self.field.eliminator(coefficient, other[0].1);
                top.added.push((owner, factor));
                let terms = other[1..].iter().map(|&(row, x)| Reverse((row, self.field.product(factor, x))));
                top.sum.terms.extend(terms);
            }
            if let Some(wanted) = wanted {
                waiting.push(top);
                waiting.push(self.begun(wanted));
                continue;
            }
            self.places.insert(top.column, self.added.starts.len() - 1);
            self.reduced.starts.push(self.reduced.entries.len());
            self.added.entries.extend(top.added);
            self.added.starts.push(self.added.entries.len());
        }
    }

    /// The combination of columns that the reduced column is: the columns with their coefficients, that of the column itself first. What was added to
    /// a column has lower numbers than the column.
    pub(super) fn combination(&mut self, column: u32) -> Vec<(u32, F::Unit)> {
        self.reduce(column);
        let mut terms = BinaryHeap::from([Reverse((u32::MAX - column, self.unit))]);
        let mut sum = Sum { field: self.field, terms: std::mem::take(&mut terms) };
        let mut all = Vec::new();
        while let Some((from_last, coefficient)) = sum.pop() {
            let column = u32::MAX - from_last;
            all.push((column, coefficient));
            let Some(&place) = self.places.get(&column) else { continue };
            for &(added, factor) in self.added.column(place) {
                let factor = self.field.product(coefficient, factor);
                sum.terms.push(Reverse((u32::MAX - added, factor)));
            }
        }
        all
    }
}
