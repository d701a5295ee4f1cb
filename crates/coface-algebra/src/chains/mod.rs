//! Chain complexes of free abelian groups with a basis of cells: what all producers make and all questions take.
//!
//! # Words and conventions
//! * The **boundary matrix** of degree k goes from k-chains to (k-1)-chains: column j is the boundary of the k-cell j.
//!   Its transpose is the **coboundary matrix** of degree k - 1.
//! * The boundary of a boundary is zero; the constructor of a [`ChainComplex`] checks it.
//! * A [`Chain`] is a combination of cells, a [`Cochain`] is a function on cells. The value of the coboundary of a
//!   cochain on a chain is the value of the cochain on the boundary of the chain. A chain without boundary is a
//!   **cycle**, a cochain without coboundary is **closed**. The [`Coefficient`]s are integers, rationals, residues
//!   modulo n, or `f64`; a [`Selection`] has the coefficients -1, 0 and 1 only.
//! * [`Cells`] is the trait of all producers: whatever is made of cells and has a chain complex.
//! * A [`TwoSkeleton`] also knows the order in which the boundary of each face runs along its edges.
//! * An [`AcyclicMatching`] pairs cells that cancel each other; what is left is a [`MorseComplex`] with the same
//!   homology. A [`Reduction`] repeats this. A [`ChainRefinement`] says what the cells of a finer complex are pieces of. A [`Partition`] cuts a complex into [`Part`]s that are reduced one by one.
//!
//! # Examples
//! An edge with two ends, and the boundary of three times the edge:
//! ```
//! use coface_algebra::chains::{Chain, ChainComplex};
//! use coface_algebra::{CellId, Integer, SparseMatrix};
//! # fn main() -> Result<(), coface_algebra::Error> {
//! let edge = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
//! let chain = Chain::new(&edge, 1, [(CellId::new(0), Integer::from(3))])?;
//! assert_eq!(edge.boundary(&chain)?.to_string(), "-3 c0 + 3 c1");
//! # Ok(()) }
//! ```

mod cells;
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
mod refinement;
mod selection;
mod subcomplex;
mod two_skeleton;

pub use cells::Cells;
pub use chain::Chain;
pub use chain_map::ChainMap;
pub use cochain::Cochain;
pub use coefficient::Coefficient;
pub use complex::{ChainComplex, WideComplex};
pub use matching::{AcyclicMatching, MatchedPair};
pub use morse::MorseComplex;
pub use partition::{
    ChainById, Part, PartTree, Partition, Parts, ReducedPart, SettledParts, StratumHash, sum_of_chains,
};
pub use product::ProductComplex;
#[doc(hidden)]
pub use product::ProductNumbers;
pub use reduction::Reduction;
pub use refinement::ChainRefinement;
pub use selection::Selection;
pub use two_skeleton::TwoSkeleton;
