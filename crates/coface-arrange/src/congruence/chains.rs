//! Congruence of whole chain complexes.

use super::cells::quotient;
use super::discards::discard;
use super::mapped::Mapped;
use super::rewrap::Rewrapping;
use super::{CellClasses, CellCongruence, Collisions, CongruenceOptions, Discard};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, ErrorKind};
use coface_geometry::Positions;

/// The quotient of a chain complex by the congruence of its vertices.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ChainCongruence {
    complex: ChainComplex,
    classes: Vec<CellClasses>,
    changed: Vec<Vec<u32>>,
    /// For each degree the cells whose classes had too few facets.
    too_small: Vec<Vec<u32>>,
}

impl ChainCongruence {
    /// The complex of the classes.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::congruence::{CellClasses, chain_congruence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two edges in a row; the second one shrinks to a point.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let classes = CellClasses::unsigned(vec![0, 1, 1])?;
    /// let merged = chain_congruence(&path, classes, None, Default::default())?;
    /// assert_eq!(merged.complex().f_vector(), [2, 1]);
    /// # Ok(()) }
    /// ```
    pub fn complex(&self) -> &ChainComplex {
        &self.complex
    }

    /// The classes of the cells of each degree.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::congruence::{CellClasses, chain_congruence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two edges in a row; the second one shrinks to a point.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let classes = CellClasses::unsigned(vec![0, 1, 1])?;
    /// let merged = chain_congruence(&path, classes, None, Default::default())?;
    /// assert_eq!(merged.classes()[0].members().list(1), [1, 2]);
    /// # Ok(()) }
    /// ```
    pub fn classes(&self) -> &[CellClasses] {
        &self.classes
    }

    /// For each degree the cells that keep a boundary but lost terms of it, were split, or have a facet that was; see
    /// [`CellCongruence::changed`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::congruence::{CellClasses, chain_congruence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two edges in a row; the second one shrinks to a point.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let classes = CellClasses::unsigned(vec![0, 1, 1])?;
    /// let merged = chain_congruence(&path, classes, None, Default::default())?;
    /// // An edge that collapses is not changed: it is gone.
    /// assert!(merged.changed().iter().all(Vec::is_empty));
    /// # Ok(()) }
    /// ```
    pub fn changed(&self) -> &[Vec<u32>] {
        &self.changed
    }

    /// The cells of a degree without a class, rising, and why.
    ///
    /// # Panics
    /// If the complex has no such degree.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::congruence::{CellClasses, Discard, chain_congruence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two edges in a row; the second one shrinks to a point.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let classes = CellClasses::unsigned(vec![0, 1, 1])?;
    /// let merged = chain_congruence(&path, classes, None, Default::default())?;
    /// assert!(merged.discards(1).eq([(CellId::new(1), Discard::Collapsed)]));
    /// # Ok(()) }
    /// ```
    pub fn discards(&self, degree: usize) -> impl Iterator<Item = (CellId, Discard)> + '_ {
        let (classes, too_small) = (&self.classes[degree], &self.too_small[degree]);
        let cells = (0..classes.cell_count()).map(CellId::new);
        cells.filter(|&cell| classes.image(cell).len() == 0).map(|cell| {
            let is_small = too_small.binary_search(&(cell.index() as u32)).is_ok();
            (cell, if is_small { Discard::TooFewFacets } else { Discard::Collapsed })
        })
    }

    /// For each degree the number of cells without a class, whatever the reason.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_arrange::congruence::{CellClasses, chain_congruence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two edges in a row; the second one shrinks to a point.
    /// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
    /// let path = ChainComplex::new(vec![edges])?;
    /// let classes = CellClasses::unsigned(vec![0, 1, 1])?;
    /// let merged = chain_congruence(&path, classes, None, Default::default())?;
    /// assert_eq!(merged.collapsed_counts(), [0, 1]);
    /// # Ok(()) }
    /// ```
    pub fn collapsed_counts(&self) -> Vec<usize> {
        self.classes.iter().map(CellClasses::collapsed_count).collect()
    }
}

/// The quotient of a complex by classes of its vertices: the classes of cells degree by degree, from below.
///
/// The map from cells to classes with their signs, collapsed cells going to zero, is a chain map; so the boundary of a
/// boundary is zero in the quotient whatever the classes are.
///
/// `positions` are those of the classes of vertices.
///
/// # Errors
/// [`ErrorKind::Shape`] unless each vertex has a class, and each class of vertices a position if there are positions;
/// those of [`super::cell_congruence`]; with [`Collisions::Refuse`] [`ErrorKind::InvalidInput`] naming the first cell,
/// of the lowest degree, that collapsed or whose boundary lost terms.
///
/// # Complexity
/// Near-linear in the entries of the boundary matrices.
///
/// # Examples
/// Two triangles, each with its own three vertices and edges, that share an edge in space: four vertices, five edges
/// and two triangles remain.
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_arrange::congruence::{CellClasses, CongruenceOptions, chain_congruence};
/// use coface_complexes::surface::PolygonMesh;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let triangles = PolygonMesh::new(6, RaggedArray::from_lists([[0, 1, 2], [3, 4, 5]]), &[])?.chain_complex()?;
/// let vertices = CellClasses::unsigned(vec![0, 1, 2, 1, 0, 3])?;
/// let merged = chain_congruence(&triangles, vertices, None, CongruenceOptions::default())?;
/// assert_eq!(merged.complex().f_vector(), [4, 5, 2]);
/// # Ok(()) }
/// ```
pub fn chain_congruence(
    complex: &ChainComplex,
    vertices: CellClasses,
    positions: Option<&Positions>,
    options: CongruenceOptions,
) -> Result<ChainCongruence, Error> {
    if vertices.cell_count() != complex.cell_count(0) {
        return Err(Error::new(
            ErrorKind::Shape,
            format!("{} classes of vertices for {} vertices", vertices.cell_count(), complex.cell_count(0)),
        ));
    }
    let vertex_count = vertices.class_count();
    if let Some(positions) = positions.filter(|positions| positions.len() != vertex_count) {
        return Err(Error::new(
            ErrorKind::Shape,
            format!("{} positions for {vertex_count} classes of vertices", positions.len()),
        )
        .with_cure("give the positions of the classes, not those of the vertices"));
    }
    let (mut boundaries, mut classes, mut changed) = (Vec::new(), vec![vertices], vec![Vec::new()]);
    for (degree, matrix) in (1..).zip(complex.boundary_matrices()) {
        let lower = classes.last().expect("there are the classes of the vertices");
        let pieces = |mapped: &Mapped| {
            if options.collisions != Collisions::Rewrap || degree == 1 {
                return Vec::new();
            }
            let before = &complex.boundary_matrices()[..degree];
            Rewrapping { before, classes: &classes, boundaries: &boundaries, positions }.pieces(mapped)
        };
        let found = quotient(matrix, lower, options.method, pieces)?;
        if options.collisions == Collisions::Refuse {
            refuse(degree, &found)?;
        }
        changed.push(found.changed().to_vec());
        let (boundary, own) = found.into_parts();
        boundaries.push(boundary);
        classes.push(own);
    }
    let too_small = match options.collisions {
        Collisions::Rewrap => discard(&mut boundaries, &mut classes, &changed)?,
        _ => vec![Vec::new(); classes.len()],
    };
    let complex = if boundaries.is_empty() {
        ChainComplex::of_points(vertex_count)
    } else {
        ChainComplex::new(boundaries)?
    };
    Ok(ChainCongruence { complex, classes, changed, too_small })
}

/// An error for the first cell that lost its shape.
fn refuse(degree: usize, found: &CellCongruence) -> Result<(), Error> {
    let collapsed = (0..found.classes().cell_count())
        .find(|&cell| found.classes().image(CellId::new(cell)).len() == 0)
        .map(|cell| (cell, "collapses: what bounds it cancels"));
    let changed = found.changed().first().map(|&cell| (cell as usize, "loses facets of its boundary"));
    match [collapsed, changed].into_iter().flatten().min() {
        None => Ok(()),
        Some((cell, fault)) => Err(Error::invalid(format!("cell {cell} of degree {degree} {fault}"))
            .with_cure("choose a smaller --tolerance, keep such cells as chains by --collisions keep, or cut them by --collisions rewrap")),
    }
}
