//! Chain complexes, and the questions that are put to them.

use crate::arrays;
use crate::errors::{OrRaise, invalid, whole, whole_or_none};
use crate::homology::{Chain, Generator, Homology};
use crate::memory::{owned_matrix, shared_matrix};
use crate::model::Model;
use crate::source::{Names, Naming};
use crate::work::run;
use coface::algebra::Integer;
use coface::algebra::chains;
use coface::algebra::chains::ProductComplex;
use coface::answers::group_chain;
use coface::io;
use coface::io::Structure;
use coface::topology::{Coefficients, HomologyBasis, homology};
use coface::{CellId, Error};
use pyo3::prelude::*;
use pyo3::types::{PyString, PyTuple};
use std::sync::Arc;

/// A chain complex: for each degree a number of cells, and their boundaries as sparse integer matrices.
///
/// Made by :meth:`Model.chain_complex`, :meth:`Complex.chain_complex` or from matrices. That the boundary of a boundary is zero is
/// checked when it is made.
///
/// Examples
/// --------
/// A circle of one vertex and one edge:
///
/// >>> import coface
/// >>> circle = coface.ChainComplex.from_boundaries([[[0]]])
/// >>> circle.homology()
/// Homology(Z, Z)
/// >>> coface.Complex([[0, 1, 2]]).chain_complex().boundary(2).toarray().T
/// array([[ 1, -1,  1]], dtype=int32)
#[pyclass(frozen, module = "coface", name = "ChainComplex")]
pub(crate) struct ChainComplex {
    pub(crate) complex: Arc<chains::ChainComplex>,
    pub(crate) naming: Arc<Naming>,
}

impl ChainComplex {
    pub(crate) fn new(complex: Arc<chains::ChainComplex>, naming: Naming) -> Self {
        Self { complex, naming: Arc::new(naming) }
    }

    /// A complex whose cells have numbers only.
    pub(crate) fn bare(complex: chains::ChainComplex) -> Self {
        Self::new(Arc::new(complex), Naming::of(Names::Own))
    }

    /// The degree inside, which counts from the lowest cells, as users give it, counted from vertices.
    pub(crate) fn inner(&self, degree: usize) -> usize {
        degree + self.naming.shift
    }

    pub(crate) fn chain_of(&self, degree: usize, terms: Vec<(CellId, Integer)>, is_cochain: bool) -> Chain {
        let cell_count = self.complex.cell_count(degree);
        Chain { degree, terms, cell_count, naming: Arc::clone(&self.naming), is_cochain }
    }

    /// A chain of this complex that users give: a :class:`Chain`, a sparse or dense vector, or terms `(coefficient, cell)`.
    pub(crate) fn terms_of(
        &self,
        value: &Bound<'_, PyAny>,
        degree: Option<usize>,
    ) -> PyResult<(usize, Vec<(CellId, Integer)>)> {
        let py = value.py();
        if let Ok(chain) = value.cast::<Chain>() {
            let chain = chain.get();
            return Ok((chain.degree, chain.terms.clone()));
        }
        if let Ok(generator) = value.cast::<Generator>() {
            let chain = generator.get().chain.get();
            return Ok((chain.degree, chain.terms.clone()));
        }
        if let Ok(name) = value.cast::<PyString>() {
            let name = name.to_str()?;
            let group = match &self.naming.names {
                Names::Source(source) => group_chain(&source.model, name),
                _ => None,
            };
            let Some((degree, named)) = group else {
                return Err(invalid(
                    py,
                    format!("the model has no group {name:?}"),
                    "give the name of a group of the mesh",
                ));
            };
            return self.by_names(py, &named, Some(degree));
        }
        if value.hasattr("tocoo")? || value.hasattr("ndim")? {
            let Some(degree) = degree else {
                return Err(invalid(py, "a vector does not say its degree", "give degree=k"));
            };
            let matrix = arrays::to_matrix(&as_column(value)?, "the vector")?;
            let degree = self.inner(degree);
            let count = self.complex.cell_count(degree);
            if matrix.row_count() != count {
                let message = format!("the vector has {} rows for {count} cells", matrix.row_count());
                return Err(invalid(py, message, "give one row for each cell of the degree"));
            }
            let terms =
                matrix.column(0).iter().map(|(row, x)| (CellId::new(row), Integer::from(x))).collect();
            return Ok((degree, terms));
        }
        self.listed(value, degree)
    }

    /// Terms `(coefficient, vertices)` or `(coefficient, number)`.
    fn listed(
        &self,
        value: &Bound<'_, PyAny>,
        degree: Option<usize>,
    ) -> PyResult<(usize, Vec<(CellId, Integer)>)> {
        let py = value.py();
        let (mut numbered, mut named) = (Vec::new(), Vec::new());
        for term in value.try_iter()? {
            let term = term?;
            let (coefficient, cell): (Bound<'_, PyAny>, Bound<'_, PyAny>) = term.extract().map_err(|_| {
                invalid(
                    py,
                    format!("{term} is no term of a chain"),
                    "give pairs (coefficient, vertices of a cell)",
                )
            })?;
            let coefficient = arrays::to_integer(&coefficient)?;
            if cell.hasattr("__len__")? {
                named.push((coefficient, arrays::ids(&cell, "a cell")?));
            } else {
                numbered.push((CellId::new(arrays::id(&cell, "a cell")? as usize), coefficient));
            }
        }
        if named.is_empty() {
            let Some(degree) = degree else {
                return Err(invalid(py, "cells by their numbers do not say their degree", "give degree=k"));
            };
            return Ok((self.inner(degree), numbered));
        }
        if !numbered.is_empty() {
            return Err(invalid(
                py,
                "some cells are named by numbers, some by vertices",
                "use one of the two",
            ));
        }
        self.by_names(py, &named, degree)
    }

    fn by_names(
        &self,
        py: Python<'_>,
        named: &[(Integer, Vec<u32>)],
        degree: Option<usize>,
    ) -> PyResult<(usize, Vec<(CellId, Integer)>)> {
        let chain = match &self.naming.names {
            Names::Source(source)
                if source.has_named_edges() && named.iter().all(|(_, vertices)| vertices.len() == 2) =>
            {
                let Some(terms) =
                    source.edges_between(named).filter(|_| degree.is_none_or(|degree| degree == 1))
                else {
                    let message = "a pair of vertices is no edge of the complex, or more than one";
                    return Err(invalid(py, message, "name edges by their numbers, with degree=1"));
                };
                chains::Chain::new(source.chains().or_raise(py)?, 1, terms).or_raise(py)?
            }
            Names::Source(source) => {
                run(py, None, || source.producer()?.chain(source.chains()?, named, degree))?
            }
            Names::Simplices(complex) => {
                let mut terms = Vec::new();
                let degree = degree.unwrap_or(named[0].1.len().max(1) - 1);
                for (coefficient, vertices) in named {
                    let simplex =
                        coface::complexes::simplicial::Simplex::from_numbers(vertices).or_raise(py)?;
                    let sign = simplex.sign_of(vertices).or_raise(py)?;
                    let place = complex.index_of(simplex.numbers()).filter(|_| simplex.dimension() == degree);
                    let place = place.ok_or_else(|| {
                        let error = Error::new(
                            coface::ErrorKind::NotInComplex,
                            format!("there is no simplex {vertices:?} of dimension {degree} in the complex"),
                        );
                        crate::errors::raised(
                            py,
                            &error
                                .with_cure("give simplices of one dimension")
                                .with_cells([vertices.clone()]),
                        )
                    })?;
                    let coefficient =
                        if sign == coface::algebra::Sign::Minus { -coefficient } else { coefficient.clone() };
                    terms.push((CellId::new(place), coefficient));
                }
                return Ok((self.inner(degree), terms));
            }
            Names::Own | Names::Given(_) => {
                return Err(invalid(
                    py,
                    "the cells of this complex have no vertices",
                    "name them by their numbers",
                ));
            }
        };
        // Cells that the pair leaves out vanish.
        let kept = chain.terms().iter().filter_map(|(cell, x)| {
            let position = match &self.naming.pair {
                Some(pair) => pair.position(chain.degree(), *cell)?,
                None => *cell,
            };
            Some((position, x.clone()))
        });
        Ok((self.inner(chain.degree()), kept.collect()))
    }

    /// Groups, with generators on the cells of the complex where they are asked for.
    fn groups(
        &self,
        py: Python<'_>,
        coefficients: Coefficients,
        generators: bool,
        is_cohomology: bool,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Homology> {
        let shift = self.naming.shift;
        let (groups, found) = run(py, progress, || {
            let of = |integral: coface::topology::Homology| match is_cohomology {
                true => integral.dual(coefficients),
                false => integral.with_coefficients(coefficients),
            };
            if !generators {
                return Ok((of(homology(&self.complex)), Vec::new()));
            }
            let basis = HomologyBasis::new(&self.complex);
            let mut found = Vec::new();
            for degree in shift..self.complex.degree_count() {
                found.push(Found::all(&basis, degree, coefficients, is_cohomology));
            }
            Ok((of(basis.homology()), found))
        })?;
        let groups = &groups.groups()[shift.min(groups.groups().len())..];
        if !generators {
            let none = vec![Vec::new(); groups.len()];
            return Ok(Homology::with_generators(groups, none, coefficients, is_cohomology));
        }
        let mut lists = Vec::new();
        for (place, list) in found.into_iter().enumerate() {
            let degree = place + shift;
            let list = list.into_iter().map(|found| {
                let certificate =
                    found.certificate.map(|terms| Py::new(py, self.chain_of(degree + 1, terms, false)));
                Ok(Generator {
                    order: found.order,
                    chain: Py::new(py, self.chain_of(degree, found.terms, is_cohomology))?,
                    certificate: certificate.transpose()?,
                })
            });
            lists.push(list.collect::<PyResult<Vec<_>>>()?);
        }
        Ok(Homology::with_generators(groups, lists, coefficients, is_cohomology))
    }
}

/// A generator, as the library says it.
struct Found {
    order: Option<Integer>,
    terms: Vec<(CellId, Integer)>,
    certificate: Option<Vec<(CellId, Integer)>>,
}

impl Found {
    fn all(
        basis: &HomologyBasis<'_>,
        degree: usize,
        coefficients: Coefficients,
        is_cohomology: bool,
    ) -> Vec<Self> {
        if is_cohomology {
            let cocycles = basis.cocycles_with(degree, coefficients).into_iter();
            return cocycles
                .map(|cocycle| Self {
                    order: cocycle.order().cloned(),
                    terms: cocycle.cochain().terms().to_vec(),
                    certificate: None,
                })
                .collect();
        }
        let is_integral = coefficients == Coefficients::Integers;
        let generators = basis.generators_with(degree, coefficients).into_iter().enumerate();
        generators
            .map(|(i, generator)| Self {
                order: generator.order().cloned(),
                terms: generator.chain().terms().to_vec(),
                certificate: is_integral
                    .then(|| basis.certificate(degree, i))
                    .flatten()
                    .map(|chain| chain.terms().to_vec()),
            })
            .collect()
    }
}

/// A vector of one dimension as one column.
fn as_column<'py>(value: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    if value.hasattr("tocoo")? {
        return Ok(value.clone());
    }
    value.call_method1("reshape", ((-1, 1),))
}

/// The ring that users name: ``"z"``, ``"q"``, ``"f2"``, ``"z/4"``, or a modulus.
pub(crate) fn ring(value: &Bound<'_, PyAny>) -> PyResult<Coefficients> {
    let py = value.py();
    if value.hasattr("__index__")? {
        let modulus: i64 = value.extract()?;
        return match modulus {
            0 => Ok(Coefficients::Integers),
            _ => format!("z/{modulus}").parse().or_raise(py),
        };
    }
    match value.cast::<PyString>() {
        Ok(word) => word.to_str()?.parse().or_raise(py),
        Err(_) => Err(invalid(
            py,
            format!("{value} is no ring of coefficients"),
            "give \"z\", \"q\", \"f2\", \"z/4\" or a modulus",
        )),
    }
}

#[pymethods]
impl ChainComplex {
    /// A chain complex from its boundary matrices.
    ///
    /// Parameters
    /// ----------
    /// boundaries : sequence of sparse arrays or array_like
    ///     The matrices of degrees 1, 2, ...: column j is the boundary of cell j.
    ///
    /// Returns
    /// -------
    /// ChainComplex
    ///     Its cells are named by their numbers.
    ///
    /// Raises
    /// ------
    /// BoundaryOfBoundaryError
    ///     If the product of two of them is not zero.
    /// ShapeError
    ///     If they do not fit together.
    #[staticmethod]
    fn from_boundaries(py: Python<'_>, boundaries: &Bound<'_, PyAny>) -> PyResult<Self> {
        let mut matrices = Vec::new();
        for (i, matrix) in boundaries.try_iter()?.enumerate() {
            matrices.push(arrays::to_matrix(&matrix?, &format!("the boundary of degree {}", i + 1))?);
        }
        run(py, None, || chains::ChainComplex::new(matrices)).map(Self::bare)
    }

    /// So many points and nothing else.
    #[staticmethod]
    fn of_points(#[pyo3(from_py_with = whole)] count: usize) -> Self {
        Self::bare(chains::ChainComplex::of_points(count))
    }

    /// The numbers of cells of the degrees 0, 1, ...
    #[getter]
    fn f_vector<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(py, self.complex.f_vector())
    }

    /// The highest degree with cells; ``None`` of the empty complex.
    #[getter]
    fn dimension(&self) -> Option<usize> {
        self.complex.dimension().and_then(|dimension| dimension.checked_sub(self.naming.shift))
    }

    /// The alternating sum of the numbers of cells.
    #[getter]
    fn euler_characteristic(&self) -> i64 {
        self.complex.euler_characteristic()
    }

    /// The number of cells of a degree.
    fn cell_count(&self, #[pyo3(from_py_with = whole)] degree: usize) -> usize {
        self.complex.cell_count(self.inner(degree))
    }

    /// The boundary matrix from degree k to k - 1, on the memory of the complex: column j is the boundary of cell j.
    ///
    /// Parameters
    /// ----------
    /// degree : int
    ///     The degree k, at least 1; 0 of a reduced complex.
    ///
    /// Returns
    /// -------
    /// scipy.sparse.csc_array
    ///     ``int32`` entries and indices, which cannot be written to: arithmetic on them makes new arrays.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> edge = coface.Complex([[0, 1]]).chain_complex()
    /// >>> edge.boundary(1).toarray()
    /// array([[-1],
    ///        [ 1]], dtype=int32)
    fn boundary<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = whole)] degree: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        match self.complex.boundary_matrix(self.inner(degree)) {
            Some(_) => {
                let inner = self.inner(degree);
                shared_matrix(py, &self.complex, |complex| {
                    complex.boundary_matrix(inner).expect("it was there")
                })
            }
            None => {
                let rows =
                    self.inner(degree).checked_sub(1).map_or(0, |below| self.complex.cell_count(below));
                let columns = self.complex.cell_count(self.inner(degree));
                owned_matrix(py, coface::algebra::SparseMatrix::zero(rows, columns).or_raise(py)?)
            }
        }
    }

    /// The coboundary matrix from degree k to k + 1: the transpose of the boundary matrix of degree k + 1.
    fn coboundary<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = whole)] degree: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        let matrix = match self.complex.coboundary_matrix(self.inner(degree)) {
            Some(matrix) => matrix,
            None => coface::algebra::SparseMatrix::zero(0, self.complex.cell_count(self.inner(degree)))
                .or_raise(py)?,
        };
        owned_matrix(py, matrix)
    }

    /// The vertices of the cells of a degree: an array of shape (m, k + 1), or ``(flat, offsets)``.
    fn simplices<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = whole)] degree: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        let inner = self.inner(degree);
        let count = self.complex.cell_count(inner);
        let names: Vec<Vec<u32>> = (0..count).map(|cell| self.naming.vertices(inner, cell)).collect();
        arrays::from_lists(py, names, (count == 0).then_some(degree + 1))
    }

    /// Homology.
    ///
    /// Parameters
    /// ----------
    /// coefficients : str or int
    ///     ``"z"``, ``"q"``, ``"f2"``, ``"z/4"``, or a modulus.
    /// generators : bool
    ///     Whether short cycles that generate the groups are wanted.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// Homology
    ///     A group for each degree.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> coface.generate("klein").chain_complex().homology("f2").betti_numbers
    /// (1, 2, 1)
    #[pyo3(signature = (coefficients=None, *, generators=false, progress=None), text_signature = "($self, coefficients='z', *, generators=False, progress=None)")]
    fn homology(
        &self,
        py: Python<'_>,
        coefficients: Option<&Bound<'_, PyAny>>,
        generators: bool,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Homology> {
        let ring = coefficients.map_or(Ok(Coefficients::Integers), ring)?;
        self.groups(py, ring, generators, false, progress)
    }

    /// Cohomology; parameters as those of :meth:`homology`.
    #[pyo3(signature = (coefficients=None, *, generators=false, progress=None), text_signature = "($self, coefficients='z', *, generators=False, progress=None)")]
    fn cohomology(
        &self,
        py: Python<'_>,
        coefficients: Option<&Bound<'_, PyAny>>,
        generators: bool,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Homology> {
        let ring = coefficients.map_or(Ok(Coefficients::Integers), ring)?;
        self.groups(py, ring, generators, true, progress)
    }

    /// A chain.
    ///
    /// Parameters
    /// ----------
    /// terms : sequence of (int, cell), vector, or str
    ///     Coefficients and cells, a cell being its vertices in the order of its orientation, or its number; or one number for each cell; or the
    ///     name of a group of the mesh, whose elements count as often as they stand there, turned ones negatively.
    /// degree : int, optional
    ///     The degree, where cells are numbers.
    ///
    /// Returns
    /// -------
    /// Chain
    ///     The chain.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> triangle = coface.Complex([[0, 1, 2]]).chain_complex()
    /// >>> path = triangle.chain([(1, [0, 1]), (1, [1, 2])])
    /// >>> triangle.boundary_of(path).terms()
    /// [(-1, [0]), (1, [2])]
    #[pyo3(signature = (terms, degree=None))]
    fn chain(
        &self,
        py: Python<'_>,
        terms: &Bound<'_, PyAny>,
        #[pyo3(from_py_with = whole_or_none)] degree: Option<usize>,
    ) -> PyResult<Chain> {
        let (degree, terms) = self.terms_of(terms, degree)?;
        let chain = chains::Chain::new(&self.complex, degree, terms).or_raise(py)?;
        Ok(self.chain_of(degree, chain.terms().to_vec(), false))
    }

    /// A cochain; parameters as those of :meth:`chain`.
    #[pyo3(signature = (terms, degree=None))]
    fn cochain(
        &self,
        py: Python<'_>,
        terms: &Bound<'_, PyAny>,
        #[pyo3(from_py_with = whole_or_none)] degree: Option<usize>,
    ) -> PyResult<Chain> {
        let (degree, terms) = self.terms_of(terms, degree)?;
        let chain = chains::Cochain::new(&self.complex, degree, terms).or_raise(py)?;
        Ok(self.chain_of(degree, chain.terms().to_vec(), true))
    }

    /// The boundary of a chain.
    #[pyo3(signature = (chain, degree=None))]
    fn boundary_of(
        &self,
        py: Python<'_>,
        chain: &Bound<'_, PyAny>,
        #[pyo3(from_py_with = whole_or_none)] degree: Option<usize>,
    ) -> PyResult<Chain> {
        let (degree, terms) = self.terms_of(chain, degree)?;
        let boundary =
            run(py, None, || self.complex.boundary(&chains::Chain::new(&self.complex, degree, terms)?))?;
        Ok(self.chain_of(boundary.degree(), boundary.terms().to_vec(), false))
    }

    /// The coboundary of a cochain.
    #[pyo3(signature = (cochain, degree=None))]
    fn coboundary_of(
        &self,
        py: Python<'_>,
        cochain: &Bound<'_, PyAny>,
        #[pyo3(from_py_with = whole_or_none)] degree: Option<usize>,
    ) -> PyResult<Chain> {
        let (degree, terms) = self.terms_of(cochain, degree)?;
        let coboundary =
            run(py, None, || self.complex.coboundary(&chains::Cochain::new(&self.complex, degree, terms)?))?;
        Ok(self.chain_of(coboundary.degree(), coboundary.terms().to_vec(), true))
    }

    /// The product of two chain complexes.
    ///
    /// Parameters
    /// ----------
    /// other : ChainComplex
    ///     The second factor.
    ///
    /// Returns
    /// -------
    /// ChainComplex
    ///     Cells are pairs of cells; the boundary is that of Leibniz.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> circle = coface.ChainComplex.from_boundaries([[[0]]])
    /// >>> (circle * circle).homology()
    /// Homology(Z, Z^2, Z)
    fn product(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        let other = other.get();
        run(py, None, || ProductComplex::new(&self.complex, &other.complex))
            .map(|product| Self::bare(product.into_complex()))
    }

    fn __mul__(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        self.product(py, other)
    }

    /// Both complexes side by side; also ``+``.
    fn direct_sum(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        let other = other.get();
        run(py, None, || self.complex.direct_sum(&other.complex)).map(Self::bare)
    }

    fn __add__(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        self.direct_sum(py, other)
    }

    /// The model that it was made of, whose vertices name its cells; ``None`` where cells are numbers only.
    #[getter]
    fn source(&self) -> Option<Model> {
        self.naming.model()
    }

    /// The complex as a model, for files.
    fn model(&self) -> Model {
        Model::of(io::Model::from_structure(Structure::Chains(self.complex.as_ref().clone())))
    }

    fn __len__(&self) -> usize {
        self.complex.f_vector().iter().sum()
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| {
            Arc::ptr_eq(&self.complex, &other.get().complex) || self.complex == other.get().complex
        })
    }

    fn __hash__(&self) -> isize {
        let counts = self.complex.f_vector().iter();
        counts.fold(31, |sum, &count| sum.wrapping_mul(1_000_003).wrapping_add(count as isize))
    }

    fn __repr__(&self) -> String {
        format!("ChainComplex(cells {:?})", self.complex.f_vector())
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        if let (Names::Source(source), None, 0) = (&self.naming.names, &self.naming.pair, self.naming.shift) {
            let model = Bound::new(py, Model { source: Arc::clone(source) })?;
            let rebuild = py.import("coface._coface")?.getattr("_chains")?;
            return Ok((rebuild, PyTuple::new(py, [model.into_any()])?));
        }
        if let (Names::Simplices(complex), 0) = (&self.naming.names, self.naming.shift) {
            let complex = Bound::new(py, crate::complex::Complex::of(complex.thaw()))?;
            let rebuild = py.import("coface._coface")?.getattr("_chains")?;
            return Ok((rebuild, PyTuple::new(py, [complex.into_any()])?));
        }
        let mut matrices = Vec::new();
        for matrix in self.complex.boundary_matrices() {
            matrices.push(owned_matrix(py, matrix.clone())?);
        }
        if let (Names::Given(names), None, 0) = (&self.naming.names, &self.naming.pair, self.naming.shift)
            && !matrices.is_empty()
        {
            let of_degree = |degree: usize| {
                let name = |cell| names.get(&(degree, cell)).cloned().unwrap_or(vec![cell as u32]);
                (0..self.complex.cell_count(degree)).map(name).collect::<Vec<_>>()
            };
            let lists: Vec<_> = (0..self.complex.degree_count()).map(of_degree).collect();
            let rebuild = py.import("coface._coface")?.getattr("_named_chains")?;
            let arguments: [Bound<'py, PyAny>; 2] =
                [matrices.into_pyobject(py)?.into_any(), lists.into_pyobject(py)?.into_any()];
            return Ok((rebuild, PyTuple::new(py, arguments)?));
        }
        if matrices.is_empty() {
            let rebuild = py.get_type::<Self>().getattr("of_points")?;
            return Ok((rebuild, PyTuple::new(py, [self.complex.cell_count(0)])?));
        }
        let rebuild = py.get_type::<Self>().getattr("from_boundaries")?;
        Ok((rebuild, PyTuple::new(py, [matrices])?))
    }
}

/// The chain complex of a model or a complex, for pickling.
#[pyfunction]
pub(crate) fn _chains<'py>(of: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyAny>> {
    of.call_method0("chain_complex")
}

/// The chain complex of boundary matrices whose cells are named by vertices: for each degree a list for each cell.
#[pyfunction]
pub(crate) fn _named_chains(
    py: Python<'_>,
    boundaries: &Bound<'_, PyAny>,
    names: Vec<Vec<Vec<u32>>>,
) -> PyResult<ChainComplex> {
    let mut made = ChainComplex::from_boundaries(py, boundaries)?;
    let of_degree = |(degree, cells): (usize, Vec<Vec<u32>>)| {
        cells.into_iter().enumerate().map(move |(cell, vertices)| ((degree, cell), vertices))
    };
    let given = names.into_iter().enumerate().flat_map(of_degree).collect();
    made.naming = Arc::new(Naming::of(Names::Given(Arc::new(given))));
    Ok(made)
}
