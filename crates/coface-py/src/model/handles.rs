//! Handles of surfaces in space.

use super::Model;
use crate::objects::to_python;
use crate::work::run;
use coface::answers::{FillHandlesRequest, HandlesRequest};
use pyo3::prelude::*;

#[pymethods]
impl Model {
    /// The handles of closed surfaces in space, each by a short handle loop, which bounds on the inside, and a short tunnel loop, which bounds
    /// on the outside.
    ///
    /// Parameters
    /// ----------
    /// shorter_than : float, optional
    ///     List only handles whose shorter loop is shorter than this, in the unit of the positions.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// dict
    ///     ``genus``, the number of all handles, and ``handles``, that with the shortest loop first: dictionaries with ``length``,
    ///     ``shorter``, ``component``, ``handle`` and ``tunnel``; loops have ``length`` and ``vertices``, the first one again at the end.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> found = coface.generate("csaszar").handles()
    /// >>> found["genus"], found["handles"][0]["shorter"]
    /// (1, 'tunnel')
    #[pyo3(signature = (*, shorter_than=None, progress=None))]
    fn handles<'py>(
        &self,
        py: Python<'py>,
        shorter_than: Option<f64>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let request = HandlesRequest::new().shorter_than(shorter_than);
        let answer = run(py, progress, || request.found(self.model(), "model"))?;
        to_python(py, &answer)
    }

    /// Closed surfaces in space without their short handles: cut along handle loops and tunnel loops, the cuts filled with triangles, until
    /// no such loop is left.
    ///
    /// Parameters
    /// ----------
    /// shorter_than : float, optional
    ///     Fill only handles with a loop shorter than this, in the unit of the positions; all of them otherwise.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// model : Model
    ///     Vertices keep their numbers; no triangles meet beside their common vertices, which is decided exactly.
    /// done : dict
    ///     ``before`` and ``after`` with ``genus``, ``euler_characteristic``, ``components``, ``closed`` and ``orientable``; ``filled``, the
    ///     loops in their order; ``left``, the loops on which no patch fits.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> sphere, done = coface.generate("torus", columns=16, rows=8).handles_filled()
    /// >>> done["before"]["genus"], done["after"]["genus"], sphere.surface().genus
    /// (1, 0, 0)
    #[pyo3(signature = (*, shorter_than=None, progress=None))]
    fn handles_filled<'py>(
        &self,
        py: Python<'py>,
        shorter_than: Option<f64>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<(Self, Bound<'py, PyAny>)> {
        let request = FillHandlesRequest::new().shorter_than(shorter_than.unwrap_or(f64::INFINITY));
        let (model, answer) = run(py, progress, || request.filled(self.model(), "model"))?;
        Ok((Self::of(model), to_python(py, &answer)?))
    }
}
