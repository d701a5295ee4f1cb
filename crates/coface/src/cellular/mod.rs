//! Complexes of cells that need not be simplices: tetrahedra, hexahedra, wedges and pyramids with shared faces.

mod shape;

pub use shape::CellShape;
