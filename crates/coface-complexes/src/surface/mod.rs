//! Surfaces: polygon meshes with identified edges, their verdicts with witnesses, halfedge permutations.
//!
//! # Words
//! * A [`PolygonMesh`] is any soup of polygons on one vertex set: its **sides** are identified to **edges**. It need be no
//!   surface. A **corner** is a vertex of a face; the side of a corner runs from it to the next vertex.
//! * A mesh is a **surface** when each edge lies in one or two faces and each vertex has one **fan** of faces: its **link**
//!   is one path or one cycle. [`SurfaceVerdict`] names the edges and vertices where it is none.
//! * The **boundary** is the edges in exactly one face; [`BoundaryLoop`] is a component of it.
//! * Two faces on an edge **agree** when they run through it in opposite directions. [`SurfaceOrientation`] says whether
//!   all do, whether they can be turned to, and gives an odd cycle of faces if not.
//! * [`SurfaceType`] is a compact connected surface by orientability, genus and number of boundary loops;
//!   [`SurfaceSurvey`] has all of this at once.
//! * A [`GeneralizedMap`] is any compact surface, orientable or not, as polygons whose sides are glued in pairs; its
//!   [`OrientationDoubleCover`] has every face twice.
//! * A [`HalfedgeMesh`] is an oriented surface as a permutation `next` of its halfedges, two to an edge; `halfedge/` has
//!   its words.
//! * [`linking_terms`] are the linking form of a closed surface in space: linking numbers of cycles with cycles pushed off to the outside.
//! * A [`Slice`] is a surface cut open along edges; [`Glued`] is one with sides of its boundary glued.
//! * A [`MeshRepair`] makes a soup a surface, on request only: it splits vertices and edges and turns faces, and says so.

mod boundary;
mod classification;
mod components;
pub(crate) mod dual_graph;
pub(crate) mod edge_identification;
mod generalized_map;
mod halfedge;
mod linking_form;
pub(crate) mod manifold;
mod orientation;
mod polygon_mesh;
pub(crate) mod range_sort;
mod repair;
mod two_skeleton;

pub use boundary::BoundaryLoop;
pub use classification::{SurfaceComponent, SurfaceSurvey, SurfaceType};
#[cfg(any(test, feature = "samples"))]
#[doc(hidden)]
pub use generalized_map::samples;
pub use generalized_map::{FaceOrientation, GeneralizedMap, Glued, OrientationDoubleCover, PathKind, Slice};
pub use halfedge::{
    CollapseObstacle, EdgeCollapse, EdgeRemoval, EdgeSplit, FacePoke, FaceSplit, HalfedgeMesh,
    HalfedgePermutations, InnerHalfedges, Renumbering, SimplicialCollapse, VertexRemoval, VertexSplit,
};
pub use linking_form::{LinkingTerm, linking_terms};
pub use manifold::{LinkComponent, LinkShape, SurfaceDefect, SurfaceFindings, SurfaceVerdict};
pub use orientation::SurfaceOrientation;
pub use polygon_mesh::PolygonMesh;
pub use repair::{FacesAtEdge, MeshRepair};
