//! Chains, cochains and generators.

use crate::arrays;
use crate::chain_sums::{chain_of, is_zero};
use crate::errors::wrong_type;
use crate::homology_facts::{ChainFacts, GeneratorFacts, integer_of, read};
use crate::json::from_python;
use crate::objects::to_python;
use crate::source::{Names, Naming};
use coface::CellId;
use coface::algebra::Integer;
use coface::answers::answer::{ChainTerm, WholeNumber};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use std::collections::BTreeMap;
use std::sync::Arc;

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

    /// The terms in the words of the program.
    fn chain_terms(&self) -> Vec<ChainTerm> {
        let term = |(cell, coefficient): &(CellId, Integer)| {
            let vertices = self.naming.vertices(self.degree, cell.index()).into_iter().map(u64::from);
            (WholeNumber::from(coefficient), vertices.collect())
        };
        self.terms.iter().map(term).collect()
    }

    fn cell_numbers(&self) -> Vec<usize> {
        self.terms.iter().map(|(cell, _)| cell.index()).collect()
    }

    /// What was written, as a chain of cells that know their vertices alone.
    fn of_parts(
        py: Python<'_>,
        (degree, is_cochain): (usize, bool),
        cell_count: usize,
        cells: &[usize],
        chain: &[ChainTerm],
    ) -> PyResult<Self> {
        if cells.len() != chain.len() {
            let message = format!("{} cells and {} terms of a chain", cells.len(), chain.len());
            return Err(crate::errors::invalid(py, message, "give what to_dict() gave"));
        }
        let (mut terms, mut names) = (Vec::new(), BTreeMap::new());
        for (&cell, (coefficient, vertices)) in cells.iter().zip(chain) {
            let number = |&vertex: &u64| u32::try_from(vertex);
            let vertices = vertices.iter().map(number).collect::<Result<Vec<u32>, _>>().map_err(|_| {
                crate::errors::invalid(py, "a vertex is beyond 32 bits", "give what to_dict() gave")
            })?;
            names.insert((degree, cell), vertices);
            terms.push((CellId::new(cell), integer_of(py, coefficient)?));
        }
        let naming = Arc::new(Naming::of(Names::Given(Arc::new(names))));
        Ok(Self { degree, terms, cell_count, naming, is_cochain })
    }

    /// The chain plus a multiple of what users give: a chain, a generator or 0.
    fn sum(&self, other: &Bound<'_, PyAny>, factor: &Integer) -> PyResult<Self> {
        match chain_of(other) {
            Some(chain) => self.plus(other.py(), chain, factor),
            None if is_zero(other) => Ok(self.times(&Integer::from(1))),
            None => {
                let message = format!("a chain and a {} have no sum", other.get_type().name()?);
                Err(wrong_type(other.py(), message, "give a chain of the same complex"))
            }
        }
    }

    /// The value on what users give as a chain.
    fn paired<'py>(&self, py: Python<'py>, chain: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        let Some(chain) = chain_of(chain) else {
            let message = format!("a {} is no chain", chain.get_type().name()?);
            return Err(wrong_type(py, message, "give a chain of the same complex"));
        };
        arrays::integer(py, &self.on(py, chain)?)
    }

    /// The vertices of the chain in the order of one closed walk along its edges, each as often as its coefficient says.
    fn closed_walk(&self) -> Option<Vec<u32>> {
        if self.is_cochain || self.degree() != 1 || self.terms.is_empty() {
            return None;
        }
        let mut steps = Vec::new();
        for (cell, coefficient) in &self.terms {
            let &[from, to] = &self.naming.vertices(self.degree, cell.index())[..] else { return None };
            let count =
                usize::try_from(coefficient.abs().to_i64()?).ok().filter(|&count| count <= 1 << 20)?;
            let step = if coefficient.signum() > 0 { [from, to] } else { [to, from] };
            steps.extend(std::iter::repeat_n(step, count));
        }
        // Over Z/n the signs need not agree along the walk.
        walk_along(&steps, true).or_else(|| walk_along(&steps, false))
    }
}

/// Whether a walk is closed and takes each step once: where some vertex has more steps out than in, the search ends beside its start.
fn is_closed_along(walk: &[u32], steps: &[[u32; 2]], is_directed: bool) -> bool {
    let ordered = |[a, b]: [u32; 2]| if is_directed || a < b { [a, b] } else { [b, a] };
    let mut taken: Vec<[u32; 2]> = walk.windows(2).map(|pair| ordered([pair[0], pair[1]])).collect();
    let mut given: Vec<[u32; 2]> = steps.iter().map(|&step| ordered(step)).collect();
    taken.sort_unstable();
    given.sort_unstable();
    walk.first() == walk.last() && taken == given
}

/// One closed walk through all steps (C. Hierholzer, 1873), each in its direction or in either one.
fn walk_along(steps: &[[u32; 2]], is_directed: bool) -> Option<Vec<u32>> {
    let mut leaving: BTreeMap<u32, Vec<usize>> = BTreeMap::new();
    for (number, &[from, to]) in steps.iter().enumerate().rev() {
        leaving.entry(from).or_default().push(number);
        let back = leaving.entry(to).or_default();
        if !is_directed {
            back.push(number);
        }
    }
    let mut is_used = vec![false; steps.len()];
    let (mut stack, mut walk) = (vec![steps[0][0]], Vec::new());
    while let Some(&vertex) = stack.last() {
        let list = leaving.get_mut(&vertex)?;
        match std::iter::from_fn(|| list.pop()).find(|&number| !is_used[number]) {
            Some(number) => {
                is_used[number] = true;
                let [from, to] = steps[number];
                stack.push(if from == vertex { to } else { from });
            }
            None => {
                walk.push(vertex);
                stack.pop();
            }
        }
    }
    walk.reverse();
    (walk.len() == steps.len() + 1 && is_closed_along(&walk, steps, is_directed)).then_some(walk)
}

#[pymethods]
impl Chain {
    /// The degree of its cells.
    #[getter]
    fn degree(&self) -> usize {
        self.degree - self.naming.shift.min(self.degree)
    }

    /// The model on whose cells it is; ``None`` where cells are numbers only.
    #[getter]
    fn model(&self) -> Option<crate::model::Model> {
        self.naming.model()
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
        if is_zero(other) {
            return self.terms.is_empty();
        }
        other.cast::<Self>().is_ok_and(|other| {
            let other = other.get();
            (self.degree(), self.is_cochain, self.cell_count)
                == (other.degree(), other.is_cochain, other.cell_count)
                && self.terms == other.terms
        })
    }

    /// The chain as a dictionary: ``degree``, ``cochain``, ``cell_count``, ``cells`` and ``chain``, pairs of a coefficient and vertices.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let facts = ChainFacts {
            cell_count: self.cell_count,
            cells: self.cell_numbers(),
            chain: self.chain_terms(),
            cochain: self.is_cochain,
            degree: self.degree(),
        };
        to_python(py, &facts)
    }

    /// The chain that :meth:`to_dict` wrote.
    #[staticmethod]
    fn from_dict(chain: &Bound<'_, PyAny>) -> PyResult<Self> {
        let py = chain.py();
        let facts: ChainFacts = read(py, from_python(chain)?, "a chain")?;
        Self::of_parts(py, (facts.degree, facts.cochain), facts.cell_count, &facts.cells, &facts.chain)
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let rebuild = py.get_type::<Self>().getattr("from_dict")?;
        Ok((rebuild, PyTuple::new(py, [self.to_dict(py)?])?))
    }

    fn __hash__(&self) -> isize {
        // A chain without cells is equal to 0.
        match self.terms.len() {
            0 => 0,
            count => (self.degree() * 1_000_003 + count) as isize,
        }
    }

    /// The sum of two chains of one complex; 0 is the chain without cells.
    fn __add__(&self, other: &Bound<'_, PyAny>) -> PyResult<Chain> {
        self.sum(other, &Integer::from(1))
    }

    fn __radd__(&self, other: &Bound<'_, PyAny>) -> PyResult<Chain> {
        self.sum(other, &Integer::from(1))
    }

    fn __sub__(&self, other: &Bound<'_, PyAny>) -> PyResult<Chain> {
        self.sum(other, &Integer::from(-1))
    }

    fn __rsub__(&self, other: &Bound<'_, PyAny>) -> PyResult<Chain> {
        Ok(self.sum(other, &Integer::from(-1))?.times(&Integer::from(-1)))
    }

    fn __neg__(&self) -> Chain {
        self.times(&Integer::from(-1))
    }

    /// An integer multiple of the chain.
    fn __mul__(&self, factor: &Bound<'_, PyAny>) -> PyResult<Chain> {
        Ok(self.times(&arrays::to_integer(factor)?))
    }

    fn __rmul__(&self, factor: &Bound<'_, PyAny>) -> PyResult<Chain> {
        Ok(self.times(&arrays::to_integer(factor)?))
    }

    /// The value of a cochain on a chain.
    fn __matmul__<'py>(&self, py: Python<'py>, chain: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.paired(py, chain)
    }

    /// The value of a cochain on a chain of the same degree: the sum of the products of their coefficients. ``cochain @ chain`` is the same.
    ///
    /// Parameters
    /// ----------
    /// chain : Chain or Generator
    ///     A chain of the same complex.
    ///
    /// Returns
    /// -------
    /// int
    ///     The value.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> found = coface.cocycles(coface.generate("torus", columns=5, rows=4))
    /// >>> complex = coface.as_chain_complex(found.cocycles[0].model)
    /// >>> loop = complex.chain([(1, step) for step in zip(found.loops[0][:-1], found.loops[0][1:])])
    /// >>> found.cocycles[0].value(loop), found.cocycles[1] @ loop
    /// (1, 0)
    fn value<'py>(&self, py: Python<'py>, chain: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.paired(py, chain)
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

impl Generator {
    fn length_value(&self) -> Integer {
        let mut length = Integer::ZERO;
        for coefficient in self.chain.get().coefficient_values() {
            length += &coefficient.abs();
        }
        length
    }

    pub(crate) fn facts(&self) -> GeneratorFacts {
        let chain = self.chain.get();
        let bounding = self.certificate.as_ref().map(Py::get);
        GeneratorFacts {
            bounding: bounding.map(Chain::chain_terms),
            bounding_cell_count: bounding.map(|chain| chain.cell_count),
            bounding_cells: bounding.map(Chain::cell_numbers),
            cell_count: chain.cell_count,
            cells: chain.cell_numbers(),
            chain: chain.chain_terms(),
            cochain: chain.is_cochain,
            degree: chain.degree(),
            length: WholeNumber::from(&self.length_value()),
            order: WholeNumber::of_order(self.order.as_ref()),
        }
    }

    pub(crate) fn of_facts(py: Python<'_>, facts: &GeneratorFacts) -> PyResult<Self> {
        let kind = (facts.degree, facts.cochain);
        let chain = Chain::of_parts(py, kind, facts.cell_count, &facts.cells, &facts.chain)?;
        let certificate = match (&facts.bounding, &facts.bounding_cells) {
            (Some(terms), Some(cells)) => {
                let count = facts.bounding_cell_count.unwrap_or(0);
                Some(Py::new(py, Chain::of_parts(py, (facts.degree + 1, false), count, cells, terms)?)?)
            }
            _ => None,
        };
        let order = if facts.order.is_zero() { None } else { Some(integer_of(py, &facts.order)?) };
        Ok(Self { order, chain: Py::new(py, chain)?, certificate })
    }
}

#[pymethods]
impl Generator {
    /// The order; ``None`` where no multiple is zero.
    #[getter]
    fn order<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyAny>>> {
        self.order.as_ref().map(|order| arrays::integer(py, order)).transpose()
    }

    /// Of a cycle of degree 1 its vertices in order, the first one again at the end: ``int64``. ``None`` of other degrees, of cocycles, and
    /// of cycles that are no single closed walk.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> coface.homology([[0, 1], [1, 2], [0, 2]], generators=True)[1].generators[0].loop
    /// array([0, 1, 2, 0])
    #[getter]
    fn r#loop<'py>(&self, py: Python<'py>) -> Option<Bound<'py, PyArray1<i64>>> {
        self.chain.get().closed_walk().map(|walk| arrays::id_array(py, walk))
    }

    /// The generator as a dictionary, as :meth:`Homology.to_dict` has it.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.facts())
    }

    /// The generator that :meth:`to_dict` wrote.
    #[staticmethod]
    fn from_dict(generator: &Bound<'_, PyAny>) -> PyResult<Self> {
        let py = generator.py();
        Self::of_facts(py, &read(py, from_python(generator)?, "a generator")?)
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let rebuild = py.get_type::<Self>().getattr("from_dict")?;
        Ok((rebuild, PyTuple::new(py, [self.to_dict(py)?])?))
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| {
            let other = other.get();
            self.order == other.order && self.facts() == other.facts()
        })
    }

    fn __hash__(&self) -> isize {
        (self.degree() * 1_000_003 + self.chain.get().terms.len()) as isize
    }

    /// The sum of two chains of one complex; 0 is the chain without cells.
    fn __add__(&self, other: &Bound<'_, PyAny>) -> PyResult<Chain> {
        self.chain.get().sum(other, &Integer::from(1))
    }

    fn __radd__(&self, other: &Bound<'_, PyAny>) -> PyResult<Chain> {
        self.chain.get().sum(other, &Integer::from(1))
    }

    fn __sub__(&self, other: &Bound<'_, PyAny>) -> PyResult<Chain> {
        self.chain.get().sum(other, &Integer::from(-1))
    }

    fn __rsub__(&self, other: &Bound<'_, PyAny>) -> PyResult<Chain> {
        Ok(self.chain.get().sum(other, &Integer::from(-1))?.times(&Integer::from(-1)))
    }

    fn __neg__(&self) -> Chain {
        self.chain.get().times(&Integer::from(-1))
    }

    /// An integer multiple of the chain.
    fn __mul__(&self, factor: &Bound<'_, PyAny>) -> PyResult<Chain> {
        Ok(self.chain.get().times(&arrays::to_integer(factor)?))
    }

    fn __rmul__(&self, factor: &Bound<'_, PyAny>) -> PyResult<Chain> {
        Ok(self.chain.get().times(&arrays::to_integer(factor)?))
    }

    /// The value of a cochain on a chain.
    fn __matmul__<'py>(&self, py: Python<'py>, chain: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.chain.get().paired(py, chain)
    }

    /// The value of a cochain on a chain of the same degree: the sum of the products of their coefficients. ``cochain @ chain`` is the same.
    ///
    /// Parameters
    /// ----------
    /// chain : Chain or Generator
    ///     A chain of the same complex.
    ///
    /// Returns
    /// -------
    /// int
    ///     The value.
    fn value<'py>(&self, py: Python<'py>, chain: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
        self.chain.get().paired(py, chain)
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

    /// The model on whose cells it is; ``None`` where cells are numbers only.
    #[getter]
    fn model(&self) -> Option<crate::model::Model> {
        self.chain.get().model()
    }

    /// Of a cycle of finite order m, a chain whose boundary is m times the cycle.
    #[getter]
    fn certificate(&self, py: Python<'_>) -> Option<Py<Chain>> {
        self.certificate.as_ref().map(|chain| chain.clone_ref(py))
    }

    /// How many cells it runs through, with multiplicity.
    #[getter]
    fn length<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        arrays::integer(py, &self.length_value())
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
