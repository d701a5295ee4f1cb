//! Reading files.

use super::{Clock, Task, Work};
use coface::{Error, io};
use std::path::Path;

const INPUTS: &[&str] = &["ico6", "ico7", "ico8"];

pub(super) const OBJ: Task = task("read-obj", "a surface from an OBJ file", "obj");
pub(super) const OFF: Task = task("read-off", "a surface from an OFF file", "off");
pub(super) const PLY: Task = task("read-ply", "a surface from a binary PLY file", "ply");

const fn task(name: &'static str, about: &'static str, extension: &'static str) -> Task {
    Task { name, about, extension, inputs: INPUTS, work: Work::Inside(read) }
}

fn read(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    let size = std::fs::metadata(path)?.len() as usize;
    let model = clock.time(size, || io::read_path(path, None))?;
    Ok(format!("V {} F {}", model.vertex_count(), model.polygons().len()))
}
