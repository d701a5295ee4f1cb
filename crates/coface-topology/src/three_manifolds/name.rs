//! Names of 3-manifolds.

use super::{GraphSpace, SeifertSpace, TorusBundle};
use std::fmt;

/// Which 3-manifold a space is, up to homeomorphism that may reverse orientation.
///
/// # Examples
/// ```
/// use coface_topology::SpaceName;
/// assert_eq!(SpaceName::Lens { p: 5, q: 2 }.to_string(), "L(5,2)");
/// assert_eq!(SpaceName::Lens { p: 2, q: 1 }.to_string(), "RP3");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SpaceName {
    /// The 3-sphere.
    Sphere,
    /// The 3-ball.
    Ball,
    /// The lens space $L(p, q)$, $p \\ge 2$, with the least q of all that give it: the projective space for p = 2.
    Lens {
        /// The order of its fundamental group.
        p: u64,
        /// Modulo p.
        q: u64,
    },
    /// A bundle of 2-spheres over the circle: the product, or the twisted one, which is not orientable.
    SphereBundle {
        /// Whether it is the product.
        is_orientable: bool,
    },
    /// The product of a projective plane and the circle.
    ProjectivePlaneTimesCircle,
    /// A Seifert fibered space that is none of the spaces above.
    Seifert(SeifertSpace),
    /// One or two Seifert fibered pieces glued along a torus on which the fibers do not agree. Two names may be of one space.
    Graph(GraphSpace),
    /// A bundle of tori over the circle, with a monodromy of trace above 2 or below -2.
    TorusBundle(TorusBundle),
    /// The connected sum of two or more spaces, none a sphere, each up to an orientation of its own: the sum of two copies of L(3,1) and that of
    /// L(3,1) with its mirror image have one name.
    Sum(Vec<SpaceName>),
}

impl SpaceName {
    /// Whether spaces with this name can differ by how summands are oriented to each other: two or more of them are other spaces than their mirror
    /// images, or may be, and all are orientable.
    ///
    /// # Examples
    /// L(5,2) is its own mirror image, for 2 times 2 is -1 modulo 5; L(3,1) is not.
    /// ```
    /// use coface_topology::SpaceName;
    /// let [third, fifth] = [(3, 1), (5, 2)].map(|(p, q)| SpaceName::Lens { p, q });
    /// assert!(SpaceName::Sum(vec![third.clone(), third.clone()]).leaves_orientations_open());
    /// assert!(!SpaceName::Sum(vec![third, fifth]).leaves_orientations_open());
    /// ```
    pub fn leaves_orientations_open(&self) -> bool {
        let Self::Sum(summands) = self else { return false };
        let is_one_sided = |summand: &Self| {
            matches!(summand, Self::SphereBundle { is_orientable: false } | Self::ProjectivePlaneTimesCircle)
        };
        let is_mirrored = |summand: &&Self| match **summand {
            Self::Lens { p, q } => u128::from(q) * u128::from(q) % u128::from(p) != u128::from(p) - 1,
            Self::SphereBundle { .. } | Self::Sphere => false,
            _ => true,
        };
        !summands.iter().any(is_one_sided) && summands.iter().filter(is_mirrored).count() > 1
    }
}

impl fmt::Display for SpaceName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sphere => f.write_str("S3"),
            Self::Ball => f.write_str("B3"),
            Self::Lens { p: 2, .. } => f.write_str("RP3"),
            Self::Lens { p, q } => write!(f, "L({p},{q})"),
            Self::SphereBundle { is_orientable: true } => f.write_str("S2 x S1"),
            Self::SphereBundle { is_orientable: false } => f.write_str("S2 x~ S1"),
            Self::ProjectivePlaneTimesCircle => f.write_str("RP2 x S1"),
            Self::Seifert(space) => write!(f, "{space}"),
            Self::Graph(space) => write!(f, "{space}"),
            Self::TorusBundle(space) => write!(f, "{space}"),
            Self::Sum(summands) => {
                for (at, summand) in summands.iter().enumerate() {
                    let sign = if at == 0 { "" } else { " # " };
                    write!(f, "{sign}{summand}")?;
                }
                Ok(())
            }
        }
    }
}

/// What the name of a space rests on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SpaceProof {
    /// The triangulation, as it is or after moves, is two layered solid tori with one boundary.
    LayeredSolidTori,
    /// The triangulation, after moves, is one tetrahedron whose facets are folded onto each other in pairs along the edges in which they meet.
    FoldedTetrahedron,
    /// The triangulation, as it is or after moves, is stacks of tetrahedra over triangles, closed by layered solid tori: a Seifert fibration. The
    /// first homology of its invariants is that of the space.
    SeifertFibration,
    /// As a Seifert fibration, of pieces that are glued along tori, directly or through layers of tetrahedra. The first homology of pieces and gluings is
    /// that of the space.
    FiberedPieces,
    /// The triangulation, after moves, is cut along normal spheres into pieces that are shown to be what they are by one of the above; the first
    /// homology says which small summands went with the spheres.
    NormalSpheres,
    /// The fundamental group is known, and of all closed 3-manifolds one has it, up to orientation: simply connected is the sphere alone, and spaces with
    /// a finite group are spherical.
    FundamentalGroup,
}

impl SpaceProof {
    /// The word for programs: `layered_solid_tori`, `folded_tetrahedron`, `seifert_fibration`, `fibered_pieces`,
    /// `normal_spheres` or `fundamental_group`.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_topology::SpaceProof::LayeredSolidTori.word(), "layered_solid_tori");
    /// ```
    pub fn word(self) -> &'static str {
        match self {
            Self::LayeredSolidTori => "layered_solid_tori",
            Self::FoldedTetrahedron => "folded_tetrahedron",
            Self::SeifertFibration => "seifert_fibration",
            Self::FiberedPieces => "fibered_pieces",
            Self::NormalSpheres => "normal_spheres",
            Self::FundamentalGroup => "fundamental_group",
        }
    }
}

/// A space with its name and what that rests on.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NamedSpace {
    pub(super) name: SpaceName,
    pub(super) proof: SpaceProof,
}

impl NamedSpace {
    /// The name.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// use coface_topology::{SpaceName, named_space};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let table = GluingTable::from_isomorphism_signature("bkaagj", 3)?;
    /// assert_eq!(named_space(&table, &table.faces()?, 0)?.map(|space| space.name().clone()), Some(SpaceName::Sphere));
    /// # Ok(()) }
    /// ```
    pub fn name(&self) -> &SpaceName {
        &self.name
    }

    /// What it rests on.
    ///
    /// # Examples
    /// ```
    /// use coface_complexes::gluing::GluingTable;
    /// use coface_topology::{SpaceProof, named_space};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let table = GluingTable::from_isomorphism_signature("eLAkbccddemken", 3)?;
    /// let proof = named_space(&table, &table.faces()?, 0)?.map(|space| space.proof());
    /// assert_eq!(proof, Some(SpaceProof::SeifertFibration));
    /// # Ok(()) }
    /// ```
    pub fn proof(&self) -> SpaceProof {
        self.proof
    }
}
