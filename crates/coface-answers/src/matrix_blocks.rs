//! Boundary matrices in blocks: rows and columns in an order in which cells of one kind stand together.

use crate::Producer;
use crate::answer::{BlockAnswer, MatrixAnswer};
use coface_algebra::chains::{AcyclicMatching, ChainComplex};
use coface_algebra::{CellId, Error, SparseMatrix, UnionFind};
use coface_io::Model;
use std::collections::BTreeMap;

/// More blocks than this have one name together: the smallest.
const MOST_BLOCKS: usize = 24;

/// By what the cells of a boundary matrix are put in blocks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum MatrixBlocks {
    /// The components of the complex: cells that boundaries connect. The matrix is the direct sum of its blocks.
    Components,
    /// The named groups of a mesh in whose closure a cell lies.
    Groups,
    /// What an acyclic matching makes of a cell: it is matched with a face, with a cell that it is a face of, or critical. Matched rows and columns
    /// are in the order of elimination: their block has units on its diagonal and zeros above it.
    Matching,
}

/// A boundary matrix whose rows and columns are in blocks.
///
/// # Examples
/// ```
/// use coface_answers::{BlockedMatrix, MatrixBlocks, Producer};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let two = coface_io::read(&b"[[0,1,2],[3,4,5]]"[..], coface_io::Format::Json)?;
/// let producer = Producer::of(two.clone())?;
/// let found = BlockedMatrix::of(&producer, &two, 2, MatrixBlocks::Components)?;
/// let names = |blocks: &[(String, usize)]| blocks.iter().map(|(name, size)| format!("{name}: {size}")).collect::<Vec<_>>();
/// assert_eq!(names(found.row_blocks()), ["component 1: 3", "component 2: 3"]);
/// assert_eq!(names(found.column_blocks()), ["component 1: 1", "component 2: 1"]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct BlockedMatrix {
    degree: usize,
    matrix: SparseMatrix,
    rows: Side,
    columns: Side,
}

/// The rows or the columns of a matrix: the cells in their order, and the blocks with their names and sizes.
#[derive(Clone, Debug)]
struct Side {
    order: Vec<u32>,
    blocks: Vec<(String, usize)>,
}

impl Side {
    /// Cells by the number of their block; those of one block in the order of their numbers.
    fn of_classes(classes: &[u32], names: &[String]) -> Self {
        let mut order: Vec<u32> = (0..classes.len() as u32).collect();
        order.sort_by_key(|&cell| classes[cell as usize]);
        let mut blocks: Vec<(String, usize)> = names.iter().map(|name| (name.clone(), 0)).collect();
        classes.iter().for_each(|&class| blocks[class as usize].1 += 1);
        blocks.retain(|(_, size)| *size > 0);
        Self { order, blocks }
    }

    /// Blocks as they are listed.
    fn of_lists(lists: Vec<(&str, Vec<u32>)>) -> Self {
        let lists: Vec<_> = lists.into_iter().filter(|(_, cells)| !cells.is_empty()).collect();
        let blocks = lists.iter().map(|(name, cells)| ((*name).to_owned(), cells.len())).collect();
        Self { order: lists.into_iter().flat_map(|(_, cells)| cells).collect(), blocks }
    }
}

impl BlockedMatrix {
    /// The boundary matrix of a degree in blocks. The model is the one that the producer was made of.
    ///
    /// # Errors
    /// Those of [`Producer::chain_complex`]; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for degree 0 or one above the
    /// dimension, and for groups where the model has none.
    ///
    /// # Complexity
    /// Near linear in the entries of all boundary matrices.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{BlockedMatrix, MatrixBlocks, Producer};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let disk = coface_io::read(&b"[[0,1,2]]"[..], coface_io::Format::Json)?;
    /// let found = BlockedMatrix::of(&Producer::of(disk.clone())?, &disk, 1, MatrixBlocks::Matching)?;
    /// assert_eq!(found.row_blocks()[0], ("matched with edges".to_owned(), 2));
    /// assert_eq!(found.row_blocks()[1], ("critical".to_owned(), 1));
    /// # Ok(()) }
    /// ```
    pub fn of(
        producer: &Producer,
        model: &Model,
        degree: usize,
        blocks: MatrixBlocks,
    ) -> Result<Self, Error> {
        let complex = producer.chain_complex()?;
        let Some(matrix) = complex.boundary_matrix(degree).cloned() else {
            let top = complex.degree_count().saturating_sub(1);
            let fault = format!("there is no boundary matrix of degree {degree}");
            return Err(match top {
                0 => Error::invalid(format!("{fault}: the model has vertices alone"))
                    .with_cure("give a model with edges"),
                top => Error::invalid(fault).with_cure(format!("give a degree from 1 to {top}")),
            });
        };
        let [rows, columns] = match blocks {
            MatrixBlocks::Components => {
                let (classes, count) = components(&complex);
                sides(&classes, &numbered_names(count), degree)
            }
            MatrixBlocks::Groups => {
                let (classes, names) = groups(producer, model, &complex)?;
                sides(&classes, &names, degree)
            }
            MatrixBlocks::Matching => matched(&complex, degree),
        };
        Ok(Self { degree, matrix, rows, columns })
    }

    /// The degree: columns are cells of it, rows those of the degree below.
    ///
    /// # Examples
    /// See [`BlockedMatrix`].
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// The matrix with its rows and columns as the chain complex has them.
    ///
    /// # Examples
    /// See [`BlockedMatrix`].
    pub fn matrix(&self) -> &SparseMatrix {
        &self.matrix
    }

    /// The rows in the order of their blocks.
    ///
    /// # Examples
    /// See [`BlockedMatrix`].
    pub fn row_order(&self) -> &[u32] {
        &self.rows.order
    }

    /// The columns in the order of their blocks.
    ///
    /// # Examples
    /// See [`BlockedMatrix`].
    pub fn column_order(&self) -> &[u32] {
        &self.columns.order
    }

    /// The blocks of rows with their sizes, in their order; none of them is empty.
    ///
    /// # Examples
    /// See [`BlockedMatrix`].
    pub fn row_blocks(&self) -> &[(String, usize)] {
        &self.rows.blocks
    }

    /// The blocks of columns with their sizes, in their order; none of them is empty.
    ///
    /// # Examples
    /// See [`BlockedMatrix`].
    pub fn column_blocks(&self) -> &[(String, usize)] {
        &self.columns.blocks
    }

    /// The blocks as plain data.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::{BlockedMatrix, MatrixBlocks, Producer};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let disk = coface_io::read(&b"[[0,1,2]]"[..], coface_io::Format::Json)?;
    /// let found = BlockedMatrix::of(&Producer::of(disk.clone())?, &disk, 2, MatrixBlocks::Components)?;
    /// let answer = found.answer();
    /// assert_eq!((answer.degree, answer.rows[0].size, answer.entries_count), (2, 3, 3));
    /// # Ok(()) }
    /// ```
    pub fn answer(&self) -> MatrixAnswer {
        let blocks = |side: &Side| {
            side.blocks.iter().map(|(name, size)| BlockAnswer { name: name.clone(), size: *size }).collect()
        };
        MatrixAnswer {
            degree: self.degree,
            rows: blocks(&self.rows),
            columns: blocks(&self.columns),
            entries_count: self.matrix.entry_count(),
        }
    }
}

/// The rows and columns of the matrix of a degree by the classes of all cells.
fn sides(classes: &[Vec<u32>], names: &[String], degree: usize) -> [Side; 2] {
    [degree - 1, degree].map(|degree| Side::of_classes(&classes[degree], names))
}

/// For each degree the component of each cell, the largest first, and their number.
fn components(complex: &ChainComplex) -> (Vec<Vec<u32>>, usize) {
    let counts = (0..complex.degree_count()).map(|degree| complex.cell_count(degree));
    let starts: Vec<usize> = std::iter::once(0)
        .chain(counts.scan(0, |sum, count| {
            *sum += count;
            Some(*sum)
        }))
        .collect();
    let total = starts.last().copied().unwrap_or(0);
    let mut classes = UnionFind::new(total);
    for (below, matrix) in complex.boundary_matrices().iter().enumerate() {
        for (cell, column) in matrix.columns().enumerate() {
            for (face, _) in column.iter() {
                classes.unite((starts[below] + face) as u32, (starts[below + 1] + cell) as u32);
            }
        }
    }
    let numbers = classes.class_numbers();
    let mut sizes = vec![0usize; classes.class_count()];
    numbers.iter().for_each(|&number| sizes[number as usize] += 1);
    let mut order: Vec<u32> = (0..sizes.len() as u32).collect();
    order.sort_by_key(|&class| std::cmp::Reverse(sizes[class as usize]));
    let mut places = vec![0u32; sizes.len()];
    (0..).zip(&order).for_each(|(place, &class)| places[class as usize] = place);
    let last = MOST_BLOCKS as u32 - 1;
    let place = |number: &u32| {
        let place = places[*number as usize];
        if sizes.len() > MOST_BLOCKS { place.min(last) } else { place }
    };
    let cells = starts.windows(2).map(|ends| numbers[ends[0]..ends[1]].iter().map(place).collect());
    (cells.collect(), sizes.len())
}

fn numbered_names(count: usize) -> Vec<String> {
    let named = if count > MOST_BLOCKS { MOST_BLOCKS - 1 } else { count };
    let mut names: Vec<String> = (1..=named).map(|number| format!("component {number}")).collect();
    if count > named {
        names.push(format!("{} more components", count - named));
    }
    names
}

/// For each degree the class of each cell, and the names of the classes: the groups in whose closure it lies.
fn groups(
    producer: &Producer,
    model: &Model,
    complex: &ChainComplex,
) -> Result<(Vec<Vec<u32>>, Vec<String>), Error> {
    if model.groups().is_empty() {
        return Err(Error::invalid("the model has no groups")
            .with_cure("give a mesh with physical groups, as Gmsh writes them, or take other blocks"));
    }
    // For each cell the groups whose closure has it, rising.
    let counts: Vec<usize> = (0..complex.degree_count()).map(|degree| complex.cell_count(degree)).collect();
    let mut sets: Vec<Vec<Vec<u32>>> = counts.iter().map(|&count| vec![Vec::new(); count]).collect();
    for (number, group) in (0..).zip(model.groups()) {
        let mut waiting: Vec<(usize, CellId)> = producer.cells_of_groups(model, &[group])?;
        while let Some((degree, cell)) = waiting.pop() {
            let own = &mut sets[degree][cell.index()];
            if own.last() == Some(&number) {
                continue;
            }
            own.push(number);
            if let Some(matrix) = complex.boundary_matrix(degree) {
                waiting.extend(
                    matrix.column(cell.index()).iter().map(|(face, _)| (degree - 1, CellId::new(face))),
                );
            }
        }
    }
    let mut sizes: BTreeMap<&[u32], usize> = BTreeMap::new();
    sets.iter().flatten().for_each(|set| *sizes.entry(set).or_default() += 1);
    // Groups by themselves in their order, then what lies in several, then the rest; small ones are one.
    let mut kinds: Vec<(&[u32], usize)> = sizes.into_iter().collect();
    kinds.sort_by_key(|(set, _)| (set.is_empty(), set.len(), *set));
    let mut small: Vec<&[u32]> = Vec::new();
    if kinds.len() > MOST_BLOCKS {
        let mut by_size: Vec<(&[u32], usize)> = kinds.clone();
        by_size.sort_by_key(|&(_, size)| std::cmp::Reverse(size));
        small = by_size[MOST_BLOCKS - 1..].iter().map(|(set, _)| *set).collect();
        small.sort_unstable();
        kinds.retain(|(set, _)| small.binary_search(set).is_err());
    }
    let name = |set: &[u32]| match set {
        [] => "no group".to_owned(),
        _ => {
            let names: Vec<&str> = set.iter().map(|&number| model.groups()[number as usize].name()).collect();
            names.join(" & ")
        }
    };
    let mut names: Vec<String> = kinds.iter().map(|(set, _)| name(set)).collect();
    if !small.is_empty() {
        names.push(format!("{} more intersections", small.len()));
    }
    let place: BTreeMap<&[u32], u32> = kinds.iter().map(|(set, _)| *set).zip(0..).collect();
    let rest = kinds.len() as u32;
    let class = |set: &Vec<u32>| place.get(&set[..]).copied().unwrap_or(rest);
    let classes = sets.iter().map(|sets| sets.iter().map(class).collect()).collect();
    Ok((classes, names))
}

/// Rows that are matched with columns, critical ones, and those that are matched with their faces; columns that are matched with rows, critical
/// ones, and those that are matched from above. A matched row stands where its column does.
fn matched(complex: &ChainComplex, degree: usize) -> [Side; 2] {
    let matching = AcyclicMatching::new(complex);
    let faces = |degree: usize| -> Vec<u32> {
        matching.pairs(complex, degree).iter().map(|pair| pair.face().to_u32()).collect()
    };
    let cells = |degree: usize| -> Vec<u32> {
        matching.pairs(complex, degree).iter().map(|pair| pair.cell().to_u32()).collect()
    };
    let sorted = |mut list: Vec<u32>| {
        list.sort_unstable();
        list
    };
    let name = |degree: usize| match ["vertices", "edges", "faces", "3-cells"].get(degree) {
        Some(name) => format!("matched with {name}"),
        None => format!("matched with {degree}-cells"),
    };
    let names =
        [degree.checked_sub(2).map_or(String::new(), name), name(degree - 1), name(degree), name(degree + 1)];
    let critical = |degree: usize| matching.critical_cells(degree).to_vec();
    [
        Side::of_lists(vec![
            (&names[2], faces(degree)),
            ("critical", critical(degree - 1)),
            (&names[0], sorted(cells(degree - 1))),
        ]),
        Side::of_lists(vec![
            (&names[1], cells(degree)),
            ("critical", critical(degree)),
            (&names[3], sorted(faces(degree + 1))),
        ]),
    ]
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_io::{Format, Group, GroupKind, read};

    fn found(text: &str, degree: usize, blocks: MatrixBlocks) -> Result<BlockedMatrix, Error> {
        let model = read(text.as_bytes(), Format::Json).unwrap();
        BlockedMatrix::of(&Producer::of(model.clone()).unwrap(), &model, degree, blocks)
    }

    /// The rows and columns of a matrix are each there once, and the blocks add up to them.
    fn check(found: &BlockedMatrix) {
        for (side, count) in
            [(&found.rows, found.matrix.row_count()), (&found.columns, found.matrix.column_count())]
        {
            let mut sorted = side.order.clone();
            sorted.sort_unstable();
            assert!(sorted.iter().copied().eq(0..count as u32));
            assert_eq!(side.blocks.iter().map(|(_, size)| size).sum::<usize>(), count);
        }
    }

    /// The entries by the places of their rows and columns in the order of blocks.
    fn placed(found: &BlockedMatrix) -> Vec<(usize, usize, i32)> {
        let place = |order: &[u32]| {
            let mut places = vec![0; order.len()];
            order.iter().enumerate().for_each(|(place, &cell)| places[cell as usize] = place);
            places
        };
        let (rows, columns) = (place(&found.rows.order), place(&found.columns.order));
        let entries = found.matrix.columns().enumerate();
        entries
            .flat_map(|(column, entries)| {
                entries.iter().map(|(row, x)| (rows[row], columns[column], x)).collect::<Vec<_>>()
            })
            .collect()
    }

    const TORUS_AND_SPHERE: &str = "[[0,1,3],[0,3,2],[1,2,4],[1,4,3],[2,3,5],[2,5,4],[3,4,6],[3,6,5],[4,5,0],[4,0,6],[5,6,1],[5,1,0],[6,0,2],[6,2,1],[10,11,12],[10,11,13],[10,12,13],[11,12,13]]";

    #[test]
    fn components_are_a_direct_sum() {
        for degree in [1, 2] {
            let found = found(TORUS_AND_SPHERE, degree, MatrixBlocks::Components).unwrap();
            check(&found);
            let sizes = |blocks: &[(String, usize)]| blocks.iter().map(|(_, size)| *size).collect::<Vec<_>>();
            let (rows, columns) = (sizes(found.row_blocks()), sizes(found.column_blocks()));
            assert_eq!(
                (rows.clone(), columns.clone()),
                if degree == 1 { (vec![7, 4], vec![21, 6]) } else { (vec![21, 6], vec![14, 4]) }
            );
            assert!(placed(&found).iter().all(|&(row, column, _)| (row < rows[0]) == (column < columns[0])));
        }
    }

    #[test]
    fn matched_cells_have_units_on_a_diagonal_and_zeros_above() {
        for degree in [1, 2] {
            let found = found(TORUS_AND_SPHERE, degree, MatrixBlocks::Matching).unwrap();
            check(&found);
            let size = found.row_blocks()[0].1;
            assert_eq!(found.column_blocks()[0].1, size);
            let mut diagonal = 0;
            for (row, column, x) in
                placed(&found).into_iter().filter(|&(row, column, _)| row < size && column < size)
            {
                // The face of a pair is in the boundary of no later cell.
                assert!(column <= row, "degree {degree}: {row} {column}");
                if row == column {
                    assert_eq!(x.abs(), 1);
                    diagonal += 1;
                }
            }
            assert_eq!(diagonal, size);
        }
        // Critical cells of a perfect matching: a vertex for each component, two loops, two surfaces.
        let critical = |degree: usize| {
            let found = found(TORUS_AND_SPHERE, degree, MatrixBlocks::Matching).unwrap();
            let of = |blocks: &[(String, usize)]| {
                blocks.iter().find(|(name, _)| name == "critical").map_or(0, |block| block.1)
            };
            [of(found.row_blocks()), of(found.column_blocks())]
        };
        assert_eq!([critical(1), critical(2)], [[2, 2], [2, 2]]);
    }

    #[test]
    fn groups_are_closed_and_what_lies_in_several_is_a_block() {
        let square =
            read(&b"OFF\n4 2 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n3 0 1 2\n3 0 2 3\n"[..], Format::Off).unwrap();
        let square = square.with_group(Group::new("left", GroupKind::Polygons, vec![1])).unwrap();
        let square = square.with_group(Group::new("right", GroupKind::Polygons, vec![0])).unwrap();
        let producer = Producer::of(square.clone()).unwrap();
        let found = BlockedMatrix::of(&producer, &square, 2, MatrixBlocks::Groups).unwrap();
        check(&found);
        let named = |name: &str, size: usize| (name.to_owned(), size);
        assert_eq!(found.row_blocks(), [named("left", 2), named("right", 2), named("left & right", 1)]);
        assert_eq!(found.column_blocks(), [named("left", 1), named("right", 1)]);
        let bare = super::tests::found("[[0,1,2]]", 2, MatrixBlocks::Groups).unwrap_err();
        assert!(bare.message().contains("no groups") && bare.cure().is_some());
    }

    #[test]
    fn degrees_without_a_matrix_are_refused() {
        for degree in [0, 3] {
            let error = found(TORUS_AND_SPHERE, degree, MatrixBlocks::Components).unwrap_err();
            assert!(error.to_string().contains("from 1 to 2"), "{error}");
        }
        let points = found("[[0],[1]]", 1, MatrixBlocks::Components).unwrap_err();
        assert!(points.to_string().contains("vertices alone"), "{points}");
    }

    #[test]
    fn many_components_share_a_block() {
        let edges: Vec<[u32; 2]> = (0..40).map(|i| [2 * i, 2 * i + 1]).collect();
        let found = found(&serde_json::to_string(&edges).unwrap(), 1, MatrixBlocks::Components).unwrap();
        check(&found);
        assert_eq!(found.column_blocks().len(), MOST_BLOCKS);
        assert_eq!(found.column_blocks()[23], ("17 more components".to_owned(), 17));
    }
}
