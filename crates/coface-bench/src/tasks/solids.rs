//! Booleans of solids.

use super::{Clock, Task, Work};
use crate::inputs::Mesh;
use coface::Error;
use coface::algebra::RaggedArray;
use coface::answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
use coface::arrange::boolean::BooleanFormula;
use coface::arrange::spatial::checks::{CheckedFaces, GeometryChecks};
use coface::geometry::Positions;
use coface::io::Model;
use std::path::Path;

pub(super) const INTERSECTION: Task = Task {
    name: "solid-intersection",
    about: "the triangles around what two closed meshes have in common, exactly, from vertices and triangles",
    extension: "raw3",
    inputs: INPUTS,
    work: Work::Inside(|path, clock| combined(path, clock, BooleanFormula::intersection(2))),
};

pub(super) const UNION: Task = Task {
    name: "solid-union",
    about: "the triangles around what two closed meshes cover together, exactly, from vertices and triangles",
    extension: "raw3",
    inputs: INPUTS,
    work: Work::Inside(|path, clock| combined(path, clock, BooleanFormula::union(2))),
};

pub(super) const CHECKS: Task = Task {
    name: "info-checks",
    about: "whether two closed meshes that overlap are sound in space: crossings, overlaps, shells, from vertices and triangles",
    extension: "raw3",
    inputs: INPUTS,
    work: Work::Inside(checked),
};

const INPUTS: &[&str] = &["spheres5", "spheres6", "spheres7", "spheres8"];

fn combined(path: &Path, clock: &mut Clock, formula: BooleanFormula) -> Result<String, Error> {
    let mesh = Mesh::read_raw3(path)?;
    let (first, second) = (half(&mesh, 0)?, half(&mesh, 1)?);
    let mut request = SolidRequest::of(formula);
    request.triangles = true;
    let mut arrangement = None;
    let (volume, count) = clock.time(mesh.lists.len(), || {
        let models = [("first", &first), ("second", &second)];
        let arrangement = arrangement.insert(SceneArrangement::of(models, &SpatialRequest::default())?);
        let found = SolidBoolean::of(arrangement, &request)?;
        let positions = found.positions()?;
        assert_eq!(positions.len(), found.surface().vertex_sources().len());
        Ok::<_, Error>((found.volume().unwrap_or(f64::INFINITY), found.surface().polygons().len()))
    })?;
    Ok(format!("volume {volume:.12} F {count}"))
}

fn checked(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    let mesh = Mesh::read_raw3(path)?;
    let positions = Positions::from_flat(3, mesh.coordinates.clone())?;
    let faces = CheckedFaces::from_polygons(mesh.lists.clone());
    let found = clock.time(mesh.lists.len(), || GeometryChecks::new().check(&positions, &faces))?;
    let counts: Vec<String> =
        found.faults().iter().map(|fault| format!("{} x {}", fault.code().number(), fault.count())).collect();
    Ok(counts.join(", "))
}

/// The first or second half of the vertices and triangles.
pub(super) fn half(mesh: &Mesh, part: usize) -> Result<Model, Error> {
    let (vertices, triangles) = (mesh.vertex_count / 2, mesh.lists.len() / 2);
    let flat = mesh.coordinates[part * 3 * vertices..][..3 * vertices].to_vec();
    let shift = (part * vertices) as u32;
    let lists = (part * triangles..(part + 1) * triangles)
        .map(|triangle| mesh.lists.list(triangle).iter().map(|&v| v - shift).collect::<Vec<_>>());
    Model::from_polygons(Positions::from_flat(3, flat)?, RaggedArray::from_lists(lists))
}
