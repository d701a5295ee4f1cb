//! Complexes of cells that need not be simplices: tetrahedra, hexahedra, wedges and pyramids with shared faces.

mod cell_mesh;
mod face_identification;
mod shape;

pub use cell_mesh::CellMesh;
pub use shape::CellShape;
