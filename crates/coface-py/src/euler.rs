//! Euler characteristics of what has entered, and along directions.

use crate::arrays;
use crate::chain_complex::ChainComplex;
use crate::diagrams::values_at;
use crate::errors::{OrRaise, invalid, whole};
use crate::images::{grey_image, periodic_reading};
use crate::persistence::filtration;
use crate::work::run;
use coface::answers::answer::EulerAnswer;
use coface::answers::{Directions, EulerRequest, ImageRequest};
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArray2, PyReadonlyArrayDyn};
use pyo3::prelude::*;

/// Values, and the numbers at them.
type Curve<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>);

fn request(at: Option<&Bound<'_, PyAny>>, smooth: bool) -> PyResult<EulerRequest> {
    let request = EulerRequest::new().smooth(smooth);
    Ok(match at {
        Some(at) => request.values(values_at(at)?),
        None => request,
    })
}

fn curve(py: Python<'_>, answer: EulerAnswer) -> Curve<'_> {
    let numbers = answer.curves.into_iter().next().unwrap_or_default();
    (PyArray1::from_vec(py, answer.values), PyArray1::from_vec(py, numbers))
}

/// The Euler characteristic of the cells that have entered, at each value.
#[pyfunction]
#[pyo3(signature = (complex, *, vertex_values=None, cell_values=None, upper=false, at=None, smooth=false, progress=None), text_signature = "(complex, *, vertex_values=None, cell_values=None, upper=False, at=None, smooth=False, progress=False)")]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn _euler_curve<'py>(
    py: Python<'py>,
    complex: &Bound<'py, ChainComplex>,
    vertex_values: Option<&Bound<'py, PyAny>>,
    cell_values: Option<&Bound<'py, PyAny>>,
    upper: bool,
    at: Option<&Bound<'py, PyAny>>,
    smooth: bool,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Curve<'py>> {
    let complex = complex.get();
    let request = request(at, smooth)?;
    let vertex_values = vertex_values.map(|values| arrays::finite(values, "vertex_values")).transpose()?;
    let lists = |lists: &Bound<'py, PyAny>| -> PyResult<Vec<Vec<f64>>> {
        lists.try_iter()?.map(|list| arrays::real_list(&list?, "cell_values")).collect()
    };
    let cell_values = cell_values.map(lists).transpose()?;
    let answer = run(py, progress, || {
        let filtration = filtration(complex, vertex_values, cell_values, upper)?;
        request.answer_of_filtration("model", "values", &filtration)
    })?;
    Ok(curve(py, answer))
}

/// The Euler characteristic of the voxels that have entered, at each value.
#[pyfunction]
#[pyo3(signature = (values, *, construction="t", superlevel=false, periodic=Vec::new(), mask=None, at=None, smooth=false, progress=None), text_signature = "(values, *, construction='t', superlevel=False, periodic=(), mask=None, at=None, smooth=False, progress=False)")]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn _euler_curve_of_image<'py>(
    py: Python<'py>,
    values: &Bound<'py, PyAny>,
    construction: &str,
    superlevel: bool,
    periodic: Vec<usize>,
    mask: Option<PyReadonlyArrayDyn<'py, bool>>,
    at: Option<&Bound<'py, PyAny>>,
    smooth: bool,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Curve<'py>> {
    let image = grey_image(py, values, mask)?;
    let request = request(at, smooth)?;
    let reading = periodic_reading(py, &image, periodic)?;
    let construction = construction.parse().or_raise(py)?;
    let of_image = ImageRequest::new().construction(construction).superlevel(superlevel).periodic(reading);
    let answer = run(py, progress, || request.answer_of_image("image", &of_image, image))?;
    Ok(curve(py, answer))
}

/// Directions, values, and a row of numbers for each direction.
type Transform<'py> = (Bound<'py, PyArray2<f64>>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray2<f64>>);

/// The Euler characteristic transform of a complex whose vertices have positions.
#[pyfunction]
#[pyo3(signature = (complex, positions, directions, *, at=None, normalize=false, smooth=false, progress=None), text_signature = "(complex, positions, directions, *, at=None, normalize=False, smooth=False, progress=False)")]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn _euler_transform<'py>(
    py: Python<'py>,
    complex: &Bound<'py, ChainComplex>,
    positions: PyReadonlyArray2<'py, f64>,
    directions: &Bound<'py, PyAny>,
    at: Option<&Bound<'py, PyAny>>,
    normalize: bool,
    smooth: bool,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Transform<'py>> {
    let complex = complex.get();
    let directions = match directions.extract::<PyReadonlyArray2<'py, f64>>() {
        Ok(rows) => Directions::Given {
            place: "directions".to_owned(),
            rows: rows.as_array().rows().into_iter().map(|row| row.to_vec()).collect(),
        },
        Err(_) => Directions::Even(whole(directions)?),
    };
    let request = request(at, smooth)?.directions(Some(directions)).normalized(normalize);
    let dimension = positions.as_array().ncols();
    if dimension == 0 {
        return Err(invalid(
            py,
            "vertices have no positions, so that they have no heights".to_owned(),
            "give a model with positions",
        ));
    }
    let flat: Vec<f64> = positions.as_array().iter().copied().collect();
    let answer =
        run(py, progress, || request.answer_of_positions("model", &complex.complex, flat, dimension))?;
    let rows = |rows: Vec<Vec<f64>>, width: usize| {
        let shape = [rows.len(), width];
        PyArray1::from_vec(py, rows.concat()).reshape(shape)
    };
    let directions = rows(answer.directions.unwrap_or_default(), dimension)?;
    let numbers = rows(answer.curves, answer.values.len())?;
    Ok((directions, PyArray1::from_vec(py, answer.values), numbers))
}
