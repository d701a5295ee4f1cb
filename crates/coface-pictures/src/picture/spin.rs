//! Animations.

use super::canvas::Canvas;
use super::palette::packed;
use super::style::SAMPLES;
use super::{Picture, PictureStyle};
use crate::Scene;
use coface_algebra::{Error, ErrorKind};

/// The most frames of an animation.
const MOST_FRAMES: u32 = 3600;

/// The model turning once about what is up, as an animated PNG of so many frames, each shown for so many milliseconds, without end. Programs that
/// know no animations show the first frame.
///
/// # Errors
/// What [`Picture::new`] and [`Picture::png`] give; [`ErrorKind::InvalidInput`] without frames; [`ErrorKind::TooLarge`] beyond 3600 of them;
/// [`ErrorKind::UnsupportedFormat`] for a transparent background, which animations do not have.
///
/// # Complexity
/// That of the pictures; one is in memory at a time, beside the file.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// use coface_pictures::{PictureStyle, Scene, spin_png};
/// let triangle = &b"v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n"[..];
/// let triangle = coface_io::read(triangle, coface_io::Format::Obj)?;
/// let scene = Scene::of("triangle", &triangle)?;
/// let mut style = PictureStyle::default();
/// style.size = [40, 30];
/// let file = spin_png(&scene, &style, 4, 100)?;
/// // The chunk that says how many frames there are.
/// assert!(file.windows(8).any(|bytes| bytes == b"acTL\0\0\0\x04"));
/// # Ok(()) }
/// ```
pub fn spin_png(
    scene: &Scene,
    style: &PictureStyle,
    frames: u32,
    milliseconds: u16,
) -> Result<Vec<u8>, Error> {
    if frames == 0 {
        return Err(Error::invalid("an animation without frames").with_cure("give a number above 0"));
    }
    if frames > MOST_FRAMES {
        let message = format!("{frames} frames are more than {MOST_FRAMES}");
        return Err(Error::new(ErrorKind::TooLarge, message).with_cure("ask for fewer"));
    }
    if style.is_transparent {
        return Err(Error::new(ErrorKind::UnsupportedFormat, "an animation has a background")
            .with_cure("leave the transparent background out"));
    }
    Canvas::png_of_frames(frames, milliseconds, SAMPLES, |number| {
        let mut style = style.clone();
        style.turn = Some(style.turn.unwrap_or(0.0) + 360.0 * f64::from(number) / f64::from(frames));
        Ok(Picture::new(scene, &style)?.canvas(packed(style.theme().background)))
    })
}
