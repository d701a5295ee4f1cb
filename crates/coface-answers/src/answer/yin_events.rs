//! Changes of the topology of a set that moves.

use coface_yin::{EventKind, InterfaceEvent, InterfaceEventKind, TopologyEvent};
use serde::{Deserialize, Serialize};

/// A kind of change.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum YinEventKind {
    /// Two components become one.
    ComponentsMerge,
    /// A component falls apart into two.
    ComponentSplits,
    /// A hole is cut off from what lies around the component.
    HoleForms,
    /// A hole opens to what lies around the component.
    HoleOpens,
    /// Two holes of a component become one.
    HolesMerge,
    /// A hole falls apart into two.
    HoleSplits,
    /// A component becomes too small to have a shape.
    ComponentVanishes,
    /// A hole becomes too small to have a shape.
    HoleVanishes,
    /// Boundaries come into contact and stay as they are.
    Contact,
}

impl YinEventKind {
    fn new(kind: EventKind) -> Self {
        match kind {
            EventKind::ComponentsMerge => Self::ComponentsMerge,
            EventKind::ComponentSplits => Self::ComponentSplits,
            EventKind::HoleForms => Self::HoleForms,
            EventKind::HoleOpens => Self::HoleOpens,
            EventKind::HolesMerge => Self::HolesMerge,
            EventKind::HoleSplits => Self::HoleSplits,
            EventKind::ComponentVanishes => Self::ComponentVanishes,
            EventKind::HoleVanishes => Self::HoleVanishes,
            _ => Self::Contact,
        }
    }
}

/// The numbers of components and holes: of positive and negative curves, and one component more for an unbounded set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinEventCounts {
    /// The number of components.
    pub components: usize,
    /// The number of holes.
    pub holes: usize,
}

/// A change of the topology of a set that moves, or a contact of its boundary with itself.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinEventAnswer {
    /// When it came, as exactly as "event_tolerance" says: the first time at which it is seen.
    pub time: f64,
    /// What changed.
    pub kind: YinEventKind,
    /// What changed, in words.
    pub words: String,
    /// Where: the middle of the gap or the neck, the point at which curves cross, or the mean of the knots of a curve that vanishes.
    pub place: [f64; 2],
    /// What there was just before.
    pub before: YinEventCounts,
    /// What there is just after.
    pub after: YinEventCounts,
}

impl YinEventAnswer {
    /// An event of the library as an answer.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::answer::{YinEventAnswer, YinEventKind};
    /// use coface_yin::{Curve, Order, TrackingOptions, YinSet};
    /// let disk = YinSet::new(&[Curve::circle([0.0, 0.0], 1.0, 64, Order::CUBIC)?])?;
    /// let options = TrackingOptions::new(8.0, 0.25, 0.1).events(true);
    /// let moved = disk.advected(|[x, y], _| [-x, -y], &options)?;
    /// assert_eq!(YinEventAnswer::new(&moved.events()[0]).kind, YinEventKind::ComponentVanishes);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn new(event: &TopologyEvent) -> Self {
        let counts = |[components, holes]: [usize; 2]| YinEventCounts { components, holes };
        Self {
            time: event.time(),
            kind: YinEventKind::new(event.kind()),
            words: event.kind().to_string(),
            place: event.place(),
            before: counts(event.before()),
            after: counts(event.after()),
        }
    }
}

/// A kind of change of an interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
#[non_exhaustive]
pub enum YinInterfaceEventKind {
    /// The last component of a phase becomes too small to have a shape.
    PhaseVanishes,
    /// A component of a phase that has others becomes too small to have a shape.
    ComponentVanishes,
    /// A hole of a phase, in which there is no phase, becomes too small to have a shape.
    HoleVanishes,
    /// The edge between two junctions becomes shorter than the least distance of knots; it is kept.
    JunctionsMeet,
    /// Components of a phase become fewer where edges are cut and pasted, or in contact.
    PhaseMerges,
    /// Components of a phase become more where edges are cut and pasted, or in contact.
    PhaseSplits,
    /// Holes of a phase become more where edges are cut and pasted, or in contact.
    HoleForms,
    /// Holes of a phase become fewer where edges are cut and pasted, or in contact.
    HoleOpens,
    /// Two phases come together where what was between them has become too narrow.
    PhasesMeet,
    /// Edges come into contact and stay as they are.
    Contact,
}

impl YinInterfaceEventKind {
    fn new(kind: InterfaceEventKind) -> Self {
        match kind {
            InterfaceEventKind::PhaseVanishes => Self::PhaseVanishes,
            InterfaceEventKind::ComponentVanishes => Self::ComponentVanishes,
            InterfaceEventKind::HoleVanishes => Self::HoleVanishes,
            InterfaceEventKind::PhaseMerges => Self::PhaseMerges,
            InterfaceEventKind::PhaseSplits => Self::PhaseSplits,
            InterfaceEventKind::HoleForms => Self::HoleForms,
            InterfaceEventKind::HoleOpens => Self::HoleOpens,
            InterfaceEventKind::PhasesMeet => Self::PhasesMeet,
            InterfaceEventKind::Contact => Self::Contact,
            _ => Self::JunctionsMeet,
        }
    }
}

/// A change of the topology of an interface that moves.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinInterfaceEventAnswer {
    /// When it came, as exactly as "event_tolerance" says: the first time at which it is seen.
    pub time: f64,
    /// What changed.
    pub kind: YinInterfaceEventKind,
    /// What changed, in words.
    pub words: String,
    /// Where: the mean of the knots of an edge that vanishes, the middle of the ends of an edge whose junctions meet, or the place at which
    /// edges came to meet.
    pub place: [f64; 2],
    /// The phase that changed; of junctions that meet all phases around them, of phases that come together these, and of a contact those beyond the
    /// edges and between them.
    pub phases: Vec<u32>,
    /// What there was of the phase just before; null for junctions and phases that meet, and for contacts.
    pub before: Option<YinEventCounts>,
    /// What there is of the phase just after; null for junctions and phases that meet, and for contacts.
    pub after: Option<YinEventCounts>,
}

impl YinInterfaceEventAnswer {
    /// An event of the library as an answer.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::answer::{YinInterfaceEventAnswer, YinInterfaceEventKind};
    /// use coface_yin::{Curve, InterfaceGraph, Order, TrackingOptions, YinSet};
    /// let disk = YinSet::new(&[Curve::circle([0.0, 0.0], 1.0, 64, Order::CUBIC)?])?;
    /// let graph = InterfaceGraph::of_sets(&[disk], Order::CUBIC, 0.0)?;
    /// let moved = graph.advected(|[x, y], _| [-x, -y], &TrackingOptions::new(8.0, 0.25, 0.1).events(true))?;
    /// assert_eq!(YinInterfaceEventAnswer::new(&moved.events()[0]).kind, YinInterfaceEventKind::PhaseVanishes);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn new(event: &InterfaceEvent) -> Self {
        let counts = |[components, holes]: [usize; 2]| YinEventCounts { components, holes };
        Self {
            time: event.time(),
            kind: YinInterfaceEventKind::new(event.kind()),
            words: event.kind().to_string(),
            place: event.place(),
            phases: event.phases().to_vec(),
            before: event.counts().map(|[before, _]| counts(before)),
            after: event.counts().map(|[_, after]| counts(after)),
        }
    }
}
