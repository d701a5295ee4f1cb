//! Vertices that rounding puts to one place.

use coface_algebra::{CellId, VertexId};
use coface_arrange::boolean::SelectionMesh;
use coface_geometry::Positions;

/// The places of vertices that are at the place of another one, but for copies of the same vertex: whoever reads the coordinates
/// takes them for one, and faces between them for faces without area.
pub(super) fn coincident(surface: &SelectionMesh, positions: &Positions) -> Vec<[f64; 3]> {
    let place = |vertex: usize| {
        let point = positions.point(VertexId::new(vertex));
        [point[0], point[1], point[2]]
    };
    let key = |vertex: usize| place(vertex).map(|x| (x + 0.0).to_bits());
    let mut all: Vec<([u64; 3], CellId, usize)> = surface
        .vertex_sources()
        .iter()
        .enumerate()
        .map(|(vertex, &source)| (key(vertex), source, vertex))
        .collect();
    all.sort_unstable();
    let pairs = all.windows(2).filter(|pair| pair[0].0 == pair[1].0 && pair[0].1 != pair[1].1);
    pairs.map(|pair| place(pair[0].2)).collect()
}
