//! What `congruence` answers: models merged within a tolerance.

use super::Remark;
use serde::{Deserialize, Serialize};

/// The quotient of the chain complexes of models by the vertices within a tolerance. Lists have an entry for each degree.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct CongruenceAnswer {
    /// The inputs in their order.
    pub inputs: Vec<CongruenceInput>,
    /// The length within which vertices are one, in the unit of the models.
    pub tolerance: f64,
    /// The numbers of cells of all inputs.
    pub f_vector_before: Vec<usize>,
    /// The numbers of cells of the quotient.
    pub f_vector: Vec<usize>,
    /// The alternating sum of the numbers of cells of the quotient.
    pub euler_characteristic: i64,
    /// The numbers of classes.
    pub classes: Vec<usize>,
    /// The largest distance of vertices that became one, in the unit of the models.
    pub largest_class_diameter: f64,
    /// The numbers of cells that collapsed.
    pub discarded: Vec<usize>,
    /// The numbers of cells that lost facets without collapsing.
    pub changed: Vec<usize>,
    /// Whether the boundary of every boundary is zero, found by multiplying the matrices.
    pub products_zero: bool,
    /// How often vertices of one block became one; null without blocks.
    pub merged_within_blocks: Option<usize>,
    /// The first hundred classes with several vertices of one block; null without blocks, and where that is allowed.
    pub block_merges: Option<Vec<BlockMergeAnswer>>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// One model among the inputs of a congruence.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct CongruenceInput {
    /// The name of the file.
    pub file: String,
    /// The numbers of its cells.
    pub f_vector: Vec<usize>,
}

/// Vertices of one block that became one.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct BlockMergeAnswer {
    /// The class.
    pub class: usize,
    /// The block.
    pub block: u32,
    /// The name of the file of the first vertex.
    pub file: Option<String>,
    /// The vertices, by their numbers in their models.
    pub vertices: Vec<usize>,
    /// The smallest distance of two of them, in the unit of the models.
    pub distance: f64,
}
