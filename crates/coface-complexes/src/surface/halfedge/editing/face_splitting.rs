//! An edge across a face, and its removal.

use super::super::mesh::HalfedgeMesh;
use super::Renumbering;
use coface_algebra::{EdgeId, Error, FaceId, HalfedgeId};

/// What [`HalfedgeMesh::split_face`] made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FaceSplit {
    edge: EdgeId,
    face: FaceId,
    renumbering: Renumbering,
}

impl FaceSplit {
    /// The added edge, from the first corner to the second.
    pub fn edge(&self) -> EdgeId {
        self.edge
    }

    /// The added face, to the left of the added edge.
    pub fn face(&self) -> FaceId {
        self.face
    }

    /// The outer face that got another number, if there is one.
    pub fn renumbering(&self) -> &Renumbering {
        &self.renumbering
    }
}

/// What [`HalfedgeMesh::remove_edge`] left.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EdgeRemoval {
    face: FaceId,
    corners: [HalfedgeId; 2],
    renumbering: Renumbering,
}

impl EdgeRemoval {
    /// The face that the two faces at the edge are now.
    pub fn face(&self) -> FaceId {
        self.face
    }

    /// The corners between which [`HalfedgeMesh::split_face`] puts the edge again.
    pub fn corners(&self) -> [HalfedgeId; 2] {
        self.corners
    }

    /// The cells that got other numbers.
    pub fn renumbering(&self) -> &Renumbering {
        &self.renumbering
    }
}

impl HalfedgeMesh {
    /// Splits a face by an edge from the corner of one of its halfedges to the corner of another. The added face lies to
    /// the left of the added edge and starts with it. From a corner to itself the edge is a loop around a monogon.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] when the halfedges are on different faces or on an outer one;
    /// [`coface_algebra::ErrorKind::TooLarge`] from 2^31 halfedges on.
    ///
    /// # Complexity
    /// The size of the face, and of the outer face that moves to the end.
    ///
    /// # Panics
    /// If there is no such halfedge.
    ///
    /// # Examples
    /// A diagonal of the square torus:
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// let split = torus.split_face(HalfedgeId::new(0), HalfedgeId::new(1))?;
    /// assert_eq!(torus.f_vector(), [1, 3, 2]);
    /// assert_eq!(torus.face_halfedges(split.face()).count(), 3);
    /// assert_eq!(torus.remove_edge(split.edge())?.face().index(), 0);
    /// # Ok(()) }
    /// ```
    pub fn split_face(&mut self, from: HalfedgeId, to: HalfedgeId) -> Result<FaceSplit, Error> {
        let (face, other) = (self.face(from), self.face(to));
        if face != other {
            return Err(Error::invalid(format!(
                "{from} and {to} are on different faces, {face} and {other}, so no edge across a face joins their corners"
            )));
        }
        self.check_inner(face.to_u32(), "an edge cannot split")?;
        self.check_room(0, 1)?;
        let (x, y) = (from.to_u32(), to.to_u32());
        let (before_x, before_y) = (self.before(x), self.before(y));
        let a = self.push_edge(self.source[x as usize], self.source[y as usize]);
        let b = a ^ 1;
        if x == y {
            self.next[before_x as usize] = b;
            self.next[a as usize] = a;
        } else {
            self.next[before_x as usize] = a;
            self.next[a as usize] = y;
            self.next[before_y as usize] = b;
        }
        self.next[b as usize] = x;
        self.face[b as usize] = face.to_u32();
        let mut renumbering = Renumbering::default();
        let added = self.push_faces(&[a], &mut renumbering);
        self.paint(a, added);
        let first = &mut self.face_halfedge[face.index()];
        if self.face[*first as usize] == added {
            *first = b;
        }
        Ok(FaceSplit { edge: EdgeId::from_u32(a >> 1), face: FaceId::from_u32(added), renumbering })
    }

    /// Removes an edge between two different faces, which become one: the one with the smaller number. The inverse of
    /// [`Self::split_face`].
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] for an edge on the boundary, an edge with the same face on both sides, and the only
    /// edge of a component.
    ///
    /// # Complexity
    /// The sizes of the two faces and of the cells around those that get other numbers.
    ///
    /// # Panics
    /// If there is no such edge.
    pub fn remove_edge(&mut self, edge: EdgeId) -> Result<EdgeRemoval, Error> {
        let h = self.edge_halfedge(edge).to_u32();
        let t = h ^ 1;
        let (face, other) = (self.face[h as usize], self.face[t as usize]);
        self.check_two_faces(edge, "removed")?;
        let (after_h, after_t) = (self.next[h as usize], self.next[t as usize]);
        if face == other {
            let error = Error::invalid(format!(
                "face {} is on both sides of edge {edge}; without the edge it is no disk",
                FaceId::from_u32(face)
            ));
            return Err(if after_h == t || after_t == h {
                error.with_cure("the edge is pendant: remove it with its end")
            } else {
                error
            });
        }
        if after_h == h && after_t == t {
            return Err(Error::invalid(format!(
                "edge {edge} is the only one of its component, a sphere, and a face needs an edge"
            )));
        }
        let mut renumbering = Renumbering::default();
        let kept = face.min(other);
        let corners = self.merge_faces(h, kept, &mut renumbering).map(HalfedgeId::from_u32);
        Ok(EdgeRemoval { face: FaceId::from_u32(kept), corners, renumbering })
    }

    /// Removes the edge of h, which lies between two different faces, not both monogons; gives the corners where it was. The
    /// face `kept` stays.
    pub(super) fn merge_faces(&mut self, h: u32, kept: u32, renumbering: &mut Renumbering) -> [u32; 2] {
        let t = h ^ 1;
        let faces = [self.face[h as usize], self.face[t as usize]];
        let (after_h, after_t) = (self.next[h as usize], self.next[t as usize]);
        let gone = faces[0] ^ faces[1] ^ kept;
        self.paint(if faces[0] == gone { h } else { t }, kept);
        let (before_h, before_t) = (self.before(h), self.before(t));
        // A monogon on one side goes with its loop.
        let (corner_h, corner_t) = if before_h == h {
            self.next[before_t as usize] = after_t;
            (after_t, after_t)
        } else if before_t == t {
            self.next[before_h as usize] = after_h;
            (after_h, after_h)
        } else {
            self.next[before_h as usize] = after_t;
            self.next[before_t as usize] = after_h;
            (after_t, after_h)
        };
        for (old, new) in [(h, corner_h), (t, corner_t)] {
            let first = &mut self.vertex_halfedge[self.source[old as usize] as usize];
            if *first == old {
                *first = new;
            }
        }
        let first = &mut self.face_halfedge[kept as usize];
        if *first >> 1 == h >> 1 {
            *first = corner_h;
        }
        let edge_moves = renumbering.edges().len();
        self.swap_remove_edge(h >> 1, renumbering);
        self.swap_remove_face(gone, renumbering);
        [corner_h, corner_t].map(|corner| renumbering.halfedge(corner, edge_moves))
    }

    /// Refuses an edge on the boundary.
    pub(super) fn check_two_faces(&self, edge: EdgeId, done: &str) -> Result<(), Error> {
        if self.is_boundary_edge(edge) {
            return Err(Error::invalid(format!(
                "edge {edge} lies on the boundary, in one face only, and cannot be {done}"
            ))
            .with_cure("name an edge between two faces"));
        }
        Ok(())
    }
}
