//! The answer of `persistence`: a diagram.

use super::{ChainTerm, Remark};
use serde::{Deserialize, Serialize};

/// Persistent homology of a function on a complex.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PersistenceAnswer {
    /// The name of the input.
    pub file: String,
    /// The characteristic of the field of coefficients.
    pub field: u32,
    /// The function on the vertices, the file of the values, `vietoris-rips`, `flag complex`, `zigzag`, or `voxels, v-construction` or `voxels, t-construction` of an image.
    pub function: String,
    /// How cells follow from the function: `lower` or `upper`; `null` for given values. Of an image sublevel or superlevel sets; `extended` where
    /// both are asked for.
    pub star: Option<String>,
    /// The largest diameter or value of the simplices that were looked at; `null` unless the input is points, distances or a graph.
    #[serde(default)]
    pub threshold: Option<f64>,
    /// The pairs of all degrees.
    pub diagram: Vec<PersistencePairAnswer>,
    /// The Betti numbers of the whole complex over the field, of points those at the threshold.
    pub betti: Vec<usize>,
    /// The primes over whose fields other cells are paired than over the rational numbers: torsion comes or goes along the way. Only if cycles were asked
    /// for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub torsion_primes: Option<Vec<u32>>,
    /// The numbers of edges before and after their collapse, if they were collapsed; cells of pairs are among those that are left.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub collapsed: Option<(usize, usize)>,
    /// The part that homology is taken relative to, if there is one.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub relative_to: Option<String>,
    /// The part whose classes are followed in the whole, if there is one: they are born in the part, and die when they bound in the whole. `betti` has the ranks of
    /// its homology in that of the whole.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub image_of: Option<String>,
    /// The names of the vertices by their numbers, of a graph whose vertices have names.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub vertex_names: Option<Vec<String>>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// A homology class that is born and dies, or stays.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PersistencePairAnswer {
    /// The degree of the class.
    pub degree: usize,
    /// Of extended persistence `ordinary`, `extended+`, `extended-` or `relative`; of a relative class the degree is that of relative homology. Of a zigzag
    /// `closed-open`, `closed-closed`, `open-closed` or `open-open`: whether the class is there at the time of its birth, and at that of its death.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub kind: Option<String>,
    /// The value at which it is born.
    pub birth: f64,
    /// The value at which it dies; `null` if it stays.
    pub death: Option<f64>,
    /// The cell that gives birth to it, by its vertices; of an image the voxel whose value the birth is, by its place along each axis.
    pub birth_cell: Vec<u32>,
    /// The cell by which it dies, by its vertices; of an image the voxel whose value the death is.
    pub death_cell: Option<Vec<u32>>,
    /// A cycle of the class, there from the birth on. Only if cycles were asked for, as the following ones.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cycle: Option<Vec<ChainTerm>>,
    /// The chain of the next degree, there from the death on, whose boundary the cycle is; of a class that dies.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub bounding_chain: Option<Vec<ChainTerm>>,
    /// A cocycle of the cells before the death, with the value 1 on the cycle.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cocycle: Option<Vec<ChainTerm>>,
}

/// The paths of the points of a diagram while the function moves.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct VineyardAnswer {
    /// The name of the input.
    pub file: String,
    /// The characteristic of the field of coefficients.
    pub field: u32,
    /// The functions on the vertices, or the files of their values: the parameters 0, 1, 2, ...
    pub functions: Vec<String>,
    /// The paths, by rising degree.
    pub vines: Vec<VineAnswer>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// The path of a class.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct VineAnswer {
    /// The degree of the class.
    pub degree: usize,
    /// Parameters with births and deaths, on lines in between; the death of a class that stays is `null`.
    pub points: Vec<(f64, f64, Option<f64>)>,
}
