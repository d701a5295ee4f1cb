//! Volumes cut into blocks.

use super::volume::{CubicalVolume, VoxelBox};
use crate::algebra::{RaggedArray, SparseMatrix};
use crate::chains::{ChainComplex, Part, Parts};
use crate::{Error, ErrorKind};
use std::collections::BTreeMap;

/// A volume cut into boxes of nearly equal size, the parts of its cubical complex.
///
/// Block numbers run like places, the last axis fastest. A part is made when it is asked for.
///
/// # Examples
/// A torus of 8 x 8 x 8 voxels in 8 blocks: one cell is left of each stratum, and 8 of the whole.
/// ```
/// use coface::cellular::{CubicalBlocks, CubicalVolume};
/// use coface::chains::PartTree;
/// # fn main() -> Result<(), coface::Error> {
/// let torus = CubicalVolume::full(&[8, 8, 8], &[true; 3])?;
/// let blocks = CubicalBlocks::new(&torus, &[2, 2, 2])?;
/// let tree = PartTree::new(&blocks, 8)?;
/// assert_eq!(tree.root().complex().f_vector(), [1, 3, 3, 1]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct CubicalBlocks<'v> {
    volume: &'v CubicalVolume,
    counts: Vec<u32>,
}

/// How many voxels are around a cell at most.
const MOST_AROUND: usize = 1 << CubicalVolume::MOST_AXES;
/// The number of no cell.
const NONE: u32 = u32::MAX;

impl<'v> CubicalBlocks<'v> {
    /// So many blocks along each axis.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] unless there is a count for each axis, from 1 to its voxels; [`ErrorKind::TooLarge`] beyond 2^32 blocks.
    pub fn new(volume: &'v CubicalVolume, counts: &[u32]) -> Result<Self, Error> {
        let fits = counts.len() == volume.shape().len()
            && counts.iter().zip(volume.shape()).all(|(count, length)| (1..=*length).contains(count));
        if !fits {
            return Err(Error::invalid(format!(
                "a volume of shape {:?} cannot be cut into {counts:?} blocks",
                volume.shape()
            ))
            .with_cure("give a count for each axis, from 1 to the number of its voxels"));
        }
        if counts.iter().try_fold(1u32, |total, &count| total.checked_mul(count)).is_none() {
            return Err(Error::new(ErrorKind::TooLarge, format!("{counts:?} are more than 2^32 blocks")));
        }
        Ok(Self { volume, counts: counts.to_vec() })
    }

    /// Blocks in all at least `part_count`, as far as there are voxels, by halving the longest side over and over.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn at_least(volume: &'v CubicalVolume, part_count: u32) -> Result<Self, Error> {
        let mut counts = vec![1u32; volume.shape().len()];
        while counts.iter().map(|&count| u64::from(count)).product::<u64>() < u64::from(part_count) {
            let side = |axis: &usize| volume.shape()[*axis] / counts[*axis];
            match (0..counts.len()).max_by_key(side) {
                Some(axis) if side(&axis) > 1 => counts[axis] *= 2,
                _ => break,
            }
        }
        Self::new(volume, &counts)
    }

    /// The volume.
    pub fn volume(&self) -> &'v CubicalVolume {
        self.volume
    }

    /// The number of blocks along each axis.
    pub fn counts(&self) -> &[u32] {
        &self.counts
    }

    /// The voxels of a block.
    ///
    /// # Panics
    /// If there is no such block.
    pub fn voxels(&self, number: u32) -> VoxelBox {
        assert!(number < self.part_count(), "there is no block {number}");
        let mut rest = number;
        let mut voxels = VoxelBox { start: vec![0; self.counts.len()], end: vec![0; self.counts.len()] };
        for axis in (0..self.counts.len()).rev() {
            let (count, length) = (self.counts[axis], self.volume.shape()[axis]);
            let at = rest % count;
            rest /= count;
            voxels.start[axis] = first_voxel(at, count, length);
            voxels.end[axis] = first_voxel(at + 1, count, length);
        }
        voxels
    }

    /// The part of a block.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] where it has 2^32 cells or entries of one dimension.
    ///
    /// # Complexity
    /// Linear in the places of cells of the block.
    ///
    /// # Panics
    /// If there is no such block.
    pub fn block(&self, number: u32) -> Result<Part, Error> {
        BlockCells::new(self, number)?.into_part()
    }
}

impl Parts for CubicalBlocks<'_> {
    fn part_count(&self) -> u32 {
        self.counts.iter().product()
    }

    fn part(&self, number: u32) -> Result<Part, Error> {
        self.block(number)
    }
}

/// Where block `at` of `count` begins along an axis.
fn first_voxel(at: u32, count: u32, length: u32) -> u32 {
    (u64::from(at) * u64::from(length) / u64::from(count)) as u32
}

/// One axis, as a block sees it.
struct Axis {
    /// The places of its cells along the axis, rising.
    places: Vec<u64>,
    /// For each of them the voxels that are around it and the numbers of their blocks along the axis: one or two.
    around: Vec<Vec<(u32, u32)>>,
    /// For each odd place where its faces are among `places`; the same twice where the axis is one voxel long and periodic.
    faces: Vec<[u32; 2]>,
    /// How many places the whole axis has.
    length: u64,
}

impl Axis {
    fn new(blocks: &CubicalBlocks<'_>, voxels: &VoxelBox, axis: usize) -> Self {
        let (count, voxel_count) = (blocks.counts[axis], blocks.volume.shape()[axis]);
        let is_periodic = blocks.volume.is_periodic()[axis];
        let length = 2 * u64::from(voxel_count) + u64::from(!is_periodic);
        let mut places: Vec<u64> = (2 * u64::from(voxels.start[axis])..=2 * u64::from(voxels.end[axis]))
            .map(|place| place % length)
            .collect();
        places.sort_unstable();
        places.dedup();
        // Block b ends where block b + 1 begins, so the block of voxel v is the last that begins at v or before.
        let block_of = |voxel: u32| {
            let guess = (u64::from(voxel) * u64::from(count) / u64::from(voxel_count)) as u32;
            let up = guess + 1 < count && first_voxel(guess + 1, count, voxel_count) <= voxel;
            guess + u32::from(up)
        };
        let around = places.iter().map(|&place| {
            let mut voxels = Vec::with_capacity(2);
            let at = (place / 2) as u32;
            if place % 2 == 0 {
                if at > 0 {
                    voxels.push(at - 1);
                } else if is_periodic {
                    voxels.push(voxel_count - 1);
                }
                if at < voxel_count && !voxels.contains(&at) {
                    voxels.push(at);
                }
            } else {
                voxels.push(at);
            }
            voxels.into_iter().map(|voxel| (voxel, block_of(voxel))).collect()
        });
        let around = around.collect();
        let faces = places.iter().map(|&place| {
            let position = |place: u64| places.binary_search(&place).map_or(NONE, |at| at as u32);
            [position((place + length - 1) % length), position((place + 1) % length)]
        });
        let faces = faces.collect();
        Self { places, around, faces, length }
    }
}

/// The cells of a block, before they are a part.
struct BlockCells {
    number: u32,
    axes: Vec<Axis>,
    /// For each place of the block the number of the cell among those of its dimension.
    number_of_place: Vec<u32>,
    ids: Vec<Vec<u64>>,
    keys: Vec<Vec<u32>>,
    sets: RaggedArray,
}

/// Goes through the places of a box, the last axis fastest.
fn for_each_place(axes: &[Axis], mut visit: impl FnMut(usize, &[usize])) {
    let mut at = vec![0; axes.len()];
    let count = axes.iter().map(|axis| axis.places.len()).product();
    for place in 0..count {
        visit(place, &at);
        for axis in (0..axes.len()).rev() {
            at[axis] += 1;
            if at[axis] < axes[axis].places.len() {
                break;
            }
            at[axis] = 0;
        }
    }
}

impl BlockCells {
    fn new(blocks: &CubicalBlocks<'_>, number: u32) -> Result<Self, Error> {
        let voxels = blocks.voxels(number);
        let axes: Vec<Axis> = (0..blocks.counts.len()).map(|axis| Axis::new(blocks, &voxels, axis)).collect();
        let place_count = axes.iter().try_fold(1usize, |count, axis| count.checked_mul(axis.places.len()));
        let Some(place_count) = place_count.filter(|&count| u32::try_from(count).is_ok()) else {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("block {number} has more than 2^32 places of cells"),
            )
            .with_cure("cut the volume into more blocks"));
        };
        let mut sets = RaggedArray::from_lists([[number]]);
        let mut number_of_set = BTreeMap::from([(vec![number], 0u32)]);
        let mut number_of_place = vec![NONE; place_count];
        let mut ids = vec![Vec::new(); axes.len() + 1];
        let mut keys = vec![Vec::new(); axes.len() + 1];
        let mut around = Vec::with_capacity(MOST_AROUND);
        for_each_place(&axes, |place, at| {
            // The blocks of the voxels around that are set, this one first found.
            around.clear();
            blocks_around(blocks, &axes, at, &mut around);
            around.sort_unstable();
            around.dedup();
            if around.binary_search(&number).is_err() {
                return;
            }
            let key = if around.len() == 1 {
                0
            } else if let Some(&key) = number_of_set.get(&around[..]) {
                key
            } else {
                let key = sets.len() as u32;
                sets.push(&around);
                number_of_set.insert(around.clone(), key);
                key
            };
            let (mut id, mut dimension) = (0, 0);
            for (axis, &at) in axes.iter().zip(at) {
                id = id * axis.length + axis.places[at];
                dimension += (axis.places[at] % 2) as usize;
            }
            number_of_place[place] = ids[dimension].len() as u32;
            ids[dimension].push(id);
            keys[dimension].push(key);
        });
        Ok(Self { number, axes, number_of_place, ids, keys, sets })
    }

    fn into_part(self) -> Result<Part, Error> {
        let degree_count = self.axes.len() + 1;
        let mut strides = vec![1usize; self.axes.len()];
        for axis in (1..self.axes.len()).rev() {
            strides[axis - 1] = strides[axis] * self.axes[axis].places.len();
        }
        let mut columns: Vec<(Vec<u32>, Vec<u32>, Vec<i32>)> = self
            .ids
            .iter()
            .enumerate()
            .map(|(dimension, ids)| {
                let count = ids.len();
                let mut starts = Vec::with_capacity(count + 1);
                starts.push(0);
                (starts, Vec::with_capacity(2 * dimension * count), Vec::with_capacity(2 * dimension * count))
            })
            .collect();
        let mut faces: Vec<(u32, i32)> = Vec::with_capacity(2 * self.axes.len());
        for_each_place(&self.axes, |place, at| {
            if self.number_of_place[place] == NONE {
                return;
            }
            faces.clear();
            let mut dimension = 0;
            for ((axis, &at), stride) in self.axes.iter().zip(at).zip(&strides) {
                if axis.places[at] % 2 == 0 {
                    continue;
                }
                let sign = if dimension % 2 == 0 { 1 } else { -1 };
                dimension += 1;
                let [low, high] = axis.faces[at];
                // An axis of one voxel that is periodic: both faces are one, and cancel.
                if low != high {
                    let origin = place - at * stride;
                    faces.push((self.number_of_place[origin + low as usize * stride], -sign));
                    faces.push((self.number_of_place[origin + high as usize * stride], sign));
                }
            }
            faces.sort_unstable();
            let (starts, rows, entries) = &mut columns[dimension];
            rows.extend(faces.iter().map(|&(row, _)| row));
            entries.extend(faces.iter().map(|&(_, entry)| entry));
            starts.push(rows.len() as u32);
        });
        let mut matrices = Vec::with_capacity(degree_count);
        for (dimension, (starts, rows, entries)) in columns.into_iter().enumerate().skip(1) {
            matrices.push(SparseMatrix::from_trusted_parts(
                self.ids[dimension - 1].len(),
                starts,
                rows,
                entries,
            )?);
        }
        Part::new(
            self.number,
            ChainComplex::from_trusted_boundaries(matrices),
            self.ids,
            &self.sets,
            self.keys,
        )
    }
}

/// Adds the blocks of the voxels around a place that are set.
fn blocks_around(blocks: &CubicalBlocks<'_>, axes: &[Axis], at: &[usize], found: &mut Vec<u32>) {
    // All choices of one voxel along each axis: (place among all voxels, block) so far.
    let mut choices = [(0usize, 0u32); MOST_AROUND];
    let mut count = 1;
    for ((axis, &at), (&length, &block_count)) in
        axes.iter().zip(at).zip(blocks.volume.shape().iter().zip(&blocks.counts))
    {
        let around = &axis.around[at];
        for i in (0..count).rev() {
            let (voxel, block) = choices[i];
            for (j, &(x, b)) in around.iter().enumerate().rev() {
                choices[i * around.len() + j] =
                    (voxel * length as usize + x as usize, block * block_count + b);
            }
        }
        count *= around.len();
    }
    found.extend(
        choices[..count].iter().filter(|&&(voxel, _)| blocks.volume.is_set_at(voxel)).map(|&(_, b)| b),
    );
}
