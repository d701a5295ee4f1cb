//! Kinks: the knots at which a boundary need not be smooth.
//!
//! * Between a kink and the next one along a curve lies a **smooth piece**: one spline through the knots there. A curve without kinks
//!   is one periodic spline, a curve with one kink one spline from it round to it.
//! * Knots never move when kinks come and go, and parameters stay; only the polynomials of the smooth pieces beside the changed kink
//!   do. What the polynomials of a smooth piece are depends on its two ends alone, not on the order of the changes: they are the fit
//!   of its knots, or what they were when the set was made.
//! * At order 2 kinks are names of knots and change no polynomial.

mod apart_curves;
mod apartness;
mod declaration;
mod detection;
mod edits;
mod fitting;
mod nearest;
mod piece_boxes;
mod smooth_pieces;
mod table;

pub(crate) use apart_curves::are_surely_apart;
pub(crate) use detection::turning_at;
pub use detection::turning_kinks;
pub(crate) use smooth_pieces::SmoothPieces;
pub use table::{Kinks, KnotIndex};
