//! How many items lists have in common with other lists: a product of sparse matrices that is never stored.
//!
//! Row by row, as in Gustavson's algorithm: the lists of columns at the items of the row are run through, and a dense array
//! counts how often each column is met. A column is written down at the moment its count reaches the threshold. Counts
//! begin at a base that moves on with each row, so that nothing is cleared between rows.

use crate::lar::parts::in_parts;
use coface_algebra::RaggedArray;
use coface_algebra::{Error, ErrorKind};
use rayon::prelude::*;
use std::borrow::Cow;
use std::ops::Range;

/// Lists of items as rows, and the columns that have each item.
pub(super) struct Overlaps<'a> {
    pub(super) rows: Cow<'a, RaggedArray>,
    /// For each item the columns that have it, rising.
    pub(super) columns_at: RaggedArray,
    pub(super) column_count: usize,
}

/// The counts of one row after the other, and the columns that reached the threshold.
pub(super) struct Counter {
    /// A column has been met `marks[column] - base` times in this row, if that is positive.
    marks: Vec<u32>,
    base: u32,
    /// The greatest mark of this row.
    limit: u32,
    found: Vec<u32>,
}

impl Counter {
    pub(super) fn new(column_count: usize) -> Self {
        Self { marks: vec![0; column_count], base: 0, limit: 0, found: Vec::new() }
    }

    /// The columns that have at least `threshold` items of the row, which is positive, in the order in which they reach it.
    fn reached(&mut self, overlaps: &Overlaps<'_>, row: usize, threshold: u32) -> &[u32] {
        let items = overlaps.rows.list(row);
        let length = items.len() as u32;
        self.base = self.limit;
        if length > u32::MAX - self.base {
            self.marks.fill(0);
            self.base = 0;
        }
        self.limit = self.base + length;
        if threshold > length {
            return &[];
        }
        let meetings: usize = items.iter().map(|&item| overlaps.columns_at.list(item as usize).len()).sum();
        if self.found.len() < meetings {
            self.found.resize(meetings, 0);
        }
        let (base, reached, mut count) = (self.base, self.base + threshold, 0);
        for &item in items {
            for &column in overlaps.columns_at.list(item as usize) {
                let mark = &mut self.marks[column as usize];
                let met = (*mark).max(base) + 1;
                *mark = met;
                // Written always and kept only when it counts: no branch to predict.
                self.found[count] = column;
                count += usize::from(met == reached);
            }
        }
        &self.found[..count]
    }

    /// How often a column was met in the last row, if it was.
    pub(super) fn count(&self, column: u32) -> u32 {
        self.marks[column as usize] - self.base
    }

    /// The columns that have an item of the row, appended to a list.
    pub(super) fn push_row_unsorted(&mut self, overlaps: &Overlaps<'_>, row: usize, list: &mut Vec<u32>) {
        list.extend_from_slice(self.reached(overlaps, row, 1));
    }

    /// The columns that have at least `threshold` items of the row and pass a test of their number and count, appended to a
    /// list, rising.
    pub(super) fn push_row(
        &mut self,
        overlaps: &Overlaps<'_>,
        row: usize,
        threshold: u32,
        keep: impl Fn(u32, u32) -> bool,
        list: &mut Vec<u32>,
    ) {
        let start = list.len();
        let count = self.reached(overlaps, row, threshold).len();
        let found = self.found[..count].iter().copied();
        list.extend(found.filter(|&column| keep(column, self.count(column))));
        list[start..].sort_unstable();
    }
}

impl Overlaps<'_> {
    /// Gives ranges of rows with a counter to `work`, in parallel; the results in the order of the ranges.
    pub(super) fn in_parts<T: Send>(&self, work: impl Fn(&mut Counter, Range<usize>) -> T + Sync) -> Vec<T> {
        in_parts(self.rows.len(), || Counter::new(self.column_count), work)
    }
}

/// Consecutive lists: where each ends among the items, and the items.
pub(super) type Part = (Vec<u32>, Vec<u32>);

/// The lists of all parts, one after the other.
pub(super) fn joined(parts: Vec<Part>) -> Result<(Vec<u32>, Vec<u32>), Error> {
    let list_count: usize = parts.iter().map(|(ends, _)| ends.len()).sum();
    let item_count: usize = parts.iter().map(|(_, items)| items.len()).sum();
    if u32::try_from(item_count).is_err() {
        return Err(Error::new(
            ErrorKind::TooLarge,
            format!("{item_count} related pairs of cells; the limit is 2^32 - 1"),
        )
        .with_cure("take the rows one by one, or ask for more shared vertices"));
    }
    let (mut starts, mut items) = (vec![0; list_count + 1], vec![0; item_count]);
    let (mut rest_starts, mut rest_items, mut shift) = (&mut starts[1..], &mut items[..], 0u32);
    let mut pieces = Vec::with_capacity(parts.len());
    for part in parts {
        let (own_starts, more_starts) = rest_starts.split_at_mut(part.0.len());
        let (own_items, more_items) = rest_items.split_at_mut(part.1.len());
        let count = part.1.len() as u32;
        pieces.push((part, shift, own_starts, own_items));
        (rest_starts, rest_items, shift) = (more_starts, more_items, shift + count);
    }
    pieces.into_par_iter().for_each(|((ends, list), shift, own_starts, own_items)| {
        own_items.copy_from_slice(&list);
        own_starts.iter_mut().zip(ends).for_each(|(start, end)| *start = shift + end);
    });
    Ok((starts, items))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Marks begin anew when the base has no room any more.
    #[test]
    fn counts_survive_the_end_of_the_numbers() {
        let rows = RaggedArray::from_lists([[0, 1], [1, 2], [0, 2]]);
        let overlaps =
            Overlaps { columns_at: rows.transposed(3), column_count: 3, rows: Cow::Borrowed(&rows) };
        for spare in 0..8 {
            let mut counter = Counter::new(3);
            counter.limit = u32::MAX - spare;
            counter.marks.fill(counter.limit);
            for row in 0..3 {
                let mut list = Vec::new();
                counter.push_row(&overlaps, row, 1, |_, _| true, &mut list);
                assert_eq!(list, [0, 1, 2]);
                let counts: Vec<u32> = list.iter().map(|&column| counter.count(column)).collect();
                assert!((0..3).all(|column| counts[column] == if column == row { 2 } else { 1 }));
                list.clear();
                counter.push_row(&overlaps, row, 3, |_, _| true, &mut list);
                assert!(list.is_empty());
            }
        }
    }
}
