//! Compressed files, told by their first bytes: gzip, Zstandard, bzip2, xz.

use coface_algebra::Error;
use std::cell::Cell;
use std::io::{self, Read};
use std::rc::Rc;

/// What a file is compressed by.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Packing {
    Gzip,
    Zstandard,
    Bzip2,
    Xz,
}

impl Packing {
    const ALL: [Self; 4] = [Self::Gzip, Self::Zstandard, Self::Bzip2, Self::Xz];

    /// What a file that begins like this is compressed by.
    pub(crate) fn of_content(start: &[u8]) -> Option<Self> {
        Self::ALL.into_iter().find(|packing| start.starts_with(packing.mark()))
    }

    /// Whether files of this extension are compressed.
    pub(crate) fn of_extension(extension: &str) -> bool {
        matches!(extension, "gz" | "zst" | "bz2" | "xz")
    }

    fn name(self) -> &'static str {
        match self {
            Self::Gzip => "gzip",
            Self::Zstandard => "Zstandard",
            Self::Bzip2 => "bzip2",
            Self::Xz => "xz",
        }
    }

    fn mark(self) -> &'static [u8] {
        match self {
            Self::Gzip => b"\x1f\x8b",
            Self::Zstandard => b"\x28\xb5\x2f\xfd",
            Self::Bzip2 => b"BZh",
            Self::Xz => b"\xfd7zXZ",
        }
    }
}

/// Beyond this size a file may be `RATIO` times as large as its compressed form; gzip cannot do better.
const FREE: u64 = 1 << 26;
const RATIO: u64 = 1100;

/// The most bytes that so many packed ones are taken to hold.
pub(crate) fn most_unpacked(packed: u64) -> u64 {
    FREE.max(packed.saturating_mul(RATIO))
}

/// The bytes of a compressed stream. It fails where they are far more than any model compresses to.
///
/// # Errors
/// Those of the decoder; [`coface_algebra::ErrorKind::UnsupportedFormat`] in a build without the feature `compression`.
pub(crate) fn unpacked<'r>(input: impl Read + 'r, packing: Packing) -> Result<Box<dyn Read + 'r>, Error> {
    let taken = Rc::new(Cell::new(0));
    let input = Counted { input, taken: Rc::clone(&taken) };
    Ok(Box::new(Unpacked { input: decoder(input, packing)?, packing, taken, given: 0 }))
}

/// The bytes of a stream, unpacked if they are compressed by gzip, Zstandard, bzip2 or xz.
///
/// # Errors
/// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) where the stream fails or its data are damaged, or are more than 1,100 times as large as their
/// compressed form; [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) in a build without the feature `compression`.
///
/// # Complexity
/// Linear.
///
/// # Examples
/// ```
/// assert_eq!(coface_io::unpacked_bytes(&b"plain"[..])?, b"plain");
/// # Ok::<(), coface_algebra::Error>(())
/// ```
pub fn unpacked_bytes(mut input: impl Read) -> Result<Vec<u8>, Error> {
    let mut bytes = Vec::new();
    input.read_to_end(&mut bytes)?;
    let Some(packing) = Packing::of_content(&bytes) else { return Ok(bytes) };
    let mut whole = Vec::new();
    unpacked(&bytes[..], packing)?.read_to_end(&mut whole)?;
    Ok(whole)
}

struct Counted<R> {
    input: R,
    taken: Rc<Cell<u64>>,
}

impl<R: Read> Read for Counted<R> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let count = self.input.read(bytes)?;
        self.taken.set(self.taken.get() + count as u64);
        Ok(count)
    }
}

struct Unpacked<'r> {
    input: Box<dyn Read + 'r>,
    packing: Packing,
    taken: Rc<Cell<u64>>,
    given: u64,
}

impl Read for Unpacked<'_> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        let count = self.input.read(bytes).map_err(|error| {
            io::Error::new(
                io::ErrorKind::InvalidData,
                format!("the data compressed by {} are damaged or cut short: {error}", self.packing.name()),
            )
        })?;
        self.given += count as u64;
        if self.given > most_unpacked(self.taken.get()) {
            let message =
                "the file is more than 1,100 times as large as its compressed form; unpack it first";
            return Err(io::Error::new(io::ErrorKind::InvalidData, message));
        }
        Ok(count)
    }
}

#[cfg(feature = "compression")]
fn decoder<'r>(input: impl Read + 'r, packing: Packing) -> Result<Box<dyn Read + 'r>, Error> {
    Ok(match packing {
        Packing::Gzip => Box::new(flate2::read::MultiGzDecoder::new(input)),
        Packing::Zstandard => Box::new(Frames { input: Some(io::BufReader::new(input)), frame: None }),
        Packing::Bzip2 => Box::new(bzip2::read::MultiBzDecoder::new(input)),
        Packing::Xz => Box::new(lzma_rust2::XzReader::new(input, true)),
    })
}

#[cfg(not(feature = "compression"))]
fn decoder<'r>(_input: impl Read + 'r, _packing: Packing) -> Result<Box<dyn Read + 'r>, Error> {
    Err(crate::features::without_compression())
}

/// The frames of a Zstandard stream, one after the other.
#[cfg(feature = "compression")]
struct Frames<R: Read> {
    /// The stream, between two frames.
    input: Option<io::BufReader<R>>,
    frame: Option<ruzstd::decoding::StreamingDecoder<io::BufReader<R>, ruzstd::decoding::FrameDecoder>>,
}

#[cfg(feature = "compression")]
impl<R: Read> Read for Frames<R> {
    fn read(&mut self, bytes: &mut [u8]) -> io::Result<usize> {
        use io::BufRead;
        loop {
            if let Some(mut input) = self.input.take() {
                if input.fill_buf()?.is_empty() {
                    self.input = Some(input);
                    return Ok(0);
                }
                let frame = ruzstd::decoding::StreamingDecoder::new(input);
                self.frame = Some(frame.map_err(|error| io::Error::other(error.to_string()))?);
            }
            let Some(frame) = &mut self.frame else { return Ok(0) };
            match frame.read(bytes)? {
                0 if !bytes.is_empty() => self.input = self.frame.take().map(|frame| frame.into_inner()),
                count => return Ok(count),
            }
        }
    }
}

#[cfg(all(test, feature = "compression"))]
mod tests {
    use super::*;

    #[test]
    fn a_bomb_is_refused_before_it_fills_memory() {
        let mut packed = Vec::new();
        let zeros = io::repeat(0).take(1 << 27);
        bzip2::read::BzEncoder::new(zeros, bzip2::Compression::best()).read_to_end(&mut packed).unwrap();
        assert!(packed.len() < 1 << 12);
        let mut stream = unpacked(&packed[..], Packing::Bzip2).unwrap();
        let error = io::copy(&mut stream, &mut io::sink()).unwrap_err();
        assert!(error.to_string().contains("1,100 times"), "{error}");
    }

    #[test]
    fn frames_follow_each_other() {
        let frame = |text: &[u8]| {
            ruzstd::encoding::compress_to_vec(text, ruzstd::encoding::CompressionLevel::Fastest)
        };
        let packed = [frame(b"one "), frame(b"two")].concat();
        let mut text = String::new();
        unpacked(&packed[..], Packing::Zstandard).unwrap().read_to_string(&mut text).unwrap();
        assert_eq!(text, "one two");
        assert!(
            unpacked(&packed[..packed.len() - 3], Packing::Zstandard)
                .unwrap()
                .read_to_end(&mut Vec::new())
                .is_err()
        );
    }
}
