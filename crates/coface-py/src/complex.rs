//! Simplicial complexes.

use crate::arrays;
use crate::chain_complex::ChainComplex;
use crate::errors::{OrRaise, bound, invalid, required, whole, wrong_type};
use crate::memory::owned_matrix;
use crate::model::Model;
use crate::source::{Names, Naming};
use crate::work::run;
use coface::algebra::chains;
use coface::algebra::{CellId, RaggedArray};
use coface::complexes::Obstruction;
use coface::complexes::simplicial::{FrozenComplex, Purity, Simplex, SimplexSet, SimplicialComplex};
use coface::io;
use coface::io::Structure;
use coface::{Error, VertexId};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};
use std::sync::{Arc, OnceLock};

/// A simplicial complex: simplices by their vertices, closed under faces, of any dimension.
///
/// Vertices are any ids; simplices are listed in lexicographic order. Complexes do not change; what edits gives a new one.
///
/// Parameters
/// ----------
/// facets : array_like of int, optional
///     Simplices that make it up with their faces: an array of shape (m, k), a list of lists, or ``(flat, offsets)``.
///
/// Examples
/// --------
/// >>> import coface
/// >>> strip = coface.Complex([[0, 1, 2], [1, 2, 3]])
/// >>> strip
/// Complex(f-vector (4, 5, 2))
/// >>> [1, 2] in strip, [0, 3] in strip
/// (True, False)
/// >>> strip.link([1]).simplices(1)
/// array([[0, 2],
///        [2, 3]])
#[pyclass(frozen, module = "coface", name = "Complex")]
pub(crate) struct Complex {
    pub(crate) tree: Arc<SimplicialComplex>,
    frozen: OnceLock<Arc<FrozenComplex>>,
    chains: OnceLock<Arc<chains::ChainComplex>>,
}

impl Complex {
    pub(crate) fn of(complex: SimplicialComplex) -> Self {
        Self { tree: Arc::new(complex), frozen: OnceLock::new(), chains: OnceLock::new() }
    }

    pub(crate) fn frozen(&self) -> &Arc<FrozenComplex> {
        self.frozen.get_or_init(|| Arc::new(self.tree.freeze()))
    }

    pub(crate) fn chains(&self) -> Result<&Arc<chains::ChainComplex>, Error> {
        if let Some(chains) = self.chains.get() {
            return Ok(chains);
        }
        let chains = Arc::new(self.frozen().chain_complex()?);
        Ok(self.chains.get_or_init(|| chains))
    }

    /// The facets as a model.
    pub(crate) fn to_model(&self) -> io::Model {
        let facets = self.tree.facets();
        let facets = RaggedArray::from_lists(facets.iter().map(Simplex::numbers));
        io::Model::from_structure(Structure::Facets(facets))
    }

    fn set(&self, py: Python<'_>, simplices: Option<&Bound<'_, PyAny>>) -> PyResult<SimplexSet> {
        match simplices {
            None => Ok(SimplexSet::from(&*self.tree)),
            Some(simplices) => simplex_set(py, simplices),
        }
    }
}

/// One simplex, `[0, 1]`, or several, `[[0, 1], [3]]`; a set; a complex.
pub(crate) fn simplex_set(py: Python<'_>, value: &Bound<'_, PyAny>) -> PyResult<SimplexSet> {
    if let Ok(set) = value.cast::<Simplices>() {
        return Ok(set.get().set.clone());
    }
    if let Ok(complex) = value.cast::<Complex>() {
        return Ok(SimplexSet::from(&*complex.get().tree));
    }
    if value.hasattr("__index__")? && !value.hasattr("__len__")? {
        return Ok(SimplexSet::from(Simplex::from([arrays::id(value, "simplices")?])));
    }
    let wrong = |_| {
        wrong_type(
            py,
            format!("simplices is {value}"),
            "give vertices, [0, 1], or lists of them, [[0, 1], [3]]",
        )
    };
    let is_one = match value.try_iter().map_err(wrong)?.next() {
        None => return Ok(SimplexSet::new()),
        Some(first) => {
            let first = first?;
            first.hasattr("__index__")? && !first.hasattr("__len__")?
                || first.hasattr("ndim")? && first.getattr("ndim")?.extract::<usize>()? == 0
        }
    };
    if is_one {
        let simplex = Simplex::from_numbers(&arrays::ids(value, "simplices")?).or_raise(py)?;
        return Ok(SimplexSet::from(simplex));
    }
    let lists = arrays::lists(value, "simplices")?;
    let simplices: Vec<Simplex> =
        lists.iter().map(Simplex::from_numbers).collect::<Result<_, _>>().or_raise(py)?;
    Ok(simplices.into_iter().collect())
}

/// Simplices of a dimension as an array of shape (m, k + 1).
fn rows<'a, 'py>(
    py: Python<'py>,
    simplices: impl Iterator<Item = &'a [u32]>,
    dimension: usize,
) -> PyResult<Bound<'py, PyAny>> {
    arrays::from_lists(py, simplices, Some(dimension + 1))
}

fn f_vector_of<'py>(py: Python<'py>, counts: &[usize]) -> PyResult<Bound<'py, PyTuple>> {
    PyTuple::new(py, counts)
}

fn words(counts: &[usize]) -> String {
    match counts {
        [one] => format!("({one},)"),
        _ => format!("({})", counts.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")),
    }
}

#[pymethods]
impl Complex {
    #[new]
    #[pyo3(signature = (*arguments, **options), text_signature = "(facets=None, *, progress=None)")]
    fn new(
        py: Python<'_>,
        arguments: &Bound<'_, PyTuple>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let [facets, progress] = bound("Complex", ["facets", "progress"], 1, arguments, options)?;
        let progress = progress.as_ref();
        let Some(facets) = facets else { return Ok(Self::of(SimplicialComplex::new())) };
        if let Ok(complex) = facets.cast::<Self>() {
            return Ok(Self::of(complex.get().tree.as_ref().clone()));
        }
        if let Ok(model) = facets.cast::<Model>() {
            let source = Arc::clone(&model.get().source);
            return run(py, progress, || coface::answers::simplicial_complex(&source.model)).map(Self::of);
        }
        let facets = match facets.cast::<Simplices>() {
            Ok(set) => RaggedArray::from_lists(set.get().set.iter().map(Simplex::numbers)),
            Err(_) => arrays::lists(&facets, "facets")?,
        };
        run(py, progress, || SimplicialComplex::from_facets(facets.iter())).map(Self::of)
    }

    /// The numbers of simplices of the dimensions 0, 1, ...
    #[getter]
    fn f_vector<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        f_vector_of(py, &self.tree.f_vector())
    }

    /// The highest dimension; ``None`` of the empty complex.
    #[getter]
    fn dimension(&self) -> Option<usize> {
        self.tree.dimension()
    }

    /// The alternating sum of the numbers of simplices.
    #[getter]
    fn euler_characteristic(&self) -> i64 {
        self.tree.euler_characteristic()
    }

    /// The vertices, rising: ``int64``.
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        arrays::id_array(py, self.tree.vertices().map(|vertex| vertex.to_u32()))
    }

    /// The simplices of a dimension, in lexicographic order.
    ///
    /// Parameters
    /// ----------
    /// dimension : int
    ///     The dimension k.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray
    ///     ``int64``, shape (m, k + 1); row i is cell i of the chain complex.
    fn simplices<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = whole)] dimension: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        let frozen = self.frozen();
        if frozen.dimension().is_none_or(|top| dimension > top) {
            return rows(py, std::iter::empty(), dimension);
        }
        let flat = frozen.flat(dimension).iter().map(|&vertex| i64::from(vertex)).collect();
        Ok(arrays::grid(py, flat, dimension + 1)?.into_any())
    }

    /// The simplices that are no faces of others, as a list of arrays by dimension.
    ///
    /// Returns
    /// -------
    /// list of numpy.ndarray
    ///     Those of dimension k at place k, shape (m, k + 1).
    fn facets<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let facets = self.tree.facets();
        let degrees = self.tree.dimension().map_or(0, |dimension| dimension + 1);
        let of = |k| facets.iter().filter(move |facet| facet.dimension() == k).map(Simplex::numbers);
        (0..degrees).map(|k| rows(py, of(k), k)).collect()
    }

    /// The place of a simplex among those of its dimension; ``None`` if it is not there.
    fn index(&self, py: Python<'_>, simplex: &Bound<'_, PyAny>) -> PyResult<Option<usize>> {
        let simplex = Simplex::from_numbers(&arrays::ids(simplex, "the simplex")?).or_raise(py)?;
        Ok(self.frozen().index_of(simplex.numbers()))
    }

    /// The simplices that have one of these as a face.
    ///
    /// Parameters
    /// ----------
    /// of : array_like of int
    ///     One simplex, ``[0, 1]``, or several, ``[[0, 1], [3]]``.
    ///
    /// Returns
    /// -------
    /// Simplices
    ///     The star; it need not be closed.
    ///
    /// Raises
    /// ------
    /// NotInComplexError
    ///     If one is not there; ``.cells`` has it.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> coface.Complex([[0, 1, 2]]).star([0]).f_vector
    /// (1, 2, 1)
    fn star(&self, py: Python<'_>, of: &Bound<'_, PyAny>) -> PyResult<Simplices> {
        let set = simplex_set(py, of)?;
        run(py, None, || self.tree.star(set)).map(Simplices::of)
    }

    /// The simplices of the star with all their faces.
    fn closed_star(&self, py: Python<'_>, of: &Bound<'_, PyAny>) -> PyResult<Self> {
        let set = simplex_set(py, of)?;
        run(py, None, || self.tree.star(set)?.closure().to_complex()).map(Self::of)
    }

    /// The simplices with all their faces: the smallest complex that holds them.
    fn closure(&self, py: Python<'_>, of: &Bound<'_, PyAny>) -> PyResult<Self> {
        let set = simplex_set(py, of)?;
        run(py, None, || self.tree.closure(set)).map(Self::of)
    }

    /// The closure of the star without the star of the closure.
    ///
    /// Parameters
    /// ----------
    /// of : array_like of int
    ///     One simplex or several.
    ///
    /// Returns
    /// -------
    /// Complex
    ///     The link; of a vertex of a closed surface a cycle.
    fn link(&self, py: Python<'_>, of: &Bound<'_, PyAny>) -> PyResult<Self> {
        let set = simplex_set(py, of)?;
        run(py, None, || self.tree.link(set)).map(Self::of)
    }

    /// The complex of the facets that lie in just one simplex of the highest dimension.
    ///
    /// Parameters
    /// ----------
    /// of : array_like of int, optional
    ///     A pure subcomplex instead of the whole.
    ///
    /// Returns
    /// -------
    /// Complex
    ///     The boundary.
    ///
    /// Raises
    /// ------
    /// NotPureError
    ///     If the simplices are not those of a pure complex.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> coface.Complex([[0, 1, 2], [1, 2, 3]]).boundary_complex().simplices(1).tolist()
    /// [[0, 1], [0, 2], [1, 3], [2, 3]]
    #[pyo3(signature = (of=None))]
    fn boundary_complex(&self, py: Python<'_>, of: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let set = self.set(py, of)?;
        run(py, None, || self.tree.boundary_complex(set)).map(Self::of)
    }

    /// The simplices that are not in the boundary.
    #[pyo3(signature = (of=None))]
    fn interior(&self, py: Python<'_>, of: Option<&Bound<'_, PyAny>>) -> PyResult<Simplices> {
        let set = self.set(py, of)?;
        run(py, None, || self.tree.interior(set)).map(Simplices::of)
    }

    /// The simplices of dimension ``k`` and lower.
    fn skeleton(&self, py: Python<'_>, #[pyo3(from_py_with = whole)] k: usize) -> PyResult<Self> {
        run(py, None, || self.tree.skeleton(k)).map(Self::of)
    }

    /// The simplices all of whose vertices are among these.
    fn induced(&self, py: Python<'_>, vertices: &Bound<'_, PyAny>) -> PyResult<Self> {
        let vertices = arrays::ids(vertices, "vertices")?;
        let vertices = vertices.into_iter().map(|vertex| VertexId::new(vertex as usize));
        self.tree.induced_subcomplex(vertices).or_raise(py).map(Self::of)
    }

    /// The simplices of both complexes; also ``|``.
    fn union(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        let other = other.get();
        run(py, None, || {
            let mut union = self.tree.as_ref().clone();
            union.extend(other.tree.facets().iter().map(Simplex::numbers))?;
            Ok(union)
        })
        .map(Self::of)
    }

    /// The simplices that both complexes have; also ``&``.
    fn intersection(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        let other = other.get();
        run(py, None, || {
            SimplexSet::from(&*self.tree).intersection(&SimplexSet::from(&*other.tree)).to_complex()
        })
        .map(Self::of)
    }

    /// The simplices of this complex that the other does not have; also ``-``. They need not be a complex.
    fn difference(&self, py: Python<'_>, other: &Bound<'_, PyAny>) -> PyResult<Simplices> {
        let other = simplex_set(py, other)?;
        run(py, None, || Ok(SimplexSet::from(&*self.tree).difference(&other))).map(Simplices::of)
    }

    /// Whether every simplex is in the other complex; also ``<=``.
    fn is_subcomplex(&self, of: &Bound<'_, Self>) -> bool {
        of.get().tree.has_subcomplex(&SimplexSet::from(&*self.tree))
    }

    fn __or__(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        self.union(py, other)
    }

    fn __and__(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        self.intersection(py, other)
    }

    fn __sub__(&self, py: Python<'_>, other: &Bound<'_, PyAny>) -> PyResult<Simplices> {
        self.difference(py, other)
    }

    /// The vertex sets of the connected components.
    fn components<'py>(&self, py: Python<'py>) -> Vec<Bound<'py, PyArray1<i64>>> {
        let components = self.tree.components().members().into_iter();
        components.map(|part| arrays::id_array(py, part.into_iter().map(|vertex| vertex.to_u32()))).collect()
    }

    /// The facets of dimension d, joined where they share a facet: one array of shape (m, d + 1) for each strong component.
    fn strong_components<'py>(&self, py: Python<'py>) -> PyResult<Vec<Bound<'py, PyAny>>> {
        let dimension = self.tree.dimension().unwrap_or(0);
        let components = self.tree.strong_components();
        components.iter().map(|part| rows(py, part.iter().map(Simplex::numbers), dimension)).collect()
    }

    /// Whether every simplex is a face of one of the highest dimension.
    ///
    /// Returns
    /// -------
    /// Verdict
    ///     ``True`` or ``False`` in conditions; ``.cells`` has a facet of lower dimension.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> verdict = coface.Complex([[0, 1, 2], [2, 3]]).is_pure()
    /// >>> bool(verdict), verdict.cells
    /// (False, [[2, 3]])
    fn is_pure(&self) -> PyVerdict {
        match self.tree.purity() {
            Purity::NotPure(simplex) => PyVerdict {
                answer: Some(false),
                kind: Some("facet".to_owned()),
                message: Some(format!("{:?} is a facet of lower dimension", simplex.numbers())),
                cells: vec![simplex.numbers().to_vec()],
                closed: None,
            },
            _ => PyVerdict::yes(None),
        }
    }

    /// Whether every point has a neighborhood like space or half-space.
    ///
    /// Returns
    /// -------
    /// Verdict
    ///     ``True`` or ``False`` in conditions, where it could be decided; ``.cells`` has the simplices that show why not.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> verdict = coface.Complex([[0, 1, 2], [0, 1, 3], [0, 1, 4]]).is_manifold()
    /// >>> bool(verdict), verdict.kind, verdict.cells[0]
    /// (False, 'branching_ridge', [0, 1])
    #[pyo3(signature = (*, progress=None))]
    fn is_manifold(&self, py: Python<'_>, progress: Option<&Bound<'_, PyAny>>) -> PyResult<PyVerdict> {
        let verdict = run(py, progress, || Ok(self.frozen().manifold_verdict_with(self.chains()?)))?;
        Ok(match verdict.witness() {
            None => PyVerdict::yes(Some(verdict.is_closed())),
            Some(witness) => PyVerdict {
                answer: verdict.to_bool(),
                kind: Some(witness.fault().as_str().to_owned()),
                message: Some(witness.message().to_owned()),
                cells: witness.cells().iter().map(|simplex| simplex.numbers().to_vec()).collect(),
                closed: None,
            },
        })
    }

    /// Whether the simplices of the highest dimension can be oriented so that neighbors agree.
    ///
    /// Returns
    /// -------
    /// Verdict
    ///     ``True`` or ``False`` in conditions; if not, ``.cells`` is an odd cycle of facets, each the neighbor of the one before.
    ///
    /// Examples
    /// --------
    /// A Moebius band of five triangles:
    ///
    /// >>> import coface
    /// >>> band = coface.Complex([[i, (i + 1) % 5, (i + 2) % 5] for i in range(5)])
    /// >>> verdict = band.is_orientable()
    /// >>> bool(verdict), len(verdict.cells)
    /// (False, 5)
    #[pyo3(signature = (*, progress=None))]
    fn is_orientable(&self, py: Python<'_>, progress: Option<&Bound<'_, PyAny>>) -> PyResult<PyVerdict> {
        let found = run(py, progress, || Ok(coface::complexes::simplicial::orientability(self.chains()?)))?;
        let frozen = self.frozen();
        let top = frozen.dimension().unwrap_or(0);
        let name = |dimension: usize, cell: CellId| frozen.numbers(dimension, cell.index()).to_vec();
        let because = |answer: Option<bool>, kind: &str, message: String, cells: Vec<Vec<u32>>| PyVerdict {
            answer,
            kind: Some(kind.to_owned()),
            message: Some(message),
            cells,
            closed: None,
        };
        if let Some(cycle) = found.odd_cycle() {
            let message = format!("a closed chain of {} facets reverses orientation", cycle.cells().len());
            let cells = cycle.cells().iter().map(|&facet| name(top, facet)).collect();
            return Ok(because(Some(false), "odd_cycle", message, cells));
        }
        Ok(match found.obstruction() {
            None | Some(Obstruction::NoFacets) => PyVerdict::yes(None),
            Some(Obstruction::CrowdedFacet { facet, cells }) => {
                let message = format!("a ridge lies in {} facets", cells.len());
                let names = cells.iter().map(|&cell| name(top, cell));
                because(
                    None,
                    "branching_ridge",
                    message,
                    std::iter::once(name(top - 1, *facet)).chain(names).collect(),
                )
            }
            Some(&Obstruction::NotPure { dimension, cell }) => {
                let message = format!("a facet of dimension {dimension} is in no facet of dimension {top}");
                because(None, "not_pure", message, vec![name(dimension, cell)])
            }
            Some(_) => PyVerdict::unknown("undecided"),
        })
    }

    /// Signs of the simplices of the highest dimension that orient them coherently; ``None`` where there are none.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray or None
    ///     1 or -1 for each row of ``simplices(dimension)``: -1 reverses the order of its vertices.
    #[pyo3(signature = (*, progress=None))]
    fn orientation<'py>(
        &self,
        py: Python<'py>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<Option<Bound<'py, PyArray1<i64>>>> {
        let found = run(py, progress, || Ok(coface::complexes::simplicial::orientability(self.chains()?)))?;
        Ok((found.is_orientable() == Some(true)).then(|| {
            let frozen = self.frozen();
            let count = frozen.dimension().map_or(0, |top| frozen.simplex_count(top));
            let sign = |facet: usize| i64::from(found.sign(CellId::new(facet)).to_i32());
            PyArray1::from_vec(py, (0..count).map(sign).collect())
        }))
    }

    /// Both complexes side by side; vertices of the other get new numbers.
    fn disjoint_union(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        let other = other.get();
        run(py, None, || self.tree.disjoint_union(&other.tree)).map(|made| Self::of(made.into_complex()))
    }

    /// Both complexes with a vertex of one and a vertex of the other made one.
    fn wedge(&self, py: Python<'_>, at: u32, other: &Bound<'_, Self>, other_at: u32) -> PyResult<Self> {
        let (other, id) = (other.get(), |vertex: u32| VertexId::new(vertex as usize));
        run(py, None, || self.tree.wedge(id(at), &other.tree, id(other_at)))
            .map(|made| Self::of(made.into_complex()))
    }

    /// The simplices of both, and every simplex of one with every simplex of the other.
    fn join(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        let other = other.get();
        run(py, None, || self.tree.join(&other.tree)).map(|made| Self::of(made.into_complex()))
    }

    /// Every simplex joined with one new vertex.
    ///
    /// Returns
    /// -------
    /// complex : Complex
    ///     The cone.
    /// apex : int
    ///     The new vertex.
    fn cone(&self, py: Python<'_>) -> PyResult<(Self, u32)> {
        run(py, None, || self.tree.cone()).map(|(cone, apex)| (Self::of(cone), apex.to_u32()))
    }

    /// Two cones on the complex.
    ///
    /// Returns
    /// -------
    /// complex : Complex
    ///     The suspension.
    /// apexes : list of int
    ///     The two new vertices.
    fn suspension(&self, py: Python<'_>) -> PyResult<(Self, [u32; 2])> {
        run(py, None, || self.tree.suspension())
            .map(|(made, apexes)| (Self::of(made), apexes.map(|apex| apex.to_u32())))
    }

    /// Both complexes without a facet each, glued along the rims.
    fn connected_sum(
        &self,
        py: Python<'_>,
        facet: &Bound<'_, PyAny>,
        other: &Bound<'_, Self>,
        other_facet: &Bound<'_, PyAny>,
    ) -> PyResult<Self> {
        let of = |value: &Bound<'_, PyAny>| -> PyResult<Vec<VertexId>> {
            let ids = arrays::ids(value, "the facet")?;
            Ok(ids.into_iter().map(|vertex| VertexId::new(vertex as usize)).collect())
        };
        let (facet, other_facet, other) = (of(facet)?, of(other_facet)?, other.get());
        run(py, None, || self.tree.connected_sum(&facet, &other.tree, &other_facet))
            .map(|made| Self::of(made.into_complex()))
    }

    /// The barycentric subdivision.
    ///
    /// Returns
    /// -------
    /// complex : Complex
    ///     A vertex for each simplex.
    /// simplices : list of list of int
    ///     The simplex of each vertex.
    fn barycentric_subdivision(&self, py: Python<'_>) -> PyResult<(Self, Vec<Vec<u32>>)> {
        run(py, None, || self.tree.barycentric_subdivision()).map(|(made, simplices)| {
            (Self::of(made), simplices.iter().map(|simplex| simplex.numbers().to_vec()).collect())
        })
    }

    /// The product, its cells cut into simplices along staircases; also ``*``.
    ///
    /// Returns
    /// -------
    /// complex : Complex
    ///     The product.
    /// vertices : numpy.ndarray of shape (n, 2)
    ///     The pair of vertices that each vertex is.
    fn product<'py>(&self, py: Python<'py>, other: &Bound<'py, Self>) -> PyResult<(Self, Bound<'py, PyAny>)> {
        let other = other.get();
        let (made, pairs) = run(py, None, || self.tree.product(&other.tree))?;
        let flat = pairs.iter().flat_map(|(a, b)| [i64::from(a.to_u32()), i64::from(b.to_u32())]).collect();
        Ok((Self::of(made), arrays::grid(py, flat, 2)?.into_any()))
    }

    fn __mul__(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        let other = other.get();
        run(py, None, || self.tree.product(&other.tree)).map(|(made, _)| Self::of(made))
    }

    /// The chain complex; cell i of degree k is row i of ``simplices(k)``.
    #[pyo3(signature = (*, progress=None))]
    fn chain_complex(&self, py: Python<'_>, progress: Option<&Bound<'_, PyAny>>) -> PyResult<ChainComplex> {
        let chains = run(py, progress, || self.chains().map(Arc::clone))?;
        Ok(ChainComplex::new(chains, Naming::of(Names::Simplices(Arc::clone(self.frozen())))))
    }

    /// The facets as a model, for files and questions about models.
    fn model(&self, py: Python<'_>) -> PyResult<Model> {
        run(py, None, || Ok(self.to_model())).map(Model::of)
    }

    /// Which simplices of dimension k - 1 are facets of which of dimension k.
    ///
    /// Parameters
    /// ----------
    /// dimension : int
    ///     The dimension k.
    /// signed : bool
    ///     Whether entries are 1 and -1, as in a boundary matrix, or 1.
    ///
    /// Returns
    /// -------
    /// scipy.sparse.csc_array
    ///     One row for each (k - 1)-simplex, one column for each k-simplex.
    #[pyo3(signature = (dimension, *, signed=false))]
    fn incidence<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = whole)] dimension: usize,
        signed: bool,
    ) -> PyResult<Bound<'py, PyAny>> {
        let frozen = self.frozen();
        let matrix = run(py, None, || match signed {
            true => frozen.incidence_matrix(dimension),
            false => frozen.unsigned_incidence_matrix(dimension),
        })?;
        owned_matrix(py, matrix)
    }

    fn __contains__(&self, py: Python<'_>, simplex: &Bound<'_, PyAny>) -> PyResult<bool> {
        let numbers = arrays::ids(simplex, "the simplex")?;
        if numbers.is_empty() {
            return Ok(false);
        }
        Ok(self.tree.contains(&Simplex::from_numbers(&numbers).or_raise(py)?))
    }

    fn __len__(&self) -> usize {
        self.tree.len()
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let simplices: Vec<Vec<u32>> = self.tree.iter().map(|simplex| simplex.numbers().to_vec()).collect();
        simplices.into_pyobject(py)?.call_method0("__iter__")
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| {
            Arc::ptr_eq(&self.tree, &other.get().tree) || self.frozen() == other.get().frozen()
        })
    }

    fn __hash__(&self) -> isize {
        let counts = self.tree.f_vector();
        counts.iter().fold(19_isize, |sum, &count| sum.wrapping_mul(1_000_003).wrapping_add(count as isize))
    }

    fn __le__(&self, other: &Bound<'_, Self>) -> bool {
        self.is_subcomplex(other)
    }

    fn __repr__(&self) -> String {
        format!("Complex(f-vector {})", words(&self.tree.f_vector()))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let facets = self.tree.facets();
        let (mut flat, mut offsets) = (Vec::new(), vec![0_i64]);
        for facet in &facets {
            flat.extend(facet.numbers().iter().map(|&vertex| i64::from(vertex)));
            offsets.push(flat.len() as i64);
        }
        let pair = PyTuple::new(py, [PyArray1::from_vec(py, flat), PyArray1::from_vec(py, offsets)])?;
        Ok((py.get_type::<Self>().into_any(), PyTuple::new(py, [pair])?))
    }
}

/// A set of simplices that need not be closed under faces: a star, an interior, a selection.
///
/// Parameters
/// ----------
/// simplices : array_like of int
///     One simplex, ``[0, 1]``, or several, ``[[0, 1], [3]]``.
///
/// Examples
/// --------
/// >>> import coface
/// >>> open_triangle = coface.Simplices([0, 1, 2])
/// >>> open_triangle.is_complex
/// False
/// >>> open_triangle.closure().f_vector
/// (3, 3, 1)
#[pyclass(frozen, module = "coface", name = "Simplices")]
pub(crate) struct Simplices {
    pub(crate) set: SimplexSet,
}

impl Simplices {
    pub(crate) fn of(set: SimplexSet) -> Self {
        Self { set }
    }
}

#[pymethods]
impl Simplices {
    #[new]
    #[pyo3(signature = (*arguments, **options), text_signature = "(simplices)")]
    fn new(
        py: Python<'_>,
        arguments: &Bound<'_, PyTuple>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let [simplices] = bound("Simplices", ["simplices"], 1, arguments, options)?;
        simplex_set(py, &required(py, "Simplices", "simplices", simplices)?).map(Self::of)
    }

    /// The numbers of simplices of the dimensions 0, 1, ...
    #[getter]
    fn f_vector<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        f_vector_of(py, &self.set.f_vector())
    }

    /// The highest dimension; ``None`` of the empty set.
    #[getter]
    fn dimension(&self) -> Option<usize> {
        self.set.dimension()
    }

    /// The vertices of all members, rising.
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        arrays::id_array(py, self.set.vertices().into_iter().map(|vertex| vertex.to_u32()))
    }

    /// Whether all faces of members are members.
    #[getter]
    fn is_complex(&self) -> bool {
        self.set.is_complex()
    }

    /// The members of a dimension: ``int64``, shape (m, k + 1).
    fn simplices<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = whole)] dimension: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        let simplices = match self.set.dimension() {
            Some(top) if dimension <= top => self.set.simplices(dimension),
            _ => &[],
        };
        rows(py, simplices.iter().map(Simplex::numbers), dimension)
    }

    /// The members with all their faces.
    fn closure(&self, py: Python<'_>) -> PyResult<Complex> {
        run(py, None, || self.set.closure().to_complex()).map(Complex::of)
    }

    /// The members as a complex.
    ///
    /// Raises
    /// ------
    /// NotAComplexError
    ///     If a face is missing.
    fn complex(&self, py: Python<'_>) -> PyResult<Complex> {
        self.set.to_complex().or_raise(py).map(Complex::of)
    }

    /// The faces of members that are no members.
    fn missing_faces(&self) -> Self {
        Self::of(self.set.missing_faces())
    }

    /// The members that are no faces of others.
    fn maximal(&self) -> Self {
        Self::of(self.set.maximal_simplices())
    }

    /// The members of dimension ``k`` and lower.
    fn skeleton(&self, #[pyo3(from_py_with = whole)] k: usize) -> Self {
        Self::of(self.set.skeleton(k))
    }

    /// The members as a model; facets only if ``as_facets``.
    #[pyo3(signature = (source, *, as_facets=false))]
    fn model(&self, py: Python<'_>, source: &Bound<'_, Model>, as_facets: bool) -> PyResult<Model> {
        let source = &source.get().source;
        run(py, None, || coface::answers::model_of_simplices(&self.set, &source.model, as_facets))
            .map(Model::of)
    }

    fn __or__(&self, py: Python<'_>, other: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(Self::of(self.set.union(&simplex_set(py, other)?)))
    }

    fn __and__(&self, py: Python<'_>, other: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(Self::of(self.set.intersection(&simplex_set(py, other)?)))
    }

    fn __sub__(&self, py: Python<'_>, other: &Bound<'_, PyAny>) -> PyResult<Self> {
        Ok(Self::of(self.set.difference(&simplex_set(py, other)?)))
    }

    fn __le__(&self, other: &Bound<'_, Self>) -> bool {
        self.set.is_subset(&other.get().set)
    }

    fn __contains__(&self, py: Python<'_>, simplex: &Bound<'_, PyAny>) -> PyResult<bool> {
        let numbers = arrays::ids(simplex, "the simplex")?;
        Ok(!numbers.is_empty() && self.set.contains(&Simplex::from_numbers(&numbers).or_raise(py)?))
    }

    fn __len__(&self) -> usize {
        self.set.len()
    }

    fn __iter__<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let simplices: Vec<Vec<u32>> = self.set.iter().map(|simplex| simplex.numbers().to_vec()).collect();
        simplices.into_pyobject(py)?.call_method0("__iter__")
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| self.set == other.get().set)
    }

    fn __hash__(&self) -> isize {
        self.set
            .f_vector()
            .iter()
            .fold(23, |sum, &count| sum.wrapping_mul(1_000_003).wrapping_add(count as isize))
    }

    fn __repr__(&self) -> String {
        format!("Simplices(f-vector {})", words(&self.set.f_vector()))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let simplices: Vec<Vec<u32>> = self.set.iter().map(|simplex| simplex.numbers().to_vec()).collect();
        Ok((py.get_type::<Self>().into_any(), PyTuple::new(py, [simplices])?))
    }
}

/// An answer with what shows that it is right: true, false, or unknown.
///
/// In conditions it is its answer; ``bool`` of an unknown one raises.
#[pyclass(frozen, module = "coface", name = "Verdict")]
pub(crate) struct PyVerdict {
    pub(crate) answer: Option<bool>,
    pub(crate) kind: Option<String>,
    pub(crate) message: Option<String>,
    pub(crate) cells: Vec<Vec<u32>>,
    pub(crate) closed: Option<bool>,
}

impl PyVerdict {
    pub(crate) fn yes(closed: Option<bool>) -> Self {
        Self { answer: Some(true), kind: None, message: None, cells: Vec::new(), closed }
    }

    pub(crate) fn unknown(message: &str) -> Self {
        Self { answer: None, kind: None, message: Some(message.to_owned()), cells: Vec::new(), closed: None }
    }
}

#[pymethods]
impl PyVerdict {
    /// ``True``, ``False``, or ``None`` where it could not be decided or the notion does not apply.
    #[getter]
    fn answer(&self) -> Option<bool> {
        self.answer
    }

    /// What sort of thing is in the way.
    #[getter]
    fn kind(&self) -> Option<&str> {
        self.kind.as_deref()
    }

    /// The same in words.
    #[getter]
    fn message(&self) -> Option<&str> {
        self.message.as_deref()
    }

    /// The cells that show it, each by its vertices.
    #[getter]
    fn cells(&self) -> Vec<Vec<u32>> {
        self.cells.clone()
    }

    /// Whether a manifold has no boundary.
    #[getter]
    fn closed(&self) -> Option<bool> {
        self.closed
    }

    fn __bool__(&self, py: Python<'_>) -> PyResult<bool> {
        self.answer.ok_or_else(|| {
            let why = self.message.as_deref().unwrap_or("it could not be decided");
            invalid(py, format!("there is no yes or no: {why}"), "look at .answer, which is None")
        })
    }

    fn __repr__(&self) -> String {
        let answer = match self.answer {
            Some(true) => "yes",
            Some(false) => "no",
            None => "unknown",
        };
        match &self.message {
            Some(message) => format!("Verdict({answer}: {message})"),
            None => format!("Verdict({answer})"),
        }
    }

    /// The verdict as a dictionary.
    fn to_dict<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        dict.set_item("answer", self.answer)?;
        dict.set_item("kind", self.kind.as_deref())?;
        dict.set_item("message", self.message.as_deref())?;
        dict.set_item("cells", &self.cells)?;
        dict.set_item("closed", self.closed)?;
        Ok(dict)
    }

    /// The verdict that :meth:`to_dict` wrote.
    #[staticmethod]
    fn from_dict(verdict: &Bound<'_, PyAny>) -> PyResult<Self> {
        let py = verdict.py();
        let wrong =
            |_| wrong_type(py, format!("{verdict} is no verdict"), "give what Verdict.to_dict() gave");
        let part = |name: &str| verdict.get_item(name).map_err(wrong);
        Ok(Self {
            answer: part("answer")?.extract().map_err(wrong)?,
            kind: part("kind")?.extract().map_err(wrong)?,
            message: part("message")?.extract().map_err(wrong)?,
            cells: part("cells")?.extract().map_err(wrong)?,
            closed: part("closed")?.extract().map_err(wrong)?,
        })
    }
}
