//! What is asked of an arrangement in space.

use coface_arrange::CoordinatePrecision;
use coface_arrange::spatial::NonPlanar;

/// How a scene is arranged.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[non_exhaustive]
pub struct SpatialRequest {
    /// What becomes of polygons that are not planar.
    pub non_planar: NonPlanar,
    /// Whether faces in exactly one plane that have the same inputs are merged, be they of different polygons.
    pub merge_coplanar: bool,
    /// Round coordinates and arrange again until rounding changes nothing: the result is a valid input.
    pub snap: bool,
    /// Put planes, vertices, edges and faces together that are at most this far apart, in the unit of the inputs.
    pub tolerance: Option<f64>,
    /// Refuse arrangements with more vertices, edges and faces together.
    pub max_cells: Option<usize>,
    /// The numbers that coordinates are rounded to where the result is to be a valid input: those of the file that it goes to.
    pub precision: CoordinatePrecision,
}
