//! Whether faces in space are what ISO 19107 calls valid: faces, shells, and the boundary of a solid.
//!
//! # Words and conventions
//! * A **face** ([`CheckedFaces`]) has one outer **ring** of vertices and any number of inner rings, its **holes**. A
//!   **shell** is a closed surface; a **solid** is bounded by one outer shell and the shells of its voids.
//! * A [`Fault`] is one [`FaultCode`] with its count and first places. A code has a number of ISO 19107 in the
//!   edition that CityGML and CityJSON validators use: 1xx rings, 2xx faces, 3xx shells, 4xx solids, 5xx solids of a composite.
//! * What faces are stated to be, a [`CheckedPrimitive`], says which codes are looked for.
//! * A fault is **of the surface** when the faces cross, overlap or contradict each other, whatever they are meant to
//!   bound; else it is **of the solid**: a sound surface that does not bound one solid, such as a surface with a
//!   boundary.
//! * Shells are given with the faces, or they are the connected components. Vertices count as one when their
//!   coordinates are equal, as far as that closes surfaces.
//! * Whether faces and shells meet is decided exactly, by signs of determinants of the coordinates. What is not exact
//!   says so: flatness is measured, with a tolerance that is an argument.
//! * [`meeting_triangles`] asks of the triangles of a mesh alone which of them meet.
//! * [`GeometryChecks`] are the options and the check itself, [`GeometryFaults`] is what it finds.

mod codes;
mod composites;
mod containment;
mod divided_edges;
mod edges;
mod examination;
mod faces;
mod faults;
mod flatness;
mod holes;
mod meeting_triangles;
mod meetings;
mod primitives;
mod rings;
mod shells;
mod solids;
mod touching_shells;
mod triangle_pairs;

pub use codes::{FaultCode, FaultScope};
pub use examination::GeometryChecks;
pub use faces::CheckedFaces;
pub use faults::{Fault, FaultPlace, GeometryFaults};
pub use meeting_triangles::meeting_triangles;
pub use primitives::CheckedPrimitive;
