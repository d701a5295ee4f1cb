//! Polylines and splines.

use super::{ends_of, order_of, point_array, points_of};
use crate::arrays;
use crate::errors::{OrRaise, bound, required, whole, wrong_type};
use crate::work::run;
use coface::geometry::Angle;
use coface::io;
use coface::yin;
use coface::yin::{Location, Order};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

/// A piecewise polynomial curve of the plane: a polyline or a spline.
///
/// Parameters
/// ----------
/// points : array_like, shape (n, 2)
///     Points on the curve, the first one again at the end of a closed one.
/// order : {2, 4, 6, 8}
///     2 for polylines, 4 for cubic splines, ..
/// ends : {"not-a-knot", "natural", "periodic"}
///     What holds at the ends; ``"not-a-knot"`` if it is left out.
///
/// Examples
/// --------
/// >>> import coface
/// >>> square = coface.Curve([[0, 0], [2, 0], [2, 2], [0, 2], [0, 0]])
/// >>> square.signed_area, square.is_closed
/// (4.0, True)
#[pyclass(frozen, module = "coface", name = "Curve")]
pub(crate) struct Curve {
    pub(super) curve: yin::Curve<'static>,
    /// The numbers of the knots where it may turn, rising.
    pub(super) kinks: Vec<u32>,
}

impl Curve {
    /// A curve that is smooth, or whose corners nobody named.
    fn plain(curve: yin::Curve<'static>) -> Self {
        Self { curve, kinks: Vec::new() }
    }

    /// The same curve elsewhere.
    fn moved(&self, curve: yin::Curve<'static>) -> Self {
        Self { curve, kinks: self.kinks.clone() }
    }
}

#[pymethods]
impl Curve {
    #[new]
    #[pyo3(signature = (*arguments, **options), text_signature = "(points, order=2, ends=None)")]
    fn new(
        py: Python<'_>,
        arguments: &Bound<'_, PyTuple>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let [points, order, ends] = bound("Curve", ["points", "order", "ends"], 3, arguments, options)?;
        let points = points_of(&required(py, "Curve", "points", points)?, "points")?;
        let order = order.as_ref().map_or(Ok(2), whole)?;
        let ends: String = match ends {
            None => "not-a-knot".to_owned(),
            Some(ends) => ends.extract().map_err(|_| {
                wrong_type(py, format!("ends is {ends}"), "give ends=\"not-a-knot\" or another name")
            })?,
        };
        let (order, ends) = (order_of(py, order)?, ends_of(py, &ends)?);
        let curve = run(py, None, || match order {
            Order::LINEAR => yin::Curve::polyline(&points),
            order => yin::Curve::fit(&points, order, &ends),
        })?;
        Ok(Self::plain(curve))
    }

    /// A closed spline through points with kinks at some of them.
    ///
    /// Parameters
    /// ----------
    /// points : array_like, shape (n, 2)
    ///     Points, the first one not repeated.
    /// kinks : array_like of int, optional
    ///     Places of points where the curve may turn; :class:`YinSet` takes them over.
    /// order : {2, 4, 6, 8}
    ///     The order.
    /// ends : {"not-a-knot", "natural"}
    ///     What holds at kinks.
    #[staticmethod]
    #[pyo3(signature = (points, kinks=None, order=4, ends="not-a-knot"))]
    fn closed(
        py: Python<'_>,
        points: &Bound<'_, PyAny>,
        kinks: Option<&Bound<'_, PyAny>>,
        #[pyo3(from_py_with = whole)] order: usize,
        ends: &str,
    ) -> PyResult<Self> {
        let points = points_of(points, "points")?;
        let mut kinks = kinks.map_or(Ok(Vec::new()), |kinks| arrays::ids(kinks, "kinks"))?;
        let (order, ends) = (order_of(py, order)?, ends_of(py, ends)?);
        let curve = run(py, None, || yin::Curve::fit_closed(&points, &kinks, order, &ends))?;
        kinks.sort_unstable();
        Ok(Self { curve, kinks })
    }

    /// A circle, counterclockwise.
    #[staticmethod]
    #[pyo3(signature = (center, radius, pieces=16, order=4))]
    fn circle(
        py: Python<'_>,
        center: [f64; 2],
        radius: f64,
        #[pyo3(from_py_with = whole)] pieces: usize,
        #[pyo3(from_py_with = whole)] order: usize,
    ) -> PyResult<Self> {
        let curve = yin::Curve::circle(center, radius, pieces, order_of(py, order)?).or_raise(py)?;
        Ok(Self::plain(curve))
    }

    /// An ellipse, counterclockwise.
    #[staticmethod]
    #[pyo3(signature = (center, axes, pieces=16, order=4))]
    fn ellipse(
        py: Python<'_>,
        center: [f64; 2],
        axes: [f64; 2],
        #[pyo3(from_py_with = whole)] pieces: usize,
        #[pyo3(from_py_with = whole)] order: usize,
    ) -> PyResult<Self> {
        let curve = yin::Curve::ellipse(center, axes, pieces, order_of(py, order)?).or_raise(py)?;
        Ok(Self::plain(curve))
    }

    /// The order: the degree of pieces plus 1.
    #[getter]
    fn order(&self) -> usize {
        self.curve.order().value()
    }

    /// The number of pieces.
    #[getter]
    fn pieces(&self) -> usize {
        self.curve.piece_count()
    }

    /// Whether it ends where it starts.
    #[getter]
    fn is_closed(&self) -> bool {
        self.curve.is_closed()
    }

    /// The parameters where pieces meet.
    #[getter]
    fn knots<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.curve.knots())
    }

    /// The numbers of the knots where the curve may turn, as :meth:`closed` was told or a :class:`YinSet` has them.
    #[getter]
    fn kinks<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        arrays::id_array(py, self.kinks.iter().copied())
    }

    /// The Bezier controls of all pieces: shape (n, 2).
    #[getter]
    fn controls<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        point_array(py, self.curve.controls())
    }

    /// Points at parameters: shape (n, 2).
    fn points<'py>(&self, py: Python<'py>, parameters: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let parameters = arrays::finite(parameters, "parameters")?;
        let points: Vec<[f64; 2]> = parameters.into_iter().map(|t| self.curve.point(t)).collect();
        point_array(py, &points)
    }

    /// A polyline no farther from the curve than this: shape (n, 2).
    fn flattened<'py>(&self, py: Python<'py>, tolerance: f64) -> PyResult<Bound<'py, PyAny>> {
        let points = run(py, None, || io::yin::flattened(&self.curve, tolerance))?;
        point_array(py, &points)
    }

    /// The area that it encloses, positive if it lies to the left.
    #[getter]
    fn signed_area(&self) -> f64 {
        self.curve.signed_area()
    }

    /// The length, to this relative tolerance.
    #[pyo3(signature = (tolerance=1e-12))]
    fn length(&self, tolerance: f64) -> f64 {
        self.curve.length(tolerance)
    }

    /// ``[low, high]`` corners of the smallest box.
    #[getter]
    fn bounding_box(&self) -> [[f64; 2]; 2] {
        self.curve.bounding_box()
    }

    /// The other way round.
    fn reversed(&self) -> Self {
        let count = self.curve.piece_count() as u32;
        let mut kinks: Vec<u32> = self.kinks.iter().map(|&kink| (count - kink) % count).collect();
        kinks.sort_unstable();
        Self { curve: self.curve.reversed(), kinks }
    }

    /// Moved by a vector.
    fn translated(&self, by: [f64; 2]) -> Self {
        self.moved(self.curve.translated(by))
    }

    /// Turned by degrees about a center.
    #[pyo3(signature = (degrees, center=[0.0, 0.0]))]
    fn rotated(&self, py: Python<'_>, degrees: f64, center: [f64; 2]) -> PyResult<Self> {
        Ok(self.moved(self.curve.rotated(Angle::degrees(degrees).or_raise(py)?, center)))
    }

    /// ``inside``, ``outside`` or ``boundary``: where a point lies of a closed curve.
    fn locate(&self, py: Python<'_>, point: [f64; 2]) -> PyResult<&'static str> {
        Ok(match self.curve.locate(point).or_raise(py)? {
            Location::Inside => "inside",
            Location::Outside => "outside",
            _ => "boundary",
        })
    }

    fn __len__(&self) -> usize {
        self.curve.piece_count()
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| {
            let other = other.get();
            self.curve == other.curve && self.kinks == other.kinks
        })
    }

    fn __hash__(&self) -> isize {
        self.curve.piece_count() as isize
    }

    fn __repr__(&self) -> String {
        let closed = if self.curve.is_closed() { "closed" } else { "open" };
        format!("Curve(order {}, {} pieces, {closed})", self.curve.order().value(), self.curve.piece_count())
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let rebuild = py.import("coface._coface")?.getattr("_curve")?;
        let parts = (self.order(), self.controls(py)?, self.knots(py), self.kinks(py));
        Ok((rebuild, parts.into_pyobject(py)?))
    }
}

/// Makes a curve again, for pickling.
#[pyfunction]
#[pyo3(signature = (order, controls, knots, kinks=None))]
pub(crate) fn _curve(
    py: Python<'_>,
    #[pyo3(from_py_with = whole)] order: usize,
    controls: &Bound<'_, PyAny>,
    knots: &Bound<'_, PyAny>,
    kinks: Option<&Bound<'_, PyAny>>,
) -> PyResult<Curve> {
    let (controls, knots) = (points_of(controls, "controls")?, arrays::finite(knots, "knots")?);
    let curve = yin::Curve::from_controls(order_of(py, order)?, controls, knots).or_raise(py)?;
    let kinks = kinks.map_or(Ok(Vec::new()), |kinks| arrays::ids(kinks, "kinks"))?;
    Ok(Curve { curve, kinks })
}
