//! Sums, multiples, slices and permutations of sparse matrices.

use crate::combinatorics::Permutation;
use crate::error::{Error, ErrorKind, Fault};
use crate::ids::narrow;
use crate::integers::Integer;
use crate::matrices::entry::Entry;
use crate::matrices::integer_matrix::IntegerMatrix;
use crate::matrices::sparse_matrix::{SparseMatrix, WideMatrix};
use crate::matrices::sparse_vector::combination;

impl<E: Entry> SparseMatrix<E> {
    /// Whether every entry is zero.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert!(SparseMatrix::zero(2, 3)?.is_zero());
    /// # Ok(()) }
    /// ```
    pub fn is_zero(&self) -> bool {
        self.entry_count() == 0
    }

    /// The sum of two matrices.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless the shapes agree.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let identity = SparseMatrix::identity(2)?;
    /// assert_eq!(identity.sum(&identity)?.into_narrow()?.entry(1, 1), 2);
    /// # Ok(()) }
    /// ```
    pub fn sum<F: Entry>(&self, other: &SparseMatrix<F>) -> Result<IntegerMatrix, Error> {
        self.combined(&Integer::ONE, other, &Integer::ONE)
    }

    /// The difference `self - other`.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless the shapes agree.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let identity = SparseMatrix::identity(2)?;
    /// assert!(identity.difference(&identity)?.is_zero());
    /// # Ok(()) }
    /// ```
    pub fn difference<F: Entry>(&self, other: &SparseMatrix<F>) -> Result<IntegerMatrix, Error> {
        self.combined(&Integer::ONE, other, &Integer::from(-1))
    }

    /// The combination $x A + y B$ of this matrix A and another one B.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless the shapes agree.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let identity = SparseMatrix::identity(2)?;
    /// let swap = SparseMatrix::from_entries(2, 2, [(0, 1, 1), (1, 0, 1)])?;
    /// let matrix = identity.combined(&3.into(), &swap, &(-1).into())?.into_narrow()?;
    /// assert_eq!((matrix.entry(0, 0), matrix.entry(0, 1)), (3, -1));
    /// # Ok(()) }
    /// ```
    pub fn combined<F: Entry>(
        &self,
        x: &Integer,
        other: &SparseMatrix<F>,
        y: &Integer,
    ) -> Result<IntegerMatrix, Error> {
        if (self.row_count(), self.column_count()) != (other.row_count(), other.column_count()) {
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "a matrix of {} rows and {} columns cannot be added to one of {} rows and {} columns",
                    self.row_count(),
                    self.column_count(),
                    other.row_count(),
                    other.column_count()
                ),
            )
            .with_fault(Fault::Shape {
                found: [other.row_count(), other.column_count()],
                expected: [Some(self.row_count()), Some(self.column_count())],
            }));
        }
        let columns = self
            .columns()
            .zip(other.columns())
            .map(|(a, b)| combination(x, &integer_terms(a.terms()), y, &integer_terms(b.terms())));
        Ok(WideMatrix::from_integer_columns(self.row_count(), columns)?.into())
    }

    /// The matrix with each entry multiplied by `factor`.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let tenfold = SparseMatrix::identity(2)?.scaled(&10.into());
    /// assert_eq!(tenfold.into_narrow()?.entry(0, 0), 10);
    /// # Ok(()) }
    /// ```
    pub fn scaled(&self, factor: &Integer) -> IntegerMatrix {
        if factor.is_zero() {
            let zero = SparseMatrix::zero(self.row_count(), self.column_count());
            return IntegerMatrix::Narrow(zero.expect("the counts fit as they are"));
        }
        self.with_entries(|entry| &entry.to_integer() * factor).into()
    }

    /// The matrix with each entry replaced by its opposite.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SparseMatrix::identity(2)?.negated().entry(0, 0), -1);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn negated(&self) -> Self {
        self.with_entries(E::negated)
    }

    /// The matrix of absolute values: of a boundary matrix, the unsigned incidence matrix.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?;
    /// assert_eq!(edge.abs().entries(), [1, 1]);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn abs(&self) -> Self {
        self.with_entries(|entry| if entry.is_negative() { entry.negated() } else { entry.clone() })
    }

    /// The matrix of these columns, in this order; a column may be listed more than once.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] for a column that does not exist; [`ErrorKind::TooLarge`] beyond 2^32 entries.
    ///
    /// # Complexity
    /// Linear in the entries of the columns taken.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(1, 3, [(0, 0, 4), (0, 1, 5), (0, 2, 6)])?;
    /// assert_eq!(matrix.select_columns(&[2, 0])?.entries(), [6, 4]);
    /// # Ok(()) }
    /// ```
    pub fn select_columns(&self, columns: &[usize]) -> Result<Self, Error> {
        check_numbers(columns, self.column_count(), "column")?;
        let (mut starts, mut rows, mut entries) = (vec![0], Vec::new(), Vec::new());
        for &j in columns {
            let column = self.column(j);
            rows.extend_from_slice(column.rows());
            entries.extend_from_slice(column.entries());
            starts.push(crate::matrices::sparse_matrix::fits(rows.len(), "entries")?);
        }
        Self::checked(self.row_count(), starts, rows, entries)
    }

    /// The matrix of these rows, in this order; a row may be listed more than once.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] for a row that does not exist; [`ErrorKind::TooLarge`] beyond 2^32 entries.
    ///
    /// # Complexity
    /// Linear in the matrix and the result.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(3, 1, [(0, 0, 4), (1, 0, 5), (2, 0, 6)])?;
    /// assert_eq!(matrix.select_rows(&[2, 0])?.entries(), [6, 4]);
    /// # Ok(()) }
    /// ```
    pub fn select_rows(&self, rows: &[usize]) -> Result<Self, Error> {
        check_numbers(rows, self.row_count(), "row")?;
        Ok(self.transpose().select_columns(rows)?.transpose())
    }

    /// The matrix of these rows and columns, in these orders.
    ///
    /// # Errors
    /// As [`Self::select_rows`] and [`Self::select_columns`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(2, 3, [(0, 0, 5), (1, 2, 7)])?;
    /// let part = matrix.submatrix(&[1, 0], &[2])?;
    /// assert_eq!((part.entry(0, 0), part.entry(1, 0)), (7, 0));
    /// # Ok(()) }
    /// ```
    pub fn submatrix(&self, rows: &[usize], columns: &[usize]) -> Result<Self, Error> {
        self.select_columns(columns)?.select_rows(rows)
    }

    /// The matrix with row i moved to place `rows.image(i)` and column j to place `columns.image(j)`.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless the permutations are of all rows and all columns.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{Permutation, SparseMatrix};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(2, 1, [(0, 0, 5)])?;
    /// let swapped = matrix.permuted(&Permutation::from_images(vec![1, 0])?, &Permutation::identity(1))?;
    /// assert_eq!(swapped.entry(1, 0), 5);
    /// # Ok(()) }
    /// ```
    pub fn permuted(&self, rows: &Permutation, columns: &Permutation) -> Result<Self, Error> {
        if (rows.len(), columns.len()) != (self.row_count(), self.column_count()) {
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "permutations of {} and {} numbers for a matrix of {} rows and {} columns",
                    rows.len(),
                    columns.len(),
                    self.row_count(),
                    self.column_count()
                ),
            )
            .with_fault(Fault::Shape {
                found: [self.row_count(), self.column_count()],
                expected: [Some(rows.len()), Some(columns.len())],
            }));
        }
        let sources = |permutation: &Permutation| {
            permutation.inverse().images().iter().map(|&i| i as usize).collect::<Vec<_>>()
        };
        self.submatrix(&sources(rows), &sources(columns))
    }
}

fn integer_terms<'a, E: Entry + 'a>(terms: impl Iterator<Item = (usize, &'a E)>) -> Vec<(u32, Integer)> {
    terms.map(|(i, entry)| (narrow(i), entry.to_integer())).collect()
}

fn check_numbers(numbers: &[usize], count: usize, what: &str) -> Result<(), Error> {
    match numbers.iter().find(|&&number| number >= count) {
        None => Ok(()),
        Some(&number) => {
            Err(Error::new(ErrorKind::Shape, format!("{what} {number} of a matrix of {count} {what}s"))
                .with_fault(Fault::OutOfRange { index: number, count }))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn matrices() -> impl Strategy<Value = SparseMatrix> {
        prop::collection::vec(prop_oneof![Just(0i64), -2_147_483_647i64..=2_147_483_647], 12).prop_map(
            |entries| {
                let places = entries.iter().enumerate().map(|(at, &entry)| (at / 4, at % 4, entry));
                SparseMatrix::from_entries(3, 4, places).unwrap()
            },
        )
    }

    proptest! {
        #[test]
        fn sums_and_slices_are_entry_by_entry(
            (a, b) in (matrices(), matrices()),
            rows in prop::collection::vec(0usize..3, 0..5),
            columns in prop::collection::vec(0usize..4, 0..5),
        ) {
            let sum = a.sum(&b).unwrap().into_wide();
            let double = a.scaled(&2.into()).into_wide();
            let part = a.submatrix(&rows, &columns).unwrap();
            for i in 0..3 {
                for j in 0..4 {
                    let [x, y] = [&a, &b].map(|matrix| i64::from(matrix.entry(i, j)));
                    prop_assert_eq!(sum.entry(i, j), Integer::from(x + y));
                    prop_assert_eq!(double.entry(i, j), Integer::from(2 * x));
                    prop_assert_eq!(i64::from(a.abs().entry(i, j)), x.abs());
                }
            }
            for (i, &row) in rows.iter().enumerate() {
                for (j, &column) in columns.iter().enumerate() {
                    prop_assert_eq!(part.entry(i, j), a.entry(row, column));
                }
            }
            prop_assert_eq!(sum.difference(&b).unwrap(), IntegerMatrix::Narrow(a.clone()));
            prop_assert!(a.sum(&a.negated()).unwrap().is_zero());
            prop_assert!(a.scaled(&Integer::ZERO).is_zero());
            prop_assert!(a == a.to_wide() && a.to_wide() == a);
            prop_assert_eq!(a == b.to_wide(), a == b);
        }

        #[test]
        fn permuting_there_and_back_changes_nothing(
            matrix in matrices(),
            rows in Just(vec![0, 1, 2]).prop_shuffle(),
            columns in Just(vec![0, 1, 2, 3]).prop_shuffle(),
        ) {
            let (rows, columns) = (Permutation::from_images(rows).unwrap(), Permutation::from_images(columns).unwrap());
            let there = matrix.permuted(&rows, &columns).unwrap();
            prop_assert_eq!(there.entry(rows.image(2), columns.image(1)), matrix.entry(2, 1));
            prop_assert_eq!(there.permuted(&rows.inverse(), &columns.inverse()).unwrap(), matrix);
        }
    }

    #[test]
    fn display_is_matrix_market() {
        let matrix = SparseMatrix::from_entries(2, 2, [(1, 0, -3), (0, 1, 1)]).unwrap();
        let text = matrix.to_string();
        assert_eq!(text, "%%MatrixMarket matrix coordinate integer general\n2 2 2\n2 1 -3\n1 2 1\n");
    }

    #[test]
    fn faults_are_named() {
        let matrix = SparseMatrix::zero(2, 3).unwrap();
        assert_eq!(matrix.select_rows(&[2]).unwrap_err().message(), "row 2 of a matrix of 2 rows");
        assert_eq!(matrix.sum(&matrix.transpose()).unwrap_err().kind(), ErrorKind::Shape);
        let shuffle = Permutation::identity(2);
        assert_eq!(matrix.permuted(&shuffle, &shuffle).unwrap_err().kind(), ErrorKind::Shape);
        let least = SparseMatrix::from_entries(1, 1, [(0, 0, i64::from(i32::MIN))]).unwrap_err();
        assert_eq!(least.kind(), ErrorKind::TooLarge);
    }
}
