//! The sections of a file: their keywords, and their codes in binary files.

use crate::GroupKind;
use crate::element_kind::Kind;

/// What a section lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Section {
    Vertices,
    Elements(Elements),
    /// Numbers of vertices or elements listed before, which make a group named as the section.
    Marks(Marks),
    End,
    /// Anything else.
    Unknown,
}

/// A section of elements: each has its corners, and then vertices inside its edges, faces and itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Elements {
    pub(super) kind: Kind,
    pub(super) corner_count: usize,
    pub(super) vertex_count: usize,
}

/// A section of marked vertices or elements.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Marks {
    pub(super) name: &'static str,
    pub(super) kind: GroupKind,
    /// The number of corners of the marked elements; 1 for vertices.
    pub(super) corner_count: usize,
}

const fn elements(kind: Kind, corner_count: usize, vertex_count: usize) -> Section {
    Section::Elements(Elements { kind, corner_count, vertex_count })
}

const fn marks(name: &'static str, kind: GroupKind, corner_count: usize) -> Section {
    Section::Marks(Marks { name, kind, corner_count })
}

/// Keyword, code in binary files (0 where it is not known to be one), section.
const SECTIONS: [(&str, i64, Section); 29] = [
    ("Vertices", 4, Section::Vertices),
    ("Edges", 5, elements(Kind::Line, 2, 2)),
    ("EdgesP2", 25, elements(Kind::Line, 2, 3)),
    ("Triangles", 6, elements(Kind::Polygon, 3, 3)),
    ("TrianglesP2", 24, elements(Kind::Polygon, 3, 6)),
    ("Quadrilaterals", 7, elements(Kind::Polygon, 4, 4)),
    ("Quadrangles", 0, elements(Kind::Polygon, 4, 4)),
    ("QuadrilateralsQ2", 27, elements(Kind::Polygon, 4, 9)),
    ("Tetrahedra", 8, elements(Kind::TETRAHEDRON, 4, 4)),
    ("Tetrahedrons", 0, elements(Kind::TETRAHEDRON, 4, 4)),
    ("TetrahedraP2", 30, elements(Kind::TETRAHEDRON, 4, 10)),
    ("Hexahedra", 10, elements(Kind::HEXAHEDRON, 8, 8)),
    ("Hexaedra", 0, elements(Kind::HEXAHEDRON, 8, 8)),
    ("Hexahedrons", 0, elements(Kind::HEXAHEDRON, 8, 8)),
    ("HexahedraQ2", 33, elements(Kind::HEXAHEDRON, 8, 27)),
    ("Prisms", 9, elements(Kind::WEDGE, 6, 6)),
    ("Wedges", 0, elements(Kind::WEDGE, 6, 6)),
    ("Pentahedra", 0, elements(Kind::WEDGE, 6, 6)),
    ("PrismsP2", 0, elements(Kind::WEDGE, 6, 18)),
    ("Pyramids", 49, elements(Kind::PYRAMID, 5, 5)),
    ("PyramidsP2", 0, elements(Kind::PYRAMID, 5, 14)),
    ("Corners", 13, marks("Corners", GroupKind::Vertices, 1)),
    ("RequiredVertices", 15, marks("RequiredVertices", GroupKind::Vertices, 1)),
    ("Ridges", 14, marks("Ridges", GroupKind::Lines, 2)),
    ("RequiredEdges", 16, marks("RequiredEdges", GroupKind::Lines, 2)),
    ("RequiredTriangles", 17, marks("RequiredTriangles", GroupKind::Polygons, 3)),
    ("RequiredQuadrilaterals", 18, marks("RequiredQuadrilaterals", GroupKind::Polygons, 4)),
    ("End", 54, Section::End),
    ("EOF", 0, Section::End),
];

impl Section {
    /// The section that a keyword opens.
    pub(super) fn from_keyword(keyword: &[u8]) -> Self {
        SECTIONS
            .iter()
            .find(|(name, ..)| name.as_bytes() == keyword)
            .map_or(Self::Unknown, |&(_, _, section)| section)
    }

    /// The section of this code in a binary file.
    pub(super) fn from_code(code: i64) -> Self {
        SECTIONS
            .iter()
            .find(|&&(_, known, _)| known == code && known > 0)
            .map_or(Self::Unknown, |&(_, _, section)| section)
    }

    /// The keyword, for an error message.
    pub(super) fn keyword(self) -> &'static str {
        SECTIONS.iter().find(|&&(_, _, section)| section == self).map_or("a section", |&(name, ..)| name)
    }
}

/// The first keyword that a word begins without being one.
pub(super) fn completed(word: &[u8]) -> Option<&'static str> {
    SECTIONS
        .iter()
        .map(|&(name, ..)| name)
        .find(|name| name.as_bytes().starts_with(word) && name.len() > word.len())
}

/// The sections that mark vertices or elements.
pub(super) fn all_marks() -> impl Iterator<Item = Marks> {
    SECTIONS.iter().filter_map(|&(_, _, section)| match section {
        Section::Marks(marks) => Some(marks),
        _ => None,
    })
}
