//! Editing of halfedge meshes: local changes that keep every invariant and the homeomorphism type of the surface.
//!
//! # Operations and their inverses
//! | operation | inverse | file |
//! |---|---|---|
//! | [`split_edge`](super::HalfedgeMesh::split_edge) | [`remove_vertex`](super::HalfedgeMesh::remove_vertex) | `edge_splitting` |
//! | [`split_face`](super::HalfedgeMesh::split_face) | [`remove_edge`](super::HalfedgeMesh::remove_edge) | `face_splitting` |
//! | [`split_vertex`](super::HalfedgeMesh::split_vertex) | [`collapse_edge`](super::HalfedgeMesh::collapse_edge) | `vertex_splitting` |
//! | the same at one corner | [`remove_pendant_edge`](super::HalfedgeMesh::remove_pendant_edge) | `vertex_splitting` |
//! | [`flip_edge`](super::HalfedgeMesh::flip_edge) | [`flip_edge_back`](super::HalfedgeMesh::flip_edge_back) | `flipping` |
//! | [`poke_face`](super::HalfedgeMesh::poke_face) | removal of the edges but one, then of that | `poking` |
//!
//! An operation that would leave no surface, or a cell without meaning, is refused and the mesh stays as it was.
//!
//! # Numbers
//! What is added gets the last number of its kind, and edge e has the halfedges 2e and 2e + 1. Faces that are added come
//! before the outer faces: the first outer face moves to the end. When a cell is removed, the last of its kind gets its
//! number; when a face is removed, the last face that is not outer gets its number, and the last outer face the number
//! of that. [`Renumbering`] lists these moves. An operation and its inverse bring the same numbers back.
//!
//! # Corners
//! The **corner** of a halfedge is the corner of its face at its source, between the halfedge before it and itself.
//! Operations on corners take halfedges.

mod edge_splitting;
mod face_splitting;
mod flipping;
mod numbering;
mod poking;
mod simplicial_collapse;
mod vertex_splitting;

pub use edge_splitting::{EdgeSplit, VertexRemoval};
pub use face_splitting::{EdgeRemoval, FaceSplit};
pub use numbering::Renumbering;
pub use poking::FacePoke;
pub use simplicial_collapse::{CollapseObstacle, SimplicialCollapse};
pub use vertex_splitting::{EdgeCollapse, VertexSplit};

#[cfg(test)]
mod tests;
