//! Groups from ranks and invariant factors, over the ring that was asked for.

use crate::Fault;
use dashu_int::IBig;
use dashu_int::ops::Gcd;
use std::fmt::Write;

/// A finitely generated module: free summands, and the orders of the others, each a divisor of the next.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Group {
    pub(crate) betti: usize,
    pub(crate) torsion: Vec<IBig>,
}

/// The ring of coefficients.
pub(crate) enum Ring {
    Integers,
    Rationals,
    Modulo(IBig),
}

impl Ring {
    pub(crate) fn of(name: &str, step: &str) -> Result<Self, Fault> {
        let modulus = |digits: &str| -> Option<u32> { digits.parse().ok().filter(|n| *n >= 2) };
        let found = match name {
            "Z" => Some(Self::Integers),
            "Q" => Some(Self::Rationals),
            _ => match (name.strip_prefix("Z/"), name.strip_prefix("F_")) {
                (Some(n), _) => modulus(n).map(|n| Self::Modulo(n.into())),
                (_, Some(p)) => modulus(p).filter(|p| is_prime(*p)).map(|p| Self::Modulo(p.into())),
                _ => None,
            },
        };
        found.ok_or_else(|| Fault::new(step, format!("{name:?} is no ring that the checker knows")))
    }

    /// The groups over this ring of a complex with these integral homology groups, by the universal coefficient theorem.
    pub(crate) fn groups(&self, integral: &[Group], cohomology: bool) -> Vec<Group> {
        let below = |k: usize| k.checked_sub(1).map_or(&[][..], |below| &integral[below].torsion);
        let group = |(k, own): (usize, &Group)| match self {
            Self::Integers if cohomology => Group { betti: own.betti, torsion: below(k).to_vec() },
            Self::Integers => own.clone(),
            Self::Rationals => Group { betti: own.betti, torsion: Vec::new() },
            Self::Modulo(n) => {
                // Over Z/n homology and cohomology are isomorphic: the same numbers of summands of the same orders.
                let orders = own.torsion.iter().chain(below(k)).map(|order| IBig::from(order.gcd(n)));
                let mut orders = divisor_chain(orders.filter(|order| *order != IBig::ONE).collect());
                let torsion_end = orders.iter().position(|order| order == n).unwrap_or(orders.len());
                let full = orders.split_off(torsion_end).len();
                Group { betti: own.betti + full, torsion: orders }
            }
        };
        integral.iter().enumerate().map(group).collect()
    }

    /// n for Z/n, and 0 for Z and Q.
    pub(crate) fn modulus(&self) -> IBig {
        match self {
            Self::Modulo(n) => n.clone(),
            Self::Integers | Self::Rationals => IBig::ZERO,
        }
    }

    fn summand(&self) -> String {
        match self {
            Self::Integers => "Z".to_owned(),
            Self::Rationals => "Q".to_owned(),
            Self::Modulo(n) => format!("Z/{n}"),
        }
    }

    /// A group for people, such as `Z^2 + Z/3`.
    pub(crate) fn in_words(&self, group: &Group) -> String {
        let mut words = String::new();
        match group.betti {
            0 => (),
            1 => words += &self.summand(),
            betti if matches!(self, Self::Modulo(_)) => {
                let _ = write!(words, "({})^{betti}", self.summand());
            }
            betti => {
                let _ = write!(words, "{}^{betti}", self.summand());
            }
        }
        for order in &group.torsion {
            let _ = write!(words, "{}Z/{order}", if words.is_empty() { "" } else { " + " });
        }
        if words.is_empty() { "0".to_owned() } else { words }
    }
}

/// Orders of a sum of cyclic groups in which each divides the next: Z/a + Z/b is Z/gcd + Z/lcm.
fn divisor_chain(mut orders: Vec<IBig>) -> Vec<IBig> {
    orders.sort_unstable();
    for i in 0..orders.len() {
        for j in i + 1..orders.len() {
            let gcd = IBig::from((&orders[i]).gcd(&orders[j]));
            orders[j] = &orders[i] / &gcd * &orders[j];
            orders[i] = gcd;
        }
    }
    orders.retain(|order| *order != IBig::ONE);
    orders
}

/// Whether a number is prime.
///
/// # Examples
/// ```
/// assert!(coface_check::is_prime(7) && !coface_check::is_prime(1));
/// ```
pub fn is_prime(p: u32) -> bool {
    p >= 2
        && (2..)
            .take_while(|d| u64::from(*d) * u64::from(*d) <= u64::from(p))
            .all(|d: u32| !p.is_multiple_of(d))
}

/// The homology of a complex of free groups from the numbers of its cells and the invariant factors of its boundaries.
pub(crate) fn integral(counts: &[usize], factors: &[Vec<IBig>], step: &str) -> Result<Vec<Group>, Fault> {
    let factors_of =
        |degree: usize| degree.checked_sub(1).and_then(|k| factors.get(k)).map_or(&[][..], |f| f);
    let group = |(k, count): (usize, &usize)| {
        let betti = count.checked_sub(factors_of(k).len() + factors_of(k + 1).len());
        let betti =
            betti.ok_or_else(|| Fault::new(step, format!("the ranks around degree {k} are too large")))?;
        let torsion = factors_of(k + 1).iter().filter(|factor| **factor != IBig::ONE).cloned().collect();
        Ok(Group { betti, torsion })
    };
    counts.iter().enumerate().map(group).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn orders_become_a_chain_of_divisors() {
        let chain = divisor_chain([4, 6, 10, 3].map(IBig::from).to_vec());
        assert_eq!(chain, [2, 6, 60].map(IBig::from));
    }

    #[test]
    fn only_prime_fields_are_fields() {
        assert!(Ring::of("F_7", "").is_ok() && Ring::of("Z/4", "").is_ok());
        assert!(Ring::of("F_4", "").is_err() && Ring::of("Z/1", "").is_err() && Ring::of("R", "").is_err());
    }
}
