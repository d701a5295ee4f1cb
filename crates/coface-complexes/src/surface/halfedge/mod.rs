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
//! * The **inner** halfedges are those around faces that are not outer; [`InnerHalfedges`] shows only them, so that a
//!   boundary edge has one.
//!
//! # Files
//! `mesh` has [`HalfedgeMesh`] with its cells and counts, `permutations` what it is written as. `polygons` and `sources` make it from other structures, `export`
//! makes other structures of it; `boundary` fills loops with outer faces; `circulators` walks around cells; `check`
//! verifies the invariants. `editing` changes a mesh step by step; `slicing` and `gluing` open and close it along edges.

mod boundary;
mod check;
mod circulators;
mod editing;
mod export;
mod gluing;
mod inner;
mod mesh;
mod permutations;
mod polygons;
mod slicing;
mod sources;

pub use editing::{
    CollapseObstacle, EdgeCollapse, EdgeRemoval, EdgeSplit, FacePoke, FaceSplit, Renumbering,
    SimplicialCollapse, VertexRemoval, VertexSplit,
};
pub use inner::InnerHalfedges;
pub use mesh::HalfedgeMesh;
pub use permutations::HalfedgePermutations;

#[cfg(test)]
mod tests;
