//! The answer of `simplify`: a 3-manifold with fewer tetrahedra.

use super::{HomologyGroup, Remark};
use serde::{Deserialize, Serialize};

/// A triangulated 3-manifold that was simplified by moves.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SimplifyAnswer {
    /// The name of the input.
    pub file: String,
    /// The numbers of vertices, edges, triangles and tetrahedra before.
    pub f_vector_before: Vec<usize>,
    /// The same numbers now.
    pub f_vector: Vec<usize>,
    /// The moves in order, each on the triangulation that those before it have made: `3-2 at edge 4`.
    pub moves: Vec<String>,
    /// The integral homology, which is that of the input.
    pub homology: Vec<HomologyGroup>,
    /// The isomorphism signature of the triangulation now.
    pub signature: String,
    /// Which 3-manifold it is, where that is proved.
    pub name: Option<String>,
    /// What the name rests on: `layered_solid_tori`, `folded_tetrahedron`, `seifert_fibration`, `fibered_pieces`, `normal_spheres` or `fundamental_group`.
    pub name_proof: Option<String>,
    /// Where the triangulation now is in the census that was given.
    pub census: Option<CensusAnswer>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// A triangulation looked up in a census.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct CensusAnswer {
    /// The file.
    pub file: String,
    /// The number of different triangulations in it.
    pub triangulation_count: usize,
    /// The line with the triangulation; null if none of those that were tried is there.
    pub found: Option<CensusLine>,
}

/// A line of a census.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct CensusLine {
    /// Its number, from 1.
    pub line: u64,
    /// The isomorphism signature as it is written there.
    pub signature: String,
    /// The name beside it: what the file says, not what is proved.
    pub name: Option<String>,
}
