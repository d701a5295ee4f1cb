//! What a halfedge mesh can be turned into: a polygon mesh or a simplicial complex where that is the same surface, and a
//! subdivision where it is not.

use super::super::PolygonMesh;
use super::super::edge_identification::{is_sound, polygon_fault};
use super::mesh::HalfedgeMesh;
use crate::simplicial::{Carrier, DeltaComplex, FrozenComplex, SimplicialComplex, Subdivision};
use coface_algebra::RaggedArray;
use coface_algebra::{CellId, EdgeId, Error, ErrorKind, FaceId, IdVec, VertexId};

/// The most simplices of a subdivision.
const SIMPLEX_LIMIT: usize = 1 << 28;
const CURE: &str = "take the barycentric subdivision";

impl HalfedgeMesh {
    /// The faces as cycles of vertices, outer ones left out: list i is face i from its first halfedge on. The cycles of
    /// cells that touch themselves repeat vertices.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(HalfedgeMesh::from_next(vec![2, 3, 4, 5, 0, 1])?.polygons().list(1), [0, 0, 0]);
    /// # Ok(()) }
    /// ```
    pub fn polygons(&self) -> RaggedArray {
        let mut polygons = RaggedArray::new();
        let mut polygon = Vec::new();
        for face in (0..self.face_count()).map(FaceId::new) {
            polygon.clear();
            polygon.extend(self.face_vertices(face).map(|v| v.to_u32()));
            polygons.push(&polygon);
        }
        polygons
    }

    /// The same surface as a polygon mesh: vertices and faces keep their numbers; edges are numbered anew.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming cells that polygons cannot tell: a face with fewer than three vertices or with
    /// one vertex twice, two edges with the same ends, two faces with the same edges; [`ErrorKind::TooLarge`] from 2^30
    /// sides on.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = HalfedgeMesh::from_polygons(4, &RaggedArray::from_lists([[2, 0, 1, 3]]))?;
    /// assert_eq!(square.to_polygon_mesh()?.polygons().list(0), [2, 0, 1, 3]);
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert!(torus.to_polygon_mesh().is_err());
    /// # Ok(()) }
    /// ```
    pub fn to_polygon_mesh(&self) -> Result<PolygonMesh, Error> {
        let polygons = self.polygons();
        if let Some(face) = (0..polygons.len()).find(|&f| !is_sound(self.vertex_count(), polygons.list(f))) {
            return Err(polygon_fault(self.vertex_count(), face, polygons.list(face)).with_cure(CURE));
        }
        let mesh = PolygonMesh::new(self.vertex_count(), polygons, &[])?;
        if mesh.edge_count() < self.edge_count() {
            return Err(self.parallel_edges());
        }
        if let Some(&(first, later)) = mesh.duplicate_faces().first() {
            return Err(Error::invalid(format!(
                "faces {first} and {} have the same edges, so polygons cannot tell them",
                FaceId::new(later)
            ))
            .with_cure(CURE));
        }
        Ok(mesh)
    }

    /// Two edges with the same ends.
    fn parallel_edges(&self) -> Error {
        let mut edges: Vec<([u32; 2], usize)> = self
            .edge_ends()
            .as_chunks::<2>()
            .0
            .iter()
            .enumerate()
            .map(|(edge, &[a, b])| ([a.min(b), a.max(b)], edge))
            .collect();
        edges.sort_unstable();
        let pair = edges.windows(2).find(|pair| pair[0].0 == pair[1].0).expect("two edges were identified");
        let ([a, b], e) = pair[0];
        Error::invalid(format!(
            "edges {} and {} both join v{a} and v{b}, so their vertices do not tell them",
            EdgeId::new(e),
            EdgeId::new(pair[1].1)
        ))
        .with_cure(CURE)
    }

    /// The same surface as a simplicial complex on the same vertex numbers, if it is one: every face is a triangle with
    /// three distinct vertices, and no two edges or faces have the same vertices.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming cells for which that does not hold.
    ///
    /// # Complexity
    /// Near-linear.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// use coface_complexes::known_spaces;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = known_spaces::cyclic_torus(2)?;
    /// assert_eq!(HalfedgeMesh::from_simplicial_complex(&torus)?.to_simplicial_complex()?, torus);
    /// # Ok(()) }
    /// ```
    pub fn to_simplicial_complex(&self) -> Result<SimplicialComplex, Error> {
        let size = |face: FaceId| self.face_halfedges(face).take(4).count();
        if let Some(face) = (0..self.face_count()).map(FaceId::new).find(|&face| size(face) != 3) {
            return Err(Error::invalid(format!(
                "face {face} has {} sides, so it is no triangle",
                self.face_halfedges(face).count()
            ))
            .with_cure(CURE));
        }
        let mut facets = self.to_polygon_mesh()?.polygons().clone();
        for vertex in (0..self.vertex_count()).map(VertexId::new) {
            if self.vertex_halfedge(vertex).is_none() {
                facets.push(&[vertex.to_u32()]);
            }
        }
        Ok(FrozenComplex::from_facets(&facets)?.thaw())
    }

    /// The barycentric subdivision: a triangle for each corner of a halfedge, between a vertex, an edge and a face. Its
    /// vertices are the vertices of the mesh, then its edges, then its faces, outer ones left out; the carrier of each is
    /// that cell.
    ///
    /// The vertices of a triangle are distinct, but two triangles may have the same ones where cells touch themselves. The
    /// subdivision of the subdivision, [`Subdivision::subdivided`], is always a simplicial complex, with carriers in the
    /// mesh.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^28 simplices.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # References
    /// A. Hatcher, *Algebraic Topology* (2002), section 2.1 and exercise 2.1.23.
    ///
    /// # Examples
    /// The square torus: its one vertex, two edges and one face become vertices. The four corners of the square touch
    /// themselves, so only the second subdivision is a simplicial complex.
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let once = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?.barycentric_subdivision()?;
    /// assert_eq!(once.complex().f_vector(), [4, 12, 8]);
    /// assert!(once.complex().to_simplicial_complex().is_err());
    /// let twice = once.subdivided()?;
    /// assert_eq!(twice.complex().to_simplicial_complex()?.f_vector(), [24, 72, 48]);
    /// # Ok(()) }
    /// ```
    pub fn barycentric_subdivision(&self) -> Result<Subdivision, Error> {
        let (vertex_count, edge_count, face_count) =
            (self.vertex_count(), self.edge_count(), self.face_count());
        let count = self.halfedge_count();
        // The corners of faces that are not outer, numbered.
        let mut corner = vec![0u32; count];
        let mut inner = Vec::with_capacity(count);
        for h in self.inner().halfedges() {
            corner[h.index()] = inner.len() as u32;
            inner.push(h);
        }
        let simplex_count = vertex_count + edge_count + face_count + count + 4 * inner.len();
        if simplex_count > SIMPLEX_LIMIT {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!(
                    "the barycentric subdivision has {simplex_count} simplices; the limit is {SIMPLEX_LIMIT}"
                ),
            ));
        }
        let middle = |h: coface_algebra::HalfedgeId| (vertex_count + self.edge(h).index()) as u32;
        let center =
            |h: coface_algebra::HalfedgeId| (vertex_count + edge_count + self.face(h).index()) as u32;
        // Face i of a simplex is the one without its vertex i. Segments: from the source of each halfedge to the middle of
        // its edge; for each corner from the middle of its halfedge, and from its vertex, to the center of its face.
        let mut segments = Vec::with_capacity(2 * (count + 2 * inner.len()));
        segments.extend(self.halfedges().flat_map(|h| [middle(h), self.source(h).to_u32()]));
        segments.extend(inner.iter().flat_map(|&h| [center(h), middle(h)]));
        segments.extend(inner.iter().flat_map(|&h| [center(h), self.source(h).to_u32()]));
        let (from_middle, from_vertex) = (count as u32, (count + inner.len()) as u32);
        let triangles = inner
            .iter()
            .flat_map(|&h| {
                let (here, after) = (corner[h.index()], corner[self.next(h).index()]);
                [
                    [from_middle + here, from_vertex + here, h.to_u32()],
                    [from_middle + here, from_vertex + after, self.twin(h).to_u32()],
                ]
            })
            .flatten()
            .collect();
        let new_vertex_count = vertex_count + edge_count + face_count;
        let complex = DeltaComplex::new(new_vertex_count, vec![segments, triangles])?;
        let carriers = self
            .f_vector()
            .into_iter()
            .enumerate()
            .flat_map(|(degree, count)| (0..count).map(move |cell| (degree, CellId::new(cell))))
            .collect();
        Ok(Subdivision::new(complex, carriers))
    }

    /// A simplicial complex of the same surface, with the cell of the mesh that each vertex lies in: the mesh itself if it
    /// is one, otherwise its first, otherwise its second barycentric subdivision.
    ///
    /// # Errors
    /// As [`Self::barycentric_subdivision`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A segment in a digon.
    /// let (sphere, carriers) = HalfedgeMesh::from_next(vec![1, 0])?.triangulation()?;
    /// assert_eq!(sphere.euler_characteristic(), 2);
    /// // The two ends lie in vertices.
    /// assert_eq!(carriers.iter().filter(|&&(degree, _)| degree == 0).count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn triangulation(&self) -> Result<(SimplicialComplex, IdVec<VertexId, Carrier>), Error> {
        match self.to_simplicial_complex() {
            Ok(complex) => {
                let itself = (0..self.vertex_count()).map(|vertex| (0, CellId::new(vertex)));
                Ok((complex, itself.collect()))
            }
            Err(_) => self.barycentric_subdivision()?.triangulation(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn fault(next: &[u32]) -> String {
        HalfedgeMesh::from_next(next.to_vec())
            .unwrap()
            .to_simplicial_complex()
            .unwrap_err()
            .message()
            .to_owned()
    }

    #[test]
    fn cells_that_simplices_cannot_tell_are_named() {
        assert_eq!(fault(&[1, 0]), "face f0 has 2 sides, so it is no triangle");
        assert_eq!(fault(&[2, 3, 4, 5, 0, 1]), "face f0 repeats vertex v0");
        let pillow =
            HalfedgeMesh::from_polygons(3, &RaggedArray::from_lists([[0, 1, 2], [2, 1, 0]])).unwrap();
        let error = pillow.to_simplicial_complex().unwrap_err();
        assert_eq!(error.message(), "faces f0 and f1 have the same edges, so polygons cannot tell them");
        // Two cones on a circle of two edges, each of two triangles.
        let rims = [[0, 4, 7], [2, 6, 5], [3, 8, 11], [1, 10, 9]];
        let ends = vec![0, 1, 1, 0, 1, 2, 0, 2, 1, 3, 0, 3];
        let skeleton = coface_algebra::chains::TwoSkeleton::new(4, ends, RaggedArray::from_lists(rims));
        let mesh = HalfedgeMesh::from_two_skeleton(&skeleton.unwrap());
        assert_eq!(
            mesh.unwrap().to_simplicial_complex().unwrap_err().message(),
            "edges e0 and e1 both join v0 and v1, so their vertices do not tell them"
        );
    }

    proptest! {
        #[test]
        fn subdivisions_are_the_same_surface(
            next in Just((0u32..8).collect::<Vec<_>>()).prop_shuffle(),
            outer in 0usize..8,
        ) {
            let mesh = HalfedgeMesh::from_next(next).unwrap();
            let face = FaceId::new(outer % mesh.face_count());
            let mesh = mesh.clone().with_outer_faces(&[face]).unwrap_or(mesh);
            let once = mesh.barycentric_subdivision().unwrap();
            let (v, e, f) = (mesh.vertex_count(), mesh.edge_count(), mesh.face_count());
            let corners = mesh.inner().halfedge_count();
            prop_assert_eq!(once.complex().f_vector(), [v + e + f, 2 * e + 2 * corners, 2 * corners]);

            let twice = once.subdivided().unwrap();
            let simplicial = twice.complex().to_simplicial_complex().unwrap();
            prop_assert_eq!(simplicial.f_vector(), twice.complex().f_vector());
            let again = HalfedgeMesh::from_simplicial_complex(&simplicial).unwrap();
            prop_assert_eq!(again.surface(), mesh.surface());
            prop_assert_eq!(again.outer_face_count(), mesh.outer_face_count());

            // Labels: each vertex of the mesh has one vertex in it; each open edge three, as a second subdivision of a
            // segment; the rest lie in open faces.
            let mut counts = [vec![0; v], vec![0; e], vec![0; f]];
            for &(degree, cell) in twice.carriers() {
                counts[degree][cell.index()] += 1;
            }
            prop_assert!(counts[0].iter().all(|&n| n == 1));
            prop_assert!(counts[1].iter().all(|&n| n == 3));
            for (face, &n) in counts[2].iter().enumerate() {
                // A cone over a circle of 2k segments, subdivided: center, spokes and triangles.
                let sides = mesh.face_halfedges(FaceId::new(face)).count();
                prop_assert_eq!(n, 1 + 2 * sides + 2 * sides);
            }
            // And the edges between vertices of one carrier stay inside it: carriers of a simplex are a chain of cells.
            for edge in simplicial.simplices(1) {
                let mut carriers: Vec<Carrier> =
                    edge.vertices().map(|vertex| twice.carriers()[vertex]).collect();
                carriers.sort_unstable();
                prop_assert!(carriers[0].0 < carriers[1].0 || carriers[0] == carriers[1]);
            }
        }

        #[test]
        fn polygon_meshes_come_back(keep in prop::collection::vec(prop::bool::weighted(0.9), 24)) {
            let polygons: Vec<Vec<u32>> = super::super::tests::torus_triangles(4, 3, |v| v)
                .into_iter()
                .zip(keep)
                .filter(|&(_, keep)| keep)
                .map(|(triangle, _)| triangle)
                .collect();
            let Ok(mesh) = HalfedgeMesh::from_polygons(12, &RaggedArray::from_lists(&polygons)) else { return Ok(()) };
            prop_assert_eq!(mesh.polygons(), RaggedArray::from_lists(&polygons));
            let polygon_mesh = mesh.to_polygon_mesh().unwrap();
            prop_assert_eq!(polygon_mesh.f_vector(), mesh.f_vector());
            prop_assert_eq!(&polygon_mesh.halfedges().unwrap(), &mesh);
            prop_assert_eq!(mesh.to_simplicial_complex().unwrap().f_vector()[0], 12);
        }
    }
}
