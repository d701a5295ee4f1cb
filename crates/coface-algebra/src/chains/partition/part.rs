//! A part of a complex, and its reduction.

use super::keys::Keys;
use crate::chains::flow::inclusions;
use crate::chains::matching::CellClasses;
use crate::chains::{AcyclicMatching, ChainComplex, MorseComplex};
use crate::ids::narrow;
use crate::integers::Integer;
use crate::matrices::{Entry, RaggedArray, SparseMatrix, SparseVector};
use crate::{Error, ErrorKind, progress};
use std::borrow::Cow;
use xxhash_rust::xxh3::xxh3_64_with_seed;

/// The closure of one part of a complex: its cells with their ids and keys.
///
/// With 32-bit incidences it is a piece of a cell complex; with [`Integer`] incidences it is a reduction of pieces, a
/// [`ReducedPart`].
///
/// # Examples
/// A circle of four edges in two parts. Each part has two edges and their three vertices; its reduction leaves the
/// two ends and an edge between them. The merged parts reduce to one vertex and one edge.
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_algebra::chains::{Partition, Parts, ReducedPart, TwoSkeleton};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let circle = TwoSkeleton::new(4, vec![0, 1, 1, 2, 2, 3, 3, 0], RaggedArray::new())?.chain_complex()?;
/// let partition = Partition::new(&circle, 2, |_, edge| u32::from(edge >= 2))?;
/// let parts = [partition.part(0)?.reduced(), partition.part(1)?.reduced()];
/// assert_eq!(parts[0].complex().f_vector(), [2, 1]);
/// let whole = ReducedPart::merged(0, &parts, |_| 0)?.reduced();
/// assert_eq!(whole.complex().f_vector(), [1, 1]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Part<E: Entry = i32> {
    number: u32,
    complex: ChainComplex<E>,
    ids: Vec<Vec<u64>>,
    keys: Keys,
}

/// The reduction of a part or of several: critical cells with their exact boundaries in the Morse complex of the whole.
pub type ReducedPart = Part<Integer>;

/// A stratum that several parts share, and a hash of the pairs and critical cells that the matching has in it.
///
/// Parts of one complex have the same hash. Different hashes show that the parts were made from different complexes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StratumHash {
    pub(super) key: Vec<u32>,
    pub(super) hash: u64,
}

impl StratumHash {
    /// The parts that have the stratum, rising; two at least.
    ///
    /// # Examples
    /// See [`Part::stratum_hashes`].
    pub fn key(&self) -> &[u32] {
        &self.key
    }

    /// The hash of the ids of its pairs and critical cells.
    ///
    /// # Examples
    /// See [`Part::stratum_hashes`].
    pub fn hash(&self) -> u64 {
        self.hash
    }
}

impl<E: Entry> Part<E> {
    /// The part of this number with these cells.
    ///
    /// `ids[k]` are the ids of the cells of degree k, rising; `key_sets` are rising lists of part numbers, and
    /// `keys[k]` says which of them each cell of degree k has.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] where lists are not as long as there are cells; [`ErrorKind::InvalidInput`] for ids that do
    /// not rise, for sets that do not rise or lack the part, and for a face whose key lacks a number that the cell's
    /// has.
    ///
    /// # Complexity
    /// Linear in the boundary matrices.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{ChainComplex, Part};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // One point with the id 40, which part 0 shares with part 1.
    /// let keys = RaggedArray::from_lists([[0, 1]]);
    /// let part = Part::new(0, ChainComplex::of_points(1), vec![vec![40]], &keys, vec![vec![0]])?;
    /// assert_eq!(part.key(0, 0), [0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn new(
        number: u32,
        complex: ChainComplex<E>,
        ids: Vec<Vec<u64>>,
        key_sets: &RaggedArray,
        keys: Vec<Vec<u32>>,
    ) -> Result<Self, Error> {
        let counts = complex.f_vector().iter().copied();
        if !counts.clone().eq(ids.iter().map(Vec::len)) || !counts.eq(keys.iter().map(Vec::len)) {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("part {number} lacks an id or a key of a cell"),
            ));
        }
        for (degree, ids) in ids.iter().enumerate() {
            if let Some(at) = ids.windows(2).position(|pair| pair[0] >= pair[1]) {
                return Err(Error::invalid(format!(
                    "the ids of part {number} in degree {degree} do not rise: {} comes before {}",
                    ids[at],
                    ids[at + 1]
                )));
            }
        }
        for set in key_sets.iter() {
            if !set.is_sorted_by(|a, b| a < b) || set.binary_search(&number).is_err() {
                return Err(Error::invalid(format!(
                    "{set:?} is no key of a cell of part {number}: it must rise and have the number"
                )));
            }
        }
        if keys.iter().flatten().any(|&key| key as usize >= key_sets.len()) {
            return Err(Error::invalid(format!(
                "part {number} has {} keys, and a cell with another",
                key_sets.len()
            )));
        }
        let part = Self { number, complex, ids, keys: Keys::of_sets(key_sets, keys) };
        part.check_keys()?;
        Ok(part)
    }

    /// The part with lists that are known to be valid: only debug builds check them.
    ///
    /// # Errors
    /// None for valid lists.
    #[doc(hidden)]
    pub fn of_trusted_cells(
        number: u32,
        complex: ChainComplex<E>,
        ids: Vec<Vec<u64>>,
        key_sets: &RaggedArray,
        keys: Vec<Vec<u32>>,
    ) -> Result<Self, Error> {
        if cfg!(debug_assertions) {
            return Self::new(number, complex, ids, key_sets, keys);
        }
        Ok(Self { number, complex, ids, keys: Keys::of_sets(key_sets, keys) })
    }

    /// The part with lists that are known to be valid.
    pub(super) fn from_trusted(
        number: u32,
        complex: ChainComplex<E>,
        ids: Vec<Vec<u64>>,
        keys: Keys,
    ) -> Self {
        let part = Self { number, complex, ids, keys };
        debug_assert!(part.check_keys().is_ok(), "faces have the keys of their cells");
        part
    }

    fn check_keys(&self) -> Result<(), Error> {
        for degree in 1..self.complex.degree_count() {
            let Some(matrix) = self.complex.boundary_matrix(degree) else { continue };
            for (cell, column) in matrix.columns().enumerate() {
                let own = self.keys.of_cell[degree][cell];
                for &face in column.rows() {
                    let other = self.keys.of_cell[degree - 1][face as usize];
                    if own != other
                        && !contains(self.keys.sets.list(other as usize), self.keys.sets.list(own as usize))
                    {
                        return Err(Error::invalid(format!(
                            "in part {}, face {} of cell {} of degree {degree} lacks a number of its key",
                            self.number,
                            self.ids[degree - 1][face as usize],
                            self.ids[degree][cell]
                        )));
                    }
                }
            }
        }
        Ok(())
    }

    /// The number of the part.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, Partition, Parts};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(2);
    /// let partition = Partition::new(&points, 2, |_, point| point)?;
    /// assert_eq!(partition.part(1)?.number(), 1);
    /// # Ok(()) }
    /// ```
    pub fn number(&self) -> u32 {
        self.number
    }

    /// The cells and their incidences.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, Partition, Parts};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(3);
    /// let partition = Partition::new(&points, 2, |_, point| u32::from(point > 0))?;
    /// assert_eq!(partition.part(1)?.complex().f_vector(), [2]);
    /// # Ok(()) }
    /// ```
    pub fn complex(&self) -> &ChainComplex<E> {
        &self.complex
    }

    /// The complex alone.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, Partition, Parts};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(3);
    /// let partition = Partition::new(&points, 1, |_, _| 0)?;
    /// assert_eq!(partition.part(0)?.into_complex(), points);
    /// # Ok(()) }
    /// ```
    pub fn into_complex(self) -> ChainComplex<E> {
        self.complex
    }

    /// The ids of the cells of this degree, rising.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, Partition, Parts};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(3);
    /// let partition = Partition::new(&points, 2, |_, point| u32::from(point > 0))?;
    /// assert_eq!(partition.part(1)?.ids(0), [1, 2]);
    /// # Ok(()) }
    /// ```
    pub fn ids(&self, degree: usize) -> &[u64] {
        self.ids.get(degree).map_or(&[], Vec::as_slice)
    }

    /// The key of a cell: the parts that have it, rising.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// The vertex between two edges belongs to the parts of both:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{Partition, Parts, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = TwoSkeleton::new(3, vec![0, 1, 1, 2], RaggedArray::new())?.chain_complex()?;
    /// let part = Partition::new(&path, 2, |_, edge| edge)?.part(0)?;
    /// assert_eq!((part.key(0, 0), part.key(0, 1)), (&[0][..], &[0, 1][..]));
    /// # Ok(()) }
    /// ```
    pub fn key(&self, degree: usize, cell: usize) -> &[u32] {
        self.keys.of(degree, narrow(cell))
    }

    /// The keys that occur, rising, and for each degree which of them each cell has.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{Partition, Parts, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = TwoSkeleton::new(3, vec![0, 1, 1, 2], RaggedArray::new())?.chain_complex()?;
    /// let part = Partition::new(&path, 2, |_, edge| edge)?.part(0)?;
    /// let (sets, of_cell) = part.keys();
    /// assert_eq!(sets, &RaggedArray::from_lists([vec![0], vec![0, 1]]));
    /// assert_eq!(of_cell, [vec![0, 1], vec![0]]);
    /// # Ok(()) }
    /// ```
    pub fn keys(&self) -> (&RaggedArray, &[Vec<u32>]) {
        (&self.keys.sets, &self.keys.of_cell)
    }

    pub(super) fn held_keys(&self) -> &Keys {
        &self.keys
    }

    /// The number of strata of the part.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{Partition, Parts, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = TwoSkeleton::new(3, vec![0, 1, 1, 2], RaggedArray::new())?.chain_complex()?;
    /// // The inside of the part and the vertex that it shares.
    /// assert_eq!(Partition::new(&path, 2, |_, edge| edge)?.part(0)?.stratum_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn stratum_count(&self) -> usize {
        self.keys.sets.len()
    }

    /// The numbers of cells of each degree that the part counts as its own: those of whose key it is the first. Each
    /// cell of the whole is the own cell of exactly one part.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{Partition, Parts, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = TwoSkeleton::new(3, vec![0, 1, 1, 2], RaggedArray::new())?.chain_complex()?;
    /// let partition = Partition::new(&path, 2, |_, edge| edge)?;
    /// // The shared vertex is a cell of part 0, the first part that has it.
    /// assert_eq!(partition.part(0)?.own_counts(), [2, 1]);
    /// assert_eq!(partition.part(1)?.own_counts(), [1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn own_counts(&self) -> Vec<usize> {
        let is_own: Vec<bool> = self.keys.sets.iter().map(|set| set[0] == self.number).collect();
        let own = |keys: &Vec<u32>| keys.iter().filter(|&&key| is_own[key as usize]).count();
        self.keys.of_cell.iter().map(own).collect()
    }

    /// The number of strata that the part counts as its own: those of whose key it is the first. Each stratum of the
    /// whole is the own stratum of exactly one part.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{Partition, Parts, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = TwoSkeleton::new(3, vec![0, 1, 1, 2], RaggedArray::new())?.chain_complex()?;
    /// let partition = Partition::new(&path, 2, |_, edge| edge)?;
    /// assert_eq!([0, 1].map(|part| partition.part(part).map(|part| part.own_stratum_count())), [Ok(2), Ok(1)]);
    /// # Ok(()) }
    /// ```
    pub fn own_stratum_count(&self) -> usize {
        self.keys.sets.iter().filter(|set| set[0] == self.number).count()
    }

    /// Whether an incidence is 1 or -1, so that more pairs can cancel after parts are merged.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{Partition, Parts, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = TwoSkeleton::new(2, vec![0, 1], RaggedArray::new())?.chain_complex()?;
    /// let part = Partition::new(&path, 1, |_, _| 0)?.part(0)?;
    /// assert!(part.has_units() && !part.reduced().has_units());
    /// # Ok(()) }
    /// ```
    pub fn has_units(&self) -> bool {
        self.complex.boundary_matrices().iter().any(|matrix| matrix.entries().iter().any(E::is_unit))
    }

    /// The matching inside the strata.
    ///
    /// # Complexity
    /// As of [`AcyclicMatching::new`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{Partition, Parts, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = TwoSkeleton::new(3, vec![0, 1, 1, 2], RaggedArray::new())?.chain_complex()?;
    /// let part = Partition::new(&path, 2, |_, edge| edge)?.part(0)?;
    /// // The edge cancels with its outer vertex; the shared vertex stays.
    /// assert_eq!(part.matching().critical_cells(0), [1]);
    /// # Ok(()) }
    /// ```
    pub fn matching(&self) -> AcyclicMatching {
        let ranks = self.keys.sizes();
        AcyclicMatching::within(&self.complex, CellClasses { of_cell: &self.keys.of_cell, ranks: &ranks })
    }

    /// The part without the pairs that cancel within its strata: the critical cells that are left.
    ///
    /// # Complexity
    /// As of [`MorseComplex`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{Partition, Parts, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = TwoSkeleton::new(3, vec![0, 1, 1, 2], RaggedArray::new())?.chain_complex()?;
    /// let part = Partition::new(&path, 2, |_, edge| edge)?.part(0)?;
    /// assert_eq!(part.reduced().ids(0), [1]);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn reduced(&self) -> ReducedPart {
        self.reduced_by(self.matching())
    }

    /// As [`Self::reduced`], with the result of [`Self::matching`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, Partition, Parts};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(2);
    /// let part = Partition::new(&points, 1, |_, _| 0)?.part(0)?;
    /// assert_eq!(part.reduced_by(part.matching()), part.reduced());
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn reduced_by(&self, matching: AcyclicMatching) -> ReducedPart {
        let morse = MorseComplex::with_matching(Cow::Borrowed(&self.complex), matching);
        let degrees = 0..self.complex.degree_count();
        let matrices = degrees.skip(1).map(|degree| morse.boundary_matrix(degree)).collect();
        let complex = ChainComplex::from_trusted(morse.critical_count(0), matrices);
        let degrees = 0..complex.degree_count();
        let critical = |degree: usize| morse.matching().critical_cells(degree);
        let ids = degrees
            .clone()
            .map(|degree| critical(degree).iter().map(|&cell| self.ids[degree][cell as usize]).collect());
        let ids = ids.collect();
        let keys = self.keys.renamed(degrees.map(critical), |part| part);
        Part::from_trusted(self.number, complex, ids, keys)
    }

    /// Chains on the critical cells of the matching as chains on the cells of the part; see
    /// [`MorseComplex::inclusion`]. Cells are numbered in the part; the number of a critical cell is its position among
    /// the critical cells of its degree.
    ///
    /// # Panics
    /// If a number is not below the count of critical cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{Partition, Parts, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = TwoSkeleton::new(2, vec![0, 1, 1, 0], RaggedArray::new())?.chain_complex()?;
    /// let part = Partition::new(&circle, 1, |_, _| 0)?.part(0)?;
    /// let cycle = part.inclusions(&part.matching(), 1, [&[(0, 1.into())][..]]);
    /// assert_eq!(cycle[0].len(), 2);
    /// # Ok(()) }
    /// ```
    pub fn inclusions<'c>(
        &self,
        matching: &AcyclicMatching,
        degree: usize,
        chains: impl IntoIterator<Item = &'c [(u32, Integer)]>,
    ) -> Vec<SparseVector> {
        let steps = progress::stage("growing chains of a part", 0);
        inclusions(&self.complex, matching, degree, chains, &steps)
    }

    /// The hashes of the matching in the strata that other parts share.
    ///
    /// # Examples
    /// The vertex between two edges is a stratum of both parts, and both find the same there:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{Partition, Parts, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = TwoSkeleton::new(3, vec![0, 1, 1, 2], RaggedArray::new())?.chain_complex()?;
    /// let partition = Partition::new(&path, 2, |_, edge| edge)?;
    /// let [first, second] = [partition.part(0)?, partition.part(1)?].map(|part| part.stratum_hashes(&part.matching()));
    /// assert_eq!((first.len(), first[0].key(), first[0].hash()), (1, &[0, 1][..], second[0].hash()));
    /// # Ok(()) }
    /// ```
    pub fn stratum_hashes(&self, matching: &AcyclicMatching) -> Vec<StratumHash> {
        let mut hashes = vec![0; self.keys.sets.len()];
        let mut add = |degree: usize, cell: u32, bytes: &[u8]| {
            let hash = &mut hashes[self.keys.of_cell[degree][cell as usize] as usize];
            *hash = xxh3_64_with_seed(bytes, *hash);
        };
        for degree in 0..self.complex.degree_count() {
            for &cell in matching.critical_cells(degree) {
                add(degree, cell, &self.ids[degree][cell as usize].to_le_bytes());
            }
            for pair in matching.pairs(&self.complex, degree) {
                let mut bytes = [0; 16];
                bytes[..8].copy_from_slice(&self.ids[degree - 1][pair.face as usize].to_le_bytes());
                bytes[8..].copy_from_slice(&self.ids[degree][pair.cell as usize].to_le_bytes());
                add(degree, pair.cell, &bytes);
            }
        }
        let strata = self.keys.sets.iter().zip(hashes).filter(|(set, _)| set.len() > 1);
        strata.map(|(set, hash)| StratumHash { key: set.to_vec(), hash }).collect()
    }
}

/// Whether a rising list has all of another.
fn contains(set: &[u32], subset: &[u32]) -> bool {
    let mut rest = set.iter();
    subset.iter().all(|x| rest.any(|y| y == x))
}

impl Part {
    /// The boundary matrices of the closure of some cells, from those of the whole: `cells` rise in each degree, and
    /// `place` has room for the cells of each degree.
    pub(super) fn local_matrix(
        matrix: &SparseMatrix,
        cells: &[u32],
        faces: &[u32],
        place: &mut [u32],
    ) -> Result<SparseMatrix, Error> {
        for (at, &face) in faces.iter().enumerate() {
            place[face as usize] = narrow(at);
        }
        let (mut starts, mut rows, mut entries) = (vec![0], Vec::new(), Vec::new());
        for &cell in cells {
            let column = matrix.column(cell as usize);
            rows.extend(column.rows().iter().map(|&row| place[row as usize]));
            entries.extend_from_slice(column.entries());
            starts.push(narrow(rows.len()));
        }
        SparseMatrix::from_trusted_parts(faces.len(), starts, rows, entries)
    }
}
