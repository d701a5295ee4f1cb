//! Surfaces cut open: spanning trees, loops, cut graphs, fundamental domains.
//!
//! # Words and conventions
//! * The **dual graph** of a surface has the faces as nodes and an arc for each edge with a face on either side; loops
//!   and several arcs between two nodes are kept.
//! * A [`TreeCotree`] splits the edges: a spanning **tree** of the vertices, a spanning **cotree** of the dual graph
//!   that crosses none of its edges, and the **generators**, which are left. A generator closes up along the tree to a
//!   loop at the base; these loops generate the fundamental group.
//! * The **cut graph** is all edges that the cotree does not cross. What remains of a component cut along it is a disk,
//!   its **fundamental domain**; a [`FundamentalDomain`] is the polygon that its boundary is, with a letter for each
//!   generator.
//! * On a component with boundary one boundary edge belongs to the cotree, which reaches the outside through it. So
//!   there are $1 - \chi$ generators, and they generate freely. On a closed component there are $2 - \chi$, with one
//!   relator.
//! * A [`ClosedWalk`] is a cycle; a [`SurfaceHomology`] gives its class and what it bounds. A [`CocycleBasis`] is a
//!   basis of first cohomology, by crossing the cotree or by [slicing](slicing_cocycle) along loops; [`harmonic_forms`]
//!   are the real ones of least energy.
//! * A [`SurfaceHomotopy`] has the words of walks: it decides which can be contracted and which are homotopic.
//! * A [`CanonicalCut`] has disjoint simple loops that cut the surface to its canonical polygon, drawn across edges and faces.
//! * On a closed surface in space a **handle loop** bounds on the inside and no multiple of it on the outside, a **tunnel loop** the other way
//!   round; [`handle_pairs`] finds short ones by linking numbers that the caller provides.
//! * A [`CutGraph`] is the cut graph without loose ends, as seams. [`shortest_cycle`] cuts along shortest paths, which the cycle crosses at
//!   most once, and searches along the sides of the cuts; on surfaces of high genus, and for [`shortest_homology_basis`], searches start from the
//!   vertices of a short cut graph, which every cycle that cannot be contracted meets; for [`shortest_loops`] from one vertex.

mod bits;
mod canonical;
mod closed_walk;
mod cocycle_basis;
mod crossings;
mod cut_graph;
mod cut_surface;
mod cut_vertices;
mod exactness;
mod handles;
mod harmonic_forms;
mod intrinsic;
mod root_search;
mod shortest_cycle;
mod shortest_homology_basis;
mod shortest_loops;
mod shortest_paths;
mod slicing_cocycle;
mod surface_homology;
mod surface_homotopy;
mod tree_cotree;

pub use canonical::{
    CanonicalComponent, CanonicalCurve, CanonicalCut, Carrier, CurveKind, PolygonPlane, Refinement,
};
pub use closed_walk::ClosedWalk;
pub use cocycle_basis::CocycleBasis;
pub use cut_graph::{CutGraph, Seam, SeamKind};
pub use cut_surface::{CutSurface, FundamentalDomain};
pub use exactness::{Exactness, exactness, exactness_within};
pub use handles::{HandleKind, HandlePair, ShortHandleLoops, handle_pairs, short_handle_loops};
pub use harmonic_forms::{HarmonicForm, cotangent_weights, harmonic_forms};
pub use shortest_cycle::{
    CycleBounds, CycleKind, ShortestCycle, shortest_cycle, shortest_cycle_through, shortest_cycle_until,
};
pub use shortest_homology_basis::shortest_homology_basis;
pub use shortest_loops::shortest_loops;
pub use slicing_cocycle::{Slicing, intersection_number, slicing_cocycle};
pub use surface_homology::SurfaceHomology;
pub use surface_homotopy::SurfaceHomotopy;
pub use tree_cotree::{EdgeRole, TreeCotree, TreeCotreeComponent};
