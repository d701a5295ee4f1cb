//! Questions about one complex or two: classes of cycles, products, forms, exact sequences, maps, harmonic cochains.

use crate::arrays;
use crate::chain_complex::{ChainComplex, ring};
use crate::errors::{OrRaise, invalid, whole, whole_or_none};
use crate::given::source_of;
use crate::homology::Homology;
use crate::work::run;
use coface::algebra::chains::{AcyclicMatching, Chain as Cycle, Cochain};
use coface::algebra::{Integer, smith_form};
use coface::answers::{OrderedSimplices, Pair, Producer};
use coface::complexes::simplicial::{FrozenComplex, SimplicialMap};
use coface::topology::{
    Bounding, CochainAlgebra, Cocycle, Coefficients, Exactness, HodgeSpace, HomologyBasis, HomologyMap,
    LongExactSequence, MetricComplex, MiddlePairing, cup_product_table, exactness, exactness_within,
    induced_maps, intersection_form as form_of, laplacian_matrix,
};
use coface::{CellId, Error};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

/// Whether a chain bounds, or what shows that it does not.
struct Class {
    degree: usize,
    coefficients: Vec<Integer>,
    orders: Vec<Option<Integer>>,
    multiple: Option<Integer>,
    bounding: Option<Vec<(CellId, Integer)>>,
    cocycle: Option<(Vec<(CellId, Integer)>, Integer)>,
}

fn order_list<'py>(py: Python<'py>, orders: &[Option<Integer>]) -> PyResult<Bound<'py, PyAny>> {
    let orders: Vec<Integer> = orders.iter().map(|order| order.clone().unwrap_or_default()).collect();
    arrays::integer_array(py, &orders)?.call_method0("tolist")
}

/// The classes of cycles in integral homology, and whether they bound.
///
/// Parameters
/// ----------
/// complex : ChainComplex
///     The complex.
/// cycles : sequence
///     Cycles as :meth:`ChainComplex.chain` takes them.
/// degree : int, optional
///     Their degree, where they do not say it.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// list of dict
///     ``class``: coefficients in the generators; ``orders`` of these, 0 for infinite; ``bounds``; ``multiple``: the least that bounds;
///     ``bounding``: a chain whose boundary is that multiple; ``cocycle`` and ``value``: what shows that no multiple bounds.
///
/// Examples
/// --------
/// >>> import coface
/// >>> ring = coface.Complex([[0, 1], [1, 2], [0, 2]]).chain_complex()
/// >>> found, = coface._coface.classes(ring, [[(2, [0, 1]), (2, [1, 2]), (-2, [0, 2])]])
/// >>> found["class"], found["bounds"], abs(found["value"])
/// ([2], False, 2)
#[pyfunction]
#[pyo3(signature = (complex, cycles, *, degree=None, progress=None))]
pub(crate) fn classes<'py>(
    py: Python<'py>,
    complex: &Bound<'py, ChainComplex>,
    cycles: &Bound<'py, PyAny>,
    #[pyo3(from_py_with = whole_or_none)] degree: Option<usize>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Vec<Bound<'py, PyDict>>> {
    let complex = complex.get();
    let mut given = Vec::new();
    for cycle in cycles.try_iter()? {
        given.push(complex.terms_of(&cycle?, degree)?);
    }
    let found = run(py, progress, || {
        let basis = HomologyBasis::new(&complex.complex);
        let mut found = Vec::new();
        for (degree, terms) in given {
            let cycle = Cycle::new(&complex.complex, degree, terms)?;
            let class = basis.class_of(&cycle)?;
            let mut answer = Class {
                degree,
                coefficients: class.coefficients().to_vec(),
                orders: basis.orders(degree),
                multiple: class.order(),
                bounding: None,
                cocycle: None,
            };
            match basis.bounding(&cycle)? {
                Bounding::Bounds(chain) | Bounding::MultipleBounds { chain, .. } => {
                    answer.bounding = Some(chain.terms().to_vec());
                }
                Bounding::Never { cocycle, value } => {
                    answer.cocycle = Some((cocycle.terms().to_vec(), value));
                }
                _ => {}
            }
            found.push(answer);
        }
        Ok(found)
    })?;
    let dict = |class: Class| {
        let dict = PyDict::new(py);
        dict.set_item("degree", class.degree)?;
        dict.set_item("class", arrays::integer_array(py, &class.coefficients)?.call_method0("tolist")?)?;
        dict.set_item("orders", order_list(py, &class.orders)?)?;
        dict.set_item("bounds", class.coefficients.iter().all(Integer::is_zero))?;
        let multiple = class.multiple.map(|multiple| arrays::integer(py, &multiple)).transpose()?;
        dict.set_item("multiple", multiple)?;
        let bounding = class.bounding.map(|terms| complex.chain_of(class.degree + 1, terms, false));
        dict.set_item("bounding", bounding)?;
        let (cocycle, value) = match class.cocycle {
            Some((terms, value)) => {
                (Some(complex.chain_of(class.degree, terms, true)), Some(arrays::integer(py, &value)?))
            }
            None => (None, None),
        };
        dict.set_item("cocycle", cocycle)?;
        dict.set_item("value", value)?;
        Ok(dict)
    };
    found.into_iter().map(dict).collect()
}

/// Harmonic cochains of a degree, dual to the free generators of homology.
///
/// Parameters
/// ----------
/// complex : ChainComplex
///     The complex.
/// degree : int
///     The degree.
/// weights : sequence of array_like, optional
///     For each degree a positive weight for each cell; 1 if left out.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// numpy.ndarray
///     ``float64``, shape (rank, cells): one row for each cochain.
#[pyfunction]
#[pyo3(signature = (complex, degree, *, weights=None, progress=None))]
pub(crate) fn harmonic<'py>(
    py: Python<'py>,
    complex: &Bound<'py, ChainComplex>,
    #[pyo3(from_py_with = whole)] degree: usize,
    weights: Option<&Bound<'py, PyAny>>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let complex = complex.get();
    let weights = weights_of(weights)?;
    let degree = complex.inner(degree);
    let count = complex.complex.cell_count(degree);
    let rows = run(py, progress, || {
        let metric = metric(complex, weights)?;
        let basis = HomologyBasis::new(&complex.complex);
        let found = metric.harmonic_cochains(degree, &basis)?;
        Ok(found.iter().map(|harmonic| dense(harmonic.cochain(), count)).collect::<Vec<_>>())
    })?;
    Ok(PyArray1::from_vec(py, rows.concat()).reshape([rows.len(), count])?.into_any())
}

fn weights_of(weights: Option<&Bound<'_, PyAny>>) -> PyResult<Option<Vec<Vec<f64>>>> {
    let Some(weights) = weights else { return Ok(None) };
    weights.try_iter()?.map(|list| arrays::finite(&list?, "weights")).collect::<PyResult<_>>().map(Some)
}

fn metric(complex: &ChainComplex, weights: Option<Vec<Vec<f64>>>) -> Result<MetricComplex<'_>, Error> {
    match weights {
        Some(weights) => MetricComplex::with_weights(&complex.complex, weights),
        None => Ok(MetricComplex::new(&complex.complex)),
    }
}

fn dense(cochain: &Cochain<f64>, count: usize) -> Vec<f64> {
    let mut values = vec![0.0; count];
    for (cell, value) in cochain.terms() {
        values[cell.index()] = *value;
    }
    values
}

/// The Hodge decomposition of a real cochain.
///
/// Parameters
/// ----------
/// complex : ChainComplex
///     The complex.
/// degree : int
///     The degree.
/// values : array_like
///     A value for each cell.
/// weights : sequence of array_like, optional
///     For each degree a positive weight for each cell; 1 if left out.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// exact, coexact, harmonic : numpy.ndarray
///     Orthogonal parts that add up to the cochain.
#[pyfunction]
#[pyo3(signature = (complex, degree, values, *, weights=None, progress=None))]
pub(crate) fn decompose<'py>(
    py: Python<'py>,
    complex: &Bound<'py, ChainComplex>,
    #[pyo3(from_py_with = whole)] degree: usize,
    values: &Bound<'py, PyAny>,
    weights: Option<&Bound<'py, PyAny>>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>, Bound<'py, PyArray1<f64>>)> {
    let complex = complex.get();
    let (values, weights) = (arrays::finite(values, "values")?, weights_of(weights)?);
    let degree = complex.inner(degree);
    let count = complex.complex.cell_count(degree);
    if values.len() != count {
        let message = format!("{} values for {count} cells", values.len());
        return Err(invalid(py, message, "give one for each cell of the degree"));
    }
    let [exact, coexact, harmonic] = run(py, progress, || {
        let metric = metric(complex, weights)?;
        let terms = values.into_iter().enumerate().map(|(cell, value)| (CellId::new(cell), value));
        let cochain = Cochain::new(&complex.complex, degree, terms)?;
        let parts = HodgeSpace::new(&metric, degree)?.decomposition(&cochain)?;
        Ok([parts.exact(), parts.coexact(), parts.harmonic()].map(|part| dense(part, count)))
    })?;
    Ok((PyArray1::from_vec(py, exact), PyArray1::from_vec(py, coexact), PyArray1::from_vec(py, harmonic)))
}

/// The combinatorial Laplacian of a degree: boundary times coboundary and coboundary times boundary.
///
/// Parameters
/// ----------
/// complex : ChainComplex
///     The complex.
/// degree : int
///     The degree.
///
/// Returns
/// -------
/// scipy.sparse.csc_array
///     Symmetric, with integer entries.
#[pyfunction]
#[pyo3(signature = (complex, degree, *, progress=None))]
pub(crate) fn laplacian<'py>(
    py: Python<'py>,
    complex: &Bound<'py, ChainComplex>,
    #[pyo3(from_py_with = whole)] degree: usize,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let complex = complex.get();
    let degree = complex.inner(degree);
    let matrix = run(py, progress, || laplacian_matrix(&complex.complex, degree))?;
    crate::memory::owned_matrix(py, matrix)
}

/// A discrete gradient field: cells matched with faces, and critical cells.
///
/// Parameters
/// ----------
/// complex : ChainComplex
///     The complex.
/// degree : int
///     The degree of the faces.
///
/// Returns
/// -------
/// critical : numpy.ndarray
///     The critical cells of the degree.
/// pairs : numpy.ndarray of shape (n, 2)
///     Faces of the degree and the cells of the next one that they are matched with.
#[pyfunction]
#[pyo3(signature = (complex, degree, *, progress=None))]
pub(crate) fn matching<'py>(
    py: Python<'py>,
    complex: &Bound<'py, ChainComplex>,
    #[pyo3(from_py_with = whole)] degree: usize,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Bound<'py, PyArray1<i64>>, Bound<'py, PyAny>)> {
    let complex = complex.get();
    let degree = complex.inner(degree);
    if degree >= complex.complex.degree_count() {
        return Err(invalid(py, format!("there are no cells of degree {degree}"), "look at .f_vector"));
    }
    let (critical, pairs) = run(py, progress, || {
        let matching = AcyclicMatching::new(&complex.complex);
        let pairs: Vec<i64> = match degree + 1 < complex.complex.degree_count() {
            true => {
                let pairs = matching.pairs(&complex.complex, degree + 1).iter();
                pairs.flat_map(|pair| [pair.face().index() as i64, pair.cell().index() as i64]).collect()
            }
            false => Vec::new(),
        };
        Ok((matching.critical_cells(degree).to_vec(), pairs))
    })?;
    Ok((arrays::id_array(py, critical), arrays::grid(py, pairs, 2)?.into_any()))
}

/// The diagonal of the Smith normal form of an integer matrix, each entry dividing the next.
///
/// Parameters
/// ----------
/// matrix : sparse array or array_like
///     Integers of 32 bits.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// list of int
///     The entries that are not zero.
///
/// Examples
/// --------
/// >>> import coface
/// >>> coface._coface.invariant_factors([[2, 4], [6, 8]])
/// [2, 4]
#[pyfunction]
#[pyo3(signature = (matrix, *, progress=None))]
pub(crate) fn invariant_factors<'py>(
    py: Python<'py>,
    matrix: &Bound<'py, PyAny>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Vec<Bound<'py, PyAny>>> {
    let matrix = arrays::to_matrix(matrix, "the matrix")?;
    let diagonal = run(py, progress, || Ok(smith_form(&matrix).diagonal().to_vec()))?;
    diagonal.iter().filter(|entry| !entry.is_zero()).map(|entry| arrays::integer(py, entry)).collect()
}

/// A cochain as ``(coefficient, vertices)``, cell by cell.
fn named<'py>(
    py: Python<'py>,
    simplices: &OrderedSimplices,
    cochain: &Cochain<Integer>,
) -> PyResult<Vec<(Bound<'py, PyAny>, Vec<u32>)>> {
    let term = |(cell, x): &(CellId, Integer)| {
        Ok((arrays::integer(py, x)?, simplices.name(cochain.degree(), *cell)))
    };
    cochain.terms().iter().map(term).collect()
}

/// Cup products of a basis of cohomology in degree p with one in degree q, in a basis of degree p + q.
///
/// Parameters
/// ----------
/// model : Model or Complex
///     Simplices, or a gluing table.
/// p, q : int
///     The degrees.
/// coefficients : str or int
///     ``"z"``, ``"f2"``, ..
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// dict
///     ``table[i][j]``: the coefficients of the product of class i and class j; ``first``, ``second``, ``target``: cocycles as lists of
///     (coefficient, vertices); ``first_orders``, ``second_orders``, ``target_orders``.
///
/// Examples
/// --------
/// On the torus the product of the two classes of degree 1 is the fundamental class, up to sign:
///
/// >>> import coface
/// >>> table = coface._coface.cup_products(coface.generate("csaszar"), 1, 1)["table"]
/// >>> table[0][0], abs(table[0][1][0])
/// ([0], 1)
#[pyfunction]
#[pyo3(signature = (model, p, q, coefficients=None, *, progress=None), text_signature = "(model, p, q, coefficients='z', *, progress=False)")]
pub(crate) fn cup_products<'py>(
    py: Python<'py>,
    model: &Bound<'py, PyAny>,
    #[pyo3(from_py_with = whole)] p: usize,
    #[pyo3(from_py_with = whole)] q: usize,
    coefficients: Option<&Bound<'py, PyAny>>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let source = source_of(model)?;
    let coefficients = coefficients.map_or(Ok(Coefficients::Integers), ring)?;
    let (simplices, table) = run(py, progress, || {
        let simplices = source.producer()?.ordered_simplices()?;
        let algebra = CochainAlgebra::new(simplices.complex().clone())?;
        let table = cup_product_table(&algebra, p, q, coefficients)?;
        Ok((simplices, table))
    })?;
    let dict = PyDict::new(py);
    for (name, cocycles) in [("first", table.first()), ("second", table.second()), ("target", table.target())]
    {
        let lists: Vec<_> = cocycles
            .iter()
            .map(|cocycle| named(py, &simplices, cocycle.cochain()))
            .collect::<PyResult<_>>()?;
        let orders: Vec<Option<Integer>> =
            cocycles.iter().map(|one: &Cocycle| one.order().cloned()).collect();
        dict.set_item(name, lists)?;
        dict.set_item(format!("{name}_orders"), order_list(py, &orders)?)?;
    }
    let rows: Vec<Vec<Bound<'py, PyAny>>> = table
        .values()
        .iter()
        .map(|row| row.iter().map(|x| arrays::integer_array(py, x)?.call_method0("tolist")).collect())
        .collect::<PyResult<_>>()?;
    dict.set_item("table", rows)?;
    Ok(dict)
}

/// The intersection form of a closed oriented manifold of even dimension.
///
/// Parameters
/// ----------
/// model : Model or Complex
///     The manifold, of simplices.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// dict
///     ``matrix``, ``rank``, ``determinant``, ``symmetric``, ``signature``, ``parity``, ``definiteness``, ``name``, ``basis``.
///
/// Examples
/// --------
/// >>> import coface
/// >>> form = coface._coface.intersection_form(coface.generate("cp2"))
/// >>> abs(form["signature"]), form["parity"]
/// (1, 'odd')
#[pyfunction]
#[pyo3(signature = (model, *, progress=None))]
pub(crate) fn intersection_form<'py>(
    py: Python<'py>,
    model: &Bound<'py, PyAny>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let source = source_of(model)?;
    let (simplices, form) = run(py, progress, || {
        let simplices = source.producer()?.ordered_simplices()?;
        let form = form_of(&CochainAlgebra::new(simplices.complex().clone())?)?;
        Ok((simplices, form))
    })?;
    let dict = PyDict::new(py);
    dict.set_item("matrix", arrays::integer_grid(py, form.rows(), form.rows().len())?)?;
    dict.set_item("rank", form.rank())?;
    dict.set_item("determinant", arrays::integer(py, &form.determinant())?)?;
    dict.set_item("symmetric", form.as_symmetric().is_some())?;
    for key in ["signature", "parity", "definiteness", "name"] {
        dict.set_item(key, py.None())?;
    }
    if let MiddlePairing::Symmetric(symmetric) = form.pairing() {
        dict.set_item("signature", symmetric.signature())?;
        dict.set_item("parity", symmetric.parity().to_string())?;
        dict.set_item("definiteness", symmetric.definiteness().to_string())?;
        dict.set_item("name", symmetric.name())?;
    }
    let basis: Vec<_> =
        form.basis().iter().map(|cochain| named(py, &simplices, cochain)).collect::<PyResult<_>>()?;
    dict.set_item("basis", basis)?;
    Ok(dict)
}

/// The columns of a map of homology groups, with the orders of generators.
fn map_dict<'py>(py: Python<'py>, map: &HomologyMap) -> PyResult<Bound<'py, PyDict>> {
    let dict = PyDict::new(py);
    let columns = map.columns();
    let rows: Vec<Vec<Integer>> = (0..map.target_orders().len())
        .map(|row| columns.iter().map(|column| column[row].clone()).collect())
        .collect();
    dict.set_item("matrix", arrays::integer_grid(py, &rows, columns.len())?)?;
    dict.set_item("source_orders", order_list(py, map.source_orders())?)?;
    dict.set_item("target_orders", order_list(py, map.target_orders())?)?;
    dict.set_item("image", map.image_group().to_string())?;
    dict.set_item("kernel", map.kernel().to_string())?;
    dict.set_item("cokernel", map.cokernel().to_string())?;
    Ok(dict)
}

/// The long exact sequence of a pair, checked to be exact.
///
/// Parameters
/// ----------
/// model : Model or Complex
///     The whole.
/// part : "boundary", Model or Complex
///     The part.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// dict
///     ``part``, ``whole`` and ``pair``: homology; ``inclusion``, ``projection`` and ``connecting``: for each degree a map or ``None``, with
///     ``matrix`` (columns are images of generators), ``image``, ``kernel`` and ``cokernel``.
#[pyfunction]
#[pyo3(signature = (model, part, *, progress=None))]
pub(crate) fn long_exact_sequence<'py>(
    py: Python<'py>,
    model: &Bound<'py, PyAny>,
    part: &Bound<'py, PyAny>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let source = source_of(model)?;
    let part = match part.cast::<PyString>() {
        Ok(word) if word.to_str()? == "boundary" => None,
        Ok(word) => return Err(invalid(py, format!("the part is {word}"), "give \"boundary\" or a Model")),
        Err(_) => Some(source_of(part)?),
    };
    let sequence = run(py, progress, || {
        let (producer, whole) = (source.producer()?, source.chains()?);
        let pair = match &part {
            None => Pair::with_boundary(producer, whole)?,
            Some(part) => Pair::with_model(producer, whole, &part.model)?,
        };
        let sequence = LongExactSequence::new(whole, &pair.subcomplex(whole)?)?;
        sequence.check()?;
        Ok(sequence)
    })?;
    let dict = PyDict::new(py);
    dict.set_item("part", Homology::of_groups(sequence.part().groups(), false))?;
    dict.set_item("whole", Homology::of_groups(sequence.whole().groups(), false))?;
    dict.set_item("pair", Homology::of_groups(sequence.pair().groups(), false))?;
    let degrees = sequence.whole().groups().len();
    let list = |map: &dyn Fn(usize) -> Option<HomologyMap>| -> PyResult<Vec<Option<Bound<'py, PyDict>>>> {
        (0..degrees).map(|degree| map(degree).map(|map| map_dict(py, &map)).transpose()).collect()
    };
    dict.set_item("inclusion", list(&|degree| sequence.inclusion(degree).cloned())?)?;
    dict.set_item("projection", list(&|degree| sequence.projection(degree).cloned())?)?;
    dict.set_item("connecting", list(&|degree| sequence.connecting(degree).cloned())?)?;
    Ok(dict)
}

fn simplices_of(producer: &Producer) -> Result<FrozenComplex, Error> {
    producer.ordered_simplices()?.simplicial().cloned().ok_or_else(|| {
        Error::invalid("a simplicial map goes between simplicial complexes")
            .with_cure("give facet lists or triangulated meshes")
    })
}

/// The maps on integral homology that a simplicial map induces.
///
/// Parameters
/// ----------
/// source, target : Model or Complex
///     Simplicial complexes.
/// vertices : dict of int to int, or sequence of (int, int)
///     The image of each vertex.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// list of dict
///     For each degree ``matrix`` (columns are images of generators), ``source_orders``, ``target_orders``, ``kernel``, ``cokernel``.
///
/// Examples
/// --------
/// A hexagon that runs twice around a triangle:
///
/// >>> import coface
/// >>> hexagon = coface.Complex([[i, (i + 1) % 6] for i in range(6)])
/// >>> triangle = coface.Complex([[0, 1], [1, 2], [0, 2]])
/// >>> maps = coface._coface.induced_map(hexagon, triangle, {i: i % 3 for i in range(6)})
/// >>> abs(maps[1]["matrix"]), maps[1]["cokernel"]
/// (array([[2]]), 'Z/2')
#[pyfunction]
#[pyo3(signature = (source, target, vertices, *, progress=None))]
pub(crate) fn induced_map<'py>(
    py: Python<'py>,
    source: &Bound<'py, PyAny>,
    target: &Bound<'py, PyAny>,
    vertices: &Bound<'py, PyAny>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Vec<Bound<'py, PyDict>>> {
    let (source, target) = (source_of(source)?, source_of(target)?);
    let images: Vec<(u32, u32)> = match vertices.cast::<PyDict>() {
        Ok(dict) => {
            dict.iter().map(|pair| Ok((pair.0.extract()?, pair.1.extract()?))).collect::<PyResult<_>>()?
        }
        Err(_) => vertices.extract().map_err(|_| {
            invalid(
                py,
                "the images of the vertices are no pairs".to_owned(),
                "give a dictionary {vertex: image}, or pairs [(vertex, image), ..]",
            )
        })?,
    };
    let maps = run(py, progress, || {
        let (from, to) = (simplices_of(source.producer()?)?, simplices_of(target.producer()?)?);
        let simplicial = SimplicialMap::new(&from, &to, images)?;
        let (first, second) = (from.chain_complex()?, to.chain_complex()?);
        let map = simplicial.chain_map(&first, &second)?;
        induced_maps(&map, &HomologyBasis::new(&first), &HomologyBasis::new(&second))
    })?;
    maps.iter().map(|map| map_dict(py, map)).collect()
}

/// Whether a cochain of degree 1 is closed, and whether it is exact.
///
/// Parameters
/// ----------
/// model : Model or Complex
///     What it is a cochain on.
/// values : array_like
///     A value for each edge, in the order of the chain complex; integers are decided exactly.
/// tolerance : float, optional
///     Which sums count as zero, for real values.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// dict
///     ``closed`` and ``exact``; ``potential`` of an exact one; ``walk`` and ``period`` of a closed one that is not; ``face`` and ``sum`` of one
///     that is not closed.
#[pyfunction]
#[pyo3(signature = (model, values, *, tolerance=None, progress=None))]
pub(crate) fn is_exact<'py>(
    py: Python<'py>,
    model: &Bound<'py, PyAny>,
    values: &Bound<'py, PyAny>,
    tolerance: Option<f64>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyDict>> {
    let source = source_of(model)?;
    let array = arrays::as_array(py, values)?;
    let is_real = array.getattr("dtype")?.getattr("kind")?.extract::<String>()? == "f";
    let dict = PyDict::new(py);
    let count = run(py, None, || Ok(source.chains()?.cell_count(1)))?;
    let length: usize = array.getattr("size")?.extract()?;
    if length != count {
        return Err(invalid(py, format!("{length} values for {count} edges"), "give one for each edge"));
    }
    let skeleton = run(py, None, || source.producer()?.two_skeleton())?;
    let names = |degree: usize, cell: usize| {
        source.producer().map_or_else(
            |_| vec![cell as u32],
            |producer| producer.cell_vertices(degree, coface::CellId::new(cell)),
        )
    };
    let walk_of = |walk: &coface::topology::ClosedWalk| -> Vec<u32> {
        walk.vertices(&skeleton).into_iter().map(|vertex| names(0, vertex.index())[0]).collect()
    };
    let set = |closed: bool, exact: bool| -> PyResult<()> {
        dict.set_item("closed", closed)?;
        dict.set_item("exact", exact)
    };
    if is_real {
        let Some(tolerance) = tolerance else {
            return Err(invalid(py, "the values are real", "say with tolerance= which sums count as zero"));
        };
        let values = arrays::finite(&array, "values")?;
        let found = run(py, progress, || {
            let terms = values.into_iter().enumerate().map(|(cell, value)| (CellId::new(cell), value));
            exactness_within(&skeleton, &Cochain::new(source.chains()?, 1, terms)?, tolerance)
        })?;
        match found {
            Exactness::Exact { potential } => {
                set(true, true)?;
                let vertices = source.chains().or_raise(py)?.cell_count(0);
                dict.set_item("potential", PyArray1::from_vec(py, dense(&potential, vertices)))?;
            }
            Exactness::Closed { walk, period } => {
                set(true, false)?;
                dict.set_item("walk", walk_of(&walk))?;
                dict.set_item("period", period)?;
            }
            Exactness::NotClosed { face, sum } => {
                set(false, false)?;
                dict.set_item("face", names(2, face.index()))?;
                dict.set_item("sum", sum)?;
            }
            _ => {}
        }
        return Ok(dict);
    }
    let values = arrays::numbers(&array, "values")?;
    let found = run(py, progress, || {
        let terms = values.into_iter().enumerate().map(|(cell, x)| (CellId::new(cell), Integer::from(x)));
        exactness(&skeleton, &Cochain::new(source.chains()?, 1, terms)?)
    })?;
    match found {
        Exactness::Exact { potential } => {
            set(true, true)?;
            let count = source.chains().or_raise(py)?.cell_count(0);
            let mut dense = vec![Integer::ZERO; count];
            for (cell, value) in potential.terms() {
                dense[cell.index()] = value.clone();
            }
            dict.set_item("potential", arrays::integer_array(py, &dense)?)?;
        }
        Exactness::Closed { walk, period } => {
            set(true, false)?;
            dict.set_item("walk", walk_of(&walk))?;
            dict.set_item("period", arrays::integer(py, &period)?)?;
        }
        Exactness::NotClosed { face, sum } => {
            set(false, false)?;
            dict.set_item("face", names(2, face.index()))?;
            dict.set_item("sum", arrays::integer(py, &sum)?)?;
        }
        _ => {}
    }
    Ok(dict)
}
