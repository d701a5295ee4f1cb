//! The kinks of a set.

use super::{YinSet, point_array};
use crate::arrays;
use crate::errors::raised;
use coface::yin;
use coface::{Error, ErrorKind, VertexId};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyList;

/// The kinks of a set: knots where its boundary may turn, with names that stay.
///
/// A mapping from names to ``(curve, knot)``: ``dict(kinks)`` has them all.
#[pyclass(frozen, mapping, module = "coface", name = "Kinks")]
pub(crate) struct Kinks {
    pub(super) set: Py<YinSet>,
}

impl Kinks {
    fn kinks(&self) -> &yin::Kinks {
        self.set.get().inner().kinks()
    }
}

/// A view of the mapping, as of a dictionary.
fn view<'py>(kinks: &Bound<'py, Kinks>, name: &str) -> PyResult<Bound<'py, PyAny>> {
    kinks.py().import("collections.abc")?.getattr(name)?.call1((kinks,))
}

#[pymethods]
impl Kinks {
    /// The set that they are of.
    #[getter]
    fn set(&self, py: Python<'_>) -> Py<YinSet> {
        self.set.clone_ref(py)
    }

    /// The names, in the order of curves and knots.
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        arrays::id_array(py, self.kinks().iter().map(|(_, vertex)| vertex.to_u32()))
    }

    /// The curves and knots: ``int64``, shape (n, 2).
    #[getter]
    fn knots<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let flat: Vec<i64> =
            self.kinks().iter().flat_map(|(at, _)| [i64::from(at.curve), i64::from(at.knot)]).collect();
        arrays::grid(py, flat, 2).map(Bound::into_any)
    }

    /// The points: ``float64``, shape (n, 2).
    #[getter]
    fn points<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let set = self.set.get().inner();
        let points: Vec<[f64; 2]> = set
            .kinks()
            .iter()
            .map(|(at, _)| set.curve(at.curve as usize).knot_point(at.knot as usize))
            .collect();
        point_array(py, &points)
    }

    fn __getitem__(&self, py: Python<'_>, vertex: u32) -> PyResult<(u32, u32)> {
        let at = self.kinks().knot(VertexId::from_u32(vertex)).ok_or_else(|| {
            let error = Error::new(ErrorKind::NotInComplex, format!("there is no kink {vertex}"));
            raised(py, &error.with_cells([[vertex]]).with_cure("look at .vertices"))
        })?;
        Ok((at.curve, at.knot))
    }

    fn __contains__(&self, vertex: &Bound<'_, PyAny>) -> bool {
        vertex.extract().is_ok_and(|vertex| self.kinks().knot(VertexId::from_u32(vertex)).is_some())
    }

    /// The names.
    fn keys<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        view(slf, "KeysView")
    }

    /// The curves and knots.
    fn values<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        view(slf, "ValuesView")
    }

    /// The names, each with its curve and knot.
    fn items<'py>(slf: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        view(slf, "ItemsView")
    }

    /// The curve and the knot of a name, or something else if there is no such kink.
    #[pyo3(signature = (vertex, default=None))]
    fn get<'py>(
        &self,
        py: Python<'py>,
        vertex: u32,
        default: Option<Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        match self.kinks().knot(VertexId::from_u32(vertex)) {
            Some(at) => Ok((at.curve, at.knot).into_pyobject(py)?.into_any()),
            None => Ok(default.unwrap_or_else(|| py.None().into_bound(py))),
        }
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let names: Vec<u32> = self.kinks().iter().map(|(_, vertex)| vertex.to_u32()).collect();
        PyList::new(py, names)?.call_method0("__iter__")
    }

    fn __len__(&self) -> usize {
        self.kinks().len()
    }

    fn __repr__(&self) -> String {
        format!("Kinks({})", self.kinks().len())
    }
}
