//! What is written of edits, so that they can be undone.

use super::EditRecord;
use serde::{Deserialize, Serialize};

/// A surface before it was edited, and what was done to it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct EditLog {
    /// The surface before the first edit.
    pub before: EditorState,
    /// The edits, the first one first.
    pub edits: Vec<EditRecord>,
}

/// A surface as it is edited.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum EditorState {
    /// Permutations of halfedges.
    Halfedges {
        /// The next halfedge around the face.
        next: Vec<u32>,
        /// The other halfedge of the edge.
        twin: Vec<u32>,
        /// The faces that are outer.
        outer: Vec<u32>,
        /// The positions of the vertices, or none.
        vertices: Vec<Vec<f64>>,
    },
    /// Polygons.
    Polygons {
        /// The positions of the vertices, or none.
        vertices: Vec<Vec<f64>>,
        /// The number of vertices.
        vertex_count: usize,
        /// The polygons by their vertices.
        polygons: Vec<Vec<u32>>,
    },
}
