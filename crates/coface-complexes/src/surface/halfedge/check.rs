//! The invariants of a halfedge mesh.

use super::mesh::{HalfedgeMesh, NONE, check_limit};
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, HalfedgeId, VertexId};

impl HalfedgeMesh {
    /// Verifies the invariants: `next` is a permutation of an even number of halfedges; it keeps the face, and leaves the
    /// target; the halfedges of a face, and those that leave a vertex, are one orbit each; first halfedges belong to
    /// their cells, and those of boundary vertices are outer; no edge has two outer sides, no vertex two outer corners.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the first cell where one is broken.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.check()?;
    /// # Ok(()) }
    /// ```
    pub fn check(&self) -> Result<(), Error> {
        let count = self.next.len();
        check_limit(count)?;
        if !count.is_multiple_of(2) || self.source.len() != count || self.face.len() != count {
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "{count} next, {} sources and {} faces of halfedges",
                    self.source.len(),
                    self.face.len()
                ),
            ));
        }
        if self.face_count > self.face_halfedge.len() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("{} faces, of which {} are not outer", self.face_halfedge.len(), self.face_count),
            ));
        }
        let mut is_met = vec![false; count];
        for h in 0..count {
            let (after, id) = (self.next[h] as usize, HalfedgeId::new(h));
            if after >= count || self.source[h] as usize >= self.vertex_halfedge.len() {
                return Err(Error::invalid(format!("{id} has a next or a source that does not exist")));
            }
            if self.face[h] as usize >= self.face_halfedge.len() {
                return Err(Error::invalid(format!("{id} has a face that does not exist")));
            }
            if std::mem::replace(&mut is_met[after], true) {
                return Err(Error::invalid(format!("two halfedges have {} as next", HalfedgeId::new(after))));
            }
        }
        for h in 0..count {
            let (after, id) = (self.next[h] as usize, HalfedgeId::new(h));
            if self.source[after] != self.source[h ^ 1] {
                return Err(Error::invalid(format!("the next of {id} does not leave its target")));
            }
            if self.face[after] != self.face[h] {
                return Err(Error::invalid(format!("the next of {id} is in another face")));
            }
            let is_outer = |h: usize| self.face[h] as usize >= self.face_count;
            if is_outer(h) && is_outer(h ^ 1) {
                return Err(Error::invalid(format!("edge {} has two outer sides", EdgeId::new(h / 2))));
            }
            if is_outer(h) && self.vertex_halfedge[self.source[h] as usize] as usize != h {
                return Err(Error::invalid(format!(
                    "the outer halfedge {id} is not the first one of its source {}",
                    VertexId::from_u32(self.source[h])
                )));
            }
        }
        for (face, &first) in self.face_halfedge.iter().enumerate() {
            if self.face.get(first as usize) != Some(&(face as u32)) {
                return Err(Error::invalid(format!(
                    "the first halfedge of face {} is not in it",
                    FaceId::new(face)
                )));
            }
        }
        let mut has_halfedge = vec![false; self.vertex_halfedge.len()];
        self.source.iter().for_each(|&vertex| has_halfedge[vertex as usize] = true);
        for (vertex, &first) in self.vertex_halfedge.iter().enumerate() {
            let expected = has_halfedge[vertex].then_some(vertex as u32);
            let found = if first == NONE { None } else { Some(self.source.get(first as usize)) };
            if found != expected.as_ref().map(Some) {
                return Err(Error::invalid(format!(
                    "the first halfedge of vertex {} does not leave it",
                    VertexId::new(vertex)
                )));
            }
        }
        if let Some(vertex) = self.several_fans() {
            return Err(Error::invalid(format!("several fans of faces meet at vertex {vertex} only")));
        }
        let around = |first: u32| {
            let follow = |&h: &u32| Some(self.next[h as usize]).filter(|&next| next != first);
            std::iter::successors(Some(first), follow).count()
        };
        if self.face_halfedge.iter().map(|&first| around(first)).sum::<usize>() != count {
            return Err(Error::invalid("a face is several orbits of next"));
        }
        Ok(())
    }
}
