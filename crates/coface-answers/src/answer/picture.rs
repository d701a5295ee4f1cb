//! What `render` answers: the picture that was written.

use super::Remark;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A still picture.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[non_exhaustive]
pub struct RenderAnswer {
    /// The name of the file that is shown.
    pub file: String,
    /// The file of the picture; null if none was written.
    pub picture: Option<String>,
    /// The size of the picture in bytes.
    pub bytes: usize,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

impl RenderAnswer {
    /// A picture of a file, of so many bytes.
    ///
    /// # Examples
    /// ```
    /// let answer = coface_answers::answer::RenderAnswer::new("a.off".to_owned(), Some("a.png".to_owned()), 7);
    /// assert_eq!((answer.file.as_str(), answer.bytes), ("a.off", 7));
    /// ```
    pub fn new(file: String, picture: Option<String>, bytes: usize) -> Self {
        Self { file, picture, bytes, remarks: Vec::new() }
    }
}
