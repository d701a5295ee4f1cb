//! Everything that is said about a surface without homology.

use super::{SURFACES, Task, Work};
use crate::inputs::Mesh;
use coface::complexes::surface::PolygonMesh;

pub(super) const TASK: Task = Task {
    name: "manifold",
    about: "manifold verdict, boundary loops, components, orientation and type, from the list of polygons",
    extension: "raw",
    inputs: SURFACES,
    work: Work::Inside(|path, clock| {
        let mesh = Mesh::read_raw(path)?;
        let survey = clock.time(mesh.lists.len(), || {
            PolygonMesh::new(mesh.vertex_count, mesh.lists, &[]).map(|mesh| mesh.survey())
        })?;
        Ok(format!(
            "manifold {} orientable {:?} components {} boundary loops {} name {}",
            survey.verdict().is_manifold(),
            survey.orientation().is_orientable(),
            survey.components().count(),
            survey.boundary_loops().len(),
            survey.name().unwrap_or_default()
        ))
    }),
};
