//! Velocity fields that are functions of Python.

use crate::arrays;
use crate::errors::invalid;
use pyo3::prelude::*;
use std::sync::Mutex;

/// Points that a function is tried with; three, so that they are no pair.
const TRIAL: [[f64; 2]; 3] = [[0.25, 0.5], [0.5, 0.25], [0.75, 0.75]];

/// A function of the user, and the first fault in it.
pub(super) struct UserFlow {
    function: Py<PyAny>,
    /// Whether it takes an array of points and a time; otherwise the coordinates of one point and a time.
    pub(super) takes_arrays: bool,
    fault: Mutex<Option<PyErr>>,
}

impl UserFlow {
    /// The function is called with an array of points first. If it cannot be, or gives something of another shape, it is one of single
    /// points.
    pub(super) fn new(function: &Bound<'_, PyAny>) -> PyResult<Self> {
        let flow = |takes_arrays| Self {
            function: function.clone().unbind(),
            takes_arrays,
            fault: Mutex::new(None),
        };
        let [together, single] = [2, 3].map(|count| takes(function, count));
        if !together? {
            return Ok(flow(false));
        }
        match velocities(function, &TRIAL, 0.0) {
            Err(error) if !single? => Err(error),
            found => Ok(flow(found.is_ok())),
        }
    }

    pub(super) fn velocity(&self, [x, y]: [f64; 2], time: f64) -> [f64; 2] {
        let found = Python::attach(|py| {
            self.function.call1(py, (x, y, time)).and_then(|found| found.extract::<[f64; 2]>(py))
        });
        found.unwrap_or_else(|error| {
            self.note(error);
            [f64::NAN; 2]
        })
    }

    pub(super) fn velocities(&self, points: &[[f64; 2]], time: f64) -> Vec<[f64; 2]> {
        let found = Python::attach(|py| velocities(self.function.bind(py), points, time));
        found.unwrap_or_else(|error| {
            self.note(error);
            Vec::new()
        })
    }

    fn note(&self, error: PyErr) {
        if let Ok(mut fault) = self.fault.lock() {
            fault.get_or_insert(error);
        }
    }

    pub(super) fn into_fault(self) -> Option<PyErr> {
        self.fault.into_inner().ok().flatten()
    }
}

/// Whether a function can be called with so many arguments; one whose signature is not known takes three.
fn takes(function: &Bound<'_, PyAny>, count: usize) -> PyResult<bool> {
    let py = function.py();
    let Ok(signature) = py.import("inspect")?.call_method1("signature", (function,)) else {
        return Ok(count == 3);
    };
    let arguments = pyo3::types::PyTuple::new(py, (0..count).map(|_| py.None()).collect::<Vec<_>>())?;
    Ok(signature.call_method1("bind", arguments).is_ok())
}

fn velocities(function: &Bound<'_, PyAny>, points: &[[f64; 2]], time: f64) -> PyResult<Vec<[f64; 2]>> {
    let py = function.py();
    let array = arrays::grid(py, points.as_flattened().to_vec(), 2)?;
    let found = function.call1((array, time))?;
    let (shape, values) = arrays::reals(&found, "velocities")?;
    if shape != [points.len(), 2] {
        let message =
            format!("velocities of {} points have the shape {}", points.len(), arrays::shape_text(&shape));
        return Err(invalid(py, message, "give an array of shape (n, 2) for points of shape (n, 2)"));
    }
    Ok(values.as_chunks::<2>().0.to_vec())
}
