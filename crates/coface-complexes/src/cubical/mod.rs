//! Cubical complexes of volumes: the voxels that are set, with all their faces, whole or block by block; and the same cut into simplices.
//!
//! # Words
//! * A **volume** is an array of voxels, each set or not, of any number of axes. An axis may be **periodic**: its last voxel then meets its
//!   first. Whatever can say which voxels of a box are set is a volume: [`Voxels`].
//! * Places of cells are counted twice as fine as voxels: an even coordinate is a corner, an odd one the inside of a voxel, and the number
//!   of odd coordinates is the dimension. The **id** of a cell is its place as one number, the last axis running fastest.
//! * A **block** is a box of voxels. Blocks are the parts of a partition ([`coface_algebra::chains::Part`]), each made from the voxels in it and one
//!   layer around it, its [`VoxelWindow`], without the rest of the volume.
//! * The **carrier** of a simplex is the cell that it lies in and no face of which it lies in. Blocks of simplices are blocks of their
//!   carriers.

mod bits;
mod blocks;
mod boxes;
mod places;
mod simplices;
mod surface;
mod volume;
mod voxels;
mod window;

pub use blocks::CubicalBlocks;
pub use boxes::{VoxelBox, VoxelBoxes};
pub use simplices::SimplicialBlocks;
pub use volume::CubicalVolume;
pub use voxels::{FullVoxels, Voxels};
pub use window::VoxelWindow;
