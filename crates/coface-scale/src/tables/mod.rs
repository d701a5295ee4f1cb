//! Tables of rows in files.
//!
//! A row is one [`Cell`] a column. A [`TableWriter`] takes rows one after the other, and keeps none of them but those of a block of
//! Parquet; the columns with their [`Kind`]s are known before the first row.

mod cell;
mod csv;
mod format;
mod parquet;
mod writer;

pub(crate) use cell::Cell;
pub use csv::csv_field;
pub use format::TableFormat;
pub(crate) use writer::{Column, Kind, TableWriter};
