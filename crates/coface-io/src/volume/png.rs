//! Images as PNG: a pixel is one number.

use super::header::{Encoding, Skip, VolumeHeader, shape_of};
use super::numbers::NumberType;
use crate::unpacking::most_unpacked;
use crate::{Remark, RemarkCode};
use coface_algebra::Error;
use png::{BitDepth, ColorType, DecodingError, Limits, Reader, Transformations};
use std::io::{Cursor, Read};

/// An image whose header has been read: what it says, its numbers row by row from the highest, and remarks.
pub(super) struct Image {
    pub(super) header: VolumeHeader,
    pub(super) numbers: Numbers,
    pub(super) remarks: Vec<Remark>,
}

/// Reads an image up to its first row. Axis 0 goes along the rows, axis 1 down. Grey values are those of the file, of 1, 2 and 4 bits
/// stretched to the range of a byte; a color is its brightness by Rec. ITU-R BT.601, and one of a palette its place there unless all colors
/// of the palette are grey. Opacity is left out.
///
/// # Errors
/// [`ErrorKind::Parse`](coface_algebra::ErrorKind::Parse) for a damaged header, and one that says more pixels than the bytes of the file
/// can unpack to.
///
/// # References
/// W3C, *Portable Network Graphics (PNG) Specification*.
pub(super) fn read(input: &mut impl Read) -> Result<Image, Error> {
    let mut bytes = Vec::new();
    input.read_to_end(&mut bytes)?;
    let most = most_unpacked(bytes.len() as u64);
    let mut decoder = png::Decoder::new(Cursor::new(bytes));
    decoder.set_transformations(Transformations::IDENTITY);
    decoder.set_ignore_text_chunk(true);
    decoder.set_ignore_iccp_chunk(true);
    let info = decoder.read_header_info().map_err(|error| damaged(&error))?;
    let (width, height) = (u64::from(info.width), u64::from(info.height));
    let row = (u128::from(width) * (info.color_type.samples() * info.bit_depth as usize) as u128).div_ceil(8);
    if row * u128::from(height) > most.into() {
        let message = format!("the image says {width} by {height} pixels, more than its bytes can hold");
        return Err(Error::parse(message).with_cure(CURE));
    }
    decoder.set_limits(Limits { bytes: most as usize });
    let reader = decoder.read_info().map_err(|error| damaged(&error))?;
    let info = reader.info();
    let shape = shape_of(&[width, height])?;
    let palette: Option<&[u8]> = info.palette.as_deref();
    let greys = palette.and_then(grey_palette);
    let remarks = remarks(info.color_type, greys.is_some());
    let header = VolumeHeader {
        shape,
        is_first_fastest: true,
        number_type: if info.bit_depth == BitDepth::Sixteen { NumberType::U16 } else { NumberType::U8 },
        is_big_endian: true,
        encoding: Encoding::Raw,
        scale: None,
        skip: Skip::NOTHING,
        data_file: None,
        length: 0,
        frame: None,
    };
    let pixel = Pixel { color: info.color_type, depth: info.bit_depth, width: info.width as usize, greys };
    let numbers = Numbers { reader, pixel, frame: Vec::new(), row: Vec::new(), place: 0, done: 0 };
    Ok(Image { header, numbers, remarks })
}

/// What was assumed of a pixel that is not one number.
fn remarks(color: ColorType, is_grey: bool) -> Vec<Remark> {
    let mut remarks = Vec::new();
    let assumed = match color {
        ColorType::Rgb | ColorType::Rgba => {
            Some("the image has colors: a pixel is its brightness, 0.299 R + 0.587 G + 0.114 B")
        }
        ColorType::Indexed if !is_grey => Some(
            "the image has a palette of colors: a pixel is the place of its color in the palette, from 0",
        ),
        _ => None,
    };
    if let Some(message) = assumed {
        remarks.push(Remark::new(RemarkCode::ColorsAsNumbers, message));
    }
    if let ColorType::Rgba | ColorType::GrayscaleAlpha = color {
        remarks.push(Remark::new(RemarkCode::DataLeftOut, "the opacity of the pixels is left out"));
    }
    remarks
}

/// The grey values of a palette without colors.
fn grey_palette(palette: &[u8]) -> Option<Vec<u8>> {
    let is_grey = palette.chunks_exact(3).all(|color| color[0] == color[1] && color[1] == color[2]);
    is_grey.then(|| palette.chunks_exact(3).map(|color| color[0]).collect())
}

const CURE: &str = "the file is damaged or cut short: copy or write it again";

fn damaged(error: &DecodingError) -> Error {
    Error::parse(format!("the image cannot be read: {error}")).with_cure(CURE)
}

/// How pixels lie in a row of the file.
struct Pixel {
    color: ColorType,
    depth: BitDepth,
    width: usize,
    /// The values of a palette without colors.
    greys: Option<Vec<u8>>,
}

impl Pixel {
    /// Makes one number of each pixel of a row.
    fn numbers(&self, row: &[u8], out: &mut Vec<u8>) {
        let of_color =
            |color: &[u32]| (19595 * color[0] + 38470 * color[1] + 7471 * color[2] + (1 << 15)) >> 16;
        let parts = self.color.samples();
        match self.depth {
            BitDepth::Sixteen => {
                for pixel in row.chunks_exact(2 * parts).take(self.width) {
                    let part = |k: usize| u32::from(u16::from_be_bytes([pixel[2 * k], pixel[2 * k + 1]]));
                    let value = if parts < 3 { part(0) } else { of_color(&[part(0), part(1), part(2)]) };
                    // A mean of 16 bits has 16 bits.
                    out.extend_from_slice(&(value as u16).to_be_bytes());
                }
            }
            BitDepth::Eight => {
                for pixel in row.chunks_exact(parts).take(self.width) {
                    let part = |k: usize| u32::from(pixel[k]);
                    let value = if parts < 3 { part(0) } else { of_color(&[part(0), part(1), part(2)]) };
                    out.push(self.palette_value(value as u8));
                }
            }
            // Several pixels a byte, the first in the highest bits.
            depth => {
                let (bits, most) = (depth as usize, (1u16 << depth as u32) - 1);
                for place in 0..self.width {
                    let shift = 8 - bits - place * bits % 8;
                    let value = u16::from(row[place * bits / 8] >> shift) & most;
                    let is_grey = self.color == ColorType::Grayscale;
                    let value = if is_grey { value * 255 / most } else { value };
                    out.push(self.palette_value(value as u8));
                }
            }
        }
    }

    fn palette_value(&self, value: u8) -> u8 {
        match &self.greys {
            Some(greys) => greys.get(usize::from(value)).copied().unwrap_or(0),
            None => value,
        }
    }
}

/// The numbers of an image, a row at a time.
pub(super) struct Numbers {
    reader: Reader<Cursor<Vec<u8>>>,
    pixel: Pixel,
    /// All rows of an interlaced image, which are known at its end only.
    frame: Vec<u8>,
    /// So many bytes of the frame are done.
    done: usize,
    row: Vec<u8>,
    place: usize,
}

impl Numbers {
    fn next_row(&mut self) -> Result<(), DecodingError> {
        self.row.clear();
        self.place = 0;
        if !self.reader.info().interlaced {
            if let Some(row) = self.reader.next_row()? {
                self.pixel.numbers(row.data(), &mut self.row);
            }
            return Ok(());
        }
        if self.frame.is_empty() {
            // The size was compared with what the bytes of the file can unpack to.
            self.frame.resize(self.reader.output_buffer_size().unwrap_or(0), 0);
            self.reader.next_frame(&mut self.frame)?;
        }
        let length = self.reader.output_line_size(self.reader.info().width).unwrap_or(0);
        if let Some(row) = self.frame.get(self.done..self.done + length) {
            self.pixel.numbers(row, &mut self.row);
            self.done += length;
        }
        Ok(())
    }
}

impl Read for Numbers {
    fn read(&mut self, out: &mut [u8]) -> std::io::Result<usize> {
        if self.place == self.row.len() {
            self.next_row().map_err(|error| match error {
                DecodingError::IoError(error) => error,
                error => std::io::Error::new(std::io::ErrorKind::InvalidData, error),
            })?;
        }
        let count = out.len().min(self.row.len() - self.place);
        out[..count].copy_from_slice(&self.row[self.place..self.place + count]);
        self.place += count;
        Ok(count)
    }
}

#[cfg(test)]
mod tests {
    use crate::{Format, RemarkCode, VolumeStream, read};
    use flate2::write::ZlibEncoder;
    use png::{BitDepth, ColorType};
    use std::io::Write;

    /// An image, as the encoder of the crate writes it.
    fn image(
        shape: [u32; 2],
        color: ColorType,
        depth: BitDepth,
        palette: Option<&[u8]>,
        rows: &[u8],
    ) -> Vec<u8> {
        let mut bytes = Vec::new();
        let mut encoder = png::Encoder::new(&mut bytes, shape[0], shape[1]);
        encoder.set_color(color);
        encoder.set_depth(depth);
        if let Some(palette) = palette {
            encoder.set_palette(palette.to_vec());
        }
        encoder.write_header().unwrap().write_image_data(rows).unwrap();
        bytes
    }

    /// The numbers of an image, and the codes of what was assumed.
    fn numbers(bytes: &[u8]) -> (Vec<f64>, Vec<RemarkCode>) {
        let (numbers, remarks) = VolumeStream::new(bytes, Format::Png).unwrap().numbers().unwrap();
        (numbers, remarks.iter().map(|remark| remark.code).collect())
    }

    #[test]
    fn grey_values_are_those_of_the_file() {
        let bytes = image([3, 2], ColorType::Grayscale, BitDepth::Eight, None, &[0, 9, 5, 5, 0, 255]);
        assert_eq!(numbers(&bytes), (vec![0.0, 9.0, 5.0, 5.0, 0.0, 255.0], vec![]));
        let words: Vec<u8> = [0u16, 256, 65535, 1].iter().flat_map(|value| value.to_be_bytes()).collect();
        let bytes = image([2, 2], ColorType::Grayscale, BitDepth::Sixteen, None, &words);
        assert_eq!(numbers(&bytes), (vec![0.0, 256.0, 65535.0, 1.0], vec![]));
        // Ten pixels of one bit: two bytes a row, the rest of the second unused.
        let bytes = image([10, 1], ColorType::Grayscale, BitDepth::One, None, &[0b1010_0001, 0b0111_1111]);
        let expected = [1, 0, 1, 0, 0, 0, 0, 1, 0, 1].map(|bit| 255.0 * f64::from(bit));
        assert_eq!(numbers(&bytes).0, expected);
        let bytes = image([4, 1], ColorType::Grayscale, BitDepth::Two, None, &[0b0001_1011]);
        assert_eq!(numbers(&bytes).0, [0.0, 85.0, 170.0, 255.0]);
    }

    #[test]
    fn colors_become_numbers_and_that_is_said() {
        let rows = [255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255];
        let bytes = image([4, 1], ColorType::Rgb, BitDepth::Eight, None, &rows);
        assert_eq!(numbers(&bytes), (vec![76.0, 150.0, 29.0, 255.0], vec![RemarkCode::ColorsAsNumbers]));
        let bytes = image([1, 1], ColorType::Rgba, BitDepth::Eight, None, &[9, 9, 9, 0]);
        assert_eq!(numbers(&bytes), (vec![9.0], vec![RemarkCode::ColorsAsNumbers, RemarkCode::DataLeftOut]));
        let bytes = image([2, 1], ColorType::GrayscaleAlpha, BitDepth::Eight, None, &[7, 0, 8, 255]);
        assert_eq!(numbers(&bytes), (vec![7.0, 8.0], vec![RemarkCode::DataLeftOut]));
        let palette = [10, 10, 10, 200, 0, 0];
        let bytes = image([4, 1], ColorType::Indexed, BitDepth::One, Some(&palette), &[0b0110_0000]);
        assert_eq!(numbers(&bytes), (vec![0.0, 1.0, 1.0, 0.0], vec![RemarkCode::ColorsAsNumbers]));
        let palette = [10, 10, 10, 200, 200, 200];
        let bytes = image([4, 1], ColorType::Indexed, BitDepth::One, Some(&palette), &[0b0110_0000]);
        assert_eq!(numbers(&bytes), (vec![10.0, 200.0, 200.0, 10.0], vec![]));
    }

    #[test]
    fn an_image_is_known_by_its_first_bytes() {
        let bytes = image([3, 2], ColorType::Grayscale, BitDepth::Eight, None, &[1, 1, 1, 1, 0, 1]);
        let model = crate::read_with(&bytes[..], &crate::ReadOptions::new()).unwrap();
        assert_eq!(model.format(), Some(Format::Png));
        assert_eq!(read(&bytes[..], Format::Png).unwrap().format(), Some(Format::Png));
    }

    fn crc(bytes: &[u8]) -> u32 {
        !bytes.iter().fold(u32::MAX, |crc, &byte| {
            (0..8).fold(
                crc ^ u32::from(byte),
                |crc, _| if crc & 1 == 1 { crc >> 1 ^ 0xedb8_8320 } else { crc >> 1 },
            )
        })
    }

    /// An interlaced image of bytes, by the table of passes in the specification.
    fn interlaced(width: usize, height: usize, values: &[u8]) -> Vec<u8> {
        let passes = [
            (0, 0, 8, 8),
            (4, 0, 8, 8),
            (0, 4, 4, 8),
            (2, 0, 4, 4),
            (0, 2, 2, 4),
            (1, 0, 2, 2),
            (0, 1, 1, 2),
        ];
        let mut packed = ZlibEncoder::new(Vec::new(), flate2::Compression::default());
        for (x, y, dx, dy) in passes {
            for row in (y..height).step_by(dy) {
                let pixels: Vec<u8> =
                    (x..width).step_by(dx).map(|column| values[row * width + column]).collect();
                if !pixels.is_empty() {
                    packed.write_all(&[0]).unwrap();
                    packed.write_all(&pixels).unwrap();
                }
            }
        }
        let size = [width as u32, height as u32].map(u32::to_be_bytes).concat();
        file(&[size, vec![8, 0, 0, 0, 1]].concat(), &packed.finish().unwrap())
    }

    /// A file of a header and packed rows.
    fn file(header: &[u8], packed: &[u8]) -> Vec<u8> {
        let mut bytes = super::super::PNG_MAGIC.to_vec();
        for (name, content) in [(b"IHDR", header), (b"IDAT", packed), (b"IEND", &[])] {
            let chunk = [&name[..], content].concat();
            bytes.extend_from_slice(&(content.len() as u32).to_be_bytes());
            bytes.extend_from_slice(&chunk);
            bytes.extend_from_slice(&crc(&chunk).to_be_bytes());
        }
        bytes
    }

    #[test]
    fn interlaced_rows_are_put_in_their_places() {
        for (width, height) in [(8, 8), (1, 1), (5, 3), (13, 9)] {
            let values: Vec<u8> = (0..width * height).map(|place| (7 * place % 251) as u8).collect();
            let expected: Vec<f64> = values.iter().map(|&value| f64::from(value)).collect();
            assert_eq!(numbers(&interlaced(width, height, &values)).0, expected, "{width} by {height}");
        }
    }

    /// What a file says of its size is compared with what it can hold, and each cut is an error.
    #[test]
    fn damaged_images_are_refused() {
        let whole = image([9, 9], ColorType::Grayscale, BitDepth::Eight, None, &(0..81).collect::<Vec<u8>>());
        for length in 0..whole.len() - 12 {
            let cut = VolumeStream::new(&whole[..length], Format::Png).and_then(VolumeStream::numbers);
            assert!(cut.is_err(), "{length} of {} bytes", whole.len());
        }
        for interlace in [0, 1] {
            let size = [0x7fff_ffffu32, 0x7fff_ffff].map(u32::to_be_bytes).concat();
            let claim = file(&[size, vec![8, 0, 0, 0, interlace]].concat(), &[]);
            let error = VolumeStream::new(&claim[..], Format::Png).map(|_| ()).unwrap_err();
            assert!(error.to_string().contains("more than its bytes can hold"), "{error}");
        }
    }
}
