//! Names of groups.

use crate::homology::AbelianGroup;
use std::fmt;

/// A group that was recognized: it is isomorphic to the one of this name, by proof.
///
/// # Examples
/// ```
/// use coface_topology::{AbelianGroup, GroupName};
/// assert_eq!(GroupName::Abelian(AbelianGroup::new(0, vec![])).to_string(), "trivial");
/// assert_eq!(GroupName::Abelian(AbelianGroup::new(1, vec![2.into()])).to_string(), "Z x Z/2");
/// assert_eq!(GroupName::Free(4).to_string(), "Free(4)");
/// let surface = GroupName::Surface { is_orientable: false, genus: 3 };
/// assert_eq!(surface.to_string(), "non-orientable surface group of genus 3");
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum GroupName {
    /// A finitely generated abelian group, the trivial group among them.
    Abelian(AbelianGroup),
    /// The free group of this rank, at least 2.
    Free(usize),
    /// The group of a closed surface other than sphere, projective plane and torus: orientable with so many handles, or
    /// non-orientable with so many cross-caps. With 2 cross-caps it is the Klein bottle group.
    Surface {
        /// Whether the surface is orientable.
        is_orientable: bool,
        /// The number of handles or cross-caps, at least 2.
        genus: usize,
    },
    /// The group of integer matrices with ones on the diagonal and zeros below, 3 by 3, for k = 1; in general two
    /// generators whose commutator is the k-th power of a central third one, $k \ge 1$.
    Heisenberg(u64),
    /// A finite group that is not abelian.
    Finite {
        /// The number of elements.
        order: usize,
        /// Its own name, if it has one here: `Q8`, `SL(2,5)`, `dihedral group of order 10`.
        name: Option<String>,
    },
    /// The group with a presentation in standard form, which is written out: `<x1, x2, x3, h | h central, x1^2 h, ..>`.
    Presented(String),
    /// The free product of groups that are neither trivial nor free, and of a free group.
    FreeProduct(Vec<GroupName>),
    /// The direct product.
    DirectProduct(Vec<GroupName>),
}

impl GroupName {
    /// The trivial group.
    pub(super) fn trivial() -> Self {
        Self::Abelian(AbelianGroup::default())
    }

    /// The free group of this rank, which may be 0 or 1.
    pub(super) fn free(rank: usize) -> Self {
        if rank < 2 { Self::Abelian(AbelianGroup::new(rank, Vec::new())) } else { Self::Free(rank) }
    }

    /// The group of a closed surface, spheres and tori included.
    pub(super) fn surface(is_orientable: bool, genus: usize) -> Self {
        match (is_orientable, genus) {
            (true, 0) => Self::trivial(),
            (true, 1) => Self::Abelian(AbelianGroup::new(2, Vec::new())),
            (false, 1) => Self::Abelian(AbelianGroup::new(0, vec![2.into()])),
            _ => Self::Surface { is_orientable, genus },
        }
    }

    /// The free product, with free factors collected.
    pub(crate) fn free_product(factors: Vec<Self>) -> Self {
        let mut rank = 0;
        let mut others = Vec::new();
        for factor in factors {
            match factor {
                Self::Free(own) => rank += own,
                Self::Abelian(group) if group.torsion().is_empty() && group.betti() < 2 => {
                    rank += group.betti();
                }
                Self::FreeProduct(own) => others.extend(own),
                other => others.push(other),
            }
        }
        others.sort_by_cached_key(Self::to_string);
        if rank > 0 || others.is_empty() {
            others.push(Self::free(rank));
        }
        if others.len() == 1 { others.swap_remove(0) } else { Self::FreeProduct(others) }
    }

    /// The direct product with the infinite cyclic group.
    pub(super) fn times_integers(self) -> Self {
        match self {
            Self::Abelian(group) => {
                Self::Abelian(AbelianGroup::new(group.betti() + 1, group.torsion().to_vec()))
            }
            Self::DirectProduct(mut factors) => {
                match factors.last_mut() {
                    Some(Self::Abelian(group)) => {
                        *group = AbelianGroup::new(group.betti() + 1, group.torsion().to_vec());
                    }
                    _ => factors.push(Self::free(1)),
                }
                Self::DirectProduct(factors)
            }
            other => Self::DirectProduct(vec![other, Self::free(1)]),
        }
    }

    /// Whether groups of this name are isomorphic: not where it is the order of a finite group alone, or a product with one.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::GroupName;
    /// assert!(GroupName::Finite { order: 8, name: Some("Q8".to_owned()) }.is_complete());
    /// // Both Q8 and the symmetries of a square have 8 elements.
    /// assert!(!GroupName::Finite { order: 8, name: None }.is_complete());
    /// ```
    pub fn is_complete(&self) -> bool {
        match self {
            Self::Finite { name, .. } => name.is_some(),
            Self::FreeProduct(factors) | Self::DirectProduct(factors) => {
                factors.iter().all(Self::is_complete)
            }
            _ => true,
        }
    }

    /// The number of elements, if it is finite.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::{AbelianGroup, GroupName};
    /// assert_eq!(GroupName::Abelian(AbelianGroup::new(0, vec![2.into(), 2.into()])).order(), Some("4".to_owned()));
    /// assert_eq!(GroupName::Free(2).order(), None);
    /// ```
    pub fn order(&self) -> Option<String> {
        match self {
            Self::Abelian(group) if group.betti() == 0 => {
                let factors = group.torsion().iter();
                Some(
                    factors
                        .fold(coface_algebra::Integer::ONE, |order, factor| order * factor.clone())
                        .to_string(),
                )
            }
            Self::Finite { order, .. } => Some(order.to_string()),
            _ => None,
        }
    }

    /// Whether the name needs brackets as a factor.
    fn is_compound(&self) -> bool {
        matches!(self, Self::FreeProduct(_) | Self::DirectProduct(_))
            || matches!(self, Self::Abelian(group) if usize::from(group.betti() > 0) + group.torsion().len() > 1)
    }
}

impl fmt::Display for GroupName {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let factors = |factors: &[Self], sign: &str| {
            let names = factors
                .iter()
                .map(|factor| if factor.is_compound() { format!("({factor})") } else { factor.to_string() });
            names.collect::<Vec<_>>().join(sign)
        };
        match self {
            Self::Abelian(group) if group.is_trivial() => f.write_str("trivial"),
            Self::Abelian(group) => f.write_str(&group.to_string().replace(" + ", " x ")),
            Self::Free(rank) => write!(f, "Free({rank})"),
            Self::Surface { is_orientable: false, genus: 2 } => f.write_str("Klein bottle group"),
            Self::Surface { is_orientable, genus } => {
                let kind = if *is_orientable { "orientable" } else { "non-orientable" };
                write!(f, "{kind} surface group of genus {genus}")
            }
            Self::Heisenberg(1) => f.write_str("Heisenberg group"),
            Self::Heisenberg(k) => write!(f, "<a, b, c | c central, [a, b] = c^{k}>"),
            Self::Finite { name: Some(name), .. } => f.write_str(name),
            Self::Finite { order, name: None } => write!(f, "finite group of order {order}"),
            Self::Presented(text) => f.write_str(text),
            Self::FreeProduct(names) => f.write_str(&factors(names, " * ")),
            Self::DirectProduct(names) => f.write_str(&factors(names, " x ")),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn products_collect_their_free_parts() {
        let two = || GroupName::surface(false, 1);
        assert_eq!(
            GroupName::free_product(vec![two(), GroupName::free(1), two()]).to_string(),
            "Z/2 * Z/2 * Z"
        );
        assert_eq!(
            GroupName::free_product(vec![GroupName::free(1), GroupName::Free(2)]).to_string(),
            "Free(3)"
        );
        assert_eq!(GroupName::free_product(vec![]), GroupName::trivial());
        assert_eq!(
            GroupName::free_product(vec![GroupName::surface(true, 1), GroupName::free(1)]).to_string(),
            "Z^2 * Z"
        );
        let klein = GroupName::surface(false, 2);
        assert_eq!(klein.clone().times_integers().to_string(), "Klein bottle group x Z");
        assert_eq!(klein.times_integers().times_integers().to_string(), "Klein bottle group x Z^2");
        assert_eq!(two().times_integers().to_string(), "Z x Z/2");
        let product = GroupName::free_product(vec![two().times_integers(), GroupName::surface(true, 2)]);
        assert_eq!(product.to_string(), "(Z x Z/2) * orientable surface group of genus 2");
        assert_eq!(two().order().as_deref(), Some("2"));
        assert_eq!(GroupName::Free(2).order(), None);
    }
}
