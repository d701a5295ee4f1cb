//! Smith and Hermite normal forms of integer matrices, and bilinear forms on lattices.
//!
//! # Words
//! * The **Smith form** of a matrix A is $U A V = D$ with unimodular U and V and a diagonal D, of which each entry
//!   divides the next: see [`smith_form`] and [`smith_form_with_transforms`]. The entries of D are the **invariant
//!   factors**, and those above 1 are the **torsion** of the cokernel.
//! * A [`SymmetricForm`] has a rank, a signature, a parity and a determinant; together they name the unimodular forms.
//! * A [`SkewForm`] has elementary divisors, which determine it up to a change of basis.

mod elimination;
mod hermite;
mod skew_form;
mod smith;
mod symmetric_form;

pub use skew_form::SkewForm;
pub use smith::{SmithForm, SmithTransforms, invariant_factors, smith_form, smith_form_with_transforms};
pub use symmetric_form::{Definiteness, Inertia, Parity, SymmetricForm};
