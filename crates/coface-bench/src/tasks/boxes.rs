//! Arrangements of many boxes, and chains of Booleans.

use super::{Clock, Task, Work};
use crate::inputs::Mesh;
use coface::Error;
use coface::algebra::RaggedArray;
use coface::answers::{SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest};
use coface::arrange::boolean::BooleanFormula;
use coface::geometry::Positions;
use coface::io::Model;
use std::path::Path;

pub(super) const ROW: Task = Task {
    name: "spatial-row",
    about: "the cells of cubes in a row that do not touch, from vertices and triangles",
    extension: "raw3",
    inputs: &["boxrow_25000", "boxrow_50000", "boxrow_100000"],
    work: Work::Inside(|path, clock| arranged(path, clock, &SpatialRequest::default())),
};

pub(super) const BLOCK: Task = Task {
    name: "spatial-block",
    about: "the cells of cubes in a block that do not touch",
    extension: "raw3",
    inputs: &["boxblock_25000", "boxblock_50000", "boxblock_100000"],
    work: Work::Inside(|path, clock| arranged(path, clock, &SpatialRequest::default())),
};

pub(super) const DOLLS: Task = Task {
    name: "spatial-dolls",
    about: "the cells of cubes around each other",
    extension: "raw3",
    inputs: &["dolls_1000", "dolls_2000", "dolls_4000"],
    work: Work::Inside(|path, clock| arranged(path, clock, &SpatialRequest::default())),
};

pub(super) const ROOMS: Task = Task {
    name: "spatial-rooms",
    about: "the rooms of a building that is turned by 30 degrees, within a tolerance",
    extension: "raw3",
    inputs: &["rooms_500", "rooms_1000", "rooms_2000"],
    work: Work::Inside(|path, clock| {
        let mut request = SpatialRequest::default();
        request.tolerance = Some(1e-9);
        arranged(path, clock, &request)
    }),
};

pub(super) const CHAIN: Task = Task {
    name: "spatial-chain",
    about: "turned boxes united with what is there and cut away from it in turns, each result rounded validly",
    extension: "raw3",
    inputs: &["turned_25", "turned_50", "turned_100"],
    work: Work::Inside(chained),
};

fn arranged(path: &Path, clock: &mut Clock, request: &SpatialRequest) -> Result<String, Error> {
    let mesh = Mesh::read_raw3(path)?;
    let count = mesh.lists.len();
    let model = mesh.into_model()?;
    let mut found = None;
    clock.time(count, || {
        found = Some(SceneArrangement::of([("boxes", &model)], request)?);
        Ok::<_, Error>(())
    })?;
    let volumes = found.as_ref().map_or(&[][..], SceneArrangement::volumes);
    Ok(format!("{} cells, volume {:.6}", volumes.len(), volumes.iter().sum::<f64>()))
}

fn chained(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    let mesh = Mesh::read_raw3(path)?;
    let boxes: Vec<Model> = (0..mesh.lists.len() / 12).map(|i| box_of(&mesh, i)).collect::<Result<_, _>>()?;
    let mut solid = None;
    clock.time(boxes.len(), || {
        let mut volume = 0.0;
        for (i, other) in boxes.iter().enumerate() {
            let Some(own) = solid.take() else {
                solid = Some(other.clone());
                continue;
            };
            let formula = if i % 2 == 1 { BooleanFormula::union(2) } else { BooleanFormula::difference(2) };
            let mut request = SolidRequest::of(formula);
            (request.triangles, request.split_pinches, request.merge_coplanar) = (true, true, true);
            let models = [("solid", &own), ("box", other)];
            let exact = SceneArrangement::of(models, &SpatialRequest::default())?;
            let mut result = SolidBoolean::of(&exact, &request)?;
            let rounded;
            if result.crossings()?.count > 0
                && let Some(valid) = exact.validly_rounded()?
            {
                rounded = valid;
                result = SolidBoolean::of(&rounded, &request)?;
            }
            volume = result.volume().unwrap_or(f64::INFINITY);
            solid = Some(Model::from_polygons(result.positions()?, result.surface().polygons().clone())?);
        }
        let faces = solid.as_ref().map_or(0, |solid| solid.polygons().len());
        Ok::<_, Error>(format!("volume {volume:.9} F {faces}"))
    })
}

/// The box with this number.
fn box_of(mesh: &Mesh, number: usize) -> Result<Model, Error> {
    let flat = mesh.coordinates[24 * number..][..24].to_vec();
    let lists = (12 * number..12 * (number + 1)).map(|triangle| {
        mesh.lists.list(triangle).iter().map(|corner| corner - 8 * number as u32).collect::<Vec<_>>()
    });
    Model::from_polygons(Positions::from_flat(3, flat)?, RaggedArray::from_lists(lists))
}
