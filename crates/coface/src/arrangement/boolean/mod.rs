//! Boolean combinations of inputs on one arrangement.
//!
//! # Words and conventions
//! * An **input** is a chain of facets: each facet of the arrangement with the multiplicity it has in the input, positive where the
//!   front of the facet is outside. Facets are edges in the plane and faces in space.
//! * [`WindingNumbers`] tell how often each input winds around each cell; the exterior has winding number zero. An [`InsideRule`]
//!   says which numbers are inside.
//! * A [`BooleanFormula`] over the inputs makes a [`CellSelection`]; its [`SelectionBoundary`] runs with the selected cells behind.

mod formula;
mod selection;
mod winding;

pub use formula::BooleanFormula;
pub use selection::{CellSelection, SelectionBoundary};
pub use winding::{InsideRule, WindingNumbers};
