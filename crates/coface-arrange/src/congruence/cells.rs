//! Congruence of cells of one degree.

use super::classes::NONE;
use super::mapped::{Mapped, Piece};
use super::{CellClasses, CongruenceMethod};
use coface_algebra::{Error, ErrorKind};
use coface_algebra::{Sign, SparseMatrix};

/// The quotient of one boundary matrix.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CellCongruence {
    boundary: SparseMatrix,
    classes: CellClasses,
    changed: Vec<u32>,
}

impl CellCongruence {
    /// The boundary matrix of the classes: column j is the boundary of the lowest member of class j, or of its piece,
    /// in classes.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_arrange::congruence::{CellClasses, cell_congruence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two edges between the same two points, one each way.
    /// let edges = SparseMatrix::from_entries(4, 2, [(0, 0, -1), (1, 0, 1), (2, 1, 1), (3, 1, -1)])?;
    /// let vertices = CellClasses::unsigned(vec![0, 1, 0, 1])?;
    /// let merged = cell_congruence(&edges, &vertices, Default::default())?;
    /// assert_eq!(merged.boundary().column(0).entries(), [-1, 1]);
    /// # Ok(()) }
    /// ```
    pub fn boundary(&self) -> &SparseMatrix {
        &self.boundary
    }

    /// The classes of the cells.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, Sign, SparseMatrix};
    /// use coface_arrange::congruence::{CellClasses, cell_congruence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two edges between the same two points, one each way.
    /// let edges = SparseMatrix::from_entries(4, 2, [(0, 0, -1), (1, 0, 1), (2, 1, 1), (3, 1, -1)])?;
    /// let vertices = CellClasses::unsigned(vec![0, 1, 0, 1])?;
    /// let merged = cell_congruence(&edges, &vertices, Default::default())?;
    /// assert_eq!(merged.classes().class(CellId::new(1)), Some((0, Sign::Minus)));
    /// # Ok(()) }
    /// ```
    pub fn classes(&self) -> &CellClasses {
        &self.classes
    }

    /// The cells that have a class, but whose boundary lost terms: facets collapsed or came together. What such a cell
    /// looks like has changed; it may be pinched. With those that were split into pieces, or have a facet that was.
    /// Rising.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_arrange::congruence::{CellClasses, cell_congruence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two edges between the same two points, one each way.
    /// let edges = SparseMatrix::from_entries(4, 2, [(0, 0, -1), (1, 0, 1), (2, 1, 1), (3, 1, -1)])?;
    /// let vertices = CellClasses::unsigned(vec![0, 1, 0, 1])?;
    /// let merged = cell_congruence(&edges, &vertices, Default::default())?;
    /// assert!(merged.changed().is_empty());
    /// # Ok(()) }
    /// ```
    pub fn changed(&self) -> &[u32] {
        &self.changed
    }

    /// The boundary and the classes by themselves.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_arrange::congruence::{CellClasses, cell_congruence};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // Two edges between the same two points, one each way.
    /// let edges = SparseMatrix::from_entries(4, 2, [(0, 0, -1), (1, 0, 1), (2, 1, 1), (3, 1, -1)])?;
    /// let vertices = CellClasses::unsigned(vec![0, 1, 0, 1])?;
    /// let merged = cell_congruence(&edges, &vertices, Default::default())?;
    /// let (boundary, classes) = merged.into_parts();
    /// assert_eq!((boundary.column_count(), classes.class_count()), (1, 1));
    /// # Ok(()) }
    /// ```
    pub fn into_parts(self) -> (SparseMatrix, CellClasses) {
        (self.boundary, self.classes)
    }
}

/// The classes of the cells of one degree, given the classes of the cells below, and the boundary matrix of the
/// classes.
///
/// The boundary of each cell is written in the classes below, with their signs; what cancels is gone. A cell without a
/// boundary then is **collapsed**, unless it had none before: such a cell is a class by itself. Cells with the same
/// boundary up to sign are congruent.
///
/// # Errors
/// [`ErrorKind::Shape`] unless there is a class, or none, for each row of the boundary matrix; [`ErrorKind::TooLarge`]
/// for a coefficient beyond 32 bits.
///
/// # Complexity
/// Near-linear in the entries of the boundary matrix.
///
/// # Examples
/// Two edges between the same two points, one each way: one class, the second with the sign minus.
/// ```
/// use coface_algebra::CellId;
/// use coface_algebra::{Sign, SparseMatrix};
/// use coface_arrange::congruence::{CellClasses, CongruenceMethod, cell_congruence};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edges = SparseMatrix::from_entries(4, 2, [(0, 0, -1), (1, 0, 1), (2, 1, 1), (3, 1, -1)])?;
/// let vertices = CellClasses::unsigned(vec![0, 1, 0, 1])?;
/// let merged = cell_congruence(&edges, &vertices, CongruenceMethod::Lists)?;
/// assert_eq!(merged.boundary().column(0).entries(), [-1, 1]);
/// assert_eq!(merged.classes().class(CellId::new(1)), Some((0, Sign::Minus)));
/// # Ok(()) }
/// ```
pub fn cell_congruence(
    boundary: &SparseMatrix,
    lower: &CellClasses,
    method: CongruenceMethod,
) -> Result<CellCongruence, Error> {
    if lower.cell_count() != boundary.row_count() {
        return Err(Error::new(
            ErrorKind::Shape,
            format!(
                "{} cells have classes, but the boundary matrix has {} rows",
                lower.cell_count(),
                boundary.row_count()
            ),
        ));
    }
    quotient(boundary, lower, method, |_| Vec::new())
}

/// The classes of cells, after some of them were split into pieces.
pub(super) fn quotient(
    boundary: &SparseMatrix,
    lower: &CellClasses,
    method: CongruenceMethod,
    pieces: impl FnOnce(&Mapped) -> Vec<(u32, Vec<Piece>)>,
) -> Result<CellCongruence, Error> {
    let mut mapped = match method {
        CongruenceMethod::Lists => Mapped::by_lists(boundary, lower)?,
        CongruenceMethod::Matrices => Mapped::by_matrices(boundary, lower)?,
    };
    let split = pieces(&mapped);
    let changed = changed_cells(boundary, lower, &mapped, &split);
    mapped.split(&split)?;
    let lowest = match method {
        CongruenceMethod::Lists => mapped.lowest_by_lists(lower.class_count()),
        CongruenceMethod::Matrices => mapped.lowest_by_map(),
    };
    let is_open = |cell: usize| boundary.column(cell).rows().is_empty();
    let mut class_of = vec![NONE; lowest.len()];
    let mut signs = vec![Sign::Plus; lowest.len()];
    // The first column of each class.
    let mut firsts: Vec<u32> = Vec::new();
    for (column, &first) in lowest.iter().enumerate() {
        // What has no boundary now had none before, or is collapsed.
        if mapped.column(column).0.is_empty() && !is_open(mapped.owner(column)) {
            continue;
        }
        if first as usize == column {
            class_of[column] = firsts.len() as u32;
            firsts.push(first);
        } else {
            class_of[column] = class_of[first as usize];
            signs[column] = mapped.sign(column).times(mapped.sign(first as usize));
        }
    }
    let classes = match mapped.owners() {
        [] => CellClasses::single(firsts.len(), class_of, signs),
        owners => CellClasses::of_columns(firsts.len(), boundary.column_count(), owners, &class_of, &signs),
    };
    let boundary = mapped.selected(lower.class_count(), &firsts)?;
    Ok(CellCongruence { boundary, classes, changed })
}

/// The cells that keep a boundary, but lost terms of it or came to be several.
fn changed_cells(
    boundary: &SparseMatrix,
    lower: &CellClasses,
    mapped: &Mapped,
    split: &[(u32, Vec<Piece>)],
) -> Vec<u32> {
    let mut split = split.iter().map(|&(cell, _)| cell).peekable();
    let has_changed = |&cell: &u32| {
        let (left, whole) = (mapped.column(cell as usize).0, boundary.column(cell as usize).rows());
        let is_split = split.next_if(|&split| split == cell).is_some();
        let has_facets_of_several = || {
            lower.as_single().is_none()
                && whole.iter().any(|&facet| lower.image_lists(facet as usize).0.len() != 1)
        };
        !left.is_empty() && (is_split || left.len() < whole.len() || has_facets_of_several())
    };
    (0..boundary.column_count() as u32).filter(has_changed).collect()
}
