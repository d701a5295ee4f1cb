//! The answers of verbs that change an interface as a whole, or cut it at a grid.

use super::{CoverageAnswer, GridAnswer, Remark, YinInterfaceAnswer};
use serde::{Deserialize, Serialize};

/// The answer of `yin normalize` for an interface.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinInterfaceNormalizeAnswer {
    /// What was wrong, in words, if edges were cut and pasted; null if nothing was.
    pub repaired: Option<String>,
    /// The number of vertices at which two edges became one.
    pub joined: usize,
    /// The number of knots within straight parts of edges that were left out; 0 above order 2.
    pub straightened: usize,
    /// The interface.
    #[serde(flatten)]
    pub interface: YinInterfaceAnswer,
}

/// The answer of `yin kinks` for an interface.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinInterfaceKinksAnswer {
    /// The kinks: vertices at which two edges end and do not go on smoothly into each other.
    pub kink_points: Vec<InterfaceKink>,
    /// The interface.
    #[serde(flatten)]
    pub interface: YinInterfaceAnswer,
}

/// A kink of an interface.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct InterfaceKink {
    /// Its vertex.
    pub vertex: u32,
    /// An edge that begins or ends there.
    pub edge: u32,
    /// Its knot on that edge.
    pub knot: u32,
    /// Where it is.
    pub point: [f64; 2],
    /// The phases on both sides; null for what is in no phase.
    pub phases: [Option<u32>; 2],
}

/// The answer of `yin cut-cells` for an interface.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinInterfaceCutCellsAnswer {
    /// The name of the file.
    pub file: String,
    /// The grid.
    pub grid: GridAnswer,
    /// The area of all phases in the grid.
    pub area: f64,
    /// The length of the edges in the grid, each once.
    pub length: f64,
    /// The phases, in their order.
    pub phases: Vec<PhaseCells>,
    /// What phases have of cells, row by row and then by phases; in files only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cells: Option<Vec<PhaseCell>>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// What a phase has of a grid.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PhaseCells {
    /// The name of the phase.
    pub name: String,
    /// The number of cells inside of the phase.
    pub full: usize,
    /// The number of cells that are partly in the phase.
    pub cut: usize,
    /// The number of cells outside of the phase.
    pub empty: usize,
    /// The area of the phase in the grid.
    pub area: f64,
    /// The length of its boundary in the grid.
    pub length: f64,
    /// The area of the phase; null if it is infinite.
    pub area_of_phase: Option<f64>,
}

/// What a phase has of a cell.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct PhaseCell {
    /// The column, from 0 at the left.
    pub column: usize,
    /// The row, from 0 at the bottom.
    pub row: usize,
    /// The number of the phase, from 0, in the order of `"phases"`.
    pub phase: u32,
    /// How much of the cell is in the phase.
    pub coverage: CoverageAnswer,
    /// The area of the phase in the cell.
    pub area: f64,
    /// The length of its boundary in the cell.
    pub length: f64,
}
