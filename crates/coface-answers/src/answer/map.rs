//! What `map` answers: a map changed feature by feature, or what is wrong with it.

use super::{DrawingInput, DrawnFaultAnswer, Remark};
use serde::{Deserialize, Serialize};

/// A map that was changed or examined.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct MapAnswer {
    /// What was done: repair, buffer, clip, node, polygonize, simplify or coverage.
    pub task: String,
    /// The dimension of the space: 2.
    pub dimension: usize,
    /// How much the new map has.
    pub counts: MapCounts,
    /// The sum of the areas of its polygons, in the square of the unit of the inputs.
    pub measure: f64,
    /// The sum of the lengths of its lines, which rings are not, in the unit of the inputs.
    pub length: f64,
    /// The inputs in their order.
    pub inputs: Vec<DrawingInput>,
    /// What was repaired: of `repair`, and of `buffer` and `clip`, which repair polygons first.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub repair: Option<MapRepairAnswer>,
    /// How arcs were flattened; of `buffer`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub arcs: Option<BufferArcsAnswer>,
    /// What was left out; of `polygonize`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub left_out: Option<PolygonizeAnswer>,
    /// How much simpler the map is; of `simplify`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub simplification: Option<SimplificationAnswer>,
    /// Gaps, overlaps and sides that do not fit; of `coverage`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub coverage: Option<MapCoverageAnswer>,
    /// What was assumed, changed or left out.
    pub remarks: Vec<Remark>,
}

/// How much a map has.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct MapCounts {
    /// The number of features, those that draw nothing included.
    pub features: usize,
    /// The number of polygons.
    pub polygons: usize,
    /// The number of their holes.
    pub holes: usize,
    /// The number of lines, which rings are not.
    pub lines: usize,
    /// The number of points of their own.
    pub points: usize,
    /// The number of corners of rings and lines, and of points.
    pub vertices: usize,
}

/// Polygons that were made valid.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct MapRepairAnswer {
    /// What decided what is inside: structure or linework.
    pub method: String,
    /// How many features were not valid and are now.
    pub features: usize,
    /// What was wrong.
    pub faults: Vec<DrawnFaultAnswer>,
    /// The area of those features before, as outer rings minus holes, which other programs state of polygons that are not valid.
    pub area_before: f64,
    /// Their area now.
    pub area: f64,
    /// The area of what is inside now and not enclosed an odd number of times by the rings of before, or the other way around.
    pub area_changed: f64,
    /// How many rings of valid polygons were reversed: outer ones run counterclockwise and holes clockwise now (RFC 7946).
    pub rings_turned: usize,
    /// How many features have no polygon any more.
    pub vanished: usize,
    /// How far points moved at most so that rounded coordinates are valid.
    pub largest_movement: f64,
}

/// Arcs as straight lines.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct BufferArcsAnswer {
    /// The distance.
    pub distance: f64,
    /// How far the flattened arcs are from the true ones at most: corners are on the true arcs.
    pub error: f64,
    /// The least number of sides that a whole circle has.
    pub sides: usize,
}

/// Edges that bound no face.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PolygonizeAnswer {
    /// The number of edges that hang on the rest at one end or at none.
    pub dangles: usize,
    /// The number of other edges with one face on both sides.
    pub cut_edges: usize,
}

/// A map with fewer vertices.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SimplificationAnswer {
    /// How far a border may be from where it was.
    pub tolerance: f64,
    /// How far the vertices that were left out are at most from the border now.
    pub largest_distance: f64,
    /// The number of different vertices of rings and lines before.
    pub vertices_before: usize,
    /// The number of different vertices now.
    pub vertices: usize,
    /// How many vertices were put in first, where borders met without one.
    pub vertices_added: usize,
}

/// Whether polygons are a coverage.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct MapCoverageAnswer {
    /// Whether polygons do not overlap, common borders have the same vertices on both sides, and no gap is too narrow.
    pub valid: bool,
    /// The width up to which a gap is a fault; `null` if none is.
    pub gap_width: Option<f64>,
    /// How many sides of polygons overlap others, run into them or meet them at no vertex of their own; the new map has these sides.
    pub invalid_edges: usize,
    /// Connected parts of the plane that are in several features.
    pub overlaps: Vec<OverlapAnswer>,
    /// Bounded connected parts of the plane that are in no feature.
    pub gaps: Vec<GapAnswer>,
}

/// A part of the plane that several features contain.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct OverlapAnswer {
    /// The features, numbered from 0.
    pub features: Vec<u32>,
    /// The area.
    pub area: f64,
    /// A corner of it.
    pub point: [f64; 2],
}

/// A bounded part of the plane that no feature contains.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct GapAnswer {
    /// The features around it, numbered from 0.
    pub features: Vec<u32>,
    /// The area.
    pub area: f64,
    /// Twice the area by the length of its border: the width of a long narrow one.
    pub width: f64,
    /// A corner of it.
    pub point: [f64; 2],
    /// Whether it is so narrow that it is a fault.
    pub narrow: bool,
}
