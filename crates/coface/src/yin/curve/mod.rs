//! Piecewise polynomial curves.

mod order;
mod piecewise;

pub use order::Order;
pub use piecewise::Curve;
pub(in crate::yin) use piecewise::chord_lengths;
