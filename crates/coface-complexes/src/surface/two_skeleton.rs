//! The faces of meshes with the paths around them.

use super::{HalfedgeMesh, PolygonMesh};
use coface_algebra::chains::TwoSkeleton;
use coface_algebra::{EdgeId, Error, FaceId};
use coface_algebra::{RaggedArray, Sign};

impl PolygonMesh {
    /// The vertices, edges and faces with their rims, numbered as in [`Self::chain_complex`].
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::TooLarge`] beyond 32 bits.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = PolygonMesh::new(4, RaggedArray::from_lists([[0, 1, 2, 3]]), &[])?;
    /// // The edges are 01, 03, 12, 23; the square runs against 03.
    /// assert_eq!(square.two_skeleton()?.faces().list(0), [0, 4, 6, 3]);
    /// # Ok(()) }
    /// ```
    pub fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        let mut rims = self.polygons().clone();
        let mut steps = Vec::with_capacity(rims.item_count());
        for face in 0..self.face_count() {
            steps.extend(self.face_edges(FaceId::new(face)).map(|(edge, sign)| packed(edge, sign)));
        }
        rims.items_mut().copy_from_slice(&steps);
        TwoSkeleton::new(self.vertex_count(), self.edge_ends().to_vec(), rims)
    }
}

impl HalfedgeMesh {
    /// The vertices, edges and faces with their rims, numbered as they are, outer faces left out. The step of a rim along
    /// halfedge h is stored as the number h. A rim starts with the first halfedge of its face.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::TooLarge`] beyond 32 bits.
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// The square torus: along the first edge, the second, and back along both.
    /// ```
    /// use coface_complexes::surface::HalfedgeMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = HalfedgeMesh::from_next(vec![2, 3, 1, 0])?;
    /// assert_eq!(torus.two_skeleton()?.faces().list(0), [0, 2, 1, 3]);
    /// # Ok(()) }
    /// ```
    pub fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        let mut rims = RaggedArray::new();
        let mut rim = Vec::new();
        for face in (0..self.face_count()).map(FaceId::new) {
            rim.clear();
            rim.extend(self.face_halfedges(face).map(|h| h.to_u32()));
            rims.push(&rim);
        }
        TwoSkeleton::new(self.vertex_count(), self.edge_ends().to_vec(), rims)
    }
}

fn packed(edge: EdgeId, sign: Sign) -> u32 {
    2 * edge.to_u32() + u32::from(sign == Sign::Minus)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn halfedges_keep_their_chain_complex(next in Just((0u32..16).collect::<Vec<_>>()).prop_shuffle()) {
            let mesh = HalfedgeMesh::from_next(next).unwrap();
            prop_assert_eq!(mesh.two_skeleton().unwrap().chain_complex().unwrap(), mesh.chain_complex().unwrap());
        }

        #[test]
        fn polygons_keep_their_chain_complex(
            polygons in prop::collection::vec(
                (Just((0u32..8).collect::<Vec<_>>()).prop_shuffle(), 3usize..6), 1..8),
        ) {
            let polygons = RaggedArray::from_lists(polygons.iter().map(|(cycle, n)| &cycle[..*n]));
            let mesh = PolygonMesh::new(9, polygons, &[[0, 8]]).unwrap();
            prop_assert_eq!(mesh.two_skeleton().unwrap().chain_complex().unwrap(), mesh.chain_complex().unwrap());
        }
    }

    #[test]
    fn meshes_without_faces_have_a_skeleton() {
        let mesh = PolygonMesh::new(3, RaggedArray::new(), &[[0, 1]]).unwrap();
        assert_eq!(mesh.two_skeleton().unwrap().f_vector(), [3, 1, 0]);
        assert_eq!(HalfedgeMesh::from_next(vec![]).unwrap().two_skeleton().unwrap().f_vector(), [0, 0, 0]);
        // A loop between two monogons, and a segment in a digon.
        assert_eq!(
            HalfedgeMesh::from_next(vec![0, 1]).unwrap().two_skeleton().unwrap().faces().items(),
            [0, 1]
        );
        assert_eq!(
            HalfedgeMesh::from_next(vec![1, 0]).unwrap().two_skeleton().unwrap().faces().items(),
            [0, 1]
        );
    }
}
