//! Where an animation goes: a file, or a folder of frames.

use crate::failure::Failure;
use crate::output::write_file;
use coface::pictures::{PictureStyle, Scene, spin_frames, spin_gif, spin_png, spin_webp};
use std::path::{Path, PathBuf};

/// So many milliseconds is each frame shown: 24 of them a second.
const MILLISECONDS: u16 = 1000 / 24;

/// What an animation is written as.
pub(super) enum SpinOutput<'a> {
    Png(&'a Path),
    Gif(&'a Path),
    WebP(&'a Path),
    /// A PNG for each frame.
    Frames(Frames),
}

/// The names of frames: numbers from 1 between two texts, with so many digits at least.
pub(super) struct Frames {
    folder: PathBuf,
    before: String,
    after: String,
    digits: usize,
}

impl<'a> SpinOutput<'a> {
    /// What the name of the output says.
    pub(super) fn of(output: Option<&'a Path>) -> Result<Self, Failure> {
        let Some(path) = output else {
            return Err(Failure::new(
                "--spin: an animation goes to a file or a folder; name it by -o spin.gif, -o spin.png or -o frames/",
            ));
        };
        let place = path.display();
        if path.as_os_str().to_string_lossy().ends_with(['/', '\\']) || path.is_dir() {
            return Ok(Self::Frames(Frames {
                folder: path.to_owned(),
                before: "frame-".to_owned(),
                after: ".png".to_owned(),
                digits: 3,
            }));
        }
        let name = path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default();
        if name.contains('%') {
            return Ok(Self::Frames(Frames::of(path, &name)?));
        }
        let extension = path.extension().map(|extension| extension.to_string_lossy().to_ascii_lowercase());
        match extension.as_deref() {
            Some("png") => Ok(Self::Png(path)),
            Some("gif") => Ok(Self::Gif(path)),
            Some("webp") => Ok(Self::WebP(path)),
            Some("mp4" | "webm" | "mov" | "avi" | "mkv") => Err(Failure::new(format!(
                "{place}: videos are not written; write frames by -o frames/ and make a video of them: \
                 ffmpeg -framerate 24 -i frames/frame-%03d.png -pix_fmt yuv420p {place}"
            ))),
            _ => Err(Failure::new(format!(
                "{place}: --spin: an animation is a GIF, a PNG or a WebP; name the output *.gif, *.png or *.webp, or a folder for frames, as in -o frames/"
            ))),
        }
    }

    /// Draws and writes the frames; the number of bytes.
    pub(super) fn write(&self, scene: &Scene, style: &PictureStyle, frames: u32) -> Result<usize, Failure> {
        let (path, bytes) = match self {
            Self::Png(path) => (path, spin_png(scene, style, frames, MILLISECONDS)?),
            Self::Gif(path) => (path, spin_gif(scene, style, frames, MILLISECONDS)?),
            Self::WebP(path) => (path, spin_webp(scene, style, frames, MILLISECONDS)?),
            Self::Frames(names) => return names.write(scene, style, frames),
        };
        write_file(path, &bytes)?;
        Ok(bytes.len())
    }
}

impl Frames {
    /// Names with their number where `%03d` or `%d` stands.
    fn of(path: &Path, name: &str) -> Result<Self, Failure> {
        let fault = || {
            Failure::new(format!(
                "{}: the number of a frame stands for %03d, once; name frames as in frames-%03d.png",
                path.display()
            ))
        };
        let (before, rest) = name.split_once('%').ok_or_else(fault)?;
        let (digits, after) = rest.split_once('d').ok_or_else(fault)?;
        let count: usize = if digits.is_empty() { 1 } else { digits.parse().map_err(|_| fault())? };
        let is_png = after.to_ascii_lowercase().ends_with(".png");
        if !(1..=9).contains(&count) || after.contains('%') || !is_png {
            return Err(fault());
        }
        let folder = path.parent().unwrap_or(Path::new("")).to_owned();
        Ok(Self { folder, before: before.to_owned(), after: after.to_owned(), digits: count })
    }

    fn write(&self, scene: &Scene, style: &PictureStyle, frames: u32) -> Result<usize, Failure> {
        if !self.folder.as_os_str().is_empty() {
            std::fs::create_dir_all(&self.folder).map_err(|error| {
                Failure::new(format!("{}: cannot be made: {error}", self.folder.display()))
            })?;
        }
        let mut sum = 0;
        let mut failure = None;
        let done = spin_frames(scene, style, frames, |number, bytes| {
            let digits = self.digits;
            let name = format!("{}{:0digits$}{}", self.before, number + 1, self.after);
            sum += bytes.len();
            write_file(&self.folder.join(name), &bytes).map_err(|fault| {
                failure = Some(fault);
                coface::Error::invalid("a frame cannot be written")
            })
        });
        match (done, failure) {
            (_, Some(failure)) => Err(failure),
            (Err(error), None) => Err(error.into()),
            (Ok(()), None) => Ok(sum),
        }
    }
}
