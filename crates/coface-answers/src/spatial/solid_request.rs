//! What is asked of a Boolean combination of solids.

use super::OpenInputs;
use coface_algebra::Error;
use coface_arrange::boolean::{BooleanFormula, InsideRule};

/// What is asked of a Boolean combination.
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct SolidRequest {
    /// The formula; input i is model i.
    pub formula: BooleanFormula,
    /// Which winding numbers mean inside a model.
    pub rule: InsideRule,
    /// What becomes of models that are open.
    pub open: OpenInputs,
    /// Whether faces are cut into triangles; if not, only those with holes or slits are, since meshes hold none.
    pub triangles: bool,
    /// Whether vertices and edges where the result is pinched are split.
    pub split_pinches: bool,
    /// Whether faces between cells of the result are kept.
    pub keep_walls: bool,
    /// Whether triangles in one plane that nothing of the result separates are drawn as one polygon is; with rounded
    /// coordinates within their rounding. Only where triangles are asked for, and walls are not.
    pub merge_coplanar: bool,
}

impl SolidRequest {
    /// The formula by itself: nonzero winding numbers mean inside, models must be closed, faces are polygons.
    ///
    /// # Examples
    /// ```
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// use coface_answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
    /// use coface_arrange::boolean::BooleanFormula;
    /// // A tetrahedron of volume 1.
    /// let text = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 6\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n";
    /// let solid = coface_io::read(text.as_bytes(), coface_io::Format::Obj)?;
    /// let arranged = SceneArrangement::of([("solid", &solid)], &SpatialRequest::default())?;
    /// let same = SolidBoolean::of(&arranged, &SolidRequest::of(BooleanFormula::parse("a", &[])?))?;
    /// let request = SolidRequest::of(BooleanFormula::difference(2));
    /// assert!(!request.triangles && !request.keep_walls);
    /// # Ok(()) }
    /// ```
    pub fn of(formula: BooleanFormula) -> Self {
        Self {
            formula,
            rule: InsideRule::default(),
            open: OpenInputs::default(),
            triangles: false,
            split_pinches: false,
            keep_walls: false,
            merge_coplanar: false,
        }
    }

    /// Whether another request is for the surface of the same cells.
    pub(super) fn is_of_same_cells(&self, other: &Self) -> bool {
        self.formula == other.formula
            && self.rule == other.rule
            && self.open == other.open
            && !self.keep_walls
            && !other.keep_walls
    }
}

/// Refuses to answer other questions from the surface of a result.
pub(super) fn surface_alone() -> Error {
    Error::invalid("this arrangement has what one result needs, not the cells of all its inputs")
        .with_cure("arrange the inputs for every question: SceneArrangement::of")
}
