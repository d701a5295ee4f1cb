//! Surfaces: sides of faces and their mates, and what is asked about them.

mod opened;
mod walks;

pub(crate) use opened::{Cocycles, Cover, Domain};

use crate::arrays;
use crate::errors::{OrRaise, bound, invalid, required, truth, whole, whole_or_none};
use crate::homology::Chain;
use crate::memory::shared_ids;
use crate::model::Model;
use crate::objects::to_python;
use crate::pi1::FundamentalGroup;
use crate::source::{Names, Naming, Source};
use crate::work::run;
use coface::algebra::chains::Cochain;
use coface::algebra::{Integer, Sign};
use coface::answers::answer::{EdgeWeights, WholeNumber};
use coface::answers::{
    CellName, CutRequest, Edit, LayoutChoice, LayoutRequest, LayoutWeights, PolygonSchema, Producer,
    SurfaceCocycles, SurfaceEditor, SurfaceModel, dual_graph_model, dual_model, surface_harmonic_forms,
};
use coface::complexes::surface::{GeneralizedMap, SurfaceType};
use coface::io::Structure;
use coface::topology::{
    ClosedWalk, CoverExtent, CycleKind, HarmonicForm, PolygonPlane, ShortestCycle, SurfaceHomotopy,
    TreeCotree, shortest_cycle, shortest_cycle_through, shortest_cycle_until, shortest_homology_basis,
    shortest_loops,
};
use coface::{EdgeId, Error, ErrorKind, FaceId, Fault, HalfedgeId, VertexId};
use numpy::{PyArray1, PyArrayMethods};
use opened::BasisAnswer;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use std::sync::Arc;
use std::time::{Duration, Instant};

/// How many vertices searches from all roots may reach in all.
const MOST_REACHED: usize = 2_000_000_000;

/// A surface: faces with sides, glued along edges.
///
/// Made by :meth:`Model.surface`. Side s runs along edge ``edge[s]`` of face ``face[s]``, from vertex ``vertex[s]``; the arrays have one
/// entry for each side. Vertices have numbers from 0; ``vertex_numbers`` has those of the file.
///
/// Parameters
/// ----------
/// model : Model
///     A model whose faces are a surface.
/// boundary : bool
///     Of a model with 3-cells, whether its boundary is meant.
///
/// Examples
/// --------
/// >>> import coface
/// >>> torus = coface.generate("torus", columns=5, rows=4).surface()
/// >>> torus
/// Surface(torus, f-vector (20, 60, 40))
/// >>> torus.genus, torus.is_orientable
/// (1, True)
#[pyclass(frozen, module = "coface", name = "Surface")]
pub(crate) struct Surface {
    surface: Arc<SurfaceModel>,
    source: Arc<Source>,
    of_boundary: bool,
    /// What was done to it, if it was edited.
    editor: Option<Arc<SurfaceEditor>>,
}

/// Why the model is no surface, with the cure in Python.
fn explained(error: Error, is_volume: bool) -> Error {
    let cells = error.cells().to_vec();
    let is_loose = matches!(error.fault(), Some(Fault::EdgeInFaces { faces, .. }) if faces.is_empty());
    match error.kind() {
        ErrorKind::NonManifold => Error::new(error.kind(), format!("no surface: {}", error.message()))
            .with_cells(cells)
            .with_cure(if is_volume {
                "cells must not touch along single edges or vertices"
            } else if is_loose {
                "model.repaired_surface() leaves out what lies in no face"
            } else {
                "model.repaired(split_edges=\"pairs\", split_vertices=True) can make it one"
            }),
        ErrorKind::UnsupportedFormat if is_volume => {
            error.with_cure("give boundary=True to take its boundary")
        }
        _ => error,
    }
}

pub(crate) fn surface_of(
    py: Python<'_>,
    source: &Arc<Source>,
    boundary: bool,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Surface> {
    let is_volume = !source.model.cells().is_empty();
    let surface = run(py, progress, || {
        let model = source.model.clone();
        let made =
            if boundary && is_volume { SurfaceModel::boundary_of(model) } else { SurfaceModel::of(model) };
        made.map_err(|error| explained(error, is_volume))
    })?;
    Ok(Surface {
        surface: Arc::new(surface),
        source: Arc::clone(source),
        of_boundary: boundary && is_volume,
        editor: None,
    })
}

impl Surface {
    /// The canonical polygon of each component.
    pub(crate) fn schemas(&self) -> Vec<PolygonSchema> {
        self.surface.schemas()
    }

    fn map(&self) -> &GeneralizedMap {
        self.surface.map()
    }

    fn lengths(&self) -> Option<Vec<f64>> {
        self.surface.edge_lengths()
    }

    /// An array with a number for each side.
    fn sides<'py>(&self, py: Python<'py>, of: impl Fn(HalfedgeId) -> i64) -> Bound<'py, PyArray1<i64>> {
        PyArray1::from_vec(py, self.map().sides().map(of).collect())
    }

    fn walk_numbers(&self, walk: &ClosedWalk) -> Vec<u32> {
        walk.vertices(self.map().skeleton()).into_iter().map(|vertex| self.surface.number(vertex)).collect()
    }

    /// An edge of the surface as the editor names it.
    fn cell(&self, given: &Bound<'_, PyAny>, is_halfedge: bool) -> PyResult<CellName> {
        let Ok(number) = given.extract::<usize>() else { return Ok(CellName::Ends(given.extract()?)) };
        let is_abstract = matches!(self.source.model.structure(), Some(Structure::Halfedges { .. }));
        // The edges of polygons are numbered otherwise than in the mesh that is edited.
        let edge = if is_halfedge { number / 2 } else { number };
        if is_abstract || edge >= self.map().edge_count() {
            return Ok(CellName::of(number));
        }
        let [a, b] = self.surface.edge_numbers(EdgeId::new(edge)).map(|end| end as usize);
        Ok(CellName::Ends(if is_halfedge && number % 2 == 1 { [b, a] } else { [a, b] }))
    }

    /// The surface after an edit.
    fn edited(
        &self,
        py: Python<'_>,
        change: impl FnOnce(&mut SurfaceEditor) -> Result<(), Error>,
    ) -> PyResult<Self> {
        let mut editor = match &self.editor {
            Some(editor) => SurfaceEditor::clone(editor),
            None if self.of_boundary => {
                SurfaceEditor::new(self.surface.to_model().or_raise(py)?).or_raise(py)?
            }
            None => SurfaceEditor::new(self.source.model.clone()).or_raise(py)?,
        };
        change(&mut editor).or_raise(py)?;
        let source = Source::new(editor.model().or_raise(py)?);
        Ok(Self { editor: Some(Arc::new(editor)), ..surface_of(py, &source, false, None)? })
    }

    fn naming(&self) -> Option<Naming> {
        // The cells of the boundary of a volume are not those of the model.
        (!self.of_boundary).then(|| Naming::of(Names::Source(Arc::clone(&self.source))))
    }
}

#[pymethods]
impl Surface {
    #[new]
    #[pyo3(signature = (*arguments, **options), text_signature = "(model, *, boundary=False, progress=None)")]
    fn new(
        py: Python<'_>,
        arguments: &Bound<'_, PyTuple>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let names = ["model", "boundary", "progress"];
        let [model, boundary, progress] = bound("Surface", names, 1, arguments, options)?;
        let model = required(py, "Surface", "model", model)?;
        let boundary = boundary.as_ref().map_or(Ok(false), truth)?;
        surface_of(py, &crate::given::source_of(&model)?, boundary, progress.as_ref())
    }

    /// The numbers of vertices, edges and faces.
    #[getter]
    fn f_vector(&self) -> (usize, usize, usize) {
        let map = self.map();
        (map.vertex_count(), map.edge_count(), map.face_count())
    }

    /// Vertices - edges + faces.
    #[getter]
    fn euler_characteristic(&self) -> i64 {
        let (v, e, f) = self.f_vector();
        v as i64 - e as i64 + f as i64
    }

    /// The next side around the face of each side.
    #[getter]
    fn next<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        self.sides(py, |side| self.map().next(side).index() as i64)
    }

    /// The side before each side around its face.
    #[getter]
    fn previous<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        self.sides(py, |side| self.map().previous(side).index() as i64)
    }

    /// The sides of a face in their order, as numbers of halfedges.
    fn halfedges_of_face<'py>(&self, py: Python<'py>, face: usize) -> PyResult<Bound<'py, PyArray1<i64>>> {
        walks::checked(py, "face", face, self.map().face_count())?;
        Ok(arrays::index_array(py, self.map().sides_of(FaceId::new(face)).map(HalfedgeId::index)))
    }

    /// The one or two sides along an edge.
    fn halfedges_of_edge<'py>(&self, py: Python<'py>, edge: usize) -> PyResult<Bound<'py, PyArray1<i64>>> {
        walks::checked(py, "edge", edge, self.map().edge_count())?;
        let first = self.map().first_side(EdgeId::new(edge));
        Ok(arrays::index_array(
            py,
            [Some(first), self.map().mate(first)].into_iter().flatten().map(HalfedgeId::index),
        ))
    }

    /// The sides that start from a vertex, in the order in which their faces lie around it.
    fn halfedges_from_vertex<'py>(
        &self,
        py: Python<'py>,
        vertex: usize,
    ) -> PyResult<Bound<'py, PyArray1<i64>>> {
        walks::checked(py, "vertex", vertex, self.map().vertex_count())?;
        Ok(arrays::index_array(py, walks::sides_from(self.map(), VertexId::new(vertex))))
    }

    /// The dual mesh: a vertex in the middle of each face, and a face around each vertex inside.
    fn dual(&self, py: Python<'_>) -> PyResult<Model> {
        let model = self.model(py)?;
        run(py, None, || dual_model(model.model().clone())).map(Model::of)
    }

    /// The dual graph: a vertex in the middle of each face, and a line across each edge between two faces.
    fn dual_graph(&self, py: Python<'_>) -> PyResult<Model> {
        let model = self.model(py)?;
        run(py, None, || dual_graph_model(model.model().clone())).map(Model::of)
    }

    /// The other side at the edge of each side; -1 on the boundary.
    #[getter]
    fn twin<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        self.sides(py, |side| self.map().mate(side).map_or(-1, |mate| mate.index() as i64))
    }

    /// The vertex that each side starts from.
    #[getter]
    fn vertex<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        self.sides(py, |side| self.map().source(side).index() as i64)
    }

    /// The edge of each side.
    #[getter]
    fn edge<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        self.sides(py, |side| self.map().edge(side).index() as i64)
    }

    /// The face of each side.
    #[getter]
    fn face<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        self.sides(py, |side| self.map().face(side).index() as i64)
    }

    /// The ends of each edge: ``int32``, shape (edges, 2), on the memory of the surface.
    #[getter]
    fn edge_ends<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let count = self.map().skeleton().edge_ends().len() / 2;
        let ends = shared_ids(py, &self.surface, |surface| surface.map().skeleton().edge_ends())?;
        Ok(ends.reshape([count, 2])?.into_any())
    }

    /// The numbers in the file of the vertices.
    #[getter]
    fn vertex_numbers<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        let vertices = (0..self.map().skeleton().vertex_count()).map(VertexId::new);
        arrays::id_array(py, vertices.map(|vertex| self.surface.number(vertex)))
    }

    /// The number of connected components with faces.
    #[getter]
    fn component_count(&self) -> usize {
        self.map().component_count()
    }

    /// The component of each face.
    #[getter]
    fn components<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        let orientation = self.map().orientation();
        let faces = (0..self.map().skeleton().face_count()).map(FaceId::new);
        arrays::index_array(py, faces.map(|face| orientation.component(face)))
    }

    /// The boundary loops, each an array of its vertices in order, as numbers of the file.
    fn boundary_loops<'py>(&self, py: Python<'py>) -> Vec<Bound<'py, PyArray1<i64>>> {
        let map = self.map();
        let vertex = |&(side, sign): &(HalfedgeId, Sign)| {
            self.surface.number(if sign == Sign::Plus { map.source(side) } else { map.target(side) })
        };
        map.boundary_loops().iter().map(|walk| arrays::id_array(py, walk.iter().map(vertex))).collect()
    }

    /// Whether faces can be turned so that neighbors agree.
    #[getter]
    fn is_orientable(&self) -> bool {
        self.map().orientation().conflicts().iter().all(Option::is_none)
    }

    /// Whether there is no boundary.
    #[getter]
    fn is_closed(&self) -> bool {
        self.map().sides().all(|side| self.map().mate(side).is_some())
    }

    /// Signs of the faces that make neighbors agree, as far as that is possible: 1 or -1.
    fn orientation<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        let orientation = self.map().orientation();
        PyArray1::from_vec(py, orientation.signs().iter().map(|sign| i64::from(sign.to_i32())).collect())
    }

    /// The genus of a connected surface; of one that cannot be oriented the number of cross-caps; ``None`` if not connected.
    #[getter]
    fn genus(&self) -> Option<usize> {
        match self.map().surfaces()[..] {
            [surface] => Some(surface.genus()),
            _ => None,
        }
    }

    /// What each component is, by the classification of surfaces.
    ///
    /// Returns
    /// -------
    /// list of dict
    ///     ``name``, ``orientable``, ``genus``, ``boundary_loops``, ``euler_characteristic``, ``f_vector``.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> coface.generate("moebius").surface().classify()[0]["name"]
    /// 'Moebius band'
    fn classify<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let components = self.map().surface_components();
        let dict = |component: &coface::complexes::surface::SurfaceComponent| {
            let surface = component.surface();
            let dict = PyDict::new(py);
            dict.set_item("name", surface.map(|surface| surface.to_string()))?;
            dict.set_item("orientable", surface.map(SurfaceType::is_orientable))?;
            dict.set_item("genus", surface.map(SurfaceType::genus))?;
            dict.set_item("boundary_loops", component.boundary_count())?;
            dict.set_item("euler_characteristic", component.euler_characteristic())?;
            dict.set_item("f_vector", PyTuple::new(py, component.f_vector())?)?;
            Ok(dict)
        };
        components.iter().map(dict).collect()
    }

    /// The surface cut open to disks along a short graph, or along a path.
    ///
    /// Parameters
    /// ----------
    /// along : array_like of int, optional
    ///     A path of vertices; if left out, a graph that leaves a disk of each component.
    /// simplify : bool
    ///     Whether the graph is made short.
    /// rounds : int, optional
    ///     How often every seam is made shorter.
    /// base : int, optional
    ///     The vertex that the graph is grown from.
    /// roles : bool
    ///     Whether ``roles`` is wanted: which edges are in the spanning tree, which the tree of faces crosses, and which close generators.
    /// canonical : bool
    ///     Whether edges and faces are split so that the cut is along disjoint simple loops through one vertex, and the word around the
    ///     domain is canonical: ``a1 b1 a1^-1 b1^-1 a2 ..``, or ``c1 c1 c2 c2 ..`` where the surface is not orientable. ``refinement``
    ///     has the new vertices.
    /// layout : {"polygon", "klein"}, optional
    ///     Draws the domain of a canonical cut as a regular polygon: in the unit circle, or in the disk of Klein, where hyperbolic lines are straight.
    ///     Polygons of several components are 2.5 apart. The attribute ``layout`` says how many triangles are turned over, decided exactly.
    /// weights : {"uniform", "cotangent"}
    ///     Of a layout: each vertex inside is the mean of its neighbors, by the cotangents of the intrinsic Delaunay triangulation or all alike.
    /// uv : bool
    ///     Of a layout: whether it becomes texture coordinates, the data ``s`` and ``t``, of a mesh that stays where it is.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// Domain
    ///     The opened surface, and what each seam is for.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> domain = coface.generate("torus", columns=5, rows=4).surface().cut()
    /// >>> domain.components[0]["euler_characteristic"]
    /// 1
    /// >>> double = coface.generate("genus", genus=2).surface()
    /// >>> double.cut(canonical=True).components[0]["canonical"]
    /// 'a1 b1 a1^-1 b1^-1 a2 b2 a2^-1 b2^-1'
    /// >>> double.cut(layout="klein").layout["turned"]
    /// 0
    #[pyo3(signature = (along=None, *, simplify=false, rounds=None, base=None, roles=false, canonical=false, layout=None, weights="uniform", uv=false, progress=None))]
    #[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
    fn cut(
        &self,
        py: Python<'_>,
        along: Option<&Bound<'_, PyAny>>,
        simplify: bool,
        #[pyo3(from_py_with = whole_or_none)] rounds: Option<usize>,
        base: Option<u32>,
        roles: bool,
        canonical: bool,
        layout: Option<&str>,
        weights: &str,
        uv: bool,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Domain> {
        let layout = layout_request(py, layout, weights, uv)?;
        let canonical = canonical || layout.is_some();
        if canonical && (simplify || roles || rounds.is_some() || along.is_some()) {
            let message = "a canonical cut has no path, no rounds and no roles, and is not simplified";
            return Err(invalid(py, message, "leave along, simplify, rounds and roles out"));
        }
        let along = along.map(|path| arrays::ids(path, "the path")).transpose()?;
        let (answer, model) = run(py, progress, || {
            let cut = match &along {
                Some(path) => self.surface.cut_along(path)?,
                None => {
                    let base = base.map(|base| self.surface.vertex_numbered(base)).transpose()?;
                    self.surface.cut_open(&CutRequest { simplify, rounds, base, roles, canonical, layout })?
                }
            };
            Ok((cut.answer(), cut.model()?))
        })?;
        Ok(Domain { answer, model: Py::new(py, Model::of(model))? })
    }

    /// The surface with an edge turned by one corner counterclockwise: between two triangles, the other diagonal.
    ///
    /// Edges are given by their numbers or by their ends, ``(3, 5)``. Surfaces do not change: each edit gives a new one. :attr:`edits` has
    /// what was done, and :meth:`undo` takes it back.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> square = coface.Model.from_facets([[0, 1, 2], [0, 2, 3]]).surface()
    /// >>> flipped = square.flip_edge((0, 2))
    /// >>> flipped.edits[0]["inverse"][0]["op"], flipped.undo().f_vector == square.f_vector
    /// ('flip_edge_back', True)
    fn flip_edge(&self, py: Python<'_>, edge: &Bound<'_, PyAny>) -> PyResult<Self> {
        let edge = self.cell(edge, false)?;
        self.edited(py, |editor| editor.apply(&Edit::FlipEdge { edge }).map(drop))
    }

    /// The surface with an edge turned by one corner clockwise: the inverse of :meth:`flip_edge`.
    fn flip_edge_back(&self, py: Python<'_>, edge: &Bound<'_, PyAny>) -> PyResult<Self> {
        let edge = self.cell(edge, false)?;
        self.edited(py, |editor| editor.apply(&Edit::FlipEdgeBack { edge }).map(drop))
    }

    /// The surface with a vertex in the middle of an edge; the inverse is :meth:`remove_vertex`.
    fn split_edge(&self, py: Python<'_>, edge: &Bound<'_, PyAny>) -> PyResult<Self> {
        let edge = self.cell(edge, false)?;
        self.edited(py, |editor| editor.apply(&Edit::SplitEdge { edge }).map(drop))
    }

    /// The surface without a vertex that has exactly two edges, which become one.
    fn remove_vertex(&self, py: Python<'_>, vertex: usize) -> PyResult<Self> {
        self.edited(py, |editor| editor.apply(&Edit::RemoveVertex { vertex }).map(drop))
    }

    /// The surface with a face split by an edge between the sources of two of its halfedges, each given by its number or as ``(from, to)``.
    fn split_face(&self, py: Python<'_>, start: &Bound<'_, PyAny>, end: &Bound<'_, PyAny>) -> PyResult<Self> {
        let (from, to) = (self.cell(start, true)?, self.cell(end, true)?);
        self.edited(py, |editor| editor.apply(&Edit::SplitFace { from, to }).map(drop))
    }

    /// The surface without an edge between two faces, which become one; the inverse is :meth:`split_face`.
    fn remove_edge(&self, py: Python<'_>, edge: &Bound<'_, PyAny>) -> PyResult<Self> {
        let edge = self.cell(edge, false)?;
        self.edited(py, |editor| editor.apply(&Edit::RemoveEdge { edge }).map(drop))
    }

    /// The surface with a vertex drawn out to an edge, between the corners of two halfedges that leave it.
    fn split_vertex(
        &self,
        py: Python<'_>,
        start: &Bound<'_, PyAny>,
        end: &Bound<'_, PyAny>,
    ) -> PyResult<Self> {
        let (from, to) = (self.cell(start, true)?, self.cell(end, true)?);
        self.edited(py, |editor| editor.apply(&Edit::SplitVertex { from, to }).map(drop))
    }

    /// The surface with an edge contracted to a vertex: its faces lose a side each. The inverse of :meth:`split_vertex`.
    fn contract_edge(&self, py: Python<'_>, edge: &Bound<'_, PyAny>) -> PyResult<Self> {
        let edge = self.cell(edge, false)?;
        self.edited(py, |editor| editor.apply(&Edit::ContractEdge { edge }).map(drop))
    }

    /// The surface with an edge and the triangles beside it collapsed, where it stays a simplicial complex.
    fn collapse_edge(&self, py: Python<'_>, edge: &Bound<'_, PyAny>) -> PyResult<Self> {
        let edge = self.cell(edge, false)?;
        self.edited(py, |editor| editor.apply(&Edit::CollapseEdge { edge }).map(drop))
    }

    /// The surface with a vertex inside a face, joined to each corner.
    fn poke_face(&self, py: Python<'_>, face: usize) -> PyResult<Self> {
        self.edited(py, |editor| editor.apply(&Edit::PokeFace { face }).map(drop))
    }

    /// The surface before its last edits, with the same numbers.
    #[pyo3(signature = (count=1))]
    fn undo(&self, py: Python<'_>, #[pyo3(from_py_with = whole)] count: usize) -> PyResult<Self> {
        self.edited(py, |editor| editor.undo(count))
    }

    /// What was done to the surface: each edit with its ``inverse``.
    #[getter]
    fn edits<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.editor.as_ref().map_or(&[][..], |editor| editor.records()))
    }

    /// The universal cover of a component, as far as it is asked for.
    ///
    /// Parameters
    /// ----------
    /// radius : int, optional
    ///     All copies of the domain at words of this length at most.
    /// copies : int, optional
    ///     So many copies, instead.
    /// component : int
    ///     The component.
    /// layout : {"auto", "flat", "disk", "klein", "none"}
    ///     Where copies are put: in the plane, in the disk of Poincare or of Klein, in the plane or the first disk, whichever there is, or over the
    ///     surface.
    /// most_cells : int
    ///     More cells than this are refused.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// Cover
    ///     The copies glued together, with the element of the group of each.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> cover = coface.generate("genus", genus=2).surface().cover(radius=1)
    /// >>> cover.spheres, cover.euler_characteristic
    /// ([1, 8], 1)
    #[pyo3(signature = (*, radius=None, copies=None, component=0, layout="auto", most_cells=100_000_000, progress=None))]
    #[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
    fn cover(
        &self,
        py: Python<'_>,
        #[pyo3(from_py_with = whole_or_none)] radius: Option<usize>,
        #[pyo3(from_py_with = whole_or_none)] copies: Option<usize>,
        #[pyo3(from_py_with = whole)] component: usize,
        layout: &str,
        #[pyo3(from_py_with = whole)] most_cells: usize,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Cover> {
        if radius.is_some() && copies.is_some() {
            return Err(invalid(py, "radius and copies are both given", "give one of the two"));
        }
        if radius.is_none() && copies.is_none() {
            let cure =
                "give radius=1 or copies=8; the cover that can be oriented is model.surface().double_cover()";
            return Err(invalid(py, "it is not said how much of the cover is wanted", cure));
        }
        let choice = match layout {
            "auto" => Some(LayoutChoice::Any),
            "flat" => Some(LayoutChoice::Flat),
            "disk" => Some(LayoutChoice::Disk),
            "klein" => Some(LayoutChoice::Klein),
            "none" => None,
            _ => {
                let cure = "give \"auto\", \"flat\", \"disk\", \"klein\" or \"none\"";
                return Err(invalid(py, format!("layout is {layout:?}"), cure));
            }
        };
        let extent = radius.map_or(CoverExtent::Copies(copies.unwrap_or(1)), CoverExtent::Radius);
        let (answer, model) = run(py, progress, || {
            let cover = self.surface.cover(component, extent, most_cells)?;
            let placed = match choice.map(|choice| cover.placed(choice)).transpose() {
                Err(_) if choice == Some(LayoutChoice::Any) => None,
                placed => placed?,
            };
            Ok((cover.answer(placed.as_ref()), cover.model(placed.as_ref())?))
        })?;
        Ok(Cover { answer, model: Py::new(py, Model::of(model))? })
    }

    /// The cover that has each face twice, once for each of its sides; it can be oriented.
    ///
    /// Returns
    /// -------
    /// Model
    ///     The cover; the data ``source`` and ``copy`` say what lies below.
    #[pyo3(signature = (*, progress=None))]
    fn double_cover(&self, py: Python<'_>, progress: Option<&Bound<'_, PyAny>>) -> PyResult<Model> {
        run(py, progress, || Ok(self.surface.orientation_double_cover()?.1)).map(Model::of)
    }

    /// A basis of the first cohomology dual to loops.
    ///
    /// Parameters
    /// ----------
    /// method : {"crossing", "slicing"}
    ///     How cocycles are found: by the dual tree that crosses edges, or by slicing along loops.
    /// harmonic : bool
    ///     Whether harmonic forms of the same classes are wanted.
    /// weights : {"auto", "cotangent", "uniform"}
    ///     The weights of edges for harmonic forms.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// Cocycles
    ///     Loops, cocycles, their pairing, and harmonic forms.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> cocycles = coface.generate("torus", columns=5, rows=4).surface().cocycles()
    /// >>> cocycles.rank, cocycles.pairing
    /// (2, [[1, 0], [0, 1]])
    #[pyo3(signature = (*, method="crossing", harmonic=false, weights="auto", progress=None))]
    fn cocycles(
        &self,
        py: Python<'_>,
        method: &str,
        harmonic: bool,
        weights: &str,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Cocycles> {
        if !matches!(method, "crossing" | "slicing") {
            return Err(invalid(py, format!("method is {method:?}"), "give \"crossing\" or \"slicing\""));
        }
        let weights = match weights {
            "auto" => None,
            "cotangent" => Some(EdgeWeights::Cotangent),
            "uniform" => Some(EdgeWeights::Uniform),
            _ => {
                return Err(invalid(
                    py,
                    format!("weights are {weights:?}"),
                    "give \"auto\", \"cotangent\" or \"uniform\"",
                ));
            }
        };
        let (found, forms) = run(py, progress, || {
            let (map, lengths) = (self.map(), self.lengths());
            if harmonic && weights != Some(EdgeWeights::Uniform) {
                self.surface.require_finite()?;
            }
            let found = SurfaceCocycles::new(map, lengths.as_deref(), method == "slicing")?;
            let cocycles = found.basis().cocycles();
            let forms = match harmonic {
                true => Some(surface_harmonic_forms(map, cocycles, lengths.as_deref(), weights)?),
                false => None,
            };
            Ok((found, forms))
        })?;
        let basis = found.basis();
        let naming = Arc::new(self.naming().unwrap_or_else(|| Naming::of(Names::Own)));
        let cell_count = self.map().skeleton().edge_count();
        let cochain = |cochain: &Cochain<Integer>| {
            let terms = cochain.terms().to_vec();
            Py::new(py, Chain { degree: 1, terms, cell_count, naming: Arc::clone(&naming), is_cochain: true })
        };
        let chains = basis.cocycles().iter().map(cochain).collect::<PyResult<_>>()?;
        let residuals = |residual: fn(&HarmonicForm) -> f64| {
            forms.as_ref().map(|(_, forms, _)| forms.iter().map(residual).collect())
        };
        let answer = BasisAnswer {
            rank: basis.cocycles().len(),
            method: method.to_owned(),
            pairing: basis.pairing().to_vec(),
            determinant: basis.determinant().map(WholeNumber::from),
            loops: basis.loops().iter().map(|walk| self.walk_numbers(walk)).collect(),
            intersection: found.intersection().map(|(matrix, _)| matrix.to_vec()),
            weights: forms.as_ref().map(|&(weights, ..)| weights),
            closed_residuals: residuals(HarmonicForm::closed_residual),
            coclosed_residuals: residuals(HarmonicForm::coclosed_residual),
        };
        let forms =
            forms.map(|(_, forms, _)| forms.iter().map(|form| form.values().as_slice().to_vec()).collect());
        Ok(Cocycles { answer, cocycles: chains, forms, edge_count: cell_count })
    }

    /// The fundamental groups of the components in generators of the surface, with their loops.
    ///
    /// Parameters
    /// ----------
    /// canonical : bool
    ///     Whether generators are those of the normal form: a b a^-1 b^-1 ... or a a b b ...
    /// shortest : bool
    ///     Whether loops are the shortest at the base.
    /// base : int, optional
    ///     The vertex that loops start from.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// list of FundamentalGroup
    ///     One for each component with faces.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> group, = coface.generate("genus", genus=2).surface().pi1(canonical=True)
    /// >>> group.relators
    /// [[1, 2, -1, -2, 3, 4, -3, -4]]
    #[pyo3(signature = (*, canonical=false, shortest=false, base=None, progress=None))]
    fn pi1(
        &self,
        py: Python<'_>,
        canonical: bool,
        shortest: bool,
        base: Option<u32>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Vec<FundamentalGroup>> {
        run(py, progress, || {
            if shortest {
                self.surface.require_finite()?;
            }
            let map = self.map();
            let lengths = self.lengths().filter(|_| shortest);
            let base = base.map(|base| self.surface.vertex_numbered(base)).transpose()?;
            let trees = TreeCotree::greedy(map, base, lengths.as_deref())?;
            let homotopy = SurfaceHomotopy::new(map, &trees)?;
            let mut groups = Vec::new();
            for (i, found) in trees.components().iter().enumerate() {
                let group = &homotopy.groups()[i];
                let canonical = if canonical { homotopy.canonical_loops(i) } else { None };
                let (presentation, loops) = match canonical {
                    Some((loops, system)) => {
                        let relators = if loops.is_empty() { Vec::new() } else { vec![system.relator()] };
                        (coface::topology::Presentation::new(loops.len(), relators)?, loops)
                    }
                    None if shortest && found.has_boundary() => {
                        let loops = shortest_loops(map, found.base(), lengths.as_deref())?;
                        (group.presentation(), loops.into_iter().map(|cycle| cycle.walk().clone()).collect())
                    }
                    None => {
                        let letters = 1..=found.generators().len() as i32;
                        let walk =
                            |letter| homotopy.walk_of_word(i, &coface::algebra::Word::from_letters([letter]));
                        (group.presentation(), letters.map(walk).collect())
                    }
                };
                let loops = loops.iter().map(|walk| self.walk_numbers(walk)).collect();
                let base = self.surface.number(found.base());
                let source = Arc::clone(&self.source);
                groups.push(FundamentalGroup::new(presentation, Some(group.name()), base, loops, source));
            }
            Ok(groups)
        })
    }

    /// Shortest closed paths: one that cannot be contracted, one that does not separate, or a basis of homology.
    ///
    /// Parameters
    /// ----------
    /// kind : {"non-contractible", "non-separating", "homology-basis"}
    ///     What is looked for.
    /// through : int, optional
    ///     A vertex that it has to go through.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// list of (float, numpy.ndarray)
    ///     Lengths and vertices, the first one again at the end. Without positions each edge has the length 1.
    #[pyo3(signature = (kind="non-contractible", *, through=None, progress=None))]
    fn shortest_cycles<'py>(
        &self,
        py: Python<'py>,
        kind: &str,
        through: Option<u32>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Vec<(f64, Bound<'py, PyArray1<i64>>)>> {
        let one = match kind {
            "non-contractible" => Some(CycleKind::NonContractible),
            "non-separating" => Some(CycleKind::NonSeparating),
            "homology-basis" if through.is_some() => {
                return Err(invalid(
                    py,
                    "a basis of homology does not go through one vertex",
                    "leave through out",
                ));
            }
            "homology-basis" => None,
            _ => {
                let cure = "give \"non-contractible\", \"non-separating\" or \"homology-basis\"";
                return Err(invalid(py, format!("kind is {kind:?}"), cure));
            }
        };
        let found: Vec<ShortestCycle> = run(py, progress, || {
            self.surface.require_finite()?;
            let (map, lengths) = (self.map(), self.lengths());
            Ok(match (one, through) {
                (None, _) => shortest_homology_basis(map, lengths.as_deref(), MOST_REACHED)?,
                (Some(kind), None) => {
                    shortest_cycle(map, lengths.as_deref(), kind, MOST_REACHED)?.into_iter().collect()
                }
                (Some(kind), Some(vertex)) => {
                    let vertex = self.surface.vertex_numbered(vertex)?;
                    shortest_cycle_through(map, vertex, lengths.as_deref(), kind)?.into_iter().collect()
                }
            })
        })?;
        Ok(found
            .iter()
            .map(|cycle| (cycle.length(), arrays::id_array(py, self.walk_numbers(cycle.walk()))))
            .collect())
    }

    /// The best closed path of a kind that is found in some time, and a length that none falls below.
    ///
    /// Parameters
    /// ----------
    /// seconds : float
    ///     For how long a shorter path is looked for; one is found in any case, if there is one.
    /// kind : {"non-contractible", "non-separating"}
    ///     What is looked for.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// (float, numpy.ndarray, float), optional
    ///     The length, the vertices, the first one again at the end, and the lower bound; the path is a shortest one if the bound is its
    ///     length. ``None`` if there is no such path.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> plane = coface.generate("rp2").surface()
    /// >>> length, vertices, bound = plane.shortest_cycle_within(60)
    /// >>> length, len(vertices), bound
    /// (3.0, 4, 3.0)
    #[pyo3(signature = (seconds, kind="non-contractible", *, progress=None))]
    fn shortest_cycle_within<'py>(
        &self,
        py: Python<'py>,
        seconds: f64,
        kind: &str,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Option<(f64, Bound<'py, PyArray1<i64>>, f64)>> {
        let kind = match kind {
            "non-contractible" => CycleKind::NonContractible,
            "non-separating" => CycleKind::NonSeparating,
            _ => {
                let cure = "give \"non-contractible\" or \"non-separating\"";
                return Err(invalid(py, format!("kind is {kind:?}"), cure));
            }
        };
        let Ok(limit) = Duration::try_from_secs_f64(seconds) else {
            return Err(invalid(py, format!("{seconds} seconds are no time"), "give seconds from 0"));
        };
        let found = run(py, progress, || {
            self.surface.require_finite()?;
            let start = Instant::now();
            let is_over = || start.elapsed() >= limit;
            shortest_cycle_until(self.map(), self.lengths().as_deref(), kind, MOST_REACHED, &is_over)
        })?;
        Ok(found.cycle().map(|cycle| {
            let vertices = arrays::id_array(py, self.walk_numbers(cycle.walk()));
            (cycle.length(), vertices, found.lower_bound())
        }))
    }

    /// What closed walks are: whether they can be contracted, bound, and which are homotopic.
    ///
    /// Parameters
    /// ----------
    /// walks : sequence of array_like of int
    ///     Closed paths of vertices along edges, the first one again at the end.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// list of dict
    ///     ``contractible``, ``bounds``, ``word``, ``homotopic`` and ``freely_homotopic`` (numbers of other walks that are).
    #[pyo3(signature = (walks, *, progress=None))]
    fn compare<'py>(
        &self,
        py: Python<'py>,
        walks: &Bound<'py, PyAny>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let mut lists = Vec::new();
        for walk in walks.try_iter()? {
            lists.push(arrays::ids(&walk?, "a walk")?);
        }
        let answers = run(py, progress, || walks::compared(&self.surface, &lists))?;
        to_python(py, &answers)
    }

    /// The surface as a model.
    fn model(&self, py: Python<'_>) -> PyResult<Model> {
        if !self.of_boundary {
            return Ok(Model { source: Arc::clone(&self.source) });
        }
        self.surface.to_model().or_raise(py).map(Model::of)
    }

    fn __len__(&self) -> usize {
        self.map().skeleton().face_count()
    }

    fn __repr__(&self) -> String {
        let names: Vec<String> = self.map().surfaces().iter().take(4).map(ToString::to_string).collect();
        let (v, e, f) = self.f_vector();
        let more = if self.map().component_count() > 4 { ", .." } else { "" };
        let names = if names.is_empty() { "no faces".to_owned() } else { names.join(" + ") };
        format!("Surface({names}{more}, f-vector ({v}, {e}, {f}))")
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Model, bool))> {
        let model = Model { source: Arc::clone(&self.source) };
        Ok((py.import("coface._coface")?.getattr("_surface")?, (model, self.of_boundary)))
    }
}

/// Makes a surface again, for pickling.
#[pyfunction]
pub(crate) fn _surface(py: Python<'_>, model: &Bound<'_, Model>, boundary: bool) -> PyResult<Surface> {
    surface_of(py, &model.get().source, boundary, None)
}

/// The vertices of a producer by their numbers in the file.
pub(crate) fn numbers_of(producer: &Producer, count: usize) -> Vec<u32> {
    (0..count).map(|vertex| producer.cell_vertices(0, coface::CellId::new(vertex))[0]).collect()
}

/// How a domain is to be drawn, in words.
fn layout_request(
    py: Python<'_>,
    layout: Option<&str>,
    weights: &str,
    as_texture: bool,
) -> PyResult<Option<LayoutRequest>> {
    let plane = match layout {
        None if as_texture => PolygonPlane::Euclidean,
        None => return Ok(None),
        Some("polygon") => PolygonPlane::Euclidean,
        Some("klein") => PolygonPlane::Klein,
        Some(other) => {
            return Err(invalid(py, format!("layout is {other:?}"), "give \"polygon\" or \"klein\""));
        }
    };
    let weights = match weights {
        "uniform" => LayoutWeights::Uniform,
        "cotangent" => LayoutWeights::Cotangent,
        other => {
            let cure = "give \"uniform\" or \"cotangent\"";
            return Err(invalid(py, format!("weights is {other:?}"), cure));
        }
    };
    Ok(Some(LayoutRequest { plane, weights, as_texture }))
}
