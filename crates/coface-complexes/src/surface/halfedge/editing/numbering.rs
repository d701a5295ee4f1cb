//! Room for new cells, and the numbers of cells that are gone.

use super::super::mesh::{HalfedgeMesh, LIMIT, NONE};
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, VertexId};

/// The cells that got other numbers in an operation.
///
/// Each move is (from, to), in the order in which they happened; the number that a cell moves to is free by then, because
/// the cell that had it is removed or has moved. So data on cells follow by copying entry `from` to entry `to`, move by
/// move, after room is made for added cells; the entries left over at the end are those of no cell. The halfedges 2e and
/// 2e + 1 move with their edge e.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Renumbering {
    vertices: Vec<(VertexId, VertexId)>,
    edges: Vec<(EdgeId, EdgeId)>,
    faces: Vec<(FaceId, FaceId)>,
}

impl Renumbering {
    /// The vertices that moved.
    pub fn vertices(&self) -> &[(VertexId, VertexId)] {
        &self.vertices
    }

    /// The edges that moved.
    pub fn edges(&self) -> &[(EdgeId, EdgeId)] {
        &self.edges
    }

    /// The faces that moved, outer ones included.
    pub fn faces(&self) -> &[(FaceId, FaceId)] {
        &self.faces
    }

    /// Whether all cells kept their numbers.
    pub fn is_empty(&self) -> bool {
        self.vertices.is_empty() && self.edges.is_empty() && self.faces.is_empty()
    }

    /// The number that a halfedge has after the moves of edges from this one on.
    pub(super) fn halfedge(&self, mut halfedge: u32, since: usize) -> u32 {
        for &(from, to) in &self.edges[since..] {
            if halfedge >> 1 == from.to_u32() {
                halfedge = to.to_u32() << 1 | (halfedge & 1);
            }
        }
        halfedge
    }
}

impl HalfedgeMesh {
    /// Refuses when so many more vertices and edges do not fit.
    pub(super) fn check_room(&self, vertices: usize, edges: usize) -> Result<(), Error> {
        if self.next.len() + 2 * edges >= LIMIT || self.vertex_halfedge.len() + vertices >= NONE as usize {
            return Err(Error::new(
                ErrorKind::TooLarge,
                "a halfedge mesh has fewer than 2^31 halfedges and 2^32 - 1 vertices",
            ));
        }
        Ok(())
    }

    /// Refuses an outer face.
    pub(super) fn check_inner(&self, face: u32, what: &str) -> Result<(), Error> {
        if (face as usize) < self.face_count {
            return Ok(());
        }
        let face = FaceId::from_u32(face);
        Err(Error::invalid(format!("{what} face {face}, which is outer: it fills a hole of the surface"))
            .with_cure("name cells of the surface itself"))
    }

    /// The halfedge before this one as a plain number.
    pub(super) fn before(&self, halfedge: u32) -> u32 {
        self.previous(coface_algebra::HalfedgeId::from_u32(halfedge)).to_u32()
    }

    /// An edge between these vertices that is on no face yet; gives its halfedge from the first of them.
    pub(super) fn push_edge(&mut self, source: u32, target: u32) -> u32 {
        let halfedge = self.next.len() as u32;
        self.next.extend([NONE; 2]);
        self.source.extend([source, target]);
        self.face.extend([NONE; 2]);
        halfedge
    }

    /// Puts faces with these first halfedges after those that are not outer, without halfedges on them; the outer faces
    /// make room. Gives the number of the first.
    pub(super) fn push_faces(&mut self, firsts: &[u32], renumbering: &mut Renumbering) -> u32 {
        let (start, outer) = (self.face_count, self.face_halfedge.len() - self.face_count);
        let added = firsts.len();
        self.face_count += added;
        self.face_halfedge.splice(start..start, firsts.iter().copied());
        if outer > 0 {
            // As often as a face is added, the first outer face goes to the end.
            self.face_halfedge[self.face_count..].rotate_left(added % outer);
            for place in 0..outer {
                let (from, to) = (start + (place + added % outer) % outer, self.face_count + place);
                if from != to {
                    self.paint(self.face_halfedge[to], to as u32);
                    renumbering.faces.push((FaceId::new(from), FaceId::new(to)));
                }
            }
        }
        start as u32
    }

    /// Gives a face to the halfedges from this one on around `next`.
    pub(super) fn paint(&mut self, halfedge: u32, face: u32) {
        let mut at = halfedge;
        loop {
            self.face[at as usize] = face;
            at = self.next[at as usize];
            if at == halfedge {
                return;
            }
        }
    }

    /// Gives a source to the halfedges from `first` on around "twin, then next" up to before `end`.
    pub(super) fn move_sources(&mut self, first: u32, end: u32, vertex: u32) {
        let mut at = first;
        loop {
            self.source[at as usize] = vertex;
            at = self.next[(at ^ 1) as usize];
            if at == end {
                return;
            }
        }
    }

    /// Removes an edge whose halfedges nothing refers to any more.
    pub(super) fn swap_remove_edge(&mut self, edge: u32, renumbering: &mut Renumbering) {
        let last = (self.next.len() / 2 - 1) as u32;
        if edge != last {
            let moved = |h: u32| if h >> 1 == last { edge << 1 | (h & 1) } else { h };
            let old = [last << 1, last << 1 | 1];
            let before = old.map(|h| self.before(h));
            for h in old {
                let new = moved(h);
                self.next[new as usize] = moved(self.next[h as usize]);
                self.source[new as usize] = self.source[h as usize];
                self.face[new as usize] = self.face[h as usize];
                let vertex_first = &mut self.vertex_halfedge[self.source[h as usize] as usize];
                *vertex_first = moved(*vertex_first);
                let face_first = &mut self.face_halfedge[self.face[h as usize] as usize];
                *face_first = moved(*face_first);
            }
            for (h, before) in old.into_iter().zip(before) {
                self.next[moved(before) as usize] = moved(h);
            }
            renumbering.edges.push((EdgeId::from_u32(last), EdgeId::from_u32(edge)));
        }
        self.next.truncate(2 * last as usize);
        self.source.truncate(2 * last as usize);
        self.face.truncate(2 * last as usize);
    }

    /// Removes a vertex that no halfedge leaves any more.
    pub(super) fn swap_remove_vertex(&mut self, vertex: u32, renumbering: &mut Renumbering) {
        let last = (self.vertex_halfedge.len() - 1) as u32;
        if vertex != last {
            let first = self.vertex_halfedge[last as usize];
            if first != NONE {
                self.move_sources(first, first, vertex);
            }
            renumbering.vertices.push((VertexId::from_u32(last), VertexId::from_u32(vertex)));
        }
        self.vertex_halfedge.swap_remove(vertex as usize);
    }

    /// Removes a face, not an outer one, that no halfedge is on any more.
    pub(super) fn swap_remove_face(&mut self, face: u32, renumbering: &mut Renumbering) {
        self.face_count -= 1;
        let last = self.face_count as u32;
        if face != last {
            let first = self.face_halfedge[last as usize];
            self.face_halfedge[face as usize] = first;
            self.paint(first, face);
            renumbering.faces.push((FaceId::from_u32(last), FaceId::from_u32(face)));
        }
        self.face_halfedge.swap_remove(last as usize);
        if let Some(&first) = self.face_halfedge.get(last as usize) {
            let from = FaceId::new(self.face_halfedge.len());
            self.paint(first, last);
            renumbering.faces.push((from, FaceId::from_u32(last)));
        }
    }
}
