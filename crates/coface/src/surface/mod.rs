//! Surfaces: polygon meshes with identified edges, their verdicts with witnesses, halfedge permutations.

mod boundary;
mod classification;
mod components;
pub(crate) mod dual_graph;
pub(crate) mod edge_identification;
pub(crate) mod manifold;
mod orientation;
mod polygon_mesh;
pub(crate) mod range_sort;

pub use boundary::BoundaryLoop;
pub use classification::{SurfaceComponent, SurfaceSurvey, SurfaceType};
pub use components::Components;
pub use manifold::{LinkComponent, LinkShape, SurfaceDefect, SurfaceVerdict};
pub use orientation::{OddFaceCycle, SurfaceOrientation};
pub use polygon_mesh::PolygonMesh;
