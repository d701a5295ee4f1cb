//! Homology groups and integers of any size in answers.

use coface_algebra::Integer;
use coface_topology::AbelianGroup;
use serde::{Deserialize, Serialize};
use std::fmt;

/// An integer: a JSON number, or beyond 64 bits a string of decimal digits, since JSON readers round such numbers.
///
/// # Examples
/// ```
/// use coface_algebra::Integer;
/// use coface_answers::answer::WholeNumber;
/// assert_eq!(WholeNumber::from(&Integer::from(-3)), WholeNumber::Number(-3));
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
#[serde(untagged)]
pub enum WholeNumber {
    /// An integer of at most 64 bits.
    Number(i64),
    /// The decimal digits of a larger one.
    Digits(String),
}

impl WholeNumber {
    /// The order of an element of a group: 0 stands for infinite.
    ///
    /// # Examples
    /// ```
    /// use coface_answers::answer::WholeNumber;
    /// assert_eq!(WholeNumber::of_order(None), WholeNumber::Number(0));
    /// assert_eq!(WholeNumber::of_order(Some(&3.into())), WholeNumber::Number(3));
    /// ```
    pub fn of_order(order: Option<&Integer>) -> Self {
        order.map_or(Self::Number(0), Self::from)
    }

    /// Whether the number is 0, which as an order stands for infinite.
    ///
    /// # Examples
    /// ```
    /// assert!(coface_answers::answer::WholeNumber::Number(0).is_zero());
    /// ```
    pub fn is_zero(&self) -> bool {
        *self == Self::Number(0)
    }
}

impl fmt::Display for WholeNumber {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
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
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
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
    ///
    /// # Examples
    /// ```
    /// use coface_answers::answer::HomologyGroup;
    /// let circle = [1, 1].map(|betti| coface_topology::AbelianGroup::new(betti, vec![]));
    /// assert_eq!(HomologyGroup::list(&circle)[1].degree, 1);
    /// ```
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
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
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

impl fmt::Display for HomologyGroup {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_group(formatter, self.betti, &self.torsion)
    }
}

impl fmt::Display for GroupAnswer {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_group(formatter, self.betti, &self.torsion)
    }
}

/// A group as the sum of its cyclic parts: `Z^2 + Z/3`.
fn write_group(formatter: &mut fmt::Formatter<'_>, betti: usize, torsion: &[WholeNumber]) -> fmt::Result {
    let mut summands = match betti {
        0 => Vec::new(),
        1 => vec!["Z".to_owned()],
        rank => vec![format!("Z^{rank}")],
    };
    for equal in torsion.chunk_by(|a, b| a == b) {
        summands.push(match equal.len() {
            1 => format!("Z/{}", equal[0]),
            count => format!("(Z/{})^{count}", equal[0]),
        });
    }
    formatter.write_str(if summands.is_empty() { "0" } else { "" })?;
    formatter.write_str(&summands.join(" + "))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn groups_of_answers_read_as_those_of_the_library() {
        for group in [
            AbelianGroup::new(0, vec![]),
            AbelianGroup::new(1, vec![]),
            AbelianGroup::new(3, vec![2.into(), 2.into(), 6.into()]),
            AbelianGroup::new(0, vec!["123456789012345678901234567890".parse().unwrap()]),
        ] {
            assert_eq!(GroupAnswer::from(&group).to_string(), group.to_string());
            assert_eq!(HomologyGroup::list(std::slice::from_ref(&group))[0].to_string(), group.to_string());
        }
    }
}
