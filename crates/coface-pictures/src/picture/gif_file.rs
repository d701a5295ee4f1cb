//! Animations as GIF: one palette for all frames.

use super::pixels::Pixels;
use coface_algebra::{Error, ErrorKind};
use std::borrow::Cow;

/// Bits of each part of a color by which colors are counted.
const BITS: u32 = 5;
const BINS: usize = 1 << (3 * BITS);
/// A palette has so many colors, one of which may be none.
const MOST_COLORS: usize = 256;
/// Pixels of less opacity are not drawn: a GIF knows no others.
const OPAQUE: u8 = 128;

/// How often colors occur, near ones together.
pub(super) struct Colors {
    /// For each bin the count, and the sums of red, green and blue.
    bins: Vec<[u64; 4]>,
}

/// The bin of a color.
fn bin([red, green, blue]: [u8; 3]) -> usize {
    [red, green, blue].iter().fold(0, |bin, part| bin << BITS | usize::from(part >> (8 - BITS)))
}

impl Colors {
    pub(super) fn new() -> Self {
        Self { bins: vec![[0; 4]; BINS] }
    }

    /// Counts the colors of a frame; pixels that are not drawn have none.
    pub(super) fn count(&mut self, pixels: &Pixels) {
        pixels.for_each(|color, opacity| {
            if opacity >= OPAQUE {
                let own = &mut self.bins[bin(color)];
                own[0] += 1;
                (0..3).for_each(|part| own[part + 1] += u64::from(color[part]));
            }
        });
    }

    /// A palette of so many colors at most: boxes around colors are halved at the median of their longest side, the one with the most pixels times length
    /// first (P. Heckbert, *Color image quantization for frame buffer display*, 1982).
    fn palette(&self, most: usize) -> Vec<[u8; 3]> {
        let used: Vec<usize> = (0..BINS).filter(|&bin| self.bins[bin][0] > 0).collect();
        if used.is_empty() {
            return vec![[0; 3]];
        }
        let part = |bin: usize, axis: usize| bin >> (BITS as usize * (2 - axis)) & ((1 << BITS) - 1);
        let weight = |bins: &[usize]| bins.iter().map(|&bin| self.bins[bin][0]).sum::<u64>();
        let longest = |bins: &[usize]| {
            let length = |axis: usize| {
                let parts = bins.iter().map(|&bin| part(bin, axis));
                parts.clone().max().unwrap_or(0) - parts.min().unwrap_or(0)
            };
            (0..3)
                .map(|axis| (length(axis), axis))
                .max_by_key(|&(length, axis)| (length, 3 - axis))
                .unwrap_or((0, 0))
        };
        // A background has most pixels; roots let it not take most colors.
        let urgency = |bins: &[usize]| (weight(bins) as f64).sqrt() * longest(bins).0 as f64;
        let mut boxes = vec![(urgency(&used), used)];
        while boxes.len() < most {
            let Some(place) = (0..boxes.len()).max_by(|&a, &b| boxes[a].0.total_cmp(&boxes[b].0)) else {
                break;
            };
            if boxes[place].0 <= 0.0 {
                break;
            }
            let (_, mut bins) = boxes.swap_remove(place);
            let (_, axis) = longest(&bins);
            bins.sort_by_key(|&bin| part(bin, axis));
            let half = weight(&bins) / 2;
            let mut sum = 0;
            let middle = bins.iter().position(|&bin| {
                sum += self.bins[bin][0];
                sum > half
            });
            let cut = middle.unwrap_or(0).clamp(1, bins.len() - 1);
            let rest = bins.split_off(cut);
            boxes.extend([(urgency(&bins), bins), (urgency(&rest), rest)]);
        }
        let mean = |bins: &Vec<usize>| {
            let sums =
                bins.iter().fold([0u64; 4], |sums, &bin| [0, 1, 2, 3].map(|i| sums[i] + self.bins[bin][i]));
            [1, 2, 3].map(|part| ((sums[part] + sums[0] / 2) / sums[0]) as u8)
        };
        boxes.iter().map(|(_, bins)| mean(bins)).collect()
    }
}

/// A GIF that is written frame by frame.
pub(super) struct Gif<'f> {
    encoder: gif::Encoder<&'f mut Vec<u8>>,
    palette: Vec<[u8; 3]>,
    /// For each bin the place of the nearest color of the palette, once it was needed.
    nearest: Vec<Option<u8>>,
    /// The place of no color.
    nothing: Option<u8>,
    hundredths: u16,
    size: [u16; 2],
}

impl<'f> Gif<'f> {
    /// Begins a file of frames of this size, each of which is shown for so many milliseconds, without end.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] for sides beyond 65535 pixels; [`ErrorKind::Io`] should the encoder fail.
    pub(super) fn new(
        file: &'f mut Vec<u8>,
        size: [usize; 2],
        colors: &Colors,
        is_transparent: bool,
        milliseconds: u16,
    ) -> Result<Self, Error> {
        let side = |side: usize| {
            u16::try_from(side).map_err(|_| {
                let message = format!("a GIF has at most 65535 pixels a side, not {side}");
                Error::new(ErrorKind::TooLarge, message).with_cure("make a smaller picture")
            })
        };
        let size = [side(size[0])?, side(size[1])?];
        let mut palette = colors.palette(MOST_COLORS - usize::from(is_transparent));
        let nothing = is_transparent.then_some(palette.len() as u8);
        let own = palette.len();
        if is_transparent {
            palette.push([0; 3]);
        }
        let mut encoder =
            gif::Encoder::new(file, size[0], size[1], palette.as_flattened()).map_err(failed)?;
        encoder.set_repeat(gif::Repeat::Infinite).map_err(failed)?;
        palette.truncate(own);
        let hundredths = (milliseconds + 5) / 10;
        Ok(Self { encoder, palette, nearest: vec![None; BINS], nothing, hundredths: hundredths.max(2), size })
    }

    /// Appends a frame.
    ///
    /// # Errors
    /// [`ErrorKind::Io`] should the encoder fail.
    pub(super) fn push(&mut self, pixels: &Pixels) -> Result<(), Error> {
        let mut places = Vec::with_capacity(usize::from(self.size[0]) * usize::from(self.size[1]));
        pixels.for_each(|color, opacity| {
            let place = match self.nothing {
                Some(nothing) if opacity < OPAQUE => nothing,
                _ => self.place(color),
            };
            places.push(place);
        });
        let frame = gif::Frame {
            width: self.size[0],
            height: self.size[1],
            buffer: Cow::Owned(places),
            delay: self.hundredths,
            transparent: self.nothing,
            dispose: if self.nothing.is_some() {
                gif::DisposalMethod::Background
            } else {
                gif::DisposalMethod::Keep
            },
            ..gif::Frame::default()
        };
        self.encoder.write_frame(&frame).map_err(failed)
    }

    /// The place of the color of the palette that is nearest.
    fn place(&mut self, color: [u8; 3]) -> u8 {
        let slot = &mut self.nearest[bin(color)];
        *slot.get_or_insert_with(|| {
            let distance = |own: &[u8; 3]| {
                (0..3).map(|part| i32::from(own[part].abs_diff(color[part])).pow(2)).sum::<i32>()
            };
            let nearest = (0u8..=255).zip(&self.palette).min_by_key(|(_, own)| distance(own));
            nearest.map_or(0, |(place, _)| place)
        })
    }
}

#[expect(clippy::needless_pass_by_value, reason = "as map_err gives it")]
fn failed(error: gif::EncodingError) -> Error {
    Error::new(ErrorKind::Io, format!("the GIF cannot be written: {error}"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pixels(colors: &[[u8; 4]]) -> Pixels {
        Pixels { bytes: colors.as_flattened().to_vec(), has_opacity: true, size: [colors.len(), 1] }
    }

    #[test]
    fn few_colors_are_kept_as_they_are() {
        let own = [[255, 255, 255, 255], [0, 114, 178, 255], [213, 94, 0, 255], [9, 9, 9, 0]];
        let mut colors = Colors::new();
        colors.count(&pixels(&own));
        let mut palette = colors.palette(256);
        palette.sort_unstable();
        assert_eq!(palette, [[0, 114, 178], [213, 94, 0], [255, 255, 255]]);
    }

    #[test]
    fn many_colors_are_near_those_of_a_palette() {
        let ramp: Vec<[u8; 4]> = (0..=255).flat_map(|x: u8| [[x, x, x, 255], [x, 0, 128, 255]]).collect();
        let mut colors = Colors::new();
        colors.count(&pixels(&ramp));
        let palette = colors.palette(40);
        assert_eq!(palette.len(), 40);
        let far = ramp.iter().map(|own| {
            let distance =
                |color: &[u8; 3]| (0..3).map(|i| u32::from(own[i].abs_diff(color[i]))).sum::<u32>();
            palette.iter().map(distance).min().unwrap()
        });
        assert!(far.max().unwrap() < 60);
    }
}
