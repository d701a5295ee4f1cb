//! The permutations that a surface is written as: next, twin and the faces that are outer.

use super::mesh::{HalfedgeMesh, check_limit, check_next};
use crate::surface::GeneralizedMap;
use coface_algebra::{EdgeId, Error, FaceId, HalfedgeId, Permutation, Sign, VertexId};

/// A surface as permutations of its halfedges `0..next.len()`, with the orbits of `next` that are outer faces.
///
/// Vertices are the orbits of "twin, then next", faces those of `next`; both are numbered by their smallest halfedges. The
/// outer faces fill the boundary loops; they are not part of the surface.
///
/// # Examples
/// Two triangles with a common edge, given by the six halfedges inside them:
/// ```
/// use coface_complexes::surface::HalfedgePermutations;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let twins = [None, None, Some(3), Some(2), None, None];
/// let square = HalfedgePermutations::with_boundary(&[1, 2, 0, 4, 5, 3], &twins)?;
/// assert_eq!(square.outer(), [2]);
/// assert_eq!(square.mesh()?.f_vector(), [4, 5, 2]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HalfedgePermutations {
    next: Vec<u32>,
    twin: Vec<u32>,
    outer: Vec<u32>,
}

impl HalfedgePermutations {
    /// These permutations; `outer` has the numbers of the faces that are outer, as the orbits of `next` are numbered.
    ///
    /// # Errors
    /// Those of [`HalfedgeMesh::from_permutations`] and [`HalfedgeMesh::with_outer_faces`].
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// A loop between two monogons; one of them outer leaves a disk.
    /// ```
    /// use coface_complexes::surface::HalfedgePermutations;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let disk = HalfedgePermutations::new(vec![0, 1], vec![1, 0], vec![1])?;
    /// assert_eq!(disk.mesh()?.surface().map(|surface| surface.to_string()).as_deref(), Some("disk"));
    /// # Ok(()) }
    /// ```
    pub fn new(next: Vec<u32>, twin: Vec<u32>, outer: Vec<u32>) -> Result<Self, Error> {
        let made = Self { next, twin, outer };
        made.mesh()?;
        Ok(made)
    }

    /// The surface whose halfedges on the boundary have no twin: `next` permutes the halfedges inside faces. The halfedges of
    /// outer faces are added after all others, one for each halfedge without a twin, in their order.
    ///
    /// A vertex at which several fans of faces meet comes apart, one vertex for each fan.
    ///
    /// # Errors
    /// As [`HalfedgeMesh::from_permutations`]; a halfedge whose twin is itself has none.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// A triangle:
    /// ```
    /// use coface_complexes::surface::HalfedgePermutations;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = HalfedgePermutations::with_boundary(&[1, 2, 0], &[None; 3])?;
    /// assert_eq!(triangle.next(), [1, 2, 0, 5, 3, 4]);
    /// assert_eq!(triangle.twin(), [3, 4, 5, 0, 1, 2]);
    /// # Ok(()) }
    /// ```
    pub fn with_boundary(next: &[u32], twin: &[Option<u32>]) -> Result<Self, Error> {
        let count = next.len();
        if twin.len() != count {
            return Err(Error::invalid(format!("next has {count} halfedges, but twin has {}", twin.len()))
                .with_cure("give each halfedge a next and a twin, or null on the boundary"));
        }
        check_next(next)?;
        let mut outer_of = vec![u32::MAX; count];
        let mut twins = Vec::with_capacity(2 * count);
        let mut bare = Vec::new();
        for (h, &mate) in twin.iter().enumerate() {
            let mate = mate.filter(|&mate| mate as usize != h).unwrap_or_else(|| {
                outer_of[h] = (count + bare.len()) as u32;
                bare.push(h as u32);
                outer_of[h]
            });
            twins.push(mate);
        }
        check_limit(count + bare.len())?;
        twins.extend(&bare);
        // Partial twins are checked before the fans are walked, which end only where they are an involution.
        HalfedgeMesh::halfedge_numbers(&twins)?;
        let mut previous = vec![0; count];
        for (h, &after) in next.iter().enumerate() {
            previous[after as usize] = h as u32;
        }
        let mut all = next.to_vec();
        for &h in &bare {
            // Outside, the halfedge after this one leaves its source: across the fan of faces there.
            let mut arriving = previous[h as usize];
            while outer_of[arriving as usize] == u32::MAX {
                arriving = previous[twins[arriving as usize] as usize];
            }
            all.push(outer_of[arriving as usize]);
        }
        let mut is_met = vec![false; all.len()];
        let (mut faces, mut outer) = (0, Vec::new());
        for start in 0..all.len() {
            if is_met[start] {
                continue;
            }
            if start >= count {
                outer.push(faces);
            }
            faces += 1;
            let mut at = start;
            while !std::mem::replace(&mut is_met[at], true) {
                at = all[at] as usize;
            }
        }
        Self::new(all, twins, outer)
    }

    /// The permutations of an oriented surface, with the vertex of it that each vertex is. Halfedges are the sides of faces
    /// in their order, those of outer faces after them; faces that do not agree with the first of their component are turned.
    /// Isolated vertices have no halfedges and are left out.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] for a component that is not orientable, naming an edge where its faces cannot agree.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::known_spaces;
    /// use coface_complexes::surface::{GeneralizedMap, HalfedgePermutations};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let map = GeneralizedMap::new(known_spaces::cyclic_torus(2)?.freeze().two_skeleton()?)?;
    /// let (torus, vertices) = HalfedgePermutations::of_map(&map)?;
    /// assert_eq!((torus.next().len(), vertices.len()), (42, 7));
    /// assert_eq!(torus.mesh()?.genus(), 1);
    /// # Ok(()) }
    /// ```
    pub fn of_map(map: &GeneralizedMap) -> Result<(Self, Vec<VertexId>), Error> {
        let orientation = map.orientation();
        if let Some(edge) = orientation.conflicts().iter().flatten().next() {
            let [a, b] = map.skeleton().edge(*edge);
            return Err(Error::invalid(format!(
                "the surface is not orientable: its faces cannot agree across the edge of {a} and {b}"
            ))
            .with_cells([[a.to_u32(), b.to_u32()]])
            .with_cure("halfedges describe oriented surfaces: take the orientation double cover by coface cover INPUT --orientation -o OUT.off"));
        }
        let is_turned = |side: HalfedgeId| orientation.signs()[map.face(side).index()] == Sign::Minus;
        let (mut next, mut twin, mut source) = (Vec::new(), Vec::new(), Vec::new());
        for side in map.sides() {
            let turned = is_turned(side);
            next.push(if turned { map.previous(side) } else { map.next(side) }.to_u32());
            twin.push(map.mate(side).map(HalfedgeId::to_u32));
            source.push(if turned { map.target(side) } else { map.source(side) });
        }
        let made = Self::with_boundary(&next, &twin)?;
        // Each vertex has a halfedge inside a face, and those come first.
        let mut is_met = vec![false; made.next.len()];
        let mut vertices = Vec::new();
        for start in 0..made.next.len() {
            if is_met[start] {
                continue;
            }
            vertices.push(source[start]);
            let mut at = start;
            while !std::mem::replace(&mut is_met[at], true) {
                at = made.next[made.twin[at] as usize] as usize;
            }
        }
        Ok((made, vertices))
    }

    /// The permutations of a mesh, with the vertex of it that each vertex is: halfedges keep their numbers. Isolated vertices are
    /// left out.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::{HalfedgeMesh, HalfedgePermutations};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(HalfedgePermutations::of_mesh(&torus).0.next(), [2, 3, 1, 0]);
    /// # Ok(()) }
    /// ```
    pub fn of_mesh(mesh: &HalfedgeMesh) -> (Self, Vec<VertexId>) {
        let (mut is_vertex_met, mut is_face_met) =
            (vec![false; mesh.vertex_count()], vec![false; mesh.face_count() + mesh.outer_face_count()]);
        let (mut vertices, mut outer, mut faces) = (Vec::new(), Vec::new(), 0);
        for halfedge in mesh.halfedges() {
            let (vertex, face) = (mesh.source(halfedge), mesh.face(halfedge));
            if !std::mem::replace(&mut is_vertex_met[vertex.index()], true) {
                vertices.push(vertex);
            }
            if !std::mem::replace(&mut is_face_met[face.index()], true) {
                if mesh.is_outer(face) {
                    outer.push(faces);
                }
                faces += 1;
            }
        }
        let twin = (0..mesh.halfedge_count() as u32).map(|h| h ^ 1).collect();
        (Self { next: mesh.next.clone(), twin, outer }, vertices)
    }

    /// The halfedge after each one around its face.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgePermutations;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let disk = HalfedgePermutations::with_boundary(&[0], &[None])?;
    /// assert_eq!((disk.next(), disk.twin(), disk.outer()), (&[0, 1][..], &[1, 0][..], &[1][..]));
    /// # Ok(()) }
    /// ```
    pub fn next(&self) -> &[u32] {
        &self.next
    }

    /// The other halfedge of the edge of each one.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgePermutations;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(HalfedgePermutations::with_boundary(&[0], &[None])?.twin(), [1, 0]);
    /// # Ok(()) }
    /// ```
    pub fn twin(&self) -> &[u32] {
        &self.twin
    }

    /// The faces that are outer.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgePermutations;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(HalfedgePermutations::with_boundary(&[0], &[None])?.outer(), [1]);
    /// # Ok(()) }
    /// ```
    pub fn outer(&self) -> &[u32] {
        &self.outer
    }

    /// The permutations `next` and `twin` and the outer faces.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgePermutations;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let disk = HalfedgePermutations::with_boundary(&[0], &[None])?;
    /// assert_eq!(disk.into_parts(), (vec![0, 1], vec![1, 0], vec![1]));
    /// # Ok(()) }
    /// ```
    pub fn into_parts(self) -> (Vec<u32>, Vec<u32>, Vec<u32>) {
        (self.next, self.twin, self.outer)
    }

    /// The mesh: its halfedges are numbered as [`Self::halfedge_numbers`] says, its vertices and faces as here but for
    /// outer faces, which are the last ones.
    ///
    /// # Errors
    /// Those of [`HalfedgeMesh::from_permutations`] and [`HalfedgeMesh::with_outer_faces`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgePermutations;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let disk = HalfedgePermutations::with_boundary(&[0], &[None])?;
    /// assert_eq!(disk.mesh()?.f_vector(), [1, 1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn mesh(&self) -> Result<HalfedgeMesh, Error> {
        let mesh = HalfedgeMesh::from_permutations(&self.next, &self.twin)?;
        let outer: Vec<FaceId> = self.outer.iter().map(|&face| FaceId::from_u32(face)).collect();
        if outer.is_empty() { Ok(mesh) } else { mesh.with_outer_faces(&outer) }
    }

    /// The number in [`Self::mesh`] of each halfedge.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgePermutations;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = HalfedgePermutations::with_boundary(&[1, 2, 0], &[None; 3])?;
    /// assert_eq!(triangle.halfedge_numbers()?.images(), [0, 2, 4, 1, 3, 5]);
    /// # Ok(()) }
    /// ```
    pub fn halfedge_numbers(&self) -> Result<Permutation, Error> {
        HalfedgeMesh::halfedge_numbers(&self.twin)
    }

    /// The edge of each halfedge, as [`Self::mesh`] numbers them.
    ///
    /// # Errors
    /// Those of [`Self::halfedge_numbers`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgePermutations;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = HalfedgePermutations::with_boundary(&[1, 2, 0], &[None; 3])?;
    /// let edges: Vec<usize> = triangle.edges()?.iter().map(|edge| edge.index()).collect();
    /// assert_eq!(edges, [0, 1, 2, 0, 1, 2]);
    /// # Ok(()) }
    /// ```
    pub fn edges(&self) -> Result<Vec<EdgeId>, Error> {
        Ok(self.halfedge_numbers()?.images().iter().map(|&h| EdgeId::from_u32(h >> 1)).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::surface::PolygonMesh;
    use coface_algebra::RaggedArray;
    use proptest::prelude::*;

    /// Figure 1 of a course on surface topology: four triangles around one, with a boundary of six edges.
    #[test]
    fn a_mesh_of_four_triangles_with_a_boundary() {
        // next: 1 -> 6 -> 10, 2 -> 11 -> 3, 4 -> 12 -> 5, 8 -> 7 -> 9, counted from 1; edges 7, 8 and 9 are inside.
        let mut next = [0u32; 12];
        for [a, b, c] in [[1, 6, 10], [2, 11, 3], [4, 12, 5], [8, 7, 9]] {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                next[from - 1] = to as u32 - 1;
            }
        }
        let twin: Vec<Option<u32>> = (1..=12)
            .map(|h| match h {
                7..=9 => Some(h + 3 - 1),
                10..=12 => Some(h - 3 - 1),
                _ => None,
            })
            .collect();
        let made = HalfedgePermutations::with_boundary(&next, &twin).unwrap();
        let mesh = made.mesh().unwrap();
        mesh.check().unwrap();
        assert_eq!((mesh.f_vector(), mesh.outer_face_count()), (vec![6, 9, 4], 1));
        assert_eq!(mesh.surface().map(|surface| surface.to_string()).as_deref(), Some("disk"));
        assert_eq!(made.outer(), [4]);
        assert_eq!(mesh.face_halfedges(FaceId::new(4)).count(), 6);
    }

    #[test]
    fn what_is_no_surface_is_refused() {
        let fault = |next: &[u32], twin: &[Option<u32>]| {
            HalfedgePermutations::with_boundary(next, twin).unwrap_err().message().to_owned()
        };
        assert!(fault(&[1, 2, 0], &[None, None]).contains("twin has 2"));
        assert!(fault(&[1, 1, 0], &[None; 3]).contains("next is no permutation"));
        assert!(fault(&[1, 2, 0], &[Some(1), Some(2), None]).contains("twin takes h0 to h1, but h1 to h2"));
        assert!(fault(&[1, 2, 0], &[Some(7), None, None]).contains("h7"));
        let error = HalfedgePermutations::new(vec![0, 1], vec![1, 0], vec![2]).unwrap_err();
        assert!(error.message().contains("face f2 is to be outer"), "{error}");
    }

    #[test]
    fn fans_that_touch_come_apart() {
        // Two triangles that share one vertex only have no common halfedge: two disks.
        let made = HalfedgePermutations::with_boundary(&[1, 2, 0, 4, 5, 3], &[None; 6]).unwrap();
        assert_eq!((made.outer().len(), made.mesh().unwrap().f_vector()), (2, vec![6, 6, 2]));
    }

    proptest! {
        /// Any permutation with any pairing of some of its points is a surface with boundary, and dropping the outer
        /// halfedges again leaves what was given.
        #[test]
        fn partial_twins_are_surfaces(
            next in Just((0u32..12).collect::<Vec<_>>()).prop_shuffle(),
            order in Just((0u32..12).collect::<Vec<_>>()).prop_shuffle(),
            pairs in 0usize..6,
        ) {
            let mut twin = vec![None; 12];
            for pair in order.chunks(2).take(pairs) {
                (twin[pair[0] as usize], twin[pair[1] as usize]) = (Some(pair[1]), Some(pair[0]));
            }
            let made = HalfedgePermutations::with_boundary(&next, &twin).unwrap();
            let mesh = made.mesh().unwrap();
            mesh.check().unwrap();
            prop_assert_eq!(made.next()[..12].to_vec(), next);
            prop_assert_eq!(made.next().len(), 24 - 2 * pairs);
            let bare = (0..12).filter(|&h| twin[h].is_none()).count();
            let boundary: usize = mesh.outer_faces().map(|face| mesh.face_halfedges(face).count()).sum();
            prop_assert_eq!(boundary, bare);
        }

        /// A mesh of polygons, some turned over, comes back from its permutations.
        #[test]
        fn meshes_come_back(keep in prop::collection::vec(prop::bool::weighted(0.8), 24), turned in any::<u32>()) {
            let polygons: Vec<Vec<u32>> = super::super::tests::torus_triangles(4, 3, |v| v)
                .into_iter()
                .zip(keep)
                .enumerate()
                .filter(|&(_, (_, keep))| keep)
                .map(|(i, (mut triangle, _))| {
                    if turned >> (i % 32) & 1 == 1 { triangle.reverse() }
                    triangle
                })
                .collect();
            let mesh = PolygonMesh::new(12, RaggedArray::from_lists(&polygons), &[]).unwrap();
            let Ok(map) = mesh.two_skeleton().and_then(GeneralizedMap::new) else { return Ok(()) };
            let (made, vertices) = HalfedgePermutations::of_map(&map).unwrap();
            let mesh = made.mesh().unwrap();
            prop_assert_eq!(mesh.face_count(), polygons.len());
            for (face, polygon) in polygons.iter().enumerate() {
                let mut around: Vec<u32> = mesh
                    .face_vertices(FaceId::new(face))
                    .map(|vertex| vertices[vertex.index()].to_u32())
                    .collect();
                let mut polygon = polygon.clone();
                around.sort_unstable();
                polygon.sort_unstable();
                prop_assert_eq!(around, polygon);
            }
        }
    }
}
