//! What `generate` answers: a model made by rule.

use super::Remark;
use coface_algebra::Error;
use coface_io::Model;
use serde::{Deserialize, Serialize};

use crate::Producer;

/// A model made by rule.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct GenerateAnswer {
    /// The numbers of cells of each dimension.
    pub f_vector: Vec<usize>,
    /// Their alternating sum.
    pub euler_characteristic: i64,
    /// The least and the greatest coordinates of all points; null without positions.
    pub bounding_box: Option<[Vec<f64>; 2]>,
    /// The file that was written; absent if there is none.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub output: Option<String>,
    /// The format of that file.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub output_format: Option<String>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

impl GenerateAnswer {
    /// Counts the cells of a model.
    ///
    /// # Errors
    /// Those of [`Producer::of`].
    ///
    /// # Examples
    /// ```
    /// use coface_answers::answer::GenerateAnswer;
    /// use coface_io::{Format, read};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = read(&b"v 0 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\n"[..], Format::Obj)?;
    /// let answer = GenerateAnswer::of(triangle)?;
    /// assert_eq!((answer.f_vector, answer.euler_characteristic), (vec![3, 3, 1], 1));
    /// assert_eq!(answer.bounding_box, Some([vec![0.0, 0.0, 0.0], vec![2.0, 1.0, 0.0]]));
    /// # Ok(()) }
    /// ```
    pub fn of(model: Model) -> Result<Self, Error> {
        let bounding_box = bounding_box(&model);
        let complex = Producer::of(model)?.into_chain_complex()?;
        Ok(Self {
            f_vector: complex.f_vector().to_vec(),
            euler_characteristic: complex.euler_characteristic(),
            bounding_box,
            output: None,
            output_format: None,
            remarks: Vec::new(),
        })
    }

    /// The same with the file that was written, and its format.
    #[must_use]
    pub fn written_to(mut self, output: String, format: &str) -> Self {
        self.output = Some(output);
        self.output_format = Some(format.to_owned());
        self
    }
}

/// The least and the greatest coordinates of all points.
fn bounding_box(model: &Model) -> Option<[Vec<f64>; 2]> {
    let positions = model.positions();
    let space = positions.dimension();
    if positions.is_empty() || space == 0 {
        return None;
    }
    let mut bounds = [vec![f64::INFINITY; space], vec![f64::NEG_INFINITY; space]];
    for point in positions.as_flat().chunks(space) {
        for (k, &x) in point.iter().enumerate() {
            bounds[0][k] = bounds[0][k].min(x);
            bounds[1][k] = bounds[1][k].max(x);
        }
    }
    Some(bounds)
}
