//! Triangulations of polygons with holes, by decisions alone.
//!
//! # Words and conventions
//! * A polygon is the set of its **sides**: directed edges between vertices, with the inside to the left of each. Its **walks** are the
//!   closed lists of vertices that the sides run through: outer walks run counterclockwise, holes clockwise.
//! * Walks may meet each other and themselves in vertices. A **slit** is an edge with the inside on both sides: a side in each direction.
//! * Vertices are numbers. Where they are is known to two closures only: one compares two vertices lexicographically, one says which
//!   way three of them turn, `Greater` for counterclockwise. So points may be given, or crossings that are never computed.
//!
//! [`triangulate`] adds no vertex, and every vertex is a corner. What is no polygon is a [`TriangulationFault`].

mod fault;
mod status;
mod sweep;
#[cfg(test)]
mod tests;

pub use fault::TriangulationFault;
pub use sweep::{triangulate, triangulate_sides};
