//! MetaImage of ITK: `.mha`, and `.mhd` with numbers in another file.

use super::frame::VoxelFrame;
use super::header::{Encoding, Lines, Skip, VolumeHeader, shape_of, shortened};
use super::numbers::NumberType;
use coface_algebra::{Error, ErrorKind};
use std::io::Read;
use std::path::PathBuf;

/// Whether a file begins as a header does: with one of the fields that stand first.
pub(crate) fn is_metaimage(start: &[u8]) -> bool {
    let line = start.split(|&byte| byte == b'\n').next().unwrap_or_default();
    let (name, value) = line.split_at(line.iter().position(|&byte| byte == b'=').unwrap_or(0));
    !value.is_empty() && matches!(name.trim_ascii(), b"ObjectType" | b"NDims" | b"Comment" | b"ObjectSubType")
}

/// Reads the header, whose last field is `ElementDataFile`.
///
/// # Errors
/// [`ErrorKind::Parse`] with the line for what is no header; [`ErrorKind::UnsupportedFormat`] for types, several numbers a voxel, and numbers in
/// several files.
pub(super) fn read_header(input: &mut impl Read) -> Result<VolumeHeader, Error> {
    let mut lines = Lines::new(input, "the field ElementDataFile ends it");
    let mut fields = Fields::default();
    while fields.data_file.is_none() {
        let Some(line) = lines.next()? else {
            return Err(Error::parse("the header lacks its last field, ElementDataFile")
                .at_line(lines.number())
                .with_cure("the file is cut short: copy or write it again"));
        };
        if !line.trim().is_empty() {
            fields.take(&line).map_err(|error| error.at_line(lines.number()))?;
        }
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
    is_big_endian: bool,
    is_packed: bool,
    is_text: bool,
    skip: Option<Skip>,
    /// `LOCAL`, or the name of a file.
    data_file: Option<String>,
    spacing: Option<Vec<f64>>,
    directions: Option<Vec<f64>>,
    origin: Option<[f64; 3]>,
}

impl Fields {
    fn take(&mut self, line: &str) -> Result<(), Error> {
        let Some((name, value)) = line.split_once('=') else {
            return Err(Error::parse(format!("\"{}\" is no field of a header", shortened(line)))
                .with_cure("write a field as \"Name = value\""));
        };
        let (name, value) = (name.trim(), value.trim());
        let wrong = |what: &str| Error::parse(format!("{name} is \"{}\", not {what}", shortened(value)));
        let truth = || match value.to_ascii_lowercase().as_str() {
            "true" | "1" => Ok(true),
            "false" | "0" => Ok(false),
            _ => Err(wrong("True or False").with_cure("write True or False")),
        };
        match name {
            "ObjectType" if !value.eq_ignore_ascii_case("Image") => {
                let fault = Error::new(ErrorKind::UnsupportedFormat, wrong("Image").message().to_owned());
                return Err(fault.with_cure("give a MetaImage of an image"));
            }
            "NDims" => self.axis_count = Some(value.parse().map_err(|_| wrong("a number of axes"))?),
            "DimSize" => {
                let sizes: Result<Vec<u64>, _> = value.split_whitespace().map(str::parse).collect();
                self.sizes = Some(sizes.map_err(|_| wrong("sizes"))?);
            }
            "ElementType" => self.number_type = Some(number_type(value)?),
            "ElementNumberOfChannels" if value != "1" => {
                return Err(Error::new(
                    ErrorKind::UnsupportedFormat,
                    format!("a voxel has {} numbers", shortened(value)),
                )
                .with_cure("write one of them as a volume of its own"));
            }
            "BinaryDataByteOrderMSB" | "ElementByteOrderMSB" => self.is_big_endian = truth()?,
            "BinaryData" => self.is_text = !truth()?,
            "CompressedData" => self.is_packed = truth()?,
            "HeaderSize" if value == "-1" => self.skip = Some(Skip::FromEnd),
            "HeaderSize" => {
                let bytes = value.parse().map_err(|_| wrong("a number of bytes"))?;
                self.skip = Some(Skip::Ahead { lines: 0, bytes });
            }
            "ElementSpacing" => self.spacing = numbers(value),
            "TransformMatrix" | "Rotation" | "Orientation" => self.directions = numbers(value),
            "Offset" | "Position" | "Origin" => {
                self.origin = numbers(value).and_then(|numbers| numbers.try_into().ok());
            }
            "ElementDataFile" => {
                if value.starts_with("LIST") || value.contains('%') {
                    return Err(Error::new(ErrorKind::UnsupportedFormat, "the numbers are in several files")
                        .with_cure("join them in one MetaImage first"));
                }
                self.data_file = Some(value.to_owned());
            }
            _ => {}
        }
        Ok(())
    }

    /// Where voxels are: the rows of the matrix are the directions of the axes.
    fn frame(&self) -> Option<VoxelFrame> {
        let spacing = self.spacing.clone().unwrap_or_else(|| vec![1.0; 3]);
        match self.directions.as_deref() {
            Some(&[a, b, c, d, e, f, g, h, i]) if spacing.len() == 3 => {
                let along = |step: usize, direction: [f64; 3]| direction.map(|x| x * spacing[step]);
                VoxelFrame::new([along(0, [a, b, c]), along(1, [d, e, f]), along(2, [g, h, i])], self.origin)
            }
            _ => VoxelFrame::of_spacing(&spacing, self.origin),
        }
    }

    fn into_header(self, length: u64) -> Result<VolumeHeader, Error> {
        let missing = |field: &str| {
            Error::parse(format!("the header lacks the field {field}"))
                .with_cure("write it before ElementDataFile, as the format asks")
        };
        let frame = self.frame();
        let axis_count = self.axis_count.ok_or_else(|| missing("NDims"))?;
        let sizes = self.sizes.ok_or_else(|| missing("DimSize"))?;
        if sizes.len() != axis_count {
            let message = format!("the header says {axis_count} axes, but gives {} sizes", sizes.len());
            return Err(Error::parse(message).with_cure("write a size for each axis"));
        }
        let encoding = match (self.is_text, self.is_packed) {
            (true, _) => Encoding::Ascii,
            (false, true) => Encoding::Zlib,
            (false, false) => Encoding::Raw,
        };
        if self.skip == Some(Skip::FromEnd) && encoding != Encoding::Raw {
            return Err(Error::parse(
                "only of raw numbers it is known how many bytes from the end they begin",
            )
            .with_cure("write how many bytes are to be skipped"));
        }
        Ok(VolumeHeader {
            shape: shape_of(&sizes)?,
            is_first_fastest: true,
            number_type: self.number_type.ok_or_else(|| missing("ElementType"))?,
            is_big_endian: self.is_big_endian,
            encoding,
            scale: None,
            skip: self.skip.unwrap_or(Skip::NOTHING),
            data_file: self.data_file.filter(|name| !name.eq_ignore_ascii_case("LOCAL")).map(PathBuf::from),
            length,
            frame,
        })
    }
}

fn numbers(text: &str) -> Option<Vec<f64>> {
    text.split_whitespace().map(|word| word.parse().ok()).collect()
}

fn number_type(name: &str) -> Result<NumberType, Error> {
    Ok(match name {
        "MET_CHAR" => NumberType::I8,
        "MET_UCHAR" => NumberType::U8,
        "MET_SHORT" => NumberType::I16,
        "MET_USHORT" => NumberType::U16,
        // Of 32 bits on every system that writes them.
        "MET_INT" | "MET_LONG" => NumberType::I32,
        "MET_UINT" | "MET_ULONG" => NumberType::U32,
        "MET_LONG_LONG" => NumberType::I64,
        "MET_ULONG_LONG" => NumberType::U64,
        "MET_FLOAT" => NumberType::F32,
        "MET_DOUBLE" => NumberType::F64,
        _ => {
            let message = format!("the type \"{}\" is not one of numbers", shortened(name));
            return Err(Error::new(ErrorKind::UnsupportedFormat, message)
                .with_cure("write integers, or floating point numbers of 32 or 64 bits"));
        }
    })
}
