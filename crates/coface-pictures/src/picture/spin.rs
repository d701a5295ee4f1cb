//! Animations.

#[cfg(not(feature = "png"))]
use super::canvas::no_png;
#[cfg(feature = "png")]
use super::gif_file::{Colors, Gif};
#[cfg(feature = "png")]
use super::pixels::Pixels;
#[cfg(feature = "png")]
use super::webp_file::WebP;
use super::{Picture, PictureStyle};
use crate::Scene;
use coface_algebra::{Error, ErrorKind};

/// The most frames of an animation.
const MOST_FRAMES: u32 = 3600;

/// The palette of a GIF is found from so many frames at most.
#[cfg(feature = "png")]
const COUNTED_FRAMES: u32 = 12;

/// The model turning once about what is up, as an animated PNG of so many frames, each shown for so many milliseconds, without end. Programs that
/// know no animations show the first frame.
///
/// # Errors
/// What [`Picture::new`] and [`Picture::png`] give; [`ErrorKind::InvalidInput`] without frames; [`ErrorKind::TooLarge`] beyond 3600 of them.
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
#[cfg(feature = "png")]
pub fn spin_png(
    scene: &Scene,
    style: &PictureStyle,
    frames: u32,
    milliseconds: u16,
) -> Result<Vec<u8>, Error> {
    check_frames(frames)?;
    Pixels::png(frames, milliseconds, |number| Ok(frame(scene, style, number, frames)?.pixels()))
}

/// The model turning once about what is up, as an animated GIF of so many frames, without end. The time of a frame is rounded to hundredths of a second,
/// and is two of them at least. All frames have one palette of 256 colors; a pixel of a transparent background is drawn or not, nothing
/// between.
///
/// # Errors
/// Those of [`spin_png`]; [`ErrorKind::TooLarge`] for sides beyond 65535 pixels.
///
/// # Complexity
/// That of the pictures, and of twelve more for the palette; one is in memory at a time, beside the file.
///
/// # References
/// P. Heckbert, *Color image quantization for frame buffer display* (1982), for the palette.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// use coface_pictures::{PictureStyle, Scene, spin_gif};
/// let triangle = &b"v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n"[..];
/// let triangle = coface_io::read(triangle, coface_io::Format::Obj)?;
/// let scene = Scene::of("triangle", &triangle)?;
/// let mut style = PictureStyle::default();
/// style.size = [40, 30];
/// let file = spin_gif(&scene, &style, 4, 100)?;
/// // The size stands after the six letters at the beginning.
/// assert!(file.starts_with(b"GIF89a\x28\0\x1e\0"));
/// # Ok(()) }
/// ```
#[cfg(feature = "png")]
pub fn spin_gif(
    scene: &Scene,
    style: &PictureStyle,
    frames: u32,
    milliseconds: u16,
) -> Result<Vec<u8>, Error> {
    check_frames(frames)?;
    let counted = frames.min(COUNTED_FRAMES);
    let mut colors = Colors::new();
    for place in 0..counted {
        let number = u64::from(place) * u64::from(frames) / u64::from(counted);
        colors.count(&frame(scene, style, number as u32, frames)?.pixels());
    }
    let mut file = Vec::new();
    let mut gif = Gif::new(&mut file, style.size, &colors, style.is_transparent, milliseconds)?;
    for number in 0..frames {
        gif.push(&frame(scene, style, number, frames)?.pixels())?;
    }
    drop(gif);
    Ok(file)
}

/// The model turning once about what is up, as an animated WebP of so many frames, each shown for so many milliseconds, without end. Colors and
/// opacities are kept as they are.
///
/// # Errors
/// Those of [`spin_png`]; [`ErrorKind::TooLarge`] for sides beyond 16384 pixels and for files beyond 4 GiB.
///
/// # Complexity
/// That of the pictures; one is in memory at a time, beside the file.
///
/// # References
/// *WebP Container Specification*: the chunks of an animation.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// use coface_pictures::{PictureStyle, Scene, spin_webp};
/// let triangle = &b"v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n"[..];
/// let triangle = coface_io::read(triangle, coface_io::Format::Obj)?;
/// let scene = Scene::of("triangle", &triangle)?;
/// let mut style = PictureStyle::default();
/// style.size = [40, 30];
/// let file = spin_webp(&scene, &style, 4, 100)?;
/// assert_eq!((&file[..4], &file[8..12]), (&b"RIFF"[..], &b"WEBP"[..]));
/// assert_eq!(file.windows(4).filter(|&bytes| bytes == b"ANMF").count(), 4);
/// # Ok(()) }
/// ```
#[cfg(feature = "png")]
pub fn spin_webp(
    scene: &Scene,
    style: &PictureStyle,
    frames: u32,
    milliseconds: u16,
) -> Result<Vec<u8>, Error> {
    check_frames(frames)?;
    let mut webp = WebP::new(style.size, style.is_transparent, milliseconds)?;
    for number in 0..frames {
        webp.push(&frame(scene, style, number, frames)?.pixels())?;
    }
    Ok(webp.into_bytes())
}

/// The model turning once about what is up: calls back with the number of each frame, from 0, and its PNG.
///
/// # Errors
/// Those of [`spin_png`], and what the callback gives.
///
/// # Complexity
/// That of the pictures; one is in memory at a time.
///
/// # Examples
/// ```
/// # fn main() -> Result<(), coface_algebra::Error> {
/// use coface_pictures::{PictureStyle, Scene, spin_frames};
/// let triangle = &b"v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n"[..];
/// let triangle = coface_io::read(triangle, coface_io::Format::Obj)?;
/// let scene = Scene::of("triangle", &triangle)?;
/// let mut style = PictureStyle::default();
/// style.size = [40, 30];
/// let mut numbers = Vec::new();
/// spin_frames(&scene, &style, 3, |number, file| {
///     assert!(file.starts_with(b"\x89PNG"));
///     numbers.push(number);
///     Ok(())
/// })?;
/// assert_eq!(numbers, [0, 1, 2]);
/// # Ok(()) }
/// ```
pub fn spin_frames(
    scene: &Scene,
    style: &PictureStyle,
    frames: u32,
    mut found: impl FnMut(u32, Vec<u8>) -> Result<(), Error>,
) -> Result<(), Error> {
    check_frames(frames)?;
    (0..frames).try_for_each(|number| found(number, frame(scene, style, number, frames)?.png()?))
}

/// Says that animations are not written by this build.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`], or those of the usual build.
#[cfg(not(feature = "png"))]
pub fn spin_png(_: &Scene, _: &PictureStyle, frames: u32, _: u16) -> Result<Vec<u8>, Error> {
    check_frames(frames)?;
    Err(no_png())
}

/// Says that animations are not written by this build.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`], or those of the usual build.
#[cfg(not(feature = "png"))]
pub fn spin_gif(_: &Scene, _: &PictureStyle, frames: u32, _: u16) -> Result<Vec<u8>, Error> {
    check_frames(frames)?;
    Err(no_png())
}

/// Says that animations are not written by this build.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`], or those of the usual build.
#[cfg(not(feature = "png"))]
pub fn spin_webp(_: &Scene, _: &PictureStyle, frames: u32, _: u16) -> Result<Vec<u8>, Error> {
    check_frames(frames)?;
    Err(no_png())
}

fn check_frames(frames: u32) -> Result<(), Error> {
    if frames == 0 {
        return Err(Error::invalid("an animation without frames").with_cure("give a number above 0"));
    }
    if frames > MOST_FRAMES {
        let message = format!("{frames} frames are more than {MOST_FRAMES}");
        return Err(Error::new(ErrorKind::TooLarge, message).with_cure("ask for fewer"));
    }
    Ok(())
}

fn frame<'s>(scene: &'s Scene, style: &PictureStyle, number: u32, frames: u32) -> Result<Picture<'s>, Error> {
    let mut style = style.clone();
    style.turn = Some(style.turn.unwrap_or(0.0) + 360.0 * f64::from(number) / f64::from(frames));
    Picture::new(scene, &style)
}
