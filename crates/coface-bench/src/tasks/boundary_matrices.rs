//! Signed boundary matrices of a mesh of cells.

use super::{Task, Work};
use crate::inputs::Mesh;
use coface::answers::Producer;

pub(super) const TASK: Task = Task {
    name: "boundary-matrices",
    about: "the boundary matrices of all degrees from the list of cells, and the products of neighboring ones, stored",
    extension: "raw",
    inputs: &["grid3_26", "grid3_35", "grid3_44", "grid3_55"],
    work: Work::Inside(|path, clock| {
        let model = Mesh::read_raw(path)?.into_model()?;
        let size = model.cells().len() + model.polygons().len();
        let (complex, products) = clock.time(size, || {
            let complex = Producer::of(model)?.into_chain_complex()?;
            let products: Result<Vec<_>, _> = complex
                .boundary_matrices()
                .windows(2)
                .map(|pair| pair[0].checked_product(&pair[1]))
                .collect();
            Ok::<_, coface::Error>((complex, products?))
        })?;
        let entries: Vec<usize> = products.iter().map(|product| product.entry_count()).collect();
        Ok(format!("cells {:?} entries of the products {entries:?}", complex.f_vector()))
    }),
};
