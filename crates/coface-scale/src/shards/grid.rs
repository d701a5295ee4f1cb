//! Shards of grids and volumes of voxels: a box each, as a description, with its voxels where not all are set.

use super::place::ShardPlace;
use coface_algebra::Error;
use coface_algebra::chains::Part;
use coface_complexes::cubical::{
    CubicalBlocks, FullVoxels, SimplicialBlocks, VoxelBoxes, VoxelWindow, Voxels,
};
use coface_io::container::{Container, ContainerWriter, Role};

/// What the voxels of a grid are cut into.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GridSort {
    /// Nothing: cells are cubes and their faces.
    Cubes,
    /// The simplices of [`SimplicialBlocks`].
    Simplices,
}

/// A grid of voxels cut into boxes, the parts of its cubical or simplicial complex.
///
/// # Examples
/// A torus of 16 x 16 x 16 voxels, of which only descriptions are stored:
/// ```
/// use coface_complexes::cubical::VoxelBoxes;
/// use coface_scale::shards::{GridShards, GridSort, ShardSource};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let folder = std::env::temp_dir().join("coface-grid-shards");
/// let boxes = VoxelBoxes::at_least(&[16, 16, 16], &[true; 3], 8)?;
/// let grid = GridShards::new(GridSort::Cubes, boxes, 8);
/// let shards = grid.shard_full(&folder, ShardSource::default(), false)?;
/// (0..8).try_for_each(|number| shards.reduce(number, false).map(|_| ()))?;
/// assert_eq!(shards.merge_all(false)?.homology().betti_numbers(), [1, 3, 3, 1]);
/// assert!(std::fs::metadata(shards.shard_path(0))?.len() < 1000);
/// # std::fs::remove_dir_all(&folder)?;
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GridShards {
    sort: GridSort,
    boxes: VoxelBoxes,
    pub(super) fan_in: u32,
}

impl GridShards {
    /// The boxes of a grid, whose complexes are merged by so many.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::cubical::VoxelBoxes;
    /// use coface_scale::shards::{GridShards, GridSort};
    /// let boxes = VoxelBoxes::at_least(&[4, 4], &[true; 2], 2)?;
    /// let grid = GridShards::new(GridSort::Cubes, boxes, 8);
    /// assert_eq!(grid.boxes().count(), 2);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn new(sort: GridSort, boxes: VoxelBoxes, fan_in: u32) -> Self {
        Self { sort, boxes, fan_in }
    }

    /// The boxes, which are the parts.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::cubical::VoxelBoxes;
    /// use coface_scale::shards::{GridShards, GridSort};
    /// let boxes = VoxelBoxes::at_least(&[4, 4], &[true; 2], 2)?;
    /// let grid = GridShards::new(GridSort::Cubes, boxes, 8);
    /// assert_eq!(grid.boxes().shape(), [4, 4]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn boxes(&self) -> &VoxelBoxes {
        &self.boxes
    }

    /// The numbers that describe the grid.
    pub(super) fn to_numbers(&self) -> Vec<u32> {
        let sort = u32::from(self.sort == GridSort::Simplices);
        let mut numbers = vec![sort, self.boxes.shape().len() as u32];
        numbers.extend(self.boxes.shape());
        numbers.extend(self.boxes.is_periodic().iter().map(|&is_periodic| u32::from(is_periodic)));
        numbers.extend(self.boxes.counts());
        numbers
    }

    /// The grid of a shard, and its voxels if not all are set.
    pub(super) fn of(
        container: &Container<'_>,
        place: ShardPlace,
    ) -> Result<(Self, Option<Vec<u64>>), Error> {
        let lie = |message: &str| container.lie(Role::Grid, 0, message);
        let numbers = container.array::<u32>(Role::Grid, 0)?;
        let &[sort @ 0..=1, axis_count @ 1..=8, ref rest @ ..] = &numbers[..] else {
            return Err(lie("this describes no grid"));
        };
        let axis_count = axis_count as usize;
        if rest.len() != 3 * axis_count || rest[axis_count..2 * axis_count].iter().any(|&number| number > 1) {
            return Err(lie("this describes no grid"));
        }
        let is_periodic: Vec<bool> =
            rest[axis_count..2 * axis_count].iter().map(|&number| number == 1).collect();
        let boxes = VoxelBoxes::new(&rest[..axis_count], &is_periodic, &rest[2 * axis_count..])
            .map_err(|error| lie(error.message()))?;
        if boxes.count() != place.part_count {
            return Err(lie("there are not as many boxes as parts"));
        }
        let sort = if sort == 1 { GridSort::Simplices } else { GridSort::Cubes };
        let words =
            container.has(Role::Bits, 0).then(|| container.array::<u64>(Role::Bits, 0)).transpose()?;
        Ok((Self { sort, boxes, fan_in: place.fan_in }, words.map(std::borrow::Cow::into_owned)))
    }

    /// The part of a box with these voxels, or all.
    pub(super) fn part(&self, number: u32, words: Option<Vec<u64>>) -> Result<Part, Error> {
        let (shape, is_periodic) = (self.boxes.shape(), self.boxes.is_periodic());
        match words {
            Some(words) => {
                let window = VoxelWindow::from_words(shape, is_periodic, &self.boxes.voxels(number), words)?;
                self.part_of(&window, number)
            }
            None => self.part_of(&FullVoxels::new(shape, is_periodic)?, number),
        }
    }

    fn part_of(&self, volume: &impl Voxels, number: u32) -> Result<Part, Error> {
        match self.sort {
            GridSort::Cubes => CubicalBlocks::new(volume, self.boxes.counts())?.block(number),
            GridSort::Simplices => SimplicialBlocks::new(volume, self.boxes.counts())?.block(number),
        }
    }

    /// The corners of a cell by its id: numbers of the points of the grid, the last axis running fastest; an axis that is not periodic has one
    /// point more than voxels. A simplex has them in its order.
    pub(super) fn vertices(&self, id: u64) -> Vec<u64> {
        let axes: Vec<(u64, bool)> = self
            .boxes
            .shape()
            .iter()
            .map(|&length| u64::from(length))
            .zip(self.boxes.is_periodic().iter().copied())
            .collect();
        let kind_count = match self.sort {
            GridSort::Cubes => 1,
            GridSort::Simplices => SimplicialBlocks::<FullVoxels>::kind_count(axes.len()),
        };
        let (mut place, kind) = (id / kind_count, id % kind_count);
        // Coordinates in half voxels.
        let mut at = vec![0; axes.len()];
        for (at, (length, is_periodic)) in at.iter_mut().zip(&axes).rev() {
            let places = 2 * length + u64::from(!is_periodic);
            (*at, place) = (place % places, place / places);
        }
        let odd: Vec<usize> = (0..axes.len()).filter(|&axis| at[axis] % 2 == 1).collect();
        let corner = |set: u32| {
            axes.iter().enumerate().fold(0, |number, (axis, &(length, is_periodic))| {
                let rank = odd.iter().position(|&other| other == axis);
                let up = rank.is_some_and(|rank| set >> rank & 1 == 1);
                let points = length + u64::from(!is_periodic);
                number * points + (at[axis] / 2 + u64::from(up)) % points
            })
        };
        match self.sort {
            // The last axis runs fastest: its bit is the highest of the set.
            GridSort::Cubes => (0..1u32 << odd.len())
                .map(|i| corner(i.reverse_bits().checked_shr(32 - odd.len() as u32).unwrap_or(0)))
                .collect(),
            GridSort::Simplices => {
                let chain = chain_of_sets(odd.len() as u32, kind);
                std::iter::once(0).chain(chain).map(corner).collect()
            }
        }
    }
}

/// The chain of this number among those that rise to all of so many axes: shorter chains first, then lexicographically.
fn chain_of_sets(axis_count: u32, number: u64) -> Vec<u32> {
    fn walk(full: u32, chain: &mut Vec<u32>, all: &mut Vec<Vec<u32>>) {
        let last = chain.last().copied().unwrap_or(0);
        if last == full {
            return all.push(chain.clone());
        }
        for set in (last + 1..=full).filter(|set| set & last == last) {
            chain.push(set);
            walk(full, chain, all);
            chain.pop();
        }
    }
    let mut all = Vec::new();
    walk((1 << axis_count) - 1, &mut Vec::new(), &mut all);
    all.sort_by_key(Vec::len);
    all.swap_remove(number as usize)
}

/// Appends the description of a grid, and the voxels of a box.
pub(super) fn push_grid<'a>(writer: &mut ContainerWriter<'a>, grid: &GridShards, words: Option<&'a [u64]>) {
    writer.push_owned(Role::Grid, 0, &grid.to_numbers());
    if let Some(words) = words {
        writer.push(Role::Bits, 0, words);
    }
}
