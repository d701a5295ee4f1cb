//! Exact algebra for topology: integers, sparse matrices, normal forms and chain complexes.
//!
//! This is the lowest crate of coface. It knows cells by their numbers only: no coordinates and no files. The crates
//! above make [chain complexes](chains::ChainComplex) from meshes, simplices or cubes, and ask questions about them.
//!
//! # Map
//! * Integers: an [`Integer`] uses 64 bits as long as they suffice, and a big integer beyond; no sum or product
//!   overflows. A [`Rational`] is a fraction in lowest terms, a [`Residue`] is an integer modulo n.
//! * Matrices: a [`SparseMatrix`] holds its columns one after the other. Its entries have 32 bits; a [`WideMatrix`] has
//!   entries of any size. Sums and products give an [`IntegerMatrix`], which is the smaller of the two that suffices. A
//!   [`RaggedArray`] is a list of lists in one flat array: polygons, facets, orbits.
//! * Normal forms: the [`SmithForm`] of a matrix is diagonal, and each entry divides the next; [`SmithTransforms`] are
//!   the unimodular matrices that produce it. A [`SymmetricForm`] or [`SkewForm`] is a bilinear form on a lattice, with
//!   the invariants that do not depend on the basis.
//! * Combinatorics: a [`Permutation`] moves i to `image(i)`; a [`Word`] is a freely reduced element of a free group; a
//!   [`UnionFind`] keeps a partition of `0..n`, and a [`ParityUnionFind`] also a [`Sign`] between the members of a
//!   class.
//! * [`chains`]: [`ChainComplex`](chains::ChainComplex), chains and cochains, chain maps, and the reduction of a
//!   complex by acyclic matchings.
//! * [`progress`]: progress and cancellation of long computations.
//! * Ids: [`VertexId`], [`EdgeId`], [`HalfedgeId`], [`FaceId`] and [`CellId`] are positions in the list of all cells of
//!   one kind; an [`IdVec`] is a vector that one kind of id indexes.
//! * Errors: every fallible function returns an [`Error`] with an [`ErrorKind`] and, where cells or numbers are at
//!   fault, a typed [`Fault`]. [`escaped`] is for names in messages.
//!
//! # Conventions
//! * Column j of the boundary matrix of degree k is the boundary of the k-cell j, a combination of (k-1)-cells.
//! * `p.then(&q)` applies p first. Numbers of cells start at 0.
//! * Results are exact and deterministic: they do not depend on the number of threads.
//!
//! # Examples
//! The boundary of a triangle is a circle: its first homology is free of rank 1, the nullity of the boundary matrix.
//! ```
//! use coface_algebra::chains::ChainComplex;
//! use coface_algebra::{SparseMatrix, smith_form};
//! # fn main() -> Result<(), coface_algebra::Error> {
//! // The edges 01, 12 and 02 on the vertices 0, 1 and 2.
//! let entries = [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)];
//! let circle = ChainComplex::new(vec![SparseMatrix::from_entries(3, 3, entries)?])?;
//! let boundary = circle.boundary_matrix(1).expect("there are edges");
//! assert_eq!(smith_form(boundary).nullity(), 1);
//! assert_eq!(circle.euler_characteristic(), 0);
//! # Ok(()) }
//! ```
//!
#![doc = include_str!("../README.md")]
#![warn(clippy::cast_possible_truncation, clippy::iter_over_hash_type, missing_debug_implementations)]
#![cfg_attr(test, allow(clippy::cast_possible_truncation, reason = "the numbers of tests are small"))]

pub mod chains;
mod combinatorics;
mod error;
mod escapes;
mod ids;
mod integers;
mod matrices;
pub mod memory;
mod normal_forms;
pub mod progress;
#[cfg(any(test, feature = "samples"))]
#[doc(hidden)]
pub mod samples;
mod spread;
#[doc(hidden)]
pub mod threads;

pub use error::{Error, ErrorKind, Fault};
pub use escapes::escaped;
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
pub use ids::narrow;
#[doc(hidden)]
pub use integers::{Binary, Field, Odd, is_prime, large_primes};
#[doc(hidden)]
pub use matrices::{ColumnBlock, combination, inner_product, joined_columns, linear_combination};
#[doc(hidden)]
pub use spread::{SpreadHasher, SpreadMap};
