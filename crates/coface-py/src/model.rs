//! Models: what files hold.

mod cells;
mod complexes;
mod halfedges;
mod handles;
mod made;
mod pickling;
mod reading;
mod repairs;
mod triangulations;
mod writing;

pub(crate) use pickling::_model;
pub(crate) use reading::{entries, read, read_options};
pub(crate) use writing::_bytes_of;

use crate::arrays;
use crate::chain_complex::ChainComplex;
use crate::complex::Complex;
use crate::cures::in_python;
use crate::errors::{OrRaise, bound, invalid, whole, whole_or_none};
use crate::memory::{shared, shared_ids};
use crate::report::{Report, report_request};
use crate::source::Source;
use crate::target::warn_all;
use crate::volumes::voxels_of;
use crate::work::run;
use cells::{
    Parts, data_of, facets_of, kind_of, kind_word, model_of_parts, permutations_of, refuse_tetrahedra,
    structure_word, system_name,
};
use coface::answers::{losses_of, repaired, simplicial_complex, triangulated, welded};
use coface::complexes::gluing::GluingTable;
use coface::io::{self, CellData, Format, Group, Structure};
use halfedges::model_from;
use numpy::{PyArray1, PyArrayDyn, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyString, PyTuple};
use repairs::named;
use std::sync::Arc;

/// What a file holds: vertices with or without positions, polygons, 3-cells, lines, groups, data, or an abstract structure.
///
/// Models do not change; methods that edit give a new one.
///
/// Parameters
/// ----------
/// vertices : array_like, shape (n, d), optional
///     Positions.
/// faces : array_like of int, optional
///     Polygons: an array of shape (m, k), a list of lists, or ``(flat, offsets)``.
///
/// Examples
/// --------
/// A square of two triangles:
///
/// >>> import coface
/// >>> square = coface.Model([[0, 0], [1, 0], [1, 1], [0, 1]], [[0, 1, 2], [0, 2, 3]])
/// >>> square
/// Model(4 vertices, 2 faces)
/// >>> square.report().euler_characteristic
/// 1
#[pyclass(frozen, module = "coface", name = "Model")]
pub(crate) struct Model {
    pub(crate) source: Arc<Source>,
}

#[pymethods]
impl Model {
    #[new]
    #[pyo3(signature = (*arguments, **options), text_signature = "(vertices=None, faces=None)")]
    fn new(
        py: Python<'_>,
        arguments: &Bound<'_, PyTuple>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let [vertices, faces] = bound("Model", ["vertices", "faces"], 2, arguments, options)?;
        Self::from_arrays(py, vertices.as_ref(), faces.as_ref(), None, None)
    }

    /// A model from arrays.
    ///
    /// Parameters
    /// ----------
    /// vertices : array_like, shape (n, d), optional
    ///     Positions. Without them the vertices are numbers only.
    /// faces : array_like of int, optional
    ///     Polygons: an array of shape (m, k), a list of lists, or ``(flat, offsets)``.
    /// cells : dict of str to array_like, optional
    ///     Cells by kind, in the words of meshio: ``vertex``, ``line``, ``triangle``, ``quad``, ``polygon``, ``tetra``, ``hexahedron``,
    ///     ``wedge``, ``pyramid``.
    /// vertex_count : int, optional
    ///     How many vertices there are, where there are no positions and the last ones are in no cell.
    ///
    /// Returns
    /// -------
    /// Model
    ///     Vertices and cells keep their numbers and order.
    ///
    /// Raises
    /// ------
    /// InvalidInputError
    ///     For ids that are no integers, negative or beyond the vertices, repeated vertices, coordinates that are not finite.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> coface.Model.from_arrays(cells={"tetra": [[0, 1, 2, 3]], "line": [[3, 4]]})
    /// Model(5 vertices, 1 line, 1 cell)
    #[staticmethod]
    #[pyo3(signature = (vertices=None, faces=None, cells=None, *, vertex_count=None))]
    fn from_arrays(
        py: Python<'_>,
        vertices: Option<&Bound<'_, PyAny>>,
        faces: Option<&Bound<'_, PyAny>>,
        cells: Option<&Bound<'_, PyDict>>,
        #[pyo3(from_py_with = whole_or_none)] vertex_count: Option<usize>,
    ) -> PyResult<Self> {
        let positions = vertices.map(|vertices| arrays::positions(vertices, "vertices")).transpose()?;
        if let (Some(positions), Some(count)) = (&positions, vertex_count)
            && positions.len() != count
        {
            let message = format!("{} positions for {count} vertices", positions.len());
            return Err(invalid(py, message, "leave vertex_count out"));
        }
        let mut parts = Parts::default();
        if let Some(faces) = faces {
            let faces = arrays::lists(faces, "faces")?;
            refuse_tetrahedra(py, positions.as_ref(), &faces)?;
            parts.polygons.push(faces);
        }
        for (kind, value) in cells.into_iter().flatten() {
            parts.add(kind.cast::<PyString>()?.to_str()?, &value)?;
        }
        run(py, None, || model_of_parts(positions, parts, vertex_count.unwrap_or(0))).map(Self::of)
    }

    /// A simplicial complex by its facets, of any dimensions; vertices are any ids.
    ///
    /// Parameters
    /// ----------
    /// facets : array_like of int
    ///     An array of shape (m, k), a list of lists, or ``(flat, offsets)``.
    ///
    /// Returns
    /// -------
    /// Model
    ///     All faces of the facets are meant to be there too.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> coface.Model.from_facets([[0, 1, 2], [2, 9]]).f_vector
    /// (4, 4, 1)
    #[staticmethod]
    fn from_facets(facets: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(Self::of(io::Model::from_structure(Structure::Facets(arrays::lists(facets, "facets")?))))
    }

    /// A surface as permutations of its halfedges.
    ///
    /// Parameters
    /// ----------
    /// next : array_like of int
    ///     The next halfedge around the face.
    /// twin : array_like of int, optional
    ///     The other halfedge of the edge; ``h ^ 1`` if left out. ``None`` or -1 on the boundary, where there is none.
    /// outer : array_like of int, optional
    ///     The faces that fill boundary loops: orbits of ``next``, numbered by their smallest halfedges.
    /// vertices : array_like of float, optional
    ///     The position of each vertex: orbits of "twin, then next", numbered by their smallest halfedges.
    ///
    /// Returns
    /// -------
    /// Model
    ///     The surface.
    ///
    /// Examples
    /// --------
    /// A square with opposite sides glued is a torus:
    ///
    /// >>> import coface
    /// >>> coface.Model.from_halfedges([2, 3, 1, 0]).report().name
    /// 'torus'
    #[staticmethod]
    #[pyo3(signature = (next, twin=None, *, outer=None, vertices=None))]
    fn from_halfedges(
        py: Python<'_>,
        next: &Bound<'_, PyAny>,
        twin: Option<&Bound<'_, PyAny>>,
        outer: Option<&Bound<'_, PyAny>>,
        vertices: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let source = Source::new(model_from(py, next, twin, outer, vertices)?);
        source.producer().or_raise(py)?;
        Ok(Self { source })
    }

    /// Simplices with their facets glued in pairs.
    ///
    /// Parameters
    /// ----------
    /// rows : list
    ///     For each simplex and each of its facets ``None`` or ``(neighbor, permutation)``, where the permutation sends vertex i of the
    ///     simplex to a vertex of the neighbor.
    ///
    /// Returns
    /// -------
    /// Model
    ///     The gluing table.
    ///
    /// Examples
    /// --------
    /// A triangle with two sides glued to a cone:
    ///
    /// >>> import coface
    /// >>> cone = coface.Model.from_gluings([[(0, [1, 0, 2]), (0, [1, 0, 2]), None]])
    /// >>> cone.f_vector
    /// (2, 2, 1)
    #[staticmethod]
    fn from_gluings(py: Python<'_>, rows: &Bound<'_, PyAny>) -> PyResult<Self> {
        let cure = "give for each facet None or (neighbor, [0, 2, 1])";
        let wrong = |_| invalid(py, "the rows are no lists of gluings", cure);
        let rows: Vec<Vec<Option<(u32, Vec<u32>)>>> = rows.extract().map_err(wrong)?;
        let table = GluingTable::from_rows(&rows).or_raise(py)?;
        Ok(Self::of(io::Model::from_structure(Structure::Gluings(table))))
    }

    /// A gluing table by its isomorphism signature.
    ///
    /// Parameters
    /// ----------
    /// signature : str
    ///     The signature.
    /// dimension : int
    ///     The dimension of the simplices.
    ///
    /// Returns
    /// -------
    /// Model
    ///     The gluing table.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> coface.Model.from_signature("cMcabbgqw", 3).f_vector
    /// (1, 3, 4, 2)
    #[staticmethod]
    #[pyo3(signature = (signature, dimension=3))]
    fn from_signature(
        py: Python<'_>,
        signature: &str,
        #[pyo3(from_py_with = whole)] dimension: usize,
    ) -> PyResult<Self> {
        let table = GluingTable::from_isomorphism_signature(signature, dimension).or_raise(py)?;
        Ok(Self::of(io::Model::from_structure(Structure::Gluings(table))))
    }

    /// Reads a model from bytes or text.
    ///
    /// Parameters
    /// ----------
    /// data : bytes or str
    ///     What a file would hold.
    /// format : str, optional
    ///     The format, if it is not to be found out.
    /// flatten : float, optional
    ///     How far the polylines of curved SVG paths may be from the curves.
    /// strict, partial : bool
    ///     As those of :func:`read`.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// Model
    ///     What the bytes hold.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> coface.Model.from_bytes("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    /// Model(3 vertices, 1 face)
    #[staticmethod]
    #[pyo3(signature = (data, format=None, *, flatten=None, strict=false, partial=false, progress=None))]
    fn from_bytes(
        py: Python<'_>,
        data: &Bound<'_, PyAny>,
        format: Option<&str>,
        flatten: Option<f64>,
        strict: bool,
        partial: bool,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        reading::from_bytes(py, data, read_options(py, format, flatten, (strict, partial, false))?, progress)
    }

    /// The positions of the vertices: ``float64``, shape (n, d), on the memory of the model; ``None`` if it has none. A file may hold
    /// coordinates that are NaN or infinite; they stand here as they are. Those of a volume are the corners of its voxels, in units of voxels.
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        let (model, dimension) = (self.model(), self.model().coordinate_count());
        if let Some(Structure::Volume(_)) = model.structure() {
            let source = &self.source;
            let corners = run(py, None, || Ok(source.producer()?.positions().clone()))?;
            let flat = corners.as_flat().to_vec();
            return Ok(
                (!corners.is_empty()).then_some(arrays::grid(py, flat, corners.dimension())?.into_any())
            );
        }
        if dimension == 0 {
            return Ok(None);
        }
        let flat = shared(py, &self.source, |source| source.model.coordinates())?;
        Ok(Some(flat.reshape([model.vertex_count(), dimension])?.into_any()))
    }

    /// The number of vertices of the file; those that nothing uses count.
    #[getter]
    fn vertex_count(&self) -> usize {
        self.model().vertex_count()
    }

    /// The polygons: ``int32`` of shape (m, k) on the memory of the model where all have k corners, else ``(flat, offsets)``.
    #[getter]
    fn faces<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.lists(py, io::Model::polygons, 3)
    }

    /// The polylines, as :attr:`faces` has the polygons. A closed line has its first vertex again at its end.
    #[getter]
    fn lines<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.lists(py, io::Model::lines, 2)
    }

    /// The 3-cells by kind: ``tetra``, ``hexahedron``, ``wedge``, ``pyramid``, each an array of shape (m, k).
    #[getter]
    fn cells<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        self.cells_by_kind(py)
    }

    /// The vertices that the file names as points.
    #[getter]
    fn points<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        arrays::id_array(py, self.model().points().iter().map(|vertex| vertex.to_u32()))
    }

    /// The edges of all cells: ``int64``, shape (m, 2), in the order of the chain complex.
    #[getter]
    fn edges<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.simplices(py, 1)
    }

    /// The vertices of all cells of a degree, in the order of the chain complex.
    ///
    /// Parameters
    /// ----------
    /// degree : int
    ///     The dimension of the cells.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray or tuple of numpy.ndarray
    ///     ``int64`` of shape (m, k), or ``(flat, offsets)`` where cells have different numbers of vertices.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> coface.Model.from_facets([[0, 1, 2]]).simplices(1)
    /// array([[0, 1],
    ///        [0, 2],
    ///        [1, 2]])
    fn simplices<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = whole)] degree: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        let source = &self.source;
        let cells = run(py, None, || {
            let (producer, chains) = (source.producer()?, source.chains()?);
            Ok((0..chains.cell_count(degree))
                .map(|cell| producer.cell_vertices(degree, coface::CellId::new(cell)))
                .collect::<Vec<_>>())
        })?;
        let width = cells.is_empty().then_some(degree + 1);
        arrays::from_lists(py, cells, width)
    }

    /// The numbers of cells of the dimensions 0, 1, ..., faces shared by cells counted once.
    #[getter]
    fn f_vector<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let source = &self.source;
        let counts = run(py, None, || Ok(source.chains()?.f_vector().to_vec()))?;
        PyTuple::new(py, counts)
    }

    /// The highest dimension of a cell; ``None`` of the empty model.
    #[getter]
    fn dimension(&self, py: Python<'_>) -> PyResult<Option<usize>> {
        let source = &self.source;
        run(py, None, || Ok(source.chains()?.dimension()))
    }

    /// The alternating sum of the numbers of cells.
    #[getter]
    fn euler_characteristic(&self, py: Python<'_>) -> PyResult<i64> {
        let source = &self.source;
        run(py, None, || Ok(source.chains()?.euler_characteristic()))
    }

    /// The name of the format that the model came from.
    #[getter]
    fn format(&self) -> Option<&'static str> {
        self.model().format().map(Format::name)
    }

    /// What the file holds instead of vertices and cells: ``facets``, ``halfedges``, ``chains``, ``gluings``, ``volume`` or ``None``.
    #[getter]
    fn structure(&self) -> Option<&'static str> {
        self.model().structure().map(structure_word)
    }

    /// The number of the reference system that a map names (``SRID`` of EWKT and EWKB, ``crs`` of GeoJSON), if it has one.
    #[getter]
    fn srid(&self) -> Option<u32> {
        self.model().reference_system()?.srid()
    }

    /// The reference system that a map names, as :mod:`pyproj` takes it: ``"EPSG:25832"``, the name of another authority such as ``"ESRI:54009"``,
    /// or WKT.
    #[getter]
    fn crs(&self) -> Option<String> {
        system_name(self.model().reference_system()?)
    }

    /// The facets of a model of facets: an array of shape (m, k) or ``(flat, offsets)``; ``None`` of other models.
    #[getter]
    fn facets<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        match self.model().structure() {
            Some(Structure::Facets(_)) => self.lists(py, facets_of, 1).map(Some),
            _ => Ok(None),
        }
    }

    /// The permutations ``(next, twin)`` of a model of halfedges; ``None`` of other models.
    #[getter]
    fn halfedges<'py>(
        &self,
        py: Python<'py>,
    ) -> PyResult<Option<(Bound<'py, PyArray1<i32>>, Bound<'py, PyArray1<i32>>)>> {
        match self.model().structure() {
            Some(Structure::Halfedges { .. }) => {
                let ids = |i: usize| shared_ids(py, &self.source, move |own| permutations_of(&own.model)[i]);
                Ok(Some((ids(0)?, ids(1)?)))
            }
            _ => Ok(None),
        }
    }

    /// The rows of a gluing table; ``None`` of other models.
    #[getter]
    fn gluings(&self) -> Option<Vec<Vec<Option<(u32, Vec<u32>)>>>> {
        match self.model().structure() {
            Some(Structure::Gluings(table)) => Some(table.rows().collect()),
            _ => None,
        }
    }

    /// The voxels of a volume, truth values, and the numbers of its axes that close up; ``None`` of other models.
    #[getter]
    fn voxels<'py>(&self, py: Python<'py>) -> PyResult<Option<(Bound<'py, PyArrayDyn<bool>>, Vec<usize>)>> {
        match self.model().structure() {
            Some(Structure::Volume(volume)) => voxels_of(py, volume).map(Some),
            _ => Ok(None),
        }
    }

    /// The isomorphism signature of a gluing table; the same for tables that differ by names only.
    fn signature(&self, py: Python<'_>) -> PyResult<String> {
        match self.model().structure() {
            Some(Structure::Gluings(table)) => run(py, None, || table.isomorphism_signature()),
            _ => Err(invalid(
                py,
                "only gluing tables have signatures",
                "give a model of structure \"gluings\"",
            )),
        }
    }

    /// The named groups of the file: a list of (name, kind, members), kinds being ``vertices``, ``lines``, ``faces``, ``cells``.
    #[getter]
    fn groups<'py>(&self, py: Python<'py>) -> Vec<(String, &'static str, Bound<'py, PyArray1<i64>>)> {
        let groups = self.model().groups().iter();
        groups
            .map(|group| {
                let members = arrays::id_array(py, group.members().iter().copied());
                (group.name().to_owned(), kind_word(group.kind()), members)
            })
            .collect()
    }

    /// The named data of the file: a list of (name, kind, array), the array of shape (m,) or (m, components).
    #[getter]
    fn data<'py>(&self, py: Python<'py>) -> PyResult<Vec<(String, &'static str, Bound<'py, PyAny>)>> {
        data_of(py, self.model())
    }

    /// What was odd about the file.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.model().remarks().iter().map(|remark| in_python(&remark.message)).collect()
    }

    /// The model with one more array of numbers on its cells.
    ///
    /// Parameters
    /// ----------
    /// name : str
    ///     The name of the array.
    /// values : array_like
    ///     Integers or reals, one row for each cell.
    /// on : {"vertices", "lines", "faces", "cells"}
    ///     What the rows belong to.
    ///
    /// Returns
    /// -------
    /// Model
    ///     The model with the data; :meth:`write` keeps them where the format does.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> triangle = coface.Model([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]])
    /// >>> triangle.with_data("height", [1.5, 2.0, 0.0]).data
    /// [('height', 'vertices', array([1.5, 2. , 0. ]))]
    #[pyo3(signature = (name, values, on="vertices"))]
    fn with_data(&self, py: Python<'_>, name: &str, values: &Bound<'_, PyAny>, on: &str) -> PyResult<Self> {
        let kind = kind_of(py, on)?;
        let array = arrays::as_array(py, values)?;
        let shape: Vec<usize> = array.getattr("shape")?.extract()?;
        let components = shape.get(1..).map_or(1, |rest| rest.iter().product());
        let sort: String = array.getattr("dtype")?.getattr("kind")?.extract()?;
        let data = if sort == "f" {
            CellData::reals(name, kind, components, arrays::reals(&array, name)?.1)
        } else {
            CellData::integers(name, kind, components, arrays::all_numbers(&array, name)?)
        };
        self.model().clone().with_data(data.or_raise(py)?).or_raise(py).map(Self::of)
    }

    /// The model with one more named group.
    ///
    /// Parameters
    /// ----------
    /// name : str
    ///     The name.
    /// members : array_like of int
    ///     Numbers of vertices, lines, faces or cells.
    /// kind : {"vertices", "lines", "faces", "cells"}
    ///     What the members are.
    ///
    /// Returns
    /// -------
    /// Model
    ///     The model with the group.
    #[pyo3(signature = (name, members, kind="faces"))]
    fn with_group(
        &self,
        py: Python<'_>,
        name: &str,
        members: &Bound<'_, PyAny>,
        kind: &str,
    ) -> PyResult<Self> {
        let group = Group::new(name, kind_of(py, kind)?, arrays::ids(members, "members")?);
        self.model().clone().with_group(group).or_raise(py).map(Self::of)
    }

    /// The model with these polylines instead of its own.
    ///
    /// Parameters
    /// ----------
    /// lines : array_like of int
    ///     Each a list of vertices; a closed line has its first vertex again at its end.
    ///
    /// Returns
    /// -------
    /// Model
    ///     The model with the lines.
    fn with_lines(&self, py: Python<'_>, lines: &Bound<'_, PyAny>) -> PyResult<Self> {
        let lines = arrays::lists(lines, "lines")?;
        self.model().clone().with_lines(lines).or_raise(py).map(Self::of)
    }

    /// Writes the model to a file, which appears whole or not at all.
    ///
    /// Parameters
    /// ----------
    /// path : str, os.PathLike or file
    ///     The file; its extension decides the format. A file that is open for writing gets all at once.
    /// format : str, optional
    ///     The format, instead of that of the extension.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Raises
    /// ------
    /// UnsupportedFormatError
    ///     If the format cannot hold the model.
    #[pyo3(signature = (path, format=None, *, progress=None))]
    fn write(
        &self,
        py: Python<'_>,
        path: &Bound<'_, PyAny>,
        format: Option<&str>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<()> {
        writing::write(py, self.model(), path, format, progress)
    }

    /// The model as a file of this format would hold it.
    ///
    /// Parameters
    /// ----------
    /// format : str
    ///     The format, such as ``"off"``.
    ///
    /// Returns
    /// -------
    /// bytes
    ///     The content of the file.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> print(coface.Model([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]]).to_bytes("off").decode().split())
    /// ['OFF', '3', '1', '0', '0', '0', '0', '1', '0', '0', '0', '1', '0', '3', '0', '1', '2']
    fn to_bytes<'py>(&self, py: Python<'py>, format: &str) -> PyResult<Bound<'py, PyBytes>> {
        let format = Format::from_name(format).or_raise(py)?;
        warn_all(py, &losses_of(self.model(), format))?;
        writing::bytes(py, self.model(), format)
    }

    /// Everything that ``coface info`` says: what it is, whether it is sound, what is wrong and where.
    ///
    /// Parameters
    /// ----------
    /// moments : sequence of (int, int, int), optional
    ///     Exponents of further moments, each x^a y^b z^c over the volume and the surface.
    /// check : {"usual", "geometry", "topology"}
    ///     Whether faces in space are checked, as :attr:`Report.geometry`: on surfaces of up to 200,000 faces, always, never.
    /// flatness : float, optional
    ///     How far points of a flat face may be from its plane; by default a hundredth of the face.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// Report
    ///     The report.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> coface.Model.from_facets([[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]).report().name
    /// 'sphere'
    #[pyo3(signature = (moments=Vec::new(), *, check="usual", flatness=None, progress=None))]
    fn report(
        &self,
        py: Python<'_>,
        moments: Vec<[u32; 3]>,
        check: &str,
        flatness: Option<f64>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Report> {
        let request = report_request(py, &moments, check, flatness)?;
        let model = self.model();
        let report = run(py, progress, || coface::answers::Report::answering(model.clone(), &request))?;
        Ok(Report::of(report, Arc::clone(&self.source), (moments, check.to_owned(), flatness)))
    }

    /// The simplicial complex of a model of simplices.
    ///
    /// Returns
    /// -------
    /// Complex
    ///     The facets, triangles, tetrahedra, segments and vertices with all their faces.
    ///
    /// Raises
    /// ------
    /// InvalidInputError
    ///     If a cell is no simplex.
    #[pyo3(signature = (*, progress=None))]
    fn complex(&self, py: Python<'_>, progress: Option<&Bound<'_, PyAny>>) -> PyResult<Complex> {
        run(py, progress, || simplicial_complex(self.model())).map(Complex::of)
    }

    /// The chain complex of the cells, or of a pair.
    ///
    /// Parameters
    /// ----------
    /// relative : "boundary", Model, str, int or list of these words, optional
    ///     A part that is divided out: the boundary of the domain, the cells of a model with the same vertex numbers, or groups of the mesh by
    ///     name or number, such as physical groups of a ``.msh``. A word that is a group and "boundary" is the group.
    /// domain : str, int or list of these, optional
    ///     Groups of the mesh, by name or number, whose cells and faces are the complex; the whole model by default.
    /// reduced : bool
    ///     Whether a cell of degree -1 below all vertices is added, so that a point has no homology. Degrees then count from it.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// ChainComplex
    ///     Its cells are named by the vertices of the model.
    ///
    /// Examples
    /// --------
    /// A disk modulo its rim is a sphere but for one point:
    ///
    /// >>> import coface
    /// >>> disk = coface.Model.from_facets([[0, 1, 2], [0, 2, 3]])
    /// >>> disk.chain_complex(relative="boundary").homology().betti_numbers
    /// (0, 0, 1)
    #[pyo3(signature = (relative=None, *, domain=None, reduced=false, progress=None))]
    fn chain_complex(
        &self,
        py: Python<'_>,
        relative: Option<&Bound<'_, PyAny>>,
        domain: Option<&Bound<'_, PyAny>>,
        reduced: bool,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<ChainComplex> {
        complexes::chain_complex(py, &self.source, relative, domain, reduced, progress)
    }

    /// The mesh with one more group for a chain or cochain of it, as Gmsh writes generators of homology.
    ///
    /// A cell of the chain stands as an element as often as its coefficient says, turned if it is negative. Of a cochain the values are data too:
    /// at the first element of each cell, for its direction. ``write("out.msh")`` makes it a physical group, and
    /// :meth:`ChainComplex.chain` reads it back by its name.
    ///
    /// Parameters
    /// ----------
    /// name : str
    ///     The name of the group; Gmsh uses ``"H_1{1},{70,71}1"`` and ``"H^1{1},{70,71}1"``.
    /// chain : Chain or Generator
    ///     A chain or cochain of a chain complex of this model.
    ///
    /// Returns
    /// -------
    /// Model
    ///     The mesh with the group.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> ring = coface.generate("ring")
    /// >>> cut = ring.chain_complex(relative="boundary").homology(generators=True)[1].generators[0]
    /// >>> with_cut = ring.with_chain("cut", cut)
    /// >>> pair = with_cut.chain_complex(relative="boundary")
    /// >>> pair.boundary_of(pair.chain("cut")).terms()
    /// []
    fn with_chain(&self, py: Python<'_>, name: String, chain: &Bound<'_, PyAny>) -> PyResult<Self> {
        complexes::with_chain(py, &self.source, name, chain).map(Self::of)
    }

    /// The faces as a surface.
    ///
    /// Parameters
    /// ----------
    /// boundary : bool
    ///     Of a model with 3-cells, whether its boundary is meant.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// Surface
    ///     The surface.
    ///
    /// Raises
    /// ------
    /// NonManifoldError
    ///     If it is not a surface; ``.cells`` has the edge or vertex that shows it.
    #[pyo3(signature = (*, boundary=false, progress=None))]
    fn surface(
        &self,
        py: Python<'_>,
        boundary: bool,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<crate::surface::Surface> {
        crate::surface::surface_of(py, &self.source, boundary, progress)
    }

    /// The model as a mesh that is a surface: edges with more than two faces and vertices with several fans are split.
    ///
    /// Parameters
    /// ----------
    /// split_edges : {"apart", "pairs"}, optional
    ///     What becomes of edges in three and more faces: each face gets the edge for itself, or coherent pairs stay together.
    /// split_vertices : bool
    ///     Whether a vertex with several fans is duplicated, one copy for each fan.
    /// orient : bool
    ///     Whether faces are turned so that neighbors agree.
    /// keep_repeated : bool
    ///     Whether faces that repeat an earlier one stay; they are left out otherwise, and faces are numbered anew.
    ///
    /// Returns
    /// -------
    /// model : Model
    ///     The repaired model; the same repair again does nothing.
    /// vertex_sources : numpy.ndarray
    ///     For each vertex the one that it was.
    #[pyo3(signature = (*, split_edges=None, split_vertices=false, orient=false, keep_repeated=false, progress=None))]
    fn repaired<'py>(
        &self,
        py: Python<'py>,
        split_edges: Option<&str>,
        split_vertices: bool,
        orient: bool,
        keep_repeated: bool,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let request = repairs::request(py, split_edges, split_vertices, orient, keep_repeated)?;
        let (model, repair) = run(py, progress, || repaired(self.model(), request))?;
        let sources = arrays::id_array(py, repair.vertex_sources().iter().map(|vertex| vertex.to_u32()));
        named(py, "Repaired", (Self::of(model), sources))
    }

    /// The model with vertices merged that are at most ``radius`` apart; none moves farther, and the order of vertices does not matter.
    ///
    /// Parameters
    /// ----------
    /// radius : float
    ///     A length in the unit of the positions; 0 merges equal positions.
    ///
    /// Returns
    /// -------
    /// Model
    ///     Polygons without enough corners are left out; a remark says what was merged.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> corners = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 0, 1e-9], [0, 1, 0], [1, 1, 0]]
    /// >>> coface.Model(corners, [[0, 1, 2], [3, 5, 4]]).welded(1e-6)
    /// Model(4 vertices, 2 faces)
    #[pyo3(signature = (radius, *, progress=None))]
    fn welded(&self, py: Python<'_>, radius: f64, progress: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        run(py, progress, || {
            let (model, done) = welded(self.model(), radius)?;
            Ok(model.with_remarks(done.remark()))
        })
        .map(Self::of)
    }

    /// A surface made of the polygons of the model: merged, cleaned, split, turned and, on request, closed.
    ///
    /// Parameters
    /// ----------
    /// tolerance : float
    ///     Vertices within this distance are merged, in the unit of the positions; 0 merges equal positions.
    /// closed : bool
    ///     Whether holes are filled.
    ///
    /// Returns
    /// -------
    /// model : Model
    /// done : dict
    ///     How much was done: the keys ``vertices_merged``, ``vertices_left_out``, ``polygons_collapsed``, ``polygons_repeated``,
    ///     ``lines_left_out``, ``edges_split``, ``vertices_split``, ``faces_turned``, ``holes_filled`` and ``triangles_added``.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> disk = coface.Model.from_facets([[0, 1, 2]])
    /// >>> sphere, done = disk.repaired_surface(closed=True)
    /// >>> done["holes_filled"], sphere.surface().genus
    /// (1, 0)
    #[pyo3(signature = (*, tolerance=0.0, closed=false, progress=None))]
    fn repaired_surface<'py>(
        &self,
        py: Python<'py>,
        tolerance: f64,
        closed: bool,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (model, done) = run(py, progress, || repairs::surface_of(self.model(), tolerance, closed))?;
        named(py, "RepairedSurface", (Self::of(model), repairs::counts(py, &done)?))
    }

    /// The voxels of a volume as a mesh.
    ///
    /// Parameters
    /// ----------
    /// surface : bool
    ///     Whether the squares around the voxels are made, turned outward; the voxels themselves otherwise: hexahedra, quadrilaterals or
    ///     segments.
    /// spacing, origin : sequence of float, optional
    ///     How long a voxel is along each axis, and where the first corner is; without both as the header of the file says, else 1 and 0.
    ///
    /// Returns
    /// -------
    /// Model
    ///     Vertices are the corners of voxels.
    ///
    /// Examples
    /// --------
    /// >>> import coface, numpy as np
    /// >>> voxel = coface.volume(np.ones((1, 1, 1)))
    /// >>> voxel.to_model(surface=True, spacing=(0.5, 0.5, 2.0)).report().signed_volume
    /// 0.5
    /// >>> voxel.to_model()
    /// Model(8 vertices, 1 cell)
    #[pyo3(signature = (*, surface=false, spacing=None, origin=None))]
    fn to_model(
        &self,
        py: Python<'_>,
        surface: bool,
        spacing: Option<&Bound<'_, PyAny>>,
        origin: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let spacing = spacing.map(|spacing| arrays::finite(spacing, "spacing")).transpose()?;
        let origin = origin.map(|origin| arrays::finite(origin, "origin")).transpose()?;
        let model = self.model();
        run(py, None, || made::mesh_of_volume(model, surface, spacing.as_deref(), origin.as_deref()))
            .map(Self::of)
    }

    /// The model with each face cut into triangles on its own corners; data and groups follow.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> square = coface.Model([[0, 0], [1, 0], [1, 1], [0, 1]], [[0, 1, 2, 3]])
    /// >>> len(square.triangulated().faces)
    /// 2
    #[pyo3(signature = (*, progress=None))]
    fn triangulated(&self, py: Python<'_>, progress: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        run(py, progress, || made::triangulated(self.model())).map(Self::of)
    }

    /// A gluing table or a surface of halfedges as a facet list, subdivided where that is needed to keep simplices apart.
    ///
    /// Returns
    /// -------
    /// model : Model
    ///     The facet list.
    /// carriers : numpy.ndarray of shape (n, 2)
    ///     For each vertex the dimension and the number of the cell that it lies in the interior of.
    #[pyo3(signature = (*, progress=None))]
    fn subdivided<'py>(
        &self,
        py: Python<'py>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let (model, carriers) = run(py, progress, || triangulated(self.model()))?;
        let flat = carriers.iter().flat_map(|&(degree, cell)| [degree as i64, cell.index() as i64]).collect();
        named(py, "Subdivided", (Self::of(model), arrays::grid(py, flat, 2)?.into_any()))
    }

    fn __len__(&self) -> usize {
        let model = self.model();
        match model.structure() {
            Some(Structure::Facets(facets)) => facets.len(),
            _ if !model.cells().is_empty() => model.cells().len(),
            _ => model.polygons().len(),
        }
    }

    fn __bool__(&self) -> bool {
        true
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| {
            Arc::ptr_eq(&self.source, &other.get().source) || *self.model() == *other.get().model()
        })
    }

    fn __hash__(&self) -> isize {
        let model = self.model();
        let counts = [model.vertex_count(), model.polygons().len(), model.cells().len(), model.lines().len()];
        counts.iter().fold(17_isize, |sum, &count| sum.wrapping_mul(1_000_003).wrapping_add(count as isize))
    }

    fn __repr__(&self) -> String {
        complexes::described(self.model())
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let rebuild = py.import("coface._coface")?.getattr("_model")?;
        Ok((rebuild, PyTuple::new(py, [pickling::parts(py, self)?])?))
    }
}
