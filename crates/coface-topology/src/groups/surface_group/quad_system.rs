//! The system of quads of a surface with one vertex and one face.

use super::polygon_scheme::PolygonScheme;
use coface_algebra::Sign;

/// The two vertices of the system of quads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Hub {
    /// The vertex of the scheme.
    Vertex,
    /// The center of its polygon.
    Center,
}

impl Hub {
    /// The other one; every edge joins the two.
    pub(super) fn other(self) -> Self {
        match self {
            Self::Vertex => Self::Center,
            Self::Center => Self::Vertex,
        }
    }
}

/// The map that a polygon scheme becomes when its center is joined to all its corners and its sides are forgotten: two
/// hubs of degree d, an edge for each corner, a quadrangle for each pair of sides. Its edges are numbered as the
/// corners.
///
/// In the universal cover all orientations agree with that of the base vertex; a walk carries it along. The **turn**
/// of a walk at a hub is the number of quadrangles on its right there, from 0 (it goes back) to d - 1.
#[derive(Clone, Debug)]
pub(super) struct QuadSystem {
    degree: u32,
    /// Counterclockwise around the vertex; around the center it is their numbers.
    rotation: Vec<u32>,
    positions: Vec<u32>,
    signs: Vec<Sign>,
}

impl QuadSystem {
    pub(super) fn new(scheme: &PolygonScheme) -> Self {
        let rotation = scheme.rotation().to_vec();
        let mut positions = vec![0; rotation.len()];
        for (position, &corner) in rotation.iter().enumerate() {
            positions[corner as usize] = position as u32;
        }
        Self { degree: rotation.len() as u32, rotation, positions, signs: scheme.signs().to_vec() }
    }

    /// The degree of both hubs.
    pub(super) fn degree(&self) -> u32 {
        self.degree
    }

    /// Whether the orientations of both hubs agree along an edge.
    pub(super) fn sign(&self, edge: u32) -> Sign {
        self.signs[edge as usize]
    }

    fn position(&self, hub: Hub, edge: u32) -> u32 {
        match hub {
            Hub::Vertex => self.positions[edge as usize],
            Hub::Center => edge,
        }
    }

    /// The turn from one edge to another at a hub where the walk's orientation is the hub's own or opposite to it.
    pub(super) fn turn(&self, hub: Hub, orientation: Sign, from: u32, to: u32) -> u32 {
        let (mut a, mut b) = (self.position(hub, from), self.position(hub, to));
        if orientation == Sign::Minus {
            (a, b) = (b, a);
        }
        if b >= a { b - a } else { b + self.degree - a }
    }

    /// The edge at this turn from another one.
    pub(super) fn turned(&self, hub: Hub, orientation: Sign, from: u32, turn: u32) -> u32 {
        let turn = if orientation == Sign::Plus { turn } else { self.degree - turn };
        let position = (self.position(hub, from) + turn) % self.degree;
        match hub {
            Hub::Vertex => self.rotation[position as usize],
            Hub::Center => position,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::Word;

    #[test]
    fn quadrangles_close_after_four_turns() {
        let schemes: [&[i32]; 6] = [
            &[1, 2, -1, -2],
            &[1, 2, 1, -2],
            &[1, 1, 2, 2, 3, 3],
            &[1, 2, -1, -2, 3, 3],
            &[1, 2, -1, -2, 3, 4, -3, -4],
            &[1, 2, 3, 4, -1, -2, -3, -4],
        ];
        for letters in schemes {
            let scheme =
                PolygonScheme::new(letters.len() / 2, &Word::from_letters(letters.iter().copied())).unwrap();
            let quads = QuadSystem::new(&scheme);
            for start in 0..quads.degree() {
                for turn in [1, quads.degree() - 1] {
                    for first in [Sign::Plus, Sign::Minus] {
                        let (mut hub, mut edge, mut orientation) = (Hub::Vertex, start, first);
                        for _ in 0..4 {
                            orientation = orientation.times(quads.sign(edge));
                            hub = hub.other();
                            let next = quads.turned(hub, orientation, edge, turn);
                            assert_eq!(quads.turn(hub, orientation, edge, next), turn);
                            edge = next;
                        }
                        assert_eq!((edge, orientation), (start, first), "{letters:?}");
                    }
                }
            }
        }
    }
}
