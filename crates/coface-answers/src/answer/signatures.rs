//! What a row of `batch` says of a line in a list of isomorphism signatures.

use super::{GroupAnswer, HomologyGroup};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// What is known of the gluing table of a signature. Ideal vertices are cut off unless they are taken as points: manifold, homology
/// and groups are those of the space with boundary that is left.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[non_exhaustive]
pub struct SignatureAnswer {
    /// The numbers of vertices, edges, triangles and tetrahedra of the triangulation.
    pub f_vector: Vec<usize>,
    /// The number of connected components.
    pub components: usize,
    /// Whether every triangle lies in two tetrahedra.
    pub closed: bool,
    /// How many vertices have a link that is a closed surface other than the sphere.
    pub ideal_vertices: usize,
    /// The Euler characteristic of the space.
    pub euler_characteristic: i64,
    /// Whether the space is a manifold: `yes`, `no` or `unknown`.
    pub manifold: String,
    /// Why it is none; `null` for manifolds.
    pub witness: Option<String>,
    /// Whether the tetrahedra can be oriented so that neighbors agree.
    pub orientable: bool,
    /// The integral homology of degrees 0 to 3.
    pub homology: Vec<HomologyGroup>,
    /// The fundamental group of each component; absent unless it is asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub groups: Option<Vec<PresentedGroup>>,
}

/// A fundamental group in a row, by a presentation that was simplified.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[non_exhaustive]
pub struct PresentedGroup {
    /// The group in words; `null` if it is not recognized, which says nothing.
    pub name: Option<String>,
    /// The number of generators.
    pub generators: usize,
    /// The relators: i is generator i, counted from 1, -i its inverse, and the product of the letters is the unit.
    pub relators: Vec<Vec<i32>>,
    /// The abelianization.
    pub abelianization: GroupAnswer,
}
