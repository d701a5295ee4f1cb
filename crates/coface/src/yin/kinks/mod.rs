//! Kinks: the knots at which a boundary need not be smooth.

mod table;

pub use table::{Kinks, KnotIndex};
