//! Gluing tables: simplices whose facets are glued in pairs, as in the census of 3-manifolds.
//!
//! # Words
//! * A [`GluingTable`] lists simplices of one dimension and, for each facet, the simplex it is glued to and the permutation of vertices.
//! * Its faces are the [`FaceClasses`]: faces of simplices that the gluings identify. A class that is glued to itself by a non-trivial
//!   permutation is **folded**.
//! * The [`VertexLink`] of a vertex is the surface (or complex) that a small sphere around it cuts out.
//! * A [`GluingVerdict`] says whether the quotient is a manifold; a [`GluingOrientation`] orients all simplices coherently.
//! * An **isomorphism signature** is a text that is the same for tables that differ by names alone.

mod faces;
mod isomorphism;
mod isomorphism_signature;
mod links;
mod manifold;
mod orientation;
mod packed_signature;
mod table;
mod truncation;

pub use faces::FaceClasses;
pub use isomorphism::GluingIsomorphism;
pub use links::VertexLink;
pub use manifold::{GluingFault, GluingVerdict, GluingWitness};
pub use orientation::{GluedFacet, GluingOrientation};
#[doc(hidden)]
pub use table::different_rows;
#[doc(hidden)]
pub use table::no_permutation;
pub use table::{GluingRow, GluingTable};
