//! Products of sparse matrices with matrices and vectors.

use crate::error::{Error, ErrorKind};
use crate::ids::narrow;
use crate::integers::Integer;
use crate::matrices::entry::Entry;
use crate::matrices::integer_matrix::IntegerMatrix;
use crate::matrices::sparse_matrix::{SparseMatrix, WideMatrix, factor_fault};
use crate::progress::stage;
use crate::threads;

/// Consecutive columns of a matrix: their lengths, rows and entries.
pub type ColumnBlock = (Vec<u32>, Vec<u32>, Vec<i32>);

/// Starts, rows and entries of all columns, from blocks of them in order.
///
/// # Errors
/// [`ErrorKind::TooLarge`] beyond 2^32 - 1 entries.
pub fn joined_columns(column_count: usize, blocks: Vec<ColumnBlock>) -> Result<ColumnBlock, Error> {
    let entry_count: usize = blocks.iter().map(|(_, rows, _)| rows.len()).sum();
    if u32::try_from(entry_count).is_err() {
        return Err(Error::new(
            ErrorKind::TooLarge,
            format!("{entry_count} entries in a product of matrices; the limit is 2^32 - 1"),
        ));
    }
    let mut starts = Vec::with_capacity(column_count + 1);
    let (mut rows, mut entries) = (Vec::with_capacity(entry_count), Vec::with_capacity(entry_count));
    let mut total = 0;
    starts.push(total);
    for (lengths, block_rows, block_entries) in blocks {
        starts.extend(lengths.into_iter().map(|length| {
            total += length;
            total
        }));
        rows.extend(block_rows);
        entries.extend(block_entries);
    }
    Ok((starts, rows, entries))
}

/// Columns that one task multiplies.
const BLOCK: usize = 1 << 12;

impl<E: Entry> SparseMatrix<E> {
    /// The product `self * other`, with 32-bit entries if they suffice and with big integers if not.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless `other` has as many rows as `self` has columns; [`ErrorKind::TooLarge`] beyond 2^32
    /// entries.
    ///
    /// # Complexity
    /// $O(m \log c)$ for m multiplications, at most c in one column; columns run in parallel.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{Integer, SparseMatrix};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let million = SparseMatrix::from_entries(1, 1, [(0, 0, 1_000_000)])?;
    /// let product = million.product(&million)?;
    /// assert!(product.as_narrow().is_none());
    /// assert_eq!(product.into_wide().entry(0, 0), Integer::from(1_000_000_000_000_i64));
    /// # Ok(()) }
    /// ```
    pub fn product<F: Entry>(&self, other: &SparseMatrix<F>) -> Result<IntegerMatrix, Error> {
        self.check_factor(other)?;
        match self.narrow_product(other) {
            Some(product) => Ok(IntegerMatrix::Narrow(product?)),
            None => Ok(self.wide_product(other)?.into()),
        }
    }

    /// The product `self * other` with 32-bit entries.
    ///
    /// # Errors
    /// As [`Self::product`], and [`ErrorKind::TooLarge`] naming the first entry that leaves 32 bits.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?;
    /// assert_eq!(edges.transpose().checked_product(&edges)?.entry(0, 0), 2);
    /// # Ok(()) }
    /// ```
    pub fn checked_product<F: Entry>(&self, other: &SparseMatrix<F>) -> Result<SparseMatrix, Error> {
        self.product(other)?.into_narrow()
    }

    /// The product of the matrix with a column vector.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless the vector has an entry for each column.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(2, 2, [(0, 0, 1), (0, 1, 2), (1, 1, 3)])?;
    /// assert_eq!(matrix.times_vector(&[1.into(), 10.into()])?, [21.into(), 30.into()]);
    /// # Ok(()) }
    /// ```
    pub fn times_vector(&self, vector: &[Integer]) -> Result<Vec<Integer>, Error> {
        if vector.len() != self.column_count() {
            return Err(factor_fault(self.column_count(), vector.len(), 1));
        }
        let mut sums = vec![Integer::ZERO; self.row_count()];
        for (column, factor) in self.columns().zip(vector) {
            if factor.is_zero() {
                continue;
            }
            for (i, entry) in column.terms() {
                sums[i] += &(&entry.to_integer() * factor);
            }
        }
        Ok(sums)
    }

    fn check_factor<F: Entry>(&self, other: &SparseMatrix<F>) -> Result<(), Error> {
        if self.column_count() == other.row_count() {
            Ok(())
        } else {
            Err(factor_fault(self.column_count(), other.row_count(), other.column_count()))
        }
    }

    /// The product in machine integers; `None` when one does not suffice.
    fn narrow_product<F: Entry>(&self, other: &SparseMatrix<F>) -> Option<Result<SparseMatrix, Error>> {
        let steps = stage("multiplying matrices", other.column_count());
        let block_count = other.column_count().div_ceil(BLOCK);
        let blocks: Vec<Option<ColumnBlock>> =
            threads::mapped(block_count, self.entries().len() + other.entries().len(), |block| {
                let (mut lengths, mut rows, mut entries) = (Vec::new(), Vec::new(), Vec::new());
                let mut terms: Vec<(u32, i64)> = Vec::new();
                let columns = block * BLOCK..((block + 1) * BLOCK).min(other.column_count());
                steps.advance(columns.len());
                for j in columns {
                    terms.clear();
                    for (k, factor) in other.column(j).terms() {
                        let factor = factor.to_i64()?;
                        let column = self.column(k);
                        for (&row, entry) in column.rows().iter().zip(column.entries()) {
                            terms.push((row, factor.checked_mul(entry.to_i64()?)?));
                        }
                    }
                    terms.sort_unstable_by_key(|&(row, _)| row);
                    let start = rows.len();
                    for group in terms.chunk_by(|a, b| a.0 == b.0) {
                        let sum: i128 = group.iter().map(|&(_, value)| i128::from(value)).sum();
                        if sum != 0 {
                            rows.push(group[0].0);
                            entries.push(i32::try_from(sum).ok().filter(|&sum| sum != i32::MIN)?);
                        }
                    }
                    // Longer than 2^32 - 1 is impossible: a column has no more entries than there are rows.
                    lengths.push(narrow(rows.len() - start));
                }
                Some((lengths, rows, entries))
            });
        let blocks = blocks.into_iter().collect::<Option<Vec<ColumnBlock>>>()?;
        Some(joined_columns(other.column_count(), blocks).and_then(|(starts, rows, entries)| {
            SparseMatrix::from_parts(self.row_count(), starts, rows, entries)
        }))
    }

    /// The product in integers of any size.
    fn wide_product<F: Entry>(&self, other: &SparseMatrix<F>) -> Result<WideMatrix, Error> {
        let steps = stage("multiplying matrices of large integers", other.column_count());
        let work = self.entries().len() + other.entries().len();
        let columns: Vec<Vec<(u32, Integer)>> = threads::mapped(other.column_count(), work, |j| {
            steps.pass(j);
            let mut terms = Vec::new();
            for (k, factor) in other.column(j).terms() {
                let factor = factor.to_integer();
                terms.extend(
                    self.column(k).terms().map(|(i, entry)| (narrow(i), &entry.to_integer() * &factor)),
                );
            }
            terms
        });
        WideMatrix::from_integer_columns(self.row_count(), columns)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn matrices(row_count: usize, column_count: usize) -> impl Strategy<Value = SparseMatrix> {
        let entry = prop_oneof![4 => Just(0i64), 2 => -3i64..=3, 1 => -2_147_483_647i64..=2_147_483_647];
        prop::collection::vec(entry, row_count * column_count).prop_map(move |entries| {
            let places =
                entries.iter().enumerate().map(|(at, &entry)| (at / column_count, at % column_count, entry));
            SparseMatrix::from_entries(row_count, column_count, places).unwrap()
        })
    }

    proptest! {
        #[test]
        fn products_agree_with_the_definition(a in matrices(3, 4), b in matrices(4, 5)) {
            let product = a.product(&b).unwrap();
            let wide = product.to_wide();
            for i in 0..3 {
                for j in 0..5 {
                    let sum: i128 = (0..4).map(|k| i128::from(a.entry(i, k)) * i128::from(b.entry(k, j))).sum();
                    prop_assert_eq!(wide.entry(i, j).to_string(), sum.to_string());
                }
            }
            let fits = wide.entries().iter().all(|e| e.to_i64().is_some_and(|e| e.abs() < 1 << 31));
            prop_assert_eq!(product.as_narrow().is_some(), fits);
            prop_assert_eq!(a.checked_product(&b).is_ok(), fits);
            prop_assert_eq!(&a.to_wide().product(&b).unwrap(), &product);
            let first = (0..5).find(|&j| !wide.column(j).rows().is_empty());
            prop_assert_eq!(a.first_nonzero_product_column(&b).unwrap(), first);
        }

        #[test]
        fn multiplication_is_associative_and_reverses_under_transposition(
            (a, b, c) in (matrices(2, 3), matrices(3, 4), matrices(4, 2)),
        ) {
            let (ab, bc) = (a.product(&b).unwrap().into_wide(), b.product(&c).unwrap().into_wide());
            prop_assert_eq!(ab.product(&c).unwrap(), a.product(&bc).unwrap());
            prop_assert_eq!(b.transpose().product(&a.transpose()).unwrap().into_wide(), ab.transpose());
            let vector: Vec<Integer> = (1..=4).map(Integer::from).collect();
            let image = b.times_vector(&vector).unwrap();
            prop_assert_eq!(a.times_vector(&image).unwrap(), ab.times_vector(&vector).unwrap());
        }
    }

    #[test]
    fn many_columns_keep_their_order() {
        let count = 3 * BLOCK + 5;
        let shift =
            SparseMatrix::from_entries(count, count, (0..count).map(|j| ((j + 1) % count, j, 2))).unwrap();
        let twice = shift.checked_product(&shift).unwrap();
        assert!((0..count).all(|j| twice.column(j).iter().eq([((j + 2) % count, 4)])));
    }

    #[test]
    fn shapes_must_fit() {
        let wide = SparseMatrix::zero(2, 3).unwrap();
        assert_eq!(wide.product(&wide).unwrap_err().kind(), ErrorKind::Shape);
        assert_eq!(wide.times_vector(&[]).unwrap_err().kind(), ErrorKind::Shape);
        let empty = SparseMatrix::zero(0, 2).unwrap();
        assert_eq!(empty.checked_product(&SparseMatrix::zero(2, 0).unwrap()).unwrap().row_count(), 0);
    }
}
