//! What the headers of volume files say.

use super::frame::VoxelFrame;
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
    /// Where voxels are, if the header says it.
    pub(super) frame: Option<VoxelFrame>,
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
    Zlib,
    Ascii,
}

/// The bytes of a header that lines make.
const LONGEST_HEADER: usize = 1 << 20;

/// Lines of a header, which the numbers follow.
pub(super) struct Lines<'a, R> {
    input: &'a mut R,
    /// What ends a header.
    end: &'static str,
    line: Vec<u8>,
    number: u64,
    total: usize,
}

impl<'a, R: Read> Lines<'a, R> {
    pub(super) fn new(input: &'a mut R, end: &'static str) -> Self {
        Self { input, end, line: Vec::new(), number: 0, total: 0 }
    }

    /// The number of the last line, from 1.
    pub(super) fn number(&self) -> u64 {
        self.number
    }

    /// The bytes that have been read.
    pub(super) fn total(&self) -> usize {
        self.total
    }

    /// The next line without its end; `None` at the end of the file.
    pub(super) fn next(&mut self) -> Result<Option<String>, Error> {
        self.line.clear();
        self.number += 1;
        let mut byte = [0];
        loop {
            if self.input.read(&mut byte)? == 0 {
                if self.line.is_empty() {
                    return Ok(None);
                }
                break;
            }
            self.total += 1;
            if self.total > LONGEST_HEADER {
                return Err(Error::parse("the header has no end")
                    .at_line(self.number)
                    .with_cure(format!("{}: check that the file is the one meant", self.end)));
            }
            if byte[0] == b'\n' {
                break;
            }
            self.line.push(byte[0]);
        }
        if self.line.last() == Some(&b'\r') {
            self.line.pop();
        }
        Ok(Some(String::from_utf8_lossy(&self.line).into_owned()))
    }
}

/// The start of a text, for a message.
pub(super) fn shortened(text: &str) -> String {
    text.chars().take(40).flat_map(char::escape_debug).collect()
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
            .with_cure("take a part of it that is shorter along that axis")
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
