//! Smith and Hermite normal forms of integer matrices, and bilinear forms on lattices.

mod elimination;
mod hermite;
mod skew_form;
mod smith;
mod symmetric_form;

pub use skew_form::SkewForm;
pub use smith::{SmithForm, SmithTransforms, invariant_factors, smith_form, smith_form_with_transforms};
pub use symmetric_form::{Definiteness, Inertia, Parity, SymmetricForm};
