//! Grids of cuboids and simplices, sweeps and products of models.

use crate::arrays;
use crate::chain_complex::ChainComplex;
use crate::errors::{OrRaise, bound, invalid, required, whole, wrong_type};
use crate::given::source_of;
use crate::model::Model;
use crate::work::run;
use coface::algebra::chains::ProductComplex;
use coface::algebra::{RaggedArray, Sign};
use coface::answers::simplicial_complex;
use coface::complexes::grids::{AxisSet, CuboidGrid as Grid, GridCell};
use coface::complexes::shapes::{CellKind, PlacedCells};
use coface::complexes::simplicial::{Simplex, SimplicialGrid as Kuhn, extrude};
use coface::io;
use coface::io::Structure;
use coface::{CellId, Error};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use std::sync::Arc;

/// A grid of cuboids of any dimension: cells are products of intervals and points, their faces index arithmetic.
///
/// Parameters
/// ----------
/// shape : sequence of int, optional
///     The numbers of unit intervals along the axes.
/// lengths : sequence of sequence of float, optional
///     The lengths of the intervals of each axis instead, negative where one is empty.
///
/// Examples
/// --------
/// >>> import coface
/// >>> grid = coface.CuboidGrid((2, 3))
/// >>> grid.f_vector
/// (12, 17, 6)
/// >>> grid.chain_complex().homology().betti_numbers
/// (1, 0, 0)
#[pyclass(frozen, module = "coface", name = "CuboidGrid")]
pub(crate) struct CuboidGrid {
    grid: Grid,
}

fn signed_cells(cells: Vec<(CellId, Sign)>) -> Vec<(usize, i32)> {
    cells.into_iter().map(|(cell, sign)| (cell.index(), sign.to_i32())).collect()
}

impl CuboidGrid {
    fn cell_id(&self, py: Python<'_>, dimension: usize, cell: usize) -> PyResult<CellId> {
        if dimension < self.grid.f_vector().len() && cell < self.grid.cell_count(dimension) {
            return Ok(CellId::new(cell));
        }
        Err(invalid(py, format!("there is no cell {cell} of dimension {dimension}"), "look at .f_vector"))
    }
}

#[pymethods]
impl CuboidGrid {
    #[new]
    #[pyo3(signature = (*arguments, **options), text_signature = "(shape=None, *, lengths=None)")]
    fn new(
        py: Python<'_>,
        arguments: &Bound<'_, PyTuple>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let [shape, lengths] = bound("CuboidGrid", ["shape", "lengths"], 1, arguments, options)?;
        let wrong = |lengths: &Bound<'_, PyAny>| {
            let cure = "give a list of lengths for each axis: lengths=[[1.0, 2.0], [1.0]]";
            wrong_type(py, format!("lengths is {lengths}"), cure)
        };
        let lengths: Option<Vec<Vec<f64>>> =
            lengths.map(|lengths| lengths.extract().map_err(|_| wrong(&lengths))).transpose()?;
        let grid = match (shape, lengths) {
            (Some(shape), None) => Grid::new(&arrays::ids(&shape, "the shape")?),
            (None, Some(lengths)) => Grid::with_lengths(&lengths),
            _ => return Err(invalid(py, "a grid has a shape or lengths", "give one of the two")),
        };
        Ok(Self { grid: grid.or_raise(py)? })
    }

    /// The numbers of cells of the dimensions 0, 1, ...
    #[getter]
    fn f_vector<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.grid.f_vector())
    }

    /// The highest dimension of a cell; ``None`` of an empty grid.
    #[getter]
    fn dimension(&self) -> Option<usize> {
        self.grid.dimension()
    }

    /// The axes along which a cell extends, and its lowest corner.
    fn cell(
        &self,
        py: Python<'_>,
        #[pyo3(from_py_with = whole)] dimension: usize,
        #[pyo3(from_py_with = whole)] cell: usize,
    ) -> PyResult<(Vec<usize>, Vec<u32>)> {
        let found = self.grid.cell(dimension, self.cell_id(py, dimension, cell)?);
        Ok((found.extent().iter().collect(), found.corner().to_vec()))
    }

    /// The number of the cell with these axes and this corner; ``None`` if there is none.
    fn number(&self, py: Python<'_>, axes: Vec<usize>, corner: Vec<u32>) -> PyResult<Option<usize>> {
        let mut extent = AxisSet::default();
        for axis in axes {
            if axis >= self.grid.axis_count() {
                return Err(invalid(py, format!("there is no axis {axis}"), "axes count from 0"));
            }
            extent = extent.with(axis);
        }
        Ok(self.grid.number(&GridCell::new(extent, corner)).map(CellId::index))
    }

    /// The vertices of the cells of a dimension: ``int64``, shape (m, 2^k).
    fn cells<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = whole)] dimension: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        let lists = run(py, None, || self.grid.cells(dimension))?;
        arrays::from_lists(py, lists.iter(), lists.is_empty().then_some(1 << dimension.min(31)))
    }

    /// The facets of a cell with signs.
    fn facets(
        &self,
        py: Python<'_>,
        #[pyo3(from_py_with = whole)] dimension: usize,
        #[pyo3(from_py_with = whole)] cell: usize,
    ) -> PyResult<Vec<(usize, i32)>> {
        Ok(signed_cells(self.grid.facets(dimension, self.cell_id(py, dimension, cell)?)))
    }

    /// The cells that a cell is a facet of, with signs.
    fn cofaces(
        &self,
        py: Python<'_>,
        #[pyo3(from_py_with = whole)] dimension: usize,
        #[pyo3(from_py_with = whole)] cell: usize,
    ) -> PyResult<Vec<(usize, i32)>> {
        Ok(signed_cells(self.grid.cofaces(dimension, self.cell_id(py, dimension, cell)?)))
    }

    /// The positions of the vertices: shape (n, d).
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let positions = run(py, None, || self.grid.positions())?;
        Ok(arrays::grid(py, positions.as_flat().to_vec(), positions.dimension())?.into_any())
    }

    /// The chain complex.
    #[pyo3(signature = (*, progress=None))]
    fn chain_complex(&self, py: Python<'_>, progress: Option<&Bound<'_, PyAny>>) -> PyResult<ChainComplex> {
        run(py, progress, || self.grid.chain_complex()).map(ChainComplex::bare)
    }

    /// The cells of the highest dimension as a model; cut into simplices if ``simplices``.
    #[pyo3(signature = (*, simplices=false))]
    fn model(&self, py: Python<'_>, simplices: bool) -> PyResult<Model> {
        run(py, None, || {
            let Some(dimension) = self.grid.dimension() else { return Ok(io::Model::default()) };
            let placed =
                if simplices { self.grid.placed_simplices()? } else { self.grid.placed_cells(dimension)? };
            io::Model::from_placed_cells(placed)
        })
        .map(Model::of)
    }

    fn __len__(&self) -> usize {
        self.grid.dimension().map_or(0, |dimension| self.grid.cell_count(dimension))
    }

    fn __repr__(&self) -> String {
        format!("CuboidGrid(cells {:?})", self.grid.f_vector())
    }
}

/// A grid of cubes, each cut into simplices along its diagonal.
///
/// Parameters
/// ----------
/// shape : sequence of int
///     The numbers of cubes along the axes.
///
/// Examples
/// --------
/// >>> import coface
/// >>> grid = coface.SimplicialGrid((2, 1))
/// >>> grid.simplices.shape, grid.signs.tolist()
/// ((4, 3), [1, -1, 1, -1])
#[pyclass(frozen, module = "coface", name = "SimplicialGrid")]
pub(crate) struct SimplicialGrid {
    grid: Kuhn,
}

#[pymethods]
impl SimplicialGrid {
    #[new]
    #[pyo3(signature = (*arguments, **options), text_signature = "(shape)")]
    fn new(
        py: Python<'_>,
        arguments: &Bound<'_, PyTuple>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let [shape] = bound("SimplicialGrid", ["shape"], 1, arguments, options)?;
        let shape = &required(py, "SimplicialGrid", "shape", shape)?;
        Ok(Self { grid: Kuhn::new(&arrays::ids(shape, "the shape")?).or_raise(py)? })
    }

    /// The numbers of cubes along the axes.
    #[getter]
    fn shape<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.grid.shape())
    }

    /// The simplices, vertices rising: ``int64``, shape (m, d + 1).
    #[getter]
    fn simplices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let simplices = run(py, None, || self.grid.simplices())?;
        arrays::from_lists(py, simplices.lists().iter(), Some(self.grid.shape().len() + 1))
    }

    /// The signs that orient the simplices coherently: 1 or -1.
    #[getter]
    fn signs<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyArray1<i64>>> {
        let simplices = run(py, None, || self.grid.simplices())?;
        Ok(PyArray1::from_vec(py, simplices.signs().iter().map(|sign| i64::from(sign.to_i32())).collect()))
    }

    /// The positions of the vertices: shape (n, d).
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let positions = run(py, None, || self.grid.positions())?;
        Ok(arrays::grid(py, positions.as_flat().to_vec(), positions.dimension())?.into_any())
    }

    /// The simplices as a model.
    fn model(&self, py: Python<'_>) -> PyResult<Model> {
        run(py, None, || io::Model::from_placed_cells(self.grid.placed_cells()?)).map(Model::of)
    }

    fn __len__(&self) -> usize {
        self.grid.simplex_count()
    }

    fn __repr__(&self) -> String {
        format!("SimplicialGrid(shape {:?}, {} simplices)", self.grid.shape(), self.grid.simplex_count())
    }
}

/// A model of points, segments, triangles or facets swept through layers: segments become triangles, triangles tetrahedra.
///
/// Parameters
/// ----------
/// model : Model or Complex
///     The model.
/// heights : sequence of float
///     The heights of the layers, negative where a layer is empty.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// Model
///     The sweep, with one more axis; of facets a facet list.
///
/// Examples
/// --------
/// >>> import coface
/// >>> triangle = coface.Model([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]])
/// >>> coface._coface.extruded(triangle, [1.0])
/// Model(6 vertices, 3 cells)
#[pyfunction]
#[pyo3(signature = (model, heights, *, progress=None))]
pub(crate) fn extruded(
    py: Python<'_>,
    model: &Bound<'_, PyAny>,
    heights: Vec<f64>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Model> {
    let source = source_of(model)?;
    run(py, progress, || {
        let model = &source.model;
        if let Some(Structure::Facets(facets)) = model.structure() {
            let count = facets.items().iter().max().map_or(0, |&last| last as usize + 1);
            let lists = extrude(count, facets, &heights)?.into_simplices().into_lists();
            return Ok(io::Model::from_structure(Structure::Facets(lists)));
        }
        if model.structure().is_some() || !model.cells().is_empty() {
            return Err(Error::invalid("only points, segments and triangles can be swept")
                .with_cure("give a model of these, or the boundary of a volume"));
        }
        if let Some(i) = model.polygons().iter().position(|polygon| polygon.len() != 3) {
            let message =
                format!("face {i} has {} corners, so it is no simplex", model.polygons().list(i).len());
            return Err(Error::invalid(message).with_cure("give triangles"));
        }
        let segments: Vec<&[u32]> = model.lines().iter().flat_map(|line| line.windows(2)).collect();
        let (dimension, simplices) = match (model.polygons().is_empty(), segments.is_empty()) {
            (false, true) => (2, model.polygons().clone()),
            (true, false) => (1, RaggedArray::from_lists(segments)),
            (false, false) => {
                return Err(
                    Error::invalid("the model has triangles and lines").with_cure("sweep one of the two")
                );
            }
            (true, true) => (0, RaggedArray::uniform(1, (0..model.vertex_count() as u32).collect())?),
        };
        let sweep = extrude(model.vertex_count(), &simplices, &heights)?;
        model.require_finite()?;
        let positions = sweep.positions(model.positions())?;
        let cells = sweep.simplices().to_oriented();
        io::Model::from_placed_cells(PlacedCells::new(positions, CellKind::Simplex, dimension + 1, cells)?)
    })
    .map(Model::of)
}

/// The product of two models: of simplices a simplicial complex, its cells cut along staircases; else a chain complex.
///
/// Parameters
/// ----------
/// first, second : Model or Complex
///     The factors.
/// chains : bool
///     Whether products of cells are kept as they are, for simplices too.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// Model
///     A facet list, or a chain complex.
///
/// Examples
/// --------
/// >>> import coface
/// >>> circle = coface.Model.from_facets([[0, 1], [1, 2], [0, 2]])
/// >>> coface._coface.product(circle, circle).report().name
/// 'torus'
#[pyfunction]
#[pyo3(signature = (first, second, *, chains=false, progress=None))]
pub(crate) fn product(
    py: Python<'_>,
    first: &Bound<'_, PyAny>,
    second: &Bound<'_, PyAny>,
    chains: bool,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Model> {
    let (first, second) = (source_of(first)?, source_of(second)?);
    run(py, progress, || {
        if !chains
            && let (Ok(a), Ok(b)) = (simplicial_complex(&first.model), simplicial_complex(&second.model))
        {
            let (complex, _) = a.product(&b)?;
            let facets = complex.facets();
            let lists = RaggedArray::from_lists(facets.iter().map(Simplex::numbers));
            return Ok(io::Model::from_structure(Structure::Facets(lists)));
        }
        let (a, b) = (Arc::clone(first.chains()?), Arc::clone(second.chains()?));
        Ok(io::Model::from_structure(Structure::Chains(ProductComplex::new(&a, &b)?.into_complex())))
    })
    .map(Model::of)
}
