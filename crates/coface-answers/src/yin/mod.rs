//! Yin sets from files: made, told about, written and drawn.
//!
//! # Words
//! * A [`PlanarSet`] is a Yin set with the names of its curves and what had to be said about the file it is from.
//! * A [`SetRequest`] says how a file becomes a set: its order, the rule that repairs what crosses itself, its kinks.
//! * A [`PlanarInterface`] is made of sets that lie side by side, its phases, which share the arcs between them.

mod cells;
mod exact;
mod facts;
mod interface;
mod interface_edits;
mod interface_file;
mod interface_motion;
mod interface_places;
mod labels;
mod making;
mod motion;
mod places;
mod svg;
mod validity;
mod writing;

pub use cells::CutCellsRequest;
pub use interface::{NamedSet, PlanarInterface};
pub use interface_edits::InterfaceKinksRequest;
pub use interface_motion::InterfaceMotion;
pub use labels::LabelImage;
pub use making::{KinkRequest, PlanarSet, SetRequest};
#[doc(hidden)]
pub use motion::below_knots as contact_below_knots;
pub use motion::{MotionRequest, PlanarMotion};
#[doc(hidden)]
pub use svg::{Piece as SetPiece, pieces_of as set_pieces};
