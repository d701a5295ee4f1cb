//! The cells that pieces divide space into.

use crate::pieces::Pieces;
use crate::point::Plane;
use crate::tree::Tree;
use crate::winding::Ray;
use coface_check::Fault;
use std::cmp::Ordering;
use std::collections::BTreeMap;

/// Sides of pieces, 2i in front of piece i and 2i + 1 behind it, in classes of one cell each; the last side is the exterior.
pub(crate) struct Cells {
    parent: Vec<u32>,
    /// A side of each shell: of each class that is joined around edges alone.
    shells: Vec<u32>,
}

impl Cells {
    /// Joins the sides that see each other around edges, and then across what is empty.
    pub(crate) fn new(all: &Pieces, tree: &Tree, planes: &[Plane]) -> Result<Self, Fault> {
        let count = all.pieces.len() as u32;
        let mut cells = Self { parent: (0..=2 * count).collect(), shells: Vec::new() };
        let mut surfaces = Self { parent: (0..count).collect(), shells: Vec::new() };
        for (ends, around) in pieces_around_edges(all) {
            let ordered = around_edge(all, planes, ends, around);
            for (place, &(piece, is_ahead)) in ordered.iter().enumerate() {
                // From the side that looks on to the side of the next piece that looks back.
                let (next, is_next_ahead) = ordered[(place + 1) % ordered.len()];
                cells.join(side(piece, is_ahead), side(next, !is_next_ahead));
                surfaces.join(piece, next);
            }
        }
        cells.shells = (0..2 * count).filter(|&side| cells.root(side) == side).collect();
        // From each surface a ray to the exterior: between one piece that it meets and the next there is nothing.
        for piece in (0..count).filter(|&piece| surfaces.root(piece) == piece) {
            let mut last = side(piece, true);
            for (met, times) in Ray::from(all, tree, planes, piece as usize, true)?.in_order(planes) {
                let leaves_in_front = times > 0;
                cells.join(last, side(met, !leaves_in_front));
                last = side(met, leaves_in_front);
            }
            cells.join(last, 2 * count);
        }
        Ok(cells)
    }

    /// The first side of the class of one.
    pub(crate) fn root(&self, mut side: u32) -> u32 {
        while self.parent[side as usize] != side {
            side = self.parent[side as usize];
        }
        side
    }

    /// The number of shells of bounded cells beyond the first of each.
    pub(crate) fn voids(&self) -> usize {
        let mut roots: Vec<u32> = self.shells.iter().map(|&shell| self.root(shell)).collect();
        roots.retain(|&root| root != self.exterior());
        let shells = roots.len();
        roots.sort_unstable();
        roots.dedup();
        shells - roots.len()
    }

    /// The class of the exterior.
    pub(crate) fn exterior(&self) -> u32 {
        self.root(self.parent.len() as u32 - 1)
    }

    fn join(&mut self, a: u32, b: u32) {
        let [a, b] = [self.root(a), self.root(b)];
        let [low, high] = [a.min(b), a.max(b)];
        self.parent[high as usize] = low;
        // Paths stay short.
        for side in [a, b] {
            self.parent[side as usize] = low;
        }
    }
}

/// The side of a piece in front of it, or behind it.
pub(crate) fn side(piece: u32, is_front: bool) -> u32 {
    2 * piece + u32::from(!is_front)
}

/// For each edge, its lower end first, the pieces there.
fn pieces_around_edges(all: &Pieces) -> BTreeMap<[u32; 2], Vec<u32>> {
    let mut around: BTreeMap<[u32; 2], Vec<u32>> = BTreeMap::new();
    for (number, piece) in (0..).zip(&all.pieces) {
        // Corners rise.
        let [a, b, c] = piece.corners;
        [[a, b], [b, c], [a, c]].into_iter().for_each(|ends| around.entry(ends).or_default().push(number));
    }
    around
}

/// The pieces around an edge in the order in which one that turns about it from the first one meets them, forwards seen from the front of the plane of
/// the edge and the first piece; with whether its front looks on.
fn around_edge(all: &Pieces, planes: &[Plane], [a, b]: [u32; 2], around: Vec<u32>) -> Vec<(u32, bool)> {
    let third = |piece: u32| {
        let corners = all.pieces[piece as usize].corners;
        corners.into_iter().find(|&corner| corner != a && corner != b).unwrap_or(a)
    };
    // The front of a piece looks on if its corners turn from a to b to the third one.
    let looks_on = |piece: u32| {
        let [x, y, z] = all.pieces[piece as usize].corners;
        [[x, y], [y, z], [z, x]].contains(&[a, b])
    };
    // Whether the third corner of one lies on ahead of another within half a turn, behind it, or in its plane.
    let ahead = |of: u32, other: u32| {
        let order = planes[of as usize].side(&all.vertices[third(other) as usize]);
        if looks_on(of) { order } else { order.reverse() }
    };
    let Some(&first) = around.first() else { return Vec::new() };
    // Within the first half turn, at its end, and behind it: no other piece lies in the half plane of the first, which would overlap it.
    let half = |piece: u32| match ahead(first, piece) {
        _ if piece == first => 0,
        Ordering::Greater => 1,
        Ordering::Equal => 2,
        Ordering::Less => 3,
    };
    let mut ordered = around;
    ordered.sort_by(|&p, &q| {
        half(p).cmp(&half(q)).then_with(|| if p == q { Ordering::Equal } else { ahead(p, q).reverse() })
    });
    ordered.into_iter().map(|piece| (piece, looks_on(piece))).collect()
}
