//! Arrays of numpy over memory of the library, and matrices of scipy.

use coface::algebra::SparseMatrix;
use numpy::ndarray::ArrayView1;
use numpy::{Element, PyArray1};
use pyo3::prelude::*;
use std::any::Any;
use std::sync::Arc;

/// Keeps memory of the library alive as long as an array looks at it.
#[pyclass(frozen, module = "coface._coface", name = "_Memory")]
pub(crate) struct Memory {
    _owner: Arc<dyn Any + Send + Sync>,
}

/// An array that looks at `data`, which lies in what `owner` keeps alive. It cannot be written to.
#[allow(unsafe_code)]
pub(crate) fn shared<'py, T: Element>(
    py: Python<'py>,
    owner: Arc<dyn Any + Send + Sync>,
    data: &[T],
) -> PyResult<Bound<'py, PyArray1<T>>> {
    let memory = Bound::new(py, Memory { _owner: owner })?;
    // SAFETY: `data` lies in what `owner` keeps alive, nothing behind an Arc without locks changes, and the array holds the Arc.
    let array = unsafe { PyArray1::borrow_from_array(&ArrayView1::from(data), memory.into_any()) };
    array.call_method1("setflags", (false,))?;
    Ok(array)
}

/// The same numbers as signed ones, which scipy and most of numpy's world want.
#[allow(unsafe_code)]
pub(crate) fn as_signed(numbers: &[u32]) -> &[i32] {
    // SAFETY: u32 and i32 have one size and alignment, and every pattern of bits is a value of both.
    unsafe { std::slice::from_raw_parts(numbers.as_ptr().cast(), numbers.len()) }
}

/// Ids as an array that looks at them: `int32`.
pub(crate) fn shared_ids<'py>(
    py: Python<'py>,
    owner: Arc<dyn Any + Send + Sync>,
    ids: &[u32],
) -> PyResult<Bound<'py, PyArray1<i32>>> {
    shared(py, owner, as_signed(ids))
}

/// A matrix that `owner` keeps alive as `scipy.sparse.csc_array` on the same memory.
pub(crate) fn shared_matrix<'py>(
    py: Python<'py>,
    owner: &Arc<dyn Any + Send + Sync>,
    matrix: &SparseMatrix,
) -> PyResult<Bound<'py, PyAny>> {
    let data = shared(py, Arc::clone(owner), matrix.entries())?;
    let indices = shared_ids(py, Arc::clone(owner), matrix.rows())?;
    let starts = shared_ids(py, Arc::clone(owner), matrix.column_starts())?;
    let shape = (matrix.row_count(), matrix.column_count());
    let class = py.import("scipy.sparse")?.getattr("csc_array")?;
    let options = pyo3::types::PyDict::new(py);
    options.set_item("shape", shape)?;
    options.set_item("copy", false)?;
    let array = class.call(((data, indices, starts),), Some(&options))?;
    // Rows rise strictly in each column: scipy need not look, nor try to sort memory that it cannot write to.
    array.setattr("has_sorted_indices", true)?;
    array.setattr("has_canonical_format", true)?;
    Ok(array)
}

/// A matrix as `scipy.sparse.csc_array` on memory of its own.
pub(crate) fn owned_matrix(py: Python<'_>, matrix: SparseMatrix) -> PyResult<Bound<'_, PyAny>> {
    let matrix = Arc::new(matrix);
    let owner: Arc<dyn Any + Send + Sync> = Arc::clone(&matrix) as _;
    shared_matrix(py, &owner, &matrix)
}
