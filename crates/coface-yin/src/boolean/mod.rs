//! The Boolean algebra of Yin sets.

mod algebra;
mod combination;
mod coverage;
mod curved;
mod linear;
mod outline;
mod repair;
mod rounding;
mod welding;

pub use algebra::Normalized;
pub use combination::{Assumption, Combination, PieceSource, UncertifiedDecision};
pub(crate) use coverage::first_covering;
pub(crate) use curved::curved_jordan_rings;
pub(crate) use linear::{combine_rings, linear_overlay};
