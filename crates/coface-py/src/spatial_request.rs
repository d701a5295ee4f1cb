//! What is asked of polygons in space.

use crate::congruence::choice;
use coface::answers::SpatialRequest;
use coface::arrange::CoordinatePrecision;
use coface::arrange::spatial::NonPlanar;
use pyo3::prelude::*;

/// The request that these arguments make.
pub(crate) fn spatial_request(
    snap: bool,
    tolerance: Option<f64>,
    max_cells: Option<usize>,
    split: bool,
    merge_coplanar: bool,
    precision: CoordinatePrecision,
) -> SpatialRequest {
    let mut request = SpatialRequest::default();
    request.non_planar = if split { NonPlanar::Split } else { NonPlanar::Refuse };
    (request.merge_coplanar, request.snap, request.max_cells) = (merge_coplanar, snap, max_cells);
    (request.tolerance, request.precision) = (tolerance, precision);
    request
}

/// The numbers that coordinates of results are, by their name.
pub(crate) fn precision_of(py: Python<'_>, name: &str) -> PyResult<CoordinatePrecision> {
    let all = [("double", CoordinatePrecision::Double), ("single", CoordinatePrecision::Single)];
    choice(py, "precision", name, &all)
}
