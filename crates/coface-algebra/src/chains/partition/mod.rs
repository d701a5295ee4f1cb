//! Homology piece by piece: a complex is cut into parts, and each part is reduced without the others.
//!
//! # Words
//! * Each maximal cell has an **owner**, the number of a part. The **key** of a cell is the set of the owners of the
//!   maximal cells that have it in their closure. The key of a face contains the key of the cell.
//! * A **stratum** is the set of all cells of one key: the interior of a part, or what two or more parts share.
//! * A [`Part`] is the closure of the cells that it owns: all cells whose key contains its number. It has each of its
//!   strata as a whole.
//! * A cell is known beyond its part by a 64-bit **id**; the ids of cells have the same order in all parts.
//!
//! # Why it is correct
//! Keys are a map to a partially ordered set, so acyclic matchings within the strata are acyclic together (the
//! patchwork theorem). The matching of a stratum depends on the stratum only, so parts that share a stratum find the
//! same matching without communication. A gradient path from a cell meets only keys that contain its own: so each part
//! that has a critical cell knows its exact boundary in the Morse complex of the whole. [`Part::reduced`] leaves the
//! critical cells, which are again a part; [`Part::merged`] joins parts, which makes strata larger, and so on up a
//! tree. What is left at the root has the integral homology of the whole, and [`Part::inclusions`] takes its cycles
//! back to the cells of the parts.
//!
//! # References
//! J. Jonsson, *Simplicial Complexes of Graphs* (2008), lemma 4.2 (the patchwork theorem); R. Forman, *Morse theory for
//! cell complexes* (1998).

mod keys;
mod lifting;
mod merging;
mod owners;
mod part;
mod settled;
mod tree;

pub use lifting::{ChainById, sum_of_chains};
pub use owners::{Partition, Parts};
pub use part::{Part, ReducedPart, StratumHash};
pub use settled::SettledParts;
pub use tree::PartTree;
