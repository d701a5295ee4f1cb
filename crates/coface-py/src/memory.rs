//! Arrays of numpy over memory of the library, and matrices of scipy.

use crate::errors::raised;
use coface::algebra::SparseMatrix;
use coface::{Error, ErrorKind};
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

/// An array that looks at what `data` finds in the owner, which lives as long as the array. It cannot be written to.
///
/// The slice borrows from the owner, whatever its lifetime is: it can lie nowhere else, nor behind a lock, and
/// nobody else can change it.
#[allow(unsafe_code)]
pub(crate) fn shared<'py, O: Any + Send + Sync, T: Element>(
    py: Python<'py>,
    owner: &Arc<O>,
    data: impl for<'a> FnOnce(&'a O) -> &'a [T],
) -> PyResult<Bound<'py, PyArray1<T>>> {
    let owner = Arc::clone(owner);
    let data: *const [T] = data(&owner);
    let memory = Bound::new(py, Memory { _owner: owner })?;
    // SAFETY: the slice was borrowed from what the Arc owns, which does not move and which nobody can borrow mutably
    // as long as there are two Arcs; the one in `memory` is dropped after this use.
    let data = unsafe { &*data };
    // SAFETY: the same, and the array holds `memory`.
    let array = unsafe { PyArray1::borrow_from_array(&ArrayView1::from(data), memory.into_any()) };
    array.call_method1("setflags", (false,))?;
    Ok(array)
}

/// The same numbers as signed ones, which scipy and most of numpy's world want; nothing where one is beyond them.
#[allow(unsafe_code)]
pub(crate) fn as_signed(numbers: &[u32]) -> Option<&[i32]> {
    if numbers.iter().fold(0, |bits, number| bits | number) > i32::MAX as u32 {
        return None;
    }
    // SAFETY: u32 and i32 have one size and alignment, and every pattern of bits is a value of both.
    Some(unsafe { std::slice::from_raw_parts(numbers.as_ptr().cast(), numbers.len()) })
}

/// Ids as an array that looks at them: `int32`.
pub(crate) fn shared_ids<'py, O: Any + Send + Sync>(
    py: Python<'py>,
    owner: &Arc<O>,
    ids: impl for<'a> Fn(&'a O) -> &'a [u32],
) -> PyResult<Bound<'py, PyArray1<i32>>> {
    if as_signed(ids(owner)).is_none() {
        let error =
            Error::new(ErrorKind::TooLarge, "there are numbers of 2^31 and above, which int32 does not hold");
        return Err(raised(py, &error.with_cure("take a smaller model")));
    }
    shared(py, owner, |owner| as_signed(ids(owner)).unwrap_or_default())
}

/// A matrix in an owner as `scipy.sparse.csc_array` on the same memory.
pub(crate) fn shared_matrix<'py, O: Any + Send + Sync>(
    py: Python<'py>,
    owner: &Arc<O>,
    matrix: impl for<'a> Fn(&'a O) -> &'a SparseMatrix,
) -> PyResult<Bound<'py, PyAny>> {
    let data = shared(py, owner, |owner| matrix(owner).entries())?;
    let indices = shared_ids(py, owner, |owner| matrix(owner).rows())?;
    let starts = shared_ids(py, owner, |owner| matrix(owner).column_starts())?;
    let shape = (matrix(owner).row_count(), matrix(owner).column_count());
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
    shared_matrix(py, &Arc::new(matrix), |matrix| matrix)
}
