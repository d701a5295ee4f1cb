//! NRRD: `.nrrd`, and `.nhdr` with numbers in another file.

use super::frame::VoxelFrame;
use super::header::{Encoding, Lines, Skip, VolumeHeader, shape_of, shortened};
use super::numbers::NumberType;
use coface_algebra::{Error, ErrorKind};
use std::io::Read;
use std::path::PathBuf;

pub(crate) const MAGIC: &[u8] = b"NRRD000";

/// Reads the header, up to the empty line that ends it, or the end of the file.
///
/// # Errors
/// [`ErrorKind::Parse`] with the line for what is no header; [`ErrorKind::UnsupportedFormat`] for types and encodings that are not read.
pub(super) fn read_header(input: &mut impl Read) -> Result<VolumeHeader, Error> {
    let mut lines = Lines::new(input, "an empty line ends it");
    let first = lines.next()?.unwrap_or_default();
    if !matches!(first.as_bytes(), [b'N', b'R', b'R', b'D', b'0', b'0', b'0', b'1'..=b'5']) {
        return Err(Error::parse("the first line is not NRRD0001 to NRRD0005")
            .at_line(1)
            .with_cure("check that the file is the one meant"));
    }
    let mut fields = Fields::default();
    let mut has_end = false;
    while let Some(line) = lines.next()? {
        if line.is_empty() {
            has_end = true;
            break;
        }
        let number = lines.number();
        if !line.starts_with('#') {
            fields.take(&line).map_err(|error| error.at_line(number))?;
        }
    }
    if !has_end && fields.data_file.is_none() {
        return Err(Error::parse("the header does not end with an empty line, and names no file of numbers")
            .at_line(lines.number())
            .with_cure("the file is cut short: copy or write it again"));
    }
    let (number, total) = (lines.number(), lines.total());
    fields.into_header(total as u64).map_err(|error| error.at_line(number))
}

/// What the lines of a header say.
#[derive(Default)]
struct Fields {
    number_type: Option<NumberType>,
    axis_count: Option<usize>,
    sizes: Option<Vec<u64>>,
    /// The axes along which one voxel has several numbers, with what they are.
    several: Vec<(usize, String)>,
    encoding: Option<Encoding>,
    is_big_endian: Option<bool>,
    data_file: Option<PathBuf>,
    lines: u64,
    bytes: u64,
    is_at_end: bool,
    spacings: Option<Vec<f64>>,
    directions: Option<[[f64; 3]; 3]>,
    origin: Option<[f64; 3]>,
}

impl Fields {
    fn take(&mut self, line: &str) -> Result<(), Error> {
        // `key:=value` pairs are for people.
        let Some((name, value)) = line.split_once(':') else {
            return Err(Error::parse(format!("\"{}\" is no field of a header", shortened(line)))
                .with_cure("write a field as \"name: value\", and an empty line after the last"));
        };
        if value.starts_with('=') {
            return Ok(());
        }
        let value = value.trim();
        let count = |what: &str| {
            value.parse().map_err(|_| Error::parse(format!("\"{}\" is no {what}", shortened(value))))
        };
        match name.trim().to_ascii_lowercase().as_str() {
            "type" => self.number_type = Some(number_type(value)?),
            "dimension" => self.axis_count = Some(count("number of axes")? as usize),
            "sizes" => {
                let sizes: Result<Vec<u64>, _> = value.split_whitespace().map(str::parse).collect();
                self.sizes =
                    Some(sizes.map_err(|_| Error::parse(format!("\"{}\" are no sizes", shortened(value))))?);
            }
            "kinds" => self.several.extend(value.split_whitespace().enumerate().filter_map(several_of_kind)),
            "encoding" => self.encoding = Some(encoding(value)?),
            "endian" => {
                self.is_big_endian = Some(match value.to_ascii_lowercase().as_str() {
                    "little" => false,
                    "big" => true,
                    _ => {
                        return Err(Error::parse(format!("\"{}\" is no byte order", shortened(value)))
                            .with_cure("write little or big"));
                    }
                });
            }
            "data file" | "datafile" => {
                if value.starts_with("LIST") || value.contains('%') {
                    return Err(Error::new(ErrorKind::UnsupportedFormat, "the numbers are in several files")
                        .with_cure("join them in one NRRD file first"));
                }
                self.data_file = Some(PathBuf::from(value));
            }
            "spacings" => {
                self.spacings = value.split_whitespace().map(|word| word.parse().ok()).collect();
            }
            "space directions" => {
                let vectors: Vec<[f64; 3]> = value.split(')').filter_map(vector).collect();
                self.directions = vectors.try_into().ok();
            }
            "space origin" => self.origin = value.split(')').find_map(vector),
            "line skip" | "lineskip" => self.lines = count("number of lines")?,
            "byte skip" | "byteskip" => match value {
                "-1" => self.is_at_end = true,
                _ => self.bytes = count("number of bytes")?,
            },
            _ => {}
        }
        Ok(())
    }

    fn into_header(self, length: u64) -> Result<VolumeHeader, Error> {
        let missing = |field: &str| {
            Error::parse(format!("the header lacks the field \"{field}\""))
                .with_cure("write it as the format asks")
        };
        let number_type = self.number_type.ok_or_else(|| missing("type"))?;
        let axis_count = self.axis_count.ok_or_else(|| missing("dimension"))?;
        let sizes = self.sizes.ok_or_else(|| missing("sizes"))?;
        let encoding = self.encoding.ok_or_else(|| missing("encoding"))?;
        if sizes.len() != axis_count {
            return Err(Error::parse(format!(
                "the header says {axis_count} axes, but gives {} sizes",
                sizes.len()
            ))
            .with_cure("write a size for each axis"));
        }
        let one = self.several.iter().find(|(axis, _)| sizes.get(*axis).is_some_and(|&size| size > 1));
        if let Some((axis, kind)) = one {
            return Err(Error::new(
                ErrorKind::UnsupportedFormat,
                format!("a voxel has {} numbers: axis {axis} is of the kind \"{kind}\"", sizes[*axis]),
            )
            .with_cure("write one of them as a volume of its own"));
        }
        let needs_order = number_type.size() > 1 && encoding != Encoding::Ascii;
        if needs_order && self.is_big_endian.is_none() {
            return Err(missing("endian"));
        }
        if self.is_at_end && encoding != Encoding::Raw {
            return Err(Error::parse(
                "only of raw numbers it is known how many bytes from the end they begin",
            )
            .with_cure("write how many bytes are to be skipped"));
        }
        let skip =
            if self.is_at_end { Skip::FromEnd } else { Skip::Ahead { lines: self.lines, bytes: self.bytes } };
        Ok(VolumeHeader {
            shape: shape_of(&sizes)?,
            is_first_fastest: true,
            number_type,
            is_big_endian: self.is_big_endian.unwrap_or(false),
            encoding,
            scale: None,
            skip,
            data_file: self.data_file,
            length,
            frame: match self.directions {
                Some(steps) => VoxelFrame::new(steps, self.origin),
                None => self.spacings.and_then(|spacings| VoxelFrame::of_spacing(&spacings, self.origin)),
            },
        })
    }
}

/// The three numbers behind a parenthesis.
fn vector(text: &str) -> Option<[f64; 3]> {
    let (_, numbers) = text.split_once('(')?;
    let numbers: Option<Vec<f64>> = numbers.split(',').map(|word| word.trim().parse().ok()).collect();
    numbers?.try_into().ok()
}

/// The axis, and the kind of its samples, if these belong to one voxel.
fn several_of_kind((axis, kind): (usize, &str)) -> Option<(usize, String)> {
    let kind = kind.to_ascii_lowercase();
    let is_of_space = matches!(&kind[..], "domain" | "space" | "time" | "none" | "???" | "stub" | "scalar");
    (!is_of_space).then(|| (axis, shortened(&kind)))
}

fn encoding(name: &str) -> Result<Encoding, Error> {
    match name.to_ascii_lowercase().as_str() {
        "raw" => Ok(Encoding::Raw),
        "gz" | "gzip" => Ok(Encoding::Gzip),
        "txt" | "text" | "ascii" => Ok(Encoding::Ascii),
        _ => Err(Error::new(
            ErrorKind::UnsupportedFormat,
            format!("the encoding \"{}\" is not read", shortened(name)),
        )
        .with_cure("write the numbers as raw, gzip or ascii")),
    }
}

fn number_type(name: &str) -> Result<NumberType, Error> {
    Ok(match name.to_ascii_lowercase().as_str() {
        "signed char" | "int8" | "int8_t" => NumberType::I8,
        "uchar" | "unsigned char" | "uint8" | "uint8_t" => NumberType::U8,
        "short" | "short int" | "signed short" | "signed short int" | "int16" | "int16_t" => NumberType::I16,
        "ushort" | "unsigned short" | "unsigned short int" | "uint16" | "uint16_t" => NumberType::U16,
        "int" | "signed int" | "int32" | "int32_t" => NumberType::I32,
        "uint" | "unsigned int" | "uint32" | "uint32_t" => NumberType::U32,
        "longlong"
        | "long long"
        | "long long int"
        | "signed long long"
        | "signed long long int"
        | "int64"
        | "int64_t" => NumberType::I64,
        "ulonglong" | "unsigned long long" | "unsigned long long int" | "uint64" | "uint64_t" => {
            NumberType::U64
        }
        "float" => NumberType::F32,
        "double" => NumberType::F64,
        _ => {
            return Err(Error::new(
                ErrorKind::UnsupportedFormat,
                format!("the type \"{}\" is not one of numbers", shortened(name)),
            )
            .with_cure("write integers, or floating point numbers of 32 or 64 bits"));
        }
    })
}
