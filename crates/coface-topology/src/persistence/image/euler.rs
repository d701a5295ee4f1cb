//! Euler characteristic curves of images.

use super::filtration::ImageFiltration;
use super::gradient::{NEVER, OUTSIDE, lower_star};
use crate::persistence::EulerCurve;
use coface_algebra::progress::stage;
use coface_algebra::{Error, memory};
use rayon::prelude::*;

impl ImageFiltration {
    /// The Euler characteristic of the sublevel sets, or superlevel sets, at each value, counted cell by cell: no homology is needed.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a voxel at infinity where values come from;
    /// [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) where the free memory would not do.
    ///
    /// # Complexity
    /// That of sorting the voxels, and $3^n$ comparisons a voxel of n axes, in parallel.
    ///
    /// # References
    /// T. Heiss, H. Wagner, *Streaming algorithm for Euler characteristic curves of multidimensional images* (2017).
    ///
    /// # Examples
    /// Four dark pixels at the corners, then a ring, then its middle.
    /// ```
    /// use coface_topology::{ImageConstruction, ImageFiltration};
    /// let ring = [1.0, 2.0, 1.0, 2.0, 9.0, 2.0, 1.0, 2.0, 1.0];
    /// let image = ImageFiltration::new(&[3, 3], ring)?.construction(ImageConstruction::Vertices);
    /// assert_eq!(image.euler_curve()?.steps(), [(1.0, 4), (2.0, 0), (9.0, 1)]);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn euler_curve(&self) -> Result<EulerCurve, Error> {
        self.require_births()?;
        // A change for each vertex, beside the ranks.
        let bytes = self.vertex_count().saturating_mul(2).saturating_add(self.bytes_of_ranks());
        memory::require(bytes, || "the Euler characteristics of the image".to_owned())?;
        let (grid, ranks, vertices) = self.ranked();
        let _steps = stage("counting cells", 0);
        let codes = &grid.codes;
        // In the T-construction a cell of the grid stands for one of the other degree: see the words of this section.
        let own = if self.is_dual() { grid.axes() } else { 0 };
        let is_odd =
            (0..codes.count()).map(|code| u128::from((own + codes.degree(code as u8)) % 2 == 1) << code);
        let odd = is_odd.fold(0, |mask, bit| mask | bit);
        // A circle has as many edges as vertices, and so has what is multiplied by it.
        let is_even = !self.circles().is_empty();
        let change = |vertex: usize| match ranks[vertex] {
            OUTSIDE | NEVER => 0,
            _ if is_even => 0,
            _ => {
                let owned = lower_star(&grid, &ranks, vertex);
                owned.count_ones() as i16 - 2 * (owned & odd).count_ones() as i16
            }
        };
        let changes: Vec<i16> = (0..ranks.len()).into_par_iter().map(change).collect();
        let of_rank = |&vertex: &u32| {
            let vertex = vertex as usize;
            (self.value(grid.voxel_of_vertex(vertex)), i64::from(changes[vertex]))
        };
        // What is first by rank enters last in the T-construction.
        Ok(match self.is_dual() {
            true => EulerCurve::of_changes(vertices.iter().rev().map(of_rank), self.is_falling()),
            false => EulerCurve::of_changes(vertices.iter().map(of_rank), self.is_falling()),
        })
    }
}
