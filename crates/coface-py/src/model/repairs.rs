//! Repairs as Python asks for them.

use crate::errors::invalid;
use coface::Error;
use coface::answers::{RepairRequest, SurfaceRepair, SurfaceRepairRequest, repaired_surface};
use coface::complexes::surface::FacesAtEdge;
use coface::io::Model;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyTuple};

pub(super) fn request(
    py: Python<'_>,
    split_edges: Option<&str>,
    split_vertices: bool,
    orient: bool,
    keep_repeated: bool,
) -> PyResult<RepairRequest> {
    let mut request = RepairRequest::default();
    request.split_edges = match split_edges {
        None => None,
        Some("apart") => Some(FacesAtEdge::Apart),
        Some("pairs") => Some(FacesAtEdge::CoherentPairs),
        Some(word) => {
            return Err(invalid(py, format!("split_edges is {word:?}"), "give \"apart\" or \"pairs\""));
        }
    };
    (request.split_vertices, request.orient, request.drop_repeated) =
        (split_vertices, orient, !keep_repeated);
    Ok(request)
}

pub(super) fn surface_of(
    model: &Model,
    tolerance: f64,
    closed: bool,
) -> Result<(Model, SurfaceRepair), Error> {
    repaired_surface(model, &SurfaceRepairRequest::new().tolerance(tolerance).closed(closed))
}

/// How much was done, by name.
pub(super) fn counts<'py>(py: Python<'py>, done: &SurfaceRepair) -> PyResult<Bound<'py, PyDict>> {
    let counts = [
        ("vertices_merged", done.merged_count()),
        ("vertices_left_out", done.unused_count()),
        ("polygons_collapsed", done.collapsed_count()),
        ("polygons_repeated", done.duplicate_count()),
        ("lines_left_out", done.loose_line_count()),
        ("edges_split", done.mesh().edges_split().len()),
        ("vertices_split", done.mesh().vertices_split().len()),
        ("faces_turned", done.mesh().faces_turned().len()),
        ("holes_filled", done.hole_count()),
        ("triangles_added", done.added_face_count()),
    ];
    let dict = PyDict::new(py);
    for (key, count) in counts {
        dict.set_item(key, count)?;
    }
    Ok(dict)
}

/// A tuple with names, of a class of Python.
pub(super) fn named<'py>(
    py: Python<'py>,
    class: &str,
    parts: impl IntoPyObject<'py, Target = PyTuple, Output = Bound<'py, PyTuple>, Error = PyErr>,
) -> PyResult<Bound<'py, PyAny>> {
    py.import("coface._models")?.getattr(class)?.call1(parts.into_pyobject(py)?)
}
