//! Reading what the command line names.

use crate::failure::Failure;
use crate::progress::Progress;
use coface::io::{self, Format, Model, ReadOptions};
use coface::report::Producer;
use std::path::Path;

/// A model with where it came from.
pub(crate) struct Loaded {
    pub(crate) name: String,
    pub(crate) format: Format,
    pub(crate) model: Model,
}

/// The name of an input for people.
pub(crate) fn name(path: &Path) -> String {
    if is_standard_input(path) { "standard input".to_owned() } else { path.display().to_string() }
}

fn is_standard_input(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// Reads a file, or standard input for `-`.
pub(crate) fn read(path: &Path, options: ReadOptions, progress: &Progress) -> Result<Loaded, Failure> {
    let name = name(path);
    progress.stage(format!("reading {name}"));
    let model = if is_standard_input(path) {
        io::read_with(std::io::stdin().lock(), &options).map_err(|error| error.in_file(name.clone()))?
    } else {
        io::read_path_with(path, &options)?
    };
    let format = model.format().unwrap_or(Format::Json);
    Ok(Loaded { name, format, model })
}

/// Reads a model and identifies its cells: its name for people, and the producer.
pub(crate) fn produce(
    path: &Path,
    options: ReadOptions,
    progress: &Progress,
) -> Result<(String, Producer), Failure> {
    let Loaded { name, model, .. } = read(path, options, progress)?;
    progress.stage("identifying cells");
    let producer = Producer::of(model).map_err(|error| error.in_file(name.clone()))?;
    Ok((name, producer))
}
