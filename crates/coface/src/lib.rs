//! Exact computational topology of cell complexes.

pub mod algebra;
pub mod cellular;
pub mod chains;
mod error;
pub mod geometry;
mod ids;
pub mod io;
pub mod report;
pub mod simplicial;
pub mod surface;
pub mod topology;

pub use error::{Error, ErrorKind};
pub use ids::{CellId, EdgeId, FaceId, HalfedgeId, Id, IdVec, VertexId};
