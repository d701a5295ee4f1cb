//! Congruence: cells that coincide within a tolerance become one.

mod cells;
mod chains;
mod near_points;
mod vertices;

pub use cells::{CellClasses, CellCongruence, cell_congruence};
pub use chains::{ChainCongruence, chain_congruence};
pub use vertices::{ClassRule, Representative, VertexCongruence, vertex_congruence};

/// How quotients are computed. The results are the same, entry by entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum CongruenceMethod {
    /// Lists of facets, sorted in buckets: the fast one.
    #[default]
    Lists,
    /// Products of sparse matrices, and a map of their columns.
    Matrices,
}
