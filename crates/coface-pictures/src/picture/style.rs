//! How pictures look.

use super::camera::Camera;
use super::palette::{DARK, LIGHT, Theme};
use coface_algebra::{Error, ErrorKind};

/// How a picture looks.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct PictureStyle {
    /// Width and height in pixels.
    pub size: [usize; 2],
    /// Where the eye is; none for the usual place.
    pub camera: Option<Camera>,
    /// Whether edges are drawn; none for where they can be told apart.
    pub edges: Option<bool>,
    /// A dark background.
    pub is_dark: bool,
}

impl Default for PictureStyle {
    fn default() -> Self {
        Self { size: [1200, 900], camera: None, edges: None, is_dark: false }
    }
}

impl PictureStyle {
    pub(super) fn theme(&self) -> &'static Theme {
        if self.is_dark { &DARK } else { &LIGHT }
    }
}

/// How often a pixel is looked at in each direction.
pub(super) const SAMPLES: usize = 3;

/// The most pixels of a picture.
const MOST_PIXELS: usize = 1 << 25;

/// Refuses sizes without pixels, and such that no memory holds.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] for a picture without pixels; [`ErrorKind::TooLarge`] beyond $2^{25}$ of them.
pub(super) fn check_size([width, height]: [usize; 2]) -> Result<(), Error> {
    if width == 0 || height == 0 {
        return Err(Error::invalid("a picture without pixels").with_cure("give a width and a height above 0"));
    }
    if width.saturating_mul(height) > MOST_PIXELS {
        let message = format!("{width} by {height} pixels are more than {MOST_PIXELS}");
        return Err(Error::new(ErrorKind::TooLarge, message).with_cure("make a smaller picture"));
    }
    Ok(())
}
