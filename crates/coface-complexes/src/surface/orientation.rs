//! Orientation of surfaces: are the faces coherent, can they be, and if not, why.

use super::PolygonMesh;
use super::dual_graph::{DualGraph, coherence};
use crate::coherence::Coherence;
use coface_algebra::{EdgeId, Error, ErrorKind, FaceId, Fault};

/// How the faces of a mesh are oriented and whether they can be oriented coherently, across the edges with two faces.
pub type SurfaceOrientation = Coherence<FaceId, EdgeId>;

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
    /// assert_eq!(orientation.odd_cycle().expect("a Moebius band").cells().len(), 5);
    /// # Ok(()) }
    /// ```
    pub fn orientation(&self) -> SurfaceOrientation {
        coherence(self)
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
        if let Some(edge) = orientation.crowded_facet() {
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
                    cycle.cells.len(),
                    cycle.cells[0]
                ),
            )
            .with_fault(Fault::OddCycle { faces: cycle.cells.clone() })
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

    fn facet_count(&self) -> usize {
        self.edge_count()
    }

    fn facets_of(&self, face: u32) -> impl Iterator<Item = u32> {
        self.side_edges(face as usize).iter().copied()
    }

    fn nodes_at(&self, edge: usize) -> &[u32] {
        self.packed_faces(edge)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::coherence::OddCycle;
    use coface_algebra::{RaggedArray, Sign};
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

    fn check_odd_cycle(mesh: &PolygonMesh, cycle: &OddCycle<FaceId, EdgeId>) {
        let n = cycle.cells().len();
        assert_eq!(cycle.facets().len(), n);
        assert_eq!(cycle.cells().iter().collect::<BTreeSet<_>>().len(), n, "no face twice");
        assert_eq!(cycle.facets().iter().collect::<BTreeSet<_>>().len(), n, "no edge twice");
        let mut conflicts = 0;
        for (i, &edge) in cycle.facets().iter().enumerate() {
            let around: Vec<(FaceId, Sign)> = mesh.faces_of_edge(edge).collect();
            let [(f, s), (g, t)] = around[..] else { panic!("{edge} has {} faces", around.len()) };
            let pair = BTreeSet::from([cycle.cells()[i], cycle.cells()[(i + 1) % n]]);
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
            prop_assert_eq!(cycle.cells().len(), n as usize);
        }
    }
}
