//! The places of cells of a block, and the cells among them.

use super::bits::Bits;
use super::boxes::VoxelBoxes;
use super::volume::CubicalVolume;
use super::window::VoxelWindow;
use coface_algebra::RaggedArray;
use coface_algebra::{Error, ErrorKind};
use std::collections::BTreeMap;

/// How many voxels are around a cell at most.
const MOST_AROUND: usize = 1 << CubicalVolume::MOST_AXES;

/// One axis, as a block sees it.
pub(super) struct Axis {
    /// The places of its cells along the axis, rising.
    pub(super) places: Vec<u64>,
    /// How many places the whole axis has.
    pub(super) length: u64,
    /// For each place the voxels around it: their places in the window and their blocks along the axis. One or two.
    around: Vec<Vec<(usize, u32)>>,
    /// The block along the axis.
    own: u32,
    /// How many blocks there are along the axis.
    block_count: u32,
    /// The number of places from one place along the axis to the next, in the block.
    pub(super) stride: usize,
}

impl Axis {
    fn new(boxes: &VoxelBoxes, window: &VoxelWindow, axis: usize, own: u32) -> Self {
        let voxel_count = boxes.shape()[axis];
        let is_periodic = boxes.is_periodic()[axis];
        let length = 2 * u64::from(voxel_count) + u64::from(!is_periodic);
        let voxels = window.inner();
        let mut places: Vec<u64> = (2 * u64::from(voxels.start[axis])..=2 * u64::from(voxels.end[axis]))
            .map(|place| place % length)
            .collect();
        places.sort_unstable();
        places.dedup();
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
            let in_window = |voxel| {
                let place = window.place_along(axis, voxel).expect("the window has what is around its box");
                (place, boxes.box_of(axis, voxel))
            };
            voxels.into_iter().map(in_window).collect()
        });
        let around = around.collect();
        Self { places, length, around, own, block_count: boxes.counts()[axis], stride: 0 }
    }

    /// Whether all voxels around a place are of the block.
    fn is_inner(&self, at: usize) -> bool {
        self.around[at].iter().all(|&(_, block)| block == self.own)
    }

    /// The places of the faces of an odd place less that place, counted in the block; the same twice where the axis is one voxel long and
    /// periodic.
    pub(super) fn face_steps(&self, at: usize) -> [isize; 2] {
        let stride = self.stride as isize;
        let upper = if at + 1 < self.places.len() && self.places[at + 1] == self.places[at] + 1 {
            stride
        } else {
            // Around the end of a periodic axis, at place 0.
            -(at as isize) * stride
        };
        [-stride, upper]
    }
}

/// The places of cells of a block, of which those are cells of the block that have a voxel of it that is set.
pub(super) struct BlockPlaces<'w> {
    number: u32,
    window: &'w VoxelWindow,
    pub(super) axes: Vec<Axis>,
    pub(super) count: usize,
}

/// A cell of a block.
pub(super) struct Cell {
    /// Its place among those of the block.
    pub(super) place: usize,
    /// Its place among those of the volume.
    pub(super) id: u64,
    pub(super) dimension: usize,
    /// The number of its key.
    pub(super) key: u32,
}

impl<'w> BlockPlaces<'w> {
    pub(super) fn new(boxes: &VoxelBoxes, window: &'w VoxelWindow, number: u32) -> Result<Self, Error> {
        let own = boxes.places(number);
        let mut axes: Vec<Axis> =
            own.iter().enumerate().map(|(axis, &own)| Axis::new(boxes, window, axis, own)).collect();
        let mut count = Some(1usize);
        for axis in axes.iter_mut().rev() {
            axis.stride = count.unwrap_or(0);
            count = count.and_then(|count| count.checked_mul(axis.places.len()));
        }
        let Some(count) = count.filter(|&count| u32::try_from(count).is_ok()) else {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("block {number} has more than 2^32 places of cells"),
            )
            .with_cure("cut the volume into more blocks"));
        };
        Ok(Self { number, window, axes, count })
    }

    /// Calls with the cells by rising ids; gives the keys.
    pub(super) fn for_each_cell(&self, mut visit: impl FnMut(Cell)) -> RaggedArray {
        let mut keys = BlockSets::new(self.number);
        let (last, outer) = self.axes.split_last().expect("a volume has an axis");
        let row_length = *self.window.lengths().last().expect("a volume has an axis") as usize;
        let mut row = Bits { words: vec![0; row_length.div_ceil(64)], len: row_length };
        let is_inner: Vec<bool> = (0..last.places.len()).map(|at| last.is_inner(at)).collect();
        // The two places of voxels around, twice the same where there is one; of the voxels of this block.
        let own_around: Vec<[usize; 2]> = last
            .around
            .iter()
            .map(|around| {
                let mut own = around.iter().filter(|&&(_, block)| block == last.own).map(|&(place, _)| place);
                let first = own.next().expect("each place of a block has a voxel of it");
                [first, own.next().unwrap_or(first)]
            })
            .collect();
        let mut choices = Vec::with_capacity(MOST_AROUND);
        let mut blocks = Vec::with_capacity(MOST_AROUND);
        self.for_each_row(|place, at, first_id, first_dimension| {
            let own_row = self.rows_around(outer, at, &mut choices);
            row.words.fill(0);
            for &(start, _) in choices.iter().filter(|&&(_, block)| block == own_row) {
                row.add(0, self.window.bits(), start, row_length);
            }
            if row.words.iter().all(|&word| word == 0) {
                return;
            }
            let row_is_inner = choices.iter().all(|&(_, block)| block == own_row);
            for (at, &[a, b]) in own_around.iter().enumerate() {
                if !row.contains(a) && !row.contains(b) {
                    continue;
                }
                let key = if row_is_inner && is_inner[at] {
                    0
                } else {
                    blocks.clear();
                    for &(start, block) in &choices {
                        for &(voxel, along) in &last.around[at] {
                            if self.window.bits().contains(start + voxel) {
                                blocks.push(block * last.block_count + along);
                            }
                        }
                    }
                    keys.number(&mut blocks)
                };
                visit(Cell {
                    place: place + at,
                    id: first_id + last.places[at],
                    dimension: first_dimension + (last.places[at] % 2) as usize,
                    key,
                });
            }
        });
        keys.sets
    }

    /// Calls for each row along the last axis with the first place, the places along the other axes, and the id and the dimension of a cell
    /// at place 0 of the row.
    pub(super) fn for_each_row(&self, mut visit: impl FnMut(usize, &[usize], u64, usize)) {
        let (last, outer) = self.axes.split_last().expect("a volume has an axis");
        let mut at = vec![0; outer.len()];
        for row in 0..self.count / last.places.len() {
            let (mut id, mut dimension) = (0, 0);
            for (axis, &at) in outer.iter().zip(&at) {
                id = id * axis.length + axis.places[at];
                dimension += (axis.places[at] % 2) as usize;
            }
            visit(row * last.places.len(), &at, id * last.length, dimension);
            for (at, axis) in at.iter_mut().zip(outer).rev() {
                *at += 1;
                if *at < axis.places.len() {
                    break;
                }
                *at = 0;
            }
        }
    }

    /// The rows of voxels around a row of places: where they begin in the window, and their block but for the last axis. Gives that of the
    /// block itself.
    fn rows_around(&self, outer: &[Axis], at: &[usize], choices: &mut Vec<(usize, u32)>) -> u32 {
        choices.clear();
        choices.push((0, 0));
        let mut own = 0;
        for (i, (axis, &at)) in outer.iter().zip(at).enumerate() {
            let length = self.window.lengths()[i] as usize;
            own = own * axis.block_count + axis.own;
            let around = &axis.around[at];
            let count = choices.len();
            if let &[_, second] = &around[..] {
                choices.extend_from_within(..);
                for (voxel, block) in &mut choices[count..] {
                    (*voxel, *block) = (*voxel * length + second.0, *block * axis.block_count + second.1);
                }
            }
            for (voxel, block) in &mut choices[..count] {
                (*voxel, *block) = (*voxel * length + around[0].0, *block * axis.block_count + around[0].1);
            }
        }
        let row_length = *self.window.lengths().last().expect("a volume has an axis") as usize;
        choices.iter_mut().for_each(|(voxel, _)| *voxel *= row_length);
        own
    }
}

/// The sets of blocks that cells have voxels of, while they are gathered; that of the block alone is the first.
struct BlockSets {
    sets: RaggedArray,
    numbers: BTreeMap<Vec<u32>, u32>,
    /// The last list that was asked for, and its number: neighbors along a wall have the same.
    last: (Vec<u32>, u32),
}

impl BlockSets {
    fn new(number: u32) -> Self {
        Self {
            sets: RaggedArray::from_lists([[number]]),
            numbers: BTreeMap::from([(vec![number], 0)]),
            last: (vec![number], 0),
        }
    }

    /// The number of the set of these blocks; the list is left rising.
    fn number(&mut self, blocks: &mut Vec<u32>) -> u32 {
        blocks.sort_unstable();
        blocks.dedup();
        if self.last.0 == *blocks {
            return self.last.1;
        }
        let number = self.numbers.get(blocks).copied().unwrap_or_else(|| {
            let number = self.sets.len() as u32;
            self.sets.push(blocks);
            self.numbers.insert(blocks.clone(), number);
            number
        });
        self.last.0.clone_from(blocks);
        self.last.1 = number;
        number
    }
}
