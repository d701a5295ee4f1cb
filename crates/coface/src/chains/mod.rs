//! The centre of the house: chain complexes of free abelian groups with a basis of cells.
//!
//! # Words and conventions
//! * The **boundary matrix** of degree k goes from k-chains to (k-1)-chains: column j is the boundary of the k-cell j.
//!   Its transpose is the **coboundary matrix** of degree k - 1.
//! * Boundary of boundary is zero (checked when a [`ChainComplex`] is made).
//! * A room above asks questions of a `ChainComplex`; a producer makes one. No coordinates are ever seen here.

mod complex;
mod matching;
mod morse;

pub use complex::ChainComplex;
pub use matching::{AcyclicMatching, MatchedPair};
pub use morse::MorseComplex;

#[cfg(test)]
pub(crate) use complex::tests::random_complexes;
