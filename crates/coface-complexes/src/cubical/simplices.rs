//! The voxels of blocks cut into simplices.

use super::boxes::{VoxelBox, VoxelBoxes};
use super::places::BlockPlaces;
use super::volume::CubicalVolume;
use super::voxels::{Voxels, check_shape};
use coface_algebra::SparseMatrix;
use coface_algebra::chains::{ChainComplex, Part, Parts};
use coface_algebra::{Error, ErrorKind};

/// A volume whose voxels are cut into simplices without new vertices, and cut into boxes of nearly equal size: the parts of a simplicial
/// complex.
///
/// A voxel of d axes is cut into the d! simplices that walk from its lowest to its highest vertex along its axes in some order (the Kuhn
/// or Freudenthal triangulation), so that neighbors are cut alike on their common face. A k-simplex goes from a corner along a rising chain of k
/// sets of axes; its carrier is the cubical cell of that corner that extends along the last set. On a periodic axis of one or two voxels
/// simplices may have a vertex twice, or the same vertices as another: the cells are then those of a Delta-complex.
///
/// The id of a simplex is the place of its carrier times [`Self::kind_count`] plus a number of its chain of sets. Signs are those of the
/// vertices in their order along the chain.
///
/// # References
/// H. W. Kuhn, *Some combinatorial lemmas in topology* (1960).
///
/// # Examples
/// A torus of 8 x 8 x 8 voxels, 26 simplices each:
/// ```
/// use coface_complexes::cubical::{FullVoxels, SimplicialBlocks};
/// use coface_algebra::chains::{PartTree, Parts};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = FullVoxels::new(&[8, 8, 8], &[true; 3])?;
/// let whole = SimplicialBlocks::new(&torus, &[1, 1, 1])?;
/// assert_eq!(whole.part(0)?.complex().f_vector(), [512, 7 * 512, 12 * 512, 6 * 512]);
/// let blocks = SimplicialBlocks::new(&torus, &[2, 2, 2])?;
/// assert_eq!(PartTree::new(&blocks, 8)?.root().complex().f_vector(), [1, 3, 3, 1]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct SimplicialBlocks<'v, V: ?Sized = CubicalVolume> {
    volume: &'v V,
    boxes: VoxelBoxes,
}

impl<'v, V: Voxels + ?Sized> SimplicialBlocks<'v, V> {
    /// So many blocks along each axis.
    ///
    /// # Errors
    /// As [`VoxelBoxes::new`]; [`ErrorKind::TooLarge`] where ids of simplices do not fit in 64 bits.
    pub fn new(volume: &'v V, counts: &[u32]) -> Result<Self, Error> {
        Self::of(volume, VoxelBoxes::new(volume.shape(), volume.is_periodic(), counts)?)
    }

    /// Blocks in all at least `part_count`, as far as there are voxels, by halving the longest side over and over.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn at_least(volume: &'v V, part_count: u32) -> Result<Self, Error> {
        Self::of(volume, VoxelBoxes::at_least(volume.shape(), volume.is_periodic(), part_count)?)
    }

    fn of(volume: &'v V, boxes: VoxelBoxes) -> Result<Self, Error> {
        check_shape(volume.shape(), volume.is_periodic())?;
        let places = volume.shape().iter().map(|&length| 2 * u64::from(length) + 1).product::<u64>();
        if places.checked_mul(Self::kind_count(volume.shape().len())).is_none() {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("simplices of a volume of shape {:?} have no 64-bit ids", volume.shape()),
            ));
        }
        Ok(Self { volume, boxes })
    }

    /// The most simplices that a carrier has in volumes of so many axes, of all dimensions together: 1, 3, 13, 75 for 1, 2, 3, 4 axes.
    pub fn kind_count(axis_count: usize) -> u64 {
        // Ordered partitions of a set: the first set of n elements, then those of the rest.
        let mut counts = vec![1u64];
        for n in 1..=axis_count {
            let mut binomial = 1;
            let mut total = 0;
            for first in 1..=n {
                binomial = binomial * (n + 1 - first) as u64 / first as u64;
                total += binomial * counts[n - first];
            }
            counts.push(total);
        }
        counts[axis_count]
    }

    /// The volume.
    pub fn volume(&self) -> &'v V {
        self.volume
    }

    /// The number of blocks along each axis.
    pub fn counts(&self) -> &[u32] {
        self.boxes.counts()
    }

    /// The boxes of voxels.
    pub fn boxes(&self) -> &VoxelBoxes {
        &self.boxes
    }

    /// The voxels of a block.
    ///
    /// # Panics
    /// If there is no such block.
    pub fn voxels(&self, number: u32) -> VoxelBox {
        self.boxes.voxels(number)
    }

    /// The part of a block.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] where it has 2^32 simplices or entries of one dimension; what [`Voxels::window`] says.
    ///
    /// # Complexity
    /// Linear in the places of cells of the block and in its simplices.
    ///
    /// # Panics
    /// If there is no such block.
    pub fn block(&self, number: u32) -> Result<Part, Error> {
        let window = self.volume.window(&self.boxes.voxels(number))?;
        let places = BlockPlaces::new(&self.boxes, &window, number)?;
        let axis_count = places.axes.len();
        let kinds = Kinds::new(axis_count);
        // Counted first, so that nothing is made that does not fit.
        let mut carriers = vec![0u64; axis_count + 1];
        places.for_each_cell(|cell| carriers[cell.dimension] += 1);
        for degree in 0..=axis_count {
            let simplices = (degree..=axis_count).map(|d| carriers[d] * kinds.count(d, degree) as u64);
            let count = simplices.fold(0, u64::saturating_add).saturating_mul(degree as u64 + 1);
            if u32::try_from(count).is_err() {
                return Err(Error::new(
                    ErrorKind::TooLarge,
                    format!("block {number} has {count} incidences of simplices of dimension {degree}"),
                )
                .with_cure("cut the volume into more blocks"));
            }
        }
        let multiplier = Self::kind_count(axis_count);
        let mut first_of_place = vec![NONE; places.count];
        let mut firsts = Vec::new();
        let mut ids = vec![Vec::new(); axis_count + 1];
        let mut keys = vec![Vec::new(); axis_count + 1];
        let sets = places.for_each_cell(|cell| {
            first_of_place[cell.place] = (firsts.len() / (axis_count + 1)) as u32;
            firsts.extend(ids.iter().map(|ids: &Vec<u64>| ids.len() as u32));
            let mut id = cell.id * multiplier;
            for degree in 0..=cell.dimension {
                let count = kinds.count(cell.dimension, degree);
                ids[degree].extend((0..count as u64).map(|kind| id + kind));
                keys[degree].extend(std::iter::repeat_n(cell.key, count));
                id += count as u64;
            }
        });
        let carriers = Carriers { places: &places, first_of_place, firsts };
        let counts: Vec<usize> = ids.iter().map(Vec::len).collect();
        let complex = ChainComplex::from_trusted_boundaries(carriers.boundaries(&kinds, &counts)?);
        Part::of_trusted_cells(number, complex, ids, &sets, keys)
    }
}

impl<V: Voxels + ?Sized> Parts for SimplicialBlocks<'_, V> {
    fn part_count(&self) -> u32 {
        self.boxes.count()
    }

    fn part(&self, number: u32) -> Result<Part, Error> {
        self.block(number)
    }
}

/// The number of no cell.
const NONE: u32 = u32::MAX;

/// The simplices of carriers, which are the same for all of one dimension.
struct Kinds {
    /// `of[d][k]` are the k-simplices of a carrier of dimension d.
    of: Vec<Vec<Vec<Kind>>>,
}

/// A simplex of a carrier by its faces, of alternating signs, the first one positive.
struct Kind {
    faces: Vec<Face>,
}

/// A face of a simplex: the axes of the carrier, as bits by their ranks, along which its own carrier is the upper or lower face, and its
/// number among the simplices of its degree of that carrier.
struct Face {
    upper: u8,
    lower: u8,
    number: u32,
}

impl Kinds {
    fn new(axis_count: usize) -> Self {
        // Chains of sets that rise strictly from the empty set, which is left out, to all axes: by degree, lexicographically.
        let chains: Vec<Vec<Vec<Vec<u8>>>> = (0..=axis_count)
            .map(|dimension| {
                let mut chains = vec![Vec::new(); axis_count + 1];
                let full = ((1u32 << dimension) - 1) as u8;
                rising_chains(full, &mut Vec::new(), &mut |chain| chains[chain.len()].push(chain.to_vec()));
                chains
            })
            .collect();
        let kind = |dimension: usize, chain: &[u8]| {
            let full = chain.last().copied().unwrap_or(0);
            let degree = chain.len();
            let faces = (0..=degree).filter(|_| degree > 0).map(|left_out| {
                let (mut upper, mut lower) = (0, 0);
                let mut face: Vec<u8> = chain.to_vec();
                if left_out == 0 {
                    upper = face.remove(0);
                    face.iter_mut().for_each(|set| *set &= !upper);
                } else {
                    face.remove(left_out - 1);
                    lower = full & !face.last().copied().unwrap_or(0);
                    if left_out < degree {
                        lower = 0;
                    }
                }
                let rest = full & !(upper | lower);
                face.iter_mut().for_each(|set| *set = gathered(*set, rest));
                let dimension = dimension - (upper | lower).count_ones() as usize;
                let number = chains[dimension][face.len()]
                    .binary_search(&face)
                    .expect("a face of a chain of sets is one") as u32;
                Face { upper, lower, number }
            });
            Kind { faces: faces.collect() }
        };
        let of = chains.iter().enumerate().map(|(dimension, by_degree)| {
            by_degree
                .iter()
                .map(|chains| chains.iter().map(|chain| kind(dimension, chain)).collect())
                .collect()
        });
        Self { of: of.collect() }
    }

    /// How many k-simplices a carrier of this dimension has.
    fn count(&self, dimension: usize, degree: usize) -> usize {
        self.of[dimension][degree].len()
    }
}

/// Calls with the chains of sets that rise strictly and end with `full`, lexicographically; the empty chain for the empty set.
fn rising_chains(full: u8, chain: &mut Vec<u8>, visit: &mut dyn FnMut(&[u8])) {
    let last = chain.last().copied().unwrap_or(0);
    if last == full {
        return visit(chain);
    }
    for set in 1..=full {
        if set & last == last && set != last && set & !full == 0 {
            chain.push(set);
            rising_chains(full, chain, visit);
            chain.pop();
        }
    }
}

/// The bits of a set at the places of another, moved together.
fn gathered(set: u8, places: u8) -> u8 {
    let places = (0..8).filter(|i| places >> i & 1 == 1);
    places.enumerate().map(|(rank, i)| (set >> i & 1) << rank).sum()
}

/// The cells of a block as carriers of simplices.
struct Carriers<'p> {
    places: &'p BlockPlaces<'p>,
    /// The number of the cell at each place.
    first_of_place: Vec<u32>,
    /// For each cell the number of its first simplex of each degree.
    firsts: Vec<u32>,
}

impl Carriers<'_> {
    fn boundaries(&self, kinds: &Kinds, counts: &[usize]) -> Result<Vec<SparseMatrix>, Error> {
        let axis_count = self.places.axes.len();
        let with_room = Vec::<u32>::with_capacity;
        let mut starts: Vec<Vec<u32>> = counts.iter().map(|&count| with_room(count + 1)).collect();
        starts.iter_mut().for_each(|starts| starts.push(0));
        let mut rows: Vec<Vec<u32>> =
            counts.iter().enumerate().map(|(degree, &count)| with_room((degree + 1) * count)).collect();
        let mut entries: Vec<Vec<i32>> =
            rows.iter().map(|rows| Vec::with_capacity(rows.capacity())).collect();
        let mut faces: Vec<(u32, i32)> = Vec::with_capacity(axis_count + 1);
        let mut steps: Vec<[isize; 2]> = Vec::with_capacity(axis_count);

        let (last, outer) = self.places.axes.split_last().expect("a volume has an axis");
        self.places.for_each_row(|first, at, _, _| {
            for along in 0..last.places.len() {
                let own = first + along;
                if self.first_of_place[own] == NONE {
                    continue;
                }
                steps.clear();
                let axes = outer.iter().zip(at.iter().copied()).chain([(last, along)]);
                steps.extend(
                    axes.filter(|(axis, at)| axis.places[*at] % 2 == 1).map(|(axis, at)| axis.face_steps(at)),
                );
                for (degree, kinds) in kinds.of[steps.len()].iter().enumerate().skip(1) {
                    for kind in kinds {
                        faces.clear();
                        for (i, face) in kind.faces.iter().enumerate() {
                            let step: isize = steps
                                .iter()
                                .enumerate()
                                .map(|(rank, [low, high])| {
                                    high * (face.upper >> rank & 1) as isize
                                        + low * (face.lower >> rank & 1) as isize
                                })
                                .sum();
                            let carrier = self.first_of_place[own.wrapping_add_signed(step)] as usize;
                            let number = self.firsts[carrier * (axis_count + 1) + degree - 1] + face.number;
                            faces.push((number, if i % 2 == 0 { 1 } else { -1 }));
                        }
                        faces.sort_unstable();
                        for group in faces.chunk_by(|a, b| a.0 == b.0) {
                            let sum = group.iter().map(|&(_, sign)| sign).sum();
                            if sum != 0 {
                                rows[degree].push(group[0].0);
                                entries[degree].push(sum);
                            }
                        }
                        starts[degree].push(rows[degree].len() as u32);
                    }
                }
            }
        });
        let columns = starts.into_iter().zip(rows).zip(entries).enumerate().skip(1);
        let matrices = columns.map(|(degree, ((starts, rows), entries))| {
            SparseMatrix::from_trusted_parts(counts[degree - 1], starts, rows, entries)
        });
        matrices.collect()
    }
}
