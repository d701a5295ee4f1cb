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
    /// No background: what lies behind the picture shows through.
    pub is_transparent: bool,
    /// The width of the lines of layers in pixels, hidden parts half as wide; 3 is usual.
    pub line_width: f64,
    /// The width of edges in pixels; 0.6 is usual. Edges that are sides of no polygon are wider.
    pub edge_width: f64,
    /// Whether the names of the layers that are shown stand above the model, with their colors.
    pub has_legend: bool,
    /// The degrees by which the eye has gone around the model, about what is up, to the left of its place; with them the model has one size in
    /// the picture wherever the eye is, as frames of an animation need it.
    pub turn: Option<f64>,
}

impl Default for PictureStyle {
    fn default() -> Self {
        Self {
            size: [1200, 900],
            camera: None,
            edges: None,
            is_dark: false,
            is_transparent: false,
            line_width: 3.0,
            edge_width: 0.6,
            has_legend: false,
            turn: None,
        }
    }
}

impl PictureStyle {
    pub(super) fn theme(&self) -> &'static Theme {
        if self.is_dark { &DARK } else { &LIGHT }
    }
}

/// Refuses lines without a width.
///
/// # Errors
/// [`ErrorKind::InvalidInput`] for a width that is not above 0, or above 1000 pixels.
pub(super) fn check_widths(style: &PictureStyle) -> Result<(), Error> {
    if [style.line_width, style.edge_width].iter().all(|&width| width > 0.0 && width <= 1000.0) {
        return Ok(());
    }
    Err(Error::invalid("a line without a width").with_cure("give a width above 0, and at most 1000 pixels"))
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
