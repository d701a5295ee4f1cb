//! Connected components: one result for meshes, complexes and gluing tables.

use coface_algebra::progress::stage_of_many;
use coface_algebra::{Id, UnionFind, VertexId};

/// The connected components of a complex, by its vertices or, for a gluing table, by its simplices.
///
/// Components are numbered in the order of their first cells; an isolated vertex is a component.
///
/// # Examples
/// ```
/// use coface_algebra::VertexId;
/// use coface_complexes::simplicial::SimplicialComplex;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let complex = SimplicialComplex::from_facets([vec![0, 4], vec![1], vec![2, 3, 4]])?;
/// let components = complex.components();
/// assert_eq!(components.count(), 2);
/// assert_eq!(components.members(), [[0, 2, 3, 4].map(VertexId::new).to_vec(), vec![VertexId::new(1)]]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Components<Cell = VertexId> {
    count: usize,
    numbers: Vec<u32>,
    /// The cells in rising order; `None` where they are 0, 1, ... without gaps.
    cells: Option<Vec<Cell>>,
}

impl<Cell: Id> Components<Cell> {
    /// The components of a graph on the nodes 0, 1, ... with these edges, two ends by two.
    pub(crate) fn of_graph(node_count: usize, ends: &[u32]) -> Self {
        let mut partition = UnionFind::new(node_count);
        let steps = stage_of_many("joining components", ends.len() / 2);
        for &[a, b] in steps.each(ends.as_chunks::<2>().0) {
            partition.unite(a, b);
            if partition.class_count() == 1 {
                break;
            }
        }
        Self::of_partition(partition)
    }

    /// The classes of the cells 0, 1, ...
    pub(crate) fn of_partition(mut partition: UnionFind) -> Self {
        let count = partition.class_count();
        let numbers = if count == 1 { vec![0; partition.len()] } else { partition.class_numbers() };
        Self { count, numbers, cells: None }
    }

    /// The classes of cells with gaps in their numbers, which rise: the partition is of their places.
    pub(crate) fn of_cells(cells: Vec<Cell>, partition: UnionFind) -> Self {
        let is_dense = cells.last().is_none_or(|last| last.index() + 1 == cells.len());
        Self { cells: (!is_dense).then_some(cells), ..Self::of_partition(partition) }
    }

    /// The number of components.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mesh = PolygonMesh::new(6, RaggedArray::from_lists([[0, 1, 2]]), &[[4, 5]])?;
    /// assert_eq!(mesh.components().count(), 3);
    /// # Ok(()) }
    /// ```
    pub fn count(&self) -> usize {
        self.count
    }

    /// The number of the component a cell is in.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{RaggedArray, VertexId};
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mesh = PolygonMesh::new(6, RaggedArray::from_lists([[0, 1, 2]]), &[[4, 5]])?;
    /// assert_eq!(mesh.components().of(VertexId::new(5)), 2);
    /// # Ok(()) }
    /// ```
    pub fn of(&self, cell: Cell) -> usize {
        let place = match &self.cells {
            None => cell.index(),
            Some(cells) => cells.binary_search(&cell).expect("the cell is one of the complex"),
        };
        self.numbers[place] as usize
    }

    /// The number of the component of each cell, in the order of the cells.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut table = GluingTable::unglued(1, 3)?;
    /// table.glue(0, 0, 2, &[1, 0])?;
    /// assert_eq!(table.components().numbers(), [0, 1, 0]);
    /// # Ok(()) }
    /// ```
    pub fn numbers(&self) -> &[u32] {
        &self.numbers
    }

    /// The cells of each component, rising.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let mut table = GluingTable::unglued(1, 3)?;
    /// table.glue(0, 0, 2, &[1, 0])?;
    /// assert_eq!(table.components().members(), [vec![CellId::new(0), CellId::new(2)], vec![CellId::new(1)]]);
    /// # Ok(()) }
    /// ```
    pub fn members(&self) -> Vec<Vec<Cell>> {
        let mut members = vec![Vec::new(); self.count];
        for (place, &number) in self.numbers.iter().enumerate() {
            let cell = self.cells.as_ref().map_or_else(|| Cell::new(place), |cells| cells[place]);
            members[number as usize].push(cell);
        }
        members
    }
}
