//! What the verbs of `yin` answer about places on and around a boundary.

use super::{Remark, YinSetAnswer};
use serde::{Deserialize, Serialize};

/// The answer of `yin locate`.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinLocateAnswer {
    /// The name of the file.
    pub file: String,
    /// The number of points inside.
    pub inside: usize,
    /// The number of points on the boundary.
    pub boundary: usize,
    /// The number of points outside.
    pub outside: usize,
    /// The points, in the order in which they were given.
    pub points: Vec<YinLocatedPoint>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// Where a point lies of a set.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum YinLocation {
    /// In the set.
    Inside,
    /// On the boundary of the set.
    Boundary,
    /// Outside of the closure of the set.
    Outside,
}

impl YinLocation {
    /// The word in files.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::answer::YinLocation::Inside.word(), "inside");
    /// ```
    pub fn word(self) -> &'static str {
        match self {
            Self::Inside => "inside",
            Self::Boundary => "boundary",
            Self::Outside => "outside",
        }
    }
}

/// A point, and the point of a boundary that is nearest to it.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinLocatedPoint {
    /// The point.
    pub point: [f64; 2],
    /// Where it lies.
    pub location: YinLocation,
    /// The distance from the boundary in the unit of the file, positive inside, negative outside; null for a set without boundary.
    pub signed_distance: Option<f64>,
    /// The point of the boundary that is nearest to it; null for a set without boundary.
    pub nearest: Option<[f64; 2]>,
    /// The curve that the nearest point is on; null for a set without boundary.
    pub curve: Option<usize>,
    /// The piece of that curve; null for a set without boundary.
    pub piece: Option<usize>,
    /// The parameter of the nearest point in [0, 1] on that piece; null for a set without boundary.
    pub parameter: Option<f64>,
}

/// The answer of `yin sample`.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinSampleAnswer {
    /// The name of the file.
    pub file: String,
    /// The points, curve by curve.
    pub samples: Vec<YinBoundarySample>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// A point of a boundary.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinBoundarySample {
    /// The curve.
    pub curve: usize,
    /// The piece of the curve.
    pub piece: usize,
    /// The parameter in [0, 1) on that piece.
    pub parameter: f64,
    /// The length of the curve from its beginning, in the unit of the file.
    pub length: f64,
    /// The point.
    pub point: [f64; 2],
    /// The direction of the curve, of length one, with the set on its left; null where the curve stands still.
    pub tangent: Option<[f64; 2]>,
    /// The signed curvature, positive where the curve turns left; null where the curve stands still.
    pub curvature: Option<f64>,
}

/// The answer of `yin curvature`.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinCurvatureAnswer {
    /// The name of the file.
    pub file: String,
    /// How each curve bends.
    pub curves: Vec<YinCurveBend>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// How a curve bends.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinCurveBend {
    /// The curve.
    pub curve: usize,
    /// Where its curvature is least: positive where it turns left, one over the unit of the file.
    pub least: YinBendPlace,
    /// Where its curvature is greatest.
    pub greatest: YinBendPlace,
    /// The knot at which its direction turns most at once, and by how many degrees, positive to the left.
    pub sharpest: YinBendPlace,
    /// The same among knots that are no kinks; null if all knots are kinks.
    pub roughest: Option<YinBendPlace>,
}

/// A place on a curve, and what is known there.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinBendPlace {
    /// The piece of the curve.
    pub piece: usize,
    /// The parameter in [0, 1] on that piece.
    pub parameter: f64,
    /// The point.
    pub point: [f64; 2],
    /// A curvature, or an angle in degrees.
    pub value: f64,
}

/// The answer of `yin validate`.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinValidationAnswer {
    /// The name of the file.
    pub file: String,
    /// Whether the curves of the file bound a set.
    pub valid: bool,
    /// What is wrong: with each curve by itself, or, if nothing is, with all of them together.
    pub faults: Vec<YinFaultAnswer>,
    /// The number of curves of the file.
    pub curves: usize,
    /// The knot that is no kink at which a curve turns most, with an angle in degrees: of order 4 and more near zero where curves are
    /// smooth. Null for order 2, without such a knot, and where something is wrong.
    pub roughest: Option<YinRoughKnot>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// What is wrong with a boundary.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinFaultAnswer {
    /// What it is.
    pub kind: YinFaultKind,
    /// The curves that it is about, by their numbers in the file; none where it is about all.
    pub curves: Vec<usize>,
    /// Where; null where that is not one point.
    pub point: Option<[f64; 2]>,
    /// The fault in words.
    pub message: String,
}

/// A kind of fault of a boundary.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum YinFaultKind {
    /// A curve does not end where it begins.
    Open,
    /// A closed polyline has less than three pieces.
    TooFewPieces,
    /// A piece has no length.
    ZeroLength,
    /// A curve comes to a point more than once.
    SelfMeeting,
    /// Two curves cross.
    Crossing,
    /// Curves share an arc.
    Overlap,
    /// A curve has the orientation of the one directly around it.
    Orientation,
    /// Of two curves that lie in no other, one is positive and one negative.
    MixedRoots,
    /// Something else, such as points that cannot be fitted: the message says what.
    Other,
}

/// A knot that is no kink, where a curve turns.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinRoughKnot {
    /// The curve.
    pub curve: usize,
    /// The knot.
    pub knot: usize,
    /// The point.
    pub point: [f64; 2],
    /// By how many degrees, positive to the left.
    pub degrees: f64,
}

/// The answer of `yin normalize`.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinNormalizeAnswer {
    /// The name of the file.
    pub file: String,
    /// How often curves were laid over each other again because rounding had made them cross.
    pub rounds: usize,
    /// The number of knots that lay on straight parts and were left out.
    pub straightened: usize,
    /// The set.
    #[serde(flatten)]
    pub set: YinSetAnswer,
}
