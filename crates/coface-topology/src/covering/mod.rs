//! Universal covering spaces of surfaces: finite parts of any size, and pictures of them.
//!
//! # Words and conventions
//! * The universal cover of a component is made of **copies** of its [`crate::curves::FundamentalDomain`], one for each
//!   element of the fundamental group. Across a side with the crossing g, copy x meets copy x g.
//! * **Letters** are the crossings of certain cut edges; they generate the group, and copies are counted and ordered by
//!   their shortest words in them. A patch of copies in this order is a disk when the group is infinite.
//! * The group acts from the left: the **deck transformation** of g takes copy x to copy g x and keeps all sources.
//! * A [`CoverLayout`] is a picture in the plane or in the hyperbolic disk, in which deck transformations are
//!   isometries.
//! * Elements of the group are compared by the normal forms of a [`crate::groups::SurfaceGroup`], never by coordinates.

mod domain;
mod flat;
mod hyperbolic;
mod isometry;
mod layout;
#[cfg(test)]
mod layout_tests;
mod springs;
#[cfg(test)]
mod tests;
mod universal_cover;

pub use layout::{CoverLayout, CoverPlane};
pub use universal_cover::{CoverExtent, UniversalCover};
