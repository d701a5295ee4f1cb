//! Interfaces: sets as phases that share the arcs between them.

use super::motion::{GivenFlow, parameters_of, scheme_of, tracking_options, verification_of};
use super::{YinSet, points_of};
use crate::answer::answer;
use crate::arrangement::rule_of;
use crate::congruence::choice;
use crate::errors::{self, OrRaise, invalid};
use crate::model::Model;
use crate::objects::to_python;
use crate::pictures::flat_file;
use crate::work::run;
use coface::answers::answer::{
    InterfacePoint, YinInterfaceAnswer, YinInterfaceEventAnswer, YinLocation, to_json,
};
use coface::answers::{LabelImage, NamedSet, PlanarInterface, SetRequest};
use coface::io;
use coface::pictures::interface_picture;
use coface::yin::{InterfaceOptions, InterfaceRepair, Overlaps};
use coface::{EdgeId, Error, ErrorKind};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::PyBytes;
use serde::Serialize;
use std::path::PathBuf;

/// Sets of the plane as phases that share the arcs between them: edges, junctions, areas, lengths and neighbors.
///
/// Made by :func:`interface`.
#[pyclass(frozen, dict, module = "coface", name = "Interface")]
pub(crate) struct Interface {
    pub(super) interface: PlanarInterface,
    answer: YinInterfaceAnswer,
}

answer! { Interface {
    /// The order of the edges.
    order,
    /// For each phase ``name``, ``area``, ``perimeter``, ``components``, ``holes`` and ``neighbors``.
    phases,
    /// The positions of the vertices, a list of [x, y].
    vertices,
    /// For each edge ``ends``, the phases on its ``left`` and ``right`` (``None`` outside), ``length``, ``pieces``, ``knots`` and ``controls``.
    edges,
    /// For each junction ``vertex``, ``point``, ``degree``, ``smooth_pairs``, ``kind``, and ``edges`` and ``phases`` counterclockwise.
    junctions,
    /// The pairs of edges that go on smoothly into each other, each as (edge, direction): 1 as it runs, -1 against that.
    smooth_pairs,
    /// The length of all edges, each once; ``None`` where it overflows.
    length,
    /// What was assumed or left out.
    remarks,
}
    fn _picture<'py>(
        &self,
        py: Python<'py>,
        title: &str,
        format: &str,
        size: (usize, usize),
        transparent: bool,
    ) -> PyResult<Bound<'py, PyBytes>> {
        flat_file(py, format, size, transparent, || interface_picture(title, &self.answer))
    }

    /// The names of the phases.
    #[getter]
    fn names(&self) -> Vec<String> {
        self.answer.phases.iter().map(|phase| phase.name.clone()).collect()
    }

    /// The areas of the phases; ``inf`` for one that is not bounded.
    #[getter]
    fn areas(&self) -> Vec<f64> {
        self.answer.phases.iter().map(|phase| phase.area.unwrap_or(f64::INFINITY)).collect()
    }

    /// The lengths of the edges.
    #[getter]
    fn lengths(&self) -> Vec<f64> {
        self.answer.edges.iter().map(|edge| edge.length.unwrap_or(f64::INFINITY)).collect()
    }

    /// Pairs of phases that have an edge in common, the lower number first, with the length of their common edges.
    ///
    /// Returns
    /// -------
    /// list of (int, int, float)
    ///     What lies outside of all phases is no phase.
    #[getter]
    fn neighbors(&self) -> Vec<(u32, u32, f64)> {
        let of_phase = |(phase, own): (u32, &coface::answers::answer::YinPhaseAnswer)| {
            let others = own.neighbors.iter().filter_map(move |neighbor| {
                let other = neighbor.phase.filter(|&other| other > phase)?;
                Some((phase, other, neighbor.length.unwrap_or(f64::INFINITY)))
            });
            others.collect::<Vec<_>>()
        };
        (0..).zip(&self.answer.phases).flat_map(of_phase).collect()
    }

    /// The phases as sets, in their order; neighbors have the same pieces along their common edges.
    ///
    /// Returns
    /// -------
    /// list of YinSet
    ///     They give the same interface again.
    fn sets(&self, py: Python<'_>) -> PyResult<Vec<YinSet>> {
        run(py, None, || self.interface.phases()?.into_iter().map(YinSet::of).collect::<Result<Vec<_>, Error>>())
    }

    /// The interface in a file that :meth:`write` or ``coface yin interface -o`` wrote.
    ///
    /// Parameters
    /// ----------
    /// path : path-like
    ///     A ``.json`` file.
    ///
    /// Returns
    /// -------
    /// Interface
    ///     The same interface, bit for bit.
    ///
    /// Examples
    /// --------
    /// >>> import coface, numpy as np, os, tempfile
    /// >>> rooms = coface.interface(np.array([[1, 1, 2], [1, 1, 2]]))
    /// >>> path = os.path.join(tempfile.mkdtemp(), "rooms.json")
    /// >>> rooms.write(path)
    /// >>> coface.Interface.read(path).areas
    /// [4.0, 2.0]
    #[staticmethod]
    fn read(py: Python<'_>, path: PathBuf) -> PyResult<Self> {
        run(py, None, || {
            let name = path.display().to_string();
            let in_file = |error: Error| error.in_file(name.clone());
            let text = std::fs::read(&path).map_err(|error| in_file(Error::from(error)))?;
            let answer = YinInterfaceAnswer::of_json(&text).unwrap_or_else(|| {
                Err(Error::new(ErrorKind::Parse, "there is no interface in it")
                    .with_cure("give a file that Interface.write wrote, or make one of sets by coface.interface"))
            });
            Self::of(PlanarInterface::of_answer(&answer.map_err(in_file)?).map_err(in_file)?)
        })
    }

    /// Writes the interface to a ``.json`` file, with the control points of all edges.
    fn write(&self, py: Python<'_>, path: PathBuf) -> PyResult<()> {
        run(py, None, || io::replace_file(&path, |out| Ok(writeln!(out, "{}", to_json(&self.answer))?)))
    }

    /// The phase with this name, or with this number if none has the name, as a set.
    ///
    /// Parameters
    /// ----------
    /// name : str or int
    ///     Its name or its number, from 0.
    ///
    /// Returns
    /// -------
    /// YinSet
    ///     Its neighbors have the same pieces along their common edges.
    fn phase(&self, py: Python<'_>, name: &Bound<'_, PyAny>) -> PyResult<YinSet> {
        let name = name.str()?.to_string();
        run(py, None, || YinSet::of(self.interface.phase(&name)?))
    }

    /// Where points lie: in which phase, on an edge, or in no phase.
    ///
    /// Parameters
    /// ----------
    /// points : array_like of shape (n, 2)
    ///     The points.
    ///
    /// Returns
    /// -------
    /// phases : ndarray of shape (n,) and type int64
    ///     The number of the phase that each point lies in, -1 for points in no phase, -2 for points on an edge.
    /// facts : dict
    ///     ``phases`` (each with its ``name`` and the number of points ``inside``), ``boundary``, ``outside``, and for each of ``points`` its
    ///     ``location``, ``phases`` (of a point on an edge those that meet there), ``distance``, ``nearest`` point of the edges, ``edge``,
    ///     ``piece`` and ``parameter``.
    ///
    /// Examples
    /// --------
    /// >>> import coface, numpy as np
    /// >>> rooms = coface.interface(np.array([[1, 1, 2], [1, 1, 2]]))
    /// >>> phases, facts = rooms.locate([[1, 1], [2.5, 1], [2, 1], [9, 9]])
    /// >>> phases.tolist(), facts["points"][2]["phases"], facts["points"][0]["distance"]
    /// ([0, 1, -2, -1], [0, 1], 1.0)
    fn locate<'py>(
        &self,
        py: Python<'py>,
        points: &Bound<'py, PyAny>,
    ) -> PyResult<(Bound<'py, PyArray1<i64>>, Bound<'py, PyAny>)> {
        let points = points_of(points, "points")?;
        let found = run(py, None, || self.interface.located("self", &points))?;
        let number = |place: &InterfacePoint| match place.location {
            YinLocation::Inside => i64::from(place.phases[0]),
            YinLocation::Boundary => -2,
            YinLocation::Outside => -1,
        };
        let phases = PyArray1::from_vec(py, found.points.iter().map(number).collect());
        Ok((phases, to_python(py, &found)?))
    }

    /// How far the phases are from those of another interface; namesakes are compared with each other.
    ///
    /// Parameters
    /// ----------
    /// other : Interface
    ///     With the same names, or as many phases.
    ///
    /// Returns
    /// -------
    /// dict
    ///     ``area_xor`` (the sum over all phases), ``area_xor_error``, ``junctions`` of both, and ``phases``, each with ``numbers`` and what
    ///     :meth:`YinSet.compare` says.
    fn compare<'py>(&self, py: Python<'py>, other: &Bound<'py, Self>) -> PyResult<Bound<'py, PyAny>> {
        let other = &other.get().interface;
        to_python(py, &run(py, None, || self.interface.compared_with("self", other, "other"))?)
    }

    /// The interface after it moved with a flow: phases keep their common arcs, and junctions stay junctions.
    ///
    /// Parameters
    /// ----------
    /// flow : str or callable
    ///     As for :meth:`YinSet.advected`.
    /// end : float, optional
    ///     The time at the end; the period, or 1.
    /// step : float, optional
    ///     The time step; a hundredth of the time if left out.
    /// spacing : float, optional
    ///     The largest distance of points along edges; a hundredth of the size if left out.
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
    ///     When it is checked that edges do not cross.
    /// repair : {"nonzero", "evenodd", "positive"}, optional
    ///     The rule by which edges that cross are cut and pasted, instead of refused.
    /// scheme : {"midpoint", "classical", "verner", "cooper-verner"}, optional
    ///     The Runge-Kutta scheme, of order 2, 4, 6 or 8; that of the order of the edges if left out.
    /// parameters : {"lengths", "kept"}, optional
    ///     What the parameters of splines are: the distances of neighbors, as in cubic MARS, or those that knots had at the beginning, which are
    ///     more exact by far unless the velocity jumps along the boundary. Lengths in orders 2 and 4, kept in orders 6 and 8, if left out.
    /// least_ratio : float
    ///     The least distance of points along edges as a part of ``spacing``, up to 1/3.
    /// turn : float, optional
    ///     Points are added where the polygon through them turns by more degrees.
    /// keep_small : bool
    ///     Keep closed edges that become short beside ``spacing``. Otherwise they leave the interface, with an :class:`AssumptionWarning`.
    /// events : bool
    ///     List the changes of the topology, with times that are narrowed down within steps.
    /// event_tolerance : float, optional
    ///     How exactly these times are found; a thousandth of the step if left out.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// interface : Interface
    ///     The interface, with the same phases.
    /// facts : dict
    ///     ``steps``, ``added``, ``removed``, ``vanished``, ``repairs``, and ``events``: ``None`` unless asked for, else dictionaries with
    ///     ``time``, ``kind``, ``words``, ``place``, ``phases``, ``before`` and ``after``, as ``coface yin advect --events`` gives them.
    ///
    /// Examples
    /// --------
    /// >>> import coface, numpy as np
    /// >>> rooms = coface.interface(np.array([[1, 1, 2], [1, 1, 2]]))
    /// >>> moved, facts = rooms.advected("translation", 1.0, velocity=(2.0, 0.0), spacing=3.0)
    /// >>> len(moved.junctions), [round(area, 9) for area in moved.areas]
    /// (2, [4.0, 2.0])
    #[pyo3(signature = (flow, end=None, *, step=None, spacing=None, period=4.0, vortices=4, velocity=[1.0, 0.0], center=[0.0, 0.0], speed=1.0, verify="each-step", repair=None, scheme=None, parameters=None, least_ratio=0.1, turn=None, keep_small=false, events=false, event_tolerance=None, progress=None))]
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
        progress: Option<&Bound<'py, PyAny>>,
    ) -> PyResult<(Self, Bound<'py, PyAny>)> {
        let (flow, usual) = GivenFlow::read(flow, period, vortices, velocity, center, speed)?;
        let graph = self.interface.graph();
        let extent = Some([[0.0; 2], [self.interface.extent(); 2]]);
        let mut options = tracking_options(end.unwrap_or(usual), step, spacing, extent);
        options = options.verification(verification_of(py, verify)?).repair(rule_of(py, repair)?);
        options = options.scheme(scheme_of(py, scheme)?).parameters(parameters_of(py, parameters)?);
        options = options.least_ratio(least_ratio).most_turn(turn.map(f64::to_radians)).keep_small(keep_small);
        options = options.events(events).event_tolerance(event_tolerance);
        let moved = flow.moved(
            py,
            progress,
            |velocity| graph.advected(velocity, &options),
            |velocities| graph.advected_together(velocities, &options),
        )?;
        if let Some((first, _)) = moved.vanished().first() {
            let count = moved.vanished().len();
            let message = format!(
                "{count} of the closed edges became shorter than three times the least distance of points and left the interface, the first at \
                 time {first}; give keep_small=True to keep such edges"
            );
            errors::warn(py, &message)?;
        }
        let counts = moved.counts();
        let repair = |repair: &InterfaceRepair| RepairedEdges {
            step: repair.step(),
            time: repair.time(),
            fault: repair.fault().to_string(),
        };
        let facts = MotionFacts {
            steps: counts.steps(),
            added: counts.added(),
            removed: counts.removed(),
            vanished: moved
                .vanished()
                .iter()
                .map(|&(time, edge)| VanishedEdge { time, edge: edge.map(EdgeId::to_u32) })
                .collect(),
            repairs: moved.repairs().iter().map(repair).collect(),
            events: options.times_within().or_raise(py)?.map(|_| moved.events().iter().map(YinInterfaceEventAnswer::new).collect()),
        };
        let found = run(py, None, || Self::of(self.interface.followed_by(&moved)))?;
        Ok((found, to_python(py, &facts)?))
    }

    fn __len__(&self) -> usize {
        self.answer.phases.len()
    }

    fn __repr__(&self) -> String {
        format!(
            "Interface({} phases, {} edges, {} junctions)",
            self.answer.phases.len(),
            self.answer.edges.len(),
            self.answer.junctions.len()
        )
    }
}

/// What moving an interface did.
#[derive(Serialize)]
struct MotionFacts {
    steps: usize,
    added: usize,
    removed: usize,
    vanished: Vec<VanishedEdge>,
    repairs: Vec<RepairedEdges>,
    events: Option<Vec<YinInterfaceEventAnswer>>,
}

/// A closed edge that became too small, and when.
#[derive(Serialize)]
struct VanishedEdge {
    time: f64,
    edge: Option<u32>,
}

/// Edges that crossed, and when they were cut and pasted.
#[derive(Serialize)]
struct RepairedEdges {
    step: usize,
    time: f64,
    fault: String,
}

impl Interface {
    pub(super) fn of(interface: PlanarInterface) -> Result<Self, Error> {
        let answer = interface.answer(&[], true)?;
        Ok(Self { interface, answer })
    }
}

/// The interface of named sets.
#[pyfunction]
#[pyo3(signature = (names, sets, overlaps, smooth, progress=None))]
pub(crate) fn _interface(
    py: Python<'_>,
    names: Vec<String>,
    sets: Vec<PyRef<'_, YinSet>>,
    overlaps: &str,
    smooth: f64,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Interface> {
    let overlaps = choice(
        py,
        "overlaps",
        overlaps,
        &[("refuse", Overlaps::Refused), ("first", Overlaps::ToTheFirst), ("last", Overlaps::ToTheLast)],
    )?;
    if !(smooth.is_finite() && smooth < 180.0) {
        let cure = "give an angle below 180 degrees; a negative one lets no edges go on smoothly";
        return Err(invalid(py, format!("smooth is {smooth}"), cure));
    }
    let named = names.into_iter().zip(&sets).map(|(name, set)| NamedSet::new(name, set.set.as_ref().clone()));
    let named: Vec<NamedSet> = named.collect();
    drop(sets);
    run(py, progress, || {
        let options =
            InterfaceOptions::new(PlanarInterface::order_for(&named)).smooth_angle(smooth.to_radians());
        Interface::of(PlanarInterface::of(named, &options, overlaps)?)
    })
}

fn as_pairs(sets: Vec<NamedSet>) -> Result<Vec<(String, YinSet)>, Error> {
    sets.into_iter().map(|one| Ok((one.name, YinSet::of(one.set)?))).collect()
}

/// A set for each label but 0 of an image, the highest row first.
#[pyfunction]
pub(crate) fn _label_sets(py: Python<'_>, width: usize, labels: Vec<u32>) -> PyResult<Vec<(String, YinSet)>> {
    run(py, None, || as_pairs(LabelImage::new(width, labels)?.sets()?))
}

/// A set for each feature of a drawing; none for curves that bound one set.
#[pyfunction]
#[pyo3(signature = (model, order=None))]
pub(crate) fn _feature_sets(
    py: Python<'_>,
    model: &Bound<'_, Model>,
    order: Option<usize>,
) -> PyResult<Option<Vec<(String, YinSet)>>> {
    let mut request = SetRequest::default();
    request.order = order.map(|order| super::order_of(py, order)).transpose()?;
    let model = &model.get().source.model;
    run(py, None, || {
        let drawing = io::yin::drawing_of_model(model)?;
        NamedSet::of_features("feature", &drawing, &request)?.map(as_pairs).transpose()
    })
}
