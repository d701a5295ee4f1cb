//! Triangles cut against each other until they meet only in common edges and vertices.
//!
//! # Words and conventions
//! * A **sheet** is a triangle with area, or all triangles with the same corners.
//! * A corner of sheets is **plain** where they lie side by side around it, seen along one axis: most pairs of
//!   triangles of a mesh that are near each other need no more.
//! * A **place** is a point by the lowest things that meet there: two edges, an edge and a sheet, three sheets. Places
//!   that are one point become one vertex.
//! * A **cut** is the segment that two sheets have in common, if it is inside both; a **run** is the part of an edge
//!   that lies inside another sheet, in its plane.
//! * Edges and cuts are **lines**; the vertices on them divide them into **pieces**, the edges of the result. The
//!   pieces in a sheet divide it into **fragments**, the faces of the result.

mod crossings;
mod cut_triangles;
mod fans;
mod fragments;
mod lines;
mod meetings;
mod parts;
mod predicates;
mod sheets;
mod triples;
mod vertices;

pub use crossings::Crossings;
pub(in crate::spatial) use crossings::{crossing_triangles, crossings};
pub use cut_triangles::{CutOptions, CutTriangles, SpatialVertexSource};
pub(in crate::spatial) use parts::PartOutlines;
