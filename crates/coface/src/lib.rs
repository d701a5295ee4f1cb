//! Exact computational topology of cell complexes.
//!
//! A file becomes a [`io::Model`]; a producer makes a [`chains::ChainComplex`] of it; a question is put to the chain
//! complex. Producers do not know the questions, questions do not know the producers.
//!
//! # The map
//! * [`algebra`] and [`geometry`] are the ground: integers that widen, sparse integer matrices, Smith normal form,
//!   union-find; positions, areas and volumes.
//! * [`chains`] is the centre: chain complexes, chains and cochains, and their reduction by acyclic matching.
//! * [`simplicial`], [`surface`] and [`cellular`] are the producers: simplicial complexes of any dimension, polygon meshes
//!   and halfedge permutations, meshes of tetrahedra, hexahedra, wedges and pyramids. They also give verdicts with
//!   witnesses: what is a manifold, what can be oriented, where the boundary runs.
//! * [`topology`] asks: homology, cohomology, generators.
//! * [`io`] reads and writes files; [`report`] puts everything that is known about a model together.
//! * [`shards`] cuts complexes that are larger than memory into files, reduces these one by one and merges what is left.
//! * [`progress`] tells how far long work is, and stops it.
//!
//! Answers are exact; an [`Error`] names the place, the fault and the cure. The guide is in the folder `examples`.

pub mod algebra;
pub mod arrangement;
pub mod cellular;
pub mod chains;
mod error;
pub mod geometry;
mod ids;
pub mod io;
pub mod progress;
pub mod report;
pub mod shards;
pub mod simplicial;
pub mod surface;
pub mod topology;
pub mod yin;

pub use error::{Error, ErrorKind};
pub use ids::{CellId, EdgeId, FaceId, HalfedgeId, Id, IdVec, VertexId};

/// The example of the README compiles.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
