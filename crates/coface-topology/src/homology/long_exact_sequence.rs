//! The long exact homology sequence of a pair.

use crate::homology::basis::HomologyBasis;
use crate::homology::computation::Homology;
use crate::homology::induced_maps::map_of_generators;
use crate::homology::induced_maps::{HomologyMap, induced_maps};
use coface_algebra::chains::{Chain, ChainComplex, ChainMap};
use coface_algebra::{CellId, Error, ErrorKind};

/// The long exact sequence of a complex K and a subcomplex L,
/// $\cdots \to H_k(L) \to H_k(K) \to H_k(K, L) \to H_{k-1}(L) \to \cdots$, over the integers.
///
/// The last map is the **connecting** homomorphism: a relative cycle goes to its boundary, which lies in L.
/// Generators of the three groups are those of [`HomologyBasis`] for [`ChainComplex::subcomplex`], the complex, and
/// [`ChainComplex::relative`].
///
/// # References
/// J. R. Munkres, *Elements of Algebraic Topology* (1984), section 23.
///
/// # Examples
/// The connecting map takes the disk, relative to its rim, to the loop around the rim:
/// ```
/// use coface_algebra::CellId;
/// use coface_complexes::known_spaces::simplex;
/// use coface_topology::LongExactSequence;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let disk = simplex(2)?.chain_complex()?;
/// let rim: Vec<Vec<CellId>> = vec![(0..3).map(CellId::new).collect(), (0..3).map(CellId::new).collect()];
/// let sequence = LongExactSequence::new(&disk, &rim)?;
/// assert_eq!(sequence.pair().betti_numbers(), [0, 0, 1]);
/// assert_eq!(sequence.connecting(2).map(|map| map.columns()[0][0].abs()), Some(1.into()));
/// sequence.check()?;
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct LongExactSequence {
    part: Homology,
    whole: Homology,
    pair: Homology,
    inclusion: Vec<HomologyMap>,
    projection: Vec<HomologyMap>,
    /// From degree k to k - 1, at position k - 1.
    connecting: Vec<HomologyMap>,
}

impl LongExactSequence {
    /// The sequence of a complex and some of its cells, which must have their faces among them, by degree.
    ///
    /// # Errors
    /// Those of [`ChainComplex::subcomplex`].
    ///
    /// # Complexity
    /// Three times that of [`HomologyBasis`], and for each generator the class of its image.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::LongExactSequence;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A segment and its two ends.
    /// let segment = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
    /// let ends = vec![vec![CellId::new(0), CellId::new(1)]];
    /// let sequence = LongExactSequence::new(&segment, &ends)?;
    /// assert_eq!(sequence.pair().betti_numbers(), [0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn new(complex: &ChainComplex, cells: &[Vec<CellId>]) -> Result<Self, Error> {
        let part = complex.subcomplex(cells)?;
        let relative = complex.relative(cells)?;
        let kept = complex.complement(cells)?;
        let [part_basis, whole_basis, pair_basis] = [&part, complex, &relative].map(HomologyBasis::new);
        let inclusion = induced_maps(&ChainMap::inclusion(complex, cells)?, &part_basis, &whole_basis)?;
        let projection = induced_maps(&ChainMap::projection(complex, cells)?, &whole_basis, &pair_basis)?;
        // Where each cell of the complex is in the subcomplex.
        let position = |degree: usize| {
            let mut position = vec![None; complex.cell_count(degree)];
            for (at, cell) in cells.get(degree).into_iter().flatten().enumerate() {
                position[cell.index()] = Some(CellId::new(at));
            }
            position
        };
        let connecting = (1..relative.degree_count()).map(|degree| {
            let position = position(degree - 1);
            map_of_generators(&pair_basis, degree, &part_basis, degree - 1, |chain| {
                let terms = chain.terms().iter().map(|(cell, x)| (kept[degree][cell.index()], x.clone()));
                let boundary = complex.boundary(&Chain::new(complex, degree, terms)?)?;
                let inside = boundary.terms().iter().map(|(cell, x)| {
                    (
                        position[cell.index()]
                            .expect("the boundary of a relative cycle lies in the subcomplex"),
                        x.clone(),
                    )
                });
                Chain::new(&part, degree - 1, inside)
            })
        });
        let connecting = connecting.collect::<Result<_, Error>>()?;
        Ok(Self {
            part: part_basis.homology(),
            whole: whole_basis.homology(),
            pair: pair_basis.homology(),
            inclusion,
            projection,
            connecting,
        })
    }

    /// The homology of the subcomplex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::LongExactSequence;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A segment and its two ends.
    /// let segment = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
    /// let ends = vec![vec![CellId::new(0), CellId::new(1)]];
    /// let sequence = LongExactSequence::new(&segment, &ends)?;
    /// assert_eq!(sequence.part().betti_numbers(), [2, 0]);
    /// # Ok(()) }
    /// ```
    pub fn part(&self) -> &Homology {
        &self.part
    }

    /// The homology of the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::LongExactSequence;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A segment and its two ends.
    /// let segment = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
    /// let ends = vec![vec![CellId::new(0), CellId::new(1)]];
    /// let sequence = LongExactSequence::new(&segment, &ends)?;
    /// assert_eq!(sequence.whole().betti_numbers(), [1, 0]);
    /// # Ok(()) }
    /// ```
    pub fn whole(&self) -> &Homology {
        &self.whole
    }

    /// The homology of the pair.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::LongExactSequence;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A segment and its two ends.
    /// let segment = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
    /// let ends = vec![vec![CellId::new(0), CellId::new(1)]];
    /// let sequence = LongExactSequence::new(&segment, &ends)?;
    /// assert_eq!(sequence.pair().betti_numbers(), [0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn pair(&self) -> &Homology {
        &self.pair
    }

    /// The map from the subcomplex to the complex in this degree; `None` beyond the degrees of the subcomplex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::LongExactSequence;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A segment and its two ends.
    /// let segment = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
    /// let ends = vec![vec![CellId::new(0), CellId::new(1)]];
    /// let sequence = LongExactSequence::new(&segment, &ends)?;
    /// // Both ends go to the one component.
    /// assert_eq!(sequence.inclusion(0).expect("degree 0").kernel().to_string(), "Z");
    /// # Ok(()) }
    /// ```
    pub fn inclusion(&self, degree: usize) -> Option<&HomologyMap> {
        self.inclusion.get(degree)
    }

    /// The map from the complex to the pair in this degree; `None` beyond the degrees of the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::LongExactSequence;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A segment and its two ends.
    /// let segment = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
    /// let ends = vec![vec![CellId::new(0), CellId::new(1)]];
    /// let sequence = LongExactSequence::new(&segment, &ends)?;
    /// assert!(sequence.projection(0).expect("degree 0").is_zero());
    /// # Ok(()) }
    /// ```
    pub fn projection(&self, degree: usize) -> Option<&HomologyMap> {
        self.projection.get(degree)
    }

    /// The connecting map from this degree of the pair to the degree below of the subcomplex; `None` for degree 0 and
    /// beyond the degrees of the pair.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::LongExactSequence;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A segment and its two ends.
    /// let segment = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
    /// let ends = vec![vec![CellId::new(0), CellId::new(1)]];
    /// let sequence = LongExactSequence::new(&segment, &ends)?;
    /// // The segment goes to the difference of its ends.
    /// assert!(sequence.connecting(1).expect("degree 1").is_injective());
    /// assert!(sequence.connecting(0).is_none());
    /// # Ok(()) }
    /// ```
    pub fn connecting(&self, degree: usize) -> Option<&HomologyMap> {
        self.connecting.get(degree.checked_sub(1)?)
    }

    /// Verifies that the sequence is exact at every group.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the first group where it is not.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::LongExactSequence;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A segment and its two ends.
    /// let segment = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
    /// let ends = vec![vec![CellId::new(0), CellId::new(1)]];
    /// let sequence = LongExactSequence::new(&segment, &ends)?;
    /// sequence.check()?;
    /// # Ok(()) }
    /// ```
    pub fn check(&self) -> Result<(), Error> {
        // From the top: ..., pair(k + 1), part(k), whole(k), pair(k), part(k - 1), ...
        let top = self.pair.groups().len();
        let mut maps: Vec<(String, HomologyMap)> = Vec::new();
        for degree in (0..top).rev() {
            // Beyond the dimension of the subcomplex its groups are zero.
            let projection = &self.projection[degree];
            let inclusion = self.inclusion(degree).cloned().unwrap_or_else(|| {
                HomologyMap::new(Vec::new(), projection.source_orders().to_vec(), Vec::new())
            });
            if degree + 1 == top {
                let nothing = HomologyMap::new(Vec::new(), inclusion.source_orders().to_vec(), Vec::new());
                maps.push(("the top".to_owned(), nothing));
            }
            maps.push((format!("H_{degree} of the subcomplex"), inclusion));
            maps.push((format!("H_{degree} of the complex"), projection.clone()));
            let out = self.connecting(degree).cloned().unwrap_or_else(|| {
                let orders = projection.target_orders().to_vec();
                let columns = vec![Vec::new(); orders.len()];
                HomologyMap::new(orders, Vec::new(), columns)
            });
            maps.push((format!("H_{degree} of the pair"), out));
        }
        for pair in maps.windows(2) {
            let [(_, before), (place, after)] = pair else { continue };
            if !before.is_exact_before(after) {
                return Err(Error::new(
                    ErrorKind::InvalidInput,
                    format!("the sequence is not exact at {place}"),
                ));
            }
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::samples::{closed_cells, random_complexes};
    use coface_complexes::known_spaces::{projective_plane, triangle_strip};
    use proptest::prelude::*;

    proptest! {
        /// Invariant 20: the sequence of a random complex and a random subcomplex is exact.
        #[test]
        fn long_sequences_are_exact(
            complex in random_complexes(),
            sizes in prop::collection::vec(0usize..40, 4),
        ) {
            let cells = closed_cells(&complex, &sizes);
            let sequence = LongExactSequence::new(&complex, &cells).unwrap();
            prop_assert!(sequence.check().is_ok(), "{:?} {sequence:?}", sequence.check());
        }
    }

    /// The loop in the middle of a Moebius band is twice met by its rim: the rim is twice the middle.
    /// A prime beyond all torsion of small complexes, so that ranks over its field are ranks over Q.
    const PRIME: i64 = 1_000_003;

    /// Chains over the field of a prime, in the cells of one degree.
    type Rows = Vec<Vec<i64>>;

    /// The rows in echelon form.
    fn reduced(mut rows: Rows) -> Rows {
        let inverse = |x: i64| {
            let (mut power, mut result, mut rest) = (x, 1, PRIME - 2);
            while rest > 0 {
                result = if rest & 1 == 1 { result * power % PRIME } else { result };
                (power, rest) = (power * power % PRIME, rest >> 1);
            }
            result
        };
        let width = rows.first().map_or(0, Vec::len);
        let mut rank = 0;
        for column in 0..width {
            let Some(pivot) = (rank..rows.len()).find(|&row| rows[row][column] != 0) else { continue };
            rows.swap(rank, pivot);
            let scale = inverse(rows[rank][column]);
            rows[rank].iter_mut().for_each(|x| *x = *x * scale % PRIME);
            let own = rows[rank].clone();
            for row in rows.iter_mut().skip(rank + 1) {
                let factor = row[column];
                row.iter_mut().zip(&own).for_each(|(x, y)| *x = (*x - factor * y % PRIME + PRIME) % PRIME);
            }
            rank += 1;
        }
        rows.truncate(rank);
        rows
    }

    fn rank(rows: Rows) -> usize {
        reduced(rows).len()
    }

    /// The dimension of what these vectors span modulo others.
    fn rank_modulo(rows: &Rows, others: &Rows) -> usize {
        rank([&rows[..], others].concat()) - rank(others.clone())
    }

    /// What is known of a complex over the field, by elimination in dense matrices alone.
    struct Dense<'c> {
        complex: &'c ChainComplex,
        is_inside: Vec<Vec<bool>>,
    }

    impl Dense<'_> {
        fn boundary(&self, degree: usize, cell: usize) -> Vec<i64> {
            let mut image = vec![0; if degree == 0 { 0 } else { self.complex.cell_count(degree - 1) }];
            if let Some(matrix) = self.complex.boundary_matrix(degree) {
                matrix.column(cell).iter().for_each(|(row, x)| image[row] = i64::from(x).rem_euclid(PRIME));
            }
            image
        }

        /// Chains of these cells whose boundary lies in the subcomplex, or is zero.
        fn cycles(&self, degree: usize, cells: impl Fn(usize) -> bool, modulo: bool) -> Rows {
            let count = self.complex.cell_count(degree);
            let width = if degree == 0 { 0 } else { self.complex.cell_count(degree - 1) };
            let rows = (0..count).filter(|&cell| cells(cell)).map(|cell| {
                let mut row = self.boundary(degree, cell);
                let below = row.iter_mut().enumerate();
                below
                    .filter(|(face, _)| modulo && self.is_inside[degree - 1][*face])
                    .for_each(|(_, x)| *x = 0);
                row.extend((0..count).map(|other| i64::from(other == cell)));
                row
            });
            let found = reduced(rows.collect());
            let kernel = found.into_iter().filter(|row| row[..width].iter().all(|&x| x == 0));
            kernel.map(|row| row[width..].to_vec()).collect()
        }

        fn boundaries(&self, degree: usize, cells: impl Fn(usize) -> bool) -> Rows {
            (0..self.complex.cell_count(degree + 1))
                .filter(|&cell| cells(cell))
                .map(|cell| self.boundary(degree + 1, cell))
                .collect()
        }

        fn inside(&self, degree: usize) -> impl Fn(usize) -> bool + '_ {
            move |cell| self.is_inside.get(degree).is_some_and(|inside| inside[cell])
        }

        /// Each cell of the subcomplex as a chain.
        fn inner_chains(&self, degree: usize) -> Rows {
            let count = self.complex.cell_count(degree);
            let cells = (0..count).filter(|&cell| self.is_inside[degree][cell]);
            cells.map(|cell| (0..count).map(|other| i64::from(other == cell)).collect()).collect()
        }

        /// The ranks of the inclusion, the projection and the connecting map of a degree.
        fn ranks(&self, degree: usize) -> [usize; 3] {
            let all = |_: usize| true;
            let boundaries = self.boundaries(degree, all);
            let inclusion = rank_modulo(&self.cycles(degree, self.inside(degree), false), &boundaries);
            let relative = [boundaries, self.inner_chains(degree)].concat();
            let projection = rank_modulo(&self.cycles(degree, all, false), &relative);
            let Some(below) = degree.checked_sub(1) else { return [inclusion, projection, 0] };
            let images =
                self.cycles(degree, |cell| !self.inside(degree)(cell), true).into_iter().map(|chain| {
                    let mut image = vec![0; self.complex.cell_count(below)];
                    for (cell, x) in chain.into_iter().enumerate().filter(|(_, x)| *x != 0) {
                        let boundary = self.boundary(degree, cell);
                        image.iter_mut().zip(boundary).for_each(|(sum, y)| *sum = (*sum + x * y) % PRIME);
                    }
                    image
                });
            let inner = self.boundaries(below, self.inside(degree));
            [inclusion, projection, rank_modulo(&images.collect(), &inner)]
        }
    }

    proptest! {
        #[test]
        fn ranks_are_those_of_elimination_over_a_field(
            complex in random_complexes(),
            sizes in prop::collection::vec(0usize..40, 4),
        ) {
            let cells = closed_cells(&complex, &sizes);
            let sequence = LongExactSequence::new(&complex, &cells).unwrap();
            let is_inside = (0..complex.degree_count()).map(|degree| {
                let mut inside = vec![false; complex.cell_count(degree)];
                cells[degree].iter().for_each(|cell| inside[cell.index()] = true);
                inside
            });
            let dense = Dense { complex: &complex, is_inside: is_inside.collect() };
            let rank_of = |map: Option<&HomologyMap>| map.map_or(0, |map| map.image_group().betti());
            let mut above = 0;
            for degree in (0..complex.degree_count()).rev() {
                let found = [sequence.inclusion(degree), sequence.projection(degree), sequence.connecting(degree)];
                let [inclusion, projection, connecting] = dense.ranks(degree);
                prop_assert_eq!(found.map(rank_of), [inclusion, projection, connecting], "degree {}", degree);
                // Image and kernel have one dimension at each place: their ranks add up to the Betti numbers.
                let betti = |homology: &Homology| homology.groups().get(degree).map_or(0, |group| group.betti());
                prop_assert_eq!(betti(sequence.part()), above + inclusion);
                prop_assert_eq!(betti(sequence.whole()), inclusion + projection);
                prop_assert_eq!(betti(sequence.pair()), projection + connecting);
                above = connecting;
            }
        }
    }

    #[test]
    fn the_rim_of_a_moebius_band_goes_twice_around() {
        let band = triangle_strip(5).unwrap().freeze();
        let complex = band.chain_complex().unwrap();
        let degrees = band.f_vector();
        let mut count = vec![0; degrees[1]];
        complex.boundary_matrix(2).unwrap().rows().iter().for_each(|&row| count[row as usize] += 1);
        let edges: Vec<CellId> = (0..degrees[1]).filter(|&e| count[e] == 1).map(CellId::new).collect();
        let vertices = (0..degrees[0]).map(CellId::new).collect();
        let sequence = LongExactSequence::new(&complex, &[vertices, edges]).unwrap();
        assert_eq!(sequence.inclusion(1).unwrap().columns()[0][0].abs(), 2.into());
        assert_eq!(sequence.pair().groups()[1].to_string(), "Z/2");
        sequence.check().unwrap();
    }

    /// A sequence with a wrong map is found out.
    #[test]
    fn what_is_not_exact_is_named() {
        let plane = projective_plane().unwrap().chain_complex().unwrap();
        let vertex = vec![vec![CellId::new(0)]];
        let mut sequence = LongExactSequence::new(&plane, &vertex).unwrap();
        sequence.check().unwrap();
        sequence.projection[1] =
            HomologyMap::new(vec![Some(2.into())], vec![Some(2.into())], vec![vec![0.into()]]);
        assert!(sequence.check().unwrap_err().to_string().contains("H_1"));
    }
}
