//! Legacy VTK, text and binary; VTK XML is written only.
//!
//! Unstructured grids, polygonal data, and structured, rectilinear and uniform grids, which become hexahedra,
//! quadrangles or lines. Cells of higher order are read by their corners, with a warning. Data on points and cells are
//! kept whatever their keyword (`SCALARS`, `VECTORS`, `FIELD`, ..) but for lookup tables and strings. The wedge of VTK has its bottom triangle the other way round than [`CellShape`] does, so
//! its vertices are exchanged in reading and writing.
//!
//! [`CellShape`]: crate::cellular::CellShape

mod cell_types;
mod data;
mod grids;
mod lists;
mod reading;
#[cfg(test)]
mod tests;
mod writing;
mod xml;

pub use reading::read;
pub use writing::{Encoding, write};
pub use xml::{XmlKind, write_xml};
