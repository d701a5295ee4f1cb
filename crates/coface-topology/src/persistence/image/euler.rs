//! Euler characteristic curves of images.

use super::filtration::ImageFiltration;
use crate::persistence::EulerCurve;
use coface_algebra::Error;
use coface_algebra::memory;
use coface_algebra::progress::stage;
use rayon::prelude::*;

/// A cell at a voxel: the steps from the voxel to the others that it has to do with.
struct NearCell {
    sign: i8,
    others: Vec<[i8; 4]>,
}

impl ImageFiltration {
    /// The Euler characteristic of the sublevel sets, or superlevel sets, at each value, counted cell by cell: no homology is needed.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a voxel at infinity where values come from;
    /// [`ErrorKind::TooLarge`](coface_algebra::ErrorKind::TooLarge) where the free memory would not do.
    ///
    /// # Complexity
    /// That of sorting the voxels, and at most $3^n 2^n$ comparisons a voxel of n axes, in parallel.
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
        let voxels = self.voxel_count() as u64;
        memory::require(voxels.saturating_mul(40), || {
            format!("the Euler characteristics of an image with {voxels} voxels")
        })?;
        let order = self.entrance();
        let _steps = stage("counting cells", 0);
        let changes = self.changes();
        let curve =
            order.iter().map(|&voxel| (self.value(voxel as usize), i64::from(changes[voxel as usize])));
        Ok(EulerCurve::of_changes(curve, self.is_falling()))
    }

    /// By how much the characteristic changes when a voxel enters: cells that it is the first or the last one of.
    fn changes(&self) -> Vec<i16> {
        let shape = self.shape();
        let axes = shape.len();
        let are_faces = self.are_top_cells();
        let cells = near_cells(axes, are_faces);
        let row = shape[axes - 1].max(1);
        let mut changes = vec![0_i16; self.voxel_count()];
        changes.par_chunks_mut(row).enumerate().for_each(|(number, changes)| {
            // The places along all axes but the last one.
            let mut place = vec![0; axes];
            let mut rest = number;
            for axis in (0..axes - 1).rev() {
                place[axis] = rest % shape[axis];
                rest /= shape[axis];
            }
            for (along, change) in changes.iter_mut().enumerate() {
                place[axes - 1] = along;
                let voxel = number * row + along;
                if self.has_entrance(voxel) {
                    *change = cells
                        .iter()
                        .filter(|cell| self.is_owner(voxel, &place, cell, are_faces))
                        .map(|cell| i16::from(cell.sign))
                        .sum();
                }
            }
        });
        changes
    }

    /// Whether a voxel is the first one around a cell, or the last one of its corners, all of which enter.
    fn is_owner(&self, voxel: usize, place: &[usize], cell: &NearCell, are_faces: bool) -> bool {
        cell.others.iter().all(|step| {
            match self.neighbor(place, step).filter(|&other| self.has_entrance(other)) {
                // A face on the rim belongs to the voxel beside it, and a cube beyond the rim is none.
                None => are_faces,
                Some(other) => self.comes_before(voxel, other) == are_faces,
            }
        })
    }

    /// The number of the voxel that lies one step from a place, in each direction that is not 0; `None` outside.
    fn neighbor(&self, place: &[usize], step: &[i8; 4]) -> Option<usize> {
        let mut number = 0;
        for (axis, (&at, &length)) in place.iter().zip(self.shape()).enumerate() {
            let to = match step[axis] {
                0 => at,
                1 if at + 1 < length => at + 1,
                -1 if at > 0 => at - 1,
                side if self.is_periodic_along(axis) => {
                    if side > 0 {
                        0
                    } else {
                        length - 1
                    }
                }
                _ => return None,
            };
            number = number * length + to;
        }
        Some(number)
    }
}

/// The cells at a voxel: faces, each between the voxels on its sides, or cubes at a vertex, each with its other corners.
fn near_cells(axes: usize, are_faces: bool) -> Vec<NearCell> {
    let cell = |index: usize| {
        let mut digits = [0_i8; 4];
        let mut rest = index;
        for digit in digits.iter_mut().take(axes) {
            *digit = [0, 1, -1][rest % 3];
            rest /= 3;
        }
        let extents: Vec<usize> = (0..axes).filter(|&axis| digits[axis] != 0).collect();
        let degree = if are_faces { axes - extents.len() } else { extents.len() };
        let other = |choice: usize| {
            let mut step = [0; 4];
            for (bit, &axis) in extents.iter().enumerate() {
                if choice >> bit & 1 == 1 {
                    step[axis] = digits[axis];
                }
            }
            step
        };
        let others = (1..1 << extents.len()).map(other).collect();
        NearCell { sign: if degree % 2 == 0 { 1 } else { -1 }, others }
    };
    (0..3_usize.pow(axes as u32)).map(cell).collect()
}
