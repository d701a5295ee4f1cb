//! The types of cells, by their numbers.

use crate::element_kind::Kind;
use coface_algebra::{Error, ErrorKind};

/// What a cell of one type becomes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum CellType {
    /// Nothing.
    Empty,
    /// A point for each vertex.
    Points,
    /// A polyline through its vertices.
    Polyline,
    /// Triangles: each vertex with the two before it.
    Strip,
    /// A polygon of any number of vertices.
    Polygon,
    /// A polygon whose first half are corners and whose second half lie on its edges.
    QuadraticPolygon,
    /// Corners in this order among the vertices of the cell; the rest up to `vertex_count` lie on edges and inside.
    Fixed { kind: Kind, corners: &'static [usize], vertex_count: usize },
}

const LINE: &[usize] = &[0, 1];
const TRIANGLE: &[usize] = &[0, 1, 2];
const QUADRANGLE: &[usize] = &[0, 1, 2, 3];
const HEXAHEDRON: &[usize] = &[0, 1, 2, 3, 4, 5, 6, 7];
const PYRAMID: &[usize] = &[0, 1, 2, 3, 4];
/// The bottom triangle runs the other way round; so does the top. Wedges of higher order have their corners as these do.
pub(super) const WEDGE: &[usize] = &[0, 2, 1, 3, 5, 4];

impl CellType {
    /// The type of cell `i`, which has this number in the file.
    pub(super) fn of_cell(i: usize, number: i64) -> Result<Self, Error> {
        Self::from_number(number).ok_or_else(|| {
            let message = format!("cell {i} has type {number}: {} are not read", unread_name(number));
            Error::new(ErrorKind::UnsupportedFormat, message)
                .with_cure("split such cells into hexahedra or tetrahedra")
        })
    }

    /// The type with this number, if it is known here.
    fn from_number(number: i64) -> Option<Self> {
        let fixed = |kind, corners, vertex_count| Self::Fixed { kind, corners, vertex_count };
        Some(match number {
            0 => Self::Empty,
            1 => fixed(Kind::Point, &[0], 1),
            2 => Self::Points,
            3 => fixed(Kind::Line, LINE, 2),
            4 => Self::Polyline,
            5 => fixed(Kind::Polygon, TRIANGLE, 3),
            6 => Self::Strip,
            7 => Self::Polygon,
            // Pixels and voxels count in rows.
            8 => fixed(Kind::Polygon, &[0, 1, 3, 2], 4),
            9 => fixed(Kind::Polygon, QUADRANGLE, 4),
            10 => fixed(Kind::TETRAHEDRON, QUADRANGLE, 4),
            11 => fixed(Kind::HEXAHEDRON, &[0, 1, 3, 2, 4, 5, 7, 6], 8),
            12 => fixed(Kind::HEXAHEDRON, HEXAHEDRON, 8),
            13 => fixed(Kind::WEDGE, WEDGE, 6),
            14 => fixed(Kind::PYRAMID, PYRAMID, 5),
            21 => fixed(Kind::Line, LINE, 3),
            22 => fixed(Kind::Polygon, TRIANGLE, 6),
            23 => fixed(Kind::Polygon, QUADRANGLE, 8),
            24 => fixed(Kind::TETRAHEDRON, QUADRANGLE, 10),
            25 => fixed(Kind::HEXAHEDRON, HEXAHEDRON, 20),
            26 => fixed(Kind::WEDGE, WEDGE, 15),
            27 => fixed(Kind::PYRAMID, PYRAMID, 13),
            28 => fixed(Kind::Polygon, QUADRANGLE, 9),
            29 => fixed(Kind::HEXAHEDRON, HEXAHEDRON, 27),
            30 => fixed(Kind::Polygon, QUADRANGLE, 6),
            31 => fixed(Kind::WEDGE, WEDGE, 12),
            32 => fixed(Kind::WEDGE, WEDGE, 18),
            33 => fixed(Kind::HEXAHEDRON, HEXAHEDRON, 24),
            34 => fixed(Kind::Polygon, TRIANGLE, 7),
            35 => fixed(Kind::Line, LINE, 4),
            36 => Self::QuadraticPolygon,
            37 => fixed(Kind::PYRAMID, PYRAMID, 19),
            _ => return None,
        })
    }
}

/// Whether a type of higher order than the linear one has the same corners and so many points.
pub(super) fn is_of_higher_order(kind: Kind, corner_count: usize, point_count: usize) -> bool {
    (21..=37).filter_map(CellType::from_number).any(|other| {
        matches!(other, CellType::Fixed { kind: own, corners, vertex_count }
            if own == kind && corners.len() == corner_count && vertex_count == point_count)
    })
}

/// The name of a type that is not read.
fn unread_name(number: i64) -> &'static str {
    match number {
        15 => "pentagonal prisms",
        16 => "hexagonal prisms",
        42 => "polyhedra",
        60..=67 => "cells of arbitrary order",
        68..=81 => "Lagrange and Bezier cells",
        _ => "cells of a type that is not known",
    }
}
