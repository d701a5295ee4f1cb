//! Pixels.

use super::palette::{Color, packed};
#[cfg(feature = "png")]
use coface_algebra::progress::stage;
use coface_algebra::{Error, ErrorKind};
use std::ops::Range;

/// Pixels with one number each: red, green and blue in bytes.
pub(super) struct Canvas {
    pub(super) width: usize,
    pub(super) height: usize,
    pub(super) pixels: Vec<u32>,
}

impl Canvas {
    pub(super) fn new(width: usize, height: usize, color: u32) -> Self {
        Self { width, height, pixels: vec![color; width * height] }
    }

    /// Mixes a color into a pixel, with a share of 256.
    pub(super) fn mix(&mut self, at: usize, color: u32, share: u32) {
        let old = self.pixels[at];
        // Two parts at a time: they do not run into each other.
        let both = |mask: u32, shift: u32| {
            let [old, new] = [old, color].map(|number| number >> shift & mask);
            ((old * (256 - share) + new * share) >> 8 & mask) << shift
        };
        self.pixels[at] = both(0x00ff_00ff, 0) | both(0x0000_00ff, 8);
    }

    /// Fills what lies within an odd number of closed outlines. $O(n + k \log k)$ for n corners and k rows that their sides cross.
    pub(super) fn fill(&mut self, outlines: &[Vec<[f64; 2]>], color: u32, share: u32) {
        let mut crossings: Vec<(u32, f64)> = Vec::new();
        for outline in outlines {
            for (i, &from) in outline.iter().enumerate() {
                let to = outline[(i + 1) % outline.len()];
                let [low, high] = if from[1] <= to[1] { [from, to] } else { [to, from] };
                let slope = (high[0] - low[0]) / (high[1] - low[1]);
                for row in centers(low[1], high[1], self.height) {
                    crossings.push((row as u32, low[0] + slope * (row as f64 + 0.5 - low[1])));
                }
            }
        }
        crossings.sort_by(|a, b| a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)));
        for pair in crossings.chunks_exact(2) {
            let start = pair[0].0 as usize * self.width;
            let columns = centers(pair[0].1, pair[1].1, self.width);
            if share >= 256 {
                self.pixels[start + columns.start..start + columns.end].fill(color);
            } else {
                columns.for_each(|column| self.mix(start + column, color, share));
            }
        }
    }

    /// What `draw` makes on a background, as PNG, each pixel the mean of `factor` by `factor` of it. Without a background it is drawn on black and on
    /// white, and the differences are what shows through.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] in a build without PNG; [`ErrorKind::Io`] should the encoder fail.
    pub(super) fn png_on(
        background: Option<Color>,
        factor: usize,
        draw: impl Fn(u32) -> Self,
    ) -> Result<Vec<u8>, Error> {
        match background {
            Some(color) => Self::png_of_frames(1, 0, factor, |_| Ok(draw(packed(color)))),
            None => Self::transparent_png([&draw(0), &draw(0x00ff_ffff)], factor),
        }
    }

    /// Frames of one size as one PNG, which is an animation if they are several: each is shown for so many milliseconds, without end. Each pixel is
    /// the mean of `factor` by `factor` of a frame.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`] in a build without PNG; what `frame` gives; [`ErrorKind::Io`] should the encoder fail.
    #[cfg(feature = "png")]
    pub(super) fn png_of_frames(
        count: u32,
        milliseconds: u16,
        factor: usize,
        frame: impl Fn(u32) -> Result<Self, Error>,
    ) -> Result<Vec<u8>, Error> {
        let first = frame(0)?;
        let mut file = Vec::new();
        let mut encoder =
            encoder(&mut file, [first.width / factor, first.height / factor], png::ColorType::Rgb);
        if count > 1 {
            encoder.set_animated(count, 0).map_err(failed)?;
            encoder.set_frame_delay(milliseconds, 1000).map_err(failed)?;
        }
        let mut writer = encoder.write_header().map_err(failed)?;
        writer.write_image_data(&first.shrunk(factor)).map_err(failed)?;
        for number in 1..count {
            writer.write_image_data(&frame(number)?.shrunk(factor)).map_err(failed)?;
        }
        writer.finish().map_err(failed)?;
        Ok(file)
    }

    /// Says that pictures are not written as PNG by this build.
    #[cfg(not(feature = "png"))]
    pub(super) fn png_of_frames(
        _: u32,
        _: u16,
        _: usize,
        _: impl Fn(u32) -> Result<Self, Error>,
    ) -> Result<Vec<u8>, Error> {
        Err(no_png())
    }

    /// Says that pictures are not written as PNG by this build.
    #[cfg(not(feature = "png"))]
    fn transparent_png(_: [&Self; 2], _: usize) -> Result<Vec<u8>, Error> {
        Err(no_png())
    }

    #[cfg(feature = "png")]
    fn transparent_png([black, white]: [&Self; 2], factor: usize) -> Result<Vec<u8>, Error> {
        let pixels = black.shrunk(factor);
        let mut bytes = Vec::with_capacity(pixels.len() / 3 * 4);
        for (on_black, on_white) in pixels.chunks_exact(3).zip(white.shrunk(factor).chunks_exact(3)) {
            let difference: u32 =
                on_black.iter().zip(on_white).map(|(&b, &w)| u32::from(w.saturating_sub(b))).sum();
            let alpha = 255 - (difference + 1) / 3;
            let whole =
                |part: u8| (u32::from(part) * 255 + alpha / 2).checked_div(alpha).unwrap_or(0).min(255);
            bytes.extend(on_black.iter().map(|&part| whole(part) as u8));
            bytes.push(alpha as u8);
        }
        let mut file = Vec::new();
        let size = [black.width / factor, black.height / factor];
        let mut writer = encoder(&mut file, size, png::ColorType::Rgba).write_header().map_err(failed)?;
        writer.write_image_data(&bytes).map_err(failed)?;
        writer.finish().map_err(failed)?;
        Ok(file)
    }

    #[cfg(feature = "png")]
    fn shrunk(&self, factor: usize) -> Vec<u8> {
        let (width, height) = (self.width / factor, self.height / factor);
        let count = (factor * factor) as u32;
        let mut bytes = Vec::with_capacity(3 * width * height);
        let steps = stage("averaging pixels", height);
        for rows in self.pixels.chunks_exact(self.width * factor).take(height) {
            steps.advance(1);
            // Red and blue in one sum, with room above each; factors are small.
            let mut sums = vec![[0u32; 2]; width];
            for row in rows.chunks_exact(self.width) {
                for (sum, samples) in sums.iter_mut().zip(row.chunks_exact(factor)) {
                    for &sample in samples {
                        sum[0] += sample & 0x00ff_00ff;
                        sum[1] += sample & 0x0000_ff00;
                    }
                }
            }
            let mean = |sum: u32| ((sum + count / 2) / count) as u8;
            for [red_and_blue, green] in sums {
                bytes.extend([mean(red_and_blue >> 16), mean(green >> 8), mean(red_and_blue & 0xffff)]);
            }
        }
        bytes
    }
}

#[cfg(feature = "png")]
fn encoder(
    file: &mut Vec<u8>,
    [width, height]: [usize; 2],
    color: png::ColorType,
) -> png::Encoder<'_, &mut Vec<u8>> {
    let mut encoder = png::Encoder::new(file, width as u32, height as u32);
    encoder.set_color(color);
    encoder.set_depth(png::BitDepth::Eight);
    encoder.set_compression(png::Compression::High);
    encoder
}

#[cfg(feature = "png")]
#[expect(clippy::needless_pass_by_value, reason = "as map_err gives it")]
fn failed(error: png::EncodingError) -> Error {
    Error::new(ErrorKind::Io, format!("the PNG cannot be written: {error}"))
}

#[cfg(not(feature = "png"))]
fn no_png() -> Error {
    Error::new(ErrorKind::UnsupportedFormat, "PNG is not in this build")
        .with_cure("write SVG, or build with the feature png")
}

/// The numbers from 0 to below `count` whose pixels have their middle from `low` to below `high`.
pub(super) fn centers(low: f64, high: f64, count: usize) -> Range<usize> {
    let end = count as f64;
    let [low, high] = [low, high].map(|bound| (bound - 0.5).ceil().clamp(0.0, end) as usize);
    low..high.max(low)
}

#[cfg(all(test, feature = "png"))]
mod tests {
    use super::*;

    #[test]
    fn a_square_with_a_hole_has_its_area() {
        let square = |low: f64, high: f64| vec![[low, low], [high, low], [high, high], [low, high]];
        let mut canvas = Canvas::new(20, 20, 0);
        canvas.fill(&[square(2.0, 18.0), square(6.0, 10.0)], 0x00ff_ffff, 256);
        let white = canvas.pixels.iter().filter(|&&pixel| pixel == 0x00ff_ffff).count();
        assert_eq!(white, 16 * 16 - 4 * 4);
        assert_eq!(canvas.shrunk(20), vec![153; 3]);
    }

    #[test]
    fn shares_of_colors_are_mixed() {
        let mut canvas = Canvas::new(1, 1, 0x0000_00ff);
        canvas.mix(0, 0x00ff_8000, 128);
        assert_eq!(canvas.pixels[0], 0x007f_407f);
    }

    #[test]
    fn what_lies_outside_is_cut_away() {
        let mut canvas = Canvas::new(4, 4, 0);
        canvas.fill(&[vec![[-1e9, -1e9], [1e9, -1e9], [1e9, 1e9], [-1e9, 1e9]]], 7, 256);
        assert!(canvas.pixels.iter().all(|&pixel| pixel == 7));
    }
}
