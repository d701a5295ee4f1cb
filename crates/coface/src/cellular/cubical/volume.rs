//! Arrays of voxels.

use super::blocks::CubicalBlocks;
use crate::chains::ChainComplex;
use crate::{Error, ErrorKind};

/// Voxels that are set or not.
///
/// # Examples
/// Three by three voxels without the one in the middle make an annulus:
/// ```
/// use coface::cellular::CubicalVolume;
/// use coface::topology::homology;
/// # fn main() -> Result<(), coface::Error> {
/// let ring = CubicalVolume::new(&[3, 3], &[false, false], |voxel| voxel != [1, 1])?;
/// let complex = ring.chain_complex()?;
/// assert_eq!(complex.f_vector(), [16, 24, 8]);
/// assert_eq!(homology(&complex).betti_numbers(), [1, 1, 0]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CubicalVolume {
    shape: Vec<u32>,
    is_periodic: Vec<bool>,
    /// A bit for each voxel, the last axis running fastest.
    words: Vec<u64>,
}

/// A box of voxels: along each axis from a first one to one before an end.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct VoxelBox {
    /// The first voxel along each axis.
    pub start: Vec<u32>,
    /// The voxel after the last one along each axis.
    pub end: Vec<u32>,
}

impl CubicalVolume {
    /// The most axes that a volume has: a cell has up to 2 to the power of them voxels around it.
    pub const MOST_AXES: usize = 8;

    /// The volume of this shape whose voxels are set where `is_set` says so; it is asked in order, the last axis running fastest.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for no axis, more than [`Self::MOST_AXES`], an axis without voxels, or lists of different lengths;
    /// [`ErrorKind::TooLarge`] where places of cells do not fit in 63 bits, or voxels in memory.
    pub fn new(
        shape: &[u32],
        is_periodic: &[bool],
        mut is_set: impl FnMut(&[u32]) -> bool,
    ) -> Result<Self, Error> {
        let mut volume = Self::empty(shape, is_periodic)?;
        let mut voxel = vec![0; shape.len()];
        for at in 0..volume.voxel_count() {
            if is_set(&voxel) {
                volume.words[at / 64] |= 1 << (at % 64);
            }
            for axis in (0..shape.len()).rev() {
                voxel[axis] += 1;
                if voxel[axis] < shape[axis] {
                    break;
                }
                voxel[axis] = 0;
            }
        }
        Ok(volume)
    }

    /// The volume of this shape with every voxel set.
    ///
    /// # Errors
    /// As [`Self::new`].
    pub fn full(shape: &[u32], is_periodic: &[bool]) -> Result<Self, Error> {
        let mut volume = Self::empty(shape, is_periodic)?;
        volume.words.fill(u64::MAX);
        Ok(volume)
    }

    fn empty(shape: &[u32], is_periodic: &[bool]) -> Result<Self, Error> {
        if shape.is_empty() || shape.len() > Self::MOST_AXES || shape.len() != is_periodic.len() {
            return Err(Error::invalid(format!(
                "a volume of {} axes, {} of which are told periodic or not",
                shape.len(),
                is_periodic.len()
            ))
            .with_cure(format!("give 1 to {} axes, and one word for each", Self::MOST_AXES)));
        }
        if let Some(axis) = shape.iter().position(|&length| length == 0) {
            return Err(Error::invalid(format!("axis {axis} of a volume has no voxels")));
        }
        let place_count =
            shape.iter().try_fold(1u64, |count, &length| count.checked_mul(2 * u64::from(length) + 1));
        let voxel_count = shape.iter().try_fold(1usize, |count, &length| count.checked_mul(length as usize));
        let (Some(0..=0x7fff_ffff_ffff_ffff), Some(voxel_count)) = (place_count, voxel_count) else {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("cells of a volume of shape {shape:?} have no 63-bit places"),
            ));
        };
        let word_count = voxel_count.div_ceil(64);
        let mut words = Vec::new();
        words.try_reserve_exact(word_count).map_err(|_| {
            Error::new(ErrorKind::TooLarge, format!("a volume of shape {shape:?} does not fit in memory"))
        })?;
        words.resize(word_count, 0);
        Ok(Self { shape: shape.to_vec(), is_periodic: is_periodic.to_vec(), words })
    }

    /// The number of voxels along each axis.
    pub fn shape(&self) -> &[u32] {
        &self.shape
    }

    /// For each axis whether its last voxel meets its first.
    pub fn is_periodic(&self) -> &[bool] {
        &self.is_periodic
    }

    /// The number of voxels, set or not.
    pub fn voxel_count(&self) -> usize {
        self.shape.iter().map(|&length| length as usize).product()
    }

    /// Whether a voxel is set.
    ///
    /// # Panics
    /// If there is no such voxel.
    pub fn is_set(&self, voxel: &[u32]) -> bool {
        let at = voxel.iter().zip(&self.shape).fold(0, |at, (&x, &length)| {
            assert!(x < length, "there is no voxel {voxel:?} in a volume of shape {:?}", self.shape);
            at * length as usize + x as usize
        });
        self.is_set_at(at)
    }

    /// Whether the voxel at this place is set, places counted with the last axis running fastest.
    pub(super) fn is_set_at(&self, at: usize) -> bool {
        self.words[at / 64] & (1 << (at % 64)) != 0
    }

    /// The chain complex of all cells, in order of their ids.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 2^32 cells or entries of one dimension.
    ///
    /// # Complexity
    /// Linear in the places of cells.
    pub fn chain_complex(&self) -> Result<ChainComplex, Error> {
        Ok(CubicalBlocks::new(self, &vec![1; self.shape.len()])?.block(0)?.into_complex())
    }
}
