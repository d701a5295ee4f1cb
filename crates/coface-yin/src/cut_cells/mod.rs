//! A Yin set on a Cartesian grid: what of it lies in each cell.
//!
//! * The boundary is cut at the lines of the grid into **arcs**, each in one cell; an arc that runs along a line belongs to the cell
//!   on its left, where the set is. Arcs that follow each other in a cell make a **chain**, from where the boundary comes in to where
//!   it goes out, or all of a curve.
//! * A cell is **full** or **empty** when no chain runs through its interior, else **cut**. What lies in a cut cell is bounded by
//!   **walks** of arcs and of parts of the sides of the cell, counterclockwise from where a chain goes out to where the next one
//!   comes in.
//! * Areas come from Green's theorem and a sweep along each row, so that those of all cells add up to the area of the set in the grid
//!   whatever is decided about a cell.

mod arcs;
mod cells;
mod grid;
mod integrals;
mod perimeter;
mod walks;

pub use arcs::CutArc;
pub use cells::{Coverage, CutCell, CutCells};
pub use grid::CartesianGrid;
pub use walks::WalkStep;
