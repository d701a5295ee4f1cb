//! Where the pieces of curves meet, with guarantees.
//!
//! # Words and conventions
//! * All coordinates are taken in a **frame**: moved and scaled by a power of two so that everything is in a box of side one. The
//!   **resolution** is 2^-40 times the largest extent of that box, or 2^-48 times the largest coordinate if that is more. What is farther apart than the resolution is told apart for
//!   certain: by hulls of control points that are separated, and by roots whose existence and uniqueness are proven. What is not is
//!   one point, or one arc, and says that it is not certified.
//! * A curved piece and a segment that touch, in general position, are proven to: exact arithmetic counts their common points. It also
//!   tells whether they pass each other or cross twice where they come nearer than the resolution, down to 2^-45 of the extent; below
//!   that they are one point, as rounding of results is of that size. Two cubic pieces that touch in a common
//!   end are proven to have nothing else in common there, and so are two that touch where both parameters are fractions with
//!   denominators up to 4096; a piece that is a part of another between such parameters is proven to be. Other curved pieces that touch
//!   are not proven to: that they are within the resolution of each other is certain, and the report names the place.
//!   At a finer resolution, which is taken where the usual one leaves something open, exact arithmetic finds where two cubic pieces
//!   cross that run side by side, and that they do not, as far as rounding of results cannot change it.
//! * A **part** of a piece is monotone in both coordinates. A piece that is a segment is one part, and segments meet each other
//!   exactly.
//! * A **meeting** is a common point of two pieces, or of a piece with itself at two parameters. An **overlap** is an arc that two
//!   pieces have in common. The point that two neighbors share is neither.
//! * Pieces of several arenas are numbered one after the other. Meetings are found between their [`Carriers`], and handed to the
//!   pieces that are there: so parts of one piece have in common what their ranges have in common.
//!
//! # References
//! T. W. Sederberg and T. Nishita, *Curve intersection using Bezier clipping*, Computer-Aided Design 22 (1990); R. Krawczyk,
//! *Newton-Algorithmen zur Bestimmung von Nullstellen mit Fehlerschranken*, Computing 4 (1969).

mod arc_tree;
mod carriers;
mod common_end;
mod contacts;
mod cubic_pair;
mod distribution;
mod frame;
mod isolation;
mod line_contact;
mod meeting;
mod overlaps;
mod parts;
mod piece_pair;
mod polynomial;
mod refinement;
mod roots;
mod search;
mod segments;
mod side_by_side;
mod simple_fractions;
mod strip;
mod sturm;
#[cfg(test)]
mod tests;

pub(crate) use arc_tree::ArcTree;
pub(crate) use carriers::Carriers;
use frame::Frame;
pub(crate) use frame::resolution;
pub(crate) use meeting::{Meeting, Overlap};
use parts::Pieces;
use polynomial::Polynomial;
pub(crate) use search::Meetings;
