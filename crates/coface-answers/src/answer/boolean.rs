//! What `boolean` answers: combinations of regions in the plane, and of solids.

use super::Remark;
use super::arrange::{
    CongruentPieces, DrawingInput, JoinedFeatures, RoundingRepair, SpatialInput, SpatialRounding,
    VertexOrigin,
};
use serde::{Deserialize, Serialize};

/// A Boolean combination of regions in the plane.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PlanarBooleanAnswer {
    /// The dimension of the space: 2.
    pub dimension: usize,
    /// The area, in the square of the unit of the inputs.
    pub measure: f64,
    /// The numbers of vertices, edges and polygons.
    pub f_vector: [usize; 3],
    /// The number of parts whose inner points are connected.
    pub components: usize,
    /// Whether the boundary is closed: always true.
    pub closed: bool,
    /// Whether the boundary is a curve everywhere.
    pub manifold: BoundaryManifold,
    /// The number of polygons.
    pub polygons: usize,
    /// The number of holes of polygons.
    pub holes: usize,
    /// The areas of the polygons without their holes.
    pub measures: Vec<f64>,
    /// The number of vertices where more than two edges of the boundary meet.
    pub pinches: usize,
    /// What rounding the coordinates does to the polygons.
    pub rounding: PolygonRounding,
    /// How many times coordinates were rounded and everything arranged again; null unless snapping was asked for.
    pub snap_rounds: Option<usize>,
    /// What was put together, where that was asked for.
    #[serde(default)]
    pub joined: Option<JoinedFeatures>,
    /// What congruence put together; with `--method congruence` only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub congruence: Option<CongruentPieces>,
    /// The numbers of vertices, edges and faces that the inputs cut the plane into; where many regions cover each other,
    /// that the sides which are cut do.
    pub arrangement: [usize; 3],
    /// The names of the regions, which are the inputs of the formula.
    pub regions: Vec<String>,
    /// The inputs in their order.
    pub inputs: Vec<DrawingInput>,
    /// Sentences about what is odd in the inputs.
    pub warnings: Vec<String>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// Whether the boundary of a result is a manifold, with a witness if it is not.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct BoundaryManifold {
    /// The verdict.
    pub verdict: BoundaryVerdict,
    /// Whether the boundary is closed.
    pub closed: bool,
    /// A place where it is no manifold; null if it is one.
    pub witness: Option<BoundaryWitness>,
}

/// Whether a boundary is a manifold.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
pub enum BoundaryVerdict {
    /// It is a manifold.
    Yes,
    /// It is not.
    No,
}

/// A place where a boundary is no manifold.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct BoundaryWitness {
    /// A word for programs: what sort of witness this is.
    pub kind: String,
    /// The cells, each by its vertices.
    pub cells: Vec<Vec<u32>>,
    /// One sentence for people.
    pub message: String,
    /// For each cell the positions of its vertices; in space only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub points: Option<Vec<Vec<Vec<f64>>>>,
}

/// What rounding the coordinates of crossings does to polygons.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PolygonRounding {
    /// Whether no coordinate was rounded.
    pub exact: bool,
    /// Whether the polygons are valid with rounded coordinates, as one multipolygon of OGC's Simple feature access.
    pub valid: bool,
    /// What was done so that they are.
    #[serde(flatten)]
    pub repair: RoundingRepair,
}

/// Where the cells of a combination of regions come from. A segment is a pair: an input and a number in it, both from 0.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PlanarBooleanProvenance {
    /// The names of the inputs.
    pub inputs: Vec<String>,
    /// The names of the regions.
    pub regions: Vec<String>,
    /// The origin of each vertex.
    pub vertices: Vec<VertexOrigin>,
    /// The edges with their origins.
    pub edges: Vec<EdgeOrigin>,
    /// For each polygon the regions that contain some of it.
    pub polygons: Vec<Vec<u32>>,
}

/// An edge of a combination of regions.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct EdgeOrigin {
    /// Its vertices, the lower first.
    pub ends: [u32; 2],
    /// The segments along it.
    pub segments: Vec<(usize, usize)>,
}

/// A Boolean combination of solids.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SolidBooleanAnswer {
    /// The dimension of the space: 3.
    pub dimension: usize,
    /// The volume, in the cube of the unit of the inputs; null if the exterior is in the result.
    pub measure: Option<f64>,
    /// The numbers of vertices, edges and polygons of the surface; a face with holes counts once unless faces are cut into triangles.
    pub f_vector: [usize; 3],
    /// The number of connected components of the surface.
    pub components: usize,
    /// Whether the surface is closed.
    pub closed: bool,
    /// Whether the surface is a manifold.
    pub manifold: BoundaryManifold,
    /// Vertices minus edges plus polygons of the surface.
    pub euler_characteristic: i64,
    /// The genus of the surface; null if it is not one connected manifold.
    pub genus: Option<usize>,
    /// The area of the surface, in the square of the unit of the inputs; null beyond the range of numbers.
    pub area: Option<f64>,
    /// The number of connected parts of the result; cells are connected through faces.
    pub solids: usize,
    /// The number of bounded connected parts of the complement.
    pub voids: usize,
    /// The number of cells of the arrangement that are selected; where many operands that cover each other were combined some at a
    /// time, of the last arrangement, in which most of what is inside is left out.
    pub cells: usize,
    /// Whether the exterior is in the result.
    pub unbounded: bool,
    /// Whether faces are cut into triangles.
    pub triangles: bool,
    /// The number of faces that were cut into triangles because they have holes or slits.
    pub faces_cut: usize,
    /// The number of faces between selected cells that are kept.
    pub walls: usize,
    /// Where the result is pinched.
    pub pinches: Pinches,
    /// Which winding numbers are inside: `nonzero`, `positive` or `evenodd`.
    pub rule: String,
    /// The inputs in their order.
    pub files: Vec<SpatialInput>,
    /// What was rounded.
    pub rounding: SpatialRounding,
    /// What was put together, where that was asked for or needed.
    pub joined: Option<JoinedFeatures>,
    /// What congruence put together; with `--method congruence` only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub congruence: Option<CongruentPieces>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// The places where a result in space is pinched, by coordinates before pinches are split.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct Pinches {
    /// The number of edges in more than two polygons.
    pub edge_count: usize,
    /// The number of vertices whose polygons are connected in several ways.
    pub vertex_count: usize,
    /// The first hundred such edges by the positions of their ends.
    pub edges: Vec<Vec<Vec<f64>>>,
    /// The first hundred such vertices by their positions.
    pub vertices: Vec<Vec<f64>>,
    /// Whether pinches were split.
    pub split: bool,
    /// The number of vertices that were copied to split them.
    pub copies: usize,
}

/// Where the polygons of a combination of solids come from.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SolidBooleanProvenance {
    /// The names of the inputs.
    pub files: Vec<String>,
    /// For each polygon its sources: the input, the polygon in it, and 1 or -1 where the result runs with it or against it.
    pub polygons: Vec<Vec<[i64; 3]>>,
}

impl BoundaryVerdict {
    /// Yes, or no.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::answer::BoundaryVerdict;
    /// assert_eq!(BoundaryVerdict::of(true), BoundaryVerdict::Yes);
    /// ```
    pub fn of(is_manifold: bool) -> Self {
        if is_manifold { Self::Yes } else { Self::No }
    }
}
