//! Overlays of regions: Boolean combinations of closed rings.
//!
//! # Words and conventions
//! * A **side** goes from one **corner** of a ring to the next; corners and sides have the same numbers. A **node** is
//!   a point where sides meet otherwise than one after the other on their ring.
//! * A **chain** is what is between two nodes of a ring: the part of a side, or corners with the sides between them.
//!   Equal parts of sides are one **edge** of several chains; every other chain is an edge of its own.
//! * Around nodes, orbits, nesting and winding numbers there is no difference to an arrangement of segments, and the
//!   code is the same. But only nodes are sorted, and long curves that seldom meet are a few edges; their corners are
//!   touched when boxes are put around them and when results are written. That is why an overlay is not made of a
//!   [`PlanarArrangement`](super::PlanarArrangement).

mod chains;
mod clear_rounding;
mod edges;
mod jordan_rings;
mod nodes;
mod polygons;
mod regions;
mod ring_cells;
mod ring_nesting;
mod tracing;
mod undecided;
mod validity;

#[doc(hidden)]
pub use jordan_rings::JordanFault;
#[doc(hidden)]
pub use jordan_rings::JordanRings;
pub use polygons::PlanarPolygons;
pub use regions::PlanarOverlay;
#[doc(hidden)]
pub use ring_cells::ChainEdges;
#[doc(hidden)]
pub use ring_cells::RingCells;
#[doc(hidden)]
pub use ring_nesting::RingFault;
pub use undecided::{UndecidedRings, UndecidedSelection};
pub use validity::are_valid_polygons;
#[doc(hidden)]
pub use validity::is_simple_ring;
#[doc(hidden)]
pub use validity::turned_rings;
