//! Sparse integer matrices in compressed columns, their products, and lists of lists in one flat array.

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
