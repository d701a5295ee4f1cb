//! The centre of the house: chain complexes of free abelian groups with a basis of cells.
//!
//! # Words and conventions
//! * The **boundary matrix** of degree k goes from k-chains to (k-1)-chains: column j is the boundary of the k-cell j.
//!   Its transpose is the **coboundary matrix** of degree k - 1.
//! * Boundary of boundary is zero (checked when a [`ChainComplex`] is made).
//! * A [`Chain`] is a combination of cells, a [`Cochain`] a function on cells; the value of the coboundary of a cochain
//!   on a chain is its value on the boundary of the chain. A chain without boundary is a **cycle**, a cochain without
//!   coboundary is **closed**. The [`Coefficient`]s are integers, rationals, residues modulo n, or `f64`;
//!   a [`Selection`] has -1, 0 and 1 only.
//! * A room above asks questions of a `ChainComplex`; a producer makes one. No coordinates are ever seen here.

mod chain;
mod chain_map;
mod cochain;
mod coefficient;
mod combination;
mod complex;
mod flow;
mod matching;
mod morse;
mod partition;
mod product;
mod reduction;
mod selection;
mod subcomplex;
mod two_skeleton;

pub use chain::Chain;
pub use chain_map::ChainMap;
pub use cochain::Cochain;
pub use coefficient::Coefficient;
pub use complex::{ChainComplex, WideComplex};
pub use matching::{AcyclicMatching, MatchedPair};
pub use morse::MorseComplex;
pub use partition::{ChainById, Part, PartTree, Partition, Parts, ReducedPart, WallHash, sum_of_chains};
pub use product::ProductComplex;
#[doc(hidden)]
pub use product::ProductNumbers;
pub use reduction::Reduction;
pub use selection::Selection;
pub use two_skeleton::TwoSkeleton;
