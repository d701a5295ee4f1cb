//! The answer of `edit`: what was done to a surface.

use super::Remark;
use crate::EditRecord;
use serde::{Deserialize, Serialize};

/// A surface that was edited.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct EditAnswer {
    /// The name of the input.
    pub file: String,
    /// How many edits of the log were undone.
    pub undone: usize,
    /// What was done, each edit with its inverse.
    pub edits: Vec<EditRecord>,
    /// The numbers of vertices, edges and faces now.
    pub f_vector: [usize; 3],
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}
