//! Halfedges as Python gives them.

use crate::arrays;
use crate::errors::OrRaise;
use coface::complexes::surface::HalfedgePermutations;
use coface::geometry::Positions;
use coface::io::Model;
use pyo3::prelude::*;

/// A surface by the permutations of its halfedges; without `twin`, halfedges 2i and 2i + 1 are twins. A twin that is none, -1 or the
/// halfedge itself is on the boundary.
pub(super) fn model_from(
    py: Python<'_>,
    next: &Bound<'_, PyAny>,
    twin: Option<&Bound<'_, PyAny>>,
    outer: Option<&Bound<'_, PyAny>>,
    vertices: Option<&Bound<'_, PyAny>>,
) -> PyResult<Model> {
    let next = arrays::ids(next, "next")?;
    let twins: Vec<Option<i64>> = match twin {
        Some(twin) => twin.try_iter()?.map(|one| one?.extract()).collect::<PyResult<_>>()?,
        None => (0..next.len() as i64).map(|halfedge| Some(halfedge ^ 1)).collect(),
    };
    let outer = outer.map_or(Ok(Vec::new()), |outer| arrays::ids(outer, "outer"))?;
    let is_bare = |(h, twin): (usize, &Option<i64>)| twin.is_none_or(|twin| twin == -1 || twin == h as i64);
    let number = |twin: Option<i64>| twin.map(|twin| u32::try_from(twin).unwrap_or(u32::MAX));
    let permutations = if twins.iter().enumerate().any(is_bare) {
        let twins: Vec<Option<u32>> =
            twins.into_iter().map(|twin| number(twin.filter(|&twin| twin != -1))).collect();
        let (next, twin, mut all) =
            HalfedgePermutations::with_boundary(&next, &twins).or_raise(py)?.into_parts();
        all.extend(outer);
        HalfedgePermutations::new(next, twin, all)
    } else {
        HalfedgePermutations::new(next, twins.into_iter().filter_map(number).collect(), outer)
    };
    let positions = match vertices {
        Some(vertices) => arrays::positions(vertices, "vertices")?,
        None => Positions::default(),
    };
    Model::from_halfedges(permutations.or_raise(py)?, positions).or_raise(py)
}
