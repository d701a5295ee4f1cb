//! The answer of `yin compare --series`.

use super::Remark;
use serde::{Deserialize, Serialize};

/// The answer of `yin compare --series`.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinSeriesAnswer {
    /// The name of the set that the others are compared with.
    pub reference: String,
    /// The sets, in their order.
    pub rows: Vec<YinSeriesRow>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// How far a set of a series is from the one that it is compared with.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinSeriesRow {
    /// The name of the file.
    pub file: String,
    /// The number of polynomial pieces of the boundary.
    pub knots: usize,
    /// The mean distance of knots along the boundary; null without a boundary.
    pub spacing: Option<f64>,
    /// The area of the symmetric difference; null if it is infinite.
    pub area_xor: Option<f64>,
    /// An estimate from above of how far that is off.
    pub area_xor_error: f64,
    /// The power of the spacing by which that area has fallen since the row before; null in the first row and at the same spacing.
    pub area_rate: Option<f64>,
    /// The area of the set less that of the reference; null if it is infinite.
    pub area_signed: Option<f64>,
    /// How far that is off at most by rounding.
    pub area_signed_error: f64,
    /// The Hausdorff distance of the boundaries; null if one set alone has a boundary.
    pub hausdorff: Option<f64>,
    /// The power of the spacing by which that distance has fallen since the row before; null in the first row and at the same spacing.
    pub hausdorff_rate: Option<f64>,
    /// An estimate from above of how far that distance is off.
    pub hausdorff_error: f64,
    /// The greatest distance of the reference along the normals of the set; null if no normal meets it within twice the Hausdorff distance.
    pub along_normals: Option<f64>,
    /// An estimate from above of how far that is off.
    pub along_normals_error: f64,
    /// The greatest difference of curvatures where normals meet; null if none does.
    pub curvature: Option<f64>,
    /// An estimate from above of how far that is off.
    pub curvature_error: f64,
    /// The power of the spacing by which that difference has fallen since the row before; null in the first row and at the same spacing.
    pub curvature_rate: Option<f64>,
    /// The number of components.
    pub components: usize,
    /// The number of holes.
    pub holes: usize,
}
