//! The Morse complex: the critical cells that remain when all pairs of an acyclic matching have cancelled.

use super::flow::{Flow, Sweep, inclusions};
use crate::chains::{AcyclicMatching, ChainComplex};
use crate::ids::narrow;
use crate::integers::Integer;
use crate::matrices::{Entry, SparseVector, WideMatrix, linear_combination};
use crate::progress::{Steps, stage};
use crate::threads;
use std::borrow::Cow;

/// The Morse complex of a chain complex: one cell for each critical cell, with the integral homology of the whole.
///
/// The boundary of a critical cell c is found by elimination: as long as the boundary of the chain grown from c has a
/// matched face, the cell of that pair is added with the coefficient that cancels the face. What remains on critical
/// faces is the boundary in the Morse complex, and the grown chain is the image of c under the **inclusion** g, a chain
/// map into the original complex. Elimination of matched faces from any chain z gives its **projection** f(z), on
/// critical cells, and the **homotopy** h(z), the cells that were added: $f g = 1$ and
/// $1 - g f = \partial h + h \partial$. So f and g are inverse on homology, and no map is ever stored as a matrix.
/// Cochains go the other way, by a sweep through the pairs in reverse: see [`Self::pullback`].
///
/// # Complexity
/// Each critical cell costs the cells that its gradient paths reach, each met once; coefficients are 64 bits, checked,
/// and a cell whose coefficients outgrow them is done again with big integers.
///
/// # References
/// R. Forman, *Morse theory for cell complexes* (1998), section 8.
///
/// # Examples
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::{ChainComplex, MorseComplex};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// // One vertex, one loop, one disk that runs twice along it: the projective plane.
/// let plane = ChainComplex::new(vec![
///     SparseMatrix::zero(1, 1)?,
///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
/// ])?;
/// let morse = MorseComplex::new(&plane);
/// assert_eq!(morse.critical_count(2), 1);
/// assert_eq!(morse.boundary(2, 0), [(0, 2.into())]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct MorseComplex<'a, E: Entry = i32> {
    complex: Cow<'a, ChainComplex<E>>,
    matching: AcyclicMatching,
    /// The boundary of each critical cell of degree k at position k - 1, on the numbers of the critical faces.
    boundaries: Vec<Vec<SparseVector>>,
}

impl<'a, E: Entry> MorseComplex<'a, E> {
    /// Matches and cancels.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, MorseComplex};
    /// assert_eq!(MorseComplex::new(&ChainComplex::of_points(2)).critical_count(0), 2);
    /// ```
    pub fn new(complex: &'a ChainComplex<E>) -> Self {
        Self::of(Cow::Borrowed(complex))
    }

    pub(super) fn of(complex: Cow<'a, ChainComplex<E>>) -> Self {
        let matching = AcyclicMatching::new(&complex);
        Self::with_matching(complex, matching)
    }

    /// Cancels what is matched; the matching is one of this complex.
    pub(super) fn with_matching(complex: Cow<'a, ChainComplex<E>>, matching: AcyclicMatching) -> Self {
        let flows = |degree: &usize| !matching.has_zero_boundary(*degree);
        let total = (1..complex.degree_count()).filter(flows).map(|k| matching.critical_cells(k).len()).sum();
        let steps = stage("cancelling pairs", total);
        let cell_count = complex.f_vector().iter().sum();
        let boundaries = threads::mapped(complex.degree_count().saturating_sub(1), cell_count, |below| {
            let degree = below + 1;
            let cells = matching.critical_cells(degree);
            if cells.is_empty() || matching.has_zero_boundary(degree) {
                return vec![Vec::new(); cells.len()];
            }
            let mut flow = Flow::new(&complex, &matching, degree, &steps);
            let boundary = |&cell: &u32| {
                let boundary = flow.boundary(&[(cell, Integer::ONE)]);
                steps.advance(1);
                boundary
            };
            cells.iter().map(boundary).collect()
        });
        Self { complex, matching, boundaries }
    }

    /// The complex that was reduced.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, MorseComplex};
    /// let points = ChainComplex::of_points(2);
    /// assert_eq!(MorseComplex::new(&points).complex(), &points);
    /// ```
    pub fn complex(&self) -> &ChainComplex<E> {
        &self.complex
    }

    /// The number of critical cells of this degree.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{MorseComplex, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = TwoSkeleton::new(3, vec![0, 1, 1, 2, 2, 0], RaggedArray::new())?.chain_complex()?;
    /// let morse = MorseComplex::new(&circle);
    /// assert_eq!((morse.critical_count(0), morse.critical_count(1)), (1, 1));
    /// # Ok(()) }
    /// ```
    pub fn critical_count(&self, degree: usize) -> usize {
        self.matching.critical_cells(degree).len()
    }

    /// The matching that was cancelled.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{MorseComplex, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = TwoSkeleton::new(2, vec![0, 1], RaggedArray::new())?.chain_complex()?;
    /// assert_eq!(MorseComplex::new(&edge).matching().critical_cells(0), [0]);
    /// # Ok(()) }
    /// ```
    pub fn matching(&self) -> &AcyclicMatching {
        &self.matching
    }

    /// The boundary, in the Morse complex, of the critical cell number `i` of this degree: (number of a critical cell
    /// one degree below, coefficient), by rising numbers. Empty for degree 0.
    ///
    /// # Panics
    /// If there is no such critical cell.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{MorseComplex, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = TwoSkeleton::new(3, vec![0, 1, 1, 2, 2, 0], RaggedArray::new())?.chain_complex()?;
    /// assert!(MorseComplex::new(&circle).boundary(1, 0).is_empty());
    /// # Ok(()) }
    /// ```
    pub fn boundary(&self, degree: usize, i: usize) -> &[(u32, Integer)] {
        assert!(i < self.critical_count(degree), "there is no critical cell {i} of degree {degree}");
        degree.checked_sub(1).map_or(&[], |below| &self.boundaries[below][i])
    }

    /// The boundary matrix of the Morse complex from this degree to the one below, on the numbers of critical cells:
    /// column j is the boundary of critical cell j. Without rows for degree 0, without columns beyond the dimension.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{MorseComplex, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let plane = TwoSkeleton::new(1, vec![0, 0], RaggedArray::from_lists([[0, 0]]))?.chain_complex()?;
    /// assert_eq!(MorseComplex::new(&plane).boundary_matrix(2).entry(0, 0), 2.into());
    /// # Ok(()) }
    /// ```
    pub fn boundary_matrix(&self, degree: usize) -> WideMatrix {
        let row_count = degree.checked_sub(1).map_or(0, |below| self.critical_count(below));
        let columns = (0..self.critical_count(degree)).map(|i| self.boundary(degree, i).to_vec());
        WideMatrix::from_integer_columns(row_count, columns).expect("critical cells have 32-bit numbers")
    }

    /// The image of a chain of the Morse complex in the original complex. The chain is given on the numbers of critical
    /// cells, its image on the cells of the complex, by rising ids. Cycles go to cycles.
    ///
    /// # Panics
    /// If a number is not below the count of critical cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{MorseComplex, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = TwoSkeleton::new(3, vec![0, 1, 1, 2, 2, 0], RaggedArray::new())?.chain_complex()?;
    /// // The critical edge stands for the cycle of all three edges.
    /// let cycle = MorseComplex::new(&circle).inclusion(1, &[(0, 1.into())]);
    /// assert_eq!(cycle.iter().map(|(edge, _)| *edge).collect::<Vec<_>>(), [0, 1, 2]);
    /// # Ok(()) }
    /// ```
    pub fn inclusion(&self, degree: usize, chain: &[(u32, Integer)]) -> SparseVector {
        self.inclusions(degree, [chain]).pop().expect("one chain has one image")
    }

    /// The images of several chains, as [`Self::inclusion`] gives them, with the preparations made once.
    ///
    /// # Panics
    /// If a number is not below the count of critical cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, MorseComplex};
    /// let points = ChainComplex::of_points(2);
    /// let chains = [vec![(0, 1.into())], vec![(1, 1.into())]];
    /// let images = MorseComplex::new(&points).inclusions(0, chains.iter().map(Vec::as_slice));
    /// assert_eq!(images, chains);
    /// ```
    pub fn inclusions<'c>(
        &self,
        degree: usize,
        chains: impl IntoIterator<Item = &'c [(u32, Integer)]>,
    ) -> Vec<SparseVector> {
        let chains = chains.into_iter();
        let steps = stage("growing chains", chains.size_hint().0);
        self.inclusions_with_steps(degree, chains, &steps)
    }

    /// As [`Self::inclusions`], and counts each chain as a step.
    pub(crate) fn inclusions_with_steps<'c>(
        &self,
        degree: usize,
        chains: impl IntoIterator<Item = &'c [(u32, Integer)]>,
        steps: &Steps,
    ) -> Vec<SparseVector> {
        inclusions(&self.complex, &self.matching, degree, chains, steps)
    }

    /// The projection of a chain of this degree, given on the cells of the complex, to the Morse complex: on the
    /// numbers of critical cells. The projection of an inclusion is the chain itself; cycles go to cycles, boundaries
    /// to boundaries.
    ///
    /// # Panics
    /// If a cell is not in the complex.
    ///
    /// # Examples
    /// ```
    /// # use coface_algebra::{Integer, SparseMatrix};
    /// # use coface_algebra::chains::{ChainComplex, MorseComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // An edge collapses to its first end: so does a chain on the other end, and the edge is the homotopy.
    /// let edge = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
    /// let morse = MorseComplex::new(&edge);
    /// assert_eq!(morse.projection(0, &[(1, 3.into())]), [(0, 3.into())]);
    /// assert_eq!(morse.homotopy(0, &[(1, 3.into())]), [(0, 3.into())]);
    /// # Ok(()) }
    /// ```
    pub fn projection(&self, degree: usize, chain: &[(u32, Integer)]) -> SparseVector {
        self.projection_and_homotopy(degree, chain).0
    }

    /// The homotopy on a chain of this degree: a chain h(z) of one degree more, with $z - g f z = \partial h z + h
    /// \partial z$. For a cycle z it is a chain whose boundary is the difference between z and the inclusion of its
    /// projection.
    ///
    /// # Panics
    /// If a cell is not in the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{MorseComplex, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Vertex 1 collapses along the edge to vertex 0.
    /// let edge = TwoSkeleton::new(2, vec![0, 1], RaggedArray::new())?.chain_complex()?;
    /// assert_eq!(MorseComplex::new(&edge).homotopy(0, &[(1, 1.into())]), [(0, 1.into())]);
    /// # Ok(()) }
    /// ```
    pub fn homotopy(&self, degree: usize, chain: &[(u32, Integer)]) -> SparseVector {
        self.projection_and_homotopy(degree, chain).1
    }

    pub(super) fn projection_and_homotopy(
        &self,
        degree: usize,
        chain: &[(u32, Integer)],
    ) -> (SparseVector, SparseVector) {
        if self.complex.boundary_matrix(degree + 1).is_none() {
            let critical = self.matching.critical_cells(degree);
            let number = |cell: &u32| critical.binary_search(cell).ok().map(narrow);
            let kept = chain.iter().filter_map(|(cell, x)| Some((number(cell)?, x.clone())));
            return (kept.collect(), Vec::new());
        }
        let steps = stage("projecting a chain", 0);
        let eliminated = Flow::new(&self.complex, &self.matching, degree + 1, &steps).push(chain);
        // What was added cancels; what cancels is the homotopy.
        let mut taken: SparseVector = eliminated.added.into_iter().map(|(cell, x)| (cell, -x)).collect();
        taken.sort_unstable_by_key(|&(cell, _)| cell);
        (eliminated.on_critical, taken)
    }

    /// Cochains of the Morse complex as cochains of the original one, by composition with the projection: column i of
    /// the argument holds the values of all cochains on critical cell i of this degree, a row for each cochain; column
    /// c of the result holds their values on cell c. Closed cochains go to closed ones.
    ///
    /// # Complexity
    /// One pass through the pairs and the entries of their boundaries, and the values that are not zero.
    ///
    /// # Panics
    /// Unless the argument has a column for each critical cell.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{MorseComplex, TwoSkeleton};
    /// use coface_algebra::{RaggedArray, SparseMatrix};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = TwoSkeleton::new(2, vec![0, 1], RaggedArray::new())?.chain_complex()?;
    /// // The value at the critical vertex becomes the value at both vertices.
    /// let value = SparseMatrix::from_entries(1, 1, [(0, 0, 5)])?.to_wide();
    /// let values = MorseComplex::new(&edge).pullback(0, &value);
    /// assert_eq!(values.to_narrow()?.entries(), [5, 5]);
    /// # Ok(()) }
    /// ```
    pub fn pullback(&self, degree: usize, cochains: &WideMatrix) -> WideMatrix {
        let critical = self.matching.critical_cells(degree);
        assert_eq!(cochains.column_count(), critical.len(), "a cochain has a value on each critical cell");
        let given = critical
            .iter()
            .zip(cochains.columns())
            .map(|(&cell, column)| (cell, column.terms().map(|(row, x)| (narrow(row), x.clone())).collect()));
        let mut sweep = Sweep::new(self.complex.cell_count(degree), given);
        sweep.run(&self.complex, &self.matching, degree + 1, None);
        self.to_matrix(degree, cochains.row_count(), &sweep)
    }

    /// Cochains of the original complex as cochains of the Morse complex, by composition with the inclusion; shapes as
    /// in [`Self::pullback`], which this undoes.
    ///
    /// # Panics
    /// Unless the argument has a column for each cell of this degree.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{MorseComplex, TwoSkeleton};
    /// use coface_algebra::{RaggedArray, SparseMatrix};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = TwoSkeleton::new(2, vec![0, 1], RaggedArray::new())?.chain_complex()?;
    /// // Vertex 0 is critical, vertex 1 is not.
    /// let values = SparseMatrix::from_entries(1, 2, [(0, 0, 5), (0, 1, 7)])?.to_wide();
    /// assert_eq!(MorseComplex::new(&edge).restriction(0, &values).to_narrow()?.entries(), [5]);
    /// # Ok(()) }
    /// ```
    pub fn restriction(&self, degree: usize, cochains: &WideMatrix) -> WideMatrix {
        let critical = self.matching.critical_cells(degree);
        // g(c) = c - h(boundary of c).
        let homotopy = (degree > 0).then(|| self.cohomotopy(degree, cochains));
        let columns = critical.iter().map(|&cell| {
            let own: SparseVector =
                cochains.column(cell as usize).terms().map(|(row, x)| (narrow(row), x.clone())).collect();
            let mut terms = vec![(Integer::ONE, own)];
            if let (Some(homotopy), Some(matrix)) = (&homotopy, self.complex.boundary_matrix(degree)) {
                for (face, entry) in matrix.column(cell as usize).terms() {
                    let list = homotopy.column(face).terms().map(|(row, x)| (narrow(row), x.clone()));
                    terms.push((-entry.to_integer(), list.collect()));
                }
            }
            linear_combination(terms.iter().map(|(x, list)| (x, &list[..])))
        });
        WideMatrix::from_integer_columns(cochains.row_count(), columns)
            .expect("critical cells have 32-bit numbers")
    }

    /// Cochains of this degree composed with the homotopy: cochains of one degree less. For a closed cochain w it gives
    /// a cochain whose coboundary is the difference between w and the pullback of its restriction. Shapes as in
    /// [`Self::pullback`], on cells of `degree` and of `degree - 1`.
    ///
    /// # Panics
    /// For degree 0, and unless the argument has a column for each cell of this degree.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{MorseComplex, TwoSkeleton};
    /// use coface_algebra::{RaggedArray, SparseMatrix};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = TwoSkeleton::new(2, vec![0, 1], RaggedArray::new())?.chain_complex()?;
    /// // The edge climbs by 5: that is the height of vertex 1 over vertex 0.
    /// let climb = SparseMatrix::from_entries(1, 1, [(0, 0, 5)])?.to_wide();
    /// let heights = MorseComplex::new(&edge).cohomotopy(1, &climb);
    /// assert_eq!((heights.entry(0, 0), heights.entry(0, 1)), (0.into(), 5.into()));
    /// # Ok(()) }
    /// ```
    pub fn cohomotopy(&self, degree: usize, cochains: &WideMatrix) -> WideMatrix {
        assert!(degree > 0, "there are no cochains of degree -1");
        assert_eq!(
            cochains.column_count(),
            self.complex.cell_count(degree),
            "a cochain has a value on each cell"
        );
        let given = cochains.columns().enumerate().filter(|(_, column)| !column.rows().is_empty());
        let given = given.map(|(cell, column)| {
            (narrow(cell), column.terms().map(|(row, x)| (narrow(row), x.clone())).collect())
        });
        let source = Sweep::new(cochains.column_count(), given);
        let mut sweep = Sweep::new(self.complex.cell_count(degree - 1), []);
        sweep.run(&self.complex, &self.matching, degree, Some(&source));
        self.to_matrix(degree - 1, cochains.row_count(), &sweep)
    }

    fn to_matrix(&self, degree: usize, row_count: usize, sweep: &Sweep) -> WideMatrix {
        let columns = (0..self.complex.cell_count(degree)).map(|cell| sweep.list(cell));
        WideMatrix::from_sorted_columns(row_count, columns).expect("cells have 32-bit numbers")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::matrices::SparseMatrix;
    use crate::samples::random_complexes;
    use proptest::prelude::*;
    use std::collections::BTreeMap;

    type Sparse = BTreeMap<u32, Integer>;

    fn sum<'a>(terms: impl Iterator<Item = (u32, Integer, &'a [(u32, Integer)])>) -> Sparse {
        let mut total = Sparse::new();
        for (_, x, chain) in terms {
            for (cell, y) in chain {
                *total.entry(*cell).or_default() += &(&x * y);
            }
        }
        total.retain(|_, x| !x.is_zero());
        total
    }

    proptest! {
        #[test]
        fn morse_boundary_of_boundary_is_zero_and_inclusion_is_a_chain_map(complex in random_complexes()) {
            let morse = MorseComplex::new(&complex);
            for degree in 1..complex.degree_count() {
                let matrix = complex.boundary_matrix(degree).unwrap();
                for i in 0..morse.critical_count(degree) {
                    let boundary = morse.boundary(degree, i);
                    let twice = sum(boundary.iter().map(|(j, x)| (*j, x.clone(), morse.boundary(degree - 1, *j as usize))));
                    prop_assert!(twice.is_empty());
                    // Boundary of the image = image of the boundary.
                    let image = morse.inclusion(degree, &[(i as u32, Integer::ONE)]);
                    let columns: Vec<Vec<(u32, Integer)>> = image
                        .iter()
                        .map(|(cell, _)| matrix.column(*cell as usize).iter().map(|(r, x)| (r as u32, x.into())).collect())
                        .collect();
                    let first = sum(image.iter().zip(&columns).map(|((cell, x), column)| (*cell, x.clone(), &column[..])));
                    let second: Sparse = morse.inclusion(degree - 1, boundary).into_iter().collect();
                    prop_assert_eq!(first, second);
                }
            }
        }

        /// The projection undoes the inclusion, and both sides of $1 - g f = \partial h + h \partial$ agree on random
        /// chains.
        #[test]
        fn projection_and_homotopy_retract(complex in random_complexes(), seed in prop::collection::vec(-3i64..4, 60)) {
            let morse = MorseComplex::new(&complex);
            let boundary = |degree: usize, chain: &[(u32, Integer)]| -> SparseVector {
                let Some(matrix) = complex.boundary_matrix(degree) else { return Vec::new() };
                let columns: Vec<(Integer, SparseVector)> = chain.iter().map(|(cell, x)| {
                    (x.clone(), matrix.column(*cell as usize).iter().map(|(r, y)| (r as u32, y.into())).collect())
                }).collect();
                linear_combination(columns.iter().map(|(x, column)| (x, &column[..])))
            };
            let (one, minus_one) = (Integer::ONE, Integer::from(-1));
            for degree in 0..complex.degree_count() {
                for i in 0..morse.critical_count(degree) as u32 {
                    let cell = [(i, Integer::ONE)];
                    prop_assert_eq!(morse.projection(degree, &morse.inclusion(degree, &cell)), &cell);
                    prop_assert!(morse.homotopy(degree, &morse.inclusion(degree, &cell)).is_empty());
                }
                let chain: SparseVector = (0..complex.cell_count(degree) as u32)
                    .map(|c| (c, Integer::from(seed[(c as usize * 7 + degree) % seed.len()])))
                    .filter(|(_, x)| !x.is_zero())
                    .collect();
                let (projection, homotopy) = morse.projection_and_homotopy(degree, &chain);
                let image = morse.inclusion(degree, &projection);
                let left = linear_combination([(&one, &chain[..]), (&minus_one, &image[..])]);
                let first = boundary(degree + 1, &homotopy);
                let second = match degree {
                    0 => Vec::new(),
                    _ => morse.homotopy(degree - 1, &boundary(degree, &chain)),
                };
                prop_assert_eq!(left, linear_combination([(&one, &first[..]), (&one, &second[..])]));
            }
        }

        /// Cochains composed with projection, inclusion and homotopy have the values that chains mapped by them give.
        #[test]
        fn cochains_are_carried_by_the_same_maps(complex in random_complexes()) {
            let morse = MorseComplex::new(&complex);
            let identity = |count: usize| {
                WideMatrix::from_integer_columns(count, (0..count as u32).map(|i| vec![(i, Integer::ONE)])).unwrap()
            };
            let column = |matrix: &WideMatrix, j: usize| -> SparseVector {
                matrix.column(j).terms().map(|(row, x)| (row as u32, x.clone())).collect()
            };
            for degree in 0..complex.degree_count() {
                // The pullback of all unit cochains is the matrix of the projection, and so on.
                let pulled = morse.pullback(degree, &identity(morse.critical_count(degree)));
                let cells = complex.cell_count(degree);
                for cell in 0..cells {
                    prop_assert_eq!(column(&pulled, cell), morse.projection(degree, &[(cell as u32, Integer::ONE)]));
                }
                let restricted = morse.restriction(degree, &identity(cells));
                for i in 0..morse.critical_count(degree) {
                    prop_assert_eq!(column(&restricted, i), morse.inclusion(degree, &[(i as u32, Integer::ONE)]));
                }
                if degree > 0 {
                    let carried = morse.cohomotopy(degree, &identity(cells));
                    for cell in 0..complex.cell_count(degree - 1) {
                        prop_assert_eq!(column(&carried, cell), morse.homotopy(degree - 1, &[(cell as u32, Integer::ONE)]));
                    }
                }
            }
        }
    }

    /// Coefficients double along a chain of cells: 70 steps leave 64 bits.
    #[test]
    fn coefficients_widen() {
        let steps = 70;
        // Disk i has the boundary e(i) - 2 e(i+1) on loops at one vertex, the last disk runs along e(0) alone.
        let entries = (0..steps).flat_map(|i| [(i, i, 1), (i + 1, i, -2)]).chain([(0, steps, 1)]);
        let complex = ChainComplex::new(vec![
            SparseMatrix::zero(1, steps + 1).unwrap(),
            SparseMatrix::from_entries(steps + 1, steps + 1, entries).unwrap(),
        ])
        .unwrap();
        let morse = MorseComplex::new(&complex);
        assert_eq!((0..3).map(|degree| morse.critical_count(degree)).collect::<Vec<_>>(), [1, 1, 1]);
        let power: Integer = (1i128 << 70).to_string().parse().unwrap();
        assert_eq!(morse.boundary(2, 0)[0].1.abs(), power);
    }
}
