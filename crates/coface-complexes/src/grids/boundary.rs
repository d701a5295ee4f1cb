//! Boundary matrices of grids, facets and cofaces of a cell, and the facets of only one cell.

use super::cuboid_grid::{Block, Counter, rows_per_piece};
use super::{AxisSet, CuboidGrid};
use coface_algebra::chains::ChainComplex;
use coface_algebra::{CellId, Error, ErrorKind};
use coface_algebra::{Sign, SparseMatrix};
use rayon::prelude::*;

impl CuboidGrid {
    /// The boundary matrix from the p-cells to the (p-1)-cells: a lower and an upper facet for each axis along which the
    /// cell extends; the upper one has the sign $(-1)^k$ on the k-th of these axes, from 0, and the lower one the opposite.
    /// For degree 0 and beyond the dimension there is nothing to bound: no row or no column.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] for more than $2^{32} - 1$ entries.
    ///
    /// # Complexity
    /// Linear in the result, in parallel.
    ///
    /// # Examples
    /// The square of the lines 0 and 1 along both axes, its edges being 01, 23, 02, 13:
    /// ```
    /// use coface_complexes::grids::CuboidGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let square = CuboidGrid::new(&[1, 1])?.boundary_matrix(2)?;
    /// assert_eq!(square.column(0).iter().collect::<Vec<_>>(), [(0, -1), (1, 1), (2, 1), (3, -1)]);
    /// # Ok(()) }
    /// ```
    pub fn boundary_matrix(&self, degree: usize) -> Result<SparseMatrix, Error> {
        let columns = self.cell_count(degree);
        let Some(row_count) =
            degree.checked_sub(1).map(|below| self.cell_count(below)).filter(|_| columns > 0)
        else {
            return SparseMatrix::zero(
                degree.checked_sub(1).map_or(0, |below| self.cell_count(below)),
                columns,
            );
        };
        let width = 2 * degree;
        let total = columns as u64 * width as u64;
        let Ok(total32) = u32::try_from(total) else {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("the boundary matrix of degree {degree} has {total} entries; the limit is 2^32 - 1"),
            ));
        };
        let mut rows = vec![0u32; total as usize];
        let mut rest = rows.as_mut_slice();
        for block in self.blocks(degree) {
            let count: usize = self.sizes(block.extent).map(|size| size as usize).product();
            let (own, after) = std::mem::take(&mut rest).split_at_mut(count * width);
            self.fill_boundary(*block, own);
            rest = after;
        }
        let signs: Vec<i32> = (0..degree).flat_map(|k| if k % 2 == 0 { [-1, 1] } else { [1, -1] }).collect();
        let mut entries = vec![0i32; total as usize];
        entries.par_chunks_mut(width << 12).for_each(|piece| {
            piece.chunks_exact_mut(width).for_each(|column| column.copy_from_slice(&signs));
        });
        let starts = (0..=total32).step_by(width).collect();
        SparseMatrix::from_trusted_parts(row_count, starts, rows, entries)
    }

    /// Writes the facets of the cells of a block. They rise: the sets without an earlier axis come first.
    fn fill_boundary(&self, block: Block, rows: &mut [u32]) {
        let axes = self.axes();
        let last = axes.len() - 1;
        let width = 2 * block.extent.len();
        let sizes: Vec<u32> = self.sizes(block.extent).collect();
        // For each axis of the extent: the axis, the first number and the strides of the facets across it.
        let sides: Vec<(usize, u32, Vec<u32>)> = block
            .extent
            .iter()
            .filter_map(|axis| {
                let facet = block.extent.without(axis);
                self.block(facet).map(|own| (axis, own.start, self.strides(facet)))
            })
            .collect();
        let row_length = sizes[last] as usize * width;
        let piece_rows = rows_per_piece(row_length);
        let lower = axes[last].lower_points().filter(|_| block.extent.contains(last));
        rows.par_chunks_mut(piece_rows * row_length).enumerate().for_each(|(piece, columns)| {
            let mut outer = Counter::at(&sizes[..last], piece * piece_rows);
            for row in columns.chunks_mut(row_length) {
                for (k, (axis, start, strides)) in sides.iter().enumerate() {
                    let places = outer.places.iter().enumerate();
                    let base: u32 = places
                        .map(|(i, &place)| {
                            strides[i] * if i == *axis { axes[i].lower_point(place) } else { place }
                        })
                        .sum();
                    let first = start + base;
                    let own_lower = lower.filter(|_| *axis == last);
                    for (c, column) in row.chunks_exact_mut(width).enumerate() {
                        let facet = first + own_lower.map_or(c as u32, |lower| lower[c]);
                        column[2 * k] = facet;
                        column[2 * k + 1] = facet + strides[*axis];
                    }
                }
                outer.advance();
            }
        });
    }

    /// The grid as a chain complex, cells in the order of their numbers.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] as [`Self::boundary_matrix`].
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::CuboidGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(CuboidGrid::new(&[4, 3, 2, 1])?.chain_complex()?.euler_characteristic(), 1);
    /// # Ok(()) }
    /// ```
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        match self.dimension() {
            None | Some(0) => Ok(ChainComplex::of_points(self.cell_count(0))),
            Some(dimension) => {
                let matrices = (1..=dimension).map(|degree| self.boundary_matrix(degree));
                ChainComplex::new(matrices.collect::<Result<_, _>>()?)
            }
        }
    }

    /// The facets of a cell in rising order, with their signs in its boundary.
    ///
    /// # Panics
    /// If there is no such cell.
    pub fn facets(&self, dimension: usize, cell: CellId) -> Vec<(CellId, Sign)> {
        let (extent, places) = self.place(dimension, cell);
        let mut facets = Vec::with_capacity(2 * dimension);
        for (k, axis) in extent.iter().enumerate() {
            let facet = extent.without(axis);
            let mut places = places.clone();
            places[axis] = self.axes()[axis].lower_point(places[axis]);
            let lower = self.number_of_places(facet, &places);
            places[axis] += 1;
            let upper = self.number_of_places(facet, &places);
            let sign = Sign::power_of_minus_one(k);
            facets.extend([(lower, sign.opposite()), (upper, sign)]);
        }
        facets
    }

    /// The cells of one dimension more that have a cell as a facet, in rising order, with its signs in their boundaries.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Complexity
    /// $O(d^2)$ for d axes.
    ///
    /// # Examples
    /// The middle edge of two squares is the upper end of the first one and the lower end of the second:
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_algebra::Sign;
    /// use coface_complexes::grids::{AxisSet, CuboidGrid, GridCell};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let grid = CuboidGrid::new(&[2, 1])?;
    /// let middle = grid.number(&GridCell::new(AxisSet::from_iter([1]), vec![1, 0])).expect("it is there");
    /// assert_eq!(grid.cofaces(1, middle), [(CellId::new(0), Sign::Plus), (CellId::new(1), Sign::Minus)]);
    /// # Ok(()) }
    /// ```
    pub fn cofaces(&self, dimension: usize, cell: CellId) -> Vec<(CellId, Sign)> {
        let (extent, places) = self.place(dimension, cell);
        let mut cofaces = Vec::new();
        for axis in (0..self.axis_count()).rev().filter(|&axis| !extent.contains(axis)) {
            let sign = Sign::power_of_minus_one(extent.rank(axis));
            let own = &self.axes()[axis];
            let sides = [
                (own.interval_below(places[axis]), sign),
                (own.interval_above(places[axis]), sign.opposite()),
            ];
            for (interval, sign) in sides {
                let Some(interval) = interval else { continue };
                let mut places = places.clone();
                places[axis] = interval;
                cofaces.push((self.number_of_places(extent.with(axis), &places), sign));
            }
        }
        cofaces
    }

    /// The facets of exactly one top cell in rising order, with their signs: they are the boundary of the sum of all
    /// top cells. A grid of dimension 0 has none.
    ///
    /// # Complexity
    /// Linear in the result.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::grids::CuboidGrid;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let grid = CuboidGrid::new(&[4, 3, 2])?;
    /// assert_eq!(grid.boundary_facets().len(), 2 * (4 * 3 + 3 * 2 + 2 * 4));
    /// # Ok(()) }
    /// ```
    pub fn boundary_facets(&self) -> Vec<(CellId, Sign)> {
        let mut found = Vec::new();
        let Some(top) = self.dimension().and_then(|dimension| self.blocks(dimension).first()) else {
            return found;
        };
        for (k, axis) in top.extent.iter().enumerate() {
            let own = &self.axes()[axis];
            let facet = top.extent.without(axis);
            let Some(block) = self.block(facet) else { continue };
            let strides = self.strides(facet);
            let ends: Vec<(u32, Sign)> = (0..own.point_count() as u32)
                .filter_map(|point| match (own.interval_below(point), own.interval_above(point)) {
                    (Some(_), None) => Some((point, Sign::power_of_minus_one(k))),
                    (None, Some(_)) => Some((point, Sign::power_of_minus_one(k + 1))),
                    _ => None,
                })
                .collect();
            let sizes: Vec<u32> = self.sizes(facet).collect();
            let above: usize = sizes[..axis].iter().map(|&size| size as usize).product();
            for outer in 0..above as u32 {
                for &(point, sign) in &ends {
                    let first = block.start + (outer * sizes[axis] + point) * strides[axis];
                    found.extend((first..first + strides[axis]).map(|i| (CellId::from_u32(i), sign)));
                }
            }
        }
        found
    }

    /// The number of the cell with this extent and these numbers of intervals and points.
    fn number_of_places(&self, extent: AxisSet, places: &[u32]) -> CellId {
        let block = self.block(extent).expect("faces and cofaces of cells lie in blocks");
        let strides = self.strides(extent);
        let number: u32 = strides.iter().zip(places).map(|(stride, place)| stride * place).sum();
        CellId::from_u32(block.start + number)
    }
}
