//! Signs of facets in the boundaries of cells: orientation in closed form.
//!
//! # Words
//! * A **ridge** of a k-cell is a facet of its facets, a (k-2)-cell. Two facets on a ridge that lies in no other facet of the
//!   cell have signs that determine each other, since the boundary of the boundary vanishes there.
//! * A **component** of the boundary of a cell is what hangs together by such ridges, a cycle by itself; a hole of a face and a
//!   void of a solid have components of their own. Signs within a component are known up to a common sign.
//! * The **lowest facet** of a cell is the one with the least number. A component has the sign that gives its lowest facet +1,
//!   and so has a cell, unless something else decides: positive area or volume of cells of full dimension, or coherence.
//! * An **outer** component encloses the others; it is the one with the largest area or volume, and the others run
//!   opposite to it.
//!
//! Vertices are positive; an edge is its second vertex minus its first.
//!
//! Signs of areas and volumes are exact, whatever the coordinates: sums of rounded products decide where their error is
//! smaller than they are, and big integers where it is not.

mod coherence;
mod exact;
mod measure;
mod nesting;
mod oriented_cells;
mod pinched;
mod propagation;
#[cfg(test)]
mod tests;

pub use coherence::CellCoherence;
pub use measure::signed_measures;
pub use oriented_cells::OrientedCells;
pub use propagation::oriented_boundary;
