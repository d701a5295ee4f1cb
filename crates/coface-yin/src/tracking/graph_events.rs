//! Changes of the topology of interfaces that move, with their times narrowed.

use super::contacts::fresh;
use super::graph_contacts::EdgeContact;
use super::graphs::{InterfaceRepair, TrackedGraph};
use super::{OnContact, TrackingCounts, TrackingOptions};
use crate::{InterfaceFault, InterfaceGraph};
use coface_algebra::{EdgeId, Error};
use coface_arrange::boolean::InsideRule;
use std::collections::BTreeMap;
use std::fmt;

/// So often a step is halted; what comes after that in it has the time of its end.
const HALTS: usize = 64;

/// So often a step is halted at contacts that change no topology: edges that are pressed together close a gap bit by bit.
const IDLE_HALTS: usize = 3;

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
    /// Components of a phase become fewer where edges are cut and pasted, or in contact.
    PhaseMerges,
    /// Components of a phase become more where edges are cut and pasted, or in contact.
    PhaseSplits,
    /// Holes of a phase become more where edges are cut and pasted, or in contact.
    HoleForms,
    /// Holes of a phase become fewer where edges are cut and pasted, or in contact.
    HoleOpens,
    /// Two phases come together where what was between them has become too narrow: they get an edge in common.
    PhasesMeet,
    /// Edges come into contact and stay as they are.
    Contact,
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
            Self::PhasesMeet => "phases come together",
            Self::Contact => "edges come into contact",
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

    /// Where: the mean of the knots of an edge that vanishes, the middle of the ends of one whose junctions meet, the place at which edges
    /// came to meet, or the middle of the gap between them.
    pub fn place(&self) -> [f64; 2] {
        self.place
    }

    /// The phase that changed; of junctions that meet all phases around them, of phases that come together these, and of a contact those beyond the
    /// edges and between them.
    pub fn phases(&self) -> &[u32] {
        &self.phases
    }

    /// The numbers of components and holes of the phase just before and just after; none for junctions and phases that meet,
    /// and for contacts.
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
    /// All contacts, and those of them that were not there before the part.
    contacts: Vec<EdgeContact>,
    fresh: Vec<EdgeContact>,
    /// Whether there are components that have become narrow all along, which go.
    has_slivers: bool,
    /// That edges have come to meet, or that this cannot be decided.
    fault: Result<Option<InterfaceFault>, Error>,
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
    /// Nearer than this edges are in contact.
    within: f64,
    /// The places of contacts that are kept.
    kept_contacts: Vec<[f64; 2]>,
    /// Whether edges that are kept as they are cross.
    is_crossed: bool,
    events: Vec<InterfaceEvent>,
}

impl<'a> GraphOnTheWay<'a> {
    pub(super) fn new(
        graph: &InterfaceGraph,
        options: &'a TrackingOptions,
        tolerance: Option<f64>,
    ) -> Result<Self, Error> {
        let within = options.contact_distance.unwrap_or(options.least_ratio * options.spacing);
        let kept_contacts = match options.on_contact {
            Some(OnContact::Keep) => graph.contacts(within)?.iter().map(EdgeContact::place).collect(),
            _ => Vec::new(),
        };
        Ok(Self {
            options,
            tolerance,
            graph: graph.clone(),
            counts: TrackingCounts::default(),
            vanished: Vec::new(),
            repairs: Vec::new(),
            numbers: (0..graph.edge_count()).map(EdgeId::new).map(Some).collect(),
            is_short: short_edges(graph, options.range().least),
            within,
            kept_contacts,
            is_crossed: false,
            events: Vec::new(),
        })
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
        let mut idle_halts = 0;
        for halt in 0..=HALTS {
            let (mut found, mut until) = (self.trial(map, [from, end], check)?, end);
            if let Some(tolerance) = self.tolerance
                && halt < HALTS
                && idle_halts < IDLE_HALTS
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
            let events = self.events.len();
            self.take(found, number, until)?;
            idle_halts += usize::from(self.events.len() == events);
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
        let contacts = match self.options.on_contact {
            Some(_) => graph.contacts(self.within)?,
            None => Vec::new(),
        };
        let fresh =
            fresh(self.options, self.within, &contacts, EdgeContact::place, || map(&self.kept_contacts));
        let has_slivers = self.closes_slivers() && !graph.slivers(self.within)?.is_empty();
        let fault = match check {
            Some(is_thorough) => graph.fault_on_the_way(is_thorough),
            None => Ok(None),
        };
        Ok(Trial { graph, counts, stays, is_short, contacts, fresh, has_slivers, fault })
    }

    /// Whether what is narrower than the distance of contacts all along goes.
    fn closes_slivers(&self) -> bool {
        self.options.on_contact == Some(OnContact::Merge) && !self.options.keep_small
    }

    /// The rule by which edges that cross are cut and pasted.
    fn rule(&self) -> Option<InsideRule> {
        match self.options.on_contact {
            Some(OnContact::Merge) => Some(self.options.repair.unwrap_or(InsideRule::Positive)),
            _ => self.options.repair,
        }
    }

    /// What was known of edges, of those that are left.
    fn kept<T: Copy>(known: &[T], stays: &[bool]) -> Vec<T> {
        known.iter().zip(stays).filter(|(_, stays)| **stays).map(|(own, _)| *own).collect()
    }

    fn is_quiet(&self, trial: &Trial) -> bool {
        let known = Self::kept(&self.is_short, &trial.stays);
        let is_fresh = trial.is_short.iter().zip(known).any(|(&is, was)| is && !was);
        let is_crossed = !matches!(trial.fault, Ok(None));
        let has_contacts = !trial.fresh.is_empty() || trial.has_slivers;
        (!is_crossed || self.is_crossed)
            && !has_contacts
            && !is_fresh
            && trial.stays.iter().all(|&stays| stays)
    }

    /// Goes on to where a trial has come, after what is done about its events.
    fn take(&mut self, trial: Trial, step: usize, time: f64) -> Result<(), Error> {
        let Trial { graph, counts, stays, is_short, contacts, mut fresh, fault, .. } = trial;
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
        if self.options.on_contact == Some(OnContact::Keep) {
            // What crosses for a while is looked at again at the end.
            let is_undecided = fault.is_err();
            if let Ok(Some(fault)) = &fault
                && !self.is_crossed
            {
                let place = fault.point().unwrap_or_default();
                self.push_contact(time, place, fault.phases().to_vec());
            }
            self.is_crossed = is_undecided || matches!(fault, Ok(Some(_)));
            for contact in &fresh {
                self.push_contact(time, contact.place(), contact.phases());
            }
            self.kept_contacts = contacts.iter().map(EdgeContact::place).collect();
            return Ok(());
        }
        if let Some(fault) = fault? {
            self.repair(&before, fault, step, time)?;
            if self.options.on_contact.is_some() {
                fresh = self.graph.contacts(self.within)?;
            }
        }
        if self.options.on_contact == Some(OnContact::Merge) {
            if !fresh.is_empty() {
                self.merge(time)?;
            }
            self.close_slivers(time)?;
        }
        Ok(())
    }

    /// Cuts and pastes edges that have come to meet.
    fn repair(
        &mut self,
        before: &InterfaceGraph,
        fault: InterfaceFault,
        step: usize,
        time: f64,
    ) -> Result<(), Error> {
        let Some(rule) = self.rule() else {
            return Err(met(fault));
        };
        let mut repaired = self.graph.repaired(rule)?;
        if !self.options.keep_small && self.options.on_contact.is_none() {
            repaired = repaired.without_fresh_slivers(&self.graph, self.options.range().least)?;
        }
        if self.tolerance.is_some() {
            let place =
                fault.point().unwrap_or_else(|| repaired.vertices().first().copied().unwrap_or_default());
            let counts = [phase_counts(before)?, phase_counts(&repaired)?];
            self.push_differences(&counts, place, time);
        }
        self.replace(repaired);
        self.repairs.push(InterfaceRepair { step, time, fault });
        Ok(())
    }

    /// Goes on with edges that have no numbers.
    fn replace(&mut self, graph: InterfaceGraph) {
        self.graph = graph;
        self.numbers = vec![None; self.graph.edge_count()];
        self.is_short = short_edges(&self.graph, self.options.range().least);
    }

    /// Lets phases come together at contacts, one after the other.
    fn merge(&mut self, time: f64) -> Result<(), Error> {
        /// More contacts than these in one place of time come from bridges that are in contact themselves.
        const MOST: usize = 1000;
        for _ in 0..MOST {
            let Some(contact) = self.graph.contacts(self.within)?.first().cloned() else { return Ok(()) };
            let bridged = self.graph.bridged(&contact, self.within)?;
            let counts = [phase_counts(&self.graph)?, phase_counts(&bridged)?];
            let place = contact.place();
            if let Some(phases) = contact.meeting() {
                let kind = InterfaceEventKind::PhasesMeet;
                self.events.push(InterfaceEvent { time, kind, place, phases, counts: None });
            }
            self.push_differences(&counts, place, time);
            self.replace(bridged);
        }
        Err(Error::invalid("bridges over contacts are in contact again and again".to_owned())
            .with_cure("give another distance of contacts, or keep contacts"))
    }

    /// Takes out what has become narrow all along.
    fn close_slivers(&mut self, time: f64) -> Result<(), Error> {
        if !self.closes_slivers() {
            return Ok(());
        }
        for _ in 0..=self.graph.edge_count() {
            let Some(sliver) = self.graph.slivers(self.within)?.into_iter().next() else { return Ok(()) };
            let closed = self.graph.without_sliver(&sliver)?;
            let [before, after] = [phase_counts(&self.graph)?, phase_counts(&closed)?];
            let of = |counts: &BTreeMap<u32, [usize; 2]>, phase: u32| {
                counts.get(&phase).copied().unwrap_or_default()
            };
            if let Some((phase, kind)) = match (sliver.phase, sliver.heir) {
                (Some(phase), _) if of(&after, phase)[0] == 0 => {
                    Some((phase, InterfaceEventKind::PhaseVanishes))
                }
                (Some(phase), _) => Some((phase, InterfaceEventKind::ComponentVanishes)),
                (None, Some(heir)) => Some((heir, InterfaceEventKind::HoleVanishes)),
                (None, None) => None,
            } {
                let counts = Some([of(&before, phase), of(&after, phase)]);
                self.events.push(InterfaceEvent {
                    time,
                    kind,
                    place: sliver.place,
                    phases: vec![phase],
                    counts,
                });
            }
            // As many edges as it had less than before are gone.
            for _ in closed.edge_count()..self.graph.edge_count() {
                self.vanished.push((time, None));
            }
            self.replace(closed);
        }
        Ok(())
    }

    fn push_contact(&mut self, time: f64, place: [f64; 2], phases: Vec<u32>) {
        let kind = InterfaceEventKind::Contact;
        self.events.push(InterfaceEvent { time, kind, place, phases, counts: None });
    }

    /// Looks thoroughly at edges that were kept as they are, after all steps.
    pub(super) fn finish(&self) -> Result<(), Error> {
        if self.options.on_contact != Some(OnContact::Keep) {
            return Ok(());
        }
        match self.graph.fault()? {
            None => Ok(()),
            Some(fault) => Err(met(fault)),
        }
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

/// That edges have come to meet.
fn met(fault: InterfaceFault) -> Error {
    fault
        .into_error()
        .with_cure("take shorter steps or a smaller spacing, or repair the interface by a fill rule")
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
