//! The cells that conforming flat faces cut space into.
//!
//! # Words and conventions
//! * A [`PolygonalComplex`] is vertices, edges and flat faces, holes and slits included, by incidence. It is
//!   **conforming** when faces meet only in common edges and vertices.
//! * The **front** of a face is the side from which its outer walk runs counterclockwise; the other is its **back**.
//! * The sides of faces close up to **shells**; [`SpatialCells`] are the bounded cells, each with one outer shell and
//!   shells of voids, and the exterior.
//! * Sides of faces are **packed** as twice the face, plus one for a side that runs against its edge.
//! * [`gift_wrapped_shells`] makes the shells from the order of faces around edges alone, by chain arithmetic: a second
//!   method.
//! * [`CutTriangles`] makes a conforming complex of any triangles, by cutting them against each other.
//! * A [`SpatialArrangement`] is all of it for [`SpatialPolygons`]: they are triangulated, cut and their pieces
//!   **merged** again, so that faces and edges are those of the polygons; the cells before that are **fine**.
//! * [`ExactPolygons`] are polygons that were cut out of others: parts of given triangles, whose outlines end in points known
//!   by lines and planes. They are input again, and nothing is rounded between.
//! * [`checks`] says what is wrong with faces, shells and solids, by the codes of ISO 19107.
//! * All decisions are [`SpatialPredicates`]: exact signs about vertices by their numbers. [`GivenPoints`] are vertices
//!   with coordinates.

mod arrangement;
mod axis_view;
mod ball_cells;
mod by_congruence;
mod cells;
pub mod checks;
mod closed_walks;
mod coplanar_triangles;
mod cutting;
mod drawing;
mod exact_faces;
mod exact_polygons;
mod face_interiors;
mod face_planes;
mod face_walks;
mod flat_polygons;
mod gift_wrapped_shells;
mod inputs;
mod merging;
mod near;
mod nesting;
mod options;
mod patches;
mod polygonal_complex;
mod polygons;
mod predicates;
mod radial_order;
mod settling;
mod shells;
mod snapping;
mod wanted_parts;

pub use arrangement::SpatialArrangement;
pub use ball_cells::{BallComplex, BallRules};
pub use by_congruence::{CongruenceArrangement, arrange_by_congruence};
pub use cells::SpatialCells;
pub use closed_walks::closed_walks;
pub use coplanar_triangles::{CoplanarMerge, CoplanarTriangles, merge_coplanar_triangles};
pub use cutting::{Crossings, CutOptions, CutTriangles, SpatialVertexSource};
pub use drawing::DrawnTriangles;
pub use exact_polygons::{ExactPart, ExactPolygons};
pub use flat_polygons::{NonPlanar, SplitPolygon};
pub use gift_wrapped_shells::gift_wrapped_shells;
pub use options::SpatialOptions;
pub use polygonal_complex::PolygonalComplex;
pub use polygons::SpatialPolygons;
pub use predicates::{GivenPoints, SpatialPredicates};
