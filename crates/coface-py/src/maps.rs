//! Maps changed feature by feature.

use crate::congruence::{choice, named_models};
use crate::errors::invalid;
use crate::model::Model;
use crate::objects::to_python;
use crate::target::warn_all;
use crate::work::run;
use coface::answers::{
    BufferCaps, BufferJoins, BufferOptions, LineOptions, MapResult, MapTask, RepairMethod,
};
use pyo3::prelude::*;

const METHODS: [(&str, RepairMethod); 2] =
    [("structure", RepairMethod::Structure), ("linework", RepairMethod::Linework)];
const CAPS: [(&str, BufferCaps); 3] =
    [("round", BufferCaps::Round), ("flat", BufferCaps::Flat), ("square", BufferCaps::Square)];

/// A map repaired, buffered, clipped, noded, made polygons, simplified, or examined as a coverage.
///
/// Parameters
/// ----------
/// models : sequence of Model, or dict of str to Model
///     The maps.
/// task : {"repair", "buffer", "clip", "node", "polygonize", "simplify", "coverage"}
///     What is done.
/// method : {"structure", "linework"}
///     What is inside of a polygon that is not valid.
/// length : float, optional
///     The distance of a buffer, the tolerance of a simplification, the width of gaps that are faults.
/// error : float, optional
///     How far flattened arcs of a buffer may be from true ones; a thousandth of the distance if left out.
/// joins : {"round", "mitre", "bevel"}
///     How corners of a buffer are joined.
/// mitre_limit : float
///     How many times the distance a mitred corner may be away.
/// caps : {"round", "flat", "square"}
///     How the ends of lines are closed.
/// frame : sequence of four float, optional
///     The box of clip: least x, least y, greatest x, greatest y.
/// snap : bool
///     Whether coordinates of node and polygonize are rounded, and lines cut again, until all vertices are where their coordinates say.
/// grid : float, optional
///     The length of which all coordinates of node and polygonize are multiples.
/// tolerance : float, optional
///     How far apart vertices and lines of node and polygonize may be that are put together.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// tuple of Model and dict
///     The new map, and what was done in numbers.
///
/// Examples
/// --------
/// >>> import coface
/// >>> square = coface.Model.from_bytes(b"POLYGON ((0 0, 2 0, 2 2, 0 2, 0 0))", "wkt")
/// >>> coface._coface.map_task([square], "buffer", length=1.0, joins="mitre")[1]["measure"]
/// 16.0
#[pyfunction]
#[pyo3(signature = (models, task, *, method="structure", length=None, error=None, joins="round", mitre_limit=5.0, caps="round", frame=None, snap=false, grid=None, tolerance=None, progress=None))]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn map_task<'py>(
    py: Python<'py>,
    models: &Bound<'py, PyAny>,
    task: &str,
    method: &str,
    length: Option<f64>,
    error: Option<f64>,
    joins: &str,
    mitre_limit: f64,
    caps: &str,
    frame: Option<[f64; 4]>,
    snap: bool,
    grid: Option<f64>,
    tolerance: Option<f64>,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<(Model, Bound<'py, PyAny>)> {
    let joins_of = [
        ("round", BufferJoins::Round),
        ("mitre", BufferJoins::Mitre(mitre_limit)),
        ("bevel", BufferJoins::Bevel),
    ];
    let needed = |length: Option<f64>| {
        length.ok_or_else(|| invalid(py, format!("{task} has no length"), "give a number"))
    };
    let lines = LineOptions::new().snap(snap).grid(grid).tolerance(tolerance);
    let task = match task {
        "repair" => MapTask::Repair(choice(py, "method", method, &METHODS)?),
        "buffer" => {
            let options = BufferOptions::new(needed(length)?)
                .joins(choice(py, "joins", joins, &joins_of)?)
                .caps(choice(py, "caps", caps, &CAPS)?);
            MapTask::Buffer(error.map_or(options, |error| options.error(error)))
        }
        "clip" => match frame {
            Some(frame) => MapTask::Clip(frame),
            None => return Err(invalid(py, "clip has no box".to_owned(), "give four numbers")),
        },
        "node" => MapTask::Node(lines),
        "polygonize" => MapTask::Polygonize(lines),
        "simplify" => MapTask::Simplify(needed(length)?),
        "coverage" => MapTask::Coverage { gap_width: length },
        _ => {
            let cure = "give one of repair, buffer, clip, node, polygonize, simplify, coverage";
            return Err(invalid(py, format!("task is {task:?}"), cure));
        }
    };
    let models = named_models(models)?;
    let result = run(py, progress, || {
        MapResult::new(models.iter().map(|(name, source)| (name.as_str(), &source.model)), &task)
    })?;
    warn_all(py, &result.answer().remarks)?;
    let answer = to_python(py, result.answer())?;
    let model = result.model().clone().with_remarks(result.answer().remarks.iter().cloned());
    Ok((Model::of(model), answer))
}
