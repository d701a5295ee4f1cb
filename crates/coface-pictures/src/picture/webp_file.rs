//! Animations as WebP: frames without loss in the container of RIFF chunks.

use super::pixels::Pixels;
use coface_algebra::{Error, ErrorKind};
use image_webp::{ColorType, WebPEncoder};

/// No frame that is packed without loss has longer sides.
const LONGEST_SIDE: usize = 1 << 14;
/// The flag of a file that has frames, and that of one whose pixels have opacities.
const ANIMATION: u8 = 1 << 1;
const OPACITY: u8 = 1 << 4;
/// A frame replaces the pixels of the one before.
const REPLACES: u8 = 1 << 1;

/// A WebP that is written frame by frame.
pub(super) struct WebP {
    file: Vec<u8>,
    milliseconds: u16,
}

impl WebP {
    /// Begins a file of frames of this size, each of which is shown for so many milliseconds, without end.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] for sides beyond 16384 pixels.
    pub(super) fn new(size: [usize; 2], is_transparent: bool, milliseconds: u16) -> Result<Self, Error> {
        if let Some(side) = size.into_iter().find(|&side| side > LONGEST_SIDE) {
            let message = format!("a WebP has at most {LONGEST_SIDE} pixels a side, not {side}");
            return Err(Error::new(ErrorKind::TooLarge, message).with_cure("make a smaller picture"));
        }
        // The length of the file is known at its end.
        let mut file = Self { file: b"RIFF\0\0\0\0WEBP".to_vec(), milliseconds };
        let flags = if is_transparent { ANIMATION | OPACITY } else { ANIMATION };
        let [width, height] = size.map(less_one);
        file.chunk(b"VP8X", &[&[flags, 0, 0, 0][..], &width, &height].concat())?;
        // Four bytes for the color behind, two for how often it is shown: 0 is without end.
        file.chunk(b"ANIM", &[0; 6])?;
        Ok(file)
    }

    /// Appends a frame.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] beyond 4 GiB; [`ErrorKind::Io`] should the encoder fail.
    pub(super) fn push(&mut self, pixels: &Pixels) -> Result<(), Error> {
        let color = if pixels.has_opacity { ColorType::Rgba8 } else { ColorType::Rgb8 };
        let [width, height] = pixels.size.map(|side| side as u32);
        let mut still = Vec::new();
        WebPEncoder::new(&mut still).encode(&pixels.bytes, width, height, color).map_err(failed)?;
        let packed = chunk_of(&still, b"VP8L").ok_or_else(|| {
            Error::new(ErrorKind::Io, "the WebP cannot be written: the encoder gives no packed pixels")
        })?;
        let [width, height] = pixels.size.map(less_one);
        let time = &u32::from(self.milliseconds).to_le_bytes()[..3];
        // The frame lies at the corner, whose place has three bytes an axis.
        self.chunk(b"ANMF", &[&[0; 6], &width[..], &height, time, &[REPLACES], packed].concat())
    }

    /// The whole file.
    pub(super) fn into_bytes(self) -> Vec<u8> {
        self.file
    }

    /// Appends a chunk, with a byte more where its length is odd.
    fn chunk(&mut self, name: &[u8; 4], content: &[u8]) -> Result<(), Error> {
        let too_long = || {
            Error::new(ErrorKind::TooLarge, "the animation takes more than 4 GiB, which a WebP cannot be")
                .with_cure("ask for fewer frames, or make a smaller picture")
        };
        let length = u32::try_from(content.len()).map_err(|_| too_long())?;
        self.file.extend(name);
        self.file.extend(length.to_le_bytes());
        self.file.extend(content);
        if length % 2 == 1 {
            self.file.push(0);
        }
        let length = u32::try_from(self.file.len() - 8).map_err(|_| too_long())?;
        self.file[4..8].copy_from_slice(&length.to_le_bytes());
        Ok(())
    }
}

/// A length less one in three bytes.
fn less_one(length: usize) -> [u8; 3] {
    let [a, b, c, _] = (length.saturating_sub(1) as u32).to_le_bytes();
    [a, b, c]
}

/// A chunk of a file by its name, with its head.
fn chunk_of<'f>(file: &'f [u8], name: &[u8; 4]) -> Option<&'f [u8]> {
    let mut rest = file.get(12..)?;
    loop {
        let length = rest.get(4..8)?.try_into().ok().map(u32::from_le_bytes)? as usize;
        let whole = rest.get(..8 + length + length % 2)?;
        if rest.starts_with(name) {
            return Some(whole);
        }
        rest = &rest[whole.len()..];
    }
}

#[expect(clippy::needless_pass_by_value, reason = "as map_err gives it")]
fn failed(error: image_webp::EncodingError) -> Error {
    Error::new(ErrorKind::Io, format!("the WebP cannot be written: {error}"))
}

#[cfg(test)]
mod tests {
    use super::*;
    use image_webp::{LoopCount, WebPDecoder};
    use std::io::Cursor;

    /// Frames of random colors, so that nothing can be packed away: read back, each has its pixels.
    #[test]
    fn frames_are_read_as_they_were_written() {
        for has_opacity in [false, true] {
            let parts = if has_opacity { 4 } else { 3 };
            let mut seed = 1u32;
            let mut byte = || {
                seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
                (seed >> 24) as u8
            };
            for size in [[1, 1], [7, 5], [64, 3]] {
                let frames: Vec<Vec<u8>> =
                    (0..3).map(|_| (0..size[0] * size[1] * parts).map(|_| byte()).collect()).collect();
                let mut webp = WebP::new(size, has_opacity, 42).unwrap();
                for bytes in &frames {
                    webp.push(&Pixels { bytes: bytes.clone(), has_opacity, size }).unwrap();
                }
                let file = webp.into_bytes();
                let mut decoder = WebPDecoder::new(Cursor::new(&file)).unwrap();
                assert!(decoder.is_animated() && decoder.has_alpha() == has_opacity);
                assert_eq!(decoder.dimensions(), (size[0] as u32, size[1] as u32));
                assert_eq!((decoder.num_frames(), decoder.loop_count()), (3, LoopCount::Forever));
                for bytes in &frames {
                    let mut found = vec![0; bytes.len()];
                    assert_eq!(decoder.read_frame(&mut found).unwrap(), 42);
                    assert_eq!(&found, bytes);
                }
            }
        }
    }

    #[test]
    fn sides_that_are_too_long_are_refused() {
        let error = WebP::new([9, LONGEST_SIDE + 1], false, 42).map(WebP::into_bytes).unwrap_err();
        assert_eq!(error.kind(), ErrorKind::TooLarge);
    }
}
