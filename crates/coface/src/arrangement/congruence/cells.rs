//! Congruence of cells of one degree.

use super::CongruenceMethod;
use crate::Error;
use crate::algebra::{RaggedArray, Sign, SparseMatrix};
use crate::{CellId, ErrorKind};
use std::collections::BTreeMap;

/// No class.
const NONE: u32 = u32::MAX;

/// Classes of congruent cells of one degree, with signs.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CellClasses {
    members: RaggedArray,
    class_of: Vec<u32>,
    signs: Vec<Sign>,
}

impl CellClasses {
    /// The classes with these numbers, all signs plus: the class of each cell, counted from 0 without gaps in the order of
    /// the lowest members.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming the first cell where the numbers are not in that order.
    ///
    /// # Examples
    /// ```
    /// use coface::arrangement::congruence::CellClasses;
    /// # fn main() -> Result<(), coface::Error> {
    /// let classes = CellClasses::unsigned(vec![0, 1, 0])?;
    /// assert_eq!(classes.members().list(0), [0, 2]);
    /// assert!(CellClasses::unsigned(vec![1, 0]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn unsigned(class_of: Vec<u32>) -> Result<Self, Error> {
        let mut count = 0;
        for (cell, &class) in class_of.iter().enumerate() {
            if class > count {
                return Err(Error::invalid(format!(
                    "cell {cell} is in class {class}, but no cell before it in class {count}"
                ))
                .with_cure("number the classes by their lowest members"));
            }
            count += u32::from(class == count);
        }
        let signs = vec![Sign::Plus; class_of.len()];
        Ok(Self { members: RaggedArray::grouped(count as usize, class_of.iter().copied()), class_of, signs })
    }

    /// The number of classes.
    pub fn class_count(&self) -> usize {
        self.members.len()
    }

    /// The members of each class, rising; classes by their lowest members.
    pub fn members(&self) -> &RaggedArray {
        &self.members
    }

    /// The class of a cell and its sign against the lowest member; `None` for a collapsed cell.
    ///
    /// # Panics
    /// If there is no such cell.
    pub fn class(&self, cell: CellId) -> Option<(usize, Sign)> {
        let class = self.class_of[cell.index()];
        (class != NONE).then_some((class as usize, self.signs[cell.index()]))
    }

    /// The number of cells that collapsed.
    pub fn collapsed_count(&self) -> usize {
        self.class_of.iter().filter(|&&class| class == NONE).count()
    }

    /// The number of cells.
    pub fn cell_count(&self) -> usize {
        self.class_of.len()
    }

    /// The matrix that takes cells to classes: a row for each class, a column for each cell.
    pub fn matrix(&self) -> Result<SparseMatrix, Error> {
        let entries =
            self.class_of.iter().zip(&self.signs).enumerate().filter(|(_, (class, _))| **class != NONE);
        let entries = entries.map(|(cell, (&class, &sign))| (class as usize, cell, i64::from(sign.to_i32())));
        SparseMatrix::from_entries(self.class_count(), self.cell_count(), entries)
    }
}

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

/// Boundaries written in classes, before cells are compared: as many lists as cells.
struct Mapped {
    starts: Vec<u32>,
    rows: Vec<u32>,
    entries: Vec<i32>,
}

impl Mapped {
    fn column(&self, cell: usize) -> (&[u32], &[i32]) {
        let range = self.starts[cell] as usize..self.starts[cell + 1] as usize;
        (&self.rows[range.clone()], &self.entries[range])
    }

    /// Each facet replaced by its class.
    fn by_lists(boundary: &SparseMatrix, lower: &CellClasses) -> Result<Self, Error> {
        let mut mapped = Self { starts: vec![0], rows: Vec::new(), entries: Vec::new() };
        let mut terms: Vec<(u32, i64)> = Vec::new();
        for column in boundary.columns() {
            terms.clear();
            for (facet, entry) in column.iter() {
                let class = lower.class_of[facet];
                if class != NONE {
                    terms.push((class, i64::from(entry) * i64::from(lower.signs[facet].to_i32())));
                }
            }
            terms.sort_unstable_by_key(|&(class, _)| class);
            for same in terms.chunk_by(|a, b| a.0 == b.0) {
                let sum: i64 = same.iter().map(|&(_, entry)| entry).sum();
                if sum != 0 {
                    mapped.rows.push(same[0].0);
                    mapped.entries.push(i32::try_from(sum).map_err(|_| {
                        Error::new(ErrorKind::TooLarge, "a coefficient of a quotient needs more than 32 bits")
                    })?);
                }
            }
            mapped.starts.push(mapped.rows.len() as u32);
        }
        Ok(mapped)
    }

    /// The product of the matrix of the classes below and the boundary matrix.
    fn by_matrices(boundary: &SparseMatrix, lower: &CellClasses) -> Result<Self, Error> {
        let product = lower.matrix()?.checked_product(boundary)?;
        Ok(Self {
            starts: product.column_starts().to_vec(),
            rows: product.rows().to_vec(),
            entries: product.entries().to_vec(),
        })
    }

    /// Whether the first coefficient of a cell is negative.
    fn sign(&self, cell: usize) -> Sign {
        match self.column(cell).1.first() {
            Some(&entry) if entry < 0 => Sign::Minus,
            _ => Sign::Plus,
        }
    }

    /// The lowest cell with the same boundary up to sign, for each cell; by sorting within buckets of the first row.
    fn lowest_by_lists(&self, row_count: usize, is_open: impl Fn(usize) -> bool) -> Vec<u32> {
        let cell_count = self.starts.len() - 1;
        let key = |cell: usize| self.column(cell).0.first().map_or(row_count as u32, |&row| row);
        let mut buckets =
            RaggedArray::grouped(row_count + 1, (0..cell_count).map(key).collect::<Vec<_>>().into_iter());
        let mut lowest: Vec<u32> = (0..cell_count as u32).collect();
        let ends: Vec<usize> =
            (0..row_count).map(|row| buckets.start(row) + buckets.list(row).len()).collect();
        let mut start = 0;
        for end in ends {
            let bucket = &mut buckets.items_mut()[start..end];
            start = end;
            let value = |cell: u32| {
                let (rows, entries) = self.column(cell as usize);
                let sign = self.sign(cell as usize).to_i32();
                (rows, entries.iter().map(move |entry| entry * sign))
            };
            bucket.sort_unstable_by(|&a, &b| {
                let ((rows, entries), (other_rows, other_entries)) = (value(a), value(b));
                rows.cmp(other_rows).then_with(|| entries.cmp(other_entries)).then(a.cmp(&b))
            });
            let is_same = |&a: &u32, &b: &u32| {
                let ((rows, entries), (other_rows, other_entries)) = (value(a), value(b));
                rows == other_rows && entries.eq(other_entries)
            };
            for same in bucket.chunk_by(is_same) {
                same.iter().for_each(|&cell| lowest[cell as usize] = same[0]);
            }
        }
        // What has no boundary now had none before, or is collapsed.
        for (cell, lowest) in lowest.iter_mut().enumerate() {
            if self.column(cell).0.is_empty() && !is_open(cell) {
                *lowest = NONE;
            }
        }
        lowest
    }

    /// The same by a map of columns.
    fn lowest_by_map(&self, is_open: impl Fn(usize) -> bool) -> Vec<u32> {
        let mut first: BTreeMap<(&[u32], Vec<i32>), u32> = BTreeMap::new();
        let lowest = (0..self.starts.len() - 1).map(|cell| {
            let (rows, entries) = self.column(cell);
            if rows.is_empty() {
                return if is_open(cell) { cell as u32 } else { NONE };
            }
            let sign = self.sign(cell).to_i32();
            *first.entry((rows, entries.iter().map(|entry| entry * sign).collect())).or_insert(cell as u32)
        });
        lowest.collect()
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
    let is_open = |cell: usize| boundary.column(cell).rows().is_empty();
    let (mapped, lowest) = match method {
        CongruenceMethod::Lists => {
            let mapped = Mapped::by_lists(boundary, lower)?;
            let lowest = mapped.lowest_by_lists(lower.class_count(), is_open);
            (mapped, lowest)
        }
        CongruenceMethod::Matrices => {
            let mapped = Mapped::by_matrices(boundary, lower)?;
            let lowest = mapped.lowest_by_map(is_open);
            (mapped, lowest)
        }
    };
    let mut class_of = vec![NONE; lowest.len()];
    let mut signs = vec![Sign::Plus; lowest.len()];
    let (mut starts, mut rows, mut entries, mut changed) = (vec![0u32], Vec::new(), Vec::new(), Vec::new());
    for (cell, &first) in lowest.iter().enumerate() {
        if first == NONE {
            continue;
        }
        if first as usize == cell {
            class_of[cell] = starts.len() as u32 - 1;
            let (own_rows, own_entries) = mapped.column(cell);
            rows.extend_from_slice(own_rows);
            entries.extend_from_slice(own_entries);
            starts.push(rows.len() as u32);
        } else {
            class_of[cell] = class_of[first as usize];
            signs[cell] = mapped.sign(cell).times(mapped.sign(first as usize));
        }
        if mapped.column(cell).0.len() < boundary.column(cell).rows().len() {
            changed.push(cell as u32);
        }
    }
    let class_count = starts.len() - 1;
    let boundary = SparseMatrix::from_parts(lower.class_count(), starts, rows, entries)?;
    let with_classes: Vec<u32> =
        (0..class_of.len() as u32).filter(|&cell| class_of[cell as usize] != NONE).collect();
    let mut members =
        RaggedArray::grouped(class_count, with_classes.iter().map(|&cell| class_of[cell as usize]));
    members.items_mut().iter_mut().for_each(|position| *position = with_classes[*position as usize]);
    Ok(CellCongruence { boundary, classes: CellClasses { members, class_of, signs }, changed })
}
