//! Edges turned inside the two faces beside them.

use super::super::mesh::HalfedgeMesh;
use coface_algebra::{EdgeId, Error, FaceId, VertexId};

impl HalfedgeMesh {
    /// Turns an edge by one corner counterclockwise: each end moves along its face to the next vertex. Between two
    /// triangles this is the other diagonal. Its faces keep their numbers and their sizes. The same face on both
    /// sides is welcome.
    ///
    /// Four flips of an edge between two triangles bring everything back, two of them turn the edge around.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] for an edge on the boundary, one with a monogon beside it, and a pendant one: there
    /// is no next corner to turn to.
    ///
    /// # Complexity
    /// The sizes of the cells at the edge.
    ///
    /// # Panics
    /// If there is no such edge.
    ///
    /// # Examples
    /// A square and its diagonals:
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut square = HalfedgeMesh::from_polygons(4, &RaggedArray::from_lists([[0, 1, 2], [0, 2, 3]]))?;
    /// let diagonal = square.edge_halfedge(EdgeId::new(2));
    /// assert_eq!([square.source(diagonal).index(), square.target(diagonal).index()], [2, 0]);
    /// square.flip_edge(EdgeId::new(2))?;
    /// assert_eq!([square.source(diagonal).index(), square.target(diagonal).index()], [3, 1]);
    /// square.flip_edge_back(EdgeId::new(2))?;
    /// assert_eq!([square.source(diagonal).index(), square.target(diagonal).index()], [2, 0]);
    /// # Ok(()) }
    /// ```
    pub fn flip_edge(&mut self, edge: EdgeId) -> Result<(), Error> {
        self.check_flip(edge)?;
        let h = self.edge_halfedge(edge).to_u32();
        let t = h ^ 1;
        // What comes after the edge on each side changes to the face on the other.
        let (after_h, after_t) = (self.next[h as usize], self.next[t as usize]);
        self.leave_corners(h);
        self.next[h as usize] = self.next[after_h as usize];
        self.next[t as usize] = self.next[after_t as usize];
        self.next[after_t as usize] = h;
        self.next[after_h as usize] = t;
        self.source[h as usize] = self.source[(after_t ^ 1) as usize];
        self.source[t as usize] = self.source[(after_h ^ 1) as usize];
        self.exchange_faces(h, after_h, after_t);
        Ok(())
    }

    /// Turns an edge by one corner clockwise: the inverse of [`Self::flip_edge`], with the same numbers.
    ///
    /// # Errors
    /// As [`Self::flip_edge`].
    ///
    /// # Complexity
    /// The sizes of the cells at the edge.
    ///
    /// # Panics
    /// If there is no such edge.
    pub fn flip_edge_back(&mut self, edge: EdgeId) -> Result<(), Error> {
        self.check_flip(edge)?;
        let h = self.edge_halfedge(edge).to_u32();
        let t = h ^ 1;
        // What comes before the edge on each side changes to the face on the other.
        let (before_h, before_t) = (self.before(h), self.before(t));
        self.leave_corners(h);
        let (end_h, end_t) = (self.before(before_h), self.before(before_t));
        self.next[h as usize] = before_t;
        self.next[t as usize] = before_h;
        self.next[end_h as usize] = h;
        self.next[end_t as usize] = t;
        self.source[h as usize] = self.source[before_h as usize];
        self.source[t as usize] = self.source[before_t as usize];
        self.exchange_faces(h, before_h, before_t);
        Ok(())
    }

    fn check_flip(&self, edge: EdgeId) -> Result<(), Error> {
        self.check_two_faces(edge, "flipped")?;
        let h = self.edge_halfedge(edge).to_u32();
        for side in [h, h ^ 1] {
            let after = self.next[side as usize];
            if after == side {
                return Err(Error::invalid(format!(
                    "face {} beside edge {edge} is a monogon, so there is no other corner to flip the edge to",
                    FaceId::from_u32(self.face[side as usize])
                ))
                .with_cure("split the edge first"));
            }
            if after == side ^ 1 {
                return Err(Error::invalid(format!(
                    "edge {edge} is pendant: no other edge ends at {}",
                    VertexId::from_u32(self.source[after as usize])
                ))
                .with_cure("remove it, or name an edge with others at both ends"));
            }
        }
        Ok(())
    }

    /// Takes an edge out of the order of halfedges around its ends, which keep a first halfedge. The edge is neither
    /// pendant nor around a monogon.
    fn leave_corners(&mut self, h: u32) {
        let t = h ^ 1;
        let (before_h, before_t) = (self.before(h), self.before(t));
        let (after_h, after_t) = (self.next[h as usize], self.next[t as usize]);
        self.next[before_h as usize] = after_t;
        self.next[before_t as usize] = after_h;
        for (old, new) in [(h, after_t), (t, after_h)] {
            let first = &mut self.vertex_halfedge[self.source[old as usize] as usize];
            if *first == old {
                *first = new;
            }
        }
    }

    /// Gives the face of h to `of_twin`, that of its twin to `of_h`, and the faces another first halfedge where needed.
    fn exchange_faces(&mut self, h: u32, of_h: u32, of_twin: u32) {
        let faces = [h, h ^ 1].map(|side| self.face[side as usize]);
        for (side, lost, face) in [(h, of_h, faces[0]), (h ^ 1, of_twin, faces[1])] {
            let first = &mut self.face_halfedge[face as usize];
            if *first == lost {
                *first = side;
            }
        }
        self.face[of_h as usize] = faces[1];
        self.face[of_twin as usize] = faces[0];
    }
}
