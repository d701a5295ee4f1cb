//! Changes of the topology of a set that moves.

use std::fmt;

/// What becomes of boundaries that come into contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum OnContact {
    /// They stay as they are, and the contact is an event.
    Keep,
    /// The set between them is joined, or cut through, so that the topology changes.
    Merge,
}

/// A kind of change.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum EventKind {
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

impl fmt::Display for EventKind {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::ComponentsMerge => "two components merge",
            Self::ComponentSplits => "a component splits",
            Self::HoleForms => "a hole forms",
            Self::HoleOpens => "a hole opens to the outside",
            Self::HolesMerge => "two holes merge",
            Self::HoleSplits => "a hole splits",
            Self::ComponentVanishes => "a component vanishes",
            Self::HoleVanishes => "a hole vanishes",
            Self::Contact => "boundaries come into contact",
        })
    }
}

/// A change of the topology of a set that moves, or a contact of its boundary with itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TopologyEvent {
    pub(crate) time: f64,
    pub(crate) kind: EventKind,
    pub(crate) place: [f64; 2],
    pub(crate) before: [usize; 2],
    pub(crate) after: [usize; 2],
}

impl TopologyEvent {
    /// When it came: the first time, but for [`TrackingOptions::event_tolerance`](super::TrackingOptions::event_tolerance), at which it is
    /// seen.
    pub fn time(&self) -> f64 {
        self.time
    }

    /// What changed.
    pub fn kind(&self) -> EventKind {
        self.kind
    }

    /// Where: the middle of the gap or the neck, the point at which curves cross, or the mean of the markers of a curve that vanishes.
    pub fn place(&self) -> [f64; 2] {
        self.place
    }

    /// The numbers of components and holes just before.
    pub fn before(&self) -> [usize; 2] {
        self.before
    }

    /// The numbers of components and holes just after.
    pub fn after(&self) -> [usize; 2] {
        self.after
    }
}
