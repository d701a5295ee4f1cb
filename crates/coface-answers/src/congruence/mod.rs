//! Congruence of models: what coincides within a tolerance becomes one.
//!
//! Several models are taken together: their cells are numbered one model after the other, and each model is a **block**.

mod certificate;
mod json;
mod merging;
mod mesh;
mod request;

pub use merging::ModelCongruence;
pub use request::{BlockRule, CongruenceRequest};
