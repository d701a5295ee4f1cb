//! Sparse integer matrices in compressed columns, their products, and lists of lists in one flat array.
//!
//! # Words and conventions
//! * Column j of a [`SparseMatrix`] is a list of (row, entry) pairs with strictly rising rows; no entry is zero. So
//!   equal matrices have equal parts.
//! * Entries have 32 bits. A [`WideMatrix`] has [`Integer`](crate::Integer) entries, as products and normal forms need
//!   them; an [`IntegerMatrix`] is the smaller of both kinds that suffices.
//! * A [`SparseVector`] is a list of (position, entry) pairs with strictly rising positions and without zeros.
//! * A [`RaggedArray`] is a list of lists of 32-bit numbers. Lists of one common length, such as triangles, need no
//!   starts.

mod entry;
mod integer_matrix;
mod matrix_arithmetic;
mod product;
mod ragged;
mod sparse_matrix;
pub(crate) mod sparse_vector;

pub use entry::Entry;
pub use integer_matrix::IntegerMatrix;
#[doc(hidden)]
pub use product::ColumnBlock;
pub use product::joined_columns;
pub use ragged::RaggedArray;
pub use sparse_matrix::{Column, SparseMatrix, WideMatrix};
pub use sparse_vector::SparseVector;
#[doc(hidden)]
pub use sparse_vector::combination;
pub use sparse_vector::{inner_product, linear_combination};
