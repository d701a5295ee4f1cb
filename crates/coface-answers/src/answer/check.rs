//! The answer of `check`.

use super::Remark;
use serde::{Deserialize, Serialize};

/// What a certificate proved. There is no answer where a step fails.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CheckAnswer {
    /// The name of the certificate.
    pub certificate: String,
    /// The names of the inputs.
    pub files: Vec<String>,
    /// Whether all steps of the proof hold; always true.
    pub verified: bool,
    /// The claims that were derived from the input and agree with the answer.
    pub proved: Vec<String>,
    /// The keys of the answer that were not checked.
    pub unchecked: Vec<String>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}
