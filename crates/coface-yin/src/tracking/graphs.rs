//! Interfaces that move.

use super::graph_events::{GraphOnTheWay, InterfaceEvent};
use super::markers::{MarkerRange, moved_markers, polyline_length};
use super::sets::in_step;
use super::{TrackingCounts, TrackingOptions};
use crate::curve::is_one_velocity;
use crate::interface::Arcs;
use crate::kinks::are_surely_apart;
use crate::{Curve, DirectedEdge, InterfaceFault, InterfaceGraph, InterfaceOptions, Overlaps, YinSet};
use coface_algebra::progress::stage;
use coface_algebra::{EdgeId, Error, Sign, VertexId};
use coface_arrange::boolean::InsideRule;

/// After a repair edges go on smoothly into each other where they turn by at most this angle, in radians: those that did before turn by
/// no more than rounding.
const SMOOTH_ANGLE: f64 = 1e-6;

/// An interface whose edges came to meet, and was cut and pasted by a rule.
#[derive(Clone, Debug, PartialEq)]
pub struct InterfaceRepair {
    pub(crate) step: usize,
    pub(crate) time: f64,
    pub(crate) fault: InterfaceFault,
}

impl InterfaceRepair {
    /// The step, counted from 1.
    pub fn step(&self) -> usize {
        self.step
    }

    /// The time at its end.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// What was found first.
    pub fn fault(&self) -> &InterfaceFault {
        &self.fault
    }
}

/// An interface that has moved.
#[derive(Clone, Debug)]
pub struct TrackedGraph {
    pub(super) graph: InterfaceGraph,
    pub(super) counts: TrackingCounts,
    pub(super) vanished: Vec<(f64, Option<EdgeId>)>,
    pub(super) repairs: Vec<InterfaceRepair>,
    pub(super) edges: Vec<Option<EdgeId>>,
    pub(super) events: Vec<InterfaceEvent>,
}

impl TrackedGraph {
    /// The interface at the end.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, Flow, InterfaceEdge, InterfaceGraph, Order, TrackingOptions};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let moved = graph.advected(|point, time| shift.velocity(point, time), &TrackingOptions::new(1.0, 0.5, 2.0))?;
    /// assert!((moved.graph().vertices()[0][0] - 1.0).abs() < 1e-12);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn graph(&self) -> &InterfaceGraph {
        &self.graph
    }

    /// What happened to markers.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, Flow, InterfaceEdge, InterfaceGraph, Order, TrackingOptions};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let moved = graph.advected(|point, time| shift.velocity(point, time), &TrackingOptions::new(1.0, 0.5, 2.0))?;
    /// assert_eq!(moved.counts().steps(), 2);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn counts(&self) -> TrackingCounts {
        self.counts
    }

    /// The closed edges that became too short and were taken out, each with the time and its number at the beginning; those that a
    /// repair has made have none.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, Flow, InterfaceEdge, InterfaceGraph, Order, TrackingOptions};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let moved = graph.advected(|point, time| shift.velocity(point, time), &TrackingOptions::new(1.0, 0.5, 2.0))?;
    /// assert!(moved.vanished().is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn vanished(&self) -> &[(f64, Option<EdgeId>)] {
        &self.vanished
    }

    /// What was cut and pasted on the way, by time; nothing without [`TrackingOptions::repair`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, Flow, InterfaceEdge, InterfaceGraph, Order, TrackingOptions};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let moved = graph.advected(|point, time| shift.velocity(point, time), &TrackingOptions::new(1.0, 0.5, 2.0))?;
    /// assert!(moved.repairs().is_empty());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn repairs(&self) -> &[InterfaceRepair] {
        &self.repairs
    }

    /// The changes of the topology, by time; nothing without [`TrackingOptions::events`] or [`TrackingOptions::on_contact`].
    ///
    /// # Examples
    /// A disk shrinks to a point, and leaves its phase empty.
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{Curve, InterfaceEventKind, InterfaceGraph, Order, TrackingOptions, YinSet};
    /// let disk = YinSet::new(&[Curve::circle([0.0, 0.0], 1.0, 64, Order::CUBIC)?])?;
    /// let graph = InterfaceGraph::of_sets(&[disk], Order::CUBIC, 0.0)?;
    /// let moved = graph.advected(|[x, y], _| [-x, -y], &TrackingOptions::new(8.0, 0.25, 0.1).events(true))?;
    /// let event = &moved.events()[0];
    /// assert_eq!((event.kind(), event.phases()), (InterfaceEventKind::PhaseVanishes, &[0][..]));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn events(&self) -> &[InterfaceEvent] {
        &self.events
    }

    /// For each edge its number at the beginning; after a repair, and where phases came together, edges have none.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, Flow, InterfaceEdge, InterfaceGraph, Order, TrackingOptions};
    /// let edge = InterfaceEdge { ends: [0, 0], markers: vec![[1.0, 0.0], [0.0, 1.0]], phases: [Some(0), None] };
    /// let around = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&[[0.0, 0.0]], &[edge], &[around], Order::LINEAR)?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let moved = graph.advected(|point, time| shift.velocity(point, time), &TrackingOptions::new(1.0, 0.5, 2.0))?;
    /// assert_eq!(moved.edges(), [Some(EdgeId::new(0))]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn edges(&self) -> &[Option<EdgeId>] {
        &self.edges
    }
}

/// Whether an edge is closed, at a vertex of its own.
fn is_alone(graph: &InterfaceGraph, edge: EdgeId) -> bool {
    let [start, end] = graph.ends(edge);
    start == end && graph.degree(start) == 2
}

/// The distances of markers of an edge.
fn range_of(graph: &InterfaceGraph, edge: EdgeId, range: MarkerRange) -> MarkerRange {
    if is_alone(graph, edge) { range.for_curve(graph.curve(edge)) } else { range }
}

impl InterfaceGraph {
    /// The interface after all its points have moved with a velocity, which depends on the point and the time.
    ///
    /// Vertices stay vertices and edges stay edges, each fitted anew after each step. Closed edges at vertices of their own vanish when
    /// they are shorter than three times the least distance of markers. Other edges stay, however short. [`TrackingOptions::events`] lists what
    /// changes, with times narrowed down within steps: see [`InterfaceEventKind`](super::InterfaceEventKind) for what is decided.
    ///
    /// With [`TrackingOptions::on_contact`] phases come together where what is between them becomes narrower than a distance: a phase with itself, and
    /// two phases by an edge that they get in common. Components that are narrow all along go to the phase that they have most of their boundary in
    /// common with.
    ///
    /// Where edges come closer to each other than the error of tracking they may meet: that is an error, or repaired by the rule of
    /// [`TrackingOptions::repair`], which says what is inside of each phase; what then lies in several goes to the lowest.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for options without meaning, a velocity that is not finite, an
    /// interface that cannot be fitted any more, and edges that have come to meet; the step, the time and the place are named.
    ///
    /// # Complexity
    /// Linear in markers times steps, in parallel over markers; and an overlay of the edges for each verification.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, Flow, InterfaceEdge, InterfaceGraph, Order, TrackingOptions};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = (0..32).map(|i| f64::from(i) * std::f64::consts::PI / 16.0).map(|t| [t.cos(), t.sin()]).collect::<Vec<_>>();
    /// let edge = InterfaceEdge { ends: [0, 0], markers: circle[1..].to_vec(), phases: [Some(0), Some(1)] };
    /// let base_point = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&circle[..1], &[edge], &[base_point], Order::CUBIC)?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let moved = graph.advected(|point, time| shift.velocity(point, time), &TrackingOptions::new(2.0, 0.5, 0.2))?;
    /// assert!((moved.graph().phase_area(0)? - graph.phase_area(0)?).abs() < 1e-12);
    /// # Ok(()) }
    /// ```
    pub fn advected(
        &self,
        velocity: impl Fn([f64; 2], f64) -> [f64; 2] + Sync,
        options: &TrackingOptions,
    ) -> Result<TrackedGraph, Error> {
        let scheme = options.scheme_for(self.order());
        self.advected_by(|points, time, step| scheme.mapped_each(&velocity, points, time, step), options)
    }

    /// The same with velocities of many points at once: `velocities` gets points and a time, and gives a velocity for each of
    /// the points, in their order. Where a velocity of one point costs little beside a call, this is the faster way.
    ///
    /// # Errors
    /// As [`Self::advected`]; a list that is too short counts as velocities that are not finite.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_yin::{DirectedEdge, Flow, InterfaceEdge, InterfaceGraph, Order, TrackingOptions};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = (0..32).map(|i| f64::from(i) * std::f64::consts::PI / 16.0).map(|t| [t.cos(), t.sin()]).collect::<Vec<_>>();
    /// let edge = InterfaceEdge { ends: [0, 0], markers: circle[1..].to_vec(), phases: [Some(0), Some(1)] };
    /// let base_point = [DirectedEdge::along(EdgeId::new(0)); 2];
    /// let graph = InterfaceGraph::new(&circle[..1], &[edge], &[base_point], Order::CUBIC)?;
    /// let shift = Flow::Translation { velocity: [1.0, 0.0] };
    /// let moved = graph.advected_together(|points, time| points.iter().map(|&p| shift.velocity(p, time)).collect(), &TrackingOptions::new(2.0, 0.5, 0.2))?;
    /// assert!((moved.graph().phase_area(0)? - graph.phase_area(0)?).abs() < 1e-12);
    /// # Ok(()) }
    /// ```
    pub fn advected_together(
        &self,
        velocities: impl Fn(&[[f64; 2]], f64) -> Vec<[f64; 2]>,
        options: &TrackingOptions,
    ) -> Result<TrackedGraph, Error> {
        let scheme = options.scheme_for(self.order());
        self.advected_by(
            |points, time, step| scheme.mapped_together(&velocities, points, time, step),
            options,
        )
    }

    fn advected_by(
        &self,
        map: impl Fn(&[[f64; 2]], f64, f64) -> Vec<[f64; 2]>,
        options: &TrackingOptions,
    ) -> Result<TrackedGraph, Error> {
        let (steps, step) = options.steps()?;
        let mut way = GraphOnTheWay::new(self, options, options.times_within()?)?;
        way.counts.steps = steps;
        let steps_done = stage("moving", steps);
        for at in 0..steps {
            steps_done.advance(1);
            let time = options.start + at as f64 * step;
            let is_verified = options.is_verified_after(at, steps);
            way.step(&map, at + 1, [time, time + step], is_verified.then_some(at + 1 == steps))
                .map_err(|error| in_step(&error, at + 1, time + step))?;
        }
        way.finish().map_err(|error| in_step(&error, steps, options.end))?;
        Ok(way.tracked())
    }

    /// The interface after a part of a step, in which edges that are closed and short go.
    pub(super) fn moved_by(
        &self,
        map: &impl Fn(&[[f64; 2]]) -> Vec<[f64; 2]>,
        range: MarkerRange,
        counts: &mut TrackingCounts,
    ) -> Result<(Self, Vec<bool>), Error> {
        let mut points = Vec::with_capacity(self.edge_count());
        let mut parameters = Vec::with_capacity(self.edge_count());
        for edge in (0..self.edge_count()).map(EdgeId::new) {
            let own_range = range_of(self, edge, range);
            let moved = moved_markers(self.curve(edge), |_| false, map, own_range, counts)?;
            points.push(moved.points);
            parameters.push(moved.parameters);
        }
        let mut vertices = map(self.vertices());
        vertices.resize(self.vertices().len(), [f64::NAN; 2]);
        for (edge, own) in points.iter().enumerate() {
            // Bit for bit what the edges have.
            let [start, end] = self.ends(EdgeId::new(edge)).map(VertexId::index);
            (vertices[start], vertices[end]) = (own[0], own[own.len() - 1]);
        }
        let is_gone = |edge: usize| {
            let least = range_of(self, EdgeId::new(edge), range).least;
            is_alone(self, EdgeId::new(edge))
                && (points[edge].len() < 4 || polyline_length(&points[edge]) < 3.0 * least)
        };
        let stays: Vec<bool> = (0..self.edge_count()).map(|edge| !is_gone(edge)).collect();
        for pair in self.smooth_pairs().iter().filter(|pair| !self.is_one_velocity_at(pair)) {
            pair.iter().for_each(|edge| parameters[edge.edge.index()] = None);
        }
        Ok((self.moved(vertices, &points, &parameters, &stays)?, stays))
    }

    /// Whether two edges have one velocity where the first goes on into the second.
    fn is_one_velocity_at(&self, [from, to]: &[DirectedEdge; 2]) -> bool {
        // From where an edge begins, or backward along it.
        let velocity = |edge: DirectedEdge| {
            let curve = self.curve(edge.edge);
            match edge.sign {
                Sign::Plus => curve.derivative_at(0, 0.0, 1),
                Sign::Minus => curve.derivative_at(curve.piece_count() - 1, 1.0, 1).map(|x| -x),
            }
        };
        is_one_velocity(velocity(from.reversed()).map(|x| -x), velocity(*to))
    }

    /// Whether edges have come to meet; that they are surely apart is enough unless it is looked thoroughly.
    pub(super) fn fault_on_the_way(&self, is_thorough: bool) -> Result<Option<InterfaceFault>, Error> {
        let edges = (0..self.edge_count()).map(EdgeId::new);
        let edges = edges.map(|edge| (self.curve(edge).as_borrowed(), self.ends(edge).map(VertexId::to_u32)));
        if !is_thorough && are_surely_apart(edges) {
            return Ok(None);
        }
        self.fault()
    }

    /// The interface of what a rule says is inside of each phase; what lies in several goes to the lowest.
    pub(crate) fn repaired(&self, rule: InsideRule) -> Result<Self, Error> {
        let phases = self.phases();
        let sets: Vec<YinSet> = phases
            .iter()
            .map(|&phase| {
                let set = self.unchecked_set(phase)?;
                let kinks = self.phase_kinks(phase);
                let curves: Vec<(Curve<'_>, Vec<u32>)> =
                    (0..set.curve_count()).map(|curve| set.curve(curve)).zip(kinks).collect();
                Ok(YinSet::combine_kinked_curves(&curves, i32::from(!set.is_bounded()), rule)?.into_set())
            })
            .collect::<Result<_, Error>>()?;
        let options = InterfaceOptions {
            order: self.order(),
            smooth_angle: SMOOTH_ANGLE,
            overlaps: Overlaps::ToTheFirst,
        };
        let mut graph = Self::of_sets_with(&sets, &options)?;
        for phase in graph.phases_mut().flatten() {
            *phase = phases[*phase as usize];
        }
        Ok(graph)
    }

    /// The same graph with vertices and the points of edges elsewhere, at these parameters, and only the edges that stay.
    fn moved(
        &self,
        vertices: Vec<[f64; 2]>,
        points: &[Vec<[f64; 2]>],
        parameters: &[Option<Vec<f64>>],
        stays: &[bool],
    ) -> Result<Self, Error> {
        let mut count = 0;
        let numbers: Vec<Option<EdgeId>> = (stays.iter())
            .map(|&stays| {
                let number = stays.then(|| EdgeId::new(count));
                count += usize::from(stays);
                number
            })
            .collect();
        let renumbered =
            |edge: DirectedEdge| Some(DirectedEdge { edge: numbers[edge.edge.index()]?, ..edge });
        fn kept<T: Clone>(all: impl Iterator<Item = T>, stays: &[bool]) -> Vec<T> {
            all.zip(stays).filter(|(_, stays)| **stays).map(|(item, _)| item).collect()
        }
        let around = (0..vertices.len()).map(|vertex| {
            self.edges_at(VertexId::new(vertex)).iter().filter_map(|&edge| renumbered(edge)).collect()
        });
        let around = around.collect();
        let ends =
            kept((0..stays.len()).map(|edge| self.ends(EdgeId::new(edge)).map(VertexId::to_u32)), stays);
        let phases = kept((0..stays.len()).map(|edge| self.phases_of(EdgeId::new(edge))), stays);
        let points: Vec<Vec<[f64; 2]>> = kept(points.iter().cloned(), stays);
        let parameters = kept(parameters.iter().cloned(), stays);
        let pairs = self.smooth_pairs().iter();
        let pairs = pairs.filter_map(|&[from, to]| Some([renumbered(from)?, renumbered(to)?])).collect();
        // The flow is a homeomorphism: edges leave vertices in the order in which they did.
        let arcs = Arcs { vertices, ends, phases, smooth_pairs: pairs };
        Self::with_points(arcs, &points, &parameters, self.order(), Some(around))
    }
}
