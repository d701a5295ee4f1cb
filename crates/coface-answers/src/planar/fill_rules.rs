//! What drawings state to be inside of their rings.

use coface_arrange::boolean::InsideRule;
use coface_io::{CellData, GroupKind, Model};
use std::ops::Range;

/// What polygons of a drawing state to be inside of their rings, as SVG does.
#[derive(Clone, Copy)]
pub(super) struct FillRules<'a>(Option<&'a CellData>);

impl<'a> FillRules<'a> {
    pub(super) fn of(model: &'a Model) -> Self {
        Self(model.data_named("fill_rule", GroupKind::Lines))
    }

    /// Whether the drawing states nothing.
    pub(super) fn are_none(self) -> bool {
        self.0.is_none()
    }

    /// That of a polygon, by the lines that are its rings; `None` if what is inside is an outer ring without holes.
    pub(super) fn of_polygon(self, lines: &Range<usize>) -> Option<InsideRule> {
        match self.0?.integer_row(lines.start)?.first()? {
            0 => Some(InsideRule::Nonzero),
            1 => Some(InsideRule::Odd),
            _ => None,
        }
    }
}
