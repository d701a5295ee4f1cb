//! Many inputs and large inputs: complexes in files, worker processes, and reports over many files.
//!
//! * [`shards`] cuts a complex that is larger than memory into files, reduces these one by one and merges what is left.
//! * [`workers`] runs requests in processes with limits of time and memory.
//! * [`batch`] makes the report on many files by such workers.
//! * [`signatures`] makes a table of a list of isomorphism signatures, line by line.
//!
#![doc = include_str!("../README.md")]

pub mod batch;
pub mod shards;
pub mod signatures;
mod tables;
pub use tables::csv_field;
pub mod workers;
