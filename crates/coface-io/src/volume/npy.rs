//! NumPy arrays: `.npy`, versions 1 to 3.

use super::header::{Encoding, Skip, VolumeHeader, exactly, shape_of};
use super::numbers::NumberType;
use coface_algebra::{Error, ErrorKind};
use coface_complexes::cubical::CubicalVolume;
use std::io::{Read, Write};

pub(crate) const MAGIC: &[u8] = b"\x93NUMPY";
/// A header that is longer describes records, not numbers.
const LONGEST_HEADER: usize = 1 << 20;

/// Reads the header.
///
/// # Errors
/// [`ErrorKind::Parse`] for what is no header; [`ErrorKind::UnsupportedFormat`] for other types than numbers and truth values.
pub(super) fn read_header(input: &mut impl Read) -> Result<VolumeHeader, Error> {
    let start = exactly(input, 8, "the header")?;
    if !start.starts_with(MAGIC) {
        return Err(Error::parse("the file does not begin as an array of NumPy").at_byte(0));
    }
    let (length, before) = match start[6] {
        1 => (usize::from(u16::from_le_bytes(pair(&exactly(input, 2, "the header")?))), 10),
        2 | 3 => {
            let bytes = exactly(input, 4, "the header")?;
            (u32::from_le_bytes([bytes[0], bytes[1], bytes[2], bytes[3]]) as usize, 12)
        }
        version => {
            return Err(Error::new(
                ErrorKind::UnsupportedFormat,
                format!("version {version} of .npy is not known"),
            )
            .at_byte(6)
            .with_cure("save the array by numpy.save, which writes version 1"));
        }
    };
    if length > LONGEST_HEADER {
        return Err(Error::parse(format!("the header claims {length} bytes"))
            .at_byte(8)
            .with_cure("the file is damaged, or an array of records: save one field of it"));
    }
    let text = exactly(input, length, "the header")?;
    let text = String::from_utf8_lossy(&text);
    let dictionary = Dictionary::parse(&text).map_err(|error| error.at_byte(before))?;
    let (number_type, is_big_endian) =
        number_type(&dictionary.descr).map_err(|error| error.at_byte(before))?;
    Ok(VolumeHeader {
        shape: shape_of(&dictionary.shape).map_err(|error| error.at_byte(before))?,
        is_first_fastest: dictionary.fortran_order,
        number_type,
        is_big_endian,
        encoding: Encoding::Raw,
        scale: None,
        skip: Skip::NOTHING,
        data_file: None,
        length: before + length as u64,
        frame: None,
    })
}

fn pair(bytes: &[u8]) -> [u8; 2] {
    [bytes[0], bytes[1]]
}

/// A type as NumPy writes it, such as `<f8`, and whether it is big-endian.
fn number_type(descr: &str) -> Result<(NumberType, bool), Error> {
    let unsupported = || {
        let name = descr.escape_debug();
        Error::new(
            ErrorKind::UnsupportedFormat,
            format!("an array of type \"{name}\" has no numbers that are compared"),
        )
        .with_cure("save it as integers, floating point numbers up to 64 bits, or truth values")
    };
    let (order, name) = match descr.as_bytes().first() {
        Some(b'<' | b'|' | b'=') => (false, &descr[1..]),
        Some(b'>') => (true, &descr[1..]),
        _ => (false, descr),
    };
    let number_type = match name {
        "b1" | "?" => NumberType::Bool,
        "i1" => NumberType::I8,
        "u1" => NumberType::U8,
        "i2" => NumberType::I16,
        "u2" => NumberType::U16,
        "i4" => NumberType::I32,
        "u4" => NumberType::U32,
        "i8" => NumberType::I64,
        "u8" => NumberType::U64,
        "f2" => NumberType::F16,
        "f4" => NumberType::F32,
        "f8" => NumberType::F64,
        _ => return Err(unsupported()),
    };
    Ok((number_type, order))
}

/// The three entries of a header.
struct Dictionary {
    descr: String,
    fortran_order: bool,
    shape: Vec<u64>,
}

impl Dictionary {
    /// Reads `{'descr': '<f8', 'fortran_order': False, 'shape': (3, 4), }`.
    fn parse(text: &str) -> Result<Self, Error> {
        let fault = |what: &str| {
            Error::parse(format!("the header of the array {what}"))
                .with_cure("it is damaged: save the array again by numpy.save")
        };
        let mut rest = text.trim();
        rest = rest.strip_prefix('{').ok_or_else(|| fault("is no dictionary"))?.trim_start();
        let (mut descr, mut order, mut shape) = (None, None, None);
        while !rest.starts_with('}') {
            let (key, after) = quoted(rest).ok_or_else(|| fault("has a key that is no text"))?;
            rest = after.trim_start().strip_prefix(':').ok_or_else(|| fault("lacks a colon"))?.trim_start();
            match key {
                "descr" => {
                    if rest.starts_with('[') {
                        return Err(Error::new(ErrorKind::UnsupportedFormat, "this is an array of records")
                            .with_cure("save one field of it as an array"));
                    }
                    let (value, after) = quoted(rest).ok_or_else(|| fault("names no type"))?;
                    (descr, rest) = (Some(value.to_owned()), after);
                }
                "fortran_order" => {
                    let word = ["True", "False"].into_iter().find(|word| rest.starts_with(word));
                    let word = word.ok_or_else(|| fault("does not say in which order numbers run"))?;
                    (order, rest) = (Some(word == "True"), &rest[word.len()..]);
                }
                "shape" => {
                    let list = rest.strip_prefix('(').and_then(|list| list.split_once(')'));
                    let (list, after) = list.ok_or_else(|| fault("has no shape in parentheses"))?;
                    let lengths = list.split(',').map(str::trim).filter(|length| !length.is_empty());
                    let lengths: Result<Vec<u64>, _> =
                        lengths.map(|length| length.strip_suffix('L').unwrap_or(length).parse()).collect();
                    (shape, rest) =
                        (Some(lengths.map_err(|_| fault("has a length that is no number"))?), after);
                }
                _ => return Err(fault(&format!("has the key \"{}\"", key.escape_debug()))),
            }
            rest = rest.trim_start();
            rest = match rest.strip_prefix(',') {
                Some(rest) => rest.trim_start(),
                None if rest.starts_with('}') => rest,
                None => return Err(fault("does not end")),
            };
        }
        match (descr, order, shape) {
            (Some(descr), Some(fortran_order), Some(shape)) => Ok(Self { descr, fortran_order, shape }),
            _ => Err(fault("lacks type, order or shape")),
        }
    }
}

/// A text in quotes, and what comes after it.
fn quoted(text: &str) -> Option<(&str, &str)> {
    let quote = text.chars().next().filter(|quote| matches!(quote, '\'' | '"'))?;
    text[1..].split_once(quote)
}

/// Writes a volume as an array of bytes, 1 where a voxel is set, the last axis running fastest. Whether axes are periodic is not kept.
///
/// # Errors
/// [`ErrorKind::Io`] from the output.
///
/// # Examples
/// ```
/// use coface_complexes::cubical::CubicalVolume;
/// use coface_io::volume;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let ring = CubicalVolume::new(&[3, 3], &[false; 2], |voxel| voxel != [1, 1])?;
/// let mut bytes = Vec::new();
/// volume::write_npy(&ring, &mut bytes)?;
/// assert_eq!(bytes[bytes.len() - 9..], [1, 1, 1, 1, 0, 1, 1, 1, 1]);
/// # Ok(()) }
/// ```
pub fn write(volume: &CubicalVolume, mut out: impl Write) -> Result<(), Error> {
    let shape: Vec<usize> = volume.shape().iter().map(|&length| length as usize).collect();
    write_header(&shape, "|u1", &mut out)?;
    let row = *volume.shape().last().unwrap_or(&1) as usize;
    let mut bytes = Vec::with_capacity(row);
    for start in (0..volume.voxel_count()).step_by(row) {
        bytes.clear();
        bytes.extend((start..start + row).map(|at| u8::from(volume.is_set_at(at))));
        out.write_all(&bytes)?;
    }
    out.flush()?;
    Ok(())
}

/// Writes what stands before the numbers of an array of this shape, of which the last axis runs fastest, and this type.
pub(crate) fn write_header(shape: &[usize], descr: &str, out: &mut impl Write) -> Result<(), Error> {
    let lengths: Vec<String> = shape.iter().map(|length| format!("{length},")).collect();
    let mut text =
        format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': ({}), }}", lengths.join(" "));
    while (text.len() + 11) % 64 != 0 {
        text.push(' ');
    }
    text.push('\n');
    out.write_all(MAGIC)?;
    out.write_all(&[1, 0])?;
    out.write_all(&(text.len() as u16).to_le_bytes())?;
    out.write_all(text.as_bytes())?;
    Ok(())
}
