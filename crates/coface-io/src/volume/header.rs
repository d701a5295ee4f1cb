//! What the headers of volume files say.

use super::numbers::NumberType;
use coface_algebra::{Error, ErrorKind};
use coface_complexes::cubical::CubicalVolume;
use std::io::Read;
use std::path::PathBuf;

/// What a header says of the numbers that follow, or lie in a file of their own.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct VolumeHeader {
    /// The number of voxels along each axis, by the axes of the file.
    pub(super) shape: Vec<u32>,
    /// Whether axis 0 runs fastest, and not the last one.
    pub(super) is_first_fastest: bool,
    pub(super) number_type: NumberType,
    pub(super) is_big_endian: bool,
    pub(super) encoding: Encoding,
    /// Factor and summand that make of a number of the file the one that is meant.
    pub(super) scale: Option<(f64, f64)>,
    /// Lines, then bytes, before the first number; [`Skip::FromEnd`] where the numbers are the end of the file.
    pub(super) skip: Skip,
    /// The file of the numbers, where it is not that of the header.
    pub(super) data_file: Option<PathBuf>,
    /// The bytes of the header.
    pub(super) length: u64,
}

/// What comes before the numbers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Skip {
    /// Lines, before anything is unpacked, then bytes, of what is unpacked.
    Ahead { lines: u64, bytes: u64 },
    /// Whatever: the numbers are the end of the file.
    FromEnd,
}

impl Skip {
    pub(super) const NOTHING: Self = Self::Ahead { lines: 0, bytes: 0 };
}

/// How numbers are written.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Encoding {
    Raw,
    Gzip,
    Ascii,
}

/// The lengths of axes, each checked.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] for no axis, more than a volume may have, or one without voxels; [`ErrorKind::TooLarge`] for one beyond
/// 32 bits.
pub(super) fn shape_of(lengths: &[u64]) -> Result<Vec<u32>, Error> {
    let axis_count = lengths.len();
    if axis_count == 0 || axis_count > CubicalVolume::MOST_AXES {
        return Err(Error::invalid(format!("the array has {axis_count} axes, and a volume has 1 to 8"))
            .with_cure("take a part of it with fewer axes"));
    }
    if let Some(axis) = lengths.iter().position(|&length| length == 0) {
        return Err(Error::invalid(format!("axis {axis} of the array has length 0: there are no voxels"))
            .with_cure("write an array with voxels"));
    }
    let shape: Result<Vec<u32>, _> = lengths.iter().map(|&length| u32::try_from(length)).collect();
    shape.map_err(|_| {
        Error::new(ErrorKind::TooLarge, format!("an axis of {lengths:?} is longer than 2^32 - 1"))
    })
}

/// So many bytes, or fewer where the stream ends before.
pub(super) fn up_to(input: &mut impl Read, count: usize) -> Result<Vec<u8>, Error> {
    let mut bytes = Vec::new();
    input.by_ref().take(count as u64).read_to_end(&mut bytes).map_err(|error| unreadable(&error))?;
    Ok(bytes)
}

/// Packed bytes that cannot be unpacked are damaged; all else is the stream.
pub(super) fn unreadable(error: &std::io::Error) -> Error {
    use std::io::ErrorKind as Io;
    match error.kind() {
        Io::InvalidInput | Io::InvalidData | Io::UnexpectedEof => {
            Error::parse(format!("the packed bytes cannot be unpacked: {error}"))
                .with_cure("the file is damaged or cut short: copy or write it again")
        }
        _ => Error::new(ErrorKind::Io, format!("the file cannot be read: {error}")).with_cure("try again"),
    }
}

/// So many bytes.
///
/// # Errors
/// [`ErrorKind::Parse`] where the stream ends before.
pub(super) fn exactly(input: &mut impl Read, count: usize, what: &str) -> Result<Vec<u8>, Error> {
    let bytes = up_to(input, count)?;
    if bytes.len() < count {
        return Err(Error::parse(format!("{what} ends after {} of {count} bytes", bytes.len()))
            .with_cure("the file is cut short: copy or write it again"));
    }
    Ok(bytes)
}
