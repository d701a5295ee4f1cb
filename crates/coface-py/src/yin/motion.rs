//! Flows that Python names or gives, and what moves with them.

use super::flow::UserFlow;
use crate::congruence::choice;
use crate::cures::in_python;
use crate::errors::{self, OrRaise, invalid};
use crate::work::run;
use coface::Error;
use coface::answers::answer::YinEventAnswer;
use coface::answers::contact_below_knots;
use coface::yin::{
    Flow, MarkerParameters, OnContact, RungeKutta, TrackingOptions, VelocityExpression, Verification,
};
use pyo3::prelude::*;
use pyo3::types::PyString;
use serde::Serialize;

/// A velocity field.
pub(super) enum GivenFlow {
    Named(Flow),
    Written(VelocityExpression),
    User(UserFlow),
}

impl GivenFlow {
    /// The flow of an argument, and the usual time at its end.
    pub(super) fn read(
        flow: &Bound<'_, PyAny>,
        period: f64,
        vortices: u32,
        velocity: [f64; 2],
        center: [f64; 2],
        speed: f64,
    ) -> PyResult<(Self, f64)> {
        let py = flow.py();
        let Ok(word) = flow.cast::<PyString>() else {
            if flow.is_callable() {
                return Ok((Self::User(UserFlow::new(flow)?), 1.0));
            }
            let cure = "give a name, or a function of (points, t) or (x, y, t)";
            return Err(invalid(py, format!("the flow is {flow}"), cure));
        };
        Ok(match word.to_str()? {
            text if text.contains(';') => {
                let found = VelocityExpression::parse(text, period).or_raise(py)?;
                let usual = if found.has_period() { period } else { 1.0 };
                (Self::Written(found), usual)
            }
            "vortex" => (Self::Named(Flow::Vortex { period }), period),
            "deformation" => (Self::Named(Flow::Deformation { period, vortices }), period),
            "rotation" => (Self::Named(Flow::Rotation { center, speed }), 1.0),
            "translation" => (Self::Named(Flow::Translation { velocity }), 1.0),
            other => {
                let cure = "give \"vortex\", \"deformation\", \"rotation\", \"translation\", two expressions as in \"-y; x\", or a function";
                return Err(invalid(py, format!("the flow is {other:?}"), cure));
            }
        })
    }

    /// What moves with the flow: `each` by velocities of single points, `together` by those of many.
    pub(super) fn moved<T: Send>(
        self,
        py: Python<'_>,
        progress: Option<&Bound<'_, PyAny>>,
        each: impl FnOnce(&(dyn Fn([f64; 2], f64) -> [f64; 2] + Sync)) -> Result<T, Error> + Send,
        together: impl FnOnce(&(dyn Fn(&[[f64; 2]], f64) -> Vec<[f64; 2]> + Sync)) -> Result<T, Error> + Send,
    ) -> PyResult<T> {
        match self {
            Self::Named(flow) => run(py, progress, || each(&|point, time| flow.velocity(point, time))),
            Self::Written(flow) => run(py, progress, || each(&|point, time| flow.velocity(point, time))),
            Self::User(function) => {
                // The function of the user is called with the lock of the interpreter; its first fault is raised at the end.
                let moved = match function.takes_arrays {
                    true => run(py, progress, || together(&|points, time| function.velocities(points, time))),
                    false => run(py, progress, || each(&|point, time| function.velocity(point, time))),
                };
                match function.into_fault() {
                    Some(error) => Err(error),
                    None => moved,
                }
            }
        }
    }
}

/// From time 0 to an end in steps, each a hundredth of the time and a hundredth of the size if not given.
pub(super) fn tracking_options(
    end: f64,
    step: Option<f64>,
    spacing: Option<f64>,
    extent: Option<[[f64; 2]; 2]>,
) -> TrackingOptions {
    let [low, high] = extent.unwrap_or([[0.0; 2], [1.0; 2]]);
    let step = step.unwrap_or((end.abs() / 100.0).max(f64::MIN_POSITIVE));
    let spacing = spacing.unwrap_or(f64::max(high[0] - low[0], high[1] - low[1]) / 100.0);
    TrackingOptions::new(end, step, spacing)
}

pub(super) fn verification_of(py: Python<'_>, word: &str) -> PyResult<Verification> {
    let times =
        [("each-step", Verification::EachStep), ("end", Verification::End), ("never", Verification::Never)];
    choice(py, "verify", word, &times)
}

pub(super) fn scheme_of(py: Python<'_>, word: Option<&str>) -> PyResult<Option<RungeKutta>> {
    let schemes = [
        ("midpoint", RungeKutta::Midpoint),
        ("classical", RungeKutta::Classical),
        ("verner", RungeKutta::Verner),
        ("cooper-verner", RungeKutta::CooperVerner),
    ];
    word.map(|word| choice(py, "scheme", word, &schemes)).transpose()
}

pub(super) fn contact_of(py: Python<'_>, word: Option<&str>) -> PyResult<Option<OnContact>> {
    let all = [("keep", OnContact::Keep), ("merge", OnContact::Merge)];
    word.map(|word| choice(py, "on_contact", word, &all)).transpose()
}

/// Warns where a distance of contacts is below what points along curves tell.
pub(super) fn below_knots(py: Python<'_>, options: &TrackingOptions) -> PyResult<()> {
    let found = options.contact_lengths().and_then(|[distance, least]| contact_below_knots(distance, least));
    found.map_or(Ok(()), |remark| errors::warn(py, &in_python(&remark.message)))
}

pub(super) fn parameters_of(py: Python<'_>, word: Option<&str>) -> PyResult<Option<MarkerParameters>> {
    let all = [("lengths", MarkerParameters::Lengths), ("kept", MarkerParameters::Kept)];
    word.map(|word| choice(py, "parameters", word, &all)).transpose()
}

/// What came of moving a set.
#[derive(Serialize)]
pub(super) struct MotionFacts {
    pub(super) steps: usize,
    pub(super) added: usize,
    pub(super) removed: usize,
    pub(super) vanished: Vec<VanishedCurve>,
    pub(super) repairs: Vec<Repair>,
    pub(super) events: Option<Vec<YinEventAnswer>>,
}

/// A curve that became too small, and when.
#[derive(Serialize)]
pub(super) struct VanishedCurve {
    pub(super) time: f64,
    pub(super) curve: u32,
}

/// A set whose curves crossed, and when it was cut and pasted.
#[derive(Serialize)]
pub(super) struct Repair {
    pub(super) step: usize,
    pub(super) time: f64,
    pub(super) fault: String,
}
