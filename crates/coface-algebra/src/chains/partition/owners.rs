//! Partitions of a complex in memory into parts.

use super::keys::Keys;
use super::part::Part;
use crate::chains::ChainComplex;
use crate::ids::narrow;
use crate::matrices::RaggedArray;
use crate::{Error, ErrorKind};
use std::collections::VecDeque;

/// The parts of one complex, computed on demand.
pub trait Parts: Sync {
    /// The number of parts, 1 at least; some may be empty.
    fn part_count(&self) -> u32;

    /// The part of this number. Each call gives the same part.
    ///
    /// # Errors
    /// If the part cannot be made: it is too large, or its source cannot be read.
    ///
    /// # Panics
    /// If there is no such part.
    fn part(&self, number: u32) -> Result<Part, Error>;
}

/// A chain complex whose maximal cells have owners. The ids of its parts are the numbers of the cells.
///
/// # Examples
/// A path of two edges, one edge for each part: the vertex between them belongs to both parts.
/// ```
/// use coface_algebra::RaggedArray;
/// use coface_algebra::chains::{Partition, TwoSkeleton};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let path = TwoSkeleton::new(3, vec![0, 1, 1, 2], RaggedArray::new())?.chain_complex()?;
/// let partition = Partition::new(&path, 2, |_, edge| edge)?;
/// assert_eq!((partition.cells(0, 0), partition.cells(0, 1)), (&[0, 1][..], &[1, 2][..]));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct Partition<'a> {
    complex: &'a ChainComplex,
    keys: Keys,
    part_count: u32,
    /// For each degree the cells of each part, rising.
    cells: Vec<RaggedArray>,
}

impl<'a> Partition<'a> {
    /// The partition by these owners: `owner(k, cell)` is asked for the cells of degree k that are a face of no other.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for 0 parts, and for an owner that is not below `part_count`;
    /// [`ErrorKind::TooLarge`] where the parts have more than 2^32 - 1 cells of one degree together, those in shared
    /// strata counted once for each part.
    ///
    /// # Complexity
    /// Linear in the boundary matrices and the sizes of the parts.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, Partition};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(3);
    /// assert_eq!(Partition::new(&points, 2, |_, point| point % 2)?.cells(0, 0), [0, 2]);
    /// # Ok(()) }
    /// ```
    pub fn new(
        complex: &'a ChainComplex,
        part_count: u32,
        owner: impl Fn(usize, u32) -> u32,
    ) -> Result<Self, Error> {
        if part_count == 0 {
            return Err(Error::invalid("a complex cannot be cut into 0 parts").with_cure("ask for 1 or more"));
        }
        let keys = Keys::of_owners(complex, owner);
        if let Some(&part) = keys.sets.items().iter().find(|&&part| part >= part_count) {
            return Err(Error::invalid(format!(
                "a cell is owned by part {part}, but there are {part_count} parts"
            ))
            .with_cure("number the parts from 0"));
        }
        let cells =
            (0..complex.degree_count()).map(|degree| {
                let of_cell = &keys.of_cell[degree];
                let total: usize = of_cell.iter().map(|&key| keys.sets.list(key as usize).len()).sum();
                if u32::try_from(total).is_err() {
                    return Err(Error::new(
                        ErrorKind::TooLarge,
                        format!(
                            "the parts have {total} cells of degree {degree} together; the limit is 2^32 - 1"
                        ),
                    ));
                }
                let with_parts = || {
                    of_cell.iter().enumerate().flat_map(|(cell, &key)| {
                        keys.sets.list(key as usize).iter().map(move |&part| (part, narrow(cell)))
                    })
                };
                let places = RaggedArray::grouped(part_count as usize, with_parts().map(|(part, _)| part));
                // Places count pairs of a cell and a part; cells come instead of them.
                let cell_of_place: Vec<u32> = with_parts().map(|(_, cell)| cell).collect();
                Ok(RaggedArray::from_lists(places.iter().map(|list| {
                    list.iter().map(|&place| cell_of_place[place as usize]).collect::<Vec<u32>>()
                })))
            });
        let cells = cells.collect::<Result<_, Error>>()?;
        Ok(Self { complex, keys, part_count, cells })
    }

    /// A partition into `part_count` parts with nearly equal numbers of maximal cells, along a breadth-first walk
    /// through cells that share faces. Parts are connected where the remaining cells are.
    ///
    /// # Errors
    /// As [`Self::new`].
    ///
    /// # Complexity
    /// Linear in the boundary matrices.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{Partition, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = TwoSkeleton::new(3, vec![0, 1, 1, 2], RaggedArray::new())?.chain_complex()?;
    /// let partition = Partition::by_walk(&path, 2)?;
    /// assert_eq!((partition.cells(1, 0), partition.cells(1, 1)), (&[0][..], &[1][..]));
    /// # Ok(()) }
    /// ```
    pub fn by_walk(complex: &'a ChainComplex, part_count: u32) -> Result<Self, Error> {
        let owners = walk_owners(complex, part_count.max(1));
        Self::new(complex, part_count, |degree, cell| owners[degree][cell as usize])
    }

    /// The complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, Partition};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(3);
    /// assert_eq!(Partition::by_walk(&points, 2)?.complex(), &points);
    /// # Ok(()) }
    /// ```
    pub fn complex(&self) -> &'a ChainComplex {
        self.complex
    }

    /// The cells of a degree that a part has in its closure, rising.
    ///
    /// # Panics
    /// If there is no such part.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, Partition};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(3);
    /// assert_eq!(Partition::new(&points, 2, |_, point| point % 2)?.cells(0, 1), [1]);
    /// # Ok(()) }
    /// ```
    pub fn cells(&self, degree: usize, part: u32) -> &[u32] {
        self.cells.get(degree).map_or(&[], |cells| cells.list(part as usize))
    }

    /// The number of strata.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{Partition, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let path = TwoSkeleton::new(3, vec![0, 1, 1, 2], RaggedArray::new())?.chain_complex()?;
    /// // The insides of both parts, and the vertex between them.
    /// assert_eq!(Partition::new(&path, 2, |_, edge| edge)?.stratum_count(), 3);
    /// # Ok(()) }
    /// ```
    pub fn stratum_count(&self) -> usize {
        self.keys.sets.len()
    }
}

impl Parts for Partition<'_> {
    fn part_count(&self) -> u32 {
        self.part_count
    }

    /// Linear in the part, but for an array as long as the complex has cells of one degree.
    fn part(&self, number: u32) -> Result<Part, Error> {
        assert!(number < self.part_count, "there is no part {number}");
        let cells = |degree: usize| self.cells[degree].list(number as usize);
        let degrees = 0..self.complex.degree_count();
        let matrices = degrees.skip(1).map(|degree| {
            let matrix = self.complex.boundary_matrix(degree).expect("each degree has its matrix");
            let mut place = vec![0; matrix.row_count()];
            Part::local_matrix(matrix, cells(degree), cells(degree - 1), &mut place)
        });
        let matrices = matrices.collect::<Result<_, Error>>()?;
        let vertex_count = self.cells.first().map_or(0, |cells| cells.list(number as usize).len());
        let complex = ChainComplex::from_trusted(vertex_count, matrices);
        let degrees = 0..complex.degree_count();
        let ids = degrees.clone().map(|degree| cells(degree).iter().map(|&cell| u64::from(cell)).collect());
        let ids = ids.collect();
        Ok(Part::from_trusted(number, complex, ids, self.keys.renamed(degrees.map(cells), |part| part)))
    }
}

/// Owners of the maximal cells: the walk goes on in the lowest cell not seen where it comes to an end.
fn walk_owners(complex: &ChainComplex, part_count: u32) -> Vec<Vec<u32>> {
    let cofaces: Vec<_> =
        (0..complex.degree_count()).map(|degree| complex.coboundary_matrix(degree)).collect();
    let is_maximal = |degree: usize, cell: usize| {
        cofaces[degree].as_ref().is_none_or(|matrix| matrix.column(cell).rows().is_empty())
    };
    let mut maximal_count = 0;
    for (degree, &count) in complex.f_vector().iter().enumerate() {
        maximal_count += (0..count).filter(|&cell| is_maximal(degree, cell)).count();
    }
    let per_part = maximal_count.div_ceil(part_count as usize).max(1);
    let mut owners: Vec<Vec<u32>> = complex.f_vector().iter().map(|&count| vec![0; count]).collect();
    let mut seen: Vec<Vec<bool>> = complex.f_vector().iter().map(|&count| vec![false; count]).collect();
    let mut queue = VecDeque::new();
    let mut given = 0;
    for start_degree in (0..complex.degree_count()).rev() {
        for start in 0..complex.cell_count(start_degree) {
            if std::mem::replace(&mut seen[start_degree][start], true) {
                continue;
            }
            queue.push_back((start_degree, start));
            while let Some((degree, cell)) = queue.pop_front() {
                if is_maximal(degree, cell) {
                    owners[degree][cell] = narrow(given / per_part);
                    given += 1;
                }
                let mut visit = |degree: usize, cells: &[u32]| {
                    for &cell in cells {
                        if !std::mem::replace(&mut seen[degree][cell as usize], true) {
                            queue.push_back((degree, cell as usize));
                        }
                    }
                };
                if let Some(matrix) = complex.boundary_matrix(degree) {
                    visit(degree - 1, matrix.column(cell).rows());
                }
                if let Some(matrix) = &cofaces[degree] {
                    visit(degree + 1, matrix.column(cell).rows());
                }
            }
        }
    }
    owners
}
