//! Canonical polygons: surfaces cut along disjoint simple loops to a polygon with a canonical word around it.
//!
//! # Words and conventions
//! * **Strands** are disjoint curves that cross edges at points and go straight through faces. They are drawn in **disks**: the faces
//!   around a root, a vertex, with all others glued on along a spanning tree, which strands cross as they must.
//! * A [`Schema`](schema) is the polygon of loops with the points where they cross edges; it cuts off crosscaps and handles.
//! * A [`Refinement`] is the surface with edges and faces subdivided such that strands are walks on edges.
//! * A [`CanonicalCut`] is all that of each component, with the words.

mod component;
mod cut;
mod layout;
mod refinement;
mod schema;
mod strands;
#[cfg(test)]
mod tests;

pub use component::{CanonicalComponent, CanonicalCurve, CurveKind};
pub use cut::CanonicalCut;
pub use layout::PolygonPlane;
pub use refinement::{Carrier, Refinement};
