//! The cubical complexes of blocks.

use super::boxes::{VoxelBox, VoxelBoxes};
use super::places::BlockPlaces;
use super::volume::CubicalVolume;
use super::voxels::Voxels;
use coface_algebra::Error;
use coface_algebra::SparseMatrix;
use coface_algebra::chains::{ChainComplex, Part, Parts};

/// A volume cut into boxes of nearly equal size, the parts of its cubical complex.
///
/// Block numbers run like places, the last axis fastest. A part is made when it is asked for, of the voxels of its box and one layer around
/// it.
///
/// # Examples
/// A torus of 8 x 8 x 8 voxels in 8 blocks: one cell is left of each stratum, and 8 of the whole.
/// ```
/// use coface_complexes::cubical::{CubicalBlocks, CubicalVolume};
/// use coface_algebra::chains::PartTree;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = CubicalVolume::full(&[8, 8, 8], &[true; 3])?;
/// let blocks = CubicalBlocks::new(&torus, &[2, 2, 2])?;
/// let tree = PartTree::new(&blocks, 8)?;
/// assert_eq!(tree.root().complex().f_vector(), [1, 3, 3, 1]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct CubicalBlocks<'v, V: ?Sized = CubicalVolume> {
    volume: &'v V,
    boxes: VoxelBoxes,
}

/// The number of no cell.
const NONE: u32 = u32::MAX;

impl<'v, V: Voxels + ?Sized> CubicalBlocks<'v, V> {
    /// So many blocks along each axis.
    ///
    /// # Errors
    /// As [`VoxelBoxes::new`].
    pub fn new(volume: &'v V, counts: &[u32]) -> Result<Self, Error> {
        let boxes = VoxelBoxes::new(volume.shape(), volume.is_periodic(), counts)?;
        Ok(Self { volume, boxes })
    }

    /// Blocks in all at least `part_count`, as far as there are voxels, by halving the longest side over and over.
    ///
    /// # Errors
    /// As [`VoxelBoxes::at_least`].
    pub fn at_least(volume: &'v V, part_count: u32) -> Result<Self, Error> {
        let boxes = VoxelBoxes::at_least(volume.shape(), volume.is_periodic(), part_count)?;
        Ok(Self { volume, boxes })
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

    /// The ids of the cells of a block, by dimension, rising.
    pub(super) fn cell_ids(&self, number: u32) -> Result<Vec<Vec<u64>>, Error> {
        let window = self.volume.window(&self.boxes.voxels(number))?;
        let places = BlockPlaces::new(&self.boxes, &window, number)?;
        let mut ids = vec![Vec::new(); places.axes.len() + 1];
        places.for_each_cell(|cell| ids[cell.dimension].push(cell.id));
        Ok(ids)
    }

    /// The part of a block.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) where it has 2^32 cells or entries of one dimension; what [`Voxels::window`]
    /// says.
    ///
    /// # Complexity
    /// Linear in the places of cells of the block.
    ///
    /// # Panics
    /// If there is no such block.
    pub fn block(&self, number: u32) -> Result<Part, Error> {
        let window = self.volume.window(&self.boxes.voxels(number))?;
        let places = BlockPlaces::new(&self.boxes, &window, number)?;
        let degree_count = places.axes.len() + 1;
        let mut number_of_place = vec![NONE; places.count];
        let mut ids = vec![Vec::new(); degree_count];
        let mut keys = vec![Vec::new(); degree_count];
        let sets = places.for_each_cell(|cell| {
            let ids = &mut ids[cell.dimension];
            number_of_place[cell.place] = ids.len() as u32;
            ids.push(cell.id);
            keys[cell.dimension].push(cell.key);
        });
        let counts: Vec<usize> = ids.iter().map(Vec::len).collect();
        let complex = ChainComplex::from_trusted_boundaries(boundaries(&places, &number_of_place, &counts)?);
        Part::of_trusted_cells(number, complex, ids, &sets, keys)
    }
}

impl<V: Voxels + ?Sized> Parts for CubicalBlocks<'_, V> {
    fn part_count(&self) -> u32 {
        self.boxes.count()
    }

    fn part(&self, number: u32) -> Result<Part, Error> {
        self.block(number)
    }
}

/// The boundary matrices of the cells at these places, numbered within their dimensions.
fn boundaries(
    places: &BlockPlaces<'_>,
    number_of_place: &[u32],
    counts: &[usize],
) -> Result<Vec<SparseMatrix>, Error> {
    let mut starts: Vec<Vec<u32>> = counts
        .iter()
        .map(|&count| {
            let mut starts = Vec::with_capacity(count + 1);
            starts.push(0);
            starts
        })
        .collect();
    let mut rows: Vec<Vec<u32>> = counts
        .iter()
        .enumerate()
        .map(|(dimension, &count)| Vec::with_capacity(2 * dimension * count))
        .collect();
    let mut entries: Vec<Vec<i32>> = rows.iter().map(|rows| Vec::with_capacity(rows.capacity())).collect();
    let mut sorted: Vec<(u32, i32)> = Vec::with_capacity(2 * places.axes.len());
    let (last, outer) = places.axes.split_last().expect("a volume has an axis");
    places.for_each_row(|first, at, _, outer_dimension| {
        let outer_steps = || outer.iter().zip(at).filter(|(axis, at)| axis.places[**at] % 2 == 1);
        let outer_steps = || outer_steps().map(|(axis, &at)| axis.face_steps(at));
        let at_corner = Faces::new(outer_steps());
        let inside = Faces::new(outer_steps().chain([[-1, 1]]));
        for (along, place) in last.places.iter().enumerate() {
            let own = first + along;
            if number_of_place[own] == NONE {
                continue;
            }
            let is_odd = place % 2 == 1;
            let dimension = outer_dimension + usize::from(is_odd);
            let around_end;
            let faces = match last.face_steps(along) {
                _ if !is_odd => &at_corner,
                [_, 1] => &inside,
                steps => {
                    around_end = Faces::new(outer_steps().chain([steps]));
                    &around_end
                }
            };
            let (rows, entries) = (&mut rows[dimension], &mut entries[dimension]);
            let number = |step: isize| number_of_place[own.wrapping_add_signed(step)];
            if faces.rise {
                rows.extend(faces.steps.iter().map(|&(step, _)| number(step)));
                entries.extend(faces.steps.iter().map(|&(_, sign)| sign));
            } else {
                sorted.clear();
                sorted.extend(faces.steps.iter().map(|&(step, sign)| (number(step), sign)));
                sorted.sort_unstable();
                rows.extend(sorted.iter().map(|&(row, _)| row));
                entries.extend(sorted.iter().map(|&(_, sign)| sign));
            }
            starts[dimension].push(rows.len() as u32);
        }
    });
    let matrices = (1..counts.len()).map(|dimension| {
        let (starts, rows, entries) = (
            std::mem::take(&mut starts[dimension]),
            std::mem::take(&mut rows[dimension]),
            std::mem::take(&mut entries[dimension]),
        );
        SparseMatrix::from_trusted_parts(counts[dimension - 1], starts, rows, entries)
    });
    matrices.collect()
}

/// The steps from the place of a cell to those of its faces, with their signs.
struct Faces {
    steps: Vec<(isize, i32)>,
    /// Whether the steps rise, and so the numbers of the faces: all but around the end of an axis.
    rise: bool,
}

impl Faces {
    /// Those of a cell with these steps along its axes, the lower and the upper.
    fn new(steps: impl Iterator<Item = [isize; 2]>) -> Self {
        let (mut lower, mut upper) = (Vec::new(), Vec::new());
        for (rank, [low, high]) in steps.enumerate() {
            let sign = if rank % 2 == 0 { 1 } else { -1 };
            // An axis of one voxel that is periodic: both faces are one, and cancel.
            if low == high {
                continue;
            }
            lower.push((low, -sign));
            upper.push((high, sign));
        }
        upper.reverse();
        lower.append(&mut upper);
        let rise = lower.is_sorted_by(|a, b| a.0 < b.0);
        Self { steps: lower, rise }
    }
}
