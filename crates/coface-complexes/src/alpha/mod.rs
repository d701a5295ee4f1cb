//! Alpha complexes: the simplices of a Delaunay triangulation with the squared radii at which they enter.
//!
//! [`AlphaComplex`] is made of points; [`PeriodicAlphaComplex`] of points that repeat along the axes, as atoms of a crystal or particles of a simulation
//! in a box whose sides are glued do.

mod complex;
mod copies;
mod periodic;
mod periodic_box;

pub use complex::AlphaComplex;
pub use periodic::PeriodicAlphaComplex;
pub use periodic_box::PeriodicBox;
