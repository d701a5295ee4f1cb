//! Exact decisions about points in the plane.
//!
//! # Words and conventions
//! * Coordinates are binary fractions, taken at their exact values. A **line** is given by two different points on it and is
//!   directed from the first to the second; a **segment** is the part between them.
//! * A [`PlanarPoint`] is a point that is given, or the crossing of two lines, which is never computed: decisions about it are
//!   signs of polynomials in the coordinates of the lines' ends.
//! * A sign is an [`Ordering`](std::cmp::Ordering) of a determinant with zero: `Greater` is to the left or counterclockwise,
//!   `Less` to the right or clockwise, `Equal` on the line.
//!
//! Each decision is made in floating point with a bound on the error, then in twice that precision, and by integers of any
//! size where that leaves it open. Numbers so large or small that products leave the range go to the integers at once.

mod double_double;
mod dyadic;
mod orientation;
mod planar_point;
#[cfg(test)]
mod samples;

pub(crate) use dyadic::Dyadic;
pub use orientation::{direction_turn, orientation};
pub use planar_point::PlanarPoint;
pub(crate) use planar_point::{HomogeneousPoint, approximate_area};

/// A directed line through two different points, or the segment between them.
pub type PlanarLine = [[f64; 2]; 2];
