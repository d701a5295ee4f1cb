//! The answers of `homology` and `merge`.

use super::{GroupAnswer, HomologyGroup, Remark, WholeNumber};
use coface_io::Group;
use coface_topology::{AbelianGroup, Coefficients, HomologyMap};
use serde::{Deserialize, Serialize};

/// A term of a chain or cochain: a coefficient and a cell by its vertices.
pub type ChainTerm = (WholeNumber, Vec<u64>);
/// A term of a real cochain: a value and a cell by its vertices.
pub type RealTerm = (f64, Vec<u32>);

/// Homology or cohomology groups, and what else was asked about them.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HomologyAnswer {
    /// The name of the input.
    pub file: String,
    /// The ring of coefficients: `Z`, `Q`, `F_2`, ...
    pub coefficients: String,
    /// Whether the groups are those of cohomology.
    pub cohomology: bool,
    /// The groups of degrees 0, 1, ...
    pub homology: Vec<HomologyGroup>,
    /// The numbers of cells of degrees 0, 1, ...; only of a complex in parts.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub f_vector: Option<Vec<u64>>,
    /// The parts that the complex was cut into.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub parts: Option<PartsAnswer>,
    /// For each degree generators of the group.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub generators: Option<Vec<Vec<GeneratorAnswer>>>,
    /// The groups of the mesh that was written, one a generator.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub physical_groups: Option<Vec<PhysicalGroup>>,
    /// The classes of the cycles that were given.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub cycles: Option<Vec<CycleClass>>,
    /// The long exact sequence of the pair.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub sequence: Option<SequenceAnswer>,
    /// Cup products of two bases.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub cup: Option<CupProducts>,
    /// The intersection form of a closed oriented manifold of even dimension.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub intersection_form: Option<IntersectionFormAnswer>,
    /// For each degree harmonic cochains, dual to the free generators.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub harmonic: Option<Vec<Vec<HarmonicCochain>>>,
    /// The Hodge decomposition of a cochain.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub decomposition: Option<HodgeParts>,
    /// The maps on homology that a simplicial map induces.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub map: Option<InducedMaps>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

impl HomologyAnswer {
    /// The groups alone, with these coefficients.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::answer::HomologyAnswer;
    /// use coface_topology::{AbelianGroup, Coefficients, HomologyMap};
    /// let point = [AbelianGroup::new(1, vec![])];
    /// let answer = HomologyAnswer::of("point.off", Coefficients::Integers, false, &point);
    /// assert_eq!((answer.homology[0].betti, answer.coefficients.as_str()), (1, "Z"));
    /// ```
    pub fn of(file: &str, coefficients: Coefficients, cohomology: bool, groups: &[AbelianGroup]) -> Self {
        Self {
            file: file.to_owned(),
            coefficients: coefficients.to_string(),
            cohomology,
            homology: HomologyGroup::list(groups),
            f_vector: None,
            parts: None,
            generators: None,
            physical_groups: None,
            cycles: None,
            sequence: None,
            cup: None,
            intersection_form: None,
            harmonic: None,
            decomposition: None,
            map: None,
            remarks: Vec::new(),
        }
    }
}

/// A generator as a physical group of a mesh.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PhysicalGroup {
    /// The degree of the generator: the dimension of the elements.
    pub degree: usize,
    /// The name of the group.
    pub name: String,
    /// Its tag.
    pub tag: Option<i32>,
    /// The number of its elements: the cells of the generator, each as often as its coefficient says.
    pub elements: usize,
}

impl PhysicalGroup {
    /// What a group of a mesh is.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::answer::PhysicalGroup;
    /// use coface_io::{Group, GroupKind};
    /// let group = Group::new("H_1{0}1", GroupKind::Lines, vec![4, 5]).with_number(81);
    /// assert_eq!(PhysicalGroup::of(&group, 1).elements, 2);
    /// ```
    pub fn of(group: &Group, degree: usize) -> Self {
        Self { degree, name: group.name().to_owned(), tag: group.number(), elements: group.members().len() }
    }
}

/// Generators alone, as they are written to a file.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct GeneratorsFile {
    /// For each degree generators of the group.
    pub generators: Vec<Vec<GeneratorAnswer>>,
}

/// How a complex was cut into parts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct PartsAnswer {
    /// The number of parts.
    pub count: u32,
    /// How many neighbors are merged at once.
    pub fan_in: u32,
    /// Critical cells for each stratum of the first level: 1 where all strata are balls.
    pub critical_per_stratum: f64,
    /// The size of what was sent between levels, in bytes.
    pub bytes: u64,
    /// The levels, from the shards on.
    pub levels: Vec<LevelAnswer>,
}

/// One level of merging.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LevelAnswer {
    /// The number of parts.
    pub parts: u32,
    /// The number of strata before the level was reduced.
    pub strata: u64,
    /// The numbers of critical cells of each degree.
    pub critical: Vec<u64>,
    /// Critical cells for each stratum.
    pub critical_per_stratum: f64,
    /// The size of all files, in bytes.
    pub bytes: u64,
    /// The number of bits of the largest incidence.
    pub widest_bits: usize,
}

/// A generator of a homology or cohomology group.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct GeneratorAnswer {
    /// The order of its class; 0 is infinite.
    pub order: WholeNumber,
    /// How many cells it runs through, with multiplicity.
    pub length: WholeNumber,
    /// The cycle or cocycle.
    pub chain: Vec<ChainTerm>,
    /// For a cycle of finite order m a chain whose boundary is m times the cycle.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub bounding: Option<Vec<ChainTerm>>,
}

/// The class of a cycle, and whether it bounds.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CycleClass {
    /// The degree of the cycle.
    pub degree: usize,
    /// The coefficients of the class in the generators.
    pub class: Vec<WholeNumber>,
    /// The orders of the generators; 0 is infinite.
    pub orders: Vec<WholeNumber>,
    /// Whether the cycle is a boundary.
    pub bounds: bool,
    /// The least m such that m times the cycle is a boundary; `null` if there is none.
    pub multiple: Option<WholeNumber>,
    /// A chain whose boundary is the cycle, or the multiple of it.
    pub bounding: Option<Vec<ChainTerm>>,
    /// A cocycle that shows that no multiple is a boundary.
    pub cocycle: Option<Vec<ChainTerm>>,
    /// The value of the cocycle on the cycle.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub value: Option<WholeNumber>,
}

/// The long exact sequence of a pair. Columns of maps are images of generators; a map that is not there is `null`.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct SequenceAnswer {
    /// The homology of the subcomplex.
    pub subcomplex: Vec<HomologyGroup>,
    /// The homology of the complex.
    pub complex: Vec<HomologyGroup>,
    /// The homology of the pair.
    pub pair: Vec<HomologyGroup>,
    /// For each degree the map of the subcomplex into the complex.
    pub inclusion: Vec<Option<Vec<Vec<WholeNumber>>>>,
    /// For each degree the map of the complex to the pair.
    pub projection: Vec<Option<Vec<Vec<WholeNumber>>>>,
    /// For each degree the map of the pair to the subcomplex, one degree below.
    pub connecting: Vec<Option<Vec<Vec<WholeNumber>>>>,
    /// What is known of each map that is there, in the order of the sequence: from the top degree down.
    #[serde(default)]
    pub maps: Vec<SequenceMap>,
    /// Whether the sequence was checked to be exact.
    pub exact: bool,
}

/// A map of a long exact sequence.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[non_exhaustive]
pub struct SequenceMap {
    /// `inclusion`, `projection` or `connecting`.
    pub map: String,
    /// The degree of its source.
    pub degree: usize,
    /// The rank of its image.
    pub rank: usize,
    /// Its image, which is the kernel of the next map.
    pub image: GroupAnswer,
    /// Whether its kernel is zero.
    pub injective: bool,
    /// Whether its image is the target.
    pub surjective: bool,
}

impl SequenceMap {
    /// What is known of a map.
    pub(crate) fn of(name: &str, degree: usize, map: &HomologyMap) -> Self {
        let image = GroupAnswer::from(&map.image_group());
        Self {
            map: name.to_owned(),
            degree,
            rank: image.betti,
            image,
            injective: map.is_injective(),
            surjective: map.is_surjective(),
        }
    }
}

/// Cup products of a basis of degree p with one of degree q, in a basis of degree p + q.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CupProducts {
    /// The degrees p and q.
    pub degrees: [usize; 2],
    /// The basis of degree p.
    pub first: Vec<Vec<ChainTerm>>,
    /// The orders of its classes; 0 is infinite.
    pub first_orders: Vec<WholeNumber>,
    /// The basis of degree q.
    pub second: Vec<Vec<ChainTerm>>,
    /// The orders of its classes; 0 is infinite.
    pub second_orders: Vec<WholeNumber>,
    /// The basis of degree p + q.
    pub target: Vec<Vec<ChainTerm>>,
    /// The orders of its classes; 0 is infinite.
    pub target_orders: Vec<WholeNumber>,
    /// Entry `[i][j]` has the coefficients of the product of class i of the first and class j of the second basis.
    pub table: Vec<Vec<Vec<WholeNumber>>>,
}

/// The intersection form of a closed oriented manifold of even dimension.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct IntersectionFormAnswer {
    /// The rank.
    pub rank: usize,
    /// The determinant.
    pub determinant: WholeNumber,
    /// Whether the form is symmetric; else it is skew.
    pub symmetric: bool,
    /// The signature of a symmetric form.
    pub signature: Option<i64>,
    /// `even` or `odd`, of a symmetric form.
    pub parity: Option<String>,
    /// The definiteness of a symmetric form.
    pub definiteness: Option<String>,
    /// The form in words, where it is known.
    pub name: Option<String>,
    /// The values on pairs of the basis.
    pub matrix: Vec<Vec<WholeNumber>>,
    /// The basis.
    pub basis: Vec<Vec<ChainTerm>>,
}

/// A harmonic cochain.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HarmonicCochain {
    /// Its values.
    pub chain: Vec<RealTerm>,
    /// Its norm.
    pub norm: f64,
    /// How far it is from closed: the norm of its coboundary.
    pub closed_residual: f64,
    /// How far it is from coclosed.
    pub coclosed_residual: f64,
}

/// The Hodge decomposition of a cochain.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HodgeParts {
    /// The degree of the cochain.
    pub degree: usize,
    /// The exact part.
    pub exact: Vec<RealTerm>,
    /// The coexact part.
    pub coexact: Vec<RealTerm>,
    /// The harmonic part.
    pub harmonic: Vec<RealTerm>,
    /// The norms of the cochain and its parts.
    pub norms: HodgeNorms,
}

/// The norms of a cochain and the parts of its Hodge decomposition.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HodgeNorms {
    /// Of the cochain.
    pub cochain: f64,
    /// Of the exact part.
    pub exact: f64,
    /// Of the coexact part.
    pub coexact: f64,
    /// Of the harmonic part.
    pub harmonic: f64,
}

/// The maps on homology that a simplicial map induces.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct InducedMaps {
    /// The name of the target.
    pub target: String,
    /// One map for each degree.
    pub degrees: Vec<InducedMap>,
}

/// The map of one degree.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct InducedMap {
    /// The degree.
    pub degree: usize,
    /// The orders of the generators of the source; 0 is infinite.
    pub source_orders: Vec<WholeNumber>,
    /// The orders of the generators of the target; 0 is infinite.
    pub target_orders: Vec<WholeNumber>,
    /// For each generator of the source the coefficients of its image.
    pub matrix: Vec<Vec<WholeNumber>>,
    /// The kernel.
    pub kernel: GroupAnswer,
    /// The cokernel.
    pub cokernel: GroupAnswer,
}
