//! Boundaries and skeletons of models of several kinds of cells.

use coface::Error;
use coface::algebra::{RaggedArray, VertexId};
use coface::complexes::shapes::{Assembly, PlacedCells};
use coface::geometry::Positions;
use coface::io::Model;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The facets of exactly one of the cells of the highest dimension; `None` if there are none.
pub(super) fn boundary(model: &Model) -> Result<Option<Model>, Error> {
    let parts = model.placed_cells()?;
    let top = parts.iter().map(PlacedCells::dimension).max();
    let facets: Vec<PlacedCells> = parts
        .iter()
        .filter(|part| Some(part.dimension()) == top)
        .map(PlacedCells::boundary)
        .collect::<Result<_, _>>()?;
    let mut count: BTreeMap<Vec<u32>, usize> = BTreeMap::new();
    for facet in facets.iter().flat_map(|part| part.cells().iter()) {
        *count.entry(sorted(facet)).or_default() += 1;
    }
    let kept = facets.iter().map(|part| of_cells(part, |facet| count[&sorted(facet)] == 1));
    model_of(kept.collect::<Result<_, _>>()?)
}

/// The faces of this dimension of all cells that have as many dimensions; `None` if no cell has.
pub(super) fn skeleton(model: &Model, dimension: usize) -> Result<Option<Model>, Error> {
    let parts = model.placed_cells()?;
    let faces: Vec<PlacedCells> = parts
        .iter()
        .filter(|part| part.dimension() >= dimension)
        .map(|part| part.skeleton(dimension))
        .collect::<Result<_, _>>()?;
    let mut known = std::collections::BTreeSet::new();
    let kept = faces.iter().map(|part| of_cells(part, |face| known.insert(sorted(face))));
    let kept = kept.collect::<Result<_, _>>()?;
    model_of(kept)
}

fn sorted(cell: &[u32]) -> Vec<u32> {
    let mut cell = cell.to_vec();
    cell.sort_unstable();
    cell
}

fn of_cells(part: &PlacedCells, mut is_kept: impl FnMut(&[u32]) -> bool) -> Result<PlacedCells, Error> {
    let cells = part.cells().iter().filter(|cell| is_kept(cell));
    let cells = RaggedArray::from_lists(cells);
    PlacedCells::new(part.positions().clone(), part.kind(), part.dimension(), cells)
}

/// A model of some cells on common positions, without the vertices that none of them has.
fn model_of(mut parts: Vec<PlacedCells>) -> Result<Option<Model>, Error> {
    parts.retain(|part| part.cell_count() > 0);
    let Some(first) = parts.first() else { return Ok(None) };
    let mut used: Vec<u32> = parts.iter().flat_map(|part| part.cells().items()).copied().collect();
    used.sort_unstable();
    used.dedup();
    let given = first.positions();
    let flat = used.iter().flat_map(|&vertex| given.point(VertexId::from_u32(vertex))).copied().collect();
    let positions = Positions::from_flat(given.dimension(), flat)?;
    let mut leaf = Vec::new();
    for part in &parts {
        let mut cells = part.cells().clone();
        let number = |vertex: u32| used.partition_point(|&other| other < vertex) as u32;
        cells.items_mut().iter_mut().for_each(|vertex| *vertex = number(*vertex));
        leaf.push(Arc::new(PlacedCells::new(positions.clone(), part.kind(), part.dimension(), cells)?));
    }
    let mut assembly = Assembly::new();
    assembly.push_mixed_cells(leaf)?;
    Model::from_assembly(&assembly.flatten()?).map(Some)
}
