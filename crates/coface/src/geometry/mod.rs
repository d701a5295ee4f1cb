//! Coordinates, beside topology and never inside it.
//!
//! [`Positions`] holds the points of one model, in the unit of its file, in any dimension;
//! [`polygon_area`] and [`enclosed_volume`] measure polygons on them.

mod measure;
mod positions;

pub(crate) use measure::{Scaled, Sum};
pub use measure::{enclosed_volume, polygon_area};
pub use positions::Positions;
