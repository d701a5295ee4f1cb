//! The start of a stream, unpacked and in UTF-8.

use crate::unpacking::{Packing, unpacked};
use crate::utf16::{Utf8Of, is_utf16};
use crate::volume;
use coface_algebra::Error;
use std::io::Read;

/// So many bytes are read to detect the format.
const START: usize = 1 << 16;

/// The start without the mark that some editors put before UTF-8 text.
pub(crate) fn without_mark(start: &[u8]) -> &[u8] {
    start.strip_prefix(b"\xef\xbb\xbf").unwrap_or(start)
}

/// The bytes of a stream, unpacked, in UTF-8 and without the mark of text.
pub(crate) fn plain_bytes<'r>(input: impl Read + 'r) -> Result<impl Read, Error> {
    let (start, whole, rest, _) = unpacked_start(input)?;
    let start = without_mark(&start).to_vec();
    Ok(std::io::Cursor::new(start).chain(rest.take(if whole { 0 } else { u64::MAX })))
}

pub(crate) type Start<'r> = (Vec<u8>, bool, Box<dyn Read + 'r>, bool);

/// The first bytes of a stream, whether they are all of it, the rest of it, and whether it was unpacked.
pub(crate) fn unpacked_start<'r>(mut input: impl Read + 'r) -> Result<Start<'r>, Error> {
    let (start, whole) = start_of(&mut input)?;
    // The readers of volumes unpack for themselves.
    let packing = Packing::of_content(&start).filter(|_| !volume::is_nifti(&start));
    let Some(packing) = packing else { return decoded_start(start, whole, Box::new(input), false) };
    let mut rest = unpacked(std::io::Cursor::new(start).chain(input), packing)?;
    let (start, whole) = start_of(&mut rest).map_err(|error| {
        error.with_cure("the file was cut short: write it again, or restore it from a copy")
    })?;
    decoded_start(start, whole, rest, true)
}

/// The same in UTF-8 if it is text in UTF-16.
fn decoded_start(
    start: Vec<u8>,
    whole: bool,
    rest: Box<dyn Read + '_>,
    is_unpacked: bool,
) -> Result<Start<'_>, Error> {
    if !is_utf16(&start) {
        return Ok(with_line_feeds((start, whole, rest, is_unpacked)));
    }
    let mut rest = Utf8Of::new(&start.clone(), std::io::Cursor::new(start).chain(rest))?;
    let (start, whole) = start_of(&mut rest)?;
    Ok(with_line_feeds((start, whole, Box::new(rest), true)))
}

/// The same with line feeds, if it is text whose lines end in carriage returns alone, as old programs write it.
fn with_line_feeds((mut start, whole, rest, is_unpacked): Start<'_>) -> Start<'_> {
    let is_text = start.iter().all(|&byte| byte >= b' ' || matches!(byte, b'\t' | b'\r' | 0x0c));
    if !is_text || !start.contains(&b'\r') {
        return (start, whole, rest, is_unpacked);
    }
    LineFeeds::<&[u8]>::replace(&mut start);
    (start, whole, Box::new(LineFeeds { input: rest }), true)
}

/// A stream with line feeds for carriage returns.
struct LineFeeds<R> {
    input: R,
}

impl<R> LineFeeds<R> {
    fn replace(bytes: &mut [u8]) {
        bytes.iter_mut().filter(|byte| **byte == b'\r').for_each(|byte| *byte = b'\n');
    }
}

impl<R: Read> Read for LineFeeds<R> {
    fn read(&mut self, bytes: &mut [u8]) -> std::io::Result<usize> {
        let count = self.input.read(bytes)?;
        Self::replace(&mut bytes[..count]);
        Ok(count)
    }
}

/// The first bytes of a stream, and whether they are all of it.
fn start_of(input: &mut impl Read) -> Result<(Vec<u8>, bool), Error> {
    let mut start = Vec::new();
    input.by_ref().take(START as u64).read_to_end(&mut start)?;
    let whole = start.len() < START;
    Ok((start, whole))
}
