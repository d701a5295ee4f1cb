//! Congruence: classes of near points, and quotients of chain complexes by them.

use super::{Clock, Task, Work};
use crate::inputs::Mesh;
use coface::Error;
use coface::arrange::congruence::{
    CellClasses, ClassRule, CongruenceOptions, Representative, chain_congruence, vertex_congruence,
};
use coface::complexes::surface::PolygonMesh;
use coface::geometry::Positions;
use std::path::Path;

/// Well above the noise of the inputs, well below their edges.
const TOLERANCE: f64 = 1e-6;

pub(super) const WELD: Task = Task {
    name: "weld",
    about: "classes of points within a tolerance, and their positions, from the coordinates",
    extension: "raw3",
    inputs: &["soup5", "soup6", "soup7"],
    work: Work::Inside(|path, clock| {
        let (positions, _) = soup(path)?;
        let size = positions.len();
        let found = clock.time(size, || {
            vertex_congruence(&positions, TOLERANCE, ClassRule::Transitive, Representative::Lowest)
        })?;
        Ok(format!("points {size} classes {}", found.class_count()))
    }),
};

pub(super) const QUOTIENT: Task = Task {
    name: "congruence",
    about: "quotient of a chain complex by its vertices within a tolerance, from coordinates and boundary matrices",
    extension: "raw3",
    inputs: &["cubes_sep_10", "cubes_sep_20", "cubes_sep_30", "cubes_sep_50"],
    work: Work::Inside(quotient),
};

fn soup(path: &Path) -> Result<(Positions, Mesh), Error> {
    let mut mesh = Mesh::read_raw3(path)?;
    Ok((Positions::from_flat(3, std::mem::take(&mut mesh.coordinates))?, mesh))
}

fn quotient(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    let (positions, mesh) = soup(path)?;
    let size = mesh.lists.len();
    let complex = PolygonMesh::new(mesh.vertex_count, mesh.lists, &[])?.into_chain_complex()?;
    let found = clock.time(size, || {
        let (rule, representative) = (ClassRule::Transitive, Representative::Lowest);
        let vertices = vertex_congruence(&positions, TOLERANCE, rule, representative)?;
        let classes = CellClasses::unsigned(vertices.class_of().to_vec())?;
        chain_congruence(&complex, classes, Some(vertices.positions()), CongruenceOptions::default())
    })?;
    let counts: Vec<String> = "VEF"
        .chars()
        .zip(found.complex().f_vector())
        .map(|(letter, count)| format!("{letter} {count}"))
        .collect();
    Ok(counts.join(" "))
}
