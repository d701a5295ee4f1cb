//! What `batch` answers: how many rows were written.

use super::Remark;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// A table of reports.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
#[non_exhaustive]
pub struct BatchAnswer {
    /// The file that was written.
    pub output: String,
    /// The number of files, which is that of rows.
    pub files: usize,
    /// The numbers of rows that are errors, by kind.
    pub errors: BTreeMap<String, usize>,
    /// The number of rows taken from an earlier run that was cut short.
    pub resumed: usize,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

impl BatchAnswer {
    /// A table with no rows in this file.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::answer::BatchAnswer::new("rows.csv".to_owned()).output, "rows.csv");
    /// ```
    pub fn new(output: String) -> Self {
        Self { output, files: 0, errors: BTreeMap::new(), resumed: 0, remarks: Vec::new() }
    }

    /// The number of rows that are errors.
    ///
    /// # Examples
    /// ```
    /// let mut answer = coface_answers::answer::BatchAnswer::new("rows.csv".to_owned());
    /// answer.errors.insert("parse".to_owned(), 2);
    /// answer.errors.insert("time".to_owned(), 1);
    /// assert_eq!(answer.error_count(), 3);
    /// ```
    pub fn error_count(&self) -> usize {
        self.errors.values().sum()
    }
}
