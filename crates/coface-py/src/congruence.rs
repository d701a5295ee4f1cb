//! Models merged within a tolerance.

use crate::answer::answer;
use crate::arrays;
use crate::chain_complex::ChainComplex;
use crate::errors::{OrRaise, invalid};
use crate::given::source_of;
use crate::memory::owned_matrix;
use crate::model::Model;
use crate::objects::text_of;
use crate::spatial_arrangement::{write_model, written_bytes};
use crate::work::run;
use coface::Error;
use coface::answers::answer::CongruenceAnswer;
use coface::answers::{BlockRule, CongruenceRequest, ModelCongruence};
use coface::arrange::congruence::{BlockPolicy, ClassRule, Collisions, CongruenceMethod, Representative};
use coface::io::{self, Format};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyBytes;

/// Models merged within a tolerance: vertices nearby become one, and edges, faces and cells with them.
///
/// Made by :func:`congruence`.
#[pyclass(frozen, dict, module = "coface", name = "Congruence")]
pub(crate) struct Congruence {
    congruence: ModelCongruence,
    answer: CongruenceAnswer,
}

/// What a word stands for.
pub(crate) fn choice<T: Copy>(py: Python<'_>, name: &str, word: &str, choices: &[(&str, T)]) -> PyResult<T> {
    match choices.iter().find(|(choice, _)| *choice == word) {
        Some((_, value)) => Ok(*value),
        None => {
            let words: Vec<&str> = choices.iter().map(|(word, _)| *word).collect();
            Err(invalid(py, format!("{name} is {word:?}"), &format!("give one of {}", words.join(", "))))
        }
    }
}

/// Models with names, from a list or a dictionary.
pub(crate) fn named_models(
    inputs: &Bound<'_, PyAny>,
) -> PyResult<Vec<(String, std::sync::Arc<crate::source::Source>)>> {
    let py = inputs.py();
    if let Ok(dict) = inputs.cast::<pyo3::types::PyDict>() {
        return dict
            .iter()
            .map(|(name, model)| Ok((name.str()?.to_str()?.to_owned(), source_of(&model)?)))
            .collect();
    }
    if let Ok(source) = source_of(inputs) {
        return Ok(vec![("input 0".to_owned(), source)]);
    }
    let mut models = Vec::new();
    for (i, model) in inputs.try_iter()?.enumerate() {
        models.push((format!("input {i}"), source_of(&model?)?));
    }
    if models.is_empty() {
        return Err(invalid(py, "there are no models", "give one or more"));
    }
    Ok(models)
}

/// Merges models within a tolerance.
///
/// Parameters
/// ----------
/// models : Model, sequence of Model, or dict of str to Model
///     The models.
/// tolerance : float
///     How near vertices become one, in the unit of the models.
/// greedy : bool
///     Whether a class is what is near its first vertex, instead of chains of near vertices.
/// representative : {"lowest", "mean", "median"}
///     Where a class is.
/// stable : bool
///     Whether classes are merged again until none are near.
/// collisions : {"rewrap", "keep", "refuse"}
///     What becomes of cells that lose terms without vanishing.
/// blocks : {"models", "components", "none"}
///     What a block is, for merges within one.
/// within_blocks : {"allow", "warn", "forbid"}
///     Whether vertices of one block may become one.
/// method : {"lists", "matrices"}
///     How it is computed; the result is the same.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// Congruence
///     The quotient, with the classes and signs of all cells.
///
/// Examples
/// --------
/// >>> import coface
/// >>> left = coface.Model([[0, 0], [1, 0], [0, 1]], [[0, 1, 2]])
/// >>> right = coface.Model([[1.0001, 0], [0, 1], [1, 1]], [[0, 2, 1]])
/// >>> merged = coface._coface.congruence([left, right], 0.01)
/// >>> merged.f_vector_before, merged.f_vector
/// ([6, 6, 2], [4, 5, 2])
#[pyfunction]
#[pyo3(signature = (models, tolerance, *, greedy=false, representative="lowest", stable=false, collisions="rewrap", blocks="models", within_blocks="allow", method="lists", progress=None))]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn congruence(
    py: Python<'_>,
    models: &Bound<'_, PyAny>,
    tolerance: f64,
    greedy: bool,
    representative: &str,
    stable: bool,
    collisions: &str,
    blocks: &str,
    within_blocks: &str,
    method: &str,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Congruence> {
    let mut request = CongruenceRequest::within(checked_tolerance(py, tolerance)?);
    request.rule = if greedy { ClassRule::Greedy } else { ClassRule::Transitive };
    let places = [
        ("lowest", Representative::Lowest),
        ("mean", Representative::Mean),
        ("median", Representative::Median),
    ];
    request.representative = choice(py, "representative", representative, &places)?;
    request.stable = stable;
    let kinds = [("rewrap", Collisions::Rewrap), ("keep", Collisions::Keep), ("refuse", Collisions::Refuse)];
    request.options = request.options.collisions(choice(py, "collisions", collisions, &kinds)?);
    let methods = [("lists", CongruenceMethod::Lists), ("matrices", CongruenceMethod::Matrices)];
    request.options = request.options.method(choice(py, "method", method, &methods)?);
    let rules =
        [("models", BlockRule::Models), ("components", BlockRule::Components), ("none", BlockRule::None)];
    request.blocks = choice(py, "blocks", blocks, &rules)?;
    let policies =
        [("allow", BlockPolicy::Allow), ("warn", BlockPolicy::Warn), ("forbid", BlockPolicy::Forbid)];
    request.within_blocks = choice(py, "within_blocks", within_blocks, &policies)?;
    let models = named_models(models)?;
    let (congruence, answer) = run(py, progress, || {
        let models = models.iter().map(|(name, source)| (name.clone(), source.model.clone())).collect();
        let congruence = ModelCongruence::of(models, &request)?;
        let answer = congruence.answer()?;
        Ok((congruence, answer))
    })?;
    Ok(Congruence { congruence, answer })
}

answer! { Congruence {
    /// The numbers of cells before.
    f_vector_before,
    /// The numbers of cells after.
    f_vector,
    /// The numbers of classes by degree.
    classes,
    /// The largest distance of vertices that became one.
    largest_class_diameter,
    /// How many cells vanished, by degree.
    discarded,
    /// Whether products of boundary matrices are zero, found by multiplying.
    products_zero,
}
    /// The class of each cell of a degree: ``int64``, -1 for cells that vanished or became several classes.
    fn class_of<'py>(&self, py: Python<'py>, degree: usize) -> Bound<'py, PyArray1<i64>> {
        let classes = self.congruence.chains().classes().get(degree);
        let of = classes.into_iter().flat_map(|classes| {
            (0..classes.cell_count()).map(|cell| {
                classes.class(coface::CellId::new(cell)).map_or(-1, |(class, _)| class as i64)
            })
        });
        PyArray1::from_vec(py, of.collect())
    }

    /// The chain map onto the quotient: column j is the signed sum of classes that cell j became.
    fn matrix<'py>(&self, py: Python<'py>, degree: usize) -> PyResult<Bound<'py, PyAny>> {
        let Some(classes) = self.congruence.chains().classes().get(degree) else {
            return Err(invalid(py, format!("there are no cells of degree {degree}"), "look at .f_vector_before"));
        };
        let matrix = run(py, None, || classes.matrix())?;
        owned_matrix(py, matrix)
    }

    /// The positions of the classes of vertices.
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let positions = self.congruence.vertices().positions();
        let flat = positions.as_flat().to_vec();
        Ok(arrays::grid(py, flat, positions.dimension())?.into_any())
    }

    /// The chain complex of the quotient.
    fn chain_complex(&self) -> ChainComplex {
        ChainComplex::bare(self.congruence.complex().clone())
    }

    /// The merged mesh.
    ///
    /// Raises
    /// ------
    /// UnsupportedFormatError
    ///     If its cells are no polygons and 3-cells any more; :meth:`chain_complex` has them.
    #[pyo3(signature = (*, progress=None))]
    fn model(&self, py: Python<'_>, progress: Option<&Bound<'_, PyAny>>) -> PyResult<Model> {
        run(py, progress, || self.congruence.to_mesh()).map(Model::of)
    }

    /// The cells of the quotient as a chain complex with positions: what ``.json`` holds, and what homology and other questions about cells
    /// are asked of.
    #[getter]
    fn cells(&self, py: Python<'_>) -> PyResult<Model> {
        run(py, None, || self.congruence.to_chains()).map(Model::of)
    }

    /// The quotient as a file of this format: ``json`` has the cells, others the merged mesh.
    fn to_bytes<'py>(&self, py: Python<'py>, format: &str) -> PyResult<Bound<'py, PyBytes>> {
        let format = Format::from_name(format).or_raise(py)?;
        let bytes = run(py, None, || written_bytes(&self.written(format)?, format))?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// Writes the quotient to a file, by its path or open for writing: ``.json`` has the cells, others the merged mesh.
    #[pyo3(signature = (path, format=None))]
    fn write(&self, py: Python<'_>, path: &Bound<'_, PyAny>, format: Option<&str>) -> PyResult<()> {
        write_model(py, path, format, |format| self.written(format))
    }

    fn __repr__(&self) -> String {
        let [after, before] = [&self.answer.f_vector, &self.answer.f_vector_before].map(text_of);
        format!("Congruence({after} from {before})")
    }
}

impl Congruence {
    /// What a file of this format holds, as the program writes it.
    fn written(&self, format: Format) -> Result<io::Model, Error> {
        match format {
            Format::Json => self.congruence.to_chains(),
            _ => self.congruence.to_mesh(),
        }
    }
}

/// A tolerance that is one.
pub(crate) fn checked_tolerance(py: Python<'_>, tolerance: f64) -> PyResult<f64> {
    match tolerance.is_finite() && tolerance >= 0.0 {
        true => Ok(tolerance),
        false => Err(invalid(
            py,
            format!("the tolerance is {tolerance}"),
            "give a finite length that is not negative",
        )),
    }
}
