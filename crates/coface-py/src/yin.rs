//! Sets of the plane with smooth boundaries and kinks.

mod curve;
mod cut_cells;
mod flow;
mod interface;
mod kink_request;
mod kinks;
mod motion;
mod places;

pub(crate) use curve::{_curve, Curve};
pub(crate) use cut_cells::CutCells;
pub(crate) use interface::{_feature_sets, _interface, _interface_of_text, _label_sets, Interface};
pub(crate) use kinks::Kinks;

use self::kink_request::kinks_of;
use self::motion::{
    GivenFlow, MotionFacts, Repair, VanishedCurve, below_knots, contact_of, parameters_of, scheme_of,
    tracking_options, verification_of,
};
use crate::answer::answer;
use crate::arrangement::{formula, rule_of};
use crate::arrays;
use crate::congruence::choice;
use crate::errors::{self, OrRaise, invalid, truth, wrong_type};
use crate::model::{Model, read_options};
use crate::objects::to_python;
use crate::pictures::flat_file;
use crate::source::Source;
use crate::target::{Target, warn_all};
use crate::work::run;
use coface::answers::answer::{YinDecision, YinEventAnswer, YinProvenance, YinSetAnswer};
use coface::answers::{PlanarSet, SetRequest, text};
use coface::io;
use coface::io::Format;
use coface::pictures::{SetPicture, set_picture};
use coface::yin;
use coface::yin::{EndCondition, EventKind, KnotIndex, Order, SetLocation};
use coface::{Error, VertexId};
use numpy::{PyArray1, PyArrayMethods};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict, PyTuple};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;
use std::sync::Arc;

/// Points of the plane.
fn points_of(value: &Bound<'_, PyAny>, what: &str) -> PyResult<Vec<[f64; 2]>> {
    let py = value.py();
    let positions = arrays::positions(value, what)?;
    if positions.dimension() != 2 && !positions.is_empty() {
        let message = format!("{what} have {} coordinates", positions.dimension());
        return Err(invalid(py, message, "give an array of shape (n, 2)"));
    }
    Ok(positions.as_flat().chunks_exact(2).map(|point| [point[0], point[1]]).collect())
}

fn point_array<'py>(py: Python<'py>, points: &[[f64; 2]]) -> PyResult<Bound<'py, PyAny>> {
    Ok(PyArray1::from_vec(py, points.concat()).reshape([points.len(), 2])?.into_any())
}

fn order_of(py: Python<'_>, order: usize) -> PyResult<Order> {
    Order::new(order).or_raise(py)
}

fn ends_of(py: Python<'_>, ends: &str) -> PyResult<EndCondition> {
    match ends {
        "not-a-knot" => Ok(EndCondition::NotAKnot),
        "natural" => Ok(EndCondition::Natural),
        "periodic" => Ok(EndCondition::Periodic),
        _ => {
            Err(invalid(py, format!("ends are {ends:?}"), "give \"not-a-knot\", \"natural\" or \"periodic\""))
        }
    }
}

/// What the class of a value is called.
fn type_name(value: &Bound<'_, PyAny>) -> String {
    value.get_type().name().map_or_else(|_| "value".to_owned(), |name| name.to_string())
}

/// A set of the plane that is regular, open and semianalytic: bounded by polylines or splines, itself bounded or not.
///
/// Sets do not change; an edit gives a new one, and one that fails leaves everything as it was.
///
/// Parameters
/// ----------
/// curves : sequence of Curve
///     Boundaries with the set on their left, pairwise disjoint but for single points. Outermost ones that run clockwise leave everything
///     outside of them, with an :class:`AssumptionWarning`. Their kinks are kinks of the set; so are corners of splines, with a warning.
/// orient : bool
///     Whether curves are turned so that they bound what is inside of them: those in no other counterclockwise, those in others against the one
///     around them.
///
/// Examples
/// --------
/// >>> import coface
/// >>> disk = coface.YinSet([coface.Curve.circle([0, 0], 1)])
/// >>> square = coface.YinSet.from_rings([[[0, 0], [2, 0], [2, 2], [0, 2]]])
/// >>> square.area, square.betti_open
/// (4.0, [1, 0])
/// >>> (square & square.complement()).is_empty
/// True
#[pyclass(frozen, module = "coface", name = "YinSet")]
pub(crate) struct YinSet {
    set: Arc<PlanarSet>,
    /// What was known when it was made: where pieces come from, what was decided without proof.
    provenance: Option<SetProvenance>,
    answer: YinSetAnswer,
}

/// A curve by its number or its name.
#[derive(FromPyObject)]
enum CurveName {
    Number(u32),
    Name(String),
}

/// Where the pieces of a combination come from, and what was decided without proof.
#[derive(Serialize, Deserialize)]
struct SetProvenance {
    #[serde(flatten)]
    provenance: YinProvenance,
    uncertified: Vec<YinDecision>,
}

impl YinSet {
    fn of(set: PlanarSet) -> Result<Self, Error> {
        Self::with_provenance(set, None)
    }

    fn with_provenance(set: PlanarSet, provenance: Option<SetProvenance>) -> Result<Self, Error> {
        let answer = set.answer()?;
        Ok(Self { set: Arc::new(set), provenance, answer })
    }

    fn inner(&self) -> &yin::YinSet {
        self.set.set()
    }

    fn combined(sets: &[&yin::YinSet], operation: &str) -> Result<Self, Error> {
        let combination = yin::YinSet::combine(sets, &formula(operation, sets.len())?)?;
        let provenance = SetProvenance {
            provenance: PlanarSet::provenance(&combination),
            uncertified: PlanarSet::decisions(&combination),
        };
        Self::with_provenance(PlanarSet::from_set(combination.into_set()), Some(provenance))
    }

    fn with(&self, py: Python<'_>, other: &Bound<'_, Self>, operation: &str) -> PyResult<Self> {
        let other = other.get();
        run(py, None, || Self::combined(&[self.inner(), other.inner()], operation))
    }

    /// The set, after a warning if outermost curves run clockwise: then it is everything outside of them.
    fn warned(self, py: Python<'_>, cure: &str) -> PyResult<Self> {
        if !self.inner().is_bounded() && !self.inner().is_plane() {
            let fault = "the outermost curves run clockwise, so the set is all that lies outside of them and its area is infinite";
            errors::warn(py, &format!("{fault}; {cure}, and ~ of that is this set without a warning"))?;
        }
        Ok(self)
    }

    /// The set, after a warning for each remark about what it was made of.
    fn after_remarks(self, py: Python<'_>) -> PyResult<Self> {
        warn_all(py, self.set.remarks())?;
        Ok(self)
    }

    /// The set with an edit.
    fn edited(
        &self,
        py: Python<'_>,
        edit: impl FnOnce(&mut PlanarSet) -> Result<(), Error> + Send,
    ) -> PyResult<Self> {
        run(py, None, || {
            let mut set = self.set.as_ref().clone();
            edit(&mut set)?;
            Self::of(set)
        })
    }
}

fn request(
    py: Python<'_>,
    order: Option<usize>,
    rule: Option<&str>,
    kinks: Option<&Bound<'_, PyAny>>,
    ends: &str,
    canonical: bool,
    fit: bool,
) -> PyResult<SetRequest> {
    let mut request = SetRequest::default();
    request.order = order.map(|order| order_of(py, order)).transpose()?;
    request.rule = rule_of(py, rule)?;
    request.kinks = kinks.map(kinks_of).transpose()?;
    request.ends = ends_of(py, ends)?;
    request.canonical = canonical;
    request.fit = fit;
    Ok(request)
}

answer! { YinSet {
    /// The lower left and upper right corners of the smallest box; ``None`` without curves.
    bounding_box,
    /// The length of the boundary.
    perimeter,
    /// How many curves have the set inside, and how many outside.
    curve_counts,
    /// Components and holes of the open set.
    betti_open,
    /// Components and holes of the closed set.
    betti_closed,
    /// For each connected component the numbers of its curves.
    atoms,
}
    /// For each curve ``sign``, ``area``, ``length``, ``knots``, ``kinks``, ``parent``, ``depth``, ``name``.
    #[getter]
    fn curve_facts<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.answer.curves)
    }

    #[new]
    #[pyo3(signature = (*arguments, **options), text_signature = "(curves, *, orient=False)")]
    fn new(
        py: Python<'_>,
        arguments: &Bound<'_, PyTuple>,
        options: Option<&Bound<'_, PyDict>>,
    ) -> PyResult<Self> {
        let [curves, orient] = errors::bound("YinSet", ["curves", "orient"], 1, arguments, options)?;
        let curves = &errors::required(py, "YinSet", "curves", curves)?;
        let orient = orient.as_ref().map_or(Ok(false), truth)?;
        let cure = "give curves: coface.YinSet([coface.Curve(points)]), or points to coface.YinSet.from_rings(rings)";
        let wrong = |name: String| wrong_type(py, format!("a {name} is no Curve"), cure);
        let listed = curves.try_iter().map_err(|_| wrong(type_name(curves)))?;
        let mut given: Vec<(yin::Curve<'static>, Vec<u32>)> = Vec::new();
        for curve in listed {
            let curve = curve?;
            let found = curve.cast::<Curve>().map_err(|_| wrong(type_name(&curve)))?;
            let found = found.get();
            given.push((found.curve.clone(), found.kinks.clone()));
        }
        let set = run(py, None, || Self::of(PlanarSet::of_curves(&given, orient)?))?.after_remarks(py)?;
        set.warned(py, "the inside of curves of any direction needs orient=True")
    }

    /// Reads a set from a file: SVG, GeoJSON, WKT, JSON, ``.dat`` or any drawing with rings.
    ///
    /// Parameters
    /// ----------
    /// path : str or os.PathLike
    ///     The file.
    /// format : str, optional
    ///     The format, if it is not to be found out.
    /// order : {2, 4, 6, 8}, optional
    ///     The order of the curves.
    /// rule : {"nonzero", "evenodd", "positive"}, optional
    ///     What rings that cross contain.
    /// kinks : "none", "all", float, or list of (int, int), optional
    ///     Where curves may turn: nowhere, everywhere, where polylines turn by more degrees, or at these (curve, knot).
    /// ends : {"not-a-knot", "natural"}
    ///     What holds at kinks.
    /// fit : bool
    ///     Whether points are fitted again.
    /// canonical : bool
    ///     Whether the unique form is made.
    /// flatten : float, optional
    ///     How far the polylines of curved paths may be from the curves, where the order is 2.
    /// allow_outside : bool
    ///     Whether other files that the file names may lie outside of its folder: allow it for files that you trust.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    #[staticmethod]
    #[pyo3(signature = (path, format=None, *, order=None, rule=None, kinks=None, ends="not-a-knot", fit=false, canonical=false, flatten=None, allow_outside=false, progress=None))]
    #[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
    fn read(
        py: Python<'_>,
        path: PathBuf,
        format: Option<&str>,
        order: Option<usize>,
        rule: Option<&str>,
        kinks: Option<&Bound<'_, PyAny>>,
        ends: &str,
        fit: bool,
        canonical: bool,
        flatten: Option<f64>,
        allow_outside: bool,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let mut request = request(py, order, rule, kinks, ends, canonical, fit)?;
        request.flatten = flatten;
        // Curves stay curves unless polylines are asked for.
        let options = read_options(py, format, flatten.filter(|_| request.order == Some(Order::LINEAR)), (false, false, allow_outside))?;
        run(py, progress, || {
            let name = path.display().to_string();
            let drawing = io::read_boundary_path(&path, &options)?;
            Self::of(PlanarSet::of(&drawing, &request).map_err(|error| error.in_file(name))?)
        })
        .and_then(|set| set.after_remarks(py))
    }

    /// A set bounded by rings of points.
    ///
    /// Parameters
    /// ----------
    /// rings : sequence of array_like, each of shape (n, 2)
    ///     Rings; the first point may stand at the end again.
    /// order : {2, 4, 6, 8}
    ///     2 for polylines, 4 for cubic splines through the points, ..
    /// rule : {"nonzero", "evenodd", "positive"}, optional
    ///     What rings that cross contain; without it the set lies to the left of each ring: inside of one that runs counterclockwise. Outermost
    ///     rings that run clockwise leave everything outside of them, with an :class:`AssumptionWarning`.
    /// kinks : "none", "all", float, or list of (int, int), optional
    ///     Where splines may turn.
    /// ends : {"not-a-knot", "natural"}
    ///     What holds at kinks.
    /// canonical : bool
    ///     Whether the unique form is made.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    #[staticmethod]
    #[pyo3(signature = (rings, *, order=2, rule=None, kinks=None, ends="not-a-knot", canonical=false, progress=None))]
    #[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
    fn from_rings(
        py: Python<'_>,
        rings: &Bound<'_, PyAny>,
        order: usize,
        rule: Option<&str>,
        kinks: Option<&Bound<'_, PyAny>>,
        ends: &str,
        canonical: bool,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let mut lists = Vec::new();
        for ring in rings.try_iter()? {
            let mut points = points_of(&ring?, "rings")?;
            // Rings of shapely and GeoJSON have their first point again.
            if points.len() > 3 && points.first() == points.last() {
                points.pop();
            }
            lists.push(points);
        }
        let request = request(py, Some(order), rule, kinks, ends, canonical, order > 2)?;
        let stated = request.rule;
        run(py, progress, || {
            let mut drawing = io::yin::BoundaryDrawing::new(Order::LINEAR);
            let curves = lists.into_iter().map(io::yin::BoundaryCurve::new).collect();
            let filling = stated.map_or(io::yin::Filling::Left, io::yin::Filling::Stated);
            drawing.push(filling, curves);
            Self::of(PlanarSet::of(&drawing, &request)?)
        })
        .and_then(|set| set.after_remarks(py))
        .and_then(|set| match stated {
            Some(_) => Ok(set),
            None => set.warned(py, "the inside of rings of any direction needs rule=\"evenodd\""),
        })
    }

    /// The rings of a planar model as a set.
    #[staticmethod]
    #[pyo3(signature = (model, *, order=None, rule=None, kinks=None, progress=None))]
    fn from_model(
        py: Python<'_>,
        model: &Bound<'_, Model>,
        order: Option<usize>,
        rule: Option<&str>,
        kinks: Option<&Bound<'_, PyAny>>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let request = request(py, order, rule, kinks, "not-a-knot", false, order.is_some_and(|order| order > 2))?;
        let source: &Arc<Source> = &model.get().source;
        run(py, progress, || {
            let drawing = io::yin::drawing_of_model(&source.model)?;
            Self::of(PlanarSet::of(&drawing, &request)?)
        })
        .and_then(|set| set.after_remarks(py))
    }

    /// The set without points.
    #[staticmethod]
    #[pyo3(signature = (order=2))]
    fn empty(py: Python<'_>, order: usize) -> PyResult<Self> {
        Self::of(PlanarSet::from_set(yin::YinSet::empty(order_of(py, order)?))).or_raise(py)
    }

    /// The whole plane.
    #[staticmethod]
    #[pyo3(signature = (order=2))]
    fn plane(py: Python<'_>, order: usize) -> PyResult<Self> {
        Self::of(PlanarSet::from_set(yin::YinSet::plane(order_of(py, order)?))).or_raise(py)
    }

    /// Any formula on any number of sets.
    ///
    /// Parameters
    /// ----------
    /// operation : str
    ///     ``"meet"``, ``"join"``, ``"difference"``, ``"xor"``, or a formula of sets by number, such as ``"(0 | 1) & !2"``.
    /// sets : sequence of YinSet
    ///     The sets.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// YinSet
    ///     The set; its :attr:`provenance` says where each piece of the boundary comes from.
    #[staticmethod]
    #[pyo3(signature = (operation, sets, *, progress=None))]
    fn combine(
        py: Python<'_>,
        operation: &Bound<'_, PyAny>,
        sets: &Bound<'_, PyAny>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Self> {
        let cure = "call coface.YinSet.combine(\"meet\", [a, b])";
        let Ok(operation) = operation.extract::<String>() else {
            return Err(wrong_type(py, format!("the operation is a {}", type_name(operation)), cure));
        };
        let Ok(sets) = sets.extract::<Vec<Py<Self>>>() else {
            return Err(wrong_type(py, format!("the sets are a {}", type_name(sets)), cure));
        };
        let sets: Vec<Arc<PlanarSet>> = sets.iter().map(|set| Arc::clone(&set.get().set)).collect();
        run(py, progress, || {
            let operands: Vec<&yin::YinSet> = sets.iter().map(|set| set.set()).collect();
            Self::combined(&operands, &operation)
        })
    }

    /// The set of all points not in its closure; also ``~``.
    fn complement(&self, py: Python<'_>) -> PyResult<Self> {
        run(py, None, || Self::of(PlanarSet::from_set(self.inner().complement()?)))
    }

    /// The regularized intersection; also ``&``.
    fn meet(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        self.with(py, other, "meet")
    }

    /// The regularized union; also ``|``.
    fn join(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        self.with(py, other, "join")
    }

    /// The regularized difference; also ``-``.
    fn difference(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        self.with(py, other, "difference")
    }

    /// What lies in exactly one of the two; also ``^``.
    fn symmetric_difference(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        self.with(py, other, "xor")
    }

    /// How far another set is from this one: ``area_xor`` (the area of the symmetric difference; ``None`` if it is infinite) and
    /// ``area_xor_error`` (an estimate from above, about 1e-14 of the box), ``area_signed``, ``area_signed_error``, ``hausdorff`` (of the
    /// boundaries), ``along_normals`` (the greatest distance along the normals of this boundary) and ``curvature`` (the greatest difference of
    /// curvatures where these normals meet the other), each with its ``_error``; ``normals_left_out`` (the part of this boundary whose normals
    /// do not meet the other within twice the Hausdorff distance), ``components`` and ``holes`` of both.
    fn compare<'py>(&self, py: Python<'py>, other: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let [first, second] = [&self.set, &other.get().set].map(Arc::clone);
        to_python(py, &run(py, None, || first.compared_with("self", &second, "other"))?)
    }

    fn __invert__(&self, py: Python<'_>) -> PyResult<Self> {
        self.complement(py)
    }

    fn __and__(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        self.meet(py, other)
    }

    fn __or__(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        self.join(py, other)
    }

    fn __sub__(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        self.difference(py, other)
    }

    fn __xor__(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<Self> {
        self.symmetric_difference(py, other)
    }

    /// Whether every point is in the other set; also ``<=``.
    fn is_subset_of(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<bool> {
        let other = other.get();
        run(py, None, || self.inner().is_subset_of(other.inner()))
    }

    fn __le__(&self, py: Python<'_>, other: &Bound<'_, Self>) -> PyResult<bool> {
        self.is_subset_of(py, other)
    }

    /// Whether it has no points.
    #[getter]
    fn is_empty(&self) -> bool {
        self.inner().is_empty()
    }

    /// Whether it is the whole plane.
    #[getter]
    fn is_plane(&self) -> bool {
        self.inner().is_plane()
    }

    /// Whether it lies in some disk.
    #[getter]
    fn is_bounded(&self) -> bool {
        self.inner().is_bounded()
    }

    /// The area; inf of an unbounded set. That of a bounded set which is beyond the range of numbers is an error.
    #[getter]
    fn area(&self, py: Python<'_>) -> PyResult<f64> {
        match self.inner().area() {
            None => Ok(f64::INFINITY),
            Some(area) if area.is_finite() => Ok(area),
            Some(_) => {
                let message = "the area of the set is bounded, but beyond the range of numbers";
                Err(invalid(py, message, "divide the coordinates by 1e200"))
            }
        }
    }

    /// The order of its curves.
    #[getter]
    fn order(&self) -> usize {
        self.inner().order().value()
    }

    /// The boundary curves, with the set on their left.
    #[getter]
    fn curves(&self) -> Vec<Curve> {
        let set = self.inner();
        let kinks = |curve: usize| set.kinks().on_curve(curve as u32).collect();
        (0..set.curve_count())
            .map(|curve| Curve { curve: set.curve(curve).into_owned(), kinks: kinks(curve) })
            .collect()
    }

    /// What was odd about the input.
    #[getter]
    fn remarks(&self) -> Vec<String> {
        self.set.remarks().iter().map(|remark| remark.message.clone()).collect()
    }

    /// Of a combination, ``sources``: for each curve and piece ``[operand, curve, piece, from, to]``; and ``uncertified`` decisions.
    #[getter]
    fn provenance<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        to_python(py, &self.provenance)
    }

    /// The kinks.
    #[getter]
    fn kinks(slf: Bound<'_, Self>) -> Kinks {
        Kinks { set: slf.unbind() }
    }

    /// The set with one more kink.
    ///
    /// Parameters
    /// ----------
    /// curve : int or str
    ///     The number of the curve, or its name.
    /// knot : int
    ///     The number of the knot.
    ///
    /// Returns
    /// -------
    /// set : YinSet
    ///     The curve fitted again.
    /// vertex : int
    ///     The name of the kink.
    fn insert_kink(&self, py: Python<'_>, curve: CurveName, knot: u32) -> PyResult<(Self, u32)> {
        let mut name = 0;
        let edited = self.edited(py, |set| {
            let curve = match &curve {
                CurveName::Number(curve) => *curve,
                CurveName::Name(name) => set.curve_of_name(name)?,
            };
            name = set.set_mut().insert_kink(KnotIndex { curve, knot })?.to_u32();
            Ok(())
        })?;
        Ok((edited, name))
    }

    /// The set with one more kink, at the knot that is nearest to a point.
    ///
    /// Parameters
    /// ----------
    /// point : array_like, shape (2,)
    ///     The point.
    ///
    /// Returns
    /// -------
    /// set : YinSet
    ///     The curve fitted again.
    /// vertex : int
    ///     The name of the kink.
    fn insert_kink_near(&self, py: Python<'_>, point: [f64; 2]) -> PyResult<(Self, u32)> {
        let mut name = 0;
        let edited = self.edited(py, |set| {
            let set = set.set_mut();
            let at = set.nearest_knot(point)?.ok_or_else(|| {
                Error::invalid("the set has no curves, and so no knots").with_cure("take a set with curves")
            })?;
            name = set.insert_kink(at)?.to_u32();
            Ok(())
        })?;
        Ok((edited, name))
    }

    /// The set without the kink of this name.
    ///
    /// Parameters
    /// ----------
    /// vertex : int
    ///     The name of the kink.
    ///
    /// Returns
    /// -------
    /// set : YinSet
    ///     The curve fitted again.
    /// vertex : int
    ///     The name of the kink that is gone.
    fn erase_kink(&self, py: Python<'_>, vertex: u32) -> PyResult<(Self, u32)> {
        Ok((self.edited(py, |set| set.set_mut().erase_kink(VertexId::from_u32(vertex)).map(drop))?, vertex))
    }

    /// The set without the kink that is nearest to a point.
    ///
    /// Parameters
    /// ----------
    /// point : array_like, shape (2,)
    ///     The point.
    ///
    /// Returns
    /// -------
    /// set : YinSet
    ///     The curve fitted again.
    /// vertex : int
    ///     The name of the kink that is gone.
    fn erase_kink_near(&self, py: Python<'_>, point: [f64; 2]) -> PyResult<(Self, u32)> {
        let mut name = 0;
        let edited = self.edited(py, |set| {
            let set = set.set_mut();
            let kink = set.nearest_kink(point)?.ok_or_else(|| {
                Error::invalid("the set has no kinks").with_cure("take a set with kinks")
            })?;
            name = kink.to_u32();
            set.erase_kink(kink).map(drop)
        })?;
        Ok((edited, name))
    }

    /// The set with these kinks and no others: ``"none"``, ``"all"``, an angle in degrees, or pairs (curve, knot).
    fn reset_kinks(&self, py: Python<'_>, kinks: &Bound<'_, PyAny>) -> PyResult<Self> {
        let request = kinks_of(kinks)?;
        self.edited(py, |set| set.reset_kinks(&request))
    }

    /// The unique form: curves in order, each from its least knot.
    fn canonical(&self, py: Python<'_>) -> PyResult<Self> {
        run(py, None, || Self::of(self.set.as_ref().clone().canonical()))
    }

    /// Where points lie.
    ///
    /// Parameters
    /// ----------
    /// points : array_like, shape (n, 2)
    ///     The points.
    ///
    /// Returns
    /// -------
    /// numpy.ndarray of int8
    ///     1 inside, 0 on the boundary, -1 outside.
    ///
    /// Examples
    /// --------
    /// >>> import coface
    /// >>> square = coface.YinSet.from_rings([[[0, 0], [2, 0], [2, 2], [0, 2]]])
    /// >>> square.locate([[1, 1], [2, 1], [3, 1]])
    /// array([ 1,  0, -1], dtype=int8)
    fn locate<'py>(&self, py: Python<'py>, points: &Bound<'py, PyAny>) -> PyResult<Bound<'py, PyArray1<i8>>> {
        let points = points_of(points, "points")?;
        let found = run(py, None, || self.inner().locate_all(&points))?;
        let word = |location: &SetLocation| match location {
            SetLocation::Inside => 1,
            SetLocation::Outside => -1,
            _ => 0,
        };
        Ok(PyArray1::from_vec(py, found.iter().map(word).collect()))
    }

    fn __contains__(&self, py: Python<'_>, point: [f64; 2]) -> PyResult<bool> {
        Ok(matches!(self.inner().locate(point).or_raise(py)?, SetLocation::Inside))
    }

    /// The set on a Cartesian grid.
    ///
    /// Parameters
    /// ----------
    /// counts : (int, int)
    ///     Columns and rows.
    /// origin : (float, float), optional
    ///     The lower left corner; of the bounding box, if left out.
    /// spacing : (float, float), optional
    ///     The size of cells; so that the bounding box is covered, if left out.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// CutCells
    ///     The part of each cell that the set covers.
    #[pyo3(signature = (counts=(64, 64), *, origin=None, spacing=None, progress=None))]
    fn cut_cells(
        &self,
        py: Python<'_>,
        counts: (usize, usize),
        origin: Option<[f64; 2]>,
        spacing: Option<[f64; 2]>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<CutCells> {
        let around = self.set.bounding_box();
        run(py, progress, || CutCells::of(self.inner(), around, counts, origin, spacing))
    }

    /// The set after it moved with a flow.
    ///
    /// Parameters
    /// ----------
    /// flow : str or callable
    ///     ``"vortex"``, ``"deformation"``, ``"rotation"``, ``"translation"``, two expressions of x, y, t and T (the period) as in
    ///     ``"-y*cos(pi*t/T); x*cos(pi*t/T)"``, or a function. One of (points, t) gets an array of shape (n, 2) and gives one of velocities,
    ///     all at once; one of (x, y, t) gives the velocity of one point, and is called for each. The first call tells which it is.
    /// end : float, optional
    ///     The time at the end; the period, or 1.
    /// step : float, optional
    ///     The time step; a hundredth of the time if left out.
    /// spacing : float, optional
    ///     The largest distance of points along curves; a hundredth of the size if left out.
    /// period : float
    ///     Of vortex and deformation.
    /// vortices : int
    ///     Of deformation.
    /// velocity : (float, float)
    ///     Of translation.
    /// center : (float, float)
    ///     Of rotation.
    /// speed : float
    ///     Of rotation.
    /// verify : {"each-step", "end", "never"}
    ///     When it is checked that curves do not cross.
    /// repair : {"nonzero", "evenodd", "positive"}, optional
    ///     The rule by which curves that cross are cut and pasted, instead of refused.
    /// scheme : {"midpoint", "classical", "verner", "cooper-verner"}, optional
    ///     The Runge-Kutta scheme, of order 2, 4, 6 or 8; that of the order of the set if left out.
    /// parameters : {"lengths", "kept"}, optional
    ///     What the parameters of splines are: the distances of neighbors, as in cubic MARS, or those that knots had at the beginning, which are
    ///     more exact by far unless the velocity jumps along the boundary. Lengths in orders 2 and 4, kept in orders 6 and 8, if left out.
    /// least_ratio : float
    ///     The least distance of points along curves as a part of ``spacing``, up to 1/3.
    /// turn : float, optional
    ///     Points are added where the polygon through them turns by more degrees.
    /// keep_small : bool
    ///     Keep curves that become short beside ``spacing``: they have points nearer together. Otherwise they leave the set, with an
    ///     :class:`AssumptionWarning`, when they are shorter than three times the least distance.
    /// events : bool
    ///     Whether changes of the topology are listed, with their times narrowed down within steps.
    /// event_tolerance : float, optional
    ///     How exactly; a thousandth of the step if left out.
    /// on_contact : {"keep", "merge"}, optional
    ///     What to do where parts of the boundary come nearer to each other than ``contact_distance``: ``"merge"`` joins the set across gaps
    ///     and cuts it through necks, ``"keep"`` goes on with the curves as they are, with an :class:`AssumptionWarning`, and is an error only
    ///     if they cross at the end. Left out, contacts are not looked for, and crossing is an error at once. Events are listed too.
    /// contact_distance : float, optional
    ///     The least distance of points along curves if left out. With ``"merge"`` curves whose mean width is below half of it vanish.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// set : YinSet
    ///     The set.
    /// facts : dict
    ///     ``steps``, ``added``, ``removed``, ``vanished``, ``repairs``, and ``events``: ``None`` unless asked for, else dictionaries with
    ///     ``time``, ``kind``, ``words``, ``place``, ``before`` and ``after``, as ``coface yin advect --events`` gives them.
    ///
    /// Examples
    /// --------
    /// The gap between two disks is 0.5 exp(-t):
    ///
    /// >>> import coface
    /// >>> disks = coface.YinSet([coface.Curve.circle([x, 0], 1) for x in (-1.25, 1.25)])
    /// >>> one, facts = disks.advected("-x; 0", 2.0, step=0.1, on_contact="merge", contact_distance=0.25)
    /// >>> [(event["kind"], round(event["time"], 2)) for event in facts["events"]]
    /// [('components-merge', 0.69)]
    /// >>> one.betti_open
    /// [1, 0]
    #[pyo3(signature = (flow, end=None, *, step=None, spacing=None, period=4.0, vortices=4, velocity=[1.0, 0.0], center=[0.0, 0.0], speed=1.0, verify="each-step", repair=None, scheme=None, parameters=None, least_ratio=0.1, turn=None, keep_small=false, events=false, event_tolerance=None, on_contact=None, contact_distance=None, progress=None))]
    #[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
    fn advected<'py>(
        &self,
        py: Python<'py>,
        flow: &Bound<'py, PyAny>,
        end: Option<f64>,
        step: Option<f64>,
        spacing: Option<f64>,
        period: f64,
        vortices: u32,
        velocity: [f64; 2],
        center: [f64; 2],
        speed: f64,
        verify: &str,
        repair: Option<&str>,
        scheme: Option<&str>,
        parameters: Option<&str>,
        least_ratio: f64,
        turn: Option<f64>,
        keep_small: bool,
        events: bool,
        event_tolerance: Option<f64>,
        on_contact: Option<&str>,
        contact_distance: Option<f64>,
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<(Self, Bound<'py, PyAny>)> {
        let (flow, usual) = GivenFlow::read(flow, period, vortices, velocity, center, speed)?;
        let extent = self.set.bounding_box();
        let mut options = tracking_options(end.unwrap_or(usual), step, spacing, extent);
        options = options.verification(verification_of(py, verify)?).repair(rule_of(py, repair)?);
        options = options.scheme(scheme_of(py, scheme)?).parameters(parameters_of(py, parameters)?);
        options = options.least_ratio(least_ratio).most_turn(turn.map(f64::to_radians)).keep_small(keep_small);
        let on_contact = contact_of(py, on_contact)?;
        options = options.events(events).event_tolerance(event_tolerance);
        options = options.on_contact(on_contact).contact_distance(contact_distance);
        let moved = flow.moved(
            py,
            progress,
            |velocity| self.inner().advected(velocity, &options),
            |velocities| self.inner().advected_together(velocities, &options),
        )?;
        let counts = moved.counts();
        let vanished = |curve: &yin::VanishedCurve| VanishedCurve { time: curve.time(), curve: curve.curve() };
        let repairs = moved.repairs().iter().map(|repair| Repair {
            step: repair.step(),
            time: repair.time(),
            fault: repair.fault().to_string(),
        });
        let facts = MotionFacts {
            steps: counts.steps(),
            added: counts.added(),
            removed: counts.removed(),
            vanished: moved.vanished().iter().map(vanished).collect(),
            repairs: repairs.collect(),
            events: options.times_within().or_raise(py)?.map(|_| moved.events().iter().map(YinEventAnswer::new).collect()),
        };
        below_knots(py, &options)?;
        let kept = moved.events().iter().filter(|event| event.kind() == EventKind::Contact);
        if let Some((first, count)) = kept.clone().next().map(|first| (first, kept.count())) {
            let [x, y] = first.place();
            let message = format!(
                "boundaries came into contact at {} and were left as they are, the first at time {} near ({x}, {y})",
                text::count(count, "place"),
                first.time()
            );
            errors::warn(py, &message)?;
        }
        if let Some(first) = moved.vanished().first() {
            let count = moved.vanished().len();
            let narrow = match on_contact {
                Some(_) => ", or narrower than half of the contact distance,",
                None => "",
            };
            let message = format!(
                "{count} of the curves became shorter than three times the least distance of points{narrow} and left the set, the first at \
                 time {}; give keep_small=True to keep such curves",
                first.time()
            );
            errors::warn(py, &message)?;
        }
        let set = run(py, None, || Self::of(PlanarSet::from_set(moved.into_set())))?;
        Ok((set, to_python(py, &facts)?))
    }

    /// The set as a file of this format.
    ///
    /// Parameters
    /// ----------
    /// format : str
    ///     ``"json"`` keeps everything; ``"svg"``, ``"geojson"``, ``"wkt"``, ``"dat"``, ..
    /// flatten : float, optional
    ///     How far polylines may be from curves, where the format has polylines only.
    #[pyo3(signature = (format, *, flatten=None))]
    fn to_bytes<'py>(&self, py: Python<'py>, format: &str, flatten: Option<f64>) -> PyResult<Bound<'py, PyBytes>> {
        let format = Format::from_name(format).or_raise(py)?;
        let bytes = run(py, None, || {
            let mut bytes = Vec::new();
            self.set.write(&mut bytes, format, flatten)?;
            Ok(bytes)
        })?;
        Ok(PyBytes::new(py, &bytes))
    }

    /// Writes the set to a file, by its path or open for writing.
    #[pyo3(signature = (path, format=None, *, flatten=None))]
    fn write(&self, py: Python<'_>, path: &Bound<'_, PyAny>, format: Option<&str>, flatten: Option<f64>) -> PyResult<()> {
        let target = Target::of(path)?;
        let format = target.known_format(py, format)?;
        target.write(py, None, |out| self.set.write(out, format, flatten))
    }

    /// A picture: SVG.
    ///
    /// Parameters
    /// ----------
    /// kind : {"set", "kinks", "forest"}
    ///     The set, the set with its kinks, or how curves lie in each other.
    #[pyo3(signature = (kind="kinks"))]
    fn to_svg(&self, py: Python<'_>, kind: &str) -> PyResult<String> {
        let kinds = [("set", SetPicture::Set), ("kinks", SetPicture::Kinks), ("forest", SetPicture::Forest)];
        let kind = choice(py, "kind", kind, &kinds)?;
        run(py, None, || set_picture(&self.set, kind)?.svg(None))
    }

    fn _picture<'py>(
        &self,
        py: Python<'py>,
        format: &str,
        size: (usize, usize),
        transparent: bool,
    ) -> PyResult<Bound<'py, PyBytes>> {
        flat_file(py, format, size, transparent, || set_picture(&self.set, SetPicture::Kinks))
    }

    fn __bool__(&self) -> bool {
        !self.inner().is_empty()
    }

    fn __eq__(&self, other: &Bound<'_, PyAny>) -> bool {
        other.cast::<Self>().is_ok_and(|other| self.inner() == other.get().inner())
    }

    fn __hash__(&self) -> isize {
        self.inner().curve_count() as isize
    }

    fn __repr__(&self) -> String {
        let set = self.inner();
        if set.is_empty() {
            return format!("YinSet(empty, order {})", set.order().value());
        }
        if set.is_plane() {
            return format!("YinSet(plane, order {})", set.order().value());
        }
        let count = set.curve_count();
        let curves = if count == 1 { "curve" } else { "curves" };
        format!("YinSet({count} {curves}, order {}, area {})", set.order().value(), set.area().unwrap_or(f64::INFINITY))
    }

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, Bound<'py, PyTuple>)> {
        let bytes = self.to_bytes(py, "json", None)?.into_any();
        let rebuild = py.import("coface._coface")?.getattr("_yin_set")?;
        let provenance = self.provenance.as_ref().map(crate::objects::text_of).into_pyobject(py)?;
        Ok((rebuild, PyTuple::new(py, [bytes, provenance])?))
    }
}

/// Makes a set again, for pickling.
#[pyfunction]
#[pyo3(signature = (bytes, provenance=None))]
pub(crate) fn _yin_set(py: Python<'_>, bytes: Vec<u8>, provenance: Option<&str>) -> PyResult<YinSet> {
    let provenance = provenance.map(serde_json::from_str).transpose();
    let provenance = provenance.map_err(|fault| invalid(py, format!("{fault}"), "pickle the set again"))?;
    run(py, None, || {
        let drawing = io::read_boundary(&bytes[..], Format::Json, &io::ReadOptions::default())?;
        let mut request = SetRequest::default();
        request.as_declared = true;
        YinSet::with_provenance(PlanarSet::of(&drawing, &request)?, provenance)
    })
}
