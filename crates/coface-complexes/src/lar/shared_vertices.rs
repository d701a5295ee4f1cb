//! Which cells share how many vertices.

use super::overlaps::{Counter, Overlaps, Part, joined};
use super::{LarModel, Operator};
use coface_algebra::Error;
use coface_algebra::{RaggedArray, SparseMatrix};
use std::borrow::Cow;

/// How many vertices two cells must share to be related.
///
/// # Examples
/// The edges with both ends in a triangle:
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_complexes::lar::{LarModel, Shared};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edges = RaggedArray::from_lists([[0, 1], [0, 2], [1, 2], [2, 3]]);
/// let model = LarModel::new(4, vec![edges, RaggedArray::from_lists([[0, 1, 2]])])?;
/// assert_eq!(model.related("FE".parse()?, Shared::AllOfColumn)?.list(0), [0, 1, 2]);
/// assert_eq!(model.related("FE".parse()?, Shared::Exactly(1))?.list(0), [3]);
/// # Ok(()) }
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Shared {
    /// At least so many; 0 is taken as 1, since cells that share nothing are not related.
    AtLeast(u32),
    /// Exactly so many; none are related for 0.
    Exactly(u32),
    /// All vertices of the cell that is the row.
    AllOfRow,
    /// All vertices of the cell that is the column.
    AllOfColumn,
}

impl LarModel {
    /// The lists whose common items the entries of an operator count. Vertices are joined by edges, and all other cells
    /// share vertices.
    fn overlaps(&self, operator: Operator) -> Overlaps<'_> {
        let (rows, columns) = (operator.rows(), operator.columns());
        if (rows, columns) == (0, 0) {
            let edges = self.cells(1);
            let edges_at = edges.transposed(self.vertex_count());
            return Overlaps {
                rows: Cow::Owned(edges_at),
                columns_at: edges.into_owned(),
                column_count: self.vertex_count(),
            };
        }
        Overlaps {
            rows: self.cells(rows),
            columns_at: match columns {
                0 => self.cells(0).into_owned(),
                _ => self.cells(columns).transposed(self.vertex_count()),
            },
            column_count: self.cell_count(columns),
        }
    }

    /// The matrix of an operator: rows are the cells of its first degree, columns those of its second, and an entry is the
    /// number of vertices that the two cells share.
    ///
    /// With the characteristic matrices $M_k$ this is $M_r M_c^T$; so `FV` is $M_2$ and `VF` its transpose. Only `VV` is
    /// defined through edges, as $M_1^T M_1$: an entry is the number of edges that join two vertices, and the diagonal
    /// the number of edges at a vertex.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::TooLarge`] beyond 2^32 - 1 entries.
    ///
    /// # Complexity
    /// $O(m \log r)$ for m multiplications and r rows in a column; in parallel.
    ///
    /// # Examples
    /// Two triangles share the edge 1 2, so two vertices:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::LarModel;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = RaggedArray::from_lists([[0, 1], [0, 2], [1, 2], [1, 3], [2, 3]]);
    /// let model = LarModel::new(4, vec![edges, RaggedArray::from_lists([[0, 1, 2], [1, 2, 3]])])?;
    /// let faces = model.shared_vertices("FF".parse()?)?;
    /// assert_eq!((faces.entry(0, 0), faces.entry(0, 1)), (3, 2));
    /// let vertices = model.shared_vertices("VV".parse()?)?;
    /// assert_eq!((vertices.entry(1, 1), vertices.entry(1, 2), vertices.entry(0, 3)), (3, 1, 0));
    /// # Ok(()) }
    /// ```
    pub fn shared_vertices(&self, operator: Operator) -> Result<SparseMatrix, Error> {
        // The columns of the matrix are the rows of the transposed operator.
        let overlaps = self.overlaps(operator.transposed());
        let parts = overlaps.in_parts(|counter, columns| {
            let (mut ends, mut rows, mut entries) = (Vec::new(), Vec::new(), Vec::new());
            for column in columns {
                let start = rows.len();
                counter.push_row(&overlaps, column, 1, |_, _| true, &mut rows);
                entries.extend(rows[start..].iter().map(|&row| counter.count(row) as i32));
                ends.push(rows.len() as u32);
            }
            ((ends, rows), entries)
        });
        let (lists, entries): (Vec<Part>, Vec<Vec<i32>>) = parts.into_iter().unzip();
        let (starts, rows) = joined(lists)?;
        SparseMatrix::from_trusted_parts(self.cell_count(operator.rows()), starts, rows, entries.concat())
    }

    /// For each cell that is a row the cells of the columns that share so many vertices with it, rising; for `VV` the
    /// vertices that so many edges join to it.
    ///
    /// A cell is not related to itself: where rows and columns are the same cells the diagonal is left out. The matrix of
    /// counts is never stored.
    ///
    /// # Errors
    /// [`coface_algebra::ErrorKind::TooLarge`] beyond 2^32 - 1 pairs.
    ///
    /// # Complexity
    /// Linear in the pairs of a row and a column with a common vertex, each counted so often as they have one, with a sort of
    /// each list of results; in parallel, with results that do not depend on the number of threads.
    ///
    /// # References
    /// F. G. Gustavson, *Two fast algorithms for sparse matrices: multiplication and permuted transposition* (1978).
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::{LarModel, Shared};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = RaggedArray::from_lists([[0, 1], [1, 2], [2, 3]]);
    /// let path = LarModel::new(4, vec![edges])?;
    /// assert_eq!(path.related("VV".parse()?, Shared::AtLeast(1))?.list(1), [0, 2]);
    /// assert_eq!(path.related("EE".parse()?, Shared::AtLeast(1))?.list(0), [1]);
    /// # Ok(()) }
    /// ```
    pub fn related(&self, operator: Operator, shared: Shared) -> Result<RaggedArray, Error> {
        let relation = Relation::new(self, operator, shared);
        let parts = relation.overlaps.in_parts(|counter, rows| {
            let (mut ends, mut columns) = (Vec::with_capacity(rows.len()), Vec::new());
            for row in rows {
                relation.push_row(counter, row, &mut columns);
                ends.push(columns.len() as u32);
            }
            (ends, columns)
        });
        let (starts, columns) = joined(parts)?;
        RaggedArray::from_parts(starts, columns)
    }

    /// Gives each row of [`Self::related`] to `visit` in order: the cell that is the row, and the related ones, rising.
    /// Nothing is stored but one row.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::{LarModel, Shared};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = LarModel::new(3, vec![RaggedArray::from_lists([[0, 1], [1, 2]])])?;
    /// let mut degrees = Vec::new();
    /// path.for_each_row("VE".parse()?, Shared::AtLeast(1), |_, edges| degrees.push(edges.len()));
    /// assert_eq!(degrees, [1, 2, 1]);
    /// # Ok(()) }
    /// ```
    pub fn for_each_row(&self, operator: Operator, shared: Shared, mut visit: impl FnMut(usize, &[u32])) {
        let relation = Relation::new(self, operator, shared);
        let mut counter = Counter::new(relation.overlaps.column_count);
        let mut columns = Vec::new();
        for row in 0..relation.overlaps.rows.len() {
            columns.clear();
            relation.push_row(&mut counter, row, &mut columns);
            visit(row, &columns);
        }
    }

    /// How often each number stands in the matrix of [`Self::shared_vertices`], the diagonal included: entry n is the number
    /// of places with n. Entry 0, the places where nothing is stored, is 0; the last entry is not, unless it is the
    /// only one. The matrix is never stored.
    ///
    /// # Examples
    /// A triangle shares three vertices with itself and two with its neighbor:
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_complexes::lar::LarModel;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let faces = RaggedArray::from_lists([[0, 1, 2], [1, 2, 3]]);
    /// let model = LarModel::new(4, vec![RaggedArray::new(), faces])?;
    /// assert_eq!(model.counts("FF".parse()?), [0, 0, 2, 2]);
    /// # Ok(()) }
    /// ```
    pub fn counts(&self, operator: Operator) -> Vec<u64> {
        let overlaps = self.overlaps(operator);
        let parts = overlaps.in_parts(|counter, rows| {
            let (mut histogram, mut columns) = (vec![0u64], Vec::new());
            for row in rows {
                columns.clear();
                counter.push_row_unsorted(&overlaps, row, &mut columns);
                for &column in &columns {
                    let count = counter.count(column) as usize;
                    if histogram.len() <= count {
                        histogram.resize(count + 1, 0);
                    }
                    histogram[count] += 1;
                }
            }
            histogram
        });
        let mut total = vec![0; parts.iter().map(Vec::len).max().unwrap_or(1)];
        for part in parts {
            total.iter_mut().zip(part).for_each(|(sum, count)| *sum += count);
        }
        total
    }
}

/// The rows of an operator and when a column belongs to one.
struct Relation<'a> {
    overlaps: Overlaps<'a>,
    shared: Shared,
    /// The lengths of the columns where these decide.
    columns: Cow<'a, RaggedArray>,
    is_square: bool,
}

impl<'a> Relation<'a> {
    fn new(model: &'a LarModel, operator: Operator, shared: Shared) -> Self {
        let (overlaps, is_square) = (model.overlaps(operator), operator.is_square());
        let mut relation = Self { overlaps, shared, columns: Cow::Owned(RaggedArray::new()), is_square };
        if shared == Shared::AllOfColumn {
            // Vertices are joined by edges: all edges at the column.
            let at = if (operator.rows(), operator.columns()) == (0, 0) {
                relation.overlaps.rows.clone()
            } else {
                model.cells(operator.columns())
            };
            match at.uniform_width() {
                Some(width) => relation.shared = Shared::AtLeast(width as u32),
                None => relation.columns = at,
            }
        }
        relation
    }

    fn push_row(&self, counter: &mut Counter, row: usize, list: &mut Vec<u32>) {
        let keep = |column: u32| !self.is_square || column as usize != row;
        let overlaps = &self.overlaps;
        match self.shared {
            Shared::AtLeast(n) => counter.push_row(overlaps, row, n.max(1), |column, _| keep(column), list),
            Shared::Exactly(0) => {}
            Shared::Exactly(n) => {
                counter.push_row(overlaps, row, n, |column, count| count == n && keep(column), list);
            }
            Shared::AllOfRow => {
                let n = overlaps.rows.list(row).len().max(1) as u32;
                counter.push_row(overlaps, row, n, |column, _| keep(column), list);
            }
            Shared::AllOfColumn => {
                let is_whole = |column: u32, count: u32| {
                    self.columns.list(column as usize).len() == count as usize && keep(column)
                };
                counter.push_row(overlaps, row, 1, is_whole, list);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::samples::{cube, grid};
    use super::*;
    use proptest::prelude::*;

    fn operator(name: &str) -> Operator {
        name.parse().unwrap()
    }

    /// Models of up to 3 degrees on 9 vertices, the last of which is never used.
    fn models() -> impl Strategy<Value = LarModel> {
        let cells = |least: usize, most: usize| {
            let cell =
                (Just((0u32..8).collect::<Vec<_>>()).prop_shuffle(), least..=most).prop_map(|(mut v, n)| {
                    v.truncate(n);
                    v
                });
            prop::collection::vec(cell, 0..12).prop_map(RaggedArray::from_lists)
        };
        (cells(2, 2), cells(1, 5), cells(3, 8))
            .prop_map(|(edges, faces, solids)| LarModel::new(9, vec![edges, faces, solids]).unwrap())
    }

    proptest! {
        #[test]
        fn counts_are_products_of_characteristic_matrices(model in models()) {
            for rows in 0..5 {
                for columns in 0..5 {
                    let operator = Operator::new(rows, columns);
                    let counts = model.shared_vertices(operator).unwrap();
                    let product = if (rows, columns) == (0, 0) {
                        let edges = model.characteristic_matrix(1).unwrap();
                        edges.transpose().checked_product(&edges).unwrap()
                    } else {
                        let [m, n] = [rows, columns].map(|k| model.characteristic_matrix(k).unwrap());
                        m.checked_product(&n.transpose()).unwrap()
                    };
                    prop_assert_eq!(&counts, &product);
                    let mut histogram = vec![0u64];
                    for &entry in counts.entries() {
                        histogram.resize(histogram.len().max(entry as usize + 1), 0);
                        histogram[entry as usize] += 1;
                    }
                    prop_assert_eq!(model.counts(operator), histogram);
                }
            }
        }

        #[test]
        fn related_cells_are_those_with_the_count(model in models(), n in 0u32..5) {
            for rows in 0..4 {
                for columns in 0..4 {
                    let operator = Operator::new(rows, columns);
                    let counts = model.shared_vertices(operator).unwrap();
                    let size = |degree: usize, cell: usize| match (rows, columns) {
                        (0, 0) => counts.entry(cell, cell) as u32,
                        _ => model.cells(degree).list(cell).len() as u32,
                    };
                    for shared in [Shared::AtLeast(n), Shared::Exactly(n), Shared::AllOfRow, Shared::AllOfColumn] {
                        let related = model.related(operator, shared).unwrap();
                        prop_assert_eq!(related.len(), model.cell_count(rows));
                        for (row, list) in related.iter().enumerate() {
                            let expected: Vec<u32> = (0..model.cell_count(columns))
                                .filter(|&column| rows != columns || row != column)
                                .filter(|&column| {
                                    let count = counts.entry(row, column) as u32;
                                    count > 0 && match shared {
                                        Shared::AtLeast(n) => count >= n,
                                        Shared::Exactly(n) => count == n,
                                        Shared::AllOfRow => count == size(rows, row),
                                        Shared::AllOfColumn => count == size(columns, column),
                                    }
                                })
                                .map(|column| column as u32)
                                .collect();
                            prop_assert_eq!(list, &expected[..], "{} {:?} row {}", operator, shared, row);
                        }
                        let mut next = 0;
                        model.for_each_row(operator, shared, |row, list| {
                            assert_eq!((row, list), (next, related.list(next)));
                            next += 1;
                        });
                        prop_assert_eq!(next, related.len());
                    }
                }
            }
        }
    }

    /// The figures of the cube: by hand.
    #[test]
    fn the_cube_has_its_counts() {
        let cube = cube();
        assert_eq!(
            cube.cells(1).items(),
            [0, 1, 2, 3, 4, 5, 6, 7, 0, 2, 1, 3, 4, 6, 5, 7, 0, 4, 1, 5, 2, 6, 3, 7]
        );
        let vertices = cube.shared_vertices(operator("VV")).unwrap();
        assert_eq!(vertices.entry_count(), 32);
        assert!((0..8).all(|v| vertices.entry(v, v) == 3));
        let edges = cube.shared_vertices(operator("EE")).unwrap();
        assert_eq!(edges.column(0).iter().filter(|&(_, n)| n == 1).count(), 4);
        let row: Vec<i32> = cube.shared_vertices(operator("EF")).unwrap().column(0).entries().to_vec();
        assert_eq!(row, [2, 2, 2, 2, 1, 1, 1, 1]);
        assert_eq!(cube.related(operator("FE"), Shared::Exactly(2)).unwrap().list(0), [0, 1, 4, 5]);
        let faces = cube.shared_vertices(operator("FF")).unwrap();
        assert_eq!((faces.entry(0, 0), faces.entry(0, 1), faces.entry(0, 2)), (4, 0, 2));
        assert_eq!(cube.shared_vertices(operator("VF")).unwrap().transpose().column(0).rows(), [0, 2, 4]);
        assert_eq!(cube.counts(operator("FE")), [0, 24, 24]);
    }

    #[test]
    fn results_do_not_depend_on_threads() {
        let model = grid([20, 20, 20]);
        let pool = |threads| rayon::ThreadPoolBuilder::new().num_threads(threads).build().unwrap();
        for name in ["VV", "FF", "FE", "CE"] {
            let [one, three] = [1, 3].map(|threads| {
                pool(threads).install(|| {
                    let operator = operator(name);
                    let related = model.related(operator, Shared::AtLeast(2)).unwrap();
                    (related, model.counts(operator), model.shared_vertices(operator).unwrap())
                })
            });
            assert!(one == three, "{name}");
        }
    }
}
