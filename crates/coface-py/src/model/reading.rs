//! Models from files.

use super::Model;
use crate::errors::{self, wrong_type};
use crate::target::{format_of, name_of};
use crate::work::run;
use coface::io;
use coface::io::{Format, ReadOptions};
use pyo3::prelude::*;
use pyo3::types::PyString;
use std::path::{Path, PathBuf};

/// How a file is read: its format, the distance of chords from curves, whether assumptions are errors and whether a damaged file is read
/// up to its fault, and whether the files that it names may lie outside of its folder.
pub(crate) fn read_options(
    py: Python<'_>,
    format: Option<&str>,
    flatten: Option<f64>,
    (strict, partial, allow_outside): (bool, bool, bool),
) -> PyResult<ReadOptions> {
    let options = ReadOptions::new().format(format_of(py, format)?).flatten(flatten);
    Ok(options.strict(strict).partial(partial).allow_outside(allow_outside))
}

/// The model, after a warning for everything that its reader assumed.
fn warned(py: Python<'_>, model: io::Model) -> PyResult<Model> {
    for remark in model.remarks().iter().filter(|remark| remark.code.is_assumption()) {
        errors::warn(py, &remark.message)?;
    }
    Ok(Model::of(model))
}

/// Reads a model from bytes, or from the characters of a text.
pub(super) fn from_bytes(
    py: Python<'_>,
    data: &Bound<'_, PyAny>,
    options: ReadOptions,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Model> {
    let bytes = match data.cast::<PyString>() {
        Ok(text) => text.to_str()?.as_bytes().to_vec(),
        Err(_) => data.extract::<Vec<u8>>()?,
    };
    warned(py, run(py, progress, || io::read_with(&bytes[..], &options))?)
}

/// The models of a file that holds several.
///
/// Parameters
/// ----------
/// path : str or os.PathLike
///     The file: a list of models in JSON, JSON lines, or isomorphism signatures.
/// format : str, optional
///     The format, such as ``"json"``, if it is not to be found out.
///
/// Returns
/// -------
/// list of str
///     Their names, or their places from 1: what :func:`read` takes behind a ``#``. Empty for a file of one model.
///
/// Examples
/// --------
/// >>> import coface, pathlib, tempfile
/// >>> path = pathlib.Path(tempfile.mkdtemp()) / "two.jsonl"
/// >>> _ = path.write_text('{"name": "disk", "facets": [[0, 1, 2]]}\n[[0, 1]]\n')
/// >>> coface.entries(path)
/// ['disk', '2']
/// >>> coface.read(f"{path}#2").f_vector
/// (2, 1)
#[pyfunction]
#[pyo3(signature = (path, format=None))]
pub(crate) fn entries(py: Python<'_>, path: PathBuf, format: Option<&str>) -> PyResult<Vec<String>> {
    let format = format_of(py, format)?;
    run(py, None, || io::entries_of_path(&path, format))
}

/// Reads a model from a file; its content and its name decide the format.
///
/// Parameters
/// ----------
/// path : str, os.PathLike or file
///     The file, or one that is open for reading. One model of several is ``file.json#name``: see :func:`entries`.
/// format : str, optional
///     The format, such as ``"off"``, if it is not to be found out.
/// flatten : float, optional
///     How far the polylines of curved SVG paths may be from the curves.
/// lod : float, optional
///     The level of detail of CityJSON; the highest of each object if left out.
/// strict : bool
///     Whether everything that the reader would assume, with an :class:`AssumptionWarning`, is an error instead.
/// partial : bool
///     Whether a damaged file is read up to its first fault.
/// allow_outside : bool
///     Whether other files that the file names may lie outside of its folder: allow it for files that you trust.
/// pseudomanifold : bool
///     Whether ideal vertices of a triangulation of a 3-manifold are points; otherwise they are cut off, which leaves a manifold with boundary.
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
#[pyo3(signature = (path, format=None, *, flatten=None, lod=None, strict=false, partial=false, allow_outside=false, pseudomanifold=false, progress=None))]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn read(
    py: Python<'_>,
    path: &Bound<'_, PyAny>,
    format: Option<&str>,
    flatten: Option<f64>,
    lod: Option<f64>,
    strict: bool,
    partial: bool,
    allow_outside: bool,
    pseudomanifold: bool,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Model> {
    let options = read_options(py, format, flatten, (strict, partial, allow_outside))?.lod(lod);
    let options = options.pseudomanifold(pseudomanifold);
    let Ok(path) = path.extract::<PathBuf>() else {
        return of_open_file(py, path, options, format, progress);
    };
    warned(py, run(py, progress, || io::read_path_with(&path, &options))?)
}

/// Reads a model from a file that is open: its format is found in its content, else in its name.
fn of_open_file(
    py: Python<'_>,
    file: &Bound<'_, PyAny>,
    options: ReadOptions,
    format: Option<&str>,
    progress: Option<&Bound<'_, PyAny>>,
) -> PyResult<Model> {
    if !file.hasattr("read")? {
        let message = format!("a {} is no file", file.get_type().name()?);
        return Err(wrong_type(py, message, "give a path, or a file that is open for reading"));
    }
    let data = file.call_method0("read")?;
    let named = name_of(file).and_then(|name| Format::from_path(Path::new(&name)));
    match (from_bytes(py, &data, options, progress), named) {
        (Err(_), Some(named)) if format.is_none() => {
            from_bytes(py, &data, options.format(Some(named)), progress)
        }
        (read, _) => read,
    }
}
