//! Grey images of Netpbm: `.pgm`, as text (P2) or bytes (P5).

use super::header::{Encoding, Skip, VolumeHeader, shape_of};
use super::numbers::NumberType;
use coface_algebra::Error;
use std::io::Read;

/// The header has four words and comments between them.
const LONGEST_HEADER: u64 = 1 << 16;

/// Whether a file begins as a grey image does.
pub(crate) fn is_pgm(start: &[u8]) -> bool {
    matches!(start, [b'P', b'2' | b'5', next, ..] if next.is_ascii_whitespace() || *next == b'#')
}

/// Reads the header: the mark, the width, the height, the largest value, and one blank. Axis 0 goes along the rows, axis 1 down.
///
/// # Errors
/// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for what is no header.
///
/// # References
/// The Netpbm manual, *PGM format specification*.
pub(super) fn read_header(input: &mut impl Read) -> Result<VolumeHeader, Error> {
    let mut words = Words { input, length: 0 };
    let is_text = match words.next()?.as_str() {
        "P2" => true,
        "P5" => false,
        _ => return Err(Error::parse("the image does not begin with P2 or P5").at_byte(0).with_cure(CURE)),
    };
    let [width, height, largest] =
        [words.number("width")?, words.number("height")?, words.number("largest value")?];
    if !(1..65_536).contains(&largest) {
        return Err(Error::parse(format!("the largest value of the image is {largest}")).with_cure(CURE));
    }
    Ok(VolumeHeader {
        shape: shape_of(&[width, height])?,
        is_first_fastest: true,
        number_type: if largest < 256 { NumberType::U8 } else { NumberType::U16 },
        is_big_endian: true,
        encoding: if is_text { Encoding::Ascii } else { Encoding::Raw },
        scale: None,
        skip: Skip::NOTHING,
        data_file: None,
        length: words.length,
        frame: None,
    })
}

const CURE: &str = "write it again, as a .pgm of type P2 or P5";

/// The words of a header, and the bytes that have been read.
struct Words<'a, R> {
    input: &'a mut R,
    length: u64,
}

impl<R: Read> Words<'_, R> {
    /// The next word; the blank behind it is read too.
    fn next(&mut self) -> Result<String, Error> {
        let (mut word, mut is_comment) = (String::new(), false);
        loop {
            let mut byte = [0];
            if self.length == LONGEST_HEADER || self.input.read(&mut byte)? == 0 {
                return Err(Error::parse("the header of the image has no end").with_cure(CURE));
            }
            self.length += 1;
            match byte[0] {
                b'\n' if is_comment => {
                    is_comment = false;
                    if !word.is_empty() {
                        return Ok(word);
                    }
                }
                _ if is_comment => {}
                b'#' => is_comment = true,
                blank if blank.is_ascii_whitespace() => {
                    if !word.is_empty() {
                        return Ok(word);
                    }
                }
                other => word.push(char::from(other)),
            }
        }
    }

    fn number(&mut self, what: &str) -> Result<u64, Error> {
        let word = self.next()?;
        let wrong = || {
            let shown: String = word.chars().take(20).flat_map(char::escape_debug).collect();
            Error::parse(format!("the {what} of the image is \"{shown}\"")).with_cure(CURE)
        };
        word.parse().map_err(|_| wrong())
    }
}
