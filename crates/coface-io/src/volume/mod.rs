//! Arrays of numbers whose voxels are set by a rule: NumPy `.npy`, NRRD, NIfTI-1 and -2, MetaImage, and images as PGM and PNG.
//!
//! # Words
//! * A **volume file** is a header and numbers of one type, raw, compressed or as text. Its **axes** are numbered as the file does: those of a
//!   NumPy array by its shape, those of the others from the one that runs fastest, x, y, z.
//! * A [`VoxelRule`] says of a number whether its voxel is set. What is no number (NaN) never is.
//! * A [`VolumeStream`] gives the voxels in runs, in the order of the file, without holding the numbers: a run is along the axis that runs
//!   fastest there, the last one or the first.

mod frame;
mod header;
mod metaimage;
mod nifti;
mod npy;
mod nrrd;
mod numbers;
mod pgm;
#[cfg(feature = "images")]
mod png;
mod rule;
mod stream;
#[cfg(test)]
mod tests;
mod windows;

pub(super) use metaimage::is_metaimage;
pub(super) use nifti::is_nifti;
pub use npy::write as write_npy;
pub(super) use npy::{MAGIC as NPY_MAGIC, write_header as write_npy_header};
pub(super) use nrrd::MAGIC as NRRD_MAGIC;
pub(super) use pgm::is_pgm;
/// The first bytes of an image as PNG.
pub(super) const PNG_MAGIC: &[u8] = b"\x89PNG\r\n\x1a\n";
pub use frame::VoxelFrame;
pub use rule::{VolumeReading, VoxelRule};
pub use stream::VolumeStream;
pub(super) use stream::header_path;
pub use windows::VolumeWindows;
