//! Integral homology of a loaded mesh, and of a chain complex that is ready.

use super::{Clock, SOLIDS, SURFACES, Task, Work};
use crate::inputs::Mesh;
use coface::Error;
use coface::cellular::CellMesh;
use coface::chains::ChainComplex;
use coface::io::Model;
use coface::surface::PolygonMesh;
use coface::topology::{Homology, homology};
use std::path::Path;

pub(super) const SURFACE: Task = Task {
    name: "homology",
    about: "integral homology from the loaded model: identified faces, boundary matrices, reduction, groups",
    extension: "raw",
    inputs: SURFACES,
    work: Work::Inside(from_model),
};

pub(super) const SOLID: Task = Task { name: "homology-solid", inputs: SOLIDS, ..SURFACE };

pub(super) const REDUCTION: Task = Task {
    name: "reduction",
    about: "integral homology, the chain complex ready: acyclic matching, Morse complex, Smith normal form",
    extension: "raw",
    inputs: SOLIDS,
    work: Work::Inside(|path, clock| {
        let complex = chain_complex(&Mesh::read_raw(path)?.into_model()?)?;
        Ok(to_text(&clock.time(complex.f_vector().iter().sum(), || homology(&complex))))
    }),
};

fn from_model(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    let model = Mesh::read_raw(path)?.into_model()?;
    let size = model.polygons().len() + model.cells().len();
    let groups = clock.time(size, || chain_complex(&model).map(|complex| homology(&complex)))?;
    Ok(to_text(&groups))
}

/// The chain complex of a model of polygons or of cells.
pub(super) fn chain_complex(model: &Model) -> Result<ChainComplex, Error> {
    let (count, polygons) = (model.vertex_count(), model.polygons());
    if model.cells().is_empty() {
        return Ok(PolygonMesh::new(count, polygons.clone(), &[])?.into_chain_complex());
    }
    let mesh = CellMesh::new(count, model.shapes().to_vec(), model.cells().clone(), polygons, &[])?;
    Ok(mesh.into_chain_complex())
}

/// The Betti numbers, and the torsion where there is some.
fn to_text(homology: &Homology) -> String {
    let mut text = "betti".to_owned();
    for group in homology.groups() {
        text += &format!(" {}", group.betti());
        for order in group.torsion() {
            text += &format!("+Z/{order}");
        }
    }
    text
}
