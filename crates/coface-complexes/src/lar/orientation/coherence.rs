//! Do cells agree across their facets, and can they be turned to?

use super::OrientedCells;
use crate::surface::dual_graph::DualGraph;
use crate::surface::dual_graph::coherence;
use coface_algebra::{CellId, Error, ErrorKind};
use coface_algebra::{RaggedArray, Sign, SparseMatrix};

/// Whether the cells of one degree agree, and whether they can be turned so that all do.
///
/// Two cells on a common facet agree when they have it with opposite signs. The question is decided across the facets with
/// exactly two cells; with a facet in three or more cells it has no answer.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CellCoherence {
    crowded_facet: Option<CellId>,
    conflicts: Vec<CellId>,
    signs: Vec<Sign>,
    odd_chain: Option<OddCellChain>,
}

/// A closed chain of cells that cannot all agree: cell i and cell i + 1 share facet i, the last and the first the last
/// facet. However the cells are turned, an odd number of these facets have two equal signs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OddCellChain {
    cells: Vec<CellId>,
    facets: Vec<CellId>,
}

impl OddCellChain {
    /// The cells in order, each once.
    pub fn cells(&self) -> &[CellId] {
        &self.cells
    }

    /// The facets in order: facet i is shared by cell i and the next.
    pub fn facets(&self) -> &[CellId] {
        &self.facets
    }
}

impl CellCoherence {
    /// Whether the cells can be turned so that all agree; `None` when a facet lies in three or more cells.
    pub fn is_orientable(&self) -> Option<bool> {
        self.crowded_facet.is_none().then_some(self.odd_chain.is_none())
    }

    /// Whether all cells agree as they are; `None` when a facet lies in three or more cells.
    pub fn is_coherent(&self) -> Option<bool> {
        self.crowded_facet.is_none().then_some(self.conflicts.is_empty())
    }

    /// The first facet in three or more cells.
    pub fn crowded_facet(&self) -> Option<CellId> {
        self.crowded_facet
    }

    /// The facets with exactly two cells, both with the same sign, rising.
    pub fn conflicts(&self) -> &[CellId] {
        &self.conflicts
    }

    /// Why the cells cannot agree.
    pub fn odd_chain(&self) -> Option<&OddCellChain> {
        self.odd_chain.as_ref()
    }
}

/// Cells as nodes, facets as walls.
struct CellGraph<'a> {
    boundary: &'a SparseMatrix,
    /// For each facet its cells, each as `2 * cell + reversed`.
    cells_at: RaggedArray,
}

impl DualGraph for CellGraph<'_> {
    fn node_count(&self) -> usize {
        self.boundary.column_count()
    }

    fn wall_count(&self) -> usize {
        self.cells_at.len()
    }

    fn walls_of(&self, cell: u32) -> impl Iterator<Item = u32> {
        self.boundary.column(cell as usize).rows().iter().copied()
    }

    fn nodes_at(&self, facet: usize) -> &[u32] {
        self.cells_at.list(facet)
    }
}

impl OrientedCells {
    /// Whether the cells agree, whether they can be made to, and a closed chain of cells that cannot if not.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] from 2^31 cells on.
    ///
    /// # Complexity
    /// Linear when the cells agree; else nearly linear, by union-find with signs.
    ///
    /// # Examples
    /// Two triangles on the edge 1 2, each with its lowest edge positive:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::{LarModel, oriented_boundary};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = RaggedArray::from_lists([[0, 1], [0, 2], [1, 2], [1, 3], [2, 3]]);
    /// let model = LarModel::new(4, vec![edges, RaggedArray::from_lists([[0, 1, 2], [1, 2, 3]])])?;
    /// let faces = oriented_boundary(&model.edge_boundaries()?, &model.facets(2)?.into_owned())?;
    /// assert_eq!(faces.coherence()?.is_coherent(), Some(false));
    /// assert_eq!(faces.coherent()?.coherence()?.is_coherent(), Some(true));
    /// # Ok(()) }
    /// ```
    pub fn coherence(&self) -> Result<CellCoherence, Error> {
        let boundary = self.boundary();
        if self.cell_count() >= 1 << 31 {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("{} cells to orient; the limit is 2^31 - 1", self.cell_count()),
            ));
        }
        let mut starts = vec![0u32; boundary.row_count() + 1];
        for &facet in boundary.rows() {
            starts[facet as usize + 1] += 1;
        }
        for i in 1..starts.len() {
            starts[i] += starts[i - 1];
        }
        let mut next = starts.clone();
        let mut packed = vec![0; boundary.entry_count()];
        for (cell, column) in boundary.columns().enumerate() {
            for (facet, entry) in column.iter() {
                packed[next[facet] as usize] = (cell as u32) << 1 | u32::from(entry < 0);
                next[facet] += 1;
            }
        }
        let graph = CellGraph { boundary, cells_at: RaggedArray::from_parts(starts, packed)? };
        let found = coherence(&graph);
        let ids = |list: Vec<u32>| list.into_iter().map(CellId::from_u32).collect();
        Ok(CellCoherence {
            crowded_facet: found.crowded_wall.map(CellId::new),
            conflicts: ids(found.conflicts),
            signs: found.signs,
            odd_chain: found
                .odd_cycle
                .map(|(cells, facets)| OddCellChain { cells: ids(cells), facets: ids(facets) }),
        })
    }

    /// The cells turned so that all agree across the facets that two of them share; the first cell of each part that
    /// hangs together so keeps its signs.
    ///
    /// # Errors
    /// [`ErrorKind::NonManifold`] naming a closed chain of cells that cannot agree.
    pub fn coherent(self) -> Result<Self, Error> {
        let found = self.coherence()?;
        if let Some(chain) = &found.odd_chain {
            let mut names: Vec<String> = chain.cells.iter().take(16).map(ToString::to_string).collect();
            if chain.cells.len() > names.len() {
                names.push(format!("and {} more", chain.cells.len() - names.len()));
            }
            return Err(Error::new(
                ErrorKind::NonManifold,
                format!("the cells {} are a closed chain that cannot agree", names.join(", ")),
            )
            .with_cure("keep each cell as its lowest facet orients it"));
        }
        Ok(self.turned(&found.signs))
    }
}
