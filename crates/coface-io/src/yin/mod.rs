//! Boundaries of Yin sets: our JSON, the binary `.dat`, and the rings of drawings.
//!
//! # Words
//! * A [`BoundaryDrawing`] is what a file says about a boundary, not yet checked: closed curves of one order, in groups, and for each
//!   group the [`Filling`] that says what is inside.
//! * A [`BoundaryCurve`] has points, which are its knots, and what is known of it beside them: kinks, a name, the parameters of the
//!   knots, and the control points if it is not the curve that is fitted to its points.
//!
//! # Our JSON
//! `{"order": 2|4|6|8, "curves": [{"points": [[x, y], ..], ..}, ..]}`: closed curves, the first point not repeated, the set on their left;
//! points that repeat the one before count once, with a remark.
//! `{"plane": true}` is the whole plane and `{"curves": []}` the empty set; the order is 2 if it is not said. A curve may also have
//! * `"kinks": [i, ..]`: the points that need not be smooth, none twice, and `"vertices": [v, ..]`: their names, as many; without
//!   names kinks are numbered in their order; `"next_vertex"` beside the curves is the first name that was never used;
//! * `"name"`: any text;
//! * `"knots": [t, ..]`: the parameters of the points and, as the last, of the first point again; they are the lengths of the way along
//!   the chords if they are not said;
//! * `"controls": [[x, y], ..]`: for each piece its Bernstein control points without the last, which is the first of the next piece. Without
//!   them the curve is fitted to its points: a polyline in order 2, else splines between kinks, periodic if there are none, with
//!   ends that are not-a-knot;
//! * `"carriers": [{"piece": i, "range": [s, t], "growth": g, "controls": [[x, y], ..]}, ..]`: pieces that are parts of others, as Boolean
//!   operations leave them: piece i is the whole piece with these control points from parameter s to t, and g is how much the parameter
//!   grows along all of that. Parts of one whole are so known to share their arc, whatever was rounded. Carriers that do not fit their
//!   pieces are left out, with a remark.
//!
//! # The binary `.dat`
//! Little endian: the number of curves (32 bits); for each curve its dimension, which is 2, its order and the number n of its pieces (32 bits
//! each), n + 1 parameters of knots (64 bits each), and for each piece the coefficients of the first coordinate, then of the second,
//! the constant first, in the parameter from the knot on. It holds neither kinks nor names nor the whole plane.
//!
//! # Curves as text
//! Circles, rectangles and lists of points by their numbers, a line each: see [`read_factories`]. They are only read.

mod boundary;
mod dat;
mod factories;
mod flattening;
mod json;
mod rings;
#[cfg(test)]
mod tests;

pub(crate) use boundary::model_of_drawing;
pub use boundary::{BoundaryCurve, BoundaryDrawing, Filling};
pub(crate) use dat::is_dat;
pub use dat::{read_dat, write_dat};
pub(crate) use factories::is_factories;
pub use factories::read_factories;
pub use flattening::flattened;
pub(crate) use flattening::{NO_BOUNDS, check_tolerance, default_tolerance, flattening_remark};
pub use json::write_json;
pub use rings::drawing_of_model;
