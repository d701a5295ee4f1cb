//! What polygons cut space into, as an answer.

use crate::answer::answer;
use crate::arrays;
use crate::chain_complex::ChainComplex;
use crate::errors::OrRaise;
use crate::model::Model;
use crate::objects::{remarks_of, text_of, to_python};
use crate::target::{Target, warn_all};
use crate::work::run;
use coface::answers::answer::SpatialArrangementAnswer;
use coface::answers::{CongruentScene, SceneArrangement, losses_of};
use coface::arrange::boolean::InsideRule;
use coface::io::{self, Format};
use coface::{Error, ErrorKind};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

/// A model as the bytes of a file.
pub(crate) fn written_bytes(model: &io::Model, format: Format) -> Result<Vec<u8>, Error> {
    let mut bytes = Vec::new();
    io::write(model, &mut bytes, format)?;
    Ok(bytes)
}

/// Writes the model that an answer has for a format, after a warning for all that the format does not keep.
pub(crate) fn write_model(
    py: Python<'_>,
    path: &Bound<'_, PyAny>,
    format: Option<&str>,
    model: impl FnOnce(Format) -> Result<io::Model, Error> + Send,
) -> PyResult<()> {
    let target = Target::of(path)?;
    let format = target.known_format(py, format)?;
    let model = run(py, None, || model(format))?;
    warn_all(py, &losses_of(&model, format))?;
    target.write(py, None, |out| io::write(&model, out, format))
}

/// Refuses formats that hold no polygons in space.
fn refuse_drawing(format: Format) -> Result<(), Error> {
    match format {
        Format::Off
        | Format::Obj
        | Format::Ply
        | Format::Stl
        | Format::Medit
        | Format::Msh
        | Format::Vtk
        | Format::VtkGrid
        | Format::VtkPolygons
        | Format::ThreeMf
        | Format::Amf
        | Format::Json => Ok(()),
        _ => Err(Error::new(
            ErrorKind::UnsupportedFormat,
            format!("a file of {} holds no polygons in space", format.title()),
        )
        .with_cure("write .vtk, .vtu, .vtp, .ply, .obj, .off, .stl, .3mf, .amf, .mesh, .msh or .json")),
    }
}

/// How the cells of space were found.
pub(crate) enum Arranged {
    Exact(Box<SceneArrangement>),
    Congruent(Box<CongruentScene>),
}

/// What polygons cut space into: vertices, edges, faces and bounded cells.
///
/// Made by :func:`arrange`.
#[pyclass(frozen, dict, module = "coface", name = "SpatialArrangement")]
pub(crate) struct SpatialArrangement {
    pub(crate) arranged: Arranged,
    pub(crate) rule: InsideRule,
    pub(crate) answer: SpatialArrangementAnswer,
    /// Whether models of it keep exact points.
    pub(crate) exact: bool,
}

impl SpatialArrangement {
    /// The faces as a mesh, in groups by cell.
    fn mesh(&self, triangles: Option<bool>, groups: bool) -> Result<io::Model, Error> {
        let arranged = match &self.arranged {
            Arranged::Exact(arranged) => arranged,
            Arranged::Congruent(own) => {
                return own.to_mesh(triangles.unwrap_or_else(|| own.scene().is_triangulated()), groups);
            }
        };
        let triangles = triangles.unwrap_or_else(|| arranged.scene().is_triangulated());
        let mesh = arranged.to_mesh(triangles, groups)?;
        Ok(match self.exact {
            true => mesh.with_exact_polygons(arranged.exact_polygons().into()),
            false => mesh,
        })
    }

    /// Vertices, edges, faces and bounded cells as a chain complex with positions.
    fn chains(&self) -> Result<io::Model, Error> {
        let arranged = match &self.arranged {
            Arranged::Exact(arranged) => arranged,
            Arranged::Congruent(own) => return own.to_chains(),
        };
        let chains = arranged.to_chains(false)?;
        Ok(match self.exact {
            true => chains.with_exact_polygons(arranged.exact_polygons().into()),
            false => chains,
        })
    }

    /// What a file of this format holds, as the program writes it.
    fn written(&self, format: Format) -> Result<io::Model, Error> {
        match format {
            Format::Json => self.chains(),
            Format::Stl => self.mesh(Some(true), false),
            _ => {
                refuse_drawing(format)?;
                self.mesh(None, matches!(format, Format::Obj | Format::Msh | Format::Medit))
            }
        }
    }
}

answer! { SpatialArrangement {
    /// The numbers of vertices, edges, faces and bounded cells.
    f_vector,
    /// The volumes of the bounded cells.
    measures,
    /// For each bounded cell the inputs that contain it.
    inside,
    /// The number of holes of faces.
    holes,
    /// The number of voids of cells.
    voids,
    /// The number of connected components of faces.
    components,
    /// Vertices - edges + faces - bounded cells.
    euler_characteristic,
    /// The number of faces with one cell, or the exterior, on both sides.
    dangling_faces,
    /// The names of the inputs, if objects, groups, features or components are inputs.
    regions,
    /// For each face the inputs that have a polygon there, if objects, groups, features or components are inputs.
    inputs_of_faces,
    /// The inputs: names, numbers of polygons, and whether each is closed.
    files,
    /// What rounding of coordinates does.
    rounding,
    /// What was put together, where that was asked for or needed.
    joined,
    /// Whether products of boundary matrices are zero, found by multiplying.
    products_zero,
    /// What congruence put together, with ``method="congruence"``.
    congruence,
}
    /// What was assumed, changed or left out, each a dictionary with ``code``, ``message``, ``count`` and ``places``; a warning said so too.
    #[getter]
    fn remarks<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        remarks_of(py, &self.answer.remarks)
    }

    /// The positions of the vertices: ``float64``, shape (n, 3).
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let positions = match &self.arranged {
            Arranged::Exact(own) => own.positions(),
            Arranged::Congruent(own) => own.positions(),
        };
        Ok(arrays::grid(py, positions.as_flat().to_vec(), positions.dimension().max(3))?.into_any())
    }

    /// Where everything comes from.
    fn provenance<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(
            py,
            &match &self.arranged {
                Arranged::Exact(own) => own.provenance(),
                Arranged::Congruent(own) => own.provenance(),
            },
        )
    }

    /// The chain complex of vertices, edges, faces and bounded cells, refined until each is a ball: its homology is that of
    /// the union of all faces and bounded cells. Those found by congruence are as they are.
    fn chain_complex(&self, py: Python<'_>) -> PyResult<ChainComplex> {
        run(py, None, || match &self.arranged {
            Arranged::Exact(own) => own.chain_complex(),
            Arranged::Congruent(own) => Ok(own.complex().clone()),
        })
        .map(ChainComplex::bare)
    }

    /// The graph of the bounded cells: which are adjacent, and across how much area.
    ///
    /// Returns
    /// -------
    /// CellGraph
    ///     Cells with volumes, centers and the inputs that contain them; pairs of cells with the area between them.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> cube = coface.generate("box", boundary=True)
    /// >>> graph = coface._coface.arrange([cube, coface.Model(cube.vertices + 0.5, cube.faces)]).graph()
    /// >>> [round(edge.area, 6) for edge in graph.edges]
    /// [0.75, 0.75]
    fn graph<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let graph = run(py, None, || match &self.arranged {
            Arranged::Exact(arranged) => arranged.graph(self.rule),
            Arranged::Congruent(arranged) => arranged.graph(self.rule),
        })?;
        let class = py.import("coface._buildings")?.getattr("CellGraph")?;
        class.call_method1("from_dict", (to_python(py, &graph)?,))
    }

    /// The faces as a model.
    ///
    /// Parameters
    /// ----------
    /// triangles : bool, optional
    ///     Whether faces are cut into triangles; if all inputs are triangles, if left out.
    ///
    /// Returns
    /// -------
    /// Model
    ///     The faces, in groups by the input that they come from.
    #[pyo3(signature = (*, triangles=None))]
    fn model(&self, py: Python<'_>, triangles: Option<bool>) -> PyResult<Model> {
        run(py, None, || self.mesh(triangles, true)).map(Model::of)
    }

    /// The vertices, edges, faces and bounded cells as a chain complex with positions, refined until each is a ball: what ``.json`` holds,
    /// and what homology and other questions about cells are asked of.
    #[getter]
    fn cells(&self, py: Python<'_>) -> PyResult<Model> {
        run(py, None, || self.chains()).map(Model::of)
    }

    /// The arrangement as a file of this format: ``json`` has the cells, others the faces.
    fn to_bytes<'py>(&self, py: Python<'py>, format: &str) -> PyResult<Bound<'py, PyBytes>> {
        let format = Format::from_name(format).or_raise(py)?;
        let bytes = run(py, None, || written_bytes(&self.written(format)?, format))?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// Writes the arrangement to a file: ``.json`` has the cells, others the faces.
    #[pyo3(signature = (path, format=None))]
    fn write(&self, py: Python<'_>, path: &Bound<'_, PyAny>, format: Option<&str>) -> PyResult<()> {
        write_model(py, path, format, |format| self.written(format))
    }

    fn __len__(&self) -> usize {
        self.answer.measures.len()
    }

    fn __repr__(&self) -> String {
        format!("SpatialArrangement(f-vector {})", text_of(&self.answer.f_vector))
    }
}
