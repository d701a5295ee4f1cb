//! The readers of a build without the feature `xml`: each refuses its file and names the feature.

use crate::Model;
use crate::features::without_xml;
use crate::yin::BoundaryDrawing;
use coface_algebra::Error;
use std::io::Read;

/// Refuses every drawing: this build lacks the feature `xml`.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat), always.
pub fn read(_input: impl Read) -> Result<Model, Error> {
    Err(without_xml("SVG"))
}

/// Refuses every drawing: this build lacks the feature `xml`.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat), always.
pub fn read_flattened(_input: impl Read, _tolerance: f64) -> Result<Model, Error> {
    Err(without_xml("SVG"))
}

pub(crate) fn read_with(_input: impl Read, _tolerance: Option<f64>) -> Result<Model, Error> {
    Err(without_xml("SVG"))
}

pub(crate) fn read_regions(_input: impl Read) -> Result<BoundaryDrawing, Error> {
    Err(without_xml("SVG"))
}
