//! Interfaces: phases that share the arcs of their boundaries, so that there are neither gaps nor overlaps between them.
//!
//! # Words and conventions
//! * **Vertices** are junctions, where three or more edges end, kinks, and base points of closed curves. **Edges** are arcs between
//!   them, each with its markers, through which it is fitted once.
//! * An edge has a **phase** on its left and one on its right, or none where what is there is not of interest.
//! * **Smooth pairs** say which edges go on smoothly through a vertex. Maximal chains of such edges are **trails**, fitted by one
//!   spline that is not-a-knot at its ends, or **circuits**, which are closed and periodic.

mod edits;
mod fault;
mod graph;
mod overlaid;
mod partition;
mod phases;
mod places;
mod sets;
mod trails;
mod unique;

pub use fault::InterfaceFault;
pub(crate) use graph::Arcs;
pub use graph::{InterfaceEdge, InterfaceGraph};
pub use partition::Overlaps;
pub use places::EdgeBend;
pub use sets::InterfaceOptions;
pub use trails::{DirectedEdge, Trail};
pub use unique::NormalizedInterface;
