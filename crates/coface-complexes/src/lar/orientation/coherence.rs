//! Do cells agree across their facets, and can they be turned to?

use super::OrientedCells;
use crate::coherence::Coherence;
use crate::surface::dual_graph::DualGraph;
use crate::surface::dual_graph::coherence;
use coface_algebra::{CellId, Error, ErrorKind};
use coface_algebra::{RaggedArray, SparseMatrix};

/// Whether the cells of one degree agree, and whether they can be turned so that all do, across the facets with two cells.
pub type CellCoherence = Coherence<CellId, CellId>;

/// Cells as nodes, with their facets.
struct CellGraph<'a> {
    boundary: &'a SparseMatrix,
    /// For each facet its cells, each as `2 * cell + reversed`.
    cells_at: RaggedArray,
}

impl DualGraph for CellGraph<'_> {
    fn node_count(&self) -> usize {
        self.boundary.column_count()
    }

    fn facet_count(&self) -> usize {
        self.cells_at.len()
    }

    fn facets_of(&self, cell: u32) -> impl Iterator<Item = u32> {
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
        Ok(coherence(&graph))
    }

    /// The cells turned so that all agree across the facets that two of them share; the first cell of each part that
    /// is connected in this way keeps its signs.
    ///
    /// # Errors
    /// [`ErrorKind::NonManifold`] naming a closed chain of cells that cannot agree.
    pub fn coherent(self) -> Result<Self, Error> {
        let found = self.coherence()?;
        if let Some(chain) = &found.odd_cycle {
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
