//! Elimination of a sparse integer matrix down to a diagonal, over the integers or modulo one integer.

use crate::ids::narrow;
use crate::integers::Integer;
use crate::matrices::sparse_vector::entry_of;
use crate::matrices::{Entry, SparseMatrix, SparseVector};
use crate::matrices::{combination, linear_combination};
use crate::normal_forms::hermite::{HermiteTransform, hermite_with_transform};
use crate::progress::{Steps, stage};
use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// A pivot that stands alone in its row and column.
#[derive(Clone, Debug)]
pub(super) struct Pivot {
    pub(super) row: u32,
    pub(super) column: u32,
    pub(super) value: Integer,
}

/// A matrix on its way to a diagonal.
///
/// Rows are stored; each column also has a list of the rows that may meet it, which may name a row twice or in vain.
/// Pivots are taken by least absolute value, then by least fill (the cost of Markowitz: row count less one times column
/// count less one, kept up to date lazily). The column of a pivot is cleared by row operations, with remainders as new
/// pivots when the division leaves any; then the column holds nothing else, and column operations touch the pivot row
/// alone.
pub(super) struct Elimination {
    rows: Vec<SparseVector>,
    columns: Vec<Vec<u32>>,
    column_counts: Vec<u32>,
    heap: BinaryHeap<Reverse<(u64, u64, u32)>>,
    modulus: Option<Integer>,
    transforms: Option<Transforms>,
    /// Whether an entry has left 64 bits.
    is_wide: bool,
    spare: SparseVector,
    pub(super) pivots: Vec<Pivot>,
    /// One for each row.
    steps: Steps,
}

/// Which vectors of a matrix are recombined.
#[derive(Clone, Copy, Debug)]
enum Side {
    Rows,
    Columns,
}

/// The row and column operations so far: `left * original * right` is the present matrix.
pub(super) struct Transforms {
    pub(super) left_rows: Vec<SparseVector>,
    pub(super) left_inverse_columns: Vec<SparseVector>,
    pub(super) right_columns: Vec<SparseVector>,
    pub(super) right_inverse_rows: Vec<SparseVector>,
}

impl Transforms {
    fn identity(row_count: usize, column_count: usize) -> Self {
        let unit = |count: usize| (0..narrow(count)).map(|i| vec![(i, Integer::ONE)]).collect::<Vec<_>>();
        Self {
            left_rows: unit(row_count),
            left_inverse_columns: unit(row_count),
            right_columns: unit(column_count),
            right_inverse_rows: unit(column_count),
        }
    }

    /// Row `i` minus `factor` times row `r`.
    fn subtract_row(&mut self, i: u32, factor: &Integer, r: u32) {
        add_multiple_of(&mut self.left_rows, i, &-factor, r);
        add_multiple_of(&mut self.left_inverse_columns, r, factor, i);
    }

    /// Rows or columns replaced by combinations of them: number i of these by row i of the transform.
    fn recombine(&mut self, side: Side, numbers: &[u32], by: &HermiteTransform) {
        let (own, inverse) = match side {
            Side::Rows => (&mut self.left_rows, &mut self.left_inverse_columns),
            Side::Columns => (&mut self.right_columns, &mut self.right_inverse_rows),
        };
        for (vectors, combinations) in [(own, &by.transform), (inverse, &by.inverse_columns)] {
            let old: Vec<SparseVector> =
                numbers.iter().map(|&j| std::mem::take(&mut vectors[j as usize])).collect();
            for (&j, coefficients) in numbers.iter().zip(combinations) {
                let terms = coefficients.iter().zip(&old).filter(|(x, _)| !x.is_zero());
                vectors[j as usize] = linear_combination(terms.map(|(x, vector)| (x, &vector[..])));
            }
        }
    }

    /// Column `j` minus `factor` times column `c`.
    fn subtract_column(&mut self, j: u32, factor: &Integer, c: u32) {
        add_multiple_of(&mut self.right_columns, j, &-factor, c);
        add_multiple_of(&mut self.right_inverse_rows, c, factor, j);
    }
}

impl Elimination {
    /// The elimination of a matrix over the integers, with transforms if they are wanted.
    pub(super) fn new<E: Entry>(matrix: &SparseMatrix<E>, with_transforms: bool) -> Self {
        let mut rows = vec![SparseVector::new(); matrix.row_count()];
        for (j, column) in matrix.columns().enumerate() {
            for (i, entry) in column.terms() {
                rows[i].push((narrow(j), entry.to_integer()));
            }
        }
        let transforms =
            with_transforms.then(|| Transforms::identity(matrix.row_count(), matrix.column_count()));
        Self::of_rows(rows, matrix.column_count(), None, transforms)
    }

    /// The elimination of these rows modulo a positive integer.
    pub(super) fn modulo(rows: &[SparseVector], column_count: usize, modulus: &Integer) -> Self {
        let reduced = rows
            .iter()
            .map(|row| {
                let terms = row.iter().map(|(j, entry)| (*j, entry.div_rem_nearest(modulus).1));
                terms.filter(|(_, entry)| !entry.is_zero()).collect()
            })
            .collect();
        Self::of_rows(reduced, column_count, Some(modulus.clone()), None)
    }

    fn of_rows(
        rows: Vec<SparseVector>,
        column_count: usize,
        modulus: Option<Integer>,
        transforms: Option<Transforms>,
    ) -> Self {
        let mut columns = vec![Vec::new(); column_count];
        let mut is_wide = false;
        for (i, row) in rows.iter().enumerate() {
            for (j, entry) in row {
                columns[*j as usize].push(narrow(i));
                is_wide |= entry.to_i64().is_none();
            }
        }
        let column_counts = columns.iter().map(|column| narrow(column.len())).collect();
        let steps = stage("eliminating rows", rows.iter().filter(|row| !row.is_empty()).count());
        let mut elimination = Self {
            steps,
            rows,
            columns,
            column_counts,
            heap: BinaryHeap::new(),
            modulus,
            transforms,
            is_wide,
            spare: Vec::new(),
            pivots: Vec::new(),
        };
        for i in 0..narrow(elimination.rows.len()) {
            elimination.offer(i);
        }
        elimination
    }

    /// Runs to the end.
    pub(super) fn finish(&mut self) {
        while let Some((row, column, _)) = self.next_pivot() {
            self.isolate(row, column);
        }
    }

    /// Runs as long as pivots are units.
    pub(super) fn finish_units(&mut self) {
        while let Some((row, column, size)) = self.next_pivot() {
            if size > 1 {
                self.offer(row);
                return;
            }
            self.isolate(row, column);
        }
    }

    /// Brings what is left to a diagonal by Hermite forms of columns and rows in turns, whose transforms are small. So
    /// a remainder without units, whose elimination would make the transforms grow, becomes first a triangle as small
    /// as its torsion, then a diagonal.
    pub(super) fn diagonalize(&mut self) {
        let mut side = Side::Columns;
        while self.rows.iter().any(|row| row.len() > 1) || self.column_counts.iter().any(|&count| count > 1) {
            self.triangulate(side);
            side = match side {
                Side::Columns => Side::Rows,
                Side::Rows => Side::Columns,
            };
        }
    }

    /// Brings what is left to echelon form by operations on one side, then takes the units among its pivots.
    fn triangulate(&mut self, side: Side) {
        let rows: Vec<u32> =
            (0..narrow(self.rows.len())).filter(|&i| !self.rows[i as usize].is_empty()).collect();
        let mut columns: Vec<u32> =
            rows.iter().flat_map(|&i| self.rows[i as usize].iter().map(|&(j, _)| j)).collect();
        columns.sort_unstable();
        columns.dedup();
        let Some(transforms) = self.transforms.as_mut() else { return };
        let (vectors, places) = match side {
            Side::Rows => (&rows, &columns),
            Side::Columns => (&columns, &rows),
        };
        let mut dense = vec![vec![Integer::ZERO; places.len()]; vectors.len()];
        for (at, &i) in rows.iter().enumerate() {
            for (j, entry) in std::mem::take(&mut self.rows[i as usize]) {
                let column = columns.binary_search(&j).expect("columns are those of the rows");
                match side {
                    Side::Rows => dense[at][column] = entry,
                    Side::Columns => dense[column][at] = entry,
                }
            }
        }
        let hermite = hermite_with_transform(dense);
        transforms.recombine(side, vectors, &hermite);
        let mut form = hermite.form;
        for k in 0..form.len() {
            let Some(at) = form[k].iter().position(|entry| !entry.is_zero()) else { continue };
            if form[k][at] != Integer::ONE {
                continue;
            }
            // No other vector has an entry at this place: they are reduced by this one.
            for (other, entry) in
                form[k].iter().enumerate().skip(at + 1).filter(|(_, entry)| !entry.is_zero())
            {
                match side {
                    Side::Rows => transforms.subtract_column(places[other], entry, places[at]),
                    Side::Columns => transforms.subtract_row(places[other], entry, places[at]),
                }
            }
            form[k].fill(Integer::ZERO);
            let (row, column) = match side {
                Side::Rows => (vectors[k], places[at]),
                Side::Columns => (places[at], vectors[k]),
            };
            self.pivots.push(Pivot { row, column, value: Integer::ONE });
        }
        let mut new_rows = vec![SparseVector::new(); self.rows.len()];
        for (entries, &vector) in form.into_iter().zip(vectors) {
            for (entry, &place) in entries.into_iter().zip(places).filter(|(entry, _)| !entry.is_zero()) {
                match side {
                    Side::Rows => new_rows[vector as usize].push((place, entry)),
                    Side::Columns => new_rows[place as usize].push((vector, entry)),
                }
            }
        }
        let (pivots, transforms) = (std::mem::take(&mut self.pivots), self.transforms.take());
        *self = Self::of_rows(new_rows, self.columns.len(), None, transforms);
        self.pivots = pivots;
    }

    /// Runs as long as pivots are units or all entries fit in 64 bits; whether that was to the end.
    pub(super) fn finish_while_narrow(&mut self) -> bool {
        while let Some((row, column, size)) = self.next_pivot() {
            if size > 1 && self.is_wide {
                return false;
            }
            self.isolate(row, column);
        }
        true
    }

    /// What is left without empty rows and columns: the rows and the number of columns.
    pub(super) fn into_remainder(self) -> (Vec<SparseVector>, usize) {
        let mut rows = self.rows;
        rows.retain(|row| !row.is_empty());
        let mut new_number = vec![0; self.columns.len()];
        for &(j, _) in rows.iter().flatten() {
            new_number[j as usize] = 1;
        }
        let mut count = 0;
        for number in &mut new_number {
            count += *number;
            *number = count;
        }
        for (j, _) in rows.iter_mut().flatten() {
            *j = new_number[*j as usize] - 1;
        }
        (rows, count as usize)
    }

    /// The pivots, and the transforms if they were requested.
    pub(super) fn into_parts(self) -> (Vec<Pivot>, Option<Transforms>) {
        (self.pivots, self.transforms)
    }

    /// The best pivot of a row as (size, cost, column), size being the absolute value held down to 64 bits.
    fn best_of_row(&self, row: u32) -> Option<(u64, u64, u32)> {
        let terms = &self.rows[row as usize];
        let width = terms.len() as u64;
        let rate = |(j, entry): &(u32, Integer)| {
            let size = entry.to_i64().map_or(u64::MAX, i64::unsigned_abs);
            (size, (width - 1) * u64::from(self.column_counts[*j as usize] - 1), *j)
        };
        terms.iter().map(rate).min()
    }

    /// Notes that the entries of a row are new.
    fn offer(&mut self, row: u32) {
        if let Some((size, cost, _)) = self.best_of_row(row) {
            self.heap.push(Reverse((size, cost, row)));
        }
    }

    /// The next pivot as (row, column, size).
    fn next_pivot(&mut self) -> Option<(u32, u32, u64)> {
        while let Some(Reverse((size, cost, row))) = self.heap.pop() {
            let Some(best) = self.best_of_row(row) else { continue };
            if (best.0, best.1) > (size, cost) {
                self.heap.push(Reverse((best.0, best.1, row)));
                continue;
            }
            return Some((row, self.column_nearest_to_unit(row).unwrap_or(best.2), best.0));
        }
        None
    }

    /// Modulo an integer: the first column where this row has a unit, or else the entry of least common divisor
    /// with the modulus.
    fn column_nearest_to_unit(&self, row: u32) -> Option<u32> {
        let modulus = self.modulus.as_ref()?;
        let mut best: Option<(Integer, u32)> = None;
        for (j, entry) in &self.rows[row as usize] {
            let gcd = entry.gcd(modulus);
            if gcd.is_unit() {
                return Some(*j);
            }
            if best.as_ref().is_none_or(|(least, _)| gcd < *least) {
                best = Some((gcd, *j));
            }
        }
        best.map(|(_, j)| j)
    }

    /// Clears the row and the column of a pivot, or of the smaller ones that the divisions leave, and takes the pivot
    /// out of the matrix.
    fn isolate(&mut self, mut row: u32, mut column: u32) {
        loop {
            while let Some(smaller) = self.clear_column(row, column) {
                row = smaller;
            }
            match self.clear_row(row, column) {
                Some(smaller) => column = smaller,
                None => break,
            }
        }
        let (_, value) = self.rows[row as usize].pop().expect("the pivot is left alone in its row");
        self.column_counts[column as usize] = 0;
        self.columns[column as usize] = Vec::new();
        self.rows[row as usize] = Vec::new();
        self.pivots.push(Pivot { row, column, value });
        self.steps.advance(1);
    }

    /// Subtracts multiples of the pivot row from the others until their entries in the pivot column are smaller than
    /// the pivot; the row of the smallest one that is not zero.
    fn clear_column(&mut self, row: u32, column: u32) -> Option<u32> {
        self.scale_to_divisor(row, column);
        let pivot_row = std::mem::take(&mut self.rows[row as usize]);
        let pivot = entry_of(&pivot_row, column).expect("the pivot is not zero").clone();
        let mut others = std::mem::take(&mut self.columns[column as usize]);
        others.sort_unstable();
        others.dedup();
        let mut smallest: Option<(Integer, u32)> = None;
        others.retain(|&i| {
            if i == row {
                return true;
            }
            let Some(entry) = entry_of(&self.rows[i as usize], column) else { return false };
            let (quotient, rest) = entry.div_rem_nearest(&pivot);
            if !quotient.is_zero() {
                self.subtract_multiple(i, &quotient, &pivot_row);
                if let Some(transforms) = &mut self.transforms {
                    transforms.subtract_row(i, &quotient, row);
                }
                self.offer(i);
            }
            if rest.is_zero() {
                return false;
            }
            let size = rest.abs();
            if smallest.as_ref().is_none_or(|(least, _)| size < *least) {
                smallest = Some((size, i));
            }
            true
        });
        self.rows[row as usize] = pivot_row;
        // The subtractions wrote no new row into the pivot column: every row met there was in the list.
        self.columns[column as usize] = others;
        if smallest.is_some() {
            self.offer(row);
        }
        smallest.map(|(_, i)| i)
    }

    /// Reduces the entries of the pivot row by the pivot, which is alone in its column; the column of the smallest one
    /// that is not zero.
    fn clear_row(&mut self, row: u32, column: u32) -> Option<u32> {
        let mut terms = std::mem::take(&mut self.rows[row as usize]);
        let pivot = entry_of(&terms, column).expect("the pivot is not zero").clone();
        let mut smallest: Option<(Integer, u32)> = None;
        terms.retain_mut(|(j, entry)| {
            if *j == column {
                return true;
            }
            if let (true, None) = (pivot.is_unit(), &self.transforms) {
                self.column_counts[*j as usize] -= 1;
                return false;
            }
            let (quotient, rest) = entry.div_rem_nearest(&pivot);
            if let Some(transforms) = &mut self.transforms {
                transforms.subtract_column(*j, &quotient, column);
            }
            if rest.is_zero() {
                self.column_counts[*j as usize] -= 1;
                return false;
            }
            let size = rest.abs();
            if smallest.as_ref().is_none_or(|(least, _)| size < *least) {
                smallest = Some((size, *j));
            }
            *entry = rest;
            true
        });
        self.rows[row as usize] = terms;
        smallest.map(|(_, j)| j)
    }

    /// Row `i` minus `factor` times the pivot row.
    fn subtract_multiple(&mut self, i: u32, factor: &Integer, pivot_row: &[(u32, Integer)]) {
        self.steps.advance(0);
        let mut old = std::mem::take(&mut self.rows[i as usize]);
        let mut new = std::mem::take(&mut self.spare);
        let mut terms = old.drain(..).peekable();
        for (j, entry) in pivot_row {
            while let Some(term) = terms.next_if(|(at, _)| at < j) {
                new.push(term);
            }
            let product = factor * entry;
            let present = terms.next_if(|(at, _)| at == j);
            let was_zero = present.is_none();
            let mut value = present.map_or(Integer::ZERO, |(_, value)| value);
            value -= &product;
            if let Some(modulus) = &self.modulus {
                value = value.div_rem_nearest(modulus).1;
            }
            let count = &mut self.column_counts[*j as usize];
            match (was_zero, value.is_zero()) {
                (true, false) => {
                    *count += 1;
                    self.columns[*j as usize].push(i);
                }
                (false, true) => *count -= 1,
                _ => {}
            }
            if !value.is_zero() {
                self.is_wide |= value.to_i64().is_none();
                new.push((*j, value));
            }
        }
        new.extend(terms);
        self.rows[i as usize] = new;
        self.spare = old;
    }

    /// Modulo an integer: multiplies the pivot row by a unit such that the pivot becomes its greatest common divisor
    /// with the modulus.
    fn scale_to_divisor(&mut self, row: u32, column: u32) {
        let Some(modulus) = &self.modulus else { return };
        let terms = &mut self.rows[row as usize];
        let pivot = entry_of(terms, column).expect("the pivot is not zero");
        let (gcd, inverse, _) = pivot.extended_gcd(modulus);
        if gcd == *pivot {
            return;
        }
        // `inverse` times the pivot is the divisor; of the numbers that are so, one is prime to the modulus.
        let step = modulus.exact_quotient(&gcd).expect("a common divisor divides");
        let mut unit = inverse.div_rem_floor(&step).1;
        while !unit.gcd(modulus).is_unit() {
            unit += &step;
        }
        for (_, entry) in terms.iter_mut() {
            *entry = (&*entry * &unit).div_rem_nearest(modulus).1;
        }
    }
}

/// Adds `factor` times vector `source` to vector `target` of the list.
pub(super) fn add_multiple_of(vectors: &mut [SparseVector], target: u32, factor: &Integer, source: u32) {
    if factor.is_zero() {
        return;
    }
    let added = std::mem::take(&mut vectors[source as usize]);
    let old = std::mem::take(&mut vectors[target as usize]);
    vectors[target as usize] = combination(&Integer::ONE, &old, factor, &added);
    vectors[source as usize] = added;
}
