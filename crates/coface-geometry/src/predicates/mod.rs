//! Exact decisions about points in the plane and in space.
//!
//! # Words and conventions
//! * Coordinates are binary fractions, taken at their exact values. A **line** is given by two different points on it
//!   and is directed from the first to the second; a **segment** is the part between them.
//! * A [`PlanarPoint`] is a given point, or the crossing of two lines. The coordinates of a crossing are never
//!   computed: decisions about it are signs of polynomials in the coordinates of the ends of the lines.
//! * A **plane** is given by three points $a, b, c$ of space that are not on one line; its **normal** is
//!   $(b - a) \times (c - a)$. A [`SpatialPoint`] is a given point, or the intersection of a line and a plane, of three
//!   planes or of two lines; its coordinates are never computed either.
//! * A sign is the [`Ordering`](std::cmp::Ordering) of a determinant and zero: `Greater` is to the left or
//!   counterclockwise, `Less` is to the right or clockwise, `Equal` is on the line. In space `Greater` is the side to
//!   which the normal points; from there the triangle $a b c$ runs counterclockwise.
//!
//! # Algorithm
//! Each decision is made in floating point with a bound on the error, then in twice that precision, and, if the sign is
//! still open, by exact integers: in space first by integers of up to 1024 bits, then by integers of any size. Numbers
//! that are so large or small that products overflow or underflow go to the integers at once.
//!
//! # Examples
//! ```
//! use coface_geometry::predicates::orientation;
//! assert!(orientation([0.0, 0.0], [1.0, 0.0], [5.0, 1e-300]).is_gt());
//! ```

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
mod smallest_sphere;
mod spatial_planes;
mod spatial_point;
mod spatial_quotient;
mod spatial_signs;
#[cfg(test)]
mod spatial_tests;
mod sphere;
#[cfg(test)]
mod sphere_tests;
mod weighted_point;

#[doc(hidden)]
pub use dyadic::Dyadic;
pub use orientation::{direction_turn, orientation};
pub use planar_point::HomogeneousPoint;
pub use planar_point::PlanarPoint;
#[doc(hidden)]
pub use planar_point::approximate_area;
pub use plane_filter::PlaneFilter;
pub use smallest_sphere::{smallest_sphere, smallest_sphere_side};
pub use spatial_planes::{are_coplanar, direction_side, normals_turn, plane_axis, spatial_orientation};
pub use spatial_point::{PointDefinition, SpatialPoint};
pub use spatial_signs::{normal_sign, orientation_of_points};
pub use sphere::{circle_side, sphere_side};
pub(crate) use sphere::{ordinary_circle_side, ordinary_sphere_side};
pub use weighted_point::WeightedPoint;

/// A directed line through two different points, or the segment between them.
pub type PlanarLine = [[f64; 2]; 2];

/// A directed line in space through two different points, or the segment between them.
pub type SpatialLine = [[f64; 3]; 2];

/// A plane through three points $a, b, c$ that are not on one line; its normal is $(b - a) \times (c - a)$.
pub type SpatialPlane = [[f64; 3]; 3];
