//! Finitely generated abelian groups.

use coface_algebra::Integer;
use std::fmt;

/// A finitely generated abelian group $R^b \oplus \mathbb{Z}/t_1 \oplus \dots \oplus \mathbb{Z}/t_r$ with
/// $1 < t_1 \mid t_2 \mid \dots \mid t_r$, the invariant factors, where R is the ring of coefficients.
///
/// # Examples
/// ```
/// use coface_topology::AbelianGroup;
/// let group = AbelianGroup::new(2, vec![2.into(), 4.into()]);
/// assert_eq!(group.to_string(), "Z^2 + Z/2 + Z/4");
/// assert_eq!(AbelianGroup::new(0, vec![]).to_string(), "0");
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq, Hash)]
pub struct AbelianGroup {
    betti: usize,
    torsion: Vec<Integer>,
}

impl AbelianGroup {
    /// The group with this rank and cyclic summands of these orders, which need not divide each other; orders 1 are
    /// dropped, an order 0 is an infinite cyclic summand.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::AbelianGroup;
    /// // Z/2 + Z/3 is cyclic.
    /// let group = AbelianGroup::new(1, vec![2.into(), 3.into()]);
    /// assert_eq!(group.to_string(), "Z + Z/6");
    /// ```
    pub fn new(betti: usize, orders: Vec<Integer>) -> Self {
        let (mut betti, mut torsion) = (betti, Vec::new());
        for order in orders {
            if order.is_zero() {
                betti += 1;
            } else {
                insert_order(&mut torsion, order.abs());
            }
        }
        Self { betti, torsion }
    }

    /// The rank of the free part: the Betti number.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::AbelianGroup;
    /// assert_eq!(AbelianGroup::new(2, vec![4.into()]).betti(), 2);
    /// ```
    pub fn betti(&self) -> usize {
        self.betti
    }

    /// The invariant factors of the torsion part, each dividing the next, none 1.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::AbelianGroup;
    /// assert_eq!(AbelianGroup::new(2, vec![2.into(), 3.into()]).torsion(), [6.into()]);
    /// ```
    pub fn torsion(&self) -> &[Integer] {
        &self.torsion
    }

    /// Whether the group is zero.
    ///
    /// # Examples
    /// ```
    /// use coface_topology::AbelianGroup;
    /// assert!(AbelianGroup::new(0, vec![1.into()]).is_trivial());
    /// assert!(!AbelianGroup::new(1, vec![]).is_trivial());
    /// ```
    pub fn is_trivial(&self) -> bool {
        self.betti == 0 && self.torsion.is_empty()
    }
}

/// Adds a cyclic summand to invariant factors: $\mathbb{Z}/a \oplus \mathbb{Z}/b = \mathbb{Z}/\gcd \oplus
/// \mathbb{Z}/\mathrm{lcm}$, from the largest factor down.
fn insert_order(factors: &mut Vec<Integer>, order: Integer) {
    let mut carried = order;
    for factor in factors.iter_mut().rev() {
        let gcd = factor.gcd(&carried);
        let cofactor = carried.exact_quotient(&gcd).expect("a gcd divides");
        *factor *= &cofactor;
        carried = gcd;
    }
    if carried != Integer::ONE {
        factors.insert(0, carried);
    }
}

impl fmt::Display for AbelianGroup {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut summands = Vec::new();
        match self.betti {
            0 => {}
            1 => summands.push("Z".to_owned()),
            rank => summands.push(format!("Z^{rank}")),
        }
        for equal in self.torsion.chunk_by(|a, b| a == b) {
            summands.push(match equal.len() {
                1 => format!("Z/{}", equal[0]),
                count => format!("(Z/{})^{count}", equal[0]),
            });
        }
        f.write_str(if summands.is_empty() { "0" } else { "" })?;
        f.write_str(&summands.join(" + "))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn invariant_factors_divide_along_and_keep_the_group(orders in prop::collection::vec(1i64..40, 0..6)) {
            let group = AbelianGroup::new(0, orders.iter().map(|&n| n.into()).collect());
            for pair in group.torsion().windows(2) {
                prop_assert!(pair[0].divides(&pair[1]));
            }
            prop_assert!(!group.torsion().contains(&Integer::ONE));
            // Two finite abelian groups are isomorphic when multiplication by n kills equally many elements for all n.
            for n in 1..80 {
                let killed = |orders: &[i64]| orders.iter().map(|&t| i128::from(gcd(t, n))).product::<i128>();
                let factors: Vec<i64> = group.torsion().iter().map(|t| t.to_i64().unwrap()).collect();
                prop_assert_eq!(killed(&orders), killed(&factors));
            }
        }
    }

    fn gcd(a: i64, b: i64) -> i64 {
        if b == 0 { a } else { gcd(b, a % b) }
    }

    #[test]
    fn order_zero_is_infinite() {
        let group = AbelianGroup::new(1, vec![0.into(), 6.into(), 1.into(), 4.into(), 2.into()]);
        assert_eq!((group.betti(), group.to_string()), (2, "Z^2 + (Z/2)^2 + Z/12".to_owned()));
    }
}
