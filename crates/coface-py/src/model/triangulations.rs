//! Triangulations as gluing tables: moves that keep the space, and sameness but for names.

use super::Model;
use crate::objects::to_python;
use crate::work::run;
use coface::answers::{Census, SimplifiedManifold, isomorphic};
use pyo3::prelude::*;
use std::path::PathBuf;

#[pymethods]
impl Model {
    /// A triangulated 3-manifold with fewer tetrahedra, by moves that keep the space.
    ///
    /// The moves 4-1, 3-2 and 2-0 and collapses of edges remove tetrahedra; 2-3 adds one on the way to others. The same input gives the same triangulation on every
    /// machine. The homology before and after is compared, and a boundary stays as it is.
    ///
    /// Parameters
    /// ----------
    /// attempts : int
    ///     How often moves that add a tetrahedron are tried, when none removes one.
    /// census : path-like, optional
    ///     A file of lines "signature name": the triangulation is looked up there, and moves go on until it is one of them.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// model : Model
    ///     A gluing table.
    /// done : dict
    ///     ``f_vector_before`` and ``f_vector``, ``moves`` in their order, ``homology``, ``signature``, and ``name`` with ``name_proof`` where it is
    ///     proved which manifold it is; ``census`` with the line that was ``found`` in the census.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> sphere = coface.as_model([[0, 1, 2, 3], [0, 1, 2, 4], [0, 1, 3, 4], [0, 2, 3, 4], [1, 2, 3, 4]])
    /// >>> smaller, done = sphere.simplified()
    /// >>> done["f_vector_before"][3], done["f_vector"][3], done["name"]
    /// (5, 1, 'S3')
    #[pyo3(signature = (*, attempts=200, census=None, progress=None))]
    fn simplified<'py>(
        &self,
        py: Python<'py>,
        attempts: usize,
        census: Option<PathBuf>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<(Self, Bound<'py, PyAny>)> {
        let found = run(py, progress, || match &census {
            None => SimplifiedManifold::of("model", self.model(), attempts),
            Some(path) => {
                SimplifiedManifold::in_census("model", self.model(), attempts, &Census::from_path(path)?)
            }
        })?;
        Ok((Self::of(found.model().clone()), to_python(py, found.answer())?))
    }

    /// Whether another triangulation is the same as this one but for the names of simplices and vertices, and with which names.
    ///
    /// Parameters
    /// ----------
    /// other : Model
    ///     A gluing table, a facet list, or a mesh of triangles or tetrahedra.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// dict
    ///     ``isomorphic``; ``difference``, the first thing in which they differ; ``simplices``, for each of this model the one of the other, and
    ///     ``vertices``, the places of its vertices there; ``signatures`` of both, which are equal if and only if the triangulations are the same.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> disk, other = coface.as_model([[0, 1, 2], [1, 2, 3]]), coface.as_model([[5, 7, 6], [5, 6, 4]])
    /// >>> disk.isomorphism(other)["isomorphic"]
    /// True
    #[pyo3(signature = (other, *, progress=None))]
    fn isomorphism<'py>(
        &self,
        py: Python<'py>,
        other: &Self,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let answer = run(py, progress, || isomorphic(["model", "other"], [self.model(), other.model()]))?;
        to_python(py, &answer)
    }
}
