//! NIfTI-1 and -2: `.nii`, `.nii.gz`, `.hdr` with `.img`.

use super::frame::VoxelFrame;
use super::header::{Encoding, Skip, VolumeHeader, exactly, shape_of};
use super::numbers::NumberType;
use crate::features::{GZIP, gunzipped};
use coface_algebra::{Error, ErrorKind};
use std::io::Read;

const LENGTH_1: usize = 348;
const LENGTH_2: usize = 540;

/// Whether bytes are the start of a NIfTI header, compressed or not.
pub(crate) fn is_nifti(start: &[u8]) -> bool {
    if start.starts_with(GZIP) {
        let mut unpacked = Vec::new();
        // NIfTI is the only format that is read compressed: without that feature, its reader says what is missing.
        let Ok(stream) = gunzipped(start) else { return true };
        // A start that is cut off gives what can be unpacked of it.
        let _ = stream.take(LENGTH_2 as u64).read_to_end(&mut unpacked);
        return !unpacked.starts_with(GZIP) && is_nifti(&unpacked);
    }
    let Some(first) = start.get(..4) else { return false };
    let first: [u8; 4] = first.try_into().expect("four bytes");
    let length = [u32::from_le_bytes(first), u32::from_be_bytes(first)];
    length.contains(&(LENGTH_1 as u32)) && matches!(start.get(344..347), Some(b"n+1" | b"ni1"))
        || length.contains(&(LENGTH_2 as u32)) && matches!(start.get(4..7), Some(b"n+2" | b"ni2"))
}

/// Numbers at places of a header, of one byte order.
struct Fields {
    bytes: Vec<u8>,
    is_big_endian: bool,
}

macro_rules! field {
    ($name:ident, $number:ty) => {
        fn $name(&self, at: usize) -> $number {
            const SIZE: usize = size_of::<$number>();
            let bytes: [u8; SIZE] = self.bytes[at..at + SIZE].try_into().expect("the header has the field");
            if self.is_big_endian { <$number>::from_be_bytes(bytes) } else { <$number>::from_le_bytes(bytes) }
        }
    };
}

impl Fields {
    field!(i16, i16);
    field!(i32, i32);
    field!(i64, i64);
    field!(f32, f32);
    field!(f64, f64);
}

/// Reads the header. `is_single` says whether its numbers lie in the same file: those of a pair do not.
///
/// # Errors
/// [`ErrorKind::Parse`] for what is no header; [`ErrorKind::UnsupportedFormat`] for ANALYZE headers and types that are no real numbers.
pub(super) fn read_header(input: &mut impl Read) -> Result<(VolumeHeader, bool), Error> {
    let mut bytes = exactly(input, 4, "the header")?;
    let first: [u8; 4] = [bytes[0], bytes[1], bytes[2], bytes[3]];
    let (length, is_big_endian) =
        match (u32::from_le_bytes(first) as usize, u32::from_be_bytes(first) as usize) {
            (length @ (LENGTH_1 | LENGTH_2), _) => (length, false),
            (_, length @ (LENGTH_1 | LENGTH_2)) => (length, true),
            _ => {
                return Err(Error::parse(
                    "the file does not begin with the length of a NIfTI header, 348 or 540",
                )
                .at_byte(0)
                .with_cure("check that the file is the one meant"));
            }
        };
    bytes.append(&mut exactly(input, length - 4, "the header")?);
    let magic_at = if length == LENGTH_1 { 344 } else { 4 };
    let is_single = match (length, &bytes[magic_at..magic_at + 3]) {
        (LENGTH_1, b"n+1") | (LENGTH_2, b"n+2") => true,
        (LENGTH_1, b"ni1") | (LENGTH_2, b"ni2") => false,
        (LENGTH_1, [0, ..]) => {
            return Err(Error::new(ErrorKind::UnsupportedFormat, "this is an ANALYZE header, not NIfTI")
                .at_byte(344)
                .with_cure("convert it to NIfTI first"));
        }
        _ => {
            return Err(Error::parse("the header has not the mark of NIfTI")
                .at_byte(magic_at as u64)
                .with_cure("the file is damaged: copy or write it again"));
        }
    };
    let fields = Fields { bytes, is_big_endian };
    let is_first = length == LENGTH_1;
    let (axes_at, type_at) = if is_first { (40, 70) } else { (16, 12) };
    let axis = |i: usize| {
        if is_first { i64::from(fields.i16(axes_at + 2 * i)) } else { fields.i64(axes_at + 8 * i) }
    };
    let axis_count = axis(0);
    if !(1..=7).contains(&axis_count) {
        return Err(Error::parse(format!("the header says {axis_count} axes, not 1 to 7"))
            .at_byte(axes_at as u64)
            .with_cure("the file is damaged: copy or write it again"));
    }
    let mut lengths = Vec::new();
    for i in 1..=axis_count as usize {
        let length = u64::try_from(axis(i)).map_err(|_| {
            Error::parse(format!("axis {} has the length {}", i - 1, axis(i))).at_byte(axes_at as u64)
        })?;
        lengths.push(length);
    }
    // Times and channels of which there is one are no axes of the volume.
    while lengths.len() > 3 && lengths.last() == Some(&1) {
        lengths.pop();
    }
    // The fifth axis holds the numbers of one voxel.
    if let Some(&count) = lengths.get(4).filter(|&&count| count > 1) {
        return Err(Error::new(ErrorKind::UnsupportedFormat, format!("a voxel has {count} numbers"))
            .with_cure("write one of them as a volume of its own"));
    }
    let shape = shape_of(&lengths).map_err(|error| error.at_byte(axes_at as u64))?;
    let number_type = number_type(fields.i16(type_at)).map_err(|error| error.at_byte(type_at as u64))?;
    let bits = fields.i16(type_at + 2);
    if usize::try_from(bits).ok() != Some(8 * number_type.size()) {
        return Err(Error::parse(format!(
            "the header says {bits} bits a voxel, but its type has {}",
            8 * number_type.size()
        ))
        .at_byte(type_at as u64 + 2)
        .with_cure("the file is damaged: copy or write it again"));
    }
    let (offset, slope, summand) = if is_first {
        (f64::from(fields.f32(108)), f64::from(fields.f32(112)), f64::from(fields.f32(116)))
    } else {
        (fields.i64(168) as f64, fields.f64(176), fields.f64(184))
    };
    let is_scaled =
        slope.is_finite() && summand.is_finite() && slope != 0.0 && (slope, summand) != (1.0, 0.0);
    let offset_at = if is_first { 108 } else { 168 };
    Ok((
        VolumeHeader {
            shape,
            is_first_fastest: true,
            number_type,
            is_big_endian,
            encoding: Encoding::Raw,
            scale: is_scaled.then_some((slope, summand)),
            skip: Skip::Ahead {
                lines: 0,
                bytes: data_offset(offset, length, is_single).map_err(|error| error.at_byte(offset_at))?,
            },
            data_file: None,
            length: length as u64,
            frame: (lengths.len() == 3).then(|| frame(&fields, is_first)).flatten(),
        },
        is_single,
    ))
}

/// Where voxels are: by the affine map, by the rotation, or by the sizes of voxels alone, in this order.
fn frame(fields: &Fields, is_first: bool) -> Option<VoxelFrame> {
    let number = |at: usize| if is_first { f64::from(fields.f32(at)) } else { fields.f64(at) };
    let width = if is_first { 4 } else { 8 };
    let numbers = |at: usize| -> [f64; 3] { std::array::from_fn(|i| number(at + i * width)) };
    let (has_rotation, has_affine) = if is_first {
        (fields.i16(252) > 0, fields.i16(254) > 0)
    } else {
        (fields.i32(344) > 0, fields.i32(348) > 0)
    };
    let [sizes_at, quaternion_at, affine_at] = if is_first { [76, 256, 280] } else { [104, 352, 400] };
    let affine = |axis: usize, column: usize| number(affine_at + (4 * axis + column) * width);
    if has_affine {
        let column = |step: usize| [0, 1, 2].map(|axis| affine(axis, step));
        if let Some(frame) =
            VoxelFrame::new([0, 1, 2].map(column), Some([0, 1, 2].map(|axis| affine(axis, 3))))
        {
            return Some(frame);
        }
    }
    let sizes = numbers(sizes_at + width).map(|size| if size == 0.0 { 1.0 } else { size.abs() });
    if has_rotation {
        let [b, c, d] = numbers(quaternion_at);
        let a = (1.0 - b * b - c * c - d * d).max(0.0).sqrt();
        let turn = if number(sizes_at) < 0.0 { -1.0 } else { 1.0 };
        let steps = [
            [a * a + b * b - c * c - d * d, 2.0 * (b * c + a * d), 2.0 * (b * d - a * c)]
                .map(|x| x * sizes[0]),
            [2.0 * (b * c - a * d), a * a + c * c - b * b - d * d, 2.0 * (c * d + a * b)]
                .map(|x| x * sizes[1]),
            [2.0 * (b * d + a * c), 2.0 * (c * d - a * b), a * a + d * d - b * b - c * c]
                .map(|x| x * sizes[2] * turn),
        ];
        return VoxelFrame::new(steps, Some(numbers(quaternion_at + 3 * width)));
    }
    VoxelFrame::of_spacing(&sizes, None)
}

/// How many bytes are between the header, or the beginning of a file of numbers alone, and the first number.
fn data_offset(offset: f64, length: usize, is_single: bool) -> Result<u64, Error> {
    // Zero, in a file of both, is whatever follows the header and the four bytes that say whether it is extended.
    let least = if is_single { length as f64 } else { 0.0 };
    let offset = if is_single && offset == 0.0 { least + 4.0 } else { offset };
    if !(least..9e15).contains(&offset) || offset.fract() != 0.0 {
        return Err(Error::parse(format!("numbers cannot begin at byte {offset}"))
            .with_cure("the file is damaged: copy or write it again"));
    }
    Ok((offset - least) as u64)
}

fn number_type(code: i16) -> Result<NumberType, Error> {
    Ok(match code {
        2 => NumberType::U8,
        4 => NumberType::I16,
        8 => NumberType::I32,
        16 => NumberType::F32,
        64 => NumberType::F64,
        256 => NumberType::I8,
        512 => NumberType::U16,
        768 => NumberType::U32,
        1024 => NumberType::I64,
        1280 => NumberType::U64,
        _ => {
            let name = match code {
                1 => "single bits",
                32 | 1792 | 2048 => "complex numbers",
                128 | 2304 => "colors",
                1536 => "floating point numbers of 128 bits",
                _ => "a type that is not known",
            };
            return Err(Error::new(
                ErrorKind::UnsupportedFormat,
                format!("the voxels are {name} (code {code})"),
            )
            .with_cure("write the volume with integers, or floating point numbers of 32 or 64 bits"));
        }
    })
}
