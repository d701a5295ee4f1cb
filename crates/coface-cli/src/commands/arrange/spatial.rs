//! `coface arrange` in space.

use super::Arrange;
use crate::arguments::Common;
use crate::failure::Failure;
use crate::progress::Progress;
use coface::io::{Format, Model};
use std::path::Path;

pub(super) fn run(
    _verb: &Arrange,
    _common: &Common,
    _output: Option<(&Path, Format)>,
    _models: &[(String, Model)],
    _progress: Progress,
) -> Result<(), Failure> {
    Err(Failure::new(
        "the inputs do not lie in the plane z = 0, and arrangements in space are not served yet",
    ))
}
