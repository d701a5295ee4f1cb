//! Permutations, words in free groups, signs, and partitions by union-find.
//!
//! # Words and conventions
//! * A [`Permutation`] of `0..n` moves i to `image(i)`; `p.then(&q)` applies p first.
//! * A [`Word`] has the letters 1, -1, 2, -2, ...; -i is the inverse of i. It is always freely reduced.
//! * A [`Sign`] is an orientation relative to a reference.
//! * A [`UnionFind`] keeps a partition of `0..n` into classes that can be united. A [`ParityUnionFind`] also keeps the
//!   sign of each member relative to its class, and reports signs that contradict each other.

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
