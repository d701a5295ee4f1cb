//! The report on a model: everything that `coface info` says, as data.
//!
//! # Words
//! * A [`SurfaceModel`] is a model that is a surface; what is cut from it or covers it is a model again.
//! * A [`Producer`] is a model with the faces of its cells identified; it makes the chain complex.
//! * The **top cells** are those of the highest degree: the faces of a surface, the cells of a volume. A **ridge** is a
//!   cell one degree below: an edge of a surface, a face of a volume.
//! * A [`Report`] is what [`Report::of`] finds out about a model. A [`Problem`] is one sort of fault in it, with all its
//!   places; a [`Witness`] shows why a model is no manifold.
//!
#![doc = include_str!("../README.md")]

pub mod answer;
mod cells;
mod chains;
mod cocycles;
mod congruence;
mod diagram;
mod examination;
mod facts;
mod gluings;
mod halfedges;
mod homology;
mod moments;
mod planar;
mod polygons;
mod problem;
mod producer;
mod repair;
mod simplices;
mod simplicial;
mod spatial;
mod surface_model;
pub mod text;
mod triangulation;
mod volume;
mod yin;

pub use cocycles::{
    CocycleBasisMethod, CocyclesRequest, EdgeWeights, FoundCocycles, GivenCochain, SurfaceCocycles,
    surface_harmonic_forms, tested_cochain,
};
pub use congruence::{BlockRule, CongruenceRequest, ModelCongruence};
pub use diagram::{DiagramFormat, write_diagram};
pub use facts::{Answer, BoundaryPart, DataSummary, Kind, Report, Skin, Witness};
pub use homology::{
    FoundHomology, GivenChain, GivenRealCochain, GivenVertexMap, HomologyRequest, RelativeTo,
};
pub use moments::Moment;
pub use planar::{
    ArrangementRequest, BooleanRequest, DrawingArrangement, PlanarDrawing, RegionBoolean, RegionSource,
    is_planar,
};
pub use problem::{Problem, ProblemKind};
pub use producer::{CellNames, OrderedSimplices, Pair, Producer, Term};
pub use repair::{RepairRequest, repaired};
pub use simplices::{model_of_simplices, simplicial_complex};
pub use spatial::{
    InputState, OpenInputs, SceneArrangement, SolidBoolean, SolidRequest, SpatialRequest, SpatialScene,
};
pub use surface_model::{
    CutComponent, CutRequest, CutSeam, LayoutChoice, PlacedCover, SurfaceCover, SurfaceCut, SurfaceModel,
    edge_lengths,
};
pub use triangulation::triangulated;
pub use volume::homology_of_volume;
pub use yin::{CutCellsRequest, KinkRequest, MotionRequest, PlanarMotion, PlanarSet, SetRequest};
#[doc(hidden)]
pub use yin::{SetPiece, set_pieces};

use producer::Labels;
