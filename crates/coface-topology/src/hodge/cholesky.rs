//! Sparse Cholesky factors of positive definite matrices.

use super::ordering::minimum_degree_order;
use coface_algebra::{Error, ErrorKind};

/// The Cholesky factor of a symmetric positive definite matrix, with a fill-reducing order. One thread: the same input
/// gives the same bytes.
///
/// Adjacent columns with the same rows below them are a **block**, stored as one dense matrix by columns, so that
/// most of the work is on dense columns. Each block takes off what the blocks before it that reach its columns
/// contribute (left-looking), then it is factorized itself.
///
/// # References
/// T. A. Davis, *Direct Methods for Sparse Linear Systems* (2006), chapter 4; E. G. Ng, B. W. Peyton, *Block sparse
/// Cholesky algorithms on advanced uniprocessor computers* (1993).
#[derive(Clone, Debug)]
pub(crate) struct CholeskyFactor {
    /// The row of the matrix at each position of the order.
    order: Vec<u32>,
    blocks: Vec<Block>,
    values: Vec<f64>,
}

/// An entry of the lower half of a symmetric matrix: row, column, value.
pub(crate) type Entry = (usize, usize, f64);

/// Adjacent columns with the same rows.
#[derive(Clone, Debug)]
struct Block {
    width: usize,
    /// The positions of its rows, rising; its own columns are the first.
    rows: Vec<u32>,
    /// Where its values begin.
    start: usize,
}

/// The largest number of entries of a factor: 2 GiB.
pub(crate) const MOST_FILL: usize = 1 << 28;

/// The largest number of columns of a block, so that a tile of rows stays in the cache.
const MOST_WIDTH: usize = 128;

/// The number of rows whose updates are added up at a time.
const TILE: usize = 128;

impl CholeskyFactor {
    /// The factor of the matrix with these entries in its lower half; those at one place are added.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if the factor has more than `most` entries, or the matrix is not positive definite in
    /// floating point.
    pub(crate) fn new(count: usize, entries: Vec<Entry>, most: usize) -> Result<Self, Error> {
        let mut neighbors = vec![Vec::new(); count];
        for &(row, column, _) in entries.iter().filter(|(row, column, _)| row != column) {
            neighbors[row].push(column as u32);
            neighbors[column].push(row as u32);
        }
        for list in &mut neighbors {
            list.sort_unstable();
            list.dedup();
        }
        let order = minimum_degree_order(neighbors);
        let matrix = Columns::new(&entries, &order);
        let parents = matrix.elimination_tree();
        let order: Vec<u32> = postorder(&parents).into_iter().map(|at| order[at as usize]).collect();
        let matrix = Columns::new(&entries, &order);
        drop(entries);
        let blocks = blocks(&matrix, &matrix.elimination_tree());
        let fill = blocks.last().map_or(0, |block| block.start + block.width * block.rows.len());
        if fill > most {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("the Cholesky factor of {count} equations has {fill} entries; the limit is {most}"),
            )
            .with_cure("take a coarser complex"));
        }
        let mut values = Vec::new();
        values.try_reserve_exact(fill).map_err(|_| too_hard(count, "there is not enough memory"))?;
        values.resize(fill, 0.0);
        let mut factor = Self { order, blocks, values };
        factor.compute(&matrix)?;
        Ok(factor)
    }

    /// Solves the equations with this right side, in its place.
    pub(crate) fn solve(&self, right: &mut [f64]) {
        let mut x: Vec<f64> = self.order.iter().map(|&row| right[row as usize]).collect();
        for block in &self.blocks {
            for (j, column) in self.columns(block).enumerate() {
                let at = block.rows[j] as usize;
                x[at] /= column[j];
                let value = x[at];
                for (&row, entry) in block.rows[j + 1..].iter().zip(&column[j + 1..]) {
                    x[row as usize] -= entry * value;
                }
            }
        }
        for block in self.blocks.iter().rev() {
            for (j, column) in self.columns(block).enumerate().rev() {
                let at = block.rows[j] as usize;
                let below: f64 = block.rows[j + 1..]
                    .iter()
                    .zip(&column[j + 1..])
                    .map(|(&row, entry)| entry * x[row as usize])
                    .sum();
                x[at] = (x[at] - below) / column[j];
            }
        }
        for (&row, value) in self.order.iter().zip(x) {
            right[row as usize] = value;
        }
    }

    /// The columns of a block, each with an entry for each of its rows; those above the diagonal mean nothing.
    fn columns(&self, block: &Block) -> std::slice::ChunksExact<'_, f64> {
        self.values[block.start..block.start + block.width * block.rows.len()].chunks_exact(block.rows.len())
    }

    fn compute(&mut self, matrix: &Columns) -> Result<(), Error> {
        let count = self.order.len();
        let mut block_of = vec![0u32; count];
        for (i, block) in self.blocks.iter().enumerate() {
            for &row in &block.rows[..block.width] {
                block_of[row as usize] = i as u32;
            }
        }
        // For each block the earlier ones that reach its columns next, with the first of their rows there.
        let mut waiting: Vec<Vec<(u32, u32)>> = vec![Vec::new(); self.blocks.len()];
        let mut place = vec![0u32; count];
        for (i, block) in self.blocks.iter().enumerate() {
            let height = block.rows.len();
            let (before, rest) = self.values.split_at_mut(block.start);
            let own = &mut rest[..block.width * height];
            for (at, &row) in block.rows.iter().enumerate() {
                place[row as usize] = at as u32;
            }
            let first = block.rows[0] as usize;
            let end = first + block.width;
            for (j, target) in own.chunks_exact_mut(height).enumerate() {
                for (row, value) in matrix.column(first + j) {
                    target[place[row] as usize] += value;
                }
            }
            for (from, start) in std::mem::take(&mut waiting[i]) {
                let (other, start) = (&self.blocks[from as usize], start as usize);
                let stop = start + other.rows[start..].partition_point(|&row| (row as usize) < end);
                let source = &before[other.start..other.start + other.width * other.rows.len()];
                subtract(own, height, source, &other.rows, start..stop, &place, first);
                if let Some(&next) = other.rows.get(stop) {
                    waiting[block_of[next as usize] as usize].push((from, stop as u32));
                }
            }
            factorize_dense(own, height, block.width).map_err(|pivot| {
                too_hard(count, &format!("pivot {} is {pivot:e}, not a positive number", first + 1))
            })?;
            if let Some(&next) = block.rows.get(block.width) {
                waiting[block_of[next as usize] as usize].push((i as u32, block.width as u32));
            }
        }
        Ok(())
    }
}

/// Subtracts from a block what an earlier one contributes to its columns: the product of its rows from `span.start` on
/// with the transpose of its rows in `span`.
fn subtract(
    target: &mut [f64],
    height: usize,
    source: &[f64],
    rows: &[u32],
    span: std::ops::Range<usize>,
    place: &[u32],
    first: usize,
) {
    let source_height = rows.len();
    let mut sums = [0.0; TILE];
    for tile in (span.start..source_height).step_by(TILE) {
        let tile_end = (tile + TILE).min(source_height);
        for column in span.start..span.end.min(tile_end) {
            // Only the lower half of the diagonal part is wanted.
            let top = tile.max(column);
            let sums = &mut sums[..tile_end - top];
            sums.fill(0.0);
            add_multiples(sums, source, source_height, top, column);
            let start = (rows[column] as usize - first) * height;
            let target = &mut target[start..start + height];
            for (&row, sum) in rows[top..tile_end].iter().zip(sums) {
                target[place[row as usize] as usize] -= *sum;
            }
        }
    }
}

/// Adds to the sums, for each column of the source, its rows from `top` on times its entry in `row`.
fn add_multiples(sums: &mut [f64], source: &[f64], height: usize, top: usize, row: usize) {
    let length = sums.len();
    let mut four = source.chunks_exact(4 * height);
    for columns in &mut four {
        let [a, b, c, d] = [0, 1, 2, 3].map(|i| &columns[i * height + top..][..length]);
        let [x, y, z, w] = [0, 1, 2, 3].map(|i| columns[i * height + row]);
        for i in 0..length {
            sums[i] += (a[i] * x + b[i] * y) + (c[i] * z + d[i] * w);
        }
    }
    for column in four.remainder().chunks_exact(height) {
        let x = column[row];
        for (sum, a) in sums.iter_mut().zip(&column[top..]) {
            *sum += a * x;
        }
    }
}

/// Factorizes a dense block in place; gives the pivot that is not positive if there is one.
fn factorize_dense(block: &mut [f64], height: usize, width: usize) -> Result<(), f64> {
    for j in 0..width {
        let (before, rest) = block.split_at_mut(j * height);
        let column = &mut rest[j..height];
        for other in before.chunks_exact(height) {
            let x = other[j];
            for (entry, a) in column.iter_mut().zip(&other[j..]) {
                *entry -= a * x;
            }
        }
        let pivot = column[0];
        if !(pivot > 0.0 && pivot.is_finite()) {
            return Err(pivot);
        }
        let root = pivot.sqrt();
        column[0] = root;
        column[1..].iter_mut().for_each(|entry| *entry /= root);
    }
    Ok(())
}

/// The lower half of a symmetric matrix by columns, in some order of rows and columns.
struct Columns {
    starts: Vec<usize>,
    rows: Vec<u32>,
    values: Vec<f64>,
}

impl Columns {
    fn new(entries: &[Entry], order: &[u32]) -> Self {
        let mut position = vec![0u32; order.len()];
        for (at, &row) in order.iter().enumerate() {
            position[row as usize] = at as u32;
        }
        let placed = |&(row, column, _): &Entry| {
            let [a, b] = [row, column].map(|x| position[x]);
            (a.min(b) as usize, a.max(b))
        };
        let mut starts = vec![0; order.len() + 1];
        for entry in entries {
            starts[placed(entry).0 + 1] += 1;
        }
        for i in 0..order.len() {
            starts[i + 1] += starts[i];
        }
        let mut next = starts.clone();
        let (mut rows, mut values) = (vec![0; entries.len()], vec![0.0; entries.len()]);
        for entry in entries {
            let (column, row) = placed(entry);
            (rows[next[column]], values[next[column]]) = (row, entry.2);
            next[column] += 1;
        }
        Self { starts, rows, values }
    }

    fn rows(&self, column: usize) -> &[u32] {
        &self.rows[self.starts[column]..self.starts[column + 1]]
    }

    fn column(&self, column: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let values = &self.values[self.starts[column]..self.starts[column + 1]];
        self.rows(column).iter().map(|&row| row as usize).zip(values.iter().copied())
    }

    /// For each column the first row below the diagonal of the factor, if there is one.
    fn elimination_tree(&self) -> Vec<Option<u32>> {
        let count = self.starts.len() - 1;
        let mut columns_of = vec![Vec::new(); count];
        for column in 0..count {
            for &row in self.rows(column) {
                if row as usize > column {
                    columns_of[row as usize].push(column as u32);
                }
            }
        }
        let mut parents = vec![None; count];
        // Shortcuts towards the root.
        let mut ancestors: Vec<Option<u32>> = vec![None; count];
        for (row, columns) in columns_of.into_iter().enumerate() {
            for column in columns {
                let mut at = Some(column);
                while let Some(node) = at.filter(|&node| (node as usize) < row) {
                    at = ancestors[node as usize].replace(row as u32);
                    if at.is_none() {
                        parents[node as usize] = Some(row as u32);
                    }
                }
            }
        }
        parents
    }
}

/// The nodes of a forest, children before parents and each subtree in one piece.
fn postorder(parents: &[Option<u32>]) -> Vec<u32> {
    let mut children = vec![Vec::new(); parents.len()];
    let mut stack = Vec::new();
    for (node, parent) in parents.iter().enumerate().rev() {
        match parent {
            Some(parent) => children[*parent as usize].push(node as u32),
            None => stack.push(node as u32),
        }
    }
    let mut order = Vec::with_capacity(parents.len());
    while let Some(&node) = stack.last() {
        match children[node as usize].pop() {
            Some(child) => stack.push(child),
            None => {
                order.push(node);
                stack.pop();
            }
        }
    }
    order
}

/// The blocks of the factor of a matrix whose elimination tree is in postorder.
fn blocks(matrix: &Columns, parents: &[Option<u32>]) -> Vec<Block> {
    let mut blocks: Vec<Block> = Vec::new();
    // The blocks whose last column is a child of a column.
    let mut children: Vec<Vec<u32>> = vec![Vec::new(); parents.len()];
    let mut seen = vec![None; parents.len()];
    for column in 0..parents.len() {
        let mut rows = vec![column as u32];
        seen[column] = Some(column);
        let mut add = |row: u32| {
            if row as usize > column && seen[row as usize] != Some(column) {
                seen[row as usize] = Some(column);
                rows.push(row);
            }
        };
        matrix.rows(column).iter().for_each(|&row| add(row));
        let below = std::mem::take(&mut children[column]);
        for &child in &below {
            let block = &blocks[child as usize];
            block.rows[block.width..].iter().for_each(|&row| add(row));
        }
        let is_child = blocks.len().checked_sub(1).is_some_and(|last| below.contains(&(last as u32)));
        match blocks.last_mut() {
            Some(last)
                if is_child && last.width < MOST_WIDTH && last.rows.len() - last.width == rows.len() =>
            {
                last.width += 1;
            }
            last => {
                let start = last.map_or(0, |block| block.start + block.width * block.rows.len());
                rows.sort_unstable();
                blocks.push(Block { width: 1, rows, start });
            }
        }
        if let Some(parent) = parents[column] {
            children[parent as usize].push(blocks.len() as u32 - 1);
        }
    }
    blocks
}

fn too_hard(count: usize, reason: &str) -> Error {
    Error::new(ErrorKind::TooLarge, format!("{count} equations cannot be solved: {reason}"))
        .with_cure("take a coarser complex, or weights that are nearer to each other")
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The lower half of $A^T A + I$ for rows of A, which is positive definite.
    fn normal(rows: &[Vec<f64>]) -> Vec<Entry> {
        let count = rows[0].len();
        let mut entries: Vec<Entry> = (0..count).map(|i| (i, i, 1.0)).collect();
        for row in rows {
            for j in (0..count).filter(|&j| row[j] != 0.0) {
                entries.extend((j..count).filter(|&i| row[i] != 0.0).map(|i| (i, j, row[i] * row[j])));
            }
        }
        entries
    }

    /// The largest difference between the right side and the matrix times the solution.
    fn residual(count: usize, entries: &[Entry], right: &[f64]) -> f64 {
        let factor = CholeskyFactor::new(count, entries.to_vec(), MOST_FILL).unwrap();
        let mut solution = right.to_vec();
        factor.solve(&mut solution);
        let mut rest = right.to_vec();
        for &(i, j, x) in entries {
            rest[i] -= x * solution[j];
            if i != j {
                rest[j] -= x * solution[i];
            }
        }
        rest.into_iter().map(f64::abs).fold(0.0, f64::max)
    }

    proptest! {
        #[test]
        fn solutions_solve(
            rows in prop::collection::vec(prop::collection::vec(-2.0f64..2.0, 6), 1..8),
            right in prop::collection::vec(-1.0f64..1.0, 6),
        ) {
            prop_assert!(residual(6, &normal(&rows), &right) < 1e-10);
        }

        /// Few entries a row: many blocks, joined groups, several components.
        #[test]
        fn solutions_of_sparse_equations_solve(
            rows in prop::collection::vec(prop::collection::vec((0..60usize, -2.0f64..2.0), 1..5), 1..90),
            right in prop::collection::vec(-1.0f64..1.0, 60),
        ) {
            let dense = |row: &Vec<(usize, f64)>| {
                let mut values = vec![0.0; 60];
                row.iter().for_each(|&(i, x)| values[i] = x);
                values
            };
            let rows: Vec<Vec<f64>> = rows.iter().map(dense).collect();
            prop_assert!(residual(60, &normal(&rows), &right) < 1e-9);
        }
    }

    #[test]
    fn blocks_wider_than_a_tile_are_solved() {
        let count = 3 * MOST_WIDTH + 11;
        let mut entries: Vec<Entry> = (0..count).map(|i| (i, i, 2.0 * count as f64)).collect();
        for j in 0..count {
            entries.extend((j + 1..count).map(|i| (i, j, ((i * 7 + j * 3) % 11) as f64 / 11.0 - 0.5)));
        }
        let right: Vec<f64> = (0..count).map(|i| (i % 5) as f64 - 2.0).collect();
        assert!(residual(count, &entries, &right) < 1e-10);
    }

    #[test]
    fn a_grid_fills_little() {
        let size = 60;
        let at = |x: usize, y: usize| x * size + y;
        let mut entries = Vec::new();
        for x in 0..size {
            for y in 0..size {
                entries.push((at(x, y), at(x, y), 4.5));
                entries.extend((x > 0).then(|| (at(x, y), at(x - 1, y), -1.0)));
                entries.extend((y > 0).then(|| (at(x, y), at(x, y - 1), -1.0)));
            }
        }
        let factor = CholeskyFactor::new(size * size, entries.clone(), MOST_FILL).unwrap();
        // In the given order the band alone has 60 entries for each of the 3,600 columns: 216,000.
        assert!(factor.values.len() < 90_000, "{}", factor.values.len());
        let right: Vec<f64> = (0..size * size).map(|i| (i % 7) as f64).collect();
        assert!(residual(size * size, &entries, &right) < 1e-12);
    }

    #[test]
    fn what_cannot_be_factorized_is_refused() {
        let dense = || normal(&[vec![1.0, 2.0, 3.0]]);
        let refused = |entries, most| CholeskyFactor::new(3, entries, most).err().map(|error| error.kind());
        assert_eq!(refused(dense(), MOST_FILL), None);
        assert_eq!(refused(dense(), 3), Some(ErrorKind::TooLarge), "six or nine entries are too many");
        let indefinite = [(0, 1.0), (1, -1.0), (2, 1.0)].map(|(i, x)| (i, i, x));
        assert_eq!(refused(indefinite.to_vec(), MOST_FILL), Some(ErrorKind::TooLarge));
    }
}
