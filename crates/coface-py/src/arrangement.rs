//! What drawings cut the plane into and surfaces space, and what Boolean formulas select of it.

use crate::answer::answer;
use crate::arrays;
use crate::chain_complex::ChainComplex;
use crate::congruence::{choice, named_models};
use crate::errors::{OrRaise, invalid, whole_or_none};
use crate::model::Model;
use crate::objects::{remarks_of, text_of, to_python};
use crate::solid_boolean::{Combined, solid_result};
use crate::source::Source;
use crate::spatial_arrangement::{Arranged, SpatialArrangement};
use crate::spatial_request::{precision_of, spatial_request};
use crate::target::{Target, warn_all};
use crate::work::run;
use coface::answers::answer::{
    PlanarArrangementAnswer, PlanarBooleanAnswer, SolidBooleanAnswer, SolidBooleanProvenance,
};
use coface::answers::{
    ArrangementMethod, ArrangementRequest, BooleanRequest, CongruentBoolean, CongruentScene,
    DrawingArrangement, DrawingOptions, PlanarDrawing, RegionBoolean, RegionSource, SceneArrangement,
    SolidBoolean, SolidRequest, SpatialRequest, SpatialScene, are_planar, welded,
};
use coface::arrange::CoordinatePrecision;
use coface::arrange::boolean::{BooleanFormula, InsideRule};
use coface::arrange::spatial::NonPlanar;
use coface::io;
use coface::io::Format;
use coface::{EdgeId, Error, FaceId};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use std::sync::Arc;

const RULES: [(&str, InsideRule); 3] =
    [("nonzero", InsideRule::Nonzero), ("evenodd", InsideRule::Odd), ("positive", InsideRule::Positive)];

pub(crate) fn rule_of(py: Python<'_>, rule: Option<&str>) -> PyResult<Option<InsideRule>> {
    rule.map(|rule| choice(py, "rule", rule, &RULES)).transpose()
}

type Named = Vec<(String, Arc<Source>)>;

fn borrowed(models: &Named) -> impl Iterator<Item = (&str, &io::Model)> {
    models.iter().map(|(name, source)| (name.as_str(), &source.model))
}

fn is_flat(py: Python<'_>, models: &Named, dimension: Option<u8>) -> PyResult<bool> {
    match dimension {
        None => Ok(are_planar(models.iter().map(|(_, source)| &source.model))),
        Some(2) => Ok(true),
        Some(3) => Ok(false),
        Some(other) => Err(invalid(py, format!("dimension is {other}"), "give 2 or 3")),
    }
}

/// What models draw, without heights if the plane was asked for.
pub(crate) fn drawing_of(
    models: &Named,
    options: &DrawingOptions,
    dimension: Option<u8>,
) -> Result<PlanarDrawing, Error> {
    let drawing = PlanarDrawing::with_options(borrowed(models), options)?;
    Ok(if dimension == Some(2) { drawing.without_heights() } else { drawing })
}

/// Names in the words of the package: inputs, where the program says files.
fn write_bytes(write: impl FnOnce(&mut Vec<u8>) -> Result<(), Error>) -> Result<Vec<u8>, Error> {
    let mut bytes = Vec::new();
    write(&mut bytes)?;
    Ok(bytes)
}

/// What segments cut the plane into, or polygons space, exactly.
///
/// Parameters
/// ----------
/// models : Model, sequence of Model, or dict of str to Model
///     The inputs.
/// dimension : {2, 3}, optional
///     The plane or space; by the models if left out. 2 leaves out the heights of maps.
/// rule : {"nonzero", "evenodd", "positive"}, optional
///     What is inside an input.
/// features : bool
///     The same as ``inputs="features"``.
/// inputs : {"files", "features", "objects", "groups", "components"}, optional
///     What an input is: a model, or its polygons of one name, its objects, groups or connected components.
/// prune : bool
///     In the plane, whether edges that hang on the rest by one end are left out.
/// snap : bool
///     Whether coordinates are rounded so that the result stays as it is.
/// exact : bool
///     Whether the exact result is kept where rounding its coordinates makes edges or faces cross; otherwise these are cut and bent
///     there by a few units of the last digit. Its model, and ``.json`` written of it, keep exact points, so that the next call takes it
///     as it is.
/// grid : float, optional
///     In the plane, all coordinates are multiples of this length.
/// close : bool
///     In the plane, whether lines that end where they begin are rings of polygons.
/// tolerance : float, optional
///     Vertices, edges, in space faces and planes too, at most so far apart are put together, in the unit of the inputs.
/// weld : float, optional
///     Before anything else, vertices of each model that are at most so far apart are merged; none moves farther.
/// method : {"exact", "congruence"}, optional
///     How cells are found: ``"congruence"`` cuts each segment, in space each polygon in its own plane, for itself, in rounded numbers,
///     and pieces that are within ``tolerance`` of each other become one; without it within 1e-9 of the extent, with a warning.
/// max_cells : int, optional
///     More cells than this are refused.
/// split : bool
///     In space, whether polygons that are not flat are split into triangles; otherwise they are refused.
/// merge_coplanar : bool
///     In space, whether faces of polygons in one plane are merged.
/// precision : {"double", "single"}
///     In space, which numbers coordinates of the result are, of 64 bits or of 32: it is valid with these.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// PlanarArrangement or SpatialArrangement
///     The cells, what contains them, and where they come from.
///
/// Examples
/// --------
/// Two crossing squares:
///
/// >>> import coface
/// >>> ring = [[0, 1, 2, 3, 0]]
/// >>> a = coface.Model.from_arrays([[0, 0], [2, 0], [2, 2], [0, 2]], cells={"polyline": ring})
/// >>> b = coface.Model.from_arrays([[1, 1], [3, 1], [3, 3], [1, 3]], cells={"polyline": ring})
/// >>> arranged = coface._coface.arrange([a, b])
/// >>> arranged.f_vector, sorted(zip(arranged.measures, arranged.inside))
/// ([10, 12, 3], [(1.0, [0, 1]), (3.0, [0]), (3.0, [1])])
#[pyfunction]
#[pyo3(signature = (models, *, dimension=None, rule=None, features=false, inputs=None, prune=false, snap=false, exact=false, grid=None, close=false, tolerance=None, weld=None, method=None, max_cells=None, split=true, merge_coplanar=true, precision="double", progress=None))]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn arrange<'py>(
    py: Python<'py>,
    models: &Bound<'py, PyAny>,
    dimension: Option<u8>,
    rule: Option<&str>,
    features: bool,
    inputs: Option<&str>,
    prune: bool,
    snap: bool,
    exact: bool,
    grid: Option<f64>,
    close: bool,
    tolerance: Option<f64>,
    weld: Option<f64>,
    method: Option<&str>,
    #[pyo3(from_py_with = whole_or_none)] max_cells: Option<usize>,
    split: bool,
    merge_coplanar: bool,
    precision: &str,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let models = welded_models(py, named_models(models)?, weld)?;
    let inputs = inputs_of(py, inputs, features)?;
    let rule = rule_of(py, rule)?;
    let method = method_of(py, method)?;
    let precision = precision_of(py, precision)?;
    if is_flat(py, &models, dimension)? {
        if precision != CoordinatePrecision::default() {
            return Err(invalid(py, "precision is for polygons in space", "leave it out in the plane"));
        }
        let mut request = ArrangementRequest::default();
        (request.rule, request.prune, request.snap, request.max_cells) = (rule, prune, snap, max_cells);
        (request.exact, request.grid, request.tolerance) = (exact, grid, tolerance);
        request.method = method;
        let options = DrawingOptions::new().source(inputs.unwrap_or_default()).close_lines(close);
        let (arranged, answer) = run(py, progress, || {
            let arranged = DrawingArrangement::new(drawing_of(&models, &options, dimension)?, &request)?;
            let answer = arranged.answer()?;
            Ok((arranged, answer))
        })?;
        warn_all(py, &answer.remarks)?;
        return Ok(Bound::new(py, PlanarArrangement { arranged, answer })?.into_any());
    }
    if prune {
        return Err(invalid(py, "prune is for drawings in the plane", "leave it out in space"));
    }
    refuse_planar(py, grid, close)?;
    if method == ArrangementMethod::Congruence {
        let rule = rule.unwrap_or_default();
        let bent = if split { NonPlanar::Split } else { NonPlanar::Refuse };
        let glued = run(py, progress, || {
            let scene = scene_of(&models, inputs, 1, true)?;
            let glued = CongruentScene::with_bent(scene, tolerance, bent)?;
            glued.refuse_more_cells(max_cells)?;
            Ok(glued)
        })?;
        if snap || exact {
            // Exact cells of what is glued.
            let request = spatial_request(snap, None, max_cells, true, merge_coplanar, precision);
            let (arranged, answer) = run(py, None, || {
                let mut arranged = SceneArrangement::of_scene(glued.glued_scene(), &request)?;
                if !exact && !arranged.is_valid()? {
                    arranged = arranged.validly_rounded()?.unwrap_or(arranged);
                }
                let mut answer = arranged.answer(rule)?;
                let (done, joined) = glued.gluing()?;
                (answer.congruence, answer.joined) = (Some(done), answer.joined.or(Some(joined)));
                Ok((arranged, answer))
            })?;
            let arranged = Arranged::Exact(Box::new(arranged));
            warn_all(py, &answer.remarks)?;
            return Ok(Bound::new(py, SpatialArrangement { arranged, rule, answer, exact })?.into_any());
        }
        let (arranged, answer) = run(py, None, || {
            let answer = glued.answer(rule)?;
            Ok((glued, answer))
        })?;
        let arranged = Arranged::Congruent(Box::new(arranged));
        warn_all(py, &answer.remarks)?;
        return Ok(Bound::new(py, SpatialArrangement { arranged, rule, answer, exact })?.into_any());
    }
    let request = spatial_request(snap, tolerance, max_cells, split, merge_coplanar, precision);
    let (arranged, answer) = run(py, progress, || {
        let mut arranged = SceneArrangement::of_scene(scene_of(&models, inputs, 1, true)?, &request)?;
        if !exact && !arranged.is_valid()? {
            arranged = arranged.validly_rounded()?.unwrap_or(arranged);
        }
        let answer = arranged.answer(rule.unwrap_or_default())?;
        Ok((arranged, answer))
    })?;
    let rule = rule.unwrap_or_default();
    let arranged = Arranged::Exact(Box::new(arranged));
    warn_all(py, &answer.remarks)?;
    Ok(Bound::new(py, SpatialArrangement { arranged, rule, answer, exact })?.into_any())
}

const SOURCES: [(&str, RegionSource); 5] = [
    ("files", RegionSource::Models),
    ("features", RegionSource::Features),
    ("objects", RegionSource::Objects),
    ("groups", RegionSource::Groups),
    ("components", RegionSource::Components),
];

/// What an input is, if it was said.
fn inputs_of(py: Python<'_>, inputs: Option<&str>, features: bool) -> PyResult<Option<RegionSource>> {
    match inputs {
        Some(inputs) => choice(py, "inputs", inputs, &SOURCES).map(Some),
        None => Ok(features.then_some(RegionSource::Features)),
    }
}

const METHODS: [(&str, ArrangementMethod); 2] =
    [("exact", ArrangementMethod::Exact), ("congruence", ArrangementMethod::Congruence)];

/// How cells are found.
fn method_of(py: Python<'_>, method: Option<&str>) -> PyResult<ArrangementMethod> {
    Ok(method.map(|word| choice(py, "method", word, &METHODS)).transpose()?.unwrap_or_default())
}

/// Models whose vertices are merged if they are at most so far apart.
fn welded_models(py: Python<'_>, models: Named, radius: Option<f64>) -> PyResult<Named> {
    let Some(radius) = radius else { return Ok(models) };
    run(py, None, || {
        let merged = models.into_iter().map(|(name, source)| {
            let (model, done) = welded(&source.model, radius).map_err(|error| error.in_file(name.clone()))?;
            Ok((name, Source::new(model.with_remarks(done.remark()))))
        });
        merged.collect::<Result<Named, Error>>()
    })
}

/// The polygons of the models; if it was not said what an input is, objects are where a formula names more inputs than
/// there are models.
fn scene_of(
    models: &Named,
    inputs: Option<RegionSource>,
    count: usize,
    walls: bool,
) -> Result<SpatialScene, Error> {
    match inputs {
        Some(inputs) => SpatialScene::with_inputs(borrowed(models), inputs, walls),
        None => SpatialScene::of_at_least(count, borrowed(models), walls),
    }
}

/// The number of inputs that a word or a formula needs.
fn least_inputs(operation: &str) -> usize {
    match operation {
        "union" | "join" | "intersection" | "meet" | "difference" | "xor" => 1,
        text => BooleanFormula::parse(text, &[]).map_or(1, |formula| formula.input_count()),
    }
}

/// Refuses what is for drawings in the plane.
fn refuse_planar(py: Python<'_>, grid: Option<f64>, close: bool) -> PyResult<()> {
    if close {
        return Err(invalid(py, "close is for drawings in the plane", "leave it out in space"));
    }
    match grid {
        Some(_) => Err(invalid(py, "grid is for drawings in the plane", "leave it out in space")),
        None => Ok(()),
    }
}

/// Combines regions of the plane, or solids, exactly.
///
/// Parameters
/// ----------
/// operation : str
///     ``"union"``, ``"intersection"``, ``"difference"``, ``"xor"``, or a formula of inputs by number, such as ``"(0 | 1) & !2"``.
/// models : sequence of Model, or dict of str to Model
///     The inputs.
/// dimension : {2, 3}, optional
///     The plane or space; by the models if left out. 2 leaves out the heights of maps.
/// rule : {"nonzero", "evenodd", "positive"}, optional
///     What is inside an input.
/// features : bool
///     The same as ``inputs="features"``.
/// inputs : {"files", "features", "objects", "groups", "components"}, optional
///     What an input is: a model, or its polygons of one name, its objects, groups or connected components.
/// keep_walls : bool
///     Whether what lies inside the result is kept.
/// snap : bool
///     Whether coordinates are rounded so that the result stays as it is.
/// exact : bool
///     Whether the exact result is kept where rounding its coordinates makes edges or faces cross; otherwise these are cut and bent
///     there by a few units of the last digit. Its model, and ``.json`` written of it, keep exact points, so that the next call takes it
///     as it is.
/// grid : float, optional
///     In the plane, all coordinates are multiples of this length.
/// close : bool
///     In the plane, whether lines that end where they begin are rings of polygons.
/// tolerance : float, optional
///     Vertices, edges, in space faces and planes too, at most so far apart are put together, in the unit of the inputs.
/// weld : float, optional
///     Before anything else, vertices of each model that are at most so far apart are merged; none moves farther.
/// method : {"exact", "congruence"}, optional
///     How cells are found, as for :func:`arrange`.
/// max_cells : int, optional
///     More cells than this are refused.
/// split : bool
///     In space, whether polygons that are not flat are split into triangles; otherwise they are refused.
/// merge_coplanar : bool
///     In space, whether faces of polygons in one plane are merged.
/// triangles : bool, optional
///     In space, whether faces are cut into triangles; if all inputs are triangles, if left out.
/// open : {"refuse", "close"}
///     In space, what becomes of an input with a rim: it is refused, or its mouths are closed with patches of least area.
/// split_pinches : bool
///     In space, whether edges and vertices where the result is no surface are duplicated.
/// precision : {"double", "single"}
///     In space, which numbers coordinates of the result are, of 64 bits or of 32: it is valid with these.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// PlanarBoolean or SolidBoolean
///     The result, which is input again.
///
/// Raises
/// ------
/// NotACycleError
///     If an input is open; the message names its rim.
///
/// Examples
/// --------
/// >>> import coface
/// >>> cube = coface.generate("box", boundary=True)
/// >>> moved = coface.Model(cube.vertices + 0.5, cube.faces)
/// >>> coface._coface.boolean("intersection", [cube, moved]).measure
/// 0.125
#[pyfunction]
#[pyo3(signature = (operation, models, *, dimension=None, rule=None, features=false, inputs=None, keep_walls=false, snap=false, exact=false, grid=None, close=false, tolerance=None, weld=None, method=None, max_cells=None, split=true, merge_coplanar=true, triangles=None, open="refuse", split_pinches=false, precision="double", progress=None))]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn boolean<'py>(
    py: Python<'py>,
    operation: &str,
    models: &Bound<'py, PyAny>,
    dimension: Option<u8>,
    rule: Option<&str>,
    features: bool,
    inputs: Option<&str>,
    keep_walls: bool,
    snap: bool,
    exact: bool,
    grid: Option<f64>,
    close: bool,
    tolerance: Option<f64>,
    weld: Option<f64>,
    method: Option<&str>,
    #[pyo3(from_py_with = whole_or_none)] max_cells: Option<usize>,
    split: bool,
    merge_coplanar: bool,
    triangles: Option<bool>,
    open: &str,
    split_pinches: bool,
    precision: &str,
    progress: Option<&Bound<'py, PyAny>>,
) -> PyResult<Bound<'py, PyAny>> {
    let models = welded_models(py, named_models(models)?, weld)?;
    let inputs = inputs_of(py, inputs, features)?;
    let rule = rule_of(py, rule)?;
    let method = method_of(py, method)?;
    let precision = precision_of(py, precision)?;
    let closes_mouths = choice(py, "open", open, &[("refuse", false), ("close", true), ("winding", true)])?;
    if is_flat(py, &models, dimension)? {
        if precision != CoordinatePrecision::default() {
            return Err(invalid(py, "precision is for polygons in space", "leave it out in the plane"));
        }
        let mut request = BooleanRequest::default();
        (request.rule, request.keep_walls, request.snap, request.max_cells) =
            (rule, keep_walls, snap, max_cells);
        (request.exact, request.grid, request.tolerance) = (exact, grid, tolerance);
        request.method = method;
        let options = DrawingOptions::new().source(inputs.unwrap_or_default()).close_lines(close);
        let result = run(py, progress, || {
            let drawing = drawing_of(&models, &options, dimension)?;
            let count = drawing.region_names().len();
            if count == 0 {
                return Err(Error::invalid("there is no region in the inputs")
                    .with_cure("give polygons or closed lines"));
            }
            RegionBoolean::new(drawing, &formula(operation, count)?, &request)
        })?;
        let answer = result.answer();
        warn_all(py, &answer.remarks)?;
        return Ok(Bound::new(py, PlanarBoolean { result, answer })?.into_any());
    }
    refuse_planar(py, grid, close)?;
    if method == ArrangementMethod::Congruence {
        let bent = if split { NonPlanar::Split } else { NonPlanar::Refuse };
        if snap || exact || split_pinches {
            let solid = run(py, progress, || {
                let mut scene = scene_of(&models, inputs, least_inputs(operation), keep_walls)?;
                if closes_mouths {
                    scene.close_mouths()?;
                }
                let triangles = triangles.unwrap_or_else(|| scene.is_triangulated());
                let glued = CongruentScene::with_bent(scene, tolerance, bent)?;
                glued.refuse_more_cells(max_cells)?;
                let scene = glued.glued_scene();
                let mut request = SolidRequest::of(formula(operation, scene.names().len())?);
                request.triangles = triangles;
                (request.rule, request.keep_walls) = (rule.unwrap_or_default(), keep_walls);
                request.split_pinches = split_pinches;
                request.merge_coplanar = merge_coplanar && !exact;
                let spatial = spatial_request(snap, None, max_cells, true, merge_coplanar, precision);
                let combined = combined(scene, &spatial, request, exact)?;
                let (done, joined) = glued.gluing()?;
                let mut answer = combined.0;
                (answer.congruence, answer.joined) = (Some(done), answer.joined.or(Some(joined)));
                Ok((answer, combined.1, combined.2, combined.3, combined.4))
            })?;
            return solid_result(py, solid);
        }
        let glued = run(py, progress, || {
            let mut scene = scene_of(&models, inputs, least_inputs(operation), keep_walls)?;
            if closes_mouths {
                scene.close_mouths()?;
            }
            let mut request = SolidRequest::of(formula(operation, scene.names().len())?);
            request.triangles = triangles.unwrap_or_else(|| scene.is_triangulated());
            (request.rule, request.keep_walls) = (rule.unwrap_or_default(), keep_walls);
            let arrangement = CongruentScene::with_bent(scene, tolerance, bent)?;
            arrangement.refuse_more_cells(max_cells)?;
            let result = CongruentBoolean::of(&arrangement, &request)?;
            let (answer, provenance, mesh) = (result.answer()?, result.provenance()?, result.to_mesh()?);
            drop(result);
            Ok((answer, provenance, mesh, Combined::Glued(Box::new(arrangement)), request))
        })?;
        return solid_result(py, glued);
    }
    let spatial = spatial_request(snap, tolerance, max_cells, split, merge_coplanar, precision);
    let solid = run(py, progress, || {
        let mut scene = scene_of(&models, inputs, least_inputs(operation), keep_walls)?;
        if closes_mouths {
            scene.close_mouths()?;
        }
        let mut request = SolidRequest::of(formula(operation, scene.names().len())?);
        request.triangles = triangles.unwrap_or_else(|| scene.is_triangulated());
        request.rule = rule.unwrap_or_default();
        (request.split_pinches, request.keep_walls) = (split_pinches, keep_walls);
        request.merge_coplanar = merge_coplanar && !exact;
        combined(scene, &spatial, request, exact)
    })?;
    solid_result(py, solid)
}

/// The combination of a scene, rounded validly unless it is exact.
fn combined(
    scene: SpatialScene,
    spatial: &SpatialRequest,
    request: SolidRequest,
    exact: bool,
) -> Result<(SolidBooleanAnswer, SolidBooleanProvenance, io::Model, Combined, SolidRequest), Error> {
    let arrangement = SceneArrangement::for_result(scene, spatial, &request)?;
    let result = SolidBoolean::of(&arrangement, &request)?;
    let rounded = if exact || result.is_valid()? { None } else { result.validly_rounded()? };
    let (answer, provenance, mesh) = match &rounded {
        None => answer_and_mesh(&result, exact)?,
        Some(rounded) => answer_and_mesh(&SolidBoolean::of(rounded, &request)?, exact)?,
    };
    drop(result);
    let arrangement = rounded.unwrap_or(arrangement);
    Ok((answer, provenance, mesh, Combined::Exact(Box::new(arrangement)), request))
}

/// The answer about a combination, where everything comes from, and its surface.
fn answer_and_mesh(
    result: &SolidBoolean<'_>,
    exact: bool,
) -> Result<(SolidBooleanAnswer, SolidBooleanProvenance, io::Model), Error> {
    let (answer, provenance) = (result.answer()?, result.provenance()?);
    let mut mesh = result.to_mesh()?;
    if exact && !answer.unbounded {
        mesh = mesh.with_exact_polygons(result.exact_polygons()?.into());
    }
    Ok((answer, provenance, mesh))
}

/// The formula that a word or a text stands for.
pub(crate) fn formula(operation: &str, count: usize) -> Result<BooleanFormula, Error> {
    Ok(match operation {
        "union" | "join" => BooleanFormula::union(count),
        "intersection" | "meet" => BooleanFormula::intersection(count),
        "difference" => BooleanFormula::difference(count),
        "xor" => BooleanFormula::xor(count),
        text => {
            let formula = BooleanFormula::parse(text, &[])?;
            if formula.input_count() > count {
                let named = formula.input_count() - 1;
                return Err(Error::invalid(format!(
                    "the formula names input {named}, but there are {count}"
                ))
                .with_cure("inputs are numbered from 0"));
            }
            formula
        }
    })
}

/// What segments cut the plane into: vertices, edges and bounded faces.
///
/// Made by :func:`arrange`.
#[pyclass(frozen, dict, module = "coface", name = "PlanarArrangement")]
pub(crate) struct PlanarArrangement {
    arranged: DrawingArrangement,
    answer: PlanarArrangementAnswer,
}

answer! { PlanarArrangement {
    /// The numbers of vertices, edges and bounded faces.
    f_vector,
    /// The areas of the bounded faces.
    measures,
    /// For each bounded face the inputs that contain it.
    inside,
    /// The number of holes of bounded faces.
    holes,
    /// The number of connected components of vertices and edges.
    components,
    /// Vertices - edges + bounded faces.
    euler_characteristic,
    /// The number of edges with one face on both sides.
    bridges,
    /// The number of those of them that hang on the rest by one end.
    dangling_edges,
    /// What rounding of coordinates does.
    rounding,
    /// Whether products of boundary matrices are zero, found by multiplying.
    products_zero,
    /// The names of the inputs that contain faces.
    regions,
    /// What was put together, where that was asked for.
    joined,
    /// What congruence put together, with ``method="congruence"``.
    congruence,
}
    /// What was assumed, changed or left out, each a dictionary with ``code``, ``message``, ``count`` and ``places``; a warning said so too.
    #[getter]
    fn remarks<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        remarks_of(py, &self.answer.remarks)
    }

    /// What is odd about the inputs.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.arranged.warnings()
    }

    /// The positions of the vertices: ``float64``, shape (n, 2).
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let positions = self.arranged.arrangement().positions();
        Ok(arrays::grid(py, positions.as_flat().to_vec(), positions.dimension())?.into_any())
    }

    /// The ends of the edges: ``int64``, shape (m, 2).
    #[getter]
    fn edges<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let arrangement = self.arranged.arrangement();
        let ends = (0..arrangement.edge_count()).flat_map(|edge| arrangement.ends(EdgeId::new(edge)));
        let flat: Vec<i64> = ends.map(|vertex| i64::from(vertex.to_u32())).collect();
        Ok(arrays::grid(py, flat, 2)?.into_any())
    }

    /// The walks around a bounded face, each an array of vertices with the face on the left: the outer one and those of holes.
    ///
    /// Parameters
    /// ----------
    /// face : int
    ///     The number of the face.
    ///
    /// Returns
    /// -------
    /// list of numpy.ndarray
    ///     Walks may run along an edge twice where it has the face on both sides.
    fn walks<'py>(&self, py: Python<'py>, face: usize) -> PyResult<Vec<Bound<'py, PyArray1<i64>>>> {
        let arrangement = self.arranged.arrangement();
        if face >= arrangement.face_count() {
            let message = format!("there is no face {face}");
            return Err(invalid(py, message, &format!("there are {}", arrangement.face_count())));
        }
        let source = |&halfedge: &u32| {
            arrangement.ends(EdgeId::from_u32(halfedge >> 1))[(halfedge & 1) as usize].to_u32()
        };
        let walks = arrangement.walks(Some(FaceId::new(face)));
        Ok(walks.map(|walk| arrays::id_array(py, walk.iter().map(source))).collect())
    }

    /// The properties of all features of GeoJSON or TopoJSON that contain a bounded face.
    ///
    /// Parameters
    /// ----------
    /// face : int
    ///     The number of the face.
    ///
    /// Returns
    /// -------
    /// dict of str
    ///     A key with equal values has that value, a key with different values the list of them in the order of the
    ///     inputs.
    ///
    /// Examples
    /// --------
    /// >>> import coface, json, pathlib, tempfile
    /// >>> def square(corner, side, **properties):
    /// ...     ring = [[corner + x * side, corner + y * side] for x, y in [(0, 0), (1, 0), (1, 1), (0, 1), (0, 0)]]
    /// ...     geometry = {"type": "Polygon", "coordinates": [ring]}
    /// ...     return {"type": "Feature", "properties": properties, "geometry": geometry}
    /// >>> features = [square(0, 9, kind="parish", code=4), square(1, 2, kind="field", crop="rye")]
    /// >>> with tempfile.TemporaryDirectory() as folder:
    /// ...     path = pathlib.Path(folder, "map.geojson")
    /// ...     _ = path.write_text(json.dumps({"type": "FeatureCollection", "features": features}))
    /// ...     map = coface.read(path)
    /// >>> coface._coface.arrange([map]).properties(1)
    /// {'kind': ['parish', 'field'], 'code': 4, 'crop': 'rye'}
    fn properties<'py>(&self, py: Python<'py>, face: usize) -> PyResult<Bound<'py, PyAny>> {
        let count = self.arranged.arrangement().face_count();
        if face >= count {
            return Err(invalid(py, format!("there is no face {face}"), &format!("there are {count}")));
        }
        loaded(py, &self.arranged.properties_of_face(FaceId::new(face)).or_raise(py)?)
    }

    /// The bounded faces that inputs contain as a map: each with the properties of all features that contain it.
    ///
    /// Returns
    /// -------
    /// Model
    ///     All faces have the same keys; a key of several inputs is one for each, such as ``use_1`` and ``use_2``, and the value is ``None``
    ///     where no feature of that input contains the face. ``GeoDataFrame.from_features`` of geopandas takes it.
    fn attributes(&self, py: Python<'_>) -> PyResult<Model> {
        run(py, None, || {
            let found = self.arranged.attributes()?;
            Ok(found.model().clone().with_remarks(found.remarks().iter().cloned()))
        })
        .map(Model::of)
    }

    /// Where everything comes from: ``vertices``, ``edges`` (segments along each) and ``faces`` (inputs around each).
    fn provenance<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.arranged.provenance())
    }

    /// The chain complex of vertices, edges and bounded faces, refined until each face is a disk: its homology is that of
    /// the union of all edges, vertices and bounded faces.
    fn chain_complex(&self, py: Python<'_>) -> PyResult<ChainComplex> {
        run(py, None, || self.arranged.arrangement().chain_complex()).map(ChainComplex::bare)
    }

    /// The arrangement as a file of this format.
    fn to_bytes<'py>(&self, py: Python<'py>, format: &str) -> PyResult<Bound<'py, PyBytes>> {
        let format = Format::from_name(format).or_raise(py)?;
        let bytes = run(py, None, || write_bytes(|out| self.arranged.write(out, format)))?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// Writes the arrangement to a file, by its path or open for writing.
    #[pyo3(signature = (path, format=None))]
    fn write(&self, py: Python<'_>, path: &Bound<'_, PyAny>, format: Option<&str>) -> PyResult<()> {
        let target = Target::of(path)?;
        let format = target.known_format(py, format)?;
        warn_all(py, &self.arranged.drawing().losses(format))?;
        target.write(py, None, |out| self.arranged.write(out, format))
    }

    /// The cells as a chain complex with positions whose faces are disks: what ``.json`` holds, and what homology and other questions about
    /// cells are asked of.
    #[getter]
    fn cells(&self, py: Python<'_>) -> PyResult<Model> {
        run(py, None, || {
            let bytes = write_bytes(|out| self.arranged.write(out, Format::Json))?;
            io::read(&bytes[..], Format::Json)
        })
        .map(Model::of)
    }

    /// The faces as a model: polygons with the plane's coordinates. With ``exact=True`` it keeps exact points.
    fn model(&self, py: Python<'_>) -> PyResult<Model> {
        run(py, None, || {
            let bytes = write_bytes(|out| self.arranged.write(out, Format::Obj))?;
            let made = io::read(&bytes[..], Format::Obj)?;
            Ok(match self.arranged.exact_segments_of_faces()? {
                Some(exact) => made.with_exact_segments(exact.into()),
                None => made,
            })
        })
        .map(Model::of)
    }

    fn __len__(&self) -> usize {
        self.arranged.arrangement().face_count()
    }

    fn __repr__(&self) -> String {
        format!("PlanarArrangement(f-vector {})", text_of(&self.answer.f_vector))
    }
}

/// The text of JSON as Python reads it: keys in their order, whole numbers with all their digits.
fn loaded<'py>(py: Python<'py>, text: &str) -> PyResult<Bound<'py, PyAny>> {
    py.import("json")?.call_method1("loads", (text,))
}

/// Regions of the plane combined: polygons with holes.
///
/// Made by :func:`boolean`.
#[pyclass(frozen, dict, module = "coface", name = "PlanarBoolean")]
pub(crate) struct PlanarBoolean {
    result: RegionBoolean,
    answer: PlanarBooleanAnswer,
}

answer! { PlanarBoolean {
    /// The area.
    measure,
    /// The numbers of vertices, edges and polygons.
    f_vector,
    /// The number of parts; those that touch in points only are different ones.
    components,
    /// Whether every edge has the result on one side.
    closed,
    /// Whether the boundary is a curve everywhere; ``witness`` has pinched vertices.
    manifold,
    /// What rounding of coordinates does.
    rounding,
    /// What was put together, where that was asked for.
    joined,
    /// What congruence put together, with ``method="congruence"``.
    congruence,
}
    /// What was assumed, changed or left out, each a dictionary with ``code``, ``message``, ``count`` and ``places``; a warning said so too.
    #[getter]
    fn remarks<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        remarks_of(py, &self.answer.remarks)
    }

    /// The number of holes.
    #[getter]
    fn holes(&self) -> usize {
        self.result.hole_count()
    }

    /// The areas of the polygons.
    #[getter]
    fn areas<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<f64>> {
        PyArray1::from_slice(py, self.result.polygon_areas())
    }

    /// The positions of the vertices: ``float64``, shape (n, 2).
    #[getter]
    fn vertices<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        let positions = self.result.positions();
        Ok(arrays::grid(py, positions.as_flat().to_vec(), positions.dimension().max(2))?.into_any())
    }

    /// For each polygon its rings, each an array of vertices: the outer one and those of holes.
    #[getter]
    fn polygons<'py>(&self, py: Python<'py>) -> Vec<Vec<Bound<'py, PyArray1<i64>>>> {
        let [_, _, count] = self.result.f_vector();
        let rings = |polygon| {
            let rings = self.result.rings_of_polygon(FaceId::new(polygon));
            rings.map(|ring| arrays::id_array(py, ring.iter().copied())).collect()
        };
        (0..count).map(rings).collect()
    }

    /// The properties of all features of GeoJSON or TopoJSON that contain some of a polygon.
    ///
    /// Parameters
    /// ----------
    /// polygon : int
    ///     The number of the polygon.
    ///
    /// Returns
    /// -------
    /// dict of str
    ///     A key with equal values has that value, a key with different values the list of them in the order of the
    ///     inputs.
    fn properties<'py>(&self, py: Python<'py>, polygon: usize) -> PyResult<Bound<'py, PyAny>> {
        let [_, _, count] = self.result.f_vector();
        if polygon >= count {
            return Err(invalid(py, format!("there is no polygon {polygon}"), &format!("there are {count}")));
        }
        loaded(py, &self.result.properties_of_polygon(FaceId::new(polygon)).or_raise(py)?)
    }

    /// Vertices where parts of the result touch.
    #[getter]
    fn pinches<'py>(&self, py: Python<'py>) -> Bound<'py, PyArray1<i64>> {
        arrays::id_array(py, self.result.pinches().iter().map(|vertex| vertex.to_u32()))
    }

    /// What is odd about the inputs.
    #[getter]
    fn warnings(&self) -> Vec<String> {
        self.result.warnings().to_vec()
    }

    /// Where everything comes from.
    fn provenance<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.result.provenance())
    }

    /// The result as a file of this format.
    fn to_bytes<'py>(&self, py: Python<'py>, format: &str) -> PyResult<Bound<'py, PyBytes>> {
        let format = Format::from_name(format).or_raise(py)?;
        let bytes = run(py, None, || write_bytes(|out| self.result.write(out, format)))?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// Writes the result to a file, by its path or open for writing.
    #[pyo3(signature = (path, format=None))]
    fn write(&self, py: Python<'_>, path: &Bound<'_, PyAny>, format: Option<&str>) -> PyResult<()> {
        let target = Target::of(path)?;
        let format = target.known_format(py, format)?;
        warn_all(py, &self.result.drawing().losses(format))?;
        target.write(py, None, |out| self.result.write(out, format))
    }

    /// The cells as a chain complex with positions whose faces are disks: what ``.json`` holds, and what homology and other questions about
    /// cells are asked of.
    #[getter]
    fn cells(&self, py: Python<'_>) -> PyResult<Model> {
        run(py, None, || {
            let bytes = write_bytes(|out| self.result.write(out, Format::Json))?;
            io::read(&bytes[..], Format::Json)
        })
        .map(Model::of)
    }

    /// The rings as a model of closed lines, which is input again. With ``exact=True`` it keeps exact points, and has no
    /// properties of features.
    fn model(&self, py: Python<'_>) -> PyResult<Model> {
        run(py, None, || {
            let bytes = write_bytes(|out| self.result.write(out, Format::GeoJson))?;
            let made = io::read(&bytes[..], Format::GeoJson)?;
            Ok(match self.result.exact_segments()? {
                // Exact segments are of no features.
                Some(exact) => made.into_parts().into_model().with_exact_segments(exact.into()),
                None => made,
            })
        })
        .map(Model::of)
    }

    fn __len__(&self) -> usize {
        self.result.f_vector()[2]
    }

    fn __repr__(&self) -> String {
        format!("PlanarBoolean(area {}, f-vector {})", text_of(&self.answer.measure), text_of(&self.answer.f_vector))
    }
}
