//! A vertex inside a face.

use super::super::mesh::HalfedgeMesh;
use super::Renumbering;
use coface_algebra::{EdgeId, Error, FaceId, VertexId};
use std::ops::Range;

/// What [`HalfedgeMesh::poke_face`] made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FacePoke {
    vertex: VertexId,
    edges: Range<u32>,
    faces: Range<u32>,
    renumbering: Renumbering,
}

impl FacePoke {
    /// The vertex inside.
    pub fn vertex(&self) -> VertexId {
        self.vertex
    }

    /// The added edges, from the vertex to the corners of the face: first to the source of its first halfedge.
    pub fn edges(&self) -> impl ExactSizeIterator<Item = EdgeId> + use<> {
        self.edges.clone().map(EdgeId::from_u32)
    }

    /// The added faces, in the order of the halfedges of the face after its first, which stays on the face itself.
    pub fn faces(&self) -> impl ExactSizeIterator<Item = FaceId> + use<> {
        self.faces.clone().map(FaceId::from_u32)
    }

    /// The outer faces that got other numbers.
    pub fn renumbering(&self) -> &Renumbering {
        &self.renumbering
    }
}

impl HalfedgeMesh {
    /// Puts a vertex inside a face and joins it to each corner: the face becomes as many triangles as it has sides. In a
    /// monogon the one added edge is pendant.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] for an outer face; [`coface_algebra::ErrorKind::TooLarge`] from 2^31 halfedges on.
    ///
    /// # Complexity
    /// The size of the face, and of the outer faces that get other numbers.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// The square torus as four triangles:
    /// ```
    /// use coface_algebra::FaceId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// let poke = torus.poke_face(FaceId::new(0))?;
    /// assert_eq!(torus.f_vector(), [2, 6, 4]);
    /// assert_eq!(torus.degree(poke.vertex()), 4);
    /// # Ok(()) }
    /// ```
    pub fn poke_face(&mut self, face: FaceId) -> Result<FacePoke, Error> {
        let rim: Vec<u32> = self.face_halfedges(face).map(|h| h.to_u32()).collect();
        self.check_inner(face.to_u32(), "a vertex cannot be put into")?;
        self.check_room(1, rim.len())?;
        let vertex = self.vertex_halfedge.len() as u32;
        let first = self.next.len() as u32;
        self.vertex_halfedge.push(first);
        for &h in &rim {
            self.push_edge(vertex, self.source[h as usize]);
        }
        let mut renumbering = Renumbering::default();
        let added = self.push_faces(&rim[1..], &mut renumbering);
        for (i, &h) in rim.iter().enumerate() {
            let triangle = if i == 0 { face.to_u32() } else { added + i as u32 - 1 };
            let after = if i + 1 == rim.len() { 0 } else { i + 1 };
            // Along the rim, in from the next corner, out to this one.
            let (inward, outward) = (first + 2 * after as u32 + 1, first + 2 * i as u32);
            for (at, next) in [(h, inward), (inward, outward), (outward, h)] {
                self.next[at as usize] = next;
                self.face[at as usize] = triangle;
            }
        }
        let count = rim.len() as u32;
        Ok(FacePoke {
            vertex: VertexId::from_u32(vertex),
            edges: first / 2..first / 2 + count,
            faces: added..added + count - 1,
            renumbering,
        })
    }
}
