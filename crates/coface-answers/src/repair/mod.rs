//! Models made ready for other questions: a manifold by splitting and turning ([`repaired`]), simplices by subdivision
//! ([`triangulated`]).

mod splitting;
mod triangulation;

pub use splitting::{RepairRequest, repaired};
pub use triangulation::triangulated;
