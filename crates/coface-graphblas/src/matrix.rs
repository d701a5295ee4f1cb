//! Matrices that the C library holds.

use crate::{Error, ffi};
use std::ffi::c_int;
use std::ptr::null_mut;
use std::sync::OnceLock;

/// A sparse matrix of 64-bit integers in the memory of the C library.
pub struct Matrix {
    handle: ffi::Handle,
    row_count: usize,
    column_count: usize,
    /// No entry is larger.
    largest: u128,
    /// No column has more entries.
    longest: usize,
}

impl std::fmt::Debug for Matrix {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Matrix")
            .field("row_count", &self.row_count)
            .field("column_count", &self.column_count)
            .finish_non_exhaustive()
    }
}

/// Compressed columns: column j has the rows `rows[starts[j]..starts[j + 1]]`, rising, with the entries beside them; none is
/// zero.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Columns {
    /// The number of rows.
    pub row_count: usize,
    /// Where each column starts; one more than columns.
    pub starts: Vec<u32>,
    /// The rows of all columns.
    pub rows: Vec<u32>,
    /// The entries of all columns.
    pub entries: Vec<i32>,
}

/// Starts the library once; all later calls give what the first one gave.
fn start() -> Result<(), Error> {
    static STARTED: OnceLock<c_int> = OnceLock::new();
    // SAFETY: `OnceLock` calls this once in the life of the program, before any other function of the library.
    let code = *STARTED.get_or_init(|| unsafe { ffi::GrB_init(ffi::BLOCKING) });
    done("GrB_init", code)
}

fn done(function: &'static str, code: c_int) -> Result<(), Error> {
    if code == 0 { Ok(()) } else { Err(Error::Library { function, code }) }
}

impl Matrix {
    /// The matrix with these compressed columns, as [`Columns`] has them; rows need not rise.
    ///
    /// # Errors
    /// [`Error::Shape`] unless the starts rise from 0 to the number of rows, which is that of the entries, and the rows are
    /// below `row_count` and differ within each column; [`Error::Library`].
    pub fn from_columns(
        row_count: usize,
        starts: &[u32],
        rows: &[u32],
        entries: &[i32],
    ) -> Result<Self, Error> {
        let is_whole = starts.first() == Some(&0)
            && starts.last().map(|&end| end as usize) == Some(rows.len())
            && starts.is_sorted()
            && rows.len() == entries.len();
        if !is_whole {
            return Err(Error::Shape(
                "the starts of columns must rise from 0 to the number of entries".into(),
            ));
        }
        check_indices(rows, row_count)?;
        check_distinct(starts, rows)?;
        start()?;
        let column_count = starts.len() - 1;
        let mut handle = null_mut();
        let wide_starts: Vec<u64> = starts.iter().map(|&start| u64::from(start)).collect();
        let wide_rows: Vec<u64> = rows.iter().map(|&row| u64::from(row)).collect();
        let wide_entries: Vec<i64> = entries.iter().map(|&entry| i64::from(entry)).collect();
        // SAFETY: the library is started, so its type object is set; it is never written again.
        let kind = unsafe { ffi::GrB_INT64 };
        // SAFETY: the three arrays have the lengths that are given beside them and outlive the call, which copies them;
        // starts rise to the number of rows and entries, and rows are below the number of rows.
        let code = unsafe {
            ffi::GrB_Matrix_import_INT64(
                &raw mut handle,
                kind,
                row_count as u64,
                column_count as u64,
                wide_starts.as_ptr(),
                wide_rows.as_ptr(),
                wide_entries.as_ptr(),
                wide_starts.len() as u64,
                wide_rows.len() as u64,
                wide_entries.len() as u64,
                ffi::COMPRESSED_COLUMNS,
            )
        };
        done("GrB_Matrix_import_INT64", code)?;
        let largest = entries.iter().map(|entry| u128::from(entry.unsigned_abs())).max().unwrap_or(0);
        let longest = starts.windows(2).map(|pair| (pair[1] - pair[0]) as usize).max().unwrap_or(0);
        Ok(Self { handle, row_count, column_count, largest, longest })
    }

    /// The matrix with these entries (row, column, entry); entries at one place are added.
    ///
    /// # Errors
    /// [`Error::Shape`] for a place outside the matrix; [`Error::Library`].
    pub fn from_entries(
        row_count: usize,
        column_count: usize,
        entries: &[(u32, u32, i32)],
    ) -> Result<Self, Error> {
        let [rows, columns]: [Vec<u32>; 2] =
            [entries.iter().map(|entry| entry.0).collect(), entries.iter().map(|entry| entry.1).collect()];
        check_indices(&rows, row_count)?;
        check_indices(&columns, column_count)?;
        start()?;
        let mut handle = null_mut();
        // SAFETY: the library is started, so its type object is set; it is never written again.
        let kind = unsafe { ffi::GrB_INT64 };
        // SAFETY: the call writes one handle to a place that is ours.
        let code =
            unsafe { ffi::GrB_Matrix_new(&raw mut handle, kind, row_count as u64, column_count as u64) };
        done("GrB_Matrix_new", code)?;
        let largest = entries.iter().map(|entry| u128::from(entry.2.unsigned_abs())).sum();
        let longest = row_count.min(entries.len());
        // Owned from here on, so that it is freed when building fails.
        let matrix = Self { handle, row_count, column_count, largest, longest };
        let [rows, columns] =
            [rows, columns].map(|list| list.into_iter().map(u64::from).collect::<Vec<u64>>());
        let values: Vec<i64> = entries.iter().map(|entry| i64::from(entry.2)).collect();
        // SAFETY: the library is started, so its operator is set; it is never written again.
        let sum = unsafe { ffi::GrB_PLUS_INT64 };
        // SAFETY: the matrix is new and empty; the three arrays have the length that is given and outlive the call, which
        // copies them.
        let code = unsafe {
            ffi::GrB_Matrix_build_INT64(
                matrix.handle,
                rows.as_ptr(),
                columns.as_ptr(),
                values.as_ptr(),
                values.len() as u64,
                sum,
            )
        };
        done("GrB_Matrix_build_INT64", code)?;
        Ok(matrix)
    }

    /// The number of rows.
    pub fn row_count(&self) -> usize {
        self.row_count
    }

    /// The number of columns.
    pub fn column_count(&self) -> usize {
        self.column_count
    }

    /// The product `self * other`.
    ///
    /// # Errors
    /// [`Error::Shape`] unless `other` has as many rows as this has columns; [`Error::TooLarge`] if a sum could leave 64
    /// bits; [`Error::Library`].
    pub fn product(&self, other: &Self) -> Result<Self, Error> {
        if self.column_count != other.row_count {
            return Err(Error::Shape(format!(
                "a matrix of {} columns times one of {} rows",
                self.column_count, other.row_count
            )));
        }
        let largest = self.largest.saturating_mul(other.largest).saturating_mul(other.longest as u128);
        if largest > i64::MAX as u128 {
            return Err(Error::TooLarge("a product of matrices could leave 64 bits".into()));
        }
        let (mut handle, longest) = (null_mut(), self.row_count);
        // SAFETY: the library is started, so its type object is set; it is never written again.
        let kind = unsafe { ffi::GrB_INT64 };
        // SAFETY: the call writes one handle to a place that is ours.
        let code = unsafe {
            ffi::GrB_Matrix_new(&raw mut handle, kind, self.row_count as u64, other.column_count as u64)
        };
        done("GrB_Matrix_new", code)?;
        let (row_count, column_count) = (self.row_count, other.column_count);
        let product = Self { handle, row_count, column_count, largest, longest };
        // SAFETY: the library is started, so its semiring is set; it is never written again.
        let semiring = unsafe { ffi::GrB_PLUS_TIMES_SEMIRING_INT64 };
        // SAFETY: the three matrices are alive and of types and sizes that fit; a null mask, accumulator and descriptor mean
        // that there is none.
        let code = unsafe {
            ffi::GrB_mxm(
                product.handle,
                null_mut(),
                null_mut(),
                semiring,
                self.handle,
                other.handle,
                null_mut(),
            )
        };
        done("GrB_mxm", code)?;
        Ok(product)
    }

    /// The matrix as compressed columns, without the zeros that sums came to.
    ///
    /// # Errors
    /// [`Error::TooLarge`] for an entry or a count beyond 32 bits; [`Error::Library`].
    pub fn to_columns(&self) -> Result<Columns, Error> {
        let (mut start_count, mut row_index_count, mut entry_count) = (0u64, 0u64, 0u64);
        // SAFETY: the matrix is alive, and the call writes three numbers to places that are ours.
        let code = unsafe {
            ffi::GrB_Matrix_exportSize(
                &raw mut start_count,
                &raw mut row_index_count,
                &raw mut entry_count,
                ffi::COMPRESSED_COLUMNS,
                self.handle,
            )
        };
        done("GrB_Matrix_exportSize", code)?;
        let mut starts = vec![0u64; start_count as usize];
        let mut rows = vec![0u64; row_index_count as usize];
        let mut entries = vec![0i64; entry_count as usize];
        // SAFETY: the matrix is alive and of 64-bit integers; the arrays have the lengths that the library asked for, which
        // are given beside them.
        let code = unsafe {
            ffi::GrB_Matrix_export_INT64(
                starts.as_mut_ptr(),
                rows.as_mut_ptr(),
                entries.as_mut_ptr(),
                &raw mut start_count,
                &raw mut row_index_count,
                &raw mut entry_count,
                ffi::COMPRESSED_COLUMNS,
                self.handle,
            )
        };
        done("GrB_Matrix_export_INT64", code)?;
        let mut columns =
            Columns { row_count: self.row_count, starts: vec![0], rows: Vec::new(), entries: Vec::new() };
        let mut terms: Vec<(u64, i64)> = Vec::new();
        for pair in starts.windows(2) {
            let range = pair[0] as usize..pair[1] as usize;
            terms.clear();
            terms.extend(rows[range.clone()].iter().copied().zip(entries[range].iter().copied()));
            terms.retain(|&(_, entry)| entry != 0);
            terms.sort_unstable();
            for &(row, entry) in &terms {
                // Rows are below a count that came from 32-bit numbers, or the matrix has no entry there.
                columns.rows.push(fits(row)?);
                columns
                    .entries
                    .push(i32::try_from(entry).map_err(|_| {
                        Error::TooLarge(format!("the entry {entry} needs more than 32 bits"))
                    })?);
            }
            columns.starts.push(fits(columns.rows.len() as u64)?);
        }
        Ok(columns)
    }
}

impl Drop for Matrix {
    fn drop(&mut self) {
        // SAFETY: the handle is of a matrix that this value alone owns; the call sets it to null. A failure cannot be
        // reported from here, and leaves no more than memory behind.
        unsafe { ffi::GrB_Matrix_free(&raw mut self.handle) };
    }
}

fn check_indices(indices: &[u32], count: usize) -> Result<(), Error> {
    match indices.iter().find(|&&index| index as usize >= count) {
        None => Ok(()),
        Some(index) => Err(Error::Shape(format!("index {index} where there are {count}"))),
    }
}

/// The library takes the rows of a column for different ones, and does not look.
fn check_distinct(starts: &[u32], rows: &[u32]) -> Result<(), Error> {
    let mut sorted = Vec::new();
    for (column, pair) in starts.windows(2).enumerate() {
        let rows = &rows[pair[0] as usize..pair[1] as usize];
        if rows.is_sorted_by(|a, b| a < b) {
            continue;
        }
        sorted.clear();
        sorted.extend_from_slice(rows);
        sorted.sort_unstable();
        if let Some(pair) = sorted.windows(2).find(|pair| pair[0] == pair[1]) {
            return Err(Error::Shape(format!("row {} stands twice in column {column}", pair[0])));
        }
    }
    Ok(())
}

fn fits(number: u64) -> Result<u32, Error> {
    u32::try_from(number).map_err(|_| Error::TooLarge(format!("{number} needs more than 32 bits")))
}
