//! Persistent homology of complexes that grow and shrink.

use crate::chain_complex::ring;
use crate::work::run;
use coface::Error;
use coface::answers::answer::PersistencePairAnswer;
use coface::answers::{GivenZigzag, PersistenceRequest};
use coface::topology::Coefficients;
use pyo3::prelude::*;
use std::path::PathBuf;

/// Zigzag persistence of the steps in a file, of steps, or of simplices with the times at which they enter and leave.
///
/// Parameters
/// ----------
/// steps : str, sequence of tuple or sequence of sequence of int
///     The path of a file; steps ``("i", simplex, time)`` and ``("d", simplex, time)``; or simplices.
/// times : sequence of sequence of float, optional
///     For each simplex the times at which it enters, leaves, and so on.
/// coefficients : str or int
///     A prime field: ``"f2"``, ``"f3"``, ...
/// least : float
///     Classes that live no longer than this are left out.
///
/// Returns
/// -------
/// list of tuple
///     Kind, degree, birth and death of each class.
#[pyfunction]
#[pyo3(signature = (steps, times=None, *, coefficients=None, least=0.0), text_signature = "(steps, times=None, *, coefficients='f2', least=0.0)")]
pub(crate) fn _zigzag(
    py: Python<'_>,
    steps: &Bound<'_, PyAny>,
    times: Option<Vec<Vec<f64>>>,
    coefficients: Option<&Bound<'_, PyAny>>,
    least: f64,
) -> PyResult<Vec<(String, usize, f64, f64)>> {
    let field = coefficients.map_or(Ok(Coefficients::Modulo(2)), ring)?;
    let given = GivenSteps::of(steps, times)?;
    let answer = run(py, None, || {
        let request = PersistenceRequest::new().coefficients(field).min_persistence(least);
        request.zigzag(&given.zigzag()?)
    })?;
    let class = |pair: PersistencePairAnswer| {
        let kind = pair.kind.unwrap_or_default();
        (kind, pair.degree, pair.birth, pair.death.unwrap_or(f64::INFINITY))
    };
    Ok(answer.diagram.into_iter().map(class).collect())
}

/// A zigzag as Python gives it.
enum GivenSteps {
    File(PathBuf),
    Stays(Vec<Vec<u32>>, Vec<Vec<f64>>),
    Steps(Vec<(String, Vec<u32>, Option<f64>)>),
}

impl GivenSteps {
    fn of(steps: &Bound<'_, PyAny>, times: Option<Vec<Vec<f64>>>) -> PyResult<Self> {
        if let Some(times) = times {
            return Ok(Self::Stays(steps.extract()?, times));
        }
        if let Ok(path) = steps.extract() {
            return Ok(Self::File(path));
        }
        let step = |step: Bound<'_, PyAny>| match step.extract() {
            Ok((word, simplex, time)) => Ok((word, simplex, Some(time))),
            Err(_) => step.extract().map(|(word, simplex)| (word, simplex, None)),
        };
        steps.try_iter()?.map(|item| step(item?)).collect::<PyResult<_>>().map(Self::Steps)
    }

    fn zigzag(self) -> Result<GivenZigzag, Error> {
        match self {
            Self::File(path) => {
                let name = path.display().to_string();
                let bytes = std::fs::read(&path).map_err(|error| Error::from(error).in_file(name.clone()))?;
                GivenZigzag::read(&name, &bytes)
            }
            Self::Stays(simplices, times) => GivenZigzag::of_stays("zigzag", &simplices, &times),
            Self::Steps(steps) => GivenZigzag::of_steps("zigzag", steps),
        }
    }
}
