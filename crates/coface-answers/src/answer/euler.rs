//! The answer of `euler`: Euler characteristics of what has entered.

use super::Remark;
use serde::{Deserialize, Serialize};

/// The Euler characteristic of what has entered, as a function of the value, and along directions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct EulerAnswer {
    /// The name of the input.
    pub file: String,
    /// What cells enter by: a coordinate, a file of values, `voxels, t-construction`, or `height along directions`.
    pub function: String,
    /// `lower` if values rise, `upper` if they fall.
    pub star: String,
    /// The Euler characteristic of the whole.
    pub characteristic: i64,
    /// The directions, each as long as a unit; `null` if cells enter by one function.
    pub directions: Option<Vec<Vec<f64>>>,
    /// The middle of the box of the vertices, from which heights are measured; `null` if they are measured from the origin.
    pub center: Option<Vec<f64>>,
    /// The greatest distance of a vertex from the center, in units of which heights are measured; `null` if they are in the unit of the positions.
    pub radius: Option<f64>,
    /// Whether the curves are the integrals of what the characteristic is above its mean over the range of the values.
    pub smooth: bool,
    /// The values at which the curves are given.
    pub values: Vec<f64>,
    /// For each direction, or once, a number for each value.
    pub curves: Vec<Vec<f64>>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}
