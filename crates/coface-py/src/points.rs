//! Persistent homology of points, distances and graphs.

use crate::arrays;
use crate::chain_complex::ring;
use crate::errors::{OrRaise, invalid, warn, whole};
use crate::model::Model;
use crate::persistence::{Diagram, Persistence};
use crate::source::{Names, Naming};
use crate::work::run;
use coface::answers::RipsRequest;
use coface::complexes::alpha::PeriodicBox;
use coface::complexes::filtered::{DirectedFlagComplex, FilteredComplex, IntervalCover, WitnessRule};
use coface::io::{
    AlphaCells, AlphaReading, CechReading, FileGraph, FlagReading, Lens, MapperReading, NumberTable, Remark,
    RipsReading, TableForm, WitnessReading,
};
use coface::topology;
use coface::topology::{Coefficients, Filtration};
use coface::{ChainComplex, Error};
use numpy::{IntoPyArray, PyArray1};
use pyo3::prelude::*;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::sync::Arc;

/// Persistent homology of the Vietoris-Rips filtration of points or distances.
///
/// Parameters
/// ----------
/// table : array_like of float
///     Rows of numbers.
/// form : {"points", "lower", "upper", "square", "sparse"}, optional
///     What the rows are: coordinates, distances to the points before or behind or to all, or two points and their distance; by default what they
///     look like.
/// dimension : int
///     The highest degree of classes.
/// threshold : float, optional
///     The largest diameter of simplices; the enclosing radius if not given.
/// coefficients : str or int
///     A prime field: ``"f2"``, ``"f3"``, ...
/// least : float
///     Classes that live no longer than this are left out.
/// collapse : bool
///     Whether edges are collapsed before.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// Persistence
///     The diagram.
#[pyfunction]
#[pyo3(signature = (table, *, form=None, dimension=None, threshold=None, coefficients=None, least=0.0, collapse=false, progress=None), text_signature = "(table, *, form=None, dimension=1, threshold=None, coefficients='f2', least=0.0, collapse=False, progress=False)")]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn rips(
    py: Python<'_>,
    table: &Bound<'_, PyAny>,
    form: Option<&str>,
    dimension: Option<&Bound<'_, PyAny>>,
    threshold: Option<f64>,
    coefficients: Option<&Bound<'_, PyAny>>,
    least: f64,
    collapse: bool,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Persistence> {
    let table = rows(table)?;
    let field = coefficients.map_or(Ok(Coefficients::Modulo(2)), ring)?;
    let dimension = dimension.map_or(Ok(1), whole)?;
    let reading = RipsReading { form: form_of(py, form)?, ..RipsReading::default() };
    let (found, said) = run(py, progress, || {
        let points = reading.distances(&table)?;
        let request = RipsRequest::new().coefficients(field).dimension(dimension);
        let request = request.threshold(threshold).min_persistence(least).collapse(collapse);
        Ok((request.found("points", points.distances())?, points.remarks().to_vec()))
    })?;
    warn_of(py, &said)?;
    Ok(Persistence { diagram: Diagram::Points(found) })
}

/// Persistent homology of the flag complex of a weighted graph.
///
/// Parameters
/// ----------
/// graph : str or array_like of float
///     The path of a file, or rows of two vertices and the value of their edge, or of a vertex twice and its value.
/// directed : bool
///     Whether edges have directions.
/// dimension : int
///     The highest degree of classes.
/// threshold : float, optional
///     The largest value of simplices.
/// coefficients : str or int
///     A prime field: ``"f2"``, ``"f3"``, ...
/// least : float
///     Classes that live no longer than this are left out.
/// collapse : bool
///     Whether edges are collapsed before.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// Persistence
///     The diagram.
#[pyfunction]
#[pyo3(signature = (graph, *, directed=false, dimension=None, threshold=None, coefficients=None, least=0.0, collapse=false, progress=None), text_signature = "(graph, *, directed=False, dimension=1, threshold=None, coefficients='f2', least=0.0, collapse=False, progress=False)")]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn flag(
    py: Python<'_>,
    graph: &Bound<'_, PyAny>,
    directed: bool,
    dimension: Option<&Bound<'_, PyAny>>,
    threshold: Option<f64>,
    coefficients: Option<&Bound<'_, PyAny>>,
    least: f64,
    collapse: bool,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Persistence> {
    let graph = GivenGraph::of(graph)?;
    let field = coefficients.map_or(Ok(Coefficients::Modulo(2)), ring)?;
    let dimension = dimension.map_or(Ok(1), whole)?;
    let reading = FlagReading { directed, threshold, ..FlagReading::default() };
    if directed && collapse {
        let message = "edges with directions are not collapsed".to_owned();
        return Err(invalid(py, message, "give collapse=False"));
    }
    if directed {
        return directed_flag(py, &graph, reading, dimension, field, least, progress);
    }
    let (found, said) = run(py, progress, || {
        let graph = graph.read(reading)?;
        let request = RipsRequest::new().coefficients(field).dimension(dimension);
        let request = request.threshold(threshold).min_persistence(least).collapse(collapse);
        Ok((request.found_of_graph("graph", &graph)?, graph.remarks().to_vec()))
    })?;
    warn_of(py, &said)?;
    Ok(Persistence { diagram: Diagram::Points(found) })
}

/// That of a directed graph, whose simplices are named by their vertices in order.
fn directed_flag(
    py: Python<'_>,
    graph: &GivenGraph,
    reading: FlagReading,
    dimension: usize,
    field: Coefficients,
    least: f64,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Persistence> {
    let threshold = reading.threshold.unwrap_or(f64::INFINITY);
    let (diagram, names, chains, filtration, said) = run(py, progress, || {
        let graph = graph.read(reading)?;
        let complex = DirectedFlagComplex::new(&graph.digraph(), threshold, dimension + 1)?;
        let counts = complex.complex().f_vector();
        let values = (0..counts.len()).map(|degree| complex.values(degree).to_vec()).collect();
        let numbers = graph.numbers();
        let cells =
            counts.iter().enumerate().flat_map(|(degree, &count)| (0..count).map(move |i| (degree, i)));
        let name = |(degree, i)| {
            let simplex = complex.simplex(degree, i).iter().map(|&vertex| numbers[vertex as usize]);
            ((degree, i), simplex.collect::<Vec<u32>>())
        };
        let names: BTreeMap<_, _> = cells.map(name).collect();
        let chains = complex.complex().chain_complex()?;
        let filtration = Filtration::new(&chains, values)?;
        let diagram = topology::persistence(&chains, &filtration, field)?.up_to_degree(dimension);
        Ok((diagram.longer_than(least), names, chains, filtration, graph.remarks().to_vec()))
    })?;
    warn_of(py, &said)?;
    let naming = Arc::new(Naming::of(Names::Given(Arc::new(names))));
    let (complex, filtration) = (Arc::new(chains), Arc::new(filtration));
    Ok(Persistence {
        diagram: Diagram::Complex { diagram, naming, complex, filtration, least, image: false },
    })
}

/// Persistent homology of the Čech complex of points.
///
/// Parameters
/// ----------
/// table : array_like of float
///     Rows of coordinates.
/// threshold : float, optional
///     The largest radius of balls.
/// dimension : int
///     The highest degree of classes.
/// coefficients : str or int
///     A prime field: ``"f2"``, ``"f3"``, ...
/// least : float
///     Classes that live no longer than this are left out.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// Persistence
///     The diagram.
#[pyfunction]
#[pyo3(signature = (table, *, threshold=None, dimension=None, coefficients=None, least=0.0, progress=None), text_signature = "(table, *, threshold=None, dimension=1, coefficients='f2', least=0.0, progress=False)")]
pub(crate) fn cech(
    py: Python<'_>,
    table: &Bound<'_, PyAny>,
    threshold: Option<f64>,
    dimension: Option<&Bound<'_, PyAny>>,
    coefficients: Option<&Bound<'_, PyAny>>,
    least: f64,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Persistence> {
    let table = rows(table)?;
    let field = coefficients.map_or(Ok(Coefficients::Modulo(2)), ring)?;
    let dimension = dimension.map_or(Ok(1), whole)?;
    of_simplices(py, progress, (field, least, Some(dimension)), || {
        let reading = CechReading { radius: threshold, dimension: Some(dimension + 1) };
        let points = reading.points(&table)?;
        let said = points.remarks().to_vec();
        Ok((points.into_parts().1, said))
    })
}

/// The Čech complex of points as a model.
///
/// Parameters
/// ----------
/// table : array_like of float
///     Rows of coordinates.
/// threshold : float, optional
///     As of :func:`cech`.
/// dimension : int, optional
///     The highest dimension of simplices, 2 if not given.
///
/// Returns
/// -------
/// Model
///     Tetrahedra, triangles, edges and points, or simplices.
#[pyfunction]
#[pyo3(signature = (table, *, threshold=None, dimension=None))]
pub(crate) fn cech_complex(
    py: Python<'_>,
    table: &Bound<'_, PyAny>,
    threshold: Option<f64>,
    dimension: Option<&Bound<'_, PyAny>>,
) -> PyResult<Model> {
    let table = rows(table)?;
    let reading = CechReading { radius: threshold, dimension: dimension.map(whole).transpose()? };
    let model = run(py, None, || Ok(reading.points(&table)?.into_model()))?;
    given(py, model)
}

/// Persistent homology of the witness complex of landmarks.
///
/// Parameters
/// ----------
/// table : array_like of float
///     Rows of coordinates.
/// landmarks : int
///     How many landmarks are chosen.
/// strong : bool
///     Whether all landmarks of a simplex are as near to a witness as the nearest one.
/// threshold : float, optional
///     The largest value.
/// dimension : int
///     The highest degree of classes.
/// coefficients : str or int
///     A prime field: ``"f2"``, ``"f3"``, ...
/// least : float
///     Classes that live no longer than this are left out.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// Persistence
///     The diagram.
#[pyfunction]
#[pyo3(signature = (table, landmarks, *, strong=false, threshold=None, dimension=None, coefficients=None, least=0.0, progress=None), text_signature = "(table, landmarks, *, strong=False, threshold=None, dimension=1, coefficients='f2', least=0.0, progress=False)")]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn witness(
    py: Python<'_>,
    table: &Bound<'_, PyAny>,
    #[pyo3(from_py_with = whole)] landmarks: usize,
    strong: bool,
    threshold: Option<f64>,
    dimension: Option<&Bound<'_, PyAny>>,
    coefficients: Option<&Bound<'_, PyAny>>,
    least: f64,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Persistence> {
    let table = rows(table)?;
    let field = coefficients.map_or(Ok(Coefficients::Modulo(2)), ring)?;
    let dimension = dimension.map_or(Ok(1), whole)?;
    of_simplices(py, progress, (field, least, Some(dimension)), || {
        let reading = WitnessReading {
            landmarks,
            rule: rule_of(strong),
            bound: threshold,
            dimension: Some(dimension + 1),
        };
        let points = reading.points(&table)?;
        let said = points.remarks().to_vec();
        Ok((points.into_parts().1, said))
    })
}

/// The witness complex of landmarks as a model.
///
/// Parameters
/// ----------
/// table : array_like of float
///     Rows of coordinates.
/// landmarks : int
///     As of :func:`witness`.
/// strong : bool
///     As of :func:`witness`.
/// threshold : float, optional
///     As of :func:`witness`.
/// dimension : int, optional
///     The highest dimension of simplices, 2 if not given.
///
/// Returns
/// -------
/// Model
///     Tetrahedra, triangles, edges and points, or simplices.
#[pyfunction]
#[pyo3(signature = (table, landmarks, *, strong=false, threshold=None, dimension=None))]
pub(crate) fn witness_complex(
    py: Python<'_>,
    table: &Bound<'_, PyAny>,
    #[pyo3(from_py_with = whole)] landmarks: usize,
    strong: bool,
    threshold: Option<f64>,
    dimension: Option<&Bound<'_, PyAny>>,
) -> PyResult<Model> {
    let table = rows(table)?;
    let dimension = dimension.map(whole).transpose()?;
    let reading = WitnessReading { landmarks, rule: rule_of(strong), bound: threshold, dimension };
    let model = run(py, None, || Ok(reading.points(&table)?.into_model()))?;
    given(py, model)
}

/// The Mapper complex of points as a model, and the points of its vertices.
///
/// Parameters
/// ----------
/// table : array_like of float
///     Rows of coordinates.
/// values : array_like of float, optional
///     The function on the points; the largest distance to another point if not given.
/// intervals : int
///     How many intervals cover the range of the function.
/// overlap : float
///     How much of each interval lies in the next.
/// threshold : float, optional
///     Points within this distance are neighbors.
///
/// Returns
/// -------
/// tuple of Model and list of numpy.ndarray
///     The model, and for each vertex the numbers of its points.
#[pyfunction]
#[pyo3(signature = (table, values, *, intervals, overlap, threshold=None))]
pub(crate) fn mapper<'py>(
    py: Python<'py>,
    table: &Bound<'py, PyAny>,
    values: Option<&Bound<'py, PyAny>>,
    #[pyo3(from_py_with = whole)] intervals: usize,
    overlap: f64,
    threshold: Option<f64>,
) -> PyResult<(Model, Vec<Bound<'py, PyArray1<i64>>>)> {
    let table = rows(table)?;
    let values = values.map(|values| arrays::real_list(values, "function")).transpose()?;
    let (model, clusters) = run(py, None, || {
        let cover = IntervalCover::new(intervals, overlap)?;
        let reading = MapperReading { cover, lens: Lens::Eccentricity, threshold };
        let found = match values {
            None => reading.points(&table)?,
            Some(values) => reading.points_of_values(&table, &values)?,
        };
        let clusters = found.clusters().clone();
        Ok((found.into_model(), clusters))
    })?;
    let numbers = |cluster: &[u32]| cluster.iter().map(|&point| i64::from(point)).collect::<Vec<_>>();
    let clusters = clusters.iter().map(|cluster| numbers(cluster).into_pyarray(py)).collect();
    Ok((given(py, model)?, clusters))
}

fn rule_of(strong: bool) -> WitnessRule {
    if strong { WitnessRule::Strong } else { WitnessRule::Weak }
}

/// The diagram of simplices with values, up to a degree.
fn of_simplices(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    (field, least, degree): (Coefficients, f64, Option<usize>),
    make: impl FnOnce() -> Result<(FilteredComplex, Vec<Remark>), Error> + Send,
) -> PyResult<Persistence> {
    of_cells(py, progress, (field, least, degree), || {
        let (complex, said) = make()?;
        Ok((named_by_vertices(complex)?, said))
    })
}

/// A chain complex, the values of its cells, and what these are called.
type Cells = (ChainComplex, Vec<Vec<f64>>, Names);

/// The chain complex of simplices, their values, and their vertices as names.
fn named_by_vertices(complex: FilteredComplex) -> Result<Cells, Error> {
    let (simplices, values) = complex.into_parts();
    Ok((simplices.chain_complex()?, values, Names::Simplices(Arc::new(simplices))))
}

/// The sides of a periodic box.
fn periodic_box(sides: &Bound<'_, PyAny>) -> PyResult<PeriodicBox> {
    PeriodicBox::new(&arrays::real_list(sides, "periods")?).or_raise(sides.py())
}

/// The diagram of cells with values and names, up to a degree.
fn of_cells(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    (field, least, degree): (Coefficients, f64, Option<usize>),
    make: impl FnOnce() -> Result<(Cells, Vec<Remark>), Error> + Send,
) -> PyResult<Persistence> {
    let (diagram, names, complex, filtration, said) = run(py, progress, || {
        let ((complex, values, names), said) = make()?;
        let filtration = Filtration::new(&complex, values)?;
        let mut diagram = topology::persistence(&complex, &filtration, field)?;
        if let Some(degree) = degree {
            diagram = diagram.up_to_degree(degree);
        }
        Ok((diagram.longer_than(least), names, complex, filtration, said))
    })?;
    warn_of(py, &said)?;
    let naming = Arc::new(Naming::of(names));
    let (complex, filtration) = (Arc::new(complex), Arc::new(filtration));
    Ok(Persistence {
        diagram: Diagram::Complex { diagram, naming, complex, filtration, least, image: false },
    })
}

/// Persistent homology of the alpha complex of points.
///
/// Parameters
/// ----------
/// table : array_like of float
///     Rows of at most three coordinates, and the weight behind them if points have weights.
/// weighted : bool
///     Whether points have weights.
/// bound : float, optional
///     The value at which the complex ends.
/// radii : bool
///     Whether values are radii instead of squared radii.
/// periods : array_like of float, optional
///     The lengths after which the points repeat, one for each coordinate.
/// coefficients : str or int
///     A prime field: ``"f2"``, ``"f3"``, ...
/// least : float
///     Classes that live no longer than this are left out.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// Persistence
///     The diagram.
#[pyfunction]
#[pyo3(signature = (table, *, weighted=false, bound=None, radii=false, periods=None, coefficients=None, least=0.0, progress=None), text_signature = "(table, *, weighted=False, bound=None, radii=False, periods=None, coefficients='f2', least=0.0, progress=False)")]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn alpha(
    py: Python<'_>,
    table: &Bound<'_, PyAny>,
    weighted: bool,
    bound: Option<f64>,
    radii: bool,
    periods: Option<&Bound<'_, PyAny>>,
    coefficients: Option<&Bound<'_, PyAny>>,
    least: f64,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Persistence> {
    let table = rows(table)?;
    let field = coefficients.map_or(Ok(Coefficients::Modulo(2)), ring)?;
    let periods = periods.map(periodic_box).transpose()?;
    of_cells(py, progress, (field, least, None), || {
        let points = AlphaReading { bound, weighted, radii, periods }.points(&table)?;
        let said = points.remarks().to_vec();
        let alpha = match points.into_parts().1 {
            AlphaCells::Plain(alpha) => return Ok((named_by_vertices(alpha.into_filtered())?, said)),
            AlphaCells::Periodic(alpha) => alpha,
        };
        if let Some(complex) = alpha.simplicial() {
            return Ok((named_by_vertices(complex)?, said));
        }
        let degrees = 0..alpha.complex().f_vector().len();
        let values = degrees.clone().map(|degree| alpha.values(degree).to_vec()).collect();
        let points = degrees.flat_map(|degree| {
            let count = alpha.complex().simplex_count(degree);
            let alpha = &alpha;
            (0..count).map(move |i| ((degree, i), alpha.points(degree, i).to_vec()))
        });
        let names = Names::Given(Arc::new(points.collect()));
        Ok(((alpha.complex().chain_complex()?, values, names), said))
    })
}

/// The alpha complex of points as a model.
///
/// Parameters
/// ----------
/// table : array_like of float
///     As of :func:`alpha`.
/// weighted : bool
///     As of :func:`alpha`.
/// bound : float, optional
///     As of :func:`alpha`.
/// radii : bool
///     As of :func:`alpha`.
/// periods : array_like of float, optional
///     As of :func:`alpha`.
///
/// Returns
/// -------
/// Model
///     Tetrahedra, triangles, edges and points; with periods a list of simplices, or of few points a chain complex, without positions.
#[pyfunction]
#[pyo3(signature = (table, *, weighted=false, bound=None, radii=false, periods=None))]
pub(crate) fn alpha_complex(
    py: Python<'_>,
    table: &Bound<'_, PyAny>,
    weighted: bool,
    bound: Option<f64>,
    radii: bool,
    periods: Option<&Bound<'_, PyAny>>,
) -> PyResult<Model> {
    let table = rows(table)?;
    let periods = periods.map(periodic_box).transpose()?;
    let model =
        run(py, None, || AlphaReading { bound, weighted, radii, periods }.points(&table)?.into_model())?;
    given(py, model)
}

/// The Vietoris-Rips complex of points or distances as a model.
///
/// Parameters
/// ----------
/// table : array_like of float
///     As of :func:`rips`.
/// form : str, optional
///     As of :func:`rips`.
/// threshold : float, optional
///     As of :func:`rips`.
/// dimension : int, optional
///     The highest dimension of simplices, 2 if not given.
///
/// Returns
/// -------
/// Model
///     Tetrahedra, triangles, edges and points, or simplices.
#[pyfunction]
#[pyo3(signature = (table, *, form=None, threshold=None, dimension=None))]
pub(crate) fn rips_complex(
    py: Python<'_>,
    table: &Bound<'_, PyAny>,
    form: Option<&str>,
    threshold: Option<f64>,
    dimension: Option<&Bound<'_, PyAny>>,
) -> PyResult<Model> {
    let table = rows(table)?;
    let dimension = dimension.map(whole).transpose()?;
    let reading = RipsReading { form: form_of(py, form)?, delay: None, threshold, dimension };
    let model = run(py, None, || reading.model(reading.distances(&table)?))?;
    given(py, model)
}

/// The flag complex of a graph as a model.
///
/// Parameters
/// ----------
/// graph : str or array_like of float
///     As of :func:`flag`.
/// directed : bool
///     As of :func:`flag`.
/// threshold : float, optional
///     As of :func:`flag`.
/// dimension : int, optional
///     The highest dimension of simplices, 2 if not given.
///
/// Returns
/// -------
/// Model
///     Simplices, or a chain complex if edges have directions.
#[pyfunction]
#[pyo3(signature = (graph, *, directed=false, threshold=None, dimension=None))]
pub(crate) fn flag_complex(
    py: Python<'_>,
    graph: &Bound<'_, PyAny>,
    directed: bool,
    threshold: Option<f64>,
    dimension: Option<&Bound<'_, PyAny>>,
) -> PyResult<Model> {
    let graph = GivenGraph::of(graph)?;
    let reading = FlagReading { directed, threshold, dimension: dimension.map(whole).transpose()? };
    let model = run(py, None, || reading.model(&graph.read(reading)?))?;
    given(py, model)
}

/// A graph in a file, or its rows.
enum GivenGraph {
    File(PathBuf),
    Rows(NumberTable),
}

impl GivenGraph {
    fn of(graph: &Bound<'_, PyAny>) -> PyResult<Self> {
        match graph.extract::<PathBuf>() {
            Ok(path) => Ok(Self::File(path)),
            Err(_) => rows(graph).map(Self::Rows),
        }
    }

    fn read(&self, reading: FlagReading) -> Result<FileGraph, Error> {
        match self {
            Self::File(path) => reading.graph_of_path(path),
            Self::Rows(table) => reading.graph_of_table(table),
        }
    }
}

/// A model that was made, after its remarks.
fn given(py: Python<'_>, model: coface::io::Model) -> PyResult<Model> {
    warn_of(py, model.remarks())?;
    Ok(Model::of(model))
}

fn warn_of(py: Python<'_>, said: &[Remark]) -> PyResult<()> {
    said.iter().try_for_each(|remark| warn(py, &remark.message))
}

fn form_of(py: Python<'_>, name: Option<&str>) -> PyResult<Option<TableForm>> {
    name.map(TableForm::from_name).transpose().or_raise(py)
}

/// The rows of a table.
fn rows(table: &Bound<'_, PyAny>) -> PyResult<NumberTable> {
    let rows: Vec<Vec<f64>> =
        table.try_iter()?.map(|row| arrays::real_list(&row?, "table")).collect::<PyResult<_>>()?;
    Ok(NumberTable::from_rows(rows))
}
