//! Changes of the topology of interfaces that move, with their times narrowed.

use super::graphs::{InterfaceRepair, TrackedGraph};
use super::{TrackingCounts, TrackingOptions};
use crate::{InterfaceFault, InterfaceGraph};
use coface_algebra::{EdgeId, Error};
use std::collections::BTreeMap;
use std::fmt;

/// So often a step is halted; what comes after that in it has the time of its end.
const HALTS: usize = 64;

/// A kind of change of an interface.
///
/// A flow is a homeomorphism, so phases vanish, split and merge only as far as markers tell: closed edges that are too short to have a shape
/// leave the interface, and edges that come to meet are cut and pasted by a rule, if there is one. Edges at junctions are kept, however
/// short; that the junctions at the ends of one meet is said when it becomes shorter than the least distance of markers. Edges that lead
/// from a junction to itself are kept too, and nothing is said of them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum InterfaceEventKind {
    /// The last component of a phase becomes too small to have a shape.
    PhaseVanishes,
    /// A component of a phase that has others becomes too small to have a shape.
    ComponentVanishes,
    /// A hole of a phase, in which there is no phase, becomes too small to have a shape.
    HoleVanishes,
    /// The junctions at the ends of an edge meet.
    JunctionsMeet,
    /// Components of a phase become fewer where edges are cut and pasted.
    PhaseMerges,
    /// Components of a phase become more where edges are cut and pasted.
    PhaseSplits,
    /// Holes of a phase become more where edges are cut and pasted.
    HoleForms,
    /// Holes of a phase become fewer where edges are cut and pasted.
    HoleOpens,
}

impl fmt::Display for InterfaceEventKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::PhaseVanishes => "a phase vanishes",
            Self::ComponentVanishes => "a component of a phase vanishes",
            Self::HoleVanishes => "a hole of a phase vanishes",
            Self::JunctionsMeet => "junctions meet",
            Self::PhaseMerges => "components of a phase merge",
            Self::PhaseSplits => "a phase splits",
            Self::HoleForms => "a hole forms in a phase",
            Self::HoleOpens => "a hole of a phase opens",
        })
    }
}

/// A change of the topology of an interface that moves.
///
/// # Examples
/// See [`TrackedGraph::events`].
#[derive(Clone, Debug, PartialEq)]
pub struct InterfaceEvent {
    time: f64,
    kind: InterfaceEventKind,
    place: [f64; 2],
    phases: Vec<u32>,
    counts: Option<[[usize; 2]; 2]>,
}

impl InterfaceEvent {
    /// When it came: the first time, but for [`TrackingOptions::event_tolerance`], at which it is seen.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// What changed.
    pub fn kind(&self) -> InterfaceEventKind {
        self.kind
    }

    /// Where: the mean of the knots of an edge that vanishes, the middle of the ends of one whose junctions meet, or the place at which edges
    /// came to meet.
    pub fn place(&self) -> [f64; 2] {
        self.place
    }

    /// The phase that changed; of junctions that meet all phases around them.
    pub fn phases(&self) -> &[u32] {
        &self.phases
    }

    /// The numbers of components and holes of the phase just before and just after; none for junctions that meet.
    pub fn counts(&self) -> Option<[[usize; 2]; 2]> {
        self.counts
    }
}

/// An interface moved for a part of a step, and what came of that.
struct Trial {
    graph: InterfaceGraph,
    counts: TrackingCounts,
    /// Which edges of before are left.
    stays: Vec<bool>,
    /// Which edges that are left are too short for their junctions to be told apart.
    is_short: Vec<bool>,
    fault: Option<InterfaceFault>,
}

/// An interface on its way.
pub(super) struct GraphOnTheWay<'a> {
    options: &'a TrackingOptions,
    /// How exactly times of events are found, if they are looked for.
    tolerance: Option<f64>,
    graph: InterfaceGraph,
    pub(super) counts: TrackingCounts,
    vanished: Vec<(f64, Option<EdgeId>)>,
    repairs: Vec<InterfaceRepair>,
    /// For each edge its number at the beginning.
    numbers: Vec<Option<EdgeId>>,
    /// The edges of which it is known that their junctions meet.
    is_short: Vec<bool>,
    events: Vec<InterfaceEvent>,
}

impl<'a> GraphOnTheWay<'a> {
    pub(super) fn new(graph: &InterfaceGraph, options: &'a TrackingOptions, tolerance: Option<f64>) -> Self {
        Self {
            options,
            tolerance,
            graph: graph.clone(),
            counts: TrackingCounts::default(),
            vanished: Vec::new(),
            repairs: Vec::new(),
            numbers: (0..graph.edge_count()).map(EdgeId::new).map(Some).collect(),
            is_short: short_edges(graph, options.range().least),
            events: Vec::new(),
        }
    }

    pub(super) fn tracked(self) -> TrackedGraph {
        TrackedGraph {
            graph: self.graph,
            counts: self.counts,
            vanished: self.vanished,
            repairs: self.repairs,
            edges: self.numbers,
            events: self.events,
        }
    }

    /// Moves the interface through a step, the number of which is counted from 1. It is looked whether edges meet, thoroughly or not, unless
    /// `check` is none.
    pub(super) fn step(
        &mut self,
        map: &impl Fn(&[[f64; 2]], f64, f64) -> Vec<[f64; 2]>,
        number: usize,
        [mut from, end]: [f64; 2],
        check: Option<bool>,
    ) -> Result<(), Error> {
        for halt in 0..=HALTS {
            let (mut found, mut until) = (self.trial(map, [from, end], check)?, end);
            if let Some(tolerance) = self.tolerance
                && halt < HALTS
                && !self.is_quiet(&found)
            {
                let mut quiet = from;
                while (until - quiet).abs() > tolerance {
                    let middle = 0.5 * quiet + 0.5 * until;
                    if middle == quiet || middle == until {
                        break;
                    }
                    let trial = self.trial(map, [from, middle], check)?;
                    if self.is_quiet(&trial) {
                        quiet = middle;
                    } else {
                        (found, until) = (trial, middle);
                    }
                }
            }
            self.take(found, number, until)?;
            if until == end {
                break;
            }
            from = until;
        }
        Ok(())
    }

    fn trial(
        &self,
        map: &impl Fn(&[[f64; 2]], f64, f64) -> Vec<[f64; 2]>,
        [from, until]: [f64; 2],
        check: Option<bool>,
    ) -> Result<Trial, Error> {
        let map = |points: &[[f64; 2]]| map(points, from, until - from);
        let mut counts = self.counts;
        let range = self.options.range();
        let (graph, stays) = self.graph.moved_by(&map, range, &mut counts)?;
        let is_short = match self.tolerance {
            Some(_) => short_edges(&graph, range.least),
            None => vec![false; graph.edge_count()],
        };
        let fault = match check {
            Some(is_thorough) => graph.fault_on_the_way(is_thorough)?,
            None => None,
        };
        Ok(Trial { graph, counts, stays, is_short, fault })
    }

    /// What was known of edges, of those that are left.
    fn kept<T: Copy>(known: &[T], stays: &[bool]) -> Vec<T> {
        known.iter().zip(stays).filter(|(_, stays)| **stays).map(|(own, _)| *own).collect()
    }

    fn is_quiet(&self, trial: &Trial) -> bool {
        let known = Self::kept(&self.is_short, &trial.stays);
        let is_fresh = trial.is_short.iter().zip(known).any(|(&is, was)| is && !was);
        trial.fault.is_none() && !is_fresh && trial.stays.iter().all(|&stays| stays)
    }

    /// Goes on to where a trial has come, after what is done about its events.
    fn take(&mut self, trial: Trial, step: usize, time: f64) -> Result<(), Error> {
        let Trial { graph, counts, stays, is_short, fault } = trial;
        self.counts = counts;
        for edge in (0..stays.len()).filter(|&edge| !stays[edge]) {
            self.vanished.push((time, self.numbers[edge]));
        }
        self.numbers = Self::kept(&self.numbers, &stays);
        let known = Self::kept(&self.is_short, &stays);
        let before = std::mem::replace(&mut self.graph, graph);
        if self.tolerance.is_some() {
            if stays.contains(&false) {
                self.push_vanished(&before, &stays, time)?;
            }
            for edge in (0..is_short.len()).filter(|&edge| is_short[edge] && !known[edge]) {
                self.events.push(junctions_meet(&self.graph, EdgeId::new(edge), time));
            }
        }
        // An edge is told apart again once it is twice as long.
        let twice = short_edges(&self.graph, 2.0 * self.options.range().least);
        self.is_short =
            is_short.iter().zip(known).zip(twice).map(|((&is, was), twice)| is || (was && twice)).collect();
        let Some(fault) = fault else { return Ok(()) };
        let Some(rule) = self.options.repair else {
            return Err(fault.into_error().with_cure(
                "take shorter steps or a smaller spacing, or repair the interface by a fill rule",
            ));
        };
        let repaired = self.graph.repaired(rule)?;
        if self.tolerance.is_some() {
            let place =
                fault.point().unwrap_or_else(|| repaired.vertices().first().copied().unwrap_or_default());
            let counts = [phase_counts(&before)?, phase_counts(&repaired)?];
            self.push_differences(&counts, place, time);
        }
        self.graph = repaired;
        self.numbers = vec![None; self.graph.edge_count()];
        self.is_short = short_edges(&self.graph, self.options.range().least);
        self.repairs.push(InterfaceRepair { step, time, fault });
        Ok(())
    }

    /// What vanishes with closed edges.
    fn push_vanished(&mut self, before: &InterfaceGraph, stays: &[bool], time: f64) -> Result<(), Error> {
        let mut counts = phase_counts(before)?;
        for edge in (0..stays.len()).filter(|&edge| !stays[edge]).map(EdgeId::new) {
            let curve = before.curve(edge);
            let [left, right] = before.phases_of(edge);
            let [inner, outer] = if curve.signed_area() > 0.0 { [left, right] } else { [right, left] };
            let count = curve.piece_count();
            let place = [0, 1]
                .map(|axis| (0..count).map(|knot| curve.knot_point(knot)[axis] / count as f64).sum::<f64>());
            // A component of what is inside is gone, and with it the hole of what is around it.
            if let (Some(_), Some(own)) = (inner, outer.and_then(|outer| counts.get_mut(&outer))) {
                own[1] = own[1].saturating_sub(1);
            }
            let (phase, axis) = match (inner, outer) {
                (Some(inner), _) => (inner, 0),
                (None, Some(outer)) => (outer, 1),
                (None, None) => continue,
            };
            let now = counts.get(&phase).copied().unwrap_or_default();
            let mut then = now;
            then[axis] = then[axis].saturating_sub(1);
            counts.insert(phase, then);
            let kind = match (axis, then) {
                (0, [0, _]) => InterfaceEventKind::PhaseVanishes,
                (0, _) => InterfaceEventKind::ComponentVanishes,
                _ => InterfaceEventKind::HoleVanishes,
            };
            let (phases, counts) = (vec![phase], Some([now, then]));
            self.events.push(InterfaceEvent { time, kind, place, phases, counts });
        }
        Ok(())
    }

    /// What has changed in phases where edges were cut and pasted.
    fn push_differences(
        &mut self,
        [before, after]: &[BTreeMap<u32, [usize; 2]>; 2],
        place: [f64; 2],
        time: f64,
    ) {
        use InterfaceEventKind::{HoleForms, HoleOpens, PhaseMerges, PhaseSplits, PhaseVanishes};
        for (&phase, &now) in before {
            let then = after.get(&phase).copied().unwrap_or_default();
            for (axis, fewer, more) in [(0, PhaseMerges, PhaseSplits), (1, HoleOpens, HoleForms)] {
                let kind = match then[axis].cmp(&now[axis]) {
                    std::cmp::Ordering::Equal => continue,
                    _ if axis == 0 && then[0] == 0 => PhaseVanishes,
                    std::cmp::Ordering::Less => fewer,
                    std::cmp::Ordering::Greater => more,
                };
                let (phases, counts) = (vec![phase], Some([now, then]));
                self.events.push(InterfaceEvent { time, kind, place, phases, counts });
            }
        }
    }
}

/// That the junctions at the ends of an edge meet.
fn junctions_meet(graph: &InterfaceGraph, edge: EdgeId, time: f64) -> InterfaceEvent {
    let ends = graph.ends(edge);
    let points = ends.map(|end| graph.vertices()[end.index()]);
    let around = ends.iter().flat_map(|&end| graph.edges_at(end));
    let mut phases: Vec<u32> = around.flat_map(|own| graph.phases_of(own.edge)).flatten().collect();
    phases.sort_unstable();
    phases.dedup();
    InterfaceEvent {
        time,
        kind: InterfaceEventKind::JunctionsMeet,
        place: [0, 1].map(|axis| 0.5 * points[0][axis] + 0.5 * points[1][axis]),
        phases,
        counts: None,
    }
}

/// Which edges between two junctions are shorter than a length, by the polygons of their knots.
fn short_edges(graph: &InterfaceGraph, least: f64) -> Vec<bool> {
    let is_short = |edge: EdgeId| {
        let [start, end] = graph.ends(edge);
        let curve = graph.curve(edge);
        let knots: Vec<[f64; 2]> = (0..=curve.piece_count()).map(|knot| curve.knot_point(knot)).collect();
        start != end
            && graph.degree(start) > 2
            && graph.degree(end) > 2
            && super::markers::polyline_length(&knots) < least
    };
    (0..graph.edge_count()).map(EdgeId::new).map(is_short).collect()
}

/// The numbers of components and holes of each phase.
fn phase_counts(graph: &InterfaceGraph) -> Result<BTreeMap<u32, [usize; 2]>, Error> {
    graph.phases().into_iter().map(|phase| Ok((phase, graph.phase_set(phase)?.betti_open()?))).collect()
}
