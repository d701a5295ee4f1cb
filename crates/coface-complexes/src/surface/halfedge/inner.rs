//! The inner halfedges of a mesh: a boundary edge has one of them.

use super::mesh::HalfedgeMesh;
use coface_algebra::{EdgeId, FaceId, HalfedgeId, VertexId};

/// A halfedge mesh without its outer halfedges, as the half-edge data structure of triangular meshes with boundary is
/// often defined: an edge has two halfedges, but one on the boundary.
///
/// Cells have the numbers that they have in the mesh, so halfedge numbers have gaps where outer ones are.
///
/// # Conventions
/// The first halfedge of a vertex *enters* it; on the boundary it is the one along the boundary. The first halfedge of an
/// edge is the one in the direction of the edge if that is an inner one.
///
/// # Panics
/// Functions panic if there is no such cell, or the halfedge is an outer one.
///
/// # Examples
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_complexes::surface::HalfedgeMesh;
/// use coface_algebra::{EdgeId, HalfedgeId};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let mesh = HalfedgeMesh::from_polygons(4, &RaggedArray::from_lists([[0, 1, 2], [2, 1, 3]]))?;
/// let inner = mesh.inner();
/// assert_eq!(inner.halfedge_count(), 6);
/// assert_eq!(inner.twin(HalfedgeId::new(0)), None);
/// assert_eq!(inner.edge_halfedges(EdgeId::new(1)), (HalfedgeId::new(2), Some(HalfedgeId::new(3))));
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug)]
pub struct InnerHalfedges<'a> {
    mesh: &'a HalfedgeMesh,
}

impl HalfedgeMesh {
    /// The mesh as one in which a boundary edge has one halfedge.
    pub fn inner(&self) -> InnerHalfedges<'_> {
        InnerHalfedges { mesh: self }
    }
}

impl<'a> InnerHalfedges<'a> {
    /// The mesh with its outer halfedges.
    pub fn mesh(self) -> &'a HalfedgeMesh {
        self.mesh
    }

    /// The number of inner halfedges.
    ///
    /// # Complexity
    /// Linear.
    pub fn halfedge_count(self) -> usize {
        self.halfedges().count()
    }

    /// The inner halfedges, rising.
    pub fn halfedges(self) -> impl Iterator<Item = HalfedgeId> + 'a {
        self.mesh.halfedges().filter(move |&h| !self.mesh.is_outer_halfedge(h))
    }

    fn inner(self, halfedge: HalfedgeId) -> HalfedgeId {
        assert!(!self.mesh.is_outer_halfedge(halfedge), "{halfedge} is an inner halfedge");
        halfedge
    }

    /// The vertex that a halfedge leaves.
    pub fn source(self, halfedge: HalfedgeId) -> VertexId {
        self.mesh.source(self.inner(halfedge))
    }

    /// The vertex that a halfedge enters.
    pub fn target(self, halfedge: HalfedgeId) -> VertexId {
        self.mesh.target(self.inner(halfedge))
    }

    /// The face that a halfedge belongs to, never an outer one.
    pub fn face(self, halfedge: HalfedgeId) -> FaceId {
        self.mesh.face(self.inner(halfedge))
    }

    /// The edge that a halfedge belongs to.
    pub fn edge(self, halfedge: HalfedgeId) -> EdgeId {
        self.mesh.edge(self.inner(halfedge))
    }

    /// The halfedge after this one around its face.
    pub fn next(self, halfedge: HalfedgeId) -> HalfedgeId {
        self.mesh.next(self.inner(halfedge))
    }

    /// The halfedge before this one around its face.
    pub fn previous(self, halfedge: HalfedgeId) -> HalfedgeId {
        self.mesh.previous(self.inner(halfedge))
    }

    /// The other halfedge of the edge; `None` on the boundary.
    pub fn twin(self, halfedge: HalfedgeId) -> Option<HalfedgeId> {
        let twin = self.mesh.twin(self.inner(halfedge));
        (!self.mesh.is_outer_halfedge(twin)).then_some(twin)
    }

    /// The first halfedge of a face.
    pub fn face_halfedge(self, face: FaceId) -> HalfedgeId {
        self.inner(self.mesh.face_halfedge(face))
    }

    /// The first halfedge that enters a vertex; `None` for an isolated vertex.
    pub fn vertex_halfedge(self, vertex: VertexId) -> Option<HalfedgeId> {
        // The first that leaves it is outer on the boundary, so its twin is inner.
        self.mesh.vertex_halfedge(vertex).map(|h| self.mesh.twin(h))
    }

    /// The one or two halfedges of an edge.
    pub fn edge_halfedges(self, edge: EdgeId) -> (HalfedgeId, Option<HalfedgeId>) {
        let first = self.mesh.edge_halfedge(edge);
        let twin = self.mesh.twin(first);
        if self.mesh.is_outer_halfedge(first) { (twin, None) } else { (first, self.twin(first)) }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::RaggedArray;
    use coface_algebra::chains::TwoSkeleton;

    /// Halfedge $h_n$ of the figure: along edge $e_n$ for n up to 9, against $e_{n-3}$ beyond.
    fn h(n: usize) -> HalfedgeId {
        HalfedgeId::new(if n <= 9 { 2 * (n - 1) } else { 2 * (n - 4) + 1 })
    }

    /// A disk of four triangles: figure 1 of X. Gu, N. Hong, *Computational conformal geometry*, lab I (2021).
    fn figure() -> HalfedgeMesh {
        let targets_and_sources = [(2, 1), (3, 2), (4, 3), (5, 4), (6, 5), (1, 6), (2, 6), (4, 2), (6, 4)];
        let ends =
            targets_and_sources.iter().flat_map(|&(source, target)| [source - 1, target - 1]).collect();
        let rims = [[1, 6, 10], [2, 11, 3], [5, 4, 12], [8, 7, 9]].map(|rim| rim.map(|n| h(n).to_u32()));
        HalfedgeMesh::from_two_skeleton(&TwoSkeleton::new(6, ends, RaggedArray::from_lists(rims)).unwrap())
            .unwrap()
    }

    #[test]
    fn the_pointer_functions_of_the_figure() {
        let mesh = figure();
        mesh.check().unwrap();
        let (v, e, f) =
            (|n: usize| VertexId::new(n - 1), |n: usize| EdgeId::new(n - 1), |n: usize| FaceId::new(n - 1));
        let inner = mesh.inner();
        assert_eq!((mesh.f_vector(), inner.halfedge_count()), (vec![6, 9, 4], 12));
        assert_eq!((mesh.halfedge_count(), mesh.outer_face_count()), (18, 1));
        assert_eq!(mesh.euler_characteristic(), 1);

        let source_and_target =
            [(2, 1), (3, 2), (4, 3), (5, 4), (6, 5), (1, 6), (2, 6), (4, 2), (6, 4), (6, 2), (2, 4), (4, 6)];
        for (n, &(source, target)) in (1..).zip(&source_and_target) {
            assert_eq!((inner.source(h(n)), inner.target(h(n))), (v(source), v(target)), "h{n}");
        }
        for (face, cycle) in (1..).zip([[1, 6, 10], [2, 11, 3], [4, 12, 5], [8, 7, 9]]) {
            for i in 0..3 {
                let (here, after) = (cycle[i], cycle[(i + 1) % 3]);
                assert_eq!(inner.next(h(here)), h(after));
                assert_eq!(inner.previous(h(after)), h(here));
                assert_eq!(inner.face(h(here)), f(face));
            }
        }
        for (face, first) in (1..).zip([1, 2, 5, 8]) {
            assert_eq!(inner.face_halfedge(f(face)), h(first));
        }
        for n in 1..=12 {
            assert_eq!(inner.edge(h(n)), e(if n <= 9 { n } else { n - 3 }));
        }
        for n in 1..=9 {
            let pair = if n <= 6 { (h(n), None) } else { (h(n), Some(h(n + 3))) };
            assert_eq!(inner.edge_halfedges(e(n)), pair);
            assert_eq!(inner.twin(h(n)), pair.1);
            assert_eq!(mesh.is_boundary_edge(e(n)), n <= 6);
        }
        for n in 1..=6 {
            assert_eq!(inner.vertex_halfedge(v(n)), Some(h(n)));
        }
        for n in 7..=9 {
            assert_eq!(inner.twin(h(n + 3)), Some(h(n)));
        }
    }

    #[test]
    #[should_panic(expected = "h1 is an inner halfedge")]
    fn outer_halfedges_are_hidden() {
        figure().inner().next(HalfedgeId::new(1));
    }

    /// A mesh whose edge goes along its outer halfedge: the other one comes first.
    #[test]
    fn an_edge_against_its_only_face_has_the_other_halfedge() {
        let disk = TwoSkeleton::new(1, vec![0, 0], RaggedArray::from_lists([[1]])).unwrap();
        let mesh = HalfedgeMesh::from_two_skeleton(&disk).unwrap();
        assert_eq!(mesh.inner().edge_halfedges(EdgeId::new(0)), (HalfedgeId::new(1), None));
        assert_eq!(mesh.inner().halfedges().collect::<Vec<_>>(), [HalfedgeId::new(1)]);
    }
}
