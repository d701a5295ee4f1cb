//! Halfedge meshes: oriented surfaces as one permutation of their halfedges.
//!
//! # Words
//! * A **halfedge** is an edge with a direction. Its **twin** is the same edge the other way around, its **next** the
//!   halfedge that follows around the face to its left, its **source** the vertex that it leaves.
//! * Edge e has the halfedges 2e and 2e + 1, so twin(h) = h ^ 1, and edge e points as halfedge 2e does.
//! * Faces are the orbits of `next`, vertices those of "twin, then next": clockwise around a vertex when faces run
//!   counterclockwise.
//! * Each boundary loop is filled with an **outer face**. Outer faces have the last numbers; counts and chain complexes
//!   leave them out. A vertex on the boundary lies in one corner of one outer face.
//!
//! # Files
//! [`HalfedgeMesh`] is in `mesh`; `polygons` makes it from polygons, `boundary` fills loops with
//! outer faces, `circulators` walks around its cells, `check` verifies its invariants.

mod boundary;
mod check;
mod circulators;
mod mesh;
mod polygons;

pub use mesh::HalfedgeMesh;

#[cfg(test)]
mod tests;
