//! Sparse integer matrices in compressed columns.

use crate::error::{Error, ErrorKind, Fault};
use crate::ids::narrow;
use crate::integers::Integer;
use crate::matrices::entry::Entry;
use crate::threads;
use std::fmt;

/// A sparse integer matrix in compressed columns: 32-bit row numbers, and entries of 32 bits or of any size.
///
/// `SparseMatrix` alone means 32-bit entries, which is what boundary matrices have; [`WideMatrix`] holds [`Integer`]s,
/// which is what products and Smith transforms may need. Within a column the rows rise strictly and no entry is zero,
/// so equal matrices have equal parts.
///
/// # Complexity
/// 8 bytes a 32-bit entry and 4 bytes a column.
///
/// # Examples
/// The boundary of an edge from vertex 0 to vertex 1 as a matrix with two rows and one column:
/// ```
/// use coface_algebra::SparseMatrix;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let boundary = SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?;
/// assert_eq!(boundary.column(0).rows(), [0, 1]);
/// assert_eq!(boundary.transpose().row_count(), 1);
/// # Ok(()) }
/// ```
#[derive(Clone, PartialEq, Eq)]
pub struct SparseMatrix<E = i32> {
    row_count: u32,
    column_starts: Vec<u32>,
    rows: Vec<u32>,
    entries: Vec<E>,
}

/// A sparse matrix of integers of any size.
pub type WideMatrix = SparseMatrix<Integer>;

/// One column: its rows in rising order and the entries beside them.
#[derive(Debug, PartialEq, Eq)]
pub struct Column<'a, E = i32> {
    rows: &'a [u32],
    entries: &'a [E],
}

impl<E> Clone for Column<'_, E> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<E> Copy for Column<'_, E> {}

impl<'a, E: Entry> Column<'a, E> {
    /// The rows with a non-zero entry, rising.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(4, 1, [(3, 0, 5), (1, 0, -2)])?;
    /// assert_eq!(matrix.column(0).rows(), [1, 3]);
    /// # Ok(()) }
    /// ```
    pub fn rows(self) -> &'a [u32] {
        self.rows
    }

    /// The entries in the order of [`Self::rows`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(4, 1, [(3, 0, 5), (1, 0, -2)])?;
    /// assert_eq!(matrix.column(0).entries(), [-2, 5]);
    /// # Ok(()) }
    /// ```
    pub fn entries(self) -> &'a [E] {
        self.entries
    }

    /// The pairs (row, entry by reference); for 32-bit entries [`Column::iter`] gives values.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(4, 1, [(3, 0, 5), (1, 0, -2)])?;
    /// assert!(matrix.column(0).terms().eq([(1, &-2), (3, &5)]));
    /// # Ok(()) }
    /// ```
    pub fn terms(self) -> impl ExactSizeIterator<Item = (usize, &'a E)> + Clone + 'a {
        self.rows.iter().zip(self.entries).map(|(&row, entry)| (row as usize, entry))
    }

    /// The entry in this row; 0 where nothing is stored.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(4, 1, [(3, 0, 5)])?;
    /// assert_eq!((matrix.column(0).entry(3), matrix.column(0).entry(0)), (5, 0));
    /// # Ok(()) }
    /// ```
    pub fn entry(self, row: usize) -> E {
        match self.rows.binary_search_by(|&r| (r as usize).cmp(&row)) {
            Ok(at) => self.entries[at].clone(),
            Err(_) => E::default(),
        }
    }
}

impl<'a> Column<'a> {
    /// The pairs (row, entry).
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(4, 1, [(3, 0, 5), (1, 0, -2)])?;
    /// assert!(matrix.column(0).iter().eq([(1, -2), (3, 5)]));
    /// # Ok(()) }
    /// ```
    pub fn iter(self) -> impl ExactSizeIterator<Item = (usize, i32)> + Clone + 'a {
        self.rows.iter().zip(self.entries).map(|(&row, &entry)| (row as usize, entry))
    }
}

impl SparseMatrix {
    /// The zero matrix.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if a count does not fit in 32 bits.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let zero = SparseMatrix::zero(2, 3)?;
    /// assert_eq!((zero.row_count(), zero.column_count(), zero.entry_count()), (2, 3, 0));
    /// # Ok(()) }
    /// ```
    pub fn zero(row_count: usize, column_count: usize) -> Result<Self, Error> {
        Self::from_parts(row_count, vec![0; column_count + 1], Vec::new(), Vec::new())
    }

    /// The identity matrix.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if `count` does not fit in 32 bits.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let identity = SparseMatrix::identity(2)?;
    /// assert_eq!((identity.entry(0, 0), identity.entry(0, 1)), (1, 0));
    /// # Ok(()) }
    /// ```
    pub fn identity(count: usize) -> Result<Self, Error> {
        let count32 = fits(count, "rows")?;
        Self::from_parts(count, (0..=count32).collect(), (0..count32).collect(), vec![1; count])
    }

    /// The matrix with these parts: column `j` has the rows `rows[column_starts[j]..column_starts[j + 1]]`.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless the starts rise from 0 to the number of entries, the rows of each column rise
    /// strictly and are below `row_count`, and no entry is zero or $-2^{31}$; [`ErrorKind::TooLarge`] beyond 32 bits.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two columns: 7 in row 0, and 8 in row 1.
    /// let matrix = SparseMatrix::from_parts(2, vec![0, 1, 2], vec![0, 1], vec![7, 8])?;
    /// assert_eq!(matrix, SparseMatrix::from_entries(2, 2, [(0, 0, 7), (1, 1, 8)])?);
    /// # Ok(()) }
    /// ```
    pub fn from_parts(
        row_count: usize,
        column_starts: Vec<u32>,
        rows: Vec<u32>,
        entries: Vec<i32>,
    ) -> Result<Self, Error> {
        Self::checked(row_count, column_starts, rows, entries)
    }

    /// The matrix with parts that are known to be valid: release builds check the counts only, debug builds everything
    /// that [`Self::from_parts`] checks.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 32 bits.
    #[doc(hidden)]
    pub fn from_trusted_parts(
        row_count: usize,
        column_starts: Vec<u32>,
        rows: Vec<u32>,
        entries: Vec<i32>,
    ) -> Result<Self, Error> {
        if cfg!(debug_assertions) {
            return Self::from_parts(row_count, column_starts, rows, entries);
        }
        fits(column_starts.len(), "columns")?;
        fits(rows.len(), "entries")?;
        Ok(Self { row_count: fits(row_count, "rows")?, column_starts, rows, entries })
    }

    /// The matrix with these (row, column, entry) triples; entries at one place are added.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] for a place outside the matrix; [`ErrorKind::TooLarge`] for counts or sums beyond 32 bits.
    ///
    /// # Complexity
    /// $O(m \log m)$ for m triples.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(2, 2, [(0, 1, 3), (1, 0, 5), (0, 1, -1)])?;
    /// assert_eq!((matrix.entry(0, 1), matrix.entry(1, 0), matrix.entry_count()), (2, 5, 2));
    /// # Ok(()) }
    /// ```
    pub fn from_entries(
        row_count: usize,
        column_count: usize,
        entries: impl IntoIterator<Item = (usize, usize, i64)>,
    ) -> Result<Self, Error> {
        fits(row_count, "rows")?;
        fits(column_count, "columns")?;
        let mut sorted = Vec::new();
        for (row, column, entry) in entries {
            if row >= row_count || column >= column_count {
                return Err(Error::new(
                    ErrorKind::Shape,
                    format!(
                        "entry ({row}, {column}) lies outside a matrix of {row_count} rows and {column_count} columns"
                    ),
                )
                .with_fault(if row >= row_count {
                    Fault::OutOfRange { index: row, count: row_count }
                } else {
                    Fault::OutOfRange { index: column, count: column_count }
                }));
            }
            sorted.push((narrow(column), narrow(row), entry));
        }
        sorted.sort_unstable_by_key(|&(column, row, _)| (column, row));
        let mut column_starts = vec![0u32; column_count + 1];
        let (mut rows, mut values) = (Vec::with_capacity(sorted.len()), Vec::with_capacity(sorted.len()));
        for group in sorted.chunk_by(|a, b| (a.0, a.1) == (b.0, b.1)) {
            let (column, row, _) = group[0];
            let sum: i128 = group.iter().map(|&(_, _, entry)| i128::from(entry)).sum();
            let value = match i32::try_from(sum) {
                Ok(value) if value != i32::MIN => value,
                _ => return Err(too_wide(row, column, &sum)),
            };
            if value != 0 {
                rows.push(row);
                values.push(value);
                column_starts[column as usize + 1] += 1;
            }
        }
        let mut total = 0;
        for start in &mut column_starts {
            total += *start;
            *start = total;
        }
        Self::from_parts(row_count, column_starts, rows, values)
    }
}

impl WideMatrix {
    /// The matrix with these columns, each a list of (row, entry); entries at one place are added.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] for a row outside the matrix; [`ErrorKind::TooLarge`] for counts beyond 32 bits.
    ///
    /// # Complexity
    /// Linear when the rows of each column rise strictly, else one sort a column.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{Integer, WideMatrix};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let huge: Integer = "100000000000000000000".parse()?;
    /// let matrix = WideMatrix::from_integer_columns(2, [vec![(1, huge.clone())], vec![]])?;
    /// assert_eq!(matrix.entry(1, 0), huge);
    /// assert_eq!(matrix.column_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn from_integer_columns(
        row_count: usize,
        columns: impl IntoIterator<Item = Vec<(u32, Integer)>>,
    ) -> Result<Self, Error> {
        let (mut column_starts, mut rows, mut entries) = (vec![0], Vec::new(), Vec::new());
        for mut column in columns {
            if !column.is_sorted_by(|a, b| a.0 < b.0) {
                column.sort_by_key(|&(row, _)| row);
            }
            let start = rows.len();
            for (row, entry) in column {
                if rows.len() > start && rows.last() == Some(&row) {
                    let last = entries.len() - 1;
                    entries[last] += &entry;
                } else {
                    drop_last_zero(start, &mut rows, &mut entries);
                    rows.push(row);
                    entries.push(entry);
                }
            }
            drop_last_zero(start, &mut rows, &mut entries);
            column_starts.push(fits(rows.len(), "entries")?);
        }
        Self::checked(row_count, column_starts, rows, entries)
    }

    /// The matrix whose columns are these lists, each with strictly rising rows and no zero.
    ///
    /// # Errors
    /// As [`Self::from_integer_columns`].
    #[doc(hidden)]
    pub fn from_sorted_columns<'c>(
        row_count: usize,
        columns: impl ExactSizeIterator<Item = &'c [(u32, Integer)]> + Clone,
    ) -> Result<Self, Error> {
        let count = columns.clone().map(<[_]>::len).sum();
        let mut column_starts = Vec::with_capacity(columns.len() + 1);
        let (mut rows, mut entries) = (Vec::with_capacity(count), Vec::with_capacity(count));
        column_starts.push(0);
        for column in columns {
            for (row, entry) in column {
                rows.push(*row);
                entries.push(entry.clone());
            }
            column_starts.push(fits(rows.len(), "entries")?);
        }
        Self::checked(row_count, column_starts, rows, entries)
    }
}

/// Removes the last entry if it is zero and belongs to the column that begins at `start`.
fn drop_last_zero(start: usize, rows: &mut Vec<u32>, entries: &mut Vec<Integer>) {
    if rows.len() > start && entries.last().is_some_and(Integer::is_zero) {
        rows.pop();
        entries.pop();
    }
}

impl<E: Entry> SparseMatrix<E> {
    /// The matrix with these parts, after the checks that [`SparseMatrix::from_parts`] lists.
    #[doc(hidden)]
    pub fn checked(
        row_count: usize,
        column_starts: Vec<u32>,
        rows: Vec<u32>,
        entries: Vec<E>,
    ) -> Result<Self, Error> {
        let row_count = fits(row_count, "rows")?;
        fits(column_starts.len(), "columns")?;
        let entry_count = fits(rows.len(), "entries")?;
        let shape = |message: String| Err(Error::new(ErrorKind::Shape, message));
        if column_starts.first() != Some(&0)
            || column_starts.last() != Some(&entry_count)
            || !column_starts.is_sorted()
        {
            return shape(format!(
                "the column starts must rise from 0 to the number of entries, {entry_count}"
            ));
        }
        if entries.len() != rows.len() {
            let message = format!("{} rows beside {} entries", rows.len(), entries.len());
            return Err(Error::new(ErrorKind::Shape, message)
                .with_fault(Fault::Length { found: entries.len(), expected: rows.len() }));
        }
        let bad = threads::first(column_starts.len() - 1, rows.len() + column_starts.len(), |j| {
            let range = column_starts[j] as usize..column_starts[j + 1] as usize;
            let column = &rows[range.clone()];
            column.last().is_some_and(|&last| last >= row_count)
                || !column.is_sorted_by(|a, b| a < b)
                || !entries[range].iter().all(E::is_storable)
        });
        if let Some(j) = bad {
            return shape(format!(
                "column {j} must have strictly rising rows below {row_count} and no entry that is zero or -2^31"
            ));
        }
        Ok(Self { row_count, column_starts, rows, entries })
    }

    /// The matrix with 32-bit entries.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] naming the first entry beyond 32 bits.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{SparseMatrix, WideMatrix};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let wide = WideMatrix::from_integer_columns(1, [vec![(0, 7.into())]])?;
    /// assert_eq!(wide.to_narrow()?, SparseMatrix::from_entries(1, 1, [(0, 0, 7)])?);
    /// # Ok(()) }
    /// ```
    pub fn to_narrow(&self) -> Result<SparseMatrix, Error> {
        let mut entries = Vec::with_capacity(self.entry_count());
        for (j, column) in self.columns().enumerate() {
            for (i, entry) in column.terms() {
                match entry.to_i64().and_then(|value| i32::try_from(value).ok()) {
                    Some(value) if value != i32::MIN => entries.push(value),
                    _ => return Err(too_wide(narrow(i), narrow(j), entry)),
                }
            }
        }
        Ok(SparseMatrix {
            row_count: self.row_count,
            column_starts: self.column_starts.clone(),
            rows: self.rows.clone(),
            entries,
        })
    }

    /// The matrix with each entry replaced by its image, which must not be zero.
    pub(super) fn with_entries<F: Entry>(&self, entry: impl Fn(&E) -> F) -> SparseMatrix<F> {
        SparseMatrix {
            row_count: self.row_count,
            column_starts: self.column_starts.clone(),
            rows: self.rows.clone(),
            entries: self.entries.iter().map(entry).collect(),
        }
    }

    /// The matrix with entries of any size.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SparseMatrix::identity(2)?.to_wide().entry(1, 1), 1.into());
    /// # Ok(()) }
    /// ```
    pub fn to_wide(&self) -> WideMatrix {
        self.with_entries(E::to_integer)
    }

    /// The number of rows.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SparseMatrix::zero(2, 3)?.row_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn row_count(&self) -> usize {
        self.row_count as usize
    }

    /// The number of columns.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SparseMatrix::zero(2, 3)?.column_count(), 3);
    /// # Ok(()) }
    /// ```
    pub fn column_count(&self) -> usize {
        self.column_starts.len() - 1
    }

    /// The number of non-zero entries.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SparseMatrix::identity(3)?.entry_count(), 3);
    /// # Ok(()) }
    /// ```
    pub fn entry_count(&self) -> usize {
        self.rows.len()
    }

    /// Column `j`.
    ///
    /// # Panics
    /// If `j` is not below the number of columns.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SparseMatrix::identity(3)?.column(2).rows(), [2]);
    /// # Ok(()) }
    /// ```
    pub fn column(&self, j: usize) -> Column<'_, E> {
        let range = self.column_starts[j] as usize..self.column_starts[j + 1] as usize;
        Column { rows: &self.rows[range.clone()], entries: &self.entries[range] }
    }

    /// All columns in order.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(2, 2, [(0, 0, 1), (1, 0, 1)])?;
    /// assert!(matrix.columns().map(|column| column.rows().len()).eq([2, 0]));
    /// # Ok(()) }
    /// ```
    pub fn columns(&self) -> impl ExactSizeIterator<Item = Column<'_, E>> {
        (0..self.column_count()).map(|j| self.column(j))
    }

    /// Where each column starts among the rows and entries; one more than columns.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(2, 2, [(0, 0, 1), (1, 0, 1)])?;
    /// assert_eq!(matrix.column_starts(), [0, 2, 2]);
    /// # Ok(()) }
    /// ```
    pub fn column_starts(&self) -> &[u32] {
        &self.column_starts
    }

    /// The rows of all columns, one after the other.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(3, 2, [(2, 0, 5), (0, 1, 6)])?;
    /// assert_eq!(matrix.rows(), [2, 0]);
    /// # Ok(()) }
    /// ```
    pub fn rows(&self) -> &[u32] {
        &self.rows
    }

    /// The entries of all columns, one after the other.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(3, 2, [(2, 0, 5), (0, 1, 6)])?;
    /// assert_eq!(matrix.entries(), [5, 6]);
    /// # Ok(()) }
    /// ```
    pub fn entries(&self) -> &[E] {
        &self.entries
    }

    /// The entry at a place; 0 where nothing is stored.
    ///
    /// # Panics
    /// If `column` is not below the number of columns.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(3, 2, [(2, 0, 5)])?;
    /// assert_eq!((matrix.entry(2, 0), matrix.entry(2, 1)), (5, 0));
    /// # Ok(()) }
    /// ```
    pub fn entry(&self, row: usize, column: usize) -> E {
        self.column(column).entry(row)
    }

    /// The transposed matrix.
    ///
    /// # Complexity
    /// Linear, by counting.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(3, 2, [(2, 0, 5)])?;
    /// assert_eq!(matrix.transpose(), SparseMatrix::from_entries(2, 3, [(0, 2, 5)])?);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn transpose(&self) -> Self {
        let mut starts = vec![0u32; self.row_count() + 1];
        for &row in &self.rows {
            starts[row as usize + 1] += 1;
        }
        let mut total = 0;
        for start in &mut starts {
            total += *start;
            *start = total;
        }
        let mut next = starts.clone();
        let mut rows = vec![0; self.rows.len()];
        let mut entries = vec![E::default(); self.rows.len()];
        for j in 0..self.column_count() {
            let range = self.column_starts[j] as usize..self.column_starts[j + 1] as usize;
            for (&row, entry) in self.rows[range.clone()].iter().zip(&self.entries[range]) {
                let at = &mut next[row as usize];
                rows[*at as usize] = narrow(j);
                entries[*at as usize] = entry.clone();
                *at += 1;
            }
        }
        Self { row_count: narrow(self.column_count()), column_starts: starts, rows, entries }
    }
}

impl SparseMatrix {
    /// The first column of the product `self * other` that is not zero, without storing the product; `None` if the
    /// product is zero.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless `other` has as many rows as `self` has columns.
    ///
    /// # Complexity
    /// Linear in the number of multiplications; columns run in parallel.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let row = SparseMatrix::from_entries(1, 2, [(0, 0, 1), (0, 1, 1)])?;
    /// // The first column cancels, the second does not.
    /// let columns = SparseMatrix::from_entries(2, 2, [(0, 0, 1), (1, 0, -1), (0, 1, 2)])?;
    /// assert_eq!(row.first_nonzero_product_column(&columns)?, Some(1));
    /// # Ok(()) }
    /// ```
    pub fn first_nonzero_product_column(&self, other: &Self) -> Result<Option<usize>, Error> {
        if self.column_count() != other.row_count() {
            return Err(factor_fault(self.column_count(), other.row_count(), other.column_count()));
        }
        const BLOCK: usize = 1 << 14;
        let block_count = other.column_count().div_ceil(BLOCK);
        let steps = crate::progress::stage("multiplying boundaries", other.column_count());
        let first_of = |block: usize| {
            let mut sums = Vec::new();
            let columns = block * BLOCK..((block + 1) * BLOCK).min(other.column_count());
            steps.advance(columns.len());
            columns.into_iter().find(|&j| !self.combination_is_zero(other.column(j), &mut sums))
        };
        Ok(threads::mapped(block_count, other.rows.len(), first_of).into_iter().flatten().min())
    }

    /// Whether the combination of columns of `self` that `coefficients` describes is zero. In a boundary of a boundary
    /// terms cancel soon, so the list of sums that are not zero stays short; where it grows long, or a sum leaves 64
    /// bits, all terms are sorted instead.
    fn combination_is_zero(&self, coefficients: Column<'_>, sums: &mut Vec<(u32, i64)>) -> bool {
        sums.clear();
        for (k, coefficient) in coefficients.iter() {
            for (row, entry) in self.column(k).iter() {
                let product = i64::from(coefficient) * i64::from(entry);
                let Some(at) = sums.iter().position(|&(r, _)| r as usize == row) else {
                    if sums.len() == 32 {
                        return self.sorted_combination_is_zero(coefficients);
                    }
                    sums.push((narrow(row), product));
                    continue;
                };
                match sums[at].1.checked_add(product) {
                    Some(0) => {
                        sums.swap_remove(at);
                    }
                    Some(sum) => sums[at].1 = sum,
                    None => return self.sorted_combination_is_zero(coefficients),
                }
            }
        }
        sums.is_empty()
    }

    fn sorted_combination_is_zero(&self, coefficients: Column<'_>) -> bool {
        let product = |coefficient: i32, entry: i32| i128::from(coefficient) * i128::from(entry);
        let mut terms: Vec<(usize, i128)> = coefficients
            .iter()
            .flat_map(|(k, x)| self.column(k).iter().map(move |(row, entry)| (row, product(x, entry))))
            .collect();
        terms.sort_unstable_by_key(|&(row, _)| row);
        terms
            .chunk_by(|a, b| a.0 == b.0)
            .all(|group| group.iter().map(|&(_, product)| product).sum::<i128>() == 0)
    }
}

/// The error of a second factor that has too few or too many rows.
pub(super) fn factor_fault(column_count: usize, row_count: usize, other_column_count: usize) -> Error {
    let message =
        format!("a matrix of {column_count} columns cannot be multiplied by one of {row_count} rows");
    Error::new(ErrorKind::Shape, message).with_fault(Fault::Shape {
        found: [row_count, other_column_count],
        expected: [Some(column_count), None],
    })
}

/// The error of an entry that 32 bits do not hold.
fn too_wide(row: u32, column: u32, value: &impl fmt::Display) -> Error {
    Error::new(
        ErrorKind::TooLarge,
        format!(
            "the entry at row {row}, column {column} is {value}, beyond the limits of -2147483647 and 2147483647"
        ),
    )
}

/// `count` as a 32-bit number, or an error that names what there are too many of.
pub(super) fn fits(count: usize, what: &str) -> Result<u32, Error> {
    u32::try_from(count).map_err(|_| {
        Error::new(ErrorKind::TooLarge, format!("{count} {what} in a matrix; the limit is 2^32 - 1"))
    })
}

impl<E: Entry> fmt::Debug for SparseMatrix<E> {
    /// The shape, and the entries as (row, column, entry) when they are few.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} x {} matrix, {} entries", self.row_count(), self.column_count(), self.entry_count())?;
        if self.entry_count() <= 64 {
            let places = self
                .columns()
                .enumerate()
                .flat_map(|(j, column)| column.terms().map(move |(i, e)| (i, j, e)));
            f.write_str(" ")?;
            f.debug_list().entries(places).finish()?;
        }
        Ok(())
    }
}

impl<E: Entry> fmt::Display for SparseMatrix<E> {
    /// The matrix in the coordinate format of Matrix Market: a line `rows columns entries`, then a line
    /// `row column entry` for each entry, counted from 1.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "%%MatrixMarket matrix coordinate integer general")?;
        writeln!(f, "{} {} {}", self.row_count(), self.column_count(), self.entry_count())?;
        for (j, column) in self.columns().enumerate() {
            for (i, entry) in column.terms() {
                writeln!(f, "{} {} {entry}", i + 1, j + 1)?;
            }
        }
        Ok(())
    }
}

impl PartialEq<WideMatrix> for SparseMatrix {
    fn eq(&self, other: &WideMatrix) -> bool {
        (self.row_count, &self.column_starts, &self.rows)
            == (other.row_count, &other.column_starts, &other.rows)
            && self.entries.iter().zip(&other.entries).all(|(a, b)| Some(i64::from(*a)) == b.to_i64())
    }
}

impl PartialEq<SparseMatrix> for WideMatrix {
    fn eq(&self, other: &SparseMatrix) -> bool {
        other == self
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn entries_at_one_place_are_added(
            places in prop::collection::vec((0usize..4, 0usize..5, -2i64..=2), 0..30),
        ) {
            let mut sums = [[0i64; 5]; 4];
            for &(i, j, entry) in &places {
                sums[i][j] += entry;
            }
            let matrix = SparseMatrix::from_entries(4, 5, places.iter().copied()).unwrap();
            let mut columns = vec![Vec::new(); 5];
            for &(i, j, entry) in &places {
                columns[j].push((i as u32, Integer::from(entry)));
            }
            let wide = WideMatrix::from_integer_columns(4, columns).unwrap();
            let transpose = matrix.transpose();
            for (i, row) in sums.iter().enumerate() {
                for (j, &sum) in row.iter().enumerate() {
                    prop_assert_eq!(i64::from(matrix.entry(i, j)), sum);
                    prop_assert_eq!(transpose.entry(j, i), matrix.entry(i, j));
                }
            }
            prop_assert_eq!(matrix.entry_count(), sums.iter().flatten().filter(|&&sum| sum != 0).count());
            prop_assert_eq!(&transpose.transpose(), &matrix);
            prop_assert_eq!(&wide, &matrix);
            prop_assert_eq!(wide.to_narrow().unwrap(), matrix);
        }
    }

    #[test]
    fn parts_are_checked() {
        let kind = |row_count, starts: &[u32], rows: &[u32], entries: &[i32]| {
            let parts = (starts.to_vec(), rows.to_vec(), entries.to_vec());
            SparseMatrix::from_parts(row_count, parts.0, parts.1, parts.2).map_err(|error| error.kind()).err()
        };
        assert_eq!(kind(2, &[0, 1, 2], &[0, 1], &[1, -1]), None);
        assert_eq!(kind(0, &[0], &[], &[]), None);
        for (starts, rows, entries) in [
            (&[][..], &[][..], &[][..]),
            (&[1, 1], &[0], &[1]),
            (&[0, 2, 1], &[0], &[1]),
            (&[0, 1], &[0], &[1, 1]),
            (&[0, 1], &[2], &[1]),
            (&[0, 2], &[1, 0], &[1, 1]),
            (&[0, 2], &[1, 1], &[1, 1]),
            (&[0, 1], &[0], &[0]),
            (&[0, 1], &[0], &[i32::MIN]),
        ] {
            assert_eq!(
                kind(2, starts, rows, entries),
                Some(ErrorKind::Shape),
                "{starts:?} {rows:?} {entries:?}"
            );
        }
    }

    #[test]
    fn entries_beyond_32_bits_are_named() {
        let error = SparseMatrix::from_entries(1, 1, [(0, 0, 1 << 40)]).unwrap_err();
        assert_eq!(
            error.message(),
            "the entry at row 0, column 0 is 1099511627776, beyond the limits of -2147483647 and 2147483647"
        );
        let wide =
            WideMatrix::from_integer_columns(3, [vec![], vec![(2, Integer::from(1i64 << 31))]]).unwrap();
        let error = wide.to_narrow().unwrap_err();
        assert_eq!(
            error.message(),
            "the entry at row 2, column 1 is 2147483648, beyond the limits of -2147483647 and 2147483647"
        );
        assert!(SparseMatrix::from_entries(1, 1, [(1, 0, 1)]).is_err());
        assert!(WideMatrix::from_integer_columns(1, [vec![(1, Integer::ONE)]]).is_err());
    }
}
