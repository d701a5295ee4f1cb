//! Cuboid grids and the numbers of their cells.

use super::AxisSet;
use super::axis::Axis;
use coface_algebra::{CellId, Error, ErrorKind};
use coface_geometry::Positions;
use rayon::prelude::*;

/// A grid of cuboids in any dimension, with all faces; the module page has the conventions.
///
/// A cell exists if all its intervals are full; the lower cells are the faces of those. So the grid is the product of its
/// axes, and every number is computed, never looked up: a grid takes no room but for its axes.
///
/// # Examples
/// The unit cube, and a row of two squares with an empty place between them:
/// ```
/// use coface_complexes::grids::CuboidGrid;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let cube = CuboidGrid::new(&[1, 1, 1])?;
/// assert_eq!(cube.f_vector(), [8, 12, 6, 1]);
/// assert_eq!(cube.cells(2)?.list(0), [0, 1, 2, 3]);
/// let squares = CuboidGrid::with_lengths(&[vec![1.0, -1.0, 1.0], vec![1.0]])?;
/// assert_eq!(squares.f_vector(), [8, 8, 2]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CuboidGrid {
    axes: Vec<Axis>,
    /// The p-cells at position p, none without cells.
    blocks: Vec<Vec<Block>>,
    cell_counts: Vec<usize>,
}

/// The cells that extend along the same axes: consecutive numbers from `start` on.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Block {
    pub(super) extent: AxisSet,
    pub(super) start: u32,
}

/// A cell of a [`CuboidGrid`] by its place.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct GridCell {
    extent: AxisSet,
    corner: Vec<u32>,
}

impl GridCell {
    /// The cell that extends along these axes from this corner, the number of a line for each axis.
    pub fn new(extent: AxisSet, corner: Vec<u32>) -> Self {
        Self { extent, corner }
    }

    /// The axes along which it extends.
    pub fn extent(&self) -> AxisSet {
        self.extent
    }

    /// For each axis its line, the lower one of two where it extends.
    pub fn corner(&self) -> &[u32] {
        &self.corner
    }
}

impl CuboidGrid {
    /// The grid with `shape[i]` unit intervals along axis i. An axis with none is a single line at 0, and no cell extends
    /// along it; without axes the grid is one point.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] for more than 32 axes, and if the cells of some dimension are more than $2^{32} - 1$.
    ///
    /// # Complexity
    /// $O(2^d)$ for d axes with intervals; their lengths do not matter.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::CuboidGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(CuboidGrid::new(&[3, 2, 1])?.f_vector(), [24, 46, 29, 6]);
    /// assert_eq!(CuboidGrid::new(&[2, 0])?.f_vector(), [3, 2]);
    /// assert_eq!(CuboidGrid::new(&[])?.f_vector(), [1]);
    /// # Ok(()) }
    /// ```
    pub fn new(shape: &[u32]) -> Result<Self, Error> {
        Self::from_axes(shape.iter().map(|&count| Axis::Unit(count)).collect())
    }

    /// The grid whose axes start at 0 and have intervals of these lengths, empty where a length is negative. Lines
    /// between two empty intervals carry no cell; an axis with empty intervals only makes the grid empty.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] naming a length that is zero, not finite, or lost when it is added to the ones before;
    /// [`ErrorKind::TooLarge`] as [`Self::new`].
    ///
    /// # Examples
    /// A plate with a hole is not a product; four legs are:
    /// ```
    /// use coface_complexes::grids::CuboidGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let legs = CuboidGrid::with_lengths(&[vec![0.5, -3.0, 0.5], vec![0.5, -1.0, 0.5], vec![2.0]])?;
    /// assert_eq!(legs.f_vector(), [32, 48, 24, 4]);
    /// assert_eq!(legs.positions()?.as_flat()[3 * 31..], [4.0, 2.0, 2.0]);
    /// # Ok(()) }
    /// ```
    pub fn with_lengths<L: AsRef<[f64]>>(lengths: &[L]) -> Result<Self, Error> {
        let axes = lengths.iter().enumerate().map(|(i, lengths)| Axis::from_lengths(i, lengths.as_ref()));
        Self::from_axes(axes.collect::<Result<_, _>>()?)
    }

    fn from_axes(axes: Vec<Axis>) -> Result<Self, Error> {
        if axes.len() > AxisSet::LIMIT {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("a grid with {} axes; the limit is {}", axes.len(), AxisSet::LIMIT),
            ));
        }
        if axes.iter().any(|axis| axis.point_count() == 0) {
            return Ok(Self { axes, blocks: Vec::new(), cell_counts: Vec::new() });
        }
        let cell_counts = cell_counts(&axes)?;
        let whole: AxisSet = (0..axes.len()).filter(|&i| axes[i].interval_count() > 0).collect();
        let mut grid = Self { axes, blocks: vec![Vec::new(); cell_counts.len()], cell_counts };
        let mut starts = vec![0u64; grid.cell_counts.len()];
        for extent in whole.subsets() {
            let start = &mut starts[extent.len()];
            grid.blocks[extent.len()].push(Block { extent, start: *start as u32 });
            *start += grid.sizes(extent).map(u64::from).product::<u64>();
        }
        debug_assert!(starts.iter().zip(&grid.cell_counts).all(|(&start, &count)| start == count as u64));
        Ok(grid)
    }

    /// The number of axes, which is the number of coordinates of a vertex.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::CuboidGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let grid = CuboidGrid::new(&[2, 1])?;
    /// assert_eq!(grid.axis_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn axis_count(&self) -> usize {
        self.axes.len()
    }

    /// The greatest dimension of a cell, the number of axes with a full interval; `None` for an empty grid.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::CuboidGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let grid = CuboidGrid::new(&[2, 1])?;
    /// assert_eq!(grid.dimension(), Some(2));
    /// # Ok(()) }
    /// ```
    pub fn dimension(&self) -> Option<usize> {
        self.cell_counts.len().checked_sub(1)
    }

    /// The number of cells of this dimension: the sum over sets S of axes of that size of the product of interval
    /// counts over S and point counts over the other axes.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::CuboidGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let grid = CuboidGrid::new(&[2, 1])?;
    /// assert_eq!(grid.cell_count(2), 2);
    /// # Ok(()) }
    /// ```
    pub fn cell_count(&self, dimension: usize) -> usize {
        self.cell_counts.get(dimension).copied().unwrap_or(0)
    }

    /// The numbers of cells of dimension 0, 1, ...; empty for an empty grid.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::CuboidGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let grid = CuboidGrid::new(&[2, 1])?;
    /// assert_eq!(grid.f_vector(), [6, 7, 2]);
    /// # Ok(()) }
    /// ```
    pub fn f_vector(&self) -> Vec<usize> {
        self.cell_counts.clone()
    }

    /// The place of a cell.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Complexity
    /// $O(d)$ for d axes.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_complexes::grids::{AxisSet, CuboidGrid};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let grid = CuboidGrid::new(&[2, 1, 1])?;
    /// // Of 20 edges the first 6 extend along the last axis, the last 8 along the first.
    /// let edge = grid.cell(1, CellId::new(19));
    /// assert_eq!(edge.extent(), AxisSet::from_iter([0]));
    /// assert_eq!(edge.corner(), [1, 1, 1]);
    /// assert_eq!(grid.number(&edge), Some(CellId::new(19)));
    /// # Ok(()) }
    /// ```
    pub fn cell(&self, dimension: usize, cell: CellId) -> GridCell {
        let (extent, mut corner) = self.place(dimension, cell);
        for (i, place) in corner.iter_mut().enumerate() {
            let axis = &self.axes[i];
            *place = axis.line(if extent.contains(i) { axis.lower_point(*place) } else { *place });
        }
        GridCell { extent, corner }
    }

    /// The number of a cell among those of its dimension; `None` if the grid has no such cell.
    ///
    /// # Complexity
    /// $O(d)$ for d axes, times the logarithm of their lengths where lengths are given.
    pub fn number(&self, cell: &GridCell) -> Option<CellId> {
        if cell.corner.len() != self.axes.len() {
            return None;
        }
        let block = self.block(cell.extent)?;
        let mut number = 0u64;
        for (i, (axis, size)) in self.axes.iter().zip(self.sizes(cell.extent)).enumerate() {
            let point = axis.point_on(cell.corner[i])?;
            let place = if cell.extent.contains(i) { axis.interval_above(point)? } else { point };
            number = number * u64::from(size) + u64::from(place);
        }
        Some(CellId::from_u32(block.start + number as u32))
    }

    /// The vertices of a cell in the order of their numbers.
    ///
    /// # Panics
    /// If there is no such cell.
    pub fn vertices(&self, dimension: usize, cell: CellId) -> Vec<u32> {
        let (extent, corner) = self.place(dimension, cell);
        let strides = self.strides(AxisSet::default());
        let base: u32 = corner
            .iter()
            .enumerate()
            .map(|(i, &place)| {
                strides[i] * if extent.contains(i) { self.axes[i].lower_point(place) } else { place }
            })
            .sum();
        self.vertex_offsets(extent).iter().map(|offset| base + offset).collect()
    }

    /// The positions of the vertices: a coordinate for each axis. The grid without axes has a vertex but no positions.
    ///
    /// # Errors
    /// None for a grid that could be made.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::CuboidGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = CuboidGrid::new(&[1, 1])?;
    /// assert_eq!(square.positions()?.as_flat(), [0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 1.0, 1.0]);
    /// # Ok(()) }
    /// ```
    pub fn positions(&self) -> Result<Positions, Error> {
        let Some(last) = self.axes.len().checked_sub(1) else { return Ok(Positions::default()) };
        let sizes: Vec<u32> = self.sizes(AxisSet::default()).collect();
        if self.cell_count(0) == 0 {
            return Positions::from_flat(self.axes.len(), Vec::new());
        }
        let row_points = sizes[last] as usize;
        let mut coordinates = vec![0.0; self.cell_count(0) * self.axes.len()];
        let rows = rows_per_piece(row_points);
        coordinates.par_chunks_mut(rows * row_points * self.axes.len()).enumerate().for_each(
            |(piece, points)| {
                let mut outer = Counter::at(&sizes[..last], piece * rows);
                for row in points.chunks_mut(row_points * self.axes.len()) {
                    for (c, point) in row.chunks_exact_mut(self.axes.len()).enumerate() {
                        for (i, &place) in outer.places.iter().enumerate() {
                            point[i] = self.axes[i].coordinate(place);
                        }
                        point[last] = self.axes[last].coordinate(c as u32);
                    }
                    outer.advance();
                }
            },
        );
        Positions::from_flat(self.axes.len(), coordinates)
    }

    pub(super) fn axes(&self) -> &[Axis] {
        &self.axes
    }

    /// The blocks of the cells of one dimension, in order.
    pub(super) fn blocks(&self, dimension: usize) -> &[Block] {
        self.blocks.get(dimension).map_or(&[], Vec::as_slice)
    }

    /// The block of the cells that extend along these axes.
    pub(super) fn block(&self, extent: AxisSet) -> Option<Block> {
        let blocks = self.blocks(extent.len());
        blocks.binary_search_by_key(&extent, |block| block.extent).ok().map(|i| blocks[i])
    }

    /// For each axis the number of places that cells with this extent can have.
    pub(super) fn sizes(&self, extent: AxisSet) -> impl DoubleEndedIterator<Item = u32> + Clone {
        self.axes.iter().enumerate().map(move |(i, axis)| {
            (if extent.contains(i) { axis.interval_count() } else { axis.point_count() }) as u32
        })
    }

    /// For each axis by how much numbers of cells with this extent grow from one place to the next.
    pub(super) fn strides(&self, extent: AxisSet) -> Vec<u32> {
        let mut stride = 1u32;
        let mut strides: Vec<u32> = self
            .sizes(extent)
            .rev()
            .map(|size| {
                let own = stride;
                // Beyond 32 bits only where the extent has no cell.
                stride = stride.wrapping_mul(size);
                own
            })
            .collect();
        strides.reverse();
        strides
    }

    /// What the vertices of a cell with this extent add to its corner, rising.
    pub(super) fn vertex_offsets(&self, extent: AxisSet) -> Vec<u32> {
        let strides = self.strides(AxisSet::default());
        let mut offsets = vec![0];
        for axis in extent.iter() {
            offsets = offsets.iter().flat_map(|&offset| [offset, offset + strides[axis]]).collect();
        }
        offsets
    }

    /// The extent of a cell, and for each axis the number of its interval or point.
    ///
    /// # Panics
    /// If there is no such cell.
    pub(super) fn place(&self, dimension: usize, cell: CellId) -> (AxisSet, Vec<u32>) {
        assert!(
            cell.index() < self.cell_count(dimension),
            "the grid has {} cells of dimension {dimension}, so no cell {cell}",
            self.cell_count(dimension)
        );
        let blocks = self.blocks(dimension);
        let block = blocks[blocks.partition_point(|block| block.start <= cell.to_u32()) - 1];
        let sizes: Vec<u32> = self.sizes(block.extent).collect();
        (block.extent, Counter::at(&sizes, cell.index() - block.start as usize).places)
    }
}

/// The numbers of cells of dimension 0, 1, ...: the coefficients of the product of (points + intervals x) over the axes.
fn cell_counts(axes: &[Axis]) -> Result<Vec<usize>, Error> {
    let mut counts = vec![1u64];
    for axis in axes {
        if axis.interval_count() > 0 {
            counts.push(0);
        }
        for p in (0..counts.len()).rev() {
            let extended = if p > 0 { counts[p - 1].checked_mul(axis.interval_count()) } else { Some(0) };
            counts[p] = counts[p]
                .checked_mul(axis.point_count())
                .and_then(|flat| flat.checked_add(extended?))
                .filter(|&count| u32::try_from(count).is_ok())
                .ok_or_else(|| {
                    Error::new(
                        ErrorKind::TooLarge,
                        format!("the grid has more than 2^32 - 1 cells of dimension {p}"),
                    )
                    .with_cure("make it of several smaller grids")
                })?;
        }
    }
    Ok(counts.into_iter().map(|count| count as usize).collect())
}

/// How many rows of this length one thread fills at a time.
pub(super) fn rows_per_piece(row_length: usize) -> usize {
    ((1 << 14) / row_length.max(1)).max(1)
}

/// A number with a digit for each axis, the last one fastest.
pub(super) struct Counter<'a> {
    sizes: &'a [u32],
    pub(super) places: Vec<u32>,
}

impl<'a> Counter<'a> {
    /// The counter at a number.
    pub(super) fn at(sizes: &'a [u32], mut number: usize) -> Self {
        let mut places = vec![0; sizes.len()];
        for (place, &size) in places.iter_mut().zip(sizes).rev() {
            *place = (number % size as usize) as u32;
            number /= size as usize;
        }
        Self { sizes, places }
    }

    /// To the next number; after the last one to zero.
    pub(super) fn advance(&mut self) {
        for (place, &size) in self.places.iter_mut().zip(self.sizes).rev() {
            *place += 1;
            if *place < size {
                return;
            }
            *place = 0;
        }
    }
}
