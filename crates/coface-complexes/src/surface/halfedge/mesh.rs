//! The halfedge mesh: its arrays, its cells and its counts.

use super::super::SurfaceType;
use crate::components::Components;
use coface_algebra::Permutation;
use coface_algebra::chains::ChainComplex;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, HalfedgeId, VertexId};

/// "No halfedge", "no face" in the arrays of a mesh.
pub(in crate::surface) const NONE: u32 = u32::MAX;
/// The most halfedges.
pub(super) const LIMIT: usize = 1 << 31;

/// A compact oriented surface, with or without boundary, as a permutation `next` of its halfedges.
///
/// Halfedges 2e and 2e + 1 are the two directions of edge e: twin(h) = h ^ 1. Faces are the orbits of `next`, edges those
/// of `twin`, vertices those of "twin, then next": the halfedges that leave a vertex. Any permutation of an even number of
/// halfedges is a surface, cells that touch themselves included: a torus with one vertex, a monogon, a segment in a
/// digon.
///
/// # Conventions
/// * Faces run counterclockwise: a face lies to the left of its halfedges.
/// * A boundary loop is filled with an **outer face**, whose halfedges have the surface on their right. Outer faces are
///   numbered after all others, from [`Self::face_count`] on; [`Self::is_outer`] tells them. [`Self::f_vector`],
///   [`Self::euler_characteristic`], [`Self::chain_complex`] and [`Self::two_skeleton`] leave them out; halfedges along
///   them are counted by [`Self::halfedge_count`].
/// * Each edge has at most one side on outer faces, each vertex at most one corner in them.
/// * An **isolated vertex** has no halfedge; meshes made from polygons keep such vertices.
///
/// # Complexity
/// About 14 bytes a halfedge for a closed mesh of triangles.
///
/// # References
/// J. Edmonds, *A combinatorial representation for polyhedral surfaces* (1960). K. Weiler, *Edge-based data structures for
/// solid modeling in curved-surface environments* (1985).
///
/// # Examples
/// The torus with one vertex, of two triangles:
/// ```
/// use coface_complexes::surface::HalfedgeMesh;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = HalfedgeMesh::from_next(vec![2, 3, 4, 5, 0, 1])?;
/// assert_eq!(torus.f_vector(), [1, 3, 2]);
/// assert_eq!(torus.genus(), 1);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HalfedgeMesh {
    /// The halfedge after each one around its face.
    pub(in crate::surface) next: Vec<u32>,
    /// The vertex that each halfedge leaves: the two ends of each edge, source first.
    pub(in crate::surface) source: Vec<u32>,
    /// The face of each halfedge.
    pub(in crate::surface) face: Vec<u32>,
    /// A halfedge that leaves each vertex, on the boundary the one along the outer face; `NONE` for isolated vertices.
    pub(in crate::surface) vertex_halfedge: Vec<u32>,
    /// The first halfedge of each face, outer faces last.
    pub(in crate::surface) face_halfedge: Vec<u32>,
    /// How many faces are not outer.
    pub(in crate::surface) face_count: usize,
}

impl HalfedgeMesh {
    /// The closed surface with this `next`, in which halfedges 2i and 2i + 1 are twins. Vertices and faces are numbered by
    /// their smallest halfedges, which are also their first ones. [`Self::with_outer_faces`] opens it along faces.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for an odd number of halfedges, and naming the first halfedge where `next` is no
    /// permutation; [`ErrorKind::TooLarge`] from 2^31 halfedges on.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// Two halfedges: a loop between two monogons, or a segment in a digon. Both are spheres.
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(HalfedgeMesh::from_next(vec![0, 1])?.f_vector(), [1, 1, 2]);
    /// assert_eq!(HalfedgeMesh::from_next(vec![1, 0])?.f_vector(), [2, 1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn from_next(next: Vec<u32>) -> Result<Self, Error> {
        check_limit(next.len())?;
        if !next.len().is_multiple_of(2) {
            return Err(Error::invalid(format!("{} halfedges cannot be paired", next.len()))
                .with_cure("give an even number of halfedges, or twin as well"));
        }
        check_next(&next)?;
        let count = next.len() as u32;
        Ok(Self::from_trusted_next(next, || 0..count))
    }

    /// The closed surface of these permutations of `0..next.len()`, `twin` an involution without fixed points.
    ///
    /// The halfedges are renumbered as [`Self::halfedge_numbers`] says, so that twins become 2e and 2e + 1: edges by their
    /// smaller halfedges, which become 2e. Vertices and faces are numbered by their smallest halfedges, as numbered
    /// before; those are their first halfedges.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the first halfedge where `next` is no permutation, or `twin` no involution without
    /// fixed points; [`ErrorKind::Shape`] if the two differ in length; [`ErrorKind::TooLarge`] from 2^31 halfedges on.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// A cone closed by a monogon: the cone is a triangle with two sides glued to each other.
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sphere = HalfedgeMesh::from_permutations(&[1, 2, 0, 3], &[1, 0, 3, 2])?;
    /// assert_eq!(sphere.f_vector(), [2, 2, 2]);
    /// assert_eq!(sphere.genus(), 0);
    /// # Ok(()) }
    /// ```
    pub fn from_permutations(next: &[u32], twin: &[u32]) -> Result<Self, Error> {
        check_limit(next.len())?;
        if twin.len() != next.len() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("next has {} halfedges, but twin has {}", next.len(), twin.len()),
            ));
        }
        check_next(next)?;
        let numbers = Self::halfedge_numbers(twin)?;
        let mut renumbered = vec![0; next.len()];
        for (h, &after) in next.iter().enumerate() {
            renumbered[numbers.image(h)] = numbers.image(after as usize) as u32;
        }
        Ok(Self::from_trusted_next(renumbered, || numbers.images().iter().copied()))
    }

    /// The numbers that [`Self::from_permutations`] gives to the halfedges with this twin: h becomes `image(h)`. Edges are
    /// numbered by their smaller halfedges, and the smaller halfedge of edge e becomes 2e, its twin 2e + 1.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the first halfedge where `twin` is no involution without fixed points.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(HalfedgeMesh::halfedge_numbers(&[2, 3, 0, 1])?.images(), [0, 2, 1, 3]);
    /// # Ok(()) }
    /// ```
    pub fn halfedge_numbers(twin: &[u32]) -> Result<Permutation, Error> {
        let mut images = vec![0; twin.len()];
        let mut count = 0;
        for (h, &image) in twin.iter().enumerate() {
            match twin.get(image as usize) {
                None => return Err(out_of_range("twin", h, image, twin.len())),
                Some(_) if image as usize == h => {
                    return Err(Error::invalid(format!("twin leaves h{h} where it is"))
                        .with_cure("give a boundary edge a second halfedge on the outer side"));
                }
                Some(&back) if back as usize != h => {
                    return Err(Error::invalid(format!(
                        "twin takes h{h} to h{image}, but h{image} to h{back}"
                    ))
                    .with_cure("halfedges must come in pairs"));
                }
                Some(_) if h < image as usize => {
                    (images[h], images[image as usize]) = (count, count + 1);
                    count += 2;
                }
                Some(_) => {}
            }
        }
        Ok(Permutation::from_images(images).expect("an involution without fixed points pairs its points"))
    }

    /// The surface of a permutation of an even number of halfedges. Vertices and faces are numbered as `order` meets them.
    fn from_trusted_next<I: Iterator<Item = u32>>(next: Vec<u32>, order: impl Fn() -> I) -> Self {
        let (face, face_halfedge) = orbits(next.len(), order(), |h| next[h as usize]);
        let (source, vertex_halfedge) = orbits(next.len(), order(), |h| next[(h ^ 1) as usize]);
        let face_count = face_halfedge.len();
        Self { next, source, face, vertex_halfedge, face_halfedge, face_count }
    }

    /// The number of halfedges, those along outer faces included: twice the number of edges.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.halfedge_count(), 4);
    /// # Ok(()) }
    /// ```
    pub fn halfedge_count(&self) -> usize {
        self.next.len()
    }

    /// The number of vertices, isolated ones included.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.vertex_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn vertex_count(&self) -> usize {
        self.vertex_halfedge.len()
    }

    /// The number of edges.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.edge_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn edge_count(&self) -> usize {
        self.next.len() / 2
    }

    /// The number of faces, outer ones not counted: they are `0..face_count()`.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.face_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn face_count(&self) -> usize {
        self.face_count
    }

    /// The number of outer faces, that is of boundary loops: they are `face_count()..face_count() + outer_face_count()`.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.outer_face_count(), 0);
    /// # Ok(()) }
    /// ```
    pub fn outer_face_count(&self) -> usize {
        self.face_halfedge.len() - self.face_count
    }

    /// The numbers of vertices, edges and faces, outer faces not counted.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.f_vector(), [1, 2, 1]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> Vec<usize> {
        vec![self.vertex_count(), self.edge_count(), self.face_count]
    }

    /// The halfedge after this one around its face.
    ///
    /// # Panics
    /// If there is no such halfedge; so do all functions of halfedges.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.next(HalfedgeId::new(0)), HalfedgeId::new(2));
    /// # Ok(()) }
    /// ```
    #[inline]
    pub fn next(&self, halfedge: HalfedgeId) -> HalfedgeId {
        HalfedgeId::from_u32(self.next[halfedge.index()])
    }

    /// The halfedge before this one around its face.
    ///
    /// # Complexity
    /// The smaller of the sizes of its face and its source, about twice: it is looked for around both at once.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// use coface_algebra::HalfedgeId;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 4, 5, 0, 1])?;
    /// assert_eq!(torus.previous(HalfedgeId::new(0)), HalfedgeId::new(4));
    /// # Ok(()) }
    /// ```
    pub fn previous(&self, halfedge: HalfedgeId) -> HalfedgeId {
        let wanted = halfedge.to_u32();
        // Around the face the candidate goes along next; around the source it is the twin of the halfedge reached.
        let (mut in_face, mut leaving) = (wanted, wanted);
        loop {
            let after = self.next[in_face as usize];
            if after == wanted {
                return HalfedgeId::from_u32(in_face);
            }
            in_face = after;
            let turned = self.next[(leaving ^ 1) as usize];
            if turned == wanted {
                return HalfedgeId::from_u32(leaving ^ 1);
            }
            leaving = turned;
        }
    }

    /// The other halfedge of the edge.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.twin(HalfedgeId::new(0)), HalfedgeId::new(1));
    /// # Ok(()) }
    /// ```
    #[inline]
    pub fn twin(&self, halfedge: HalfedgeId) -> HalfedgeId {
        HalfedgeId::from_u32(halfedge.to_u32() ^ 1)
    }

    /// The vertex a halfedge leaves.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.source(HalfedgeId::new(0)).index(), 0);
    /// # Ok(()) }
    /// ```
    #[inline]
    pub fn source(&self, halfedge: HalfedgeId) -> VertexId {
        VertexId::from_u32(self.source[halfedge.index()])
    }

    /// The vertex a halfedge goes to.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.target(HalfedgeId::new(0)).index(), 0);
    /// # Ok(()) }
    /// ```
    #[inline]
    pub fn target(&self, halfedge: HalfedgeId) -> VertexId {
        VertexId::from_u32(self.source[halfedge.index() ^ 1])
    }

    /// The edge of a halfedge.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.edge(HalfedgeId::new(3)).index(), 1);
    /// # Ok(()) }
    /// ```
    #[inline]
    pub fn edge(&self, halfedge: HalfedgeId) -> EdgeId {
        EdgeId::from_u32(halfedge.to_u32() >> 1)
    }

    /// The face that a halfedge runs around, to its left; an outer one along the boundary.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.face(HalfedgeId::new(3)).index(), 0);
    /// # Ok(()) }
    /// ```
    #[inline]
    pub fn face(&self, halfedge: HalfedgeId) -> FaceId {
        FaceId::from_u32(self.face[halfedge.index()])
    }

    /// The halfedge of an edge in the direction of the edge; its twin is the other one.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.edge_halfedge(EdgeId::new(1)).index(), 2);
    /// # Ok(()) }
    /// ```
    #[inline]
    pub fn edge_halfedge(&self, edge: EdgeId) -> HalfedgeId {
        HalfedgeId::from_u32(edge.to_u32() << 1)
    }

    /// A halfedge that leaves a vertex: on the boundary the one along the outer face; else any, and the same one until the
    /// mesh is changed. `None` for an isolated vertex.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert!(torus.vertex_halfedge(VertexId::new(0)).is_some());
    /// # Ok(()) }
    /// ```
    #[inline]
    pub fn vertex_halfedge(&self, vertex: VertexId) -> Option<HalfedgeId> {
        let halfedge = self.vertex_halfedge[vertex.index()];
        (halfedge != NONE).then_some(HalfedgeId::from_u32(halfedge))
    }

    /// The first halfedge of a face, outer faces included. In a mesh made from polygons: the first side of the polygon.
    ///
    /// # Panics
    /// If there is no such face.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::FaceId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.face_halfedge(FaceId::new(0)).index(), 0);
    /// # Ok(()) }
    /// ```
    #[inline]
    pub fn face_halfedge(&self, face: FaceId) -> HalfedgeId {
        HalfedgeId::from_u32(self.face_halfedge[face.index()])
    }

    /// Whether a face is an outer one, which fills a boundary loop.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::FaceId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert!(!torus.is_outer(FaceId::new(0)));
    /// # Ok(()) }
    /// ```
    #[inline]
    pub fn is_outer(&self, face: FaceId) -> bool {
        face.index() >= self.face_count
    }

    /// Whether a halfedge runs along an outer face, with the surface on its right.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::HalfedgeId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert!(!torus.is_outer_halfedge(HalfedgeId::new(0)));
    /// # Ok(()) }
    /// ```
    #[inline]
    pub fn is_outer_halfedge(&self, halfedge: HalfedgeId) -> bool {
        self.is_outer(self.face(halfedge))
    }

    /// Whether an edge lies on the boundary.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::EdgeId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert!(!torus.is_boundary_edge(EdgeId::new(0)));
    /// # Ok(()) }
    /// ```
    #[inline]
    pub fn is_boundary_edge(&self, edge: EdgeId) -> bool {
        let h = self.edge_halfedge(edge);
        self.is_outer_halfedge(h) || self.is_outer_halfedge(self.twin(h))
    }

    /// Whether a vertex lies on the boundary.
    ///
    /// # Panics
    /// If there is no such vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert!(!torus.is_boundary_vertex(VertexId::new(0)));
    /// # Ok(()) }
    /// ```
    #[inline]
    pub fn is_boundary_vertex(&self, vertex: VertexId) -> bool {
        self.vertex_halfedge(vertex).is_some_and(|h| self.is_outer_halfedge(h))
    }

    /// Whether there is no boundary.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert!(torus.is_closed());
    /// # Ok(()) }
    /// ```
    pub fn is_closed(&self) -> bool {
        self.outer_face_count() == 0
    }

    /// The sources and targets of all edges, two by two.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.edge_ends(), [0, 0, 0, 0]);
    /// # Ok(()) }
    /// ```
    pub fn edge_ends(&self) -> &[u32] {
        &self.source
    }

    /// The connected components; each isolated vertex is one.
    ///
    /// # Complexity
    /// Nearly linear, by union-find along the edges.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let spheres = HalfedgeMesh::from_next((0..10).collect())?;
    /// assert_eq!(spheres.components().count(), 5);
    /// # Ok(()) }
    /// ```
    pub fn components(&self) -> Components {
        Components::of_graph(self.vertex_count(), &self.source)
    }

    /// The number of connected components: orbits of the group that `next` and `twin` generate, and isolated vertices.
    ///
    /// # Complexity
    /// That of [`Self::components`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.component_count(), 1);
    /// # Ok(()) }
    /// ```
    pub fn component_count(&self) -> usize {
        self.components().count()
    }

    /// Vertices minus edges plus faces, outer faces not counted. In each component of a closed surface it is even.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.euler_characteristic(), 0);
    /// # Ok(()) }
    /// ```
    pub fn euler_characteristic(&self) -> i64 {
        let (v, e, f) = (self.vertex_count(), self.edge_count(), self.face_count());
        v as i64 - e as i64 + f as i64
    }

    /// The sum of the genera of the components: $2 - 2g - b$ is the Euler characteristic of one with b boundary loops.
    ///
    /// # Complexity
    /// That of [`Self::components`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.genus(), 1);
    /// # Ok(()) }
    /// ```
    pub fn genus(&self) -> usize {
        let isolated = self.vertex_halfedge.iter().filter(|&&h| h == NONE).count() as i64;
        let surfaces = self.component_count() as i64 - isolated;
        let closed = self.euler_characteristic() - isolated + self.outer_face_count() as i64;
        usize::try_from(surfaces - closed / 2)
            .expect("a closed connected surface has Euler characteristic at most 2")
    }

    /// Which surface the mesh is, if it is connected and no isolated vertex; `None` for the empty mesh.
    ///
    /// # Complexity
    /// That of [`Self::components`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.surface().map(|surface| surface.to_string()).as_deref(), Some("torus"));
    /// # Ok(()) }
    /// ```
    pub fn surface(&self) -> Option<SurfaceType> {
        let is_one = self.halfedge_count() > 0 && self.component_count() == 1;
        is_one.then(|| SurfaceType::orientable(self.genus(), self.outer_face_count()))
    }

    /// The chain complex of vertices, edges and faces in the order of their ids, outer faces left out. A face that runs
    /// along an edge once each way has no part of it in its boundary.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] for boundary matrices beyond 32 bits.
    ///
    /// # Complexity
    /// Nearly linear.
    ///
    /// # Examples
    /// The square torus: one vertex, two edges, one face, and no boundary anywhere.
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// let complex = torus.chain_complex()?;
    /// assert_eq!(complex.f_vector(), [1, 2, 1]);
    /// assert!(complex.boundary_matrices().iter().all(|matrix| matrix.entry_count() == 0));
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.two_skeleton()?.chain_complex()
    }
}

/// Checks that `next` is a permutation.
pub(super) fn check_next(next: &[u32]) -> Result<(), Error> {
    let mut is_met = vec![false; next.len()];
    for (h, &image) in next.iter().enumerate() {
        match is_met.get_mut(image as usize) {
            None => return Err(out_of_range("next", h, image, next.len())),
            Some(met) if *met => {
                let earlier =
                    next.iter().position(|&other| other == image).expect("it was met at an earlier halfedge");
                return Err(Error::invalid(format!(
                    "next is no permutation: h{earlier} and h{h} both go to h{image}"
                ))
                .with_cure("each halfedge must follow exactly one"));
            }
            Some(met) => *met = true,
        }
    }
    Ok(())
}

pub(super) fn check_limit(count: usize) -> Result<(), Error> {
    if count >= LIMIT {
        return Err(Error::new(ErrorKind::TooLarge, format!("{count} halfedges; the limit is 2^31 - 1")));
    }
    Ok(())
}

fn out_of_range(name: &str, h: usize, image: u32, count: usize) -> Error {
    Error::invalid(format!("{name} takes h{h} to h{image}, but there are {count} halfedges"))
        .with_cure("number the halfedges from 0")
}

/// The number of the orbit of each halfedge and the first halfedge of each orbit, orbits numbered in the order in which
/// `order` meets them.
fn orbits(
    count: usize,
    order: impl Iterator<Item = u32>,
    permutation: impl Fn(u32) -> u32,
) -> (Vec<u32>, Vec<u32>) {
    let mut orbit = vec![NONE; count];
    let mut firsts = Vec::new();
    for start in order {
        let mut at = start;
        while orbit[at as usize] == NONE {
            orbit[at as usize] = firsts.len() as u32;
            at = permutation(at);
        }
        if orbit[start as usize] as usize == firsts.len() {
            firsts.push(start);
        }
    }
    (orbit, firsts)
}
