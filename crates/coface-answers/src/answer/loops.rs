//! The answers of `loops`, `cycles`, `homotopic` and `subgroups`.

use super::{ClosedPath, GroupAnswer, GroupCounts, Remark, WalkAnswer, WalkPair};
use serde::{Deserialize, Serialize};

/// Loops that generate the fundamental group of each component.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LoopsAnswer {
    /// The name of the input.
    pub file: String,
    /// Which loops they are: `any`, `shortest` or `canonical`.
    pub kind: String,
    /// The components; that of the base vertex comes first.
    pub components: Vec<LoopsComponent>,
    /// The trees that the loops of a complex of at most 40 edges come from; `null` for larger ones.
    #[serde(default)]
    pub trees: Option<TreesAnswer>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// The loops of one component.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LoopsComponent {
    /// The vertex where loops start and end, by its number in the file.
    pub base: u32,
    /// The group in words; `null` if it is not recognized, which says nothing.
    pub name: Option<String>,
    /// The loops: loop i is generator i + 1.
    pub loops: Vec<ClosedPath>,
    /// The relators: i is loop i, counted from 1, -i its inverse, and the product of the letters can be contracted.
    pub relators: Vec<Vec<i32>>,
}

/// The edges of a small complex by what they are in a tree-cotree decomposition, each by its vertices.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct TreesAnswer {
    /// The edges of the spanning trees of vertices.
    pub tree: Vec<[u32; 2]>,
    /// The edges that spanning trees of faces cross: what they are as loops follows from the faces.
    pub cotree: Vec<[u32; 2]>,
    /// The edges in neither: each makes a loop with the tree. Where a presentation was simplified, fewer loops are shown.
    pub generators: Vec<[u32; 2]>,
}

/// Short closed paths on a surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CyclesAnswer {
    /// The name of the input.
    pub file: String,
    /// Which paths they are: `non-contractible`, `non-separating` or `homology-basis`.
    pub kind: String,
    /// The paths; empty if none is of this kind.
    pub cycles: Vec<ClosedPath>,
    /// Of the shortest path of a kind on the whole surface: no path of this kind is shorter than this. It is the length of the path
    /// unless the search ended early; `null` if there is no such path, and for other requests.
    #[serde(default)]
    pub lower_bound: Option<f64>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// Closed walks on a surface compared with each other.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HomotopicAnswer {
    /// The name of the input.
    pub file: String,
    /// The groups that the words of walks are in.
    pub components: Vec<HomotopicComponent>,
    /// What is known of each walk.
    pub walks: Vec<WalkAnswer>,
    /// All pairs of walks.
    pub pairs: Vec<WalkPair>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// The group that the words of walks on a component are in.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HomotopicComponent {
    /// The vertex where loops start and end, by its number in the file.
    pub base: u32,
    /// The number of generators.
    pub generators: usize,
    /// The relators: i is generator i, counted from 1, -i its inverse, and the product of the letters is the unit.
    pub relators: Vec<Vec<i32>>,
}

/// The numbers of subgroups of the fundamental group of each component.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SubgroupsAnswer {
    /// The name of the input.
    pub file: String,
    /// The highest index of subgroups that are counted.
    pub highest_index: usize,
    /// The components; that of the base vertex comes first.
    pub components: Vec<SubgroupsComponent>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// The numbers of one component.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SubgroupsComponent {
    /// The vertex where loops start and end, by its number in the file.
    pub base: u32,
    /// The abelianization, which agrees with the first homology.
    pub abelianization: GroupAnswer,
    /// The group in words; `null` if it is not recognized, which says nothing.
    pub name: Option<String>,
    /// The numbers; absent at an isolated vertex.
    #[serde(flatten)]
    pub counts: Option<GroupCounts>,
}
