//! Circulators: the cells around a cell of a halfedge mesh, in order.

use super::mesh::HalfedgeMesh;
use coface_algebra::{EdgeId, FaceId, HalfedgeId, VertexId};

/// The halfedges around a face or a vertex, or along a boundary loop.
struct Circulator<F> {
    at: Option<u32>,
    first: u32,
    step: F,
}

impl<F: Fn(u32) -> u32> Iterator for Circulator<F> {
    type Item = HalfedgeId;

    #[inline]
    fn next(&mut self) -> Option<HalfedgeId> {
        let at = self.at?;
        let next = (self.step)(at);
        self.at = (next != self.first).then_some(next);
        Some(HalfedgeId::from_u32(at))
    }
}

fn circulator<F: Fn(u32) -> u32>(first: Option<HalfedgeId>, step: F) -> Circulator<F> {
    let at = first.map(|first| first.to_u32());
    Circulator { at, first: at.unwrap_or_default(), step }
}

impl HalfedgeMesh {
    /// The halfedges around a face from its first one on, in the direction of the face: counterclockwise. Around an outer
    /// face they run along the boundary loop with the surface on their right.
    ///
    /// # Panics
    /// If there is no such face; so do the functions that follow if there is no such cell.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// use coface_algebra::FaceId;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 4, 5, 0, 1])?;
    /// let around: Vec<usize> = torus.face_halfedges(FaceId::new(1)).map(|h| h.index()).collect();
    /// assert_eq!(around, [1, 3, 5]);
    /// # Ok(()) }
    /// ```
    pub fn face_halfedges(&self, face: FaceId) -> impl Iterator<Item = HalfedgeId> + '_ {
        circulator(Some(self.face_halfedge(face)), |h| self.next[h as usize])
    }

    /// The edges around a face, counterclockwise from that of its first halfedge on; one that the face runs along twice is
    /// there twice.
    pub fn face_edges(&self, face: FaceId) -> impl Iterator<Item = EdgeId> + '_ {
        self.face_halfedges(face).map(|h| self.edge(h))
    }

    /// The vertices around a face, counterclockwise from the source of its first halfedge on, once for each corner.
    pub fn face_vertices(&self, face: FaceId) -> impl Iterator<Item = VertexId> + '_ {
        self.face_halfedges(face).map(|h| self.source(h))
    }

    /// The faces across the edges of a face, counterclockwise, outer faces included; one for each halfedge, so a face may
    /// be there several times, and be its own neighbor.
    pub fn adjacent_faces(&self, face: FaceId) -> impl Iterator<Item = FaceId> + '_ {
        self.face_halfedges(face).map(|h| self.face(self.twin(h)))
    }

    /// The halfedges that leave a vertex, clockwise: after h comes the next of its twin. They start with
    /// [`Self::vertex_halfedge`], at a boundary vertex the outer one, so that the corners that follow are one fan. A loop
    /// leaves its vertex with both halfedges.
    ///
    /// # Examples
    /// A square cut by a diagonal: clockwise from the outer halfedge around one end of the diagonal.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// use coface_algebra::VertexId;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mesh = HalfedgeMesh::from_polygons(4, &RaggedArray::from_lists([[0, 1, 2], [0, 2, 3]]))?;
    /// let leaving = mesh.halfedges_leaving(VertexId::new(0));
    /// let targets: Vec<usize> = leaving.map(|h| mesh.target(h).index()).collect();
    /// assert_eq!(targets, [3, 2, 1]);
    /// # Ok(()) }
    /// ```
    pub fn halfedges_leaving(&self, vertex: VertexId) -> impl Iterator<Item = HalfedgeId> + '_ {
        circulator(self.vertex_halfedge(vertex), |h| self.next[(h ^ 1) as usize])
    }

    /// The halfedges that enter a vertex, clockwise: the twins of those that leave it, in their order.
    pub fn halfedges_entering(&self, vertex: VertexId) -> impl Iterator<Item = HalfedgeId> + '_ {
        self.halfedges_leaving(vertex).map(|h| self.twin(h))
    }

    /// The edges at a vertex, clockwise as [`Self::halfedges_leaving`]; a loop is there twice.
    pub fn vertex_edges(&self, vertex: VertexId) -> impl Iterator<Item = EdgeId> + '_ {
        self.halfedges_leaving(vertex).map(|h| self.edge(h))
    }

    /// The other ends of the edges at a vertex, clockwise as [`Self::halfedges_leaving`]; the vertex itself for a loop,
    /// and a neighbor once for each edge to it.
    pub fn adjacent_vertices(&self, vertex: VertexId) -> impl Iterator<Item = VertexId> + '_ {
        self.halfedges_leaving(vertex).map(|h| self.target(h))
    }

    /// The faces at a vertex, once for each corner, outer ones left out: clockwise, on the boundary from one side of the fan
    /// to the other.
    pub fn vertex_faces(&self, vertex: VertexId) -> impl Iterator<Item = FaceId> + '_ {
        self.halfedges_leaving(vertex).map(|h| self.face(h)).filter(|&face| !self.is_outer(face))
    }

    /// The number of edges at a vertex, loops counted twice.
    ///
    /// # Complexity
    /// Linear in the answer.
    pub fn degree(&self, vertex: VertexId) -> usize {
        self.halfedges_leaving(vertex).count()
    }

    /// All halfedges.
    pub fn halfedges(&self) -> impl ExactSizeIterator<Item = HalfedgeId> + use<> {
        (0..self.halfedge_count()).map(HalfedgeId::new)
    }

    /// The outer faces: one for each boundary loop.
    ///
    /// # Examples
    /// An annulus of four quadrangles:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let ring = [[0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]];
    /// let mesh = HalfedgeMesh::from_polygons(8, &RaggedArray::from_lists(ring))?;
    /// let loops: Vec<Vec<usize>> = mesh
    ///     .outer_faces()
    ///     .map(|face| mesh.boundary_loop(face).map(|h| mesh.source(h).index()).collect())
    ///     .collect();
    /// assert_eq!(loops, [[0, 1, 2, 3], [5, 4, 7, 6]]);
    /// # Ok(()) }
    /// ```
    pub fn outer_faces(&self) -> impl ExactSizeIterator<Item = FaceId> + use<> {
        (self.face_count()..self.face_count() + self.outer_face_count()).map(FaceId::new)
    }

    /// The halfedges along the boundary loop of an outer face that have the surface on their left, in their direction:
    /// against that of the outer face. They start with the twin of its first halfedge.
    ///
    /// # Complexity
    /// The number of halfedges at its vertices.
    ///
    /// # Panics
    /// If the face is not an outer one.
    pub fn boundary_loop(&self, outer: FaceId) -> impl Iterator<Item = HalfedgeId> + '_ {
        assert!(self.is_outer(outer), "{outer} is an outer face");
        circulator(Some(self.twin(self.face_halfedge(outer))), |h| {
            // Around the target to the next halfedge whose right side is outer.
            let mut at = self.next[h as usize];
            while !self.is_outer_halfedge(HalfedgeId::from_u32(at ^ 1)) {
                at = self.next[(at ^ 1) as usize];
            }
            at
        })
    }
}
