//! Models from files.

use super::Model;
use crate::errors::OrRaise;
use crate::work::run;
use coface::io;
use coface::io::{Format, ReadOptions};
use pyo3::prelude::*;
use std::path::PathBuf;

pub(crate) fn format_of(py: Python<'_>, format: Option<&str>) -> PyResult<Option<Format>> {
    format.map(|name| Format::from_name(name).or_raise(py)).transpose()
}

pub(crate) fn read_options(
    py: Python<'_>,
    format: Option<&str>,
    flatten: Option<f64>,
) -> PyResult<ReadOptions> {
    Ok(ReadOptions::new().format(format_of(py, format)?).flatten(flatten))
}

/// Reads a model from a file; its content and its name decide the format.
///
/// Parameters
/// ----------
/// path : str or os.PathLike
///     The file. One entry of a JSON file of many is ``file.json:name``.
/// format : str, optional
///     The format, such as ``"off"``, if it is not to be found out.
/// flatten : float, optional
///     How far the polylines of curved SVG paths may be from the curves.
/// progress : bool or callable, optional
///     ``True`` shows a bar; a function is called with (stage, done, total).
///
/// Returns
/// -------
/// Model
///     What the file holds.
///
/// Raises
/// ------
/// FileError
///     If the file cannot be read.
/// ParseError
///     If it breaks the rules of its format, with the line or byte.
///
/// Examples
/// --------
/// >>> import coface, pathlib, tempfile
/// >>> path = pathlib.Path(tempfile.mkdtemp()) / "triangle.off"
/// >>> _ = path.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
/// >>> coface.read(path)
/// Model(3 vertices, 1 face)
#[pyfunction]
#[pyo3(signature = (path, format=None, *, flatten=None, progress=None))]
pub(crate) fn read(
    py: Python<'_>,
    path: PathBuf,
    format: Option<&str>,
    flatten: Option<f64>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Model> {
    let options = read_options(py, format, flatten)?;
    run(py, progress, || io::read_path_with(&path, &options)).map(Model::of)
}
