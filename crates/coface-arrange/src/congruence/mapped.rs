//! Boundaries of cells written in the classes of their facets.

use super::CellClasses;
use super::classes::NONE;
use coface_algebra::progress::stage;
use coface_algebra::{ColumnBlock, RaggedArray, Sign, SparseMatrix, joined_columns};
use coface_algebra::{Error, ErrorKind};
use rayon::prelude::*;
use std::collections::BTreeMap;

/// Columns that one task writes.
const BLOCK: usize = 1 << 13;

/// The boundary of a piece: facets with coefficients, rising.
pub(super) type Piece = Vec<(u32, i32)>;

/// Boundaries written in classes: a column for each cell, or one for each piece of a cell. Rows of a column rise, no
/// entry is zero.
pub(super) struct Mapped {
    starts: Vec<u32>,
    rows: Vec<u32>,
    entries: Vec<i32>,
    /// The cell of each column, rising; empty if no cell has several.
    owners: Vec<u32>,
}

impl Mapped {
    pub(super) fn column_count(&self) -> usize {
        self.starts.len() - 1
    }

    /// The cell that a column is of.
    pub(super) fn owner(&self, column: usize) -> usize {
        self.owners.get(column).map_or(column, |&owner| owner as usize)
    }

    /// The cell of each column; empty if each cell has one.
    pub(super) fn owners(&self) -> &[u32] {
        &self.owners
    }

    /// Gives cells, rising, columns for their pieces instead of their own.
    pub(super) fn split(&mut self, cells: &[(u32, Vec<Piece>)]) -> Result<(), Error> {
        if cells.is_empty() {
            return Ok(());
        }
        let mut split = Self { starts: vec![0], rows: Vec::new(), entries: Vec::new(), owners: Vec::new() };
        let mut cells = cells.iter().peekable();
        for cell in 0..self.column_count() {
            let end = |split: &mut Self| {
                split.starts.push(split.rows.len() as u32);
                split.owners.push(cell as u32);
            };
            if let Some((_, pieces)) = cells.next_if(|(split, _)| *split as usize == cell) {
                for piece in pieces {
                    split.rows.extend(piece.iter().map(|&(row, _)| row));
                    split.entries.extend(piece.iter().map(|&(_, entry)| entry));
                    end(&mut split);
                }
            } else {
                let (rows, entries) = self.column(cell);
                split.rows.extend_from_slice(rows);
                split.entries.extend_from_slice(entries);
                end(&mut split);
            }
            if u32::try_from(split.rows.len()).is_err() {
                return Err(Error::new(ErrorKind::TooLarge, "more than 2^32 - 1 entries in a quotient"));
            }
        }
        *self = split;
        Ok(())
    }

    pub(super) fn column(&self, cell: usize) -> (&[u32], &[i32]) {
        let range = self.starts[cell] as usize..self.starts[cell + 1] as usize;
        (&self.rows[range.clone()], &self.entries[range])
    }

    /// Each facet replaced by its image.
    pub(super) fn by_lists(boundary: &SparseMatrix, lower: &CellClasses) -> Result<Self, Error> {
        let cell_count = boundary.column_count();
        let steps = stage("mapping boundaries", cell_count);
        let blocks: Vec<ColumnBlock> = (0..cell_count.div_ceil(BLOCK))
            .into_par_iter()
            .map(|block| {
                let cells = block * BLOCK..((block + 1) * BLOCK).min(cell_count);
                steps.advance(cells.len());
                mapped_block(boundary, lower, cells)
            })
            .collect::<Result<_, _>>()?;
        let (starts, rows, entries) = joined_columns(cell_count, blocks)?;
        Ok(Self { starts, rows, entries, owners: Vec::new() })
    }

    /// The product of the matrix of the classes below and the boundary matrix.
    pub(super) fn by_matrices(boundary: &SparseMatrix, lower: &CellClasses) -> Result<Self, Error> {
        Ok(Self::of_matrix(&lower.matrix()?.checked_product(boundary)?))
    }

    fn of_matrix(matrix: &SparseMatrix) -> Self {
        Self {
            starts: matrix.column_starts().to_vec(),
            rows: matrix.rows().to_vec(),
            entries: matrix.entries().to_vec(),
            owners: Vec::new(),
        }
    }

    /// The matrix of some of the columns.
    pub(super) fn selected(&self, row_count: usize, columns: &[u32]) -> Result<SparseMatrix, Error> {
        let mut starts = Vec::with_capacity(columns.len() + 1);
        let mut total = 0;
        starts.push(total);
        starts.extend(columns.iter().map(|&column| {
            total += self.column(column as usize).0.len() as u32;
            total
        }));
        let (mut rows, mut entries) =
            (Vec::with_capacity(total as usize), Vec::with_capacity(total as usize));
        for &column in columns {
            let (own_rows, own_entries) = self.column(column as usize);
            rows.extend_from_slice(own_rows);
            entries.extend_from_slice(own_entries);
        }
        SparseMatrix::from_trusted_parts(row_count, starts, rows, entries)
    }

    /// Minus if the first coefficient of a cell is negative.
    pub(super) fn sign(&self, cell: usize) -> Sign {
        match self.column(cell).1.first() {
            Some(&entry) if entry < 0 => Sign::Minus,
            _ => Sign::Plus,
        }
    }

    /// The lowest cell with the same boundary up to sign, for each cell; by sorting within buckets of the first row.
    /// Cells without boundary are by themselves.
    pub(super) fn lowest_by_lists(&self, row_count: usize) -> Vec<u32> {
        let cell_count = self.column_count();
        let keys: Vec<u32> = (0..cell_count)
            .into_par_iter()
            .map(|cell| self.column(cell).0.first().map_or(row_count as u32, |&row| row))
            .collect();
        let mut buckets = RaggedArray::grouped(row_count + 1, keys.iter().copied());
        // Runs of buckets of some thousand cells, for one thread each; the last bucket has the cells without boundary.
        let (mut runs, mut from) = (Vec::new(), 0);
        for row in 0..row_count {
            let end = buckets.start(row + 1);
            if end - from >= BLOCK || row + 1 == row_count {
                runs.push(end - from);
                from = end;
            }
        }
        let mut slices = Vec::with_capacity(runs.len());
        let mut rest = buckets.items_mut();
        for length in runs {
            let (slice, others) = rest.split_at_mut(length);
            slices.push(slice);
            rest = others;
        }
        let steps = stage("comparing boundaries", cell_count);
        let found: Vec<Vec<[u32; 2]>> = slices
            .into_par_iter()
            .map(|run| {
                steps.advance(run.len());
                let mut found = Vec::new();
                for bucket in run.chunk_by_mut(|&a, &b| keys[a as usize] == keys[b as usize]) {
                    self.repetitions(bucket, &mut found);
                }
                found
            })
            .collect();
        let mut lowest: Vec<u32> = (0..cell_count as u32).collect();
        for [cell, first] in found.into_iter().flatten() {
            lowest[cell as usize] = first;
        }
        lowest
    }

    /// Sorts the cells of a bucket by their boundaries, and lists those that repeat a lower one, with it.
    fn repetitions(&self, bucket: &mut [u32], found: &mut Vec<[u32; 2]>) {
        let compare = |a: u32, b: u32| {
            let [(rows, entries), (other_rows, other_entries)] =
                [a, b].map(|cell| self.column(cell as usize));
            let is_same_sign = entries.first().map(|e| *e < 0) == other_entries.first().map(|e| *e < 0);
            rows.cmp(other_rows).then_with(|| {
                if is_same_sign && entries.first().is_some_and(|e| *e > 0) {
                    entries.cmp(other_entries)
                } else {
                    let [sign, other] = [a, b].map(|cell| self.sign(cell as usize).to_i32());
                    entries.iter().map(|e| e * sign).cmp(other_entries.iter().map(|e| e * other))
                }
            })
        };
        bucket.sort_unstable_by(|&a, &b| compare(a, b).then(a.cmp(&b)));
        for same in bucket.chunk_by(|&a, &b| compare(a, b).is_eq()) {
            found.extend(same[1..].iter().map(|&cell| [cell, same[0]]));
        }
    }

    /// The same by a map of columns.
    pub(super) fn lowest_by_map(&self) -> Vec<u32> {
        let mut first: BTreeMap<(&[u32], Vec<i32>), u32> = BTreeMap::new();
        let lowest = (0..self.column_count()).map(|cell| {
            let (rows, entries) = self.column(cell);
            if rows.is_empty() {
                return cell as u32;
            }
            let sign = self.sign(cell).to_i32();
            *first.entry((rows, entries.iter().map(|entry| entry * sign).collect())).or_insert(cell as u32)
        });
        lowest.collect()
    }
}

fn mapped_block(
    boundary: &SparseMatrix,
    lower: &CellClasses,
    cells: std::ops::Range<usize>,
) -> Result<ColumnBlock, Error> {
    let (mut lengths, mut rows, mut entries) = (Vec::with_capacity(cells.len()), Vec::new(), Vec::new());
    let mut terms: Vec<(u32, i64)> = Vec::new();
    for cell in cells {
        terms.clear();
        let column = boundary.column(cell);
        if let Some((class_of, signs)) = lower.as_single() {
            for (facet, entry) in column.iter() {
                if class_of[facet] != NONE {
                    terms.push((class_of[facet], i64::from(entry) * i64::from(signs[facet].to_i32())));
                }
            }
        } else {
            for (facet, entry) in column.iter() {
                let (classes, signs) = lower.image_lists(facet);
                let image = classes.iter().zip(signs);
                terms
                    .extend(image.map(|(&class, sign)| (class, i64::from(entry) * i64::from(sign.to_i32()))));
            }
        }
        terms.sort_unstable_by_key(|&(class, _)| class);
        let start = rows.len();
        for same in terms.chunk_by(|a, b| a.0 == b.0) {
            let sum: i128 = same.iter().map(|&(_, entry)| i128::from(entry)).sum();
            if sum != 0 {
                rows.push(same[0].0);
                let narrow = i32::try_from(sum).ok().filter(|&sum| sum != i32::MIN);
                entries.push(narrow.ok_or_else(|| {
                    Error::new(
                        ErrorKind::TooLarge,
                        format!("a coefficient of the boundary of cell {cell} of a quotient needs more than 32 bits"),
                    )
                })?);
            }
        }
        lengths.push((rows.len() - start) as u32);
    }
    Ok((lengths, rows, entries))
}
