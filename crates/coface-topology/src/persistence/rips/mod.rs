//! Persistent homology of Vietoris-Rips complexes, without the complexes.
//!
//! # Words and conventions
//! * A simplex enters a **Vietoris-Rips filtration** at its diameter, the largest distance of two of its points. Points enter at 0.
//! * The **flag complex** of a graph has a simplex for each set of vertices of which each two are joined. With values of vertices and edges a simplex
//!   enters at the largest of its edges: that of the complete graph of points, whose vertices have the value 0, is the Vietoris-Rips filtration.
//! * The **rank** of a distance is its place among all different distances up to the threshold, from 0 (the distance 0) on. Inside this section
//!   simplices are compared by ranks.
//! * A simplex with the points a > b > .. > z has the **index** C(a, k + 1) + C(b, k) + .. + C(z, 1): the simplices of degree k are numbered
//!   without gaps. Simplices of one diameter enter by rising degree, then by falling index.
//! * A simplex and a coface of the same diameter are an **apparent pair** if the coface is the first one to enter and the simplex the last facet
//!   of it to enter. Both are seen from the distances, so such pairs are neither stored nor reduced.

mod collapse;
mod diagram;
mod filtration;
mod near;
mod reduction;
mod simplices;

#[cfg(test)]
mod tests;

pub use diagram::{RipsCochain, RipsDiagram, RipsPair};
pub use filtration::{RipsFiltration, RipsSize};
