//! Files of pictures.

use crate::failure::Failure;
use coface::pictures::FlatPicture;
use std::path::Path;

/// What a picture is written as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum PictureFormat {
    Png,
    Svg,
    Pdf,
}

impl PictureFormat {
    /// The format of a file of this name, if it is one of pictures.
    pub(crate) fn of(path: &Path) -> Option<Self> {
        let extension = path.extension()?.to_ascii_lowercase();
        Some(match extension.to_str()? {
            "png" => Self::Png,
            "svg" => Self::Svg,
            "pdf" => Self::Pdf,
            _ => return None,
        })
    }

    /// The format of a picture of this name; SVG without a name.
    pub(crate) fn of_output(output: Option<&Path>) -> Result<Self, Failure> {
        let Some(path) = output else { return Ok(Self::Svg) };
        Self::of(path).ok_or_else(|| {
            let fault = path.extension().map_or_else(String::new, |extension| {
                format!("no picture has the extension {}; ", extension.display())
            });
            Failure::new(format!("{}: {fault}name the output *.png, *.svg or *.pdf", path.display()))
        })
    }

    /// A flat picture as a file of this format: PNG is twice as large as the picture by itself, so that letters are clear, but not beyond 4000 pixels.
    pub(crate) fn bytes(
        self,
        picture: &FlatPicture,
        size: Option<[usize; 2]>,
    ) -> Result<Vec<u8>, coface::Error> {
        Ok(match self {
            Self::Png => picture.png(size.unwrap_or_else(|| usual_size(picture)))?,
            Self::Svg => picture.svg(size)?.into_bytes(),
            Self::Pdf => picture.pdf(size)?,
        })
    }
}

fn usual_size(picture: &FlatPicture) -> [usize; 2] {
    let size = picture.size();
    let scale = (4000.0 / size[0].max(size[1])).min(2.0);
    size.map(|side| (scale * side).round().max(1.0) as usize)
}
