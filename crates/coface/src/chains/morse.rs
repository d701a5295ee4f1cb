//! The Morse complex: what is left of a chain complex when all pairs of an acyclic matching have cancelled.

use crate::algebra::{Integer, SparseMatrix, WideMatrix};
use crate::chains::{AcyclicMatching, ChainComplex, MatchedPair};
use rayon::prelude::*;

/// The Morse complex of a chain complex: one cell for each critical cell, with the integral homology of the whole.
///
/// The boundary of a critical cell c is found by elimination: as long as the boundary of the chain grown from c has a
/// matched face, the cell of that pair is added with the coefficient that cancels the face. What remains on critical
/// faces is the boundary in the Morse complex, and the grown chain is the image of c under the **inclusion**, a chain
/// map into the original complex that induces an isomorphism on homology.
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
/// use coface::algebra::SparseMatrix;
/// use coface::chains::{ChainComplex, MorseComplex};
/// # fn main() -> Result<(), coface::Error> {
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
pub struct MorseComplex<'a> {
    complex: &'a ChainComplex,
    matching: AcyclicMatching,
    /// The boundary of each critical cell of degree k at position k - 1, on the numbers of the critical faces.
    boundaries: Vec<Vec<Vec<(u32, Integer)>>>,
}

impl<'a> MorseComplex<'a> {
    /// Matches and cancels.
    pub fn new(complex: &'a ChainComplex) -> Self {
        let matching = AcyclicMatching::new(complex);
        let boundaries = (1..complex.degree_count())
            .into_par_iter()
            .map(|degree| {
                let cells = matching.critical_cells(degree);
                if cells.is_empty() || matching.has_zero_boundary(degree) {
                    return vec![Vec::new(); cells.len()];
                }
                let mut flow = Flow::new(complex, &matching, degree);
                cells.iter().map(|&cell| flow.boundary(&[(cell, Integer::ONE)], None)).collect()
            })
            .collect();
        Self { complex, matching, boundaries }
    }

    /// The number of critical cells of this degree.
    pub fn critical_count(&self, degree: usize) -> usize {
        self.matching.critical_cells(degree).len()
    }

    /// The matching that was cancelled.
    pub fn matching(&self) -> &AcyclicMatching {
        &self.matching
    }

    /// The boundary, in the Morse complex, of the critical cell number `i` of this degree: (number of a critical cell
    /// one degree below, coefficient), by rising numbers. Empty for degree 0.
    ///
    /// # Panics
    /// If there is no such critical cell.
    pub fn boundary(&self, degree: usize, i: usize) -> &[(u32, Integer)] {
        assert!(i < self.critical_count(degree), "there is no critical cell {i} of degree {degree}");
        degree.checked_sub(1).map_or(&[], |below| &self.boundaries[below][i])
    }

    /// The boundary matrix of the Morse complex from this degree to the one below, on the numbers of critical cells:
    /// column j is the boundary of critical cell j. Without rows for degree 0, without columns beyond the dimension.
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
    pub fn inclusion(&self, degree: usize, chain: &[(u32, Integer)]) -> Vec<(u32, Integer)> {
        let cells = self.matching.critical_cells(degree);
        let chain: Vec<(u32, Integer)> = chain.iter().map(|(i, x)| (cells[*i as usize], x.clone())).collect();
        let mut image = chain.clone();
        if degree > 0 {
            Flow::new(self.complex, &self.matching, degree).boundary(&chain, Some(&mut image));
        }
        image.sort_unstable_by_key(|&(cell, _)| cell);
        image
    }
}

/// The elimination of matched faces from boundaries of chains of one degree.
struct Flow<'a> {
    matrix: &'a SparseMatrix,
    pairs: &'a [MatchedPair],
    /// For each face its place in `values`: first the matched faces in the order of elimination, then the critical
    /// ones. [`NOWHERE`] for the faces that are themselves cells of pairs one degree below: they cancel there.
    slot_of_face: Vec<u32>,
    slot_count: usize,
    /// The coefficient of each slot; zero between calls.
    values: Vec<i64>,
    /// The matched faces that may have a coefficient; empty between calls.
    waiting: SlotQueue,
}

const NOWHERE: u32 = u32::MAX;

/// The arithmetic of elimination; `None` says that the result does not fit.
trait Number: Clone + Default {
    fn is_zero(&self) -> bool;
    fn from_integer(value: &Integer) -> Option<Self>;
    fn to_integer(&self) -> Integer;
    fn plus_product(&self, a: &Self, b: i32) -> Option<Self>;
}

impl Number for i64 {
    fn is_zero(&self) -> bool {
        *self == 0
    }
    fn from_integer(value: &Integer) -> Option<Self> {
        value.to_i64()
    }
    fn to_integer(&self) -> Integer {
        Integer::from(*self)
    }
    fn plus_product(&self, a: &Self, b: i32) -> Option<Self> {
        self.checked_add(a.checked_mul(i64::from(b))?)
    }
}

impl Number for Integer {
    fn is_zero(&self) -> bool {
        Integer::is_zero(self)
    }
    fn from_integer(value: &Integer) -> Option<Self> {
        Some(value.clone())
    }
    fn to_integer(&self) -> Integer {
        self.clone()
    }
    fn plus_product(&self, a: &Self, b: i32) -> Option<Self> {
        Some(self + &(a * &Integer::from(b)))
    }
}

impl<'a> Flow<'a> {
    fn new(complex: &'a ChainComplex, matching: &'a AcyclicMatching, degree: usize) -> Self {
        let matrix = complex.boundary_matrix(degree).expect("a flow is of a degree with a boundary matrix");
        let pairs = matching.pairs(complex, degree);
        let mut slot_of_face = vec![NOWHERE; matrix.row_count()];
        let critical = matching.critical_cells(degree - 1);
        for (slot, face) in pairs.iter().map(|pair| pair.face).chain(critical.iter().copied()).enumerate() {
            slot_of_face[face as usize] = slot as u32;
        }
        let slot_count = pairs.len() + critical.len();
        let waiting = SlotQueue::new(pairs.len());
        Self { matrix, pairs, slot_of_face, slot_count, values: vec![0; slot_count], waiting }
    }

    /// Grows a chain until its boundary has no matched face. Gives that boundary on the numbers of the critical faces,
    /// and appends to `grown` each cell that was added with its coefficient.
    fn boundary(
        &mut self,
        chain: &[(u32, Integer)],
        grown: Option<&mut Vec<(u32, Integer)>>,
    ) -> Vec<(u32, Integer)> {
        let mut values = std::mem::take(&mut self.values);
        let mut waiting = std::mem::take(&mut self.waiting);
        waiting.from = 0;
        let mut added = grown.is_some().then(Vec::new);
        if let Some(boundary) = self.eliminate(chain, &mut values, &mut waiting, &mut added) {
            (self.values, self.waiting) = (values, waiting);
            append(grown, added);
            return boundary;
        }
        // A coefficient left 64 bits: once more with big integers.
        values.fill(0);
        (self.values, self.waiting) = (values, SlotQueue::new(self.pairs.len()));
        let mut added = grown.is_some().then(Vec::new);
        let mut wide = vec![Integer::ZERO; self.slot_count];
        let boundary = self
            .eliminate(chain, &mut wide, &mut SlotQueue::new(self.pairs.len()), &mut added)
            .expect("big integers hold every coefficient");
        append(grown, added);
        boundary
    }

    fn eliminate<N: Number>(
        &self,
        chain: &[(u32, Integer)],
        values: &mut [N],
        waiting: &mut SlotQueue,
        added: &mut Option<Vec<(u32, N)>>,
    ) -> Option<Vec<(u32, Integer)>> {
        let mut reached = Vec::new();
        for (cell, coefficient) in chain {
            self.add(*cell, &N::from_integer(coefficient)?, values, waiting, &mut reached)?;
        }
        while let Some(slot) = waiting.pop() {
            let value = &values[slot];
            if value.is_zero() {
                continue;
            }
            let MatchedPair { face, cell } = self.pairs[slot];
            // The incidence is a unit, its own inverse.
            let minus_incidence = -self.matrix.entry(face as usize, cell as usize);
            let coefficient = N::default().plus_product(value, minus_incidence)?;
            self.add(cell, &coefficient, values, waiting, &mut reached)?;
            if let Some(added) = added {
                added.push((cell, coefficient));
            }
        }
        reached.sort_unstable();
        reached.dedup();
        let boundary = reached.iter().filter(|&&slot| !values[slot as usize].is_zero());
        let boundary = boundary
            .map(|&slot| (slot - self.pairs.len() as u32, values[slot as usize].to_integer()))
            .collect();
        for &slot in &reached {
            values[slot as usize] = N::default();
        }
        Some(boundary)
    }

    /// Adds a multiple of the boundary of a cell.
    fn add<N: Number>(
        &self,
        cell: u32,
        coefficient: &N,
        values: &mut [N],
        waiting: &mut SlotQueue,
        reached: &mut Vec<u32>,
    ) -> Option<()> {
        for (face, incidence) in self.matrix.column(cell as usize).iter() {
            let slot = self.slot_of_face[face];
            if slot == NOWHERE {
                continue;
            }
            let value = &mut values[slot as usize];
            if value.is_zero() {
                if (slot as usize) < self.pairs.len() {
                    waiting.insert(slot as usize);
                } else {
                    reached.push(slot);
                }
            }
            *value = value.plus_product(coefficient, incidence)?;
        }
        Some(())
    }
}

fn append<N: Number>(grown: Option<&mut Vec<(u32, Integer)>>, added: Option<Vec<(u32, N)>>) {
    if let (Some(grown), Some(added)) = (grown, added) {
        grown.extend(added.into_iter().map(|(cell, x)| (cell, x.to_integer())));
    }
}

/// A set of small numbers that gives its least, when none is ever put in below one already taken: one bit a number, and
/// one bit for each word of them.
#[derive(Default)]
struct SlotQueue {
    words: Vec<u64>,
    summary: Vec<u64>,
    /// No word of the summary before this one has a bit.
    from: usize,
}

impl SlotQueue {
    fn new(count: usize) -> Self {
        let words = count.div_ceil(64);
        Self { words: vec![0; words], summary: vec![0; words.div_ceil(64)], from: 0 }
    }

    fn insert(&mut self, number: usize) {
        self.words[number / 64] |= 1 << (number % 64);
        self.summary[number / 4096] |= 1 << (number / 64 % 64);
    }

    fn pop(&mut self) -> Option<usize> {
        while let Some(&summary) = self.summary.get(self.from) {
            if summary == 0 {
                self.from += 1;
                continue;
            }
            let at = self.from * 64 + summary.trailing_zeros() as usize;
            let word = &mut self.words[at];
            let number = at * 64 + word.trailing_zeros() as usize;
            *word &= *word - 1;
            if *word == 0 {
                self.summary[self.from] &= summary - 1;
            }
            return Some(number);
        }
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chains::random_complexes;
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

    #[test]
    fn the_queue_gives_the_least() {
        let mut queue = SlotQueue::new(10_000);
        [9_999, 0, 4_096, 63, 64].into_iter().for_each(|n| queue.insert(n));
        assert_eq!(queue.pop(), Some(0));
        queue.insert(5);
        assert_eq!(std::iter::from_fn(|| queue.pop()).collect::<Vec<_>>(), [5, 63, 64, 4_096, 9_999]);
    }
}
