//! Products by SuiteSparse:GraphBLAS.

use coface_algebra::SparseMatrix;
use coface_algebra::{Error, ErrorKind};
use coface_graphblas::Matrix;

/// The product of two matrices, with 32-bit entries.
pub(super) fn product(first: &SparseMatrix, second: &SparseMatrix) -> Result<SparseMatrix, Error> {
    let [first, second] = [first, second].map(|matrix| {
        Matrix::from_columns(matrix.row_count(), matrix.column_starts(), matrix.rows(), matrix.entries())
    });
    let columns =
        first.and_then(|first| first.product(&second?)?.to_columns()).map_err(|error| fault(&error))?;
    SparseMatrix::from_parts(columns.row_count, columns.starts, columns.rows, columns.entries)
}

/// The columns of a matrix at these places, by a product with a matrix that selects them.
pub(super) fn selected(matrix: &SparseMatrix, columns: &[u32]) -> Result<SparseMatrix, Error> {
    let starts = (0..=columns.len() as u32).collect();
    let selection =
        SparseMatrix::from_parts(matrix.column_count(), starts, columns.to_vec(), vec![1; columns.len()])?;
    product(matrix, &selection)
}

fn fault(error: &coface_graphblas::Error) -> Error {
    let kind = match error {
        coface_graphblas::Error::Shape(_) => ErrorKind::Shape,
        coface_graphblas::Error::TooLarge(_) => ErrorKind::TooLarge,
        _ => ErrorKind::UnsupportedFormat,
    };
    Error::new(kind, error.to_string()).with_cure("compute the congruence by lists")
}
