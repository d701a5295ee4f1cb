//! Cuboid grids: products of subdivided intervals in any dimension, with all their faces in closed form.
//!
//! # Words and conventions
//! * An **axis** is an interval cut by grid **lines** (planes, ...), numbered from 0. An interval between neighboring lines is
//!   full or empty.
//! * A **cell** is a product of one full interval or one line for each axis. It **extends** along the axes of the
//!   intervals, an [`AxisSet`]; its **corner** are the lower lines. Its dimension is the number of axes it extends along.
//! * Vertices are numbered lexicographically by their lines, the last axis fastest. A p-cell lists its 2^p vertices in
//!   that order (a square is not listed as a cycle).
//! * The p-cells come in blocks of one axis set, in the order of the bit strings with a 1 for each axis of the set, axis 0
//!   first; within a block lexicographically by corner.
//! * The boundary is that of a product, axis 0 the first factor: along the k-th axis of its set, counted from 0, the upper
//!   facet has the sign $(-1)^k$ and the lower facet the opposite.
//! * [`CuboidGrid::simplices`] cuts the top cells into simplices along diagonals. [`product()`] multiplies cells with positions,
//!   [`LarModel::product`](crate::lar::LarModel::product) models with all their cells; vertices and cells of a product are pairs, the
//!   second factor fastest.

mod axis;
mod axis_set;
mod boundary;
mod cuboid_grid;
mod kuhn;
mod lists;
mod placed;
mod product;

pub use axis_set::AxisSet;
pub use cuboid_grid::{CuboidGrid, GridCell};
pub use product::{ProductCells, product};

#[cfg(test)]
mod tests;
