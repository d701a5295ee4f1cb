//! Persistent homology along a filtration.

use crate::arrays;
use crate::chain::Chain;
use crate::chain_complex::{ChainComplex, ring};
use crate::diagrams::{self, Curves};
use crate::errors::{OrRaise, invalid, warn, whole};
use crate::image_cycles::{ProvedClass, image_cycles};
use crate::images::{grey_image, periodic_reading};
use crate::pairs;
use crate::pictures::flat_file;
use crate::source::{Names, Naming};
use crate::work::run;
use coface::algebra::Integer;
use coface::algebra::chains::ChainComplex as Chains;
use coface::answers::{
    DiagramCurveKind, DiagramFormat, DiagramImageRequest, FoundImage, FoundRips, GivenDiagram, ImageCells,
    ImageRequest, write_diagram,
};
use coface::io::ReadOptions;
use coface::pictures::{DiagramPoint, diagram_picture};
use coface::topology;
use coface::topology::{
    Barcode, Coefficients, Filtration, PersistenceDiagram, PersistencePair, RipsFiltration,
};
use coface::{CellId, Error, ErrorKind, VertexId};
use numpy::{PyArray1, PyArray2, PyArrayMethods, PyReadonlyArrayDyn};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyList, PyTuple};
use std::path::PathBuf;
use std::sync::Arc;

/// Births and deaths of homology classes along a filtration, over a prime field.
///
/// Made by :func:`persistence`.
///
/// Examples
/// --------
/// A path that goes up to 2 and down to 1:
///
/// >>> import coface
/// >>> path = coface.Complex([[0, 1], [1, 2]]).chain_complex()
/// >>> coface._coface.persistence(path, vertex_values=[0.0, 2.0, 1.0]).diagram(0)
/// array([[ 0., inf],
///        [ 1.,  2.]])
#[pyclass(frozen, dict, module = "coface", name = "Persistence")]
pub(crate) struct Persistence {
    pub(crate) diagram: Diagram,
}

/// The diagram of a complex, whose cells have names, of points, or of an image.
pub(crate) enum Diagram {
    Complex {
        diagram: PersistenceDiagram,
        naming: Arc<Naming>,
        complex: Arc<Chains>,
        filtration: Arc<Filtration>,
        /// Classes that live no longer were left out.
        least: f64,
        /// Whether classes are those of a part as the whole sees them.
        image: bool,
    },
    Points(FoundRips),
    Image {
        found: FoundImage,
        /// The cubes, if they were to be kept for cycles.
        cells: Option<Arc<ImageCells>>,
    },
}

/// A class: degree, birth and death.
type Class = (usize, f64, Option<f64>);

/// The filtration that values make: of vertices, or of all cells.
pub(crate) fn filtration(
    complex: &ChainComplex,
    vertex_values: Option<Vec<f64>>,
    cell_values: Option<Vec<Vec<f64>>>,
    upper: bool,
) -> Result<Filtration, Error> {
    let chains = &complex.complex;
    match (vertex_values, cell_values) {
        (Some(values), None) => match upper {
            true => Filtration::upper_star(chains, &values),
            false => Filtration::lower_star(chains, &values),
        },
        (None, Some(values)) => {
            let given: Vec<Vec<Option<f64>>> = values
                .into_iter()
                .map(|list| list.into_iter().map(|value| (!value.is_nan()).then_some(value)).collect())
                .collect();
            Filtration::from_cofaces(chains, &given)
        }
        _ => Err(Error::new(ErrorKind::InvalidInput, "a filtration has values of vertices or of all cells")
            .with_cure("give vertex_values or cell_values")),
    }
}

/// Persistent homology of a filtration by values.
///
/// Parameters
/// ----------
/// complex : ChainComplex
///     The complex.
/// vertex_values : array_like of float, optional
///     A value for each vertex in the order of the complex; a cell enters with its last vertex.
/// cell_values : sequence of array_like, optional
///     For each degree a value for each cell; NaN where a cell enters as late as its cofaces allow.
/// coefficients : str or int
///     A prime field: ``"f2"``, ``"f3"``, ...
/// upper : bool
///     Whether a cell enters with its first vertex and values fall.
/// least : float
///     Classes that live no longer than this are left out.
/// part : list of list of int, optional
///     For each degree the cells of a part, relative to which persistence is.
/// image : bool
///     Whether it is that of the part, as the complex sees it.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// Persistence
///     The diagram.
#[pyfunction]
#[pyo3(signature = (complex, *, vertex_values=None, cell_values=None, coefficients=None, upper=false, least=0.0, part=None, image=false, progress=None), text_signature = "(complex, *, vertex_values=None, cell_values=None, coefficients='f2', upper=False, least=0.0, part=None, image=False, progress=False)")]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn persistence(
    py: Python<'_>,
    complex: &Bound<'_, ChainComplex>,
    vertex_values: Option<&Bound<'_, PyAny>>,
    cell_values: Option<&Bound<'_, PyAny>>,
    coefficients: Option<&Bound<'_, PyAny>>,
    upper: bool,
    least: f64,
    part: Option<Vec<Vec<u32>>>,
    image: bool,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Persistence> {
    let complex = complex.get();
    let field = coefficients.map_or(Ok(Coefficients::Modulo(2)), ring)?;
    let vertex_values = vertex_values.map(|values| arrays::finite(values, "vertex_values")).transpose()?;
    let cell_values = match cell_values {
        None => None,
        Some(lists) => {
            let lists: Vec<Vec<f64>> = lists
                .try_iter()?
                .map(|list| arrays::real_list(&list?, "cell_values"))
                .collect::<PyResult<_>>()?;
            Some(lists)
        }
    };
    let found = run(py, progress, || {
        let filtration = filtration(complex, vertex_values, cell_values, upper)?;
        pairs::found(complex, part, image, filtration, field)
    })?;
    let pairs::Found { diagram, naming, complex, filtration } = found;
    let diagram = diagram.longer_than(least);
    Ok(Persistence { diagram: Diagram::Complex { diagram, naming, complex, filtration, least, image } })
}

/// The paths of the points of a diagram while the function moves.
///
/// Parameters
/// ----------
/// complex : ChainComplex
///     The complex.
/// functions : sequence of array_like of float
///     For each function a value for each vertex in the order of the complex.
/// coefficients : str or int
///     A prime field: ``"f2"``, ``"f3"``, ...
/// least : float
///     Paths whose persistence is nowhere greater are left out.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// list of tuple
///     The degree of each path, and an array with a row for each point: parameter, birth, death.
#[pyfunction]
#[pyo3(signature = (complex, functions, *, coefficients=None, least=0.0, progress=None), text_signature = "(complex, functions, *, coefficients='f2', least=0.0, progress=False)")]
pub(crate) fn _vineyard<'py>(
    py: Python<'py>,
    complex: &Bound<'py, ChainComplex>,
    functions: &Bound<'py, PyAny>,
    coefficients: Option<&Bound<'py, PyAny>>,
    least: f64,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Vec<(usize, Bound<'py, PyAny>)>> {
    let complex = complex.get();
    let field = coefficients.map_or(Ok(Coefficients::Modulo(2)), ring)?;
    let functions: Vec<Vec<f64>> = functions
        .try_iter()?
        .map(|function| arrays::finite(&function?, "functions"))
        .collect::<PyResult<_>>()?;
    let vines = run(py, progress, || topology::vineyard(&complex.complex, &functions, field))?;
    let path = |vine: &topology::Vine| {
        let row = |point: &topology::VinePoint| {
            [point.parameter(), point.birth(), point.death().unwrap_or(f64::INFINITY)]
        };
        let rows: Vec<f64> = vine.points().iter().flat_map(row).collect();
        let count = vine.points().len();
        Ok((vine.degree(), PyArray1::from_vec(py, rows).reshape([count, 3])?.into_any()))
    };
    vines.iter().filter(|vine| vine.persistence() > least).map(path).collect()
}

/// Persistent homology of the sublevel or superlevel sets of an image.
///
/// Parameters
/// ----------
/// values : numpy.ndarray
///     ``float64`` or ``float32``, contiguous.
/// construction : {"t", "v"}
///     Whether voxels are top cells or vertices.
/// superlevel : bool
///     Whether superlevel sets grow.
/// periodic : sequence of int
///     The axes whose last voxels meet the first.
/// mask : numpy.ndarray, optional
///     ``bool``, contiguous: the voxels that are inside.
/// coefficients : str or int
///     A prime field: ``"f2"``, ``"f3"``, ...
/// least : float
///     Classes that live no longer than this are left out.
/// cycles : bool
///     Whether the cubes are kept, for cycles.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// Persistence
///     The diagram.
#[pyfunction]
#[pyo3(signature = (values, *, construction="t", superlevel=false, periodic=Vec::new(), mask=None, coefficients=None, least=0.0, cycles=false, progress=None), text_signature = "(values, *, construction='t', superlevel=False, periodic=(), mask=None, coefficients='f2', least=0.0, cycles=False, progress=False)")]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn cubical(
    py: Python<'_>,
    values: &Bound<'_, PyAny>,
    construction: &str,
    superlevel: bool,
    periodic: Vec<usize>,
    mask: Option<PyReadonlyArrayDyn<'_, bool>>,
    coefficients: Option<&Bound<'_, PyAny>>,
    least: f64,
    cycles: bool,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Persistence> {
    let image = grey_image(py, values, mask)?;
    let field = coefficients.map_or(Ok(Coefficients::Modulo(2)), ring)?;
    let construction = construction.parse().or_raise(py)?;
    let reading = periodic_reading(py, &image, periodic)?;
    let (found, cells) = run(py, progress, || {
        let request =
            ImageRequest::new().coefficients(field).construction(construction).superlevel(superlevel);
        let request = request.periodic(reading).min_persistence(least);
        let cells = cycles.then(|| request.cells("image", image.clone())).transpose()?.map(Arc::new);
        Ok((request.found("image", image)?, cells))
    })?;
    Ok(Persistence { diagram: Diagram::Image { found, cells } })
}

/// The values of a volume file, with its axes; ``None`` for another file.
#[pyfunction]
pub(crate) fn _values_of_volume<'py>(py: Python<'py>, path: PathBuf) -> PyResult<Option<Bound<'py, PyAny>>> {
    let read = run(py, None, || {
        let Some((stream, mut remarks)) = coface::io::volume_of_path(&path, &ReadOptions::new())? else {
            return Ok(None);
        };
        let shape: Vec<usize> = stream.shape().iter().map(|&length| length as usize).collect();
        let is_first_fastest = stream.fastest_axis() == 0;
        let (numbers, said) = stream.numbers().map_err(|error| error.in_file(path.display().to_string()))?;
        remarks.extend(said);
        Ok(Some((shape, is_first_fastest, numbers, remarks)))
    })?;
    let Some((shape, is_first_fastest, numbers, remarks)) = read else { return Ok(None) };
    for remark in remarks {
        warn(py, &remark.message)?;
    }
    let order = if is_first_fastest { "F" } else { "C" };
    let options = pyo3::types::PyDict::new(py);
    options.set_item("order", order)?;
    let array = PyArray1::from_vec(py, numbers).into_any();
    Ok(Some(array.call_method("reshape", (shape,), Some(&options))?))
}

impl Persistence {
    fn degree_count(&self) -> usize {
        match &self.diagram {
            Diagram::Complex { diagram, .. } => diagram.degree_count(),
            Diagram::Points(found) => found.diagram().degree_count(),
            Diagram::Image { found, .. } => found.diagram().degree_count(),
        }
    }

    fn classes(&self) -> Vec<Class> {
        match &self.diagram {
            Diagram::Complex { diagram, .. } => {
                diagram.pairs().iter().map(|pair| (pair.degree(), pair.birth(), pair.death())).collect()
            }
            Diagram::Points(found) => {
                found.pairs().iter().map(|pair| (pair.degree(), pair.birth(), pair.death())).collect()
            }
            Diagram::Image { found, .. } => {
                let pairs = found.diagram().pairs().iter();
                pairs.map(|pair| (pair.degree(), pair.birth(), pair.death())).collect()
            }
        }
    }

    /// The death of what never dies.
    fn never(&self) -> f64 {
        if self.is_falling() { f64::NEG_INFINITY } else { f64::INFINITY }
    }

    /// The births and deaths alone.
    fn given(&self, py: Python<'_>) -> PyResult<GivenDiagram> {
        let never = self.never();
        let mut degrees = vec![Vec::new(); self.degree_count()];
        for (degree, birth, death) in self.classes() {
            degrees[degree].push([birth, death.unwrap_or(never)]);
        }
        let degrees = degrees.into_iter().map(Barcode::new).collect::<Result<_, Error>>().or_raise(py)?;
        let diagram = GivenDiagram::new("diagram", degrees);
        Ok(if matches!(self.diagram, Diagram::Points(_)) { diagram.of_points() } else { diagram })
    }

    fn points(&self) -> Vec<DiagramPoint> {
        let point = |(degree, birth, death)| DiagramPoint { degree, birth, death };
        self.classes().into_iter().map(point).collect()
    }

    /// The pairs of a degree, of a complex.
    fn pairs_of_degree(&self, degree: usize) -> &[PersistencePair] {
        match &self.diagram {
            Diagram::Complex { diagram, .. } if degree < diagram.degree_count() => {
                diagram.pairs_of_degree(degree)
            }
            _ => &[],
        }
    }

    /// The cells, which points make again for their cycles.
    fn stored(&self, py: Python<'_>, progress: Option<&Bound<'_, PyAny>>) -> PyResult<Stored> {
        match &self.diagram {
            Diagram::Complex { image: true, .. } => Err(invalid(
                py,
                "there are no cycles of the image of a part".to_owned(),
                "ask for those of the part or of the whole",
            )),
            Diagram::Complex { diagram, naming, complex, filtration, least, .. } => Ok(Stored {
                prime: diagram.prime(),
                naming: Arc::clone(naming),
                complex: Arc::clone(complex),
                filtration: Arc::clone(filtration),
                least: *least,
            }),
            Diagram::Points(found) => {
                let (simplices, complex, filtration) = run(py, progress, || {
                    let stored = found.simplices()?;
                    let order = RipsFiltration::order_of(&stored);
                    let (simplices, values) = stored.into_parts();
                    let complex = simplices.chain_complex()?;
                    let filtration = Filtration::in_order(&complex, values, order)?;
                    Ok((simplices, complex, filtration))
                })?;
                let name = |points: &[u32]| {
                    let points: Vec<VertexId> = points.iter().map(|&id| VertexId::new(id as usize)).collect();
                    found.numbers(&points)
                };
                let cells = (0..complex.degree_count())
                    .flat_map(|degree| (0..complex.cell_count(degree)).map(move |cell| (degree, cell)));
                let naming = match name(simplices.flat(0)) == simplices.flat(0) {
                    true => Names::Simplices(Arc::new(simplices)),
                    // The vertices of a graph have other numbers in its file.
                    false => {
                        let named = cells.map(|(k, cell)| ((k, cell), name(simplices.numbers(k, cell))));
                        Names::Given(Arc::new(named.collect()))
                    }
                };
                let (complex, filtration) = (Arc::new(complex), Arc::new(filtration));
                let least = found.min_persistence().max(0.0);
                let naming = Arc::new(Naming::of(naming));
                Ok(Stored { prime: found.diagram().prime(), naming, complex, filtration, least })
            }
            // Their cubes are not stored.
            Diagram::Image { .. } => Err(no_cells(py)),
        }
    }

    /// The cubes of an image, if the diagram is that of one.
    fn cubes(&self, py: Python<'_>) -> PyResult<Option<(&FoundImage, &ImageCells)>> {
        match &self.diagram {
            Diagram::Image { found, cells: Some(cells) } => Ok(Some((found, cells.as_ref()))),
            Diagram::Image { cells: None, .. } => Err(invalid(
                py,
                "the cubes of the image were not kept".to_owned(),
                "ask coface.cubical(x, cycles=True)",
            )),
            _ => Ok(None),
        }
    }

    /// Of points and images, whose cells have no numbers, nothing.
    fn require_complex(&self, py: Python<'_>) -> PyResult<()> {
        match &self.diagram {
            Diagram::Complex { .. } => Ok(()),
            Diagram::Points(_) => Err(invalid(
                py,
                "simplices of points have no numbers".to_owned(),
                "ask .simplices(degree) for their points",
            )),
            Diagram::Image { .. } => Err(no_cells(py)),
        }
    }
}

/// The cells of a diagram and when they enter.
struct Stored {
    prime: u32,
    naming: Arc<Naming>,
    complex: Arc<Chains>,
    filtration: Arc<Filtration>,
    /// Classes that live no longer were left out.
    least: f64,
}

fn no_cells(py: Python<'_>) -> PyErr {
    invalid(
        py,
        "cells of images have no numbers".to_owned(),
        "ask .voxels(degree) for the voxels whose values they have",
    )
}

#[pymethods]
impl Persistence {
    /// The prime of the field.
    #[getter]
    fn prime(&self) -> u32 {
        match &self.diagram {
            Diagram::Complex { diagram, .. } => diagram.prime(),
            Diagram::Points(found) => found.diagram().prime(),
            Diagram::Image { found, .. } => found.diagram().prime(),
        }
    }

    /// The largest diameter of the simplices that were looked at; ``None`` unless the diagram is of points.
    #[getter]
    fn threshold(&self) -> Option<f64> {
        match &self.diagram {
            Diagram::Complex { .. } | Diagram::Image { .. } => None,
            Diagram::Points(found) => Some(found.diagram().threshold()),
        }
    }

    /// The names of the vertices of a graph by their numbers; ``None`` where vertices have numbers.
    #[getter]
    fn vertex_names<'py>(&self, py: Python<'py>) -> PyResult<Option<Bound<'py, PyTuple>>> {
        match &self.diagram {
            Diagram::Complex { .. } | Diagram::Image { .. } => Ok(None),
            Diagram::Points(found) => found.vertex_names().map(|names| PyTuple::new(py, names)).transpose(),
        }
    }

    /// Whether values fall along the filtration.
    #[getter]
    fn is_falling(&self) -> bool {
        match &self.diagram {
            Diagram::Complex { diagram, .. } => diagram.is_falling(),
            Diagram::Points(_) => false,
            Diagram::Image { found, .. } => found.diagram().is_falling(),
        }
    }

    /// The numbers of classes that never die, by degree.
    #[getter]
    fn betti_numbers<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyTuple>> {
        PyTuple::new(
            py,
            match &self.diagram {
                Diagram::Complex { diagram, .. } => diagram.betti_numbers(),
                Diagram::Points(found) => found.diagram().betti_numbers(),
                Diagram::Image { found, .. } => found.diagram().betti_numbers(),
            },
        )
    }

    /// Births and deaths of a degree.
    ///
    /// Parameters
    /// ----------
    /// degree : int
    ///     The degree.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray
    ///     ``float64``, shape (n, 2); a class that never dies has the death inf, where values fall -inf.
    fn diagram<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = whole)] degree: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        let classes = self.classes().into_iter().filter(|class| class.0 == degree);
        let never = self.never();
        let values: Vec<f64> =
            classes.flat_map(|(_, birth, death)| [birth, death.unwrap_or(never)]).collect();
        let count = values.len() / 2;
        Ok(PyArray1::from_vec(py, values).reshape([count, 2])?.into_any())
    }

    /// The diagrams of all degrees, as Ripser's users have them.
    #[getter]
    fn diagrams<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyList>> {
        let all: Vec<Bound<'py, PyAny>> =
            (0..self.degree_count()).map(|degree| self.diagram(py, degree)).collect::<PyResult<_>>()?;
        PyList::new(py, all)
    }

    /// All pairs as ``(degree, (birth, death))``, as GUDHI's users have them.
    fn to_gudhi(&self) -> Vec<(usize, (f64, f64))> {
        let never = self.never();
        let pair = |(degree, birth, death): Class| (degree, (birth, death.unwrap_or(never)));
        self.classes().into_iter().map(pair).collect()
    }

    /// The Betti curve of a degree: how many classes live at a value.
    ///
    /// Parameters
    /// ----------
    /// degree : int
    ///     The degree.
    /// at : int or array_like, optional
    ///     Values, or the number of values from the first birth or death to the last; all births and deaths if not given.
    /// end : float, optional
    ///     Where classes that never die, die.
    ///
    /// Returns
    /// -------
    /// tuple of numpy.ndarray
    ///     The values and the numbers of classes, ``float64``.
    #[pyo3(signature = (degree, *, at=None, end=None))]
    fn betti_curve<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = whole)] degree: usize,
        at: Option<&Bound<'py, PyAny>>,
        end: Option<f64>,
    ) -> PyResult<(Bound<'py, PyArray1<f64>>, Bound<'py, PyAny>)> {
        let (at, rows) =
            diagrams::curves(py, &self.given(py)?, DiagramCurveKind::Betti, Some(degree), at, end)?;
        Ok((at, rows.get_item(0)?))
    }

    /// The Euler characteristic curve: the alternating sum of the numbers of classes that live at a value.
    ///
    /// Parameters
    /// ----------
    /// at : int or array_like, optional
    ///     Values, or the number of values from the first birth or death to the last; all births and deaths if not given.
    ///
    /// Returns
    /// -------
    /// tuple of numpy.ndarray
    ///     The values and the Euler characteristics, ``float64``.
    #[pyo3(signature = (*, at=None))]
    fn euler_curve<'py>(
        &self,
        py: Python<'py>,
        at: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<(Bound<'py, PyArray1<f64>>, Bound<'py, PyAny>)> {
        let (at, rows) = diagrams::curves(py, &self.given(py)?, DiagramCurveKind::Euler, None, at, None)?;
        Ok((at, rows.get_item(0)?))
    }

    /// The first persistence landscapes of a degree (Bubenik, 2015). GUDHI multiplies them by the root of 2.
    ///
    /// Parameters
    /// ----------
    /// degree : int
    ///     The degree.
    /// count : int
    ///     How many.
    /// at : int or array_like, optional
    ///     Values, or the number of values from the first birth or death to the last; 100 if not given.
    /// end : float, optional
    ///     Where classes that never die, die.
    ///
    /// Returns
    /// -------
    /// tuple of numpy.ndarray
    ///     The values, and an array with a row for each landscape, from the largest one on.
    #[pyo3(signature = (degree, count=None, *, at=None, end=None), text_signature = "($self, degree, count=5, *, at=None, end=None)")]
    fn landscapes<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = whole)] degree: usize,
        count: Option<&Bound<'py, PyAny>>,
        at: Option<&Bound<'py, PyAny>>,
        end: Option<f64>,
    ) -> PyResult<Curves<'py>> {
        let count = count.map_or(Ok(5), whole)?;
        let kind = DiagramCurveKind::Landscape(count);
        diagrams::curves(py, &self.given(py)?, kind, Some(degree), at, end)
    }

    /// The silhouette of a degree: the mean of the tents over the intervals of births and deaths (Chazal et al., 2014).
    ///
    /// Parameters
    /// ----------
    /// degree : int
    ///     The degree.
    /// power : float
    ///     The power of the persistence that is the weight of a class.
    /// at : int or array_like, optional
    ///     Values, or the number of values from the first birth or death to the last; 100 if not given.
    /// end : float, optional
    ///     Where classes that never die, die; they are left out if not given.
    ///
    /// Returns
    /// -------
    /// tuple of numpy.ndarray
    ///     The values and the silhouette.
    #[pyo3(signature = (degree, power=1.0, *, at=None, end=None))]
    fn silhouette<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = whole)] degree: usize,
        power: f64,
        at: Option<&Bound<'py, PyAny>>,
        end: Option<f64>,
    ) -> PyResult<(Bound<'py, PyArray1<f64>>, Bound<'py, PyAny>)> {
        let kind = DiagramCurveKind::Silhouette(power);
        let (at, rows) = diagrams::curves(py, &self.given(py)?, kind, Some(degree), at, end)?;
        Ok((at, rows.get_item(0)?))
    }

    /// The persistence image of a degree (Adams et al., 2017).
    ///
    /// Parameters
    /// ----------
    /// degree : int
    ///     The degree.
    /// resolution : tuple of int
    ///     The numbers of pixels in the direction of births and of persistences.
    /// bandwidth : float, optional
    ///     The standard deviation of the normal distribution around a class; the longer side of a pixel if not given.
    /// births, persistences : tuple of float, optional
    ///     The first and the last; by default those of the classes, persistences from 0 on.
    /// power : float
    ///     The power of the persistence that is the weight of a class.
    /// end : float, optional
    ///     Where classes that never die, die; they are left out if not given.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray
    ///     ``float64``, a row for each range of persistences, from the shortest on, in which births run. A pixel is the volume over it.
    #[pyo3(signature = (degree, *, resolution=(20, 20), bandwidth=None, births=None, persistences=None, power=1.0, end=None))]
    #[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
    fn persistence_image<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = whole)] degree: usize,
        resolution: (usize, usize),
        bandwidth: Option<f64>,
        births: Option<[f64; 2]>,
        persistences: Option<[f64; 2]>,
        power: f64,
        end: Option<f64>,
    ) -> PyResult<Bound<'py, PyArray2<f64>>> {
        let request = DiagramImageRequest::new(degree)
            .resolution([resolution.0, resolution.1])
            .bandwidth(bandwidth)
            .births(births)
            .persistences(persistences)
            .power(power)
            .end(end);
        diagrams::image(py, &self.given(py)?, &request)
    }

    /// The cells that make and end the classes of a degree.
    ///
    /// Parameters
    /// ----------
    /// degree : int
    ///     The degree.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray
    ///     ``int64``, shape (n, 2): the numbers of a cell of this degree and of one of the next, -1 where there is none.
    fn pairs<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = whole)] degree: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        self.require_complex(py)?;
        let pairs = self.pairs_of_degree(degree);
        let cells = pairs.iter().flat_map(|pair| {
            let death = pair.death_cell().map_or(-1, |cell| cell.index() as i64);
            [pair.birth_cell().index() as i64, death]
        });
        Ok(PyArray1::from_vec(py, cells.collect()).reshape([pairs.len(), 2])?.into_any())
    }

    /// The vertices of the cells that make and end the classes of a degree: a list of pairs.
    fn simplices(
        &self,
        py: Python<'_>,
        #[pyo3(from_py_with = whole)] degree: usize,
    ) -> PyResult<Vec<(Vec<u32>, Option<Vec<u32>>)>> {
        Ok(match &self.diagram {
            Diagram::Complex { naming, .. } => {
                let names = |pair: &PersistencePair| {
                    let death = pair.death_cell().map(|cell| naming.vertices(degree + 1, cell.index()));
                    (naming.vertices(degree, pair.birth_cell().index()), death)
                };
                self.pairs_of_degree(degree).iter().map(names).collect()
            }
            Diagram::Points(found) => {
                let points = |simplex: &[VertexId]| found.numbers(simplex);
                let of_degree = found.pairs().iter().filter(|pair| pair.degree() == degree);
                of_degree
                    .map(|pair| (points(pair.birth_simplex()), pair.death_simplex().map(points)))
                    .collect()
            }
            Diagram::Image { .. } => return Err(no_cells(py)),
        })
    }

    /// The voxels of an image whose values are the births and deaths of the classes of a degree.
    ///
    /// Parameters
    /// ----------
    /// degree : int
    ///     The degree.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray
    ///     ``int64``, shape (n, 2, axes): for each class the place of the voxel of its birth and of that of its death along each axis, -1 where there is none.
    fn voxels<'py>(
        &self,
        py: Python<'py>,
        #[pyo3(from_py_with = whole)] degree: usize,
    ) -> PyResult<Bound<'py, PyAny>> {
        let Diagram::Image { found, .. } = &self.diagram else {
            return Err(invalid(py, "the diagram is not of an image".to_owned(), "ask .simplices(degree)"));
        };
        let axes = found.diagram().shape().len();
        let pairs = found.diagram().pairs_of_degree(degree);
        let mut places: Vec<i64> = Vec::with_capacity(2 * axes * pairs.len());
        for pair in pairs {
            let (birth, death) = found.voxels(pair);
            places.extend(birth.into_iter().map(i64::from));
            match death {
                Some(voxel) => places.extend(voxel.into_iter().map(i64::from)),
                None => places.extend(std::iter::repeat_n(-1, axes)),
            }
        }
        Ok(PyArray1::from_vec(py, places).reshape([pairs.len(), 2, axes])?.into_any())
    }

    /// What proves the classes of a degree: for each a cycle, the chain that it bounds, and a cocycle, over the field.
    ///
    /// Each is a :class:`Chain` with ``cells``, ``coefficients`` and ``simplices`` as arrays. The cycle is there from the birth on, and bounds from the death
    /// on, not before; the cocycle is one of the cells before the death, with the value 1 on the cycle. Over the field of p elements coefficients are the
    /// whole numbers of least absolute value. Cycles are made shorter by boundaries of
    /// cells that are there at the birth; the shortest ones are not promised.
    ///
    /// Parameters
    /// ----------
    /// degree : int
    ///     The degree.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// list of tuple
    ///     ``(cycle, bounding_chain, cocycle)`` for each row of :meth:`diagram`; the bounding chain is ``None`` for a class that never dies.
    ///
    /// Examples
    /// --------
    /// The rim of a triangle, which is filled later:
    ///
    /// >>> import coface
    /// >>> rim = coface.persistence([[0, 1, 2]], cell_values=[[0.0] * 3, [1.0] * 3, [5.0]])
    /// >>> ((cycle, bounding_chain, cocycle),) = rim.cycles(1)
    /// >>> cycle.simplices.tolist(), bounding_chain.simplices.tolist()
    /// ([[0, 1], [0, 2], [1, 2]], [[0, 1, 2]])
    #[pyo3(signature = (degree, *, progress=None))]
    fn cycles(
        &self,
        py: Python<'_>,
        #[pyo3(from_py_with = whole)] degree: usize,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Vec<ProvedClass>> {
        if let Some((found, cells)) = self.cubes(py)? {
            return image_cycles(py, progress, (found, cells), degree);
        }
        let Stored { prime, naming, complex, filtration, least } = &self.stored(py, progress)?;
        let found = run(py, progress, || {
            let whole = topology::persistence(complex, filtration, Coefficients::Modulo((*prime).into()))?;
            topology::persistent_cycles(complex, filtration, &whole.up_to_degree(degree), *least)
        })?;
        let chain = |degree: usize, terms: &[(CellId, Integer)], is_cochain: bool| Chain {
            degree,
            terms: terms.to_vec(),
            cell_count: complex.cell_count(degree),
            naming: Arc::clone(naming),
            is_cochain,
        };
        let found: Vec<_> = found.iter().filter(|class| class.pair().degree() == degree).collect();
        let rows = self.classes().into_iter().filter(|class| class.0 == degree).map(|row| (row.1, row.2));
        if !rows.eq(found.iter().map(|class| (class.pair().birth(), class.pair().death()))) {
            let message = "the cycles are not those of the rows of the diagram".to_owned();
            return Err(invalid(py, message, "report this: it is a fault of coface"));
        }
        let proved = found.into_iter().map(|class| {
            let bounding = class.bounding_chain().map(|bounding| chain(degree + 1, bounding.terms(), false));
            let cycle = chain(degree, class.cycle().terms(), false);
            (cycle, bounding, chain(degree, class.cocycle().terms(), true))
        });
        Ok(proved.collect())
    }

    /// The primes over whose fields other cells are paired than over the rational numbers: those of torsion along the way.
    ///
    /// Returns
    /// -------
    /// list of int
    ///     The primes, rising.
    fn torsion_primes(&self, py: Python<'_>) -> PyResult<Vec<u32>> {
        if let Some((_, cells)) = self.cubes(py)? {
            return run(py, None, || Ok(cells.found()?.torsion_primes().to_vec()));
        }
        let Stored { complex, filtration, .. } = &self.stored(py, None)?;
        run(py, None, || topology::torsion_primes(complex, filtration))
    }

    /// The cycle that a death cell fills: its boundary.
    ///
    /// Parameters
    /// ----------
    /// degree : int
    ///     The degree of the class.
    /// place : int
    ///     Its row in :meth:`diagram`.
    ///
    /// Returns
    /// -------
    /// Chain or None
    ///     The boundary of the cell that ends the class; ``None`` if it never ends.
    fn dying_cycle(
        &self,
        py: Python<'_>,
        #[pyo3(from_py_with = whole)] degree: usize,
        #[pyo3(from_py_with = whole)] place: usize,
    ) -> PyResult<Option<Chain>> {
        self.require_complex(py)?;
        self.stored(py, None)?;
        let Diagram::Complex { naming, complex, .. } = &self.diagram else { return Ok(None) };
        let Some(pair) = self.pairs_of_degree(degree).get(place) else {
            return Err(invalid(
                py,
                format!("there is no class {place} of degree {degree}"),
                "look at .diagram(degree)",
            ));
        };
        let Some(cell) = pair.death_cell() else { return Ok(None) };
        let Some(matrix) = complex.boundary_matrix(degree + 1) else { return Ok(None) };
        let terms = matrix.column(cell.index()).iter();
        let terms = terms.map(|(row, x)| (CellId::new(row), Integer::from(x))).collect();
        let cell_count = complex.cell_count(degree);
        let naming = Arc::clone(naming);
        Ok(Some(Chain { degree, terms, cell_count, naming, is_cochain: false }))
    }

    /// The diagram without classes that live no longer than this.
    fn longer_than(&self, length: f64) -> Self {
        let diagram = match &self.diagram {
            Diagram::Complex { diagram, naming, complex, filtration, least, image } => Diagram::Complex {
                diagram: diagram.longer_than(length),
                naming: Arc::clone(naming),
                complex: Arc::clone(complex),
                filtration: Arc::clone(filtration),
                least: least.max(length),
                image: *image,
            },
            Diagram::Points(found) => Diagram::Points(found.longer_than(length)),
            Diagram::Image { found, cells } => {
                Diagram::Image { found: found.longer_than(length), cells: cells.clone() }
            }
        };
        Self { diagram }
    }

    /// The diagram as a file has it.
    ///
    /// Parameters
    /// ----------
    /// format : {"gudhi", "ripser", "csv"}
    ///     The format.
    ///
    /// Returns
    /// -------
    /// bytes
    ///     The content of the file.
    fn to_bytes<'py>(&self, py: Python<'py>, format: &str) -> PyResult<Bound<'py, PyBytes>> {
        let format = match format {
            "gudhi" | "pers" => DiagramFormat::Gudhi,
            "ripser" | "txt" => DiagramFormat::Ripser,
            "csv" => DiagramFormat::Csv,
            _ => {
                return Err(invalid(
                    py,
                    format!("the format is {format:?}"),
                    "give \"gudhi\", \"ripser\" or \"csv\"",
                ));
            }
        };
        let bytes = run(py, None, || {
            let mut bytes = Vec::new();
            match &self.diagram {
                Diagram::Complex { diagram, .. } => write_diagram(diagram, &mut bytes, format)?,
                Diagram::Points(found) => found.write(&mut bytes, format)?,
                Diagram::Image { found, .. } => found.write(&mut bytes, format)?,
            }
            Ok(bytes)
        })?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// The diagram as a picture: SVG.
    #[pyo3(signature = (title="persistence diagram"))]
    fn to_svg(&self, py: Python<'_>, title: &str) -> PyResult<String> {
        run(py, None, || diagram_picture(title, &self.points())?.svg(None))
    }

    fn _picture<'py>(
        &self,
        py: Python<'py>,
        title: &str,
        format: &str,
        size: (usize, usize),
        transparent: bool,
    ) -> PyResult<Bound<'py, PyBytes>> {
        flat_file(py, format, size, transparent, || diagram_picture(title, &self.points()))
    }

    /// The numbers of edges before and after their collapse; ``None`` if they were not collapsed.
    #[getter]
    fn collapsed(&self) -> Option<(usize, usize)> {
        match &self.diagram {
            Diagram::Points(found) => found.collapsed(),
            Diagram::Complex { .. } | Diagram::Image { .. } => None,
        }
    }

    fn __len__(&self) -> usize {
        self.classes().len()
    }

    fn __repr__(&self) -> String {
        let count = self.classes().len();
        let classes = if count == 1 { "class" } else { "classes" };
        format!("Persistence(field of {}, {count} {classes})", self.prime())
    }
}
