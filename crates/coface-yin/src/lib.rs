//! Yin sets: regular open sets of the plane with bounded boundary, as closed curves with kinks, and their Boolean algebra.
//!
//! # Words and conventions
//! * A [`Curve`] is a chain of polynomial pieces of one [`Order`] between **knots**; order 2 is a polyline, order 4 a cubic spline.
//! * A **Jordan curve** is closed and simple. The **set** is on the left of its boundary: a **positive** curve runs counterclockwise
//!   around the set, a **negative** one clockwise around a hole.
//! * Curves are **almost disjoint** when they touch in finitely many points and neither cross nor share an arc. An **atom** is a
//!   connected set bounded by such curves. A [`YinSet`] is bounded by the unique almost disjoint curves of its atoms.
//! * The **Hasse forest** of a set says which curve lies directly inside which; positive and negative curves alternate by depth.
//! * **Meet** is the intersection, **join** the interior of the closed union, **complement** the exterior: so all laws of a Boolean
//!   algebra hold.
//! * A **kink** is a knot at which the boundary need not be smooth. Between kinks the boundary is one spline.
//!
#![doc = include_str!("../README.md")]

mod boolean;
mod curve;
mod cut_cells;
mod interface;
mod kinks;
mod meetings;
mod overlay;
mod set;
mod tracking;

pub use boolean::{Assumption, Combination, Normalized, PieceSource, UncertifiedDecision};
pub use curve::{Carrier, Curve, EndCondition, Location, Order};
pub use cut_cells::{CartesianGrid, Coverage, CutArc, CutCell, CutCells, WalkStep};
pub use interface::{
    DirectedEdge, EdgeBend, InterfaceEdge, InterfaceFault, InterfaceGraph, InterfaceOptions,
    NormalizedInterface, Overlaps, Trail,
};
pub use kinks::{Kinks, KnotIndex, turning_kinks};
pub use set::{
    Atom, AtomKind, Comparison, CurveBend, CurvePlace, HasseForest, JordanCurve, NearestPoint, Sample,
    Sampling, SetLocation, YinFault, YinSet,
};
pub use tracking::{
    EventKind, Flow, InterfaceEvent, InterfaceEventKind, InterfaceRepair, MarkerParameters, OnContact,
    Repair, RungeKutta, TopologyEvent, TrackedGraph, TrackedSet, TrackingCounts, TrackingOptions,
    VanishedCurve, VelocityExpression, Verification,
};
