//! Permutations, words in free groups, and partitions kept by union-find.

mod permutation;
mod sign;
mod union_find;
mod word;

pub use permutation::Permutation;
pub use sign::Sign;
pub use union_find::{ParityUnion, ParityUnionFind, UnionFind};
pub use word::Word;
#[doc(hidden)]
pub use word::least_rotation;
