//! What `render` answers: the picture that was written.

use super::Remark;
use serde::{Deserialize, Serialize};

/// A still picture.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct RenderAnswer {
    /// The name of the file that is shown.
    pub file: String,
    /// The file of the picture; null if none was written.
    pub picture: Option<String>,
    /// The size of the picture in bytes.
    pub bytes: usize,
    /// The polygons that were drawn, of a picture of them.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub schemas: Vec<SchemaAnswer>,
    /// The boundary matrix that was drawn in blocks, of a picture of one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub matrix: Option<MatrixAnswer>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// A boundary matrix in blocks.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct MatrixAnswer {
    /// The degree of the cells of columns; rows are cells of the degree below.
    pub degree: usize,
    /// The blocks of rows in their order.
    pub rows: Vec<BlockAnswer>,
    /// The blocks of columns in their order.
    pub columns: Vec<BlockAnswer>,
    /// The number of entries that are not zero.
    pub entries_count: usize,
}

/// A block of rows or columns of a matrix.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct BlockAnswer {
    /// What its cells are.
    pub name: String,
    /// The number of its cells.
    pub size: usize,
}

/// A polygon whose sides are glued by letters.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SchemaAnswer {
    /// The letters of its sides, counterclockwise: `a b a^-1 b^-1`.
    pub word: String,
    /// The surface that it is glued to; `null` if a letter is at three sides or more.
    pub surface: Option<String>,
    /// For each corner the number of its class: those of one class are glued to one point. Side i runs from corner i to the next.
    pub corner_classes: Vec<usize>,
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
        Self { file, picture, bytes, schemas: Vec::new(), matrix: None, remarks: Vec::new() }
    }
}
