//! Exact decisions about points in the plane and in space.
//!
//! # Words and conventions
//! * Coordinates are binary fractions, taken at their exact values. A **line** is given by two different points on it and is
//!   directed from the first to the second; a **segment** is the part between them.
//! * A [`PlanarPoint`] is a point that is given, or the crossing of two lines, which is never computed: decisions about it are
//!   signs of polynomials in the coordinates of the lines' ends.
//! * A **plane** is given by three points $a, b, c$ of space that are not on one line; its **normal** is
//!   $(b - a) \times (c - a)$. A [`SpatialPoint`] is a point that is given, or the place where a line and a plane, three planes or
//!   two lines meet, which is never computed either.
//! * A sign is an [`Ordering`](std::cmp::Ordering) of a determinant with zero: `Greater` is to the left or counterclockwise,
//!   `Less` to the right or clockwise, `Equal` on the line. In space `Greater` is where the normal points, from where the triangle
//!   $a b c$ is seen to run counterclockwise.
//!
//! Each decision is made in floating point with a bound on the error, then in twice that precision, and by integers where that
//! leaves it open: in space first by short ones, then by those of any size. Numbers so large or small that products leave the range
//! go to the integers at once.

mod arithmetic;
mod common_line;
mod double_double;
mod dyadic;
mod estimate;
mod orientation;
mod planar_point;
mod plane_filter;
#[cfg(test)]
mod samples;
mod short_dyadic;
mod spatial_planes;
mod spatial_point;
mod spatial_quotient;
mod spatial_signs;
#[cfg(test)]
mod spatial_tests;

#[doc(hidden)]
pub use dyadic::Dyadic;
pub use orientation::{direction_turn, orientation};
pub use planar_point::HomogeneousPoint;
pub use planar_point::PlanarPoint;
#[doc(hidden)]
pub use planar_point::approximate_area;
pub use plane_filter::PlaneFilter;
pub use spatial_planes::{are_coplanar, direction_side, normals_turn, plane_axis, spatial_orientation};
pub use spatial_point::SpatialPoint;
pub use spatial_signs::{normal_sign, orientation_of_points};

/// A directed line through two different points, or the segment between them.
pub type PlanarLine = [[f64; 2]; 2];

/// A directed line in space through two different points, or the segment between them.
pub type SpatialLine = [[f64; 3]; 2];

/// A plane through three points $a, b, c$ that are not on one line; its normal is $(b - a) \times (c - a)$.
pub type SpatialPlane = [[f64; 3]; 3];
