//! Simplicial complexes of any dimension.
//!
//! # Words and conventions
//! * A [`Simplex`] is a non-empty set of vertices, kept sorted; its **dimension** is their number less one. The empty
//!   set is no simplex here. A **face** is a non-empty subset (the simplex itself included), a **facet** of a simplex
//!   is a face of one dimension less. The orientation of a simplex is the class of its rising vertex order.
//! * A [`SimplicialComplex`] holds with each simplex all its faces. Its **facets** are its maximal simplices.
//!   It changes: simplices are inserted with their faces and erased with their cofaces.
//! * The **star** of a simplex is the set of its **cofaces**, the simplices it is a face of; the **closed star** adds
//!   their faces. The **adjacent vertices** of a vertex share an edge with it.
//! * The **link** of a set S of simplices is the closure of its star minus the star of its closure
//!   ([`SimplicialComplex::link`]); **bd** of a pure complex is [`SimplicialComplex::boundary_complex`], a set operator, not
//!   the boundary of a chain. A [`SimplexSet`] is a set of simplices that need not be a complex.
//! * A **combinatorial manifold** has spheres and balls as links; [`ManifoldVerdict`] is yes, no or unknown. Facets are
//!   **oriented consistently** when neighbors induce opposite signs on the common ridge: [`orientability`].
//! * A [`FrozenComplex`] is a complex at rest, in sorted flat arrays; boundary and incidence matrices are made from it.
//!   Its cells are in lexicographic order, as are those of every chain complex made here.
//! * A [`DeltaComplex`] has simplices with ordered vertices, told by their faces: faces of one simplex may coincide.
//! * [`SignedSimplices`] are oriented simplices: rising vertices and a sign. A [`FacetTable`] has the facets of a list of them,
//!   a [`Prism`] is the product with an interval, an [`Extrusion`] sweeps them through layers; a [`SimplicialGrid`] is a point
//!   that is swept along each axis.

mod bistellar;
pub(crate) mod collapse;
mod complex;
mod components;
mod construction;
mod delta;
pub(crate) mod delta_subdivision;
mod delta_two_skeleton;
mod extrusion;
mod facets;
mod faults;
mod frozen;
mod incidence;
pub(crate) mod links;
mod lists;
pub(crate) mod manifold;
mod map;
mod neighborhood;
mod orientation;
mod prism;
mod signed_simplices;
mod simplex;
pub(crate) mod simplicial_grid;
mod subcomplex;
mod tree;
mod tree_bulk;
mod tree_link;
mod tree_walk;
mod two_skeleton;

pub use bistellar::{BistellarMove, SphereCertificate, recognize_ball, recognize_sphere};
pub use complex::SimplicialComplex;
pub use construction::{Composite, VertexPairs};
pub use delta::DeltaComplex;
pub use delta_subdivision::{Carrier, Subdivision};
pub use extrusion::{Extrusion, extrude};
pub use facets::{FacetTable, facets};
pub use faults::FaultyCells;
pub use frozen::FrozenComplex;
pub(crate) use frozen::FrozenLevels;
pub use manifold::{LINK_BUDGET, LinkFault, ManifoldVerdict, ManifoldWitness};
pub use map::SimplicialMap;
pub use neighborhood::SimplexSet;
pub use orientation::{orientability, relative_orientation};
pub use prism::{Prism, prism};
pub use signed_simplices::SignedSimplices;
pub use simplex::Simplex;
pub use simplicial_grid::SimplicialGrid;
pub use subcomplex::Purity;
