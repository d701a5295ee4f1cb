//! What an element of a mesh is.

use super::GroupKind;
use coface_complexes::cell_mesh::CellShape;

/// What an element of a mesh is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    Point,
    Line,
    Polygon,
    Cell(CellShape),
}

impl Kind {
    pub(crate) const TETRAHEDRON: Self = Self::Cell(CellShape::Tetrahedron);
    pub(crate) const HEXAHEDRON: Self = Self::Cell(CellShape::Hexahedron);
    pub(crate) const WEDGE: Self = Self::Cell(CellShape::Wedge);
    pub(crate) const PYRAMID: Self = Self::Cell(CellShape::Pyramid);

    /// The name of such an element with so many vertices.
    pub(super) fn name(self, corner_count: usize) -> &'static str {
        match (self, corner_count) {
            (Self::Point, _) => "point",
            (Self::Line, _) => "line",
            (Self::Polygon, 3) => "triangle",
            (Self::Polygon, 4) => "quadrangle",
            (Self::Polygon, _) => "polygon",
            (Self::Cell(shape), _) => shape.name(),
        }
    }

    /// What a group of such elements is a group of; points are grouped by their vertices.
    pub(crate) fn group_kind(self) -> GroupKind {
        match self {
            Self::Point => GroupKind::Vertices,
            Self::Line => GroupKind::Lines,
            Self::Polygon => GroupKind::Polygons,
            Self::Cell(_) => GroupKind::Cells,
        }
    }
}
