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

pub mod chains;
mod elimination;
mod entry;
mod error;
mod hermite;
mod ids;
mod integer;
mod integer_matrix;
mod matrix_arithmetic;
mod modular;
mod permutation;
mod prime_field;
mod primes;
mod product;
pub mod progress;
mod ragged;
mod rational;
mod residue;
#[cfg(any(test, feature = "samples"))]
#[doc(hidden)]
pub mod samples;
mod skew_form;
mod smith;
mod sparse_matrix;
mod sparse_vector;
mod symmetric_form;
mod union_find;
mod word;

pub use entry::Entry;
pub use error::{Error, ErrorKind};
pub use ids::{CellId, EdgeId, FaceId, HalfedgeId, Id, IdVec, VertexId};
pub use integer::Integer;
pub use integer_matrix::IntegerMatrix;
pub use permutation::Permutation;
#[doc(hidden)]
pub use prime_field::Binary;
pub use prime_field::{Field, Odd};
#[doc(hidden)]
pub use primes::is_prime;
pub use primes::large_primes;
#[doc(hidden)]
pub use product::ColumnBlock;
pub use product::joined_columns;
pub use ragged::RaggedArray;
pub use rational::Rational;
pub use residue::Residue;
pub use skew_form::SkewForm;
pub use smith::{SmithForm, SmithTransforms, invariant_factors, smith_form, smith_form_with_transforms};
pub use sparse_matrix::{Column, SparseMatrix, WideMatrix};
pub use sparse_vector::SparseVector;
#[doc(hidden)]
pub use sparse_vector::combination;
pub use sparse_vector::{inner_product, linear_combination};
pub use symmetric_form::{Definiteness, Inertia, Parity, SymmetricForm};
pub use union_find::{ParityUnion, ParityUnionFind, UnionFind};
pub use word::Word;
#[doc(hidden)]
pub use word::least_rotation;

use std::fmt;

/// An orientation: the same as the reference, or opposite to it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Sign {
    /// The orientation of the reference.
    Plus,
    /// The opposite orientation.
    Minus,
}

impl Sign {
    /// The sign of $(-1)^i$: plus when `exponent` is even.
    pub fn power_of_minus_one(exponent: usize) -> Self {
        if exponent.is_multiple_of(2) { Self::Plus } else { Self::Minus }
    }

    /// +1 or -1.
    pub fn to_i32(self) -> i32 {
        match self {
            Self::Plus => 1,
            Self::Minus => -1,
        }
    }

    /// The product of two signs.
    #[must_use]
    pub fn times(self, other: Self) -> Self {
        if self == other { Self::Plus } else { Self::Minus }
    }

    /// The opposite sign.
    #[must_use]
    pub fn opposite(self) -> Self {
        self.times(Self::Minus)
    }
}

impl fmt::Display for Sign {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Plus => "+",
            Self::Minus => "-",
        })
    }
}
