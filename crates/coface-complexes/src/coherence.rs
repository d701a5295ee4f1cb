//! Whether top cells agree, and whether they can be turned so that they do: one answer for faces, cells and facets.

use coface_algebra::{CellId, Id, Sign};

/// How the top cells of a complex are oriented and whether they can be oriented coherently.
///
/// Two cells on a common facet agree when their boundaries run through it in opposite directions. The question is decided
/// across the facets with exactly two cells; with a facet in three or more cells it has no answer. It is the one result for
/// faces of surfaces, cells of meshes and of LAR models, facets of simplicial complexes and simplices of gluing tables.
///
/// # Examples
/// Two triangles that run through their common edge in the same direction:
/// ```
/// use coface_algebra::{FaceId, RaggedArray, Sign};
/// use coface_complexes::surface::PolygonMesh;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangles = RaggedArray::from_lists([[0, 1, 2], [1, 2, 3]]);
/// let found = PolygonMesh::new(4, triangles, &[])?.orientation();
/// assert_eq!((found.is_coherent(), found.is_orientable()), (Some(false), Some(true)));
/// assert_eq!(found.conflicts().len(), 1);
/// assert_eq!(found.sign(FaceId::new(1)), Sign::Minus);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Coherence<Cell, Facet> {
    pub(crate) obstruction: Option<Obstruction<Cell, Facet>>,
    pub(crate) conflicts: Vec<Facet>,
    /// The sign of each cell that makes all agree; empty when all are plus, and when there is none.
    pub(crate) signs: Vec<Sign>,
    pub(crate) odd_cycle: Option<OddCycle<Cell, Facet>>,
}

/// Why the top cells of a complex have no orientation to ask for.
///
/// # Examples
/// A book of three pages:
/// ```
/// use coface_algebra::CellId;
/// use coface_complexes::{Obstruction, known_spaces};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let found = known_spaces::book(3)?.orientability()?;
/// let (facet, cells) = (CellId::new(0), [0, 1, 2].map(CellId::new).to_vec());
/// assert_eq!(found.obstruction(), Some(&Obstruction::CrowdedFacet { facet, cells }));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Obstruction<Cell, Facet> {
    /// This facet lies in three top cells or more.
    CrowdedFacet {
        /// The facet.
        facet: Facet,
        /// All top cells that contain it, rising.
        cells: Vec<Cell>,
    },
    /// This cell is maximal but not of the top dimension.
    NotPure {
        /// The dimension of the cell.
        dimension: usize,
        /// The cell.
        cell: CellId,
    },
    /// The top cells have no facets, for the complex is empty or of dimension 0.
    NoFacets,
}

/// A closed chain of top cells that cannot all agree: in a surface a Moebius band, possibly meeting itself in vertices.
///
/// Cell i and cell i + 1 share facet i; the last and the first share the last facet. The cells are distinct, and so are
/// the facets. However the cells are turned, an odd number of these facets is run through twice in the same direction.
///
/// # Examples
/// The Moebius band of five triangles:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_complexes::surface::PolygonMesh;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangles = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]];
/// let found = PolygonMesh::new(5, RaggedArray::from_lists(triangles), &[])?.orientation();
/// let cycle = found.odd_cycle().expect("a Moebius band is not orientable");
/// assert_eq!((cycle.cells().len(), cycle.facets().len()), (5, 5));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct OddCycle<Cell, Facet> {
    pub(crate) cells: Vec<Cell>,
    pub(crate) facets: Vec<Facet>,
}

impl<Cell, Facet> OddCycle<Cell, Facet> {
    /// The cells in order.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangles = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]];
    /// let found = PolygonMesh::new(5, RaggedArray::from_lists(triangles), &[])?.orientation();
    /// assert_eq!(found.odd_cycle().map(|cycle| cycle.cells().len()), Some(5));
    /// # Ok(()) }
    /// ```
    pub fn cells(&self) -> &[Cell] {
        &self.cells
    }

    /// The facets in order: facet i is shared by cell i and the next.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangles = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]];
    /// let found = PolygonMesh::new(5, RaggedArray::from_lists(triangles), &[])?.orientation();
    /// assert_eq!(found.odd_cycle().map(|cycle| cycle.facets().len()), Some(5));
    /// # Ok(()) }
    /// ```
    pub fn facets(&self) -> &[Facet] {
        &self.facets
    }
}

impl<Cell: Id, Facet: Copy> Coherence<Cell, Facet> {
    /// Whether the cells can be turned so that all agree; `None` with an [`Obstruction`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangles = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]];
    /// let found = PolygonMesh::new(5, RaggedArray::from_lists(triangles), &[])?.orientation();
    /// assert_eq!(found.is_orientable(), Some(false));
    /// # Ok(()) }
    /// ```
    pub fn is_orientable(&self) -> Option<bool> {
        self.obstruction.is_none().then_some(self.odd_cycle.is_none())
    }

    /// Whether all cells agree as they are listed; `None` with an [`Obstruction`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangles = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]];
    /// let found = PolygonMesh::new(5, RaggedArray::from_lists(triangles), &[])?.orientation();
    /// assert_eq!(found.is_coherent(), Some(false));
    /// # Ok(()) }
    /// ```
    pub fn is_coherent(&self) -> Option<bool> {
        self.obstruction.is_none().then_some(self.conflicts.is_empty())
    }

    /// The first facet in three or more cells, for which the questions have no answer.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangles = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]];
    /// let found = PolygonMesh::new(5, RaggedArray::from_lists(triangles), &[])?.orientation();
    /// assert_eq!(found.crowded_facet(), None);
    /// # Ok(()) }
    /// ```
    pub fn crowded_facet(&self) -> Option<Facet> {
        match self.obstruction {
            Some(Obstruction::CrowdedFacet { facet, .. }) => Some(facet),
            _ => None,
        }
    }

    /// Why the questions have no answer, where they have none.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::Obstruction;
    /// use coface_complexes::simplicial::SimplicialComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = SimplicialComplex::from_facets([[0], [1]])?;
    /// assert_eq!(points.orientability()?.obstruction(), Some(&Obstruction::NoFacets));
    /// # Ok(()) }
    /// ```
    pub fn obstruction(&self) -> Option<&Obstruction<Cell, Facet>> {
        self.obstruction.as_ref()
    }

    /// The facets with exactly two cells that run through it in the same direction, rising.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangles = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]];
    /// let found = PolygonMesh::new(5, RaggedArray::from_lists(triangles), &[])?.orientation();
    /// assert!(!found.conflicts().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn conflicts(&self) -> &[Facet] {
        &self.conflicts
    }

    /// Why there is no coherent orientation.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::surface::PolygonMesh;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let triangles = [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]];
    /// let found = PolygonMesh::new(5, RaggedArray::from_lists(triangles), &[])?.orientation();
    /// assert!(found.odd_cycle().is_some());
    /// # Ok(()) }
    /// ```
    pub fn odd_cycle(&self) -> Option<&OddCycle<Cell, Facet>> {
        self.odd_cycle.as_ref()
    }

    /// The sign of a cell: minus if it must be turned for a coherent orientation in which the first cell of each strongly
    /// connected part stays. Plus when there is no coherent orientation.
    pub fn sign(&self, cell: Cell) -> Sign {
        self.signs.get(cell.index()).copied().unwrap_or(Sign::Plus)
    }
}
