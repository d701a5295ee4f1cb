//! Facet lists, halfedge permutations, chain complexes and gluing tables as JSON.
//!
//! A file is one of
//! * `{"facets": [[0, 1, 2], ..]}`, or the bare list: simplices by their vertices, numbers from 0 to 2^32 - 1 that need
//!   not be dense;
//! * `{"next": [..], "twin": [..]}`: a surface as two permutations of its halfedges; without `twin`, halfedges 2i and
//!   2i + 1 are twins. A surface with boundary has `"outer": [face, ..]`, the faces that fill its boundary loops by the
//!   numbers of the orbits of `next`, by their smallest halfedges; or `null` (or -1, or itself) as the twin of each
//!   halfedge on the boundary, so that there are no halfedges outside: they are added after all others;
//! * `{"boundaries": [{"rows": m, "cols": n, "entries": [[row, column, value], ..]}, ..]}`: the boundary matrices of
//!   degrees 1, 2, ..; values at one place are added;
//! * `{"vertices": [[x, y, ..], ..], "d0": [[row, column, value], ..], "d1": .., ..}`: points, and the coboundary matrices of
//!   degrees 0, 1, ..: the matrix of degree k has a row for each (k+1)-cell and a column for each k-cell. Instead of the
//!   list there can be an object `{"rows": m, "cols": n, "coo": [..]}`, the list also called `"entries"`; where counts are
//!   not given, there are as many vertices as points, and one more cell than the largest index. No place may have two values;
//! * `{"gluings": [[[neighbor, [images of vertices]] or null, ..], ..]}`: a gluing table, a row for each simplex with an
//!   entry for each facet, the one opposite to vertex 0 first; vertex k goes to vertex images\[k\] of the neighbor;
//! * `{"order": 2, "curves": [{"points": [[x, y], ..], ..}, ..]}` or `{"plane": true}`: the boundary of a set in the plane, as
//!   [`yin`](super::yin) says; in a model its curves are closed lines;
//! * several of these: a list of such objects and lists of facets, or one after the other, such as one a line (JSON lines). [`read`]
//!   takes the first, and [`read_entry`] the one of a `"name"` or at a place.
//!
//! Points under `"vertices"` can stand beside `"facets"` of up to four vertices, which make a mesh then, beside `"boundaries"`, and beside `"next"`: vertices are the orbits of "twin, then
//! next", numbered by their smallest halfedges. All matrices together have at
//! most 2^20 rows and columns, and 16 more for each entry: an index that a file merely names takes no memory.
//!
//! Beside `"boundaries"`, `"pieces_of": [[cell or null, ..], ..]` says for each cell of degrees 0, 1, .. which cell it is a
//! piece of, or that it is none of one: a bridge or a cut inside of a cell of higher degree, there so that each piece is
//! a ball. Homology is that of the pieces; arrangements and Booleans take the cells that they make up.
//!
//! Beside `"boundaries"`, `"exact_polygons"` are the faces as they were before coordinates were rounded, for arrangements and
//! Booleans: `{"points": [[x, y, z], ..], "vertices": [[point, ..], ..], "polygons": [{"parts": [{"triangle": [a, b, c],
//! "walks": [[vertex, ..], ..]}, ..], "shared": true}, ..]}`, as [`ExactPolygons`](coface_arrange::spatial::ExactPolygons) has
//! them. A vertex is a point, or where two lines (4 points), a line and a plane (5) or three planes (9) meet; `"shared"` is left
//! out where it is false.
//!
//! Beside `"boundaries"`, `"exact_segments"` are the edges of a drawing in the plane as they were before coordinates were rounded:
//! `{"points": [[x, y], ..], "supports": [[point, point], ..], "vertices": [[point] or [support, support], ..], "pieces": [[support,
//! vertex, vertex], ..], "shared": [..]}`, as [`ExactSegments`](coface_arrange::planar::ExactSegments) has them. A vertex is a
//! point, or where two supports meet; a piece is the part of a support between two vertices. `"shared"` are pieces that bound nothing, and is
//! left out where there are none.
//!
//! Other keys are passed over. Reading is a stream: memory is what the model takes.

mod coboundaries;
mod curves;
mod document;
mod exact;
mod exact_segments;
mod facets;
mod faults;
mod gluings;
mod interface;
mod matrices;
mod outline;
mod points;
mod reading;
#[cfg(test)]
mod tests;
mod writing;

#[doc(hidden)]
pub use exact::{exact_keys, with_exact_keys};
pub(crate) use faults::Faults;
pub(crate) use matrices::most_cells;
pub(crate) use outline::outline;
pub use reading::{read, read_entry};
pub(crate) use reading::{read_boundary, read_with};
pub use writing::write;
