//! The answer of `isomorphic`: whether two triangulations differ by names alone.

use super::Remark;
use serde::{Deserialize, Serialize};

/// Whether two triangulations are the same under other names.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct IsomorphicAnswer {
    /// The names of the two inputs.
    pub files: [String; 2],
    /// Whether they are.
    pub isomorphic: bool,
    /// The first thing found in which they differ and that names do not change; `null` if they are the same.
    #[serde(default)]
    pub difference: Option<String>,
    /// For each simplex of the first the one of the second that it is; `null` if they are not the same.
    pub simplices: Option<Vec<u32>>,
    /// For each simplex of the first the places of its vertices in the simplex of the second; vertices of facets are in rising order.
    pub vertices: Option<Vec<Vec<u32>>>,
    /// Their isomorphism signatures; `null` beyond 2,000 simplices and dimension 8.
    pub signatures: [Option<String>; 2],
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}
