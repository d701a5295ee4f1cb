//! Products of sparse integer matrices by SuiteSparse:GraphBLAS, a C library.
//!
//! A [`Matrix`] is made from compressed columns or from triples, multiplied over plus and times, and read back as compressed
//! [`Columns`]. Entries are 32 bits wide at both ends and 64 bits wide in between; a product that could leave 64 bits is
//! refused before it is computed, so no sum wraps.
//!
//! The library has to be installed (Debian: `libgraphblas-dev`, version 7 or newer) where a program with this crate is
//! linked; checking and documenting need nothing. It is started once, at the first matrix, and runs until the program ends.
//!
//! # References
//! B. Brock, A. Buluç, R. Kimmerer, J. Kitchen, M. Kumar, T. Mattson, S. McMillan, J. Moreira, M. Pelletier, E. Welch, *The
//! GraphBLAS C API specification, version 2.0* (2021). T. A. Davis, *Algorithm 1000: SuiteSparse:GraphBLAS* (2019).

mod error;
mod ffi;
mod matrix;

pub use error::Error;
pub use matrix::{Columns, Matrix};
