//! Surfaces: polygon meshes with identified edges, their verdicts with witnesses, halfedge permutations.

mod edge_identification;
mod polygon_mesh;

pub use polygon_mesh::PolygonMesh;
