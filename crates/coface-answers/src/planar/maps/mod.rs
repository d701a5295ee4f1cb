//! Maps changed feature by feature: repaired, buffered, clipped, simplified; lines cut at their meetings; coverages checked.
//!
//! # Words
//! * A **feature** has polygons with holes, lines and points, and keeps its properties and its id.
//! * A **coverage** is a map whose polygons do not overlap and have their common borders vertex by vertex.
//! * A polygon is repaired by its **structure** (outer rings minus holes) or by its **linework** (what its rings cut the plane into).
//!
//! A [`MapTask`] says what is done, a [`MapResult`] is the new map with what was done in numbers. What need not change is kept as it
//! is, coordinate by coordinate; what is cut is cut exactly and rounded so that it is valid.

mod borders;
mod buffer;
mod clip;
mod coverage;
mod filled_polygons;
mod layer;
mod lines;
mod linework;
mod map_builder;
mod repair;
mod result;
mod simplify;
mod task;
#[cfg(test)]
mod tests;

pub use filled_polygons::polygons_of_fill_rules;
pub use result::MapResult;
pub use task::{BufferCaps, BufferJoins, BufferOptions, LineOptions, MapTask, RepairMethod};
