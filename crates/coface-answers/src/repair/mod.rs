//! Models made ready for other questions: a manifold by splitting and turning ([`repaired`]), a surface by all that it takes
//! ([`repaired_surface`]), simplices by subdivision ([`triangulated`]).

mod halfedges;
mod outwards;
mod polygons_of;
mod splitting;
mod surface;
mod triangulation;
mod weld;

pub use halfedges::{dual_graph_model, dual_model, halfedge_model, polygon_model};
pub(crate) use polygons_of::PolygonsOf;
pub use splitting::{RepairRequest, repaired};
pub use surface::{SurfaceRepair, SurfaceRepairRequest, repaired_surface};
pub use triangulation::{triangulated, truncated};
pub(crate) use weld::near_vertices;
pub use weld::{Weld, welded};
