//! Sets on a Cartesian grid.

use coface::Error;
use coface::answers::CutCellsRequest;
use coface::yin::{CartesianGrid, Coverage, CutCells as Cells, YinSet};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::PyDict;

/// A set on a Cartesian grid: what of each cell it covers. Arrays have one row of cells a row.
///
/// Made by :meth:`YinSet.cut_cells`.
#[pyclass(frozen, dict, module = "coface", name = "CutCells")]
pub(crate) struct CutCells {
    pub(super) origin: [f64; 2],
    pub(super) spacing: [f64; 2],
    pub(super) counts: [usize; 2],
    pub(super) coverage: Vec<i8>,
    pub(super) areas: Vec<f64>,
    pub(super) lengths: Vec<f64>,
    pub(super) total_area: f64,
    pub(super) total_length: f64,
}

impl CutCells {
    /// What a set has of the cells of a grid, by default over a box.
    pub(super) fn of(
        set: &YinSet,
        around: Option<[[f64; 2]; 2]>,
        counts: (usize, usize),
        origin: Option<[f64; 2]>,
        spacing: Option<[f64; 2]>,
    ) -> Result<Self, Error> {
        let request = CutCellsRequest::new([counts.0, counts.1]).origin(origin).spacing(spacing);
        let grid = request.over(around);
        let cells = Cells::new(set, CartesianGrid::new(grid.origin, grid.spacing, grid.counts)?)?;
        let mut found = Self {
            origin: grid.origin,
            spacing: grid.spacing,
            counts: grid.counts,
            coverage: Vec::new(),
            areas: Vec::new(),
            lengths: Vec::new(),
            total_area: cells.total_area(),
            total_length: cells.total_length(),
        };
        for row in 0..grid.counts[1] {
            for column in 0..grid.counts[0] {
                found.coverage.push(match cells.coverage(column, row) {
                    Coverage::Empty => -1,
                    Coverage::Full => 1,
                    _ => 0,
                });
                found.areas.push(cells.area(column, row));
                found.lengths.push(cells.cell(column, row).map_or(0.0, |cell| cell.length()));
            }
        }
        Ok(found)
    }

    fn grid<'py, T: numpy::Element + Clone>(
        &self,
        py: Python<'py>,
        values: &[T],
    ) -> PyResult<Bound<'py, PyAny>> {
        let array = PyArray1::from_vec(py, values.to_vec());
        Ok(array.reshape([self.counts[1], self.counts[0]])?.into_any())
    }
}

#[pymethods]
impl CutCells {
    /// The lower left corner of the grid.
    #[getter]
    fn origin(&self) -> [f64; 2] {
        self.origin
    }

    /// The size of cells.
    #[getter]
    fn spacing(&self) -> [f64; 2] {
        self.spacing
    }

    /// For each cell -1 empty, 0 cut, 1 full: ``int8``, shape (rows, columns).
    #[getter]
    fn coverage<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.grid(py, &self.coverage)
    }

    /// The area of the set in each cell: shape (rows, columns).
    #[getter]
    fn areas<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.grid(py, &self.areas)
    }

    /// The length of the boundary in each cell: shape (rows, columns).
    #[getter]
    fn lengths<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.grid(py, &self.lengths)
    }

    /// The area in all cells.
    #[getter]
    fn total_area(&self) -> f64 {
        self.total_area
    }

    /// The length of the boundary in all cells.
    #[getter]
    fn total_length(&self) -> f64 {
        self.total_length
    }

    /// How many cells are full, cut and empty.
    fn counts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for (word, value) in [("full", 1), ("cut", 0), ("empty", -1)] {
            dict.set_item(word, self.coverage.iter().filter(|&&coverage| coverage == value).count())?;
        }
        Ok(dict)
    }

    fn __repr__(&self) -> String {
        format!("CutCells({} by {}, area {})", self.counts[0], self.counts[1], self.total_area)
    }
}
