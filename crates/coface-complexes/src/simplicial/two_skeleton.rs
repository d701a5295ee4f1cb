//! The 2-skeleton of a simplicial complex.

use super::FrozenComplex;
use coface_algebra::Error;
use coface_algebra::RaggedArray;
use coface_algebra::chains::TwoSkeleton;

impl FrozenComplex {
    /// The vertices, edges and triangles with their rims, and the triangles of each tetrahedron, numbered as in
    /// [`Self::chain_complex`]. An edge goes from its smaller vertex to its larger; the triangle abc runs along ab, bc and
    /// back along ac.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::TooLarge`] beyond 32 bits.
    ///
    /// # Complexity
    /// Near-linear, in parallel; simplices beyond dimension 3 are not looked at.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::FrozenComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let tetrahedron = FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1, 2, 3]]))?;
    /// let skeleton = tetrahedron.two_skeleton()?;
    /// assert_eq!(skeleton.f_vector(), [4, 6, 4]);
    /// assert_eq!(skeleton.solids().list(0), [0, 1, 2, 3]);
    /// # Ok(()) }
    /// ```
    pub fn two_skeleton(&self) -> Result<TwoSkeleton, Error> {
        let top = self.dimension().unwrap_or(0);
        let ends = if top >= 1 { self.facet_rows(1, &[]) } else { Vec::new() };
        let triangles = if top >= 2 { self.facet_rows(2, &ends) } else { Vec::new() };
        let solids = if top >= 3 { self.facet_rows(3, &triangles) } else { Vec::new() };
        // The rows of triangle abc are ab, ac, bc.
        let mut steps = triangles;
        for rim in steps.chunks_exact_mut(3) {
            rim.copy_from_slice(&[2 * rim[0], 2 * rim[2], 2 * rim[1] + 1]);
        }
        TwoSkeleton::new(self.simplex_count(0), ends, RaggedArray::uniform(3, steps)?)?
            .with_solids(RaggedArray::uniform(4, solids)?)
    }
}

#[cfg(test)]
mod tests {
    use crate::known_spaces;

    #[test]
    fn it_is_the_chain_complex_up_to_degree_two() {
        for complex in [
            known_spaces::cyclic_torus(3).unwrap(),
            known_spaces::projective_plane().unwrap(),
            known_spaces::simplex_boundary(4).unwrap(),
            known_spaces::circle(5).unwrap(),
            known_spaces::simplex(0).unwrap(),
        ] {
            let frozen = complex.freeze();
            let (skeleton, chains) = (frozen.two_skeleton().unwrap(), frozen.chain_complex().unwrap());
            let own = skeleton.chain_complex().unwrap();
            for degree in 0..=2 {
                assert_eq!(own.cell_count(degree), chains.cell_count(degree));
                assert_eq!(
                    own.boundary_matrix(degree),
                    chains.boundary_matrix(degree).filter(|_| degree < 3)
                );
            }
            assert_eq!(skeleton.solids().len(), chains.cell_count(3));
            for solid in 0..skeleton.solids().len() {
                let column = chains.boundary_matrix(3).unwrap().column(solid);
                assert_eq!(skeleton.solids().list(solid), column.rows());
            }
        }
    }
}
