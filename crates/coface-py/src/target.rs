//! Where things are written: files by their paths, and files that are open.

use crate::errors::{self, OrRaise, invalid, wrong_type};
use crate::work::run;
use coface::Error;
use coface::answers::answer::Remark;
use coface::io::{self, Format};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyString};
use std::io::Write;
use std::path::{Path, PathBuf};

/// The format of this name, if one is given.
pub(crate) fn format_of(py: Python<'_>, format: Option<&str>) -> PyResult<Option<Format>> {
    format.map(|name| Format::from_name(name).or_raise(py)).transpose()
}

/// A path, or a file that is open.
pub(crate) enum Target<'py> {
    Path(PathBuf),
    Open(Bound<'py, PyAny>),
}

impl<'py> Target<'py> {
    pub(crate) fn of(value: &Bound<'py, PyAny>) -> PyResult<Self> {
        if let Ok(path) = value.extract::<PathBuf>() {
            return Ok(Self::Path(path));
        }
        if value.hasattr("write")? {
            return Ok(Self::Open(value.clone()));
        }
        let message = format!("a {} is nothing to write to", value.get_type().name()?);
        Err(wrong_type(value.py(), message, "give a path, or a file that is open for writing"))
    }

    /// The format of this name; else the one that the name of the file has.
    pub(crate) fn format(&self, py: Python<'py>, format: Option<&str>) -> PyResult<Option<Format>> {
        Ok(match (format_of(py, format)?, self) {
            (Some(format), _) => Some(format),
            (None, Self::Path(path)) => Format::from_path(path),
            (None, Self::Open(file)) => name_of(file).and_then(|name| Format::from_path(Path::new(&name))),
        })
    }

    /// The same; an error where there is none.
    pub(crate) fn known_format(&self, py: Python<'py>, format: Option<&str>) -> PyResult<Format> {
        if let Some(format) = self.format(py, format)? {
            return Ok(format);
        }
        let message = match self {
            Self::Path(path) => format!("{}: the extension is no format known here", path.display()),
            Self::Open(_) => "the format is not told by the name of the file that is open".to_owned(),
        };
        Err(invalid(py, message, "give format=\"off\", or the name of another format"))
    }

    /// Writes what the function writes: a path appears whole or not at all, an open file gets all bytes at once.
    pub(crate) fn write(
        &self,
        py: Python<'py>,
        progress: Option<&Bound<'py, PyAny>>,
        write: impl FnOnce(&mut dyn Write) -> Result<(), Error> + Send,
    ) -> PyResult<()> {
        match self {
            Self::Path(path) => run(py, progress, || io::replace_file(path, write)),
            Self::Open(file) => {
                let bytes = run(py, progress, || {
                    let mut bytes = Vec::new();
                    write(&mut bytes)?;
                    Ok(bytes)
                })?;
                put(file, bytes)
            }
        }
    }
}

/// The name of an open file, if it has one.
pub(crate) fn name_of(file: &Bound<'_, PyAny>) -> Option<String> {
    let name = file.getattr("name").ok()?;
    name.cast::<PyString>().ok().and_then(|name| name.to_str().ok().map(str::to_owned))
}

/// Writes bytes to a file that is open: as text where it takes text.
fn put(file: &Bound<'_, PyAny>, bytes: Vec<u8>) -> PyResult<()> {
    let py = file.py();
    let is_text = file.is_instance(&py.import("io")?.getattr("TextIOBase")?)?;
    if !is_text {
        return file.call_method1("write", (PyBytes::new(py, &bytes),)).map(drop);
    }
    match String::from_utf8(bytes) {
        Ok(text) => file.call_method1("write", (text,)).map(drop),
        Err(_) => Err(invalid(
            py,
            "the format has bytes that are no text, and the file is open for text",
            "open it with the mode \"wb\"",
        )),
    }
}

/// Warns of each remark.
pub(crate) fn warn_all<'a>(py: Python<'_>, remarks: impl IntoIterator<Item = &'a Remark>) -> PyResult<()> {
    remarks.into_iter().try_for_each(|remark| errors::warn(py, &remark.message))
}
