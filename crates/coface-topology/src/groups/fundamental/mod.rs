//! Fundamental groups: loops up to homotopy, by generators and relators.
//!
//! # Words and conventions
//! * A [`Presentation`] has generators 1, ..., n and relators, [`coface_algebra::Word`]s in them that are the unit.
//! * [`EdgePathGroups`] presents the fundamental group of each component of a
//!   [`coface_algebra::chains::TwoSkeleton`]; every edge has a word, every generator a loop at the base vertex.
//! * A [`Simplification`] is a list of [`TietzeMove`]s with the isomorphism that they are, both ways.
//! * [`Presentation::subgroups_up_to`] and [`Presentation::homomorphisms_to`] count what distinguishes groups. The
//!   section [`crate::recognition`] names groups.
//! * What may take forever has an [`Effort`]; its steps are the same on every machine.

mod coset_enumeration;
mod edge_path;
mod homomorphisms;
mod low_index;
mod moves;
mod presentation;
mod tietze;
mod word_table;

pub use coset_enumeration::CosetTable;
pub use edge_path::EdgePathGroups;
pub use homomorphisms::{HomomorphismCount, PermutationGroup};
pub use low_index::SubgroupClass;
pub use moves::TietzeMove;
pub use presentation::Presentation;
pub use tietze::{Effort, Simplification};
