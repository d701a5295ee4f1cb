//! Cells of one dimension with positions.
//!
//! # Words
//! * [`PlacedCells`] are simplices or cuboids of one dimension on one list of positions, what grids, mapped shapes and
//!   products are before they become a model, a mesh or a chain complex.
//! * [`CellKind`] says which of the two, and with it the order of the vertices of a cell.

mod faces;
mod placed_cells;

pub(crate) use faces::turn_cell;
pub use placed_cells::{CellKind, PlacedCells};
