//! Files of points as tables: tables of numbers, and the vertices of models.

use crate::readers::{ReadOptions, read_path_with};
use crate::{Format, NumberTable, Remark};
use coface_algebra::Error;
use std::path::Path;

/// Whether a file is a model by its name, or by the format that it is said to have; else it is a table of numbers.
pub(crate) fn is_model(path: &Path, options: &ReadOptions) -> bool {
    let extension =
        |path: &Path| path.extension().and_then(|extension| extension.to_str()).map(str::to_ascii_lowercase);
    match options.format.or_else(|| Format::from_input_path(path)) {
        None | Some(Format::Npy | Format::MatrixMarket) => false,
        // Atoms have names, and tables of points have any number of columns.
        Some(Format::Points) => {
            let inner = path.file_stem().and_then(|stem| extension(Path::new(stem)));
            [extension(path), inner].iter().flatten().any(|extension| extension == "xyz")
        }
        Some(_) => true,
    }
}

/// The points in a file, the rows of a table or the vertices of a model, and what the reader of the model assumed.
pub(crate) fn points_of_path(
    path: &Path,
    options: &ReadOptions,
) -> Result<(NumberTable, Vec<Remark>), Error> {
    match vertices_of_path(path, options)? {
        Some(vertices) => Ok(vertices),
        None => Ok((NumberTable::read_path(path)?, Vec::new())),
    }
}

/// The vertices of the model in a file as a table, and what its reader assumed; `None` for a file that is a table of numbers by its name.
///
/// # Errors
/// As of [`read_path_with`]; [`ErrorKind::InvalidInput`](coface_algebra::ErrorKind::InvalidInput) for a coordinate that is not finite.
///
/// # Examples
/// ```
/// use coface_io::{ReadOptions, vertices_of_path};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let path = std::env::temp_dir().join("coface-vertices.obj");
/// std::fs::write(&path, "v 0 0 1\nv 2 0 0\n")?;
/// let (vertices, _) = vertices_of_path(&path, &ReadOptions::new())?.expect("a model");
/// assert_eq!(vertices.row(1), [2.0, 0.0, 0.0]);
/// # std::fs::remove_file(&path)?;
/// # Ok(()) }
/// ```
pub fn vertices_of_path(
    path: impl AsRef<Path>,
    options: &ReadOptions,
) -> Result<Option<(NumberTable, Vec<Remark>)>, Error> {
    let path = path.as_ref();
    if !is_model(path, options) {
        return Ok(None);
    }
    let model = read_path_with(path, &options.as_file())?;
    model.require_finite().map_err(|error| error.in_file(path.display().to_string()))?;
    let positions = model.positions();
    let table = NumberTable::from_rows(positions.as_flat().chunks(positions.dimension().max(1)));
    Ok(Some((table, model.remarks().to_vec())))
}
