//! Facet lists, halfedge permutations, chain complexes and gluing tables as JSON.
//!
//! A file is one of
//! * `{"facets": [[0, 1, 2], ..]}`, or the bare list: simplices by their vertices, numbers from 0 to 2^32 - 1 that need
//!   not be dense;
//! * `{"next": [..], "twin": [..]}`: a surface as two permutations of its halfedges; without `twin`, halfedges 2i and
//!   2i + 1 are twins;
//! * `{"boundaries": [{"rows": m, "cols": n, "entries": [[row, column, value], ..]}, ..]}`: the boundary matrices of
//!   degrees 1, 2, ..; values at one place are added;
//! * `{"gluings": [[[neighbor, [images of vertices]] or null, ..], ..]}`: a gluing table, a row for each simplex with an
//!   entry for each facet, the one opposite to vertex 0 first; vertex k goes to vertex images\[k\] of the neighbor;
//! * a list of such objects, each with a `"name"`, of which [`read_entry`] chooses one.
//!
//! Other keys are passed over. Reading is a stream: memory is what the model takes.

mod document;
mod facets;
mod gluings;
mod matrices;
mod reading;
mod writing;

pub use reading::{read, read_entry};
pub use writing::write;
