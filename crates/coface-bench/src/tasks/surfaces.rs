//! Loops and cocycles of closed surfaces.

use super::{Clock, SURFACES, Task, Work};
use crate::inputs::Mesh;
use coface::Error;
use coface::complexes::surface::{GeneralizedMap, PolygonMesh};
use coface::topology::{CocycleBasis, CutSurface, SurfaceHomology, TreeCotree};
use std::path::Path;

/// Plates of about 250,000 triangles with few and many holes.
const GENERA: &[&str] = &["plate2_255", "plate8_255", "plate32_255", "plate128_255"];

pub(super) const LOOPS: Task = Task {
    name: "surface-loops",
    about: "tree-cotree decomposition, loops of the generators and the word of the relator, from the loaded faces",
    extension: "raw",
    inputs: SURFACES,
    work: Work::Inside(loops),
};

pub(super) const COCYCLES: Task = Task {
    name: "surface-cocycles",
    about: "basis of first cohomology by slicing, intersection matrix and dual basis, from the loaded faces",
    work: Work::Inside(cocycles),
    ..LOOPS
};

pub(super) const LOOPS_BY_GENUS: Task = Task { name: "surface-loops-genus", inputs: GENERA, ..LOOPS };

pub(super) const COCYCLES_BY_GENUS: Task =
    Task { name: "surface-cocycles-genus", inputs: GENERA, ..COCYCLES };

fn mesh_of(path: &Path) -> Result<(PolygonMesh, usize), Error> {
    let mesh = Mesh::read_raw(path)?;
    let vertex_count = mesh.lists.items().iter().max().map_or(0, |&last| last as usize + 1);
    let count = mesh.lists.len();
    Ok((PolygonMesh::new(vertex_count, mesh.lists, &[])?, count))
}

fn loops(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    let (mesh, count) = mesh_of(path)?;
    clock.time(count, || {
        let map = GeneralizedMap::new(mesh.two_skeleton()?)?;
        let trees = TreeCotree::new(&map);
        let cut = CutSurface::new(&map, &trees);
        let generators = trees.components()[0].generators();
        let length: usize = generators.iter().map(|&edge| trees.based_loop(&map, edge).len()).sum();
        let letters = cut.domains()[0].relator().map_or(0, |relator| relator.len());
        Ok(format!("{} loops of {length} steps in all, relator of {letters} letters", generators.len()))
    })
}

fn cocycles(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    let (mesh, count) = mesh_of(path)?;
    clock.time(count, || {
        let map = GeneralizedMap::new(mesh.two_skeleton()?)?;
        let trees = TreeCotree::new(&map);
        let sliced = CocycleBasis::by_slicing(&map, SurfaceHomology::new(&map, &trees).loops())?;
        let dual = sliced.dual()?;
        let determinant = sliced.determinant().map_or_else(String::new, ToString::to_string);
        Ok(format!("{} cocycles, determinant {determinant}", dual.cocycles().len()))
    })
}
