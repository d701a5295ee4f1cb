//! What the verbs of `yin` answer about places on and around the edges of an interface.

use super::{Remark, YinBendPlace, YinComparisonAnswer, YinLocation};
use serde::{Deserialize, Serialize};

/// The answer of `yin locate` for an interface.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinInterfaceLocateAnswer {
    /// The name of the file.
    pub file: String,
    /// For each phase the number of points inside.
    pub phases: Vec<PhasePoints>,
    /// The number of points on edges.
    pub boundary: usize,
    /// The number of points in no phase.
    pub outside: usize,
    /// The points, in the order in which they were given.
    pub points: Vec<InterfacePoint>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// How many points lie in a phase.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PhasePoints {
    /// The name of the phase.
    pub name: String,
    /// The number of points inside.
    pub inside: usize,
}

impl PhasePoints {
    pub(crate) fn new(name: String, inside: usize) -> Self {
        Self { name, inside }
    }
}

/// Where a point lies of an interface.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct InterfacePoint {
    /// The point.
    pub point: [f64; 2],
    /// Whether it lies in a phase, on an edge, or in no phase.
    pub location: YinLocation,
    /// The phase that it lies in; of a point on an edge the phases that meet there, without what is in no phase.
    pub phases: Vec<u32>,
    /// The distance from the nearest edge; null without edges.
    pub distance: Option<f64>,
    /// The point of the edges that is nearest to it; null without edges.
    pub nearest: Option<[f64; 2]>,
    /// The edge that the nearest point is on; null without edges.
    pub edge: Option<u32>,
    /// The piece of that edge; null without edges.
    pub piece: Option<usize>,
    /// The parameter of the nearest point in [0, 1] on that piece; null without edges.
    pub parameter: Option<f64>,
}

/// The answer of `yin sample` for an interface.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinInterfaceSampleAnswer {
    /// The name of the file.
    pub file: String,
    /// The points, edge by edge; edges that are not closed give the point at their end too.
    pub samples: Vec<EdgeSample>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// A point of an edge of an interface.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct EdgeSample {
    /// The edge.
    pub edge: u32,
    /// The phase on its left; null for what is in no phase.
    pub left: Option<u32>,
    /// The phase on its right; null for what is in no phase.
    pub right: Option<u32>,
    /// The piece of the edge.
    pub piece: usize,
    /// The parameter in [0, 1] on that piece.
    pub parameter: f64,
    /// The length of the edge from its start, in the unit of the file.
    pub length: f64,
    /// The point.
    pub point: [f64; 2],
    /// The direction of the edge, of length one; null where it stands still.
    pub tangent: Option<[f64; 2]>,
    /// The signed curvature, positive where the edge turns left; null where it stands still.
    pub curvature: Option<f64>,
}

/// The answer of `yin curvature` for an interface.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinInterfaceCurvatureAnswer {
    /// The name of the file.
    pub file: String,
    /// How each edge bends.
    pub edges: Vec<EdgeBendAnswer>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// How an edge of an interface bends.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct EdgeBendAnswer {
    /// The edge.
    pub edge: u32,
    /// The phase on its left; null for what is in no phase.
    pub left: Option<u32>,
    /// The phase on its right; null for what is in no phase.
    pub right: Option<u32>,
    /// Where its curvature is least: positive where it turns left, one over the unit of the file.
    pub least: YinBendPlace,
    /// Where its curvature is greatest.
    pub greatest: YinBendPlace,
    /// The knot between its ends at which its direction turns most at once, and by how many degrees, positive to the left; null for an edge
    /// of one piece.
    pub sharpest: Option<YinBendPlace>,
}

/// The answer of `yin compare` for two interfaces.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinInterfaceComparisonAnswer {
    /// The names of the files.
    pub files: Vec<String>,
    /// The sum of the areas of the symmetric differences of all phases; null if one is infinite. What went from one phase to another counts
    /// twice.
    pub area_xor: Option<f64>,
    /// An estimate from above of how far that is off.
    pub area_xor_error: f64,
    /// The number of junctions of each interface.
    pub junctions: [usize; 2],
    /// The phases of the first interface, each compared with its namesake in the second, or with the one of its number if names differ.
    pub phases: Vec<PhaseComparison>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// How far a phase of one interface is from one of another.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PhaseComparison {
    /// The numbers of the phases.
    pub numbers: [u32; 2],
    /// The comparison; its files are the names of the phases.
    #[serde(flatten)]
    pub sets: YinComparisonAnswer,
}
