//! The answer of `pi1`: fundamental groups.

use super::{GroupAnswer, Remark, SpaceAnswer};
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// The fundamental group of each component, by generators and relators.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Pi1Answer {
    /// The name of the input.
    pub file: String,
    /// Whether the presentations were simplified.
    pub simplified: bool,
    /// The components; that of the base vertex comes first.
    pub components: Vec<Pi1Component>,
    /// The short closed paths that were asked for.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub cycles: Option<Vec<ClosedPath>>,
    /// What is known of each walk that was given.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub walks: Option<Vec<WalkAnswer>>,
    /// The walks compared with each other.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub pairs: Option<Vec<WalkPair>>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// The fundamental group of one component.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Pi1Component {
    /// The vertex where loops start and end, by its number in the file.
    pub base: u32,
    /// The number of generators.
    pub generators: usize,
    /// The relators: i is generator i, counted from 1, -i its inverse, and the product of the letters is the unit.
    pub relators: Vec<Vec<i32>>,
    /// The abelianization, which agrees with the first homology.
    pub abelianization: GroupAnswer,
    /// The group in words, or by a presentation in standard form; `null` if it is not recognized, which says nothing.
    pub name: Option<String>,
    /// Why there is no name; absent with one.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub unrecognized: Option<Unrecognized>,
    /// The closed 3-manifold that the complex is, where the name of the group follows from it; absent where it follows from the presentation.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub space: Option<SpaceAnswer>,
    /// The lengths of the loops of a surface, in the unit of the file.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub lengths: Option<Vec<f64>>,
    /// Numbers that distinguish groups; absent unless they are asked for.
    #[serde(flatten)]
    pub counts: Option<GroupCounts>,
}

/// Why a group has no name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "snake_case")]
#[non_exhaustive]
pub enum Unrecognized {
    /// Counting its elements was given up: it may be finite or not.
    GaveUp,
    /// It is infinite, since its abelianization is, and no rule for such groups fits.
    NoRule,
}

/// Numbers that distinguish groups.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct GroupCounts {
    /// The numbers of subgroups of index 1, 2, ...; `null` if they take too long to count.
    pub subgroups: Option<Vec<SubgroupCount>>,
    /// The numbers of homomorphisms to some finite groups; `null` where they take too long to count.
    pub homomorphisms: BTreeMap<String, Option<HomomorphismAnswer>>,
}

/// The number of subgroups of one index.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SubgroupCount {
    /// The index.
    pub index: usize,
    /// The number of subgroups.
    pub subgroups: usize,
    /// The number of their conjugacy classes.
    pub classes: usize,
}

/// The number of homomorphisms to a finite group.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HomomorphismAnswer {
    /// All of them.
    pub all: u64,
    /// Those onto the whole group.
    pub onto: u64,
}

/// A closed path with its length.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct ClosedPath {
    /// The length in the unit of the file, or the number of edges without positions.
    pub length: f64,
    /// The vertices, by their numbers in the file; the first is repeated at the end.
    pub vertices: Vec<u32>,
}

/// What is known of a closed walk on a surface.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct WalkAnswer {
    /// The number of its edges.
    pub steps: usize,
    /// The component that it lies on; `null` at an isolated vertex.
    pub component: Option<usize>,
    /// Whether it can be contracted to a point.
    pub contractible: bool,
    /// Whether it is a boundary over the integers.
    pub bounds: bool,
    /// Its word in the generators.
    pub word: Vec<i32>,
    /// Its class in the first homology, by exponent sums of the generators.
    pub homology: Vec<i64>,
}

/// Two walks compared.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct WalkPair {
    /// The numbers of the two walks, counted from 0.
    pub walks: [usize; 2],
    /// Whether they are homotopic with the base fixed; `null` if they start at different vertices.
    pub homotopic: Option<bool>,
    /// Whether they are homotopic when the base may move.
    pub freely_homotopic: bool,
    /// Whether they are homologous.
    pub homologous: bool,
}
