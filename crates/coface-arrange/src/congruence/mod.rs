//! Congruence: cells that coincide within a tolerance become one.

mod blocks;
mod cells;
mod chains;
mod classes;
mod discards;
mod mapped;
mod near_points;
mod options;
mod rewrap;
mod vertices;

pub use blocks::{BlockMerge, BlockPolicy, blocks_of, check_blocks};
pub use cells::{CellCongruence, cell_congruence};
pub use chains::{ChainCongruence, chain_congruence};
pub use classes::CellClasses;
pub use discards::Discard;
pub(crate) use near_points::is_near;
pub use options::{Collisions, CongruenceMethod, CongruenceOptions};
pub use vertices::{
    ClassRule, Representative, VertexCongruence, stable_vertex_congruence, vertex_congruence,
};
