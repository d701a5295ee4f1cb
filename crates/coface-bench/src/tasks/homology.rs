//! Integral homology of a loaded mesh.

use super::{SURFACES, Task, Work};
use crate::inputs::Mesh;
use coface::surface::PolygonMesh;
use coface::topology::{Homology, homology};

pub(super) const SURFACE: Task = Task {
    name: "homology",
    about: "integral homology of a surface from the loaded model: edges, boundary matrices, reduction, groups",
    extension: "raw",
    inputs: SURFACES,
    work: Work::Inside(|path, clock| {
        let model = Mesh::read_raw(path)?.into_model()?;
        let polygons = model.polygons();
        let groups = clock.time(polygons.len(), || {
            PolygonMesh::new(model.vertex_count(), polygons.clone(), &[])
                .map(|mesh| homology(&mesh.into_chain_complex()))
        })?;
        Ok(to_text(&groups))
    }),
};

/// The Betti numbers, and the torsion where there is some.
pub(super) fn to_text(homology: &Homology) -> String {
    let mut text = "betti".to_owned();
    for group in homology.groups() {
        text += &format!(" {}", group.betti());
        for order in group.torsion() {
            text += &format!("+Z/{order}");
        }
    }
    text
}
