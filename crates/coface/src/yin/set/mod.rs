//! Yin sets and the curves that bound them.

mod curve_arena;
mod hasse_forest;
mod yin_set;

pub(in crate::yin) use curve_arena::CurveArena;
pub use hasse_forest::HasseForest;
pub use yin_set::YinSet;
