//! The gradient flow of an acyclic matching: elimination of matched faces from chains, and the dual sweep on cochains.

use crate::chains::{AcyclicMatching, ChainComplex, MatchedPair};
use crate::ids::narrow;
use crate::integers::Integer;
use crate::matrices::{Entry, SparseMatrix, SparseVector};
use crate::progress::{Steps, stage};

/// The elimination of matched faces from chains of one degree less than that of the pairs.
pub(super) struct Flow<'a, E> {
    matrix: &'a SparseMatrix<E>,
    pairs: &'a [MatchedPair],
    /// For each face its place in `values`: first the matched faces in the order of elimination, then the critical
    /// ones. [`NOWHERE`] for the faces that are themselves cells of pairs one degree below: they cancel there.
    slot_of_face: Vec<u32>,
    slot_count: usize,
    /// The coefficient of each slot; zero between calls.
    values: Vec<i64>,
    /// The matched faces that may have a coefficient; empty between calls.
    waiting: SlotQueue,
    /// Told a 0 now and then, so that a long elimination can be stopped; whoever starts one counts what is done.
    steps: &'a Steps,
}

const NOWHERE: u32 = u32::MAX;

/// The arithmetic of elimination; `None` says that the result does not fit.
trait Number: Clone + Default {
    fn is_zero(&self) -> bool;
    fn from_integer(value: &Integer) -> Option<Self>;
    fn to_integer(&self) -> Integer;
    fn plus_product<E: Entry>(&self, a: &Self, b: &E) -> Option<Self>;
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
    #[inline]
    fn plus_product<E: Entry>(&self, a: &Self, b: &E) -> Option<Self> {
        self.checked_add(a.checked_mul(b.to_i64()?)?)
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
    fn plus_product<E: Entry>(&self, a: &Self, b: &E) -> Option<Self> {
        Some(self + &(a * &b.to_integer()))
    }
}

/// What an elimination starts from.
#[derive(Clone, Copy)]
enum Start<'c> {
    /// The boundary of this chain of cells.
    BoundaryOf(&'c [(u32, Integer)]),
    /// This chain of faces.
    Faces(&'c [(u32, Integer)]),
}

/// What an elimination ends with.
pub(super) struct Eliminated {
    /// The coefficients of critical faces, by their numbers.
    pub(super) on_critical: SparseVector,
    /// The cells that were added, in the order of elimination.
    pub(super) added: SparseVector,
}

impl<'a, E: Entry> Flow<'a, E> {
    /// The flow along the pairs of cells of this degree with their faces, which has a boundary matrix.
    pub(super) fn new(
        complex: &'a ChainComplex<E>,
        matching: &'a AcyclicMatching,
        degree: usize,
        steps: &'a Steps,
    ) -> Self {
        let matrix = complex.boundary_matrix(degree).expect("a flow is of a degree with a boundary matrix");
        let pairs = matching.pairs(complex, degree);
        let mut slot_of_face = vec![NOWHERE; matrix.row_count()];
        let critical = matching.critical_cells(degree - 1);
        for (slot, face) in pairs.iter().map(|pair| pair.face).chain(critical.iter().copied()).enumerate() {
            slot_of_face[face as usize] = narrow(slot);
        }
        let slot_count = pairs.len() + critical.len();
        let waiting = SlotQueue::new(pairs.len());
        Self { matrix, pairs, slot_of_face, slot_count, values: vec![0; slot_count], waiting, steps }
    }

    /// Grows a chain of cells until its boundary has no matched face: that boundary on the numbers of critical faces.
    pub(super) fn boundary(&mut self, chain: &[(u32, Integer)]) -> SparseVector {
        self.run(Start::BoundaryOf(chain), false).on_critical
    }

    /// Grows a chain of cells until its boundary has no matched face, and gives the cells added too.
    pub(super) fn grow(&mut self, chain: &[(u32, Integer)]) -> Eliminated {
        self.run(Start::BoundaryOf(chain), true)
    }

    /// Adds boundaries of cells to a chain of faces until it has no matched face.
    pub(super) fn push(&mut self, faces: &[(u32, Integer)]) -> Eliminated {
        self.run(Start::Faces(faces), true)
    }

    fn run(&mut self, start: Start<'_>, keeps_added: bool) -> Eliminated {
        let mut values = std::mem::take(&mut self.values);
        let mut waiting = std::mem::take(&mut self.waiting);
        waiting.from = 0;
        let narrow = self.eliminate(start, &mut values, &mut waiting, keeps_added);
        if let Some(eliminated) = narrow {
            (self.values, self.waiting) = (values, waiting);
            return eliminated;
        }
        // A coefficient left 64 bits: once more with big integers.
        values.fill(0);
        (self.values, self.waiting) = (values, SlotQueue::new(self.pairs.len()));
        let mut wide = vec![Integer::ZERO; self.slot_count];
        self.eliminate(start, &mut wide, &mut SlotQueue::new(self.pairs.len()), keeps_added)
            .expect("big integers hold every coefficient")
    }

    fn eliminate<N: Number>(
        &self,
        start: Start<'_>,
        values: &mut [N],
        waiting: &mut SlotQueue,
        keeps_added: bool,
    ) -> Option<Eliminated> {
        let mut reached = Vec::new();
        let mut added = SparseVector::new();
        match start {
            Start::BoundaryOf(chain) => {
                for (cell, coefficient) in chain {
                    self.add(*cell, &N::from_integer(coefficient)?, values, waiting, &mut reached)?;
                }
            }
            Start::Faces(chain) => {
                for (face, coefficient) in chain {
                    let coefficient = N::from_integer(coefficient)?;
                    self.add_to_slot(*face as usize, &coefficient, &1, values, waiting, &mut reached)?;
                }
            }
        }
        let mut popped = 0;
        while let Some(slot) = waiting.pop() {
            popped += 1;
            if popped % (1 << 12) == 0 {
                self.steps.advance(0);
            }
            let value = &values[slot];
            if value.is_zero() {
                continue;
            }
            let MatchedPair { face, cell } = self.pairs[slot];
            // The incidence is a unit, its own inverse.
            let minus_incidence = self.matrix.entry(face as usize, cell as usize).negated();
            let coefficient = N::default().plus_product(value, &minus_incidence)?;
            self.add(cell, &coefficient, values, waiting, &mut reached)?;
            if keeps_added {
                added.push((cell, coefficient.to_integer()));
            }
        }
        reached.sort_unstable();
        reached.dedup();
        let on_critical = reached.iter().filter(|&&slot| !values[slot as usize].is_zero());
        let on_critical = on_critical
            .map(|&slot| (slot - narrow(self.pairs.len()), values[slot as usize].to_integer()))
            .collect();
        for &slot in &reached {
            values[slot as usize] = N::default();
        }
        Some(Eliminated { on_critical, added })
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
        for (face, incidence) in self.matrix.column(cell as usize).terms() {
            self.add_to_slot(face, coefficient, incidence, values, waiting, reached)?;
        }
        Some(())
    }

    #[inline]
    fn add_to_slot<N: Number>(
        &self,
        face: usize,
        coefficient: &N,
        incidence: &impl Entry,
        values: &mut [N],
        waiting: &mut SlotQueue,
        reached: &mut Vec<u32>,
    ) -> Option<()> {
        let slot = self.slot_of_face[face];
        if slot == NOWHERE {
            return Some(());
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
        Some(())
    }
}

/// The images of chains on the numbers of critical cells under the inclusion in the complex, by rising cells; each is a
/// step.
pub(super) fn inclusions<'c, E: Entry>(
    complex: &ChainComplex<E>,
    matching: &AcyclicMatching,
    degree: usize,
    chains: impl IntoIterator<Item = &'c [(u32, Integer)]>,
    steps: &Steps,
) -> Vec<SparseVector> {
    let cells = matching.critical_cells(degree);
    let mut flow = (degree > 0 && !cells.is_empty()).then(|| Flow::new(complex, matching, degree, steps));
    let image = |chain: &[(u32, Integer)]| {
        let mut image: SparseVector = chain.iter().map(|(i, x)| (cells[*i as usize], x.clone())).collect();
        if let Some(flow) = &mut flow
            && !image.is_empty()
        {
            let added = flow.grow(&image).added;
            image.extend(added);
        }
        image.sort_unstable_by_key(|&(cell, _)| cell);
        steps.advance(1);
        image
    };
    chains.into_iter().map(image).collect()
}

/// The dual of elimination, for many cochains at once: each cell of degree k - 1 gets the list of (number of the
/// cochain, value). Given are the values on unmatched faces and a source on cells of degree k.
///
/// For a pair of a face a and a cell b with incidence e the value is
/// $w(a) = e \, (s(b) - \sum_{a' \ne a} [b : a'] \, w(a'))$, taken from the last pair to the first: the other matched
/// faces of b belong to later pairs.
pub(super) struct Sweep {
    /// For each face where its list is in the arena.
    spans: Vec<(u32, u32)>,
    arena: SparseVector,
}

impl Sweep {
    /// With the lists of these faces given, all others empty.
    pub(super) fn new(face_count: usize, given: impl IntoIterator<Item = (u32, SparseVector)>) -> Self {
        let mut sweep = Self { spans: vec![(0, 0); face_count], arena: Vec::new() };
        for (face, list) in given {
            sweep.store(face, list);
        }
        sweep
    }

    fn store(&mut self, face: u32, list: SparseVector) {
        let start = narrow(self.arena.len());
        self.arena.extend(list);
        self.spans[face as usize] = (start, narrow(self.arena.len()));
    }

    pub(super) fn list(&self, face: usize) -> &[(u32, Integer)] {
        let (start, end) = self.spans[face];
        &self.arena[start as usize..end as usize]
    }

    /// Goes through the pairs of this degree, with the source on its cells.
    pub(super) fn run<E: Entry>(
        &mut self,
        complex: &ChainComplex<E>,
        matching: &AcyclicMatching,
        degree: usize,
        source: Option<&Sweep>,
    ) {
        let Some(matrix) = complex.boundary_matrix(degree) else { return };
        let minus_one = Integer::from(-1);
        let pairs = matching.pairs(complex, degree);
        let steps = stage("carrying cochains", pairs.len());
        for &MatchedPair { face, cell } in steps.each(pairs.iter().rev()) {
            let column = matrix.column(cell as usize);
            let from_source = source.map_or(&[][..], |source| source.list(cell as usize));
            let is_bare = column.rows().iter().all(|&other| {
                let (start, end) = self.spans[other as usize];
                start == end || other == face
            });
            if is_bare && from_source.is_empty() {
                continue;
            }
            let incidence = column.entry(face as usize).to_integer();
            let mut total: SparseVector = from_source.to_vec();
            for (other, entry) in column.terms().filter(|&(other, _)| other != face as usize) {
                let list = self.list(other);
                if !list.is_empty() {
                    let factor = &minus_one * &entry.to_integer();
                    total = crate::matrices::combination(&Integer::ONE, &total, &factor, list);
                }
            }
            for (_, value) in &mut total {
                *value = &*value * &incidence;
            }
            self.store(face, total);
        }
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

    #[test]
    fn the_queue_gives_the_least() {
        let mut queue = SlotQueue::new(10_000);
        [9_999, 0, 4_096, 63, 64].into_iter().for_each(|n| queue.insert(n));
        assert_eq!(queue.pop(), Some(0));
        queue.insert(5);
        assert_eq!(std::iter::from_fn(|| queue.pop()).collect::<Vec<_>>(), [5, 63, 64, 4_096, 9_999]);
    }
}
