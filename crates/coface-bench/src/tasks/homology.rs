//! Integral homology of a loaded mesh, and of a chain complex that is ready.

use super::{Clock, SOLIDS, SURFACES, Task, Work};
use crate::inputs::Mesh;
use coface::Error;
use coface::algebra::Integer;
use coface::algebra::chains::ChainComplex;
use coface::answers::Producer;
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
        let complex = Producer::of(Mesh::read_raw(path)?.into_model()?)?.into_chain_complex()?;
        Ok(to_text(&clock.time(complex.f_vector().iter().sum(), || homology(&complex))))
    }),
};

fn from_model(path: &Path, clock: &mut Clock) -> Result<String, Error> {
    Ok(to_text(&ask_model(path, clock, homology)?))
}

/// The answer to a question about the chain complex of a loaded model, which is made within the clock.
pub(super) fn ask_model<T>(
    path: &Path,
    clock: &mut Clock,
    question: impl FnOnce(&ChainComplex) -> T,
) -> Result<T, Error> {
    let model = Mesh::read_raw(path)?.into_model()?;
    let size = model.polygons().len() + model.cells().len();
    // As the program does it: the model is given away, and its arrays go into the complex.
    let (answer, _complex) = clock.time(size, || {
        let complex = Producer::of(model)?.into_chain_complex()?;
        Ok::<_, Error>((question(&complex), complex))
    })?;
    Ok(answer)
}

/// The Betti numbers, and the torsion where there is some.
fn to_text(homology: &Homology) -> String {
    let groups = homology.groups().iter();
    groups.fold("betti".to_owned(), |text, group| text + &group_to_text(group.betti(), group.torsion()))
}

/// One group: a Betti number, then the orders of torsion; of long orders the number of digits.
pub(super) fn group_to_text<'a>(betti: usize, orders: impl IntoIterator<Item = &'a Integer>) -> String {
    let order_to_text = |order: &Integer| match order.to_string() {
        digits if digits.len() > 12 => format!("+Z/({} digits)", digits.len()),
        digits => format!("+Z/{digits}"),
    };
    orders.into_iter().map(order_to_text).fold(format!(" {betti}"), |text, order| text + &order)
}
