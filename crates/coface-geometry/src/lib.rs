//! Positions of vertices, exact predicates, triangulation of polygons, box trees and moments.
//!
//! Coordinates stand beside topology, never inside it: a complex knows its vertices by number, and [`Positions`] holds
//! the point of each number.
//!
//! # Map
//! * [`Positions`]: the points of one model, in any dimension. An [`AffineMap`] moves points; an [`Angle`] is exact at
//!   quarter turns.
//! * [`predicates`]: exact decisions about points: orientation, side of a line or plane, order of crossings that are
//!   never computed.
//! * [`triangulation`]: triangles of a polygon with holes, by exact predicates alone.
//! * A [`RegularTriangulation`]: the Delaunay triangulation of points, also with weights, exact.
//! * Measures: [`polygon_area`], [`enclosed_volume`]; the integrals of monomials are [`surface_moment`] and
//!   [`enclosed_moment`]; [`MassProperties`] are volume, center and inertia tensor of a solid of density 1.
//! * Boxes: a [`BoxTree`] finds the boxes that meet a given box.
//!
//! # Conventions
//! * Lengths are in the unit of the input, areas in its square, volumes in its cube; angles are in turns, degrees or
//!   radians, as the constructor of [`Angle`] says.
//! * A predicate returns an [`Ordering`](std::cmp::Ordering): `Greater` is to the left of a line, counterclockwise, or
//!   on the side of the normal of a plane.
//! * Predicates are exact for all finite coordinates; measures are rounded, with the same rounding for any number of
//!   threads.
//!
//! # Examples
//! A unit square: its area, and the side of its diagonal on which a corner lies.
//! ```
//! use coface_algebra::RaggedArray;
//! use coface_geometry::predicates::orientation;
//! use coface_geometry::{Positions, polygon_area};
//! # fn main() -> Result<(), coface_algebra::Error> {
//! let corners = Positions::from_flat(2, vec![0., 0., 1., 0., 1., 1., 0., 1.])?;
//! assert_eq!(polygon_area(&corners, &RaggedArray::from_lists([[0, 1, 2, 3]])), Some(1.0));
//! // The corner (0, 1) lies to the left of the diagonal from (0, 0) to (1, 1).
//! assert!(orientation([0., 0.], [1., 1.], [0., 1.]).is_gt());
//! # Ok(()) }
//! ```
//!
#![doc = include_str!("../README.md")]
#![warn(clippy::cast_possible_truncation, clippy::iter_over_hash_type, missing_debug_implementations)]
#![cfg_attr(test, allow(clippy::cast_possible_truncation, reason = "the numbers of tests are small"))]

mod affine;
mod angle;
mod box_tree;
mod delaunay;
mod measure;
mod moments;
mod pair_tree;
mod partial_positions;
mod positions;
pub mod predicates;
pub mod triangulation;

pub use affine::AffineMap;
pub use angle::Angle;
pub use box_tree::{AxisBox, BoxTree, boxes_meet, frame_around};
pub use delaunay::RegularTriangulation;
#[doc(hidden)]
pub use measure::{Scaled, Sum, distance};
pub use measure::{cross, determinant, dot, enclosed_volume, polygon_area};
pub use moments::{MassProperties, enclosed_moment, surface_centroid, surface_moment};
#[doc(hidden)]
pub use pair_tree::{Bounds, PairNode, PairTask, PairTree, hilbert};
pub use partial_positions::PartialPositions;
pub use positions::Positions;
