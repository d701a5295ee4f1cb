//! `coface boolean` in space.

use super::{Boolean, Task};
use crate::arguments::Common;
use crate::failure::Failure;
use crate::progress::Progress;
use coface::io::{Format, Model};
use std::path::Path;

pub(super) fn run(
    _verb: &Boolean,
    _task: &Task,
    _common: &Common,
    _output: Option<(&Path, Format)>,
    _models: &[(String, Model)],
    _progress: Progress,
) -> Result<(), Failure> {
    Err(Failure::new("the inputs do not lie in the plane z = 0, and solids are not combined yet"))
}
