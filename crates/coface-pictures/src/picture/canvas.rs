//! Pixels.

use super::palette::Color;
#[cfg(feature = "png")]
use super::palette::packed;
#[cfg(feature = "png")]
use super::pixels::Pixels;
use coface_algebra::Error;
#[cfg(not(feature = "png"))]
use coface_algebra::ErrorKind;
#[cfg(feature = "png")]
use coface_algebra::progress::stage;
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

    /// What `draw` makes on a background, each pixel the mean of `factor` by `factor` of it. Without a background it is drawn on black and on white,
    /// and the differences are what shows through.
    #[cfg(feature = "png")]
    pub(super) fn pixels_on(background: Option<Color>, factor: usize, draw: impl Fn(u32) -> Self) -> Pixels {
        match background {
            Some(color) => draw(packed(color)).pixels(factor),
            None => Pixels::between(&draw(0).pixels(factor), &draw(0x00ff_ffff).pixels(factor)),
        }
    }

    #[cfg(feature = "png")]
    fn pixels(&self, factor: usize) -> Pixels {
        let size = [self.width / factor, self.height / factor];
        Pixels { bytes: self.shrunk(factor), has_opacity: false, size }
    }

    /// The same as PNG.
    ///
    /// # Errors
    /// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat) in a build without PNG;
    /// [`ErrorKind::Io`](coface_algebra::ErrorKind::Io) should the encoder fail.
    #[cfg(feature = "png")]
    pub(super) fn png_on(
        background: Option<Color>,
        factor: usize,
        draw: impl Fn(u32) -> Self,
    ) -> Result<Vec<u8>, Error> {
        Pixels::png(1, 0, |_| Ok(Self::pixels_on(background, factor, &draw)))
    }

    /// Says that pictures are not written as PNG by this build.
    #[cfg(not(feature = "png"))]
    pub(super) fn png_on(_: Option<Color>, _: usize, _: impl Fn(u32) -> Self) -> Result<Vec<u8>, Error> {
        Err(no_png())
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

#[cfg(not(feature = "png"))]
pub(super) fn no_png() -> Error {
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
