//! The reader of a build without the feature `xml`: it refuses its file and names the feature.

use crate::Model;
use crate::features::without_xml;
use coface_algebra::Error;
use std::io::Read;

/// Refuses every file: this build lacks the feature `xml`.
///
/// # Errors
/// [`ErrorKind::UnsupportedFormat`](coface_algebra::ErrorKind::UnsupportedFormat), always.
pub fn read_xml(_input: impl Read) -> Result<Model, Error> {
    Err(without_xml("VTK XML"))
}
