//! Complexes of cells that need not be simplices: tetrahedra, hexahedra, wedges and pyramids with shared faces.
//!
//! # Words
//! * A [`CellMesh`] is a set of cells on one vertex set with **sides** identified: two sides of cells are one **face** when
//!   they are the same cycle of vertices. Its vertices, edges and faces are its **skeleton**, a
//!   [`crate::surface::PolygonMesh`].
//! * A **positive** cell lists its vertices as [`CellShape`] describes in a right-handed frame; the boundary of a cell is
//!   the sum of its sides as seen from outside.
//! * [`VolumeVerdict`], [`VolumeOrientation`]: exact answers with the cells that prove a no.
//! * [`BoundarySurface`]: the faces of exactly one cell.
//! * [`cell_volumes`]: what cells with positions measure.
//! * [`PlacedCells`]: simplices or cuboids of one dimension with positions, as grids and shapes are made of.
//! * An [`Assembly`] is a list of those, affine maps and further lists.
//! * A [`CuboidGrid`] is a product of subdivided intervals; the numbers of its cells are computed, never stored.
//! * [`Voxels`] are set or not: a [`CubicalVolume`] in memory, [`FullVoxels`] of which nothing is stored, the [`VoxelWindow`] of a box.
//!   [`CubicalBlocks`] makes the complex of their faces piece by piece, [`SimplicialBlocks`] that of the simplices they are cut into.
//! * A [`LarModel`] is cells of any dimension as lists of vertices; an [`Operator`] relates the cells of two degrees.
//! * [`OrientedCells`] have signs of their facets that make each boundary a cycle: [`oriented_boundary`] finds them.

mod assembly;
mod boundary;
mod cell_mesh;
mod cubical;
mod face_identification;
mod grids;
mod lar;
mod manifold;
mod measure;
mod orientation;
mod parts;
mod shape;
pub mod shapes;
mod two_skeleton;

pub use assembly::{Assembly, AssemblyPart, FlatAssembly};
pub use boundary::{BoundarySurface, OddCellCycle, VolumeOrientation};
pub use cell_mesh::CellMesh;
pub use cubical::{
    CubicalBlocks, CubicalVolume, FullVoxels, SimplicialBlocks, VoxelBox, VoxelBoxes, VoxelWindow, Voxels,
};
pub use grids::{AxisSet, CuboidGrid, GridCell, ProductCells, product};
pub use lar::{LarModel, Operator, Shared, TopOrientation};
pub use manifold::{VolumeDefect, VolumeVerdict};
pub use measure::{CellVolumes, cell_volumes};
pub use orientation::{CellCoherence, OddCellChain, OrientedCells, oriented_boundary, signed_measures};
pub use shape::CellShape;
#[doc(hidden)]
pub use shapes::turn_cell;
pub use shapes::{CellKind, PlacedCells};
