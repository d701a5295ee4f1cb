//! Homology of a chain complex that is ready.

use super::homology::to_text;
use super::{SOLIDS, Task, Work};
use crate::inputs::Mesh;
use coface::Error;
use coface::algebra::SparseMatrix;
use coface::chains::ChainComplex;
use coface::topology::homology;

pub(super) const TASK: Task = Task {
    name: "reduction",
    about: "integral homology, the chain complex ready: acyclic matching, Morse complex, Smith normal form",
    extension: "raw",
    inputs: SOLIDS,
    work: Work::Inside(|path, clock| {
        let complex = chain_complex(&Mesh::read_raw(path)?)?;
        Ok(to_text(&clock.time(complex.f_vector().iter().sum(), || homology(&complex))))
    }),
};

/// The chain complex of simplices of one dimension with all their faces, vertices in rising order.
fn chain_complex(mesh: &Mesh) -> Result<ChainComplex, Error> {
    let mut simplices: Vec<Vec<u32>> = mesh.lists.iter().map(<[u32]>::to_vec).collect();
    simplices.iter_mut().for_each(|s| s.sort_unstable());
    simplices.sort_unstable();
    let mut boundaries = Vec::new();
    while simplices.first().is_some_and(|s| s.len() > 1) {
        let face = |s: &[u32], i: usize| -> Vec<u32> { [&s[..i], &s[i + 1..]].concat() };
        let mut faces: Vec<Vec<u32>> =
            simplices.iter().flat_map(|s| (0..s.len()).map(move |i| face(s, i))).collect();
        faces.sort_unstable();
        faces.dedup();
        let entries = simplices.iter().enumerate().flat_map(|(j, s)| {
            let faces = &faces;
            (0..s.len()).map(move |i| {
                let row = faces.binary_search(&face(s, i)).expect("every face is listed");
                (row, j, if i % 2 == 0 { 1 } else { -1 })
            })
        });
        boundaries.push(SparseMatrix::from_entries(faces.len(), simplices.len(), entries)?);
        simplices = faces;
    }
    boundaries.reverse();
    ChainComplex::new(boundaries)
}
