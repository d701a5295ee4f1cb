//! Persistent homology of images: arrays of numbers with one to four axes.
//!
//! # Words and conventions
//! * An image makes a cubical complex in two ways, an [`ImageConstruction`]. In the **V-construction** voxels are vertices, and a cube enters with
//!   its last vertex; in the **T-construction** voxels are cubes of the highest dimension, and a face enters with the first voxel around it.
//! * **Sublevel** sets grow with rising values, **superlevel** sets with falling ones. A voxel whose value is no number (NaN) never enters.
//! * By duality one computation serves both: the pairs of the T-construction are those of the V-construction of the falling values, relative to
//!   what is outside, with degrees counted from the other end. So inside this section voxels are the vertices of a **grid**, which has a layer of
//!   **absent** vertices around it, except along periodic axes. Absent vertices enter never (V) or have always been there and are divided out (T).
//! * The **rank** of a vertex is its place in the order of entrance, from 1 on. The vertex of the highest rank **owns** a cell; the cells that it
//!   owns are its **lower star**. A cell of a star has a **code**: for each axis whether it lies before, at or behind the owner.
//! * In each lower star cells are matched with faces by coreduction. The matching is acyclic and pairs cells of one value, so persistence depends
//!   on the **critical** cells alone: those that are left, in the order (rank, degree, code).
//! * A periodic axis of a single voxel is a **circle** that the image is multiplied by: each class is there once more, a degree higher. The grid leaves such axes out.
//! * Vertices are paired with edges, and top cells with their facets, by union-find. Between them the boundaries of critical cells are reduced,
//!   with clearing; a matched cell in a column is replaced by the rest of the boundary of its partner as soon as it leads the column.

mod blocks;
mod circles;
mod cycles;
mod descent;
mod diagram;
mod euler;
mod filtration;
mod forest;
mod gradient;
mod grid;
mod pairing;

#[cfg(test)]
mod tests;

pub use blocks::{ImageBlocks, ImagePart};
pub use cycles::{CubeTerms, ImageCycle, ImageCycles};
pub use diagram::{ImageDiagram, ImagePair};
pub use filtration::{ImageConstruction, ImageFiltration};
