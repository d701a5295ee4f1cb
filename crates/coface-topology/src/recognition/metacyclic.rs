//! Groups of two generators of which one inverts the other: quotients of the group of the Klein bottle.

use crate::groups::Presentation;
use crate::recognition::group_name::GroupName;
use coface_algebra::Word;

/// An element $b^i a^j$ of the group of the Klein bottle, in which $a b a^{-1} = b^{-1}$.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Element {
    i: i128,
    j: i128,
}

impl Element {
    /// The element times a letter: 1 is a, 2 is b.
    fn times(self, letter: i32) -> Option<Self> {
        let sign = i128::from(letter.signum());
        Some(match letter.unsigned_abs() {
            1 => Self { j: self.j.checked_add(sign)?, ..self },
            _ if self.j.rem_euclid(2) == 0 => Self { i: self.i.checked_add(sign)?, ..self },
            _ => Self { i: self.i.checked_sub(sign)?, ..self },
        })
    }

    fn of(word: impl IntoIterator<Item = i32>) -> Option<Self> {
        word.into_iter().try_fold(Self { i: 0, j: 0 }, Self::times)
    }
}

/// The group with generators a and b in which $a b a^{-1} = b^{-1}$ and further relators hold, if one of the given
/// presentation says the first or follows from it and the others; `None` says nothing.
///
/// Each relator is an element $b^i a^j$ of the group of the Klein bottle. Where all j are even, these are elements of its
/// abelian subgroup of index 2, and what they generate together with their conjugates is a lattice that is its own mirror
/// image: either that of $(p, 0), (0, 2q)$ or that of $(p, 0), (p/2, 2q)$. So b has the order p, and $a^{2q}$ is 1 or $b^{p/2}$.
///
/// For $2q = 2^k m$ with m odd, $a^{2^k}$ is central and $\langle a \rangle$ the product of $\langle a^m \rangle$ with what it
/// generates, so that $\mathbb Z/m$ is a direct factor.
pub(super) fn inverted(group: &Presentation) -> Option<GroupName> {
    if group.generator_count() != 2 {
        return None;
    }
    [[1, 2], [2, 1]].into_iter().find_map(|[a, b]| {
        // a as letter 1, b as letter 2.
        let renamed = |word: &Word| -> Vec<i32> {
            let letter = |&letter: &i32| {
                if letter.abs() == a {
                    letter.signum()
                } else {
                    debug_assert_eq!(letter.abs(), b);
                    2 * letter.signum()
                }
            };
            word.letters().iter().map(letter).collect()
        };
        let relators: Vec<Vec<i32>> = group.relators().iter().map(renamed).collect();
        inverts(&relators).then(|| quotient(&relators)).flatten()
    })
}

/// Whether the relators say that a inverts b: one is a b a^-1 b, up to the signs of a where its square is a relator too.
fn inverts(relators: &[Vec<i32>]) -> bool {
    let is_involution = relators.iter().any(|relator| matches!(relator[..], [1, 1] | [-1, -1]));
    relators.iter().any(|relator| {
        let [x, y, z, w] = relator[..] else { return false };
        // Two letters of each kind, by turns; b twice the same way, a once each way.
        let is_klein = |a: [i32; 2], b: [i32; 2]| {
            a.iter().all(|letter| letter.abs() == 1)
                && b.iter().all(|letter| letter.abs() == 2)
                && b[0] == b[1]
                && (a[0] != a[1] || is_involution)
        };
        is_klein([x, z], [y, w]) || is_klein([y, w], [x, z])
    })
}

/// The quotient of the group of the Klein bottle by these relators.
fn quotient(relators: &[Vec<i32>]) -> Option<GroupName> {
    let elements: Option<Vec<Element>> =
        relators.iter().map(|relator| Element::of(relator.iter().copied())).collect();
    let elements = elements?;
    if elements.iter().any(|element| element.j % 2 != 0) {
        // Then b squared is a relator, and the group is abelian: others say which.
        return None;
    }
    // The lattice of all of them with their mirror images: rows (i, j), j even, in echelon form.
    let rows = elements.iter().flat_map(|&Element { i, j }| [[i, j], [i.checked_neg().unwrap_or(0), j]]);
    let mut first: Option<[i128; 2]> = None;
    let mut p = 0i128;
    for row in rows {
        let mut row = row;
        if let Some(mut held) = first {
            while row[1] != 0 {
                let times = held[1].div_euclid(row[1]);
                let next = [
                    held[0].checked_sub(times.checked_mul(row[0])?)?,
                    held[1].checked_sub(times.checked_mul(row[1])?)?,
                ];
                (held, row) = (row, next);
            }
            first = Some(held);
        } else if row[1] != 0 {
            first = Some(row);
            continue;
        }
        p = gcd(p, row[0]);
    }
    let [shift, height] = first.unwrap_or([0, 0]);
    let height = height.unsigned_abs();
    if p == 0 {
        return match (shift, height) {
            (0, 0) => Some(GroupName::surface(false, 2)),
            // A group with Z inverted by an involution.
            (0, 2) => {
                let two = || GroupName::surface(false, 1);
                Some(GroupName::free_product(vec![two(), two()]))
            }
            _ => None,
        };
    }
    let p = p.unsigned_abs();
    let shift = shift.unsigned_abs() % p;
    if p < 3 || height == 0 {
        return None;
    }
    let order = usize::try_from(p.checked_mul(height)?).ok()?;
    // Mirrored rows differ by twice the shift: it is 0 or half of p.
    let is_rhombic = shift != 0;
    let name = if is_rhombic && !(p / 2).is_multiple_of(2) {
        // b to the power of p/2 is that of a: b^2 alone is inverted, and a has twice the order.
        name_of_inversion_product(p / 2, 2 * height)
    } else if is_rhombic {
        let two_power = height & height.wrapping_neg();
        let odd = height / two_power;
        let own = match two_power {
            2 if p == 4 => "Q8".to_owned(),
            2 => format!("dicyclic group of order {}", 2 * p),
            _ => format!("<a, b | a b a^-1 = b^-1, a^{two_power} = b^{}>", p / 2),
        };
        name_of_cyclic_product(own, odd)
    } else {
        name_of_inversion_product(p, height)
    };
    Some(GroupName::Finite { order, name: Some(name) })
}

/// The name of the group in which an element of even order n inverts one of order p, with nothing in common.
pub(crate) fn name_of_inversion_product(p: u128, n: u128) -> String {
    let two_power = n & n.wrapping_neg();
    let own = match (two_power, p) {
        (2, 3) => "S3".to_owned(),
        (2, _) => format!("dihedral group of order {}", 2 * p),
        (4, _) if !p.is_multiple_of(2) => format!("dicyclic group of order {}", 4 * p),
        _ => format!("semidirect product of Z/{p} by Z/{two_power}, acting by inversion"),
    };
    name_of_cyclic_product(own, n / two_power)
}

/// The name of the direct product with a cyclic group of odd order.
pub(crate) fn name_of_cyclic_product(own: String, odd: u128) -> String {
    match odd {
        1 => own,
        odd if own.contains(' ') && own.contains(',') => format!("({own}) x Z/{odd}"),
        odd => format!("{own} x Z/{odd}"),
    }
}

fn gcd(a: i128, b: i128) -> i128 {
    let (mut a, mut b) = (a, b);
    while b != 0 {
        (a, b) = (b, a % b);
    }
    a
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::groups::CosetTable;
    use crate::{AbelianGroup, Effort};

    fn group(relators: &[&[i32]]) -> Presentation {
        Presentation::new(2, relators.iter().map(|word| Word::from_letters(word.iter().copied())).collect())
            .unwrap()
    }

    fn power(letter: i32, exponent: i32) -> Vec<i32> {
        vec![letter * exponent.signum(); exponent.unsigned_abs() as usize]
    }

    fn name(group: &Presentation) -> Option<String> {
        inverted(group).map(|name| name.to_string())
    }

    #[test]
    fn the_infinite_dihedral_group_is_a_free_product() {
        assert_eq!(name(&group(&[&[1, 2, -1, 2], &[1, 1]])).as_deref(), Some("Z/2 * Z/2"));
        assert_eq!(name(&group(&[&[1, 2, 1, 2], &[1, 1]])).as_deref(), Some("Z/2 * Z/2"));
        assert_eq!(name(&group(&[&[2, 1, -2, 1], &[-2, -2]])).as_deref(), Some("Z/2 * Z/2"));
        assert_eq!(name(&group(&[&[1, 2, -1, 2]])).as_deref(), Some("Klein bottle group"));
        // (ab)^2 alone inverts nothing.
        assert_eq!(name(&group(&[&[1, 2, 1, 2]])), None);
    }

    /// The order is that of coset enumeration, and where a table of the group names it too, the names agree.
    #[test]
    fn orders_and_names_agree_with_the_enumeration_of_cosets() {
        let mut named = 0;
        for p in 3..=10i32 {
            for n in 1..=12i32 {
                for half in [false, true] {
                    if half && (p % 2 == 1 || n % 2 == 1) {
                        continue;
                    }
                    let klein = [1, 2, -1, 2];
                    let mut relator = power(1, n);
                    if half {
                        relator.extend(power(-2, p / 2));
                    }
                    let group = group(&[&klein, &power(2, p), &relator]);
                    let cosets = CosetTable::new(&group, &[], 10_000).unwrap();
                    let Some(found) = inverted(&group) else {
                        // An odd power of a is central, and b its own inverse.
                        assert!(n % 2 == 1, "{group}");
                        continue;
                    };
                    assert_eq!(found.order(), Some(cosets.index().to_string()), "{group}");
                    let GroupName::Finite { name: Some(found), .. } = found else { panic!("{group}") };
                    let table = crate::recognition::finite_group::FiniteGroup::new(&cosets).unwrap();
                    if let Some(known) = table.name() {
                        named += 1;
                        // A cyclic factor of odd order may be written with or without that of the other part.
                        let is_same = known == found || known.contains(" x ") || found.contains(" x ");
                        assert!(is_same, "{group}: {known}, {found}");
                    }
                }
            }
        }
        assert!(named >= 30, "{named}");
    }

    #[test]
    fn groups_of_prism_manifolds_have_orders_at_once() {
        // Two relators with long words, as they come from a triangulation: b^37 is inverted, and a^104 = 1.
        let long: Vec<i32> = power(2, 37).into_iter().chain(power(1, 104)).collect();
        let group = group(&[&[2, 1, 2, -1], &long]);
        let found = inverted(&group).unwrap();
        assert_eq!(found.order(), Some("7696".to_owned()));
        assert_eq!(found.to_string(), "(semidirect product of Z/37 by Z/16, acting by inversion) x Z/13");
        assert_eq!(group.abelianization(), AbelianGroup::new(0, vec![208.into()]));
        assert_eq!(group.recognized(Effort::default()), Some(found));
    }
}
