//! The answers of the verbs as plain data: what the program prints as JSON, one type a verb.
//!
//! Each answer is a struct whose fields are the keys of the JSON object; the documentation of a field says its meaning
//! and its unit. Every answer has `remarks`: what was assumed or left out on the way, each a [`Remark`] with a
//! [`RemarkCode`] that programs can match on.
//!
//! With the feature `schema` the function `schema` describes all of them as one JSON schema; the file `docs/answers.schema.json` is its output.

mod arrange;
mod batch;
mod boolean;
mod cell_graph;
mod check;
mod cocycles;
mod congruence;
mod convert;
mod cover;
mod cut;
mod diagram;
mod dissolve;
mod edit;
mod euler;
mod generate;
mod groups;
mod halfedges;
mod handles;
mod homology;
mod incidence;
mod info;
mod isomorphic;
mod loops;
mod map;
mod persistence;
mod pi1;
mod picture;
mod refinement;
mod remark;
#[cfg(feature = "schema")]
mod schema;
mod shards;
mod signatures;
mod simplices;
mod simplify;
mod view;
mod yin;
mod yin_events;
mod yin_interface;
mod yin_interface_edits;
mod yin_interface_places;
mod yin_places;
mod yin_series;

pub use cover::{CoverAnswer, DoubleCoverAnswer};
pub use cut::{CutAnswer, CutPath, CutPiece, FundamentalDomain, LayoutAnswer, SeamAnswer};
pub use dissolve::{DissolveAnswer, DissolvedGroupAnswer};
pub use edit::EditAnswer;
pub use groups::{GroupAnswer, HomologyGroup, WholeNumber};
pub use halfedges::HalfedgePointers;
pub use homology::{
    ChainTerm, CupProducts, CycleClass, GeneratorAnswer, GeneratorsFile, HarmonicCochain, HodgeNorms,
    HodgeParts, HomologyAnswer, InducedMap, InducedMaps, IntersectionFormAnswer, LevelAnswer, PartsAnswer,
    PhysicalGroup, RealTerm, SequenceAnswer, SequenceMap,
};
pub use incidence::IncidenceAnswer;
pub use refinement::{RefinedVertex, RefinementAnswer};

pub use arrange::{
    AttributeColumn, CongruentPieces, DegeneratePolygons, DrawingInput, InsideMethod, JoinedFeatures,
    PlanarArrangementAnswer, PlanarArrangementProvenance, PlanarRounding, RoundingRepair,
    SpatialArrangementAnswer, SpatialArrangementProvenance, SpatialInput, SpatialRounding, SplitPolygons,
    VertexOrigin,
};
pub use batch::{BatchAnswer, RowAnswer};
pub use boolean::{
    BoundaryManifold, BoundaryVerdict, BoundaryWitness, EdgeOrigin, Pinches, PlanarBooleanAnswer,
    PlanarBooleanProvenance, PolygonRounding, SolidBooleanAnswer, SolidBooleanProvenance,
};
pub use cell_graph::{CellEdge, CellGraph, CellNode};
pub use check::CheckAnswer;
pub use cocycles::{
    CochainTestAnswer, CochainValue, CocycleBasisMethod, CocyclesAnswer, EdgeWeights, HarmonicFormAnswer,
    LoopAnswer, LoopIntersections,
};
pub use congruence::{BlockMergeAnswer, CongruenceAnswer, CongruenceInput};
pub use convert::{
    CarriersAnswer, ConvertAnswer, ConvertCounts, MeshRepairAnswer, ModelCounts, SetCounts,
    SurfaceRepairAnswer,
};
pub use diagram::{
    DegreeDistance, DiagramCurve, DiagramCurvesAnswer, DiagramDistanceAnswer, DiagramImageAnswer,
};
pub use euler::EulerAnswer;
pub use generate::GenerateAnswer;
pub use handles::{
    FilledHandle, FilledHandlesAnswer, HandleAnswer, HandleCounts, HandlesAnswer, LeftHandle, LoopKind,
};
pub use info::{
    BoundarySurface, CellsOfShape, DataAnswer, DrawnFaultAnswer, DrawnPlaceAnswer, DrawnPolygonsAnswer,
    FailedInput, GeometryAnswer, GeometryFaultAnswer, GeometryPlace, InfoAnswer, InfoEntry, InfoReports,
    ManifoldAnswer, MassAnswer, MomentAnswer, NamedGroup, ProblemAnswer, ReferenceAnswer, SurfaceAnswer,
    WitnessAnswer,
};
pub use isomorphic::IsomorphicAnswer;
pub use loops::{
    CyclesAnswer, HomotopicAnswer, HomotopicComponent, LoopsAnswer, LoopsComponent, SubgroupsAnswer,
    SubgroupsComponent, TreesAnswer,
};
pub use map::{
    BufferArcsAnswer, GapAnswer, MapAnswer, MapCounts, MapCoverageAnswer, MapRepairAnswer, OverlapAnswer,
    PolygonizeAnswer, SimplificationAnswer,
};
pub use persistence::{PersistenceAnswer, PersistencePairAnswer, VineAnswer, VineyardAnswer};
pub use pi1::{
    ClosedPath, GroupCounts, HomomorphismAnswer, Pi1Answer, Pi1Component, SubgroupCount, Unrecognized,
    WalkAnswer, WalkPair,
};
pub use picture::{BlockAnswer, MatrixAnswer, RenderAnswer, SchemaAnswer};
pub(crate) use remark::remarks_of_file;
pub use remark::{Place, Remark, RemarkCode};
#[doc(hidden)]
#[cfg(feature = "schema")]
pub use schema::{reprinted, schema};
pub use shards::{ReduceAnswer, ReducedShard, ShardAnswer};
pub use signatures::{PresentedGroup, SignatureAnswer, SpaceAnswer};
pub use simplices::SimplicesAnswer;
pub use simplify::{CensusAnswer, CensusLine, SimplifyAnswer};
pub use view::{LayerAnswer, ViewAnswer};
pub use yin::{
    CoverageAnswer, CutCellAnswer, GridAnswer, VanishedAnswer, YinAdvectAnswer, YinCombinationAnswer,
    YinComparisonAnswer, YinCurve, YinCutCellsAnswer, YinDecision, YinInfoAnswer, YinKinkPoint,
    YinKinksAnswer, YinPieceSource, YinProvenance, YinRepairAnswer, YinSetAnswer,
};
pub use yin_events::{
    YinEventAnswer, YinEventCounts, YinEventKind, YinInterfaceEventAnswer, YinInterfaceEventKind,
};
pub use yin_interface::{
    JunctionKind, VanishedEdgeAnswer, YinEdgeAnswer, YinInterfaceAdvectAnswer, YinInterfaceAnswer,
    YinJunctionAnswer, YinNeighborAnswer, YinPhaseAnswer,
};
pub use yin_interface_edits::{
    InterfaceKink, PhaseCell, PhaseCells, YinInterfaceCutCellsAnswer, YinInterfaceKinksAnswer,
    YinInterfaceNormalizeAnswer,
};
pub use yin_interface_places::{
    EdgeBendAnswer, EdgeSample, InterfacePoint, PhaseComparison, PhasePoints, YinInterfaceComparisonAnswer,
    YinInterfaceCurvatureAnswer, YinInterfaceLocateAnswer, YinInterfaceSampleAnswer,
};
pub use yin_places::{
    YinBendPlace, YinBoundarySample, YinCurvatureAnswer, YinCurveBend, YinFaultAnswer, YinFaultKind,
    YinLocateAnswer, YinLocatedPoint, YinLocation, YinNormalizeAnswer, YinRoughKnot, YinSampleAnswer,
    YinValidationAnswer,
};
pub use yin_series::{YinSeriesAnswer, YinSeriesRow};

use serde::Serialize;

/// An answer as one line of JSON with its keys in alphabetical order.
///
/// # Panics
/// If the answer has a map whose keys are no texts, which no answer has.
///
/// # Examples
/// ```
/// use coface_answers::answer::{Remark, RemarkCode, to_json};
/// let remark = Remark::new(RemarkCode::UnitLengths, "each edge has the length 1");
/// let json = r#"{"code":"unit-lengths","count":1,"message":"each edge has the length 1","places":[]}"#;
/// assert_eq!(to_json(&remark), json);
/// ```
pub fn to_json(answer: &(impl Serialize + ?Sized)) -> String {
    serde_json::to_value(answer).expect("answers have texts as keys").to_string()
}

/// An answer as indented JSON with its keys in alphabetical order.
///
/// # Panics
/// Those of [`to_json`].
///
/// # Examples
/// ```
/// use coface_answers::answer::{WholeNumber, to_pretty_json};
/// assert_eq!(to_pretty_json(&[WholeNumber::Number(2)]), "[\n  2\n]");
/// ```
pub fn to_pretty_json(answer: &(impl Serialize + ?Sized)) -> String {
    format!("{:#}", serde_json::to_value(answer).expect("answers have texts as keys"))
}
