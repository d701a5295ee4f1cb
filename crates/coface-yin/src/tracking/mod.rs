//! Interface tracking: boundaries that move with a velocity field, by mapping markers and fitting anew.
//!
//! # Words and conventions
//! * **Markers** are the knots of a boundary. A step maps them by a Runge-Kutta scheme; where two neighbors come to lie farther apart
//!   than the **spacing** h, points of the old boundary between them are mapped too, and where they come closer than r h markers
//!   are left out. Kinks and junctions stay.
//! * In orders 6 and 8 markers keep their **parameter**, and added ones have that of the point of the old boundary: the images of a smooth
//!   curve are a smooth function of it, which a spline approximates with the power of its order. In orders 2 and 4 the parameter is the
//!   distance of neighbors, as in the method of the references, unless [`MarkerParameters`] say something else.
//! * The flow of a velocity field is a homeomorphism: curves keep their places in the Hasse forest. Curves that become too short to
//!   have a shape at the spacing vanish, which is reported.
//! * **Contacts** are places where boundaries come nearer to each other than a distance; there the topology may be changed. **Events** are
//!   changes of the topology, with their times.
//!
//! # References
//! Q. Zhang, *Fourth- and higher-order interface tracking via mapping and adjusting regular semianalytic sets represented by cubic
//! splines* (2018); Y. Tan, Y. Qian, Z. Li, Q. Zhang, on multiphase cubic MARS (2025).

mod contacts;
mod events;
mod expression;
mod flow;
mod fronts;
mod graph_contacts;
mod graph_events;
mod graphs;
mod markers;
mod options;
mod runge_kutta;
mod sets;
mod watch;

pub use events::{EventKind, OnContact, TopologyEvent};
pub use expression::VelocityExpression;
pub use flow::Flow;
pub use graph_events::{InterfaceEvent, InterfaceEventKind};
pub use graphs::{InterfaceRepair, TrackedGraph};
pub use markers::TrackingCounts;
pub use options::{MarkerParameters, TrackingOptions, Verification};
pub use runge_kutta::RungeKutta;
pub use sets::{Repair, TrackedSet, VanishedCurve};
