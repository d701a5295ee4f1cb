//! Persistence diagrams as data: distances, curves and images.

use crate::arrays;
use crate::errors::{OrRaise, warn, whole};
use crate::work::run;
use coface::answers::{
    CurveValues, DiagramCurveKind, DiagramCurvesRequest, DiagramDistanceRequest, DiagramImageRequest,
    DiagramMetric, GivenDiagram,
};
use coface::topology::Barcode;
use numpy::{PyArray1, PyArray2, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyList;

/// Values and the numbers of curves at them.
pub(crate) type Curves<'py> = (Bound<'py, PyArray1<f64>>, Bound<'py, PyArray2<f64>>);

/// How far two diagrams are from each other, with the matched classes of each degree.
///
/// Parameters
/// ----------
/// first, second : sequence of array_like of float
///     For each degree an array of births and deaths, one after the other.
/// order : float, optional
///     The order of the Wasserstein distance; the bottleneck distance if not given.
/// internal_p : float
///     The exponent of the norm that measures a pair.
/// degree : int, optional
///     One degree alone.
///
/// Returns
/// -------
/// tuple
///     The distance, and for each degree the matching: ``int64``, shape (n, 2), -1 for the diagonal.
#[pyfunction]
#[pyo3(signature = (first, second, *, order=None, internal_p=f64::INFINITY, degree=None), text_signature = "(first, second, *, order=None, internal_p=inf, degree=None)")]
pub(crate) fn _diagram_distance<'py>(
    py: Python<'py>,
    first: &Bound<'py, PyAny>,
    second: &Bound<'py, PyAny>,
    order: Option<f64>,
    internal_p: f64,
    degree: Option<&Bound<'py, PyAny>>,
) -> PyResult<(f64, Bound<'py, PyList>)> {
    let degree = degree.map(whole).transpose()?;
    let (first, second) = (given(py, first)?, given(py, second)?);
    let metric =
        order.map_or(DiagramMetric::Bottleneck, |order| DiagramMetric::Wasserstein { order, internal_p });
    let request = DiagramDistanceRequest::new().metric(metric).degree(degree).matching(true);
    let answer = run(py, None, || request.answer(&first, &second))?;
    let matching = answer.degrees.iter().map(|one| {
        // The places are those among the classes of all degrees: here each degree has its own array.
        let start = |diagram: &GivenDiagram| -> usize {
            let before = diagram.barcodes().iter().take(one.degree);
            before.map(|barcode| barcode.intervals().len()).sum()
        };
        let starts = [start(&first), start(&second)];
        let pairs = one.matching.iter().flatten();
        let places: Vec<i64> = pairs
            .flat_map(|pair| [0, 1].map(|side| pair[side].map_or(-1, |place| (place - starts[side]) as i64)))
            .collect();
        let count = places.len() / 2;
        PyArray1::from_vec(py, places).reshape([count, 2])
    });
    let matching = PyList::new(py, matching.collect::<PyResult<Vec<_>>>()?)?;
    Ok((answer.distance.unwrap_or(f64::INFINITY), matching))
}

/// The diagram of an array for each degree.
fn given(py: Python<'_>, degrees: &Bound<'_, PyAny>) -> PyResult<GivenDiagram> {
    let mut barcodes = Vec::new();
    for numbers in degrees.try_iter()? {
        let numbers = arrays::real_list(&numbers?, "a diagram")?;
        let intervals = numbers.chunks_exact(2).map(|pair| [pair[0], pair[1]]).collect();
        barcodes.push(Barcode::new(intervals).or_raise(py)?);
    }
    Ok(GivenDiagram::new("diagram", barcodes))
}

/// Curves of a diagram at what a user gives: an array of values, or their number.
pub(crate) fn curves<'py>(
    py: Python<'py>,
    diagram: &GivenDiagram,
    kind: DiagramCurveKind,
    degree: Option<usize>,
    at: Option<&Bound<'py, PyAny>>,
    end: Option<f64>,
) -> PyResult<Curves<'py>> {
    let mut request = DiagramCurvesRequest::new(kind).degree(degree).end(end);
    if let Some(at) = at {
        request = request.values(values_at(at)?);
    }
    let answer = run(py, None, || request.answer(diagram))?;
    for remark in &answer.remarks {
        warn(py, &remark.message)?;
    }
    let shape = [answer.curves.len(), answer.values.len()];
    let numbers: Vec<f64> = answer.curves.iter().flat_map(|curve| curve.numbers.iter().copied()).collect();
    Ok((PyArray1::from_vec(py, answer.values), PyArray1::from_vec(py, numbers).reshape(shape)?))
}

/// Values, or their number.
pub(crate) fn values_at(at: &Bound<'_, PyAny>) -> PyResult<CurveValues> {
    Ok(match at.is_instance_of::<pyo3::types::PyInt>() {
        true => CurveValues::Even { count: whole(at)?, range: None },
        false => CurveValues::Given(arrays::finite(at, "at")?),
    })
}

/// A persistence image.
pub(crate) fn image<'py>(
    py: Python<'py>,
    diagram: &GivenDiagram,
    request: &DiagramImageRequest,
) -> PyResult<Bound<'py, PyArray2<f64>>> {
    let answer = run(py, None, || request.answer(diagram))?;
    for remark in &answer.remarks {
        warn(py, &remark.message)?;
    }
    let shape = [answer.rows.len(), answer.rows.first().map_or(0, Vec::len)];
    PyArray1::from_vec(py, answer.rows.concat()).reshape(shape)
}
