//! Two parts of the faces at a vertex that touch in it alone: which corners of cells lie between them.

use super::pieces::Kept;
use crate::spatial::SpatialArrangement;
use crate::spatial::predicates::SpatialPredicates;
use coface_algebra::{EdgeId, FaceId, Sign, VertexId};
use std::cmp::Ordering;

/// The corner of a face at a vertex: the fine vertices next to it on the two sides that meet there.
#[derive(Clone, Copy)]
struct Corner {
    face: u32,
    /// The edges of the two sides.
    edges: [u32; 2],
    beside: [u32; 2],
}

/// The half-faces of two parts that see each other at a vertex, one of each part; `None` where that cannot be told.
///
/// On a small sphere around the vertex the parts are two closed curves, of arcs less than a half turn, that do not meet. An
/// arc from a node of one to a node of the other that crosses neither lies between them. Where the vertex is inside of a
/// face, one of the curves is a great circle.
pub(super) fn facing_halves(
    arrangement: &SpatialArrangement,
    kept: &Kept,
    vertex: u32,
    faces: [&[u32]; 2],
) -> Option<[u32; 2]> {
    let predicates = arrangement.fine_triangles().predicates();
    let fine = arrangement.fine_vertex(VertexId::from_u32(vertex)).to_u32();
    let mut around = Around { arrangement, kept, vertex, fine, predicates, nodes: Vec::new() };
    match faces.map(|own| around.face_around(own)) {
        [None, None] => {}
        [Some(face), None] => return around.facing_face(face, faces[1]),
        [None, Some(face)] => return around.facing_face(face, faces[0]),
        [Some(_), Some(_)] => return None,
    }
    let corners = [around.corners(faces[0])?, around.corners(faces[1])?];
    around.nodes = corners.iter().flatten().flat_map(|corner| corner.beside).collect();
    for own in &corners[0] {
        for other in &corners[1] {
            let ends = [own.beside[0], other.beside[0]];
            if around.off(ends[0], ends[1]).is_some()
                && corners.iter().flatten().all(|corner| around.lets_pass(corner, ends))
            {
                let first = around.half_towards(own.edges[0], ends[0], ends[1], &corners[0])?;
                let second = around.half_towards(other.edges[0], ends[1], ends[0], &corners[1])?;
                return Some([first, second]);
            }
        }
    }
    None
}

struct Around<'a, P> {
    arrangement: &'a SpatialArrangement,
    kept: &'a Kept,
    vertex: u32,
    fine: u32,
    predicates: P,
    /// The fine vertices next to the vertex.
    nodes: Vec<u32>,
}

impl<P: SpatialPredicates> Around<'_, P> {
    fn det(&self, x: u32, y: u32, z: u32) -> Ordering {
        self.predicates.orientation([self.fine, x, y, z])
    }

    /// The only one of these faces, if the vertex is inside of it.
    fn face_around(&self, faces: &[u32]) -> Option<u32> {
        let &[face] = faces else { return None };
        self.fine_vertices(face).all(|fine| fine != self.fine).then_some(face)
    }

    /// The fine vertices that sides of a face begin at.
    fn fine_vertices(&self, face: u32) -> impl Iterator<Item = u32> {
        let complex = self.arrangement.complex();
        let list = complex.packed_sides().list(face as usize).iter();
        list.map(|&side| {
            self.arrangement.fine_vertex(VertexId::from_u32(complex.side_ends(side)[0])).to_u32()
        })
    }

    /// [`facing_halves`] of a face that the vertex is inside of, and of other faces at the vertex, which are on one side of
    /// it.
    fn facing_face(&mut self, face: u32, others: &[u32]) -> Option<[u32; 2]> {
        let corners = self.corners(others)?;
        let circle: Vec<u32> = self.fine_vertices(face).collect();
        self.nodes = corners.iter().flat_map(|corner| corner.beside).chain(circle.iter().copied()).collect();
        let view = self.arrangement.view(FaceId::from_u32(face));
        for own in &corners {
            let from = own.beside[0];
            let is_free = |&&to: &&u32| {
                self.off(from, to).is_some()
                    && corners.iter().all(|corner| self.lets_pass(corner, [from, to]))
            };
            let Some(&to) = circle.iter().find(is_free) else { continue };
            let (turn, &next) = circle
                .iter()
                .map(|next| (view.turn(&self.predicates, [self.fine, to, *next]), next))
                .find(|(turn, _)| turn.is_ne())?;
            // Seen from the front both turn the same way.
            let is_in_front = self.det(from, to, next) == turn;
            let half = self.half_towards(own.edges[0], from, to, &corners)?;
            return Some([2 * face + u32::from(is_in_front), half]);
        }
        None
    }

    /// The corners at the vertex of these faces; `None` if a face has several there, or one of a half turn or more.
    fn corners(&self, faces: &[u32]) -> Option<Vec<Corner>> {
        let complex = self.arrangement.complex();
        let mut corners = Vec::with_capacity(faces.len());
        for &face in faces {
            let list = complex.packed_sides().list(face as usize);
            let mut coming = list.iter().filter(|&&side| complex.side_ends(side)[1] == self.vertex);
            let mut leaving = list.iter().filter(|&&side| complex.side_ends(side)[0] == self.vertex);
            let (Some(&a), None, Some(&b), None) =
                (coming.next(), coming.next(), leaving.next(), leaving.next())
            else {
                return None;
            };
            let beside = [self.beside(a >> 1), self.beside(b >> 1)];
            let view = self.arrangement.view(FaceId::from_u32(face));
            if view.turn(&self.predicates, [beside[0], self.fine, beside[1]]).is_le() {
                return None;
            }
            corners.push(Corner { face, edges: [a >> 1, b >> 1], beside });
        }
        Some(corners)
    }

    /// The fine vertex next to the vertex on an edge.
    fn beside(&self, edge: u32) -> u32 {
        let fine = self.arrangement.fine().complex();
        let mut own = self.arrangement.fine_edges(EdgeId::from_u32(edge));
        let begins = self.arrangement.complex().edges()[edge as usize][0] == self.vertex;
        let (edge, _) = if begins { own.next() } else { own.last() }.expect("an edge has pieces");
        let [a, b] = fine.edges()[edge.index()];
        if a == self.fine { b } else { a }
    }

    /// A direction off the great circle of two others; `None` if these are opposite.
    fn off(&self, u: u32, w: u32) -> Option<u32> {
        self.nodes.iter().copied().find(|&n| self.det(u, w, n).is_ne())
    }

    /// Whether a direction is on the arc between two others.
    fn is_on_arc(&self, p: u32, [u, w]: [u32; 2]) -> bool {
        self.det(u, p, w).is_eq()
            && self.off(u, w).is_some_and(|n| {
                let sign = self.det(u, w, n);
                self.det(u, p, n) == sign && self.det(p, w, n) == sign
            })
    }

    /// Whether the arc between two nodes, which are not opposite, misses that of a corner, which may have one of them for an end.
    fn lets_pass(&self, corner: &Corner, [u, w]: [u32; 2]) -> bool {
        let [p, q] = corner.beside;
        if p == u || p == w || q == u || q == w {
            let (shared, other) = if p == u || p == w { (p, q) } else { (q, p) };
            let far = if shared == u { w } else { u };
            // Both go away from the node that they have in common, perhaps on one circle.
            return !self.is_on_arc(other, [shared, far]) && !self.is_on_arc(far, [shared, other]);
        }
        let touches = self.is_on_arc(p, [u, w])
            || self.is_on_arc(q, [u, w])
            || self.is_on_arc(u, [p, q])
            || self.is_on_arc(w, [p, q]);
        let signs = [self.det(u, p, w), self.det(p, w, q), self.det(w, q, u), self.det(q, u, p)];
        let crosses = signs[0].is_ne() && signs.iter().all(|sign| *sign == signs[0]);
        !touches && !crosses
    }

    /// The half-face that sees a direction from an edge, which leads to the fine vertex u.
    fn half_towards(&self, edge: u32, u: u32, towards: u32, corners: &[Corner]) -> Option<u32> {
        let arrangement = self.arrangement;
        let (fine, along) = arrangement.fine_edges(EdgeId::from_u32(edge)).next()?;
        // Directions of the faces around the edge, as they lie there, with the half-face on the side where the list begins.
        let mut list: Vec<(u32, u32)> = Vec::new();
        for &side in arrangement.fine().radial_order().list(fine.index()) {
            let packed = self.kept.faces_of_fine[(side >> 1) as usize];
            if !self.kept.is_kept[(packed >> 1) as usize] {
                continue;
            }
            let corner =
                corners.iter().find(|corner| corner.face == packed >> 1 && corner.edges.contains(&edge))?;
            let [p, q] = corner.beside;
            list.push((if corner.edges[0] == edge { q } else { p }, packed ^ (side & 1)));
        }
        // The order is counterclockwise seen from where the first fine edge ends; here it is seen from u.
        let leads_away =
            (arrangement.complex().edges()[edge as usize][0] == self.vertex) == (along == Sign::Plus);
        let count = list.len();
        (0..count).find_map(|i| {
            let (from, before) = list[i];
            let (to, _) = list[(i + 1) % count];
            let [from, to] = if leads_away { [from, to] } else { [to, from] };
            let is_between = if from == to { true } else { self.is_between(u, from, towards, to)? };
            is_between.then_some(before ^ 1)
        })
    }

    /// Whether a direction is met on the way from one to another, counterclockwise seen from u; `None` if it is on a
    /// level with one of them.
    fn is_between(&self, u: u32, from: u32, middle: u32, to: u32) -> Option<bool> {
        // The part of a turn from the first: none, less than a half, a half, more.
        let part = |x: u32| -> Option<u8> {
            Some(match self.det(u, from, x) {
                Ordering::Greater => 1,
                Ordering::Less => 3,
                Ordering::Equal => {
                    let n = self.off(u, from)?;
                    if self.det(u, from, n) == self.det(u, x, n) { 0 } else { 2 }
                }
            })
        };
        let (middle_part, end_part) = (part(middle)?, part(to)?);
        match middle_part.cmp(&end_part) {
            _ if middle_part == 0 => None,
            Ordering::Less => Some(true),
            Ordering::Greater => Some(false),
            Ordering::Equal => match self.det(u, middle, to) {
                Ordering::Greater => Some(true),
                Ordering::Less => Some(false),
                Ordering::Equal => None,
            },
        }
    }
}
