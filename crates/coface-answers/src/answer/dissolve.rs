//! What `boolean --dissolve` answers: features united by the values of their properties.

use super::Remark;
use super::arrange::DrawingInput;
use serde::{Deserialize, Serialize};
use serde_json::Value;

/// Features of maps united by the values of their properties.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct DissolveAnswer {
    /// The dimension of the space: 2.
    pub dimension: usize,
    /// The names of the properties.
    pub properties: Vec<String>,
    /// The sum of the areas of the united features, in the square of the unit of the inputs.
    pub measure: f64,
    /// The numbers of vertices, edges and polygons of all united features.
    pub f_vector: [usize; 3],
    /// The united features.
    pub groups: Vec<DissolvedGroupAnswer>,
    /// The inputs in their order.
    pub inputs: Vec<DrawingInput>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// The features that have the same values of the properties.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct DissolvedGroupAnswer {
    /// The values in the order of the properties; null for one that the features do not have.
    pub values: Vec<Value>,
    /// How many features were united. A polygon of a feature without any properties counts as one.
    pub features: usize,
    /// The area, in the square of the unit of the inputs.
    pub measure: f64,
    /// The number of polygons.
    pub polygons: usize,
    /// The number of holes of polygons.
    pub holes: usize,
    /// The number of parts whose inner points are connected.
    pub components: usize,
}
