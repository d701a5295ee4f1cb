//! Which knots of a set that is made are kinks.

use crate::errors::invalid;
use coface::answers::KinkRequest;
use coface::yin::KnotIndex;
use pyo3::prelude::*;
use pyo3::types::PyString;

/// A word, an angle in degrees, or pairs of curves and knots.
pub(super) fn kinks_of(kinks: &Bound<'_, PyAny>) -> PyResult<KinkRequest> {
    let py = kinks.py();
    if let Ok(word) = kinks.cast::<PyString>() {
        return match word.to_str()? {
            "none" => Ok(KinkRequest::None),
            "all" => Ok(KinkRequest::All),
            other => Err(invalid(
                py,
                format!("kinks are {other:?}"),
                "give \"none\", \"all\", an angle, or pairs (curve, knot)",
            )),
        };
    }
    if let Ok(degrees) = kinks.extract::<f64>() {
        if (0.0..=180.0).contains(&degrees) {
            return Ok(KinkRequest::Detected(degrees.to_radians()));
        }
        return Err(invalid(
            py,
            format!("kinks are detected at {degrees} degrees"),
            "give an angle between 0 and 180",
        ));
    }
    let pairs: Vec<(u32, u32)> = kinks.extract().map_err(|_| {
        invalid(py, format!("kinks are {kinks}"), "give \"none\", \"all\", an angle, or pairs (curve, knot)")
    })?;
    Ok(KinkRequest::Listed(pairs.into_iter().map(|(curve, knot)| KnotIndex { curve, knot }).collect()))
}
