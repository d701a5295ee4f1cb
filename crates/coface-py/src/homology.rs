//! Groups, and the cycles and cocycles that generate them.

use crate::arrays;
use crate::source::Naming;
use coface::CellId;
use coface::algebra::Integer;
use coface::topology::AbelianGroup;
use numpy::PyArray1;
use pyo3::IntoPyObjectExt;
use pyo3::exceptions::PyIndexError;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use std::sync::Arc;

/// Homology or cohomology: a group for each degree.
///
/// Made by :meth:`ChainComplex.homology`. ``homology[k]`` is the group of degree k.
///
/// Examples
/// --------
/// >>> import coface
/// >>> plane = coface.generate("rp2").chain_complex()
/// >>> plane.homology()
/// Homology(Z, Z/2)
/// >>> plane.homology()[1].torsion
/// (2,)
#[pyclass(frozen, module = "coface", name = "Homology")]
pub(crate) struct Homology {
    groups: Vec<Py<HomologyGroup>>,
    words: Vec<String>,
    bettis: Vec<usize>,
    is_cohomology: bool,
}

impl Homology {
    /// Groups without generators.
    pub(crate) fn of_groups(groups: &[AbelianGroup], is_cohomology: bool) -> Self {
        let none = vec![Vec::new(); groups.len()];
        Self::with_generators(groups, none, is_cohomology)
    }

    /// Groups with generators.
    pub(crate) fn with_generators(
        groups: &[AbelianGroup],
        generators: Vec<Vec<Generator>>,
        is_cohomology: bool,
    ) -> Self {
        let words = groups.iter().map(ToString::to_string).collect();
        let bettis = groups.iter().map(AbelianGroup::betti).collect();
        let made = Python::attach(|py| {
            groups
                .iter()
                .zip(generators)
                .enumerate()
                .map(|(degree, (group, generators))| {
                    let generators =
                        generators.into_iter().map(|one| Py::new(py, one)).collect::<PyResult<_>>()?;
                    Py::new(py, HomologyGroup { degree, group: group.clone(), generators, is_cohomology })
                })
                .collect::<PyResult<_>>()
        });
        // Only a lack of memory could be in the way.
        Self { groups: made.unwrap_or_default(), words, bettis, is_cohomology }
    }
}

#[pymethods]
impl Homology {
    /// The groups of the degrees 0, 1, ...
    #[getter]
    fn groups<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.groups.iter().map(|group| group.clone_ref(py)))
    }

    /// The ranks of the free parts.
    #[getter]
    fn betti_numbers<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, &self.bettis)
    }

    /// The orders of the finite parts, one tuple a degree, each order dividing the next.
    #[getter]
    fn torsion<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let lists: Vec<Bound<'py, PyTuple>> =
            self.groups.iter().map(|group| group.get().torsion(py)).collect::<PyResult<_>>()?;
        PyTuple::new(py, lists)
    }

    /// Whether it is cohomology.
    #[getter]
    fn is_cohomology(&self) -> bool {
        self.is_cohomology
    }

    /// The alternating sum of the Betti numbers.
    #[getter]
    fn euler_characteristic(&self) -> i64 {
        self.bettis.iter().enumerate().map(|(k, &b)| if k % 2 == 0 { b as i64 } else { -(b as i64) }).sum()
    }

    /// The groups as ``coface homology --json`` prints them.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyDict>>> {
        let dict = |group: &Py<HomologyGroup>| {
            let group = group.get();
            let dict = PyDict::new(py);
            dict.set_item("degree", group.degree)?;
            dict.set_item("betti", group.group.betti())?;
            let torsion: Vec<Bound<'py, PyAny>> = group
                .group
                .torsion()
                .iter()
                .map(|order| arrays::integer(py, order))
                .collect::<PyResult<_>>()?;
            dict.set_item("torsion", torsion)?;
            Ok(dict)
        };
        self.groups.iter().map(dict).collect()
    }

    fn __getitem__(&self, py: Python<'_>, degree: isize) -> PyResult<Py<HomologyGroup>> {
        let place = if degree < 0 { degree + self.groups.len() as isize } else { degree };
        let group = usize::try_from(place).ok().and_then(|place| self.groups.get(place));
        group.map(|group| group.clone_ref(py)).ok_or_else(|| {
            PyIndexError::new_err(format!(
                "there is no degree {degree}; the groups have degrees below {}",
                self.groups.len()
            ))
        })
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.groups(py)?.call_method0("__iter__")
    }

    fn __len__(&self) -> usize {
        self.groups.len()
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| {
            let other = other.get();
            self.is_cohomology == other.is_cohomology && self.words == other.words
        })
    }

    fn __hash__(&self) -> isize {
        self.bettis.iter().fold(29, |sum, &betti| sum.wrapping_mul(1_000_003).wrapping_add(betti as isize))
    }

    fn __repr__(&self) -> String {
        let name = if self.is_cohomology { "Cohomology" } else { "Homology" };
        let mut words = &self.words[..];
        while let [rest @ .., last] = words
            && last == "0"
        {
            words = rest;
        }
        format!("{name}({})", words.join(", "))
    }
}

/// A finitely generated abelian group of one degree: Z^betti and cyclic groups of finite orders.
#[pyclass(frozen, module = "coface", name = "HomologyGroup")]
pub(crate) struct HomologyGroup {
    degree: usize,
    group: AbelianGroup,
    generators: Vec<Py<Generator>>,
    is_cohomology: bool,
}

#[pymethods]
impl HomologyGroup {
    /// The degree.
    #[getter]
    fn degree(&self) -> usize {
        self.degree
    }

    /// The rank of the free part.
    #[getter]
    fn betti(&self) -> usize {
        self.group.betti()
    }

    /// The orders of the finite part, each dividing the next.
    #[getter]
    fn torsion<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        let orders: Vec<Bound<'py, PyAny>> =
            self.group.torsion().iter().map(|order| arrays::integer(py, order)).collect::<PyResult<_>>()?;
        PyTuple::new(py, orders)
    }

    /// The generators, if they were asked for: those of finite order in the order of :attr:`torsion`, and the free ones.
    #[getter]
    fn generators<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.generators.iter().map(|one| one.clone_ref(py)))
    }

    /// Whether it is the group of one element.
    #[getter]
    fn is_trivial(&self) -> bool {
        self.group.is_trivial()
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| self.group == other.get().group)
    }

    fn __hash__(&self) -> isize {
        self.group.betti() as isize
    }

    fn __str__(&self) -> String {
        self.group.to_string()
    }

    fn __repr__(&self) -> String {
        let symbol = if self.is_cohomology { "H^" } else { "H_" };
        format!("{symbol}{} = {}", self.degree, self.group)
    }
}

/// An integral chain or cochain: cells with coefficients.
///
/// Made by :meth:`ChainComplex.chain` and by questions whose answers are chains.
#[pyclass(frozen, module = "coface", name = "Chain")]
pub(crate) struct Chain {
    pub(crate) degree: usize,
    pub(crate) terms: Vec<(CellId, Integer)>,
    pub(crate) cell_count: usize,
    pub(crate) naming: Arc<Naming>,
    pub(crate) is_cochain: bool,
}

impl Chain {
    fn coefficient_values(&self) -> impl Iterator<Item = &Integer> + Clone {
        self.terms.iter().map(|(_, coefficient)| coefficient)
    }
}

#[pymethods]
impl Chain {
    /// The degree of its cells.
    #[getter]
    fn degree(&self) -> usize {
        self.degree - self.naming.shift.min(self.degree)
    }

    /// Whether it is a cochain.
    #[getter]
    fn is_cochain(&self) -> bool {
        self.is_cochain
    }

    /// The coefficients: ``int64``, objects where one is larger.
    #[getter]
    pub(crate) fn coefficients<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        arrays::integer_array(py, self.coefficient_values())
    }

    /// The cells with a coefficient, rising, by their numbers in the complex.
    #[getter]
    pub(crate) fn cells<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        arrays::index_array(py, self.terms.iter().map(|(cell, _)| cell.index()))
    }

    /// The vertices of those cells: an array of shape (m, k + 1), or ``(flat, offsets)`` where cells have different numbers of vertices.
    ///
    /// The order of the vertices is the orientation that the coefficient is for. Cells that are not named by vertices have their own
    /// number instead.
    #[getter]
    pub(crate) fn simplices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let names = self.terms.iter().map(|(cell, _)| self.naming.vertices(self.degree, cell.index()));
        let width = self.terms.is_empty().then(|| self.degree() + 1);
        arrays::from_lists(py, names.collect::<Vec<_>>(), width)
    }

    /// All coefficients as a column: one row for each cell of the degree.
    ///
    /// Returns
    /// -------
    /// scipy.sparse.csc_array
    ///     Shape (cells, 1), ``int64``.
    pub(crate) fn as_vector<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let indices =
            PyArray1::from_vec(py, self.terms.iter().map(|(cell, _)| cell.index() as i32).collect());
        let starts = PyArray1::from_vec(py, vec![0_i32, self.terms.len() as i32]);
        let options = PyDict::new(py);
        options.set_item("shape", (self.cell_count, 1))?;
        let class = py.import("scipy.sparse")?.getattr("csc_array")?;
        class.call(((self.coefficients(py)?, indices, starts),), Some(&options))
    }

    /// The chain as ``(coefficient, vertices)``, cell by cell.
    fn terms<'py>(&self, py: Python<'py>) -> PyResult<Vec<(Bound<'py, PyAny>, Vec<u32>)>> {
        let term = |(cell, coefficient): &(CellId, Integer)| {
            Ok((arrays::integer(py, coefficient)?, self.naming.vertices(self.degree, cell.index())))
        };
        self.terms.iter().map(term).collect()
    }

    fn __len__(&self) -> usize {
        self.terms.len()
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| {
            let other = other.get();
            self.degree == other.degree && self.is_cochain == other.is_cochain && self.terms == other.terms
        })
    }

    fn __hash__(&self) -> isize {
        (self.degree * 1_000_003 + self.terms.len()) as isize
    }

    fn __repr__(&self) -> String {
        let name = if self.is_cochain { "Cochain" } else { "Chain" };
        let cells = if self.terms.len() == 1 { "cell" } else { "cells" };
        format!("{name}(degree {}, {} {cells})", self.degree(), self.terms.len())
    }
}

/// A cycle, or a cocycle, that generates a cyclic part of a group.
///
/// Examples
/// --------
/// The loop of the projective plane, twice which bounds a disk:
///
/// >>> import coface
/// >>> homology = coface.generate("rp2").chain_complex().homology(generators=True)
/// >>> loop = homology[1].generators[0]
/// >>> loop.order, loop.simplices.shape, loop.coefficients
/// (2, (3, 2), array([ 1, -1,  1]))
/// >>> loop.certificate
/// Chain(degree 2, 10 cells)
#[pyclass(frozen, module = "coface", name = "Generator")]
pub(crate) struct Generator {
    pub(crate) order: Option<Integer>,
    pub(crate) chain: Py<Chain>,
    pub(crate) certificate: Option<Py<Chain>>,
}

impl Clone for Generator {
    fn clone(&self) -> Self {
        Python::attach(|py| Self {
            order: self.order.clone(),
            chain: self.chain.clone_ref(py),
            certificate: self.certificate.as_ref().map(|chain| chain.clone_ref(py)),
        })
    }
}

#[pymethods]
impl Generator {
    /// The order: 0 where no multiple is zero.
    #[getter]
    fn order<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        match &self.order {
            Some(order) => arrays::integer(py, order),
            None => 0_i64.into_bound_py_any(py),
        }
    }

    /// The degree.
    #[getter]
    fn degree(&self) -> usize {
        self.chain.get().degree()
    }

    /// The cycle or cocycle.
    #[getter]
    fn chain(&self, py: Python<'_>) -> Py<Chain> {
        self.chain.clone_ref(py)
    }

    /// Of a cycle of finite order m, a chain whose boundary is m times the cycle.
    #[getter]
    fn certificate(&self, py: Python<'_>) -> Option<Py<Chain>> {
        self.certificate.as_ref().map(|chain| chain.clone_ref(py))
    }

    /// How many cells it runs through, with multiplicity.
    #[getter]
    fn length<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let mut length = Integer::ZERO;
        for coefficient in self.chain.get().coefficient_values() {
            length += &coefficient.abs();
        }
        arrays::integer(py, &length)
    }

    /// The coefficients: ``int64``, objects where one is larger.
    #[getter]
    fn coefficients<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.chain.get().coefficients(py)
    }

    /// The cells by their numbers.
    #[getter]
    fn cells<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        self.chain.get().cells(py)
    }

    /// The vertices of the cells: an array of shape (m, k + 1), or ``(flat, offsets)``.
    #[getter]
    fn simplices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.chain.get().simplices(py)
    }

    /// All coefficients as a sparse column.
    fn as_vector<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        self.chain.get().as_vector(py)
    }

    fn __len__(&self) -> usize {
        self.chain.get().terms.len()
    }

    fn __repr__(&self) -> String {
        let order = self.order.as_ref().map_or_else(|| "free".to_owned(), |order| format!("order {order}"));
        let cells = self.chain.get().terms.len();
        format!(
            "Generator(degree {}, {order}, {cells} {})",
            self.degree(),
            if cells == 1 { "cell" } else { "cells" }
        )
    }
}
