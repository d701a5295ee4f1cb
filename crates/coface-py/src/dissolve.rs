//! Features of maps united by the values of their properties.

use crate::arrangement::{drawing_of, rule_of};
use crate::congruence::named_models;
use crate::errors::{invalid, whole_or_none};
use crate::model::Model;
use crate::target::warn_all;
use crate::work::run;
use coface::answers::{BooleanRequest, DissolveRequest, Dissolved, DrawingOptions};
use pyo3::prelude::*;

/// Features of maps with the same values of properties, united: one feature for each list of values.
///
/// Parameters
/// ----------
/// models : sequence of Model, or dict of str to Model
///     The maps.
/// names : sequence of str
///     The names of the properties.
/// dimension : {2}, optional
///     2 leaves out the heights of maps.
/// rule : {"nonzero", "evenodd", "positive"}, optional
///     What is inside a ring.
/// snap : bool
///     Whether coordinates are rounded so that the result stays as it is.
/// exact : bool
///     Whether the exact result is kept where rounding its coordinates makes edges cross.
/// grid : float, optional
///     All coordinates are multiples of this length.
/// close : bool
///     Whether lines that end where they begin are rings of polygons.
/// max_cells : int, optional
///     More cells than this are refused.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// Model
///     A map with a feature for each list of values.
///
/// Examples
/// --------
/// >>> import coface, json
/// >>> def lot(x, owner):
/// ...     ring = [[x, 0], [x + 1, 0], [x + 1, 1], [x, 1], [x, 0]]
/// ...     geometry = {"type": "Polygon", "coordinates": [ring]}
/// ...     return {"type": "Feature", "properties": {"owner": owner}, "geometry": geometry}
/// >>> lots = {"type": "FeatureCollection", "features": [lot(0, "A"), lot(1, "A"), lot(2, "B")]}
/// >>> model = coface.Model.from_bytes(json.dumps(lots).encode(), "geojson")
/// >>> found = coface._coface.dissolve([model], ["owner"])
/// >>> [feature["properties"] for feature in found.__geo_interface__["features"]]
/// [{'owner': 'A', 'features': 2, 'area': 2}, {'owner': 'B', 'features': 1, 'area': 1}]
#[pyfunction]
#[pyo3(signature = (models, names, *, dimension=None, rule=None, snap=false, exact=false, grid=None, close=false, max_cells=None, progress=None))]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn dissolve(
    py: Python<'_>,
    models: &Bound<'_, PyAny>,
    names: Vec<String>,
    dimension: Option<u8>,
    rule: Option<&str>,
    snap: bool,
    exact: bool,
    grid: Option<f64>,
    close: bool,
    #[pyo3(from_py_with = whole_or_none)] max_cells: Option<usize>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Model> {
    if let Some(other) = dimension.filter(|&dimension| dimension != 2) {
        return Err(invalid(
            py,
            format!("dimension is {other}"),
            "give 2, or leave it out: maps lie in the plane",
        ));
    }
    let models = named_models(models)?;
    let mut boolean = BooleanRequest::default();
    (boolean.rule, boolean.snap, boolean.exact) = (rule_of(py, rule)?, snap, exact);
    (boolean.grid, boolean.max_cells) = (grid, max_cells);
    let options = DrawingOptions::new().close_lines(close);
    let dissolved = run(py, progress, || {
        let drawing = drawing_of(&models, &options, dimension)?;
        Dissolved::new(&drawing, &DissolveRequest::new(names).boolean(boolean))
    })?;
    let remarks = &dissolved.answer().remarks;
    warn_all(py, remarks)?;
    Ok(Model::of(dissolved.model().clone().with_remarks(remarks.iter().cloned())))
}
