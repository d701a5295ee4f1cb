//! The answer of `incidence`: an operator between cells.

use super::Remark;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// An operator between the cells of a model: a sparse matrix.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct IncidenceAnswer {
    /// The name of the input.
    pub file: String,
    /// The operator, such as `FE`: rows are faces, columns edges.
    pub operator: String,
    /// What the entries are: `shared vertices`, `at least`, `exactly`, `incident` or `signed`.
    pub kind: String,
    /// The number of rows.
    pub rows: usize,
    /// The number of columns.
    pub columns: usize,
    /// The number of entries that are not zero.
    pub entries_count: u64,
    /// How often each entry occurs; the keys are the entries as decimal digits.
    pub histogram: BTreeMap<String, u64>,
    /// The entries `[row, column, entry]` by rows, counted from 0; absent unless they are asked for.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub entries: Option<Vec<(usize, usize, i64)>>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}
