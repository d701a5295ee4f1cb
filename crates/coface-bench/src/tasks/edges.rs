//! Identification of the edges of a polygon mesh.

use super::{SURFACES, Task, Work};
use crate::inputs::Mesh;
use coface::complexes::surface::PolygonMesh;

pub(super) const TASK: Task = Task {
    name: "edges",
    about: "edges of a polygon mesh, each with its faces and signs, from the list of polygons",
    extension: "raw",
    inputs: SURFACES,
    work: Work::Inside(|path, clock| {
        let mesh = Mesh::read_raw(path)?;
        let mesh = clock.time(mesh.lists.len(), || PolygonMesh::new(mesh.vertex_count, mesh.lists, &[]))?;
        Ok(format!("V E F {:?}", mesh.f_vector()))
    }),
};
