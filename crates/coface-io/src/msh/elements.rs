//! The types of elements, by their numbers.

use crate::element_kind::Kind;

/// A type of element: its first `corner_count` nodes are the corners.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct ElementType {
    pub(super) kind: Kind,
    pub(super) corner_count: usize,
    pub(super) node_count: usize,
}

/// The most nodes of a known type.
pub(super) const MOST_NODES: usize = 125;

impl ElementType {
    /// The type with this number, if it is known here.
    pub(super) fn from_number(number: i64) -> Option<Self> {
        let (kind, corner_count, node_count) = match number {
            1 => (Kind::Line, 2, 2),
            2 => (Kind::Polygon, 3, 3),
            3 => (Kind::Polygon, 4, 4),
            4 => (Kind::TETRAHEDRON, 4, 4),
            5 => (Kind::HEXAHEDRON, 8, 8),
            6 => (Kind::WEDGE, 6, 6),
            7 => (Kind::PYRAMID, 5, 5),
            8 => (Kind::Line, 2, 3),
            9 => (Kind::Polygon, 3, 6),
            10 => (Kind::Polygon, 4, 9),
            11 => (Kind::TETRAHEDRON, 4, 10),
            12 => (Kind::HEXAHEDRON, 8, 27),
            13 => (Kind::WEDGE, 6, 18),
            14 => (Kind::PYRAMID, 5, 14),
            15 => (Kind::Point, 1, 1),
            16 => (Kind::Polygon, 4, 8),
            17 => (Kind::HEXAHEDRON, 8, 20),
            18 => (Kind::WEDGE, 6, 15),
            19 => (Kind::PYRAMID, 5, 13),
            20 => (Kind::Polygon, 3, 9),
            21 => (Kind::Polygon, 3, 10),
            22 => (Kind::Polygon, 3, 12),
            23 => (Kind::Polygon, 3, 15),
            24 => (Kind::Polygon, 3, 15),
            25 => (Kind::Polygon, 3, 21),
            26 => (Kind::Line, 2, 4),
            27 => (Kind::Line, 2, 5),
            28 => (Kind::Line, 2, 6),
            29 => (Kind::TETRAHEDRON, 4, 20),
            30 => (Kind::TETRAHEDRON, 4, 35),
            31 => (Kind::TETRAHEDRON, 4, 56),
            36 => (Kind::Polygon, 4, 16),
            37 => (Kind::Polygon, 4, 25),
            38 => (Kind::Polygon, 4, 36),
            92 => (Kind::HEXAHEDRON, 8, 64),
            93 => (Kind::HEXAHEDRON, 8, 125),
            _ => return None,
        };
        Some(Self { kind, corner_count, node_count })
    }

    /// The number of the type of first order with this kind and so many corners.
    pub(super) fn number_of(kind: Kind, corner_count: usize) -> Option<u8> {
        [15, 1, 2, 3, 4, 5, 6, 7].into_iter().find(|&number| {
            Self::from_number(number.into())
                .is_some_and(|element| element.kind == kind && element.corner_count == corner_count)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn types_have_room_for_their_corners() {
        for element in (0..200).filter_map(ElementType::from_number) {
            assert!(element.corner_count <= element.node_count && element.node_count <= MOST_NODES);
            let number = ElementType::number_of(element.kind, element.corner_count).unwrap();
            assert_eq!(ElementType::from_number(number.into()).unwrap().node_count, element.corner_count);
        }
    }
}
