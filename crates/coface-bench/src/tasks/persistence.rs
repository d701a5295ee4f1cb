//! Persistent homology of a random function on the vertices.

use super::{Clock, SOLIDS, SURFACES, Task, Work};
use crate::inputs::{Mesh, random_values};
use coface::Error;
use coface::answers::Producer;
use coface::topology::{Coefficients, Filtration, persistence};
use std::path::Path;

pub(super) const SURFACE: Task = Task {
    name: "persistence",
    about: "persistence over F_2 of a random function on the vertices, the chain complex ready",
    extension: "raw",
    inputs: SURFACES,
    work: Work::Inside(lower_star),
};

pub(super) const SOLID: Task = Task { name: "persistence-solid", inputs: SOLIDS, ..SURFACE };

fn lower_star(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    let complex = Producer::of(Mesh::read_raw(path)?.into_model()?)?.into_chain_complex()?;
    let heights = random_values(complex.cell_count(0));
    let diagram = clock.time(complex.f_vector().iter().sum(), || {
        let filtration = Filtration::lower_star(&complex, &heights)?;
        persistence(&complex, &filtration, Coefficients::Modulo(2))
    })?;
    let mut text = "betti".to_owned();
    diagram.betti_numbers().iter().for_each(|betti| text += &format!(" {betti}"));
    text += &format!(" pairs {}", diagram.longer_than(0.0).pairs().len());
    Ok(text)
}
