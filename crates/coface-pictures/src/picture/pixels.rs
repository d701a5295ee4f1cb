//! Pixels as bytes, and PNG files of them.

use coface_algebra::{Error, ErrorKind};

/// Pixels row after row: red, green and blue in bytes, and opacity where it is known.
pub(super) struct Pixels {
    pub(super) bytes: Vec<u8>,
    pub(super) has_opacity: bool,
    pub(super) size: [usize; 2],
}

impl Pixels {
    /// What a picture is that was drawn on black and on white: where they differ, what lies behind shows through.
    pub(super) fn between(black: &Self, white: &Self) -> Self {
        let mut bytes = Vec::with_capacity(black.bytes.len() / 3 * 4);
        for (on_black, on_white) in black.bytes.chunks_exact(3).zip(white.bytes.chunks_exact(3)) {
            let difference: u32 =
                on_black.iter().zip(on_white).map(|(&b, &w)| u32::from(w.saturating_sub(b))).sum();
            let alpha = 255 - (difference + 1) / 3;
            let whole =
                |part: u8| (u32::from(part) * 255 + alpha / 2).checked_div(alpha).unwrap_or(0).min(255);
            bytes.extend(on_black.iter().map(|&part| whole(part) as u8));
            bytes.push(alpha as u8);
        }
        Self { bytes, has_opacity: true, size: black.size }
    }

    /// Calls back with each pixel, row after row: its color and its opacity.
    pub(super) fn for_each(&self, mut found: impl FnMut([u8; 3], u8)) {
        for pixel in self.bytes.chunks_exact(if self.has_opacity { 4 } else { 3 }) {
            found([pixel[0], pixel[1], pixel[2]], pixel.get(3).copied().unwrap_or(255));
        }
    }

    /// The PNG of one frame, or of several of one size, each shown for so many milliseconds, without end.
    ///
    /// # Errors
    /// What `frame` gives; [`ErrorKind::Io`] should the encoder fail.
    pub(super) fn png(
        count: u32,
        milliseconds: u16,
        frame: impl Fn(u32) -> Result<Self, Error>,
    ) -> Result<Vec<u8>, Error> {
        let first = frame(0)?;
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, first.size[0] as u32, first.size[1] as u32);
        encoder.set_color(if first.has_opacity { png::ColorType::Rgba } else { png::ColorType::Rgb });
        encoder.set_depth(png::BitDepth::Eight);
        encoder.set_compression(png::Compression::High);
        if count > 1 {
            encoder.set_animated(count, 0).map_err(failed)?;
            encoder.set_frame_delay(milliseconds, 1000).map_err(failed)?;
        }
        let mut writer = encoder.write_header().map_err(failed)?;
        writer.write_image_data(&first.bytes).map_err(failed)?;
        for number in 1..count {
            writer.write_image_data(&frame(number)?.bytes).map_err(failed)?;
        }
        writer.finish().map_err(failed)?;
        Ok(file)
    }
}

#[expect(clippy::needless_pass_by_value, reason = "as map_err gives it")]
fn failed(error: png::EncodingError) -> Error {
    Error::new(ErrorKind::Io, format!("the PNG cannot be written: {error}"))
}
