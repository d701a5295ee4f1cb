//! Doors: one file a format, and [`Model`], what a file can hold.
//!
//! A reader takes bytes and gives a whole [`Model`] or an error that names the line or byte; it never allocates by a
//! count that a file merely claims. Indices in a model are 0-based whatever the format does.

mod blocks;
mod decimal;
mod limits;
mod lists;
mod model;
pub mod obj;
pub mod off;
mod scanner;

pub use model::{Group, GroupKind, Model, Structure};
