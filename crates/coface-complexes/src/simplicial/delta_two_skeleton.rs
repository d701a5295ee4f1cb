//! The part of delta complexes and gluing tables that loops see.

use super::DeltaComplex;
use crate::gluing::FaceClasses;
use coface_algebra::chains::TwoSkeleton;
use coface_algebra::{CellId, Error, RaggedArray};

impl DeltaComplex {
    /// The vertices, edges and triangles, numbered as here, with the edges around each triangle, and the triangles around
    /// each tetrahedron.
    ///
    /// Edges run from their first vertex to their last; the rim of a triangle with vertices a, b, c runs ab, bc, ca.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::TooLarge`] beyond 32 bits.
    ///
    /// # Complexity
    /// Linear in the simplices up to dimension 3.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::DeltaComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The dunce hat: the rim runs along one edge twice and back once.
    /// let hat = DeltaComplex::new(1, vec![vec![0, 0], vec![0, 0, 0]])?.two_skeleton()?;
    /// assert_eq!(hat.faces().list(0), [0, 0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        let all = |degree: usize| {
            (0..self.simplex_count(degree)).map(move |cell| self.faces(degree, CellId::new(cell)))
        };
        let ends = all(1).flat_map(|faces| [faces[1], faces[0]]).collect();
        let rims = all(2).flat_map(|faces| [2 * faces[2], 2 * faces[0], 2 * faces[1] + 1]).collect();
        let solids = all(3).flatten().copied().collect();
        TwoSkeleton::new(self.simplex_count(0), ends, RaggedArray::uniform(3, rims)?)?
            .with_solids(RaggedArray::uniform(4, solids)?)
    }
}

impl FaceClasses {
    /// The classes of vertices, edges and triangles with the edges around each triangle, and the triangles around each
    /// tetrahedron: cells and orientations are those of [`Self::chain_complex`], and so are those of the barycentric
    /// subdivision if a class is folded.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::TooLarge`] as [`Self::barycentric_subdivision`].
    ///
    /// # Complexity
    /// Linear in the classes up to degree 3; with folds, in the subdivision.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut band = GluingTable::unglued(2, 1)?;
    /// band.glue(0, 2, 0, &[1, 2, 0])?;
    /// // Edge 0 is passed twice, edge 1 backward.
    /// assert_eq!(band.faces()?.two_skeleton()?.faces().list(0), [0, 0, 3]);
    /// # Ok(()) }
    /// ```
    pub fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        if self.has_folds() {
            return self.barycentric_subdivision()?.complex().two_skeleton();
        }
        let counts = self.class_counts();
        let count = |degree: usize| counts.get(degree).copied().unwrap_or(0);
        let mut ends = Vec::with_capacity(2 * count(1));
        (0..count(1)).for_each(|edge| ends.extend(self.vertices(1, CellId::new(edge))));
        let mut rims = Vec::with_capacity(3 * count(2));
        for triangle in (0..count(2)).map(CellId::new) {
            let (simplex, corners) = self.representative(2, triangle);
            for (from, to) in [(0, 1), (1, 2), (2, 0)] {
                let (from, to) = (corners[from], corners[to]);
                let (edge, order) = self.of_face(simplex, 1 << from | 1 << to);
                // The order lists the places of the rising vertices.
                let is_forward = (order[0] < order[1]) == (from < to);
                rims.push(2 * edge as u32 + u32::from(!is_forward));
            }
        }
        let mut solids = Vec::with_capacity(4 * count(3));
        for solid in (0..count(3)).map(CellId::new) {
            let (simplex, corners) = self.representative(3, solid);
            let whole = corners.iter().fold(0, |set, &v| set | 1 << v);
            solids.extend(corners.iter().map(|&v| self.of_face(simplex, whole & !(1 << v)).0 as u32));
        }
        TwoSkeleton::new(count(0), ends, RaggedArray::uniform(3, rims)?)?
            .with_solids(RaggedArray::uniform(4, solids)?)
    }
}
