//! Volumes cut into boxes.

use super::voxels::check_shape;
use coface_algebra::{Error, ErrorKind};

/// A box of voxels: along each axis from a first one to one before an end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VoxelBox {
    /// The first voxel along each axis.
    pub start: Vec<u32>,
    /// The voxel after the last one along each axis.
    pub end: Vec<u32>,
}

/// A volume cut into boxes of nearly equal size, so many along each axis. Their numbers run like places, the last axis fastest.
///
/// # Examples
/// ```
/// use coface_complexes::cubical::VoxelBoxes;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let boxes = VoxelBoxes::new(&[5, 4], &[false, true], &[2, 1])?;
/// assert_eq!(boxes.count(), 2);
/// assert_eq!((boxes.voxels(1).start, boxes.voxels(1).end), (vec![2, 0], vec![5, 4]));
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VoxelBoxes {
    shape: Vec<u32>,
    is_periodic: Vec<bool>,
    counts: Vec<u32>,
}

impl VoxelBoxes {
    /// So many boxes along each axis.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a shape that no volume has, and unless there is a count for each axis, from 1 to its voxels;
    /// [`ErrorKind::TooLarge`] beyond 2^32 boxes, or places of cells beyond 63 bits.
    pub fn new(shape: &[u32], is_periodic: &[bool], counts: &[u32]) -> Result<Self, Error> {
        check_shape(shape, is_periodic)?;
        let fits = counts.len() == shape.len()
            && counts.iter().zip(shape).all(|(count, length)| (1..=*length).contains(count));
        if !fits {
            return Err(Error::invalid(format!(
                "a volume of shape {shape:?} cannot be cut into {counts:?} blocks"
            ))
            .with_cure("give a count for each axis, from 1 to the number of its voxels"));
        }
        if counts.iter().try_fold(1u32, |total, &count| total.checked_mul(count)).is_none() {
            return Err(Error::new(ErrorKind::TooLarge, format!("{counts:?} are more than 2^32 blocks")));
        }
        Ok(Self { shape: shape.to_vec(), is_periodic: is_periodic.to_vec(), counts: counts.to_vec() })
    }

    /// Boxes in all at least `count`, as far as there are voxels, by halving the longest side over and over.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn at_least(shape: &[u32], is_periodic: &[bool], count: u32) -> Result<Self, Error> {
        check_shape(shape, is_periodic)?;
        let mut counts = vec![1u32; shape.len()];
        while counts.iter().map(|&count| u64::from(count)).product::<u64>() < u64::from(count) {
            let side = |axis: &usize| shape[*axis] / counts[*axis];
            match (0..counts.len()).max_by_key(side) {
                Some(axis) if side(&axis) > 1 => counts[axis] *= 2,
                _ => break,
            }
        }
        Self::new(shape, is_periodic, &counts)
    }

    /// The number of voxels along each axis.
    pub fn shape(&self) -> &[u32] {
        &self.shape
    }

    /// For each axis whether its last voxel meets its first.
    pub fn is_periodic(&self) -> &[bool] {
        &self.is_periodic
    }

    /// The number of boxes along each axis.
    pub fn counts(&self) -> &[u32] {
        &self.counts
    }

    /// The number of boxes.
    pub fn count(&self) -> u32 {
        self.counts.iter().product()
    }

    /// The voxels of a box.
    ///
    /// # Panics
    /// If there is no such box.
    pub fn voxels(&self, number: u32) -> VoxelBox {
        let mut voxels = VoxelBox { start: vec![0; self.counts.len()], end: vec![0; self.counts.len()] };
        for (axis, &at) in self.places(number).iter().enumerate() {
            voxels.start[axis] = self.first_voxel(axis, at);
            voxels.end[axis] = self.first_voxel(axis, at + 1);
        }
        voxels
    }

    /// Where the window of a box begins along an axis, and how many voxels it has there; see [`super::VoxelWindow`].
    ///
    /// # Panics
    /// If there is no such box or axis.
    pub fn window_along(&self, axis: usize, number: u32) -> (u32, u32) {
        let at = self.places(number)[axis];
        let (start, end) = (self.first_voxel(axis, at), self.first_voxel(axis, at + 1));
        window_span(self.shape[axis], self.is_periodic[axis], start, end)
    }

    /// Where a box is along each axis, among the boxes.
    pub(super) fn places(&self, number: u32) -> Vec<u32> {
        assert!(number < self.count(), "there is no block {number}");
        let mut places = vec![0; self.counts.len()];
        let mut rest = number;
        for (place, &count) in places.iter_mut().zip(&self.counts).rev() {
            *place = rest % count;
            rest /= count;
        }
        places
    }

    /// Where box `at` begins along an axis.
    fn first_voxel(&self, axis: usize, at: u32) -> u32 {
        (u64::from(at) * u64::from(self.shape[axis]) / u64::from(self.counts[axis])) as u32
    }

    /// The box that has a voxel, along an axis: the last one that begins at it or before.
    pub(super) fn box_of(&self, axis: usize, voxel: u32) -> u32 {
        let count = self.counts[axis];
        let guess = (u64::from(voxel) * u64::from(count) / u64::from(self.shape[axis])) as u32;
        let up = guess + 1 < count && self.first_voxel(axis, guess + 1) <= voxel;
        guess + u32::from(up)
    }
}

/// Where a box along an axis begins with the layer around it, and how many voxels it has with it.
pub(super) fn window_span(length: u32, is_periodic: bool, start: u32, end: u32) -> (u32, u32) {
    if !is_periodic {
        let first = start.saturating_sub(1);
        return (first, end.saturating_add(1).min(length) - first);
    }
    let count = u64::from(end - start) + 2;
    if count >= u64::from(length) {
        (0, length)
    } else {
        (if start > 0 { start - 1 } else { length - 1 }, count as u32)
    }
}
