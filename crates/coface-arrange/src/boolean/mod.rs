//! Boolean combinations of inputs on one arrangement.
//!
//! # Words and conventions
//! * An **input** is a chain of facets: each facet of the arrangement with the multiplicity it has in the input,
//!   positive where the front of the facet is outside. Facets are edges in the plane and faces in space.
//! * [`WindingNumbers`] tell how often each input winds around each cell; the exterior has winding number zero. An
//!   [`InsideRule`] says which numbers are inside. An [`InputRim`] is where an input is open and has none; the
//!   [`generalized_winding_numbers`] are for such inputs, in floating point.
//! * A [`BooleanFormula`] over the inputs, as a [`FormulaTree`] with all operands of an operator beside each other, makes a [`CellSelection`]; its [`SelectionBoundary`] runs with the selected
//!   cells behind, and in space makes a [`SelectionMesh`].

mod formula;
mod formula_tree;
mod generalized_winding;
mod input_rim;
mod partial_values;
mod pinches;
mod selection;
mod selection_mesh;
mod winding;

pub use formula::BooleanFormula;
pub use formula_tree::{FormulaTree, TreeOperator};
pub use generalized_winding::{generalized_winding_numbers, point_inside};
pub use input_rim::InputRim;
pub use partial_values::PartialValues;
pub use selection::{CellSelection, SelectionBoundary};
pub use selection_mesh::SelectionMesh;
pub use winding::{InsideRule, WindingNumbers};
