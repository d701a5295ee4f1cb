//! Subcomplexes: the test, skeletons, the part on some vertices, purity.

use super::{Simplex, SimplexSet, SimplicialComplex};
use coface_algebra::{Error, VertexId};

/// Whether all maximal simplices of a set have one dimension.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Purity {
    /// There is no simplex: pure of every dimension.
    Empty,
    /// A complex all of whose maximal simplices have this dimension.
    Pure(usize),
    /// A complex; this simplex is maximal but not of the top dimension.
    NotPure(Simplex),
    /// Not a complex: the first simplex is a member, its face, the second, is not.
    NotAComplex(Simplex, Simplex),
}

impl Purity {
    /// The dimension of a pure complex that is not empty.
    pub fn dimension(&self) -> Option<usize> {
        match self {
            Self::Pure(dimension) => Some(*dimension),
            _ => None,
        }
    }

    /// Whether this is a pure complex, the empty one included.
    pub fn is_pure(&self) -> bool {
        matches!(self, Self::Empty | Self::Pure(_))
    }
}

impl SimplexSet {
    /// Whether this is a pure complex and of which dimension; if not, a witness.
    ///
    /// # Complexity
    /// $O(m d \log m)$ for m members of dimension up to d.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::{Purity, Simplex, SimplexSet};
    /// let edge = SimplexSet::from(Simplex::from([0, 1]));
    /// assert_eq!(edge.purity(), Purity::NotAComplex(Simplex::from([0, 1]), Simplex::from([1])));
    /// assert_eq!(edge.closure().purity(), Purity::Pure(1));
    /// let with_triangle = edge.union(&SimplexSet::from(Simplex::from([1, 2, 3]))).closure();
    /// assert_eq!(with_triangle.purity(), Purity::NotPure(Simplex::from([0, 1])));
    /// assert_eq!(SimplexSet::new().purity(), Purity::Empty);
    /// ```
    pub fn purity(&self) -> Purity {
        let Some(top) = self.dimension() else { return Purity::Empty };
        if let Some((simplex, face)) = self.first_missing_face() {
            return Purity::NotAComplex(simplex.clone(), face);
        }
        self.first_not_in_top().map_or(Purity::Pure(top), Purity::NotPure)
    }

    /// The members of dimension up to k.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::{Simplex, SimplexSet};
    /// let tetrahedron = SimplexSet::from(Simplex::from([0, 1, 2, 3])).closure();
    /// assert_eq!(tetrahedron.skeleton(1).f_vector(), [4, 6]);
    /// ```
    #[must_use]
    pub fn skeleton(&self, k: usize) -> Self {
        self.iter().filter(|simplex| simplex.dimension() <= k).cloned().collect()
    }
}

impl SimplicialComplex {
    /// Whether a set of simplices is a subcomplex: all its members are in this complex, and all their faces among them.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::{Simplex, SimplexSet, SimplicialComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = SimplicialComplex::from_facets([[0, 1, 2]])?;
    /// let edge = SimplexSet::from(Simplex::from([0, 1]));
    /// assert!(!triangle.has_subcomplex(&edge));
    /// assert!(triangle.has_subcomplex(&edge.closure()));
    /// # Ok(()) }
    /// ```
    pub fn has_subcomplex(&self, set: &SimplexSet) -> bool {
        set.iter().all(|simplex| self.contains(simplex)) && set.is_complex()
    }

    /// Whether all facets have one dimension; if not, a witness. Never [`Purity::NotAComplex`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::{Purity, Simplex, SimplicialComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mixed = SimplicialComplex::from_facets([vec![0, 1, 2], vec![2, 3]])?;
    /// assert_eq!(mixed.purity(), Purity::NotPure(Simplex::from([2, 3])));
    /// # Ok(()) }
    /// ```
    pub fn purity(&self) -> Purity {
        SimplexSet::from(self).purity()
    }

    /// The k-skeleton: the subcomplex of all simplices of dimension up to k.
    ///
    /// # Errors
    /// As [`SimplicialComplex::from_facets`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let tetrahedron = SimplicialComplex::from_facets([[0, 1, 2, 3]])?;
    /// assert_eq!(tetrahedron.skeleton(1)?.f_vector(), [4, 6]);
    /// # Ok(()) }
    /// ```
    pub fn skeleton(&self, k: usize) -> Result<Self, Error> {
        let set: SimplexSet =
            (0..=k.min(self.dimension().unwrap_or(0))).flat_map(|i| self.simplices(i)).collect();
        set.spanned_complex()
    }

    /// The subcomplex induced on some vertices: all simplices that have no others. Vertices that are not in the complex
    /// count for nothing.
    ///
    /// # Errors
    /// As [`SimplicialComplex::from_facets`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::VertexId;
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let disk = SimplicialComplex::from_facets([[0, 1, 2], [1, 2, 3]])?;
    /// let path = disk.induced_subcomplex([0, 1, 3].map(VertexId::new))?;
    /// assert_eq!(path.f_vector(), [3, 2]);
    /// # Ok(()) }
    /// ```
    pub fn induced_subcomplex(&self, vertices: impl IntoIterator<Item = VertexId>) -> Result<Self, Error> {
        let mut kept: Vec<u32> = vertices.into_iter().map(VertexId::to_u32).collect();
        kept.sort_unstable();
        // A facet keeps a face of itself; these faces have all others.
        let faces = self.facets().into_iter().filter_map(|facet| {
            let face: Vec<u32> =
                facet.numbers().iter().copied().filter(|v| kept.binary_search(v).is_ok()).collect();
            (!face.is_empty()).then(|| Simplex::from_sorted(&face))
        });
        let faces: SimplexSet = faces.collect();
        faces.spanned_complex()
    }
}

#[cfg(test)]
mod tests {
    use super::super::neighborhood::tests::complex_and_part;
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn parts_follow_their_definitions((k, part) in complex_and_part(), dimension in 0usize..5) {
            let all = SimplexSet::from(&k);
            prop_assert_eq!(k.has_subcomplex(&part), part.is_complex());
            prop_assert!(k.has_subcomplex(&part.closure()));
            let skeleton: SimplexSet = k.iter().filter(|s| s.dimension() <= dimension).collect();
            prop_assert_eq!(&SimplexSet::from(&k.skeleton(dimension).unwrap()), &skeleton);
            prop_assert_eq!(all.skeleton(dimension), skeleton);
            let vertices = part.vertices();
            let induced: SimplexSet = k.iter().filter(|s| s.vertices().all(|v| vertices.contains(&v))).collect();
            prop_assert_eq!(SimplexSet::from(&k.induced_subcomplex(vertices).unwrap()), induced);
        }

        #[test]
        fn purity_follows_its_definition((k, part) in complex_and_part()) {
            let dimensions: Vec<usize> = k.facets().iter().map(Simplex::dimension).collect();
            match k.purity() {
                Purity::Empty => prop_assert!(k.is_empty()),
                Purity::Pure(n) => prop_assert!(dimensions.iter().all(|&d| d == n) && !k.is_empty()),
                Purity::NotPure(witness) => {
                    prop_assert!(k.facets().contains(&witness) && Some(witness.dimension()) < k.dimension());
                }
                Purity::NotAComplex(..) => prop_assert!(false),
            }
            if let Purity::NotAComplex(simplex, face) = part.purity() {
                prop_assert!(part.contains(&simplex) && face.is_face_of(&simplex) && !part.contains(&face));
            } else {
                prop_assert!(part.is_complex());
            }
        }
    }

    #[test]
    fn a_foreign_simplex_makes_no_subcomplex() {
        let triangle = SimplicialComplex::from_facets([[0, 1, 2]]).unwrap();
        assert!(!triangle.has_subcomplex(&SimplexSet::from(Simplex::from([7]))));
        assert!(triangle.has_subcomplex(&SimplexSet::new()));
        assert!(triangle.skeleton(9).unwrap() == triangle);
        assert!(SimplicialComplex::new().skeleton(0).unwrap().is_empty());
    }
}
