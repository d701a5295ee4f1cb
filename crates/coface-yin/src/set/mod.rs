//! Yin sets and the curves that bound them.

mod atoms;
mod canonical;
mod comparison;
mod construction;
mod curvature;
mod curve_arena;
mod fault;
mod gaps;
mod hasse_forest;
mod jordan_curve;
mod location;
mod measures;
mod motions;
mod nearest;
mod samples;
mod yin_set;

pub use atoms::{Atom, AtomKind};
pub(crate) use canonical::CanonicalOrder;
pub use comparison::Comparison;
pub(crate) use construction::{Lying, lying};
pub use curvature::{CurveBend, CurvePlace};
pub(crate) use curvature::{extreme_curvatures, is_more, turn_at};
pub(crate) use curve_arena::CurveArena;
pub use fault::YinFault;
pub use hasse_forest::HasseForest;
pub use jordan_curve::JordanCurve;
pub use location::SetLocation;
pub(crate) use location::parameter;
pub use nearest::NearestPoint;
pub(crate) use samples::samples_along;
pub use samples::{Sample, Sampling};
pub use yin_set::YinSet;
