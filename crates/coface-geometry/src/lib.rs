//! Coordinates, beside topology and never inside it.
//!
//! [`Positions`] holds the points of one model, in the unit of its file, in any dimension;
//! [`polygon_area`] and [`enclosed_volume`] measure polygons on them, [`surface_moment`] and [`enclosed_moment`] integrate
//! monomials, and [`MassProperties`] are what a solid of density 1 has. [`predicates`] are exact decisions about points, and
//! [`triangulation`] of polygons needs no more than those. An [`AffineMap`] moves points; an [`Angle`] is exact at quarter turns.
//!
#![doc = include_str!("../README.md")]

mod affine;
mod angle;
mod box_tree;
mod measure;
mod moments;
mod positions;
pub mod predicates;
pub mod triangulation;

pub use affine::AffineMap;
pub use angle::Angle;
#[doc(hidden)]
pub use box_tree::boxes_meet;
pub use box_tree::{AxisBox, BoxTree, frame_around};
#[doc(hidden)]
pub use measure::Scaled;
#[doc(hidden)]
pub use measure::Sum;
#[doc(hidden)]
pub use measure::dot;
pub use measure::{cross, determinant};
pub use measure::{enclosed_volume, polygon_area};
pub use moments::{MassProperties, enclosed_moment, surface_centroid, surface_moment};
pub use positions::Positions;
