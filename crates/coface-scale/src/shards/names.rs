//! Vertices of cells, by which chains on them are written.

use super::grid::GridShards;
use coface_algebra::RaggedArray;

/// How the cells of a shard are named.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Names {
    /// By their ids.
    Ids,
    /// By corners of a grid.
    Grid(GridShards),
    /// By these lists of vertices, for each degree one for each cell.
    Vertices(Vec<RaggedArray>),
}

impl Names {
    pub(super) fn of(&self, degree: usize, cell: usize, id: u64) -> Vec<u64> {
        match self {
            Self::Ids => vec![id],
            Self::Grid(grid) => grid.vertices(id),
            Self::Vertices(lists) => {
                lists[degree].list(cell).iter().map(|&vertex| u64::from(vertex)).collect()
            }
        }
    }
}
