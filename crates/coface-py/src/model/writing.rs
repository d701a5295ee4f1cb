//! Models to files.

use super::{Model, made};
use crate::errors::OrRaise;
use crate::spatial_arrangement::written_bytes;
use crate::target::{Target, warn_all};
use crate::work::run;
use coface::answers::losses_of;
use coface::io::{self, Format};
use pyo3::prelude::*;
use pyo3::types::PyBytes;

/// Writes a model, after a warning for all that the format does not keep.
pub(super) fn write(
    py: Python<'_>,
    model: &io::Model,
    path: &Bound<'_, PyAny>,
    format: Option<&str>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<()> {
    let target = Target::of(path)?;
    let Some(to) = target.format(py, format)? else {
        // Names the formats that there are.
        return match &target {
            Target::Path(path) => run(py, None, || io::write_path(model, path, None)),
            Target::Open(_) => target.known_format(py, None).map(drop),
        };
    };
    let model = run(py, None, || made::writable(model, Some(to)))?;
    warn_all(py, &losses_of(&model, to))?;
    target.write(py, progress, |out| io::write(&model, out, to))
}

/// A model as the bytes of a file.
pub(super) fn bytes<'py>(
    py: Python<'py>,
    model: &io::Model,
    format: Format,
) -> PyResult<Bound<'py, PyBytes>> {
    let bytes = run(py, None, || written_bytes(&*made::writable(model, Some(format))?, format))?;
    Ok(PyBytes::new(py, &bytes))
}

/// The same without warnings, for adapters that say themselves what they leave out.
#[pyfunction]
pub(crate) fn _bytes_of<'py>(
    py: Python<'py>,
    model: &Bound<'py, Model>,
    format: &str,
) -> PyResult<Bound<'py, PyBytes>> {
    bytes(py, model.get().model(), Format::from_name(format).or_raise(py)?)
}
