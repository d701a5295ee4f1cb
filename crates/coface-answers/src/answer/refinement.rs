//! What was added to a surface that was refined.

use serde::{Deserialize, Serialize};

/// A surface that was refined.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct RefinementAnswer {
    /// The numbers of vertices, edges and faces of the refined surface, before it is cut.
    pub f_vector: Vec<usize>,
    /// The new vertices.
    pub vertices: Vec<RefinedVertex>,
}

/// A vertex that was added to a surface, on an edge or in a face.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct RefinedVertex {
    /// Its number: those of the file come first.
    pub vertex: u32,
    /// The vertices of the file whose convex combination it is: the ends of its edge, or corners of its face.
    pub of: Vec<u32>,
    /// Their weights, which add up to 1.
    pub weights: Vec<f64>,
}
