//! Arrangements in the plane: the cells that segments cut it into, exactly.
//!
//! # Words and conventions
//! * The **arrangement** of segments has as vertices all given points and all points where segments meet, as edges the
//!   pieces between them, as faces the connected parts of the rest of the plane.
//! * Coordinates are exact; a crossing is known by its two segments, and coordinates are rounded for output only.
//! * [`ExactSegments`] are segments that were cut out of others: pieces of given segments, whose ends are given points or
//!   crossings, so that an arrangement is input again and nothing is rounded.
//! * A **halfedge** has its face on its left; following next around a face gives an **orbit**, a closed walk. Each
//!   component of vertices and edges has one orbit on its outside, and lies in a face of the others: the face has a
//!   **hole**.
//! * A **bridge** has one face on both sides. It stays: the walk around that face runs over it in both directions.

mod areas;
mod arrangement;
mod ball_cells;
mod by_congruence;
mod crossings;
mod edges;
mod exact_ends;
mod exact_segments;
mod face_outline;
mod face_polygons;
mod faces;
mod gift_wrapped_faces;
mod hilbert_order;
mod near_features;
mod nesting;
mod options;
mod oriented_box;
mod overlay;
mod polygon_faults;
mod pruning;
mod regions;
mod rounding;
mod segment_tree;
mod simple_rings;
mod snap_rounding;
mod tour;
mod vertices;
mod windings;

#[doc(hidden)]
pub use areas::walks_area;
pub use arrangement::{PlanarArrangement, VertexSource};
#[doc(hidden)]
pub use ball_cells::exact_turn;
pub use by_congruence::StackedSegments;
pub use exact_ends::ExactPlace;
#[doc(hidden)]
pub use exact_segments::is_between;
pub use exact_segments::{ExactPiece, ExactSegments, ExactVertex};
pub use face_outline::FaceOutline;
pub use faces::Faces;
#[doc(hidden)]
pub use faces::Orbits;
pub use gift_wrapped_faces::gift_wrapped_faces;
pub use options::PlanarOptions;
#[doc(hidden)]
pub use overlay::RingCells;
pub use overlay::{ChainEdges, JordanFault, JordanRings, RingFault};
pub use overlay::{PlanarOverlay, PlanarPolygons, UndecidedRings, UndecidedSelection, are_valid_polygons};
#[doc(hidden)]
pub use overlay::{is_simple_ring, turned_rings};
pub use polygon_faults::{PolygonFault, PolygonFaultKind, polygon_faults};
pub use regions::PlanarRegions;
pub use rounding::{RoundingCertificate, SnappedArrangement};
#[doc(hidden)]
pub use tour::Step;
#[doc(hidden)]
pub use windings::Windings;
