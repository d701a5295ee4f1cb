//! The halfedge mesh of a list of triangles.

use super::{Task, Work};
use crate::inputs::Mesh;
use coface::complexes::surface::HalfedgeMesh;

pub(super) const TASK: Task = Task {
    name: "halfedges",
    about: "halfedge mesh with outer faces, every edge and vertex checked, from the list of triangles",
    extension: "raw",
    inputs: &["ico6", "ico7", "ico8", "ico9"],
    work: Work::Inside(|path, clock| {
        let mesh = Mesh::read_raw(path)?;
        let size = mesh.lists.len();
        let halfedges = clock.time(size, || HalfedgeMesh::from_polygons(mesh.vertex_count, &mesh.lists))?;
        let (v, e, f) = (halfedges.vertex_count(), halfedges.edge_count(), halfedges.face_count());
        Ok(format!("V {v} E {e} F {f} outer faces {}", halfedges.outer_face_count()))
    }),
};
