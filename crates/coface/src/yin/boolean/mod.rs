//! The Boolean algebra of Yin sets.

mod algebra;
mod combination;
mod coverage;
mod curved;
mod linear;
mod outline;
mod repair;

pub use algebra::Normalized;
pub use combination::{Assumption, Combination, PieceSource, UncertifiedDecision};
pub(in crate::yin) use coverage::first_covering;
pub(in crate::yin) use curved::curved_jordan_rings;
pub(in crate::yin) use linear::{combine_rings, linear_overlay};
