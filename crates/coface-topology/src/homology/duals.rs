//! What tells generators apart: cochains for cycles, and cycles for cocycles.

use crate::homology::basis::{HomologyBasis, to_chain};
use crate::homology::class::{Cocycle, Generator};
use crate::homology::coefficients::Coefficients;
use coface_algebra::chains::{Chain, Cochain};
use coface_algebra::{CellId, Integer, SparseVector, combination, inner_product};

impl HomologyBasis<'_> {
    /// For each of [`Self::generators_with`] a cochain: it is closed modulo N, and has the value N/m on the generator, of order m, and 0 on
    /// the other ones, modulo N. Over Z and Q, N is m; over Z/n it is n. For a free generator over Z and Q the cochain is closed, and the
    /// values are 1 and 0. So these cochains prove that the generators are independent and have their orders.
    ///
    /// # Complexity
    /// That of [`Self::cocycles`], and over Z/n the values of all cochains on all generators.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, HomologyBasis};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// let duals = basis.generator_duals(1, Coefficients::Integers);
    /// // Closed modulo 2 alone: its coboundary has the value 2 on the disk.
    /// assert_eq!(duals[0].pairing(basis.generators(1)[0].chain())?, Some(1.into()));
    /// # Ok(()) }
    /// ```
    pub fn generator_duals(&self, degree: usize, coefficients: Coefficients) -> Vec<Cochain<Integer>> {
        let Some(basis) = self.degrees.get(degree) else { return Vec::new() };
        let positions = basis.generators();
        let positions = match coefficients {
            Coefficients::Integers => positions,
            Coefficients::Rationals => basis.rank + basis.orders.len()..positions.end,
            Coefficients::Modulo(n) => {
                let modulus = Integer::from(n);
                let (summands, chains) = self.cyclic_generators(degree, &modulus);
                let (_, cochains) = self.cyclic_cocycles(degree, &modulus);
                let duals = summands.duals(corrected(&cochains, &chains, Some(&modulus))).into_iter();
                return duals.map(|terms| self.cochain(degree, terms)).collect();
            }
        };
        self.pulled_back(degree, &basis.duals[positions])
    }

    /// For each of [`Self::cocycles_with`] a chain: its boundary is zero modulo N, and the cocycle, of order m, has the value N/m on it and
    /// the other ones 0, modulo N. N is as for [`Self::generator_duals`].
    ///
    /// # Complexity
    /// That of [`Self::generators_with`], and the values of all cocycles on all chains.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, HomologyBasis};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let basis = HomologyBasis::new(&plane);
    /// // The boundary of the disk is twice the loop.
    /// let disk = &basis.cocycle_duals(2, Coefficients::Integers)[0];
    /// assert_eq!(basis.cocycles(2)[0].cochain().pairing(disk)?, Some(1.into()));
    /// # Ok(()) }
    /// ```
    pub fn cocycle_duals(&self, degree: usize, coefficients: Coefficients) -> Vec<Chain<Integer>> {
        if let Coefficients::Modulo(n) = coefficients {
            let modulus = Integer::from(n);
            let (summands, cochains) = self.cyclic_cocycles(degree, &modulus);
            let (_, chains) = self.cyclic_generators(degree, &modulus);
            let duals = summands.duals(corrected(&chains, &cochains, Some(&modulus))).into_iter();
            return duals.map(|terms| to_chain(self.complex, degree, terms)).collect();
        }
        let mut chains: Vec<SparseVector> = Vec::new();
        if coefficients == Coefficients::Integers
            && let Some(below) = degree.checked_sub(1)
        {
            let torsion = (0..self.generators(below).len()).filter_map(|i| self.certificate(below, i));
            chains.extend(torsion.map(|chain| terms_of(chain.terms())));
        }
        let free = self.generators(degree).iter().filter(|one| one.order().is_none());
        chains.extend(free.map(Generator::chain).map(|chain| terms_of(chain.terms())));
        let cocycles = self.cocycles_with(degree, coefficients);
        let cochains: Vec<_> =
            cocycles.iter().map(Cocycle::cochain).map(|one| terms_of(one.terms())).collect();
        let corrected = corrected(&chains, &cochains, None).into_iter();
        corrected.map(|terms| to_chain(self.complex, degree, terms)).collect()
    }

    pub(super) fn cochain(&self, degree: usize, terms: SparseVector) -> Cochain<Integer> {
        let terms = terms.into_iter().map(|(cell, x)| (CellId::new(cell as usize), x));
        Cochain::new(self.complex, degree, terms).expect("the cells are those of a cochain of the complex")
    }
}

fn terms_of(terms: &[(CellId, Integer)]) -> SparseVector {
    terms.iter().map(|(cell, x)| (cell.to_u32(), x.clone())).collect()
}

/// Subtracts multiples of the other vectors from each, so that it has the value 0 with all `others` but its own.
///
/// The values of vector i with other i divide those of vector j with other i, and what is subtracted has no value with a third one: a free
/// generator may have values with the chain that a multiple of a generator one degree below bounds, but not the other way around.
fn corrected(
    vectors: &[SparseVector],
    others: &[SparseVector],
    modulus: Option<&Integer>,
) -> Vec<SparseVector> {
    let value = |vector: &SparseVector, other: &SparseVector| {
        let value = inner_product(vector, other);
        modulus.map_or(value.clone(), |n| value.div_rem_floor(n).1)
    };
    let one = |j: usize| {
        let mut corrected = vectors[j].clone();
        for (i, other) in others.iter().enumerate().filter(|(i, _)| *i != j) {
            let rest = value(&vectors[j], other);
            if !rest.is_zero() {
                let unit = value(&vectors[i], other);
                let times =
                    rest.exact_quotient(&unit).expect("values of one summand are multiples of its own");
                corrected = combination(&Integer::ONE, &corrected, &-&times, &vectors[i]);
            }
        }
        if let Some(n) = modulus {
            corrected.iter_mut().for_each(|(_, x)| *x = x.div_rem_nearest(n).1);
            corrected.retain(|(_, x)| !x.is_zero());
        }
        corrected
    };
    (0..vectors.len()).map(one).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::samples::random_complexes;
    use proptest::prelude::*;

    proptest! {
        /// Invariant 18: what tells generators apart is closed on the other side, and has unit values.
        #[test]
        fn duals_have_unit_values(complex in random_complexes(), n in 0u64..13) {
            let coefficients = match n {
                0 => Coefficients::Integers,
                1 => Coefficients::Rationals,
                n => Coefficients::Modulo(n),
            };
            let basis = HomologyBasis::new(&complex);
            let modulus = |order: Option<&Integer>| match coefficients {
                Coefficients::Modulo(n) => Integer::from(n),
                _ => order.cloned().unwrap_or(Integer::ZERO),
            };
            let is_zero = |x: &Integer, n: &Integer| x.is_zero() || !n.is_zero() && n.divides(x);
            let unit = |order: Option<&Integer>| match (coefficients, order) {
                (Coefficients::Modulo(n), Some(order)) => Integer::from(n).exact_quotient(order).unwrap(),
                _ => Integer::ONE,
            };
            for degree in 0..complex.degree_count() {
                let generators = basis.generators_with(degree, coefficients);
                let duals = basis.generator_duals(degree, coefficients);
                prop_assert_eq!(generators.len(), duals.len());
                for (j, dual) in duals.iter().enumerate() {
                    let n = modulus(generators[j].order());
                    prop_assert!(complex.coboundary(dual).unwrap().terms().iter().all(|(_, x)| is_zero(x, &n)));
                    for (i, generator) in generators.iter().enumerate() {
                        let value = dual.pairing(generator.chain()).unwrap().unwrap_or(Integer::ZERO);
                        let expected = if i == j { unit(generator.order()) } else { Integer::ZERO };
                        prop_assert!(is_zero(&(&value - &expected), &n), "{} {} {}", i, j, value);
                    }
                }
                let cocycles = basis.cocycles_with(degree, coefficients);
                let duals = basis.cocycle_duals(degree, coefficients);
                prop_assert_eq!(cocycles.len(), duals.len());
                for (j, dual) in duals.iter().enumerate() {
                    let n = modulus(cocycles[j].order());
                    prop_assert!(complex.boundary(dual).unwrap().terms().iter().all(|(_, x)| is_zero(x, &n)));
                    for (i, cocycle) in cocycles.iter().enumerate() {
                        let value = cocycle.cochain().pairing(dual).unwrap().unwrap_or(Integer::ZERO);
                        let expected = if i == j { unit(cocycle.order()) } else { Integer::ZERO };
                        prop_assert!(is_zero(&(&value - &expected), &n), "{} {} {}", i, j, value);
                    }
                }
            }
        }
    }
}
