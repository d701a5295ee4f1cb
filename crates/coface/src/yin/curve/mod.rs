//! Piecewise polynomial curves.

pub(in crate::yin) mod bernstein;
mod block_tridiagonal;
mod end_condition;
mod evaluation;
mod extent;
mod factories;
mod fit;
mod fit_by_length;
mod hermite;
mod location;
mod measures;
mod motions;
mod order;
mod parts;
mod piecewise;
mod power;
pub(in crate::yin) mod roots;
mod separators;

pub use end_condition::EndCondition;
pub(in crate::yin) use extent::monotone_breaks;
pub(in crate::yin) use fit::checked_chord_lengths;
pub use location::Location;
pub(in crate::yin) use location::piece_crossings;
pub(in crate::yin) use measures::gauss_legendre;
pub use order::Order;
pub use piecewise::Curve;
pub(in crate::yin) use piecewise::{chord_lengths, distance};
