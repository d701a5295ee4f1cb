//! Halfedge meshes: a closed oriented surface as two permutations.

use crate::algebra::{SparseMatrix, UnionFind};
use crate::chains::ChainComplex;
use crate::{EdgeId, Error, FaceId, HalfedgeId, IdVec, VertexId};

/// A closed oriented surface as two permutations of its halfedges: `next`, and `twin`, an involution without fixed
/// points.
///
/// Faces are the orbits of `next`, edges the orbits of `twin`, vertices the orbits of "twin, then next": the halfedges
/// that leave a vertex. Any two such permutations are a surface, cells that touch themselves included: a torus with
/// one vertex, a monogon, a segment in a digon. Orbits are numbered by their smallest halfedges; an edge points as its
/// smaller halfedge does.
///
/// # References
/// J. Edmonds, *A combinatorial representation for polyhedral surfaces* (1960).
///
/// # Examples
/// The torus with one vertex, of two triangles:
/// ```
/// use coface::surface::HalfedgeMesh;
/// # fn main() -> Result<(), coface::Error> {
/// let torus = HalfedgeMesh::from_next(vec![2, 3, 4, 5, 0, 1])?;
/// assert_eq!(torus.f_vector(), [1, 3, 2]);
/// assert_eq!(torus.genus(), 1);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct HalfedgeMesh {
    next: Vec<u32>,
    twin: Vec<u32>,
    source: IdVec<HalfedgeId, VertexId>,
    edge: IdVec<HalfedgeId, EdgeId>,
    face: IdVec<HalfedgeId, FaceId>,
    counts: [usize; 3],
    component_count: usize,
}

impl HalfedgeMesh {
    /// The surface of these permutations of `0..next.len()`.
    ///
    /// # Errors
    /// [`crate::ErrorKind::InvalidInput`] naming the first halfedge where `next` is no permutation, or `twin` no involution without
    /// fixed points; [`crate::ErrorKind::Shape`] if the two differ in length;
    /// [`crate::ErrorKind::TooLarge`] from 2^31 halfedges on.
    pub fn from_permutations(next: Vec<u32>, twin: Vec<u32>) -> Result<Self, Error> {
        let count = next.len();
        if twin.len() != count {
            return Err(Error::new(
                crate::ErrorKind::Shape,
                format!("next has {count} halfedges, but twin has {}", twin.len()),
            ));
        }
        if count >= 1 << 31 {
            return Err(Error::new(
                crate::ErrorKind::TooLarge,
                format!("{count} halfedges; the limit is 2^31 - 1"),
            ));
        }
        let mut from: Vec<Option<usize>> = vec![None; count];
        for (h, &image) in next.iter().enumerate() {
            let Some(earlier) = from.get_mut(image as usize) else {
                return Err(out_of_range("next", h, image, count));
            };
            if let Some(earlier) = earlier.replace(h) {
                return Err(Error::invalid(format!(
                    "next is no permutation: h{earlier} and h{h} both go to h{image}"
                ))
                .with_cure("each halfedge must follow exactly one"));
            }
        }
        for (h, &image) in twin.iter().enumerate() {
            match twin.get(image as usize) {
                None => return Err(out_of_range("twin", h, image, count)),
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
                Some(_) => {}
            }
        }
        let (edge, edge_count) = orbits(count, |h| twin[h as usize]);
        let (face, face_count) = orbits(count, |h| next[h as usize]);
        let (source, vertex_count) = orbits(count, |h| next[twin[h as usize] as usize]);
        let mut partition = UnionFind::new(count);
        for h in 0..count as u32 {
            partition.unite(h, next[h as usize]);
            partition.unite(h, twin[h as usize]);
        }
        Ok(Self {
            next,
            twin,
            source: source.into_iter().map(VertexId::from_u32).collect(),
            edge: edge.into_iter().map(EdgeId::from_u32).collect(),
            face: face.into_iter().map(FaceId::from_u32).collect(),
            counts: [vertex_count, edge_count, face_count],
            component_count: partition.class_count(),
        })
    }

    /// The surface with this `next` in which halfedges 2i and 2i + 1 are twins.
    ///
    /// # Errors
    /// Those of [`Self::from_permutations`]; an odd number of halfedges is one.
    pub fn from_next(next: Vec<u32>) -> Result<Self, Error> {
        if !next.len().is_multiple_of(2) {
            return Err(Error::invalid(format!("{} halfedges cannot be paired", next.len()))
                .with_cure("give an even number of halfedges, or twin as well"));
        }
        let twin = (0..next.len() as u32).map(|h| h ^ 1).collect();
        Self::from_permutations(next, twin)
    }

    /// The number of halfedges.
    pub fn halfedge_count(&self) -> usize {
        self.next.len()
    }

    /// The numbers of vertices, edges and faces.
    pub fn f_vector(&self) -> [usize; 3] {
        self.counts
    }

    /// The halfedge after this one around its face.
    ///
    /// # Panics
    /// If there is no such halfedge; so do the four functions that follow.
    pub fn next(&self, halfedge: HalfedgeId) -> HalfedgeId {
        HalfedgeId::from_u32(self.next[halfedge.index()])
    }

    /// The other halfedge of the edge.
    pub fn twin(&self, halfedge: HalfedgeId) -> HalfedgeId {
        HalfedgeId::from_u32(self.twin[halfedge.index()])
    }

    /// The vertex a halfedge leaves.
    pub fn source(&self, halfedge: HalfedgeId) -> VertexId {
        self.source[halfedge]
    }

    /// The vertex a halfedge goes to.
    pub fn target(&self, halfedge: HalfedgeId) -> VertexId {
        self.source[self.twin(halfedge)]
    }

    /// The edge of a halfedge.
    pub fn edge(&self, halfedge: HalfedgeId) -> EdgeId {
        self.edge[halfedge]
    }

    /// The face that a halfedge runs around.
    pub fn face(&self, halfedge: HalfedgeId) -> FaceId {
        self.face[halfedge]
    }

    /// The number of connected components: orbits of the group that `next` and `twin` generate.
    pub fn component_count(&self) -> usize {
        self.component_count
    }

    /// Vertices minus edges plus faces; even in each component.
    pub fn euler_characteristic(&self) -> i64 {
        let [v, e, f] = self.counts;
        v as i64 - e as i64 + f as i64
    }

    /// The sum of the genera of the components.
    pub fn genus(&self) -> usize {
        let handles = self.component_count as i64 - self.euler_characteristic() / 2;
        usize::try_from(handles).expect("a closed connected surface has Euler characteristic at most 2")
    }

    /// The chain complex of vertices, edges and faces. A face that runs along an edge once each way has no part of it in
    /// its boundary.
    ///
    /// # Examples
    /// The square torus: one vertex, two edges, one face, and no boundary anywhere.
    /// ```
    /// use coface::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// let complex = torus.chain_complex();
    /// assert_eq!(complex.f_vector(), [1, 2, 1]);
    /// assert!(complex.boundary_matrices().iter().all(|matrix| matrix.entry_count() == 0));
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> ChainComplex {
        let [vertex_count, edge_count, face_count] = self.counts;
        if edge_count == 0 {
            return ChainComplex::of_points(vertex_count);
        }
        let halfedges = || (0..self.halfedge_count()).map(HalfedgeId::new);
        let is_first = |h: HalfedgeId| h < self.twin(h);
        let edges = halfedges().filter(|&h| is_first(h)).flat_map(|h| {
            let column = self.edge(h).index();
            [(self.target(h).index(), column, 1), (self.source(h).index(), column, -1)]
        });
        let faces = halfedges()
            .map(|h| (self.edge(h).index(), self.face(h).index(), if is_first(h) { 1 } else { -1 }));
        let boundaries = vec![
            SparseMatrix::from_entries(vertex_count, edge_count, edges).expect("each entry is at most 2"),
            SparseMatrix::from_entries(edge_count, face_count, faces).expect("each entry is at most 2"),
        ];
        ChainComplex::new(boundaries).expect("the halfedges of a face are a cycle")
    }
}

fn out_of_range(name: &str, h: usize, image: u32, count: usize) -> Error {
    Error::invalid(format!("{name} takes h{h} to h{image}, but there are {count} halfedges"))
        .with_cure("number the halfedges from 0")
}

/// The number of the orbit of each halfedge, orbits numbered by their smallest members, and how many there are.
fn orbits(count: usize, permutation: impl Fn(u32) -> u32) -> (Vec<u32>, usize) {
    const UNSEEN: u32 = u32::MAX;
    let mut orbit = vec![UNSEEN; count];
    let mut orbit_count = 0;
    for start in 0..count as u32 {
        let mut at = start;
        while orbit[at as usize] == UNSEEN {
            orbit[at as usize] = orbit_count;
            at = permutation(at);
        }
        orbit_count += u32::from(orbit[start as usize] == orbit_count);
    }
    (orbit, orbit_count as usize)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    #[test]
    fn a_cone_with_a_monogon_is_a_sphere() {
        let mesh = HalfedgeMesh::from_permutations(vec![1, 2, 0, 3], vec![1, 0, 3, 2]).unwrap();
        assert_eq!((mesh.f_vector(), mesh.euler_characteristic(), mesh.genus()), ([2, 2, 2], 2, 0));
        let sources: Vec<usize> = (0..4).map(|h| mesh.source(HalfedgeId::new(h)).index()).collect();
        assert_eq!(sources, [0, 1, 0, 0]);
    }

    #[test]
    fn small_permutations_have_the_known_orbits() {
        let table: [(&[u32], [usize; 3], usize); 6] = [
            (&[2, 3, 4, 5, 0, 1], [1, 3, 2], 1), // the one-vertex torus
            (&[2, 5, 4, 1, 0, 3], [3, 3, 2], 0), // its second triangle backwards: a sphere
            (&[2, 3, 1, 0], [1, 2, 1], 1),       // the square torus
            (&[0, 1], [1, 1, 2], 0),             // a loop between two monogons
            (&[1, 0], [2, 1, 1], 0),             // a segment in a digon
            (&[], [0, 0, 0], 0),
        ];
        for (next, f_vector, genus) in table {
            let mesh = HalfedgeMesh::from_next(next.to_vec()).unwrap();
            assert_eq!((mesh.f_vector(), mesh.genus()), (f_vector, genus), "{next:?}");
        }
        let spheres = HalfedgeMesh::from_next((0..10).collect()).unwrap();
        assert_eq!((spheres.component_count(), spheres.euler_characteristic()), (5, 10));
    }

    #[test]
    fn faults_name_the_halfedge() {
        let fault = |next: &[u32], twin: &[u32]| {
            HalfedgeMesh::from_permutations(next.to_vec(), twin.to_vec()).unwrap_err().message().to_owned()
        };
        assert_eq!(fault(&[0, 0], &[1, 0]), "next is no permutation: h0 and h1 both go to h0");
        assert_eq!(fault(&[0, 2], &[1, 0]), "next takes h1 to h2, but there are 2 halfedges");
        assert_eq!(fault(&[0, 1], &[0, 1]), "twin leaves h0 where it is");
        assert_eq!(fault(&[0, 1, 2, 3], &[1, 2, 3, 0]), "twin takes h0 to h1, but h1 to h2");
        assert_eq!(fault(&[0, 1], &[1, 5]), "twin takes h0 to h1, but h1 to h5");
        assert_eq!(fault(&[0, 1], &[7, 0]), "twin takes h0 to h7, but there are 2 halfedges");
        assert_eq!(fault(&[0, 1], &[]), "next has 2 halfedges, but twin has 0");
        assert_eq!(HalfedgeMesh::from_next(vec![0]).unwrap_err().message(), "1 halfedges cannot be paired");
    }

    /// All permutations of `0..n`, by inserting the last element everywhere.
    fn permutations(n: u32) -> Vec<Vec<u32>> {
        if n == 0 {
            return vec![Vec::new()];
        }
        permutations(n - 1)
            .into_iter()
            .flat_map(|p| {
                (0..n as usize).map(move |at| {
                    let mut longer = p.clone();
                    longer.insert(at, n - 1);
                    longer
                })
            })
            .collect()
    }

    #[test]
    fn all_surfaces_of_up_to_three_edges_are_counted() {
        // Connected ones by genus, then disconnected ones; the numbers were found by an independent program.
        let table = [(1, vec![(0, 2)], 0), (2, vec![(0, 18), (1, 2)], 4), (3, vec![(0, 432), (1, 160)], 128)];
        for (edges, by_genus, disconnected) in table {
            let mut counted: BTreeMap<usize, usize> = BTreeMap::new();
            let mut several = 0;
            for next in permutations(2 * edges) {
                let mesh = HalfedgeMesh::from_next(next).unwrap();
                if mesh.component_count() == 1 {
                    *counted.entry(mesh.genus()).or_default() += 1;
                } else {
                    several += 1;
                }
            }
            assert_eq!((counted.into_iter().collect::<Vec<_>>(), several), (by_genus, disconnected));
        }
    }

    proptest! {
        #[test]
        fn any_two_permutations_are_a_closed_surface(
            next in Just((0u32..24).collect::<Vec<_>>()).prop_shuffle(),
            pairs in Just((0u32..24).collect::<Vec<_>>()).prop_shuffle(),
        ) {
            let mut twin = vec![0; 24];
            for pair in pairs.chunks(2) {
                twin[pair[0] as usize] = pair[1];
                twin[pair[1] as usize] = pair[0];
            }
            let mesh = HalfedgeMesh::from_permutations(next, twin).unwrap();
            prop_assert_eq!(mesh.euler_characteristic() % 2, 0);
            let complex = mesh.chain_complex();
            prop_assert_eq!(complex.f_vector(), mesh.f_vector());
            for h in (0..24).map(HalfedgeId::new) {
                prop_assert_eq!(mesh.target(h), mesh.source(mesh.next(h)));
                prop_assert_eq!(mesh.face(h), mesh.face(mesh.next(h)));
                prop_assert_eq!(mesh.edge(h), mesh.edge(mesh.twin(h)));
            }
            // Orbits are numbered by their smallest halfedges.
            let mut seen = 0;
            for h in (0..24).map(HalfedgeId::new) {
                prop_assert!(mesh.source(h).index() <= seen);
                seen = seen.max(mesh.source(h).index() + 1);
            }
            prop_assert_eq!(seen, mesh.f_vector()[0]);
            // Closed and oriented: the sum of the faces of each component is a cycle.
            let faces = complex.boundary_matrix(2).unwrap().transpose();
            for edge in faces.columns() {
                prop_assert_eq!(edge.entries().iter().sum::<i32>(), 0);
            }
        }
    }
}
