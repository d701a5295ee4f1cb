//! Insertion of simplices with all their faces, stars and links of vertices.

use super::{Task, Work};
use crate::inputs::Mesh;
use coface::Error;
use coface::complexes::simplicial::{FrozenComplex, Simplex, SimplicialComplex};
use std::path::Path;

const INPUTS: &[&str] = &["simp_100000", "simp_250000", "simp_500000", "simp_1000000"];
/// As many vertices, the lowest, have their stars and links listed.
const VERTEX_COUNT: usize = 2000;

pub(super) const INSERTION: Task = Task {
    name: "insertion",
    about: "a dynamic complex from simplices of dimension 0 to 5, with all faces",
    extension: "raw",
    inputs: INPUTS,
    work: Work::Inside(|path, clock| {
        let mesh = Mesh::read_raw(path)?;
        let complex = clock.time(mesh.lists.len(), || SimplicialComplex::from_facets(mesh.lists.iter()))?;
        Ok(format!("simplices {}", complex.len()))
    }),
};

pub(super) const FREEZING: Task = Task {
    name: "insertion-frozen",
    about: "the same simplices as a frozen complex",
    extension: "raw",
    inputs: INPUTS,
    work: Work::Inside(|path, clock| {
        let mesh = Mesh::read_raw(path)?;
        let complex = clock.time(mesh.lists.len(), || FrozenComplex::from_facets(&mesh.lists))?;
        Ok(format!("simplices {}", complex.len()))
    }),
};

pub(super) const STARS: Task = Task {
    name: "stars",
    about: "all cofaces of 2000 vertices, one after the other, the complex ready",
    extension: "raw",
    inputs: INPUTS,
    work: Work::Inside(|path, clock| {
        let (complex, vertices) = prepare(path)?;
        let count = clock.time(complex.len(), || -> usize {
            vertices.iter().map(|vertex| complex.cofaces(vertex).count()).sum()
        });
        Ok(format!("vertices {} simplices {count}", vertices.len()))
    }),
};

pub(super) const LINKS: Task = Task {
    name: "links",
    about: "the links of 2000 vertices as complexes, one after the other, the complex ready",
    extension: "raw",
    inputs: INPUTS,
    work: Work::Inside(|path, clock| {
        let (complex, vertices) = prepare(path)?;
        let count = clock.time(complex.len(), || -> Result<usize, Error> {
            vertices.iter().map(|vertex| complex.link(vertex.clone()).map(|link| link.len())).sum()
        })?;
        Ok(format!("vertices {} simplices {count}", vertices.len()))
    }),
};

pub(super) const LINK_SIMPLICES: Task = Task {
    name: "link-simplices",
    about: "the simplices of the links of 2000 vertices, listed one after the other, the complex ready",
    extension: "raw",
    inputs: INPUTS,
    work: Work::Inside(|path, clock| {
        let (complex, vertices) = prepare(path)?;
        let count = clock.time(complex.len(), || -> Result<usize, Error> {
            vertices.iter().map(|vertex| complex.link_simplices(vertex.clone()).map(|link| link.len())).sum()
        })?;
        Ok(format!("vertices {} simplices {count}", vertices.len()))
    }),
};

/// The complex and its lowest vertices.
fn prepare(path: &Path) -> Result<(SimplicialComplex, Vec<Simplex>), Error> {
    let complex = SimplicialComplex::from_facets(Mesh::read_raw(path)?.lists.iter())?;
    let vertices = complex.vertices().take(VERTEX_COUNT).map(Simplex::vertex).collect();
    Ok((complex, vertices))
}
