//! Cells as lists of vertices, and operators between them.

use crate::arrays;
use crate::chain_complex::ChainComplex;
use crate::errors::{OrRaise, bound, invalid, required, whole, wrong_type};
use crate::given::source_of;
use crate::memory::owned_matrix;
use crate::model::Model;
use crate::work::run;
use coface::Error;
use coface::algebra::chains;
use coface::algebra::{RaggedArray, SparseMatrix};
use coface::complexes::lar::{LarModel as Lar, Operator, Shared, TopOrientation};
use coface::geometry::Positions;
use coface::io::{self, Structure};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use std::sync::Arc;

/// Cells of each degree as lists of vertices, as in the linear algebraic representation.
///
/// The characteristic matrix of a degree has these lists as rows; operators such as ``VV`` or ``FE`` are products of two of them.
///
/// Parameters
/// ----------
/// cells : Model, Complex, ChainComplex, or sequence of lists
///     A model, or for each degree 1, 2, .. lists of vertices.
/// vertex_count : int, optional
///     The number of vertices, where lists are given.
///
/// Examples
/// --------
/// >>> import coface
/// >>> lar = coface.LarModel(coface.Complex([[0, 1, 2], [1, 2, 3]]))
/// >>> lar.incidence("FE", "incident").toarray()
/// array([[1, 1, 1, 0, 0],
///        [0, 0, 1, 1, 1]], dtype=int32)
#[pyclass(frozen, module = "coface", name = "LarModel")]
pub(crate) struct LarModel {
    lar: Arc<Lar>,
    /// The chain complex that the cells came with.
    chains: Option<Arc<chains::ChainComplex>>,
    positions: Option<Positions>,
}

/// A matrix of ones with these lists as rows, as its transpose.
fn pattern(column_count: usize, lists: &RaggedArray) -> Result<SparseMatrix, Error> {
    let starts = (0..=lists.len()).map(|row| lists.start(row) as u32).collect();
    let ones = vec![1; lists.item_count()];
    SparseMatrix::from_parts(column_count, starts, lists.items().to_vec(), ones)
}

#[pymethods]
impl LarModel {
    #[new]
    #[pyo3(signature = (*arguments, **options), text_signature = "(cells, vertex_count=None, *, progress=None)")]
    fn new(
        py: Python<'_>,
        arguments: &Bound<'_, PyTuple>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let names = ["cells", "vertex_count", "progress"];
        let [cells, vertex_count, progress] = bound("LarModel", names, 2, arguments, options)?;
        let (cells, progress) = (&required(py, "LarModel", "cells", cells)?, progress.as_ref());
        let vertex_count = vertex_count.map(|count| whole(&count)).transpose()?;
        if let Ok(source) = source_of(cells) {
            return run(py, progress, || {
                let producer = source.producer()?;
                let positions = producer.positions();
                Ok(Self {
                    lar: Arc::new(producer.lar_model()?),
                    chains: Some(Arc::clone(source.chains()?)),
                    positions: (!positions.is_empty()).then(|| positions.clone()),
                })
            });
        }
        let mut levels = Vec::new();
        let wrong = |_| {
            let cure = "give a model, or for each degree from 1 on the vertices of its cells";
            wrong_type(py, format!("cells is {cells}, which is no list of cells"), cure)
        };
        for lists in cells.try_iter().map_err(wrong)? {
            levels.push(arrays::lists(&lists?, "cells")?);
        }
        let highest = levels.iter().flat_map(|lists| lists.items().iter()).max();
        let count = vertex_count.unwrap_or(highest.map_or(0, |&vertex| vertex as usize + 1));
        let lar = run(py, progress, || Lar::new(count, levels))?;
        Ok(Self { lar: Arc::new(lar), chains: None, positions: None })
    }

    /// The numbers of cells of the degrees 0, 1, ...
    #[getter]
    fn f_vector<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.lar.f_vector())
    }

    /// The vertices of the cells of a degree.
    fn cells<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = whole)] degree: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        let lists = self.lar.cells(degree);
        arrays::from_lists(py, lists.iter(), lists.is_empty().then_some(degree + 1))
    }

    /// The characteristic matrix of a degree: one row for each cell, 1 in the columns of its vertices.
    fn characteristic<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = whole)] degree: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        let matrix = run(py, None, || self.lar.characteristic_matrix(degree))?;
        owned_matrix(py, matrix)
    }

    /// An operator between cells of two degrees.
    ///
    /// Parameters
    /// ----------
    /// operator : str
    ///     Rows and columns: two of ``V``, ``E``, ``F``, ``C``, as in ``"FE"``.
    /// kind : {"counts", "incident", "signed"}, optional
    ///     How many vertices two cells share, 1 where one is a face of the other (adjacent, if both have one degree), or the signs of
    ///     the boundary or coboundary operator. If it is left out, ``"counts"`` between cells of one degree, as in ``FF``, and ``"incident"``
    ///     between those of two, as in ``FE``: what ``coface incidence`` prints.
    /// at_least : int, optional
    ///     1 where so many vertices are shared, instead of ``kind``.
    /// exactly : int, optional
    ///     1 where exactly so many vertices are shared, instead of ``kind``.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// scipy.sparse.csr_array
    ///     One row for each cell of the first degree. Of ``counts`` between cells of one degree the diagonal is not empty: a cell shares all its
    ///     vertices with itself. ``VV`` counts edges: an entry is the number of edges that join two vertices, the diagonal the number of
    ///     edges at a vertex. ``incident`` has no diagonal.
    #[pyo3(signature = (operator, kind=None, *, at_least=None, exactly=None, progress=None))]
    fn incidence<'py>(
        &self,
        py: Python<'py>,
        operator: &str,
        kind: Option<&str>,
        at_least: Option<u32>,
        exactly: Option<u32>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Bound<'py, PyAny>> {
        let operator: Operator = operator.parse().or_raise(py)?;
        let usual = if operator.rows() == operator.columns() { "counts" } else { "incident" };
        let kind = kind.unwrap_or(usual);
        let shared = match (at_least, exactly) {
            (None, None) => None,
            (Some(n), None) if n > 0 => Some(Shared::AtLeast(n)),
            (None, Some(n)) if n > 0 => Some(Shared::Exactly(n)),
            _ => return Err(invalid(py, "at_least and exactly", "give one of them, 1 or more")),
        };
        if !matches!(kind, "counts" | "incident" | "signed") {
            return Err(invalid(
                py,
                format!("kind is {kind:?}"),
                "give \"counts\", \"incident\" or \"signed\"",
            ));
        }
        let by_rows = run(py, progress, || {
            let columns = self.lar.cell_count(operator.columns());
            match (shared, kind) {
                (Some(shared), _) => pattern(columns, &self.lar.related(operator, shared)?),
                (_, "incident") => pattern(columns, &self.lar.incident(operator)?),
                (_, "signed") => self.signed(operator),
                _ => self.lar.shared_vertices(operator.transposed()),
            }
        })?;
        // Columns of the transpose are rows.
        owned_matrix(py, by_rows)?.getattr("T")
    }

    /// The chain complex: with the signs that the cells came with, or found by spreading signs over facets.
    ///
    /// Parameters
    /// ----------
    /// orientation : {"given", "lowest", "coherent", "positive"}
    ///     How cells of the highest degree are oriented: as they came, by their lowest facet, so that neighbors agree, or with a positive
    ///     measure.
    /// positions : array_like, optional
    ///     Positions of the vertices, where measures decide.
    ///
    /// Returns
    /// -------
    /// ChainComplex
    ///     The complex.
    #[pyo3(signature = (orientation="given", positions=None, *, progress=None))]
    fn chain_complex(
        &self,
        py: Python<'_>,
        orientation: &str,
        positions: Option<&Bound<'_, PyAny>>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<ChainComplex> {
        let given = positions.map(|positions| arrays::positions(positions, "positions")).transpose()?;
        let top = match (orientation, &self.chains) {
            ("given", Some(chains)) => {
                return Ok(ChainComplex::new(
                    Arc::clone(chains),
                    crate::source::Naming::of(crate::source::Names::Own),
                ));
            }
            ("given" | "lowest", _) => TopOrientation::LowestFacet,
            ("coherent", _) => TopOrientation::Coherent,
            ("positive", _) => TopOrientation::Positive,
            _ => {
                let cure = "give \"given\", \"lowest\", \"coherent\" or \"positive\"";
                return Err(invalid(py, format!("orientation is {orientation:?}"), cure));
            }
        };
        let positions = given.as_ref().or(self.positions.as_ref());
        run(py, progress, || self.lar.oriented_chain_complex(top, positions)).map(ChainComplex::bare)
    }

    /// The cells as a model: their chain complex, with positions if there are some.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> coface.LarModel(coface.Complex([[0, 1, 2]])).model().f_vector
    /// (3, 3, 1)
    #[pyo3(signature = (*, progress=None))]
    fn model(&self, py: Python<'_>, progress: Option<&Bound<'_, PyAny>>) -> PyResult<Model> {
        let complex = run(py, progress, || match &self.chains {
            Some(chains) => Ok(chains.as_ref().clone()),
            None => self.lar.oriented_chain_complex(TopOrientation::LowestFacet, self.positions.as_ref()),
        })?;
        let made = match &self.positions {
            Some(positions) => io::Model::from_chains(complex, positions.clone()),
            None => Ok(io::Model::from_structure(Structure::Chains(complex))),
        };
        made.or_raise(py).map(Model::of)
    }

    /// The product: cells are pairs of cells; also ``*``.
    fn product(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        let other = other.get();
        let lar = run(py, None, || self.lar.product(&other.lar))?;
        Ok(Self { lar: Arc::new(lar), chains: None, positions: None })
    }

    fn __mul__(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        self.product(py, other)
    }

    fn __repr__(&self) -> String {
        format!("LarModel(cells {:?})", self.lar.f_vector())
    }
}

impl LarModel {
    /// The boundary or coboundary operator by rows.
    fn signed(&self, operator: Operator) -> Result<SparseMatrix, Error> {
        let (rows, columns) = (operator.rows(), operator.columns());
        if rows.abs_diff(columns) != 1 {
            return Err(Error::invalid(format!("{operator} is no boundary or coboundary operator"))
                .with_cure("signs are those of neighboring degrees: EV, FE, CF and VE, EF, FC"));
        }
        let found;
        let complex = match &self.chains {
            Some(chains) => chains,
            None => {
                found = Arc::new(
                    self.lar.oriented_chain_complex(TopOrientation::LowestFacet, self.positions.as_ref())?,
                );
                &found
            }
        };
        match complex.boundary_matrix(rows.max(columns)) {
            // A coboundary matrix has the boundary of each row's cell in the row.
            Some(boundary) if rows > columns => Ok(boundary.clone()),
            Some(boundary) => Ok(boundary.transpose()),
            None => SparseMatrix::zero(complex.cell_count(columns), complex.cell_count(rows)),
        }
    }
}
