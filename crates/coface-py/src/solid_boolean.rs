//! The surface that a Boolean formula selects of surfaces in space.

use crate::answer::answer;
use crate::errors::OrRaise;
use crate::model::Model;
use crate::objects::{remarks_of, text_of, to_python};
use crate::spatial_arrangement::{write_model, written_bytes};
use crate::target::{Target, warn_all};
use crate::work::run;
use coface::answers::answer::{SolidBooleanAnswer, SolidBooleanProvenance};
use coface::answers::{CongruentBoolean, CongruentScene, SceneArrangement, SolidBoolean, SolidRequest};
use coface::io::{self, Format};
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::sync::OnceLock;

/// The cells that a combination is of.
pub(crate) enum Combined {
    Exact(Box<SceneArrangement>),
    Glued(Box<CongruentScene>),
}

/// Solids combined: a surface.
///
/// Made by :func:`boolean`.
#[pyclass(frozen, dict, module = "coface", name = "SolidBoolean")]
pub(crate) struct SolidBooleanResult {
    answer: SolidBooleanAnswer,
    provenance: SolidBooleanProvenance,
    model: Py<Model>,
    arrangement: Combined,
    request: SolidRequest,
    /// Made when they are asked for.
    cells: OnceLock<Py<Model>>,
}

answer! { SolidBooleanResult {
    /// The volume; ``None`` if the exterior is in the result.
    measure,
    /// The numbers of vertices, edges and faces of the surface.
    f_vector,
    /// The number of components of the surface.
    components,
    /// Whether the surface has no rim.
    closed,
    /// Whether the surface is a manifold, with a witness if not.
    manifold,
    /// The area of the surface.
    area,
    /// The genus of a connected surface.
    genus,
    /// The number of parts that are connected through faces.
    solids,
    /// The number of voids.
    voids,
    /// Whether the exterior is in the result.
    unbounded,
    /// Edges and vertices where the result is no surface.
    pinches,
    /// What rounding of coordinates does.
    rounding,
    /// What was put together, where that was asked for or needed.
    joined,
    /// What congruence put together, with ``method="congruence"``.
    congruence,
    /// Vertices - edges + faces.
    euler_characteristic,
}
    /// What was assumed, changed or left out, each a dictionary with ``code``, ``message``, ``count`` and ``places``; a warning said so too.
    #[getter]
    fn remarks<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        remarks_of(py, &self.answer.remarks)
    }

    /// The surface.
    #[getter]
    fn model(&self, py: Python<'_>) -> Py<Model> {
        self.model.clone_ref(py)
    }

    /// The cells of the result as a chain complex with positions, refined until each is a ball, so that its homology is
    /// that of the result.
    #[getter]
    fn cells(&self, py: Python<'_>) -> PyResult<Py<Model>> {
        if let Some(cells) = self.cells.get() {
            return Ok(cells.clone_ref(py));
        }
        let exact = self.model.get().source.model.exact_polygons().cloned();
        let made = run(py, None, || {
            let made = match &self.arrangement {
                Combined::Exact(own) => SolidBoolean::of(own, &self.request)?.to_chains()?,
                Combined::Glued(own) => CongruentBoolean::of(own, &self.request)?.to_chains()?,
            };
            Ok(match exact {
                Some(exact) => made.with_exact_polygons(exact),
                None => made,
            })
        })?;
        let made = Py::new(py, Model::of(made))?;
        Ok(self.cells.get_or_init(|| made).clone_ref(py))
    }

    /// The result as a file of this format: ``json`` has the cells, others the surface.
    fn to_bytes<'py>(&self, py: Python<'py>, format: &str) -> PyResult<Bound<'py, PyBytes>> {
        let format = Format::from_name(format).or_raise(py)?;
        let model = self.written(py, format)?;
        let bytes = run(py, None, || written_bytes(&model.get().source.model, format))?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// Writes the result to a file, by its path or open for writing: ``.json`` has the cells, others the surface.
    #[pyo3(signature = (path, format=None))]
    fn write(&self, py: Python<'_>, path: &Bound<'_, PyAny>, format: Option<&str>) -> PyResult<()> {
        let format = Target::of(path)?.known_format(py, format)?;
        let model = self.written(py, format)?;
        write_model(py, path, Some(format.name()), |_| Ok(model.get().source.model.clone()))
    }

    /// Where everything comes from.
    fn provenance<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.provenance)
    }

    fn __repr__(&self) -> String {
        format!("SolidBoolean(volume {}, f-vector {})", text_of(&self.answer.measure), text_of(&self.answer.f_vector))
    }
}

impl SolidBooleanResult {
    /// What a file of this format holds, as the program writes it.
    fn written(&self, py: Python<'_>, format: Format) -> PyResult<Py<Model>> {
        match format {
            Format::Json => self.cells(py),
            _ => Ok(self.model.clone_ref(py)),
        }
    }
}

/// The result with what it is asked for later.
pub(crate) fn solid_result(
    py: Python<'_>,
    (answer, provenance, mesh, arrangement, request): (
        SolidBooleanAnswer,
        SolidBooleanProvenance,
        io::Model,
        Combined,
        SolidRequest,
    ),
) -> PyResult<Bound<'_, PyAny>> {
    warn_all(py, &answer.remarks)?;
    let result = SolidBooleanResult {
        answer,
        provenance,
        model: Py::new(py, Model::of(mesh))?,
        arrangement,
        request,
        cells: OnceLock::new(),
    };
    Ok(Bound::new(py, result)?.into_any())
}
