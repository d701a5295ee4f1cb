//! Scenes: what a picture shows of a model and of answers about it.
//!
//! # Words and conventions
//! * A **scene** has the cells of a model with their positions, what is shaded of it as triangles, and **layers** that can be shown or
//!   not: generators, seams, boundary loops, witnesses. A **pane** is a flat picture beside it, such as a persistence diagram.
//! * The **rims** of a polygon are walks around it beyond the first: around its holes. A **note** is what is known of a top cell.
//! * Cells are named by vertices as everywhere in results, so an answer that was written as JSON becomes layers without the
//!   computation that it came from.
//! * Positions in the page have 32 bits; the middle of the model is taken away before, so that coordinates far from zero keep their
//!   digits.

mod boundary;
mod cochains;
mod cover;
mod document;
mod domain;
mod forest;
mod geodesics;
mod hidden;
mod interfaces;
mod labels;
mod layers;
mod layout;
mod members;
mod model;
mod neighborhood;
mod numbering;
mod parts;
mod persistence;
mod pixels;
mod reading;
mod regions;
mod results;
mod sets;
mod shading;
mod shown;

pub use document::{
    LabelDocument, LayerDocument, PackedLists, PackedTriangles, PaneDocument, SceneDocument, SceneReport,
};
pub use layers::{Layer, Pane};
pub use model::Scene;
