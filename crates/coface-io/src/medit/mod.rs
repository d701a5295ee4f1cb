//! MEDIT `.mesh`, text, and `.meshb`, binary.
//!
//! Sections of vertices (of dimension 2 or 3), edges, triangles, quadrilaterals, tetrahedra, hexahedra, prisms and
//! pyramids, each record with a reference number at its end. A reference other than 0 becomes a
//! [`Group`](super::Group) whose name is the number; `Corners`, `RequiredVertices`, `Ridges` and the like become groups
//! of these names. Vertices are numbered from 1 in the file. Other sections are passed over.

mod reading;
mod sections;
#[cfg(test)]
mod tests;
mod writing;

pub use reading::read;
pub(super) use reading::read_into;
pub(crate) use reading::read_with;
pub use writing::write;
