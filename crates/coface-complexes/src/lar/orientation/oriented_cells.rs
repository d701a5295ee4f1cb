//! Cells with signs of their facets, component by component.

use coface_algebra::{CellId, Error};
use coface_algebra::{Sign, SparseMatrix};

/// The cells of one degree with the signs of their facets, and the components of their boundaries.
///
/// The facets of each component have signs up to a common one; [`Self::boundary`] has a choice of it.
/// [`oriented_boundary`](super::oriented_boundary) makes them with the lowest facet of each component positive.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OrientedCells {
    boundary: SparseMatrix,
    /// The number of the component within its cell for each entry of the boundary, counted from 0 in the order of
    /// lowest facets; empty when no cell has more than one.
    components: Vec<u32>,
}

impl OrientedCells {
    /// Cells with these boundaries and the number of the component of each entry, or nothing if all are connected.
    pub(super) fn from_parts(boundary: SparseMatrix, components: Vec<u32>) -> Self {
        Self { boundary, components }
    }

    /// Cells whose boundaries are connected.
    pub(crate) fn connected(boundary: SparseMatrix) -> Self {
        Self { boundary, components: Vec::new() }
    }

    /// The boundary matrix: rows are facets, columns cells.
    pub fn boundary(&self) -> &SparseMatrix {
        &self.boundary
    }

    /// The boundary matrix, given away.
    pub fn into_boundary(self) -> SparseMatrix {
        self.boundary
    }

    /// The number of cells.
    pub fn cell_count(&self) -> usize {
        self.boundary.column_count()
    }

    /// The components of the boundary of a cell in the order of their lowest facets, each with its facets, rising, and their
    /// signs.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// A face with a triangle around it and one inside:
    /// ```
    /// use coface_algebra::{RaggedArray, Sign, SparseMatrix};
    /// use coface_complexes::lar::oriented_boundary;
    /// use coface_algebra::CellId;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let ends = [(0, 1), (1, 2), (0, 2), (3, 4), (4, 5), (3, 5)];
    /// let entries = ends.iter().enumerate().flat_map(|(j, &(a, b))| [(a, j, -1), (b, j, 1)]);
    /// let edges = SparseMatrix::from_entries(6, 6, entries)?;
    /// let face = oriented_boundary(&edges, &RaggedArray::from_lists([[0, 1, 2, 3, 4, 5]]))?;
    /// let components = face.boundary_components(CellId::new(0));
    /// assert_eq!(components.len(), 2);
    /// assert_eq!(components[1][2], (CellId::new(5), Sign::Minus));
    /// # Ok(()) }
    /// ```
    pub fn boundary_components(&self, cell: CellId) -> Vec<Vec<(CellId, Sign)>> {
        let mut components = vec![Vec::new(); self.component_count(cell.index())];
        let column = self.boundary.column(cell.index());
        for (at, (facet, entry)) in column.iter().enumerate() {
            let sign = if entry > 0 { Sign::Plus } else { Sign::Minus };
            components[self.component(cell.index(), at) as usize].push((CellId::new(facet), sign));
        }
        components
    }

    /// The component of the entry at this place in the column of a cell.
    pub(super) fn component(&self, cell: usize, at: usize) -> u32 {
        let start = self.boundary.column_starts()[cell] as usize;
        self.components.get(start + at).copied().unwrap_or(0)
    }

    /// The number of components of the boundary of the cell at this position.
    pub(super) fn component_count(&self, cell: usize) -> usize {
        let starts = self.boundary.column_starts();
        let range = starts[cell] as usize..starts[cell + 1] as usize;
        if self.components.is_empty() {
            return usize::from(!range.is_empty());
        }
        self.components[range].iter().max().map_or(0, |&last| last as usize + 1)
    }

    /// The first cell whose boundary has several components.
    ///
    /// Combinatorics do not relate their signs: a hole of a face runs opposite to its rim, and only positions tell which is
    /// which.
    pub fn first_disconnected(&self) -> Option<CellId> {
        if self.components.is_empty() {
            return None;
        }
        (0..self.cell_count()).find(|&cell| self.component_count(cell) > 1).map(CellId::new)
    }

    /// The same cells, those of minus sign turned around. `signs` has one for each cell, or is empty for all plus.
    pub(super) fn turned(self, signs: &[Sign]) -> Self {
        if signs.iter().all(|&sign| sign == Sign::Plus) {
            return self;
        }
        let starts = self.boundary.column_starts();
        let mut entries = self.boundary.entries().to_vec();
        for (cell, _) in signs.iter().enumerate().filter(|&(_, &sign)| sign == Sign::Minus) {
            for entry in &mut entries[starts[cell] as usize..starts[cell + 1] as usize] {
                *entry = -*entry;
            }
        }
        self.with_entries(entries)
    }

    /// The same facets with these entries, which are not zero.
    pub(super) fn with_entries(self, entries: Vec<i32>) -> Self {
        let Self { boundary, components } = self;
        let boundary = SparseMatrix::from_trusted_parts(
            boundary.row_count(),
            boundary.column_starts().to_vec(),
            boundary.rows().to_vec(),
            entries,
        )
        .expect("a matrix of the same shape has been stored");
        Self { boundary, components }
    }

    /// The cells and one more, the exterior, whose boundary is minus the sum of all others: then the rows of the boundary
    /// matrix sum to zero. It is the last cell.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::InvalidInput`] naming the first facet that the cells run through several times in one direction:
    /// the cells do not agree there, or more than two lie at it.
    ///
    /// # Examples
    /// A square and what is outside of it:
    /// ```
    /// use coface_algebra::{RaggedArray, SparseMatrix};
    /// use coface_complexes::lar::oriented_boundary;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let ends = [(0, 1), (1, 2), (0, 2)];
    /// let entries = ends.iter().enumerate().flat_map(|(j, &(a, b))| [(a, j, -1), (b, j, 1)]);
    /// let edges = SparseMatrix::from_entries(3, 3, entries)?;
    /// let triangle = oriented_boundary(&edges, &RaggedArray::from_lists([[0, 1, 2]]))?;
    /// let plane = triangle.with_exterior()?;
    /// assert_eq!(plane.boundary().column(0).entries(), [1, 1, -1]);
    /// assert_eq!(plane.boundary().column(1).entries(), [-1, -1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn with_exterior(&self) -> Result<Self, Error> {
        let mut sums = vec![0i64; self.boundary.row_count()];
        for column in self.boundary.columns() {
            column.iter().for_each(|(facet, entry)| sums[facet] += i64::from(entry));
        }
        if let Some(facet) = sums.iter().position(|sum| sum.abs() > 1) {
            return Err(Error::invalid(format!(
                "the cells run through facet {facet} {} times in one direction, so there is no exterior cell",
                sums[facet].abs()
            ))
            .with_cure("orient the cells coherently, and see that at most two lie at each facet"));
        }
        let mut starts = self.boundary.column_starts().to_vec();
        let (mut rows, mut entries) = (self.boundary.rows().to_vec(), self.boundary.entries().to_vec());
        for (facet, &sum) in sums.iter().enumerate().filter(|&(_, &sum)| sum != 0) {
            rows.push(facet as u32);
            entries.push(-sum as i32);
        }
        starts.push(u32::try_from(rows.len()).map_err(|_| {
            Error::new(
                coface_algebra::ErrorKind::TooLarge,
                "more than 2^32 - 1 facets of cells; the limit is reached",
            )
        })?);
        let mut components = self.components.clone();
        if !components.is_empty() {
            components.resize(rows.len(), 0);
        }
        let boundary = SparseMatrix::from_trusted_parts(self.boundary.row_count(), starts, rows, entries)?;
        Ok(Self { boundary, components })
    }
}
