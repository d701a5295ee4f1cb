//! Ground for exact answers: integers that widen, sparse integer matrices, Smith normal form, union-find.
//!
//! # Words
//! * An [`Integer`] is held in 64 bits as long as it fits and as a big integer beyond; no sum or product wraps.
//! * A [`Rational`] is a fraction in lowest terms, a [`Residue`] an integer modulo n.
//! * A [`SparseMatrix`] is in compressed columns: column `j` is a sorted list of (row, entry), no entry is zero. Its
//!   entries are 32 bits wide; a [`WideMatrix`] has integers of any size, and arithmetic gives an [`IntegerMatrix`],
//!   which is whichever of the two suffices.
//! * The [`SmithForm`] of a matrix is diagonal with each entry dividing the next; [`SmithTransforms`] make it.
//! * A [`SymmetricForm`] or [`SkewForm`] is a bilinear form on a lattice, with the invariants that its basis does not change.
//! * A [`Permutation`] moves i to `image(i)`; `p.then(&q)` does p first.
//! * A [`RaggedArray`] is a list of lists in one flat array: polygons, facets, orbits.
//! * A [`Word`] is an element of a free group, freely reduced.
//! * A [`UnionFind`] keeps a partition of `0..n`; [`ParityUnionFind`] also keeps a sign between members.
//!
#![doc = include_str!("../README.md")]

pub mod chains;
mod combinatorics;
mod error;
mod ids;
mod integers;
mod matrices;
mod normal_forms;
pub mod progress;
#[cfg(any(test, feature = "samples"))]
#[doc(hidden)]
pub mod samples;

pub use error::{Error, ErrorKind, Fault};
pub use ids::{CellId, EdgeId, FaceId, HalfedgeId, Id, IdVec, VertexId};

pub use combinatorics::{ParityUnion, ParityUnionFind, Permutation, Sign, UnionFind, Word};
pub use integers::{Integer, Rational, Residue};
pub use matrices::{Column, Entry, IntegerMatrix, RaggedArray, SparseMatrix, SparseVector, WideMatrix};
pub use normal_forms::{
    Definiteness, Inertia, Parity, SkewForm, SmithForm, SmithTransforms, SymmetricForm, invariant_factors,
    smith_form, smith_form_with_transforms,
};

// What the crates above share; not for users.
#[doc(hidden)]
pub use combinatorics::least_rotation;
#[doc(hidden)]
pub use integers::{Binary, Field, Odd, is_prime, large_primes};
#[doc(hidden)]
pub use matrices::{ColumnBlock, combination, inner_product, joined_columns, linear_combination};
