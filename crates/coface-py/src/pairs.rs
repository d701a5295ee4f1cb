//! Persistence of pairs, and extended persistence.

use crate::arrays;
use crate::chain_complex::{ChainComplex, ring};
use crate::errors::OrRaise;
use crate::source::Naming;
use crate::work::run;
use coface::algebra::chains::ChainComplex as Chains;
use coface::answers::Pair;
use coface::topology;
use coface::topology::{Coefficients, Filtration, PersistenceDiagram};
use coface::{CellId, Error};
use pyo3::prelude::*;
use std::sync::Arc;

/// A diagram with the complex of its cells, how they are named, and when they enter.
pub(crate) struct Found {
    pub(crate) diagram: PersistenceDiagram,
    pub(crate) naming: Arc<Naming>,
    pub(crate) complex: Arc<Chains>,
    pub(crate) filtration: Arc<Filtration>,
}

/// The diagram of a complex, of that relative to a part, or of the image of the part.
pub(crate) fn found(
    complex: &ChainComplex,
    part: Option<Vec<Vec<u32>>>,
    is_image: bool,
    filtration: Filtration,
    field: Coefficients,
) -> Result<Found, Error> {
    let (naming, whole) = (Arc::clone(&complex.naming), Arc::clone(&complex.complex));
    let Some(part) = part else {
        let diagram = topology::persistence(&whole, &filtration, field)?;
        return Ok(Found { diagram, naming, complex: whole, filtration: Arc::new(filtration) });
    };
    let part: Vec<Vec<CellId>> =
        part.iter().map(|cells| cells.iter().map(|&cell| CellId::new(cell as usize)).collect()).collect();
    if is_image {
        let diagram = topology::image_persistence(&whole, &filtration, &part, field)?;
        return Ok(Found { diagram, naming, complex: whole, filtration: Arc::new(filtration) });
    }
    let kept = whole.complement(&part)?;
    let cells: Vec<(usize, CellId)> = (part.iter().enumerate())
        .flat_map(|(degree, cells)| cells.iter().map(move |&cell| (degree, cell)))
        .collect();
    let pair = Pair::absolute(Chains::clone(&whole)).modulo_cells(&whole, &cells)?;
    let (chains, filtration) = (Arc::new(pair.chains().clone()), filtration.restricted(&kept));
    let diagram = topology::persistence(&chains, &filtration, field)?;
    let naming = Naming { pair: Some(Arc::new(pair)), ..Naming::clone(&naming) };
    Ok(Found { diagram, naming: Arc::new(naming), complex: chains, filtration: Arc::new(filtration) })
}

/// The cells of the part that a complex was taken relative to, by degree, in the whole complex.
#[pyfunction]
#[pyo3(signature = (complex, pair))]
pub(crate) fn _cells_of_part(
    py: Python<'_>,
    complex: &Bound<'_, ChainComplex>,
    pair: &Bound<'_, ChainComplex>,
) -> PyResult<Vec<Vec<u32>>> {
    let Some(pair) = &pair.get().naming.pair else { return Ok(Vec::new()) };
    let part = pair.subcomplex(&complex.get().complex).or_raise(py)?;
    Ok(part.iter().map(|cells| cells.iter().map(|cell| cell.to_u32()).collect()).collect())
}

/// Extended persistence of values of vertices.
///
/// Parameters
/// ----------
/// complex : ChainComplex
///     The complex.
/// vertex_values : array_like of float
///     A value for each vertex in the order of the complex.
/// coefficients : str or int
///     A prime field: ``"f2"``, ``"f3"``, ...
/// least : float
///     Ordinary and relative classes that live no longer than this are left out.
///
/// Returns
/// -------
/// list of tuple
///     Kind, degree, birth and death of each class.
#[pyfunction]
#[pyo3(signature = (complex, vertex_values, *, coefficients=None, least=0.0), text_signature = "(complex, vertex_values, *, coefficients='f2', least=0.0)")]
pub(crate) fn _extended_persistence(
    py: Python<'_>,
    complex: &Bound<'_, ChainComplex>,
    vertex_values: &Bound<'_, PyAny>,
    coefficients: Option<&Bound<'_, PyAny>>,
    least: f64,
) -> PyResult<Vec<(&'static str, usize, f64, f64)>> {
    let complex = complex.get();
    let field = coefficients.map_or(Ok(Coefficients::Modulo(2)), ring)?;
    let values = arrays::finite(vertex_values, "vertex_values")?;
    let pairs = run(py, None, || topology::extended_persistence(&complex.complex, &values, field))?;
    let class = |pair: &topology::ExtendedPair| {
        let (kind, is_whole) = match pair.kind() {
            topology::ExtendedKind::Ordinary => ("ordinary", false),
            topology::ExtendedKind::Relative => ("relative", false),
            topology::ExtendedKind::ExtendedPlus => ("extended+", true),
            topology::ExtendedKind::ExtendedMinus => ("extended-", true),
        };
        let is_long = is_whole || (pair.death() - pair.birth()).abs() > least;
        is_long.then(|| (kind, pair.degree(), pair.birth(), pair.death()))
    };
    Ok(pairs.iter().filter_map(class).collect())
}
