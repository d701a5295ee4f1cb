//! Delaunay and regular triangulations of points on a line, in the plane and in space.
//!
//! # Words and conventions
//! * A **cell** is a simplex of the highest dimension, that of the flat which the points span: they may lie in a plane or on a line of space, or at one
//!   place.
//! * A cell of a **Delaunay triangulation** has no point inside the sphere through its corners. In a **regular triangulation** each point has a weight, and
//!   no point has negative power to the sphere that is orthogonal to the corners. A point in no cell is **hidden**: it equals another one, or weights
//!   hide it.
//! * Of points on one sphere one triangulation of several is taken. It is the regular one after weights are lowered by numbers without size, the more the
//!   later a point is inserted; so the cells fit together in all degenerate positions.
//! * An **unbounded** cell joins the point at infinity and a facet of the convex hull.

#![allow(
    clippy::cast_possible_truncation,
    reason = "points have numbers of 32 bits, and so have their cells"
)]

mod cells;
mod order;
mod space;
mod triangulation;

#[cfg(test)]
mod tests;

pub use triangulation::RegularTriangulation;
