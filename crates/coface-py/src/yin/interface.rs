//! Interfaces: sets as phases that share the arcs between them.

use super::kink_request::kinks_of;
use super::motion::{
    GivenFlow, below_knots, contact_of, parameters_of, scheme_of, tracking_options, verification_of,
};
use super::{CutCells, YinSet, points_of};
use crate::answer::answer;
use crate::arrangement::rule_of;
use crate::congruence::choice;
use crate::errors::{self, OrRaise, invalid};
use crate::model::Model;
use crate::objects::{remarks_of, to_python};
use crate::pictures::flat_file;
use crate::target::{Target, warn_all};
use crate::work::run;
use coface::answers::answer::{
    InterfacePoint, YinInterfaceAnswer, YinInterfaceEventAnswer, YinLocation, to_json,
};
use coface::answers::{InterfaceKinksRequest, LabelImage, NamedSet, PlanarInterface, SetRequest, text};
use coface::arrange::boolean::InsideRule;
use coface::io;
use coface::pictures::interface_picture;
use coface::yin::{InterfaceEventKind, InterfaceOptions, InterfaceRepair, KnotIndex, Overlaps};
use coface::{EdgeId, Error, ErrorKind};
use numpy::PyArray1;
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyDict};
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
}
    /// What was assumed, changed or left out, each a dictionary with ``code``, ``message``, ``count`` and ``places``; a warning said so too.
    #[getter]
    fn remarks<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyAny>> {
        remarks_of(py, &self.answer.remarks)
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
    /// rule : {"nonzero", "evenodd", "positive"}, optional
    ///     What is inside of edges that cross: they are cut and pasted by it, and the interface is in its unique form. Left out, edges that cross are an
    ///     error.
    ///
    /// Returns
    /// -------
    /// Interface
    ///     The same interface, bit for bit unless there is a rule.
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
    #[pyo3(signature = (path, *, rule=None))]
    fn read(py: Python<'_>, path: PathBuf, rule: Option<&str>) -> PyResult<Self> {
        let rule = rule_of(py, rule)?;
        run(py, None, || {
            let name = path.display().to_string();
            let in_file = |error: Error| error.in_file(name.clone());
            let text = std::fs::read(&path).map_err(|error| in_file(Error::from(error)))?;
            let answer = YinInterfaceAnswer::of_json(&text).unwrap_or_else(|| {
                Err(Error::new(ErrorKind::Parse, "there is no interface in it")
                    .with_cure("give a file that Interface.write wrote, or make one of sets by coface.interface"))
            });
            let answer = answer.map_err(in_file)?;
            let found = match rule {
                None => PlanarInterface::of_answer(&answer),
                Some(rule) => PlanarInterface::unchecked(&answer).and_then(|found| Ok(found.normalized(&[], rule)?.0)),
            };
            Self::of(found.map_err(in_file)?)
        })
    }

    /// Writes the interface to a ``.json`` file, by its path or open for writing, with the control points of all edges.
    fn write(&self, py: Python<'_>, path: &Bound<'_, PyAny>) -> PyResult<()> {
        Target::of(path)?.write(py, None, |out| Ok(writeln!(out, "{}", to_json(&self.answer))?))
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

    /// The interface in its unique form: edges that go on smoothly where nothing else ends become one, knots within straight parts of polylines are left
    /// out, and edges and vertices come in one order. Interfaces of order 2 whose phases have the same points have the same edges then.
    ///
    /// Returns
    /// -------
    /// Interface
    ///     With the same phases and junctions.
    ///
    /// Examples
    /// --------
    /// >>> import coface, numpy as np
    /// >>> rooms = coface.interface(np.array([[1, 1, 2], [1, 1, 2]]))
    /// >>> rooms.normalized().vertices
    /// [[2.0, 0.0], [2.0, 2.0]]
    fn normalized(&self, py: Python<'_>) -> PyResult<Self> {
        run(py, None, || Self::of(self.interface.normalized(&[], InsideRule::Nonzero)?.0))
    }

    /// Splines through the knots of the edges, smooth but for junctions and kinks. Each edge is fitted once, so phases keep their common edges.
    ///
    /// Parameters
    /// ----------
    /// order : {2, 4, 6, 8}, optional
    ///     The order; that of the edges, and 4 at least, if left out.
    /// kinks : "none", "all", float, or list of (int, int), optional
    ///     Where edges may turn: nowhere but at junctions, at all knots, where polylines turn by more degrees, or at these (edge, knot); at the kinks that there
    ///     are, if left out.
    ///
    /// Returns
    /// -------
    /// Interface
    ///     With the same phases and junctions.
    ///
    /// Examples
    /// --------
    /// >>> import coface, numpy as np
    /// >>> rooms = coface.interface(np.array([[1, 1, 2], [1, 1, 2]]))
    /// >>> smooth = rooms.fit(4, kinks=45.0)
    /// >>> smooth.order, smooth.areas, len(smooth.kinks)
    /// (4, [4.0, 2.0], 4)
    #[pyo3(signature = (order=None, *, kinks=None))]
    fn fit(&self, py: Python<'_>, order: Option<usize>, kinks: Option<&Bound<'_, PyAny>>) -> PyResult<Self> {
        let order = order.map(|order| super::order_of(py, order)).transpose()?;
        let kinks = kinks.map(kinks_of).transpose()?;
        run(py, None, || Self::of(self.interface.fitted(order, kinks.as_ref())?))
    }

    /// The kinks: vertices at which two edges end that do not go on smoothly into each other. A dictionary from vertices to ``(edge, knot)``, one of the
    /// two ways to name the knot there. Junctions are no kinks.
    #[getter]
    fn kinks<'py>(&self, py: Python<'py>) -> PyResult<Bound<'py, PyDict>> {
        let dict = PyDict::new(py);
        for kink in self.interface.kink_points() {
            dict.set_item(kink.vertex, (kink.edge, kink.knot))?;
        }
        Ok(dict)
    }

    /// The interface with one more kink; its edge is cut into two there.
    ///
    /// Parameters
    /// ----------
    /// edge : int
    ///     The number of the edge.
    /// knot : int
    ///     The number of the knot on it, 0 where it begins.
    ///
    /// Returns
    /// -------
    /// interface : Interface
    ///     The splines beside the kink fitted again; phases on both sides have it.
    /// vertex : int
    ///     The vertex of the kink.
    ///
    /// Examples
    /// --------
    /// >>> import coface, numpy as np
    /// >>> rooms = coface.interface(np.array([[1, 1, 2], [1, 1, 2]]))
    /// >>> cut, vertex = rooms.insert_kink_near([0, 2])
    /// >>> cut.vertices[vertex], len(cut.edges) - len(rooms.edges)
    /// ([0.0, 2.0], 1)
    fn insert_kink(&self, py: Python<'_>, edge: u32, knot: u32) -> PyResult<(Self, u32)> {
        let inserted = vec![KnotIndex { curve: edge, knot }];
        self.with_new_kink(py, &InterfaceKinksRequest { inserted, ..InterfaceKinksRequest::default() })
    }

    /// The interface with one more kink, at the knot that is nearest to a point; junctions are left out.
    ///
    /// Parameters
    /// ----------
    /// point : array_like, shape (2,)
    ///     The point.
    ///
    /// Returns
    /// -------
    /// interface : Interface
    ///     The splines beside the kink fitted again.
    /// vertex : int
    ///     The vertex of the kink.
    fn insert_kink_near(&self, py: Python<'_>, point: [f64; 2]) -> PyResult<(Self, u32)> {
        let request = InterfaceKinksRequest { inserted_near: vec![point], ..InterfaceKinksRequest::default() };
        self.with_new_kink(py, &request)
    }

    /// The interface without a kink; its two edges become one. Vertices and edges with higher numbers get lower ones.
    ///
    /// Parameters
    /// ----------
    /// vertex : int
    ///     The vertex of the kink.
    ///
    /// Returns
    /// -------
    /// interface : Interface
    ///     The splines beside the kink fitted again.
    /// vertex : int
    ///     The vertex that the kink had.
    fn erase_kink(&self, py: Python<'_>, vertex: u32) -> PyResult<(Self, u32)> {
        let request = InterfaceKinksRequest { erased: vec![vertex], ..InterfaceKinksRequest::default() };
        Ok((run(py, None, || Self::of(self.interface.with_kinks(&request)?))?, vertex))
    }

    /// The interface without the kink that is nearest to a point.
    ///
    /// Parameters
    /// ----------
    /// point : array_like, shape (2,)
    ///     The point.
    ///
    /// Returns
    /// -------
    /// interface : Interface
    ///     The splines beside the kink fitted again.
    /// vertex : int
    ///     The vertex that the kink had.
    fn erase_kink_near(&self, py: Python<'_>, point: [f64; 2]) -> PyResult<(Self, u32)> {
        let found = self.interface.graph().nearest_kink(point).or_raise(py)?;
        let cure = "take an interface with kinks";
        let vertex = found.ok_or_else(|| invalid(py, "the interface has no kinks".to_owned(), cure))?;
        self.erase_kink(py, vertex.to_u32())
    }

    /// The interface with these kinks and no others: ``"none"``, ``"all"``, an angle in degrees, or pairs (edge, knot).
    fn reset_kinks(&self, py: Python<'_>, kinks: &Bound<'_, PyAny>) -> PyResult<Self> {
        let request = InterfaceKinksRequest { reset: Some(kinks_of(kinks)?), ..InterfaceKinksRequest::default() };
        run(py, None, || Self::of(self.interface.with_kinks(&request)?))
    }

    /// The phases on one Cartesian grid. What they have of a cell adds up.
    ///
    /// Parameters
    /// ----------
    /// counts : (int, int)
    ///     Columns and rows.
    /// origin : (float, float), optional
    ///     The lower left corner; of the box around all edges, if left out.
    /// spacing : (float, float), optional
    ///     The size of cells; so that this box is covered, if left out.
    /// progress : bool or callable, optional
    ///     ``True`` shows a bar; a function is called with (stage, done, total).
    ///
    /// Returns
    /// -------
    /// list of CutCells
    ///     What each phase has of the cells, in the order of the phases.
    ///
    /// Examples
    /// --------
    /// >>> import coface, numpy as np
    /// >>> rooms = coface.interface(np.array([[1, 1, 2], [1, 1, 2]]))
    /// >>> [cells.areas.tolist() for cells in rooms.cut_cells((2, 1))]
    /// [[[3.0, 1.0]], [[0.0, 2.0]]]
    #[pyo3(signature = (counts=(64, 64), *, origin=None, spacing=None, progress=None))]
    fn cut_cells(
        &self,
        py: Python<'_>,
        counts: (usize, usize),
        origin: Option<[f64; 2]>,
        spacing: Option<[f64; 2]>,
        progress: Option<&Bound<'_, PyAny>>,
    ) -> PyResult<Vec<CutCells>> {
        run(py, progress, || {
            let around = self.interface.bounding_box();
            let phases = self.interface.phases()?;
            phases.iter().map(|phase| CutCells::of(phase.set(), around, counts, origin, spacing)).collect()
        })
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
    /// on_contact : {"keep", "merge"}, optional
    ///     What to do where edges come nearer to each other than ``contact_distance``: ``"merge"`` lets what is beyond them come together, a phase with
    ///     itself, and two phases by an edge that they get in common; ``"keep"`` goes on with the edges as they are, with an
    ///     :class:`AssumptionWarning`, and is an error only if they cross at the end. Left out, contacts are not looked for. Events are listed too.
    /// contact_distance : float, optional
    ///     The least distance of points along edges if left out. With ``"merge"`` components of phases whose mean width is below half of it go to the
    ///     phase that they have most of their boundary in common with.
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
        let graph = self.interface.graph();
        let extent = Some([[0.0; 2], [self.interface.extent(); 2]]);
        let mut options = tracking_options(end.unwrap_or(usual), step, spacing, extent);
        options = options.verification(verification_of(py, verify)?).repair(rule_of(py, repair)?);
        options = options.scheme(scheme_of(py, scheme)?).parameters(parameters_of(py, parameters)?);
        options = options.least_ratio(least_ratio).most_turn(turn.map(f64::to_radians)).keep_small(keep_small);
        options = options.events(events).event_tolerance(event_tolerance);
        options = options.on_contact(contact_of(py, on_contact)?).contact_distance(contact_distance);
        let moved = flow.moved(
            py,
            progress,
            |velocity| graph.advected(velocity, &options),
            |velocities| graph.advected_together(velocities, &options),
        )?;
        below_knots(py, &options)?;
        let kept = moved.events().iter().filter(|event| event.kind() == InterfaceEventKind::Contact);
        if let Some((first, count)) = kept.clone().next().map(|first| (first, kept.count())) {
            let [x, y] = first.place();
            let message = format!(
                "edges came into contact at {} and were left as they are, the first at time {} near ({x}, {y})",
                text::count(count, "place"),
                first.time()
            );
            errors::warn(py, &message)?;
        }
        if let Some((first, _)) = moved.vanished().first() {
            let count = moved.vanished().len();
            let [what, narrow] = match on_contact {
                Some(_) => ["edges", ", or narrower than half of the contact distance,"],
                None => ["closed edges", ""],
            };
            let message = format!(
                "{count} of the {what} became shorter than three times the least distance of points{narrow} and left the interface, the first at \
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

    fn __reduce__<'py>(&self, py: Python<'py>) -> PyResult<(Bound<'py, PyAny>, (Bound<'py, PyBytes>,))> {
        let rebuild = py.import("coface._coface")?.getattr("_interface_of_text")?;
        Ok((rebuild, (PyBytes::new(py, to_json(&self.answer).as_bytes()),)))
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
    /// The interface with a kink that was not there, and its vertex.
    fn with_new_kink(&self, py: Python<'_>, request: &InterfaceKinksRequest) -> PyResult<(Self, u32)> {
        let before: Vec<u32> = self.interface.kink_points().iter().map(|kink| kink.vertex).collect();
        let found = run(py, None, || Self::of(self.interface.with_kinks(request)?))?;
        let fresh =
            found.interface.kink_points().iter().map(|kink| kink.vertex).find(|kink| !before.contains(kink));
        Ok((found, fresh.expect("vertices keep their numbers where a kink comes")))
    }

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
    let made = run(py, progress, || {
        let options =
            InterfaceOptions::new(PlanarInterface::order_for(&named)).smooth_angle(smooth.to_radians());
        Interface::of(PlanarInterface::of(named, &options, overlaps)?)
    })?;
    warn_all(py, &made.answer.remarks)?;
    Ok(made)
}

/// Makes an interface again, for pickling.
#[pyfunction]
pub(crate) fn _interface_of_text(py: Python<'_>, text: Vec<u8>) -> PyResult<Interface> {
    run(py, None, || {
        let answer = YinInterfaceAnswer::of_json(&text).unwrap_or_else(|| {
            Err(Error::new(ErrorKind::Parse, "there is no interface in it")
                .with_cure("pickle the interface again"))
        })?;
        // It was one when it was written.
        let mut found = Interface::of(PlanarInterface::unchecked(&answer)?)?;
        found.answer.remarks = answer.remarks;
        Ok(found)
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
