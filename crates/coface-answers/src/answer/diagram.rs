//! The answers of `diagram`: distances of persistence diagrams, and diagrams as curves and images.

use super::Remark;
use serde::{Deserialize, Serialize};

/// How far two persistence diagrams are from each other.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct DiagramDistanceAnswer {
    /// The names of the inputs.
    pub files: [String; 2],
    /// `bottleneck` or `wasserstein`.
    pub metric: String,
    /// The order of a Wasserstein distance; `null` for the bottleneck distance.
    pub order: Option<f64>,
    /// The exponent of the norm that measures a pair; `null` for the greater one of the differences of births and of deaths.
    pub internal_p: Option<f64>,
    /// The distance of the degrees together: the greatest, or the root of the sum of powers; `null` if it is infinite.
    pub distance: Option<f64>,
    /// The distances by degree.
    pub degrees: Vec<DegreeDistance>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// How far the classes of one degree are from each other.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct DegreeDistance {
    /// The degree.
    pub degree: usize,
    /// The distance; `null` if it is infinite: the numbers of classes that never die differ.
    pub distance: Option<f64>,
    /// No matching is shorter than this: the value of a solution of the dual problem. `null` if the distance is infinite.
    pub lower_bound: Option<f64>,
    /// The numbers of classes that never die in the two inputs.
    pub essential: [usize; 2],
    /// Pairs of matched classes, each with its place in its input, from 0; `null` stands for the diagonal. Only if it was asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub matching: Option<Vec<[Option<usize>; 2]>>,
}

/// A diagram as functions of the value: Betti curves, the Euler characteristic, landscapes, silhouettes.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct DiagramCurvesAnswer {
    /// The name of the input.
    pub file: String,
    /// `betti`, `euler`, `landscape` or `silhouette`.
    pub kind: String,
    /// The values at which the curves are given.
    pub values: Vec<f64>,
    /// The curves.
    pub curves: Vec<DiagramCurve>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// A function of the value.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct DiagramCurve {
    /// What it is: `degree 1`, `landscape 2 of degree 1`, `euler characteristic`.
    pub name: String,
    /// Its numbers, one for each value.
    pub numbers: Vec<f64>,
}

/// A persistence image.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct DiagramImageAnswer {
    /// The name of the input.
    pub file: String,
    /// The degree of the classes.
    pub degree: usize,
    /// The first and the last birth.
    pub births: [f64; 2],
    /// The first and the last persistence.
    pub persistences: [f64; 2],
    /// The standard deviation of the normal distribution around each class.
    pub bandwidth: f64,
    /// The power of the persistence that is the weight of a class.
    pub power: f64,
    /// The pixels: a row for each range of persistences, from the shortest on, in which births run.
    pub rows: Vec<Vec<f64>>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}
