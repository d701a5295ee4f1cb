//! Boundary and incidence matrices of simplicial complexes.
//!
//! The boundary of a simplex of vertices $v_0 < \dots < v_k$ is $\sum_i (-1)^i [v_0, \dots, \hat v_i, \dots, v_k]$.

use super::{FrozenComplex, SimplicialComplex};
use coface_algebra::Error;
use coface_algebra::SparseMatrix;
use coface_algebra::chains::ChainComplex;
use rayon::prelude::*;
use std::ops::Range;

/// How many simplices of the dimension below are worked on as one piece.
const PIECE: usize = 4096;

impl FrozenComplex {
    /// The boundary matrix from k-chains to (k-1)-chains: column j is the boundary of the j-th k-simplex.
    ///
    /// Without rows for degree 0, without columns above the dimension.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) beyond 2^32 entries.
    ///
    /// # Complexity
    /// Linear in the entries of the matrices up to this degree if vertices have few neighbors, with a logarithmic
    /// factor otherwise; in parallel.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::FrozenComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1, 2]]))?;
    /// // The edges are {0, 1}, {0, 2}, {1, 2}: the rim runs along the first and the third and against the second.
    /// assert_eq!(triangle.boundary_matrix(2)?.column(0).entries(), [1, -1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn boundary_matrix(&self, degree: usize) -> Result<SparseMatrix, Error> {
        let Some(below) = degree.checked_sub(1) else {
            return SparseMatrix::zero(0, self.simplex_count(0));
        };
        if self.simplex_count(degree) == 0 {
            return SparseMatrix::zero(self.simplex_count(below), 0);
        }
        let mut rows = self.facet_rows(1, &[]);
        for k in 2..=degree {
            rows = self.facet_rows(k, &rows);
        }
        self.matrix_of(degree, rows)
    }

    /// The chain complex: cells of degree k are the k-simplices in their order here.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) beyond 2^32 entries in a matrix.
    ///
    /// # Complexity
    /// As [`Self::boundary_matrix`] of the highest degree; each matrix is made from the one below in one pass, and
    /// their products are checked.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::FrozenComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sphere = RaggedArray::from_lists([[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]]);
    /// assert_eq!(FrozenComplex::from_facets(&sphere)?.chain_complex()?.f_vector(), [4, 6, 4]);
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        let top = self.dimension().unwrap_or(0);
        if top == 0 {
            return Ok(ChainComplex::of_points(self.simplex_count(0)));
        }
        let mut boundaries: Vec<SparseMatrix> = Vec::with_capacity(top);
        for k in 1..=top {
            let rows = self.facet_rows(k, boundaries.last().map_or(&[], |matrix| matrix.rows()));
            boundaries.push(self.matrix_of(k, rows)?);
        }
        ChainComplex::new(boundaries)
    }

    /// The signed incidence matrix: a row for each (k+1)-simplex, a column for each k-simplex, entry 1 or -1 where the
    /// column's simplex is a facet of the row's with equal or opposite orientation. It is the coboundary matrix of
    /// degree k, the transpose of the boundary matrix of degree k + 1.
    ///
    /// # Errors
    /// As [`Self::boundary_matrix`].
    ///
    /// # Examples
    /// The edge from 0 to 1 agrees with its end and disagrees with its start.
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::FrozenComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1]]))?;
    /// let incidence = edge.incidence_matrix(0)?;
    /// assert_eq!((incidence.entry(0, 0), incidence.entry(0, 1)), (-1, 1));
    /// # Ok(()) }
    /// ```
    pub fn incidence_matrix(&self, dimension: usize) -> Result<SparseMatrix, Error> {
        Ok(self.boundary_matrix(dimension.saturating_add(1))?.transpose())
    }

    /// The incidence matrix without signs: as [`Self::incidence_matrix`], with entry 1 for each facet.
    ///
    /// # Errors
    /// As [`Self::boundary_matrix`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::simplicial::FrozenComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = FrozenComplex::from_facets(&RaggedArray::from_lists([[0, 1]]))?;
    /// assert_eq!(edge.unsigned_incidence_matrix(0)?.entries(), [1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn unsigned_incidence_matrix(&self, dimension: usize) -> Result<SparseMatrix, Error> {
        let signed = self.incidence_matrix(dimension)?;
        SparseMatrix::from_parts(
            signed.row_count(),
            signed.column_starts().to_vec(),
            signed.rows().to_vec(),
            vec![1; signed.entry_count()],
        )
    }

    /// The facets of all k-simplices as rising positions, k + 1 each: the facet without the last vertex first.
    /// `below` is the same for the dimension below, empty for k = 1.
    ///
    /// A simplex is the child, by its last vertex w, of the face p without w. Its other facets are the children by w of
    /// the facets of p, and the children of p and of each facet of p are sorted by w, so they are found side by side.
    pub(super) fn facet_rows(&self, k: usize, below: &[u32]) -> Vec<u32> {
        let starts = self.child_starts(k - 1);
        let mut rows = vec![0; self.simplex_count(k) * (k + 1)];
        let mut pieces = Vec::new();
        let mut rest = rows.as_mut_slice();
        for begin in (0..starts.len() - 1).step_by(PIECE) {
            let parents = begin..(begin + PIECE).min(starts.len() - 1);
            let child_count = (starts[parents.end] - starts[parents.start]) as usize;
            let (piece, others) = rest.split_at_mut(child_count * (k + 1));
            pieces.push((parents, piece));
            rest = others;
        }
        pieces.into_par_iter().for_each(|(parents, piece)| self.facet_rows_below(k, parents, below, piece));
        rows
    }

    fn facet_rows_below(&self, k: usize, parents: Range<usize>, below: &[u32], mut rows: &mut [u32]) {
        for parent in parents {
            let children = self.children(k - 1, parent);
            let (own, others) = rows.split_at_mut(children.len() * (k + 1));
            rows = others;
            if children.is_empty() {
                continue;
            }
            for row in own.chunks_exact_mut(k + 1) {
                row[0] = parent as u32;
            }
            if k == 1 {
                for (row, child) in own.chunks_exact_mut(2).zip(children) {
                    let end = self.vertex_position(self.last_number(1, child));
                    row[1] = end.expect("a complex has all vertices of its simplices") as u32;
                }
                continue;
            }
            for j in 0..k {
                let mut cousins = self.children(k - 2, below[parent * k + j] as usize);
                for (row, child) in own.chunks_exact_mut(k + 1).zip(children.clone()) {
                    cousins.start = self.seek(k - 1, cousins.clone(), self.last_number(k, child));
                    row[j + 1] = cousins.start as u32;
                }
            }
        }
    }

    /// The boundary matrix of degree k from its rows.
    fn matrix_of(&self, k: usize, rows: Vec<u32>) -> Result<SparseMatrix, Error> {
        let count = self.simplex_count(k);
        // Beyond 32 bits the starts are of no use, and the matrix refuses so many rows.
        let column_starts = (0..=count).map(|j| (j * (k + 1)) as u32).collect();
        let signs: Vec<i32> = (0..=k).rev().map(|i| if i % 2 == 0 { 1 } else { -1 }).collect();
        SparseMatrix::from_trusted_parts(self.simplex_count(k - 1), column_starts, rows, signs.repeat(count))
    }
}

impl SimplicialComplex {
    /// The chain complex: cells of degree k are the k-simplices in lexicographic order.
    ///
    /// # Errors
    /// As [`FrozenComplex::chain_complex`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = SimplicialComplex::from_facets([[0, 1], [1, 2], [2, 0]])?;
    /// assert_eq!(circle.chain_complex()?.f_vector(), [3, 3]);
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        self.freeze().chain_complex()
    }

    /// The signed incidence matrix of [`FrozenComplex::incidence_matrix`], simplices in lexicographic order.
    ///
    /// # Errors
    /// As [`FrozenComplex::boundary_matrix`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = SimplicialComplex::from_facets([[0, 1, 2]])?;
    /// assert_eq!(triangle.incidence_matrix(1)?.entry(0, 1), -1);
    /// # Ok(()) }
    /// ```
    pub fn incidence_matrix(&self, dimension: usize) -> Result<SparseMatrix, Error> {
        self.freeze().incidence_matrix(dimension)
    }

    /// The incidence matrix without signs of [`FrozenComplex::unsigned_incidence_matrix`].
    ///
    /// # Errors
    /// As [`FrozenComplex::boundary_matrix`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangle = SimplicialComplex::from_facets([[0, 1, 2]])?;
    /// assert_eq!(triangle.unsigned_incidence_matrix(1)?.entry(0, 1), 1);
    /// # Ok(()) }
    /// ```
    pub fn unsigned_incidence_matrix(&self, dimension: usize) -> Result<SparseMatrix, Error> {
        self.freeze().unsigned_incidence_matrix(dimension)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simplicial::Simplex;
    use coface_algebra::ErrorKind;
    use coface_algebra::RaggedArray;
    use proptest::prelude::*;
    use std::collections::BTreeSet;

    fn lists() -> impl Strategy<Value = RaggedArray> {
        let vertex = prop_oneof![9 => 0u32..10, 1 => Just(1_000_000), 1 => Just(u32::MAX)];
        let list = prop::collection::btree_set(vertex, 1..7);
        prop::collection::vec(list, 0..30).prop_map(|lists| {
            RaggedArray::from_lists(lists.iter().map(|list| list.iter().rev().copied().collect::<Vec<u32>>()))
        })
    }

    proptest! {
        #[test]
        fn frozen_and_dynamic_agree(lists in lists()) {
            let frozen = FrozenComplex::from_facets(&lists).unwrap();
            let dynamic = SimplicialComplex::from_facets(lists.iter()).unwrap();
            frozen.check().unwrap();
            let thawed = frozen.thaw();
            thawed.check().unwrap();
            prop_assert_eq!(&thawed, &dynamic);
            prop_assert_eq!(&dynamic.freeze(), &frozen);
            prop_assert_eq!(dynamic.f_vector(), frozen.f_vector());
            for (k, &count) in frozen.f_vector().iter().enumerate() {
                prop_assert_eq!(dynamic.simplices(k).count(), count);
                for (i, simplex) in dynamic.simplices(k).enumerate() {
                    prop_assert_eq!(frozen.index_of(simplex.numbers()), Some(i));
                    prop_assert_eq!(frozen.simplex(k, i), simplex);
                }
            }
        }

        /// The chain complex is made (so boundary of boundary is zero) and its columns are the facets with signs.
        #[test]
        fn columns_are_boundaries(lists in lists()) {
            let frozen = FrozenComplex::from_facets(&lists).unwrap();
            let chains = frozen.chain_complex().unwrap();
            prop_assert_eq!(chains.f_vector(), frozen.f_vector());
            for k in 0..frozen.f_vector().len() {
                let matrix = frozen.boundary_matrix(k).unwrap();
                if k > 0 {
                    prop_assert_eq!(chains.boundary_matrix(k), Some(&matrix));
                }
                for i in 0..frozen.simplex_count(k) {
                    let column: BTreeSet<(usize, i32)> = matrix.column(i).iter().collect();
                    let by_search: BTreeSet<(usize, i32)> =
                        frozen.facets(k, i).map(|(sign, facet)| (facet, sign.to_i32())).collect();
                    let by_definition: BTreeSet<(usize, i32)> = frozen.simplex(k, i).facets()
                        .map(|(sign, facet)| (frozen.index_of(facet.numbers()).unwrap(), sign.to_i32())).collect();
                    prop_assert_eq!(&column, &by_search);
                    prop_assert_eq!(&column, &by_definition);
                }
            }
        }

        /// Row sums of the unsigned matrix are k + 2, and the product of signed ones is zero.
        #[test]
        fn incidence_matrices(lists in lists()) {
            let frozen = FrozenComplex::from_facets(&lists).unwrap();
            for k in 0..=frozen.f_vector().len() {
                let signed = frozen.incidence_matrix(k).unwrap();
                let unsigned = frozen.unsigned_incidence_matrix(k).unwrap();
                prop_assert_eq!(signed.column_count(), frozen.simplex_count(k));
                prop_assert_eq!(signed.row_count(), frozen.simplex_count(k + 1));
                prop_assert_eq!(signed.rows(), unsigned.rows());
                for row in unsigned.transpose().columns() {
                    prop_assert_eq!(row.entries().iter().sum::<i32>(), k as i32 + 2);
                }
                let next = frozen.incidence_matrix(k + 1).unwrap();
                prop_assert_eq!(next.first_nonzero_product_column(&signed).unwrap(), None);
            }
        }
    }

    #[test]
    fn degenerate_complexes_have_matrices() {
        let empty = FrozenComplex::default();
        assert_eq!(empty, FrozenComplex::from_facets(&RaggedArray::new()).unwrap());
        assert_eq!(empty, SimplicialComplex::new().freeze());
        assert!(empty.thaw().is_empty());
        assert_eq!(empty.chain_complex().unwrap(), ChainComplex::of_points(0));
        assert_eq!(empty.boundary_matrix(0).unwrap(), SparseMatrix::zero(0, 0).unwrap());
        assert_eq!(empty.index_of(&[0]), None);
        let point = FrozenComplex::from_facets(&RaggedArray::from_lists([[7]])).unwrap();
        assert_eq!(point.chain_complex().unwrap(), ChainComplex::of_points(1));
        assert_eq!(point.boundary_matrix(0).unwrap(), SparseMatrix::zero(0, 1).unwrap());
        assert_eq!(point.boundary_matrix(1).unwrap(), SparseMatrix::zero(1, 0).unwrap());
        assert_eq!(point.incidence_matrix(0).unwrap(), SparseMatrix::zero(0, 1).unwrap());
        assert_eq!(
            (point.index_of(&[]), point.index_of(&[7, 8]), point.facets(0, 0).count()),
            (None, None, 0)
        );
    }

    /// Many lists, so that several parts are made, with gaps in the numbers; the shape is known: a row of tetrahedra.
    #[test]
    fn parts_fit_together() {
        let row: Vec<u32> = (0..30_000u32).flat_map(|i| [3 * i + 9, 3 * i + 6, 3 * i + 3, 3 * i]).collect();
        let lists = RaggedArray::uniform(4, row).unwrap();
        let frozen = FrozenComplex::from_facets(&lists).unwrap();
        assert_eq!(frozen.f_vector(), [30_003, 90_003, 90_001, 30_000]);
        assert_eq!(frozen.numbers(3, 29_999), [89_997, 90_000, 90_003, 90_006]);
        assert_eq!(frozen, SimplicialComplex::from_facets(lists.iter()).unwrap().freeze());
        assert_eq!(frozen.chain_complex().unwrap().euler_characteristic(), 1);
        assert!(frozen.contains(&Simplex::from([3, 6])) && !frozen.contains(&Simplex::from([3, 7])));
    }

    #[test]
    fn too_many_faces_are_refused() {
        let lists = RaggedArray::from_lists([(0..29).collect::<Vec<u32>>()]);
        assert_eq!(FrozenComplex::from_facets(&lists).unwrap_err().kind(), ErrorKind::TooLarge);
    }
}
