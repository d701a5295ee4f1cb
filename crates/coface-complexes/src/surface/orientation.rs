//! Orientation of surfaces: are the faces coherent, can they be, and if not, why.

use super::PolygonMesh;
use super::dual_graph::{DualGraph, coherence};
use coface_algebra::Sign;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, Fault};

/// How the faces of a mesh are oriented and whether they can be oriented coherently.
///
/// Two faces on a common edge agree when they run through it in opposite directions. The question is decided across
/// the edges with exactly two faces; with an edge in three or more faces it has no answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct SurfaceOrientation {
    many_faced_edge: Option<EdgeId>,
    conflicts: Vec<EdgeId>,
    /// The sign of each face that makes all agree, empty when all are plus.
    signs: Vec<Sign>,
    odd_cycle: Option<OddFaceCycle>,
}

/// A closed chain of faces that cannot all agree: a Moebius band, possibly meeting itself in vertices.
///
/// Face i and face i + 1 share edge i; the last and the first share the last edge. The faces are distinct, and so are
/// the edges. However the faces are turned, an odd number of these edges is run through twice in the same direction.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OddFaceCycle {
    faces: Vec<FaceId>,
    edges: Vec<EdgeId>,
}

impl OddFaceCycle {
    /// The faces in order.
    pub fn faces(&self) -> &[FaceId] {
        &self.faces
    }

    /// The edges in order: edge i is shared by face i and the next.
    pub fn edges(&self) -> &[EdgeId] {
        &self.edges
    }
}

impl SurfaceOrientation {
    /// Whether the faces can be turned so that all agree; `None` when an edge lies in three or more faces.
    pub fn is_orientable(&self) -> Option<bool> {
        self.many_faced_edge.is_none().then_some(self.odd_cycle.is_none())
    }

    /// Whether all faces agree as they are listed; `None` when an edge lies in three or more faces.
    pub fn is_coherent(&self) -> Option<bool> {
        self.many_faced_edge.is_none().then_some(self.conflicts.is_empty())
    }

    /// The first edge in three or more faces, for which the questions have no answer.
    pub fn many_faced_edge(&self) -> Option<EdgeId> {
        self.many_faced_edge
    }

    /// The edges with exactly two faces that run through it in the same direction, rising.
    pub fn conflicts(&self) -> &[EdgeId] {
        &self.conflicts
    }

    /// Why there is no coherent orientation.
    pub fn odd_cycle(&self) -> Option<&OddFaceCycle> {
        self.odd_cycle.as_ref()
    }

    /// The sign of a face: minus if it must be turned around for a coherent orientation in which the first face of each
    /// strongly connected part keeps its direction. Plus when there is no coherent orientation.
    pub fn sign(&self, face: FaceId) -> Sign {
        self.signs.get(face.index()).copied().unwrap_or(Sign::Plus)
    }
}

impl PolygonMesh {
    /// Whether the faces agree, whether they can be made to, and a closed chain of faces that cannot if not.
    ///
    /// # Complexity
    /// Linear when the faces agree as listed; else nearly linear, by union-find with signs. The odd cycle is found by a
    /// breadth-first search in the orientation double cover, and is shortest through one of its faces before it is
    /// made simple.
    ///
    /// # References
    /// H. Seifert, W. Threlfall, *Lehrbuch der Topologie* (1934), section 38, for orientability by closed chains.
    ///
    /// # Examples
    /// The Moebius band of five triangles:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangles = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]];
    /// let band = PolygonMesh::new(5, RaggedArray::from_lists(triangles), &[])?;
    /// let orientation = band.orientation();
    /// assert_eq!(orientation.is_orientable(), Some(false));
    /// assert_eq!(orientation.odd_cycle().expect("a Moebius band").faces().len(), 5);
    /// # Ok(()) }
    /// ```
    pub fn orientation(&self) -> SurfaceOrientation {
        let found = coherence(self);
        SurfaceOrientation {
            many_faced_edge: found.crowded_wall.map(EdgeId::new),
            conflicts: found.conflicts.into_iter().map(EdgeId::from_u32).collect(),
            signs: found.signs,
            odd_cycle: found.odd_cycle.map(|(faces, edges)| OddFaceCycle {
                faces: faces.into_iter().map(FaceId::from_u32).collect(),
                edges: edges.into_iter().map(EdgeId::from_u32).collect(),
            }),
        }
    }

    /// The mesh with its faces turned so that all agree; the first face of each strongly connected part keeps its
    /// direction.
    ///
    /// # Errors
    /// [`ErrorKind::NonManifold`] when an edge lies in three or more faces, and when the mesh is not orientable; both
    /// name the place.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// use coface_algebra::FaceId;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mesh = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2], [1, 2, 3]]), &[])?;
    /// assert_eq!(mesh.oriented()?.face(FaceId::new(1)), [3, 2, 1]);
    /// # Ok(()) }
    /// ```
    pub fn oriented(&self) -> Result<Self, Error> {
        let orientation = self.orientation();
        if let Some(edge) = orientation.many_faced_edge {
            let [a, b] = self.edge(edge);
            return Err(Error::new(
                ErrorKind::NonManifold,
                format!(
                    "edge {edge} = {{{a}, {b}}} lies in {} faces, so faces cannot agree across it",
                    self.face_count_at(edge)
                ),
            )
            .with_fault(Fault::EdgeInFaces {
                edge: [a, b],
                faces: self.faces_of_edge(edge).map(|(face, _)| face).collect(),
            })
            .with_cure("split the mesh there first"));
        }
        if let Some(cycle) = &orientation.odd_cycle {
            return Err(Error::new(
                ErrorKind::NonManifold,
                format!(
                    "the mesh is not orientable: the {} faces from {} around to it again form a Moebius band",
                    cycle.faces.len(),
                    cycle.faces[0]
                ),
            )
            .with_fault(Fault::OddCycle { faces: cycle.faces.clone() })
            .with_cure("cut the mesh open, or take its orientation double cover"));
        }
        if orientation.signs.is_empty() {
            return Ok(self.clone());
        }
        Ok(self.with_face_signs(&orientation.signs))
    }
}

impl DualGraph for PolygonMesh {
    fn node_count(&self) -> usize {
        self.face_count()
    }

    fn wall_count(&self) -> usize {
        self.edge_count()
    }

    fn walls_of(&self, face: u32) -> impl Iterator<Item = u32> {
        self.side_edges(face as usize).iter().copied()
    }

    fn nodes_at(&self, edge: usize) -> &[u32] {
        self.packed_faces(edge)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::RaggedArray;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    /// Whether some choice of signs lets all faces agree across the edges with two faces: all choices are tried.
    fn some_signs_agree(mesh: &PolygonMesh) -> bool {
        (0u32..1 << mesh.face_count()).any(|turned| {
            (0..mesh.edge_count()).all(|edge| match mesh.packed_faces(edge) {
                &[f, g] => (f ^ (turned >> (f >> 1)) ^ g ^ (turned >> (g >> 1))) & 1 == 1,
                _ => true,
            })
        })
    }

    fn check_odd_cycle(mesh: &PolygonMesh, cycle: &OddFaceCycle) {
        let n = cycle.faces().len();
        assert_eq!(cycle.edges().len(), n);
        assert_eq!(cycle.faces().iter().collect::<BTreeSet<_>>().len(), n, "no face twice");
        assert_eq!(cycle.edges().iter().collect::<BTreeSet<_>>().len(), n, "no edge twice");
        let mut conflicts = 0;
        for (i, &edge) in cycle.edges().iter().enumerate() {
            let around: Vec<(FaceId, Sign)> = mesh.faces_of_edge(edge).collect();
            let [(f, s), (g, t)] = around[..] else { panic!("{edge} has {} faces", around.len()) };
            let pair = BTreeSet::from([cycle.faces()[i], cycle.faces()[(i + 1) % n]]);
            assert_eq!(BTreeSet::from([f, g]), pair);
            conflicts += usize::from(s == t);
        }
        assert_eq!(conflicts % 2, 1);
    }

    proptest! {
        #[test]
        fn orientability_agrees_with_trying_all_signs(
            polygons in prop::collection::vec(
                (Just((0u32..7).collect::<Vec<_>>()).prop_shuffle(), 3usize..5).prop_map(|(mut v, n)| { v.truncate(n); v }),
                0..10,
            ),
        ) {
            let mesh = PolygonMesh::new(7, RaggedArray::from_lists(&polygons), &[[0, 1]]).unwrap();
            let orientation = mesh.orientation();
            prop_assert_eq!(orientation.odd_cycle().is_none(), some_signs_agree(&mesh));
            if let Some(cycle) = orientation.odd_cycle() {
                check_odd_cycle(&mesh, cycle);
            }
            let many = (0..mesh.edge_count()).any(|e| mesh.packed_faces(e).len() > 2);
            prop_assert_eq!(orientation.is_orientable().is_none(), many);
            match mesh.oriented() {
                Ok(turned) => {
                    prop_assert_eq!(turned.orientation().is_coherent(), Some(true));
                    prop_assert_eq!(turned.edge_ends(), mesh.edge_ends());
                    prop_assert_eq!(turned.loose_edge(0), mesh.loose_edge(0));
                }
                Err(error) => prop_assert!(many || orientation.odd_cycle().is_some(), "{error}"),
            }
        }

        /// A strip of triangles closed with a half turn: the shortest odd cycle is the strip.
        #[test]
        fn the_odd_cycle_of_a_band_is_the_band(half in 2u32..20, turned in prop::collection::vec(any::<bool>(), 41)) {
            let n = 2 * half + 1;
            let triangles: Vec<[u32; 3]> = (0..n)
                .map(|i| {
                    let (a, b) = (i, (i + 1) % n);
                    if turned[i as usize] { [b, a, (i + 2) % n] } else { [a, b, (i + 2) % n] }
                })
                .collect();
            let band = PolygonMesh::new(n as usize, RaggedArray::from_lists(triangles), &[]).unwrap();
            let orientation = band.orientation();
            let cycle = orientation.odd_cycle().unwrap();
            check_odd_cycle(&band, cycle);
            prop_assert_eq!(cycle.faces().len(), n as usize);
        }
    }
}
