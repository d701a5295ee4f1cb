//! `coface persistence --zigzag`: complexes that gain and lose simplices.

use super::image::ImageArguments;
use crate::arguments::Common;
use crate::failure::Failure;
use crate::input::{self, Source};
use clap::error::ErrorKind;
use coface::answers::GivenZigzag;
use std::path::Path;

/// The zigzag in the input.
pub(super) fn given(path: &Path, common: &Common, image: &ImageArguments) -> Result<GivenZigzag, Failure> {
    let others = [common.points.given(), common.voxels.rule_given(), image.given()];
    if let Some(option) = others.into_iter().flatten().next() {
        let message = format!("a zigzag has its simplices: leave {option} out");
        return Err(Failure::Usage(ErrorKind::ArgumentConflict, message));
    }
    let name = input::name(path);
    let bytes = match Source::of(path)? {
        Source::File(path) => {
            std::fs::read(path).map_err(|error| coface::Error::from(error).in_file(name.clone()))?
        }
        Source::Bytes(bytes) => bytes.to_vec(),
    };
    Ok(GivenZigzag::read(&name, &bytes)?)
}
