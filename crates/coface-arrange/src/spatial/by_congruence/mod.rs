//! Arrangements of polygons by congruence: each face is cut in its own plane, and what was made apart is brought
//! together.
//!
//! # Words and conventions
//! * A **sheet** is one polygon in its own plane with the traces of the others, as a planar arrangement of its own.
//! * The sheets side by side are one chain complex with block-diagonal matrices; its quotient by congruence is the
//!   arrangement.
//! * Numbers are rounded, and a tolerance decides what coincides: this is the second method, for comparison and for
//!   polygons that meet only nearly. The exact one knows no tolerance.

mod arrangement;
mod cells;
mod sheet;

pub use arrangement::{CongruenceArrangement, arrange_by_congruence};
