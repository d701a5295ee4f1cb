//! Curved boundaries laid over each other: what the polynomial pieces of several sets make of the plane.
//!
//! # Words and conventions
//! * A **position** is a piece and a parameter on it; pieces of all sets are numbered one after the other. An **event** is a position
//!   at which a curve comes to a node. A **break** is all events of a curve at one node that follow each other within the resolution.
//! * Pieces are parts of **carriers**, whole polynomials. A position is the way along the span of its piece on the carrier, exactly, so
//!   that what runs along the same part of the same carrier is one edge without comparing points. Results keep the carriers of their
//!   pieces, and two of them that go on along one carrier are joined again: what was cut is whole again, bit for bit.
//! * A **node** is a point where curves meet. What lies between breaks of a curve is a **chain**; chains along a common arc are one
//!   **edge**. Around nodes, orbits, faces and winding numbers there is no difference to polygons, and the code is the same.
//! * Nodes are brought together along curves only: where the arc between two of them is shorter than the resolution, it is
//!   contracted; longer arcs that run along each other are one edge. Contraction of an edge never makes a plane drawing impossible; so a rotation that has no plane drawing is a
//!   contradiction, and an error.
//! * What lies below a component is read off on a vertical line that comes near no node, with enclosures of all heights; where these
//!   are too wide, exact arithmetic has them.

mod arcs;
mod boundaries;
mod chains;
mod columns;
mod curved_overlay;
mod departures;
mod exact_columns;
mod jordan;
mod nesting;
mod nodes;
mod outline;

pub(crate) use chains::NEARNESS_CURE;
pub(crate) use curved_overlay::CurvedOverlay;
