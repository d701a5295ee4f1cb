//! What the halfedges of a surface point to.

use serde::{Deserialize, Serialize};

/// What a halfedge of a small surface points to, by the numbers of the file.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HalfedgePointers {
    /// The halfedge.
    pub halfedge: usize,
    /// The next one around its face.
    pub next: usize,
    /// The other one of its edge.
    pub twin: usize,
    /// The vertex that it leaves. Vertices, edges and faces are numbered by their smallest halfedges.
    pub source: usize,
    /// The vertex that it goes to.
    pub target: usize,
    /// Its edge.
    pub edge: usize,
    /// The face on its left.
    pub face: usize,
    /// Whether that is an outer face, which fills a boundary loop.
    pub outer: bool,
}
