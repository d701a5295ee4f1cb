//! Triangulates polygons with holes, and reports the polygons that are not simple.
//!
//! # Words and conventions
//! * A polygon is the set of its **sides**: directed edges between vertices, with the inside to the left of each. Its
//!   **walks** are the closed lists of vertices along which the sides run: outer walks run counterclockwise, holes
//!   clockwise.
//! * Walks may meet each other and themselves in vertices. A **slit** is an edge with the inside on both sides: it is a
//!   side in each direction.
//! * Vertices are numbers. Two closures know their places: one compares two vertices lexicographically, one says which
//!   way three of them turn, `Greater` for counterclockwise. So points may be given, or crossings that are never
//!   computed.
//!
//! [`triangulate`] adds no vertex, and every vertex is a corner of a triangle. Walks that do not bound a polygon give a
//! [`TriangulationFault`].

mod fault;
mod flips;
mod status;
mod sweep;
#[cfg(test)]
mod tests;

pub use fault::TriangulationFault;
pub use flips::flip_to_delaunay;
pub use sweep::{triangulate, triangulate_sides};
