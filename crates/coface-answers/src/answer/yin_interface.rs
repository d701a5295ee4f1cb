//! The answer of `yin interface`.

use super::{Remark, YinInterfaceEventAnswer, YinRepairAnswer};
use serde::{Deserialize, Serialize};

/// The answer of `yin interface`.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinInterfaceAnswer {
    /// The names of the files.
    pub files: Vec<String>,
    /// The order of the edges.
    pub order: u32,
    /// The phases, in the order of the sets.
    pub phases: Vec<YinPhaseAnswer>,
    /// The points at which edges end: junctions, kinks, and one point of each closed edge.
    pub vertices: Vec<[f64; 2]>,
    /// The edges: arcs between two phases, or between a phase and what is in none.
    pub edges: Vec<YinEdgeAnswer>,
    /// The vertices at which three or more edges end.
    pub junctions: Vec<YinJunctionAnswer>,
    /// The pairs of edges that go on smoothly into each other at a vertex, each with its direction: 1 as it runs, -1 against that; in files
    /// only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub smooth_pairs: Option<Vec<[(u32, i8); 2]>>,
    /// The length of all edges, each once, in the unit of the coordinates; null beyond the range of numbers.
    pub length: Option<f64>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// The answer of `yin advect` for an interface.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinInterfaceAdvectAnswer {
    /// The time at the end.
    pub time: f64,
    /// The number of time steps.
    pub steps: usize,
    /// The order of the Runge-Kutta scheme.
    pub scheme: u32,
    /// The number of knots that were added.
    pub added: usize,
    /// The number of knots that were removed.
    pub removed: usize,
    /// The closed edges that became too short to be kept.
    pub vanished: Vec<VanishedEdgeAnswer>,
    /// The steps in which edges were cut and pasted.
    pub repairs: Vec<YinRepairAnswer>,
    /// The changes of the topology, by time; null unless they were asked for.
    pub events: Option<Vec<YinInterfaceEventAnswer>>,
    /// How exactly times of events are found; null unless they were asked for.
    pub event_tolerance: Option<f64>,
    /// The distance at which edges are in contact; null if contacts were not looked for.
    #[serde(default)]
    pub contact_distance: Option<f64>,
    /// The areas of the phases at the beginning; null where one is infinite.
    pub areas_before: Vec<Option<f64>>,
    /// The files of the way, in the order of time.
    pub frames: Vec<String>,
    /// The interface at the end.
    #[serde(flatten)]
    pub interface: YinInterfaceAnswer,
}

/// A closed edge that vanished.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct VanishedEdgeAnswer {
    /// When it vanished: the end of the step.
    pub time: f64,
    /// Its number at the beginning; null for one that a repair has made.
    pub edge: Option<u32>,
}

/// A phase of an interface.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinPhaseAnswer {
    /// The name: of the feature, or of the file.
    pub name: String,
    /// The area, in the square of the unit of the coordinates; null if it is infinite.
    pub area: Option<f64>,
    /// The length of the boundary; null beyond the range of numbers.
    pub perimeter: Option<f64>,
    /// The number of components.
    pub components: usize,
    /// The number of holes.
    pub holes: usize,
    /// What lies on the other side of the boundary; what is in no phase comes first.
    pub neighbors: Vec<YinNeighborAnswer>,
}

/// What phases have in common.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinNeighborAnswer {
    /// The number of the other phase; null for what is in no phase.
    pub phase: Option<u32>,
    /// The number of common edges.
    pub edges: usize,
    /// Their length; null beyond the range of numbers.
    pub length: Option<f64>,
}

/// An edge of an interface.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinEdgeAnswer {
    /// The vertices at its start and at its end.
    pub ends: [u32; 2],
    /// The phase on its left; null for what is in no phase.
    pub left: Option<u32>,
    /// The phase on its right; null for what is in no phase.
    pub right: Option<u32>,
    /// Its length; null beyond the range of numbers.
    pub length: Option<f64>,
    /// The number of its polynomial pieces.
    pub pieces: usize,
    /// The parameters of its knots; in files only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub knots: Option<Vec<f64>>,
    /// The Bernstein control points of its pieces, neighbors sharing the one between them; in files only.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub controls: Option<Vec<[f64; 2]>>,
}

/// A junction of an interface.
#[derive(Clone, Debug, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct YinJunctionAnswer {
    /// Its vertex.
    pub vertex: u32,
    /// Where it is.
    pub point: [f64; 2],
    /// The number of edges that end there.
    pub degree: usize,
    /// How many pairs of edges go on smoothly into each other.
    pub smooth_pairs: usize,
    /// The type, by degree and smooth pairs.
    pub kind: JunctionKind,
    /// The edges that leave it, counterclockwise.
    pub edges: Vec<u32>,
    /// For each of these edges the phase on its left; null for what is in no phase.
    pub phases: Vec<Option<u32>>,
}

/// The type of a junction.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "lowercase")]
pub enum JunctionKind {
    /// Three edges, none of which goes on smoothly into another.
    Y,
    /// Three edges, two of which are one smooth way.
    T,
    /// Four edges that are two smooth ways.
    X,
    /// Any other.
    Other,
}

impl JunctionKind {
    /// The type of a junction with so many edges and smooth pairs.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::answer::JunctionKind;
    /// assert_eq!([JunctionKind::new(3, 0), JunctionKind::new(4, 2)], [JunctionKind::Y, JunctionKind::X]);
    /// ```
    pub fn new(degree: usize, smooth_pairs: usize) -> Self {
        match (degree, smooth_pairs) {
            (3, 0) => Self::Y,
            (3, 1) => Self::T,
            (4, 2) => Self::X,
            _ => Self::Other,
        }
    }

    /// The word for it.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::answer::JunctionKind::T.word(), "T");
    /// ```
    pub fn word(self) -> &'static str {
        match self {
            Self::Y => "Y",
            Self::T => "T",
            Self::X => "X",
            Self::Other => "other",
        }
    }
}
