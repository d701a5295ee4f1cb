//! Outer faces: flagged in a closed mesh, or filled into the boundary loops of an open one.

use super::mesh::{HalfedgeMesh, NONE};
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, VertexId};
use rayon::prelude::*;

impl HalfedgeMesh {
    /// The same mesh with these faces declared outer: the surface without them, which has their rims as its boundary.
    ///
    /// The other faces keep their order; the outer ones follow in the order given, after those that are outer already.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming a face that does not exist, is given twice or is outer already;
    /// [`ErrorKind::NonManifold`] naming an edge that would lie in no face, or a vertex where two fans would meet.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// A loop between two monogons; one of them outer leaves a disk.
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// use coface_algebra::FaceId;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let disk = HalfedgeMesh::from_next(vec![0, 1])?.with_outer_faces(&[FaceId::new(0)])?;
    /// assert_eq!((disk.f_vector(), disk.outer_face_count()), (vec![1, 1, 1], 1));
    /// assert_eq!(disk.surface().map(|surface| surface.to_string()).as_deref(), Some("disk"));
    /// # Ok(()) }
    /// ```
    pub fn with_outer_faces(mut self, faces: &[FaceId]) -> Result<Self, Error> {
        let mut is_outer = vec![false; self.face_count];
        for &face in faces {
            match is_outer.get_mut(face.index()) {
                Some(outer) if !*outer => *outer = true,
                Some(_) => return Err(Error::invalid(format!("face {face} is given twice"))),
                None if face.index() < self.face_halfedge.len() => {
                    return Err(Error::invalid(format!("face {face} is outer already")));
                }
                None => {
                    return Err(Error::invalid(format!(
                        "face {face} is to be outer, but there are {} faces",
                        self.face_count
                    )));
                }
            }
        }
        // Faces that stay, faces that are outer already, faces that become outer.
        let kept = (0..self.face_count).filter(|&face| !is_outer[face]);
        let old: Vec<usize> = kept
            .chain(self.face_count..self.face_halfedge.len())
            .chain(faces.iter().map(|face| face.index()))
            .collect();
        let mut number = vec![0; old.len()];
        for (new, &old) in old.iter().enumerate() {
            number[old] = new as u32;
        }
        self.face_count -= faces.len();
        self.face_halfedge = old.iter().map(|&face| self.face_halfedge[face]).collect();
        for face in &mut self.face {
            *face = number[*face as usize];
        }
        self.put_outer_halfedges_first()?;
        Ok(self)
    }

    /// Makes the outer halfedges the first ones of their sources.
    fn put_outer_halfedges_first(&mut self) -> Result<(), Error> {
        let face_count = self.face_count as u32;
        let mut seen = vec![false; self.vertex_halfedge.len()];
        for h in (0..self.next.len()).filter(|&h| self.face[h] >= face_count) {
            let vertex = self.source[h];
            if self.face[h ^ 1] >= face_count {
                return Err(Error::new(
                    ErrorKind::NonManifold,
                    format!(
                        "edge {} lies between outer faces only, so it would be in no face",
                        EdgeId::new(h / 2)
                    ),
                )
                .with_cure("remove the edge, or keep one of its faces"));
            }
            if std::mem::replace(&mut seen[vertex as usize], true) {
                return Err(Error::new(
                    ErrorKind::NonManifold,
                    format!(
                        "vertex {} has several corners in outer faces, so several fans of faces would meet there only",
                        VertexId::from_u32(vertex)
                    ),
                )
                .with_cure("keep all but one of these faces, or split the vertex"));
            }
            self.vertex_halfedge[vertex as usize] = h as u32;
        }
        Ok(())
    }

    /// The mesh of halfedges with these sources, of which `outer` ones, given rising, have no face: `NONE` stands for their
    /// `next` and `face`. Boundary loops are filled with outer faces, numbered by their smallest halfedges.
    ///
    /// Each edge has at least one halfedge with a face. Gives a vertex of several fans if there is one.
    pub(in crate::surface) fn filled(
        vertex_count: usize,
        mut next: Vec<u32>,
        source: Vec<u32>,
        mut face: Vec<u32>,
        mut face_halfedge: Vec<u32>,
        outer: &[u32],
    ) -> Result<Self, VertexId> {
        let face_count = face_halfedge.len();
        let mut vertex_halfedge = vec![NONE; vertex_count];
        for &h in outer {
            let vertex = source[h as usize];
            if vertex_halfedge[vertex as usize] != NONE {
                return Err(VertexId::from_u32(vertex));
            }
            vertex_halfedge[vertex as usize] = h;
        }
        for &h in outer {
            // As many outer halfedges leave a vertex as arrive there.
            next[h as usize] = vertex_halfedge[source[(h ^ 1) as usize] as usize];
        }
        for &first in outer {
            let mut at = first;
            while face[at as usize] == NONE {
                face[at as usize] = face_halfedge.len() as u32;
                at = next[at as usize];
            }
            if face[first as usize] as usize == face_halfedge.len() {
                face_halfedge.push(first);
            }
        }
        for (h, &vertex) in source.iter().enumerate() {
            // The smallest one, unless there is an outer one.
            let first = &mut vertex_halfedge[vertex as usize];
            if *first == NONE {
                *first = h as u32;
            }
        }
        let mesh = Self { next, source, face, vertex_halfedge, face_halfedge, face_count };
        mesh.several_fans().map_or(Ok(mesh), Err)
    }

    /// The first vertex whose halfedges are more than one orbit.
    pub(super) fn several_fans(&self) -> Option<VertexId> {
        let orbit_length = |first: u32| {
            let (mut at, mut length) = (first, 0);
            loop {
                length += 1;
                at = self.next[(at ^ 1) as usize];
                if at == first {
                    return length;
                }
            }
        };
        let met: usize = self
            .vertex_halfedge
            .par_chunks(1 << 12)
            .map(|firsts| firsts.iter().filter(|&&h| h != NONE).map(|&h| orbit_length(h)).sum::<usize>())
            .sum();
        if met == self.next.len() {
            return None;
        }
        let mut degrees = vec![0; self.vertex_count()];
        for &vertex in &self.source {
            degrees[vertex as usize] += 1;
        }
        let is_whole = |(&first, &degree): (&u32, &usize)| degree == 0 || orbit_length(first) == degree;
        self.vertex_halfedge.iter().zip(&degrees).position(|pair| !is_whole(pair)).map(VertexId::new)
    }
}
