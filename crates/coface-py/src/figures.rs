//! Figures: polygons with their letters, long exact sequences, boundary matrices in blocks.

use crate::errors::{OrRaise, invalid};
use crate::given::source_of;
use crate::pictures::flat_file;
use crate::surface::surface_of;
use coface::Error;
use coface::answers::{BlockedMatrix, HomologyRequest, MatrixBlocks, PolygonSchema, RelativeTo};
use coface::pictures::{blocked_matrix_picture, schema_picture, sequence_picture};
use pyo3::prelude::*;
use pyo3::types::{PyBytes, PyString};

/// Polygons of a word or of the components of a surface, as a file.
#[pyfunction]
pub(crate) fn _schema_picture<'py>(
    py: Python<'py>,
    of: &Bound<'py, PyAny>,
    format: &str,
    size: (usize, usize),
    transparent: bool,
    title: &str,
) -> PyResult<Bound<'py, PyBytes>> {
    let schemas = match of.cast::<PyString>() {
        Ok(word) => vec![word.to_str()?.parse::<PolygonSchema>().or_raise(py)?],
        Err(_) => surface_of(py, &source_of(of)?, false, None)?.schemas(),
    };
    flat_file(py, format, size, transparent, || schema_picture(title, &schemas))
}

/// The long exact sequence of a pair as a file.
#[pyfunction]
pub(crate) fn _sequence_picture<'py>(
    py: Python<'py>,
    model: &Bound<'py, PyAny>,
    part: &Bound<'py, PyAny>,
    format: &str,
    size: (usize, usize),
    transparent: bool,
    title: &str,
) -> PyResult<Bound<'py, PyBytes>> {
    let source = source_of(model)?;
    let relative = match part.cast::<PyString>() {
        Ok(word) if word.to_str()? == "boundary" => RelativeTo::Boundary,
        Ok(word) => return Err(invalid(py, format!("the part is {word}"), "give \"boundary\" or a Model")),
        Err(_) => {
            let model = Box::new(source_of(part)?.model.clone());
            RelativeTo::Part { name: "part".to_owned(), model }
        }
    };
    flat_file(py, format, size, transparent, || {
        let request = HomologyRequest::new().relative(Some(relative)).sequence(true);
        let answer = request.found(title, source.model.clone())?.into_answer();
        let sequence = answer.sequence.ok_or_else(|| Error::invalid("there is no sequence"))?;
        Ok(sequence_picture(title, &sequence))
    })
}

/// A boundary matrix in blocks as a file.
#[pyfunction]
#[expect(clippy::too_many_arguments, reason = "named arguments of Python")]
pub(crate) fn _blocked_matrix_picture<'py>(
    py: Python<'py>,
    model: &Bound<'py, PyAny>,
    degree: usize,
    blocks: &str,
    format: &str,
    size: (usize, usize),
    transparent: bool,
    title: &str,
) -> PyResult<Bound<'py, PyBytes>> {
    let blocks = match blocks {
        "components" => MatrixBlocks::Components,
        "groups" => MatrixBlocks::Groups,
        "matching" => MatrixBlocks::Matching,
        _ => {
            let message = format!("no blocks are called {blocks:?}");
            return Err(invalid(py, message, "give \"components\", \"groups\" or \"matching\""));
        }
    };
    let source = source_of(model)?;
    flat_file(py, format, size, transparent, || {
        let found = BlockedMatrix::of(source.producer()?, &source.model, degree, blocks)?;
        Ok(blocked_matrix_picture(title, &found))
    })
}
