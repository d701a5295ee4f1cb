//! Coordinates, beside topology and never inside it.
//!
//! [`Positions`] holds the points of one model, in the unit of its file, in any dimension.

mod positions;

pub use positions::Positions;
