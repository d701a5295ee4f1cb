//! Groups of surfaces: free groups and groups of closed surfaces, with normal forms of their elements.
//!
//! # Words and conventions
//! * A **polygon scheme** is a word in which each generator occurs exactly twice, with either sign: the sides of a
//!   polygon in order, equal letters glued, +i along and -i against generator i. Its surface has one face, an edge
//!   for each generator and, if all corners of the polygon come together, one vertex. Then the edges are loops, and
//!   the word is the one relator of the fundamental group.
//! * A [`SurfaceGroup`] is given by such a scheme or, for a surface with boundary, by no relator at all: a free group.
//! * The [`NormalForm`] of a word is its element of the group: two words are equal there if and only if their normal
//!   forms are. [`ConjugacyForm`]s do the same for free homotopy of closed curves.
//! * Lengths of elements are counted in letters, so the **sphere** of radius r is all elements whose shortest words
//!   have r letters. [`SurfaceGroup::sphere_sizes`] counts them by formula, [`Ball`] lists them.
//! * A [`CanonicalSystem`] has generators whose relator is a product of commutators or of squares.
//!
//! # Source
//! F. Lazarus, J. Rivaud, *On the homotopy test on surfaces* (2012); J. Erickson, K. Whittlesey, *Transforming curves
//! on surfaces redux* (2013).

mod ball;
mod canonical_system;
mod conjugacy;
mod dehn;
mod group;
mod growth;
mod klein_bottle;
mod normal_form;
mod polygon_scheme;
mod quad_system;
#[cfg(test)]
mod tests;
mod walk;

pub use ball::Ball;
pub use canonical_system::CanonicalSystem;
pub use conjugacy::ConjugacyForm;
pub use group::SurfaceGroup;
pub use normal_form::NormalForm;
