//! Homology piece by piece: complexes that are cut into parts, each reduced without the others.
//!
//! # Words
//! * Each maximal cell has an **owner**, the number of a part. The **key** of a cell is the set of owners of the maximal cells above it.
//!   A face has at least the key of the cell.
//! * A **stratum** is all cells of one key: what is inside a part, a wall between two, an edge where walls meet.
//! * A [`Part`] is the closure of what it owns: all cells whose key has its number. It sees each of its strata whole.
//! * Cells are known beyond their part by 64-bit **ids**, whose order is the same in all parts.
//!
//! # Why it works
//! Keys are a map to a partially ordered set, so acyclic matchings inside the strata are together acyclic (the patchwork theorem). The
//! matching of a stratum depends on nothing but the stratum, so that neighbors find the same in their common wall without a word. A gradient
//! path from a cell meets only keys that contain its own: so each part that has a critical cell knows its exact boundary in the Morse
//! complex of the whole. [`Part::reduced`] leaves the critical cells, again a part; [`Part::merged`] joins parts, which makes strata larger,
//! and so on up a tree. What is left at the root has the integral homology of the whole, and [`Part::inclusions`] takes its cycles down
//! again.
//!
//! # References
//! J. Jonsson, *Simplicial Complexes of Graphs* (2008), lemma 4.2 (the patchwork theorem); R. Forman, *Morse theory for cell complexes*
//! (1998).

mod keys;
mod lifting;
mod merging;
mod owners;
mod part;
mod tree;

pub use lifting::{ChainById, sum_of_chains};
pub use owners::{Partition, Parts};
pub use part::{Part, ReducedPart, WallHash};
pub use tree::PartTree;
