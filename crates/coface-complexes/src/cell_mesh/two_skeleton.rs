//! The 2-skeleton of a cell mesh, with the faces around each cell.

use crate::cell_mesh::mesh::CellMesh;
use coface_algebra::Error;
use coface_algebra::RaggedArray;
use coface_algebra::chains::TwoSkeleton;

impl CellMesh {
    /// The vertices, edges and faces with their rims, and the faces of each cell, numbered as in [`Self::chain_complex`].
    ///
    /// # Complexity
    /// Linear.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::cell_mesh::{CellMesh, CellShape};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let cells = RaggedArray::from_lists([[0, 1, 2, 3, 4]]);
    /// let mesh = CellMesh::new(5, vec![CellShape::Pyramid], cells, &RaggedArray::new(), &[])?;
    /// let skeleton = mesh.two_skeleton()?;
    /// assert_eq!(skeleton.f_vector(), [5, 8, 5]);
    /// assert_eq!(skeleton.solids().list(0).len(), 5);
    /// # Ok(()) }
    /// ```
    pub fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        let mut solids = RaggedArray::new();
        let mut faces = Vec::new();
        for cell in 0..self.cell_count() {
            faces.clear();
            faces.extend(self.packed_faces(cell).iter().map(|packed| packed >> 1));
            solids.push(&faces);
        }
        self.skeleton().two_skeleton()?.with_solids(solids)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell_mesh::shape::CellShape;

    #[test]
    fn it_is_the_chain_complex_up_to_degree_two() {
        let cells = RaggedArray::from_lists([vec![0, 1, 2, 3, 4, 5, 6, 7], vec![4, 5, 6, 7, 8]]);
        let polygons = RaggedArray::from_lists([[0, 8, 9]]);
        let mesh =
            CellMesh::new(10, vec![CellShape::Hexahedron, CellShape::Pyramid], cells, &polygons, &[[8, 9]])
                .unwrap();
        let (skeleton, chains) = (mesh.two_skeleton().unwrap(), mesh.chain_complex().unwrap());
        assert_eq!(skeleton.chain_complex().unwrap().boundary_matrices(), &chains.boundary_matrices()[..2]);
        for cell in 0..2 {
            let mut faces = skeleton.solids().list(cell).to_vec();
            faces.sort_unstable();
            assert_eq!(faces, chains.boundary_matrix(3).unwrap().column(cell).rows());
        }
    }
}
