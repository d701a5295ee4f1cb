//! Piecewise polynomial curves.

pub(in crate::yin) mod bernstein;
mod order;
mod piecewise;

pub use order::Order;
pub use piecewise::Curve;
pub(in crate::yin) use piecewise::{chord_lengths, distance};
