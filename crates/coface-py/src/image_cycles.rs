//! Cycles of the classes of an image, as chains of cubes.

use crate::chain::Chain;
use crate::source::{Names, Naming};
use crate::work::run;
use coface::algebra::Integer;
use coface::answers::{FoundImage, ImageCells};
use coface::topology;
use coface::{CellId, Error};
use pyo3::prelude::*;
use std::collections::BTreeMap;
use std::sync::Arc;

/// A cycle, the chain that it bounds, and a cocycle.
pub(crate) type ProvedClass = (Chain, Option<Chain>, Chain);

/// What proves the classes of a degree of an image, in the order of its diagram.
pub(crate) fn image_cycles(
    py: Python<'_>,
    progress: Option<&Bound<'_, PyAny>>,
    (found, cells): (&FoundImage, &ImageCells),
    degree: usize,
) -> PyResult<Vec<ProvedClass>> {
    /// Cells with coefficients and vertices.
    type Named = (Vec<(CellId, Integer)>, Names);
    let least = found.min_persistence();
    let named = |of_degree: usize, terms: &[(u64, i64)]| -> Result<Named, Error> {
        let named = cells.named_chain(degree, of_degree, terms)?;
        let (mut terms, mut names) = (Vec::with_capacity(named.len()), BTreeMap::new());
        for (cell, x, vertices) in named {
            names.insert((of_degree, cell.index()), vertices);
            terms.push((cell, x));
        }
        Ok((terms, Names::Given(Arc::new(names))))
    };
    let (proved, counts) = run(py, progress, || {
        let all = cells.found()?;
        let wanted = all
            .cycles()
            .iter()
            .filter(|one| one.pair().degree() == degree && one.pair().persistence() > least);
        let prove = |one: &topology::ImageCycle| {
            let bounding = one.bounding_chain().map(|chain| named(degree + 1, chain)).transpose()?;
            Ok::<_, Error>((named(degree, one.cycle())?, bounding, named(degree, one.cocycle())?))
        };
        let counts = [cells.cell_count(degree)?, cells.cell_count(degree + 1)?];
        Ok((wanted.map(prove).collect::<Result<Vec<_>, Error>>()?, counts))
    })?;
    let chain = |degree: usize, (terms, names): Named, cell_count: usize, is_cochain: bool| Chain {
        degree,
        terms,
        cell_count,
        naming: Arc::new(Naming::of(names)),
        is_cochain,
    };
    let classes = proved.into_iter().map(|(cycle, bounding, cocycle)| {
        let bounding = bounding.map(|bounding| chain(degree + 1, bounding, counts[1], false));
        (chain(degree, cycle, counts[0], false), bounding, chain(degree, cocycle, counts[0], true))
    });
    Ok(classes.collect())
}
