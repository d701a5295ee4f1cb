//! Reading what the command line names.

use crate::failure::Failure;
use crate::output::is_json;
use crate::progress::Progress;
use crate::remarks;
use coface::answers::Producer;
use coface::answers::answer::YinInterfaceAnswer;
use coface::io;
use coface::io::yin::BoundaryDrawing;
use coface::io::{Format, Model, ReadOptions};
use std::io::Read;
use std::path::Path;
use std::sync::OnceLock;

/// A model with where it came from.
pub(crate) struct Loaded {
    pub(crate) name: String,
    pub(crate) format: Format,
    pub(crate) model: Model,
}

impl Loaded {
    /// Takes what the reader of the model assumed.
    fn new(name: String, model: Model) -> Self {
        remarks::take(&name, model.remarks());
        let format = model.format().unwrap_or(Format::Json);
        Self { name, format, model }
    }
}

/// The name of an input for people.
pub(crate) fn name(path: &Path) -> String {
    if is_standard_input(path) { "standard input".to_owned() } else { path.display().to_string() }
}

fn is_standard_input(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// What `-` names, read to its end so that it can be looked at twice.
static STANDARD_INPUT: OnceLock<Result<Vec<u8>, String>> = OnceLock::new();

/// What an input names.
pub(crate) enum Source<'a> {
    File(&'a Path),
    Bytes(&'static [u8]),
}

impl<'a> Source<'a> {
    pub(crate) fn of(path: &'a Path) -> Result<Self, Failure> {
        if !is_standard_input(path) {
            return Ok(Self::File(path));
        }
        let bytes = STANDARD_INPUT.get_or_init(|| {
            let mut bytes = Vec::new();
            std::io::stdin().lock().read_to_end(&mut bytes).map_err(|error| error.to_string())?;
            Ok(bytes)
        });
        match bytes {
            Ok(bytes) => Ok(Self::Bytes(bytes)),
            Err(error) => Err(Failure::new(format!("standard input: cannot be read: {error}"))),
        }
    }

    /// What `coface yin interface -o` wrote, if that is in it.
    pub(crate) fn interface(&self) -> Result<Option<YinInterfaceAnswer>, coface::Error> {
        match self {
            Self::File(path) if is_json(path) && path.is_file() => {
                YinInterfaceAnswer::of_json(&std::fs::read(path)?).transpose()
            }
            Self::File(_) => Ok(None),
            Self::Bytes(bytes) => YinInterfaceAnswer::of_json(bytes).transpose(),
        }
    }

    /// The model in it, with its name.
    pub(crate) fn model(&self, options: ReadOptions, progress: &Progress) -> Result<Loaded, Failure> {
        match self {
            Self::File(path) => read(path, options, progress),
            Self::Bytes(bytes) => {
                let name = name(Path::new("-"));
                let model = io::read_with(*bytes, &options).map_err(|error| error.in_file(name.clone()))?;
                Ok(Loaded::new(name, model))
            }
        }
    }

    /// The boundary of a set of the plane in it.
    pub(crate) fn boundary(&self, options: &ReadOptions) -> Result<BoundaryDrawing, coface::Error> {
        let (name, drawing) = match self {
            Self::File(path) => (name(path), io::read_boundary_path(path, options)?),
            Self::Bytes(bytes) => (name(Path::new("-")), io::read_boundary_with(*bytes, options)?),
        };
        remarks::take(&name, drawing.remarks());
        Ok(drawing)
    }
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
    Ok(Loaded::new(name, model))
}

/// Reads a model and identifies its cells: its name for people, and the producer.
pub(crate) fn produce(
    path: &Path,
    options: ReadOptions,
    progress: &Progress,
) -> Result<(String, Producer), Failure> {
    identify(read(path, options, progress)?, progress)
}

/// Identifies the cells of a model.
pub(crate) fn identify(loaded: Loaded, progress: &Progress) -> Result<(String, Producer), Failure> {
    let Loaded { name, model, .. } = loaded;
    progress.stage("identifying cells");
    let producer = Producer::of(model).map_err(|error| error.in_file(name.clone()))?;
    remarks::take(&name, producer.remarks());
    Ok((name, producer))
}
