//! Cubical complexes of volumes: the voxels that are set, with all their faces, whole or block by block.
//!
//! # Words
//! * A **volume** is an array of voxels, each set or not, of any number of axes. An axis may be **periodic**: its last voxel then meets its
//!   first.
//! * Places of cells are counted twice as fine as voxels: an even coordinate is a corner, an odd one the inside of a voxel, and the number
//!   of odd coordinates is the dimension. The **id** of a cell is its place as one number, the last axis running fastest.
//! * A **block** is a box of voxels. Blocks are the parts of a partition ([`crate::chains::Part`]), each made from the voxels in it and one
//!   layer around it, without the rest of the complex.

mod blocks;
mod volume;

pub use blocks::CubicalBlocks;
pub use volume::{CubicalVolume, VoxelBox};
