//! Congruence of cells of one degree.

use super::classes::NONE;
use super::mapped::Mapped;
use super::{CellClasses, CongruenceMethod};
use crate::algebra::{Sign, SparseMatrix};
use crate::{Error, ErrorKind};

/// The quotient of one boundary matrix.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CellCongruence {
    boundary: SparseMatrix,
    classes: CellClasses,
    changed: Vec<u32>,
}

impl CellCongruence {
    /// The boundary matrix of the classes: column j is the boundary of the lowest member of class j, in classes.
    pub fn boundary(&self) -> &SparseMatrix {
        &self.boundary
    }

    /// The classes of the cells.
    pub fn classes(&self) -> &CellClasses {
        &self.classes
    }

    /// The cells that have a class, but whose boundary lost terms: facets collapsed or came together. What such a cell looks
    /// like has changed; it may be pinched. Rising.
    pub fn changed(&self) -> &[u32] {
        &self.changed
    }

    /// The boundary and the classes by themselves.
    pub fn into_parts(self) -> (SparseMatrix, CellClasses) {
        (self.boundary, self.classes)
    }
}

/// The classes of the cells of one degree, given the classes of the cells below, and the boundary matrix of the classes.
///
/// The boundary of each cell is written in the classes below, with their signs; what cancels is gone. A cell without a
/// boundary then is **collapsed**, unless it had none before: such a cell is a class by itself. Cells with the same
/// boundary up to sign are congruent.
///
/// # Errors
/// [`ErrorKind::Shape`] unless there is a class, or none, for each row of the boundary matrix; [`ErrorKind::TooLarge`] for a
/// coefficient beyond 32 bits.
///
/// # Complexity
/// Near-linear in the entries of the boundary matrix.
///
/// # Examples
/// Two edges between the same two points, one each way: one class, the second with the sign minus.
/// ```
/// use coface::CellId;
/// use coface::algebra::{Sign, SparseMatrix};
/// use coface::arrangement::congruence::{CellClasses, CongruenceMethod, cell_congruence};
/// # fn main() -> Result<(), coface::Error> {
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
    let mapped = match method {
        CongruenceMethod::Lists => Mapped::by_lists(boundary, lower)?,
        CongruenceMethod::Matrices => Mapped::by_matrices(boundary, lower)?,
    };
    compared(&mapped, boundary, lower, method)
}

/// Classes of cells whose boundaries are written in classes.
fn compared(
    mapped: &Mapped,
    boundary: &SparseMatrix,
    lower: &CellClasses,
    method: CongruenceMethod,
) -> Result<CellCongruence, Error> {
    let lowest = match method {
        CongruenceMethod::Lists => mapped.lowest_by_lists(lower.class_count()),
        CongruenceMethod::Matrices => mapped.lowest_by_map(),
    };
    let is_open = |cell: usize| boundary.column(cell).rows().is_empty();
    let mut class_of = vec![NONE; lowest.len()];
    let mut signs = vec![Sign::Plus; lowest.len()];
    let (mut starts, mut rows, mut entries) = (vec![0u32], Vec::new(), Vec::new());
    for (cell, &first) in lowest.iter().enumerate() {
        let (own_rows, own_entries) = mapped.column(cell);
        // What has no boundary now had none before, or is collapsed.
        if own_rows.is_empty() && !is_open(cell) {
            continue;
        }
        if first as usize == cell {
            class_of[cell] = starts.len() as u32 - 1;
            rows.extend_from_slice(own_rows);
            entries.extend_from_slice(own_entries);
            starts.push(rows.len() as u32);
        } else {
            class_of[cell] = class_of[first as usize];
            signs[cell] = mapped.sign(cell).times(mapped.sign(first as usize));
        }
    }
    let has_changed = |&cell: &u32| {
        let (left, whole) = (mapped.column(cell as usize).0, boundary.column(cell as usize).rows());
        left.len() < whole.len() && !left.is_empty()
    };
    let changed = (0..lowest.len() as u32).filter(has_changed).collect();
    let class_count = starts.len() - 1;
    let boundary = SparseMatrix::from_trusted_parts(lower.class_count(), starts, rows, entries)?;
    Ok(CellCongruence { boundary, classes: CellClasses::single(class_count, class_of, signs), changed })
}
