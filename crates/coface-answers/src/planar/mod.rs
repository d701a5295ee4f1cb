//! Drawings arranged in the plane, and Boolean combinations of the regions in them.
//!
//! # Words
//! * A [`PlanarDrawing`] is what several models draw: **segments**, each of one model, and **rings** of segments that bound
//!   **polygons**. A **region** is the union of the polygons of a model, or of a named part of it.
//! * A [`DrawingArrangement`] is the complex that all segments cut the plane into, with the models whose regions contain each face.
//! * A [`RegionBoolean`] is the set of faces that a formula of regions selects, as polygons with holes.
//!
//! Features of maps have properties. A face of an arrangement has those of all features that contain it, a polygon of
//! a combination those of all features that contain some of it:
//! [`MergedProperties`](coface_io::geojson::MergedProperties) says what becomes of different values.
//!
//! Lines of maps (WKT, WKB, GeoJSON) bound nothing, closed or not, unless closed ones are to be rings
//! ([`DrawingOptions::close_lines`]). Faces of a chain complex with positions are polygons, which together are a region. Another model without polygons, such as a file of segments, whose lines end nowhere (an even number of them at every
//! point) is a region: what its lines enclose an odd number of times, whatever the rule is.

mod arrangement;
mod attributes;
mod boolean;
mod canonical;
mod certificate;
mod chain_faces;
mod containment;
mod crossings;
mod crowd;
mod dissolve;
mod drawing;
mod drawing_options;
mod exact;
mod feature_model;
mod fill_rules;
mod heights;
mod maps;
mod outcome;
mod outline;
mod properties;
mod settling;
mod sides;
mod walks;
mod writing;

pub use arrangement::{ArrangementMethod, ArrangementRequest, DrawingArrangement};
pub use attributes::FaceAttributes;
pub use boolean::{BooleanRequest, RegionBoolean};
pub use dissolve::{DissolveRequest, Dissolved};
pub use drawing::{PlanarDrawing, are_planar, is_planar};
pub use drawing_options::DrawingOptions;
pub use maps::{
    BufferCaps, BufferJoins, BufferOptions, LineOptions, MapResult, MapTask, RepairMethod,
    polygons_of_fill_rules,
};
pub use writing::reference_loss;
