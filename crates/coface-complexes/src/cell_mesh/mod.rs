//! Meshes of tetrahedra, hexahedra, wedges and pyramids with shared faces.
//!
//! # Words
//! * A [`CellMesh`] is a set of cells on one vertex set with **sides** identified: two sides of cells are one **face** when
//!   they are the same cycle of vertices. Its vertices, edges and faces are its **skeleton**, a
//!   [`crate::surface::PolygonMesh`].
//! * A **positive** cell lists its vertices as [`CellShape`] describes in a right-handed frame; the boundary of a cell is
//!   the sum of its sides as seen from outside.
//! * [`VolumeVerdict`], [`VolumeOrientation`]: exact answers with the cells that prove a no.
//! * [`BoundarySurface`]: the faces of exactly one cell.
//! * [`cell_volumes`]: what cells with positions measure.

mod boundary;
mod face_identification;
mod manifold;
mod measure;
mod mesh;
mod shape;
mod two_skeleton;

pub use boundary::{BoundarySurface, VolumeOrientation};
pub use manifold::{VolumeDefect, VolumeFindings, VolumeVerdict};
pub use measure::{CellVolumes, cell_volumes};
pub use mesh::CellMesh;
pub use shape::CellShape;
