//! One request and one answer for each question, and what assembles the answers.
//!
//! * `answer` has the answers as plain data: what the program prints as JSON, with their schema.
//! * `producer` makes the chain complex of a model and names its cells; `facts` reports on it; `repair` makes it ready for
//!   other questions.
//! * `homology`, `groups`, `cocycles`, `persistence`, `incidence`, `handles`, `surface_model` (cuts and covers), `simplices`, `matrix_blocks`, `planar`, `spatial`,
//!   `congruence`, `signatures` and `yin` each answer the requests of some verbs.
//! * `text` lays answers out for people.
//!
#![doc = include_str!("../README.md")]

pub mod answer;
mod census;
mod cocycles;
mod congruence;
mod editing;
mod facts;
mod groups;
mod handles;
mod homology;
mod incidence;
mod isomorphism;
mod losses;
mod matrix_blocks;
mod near;
mod parts;
mod persistence;
mod planar;
mod polygon_isomorphism;
mod producer;
mod repair;
mod signatures;
mod simplices;
mod simplification;
mod spatial;
mod surface_model;
pub mod text;
mod yin;

pub use census::Census;
pub use cocycles::{
    CocyclesRequest, FoundCocycles, GivenCochain, SurfaceCocycles, surface_harmonic_forms, tested_cochain,
};
pub use congruence::{BlockRule, CongruenceRequest, ModelCongruence};
pub use editing::{CellName, Edit, EditLog, EditRecord, EditorState, SurfaceEditor};
pub use facts::{
    Answer, BoundaryPart, DataSummary, DrawnFault, DrawnPlace, DrawnPolygons, GeometryCheck, GeometryFacts,
    GeometryUnchecked, GroupSummary, Kind, Moment, Problem, ProblemKind, Report, ReportRequest, Skin,
    Witness, group_of_space, homology_of_volume,
};
pub use groups::{FoundGroups, GivenWalks, GroupsRequest, ShortPaths, SurfaceLoops};
pub use handles::{FillHandlesRequest, HandlesRequest};
pub use homology::{
    Domain, FoundHomology, GivenChain, GivenRealCochain, GivenVertexMap, HomologyRequest, RelativeTo,
};
pub use incidence::{FoundOperator, OperatorKind, OperatorRequest};
pub use isomorphism::isomorphic;
pub use losses::losses_of;
pub use matrix_blocks::{BlockedMatrix, MatrixBlocks};
pub use parts::RegionSource;
pub use persistence::{
    CurveValues, DiagramCurveKind, DiagramCurvesRequest, DiagramDistanceRequest, DiagramFormat,
    DiagramImageRequest, DiagramMetric, Directions, EulerRequest, FoundDiagram, FoundImage, FoundImageCycles,
    FoundRips, GivenDiagram, GivenZigzag, GreyImage, Growth, ImageCells, ImageRequest, PersistenceRequest,
    PointFiltration, RipsRequest, VertexFunction, VineyardRequest, write_diagram, write_kinds, write_vines,
};
pub use planar::{
    ArrangementMethod, ArrangementRequest, BooleanRequest, BufferCaps, BufferJoins, BufferOptions,
    DissolveRequest, Dissolved, DrawingArrangement, DrawingOptions, FaceAttributes, LineOptions, MapResult,
    MapTask, PlanarDrawing, RegionBoolean, RepairMethod, are_planar, is_planar, polygons_of_fill_rules,
    reference_loss,
};
pub use producer::{CellNames, OrderedSimplices, Pair, Producer, Term, group_chain, named_groups};
pub use repair::{
    RepairRequest, SurfaceRepair, SurfaceRepairRequest, Weld, dual_graph_model, dual_model, halfedge_model,
    polygon_model, repaired, repaired_surface, triangulated, truncated, welded,
};
pub use signatures::SignatureRequest;
pub use simplices::{Neighborhood, model_of_simplices, simplicial_complex, simplicial_skeleton};
pub use simplification::{SimplifiedManifold, gluing_model};
pub use spatial::{
    CongruentBoolean, CongruentScene, InputState, OpenInputs, SceneArrangement, SolidBoolean, SolidRequest,
    SpatialRequest, SpatialScene, remarks_of_single_precision,
};
pub use surface_model::{
    CutComponent, CutRequest, CutSeam, LayoutChoice, LayoutRequest, LayoutWeights, PlacedCover,
    PlacedPolygons, PolygonSchema, SurfaceCover, SurfaceCut, SurfaceModel, edge_lengths,
};
pub use yin::{
    CutCellsRequest, InterfaceKinksRequest, InterfaceMotion, KinkRequest, LabelImage, MotionRequest,
    NamedSet, PlanarInterface, PlanarMotion, PlanarSet, SetRequest,
};
#[doc(hidden)]
pub use yin::{SetPiece, contact_below_knots, set_pieces};
