//! Gmsh MSH of the versions 2 and 4, text and binary; version 1, text, is read.
//!
//! Nodes have tags, any positive numbers; vertex i of the model is node i in the order of the file. Elements belong to
//! physical groups, in version 2 by a tag of their own and in version 4 by the entity of the geometry that they lie on;
//! each becomes a [`Group`](super::Group) with its name, or its number if it has none. Physical groups of points are
//! groups of vertices. Elements of higher order are read by their corners, with a warning. Sections other than those of
//! names, entities, nodes and elements are passed over.

mod data;
mod elements;
mod nodes;
mod reader;
mod reading;
#[cfg(test)]
mod tests;
mod version_2;
mod version_4;
mod writing;

pub use reading::read;
pub(super) use reading::read_into;
pub(crate) use reading::read_with;
pub use writing::{Version, physical_tags, write};
