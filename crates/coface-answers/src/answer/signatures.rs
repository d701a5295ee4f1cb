//! What a row of `batch` says of a line in a list of isomorphism signatures.

use super::{GroupAnswer, HomologyGroup};
use coface_topology::NamedSpace;
use serde::{Deserialize, Deserializer, Serialize};

/// What is known of the gluing table of a signature. Ideal vertices are cut off unless they are taken as points: manifold, homology
/// and groups are those of the space with boundary that is left.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
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
    /// Which 3-manifold the space is, `null` where that is not proved; absent unless it is asked for.
    #[serde(default, skip_serializing_if = "Option::is_none", deserialize_with = "there")]
    pub space: Option<Option<SpaceAnswer>>,
    /// The fundamental group of each component; absent unless it is asked for.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub groups: Option<Vec<PresentedGroup>>,
}

/// A key that is there, whatever its value.
fn there<'de, D: Deserializer<'de>>(value: D) -> Result<Option<Option<SpaceAnswer>>, D::Error> {
    Option::deserialize(value).map(Some)
}

/// A fundamental group in a row, by a presentation that was simplified.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
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

/// Which 3-manifold a space is, up to homeomorphism that may reverse orientation.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SpaceAnswer {
    /// The name: `S3`, `RP3`, `L(8,3)`, `S2 x S1`, `SFS [S2: (2,1) (3,1) (5,-4)]`, ...
    pub name: String,
    /// What the name rests on: `layered_solid_tori`, `folded_tetrahedron`, `seifert_fibration`, `fibered_pieces`, `normal_spheres` or `fundamental_group`.
    pub proof: String,
}

impl SpaceAnswer {
    /// The answer about a space that was named.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::answer::SpaceAnswer;
    /// use coface_complexes::gluing::GluingTable;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let sphere = GluingTable::from_isomorphism_signature("bkaagj", 3)?;
    /// let space = coface_topology::named_space(&sphere, &sphere.faces()?, 0)?;
    /// assert_eq!(space.as_ref().map(|space| SpaceAnswer::of(space).name).as_deref(), Some("S3"));
    /// # Ok(()) }
    /// ```
    pub fn of(space: &NamedSpace) -> Self {
        Self { name: space.name().to_string(), proof: space.proof().word().to_owned() }
    }
}
