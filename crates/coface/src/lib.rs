//! Exact computational topology of cell complexes.

pub use coface_algebra as algebra;
pub use coface_answers as answers;
pub use coface_arrange as arrange;
pub use coface_complexes as complexes;
pub use coface_geometry as geometry;
pub use coface_io as io;
pub use coface_pictures as pictures;
pub use coface_scale as scale;
pub use coface_topology as topology;
pub use coface_yin as yin;

pub use coface_algebra::{CellId, EdgeId, Error, ErrorKind, FaceId, HalfedgeId, Id, IdVec, VertexId};

/// The example of the README compiles.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
