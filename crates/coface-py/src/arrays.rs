//! What users give as arrays: any integers, any floats, any layout; and what they get.

use crate::errors::{OrRaise, invalid};
use coface::algebra::{Integer, RaggedArray, SparseMatrix};
use coface::geometry::Positions;
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray1, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyFrozenSet, PyInt, PyList, PySet, PySlice, PyString, PyTuple};

/// What to do with masked entries where nothing can be left out.
const MASKED: &str = "leave them out or give them numbers with array.filled(..); only coface.volume and coface.cubical take them, as outside";

/// Arrays, lists and tuples as they are; tables, sets, generators and views of dictionaries as an array or a list. Members of sets come in
/// rising order. Arrays of which entries are masked are refused: what stands behind a mask is no number of its owner's.
pub(crate) fn plain<'py>(value: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let py = value.py();
    if value.is_instance_of::<PyList>()
        || value.is_instance_of::<PyTuple>()
        || value.is_instance_of::<PyString>()
    {
        return Ok(value.clone());
    }
    if value.is_instance_of::<PySet>() || value.is_instance_of::<PyFrozenSet>() {
        let mut members = Vec::new();
        for member in value.try_iter()? {
            let member = member?;
            let is_set = member.is_instance_of::<PyFrozenSet>();
            members.push(if is_set {
                PyTuple::new(py, plain(&member)?.try_iter()?.collect::<PyResult<Vec<_>>>()?)?.into_any()
            } else {
                member
            });
        }
        return py.import("builtins")?.getattr("sorted")?.call1((members,));
    }
    if value.hasattr("to_numpy")? {
        return value.call_method0("to_numpy");
    }
    if value.hasattr("mask")? && value.hasattr("filled")? {
        let is_masked: bool =
            py.import("numpy")?.getattr("ma")?.call_method1("is_masked", (value,))?.extract()?;
        if is_masked {
            return Err(invalid(py, "an array has masked entries", MASKED));
        }
    }
    let is_array = value.hasattr("__array__")?
        || value.hasattr("__array_interface__")?
        || value.hasattr("__getitem__")?;
    if !is_array && value.hasattr("__iter__")? {
        return Ok(PyList::new(py, value.try_iter()?.collect::<PyResult<Vec<_>>>()?)?.into_any());
    }
    Ok(value.clone())
}

/// `numpy.asarray(value)`.
pub(crate) fn as_array<'py>(py: Python<'py>, value: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    py.import("numpy")?.getattr("asarray")?.call1((plain(value)?,))
}

/// An array along one axis: numbers of a table are not put one after the other. A column is a list too.
fn along_one_axis<'py>(array: Bound<'py, PyAny>, what: &str) -> PyResult<Bound<'py, PyAny>> {
    let py = array.py();
    let shape: Vec<usize> = array.getattr("shape")?.extract()?;
    match shape[..] {
        [] | [_] | [_, 1] => array.call_method1("reshape", (-1,)),
        _ => Err(invalid(
            py,
            format!("{what} have the shape {}", shape_text(&shape)),
            "give an array of shape (n,): one number for each",
        )),
    }
}

/// A shape as numpy prints it.
pub(crate) fn shape_text(shape: &[usize]) -> String {
    match shape {
        [one] => format!("({one},)"),
        _ => format!("({})", shape.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")),
    }
}

/// The letter of the sort of numbers: `i`, `u`, `b`, `f`, `O`, ...
fn sort_of(array: &Bound<'_, PyAny>) -> PyResult<String> {
    array.getattr("dtype")?.getattr("kind")?.extract()
}

fn size_of(array: &Bound<'_, PyAny>) -> PyResult<usize> {
    array.getattr("size")?.extract()
}

/// An array of ids as 64-bit integers, in the layout of C.
fn integers<'py>(value: &Bound<'py, PyAny>, what: &str) -> PyResult<Bound<'py, PyAny>> {
    let py = value.py();
    let array = as_array(py, &plain(value)?).map_err(|_| {
        invalid(
            py,
            format!("{what} are lists of different lengths"),
            "give a list of lists or (flat, offsets)",
        )
    })?;
    let sort = sort_of(&array)?;
    let array = if sort == "f" { rounded(&array, what)? } else { array };
    if !matches!(&sort[..], "i" | "u" | "f") && size_of(&array)? > 0 {
        let dtype = array.getattr("dtype")?;
        return Err(invalid(py, format!("{what} have the type {dtype}"), "give integers"));
    }
    if sort == "u" && size_of(&array)? > 0 {
        let most: u64 = array.call_method0("max")?.extract()?;
        if u32::try_from(most).is_err() {
            return Err(invalid(py, format!("{what} have the number {most}"), "give ids below 4294967296"));
        }
    }
    let numpy = py.import("numpy")?;
    numpy.getattr("ascontiguousarray")?.call1((array, numpy.getattr("int64")?))
}

/// Floats that are whole numbers, as 64-bit integers.
fn rounded<'py>(array: &Bound<'py, PyAny>, what: &str) -> PyResult<Bound<'py, PyAny>> {
    let py = array.py();
    let numpy = py.import("numpy")?;
    let real = numpy.getattr("ascontiguousarray")?.call1((array, numpy.getattr("float64")?))?;
    let flat: PyReadonlyArray1<'_, f64> = real.call_method1("reshape", (-1,))?.extract()?;
    // Beyond 2^53 floats are no longer every whole number.
    let is_whole = |x: f64| x.fract() == 0.0 && x.abs() <= 9_007_199_254_740_992.0;
    if let Some((place, x)) = flat.as_slice()?.iter().enumerate().find(|&(_, &x)| !is_whole(x)) {
        let message = format!("{what} have {x} at place {place}, which is no integer");
        return Err(invalid(py, message, "give integers"));
    }
    real.call_method1("astype", (numpy.getattr("int64")?,))
}

fn checked(py: Python<'_>, numbers: &[i64], what: &str) -> PyResult<Vec<u32>> {
    let mut ids = Vec::with_capacity(numbers.len());
    for (i, &number) in numbers.iter().enumerate() {
        let id = u32::try_from(number).map_err(|_| {
            let cure = if number < 0 { "ids count from 0" } else { "give ids below 4294967296" };
            invalid(py, format!("{what} have the number {number} at place {i}"), cure)
        })?;
        ids.push(id);
    }
    Ok(ids)
}

/// A list of ids.
pub(crate) fn ids(value: &Bound<'_, PyAny>, what: &str) -> PyResult<Vec<u32>> {
    let flat = along_one_axis(integers(value, what)?, what)?;
    let numbers: PyReadonlyArray1<'_, i64> = flat.extract()?;
    checked(value.py(), numbers.as_slice()?, what)
}

/// Signed numbers along one axis.
pub(crate) fn numbers(value: &Bound<'_, PyAny>, what: &str) -> PyResult<Vec<i64>> {
    let flat = along_one_axis(integers(value, what)?, what)?;
    let numbers: PyReadonlyArray1<'_, i64> = flat.extract()?;
    Ok(numbers.as_slice()?.to_vec())
}

/// Signed numbers of an array of any shape, its last axis fastest.
pub(crate) fn all_numbers(value: &Bound<'_, PyAny>, what: &str) -> PyResult<Vec<i64>> {
    let flat = integers(value, what)?.call_method1("reshape", (-1,))?;
    let numbers: PyReadonlyArray1<'_, i64> = flat.extract()?;
    Ok(numbers.as_slice()?.to_vec())
}

/// Lists of ids: an integer array of shape (m, k), a list of lists, or (flat, offsets).
pub(crate) fn lists(value: &Bound<'_, PyAny>, what: &str) -> PyResult<RaggedArray> {
    let py = value.py();
    let value = &plain(value)?;
    if let Ok(pair) = value.cast::<PyTuple>()
        && pair.len() == 2
        && is_one_dimensional(&pair.get_item(0)?)?
        && is_one_dimensional(&pair.get_item(1)?)?
    {
        let flat = ids(&pair.get_item(0)?, what)?;
        let offsets = ids(&pair.get_item(1)?, "offsets")?;
        return RaggedArray::from_parts(offsets, flat).or_raise(py);
    }
    if value.hasattr("dtype")? || is_rectangular(value)? {
        let array = integers(value, what)?;
        let shape: Vec<usize> = array.getattr("shape")?.extract()?;
        return match shape[..] {
            [0] | [0, _] => Ok(RaggedArray::new()),
            [_, width] => {
                let grid: PyReadonlyArray2<'_, i64> = array.extract()?;
                RaggedArray::uniform(width, checked(py, grid.as_slice()?, what)?).or_raise(py)
            }
            _ => Err(invalid(
                py,
                format!("{what} have the shape {}", shape_text(&shape)),
                "give an array of shape (m, k), a list of lists, or (flat, offsets)",
            )),
        };
    }
    let mut flat = Vec::new();
    let mut starts = vec![0_u32];
    for list in value.try_iter().map_err(|_| {
        invalid(
            py,
            format!("{what} are no lists of ids"),
            "give an array of shape (m, k), a list of lists, or (flat, offsets)",
        )
    })? {
        let list = list?;
        append_ids(&list, what, &mut flat)?;
        let end = u32::try_from(flat.len())
            .map_err(|_| invalid(py, format!("{what} have more than 4294967295 corners"), "give fewer"))?;
        starts.push(end);
    }
    RaggedArray::from_parts(starts, flat).or_raise(py)
}

/// The ids of one list or tuple, without an array where they are plain integers.
fn append_ids(list: &Bound<'_, PyAny>, what: &str, flat: &mut Vec<u32>) -> PyResult<()> {
    let py = list.py();
    let is_set = list.is_instance_of::<PySet>() || list.is_instance_of::<PyFrozenSet>();
    if is_set && !matches!(what, "facets" | "simplices" | "cells") {
        let cure = "give the corners in their order, as a list";
        return Err(invalid(py, format!("{what} have the set {list}, whose corners have no order"), cure));
    }
    let list = &plain(list)?;
    if list.hasattr("dtype")? {
        flat.extend(ids(list, what)?);
        return Ok(());
    }
    if list.is_instance_of::<PyString>() {
        return Err(invalid(py, format!("{what} have the text {list}"), "give lists of integers"));
    }
    let each = list.try_iter().map_err(|_| {
        invalid(py, format!("{what} have {list} where a list of ids should be"), "give a list of lists")
    })?;
    for item in each {
        flat.push(id(&item?, what)?);
    }
    Ok(())
}

/// An integer of Python or numpy, or a float that is one.
fn whole_number<'py>(value: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    let py = value.py();
    let is_whole = value.hasattr("is_integer")? && !value.hasattr("__index__")?;
    if is_whole && value.call_method0("is_integer")?.is_truthy()? {
        return py.get_type::<PyInt>().call1((value,));
    }
    py.import("operator")?.getattr("index")?.call1((value,))
}

/// One id: an integer of Python or numpy, or a float that is one.
pub(crate) fn id(value: &Bound<'_, PyAny>, what: &str) -> PyResult<u32> {
    let py = value.py();
    let number = whole_number(value)
        .map_err(|_| invalid(py, format!("{what} have {value}, which is no integer"), "give integers"))?;
    number.extract::<u32>().map_err(|_| {
        invalid(py, format!("{what} have the number {number}"), "ids count from 0 and are below 4294967296")
    })
}

fn is_one_dimensional(value: &Bound<'_, PyAny>) -> PyResult<bool> {
    if value.hasattr("ndim")? {
        return Ok(value.getattr("ndim")?.extract::<usize>()? == 1);
    }
    Ok(false)
}

/// Whether numpy makes an array of a list of lists at once: only checked for long lists, where it is faster.
fn is_rectangular(value: &Bound<'_, PyAny>) -> PyResult<bool> {
    let Ok(list) = value.cast::<PyList>() else { return Ok(false) };
    if list.len() < 64 {
        return Ok(false);
    }
    let mut width = None;
    for item in list.iter().take(1 << 24) {
        let Ok(len) = item.len() else { return Ok(false) };
        if *width.get_or_insert(len) != len {
            return Ok(false);
        }
    }
    Ok(true)
}

/// Real numbers of any sort as a flat array in the layout of C, with its shape.
pub(crate) fn reals(value: &Bound<'_, PyAny>, what: &str) -> PyResult<(Vec<usize>, Vec<f64>)> {
    let py = value.py();
    let array = as_array(py, &plain(value)?).map_err(|_| {
        invalid(py, format!("{what} are lists of different lengths"), "give a rectangular array of numbers")
    })?;
    if !matches!(&sort_of(&array)?[..], "i" | "u" | "f") && size_of(&array)? > 0 {
        let dtype = array.getattr("dtype")?;
        return Err(invalid(py, format!("{what} have the type {dtype}"), "give real numbers"));
    }
    let numpy = py.import("numpy")?;
    let array = numpy.getattr("ascontiguousarray")?.call1((array, numpy.getattr("float64")?))?;
    let shape: Vec<usize> = array.getattr("shape")?.extract()?;
    let flat = array.call_method1("reshape", (-1,))?;
    let values: PyReadonlyArray1<'_, f64> = flat.extract()?;
    Ok((shape, values.as_slice()?.to_vec()))
}

/// Finite real numbers along one axis.
pub(crate) fn finite(value: &Bound<'_, PyAny>, what: &str) -> PyResult<Vec<f64>> {
    let values = real_list(value, what)?;
    if let Some(i) = values.iter().position(|x| !x.is_finite()) {
        return Err(invalid(
            value.py(),
            format!("{what} have {} at place {i}", values[i]),
            "give finite numbers",
        ));
    }
    Ok(values)
}

/// Real numbers along one axis; they may be NaN or infinite.
pub(crate) fn real_list(value: &Bound<'_, PyAny>, what: &str) -> PyResult<Vec<f64>> {
    let (shape, values) = reals(value, what)?;
    match shape[..] {
        [] | [_] | [_, 1] => Ok(values),
        _ => Err(invalid(
            value.py(),
            format!("{what} have the shape {}", shape_text(&shape)),
            "give an array of shape (n,): one number for each",
        )),
    }
}

/// Points: an array of shape (n, d) of finite numbers.
pub(crate) fn positions(value: &Bound<'_, PyAny>, what: &str) -> PyResult<Positions> {
    let py = value.py();
    let (shape, values) = reals(value, what)?;
    let (count, dimension) = match shape[..] {
        [0] => (0, 3),
        [count, dimension] if dimension > 0 => (count, dimension),
        _ => {
            return Err(invalid(
                py,
                format!("{what} have the shape {}", shape_text(&shape)),
                "give an array of shape (n, d): one row for each vertex",
            ));
        }
    };
    if let Some(i) = values.iter().position(|x| !x.is_finite()) {
        let message = format!("{what} have {} in row {}", values[i], i / dimension);
        return Err(invalid(py, message, "give finite coordinates"));
    }
    debug_assert_eq!(values.len(), count * dimension);
    Positions::from_flat(dimension, values).or_raise(py)
}

/// Ids as an array of `int64`.
pub(crate) fn id_array<'py>(
    py: Python<'py>,
    ids: impl IntoIterator<Item = u32>,
) -> Bound<'py, PyArray1<i64>> {
    PyArray1::from_vec(py, ids.into_iter().map(i64::from).collect())
}

/// Places as an array of `int64`.
pub(crate) fn index_array<'py>(
    py: Python<'py>,
    ids: impl IntoIterator<Item = usize>,
) -> Bound<'py, PyArray1<i64>> {
    PyArray1::from_vec(py, ids.into_iter().map(|id| id as i64).collect())
}

/// Rows of one length as an array of shape (m, width).
pub(crate) fn grid<'py, T: numpy::Element>(
    py: Python<'py>,
    values: Vec<T>,
    width: usize,
) -> PyResult<Bound<'py, PyArray2<T>>> {
    let rows = values.len().checked_div(width).unwrap_or(0);
    PyArray1::from_vec(py, values).reshape([rows, width])
}

/// Lists of ids: an array of shape (m, k) where all have one length, else (flat, offsets).
pub(crate) fn from_lists<'py, L: AsRef<[u32]>>(
    py: Python<'py>,
    lists: impl IntoIterator<Item = L>,
    width: Option<usize>,
) -> PyResult<Bound<'py, PyAny>> {
    let mut flat: Vec<i64> = Vec::new();
    let mut offsets = vec![0_i64];
    let mut uniform = width;
    let mut is_uniform = true;
    for list in lists {
        let list = list.as_ref();
        is_uniform &= *uniform.get_or_insert(list.len()) == list.len();
        flat.extend(list.iter().map(|&id| i64::from(id)));
        offsets.push(flat.len() as i64);
    }
    if is_uniform {
        return Ok(grid(py, flat, uniform.unwrap_or(0))?.into_any());
    }
    let pair = (PyArray1::from_vec(py, flat), PyArray1::from_vec(py, offsets));
    Ok(pair.into_pyobject(py)?.into_any())
}

/// An integer of any size as one of Python.
pub(crate) fn integer<'py>(py: Python<'py>, value: &Integer) -> PyResult<Bound<'py, PyAny>> {
    match value.to_i64() {
        Some(small) => Ok(small.into_pyobject(py)?.into_any()),
        None => py.get_type::<PyInt>().call1((value.to_string(),)),
    }
}

/// Integers as an array of `int64`, of objects where one is too large for that.
pub(crate) fn integer_array<'a, 'py>(
    py: Python<'py>,
    values: impl IntoIterator<Item = &'a Integer> + Clone,
) -> PyResult<Bound<'py, PyAny>> {
    let small: Option<Vec<i64>> = values.clone().into_iter().map(Integer::to_i64).collect();
    if let Some(small) = small {
        return Ok(PyArray1::from_vec(py, small).into_any());
    }
    let items: Vec<Bound<'py, PyAny>> =
        values.into_iter().map(|value| integer(py, value)).collect::<PyResult<_>>()?;
    let numpy = py.import("numpy")?;
    let array = numpy.getattr("empty")?.call1((items.len(), numpy.getattr("object_")?))?;
    array.set_item(PySlice::full(py), PyList::new(py, items)?)?;
    Ok(array)
}

/// A matrix of integers as rows: `int64`, of objects where one is too large.
pub(crate) fn integer_grid<'py>(
    py: Python<'py>,
    rows: &[Vec<Integer>],
    width: usize,
) -> PyResult<Bound<'py, PyAny>> {
    let flat = integer_array(py, rows.iter().flatten())?;
    flat.call_method1("reshape", ((rows.len(), width),))
}

/// An integer of Python.
pub(crate) fn to_integer(value: &Bound<'_, PyAny>) -> PyResult<Integer> {
    let py = value.py();
    let number = whole_number(value)
        .map_err(|_| invalid(py, format!("the coefficient {value} is no integer"), "give integers"))?;
    if let Ok(small) = number.extract::<i64>() {
        return Ok(Integer::from(small));
    }
    number.str()?.to_str()?.parse().or_raise(py)
}

/// What to do about entries of matrices beyond 32 bits; dividing a matrix would change its homology.
const BEYOND: &str =
    "write it with one more cell in each of the two degrees: 2^40 a = 0 is 2^20 a = b and 2^20 b = 0";

/// An entry of rows of integers that is beyond 64 bits, which no array of scipy holds.
fn large_entry(rows: &Bound<'_, PyAny>, what: &str) -> PyResult<Option<String>> {
    for (i, row) in rows.try_iter()?.enumerate() {
        for (j, entry) in row?.try_iter()?.enumerate() {
            let entry = entry?;
            if entry.is_instance_of::<PyInt>() && entry.extract::<i64>().is_err() {
                return Ok(Some(format!(
                    "{what} has {entry} in row {i}, column {j}, which is beyond 32 bits"
                )));
            }
        }
    }
    Ok(None)
}

/// A sparse matrix of scipy, or any array, as one of the library.
pub(crate) fn to_matrix(value: &Bound<'_, PyAny>, what: &str) -> PyResult<SparseMatrix> {
    let py = value.py();
    let class = py.import("scipy.sparse")?.getattr("csc_array")?;
    let copied = PyDict::new(py);
    copied.set_item("copy", true)?;
    let matrix = class.call((value,), Some(&copied)).map_err(|_| {
        if let Ok(Some(message)) = large_entry(value, what) {
            return invalid(py, message, BEYOND);
        }
        invalid(
            py,
            format!("{what} is no matrix"),
            "give scipy.sparse.csc_array, any other sparse array, or rows of integers",
        )
    })?;
    let sort = sort_of(&matrix)?;
    if !matches!(&sort[..], "i" | "u" | "b" | "f" | "O") && matrix.getattr("nnz")?.extract::<usize>()? > 0 {
        let dtype = matrix.getattr("dtype")?;
        return Err(invalid(py, format!("{what} has the type {dtype}"), "give integers"));
    }
    matrix.call_method0("sum_duplicates")?;
    matrix.call_method0("eliminate_zeros")?;
    matrix.call_method0("sort_indices")?;
    let [rows, _]: [usize; 2] = matrix.getattr("shape")?.extract()?;
    let starts = ids(&matrix.getattr("indptr")?, what)?;
    let indices = ids(&matrix.getattr("indices")?, what)?;
    let mut entries = Vec::with_capacity(indices.len());
    for (place, entry) in matrix.getattr("data")?.call_method0("tolist")?.try_iter()?.enumerate() {
        let entry = entry?;
        let at = || {
            let column = starts.partition_point(|&start| start as usize <= place) - 1;
            format!("{what} has {entry} in row {}, column {column}", indices[place])
        };
        let number = whole_number(&entry)
            .map_err(|_| invalid(py, format!("{}, which is no integer", at()), "give integers"))?;
        let small = number
            .extract::<i32>()
            .map_err(|_| invalid(py, format!("{}, which is beyond 32 bits", at()), BEYOND))?;
        entries.push(small);
    }
    SparseMatrix::from_parts(rows, starts, indices, entries).or_raise(py)
}
