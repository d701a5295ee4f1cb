//! Producers: cell complexes of every kind, and the chain complexes that they give.
//!
//! Every producer is a [`Cells`]: it has a chain complex, a 2-skeleton, the vertices of its cells and their counts. [`Coherence`]
//! says whether the top cells agree, with an [`OddCycle`] where they cannot; a [`Verdict`] says whether the space is a manifold.
//!
//! * [`simplicial`]: simplicial complexes of any dimension with star, closure, link and boundary; complexes with ordered simplices.
//! * [`gluing`]: simplices with facets glued in pairs, and isomorphism signatures.
//! * [`known_spaces`]: named triangulations with published answers.
//! * [`surface`]: polygon meshes, halfedge meshes and generalized maps.
//! * [`cell_mesh`]: tetrahedra, hexahedra, wedges and pyramids with shared faces.
//! * [`lar`]: cells as lists of vertices, incidence operators, oriented boundaries.
//! * [`alpha`]: alpha complexes of points, from Delaunay triangulations.
//! * [`filtered`]: simplicial complexes with values: flag complexes of weighted graphs and of points with distances.
//! * [`grids`], [`cubical`], [`shapes`]: products of intervals, voxels, and mapped grids with positions.
//! * [`families`]: the shapes and known spaces by name, with their parameters.
//!
#![doc = include_str!("../README.md")]

pub mod alpha;
pub mod cell_mesh;
mod cells;
mod coherence;
mod components;
pub mod cubical;
pub mod families;
pub mod filtered;
pub mod gluing;
pub mod grids;
pub mod known_spaces;
pub mod lar;
pub mod shapes;
pub mod simplicial;
pub mod surface;
mod verdict;

pub use cells::Cells;
pub use coherence::{Coherence, Obstruction, OddCycle};
pub use components::Components;
pub use verdict::{LinkFindings, Verdict};
