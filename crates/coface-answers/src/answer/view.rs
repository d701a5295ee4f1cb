//! The answer of `view`: a page.

use super::Remark;
use serde::{Deserialize, Serialize};

/// A page that shows a model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ViewAnswer {
    /// The name of the input.
    pub file: String,
    /// The file of the page; `null` if it was not written.
    pub page: Option<String>,
    /// The size of the page, in bytes.
    pub bytes: usize,
    /// The number of triangles that are drawn.
    pub triangles: usize,
    /// The layers that can be shown.
    pub layers: Vec<LayerAnswer>,
    /// The names of the panes beside the model.
    pub panes: Vec<String>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// A layer over the model.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LayerAnswer {
    /// Layers of one group stand together, such as `homology` or `boundary`.
    pub group: String,
    /// What it is called.
    pub name: String,
    /// What is said about it beside its name.
    pub detail: String,
}
