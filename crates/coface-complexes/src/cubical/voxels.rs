//! Where it is known which voxels are set.

use super::boxes::VoxelBox;
use super::volume::CubicalVolume;
use super::window::VoxelWindow;
use coface_algebra::{Error, ErrorKind};

/// A volume: whatever can say which voxels of a box are set.
pub trait Voxels: Sync {
    /// The number of voxels along each axis.
    fn shape(&self) -> &[u32];

    /// For each axis whether its last voxel meets its first.
    fn is_periodic(&self) -> &[bool];

    /// The voxels of a box, with the layer of voxels around it.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for a box that is empty or not in the volume, or not in what is known of it; [`ErrorKind::TooLarge`] where
    /// it does not fit in memory; and where it cannot be read.
    fn window(&self, inner: &VoxelBox) -> Result<VoxelWindow, Error>;
}

/// A volume with every voxel set, of which nothing is stored.
///
/// # Examples
/// ```
/// use coface_complexes::cubical::{CubicalBlocks, FullVoxels};
/// use coface_algebra::chains::PartTree;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = FullVoxels::new(&[30, 20, 10], &[true; 3])?;
/// let blocks = CubicalBlocks::at_least(&torus, 16)?;
/// assert_eq!(PartTree::new(&blocks, 8)?.root().complex().f_vector(), [1, 3, 3, 1]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct FullVoxels {
    shape: Vec<u32>,
    is_periodic: Vec<bool>,
}

impl FullVoxels {
    /// All voxels of this shape.
    ///
    /// # Errors
    /// [`ErrorKind::InvalidInput`] for no axis, more than [`CubicalVolume::MOST_AXES`], an axis without voxels, or lists of different
    /// lengths; [`ErrorKind::TooLarge`] where places of cells do not fit in 63 bits.
    pub fn new(shape: &[u32], is_periodic: &[bool]) -> Result<Self, Error> {
        check_shape(shape, is_periodic)?;
        Ok(Self { shape: shape.to_vec(), is_periodic: is_periodic.to_vec() })
    }
}

impl Voxels for FullVoxels {
    fn shape(&self) -> &[u32] {
        &self.shape
    }

    fn is_periodic(&self) -> &[bool] {
        &self.is_periodic
    }

    fn window(&self, inner: &VoxelBox) -> Result<VoxelWindow, Error> {
        let mut window = VoxelWindow::empty(&self.shape, &self.is_periodic, inner)?;
        window.fill();
        Ok(window)
    }
}

/// Refuses what is no shape of a volume.
pub(super) fn check_shape(shape: &[u32], is_periodic: &[bool]) -> Result<(), Error> {
    const MOST_AXES: usize = CubicalVolume::MOST_AXES;
    if shape.is_empty() || shape.len() > MOST_AXES || shape.len() != is_periodic.len() {
        return Err(Error::invalid(format!(
            "a volume of {} axes, {} of which are told periodic or not",
            shape.len(),
            is_periodic.len()
        ))
        .with_cure(format!("give 1 to {MOST_AXES} axes, and one word for each")));
    }
    if let Some(axis) = shape.iter().position(|&length| length == 0) {
        return Err(Error::invalid(format!("axis {axis} of a volume has no voxels")));
    }
    let place_count =
        shape.iter().try_fold(1u64, |count, &length| count.checked_mul(2 * u64::from(length) + 1));
    match place_count {
        Some(0..=0x7fff_ffff_ffff_ffff) => Ok(()),
        _ => Err(Error::new(
            ErrorKind::TooLarge,
            format!("cells of a volume of shape {shape:?} have no 63-bit places"),
        )),
    }
}
