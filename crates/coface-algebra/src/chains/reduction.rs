//! A chain complex reduced by one acyclic matching after another.

use super::{ChainComplex, MorseComplex};
use crate::integers::Integer;
use crate::matrices::{SparseMatrix, SparseVector, WideMatrix, linear_combination};
use crate::progress::{Steps, stage};
use std::borrow::Cow;

/// A chain complex reduced by acyclic matchings, each in the Morse complex of the one before, until none finds a pair.
/// The reduced complex has the integral homology of the original, and the maps of [`MorseComplex`] compose: inclusion
/// g, projection f and homotopy h with $f g = 1$ and $1 - g f = \partial h + h \partial$.
///
/// Cells of the reduced complex are critical cells of the last matching, by their numbers. A complex without unit
/// incidences cannot be reduced further; where the greedy matching leaves some, or where boundaries outgrow the 32 bits
/// of a [`ChainComplex`], Smith normal form takes them as its first pivots.
///
/// # Complexity
/// That of the first [`MorseComplex`]: the further ones are of what it leaves.
///
/// # Examples
/// A torus of one vertex, two loops and a square, with one loop cut in two:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_algebra::chains::{Reduction, TwoSkeleton};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// // Edges 0 and 1 are the first loop, edge 2 is the second; the face runs along 0 1 2 -1 -0 -2.
/// let rim = RaggedArray::from_lists([[0, 2, 4, 3, 1, 5]]);
/// let torus = TwoSkeleton::new(2, vec![0, 1, 1, 0, 0, 0], rim)?.chain_complex()?;
/// let reduction = Reduction::new(&torus);
/// assert_eq!([0, 1, 2].map(|degree| reduction.cell_count(degree)), [1, 2, 1]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct Reduction<'a> {
    /// At least one; each further one is of the Morse complex of the one before.
    levels: Vec<MorseComplex<'a>>,
}

impl<'a> Reduction<'a> {
    /// Matches and cancels as long as there is a pair.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, Reduction};
    /// assert_eq!(Reduction::new(&ChainComplex::of_points(2)).cell_count(0), 2);
    /// ```
    pub fn new(complex: &'a ChainComplex) -> Self {
        let mut levels = vec![MorseComplex::new(complex)];
        while let Some(left) = levels.last().and_then(narrow_complex) {
            let next = MorseComplex::of(Cow::Owned(left));
            let is_smaller = (0..next.complex().degree_count())
                .any(|degree| next.critical_count(degree) < next.complex().cell_count(degree));
            if !is_smaller {
                break;
            }
            levels.push(next);
        }
        Self { levels }
    }

    fn last(&self) -> &MorseComplex<'a> {
        self.levels.last().expect("there is at least one level")
    }

    /// The complex that was reduced.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, Reduction};
    /// let points = ChainComplex::of_points(2);
    /// assert_eq!(Reduction::new(&points).complex(), &points);
    /// ```
    pub fn complex(&self) -> &ChainComplex {
        self.levels[0].complex()
    }

    /// The number of matchings taken.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, Reduction};
    /// assert_eq!(Reduction::new(&ChainComplex::of_points(2)).level_count(), 1);
    /// ```
    pub fn level_count(&self) -> usize {
        self.levels.len()
    }

    /// The number of cells of the reduced complex in this degree.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{Reduction, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = TwoSkeleton::new(3, vec![0, 1, 1, 2, 2, 0], RaggedArray::new())?.chain_complex()?;
    /// let reduction = Reduction::new(&circle);
    /// assert_eq!([0, 1].map(|degree| reduction.cell_count(degree)), [1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn cell_count(&self, degree: usize) -> usize {
        self.last().critical_count(degree)
    }

    /// The boundary matrix of the reduced complex from this degree to the one below. Without rows for degree 0, without
    /// columns beyond the dimension.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{Reduction, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: nothing cancels an incidence of 2.
    /// let plane = TwoSkeleton::new(1, vec![0, 0], RaggedArray::from_lists([[0, 0]]))?.chain_complex()?;
    /// assert_eq!(Reduction::new(&plane).boundary_matrix(2).entry(0, 0).abs(), 2.into());
    /// # Ok(()) }
    /// ```
    pub fn boundary_matrix(&self, degree: usize) -> WideMatrix {
        self.last().boundary_matrix(degree)
    }

    /// The images in the original complex of chains of the reduced one; see [`MorseComplex::inclusion`].
    ///
    /// # Panics
    /// If a number is not below the count of cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{Reduction, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = TwoSkeleton::new(3, vec![0, 1, 1, 2, 2, 0], RaggedArray::new())?.chain_complex()?;
    /// // The edge that is left stands for the cycle of all three.
    /// let cycles = Reduction::new(&circle).inclusions(1, vec![vec![(0, 1.into())]]);
    /// assert_eq!(cycles[0].len(), 3);
    /// # Ok(()) }
    /// ```
    pub fn inclusions(&self, degree: usize, chains: Vec<SparseVector>) -> Vec<SparseVector> {
        let steps = stage("growing chains", chains.len() * self.levels.len());
        self.inclusions_with_steps(degree, chains, &steps)
    }

    /// As [`Self::inclusions`], and counts a step for each chain and matching.
    #[doc(hidden)]
    pub fn inclusions_with_steps(
        &self,
        degree: usize,
        chains: Vec<SparseVector>,
        steps: &Steps,
    ) -> Vec<SparseVector> {
        self.levels.iter().rev().fold(chains, |chains, level| {
            level.inclusions_with_steps(degree, chains.iter().map(Vec::as_slice), steps)
        })
    }

    /// The projection of a chain of the original complex to the reduced one, and the homotopy, a chain of one degree
    /// more on the original cells; see [`MorseComplex::projection`] and [`MorseComplex::homotopy`].
    ///
    /// # Panics
    /// If a cell is not in the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::Integer;
    /// use coface_algebra::chains::{ChainComplex, Reduction};
    /// let points = ChainComplex::of_points(2);
    /// let (projection, homotopy) = Reduction::new(&points).projection_and_homotopy(0, &[(1, Integer::ONE)]);
    /// assert_eq!((projection, homotopy), (vec![(1, Integer::ONE)], vec![]));
    /// ```
    pub fn projection_and_homotopy(
        &self,
        degree: usize,
        chain: &[(u32, Integer)],
    ) -> (SparseVector, SparseVector) {
        let mut projection = chain.to_vec();
        // h = h1 + g1 h2 f1 + g1 g2 h3 f2 f1 + ...
        let mut homotopies = Vec::new();
        for level in &self.levels {
            let (next, homotopy) = level.projection_and_homotopy(degree, &projection);
            projection = next;
            homotopies.push(homotopy);
        }
        let mut sum = SparseVector::new();
        for (level, homotopy) in self.levels.iter().zip(homotopies).rev() {
            if !sum.is_empty() {
                sum = level.inclusion(degree + 1, &sum);
            }
            sum = linear_combination([(&Integer::ONE, &sum[..]), (&Integer::ONE, &homotopy[..])]);
        }
        (projection, sum)
    }

    /// Cochains of the reduced complex composed with the projection; see [`MorseComplex::pullback`].
    ///
    /// # Panics
    /// Unless the argument has a column for each cell of the reduced complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, Reduction};
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(2);
    /// // No cell cancels, so the values stay.
    /// let values = SparseMatrix::from_entries(1, 2, [(0, 0, 5), (0, 1, 7)])?.to_wide();
    /// assert_eq!(Reduction::new(&points).pullback(0, &values), values);
    /// # Ok(()) }
    /// ```
    pub fn pullback(&self, degree: usize, cochains: &WideMatrix) -> WideMatrix {
        let pulled = self.last().pullback(degree, cochains);
        self.levels.iter().rev().skip(1).fold(pulled, |cochains, level| level.pullback(degree, &cochains))
    }

    /// Cochains of the original complex composed with the inclusion, and with the homotopy; see
    /// [`MorseComplex::restriction`] and [`MorseComplex::cohomotopy`]. Those composed with the homotopy have no column
    /// in degree 0.
    ///
    /// # Panics
    /// Unless the argument has a column for each cell of the original complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, Reduction};
    /// use coface_algebra::SparseMatrix;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(2);
    /// let values = SparseMatrix::from_entries(1, 2, [(0, 0, 5), (0, 1, 7)])?.to_wide();
    /// let (restriction, cohomotopy) = Reduction::new(&points).restriction_and_cohomotopy(0, &values);
    /// assert_eq!((restriction, cohomotopy.column_count()), (values, 0));
    /// # Ok(()) }
    /// ```
    pub fn restriction_and_cohomotopy(
        &self,
        degree: usize,
        cochains: &WideMatrix,
    ) -> (WideMatrix, WideMatrix) {
        let none =
            || WideMatrix::from_integer_columns(cochains.row_count(), []).expect("an empty matrix fits");
        let mut restriction = cochains.clone();
        let mut homotopies = Vec::new();
        for level in &self.levels {
            homotopies.push(if degree > 0 { level.cohomotopy(degree, &restriction) } else { none() });
            restriction = level.restriction(degree, &restriction);
        }
        if degree == 0 {
            return (restriction, none());
        }
        let mut sum: Option<WideMatrix> = None;
        for (level, homotopy) in self.levels.iter().zip(homotopies).rev() {
            sum = Some(match sum {
                None => homotopy,
                Some(inner) => level
                    .pullback(degree - 1, &inner)
                    .sum(&homotopy)
                    .expect("both have the shape of this level")
                    .into_wide(),
            });
        }
        (restriction, sum.unwrap_or_else(none))
    }
}

/// The Morse complex as a chain complex, if a further matching could find a pair in it: if it has a unit incidence and
/// no entry beyond 32 bits.
fn narrow_complex(morse: &MorseComplex<'_>) -> Option<ChainComplex> {
    let degree_count = morse.complex().degree_count();
    let has_unit = (1..degree_count).any(|degree| {
        (0..morse.critical_count(degree))
            .any(|i| morse.boundary(degree, i).iter().any(|(_, entry)| entry.is_unit()))
    });
    if !has_unit {
        return None;
    }
    let boundaries: Option<Vec<SparseMatrix>> =
        (1..degree_count).map(|degree| morse.boundary_matrix(degree).to_narrow().ok()).collect();
    Some(ChainComplex::new(boundaries?).expect("boundary of boundary is zero in a Morse complex"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::random_complexes;
    use proptest::prelude::*;

    /// The boundary of a chain of a complex.
    fn boundary(complex: &ChainComplex, degree: usize, chain: &[(u32, Integer)]) -> SparseVector {
        let Some(matrix) = complex.boundary_matrix(degree) else { return Vec::new() };
        let columns: Vec<(Integer, SparseVector)> = chain
            .iter()
            .map(|(cell, x)| {
                (x.clone(), matrix.column(*cell as usize).iter().map(|(r, y)| (r as u32, y.into())).collect())
            })
            .collect();
        linear_combination(columns.iter().map(|(x, column)| (x, &column[..])))
    }

    fn column(matrix: &WideMatrix, j: usize) -> SparseVector {
        matrix.column(j).terms().map(|(row, x)| (row as u32, x.clone())).collect()
    }

    fn identity(count: usize) -> WideMatrix {
        WideMatrix::from_integer_columns(count, (0..count as u32).map(|i| vec![(i, Integer::ONE)])).unwrap()
    }

    proptest! {
        /// Invariant 16: the composed maps are a deformation retraction, on chains and on cochains.
        #[test]
        fn reductions_retract(complex in random_complexes()) {
            let reduction = Reduction::new(&complex);
            let (one, minus_one) = (Integer::ONE, Integer::from(-1));
            for degree in 0..complex.degree_count() {
                for cell in 0..complex.cell_count(degree) as u32 {
                    let chain = [(cell, Integer::ONE)];
                    let (projection, homotopy) = reduction.projection_and_homotopy(degree, &chain);
                    let image = reduction.inclusions(degree, vec![projection.clone()]).pop().unwrap();
                    let first = boundary(&complex, degree + 1, &homotopy);
                    let faces = boundary(&complex, degree, &chain);
                    let second = match degree {
                        0 => Vec::new(),
                        _ => reduction.projection_and_homotopy(degree - 1, &faces).1,
                    };
                    let left = linear_combination([(&one, &chain[..]), (&minus_one, &image[..])]);
                    prop_assert_eq!(left, linear_combination([(&one, &first[..]), (&one, &second[..])]));
                }
                let pulled = reduction.pullback(degree, &identity(reduction.cell_count(degree)));
                let units = identity(complex.cell_count(degree));
                let (restricted, carried) = reduction.restriction_and_cohomotopy(degree, &units);
                for cell in 0..complex.cell_count(degree) {
                    let chain = [(cell as u32, Integer::ONE)];
                    prop_assert_eq!(column(&pulled, cell), reduction.projection_and_homotopy(degree, &chain).0);
                }
                for i in 0..reduction.cell_count(degree) {
                    let image = reduction.inclusions(degree, vec![vec![(i as u32, Integer::ONE)]]).pop().unwrap();
                    prop_assert_eq!(column(&restricted, i), image);
                }
                for cell in 0..carried.column_count() {
                    let chain = [(cell as u32, Integer::ONE)];
                    prop_assert_eq!(column(&carried, cell), reduction.projection_and_homotopy(degree - 1, &chain).1);
                }
            }
        }
    }

    /// A matching that leaves a unit between critical cells is followed by one that takes it.
    #[test]
    fn units_between_critical_cells_are_matched_again() {
        // Three loops at a vertex; disks along 2a + b, a + b and a + 2b + c, each face in two or more of them.
        let complex = ChainComplex::new(vec![
            SparseMatrix::zero(1, 3).unwrap(),
            SparseMatrix::from_entries(
                3,
                3,
                [(0, 0, 2), (1, 0, 1), (0, 1, 1), (1, 1, 1), (0, 2, 1), (1, 2, 2)],
            )
            .unwrap(),
        ])
        .unwrap();
        let reduction = Reduction::new(&complex);
        assert!(reduction.cell_count(1) + reduction.cell_count(2) <= 2, "{reduction:?}");
    }
}
