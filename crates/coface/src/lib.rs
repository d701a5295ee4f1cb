#![doc = include_str!("../README.md")]
//!
//! # The chapters
//! * [`algebra`]: integers that widen, sparse integer matrices, normal forms, words; and [`algebra::chains`], the center: chain complexes,
//!   chains, cochains, chain maps and their reduction. [`algebra::progress`] reports how far long work is, and stops it.
//! * [`geometry`]: positions, exact predicates, triangulation of polygons, areas, volumes and moments.
//! * [`complexes`]: the producers. Simplicial complexes with star, closure, link and boundary; gluing tables; polygon meshes, halfedge meshes
//!   and generalized maps; meshes of tetrahedra to hexahedra; LAR models; grids, voxels, shapes; known spaces. They give verdicts with
//!   witnesses: what is a manifold, what can be oriented, where the boundary runs.
//! * [`topology`]: the questions. Homology and cohomology with generators and certificates, cup products, harmonic cochains, persistence,
//!   fundamental groups, cut graphs, short loops, universal covers.
//! * [`arrange`]: arrangements of segments in the plane and polygons in space, Booleans, congruence of chain complexes.
//! * [`yin`]: regions of the plane with spline boundaries and kinks, their Booleans, interfaces that move.
//! * [`io`]: models and their files. [`answers`]: one request and one answer for each question. [`pictures`]: scenes, stills and pages.
//!   [`scale`]: complexes larger than memory, worker processes, reports over many files.
//!
//! The guide in `examples/` has twenty numbered pages, a program each, whose assertions can be checked by hand: 1 to 7 go through the chapters, 8 and 9 cut
//! and combine solids and regions, 10 and 11 are persistence and Hodge theory, 12 and 13 shards and voxels, 14 to 16 census, certificates, products and
//! pairs, 17 to 20 groups and covers, halfedges, operators and congruence, interfaces.
//!
//! A producer makes a [`ChainComplex`] and a question is put to it; neither knows the other. Answers are exact; an [`Error`] names the place,
//! the fault and the cure.

pub use coface_algebra as algebra;
pub use coface_answers as answers;
pub use coface_arrange as arrange;
pub use coface_complexes as complexes;
pub use coface_geometry as geometry;
pub use coface_io as io;
pub use coface_pictures as pictures;
pub use coface_scale as scale;
pub use coface_topology as topology;
pub use coface_yin as yin;

pub use coface_algebra::chains::{Chain, ChainComplex, Cochain};
pub use coface_algebra::{
    CellId, EdgeId, Error, ErrorKind, FaceId, Fault, HalfedgeId, Id, IdVec, SparseMatrix, VertexId,
};
pub use coface_answers::Report;
pub use coface_complexes::cell_mesh::CellMesh;
pub use coface_complexes::simplicial::{Simplex, SimplicialComplex};
pub use coface_complexes::surface::{HalfedgeMesh, PolygonMesh};
pub use coface_geometry::Positions;
pub use coface_io::Model;
pub use coface_topology::{AbelianGroup, Coefficients, HomologyBasis, homology};
pub use coface_yin::YinSet;

/// The Rust programs of the book, which `cargo test --doc` compiles and runs. `xtask` runs the commands in it, whose blocks have attributes that rustdoc does not know.
#[cfg(doctest)]
#[allow(rustdoc::invalid_codeblock_attributes)]
mod book {
    #[doc = include_str!("../../../docs/book/src/surfaces.md")]
    mod surfaces {}
    #[doc = include_str!("../../../docs/book/src/complexes.md")]
    mod complexes {}
    #[doc = include_str!("../../../docs/book/src/cells.md")]
    mod cells {}
    #[doc = include_str!("../../../docs/book/src/arrangements.md")]
    mod arrangements {}
    #[doc = include_str!("../../../docs/book/src/yin.md")]
    mod yin {}
    #[doc = include_str!("../../../docs/book/src/homology.md")]
    mod homology {}
    #[doc = include_str!("../../../docs/book/src/scale.md")]
    mod scale {}
}
