//! Homology groups and integers of any size in answers.

use coface_algebra::Integer;
use coface_topology::AbelianGroup;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An integer: a JSON number, or beyond 64 bits a string of decimal digits, since JSON readers round such numbers.
///
/// # Examples
/// ```
/// use coface_algebra::Integer;
/// use coface_answers::answer::WholeNumber;
/// assert_eq!(WholeNumber::from(&Integer::from(-3)), WholeNumber::Number(-3));
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum WholeNumber {
    /// An integer of at most 64 bits.
    Number(i64),
    /// The decimal digits of a larger one.
    Digits(String),
}

impl WholeNumber {
    /// The order of an element of a group: 0 stands for infinite.
    pub fn of_order(order: Option<&Integer>) -> Self {
        order.map_or(Self::Number(0), Self::from)
    }
}

impl std::fmt::Display for WholeNumber {
    fn fmt(&self, formatter: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Number(number) => number.fmt(formatter),
            Self::Digits(digits) => digits.fmt(formatter),
        }
    }
}

impl From<&Integer> for WholeNumber {
    fn from(integer: &Integer) -> Self {
        integer.to_i64().map_or_else(|| Self::Digits(integer.to_string()), Self::Number)
    }
}

/// A homology or cohomology group of one degree: $\mathbb{Z}^b$ plus a cyclic group for each torsion coefficient.
///
/// # Examples
/// ```
/// use coface_answers::answer::HomologyGroup;
/// use coface_topology::AbelianGroup;
/// let groups = HomologyGroup::list(&[AbelianGroup::new(1, vec![]), AbelianGroup::new(0, vec![2.into()])]);
/// assert_eq!((groups[1].degree, groups[1].betti, groups[1].torsion.len()), (1, 0, 1));
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[non_exhaustive]
pub struct HomologyGroup {
    /// The degree of the group.
    pub degree: usize,
    /// The rank of the free part: the Betti number. Over a field it is the dimension.
    pub betti: usize,
    /// The orders of the cyclic parts, each a divisor of the next.
    pub torsion: Vec<WholeNumber>,
}

impl HomologyGroup {
    /// The groups of degrees 0, 1, ...
    pub fn list(groups: &[AbelianGroup]) -> Vec<Self> {
        let group = |(degree, group): (usize, &AbelianGroup)| Self {
            degree,
            betti: group.betti(),
            torsion: group.torsion().iter().map(WholeNumber::from).collect(),
        };
        groups.iter().enumerate().map(group).collect()
    }
}

/// A finitely generated abelian group.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct GroupAnswer {
    /// The rank of the free part.
    pub betti: usize,
    /// The orders of the cyclic parts, each a divisor of the next.
    pub torsion: Vec<WholeNumber>,
}

impl From<&AbelianGroup> for GroupAnswer {
    fn from(group: &AbelianGroup) -> Self {
        Self { betti: group.betti(), torsion: group.torsion().iter().map(WholeNumber::from).collect() }
    }
}
