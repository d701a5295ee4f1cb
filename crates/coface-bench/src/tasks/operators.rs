//! Operators between cells that share vertices, and grids with all their cells.

use super::{Clock, Task, Work};
use crate::inputs::Mesh;
use coface::Error;
use coface::algebra::RaggedArray;
use coface::complexes::grids::CuboidGrid;
use coface::complexes::lar::{LarModel, Operator, Shared};
use std::path::Path;

pub(super) const FACES: Task = Task {
    name: "operator-ff",
    about: "faces that share two vertices or more (FF), from their lists of vertices",
    extension: "raw",
    inputs: &["cuboid_faces_25", "cuboid_faces_50", "cuboid_faces_100"],
    work: Work::Inside(|path, clock| related(path, clock, 2, "FF", Shared::AtLeast(2))),
};

pub(super) const VERTICES: Task = Task {
    name: "operator-vv",
    about: "vertices joined by an edge (VV), from the ends of the edges",
    extension: "raw",
    inputs: &["cuboid_edges_25", "cuboid_edges_50", "cuboid_edges_100"],
    work: Work::Inside(|path, clock| related(path, clock, 1, "VV", Shared::AtLeast(1))),
};

pub(super) const GRID: Task = Task {
    name: "operators-grid",
    about: "a cuboid grid from nothing: all cells and boundary matrices, then all 16 incidences and adjacencies",
    extension: "raw",
    inputs: &["cuboid_faces_25", "cuboid_faces_50", "cuboid_faces_100"],
    work: Work::Inside(all_operators),
};

fn related(
    path: &Path,
    clock: &mut Clock,
    degree: usize,
    operator: &str,
    shared: Shared,
) -> Result<String, Error> {
    let mesh = Mesh::read_raw(path)?;
    let mut cells = vec![RaggedArray::new(); degree];
    cells[degree - 1] = mesh.lists;
    let model = LarModel::new(mesh.vertex_count, cells)?;
    let operator: Operator = operator.parse()?;
    let rows = clock.time(model.cell_count(degree), || model.related(operator, shared))?;
    Ok(format!("pairs {}", rows.item_count()))
}

fn all_operators(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    // The grid is made within the clock; the file only tells its size.
    let vertex_count = Mesh::read_raw(path)?.vertex_count;
    let side = (1..).find(|side| (side + 1usize).pow(3) >= vertex_count).unwrap_or(1);
    let (entries, pairs) = clock.time(side.pow(3), || {
        let grid = CuboidGrid::new(&[side as u32; 3])?;
        let complex = grid.chain_complex()?;
        let model = grid.lar_model()?;
        let mut pairs = 0;
        for (rows, columns) in (0..4).flat_map(|rows| (0..4).map(move |columns| (rows, columns))) {
            pairs += model.incident(Operator::new(rows, columns))?.item_count();
        }
        let entries: usize = complex.boundary_matrices().iter().map(|matrix| matrix.entry_count()).sum();
        Ok::<_, Error>((entries, pairs))
    })?;
    Ok(format!("entries of boundaries {entries} pairs of all operators {pairs}"))
}
