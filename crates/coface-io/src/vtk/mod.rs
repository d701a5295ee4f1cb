//! Legacy VTK, text and binary, and VTK XML (`.vtu`, `.vtp`).
//!
//! Unstructured grids, polygonal data, and structured, rectilinear and uniform grids, which become hexahedra,
//! quadrangles or lines. Cells of higher order are read by their corners, with a warning. Data on points and cells are
//! kept whatever their keyword (`SCALARS`, `VECTORS`, `FIELD`, ..) but for lookup tables and strings. The wedge of VTK has its bottom triangle the other way round than [`CellShape`] does, so
//! its vertices are exchanged in reading and writing.
//!
//! XML files are read in every encoding: text, base64 within the XML or appended, appended bytes, with lengths of 32 or 64 bits, in both byte
//! orders, as they are or compressed by zlib; several pieces become one mesh.
//!
//! [`CellShape`]: coface_complexes::cell_mesh::CellShape

mod cell_runs;
mod cell_types;
mod data;
mod elements;
mod grids;
mod lists;
mod reader;
mod reading;
#[cfg(test)]
mod tests;
#[cfg(not(feature = "xml"))]
mod without_xml;
mod writing;
#[cfg(feature = "xml")]
mod xml_arrays;
#[cfg(feature = "xml")]
mod xml_reading;
#[cfg(all(test, feature = "xml", feature = "compression"))]
mod xml_tests;
mod xml_writing;

pub use reading::read;
pub(crate) use reading::read_with;
#[cfg(not(feature = "xml"))]
pub use without_xml::read_xml;
pub use writing::{Encoding, write};
#[cfg(feature = "xml")]
pub use xml_reading::read_xml;
pub use xml_writing::{XmlKind, write_xml};
