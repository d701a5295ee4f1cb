//! The vertex lists of the cells of a grid.

use super::CuboidGrid;
use super::cuboid_grid::{Block, Counter, rows_per_piece};
use coface_algebra::RaggedArray;
use coface_algebra::{Error, ErrorKind};
use rayon::prelude::*;

impl CuboidGrid {
    /// The vertices of all cells of one dimension p, $2^p$ each.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] for more than $2^{32} - 1$ vertices in all lists.
    ///
    /// # Complexity
    /// Linear in the result, in parallel.
    ///
    /// # Examples
    /// The edges of the cube in the directions of the last, the middle and the first axis:
    /// ```
    /// use coface_complexes::grids::CuboidGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edges = CuboidGrid::new(&[1, 1, 1])?.cells(1)?;
    /// let expected =
    ///     [[0, 1], [2, 3], [4, 5], [6, 7], [0, 2], [1, 3], [4, 6], [5, 7], [0, 4], [1, 5], [2, 6], [3, 7]];
    /// assert!(edges.iter().eq(expected));
    /// # Ok(()) }
    /// ```
    pub fn cells(&self, dimension: usize) -> Result<RaggedArray, Error> {
        let Some(width) = 1usize.checked_shl(dimension as u32).filter(|_| self.cell_count(dimension) > 0)
        else {
            return Ok(RaggedArray::new());
        };
        let total = self.cell_count(dimension) as u64 * width as u64;
        if u32::try_from(total).is_err() {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!(
                    "the cells of dimension {dimension} have {total} vertices in all; the limit is 2^32 - 1"
                ),
            ));
        }
        let mut items = vec![0u32; total as usize];
        let mut rest = items.as_mut_slice();
        for block in self.blocks(dimension) {
            let count: usize = self.sizes(block.extent).map(|size| size as usize).product();
            let (own, after) = std::mem::take(&mut rest).split_at_mut(count * width);
            self.fill_block(*block, &self.vertex_offsets(block.extent), own);
            rest = after;
        }
        RaggedArray::uniform(width, items)
    }

    /// Writes for each cell of a block its corner plus each of these offsets.
    pub(super) fn fill_block(&self, block: Block, offsets: &[u32], items: &mut [u32]) {
        let Some(last) = self.axis_count().checked_sub(1) else {
            // The one point of a grid without axes is vertex 0.
            return;
        };
        let axes = self.axes();
        let sizes: Vec<u32> = self.sizes(block.extent).collect();
        let strides = self.strides(super::AxisSet::default());
        let width = offsets.len();
        let row_length = sizes[last] as usize * width;
        let rows = rows_per_piece(row_length);
        let lower = axes[last].lower_points().filter(|_| block.extent.contains(last));
        items.par_chunks_mut(rows * row_length).enumerate().for_each(|(piece, cells)| {
            let mut outer = Counter::at(&sizes[..last], piece * rows);
            for row in cells.chunks_mut(row_length) {
                let places = outer.places.iter().enumerate();
                let base: u32 = places
                    .map(|(i, &place)| {
                        strides[i] * if block.extent.contains(i) { axes[i].lower_point(place) } else { place }
                    })
                    .sum();
                for (c, cell) in row.chunks_exact_mut(width).enumerate() {
                    let corner = base + lower.map_or(c as u32, |lower| lower[c]);
                    for (vertex, offset) in cell.iter_mut().zip(offsets) {
                        *vertex = corner + offset;
                    }
                }
                outer.advance();
            }
        });
    }
}
