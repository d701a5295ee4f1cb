//! The answer of `star`, `closure`, `link`, `boundary`, `interior` and `skeleton`: a set of simplices.

use super::Remark;
use coface_complexes::simplicial::{Simplex, SimplexSet};
use serde::{Deserialize, Serialize};

/// A set of simplices of a complex.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SimplicesAnswer {
    /// The name of the input.
    pub file: String,
    /// The simplices, each by its vertices, by rising dimension.
    pub simplices: Vec<Vec<u32>>,
    /// How many simplices of dimension 0, 1, ... there are.
    pub f_vector: Vec<usize>,
    /// Whether the set has all faces of its simplices.
    pub is_complex: bool,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

impl SimplicesAnswer {
    /// The answer for a set of simplices in the file of this name.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::answer::SimplicesAnswer;
    /// use coface_complexes::simplicial::{Simplex, SimplexSet};
    /// let edge: SimplexSet = [Simplex::from([0, 1])].into_iter().collect();
    /// let answer = SimplicesAnswer::of("edge.json", &edge);
    /// assert_eq!((answer.simplices, answer.is_complex), (vec![vec![0, 1]], false));
    /// ```
    pub fn of(file: &str, set: &SimplexSet) -> Self {
        Self {
            file: file.to_owned(),
            simplices: set.iter().map(Simplex::numbers).map(<[u32]>::to_vec).collect(),
            f_vector: set.f_vector().to_vec(),
            is_complex: set.is_complex(),
            remarks: Vec::new(),
        }
    }
}
