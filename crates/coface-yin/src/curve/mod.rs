//! Piecewise polynomial curves.

pub(crate) mod bernstein;
mod block_tridiagonal;
mod carrier;
mod distance;
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
pub(crate) mod roots;
mod separators;

pub use carrier::Carrier;
pub(crate) use carrier::on_grid;
pub(crate) use distance::{distance_to, nearest_on};
pub use end_condition::EndCondition;
pub(crate) use evaluation::is_one_velocity;
pub(crate) use extent::monotone_breaks;
pub use location::Location;
pub(crate) use location::piece_crossings;
pub(crate) use measures::{gauss_legendre, length_between};
pub use order::Order;
pub use piecewise::Curve;
pub(crate) use piecewise::{checked_chord_lengths, chord_lengths, distance};
