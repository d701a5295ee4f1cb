//! The answers of `cocycles`: a basis of the first cohomology, and the test of one cochain.

use super::{ChainTerm, Remark, WholeNumber};
use serde::{Deserialize, Serialize};

/// A basis of the first cohomology over the integers, dual to loops.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CocyclesAnswer {
    /// The name of the input.
    pub file: String,
    /// How the cocycles were found.
    pub method: CocycleBasisMethod,
    /// The rank of the first cohomology: the number of cocycles.
    pub rank: usize,
    /// The value of cocycle i on loop j, in row i.
    pub pairing: Vec<Vec<WholeNumber>>,
    /// The determinant of the pairing; `null` where it is not square.
    pub determinant: Option<WholeNumber>,
    /// The loops that the cocycles are measured on.
    pub loops: Vec<LoopAnswer>,
    /// The cocycles, by their values on edges.
    pub cocycles: Vec<Vec<ChainTerm>>,
    /// The intersection numbers of the loops with each other; only on closed orientable surfaces.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub intersection: Option<LoopIntersections>,
    /// The weights of edges that harmonic forms have the least energy for.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub weights: Option<EdgeWeights>,
    /// The edges by their ends, in the order of the values of harmonic forms.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub edges: Option<Vec<Vec<u32>>>,
    /// The harmonic forms in the classes of the cocycles.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub harmonic: Option<Vec<HarmonicFormAnswer>>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// A loop that cocycles are measured on.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum LoopAnswer {
    /// A closed walk on a surface: its vertices, the first again at the end.
    Walk(Vec<u32>),
    /// A cycle of a complex: its edges with coefficients.
    Cycle(Vec<ChainTerm>),
}

impl LoopAnswer {
    /// The number of edges of the loop.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::answer::LoopAnswer;
    /// assert_eq!(LoopAnswer::Walk(vec![0, 1, 2, 0]).edge_count(), 3);
    /// ```
    pub fn edge_count(&self) -> usize {
        match self {
            Self::Walk(vertices) => vertices.len().saturating_sub(1),
            Self::Cycle(terms) => terms.len(),
        }
    }
}

/// The intersection numbers of loops on a closed oriented surface.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct LoopIntersections {
    /// How often loop j crosses loop i, from the right to the left as plus, in row i.
    pub matrix: Vec<Vec<i64>>,
    /// The determinant of the matrix; `null` where it was not computed.
    pub determinant: Option<WholeNumber>,
}

/// A harmonic one-form: the cochain of the least energy in its class.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct HarmonicFormAnswer {
    /// The values on the edges, in their order.
    pub values: Vec<f64>,
    /// The largest sum around a face, which is 0 but for rounding.
    pub closed_residual: f64,
    /// The largest weighted sum at a vertex, which is 0 but for rounding.
    pub coclosed_residual: f64,
}

/// Whether a cochain of degree 1 is closed and exact, with what shows it.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct CochainTestAnswer {
    /// The name of the input.
    pub file: String,
    /// Whether the sum around each face is zero.
    pub closed: bool,
    /// Whether the cochain is the difference of a function on the vertices.
    pub exact: bool,
    /// Of an exact cochain: a function on the vertices whose differences it is.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub potential: Option<Vec<(CochainValue, Vec<u64>)>>,
    /// Of a closed cochain that is not exact: the vertices of a closed walk on which its sum is not zero.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub walk: Option<Vec<u32>>,
    /// The sum along the walk.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub period: Option<CochainValue>,
    /// Of a cochain that is not closed: a face, by its vertices, around which the sum is not zero.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub face: Option<Vec<u32>>,
    /// The sum around the face.
    #[serde(skip_serializing_if = "Option::is_none", default)]
    pub sum: Option<CochainValue>,
    /// What was assumed or left out.
    pub remarks: Vec<Remark>,
}

/// A value of a cochain: exact where all values are integers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum CochainValue {
    /// An integer.
    Whole(WholeNumber),
    /// A real number.
    Real(f64),
}

impl std::fmt::Display for CochainValue {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Whole(number) => number.fmt(formatter),
            Self::Real(number) => number.fmt(formatter),
        }
    }
}

/// How cocycles are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum CocycleBasisMethod {
    /// By crossing the faces between loops, of a surface.
    Crossing,
    /// By slicing along loops, of a closed orientable surface.
    Slicing,
    /// By reduction of the chain complex, of any model.
    General,
}

impl CocycleBasisMethod {
    /// The word of the answer.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::answer::CocycleBasisMethod::Slicing.name(), "slicing");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            Self::Crossing => "crossing",
            Self::Slicing => "slicing",
            Self::General => "general",
        }
    }
}

/// The weights of edges in the energy of harmonic forms.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(rename_all = "kebab-case")]
pub enum EdgeWeights {
    /// By the cotangents of the angles opposite to an edge, of triangles.
    Cotangent,
    /// 1 for each edge.
    Uniform,
}

impl EdgeWeights {
    /// The word of the answer.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_answers::answer::EdgeWeights::Cotangent.name(), "cotangent");
    /// ```
    pub fn name(self) -> &'static str {
        match self {
            Self::Cotangent => "cotangent",
            Self::Uniform => "uniform",
        }
    }
}
