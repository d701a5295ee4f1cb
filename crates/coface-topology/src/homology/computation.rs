//! Homology and cohomology groups.

use crate::homology::abelian_group::AbelianGroup;
use crate::homology::coefficients::Coefficients;
use coface_algebra::chains::{ChainComplex, MorseComplex};
use coface_algebra::{Entry, Integer, invariant_factors};

/// The homology or cohomology groups of a complex, by degree.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Homology {
    groups: Vec<AbelianGroup>,
}

impl Homology {
    pub(super) fn from_groups(groups: Vec<AbelianGroup>) -> Self {
        Self { groups }
    }

    /// The groups of degrees 0, 1, ..., up to the highest degree of the complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::homology;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// assert_eq!(homology(&plane).groups()[1].to_string(), "Z/2");
    /// # Ok(()) }
    /// ```
    pub fn groups(&self) -> &[AbelianGroup] {
        &self.groups
    }

    /// The Betti numbers of degrees 0, 1, ...
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::homology;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// assert_eq!(homology(&plane).betti_numbers(), [1, 0, 0]);
    /// # Ok(()) }
    /// ```
    pub fn betti_numbers(&self) -> Vec<usize> {
        self.groups.iter().map(AbelianGroup::betti).collect()
    }

    /// The torsion of each degree: invariant factors, each dividing the next.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::homology;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// assert_eq!(homology(&plane).torsion()[1], [2.into()]);
    /// # Ok(()) }
    /// ```
    pub fn torsion(&self) -> Vec<&[Integer]> {
        self.groups.iter().map(AbelianGroup::torsion).collect()
    }

    /// Of integral homology: homology with other coefficients; see [`homology_with`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, homology};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let over_f2 = homology(&plane).with_coefficients(Coefficients::Modulo(2));
    /// assert_eq!(over_f2.betti_numbers(), [1, 1, 1]);
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn with_coefficients(&self, coefficients: Coefficients) -> Self {
        change_coefficients(self, coefficients)
    }

    /// Of integral homology: cohomology with coefficients; see [`cohomology`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::{Coefficients, homology};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// let cohomology = homology(&plane).dual(Coefficients::Integers);
    /// assert_eq!(cohomology.groups()[2].to_string(), "Z/2");
    /// # Ok(()) }
    /// ```
    #[must_use]
    pub fn dual(&self, coefficients: Coefficients) -> Self {
        if coefficients != Coefficients::Integers {
            // Hom(Z/m, G) and Ext(Z/m, G) are what Z/m tensor G and Tor(Z/m, G) are, for G = Q and G = Z/n.
            return change_coefficients(self, coefficients);
        }
        let below = |degree: usize| degree.checked_sub(1).map_or(&[][..], |k| self.groups[k].torsion());
        let groups = self.groups.iter().enumerate();
        Self {
            groups: groups.map(|(k, group)| AbelianGroup::new(group.betti(), below(k).to_vec())).collect(),
        }
    }

    /// The alternating sum of the Betti numbers. Over Z, Q and prime fields it is the Euler characteristic.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::homology;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // The projective plane: one vertex, one loop, and a disk that runs twice along it.
    /// let plane = ChainComplex::new(vec![
    ///     SparseMatrix::zero(1, 1)?,
    ///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
    /// ])?;
    /// assert_eq!(homology(&plane).euler_characteristic(), 1);
    /// # Ok(()) }
    /// ```
    pub fn euler_characteristic(&self) -> i64 {
        let signed = |(k, group): (usize, &AbelianGroup)| {
            if k % 2 == 0 { group.betti() as i64 } else { -(group.betti() as i64) }
        };
        self.groups.iter().enumerate().map(signed).sum()
    }
}

/// The integral homology of a chain complex: Betti numbers and torsion, exact.
///
/// # Complexity
/// Near-linear in the entries of the boundary matrices for complexes on which acyclic matching leaves few cells, as it
/// does on meshes; the Smith normal form of what it leaves is polynomial.
///
/// # References
/// J. R. Munkres, *Elements of Algebraic Topology* (1984), section 11.
///
/// # Examples
/// The projective plane as one vertex, one loop and one disk that runs twice along the loop:
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::ChainComplex;
/// use coface_topology::homology;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let plane = ChainComplex::new(vec![
///     SparseMatrix::zero(1, 1)?,
///     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
/// ])?;
/// let groups: Vec<String> = homology(&plane).groups().iter().map(|group| group.to_string()).collect();
/// assert_eq!(groups, ["Z", "Z/2", "0"]);
/// # Ok(()) }
/// ```
pub fn homology<E: Entry>(complex: &ChainComplex<E>) -> Homology {
    let morse = MorseComplex::new(complex);
    // The nonzero invariant factors of the boundary from each degree.
    let factors: Vec<Vec<Integer>> = (0..=complex.degree_count())
        .map(|degree| invariant_factors(&morse.boundary_matrix(degree)))
        .collect();
    let groups = (0..complex.degree_count()).map(|degree| {
        let betti = morse.critical_count(degree) - factors[degree].len() - factors[degree + 1].len();
        AbelianGroup::new(betti, factors[degree + 1].clone())
    });
    Homology { groups: groups.collect() }
}

/// Homology with coefficients, from integral homology by the universal coefficient theorem:
/// $H_k(C; G) = H_k(C) \otimes G \oplus \operatorname{Tor}(H_{k-1}(C), G)$, each group with its own coefficients plus
/// what the torsion one degree below contributes.
///
/// Over Z/n the "Betti number" counts the summands Z/n, and the torsion lists the cyclic summands of smaller order.
///
/// # Examples
/// Over the field with two elements the projective plane has one class in each degree:
/// ```
/// # use coface_algebra::SparseMatrix;
/// # use coface_algebra::chains::ChainComplex;
/// use coface_topology::{Coefficients, homology_with};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// # let plane = ChainComplex::new(vec![
/// #     SparseMatrix::zero(1, 1)?,
/// #     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
/// # ])?;
/// assert_eq!(homology_with(&plane, Coefficients::Modulo(2)).betti_numbers(), [1, 1, 1]);
/// assert_eq!(homology_with(&plane, Coefficients::Modulo(3)).betti_numbers(), [1, 0, 0]);
/// # Ok(()) }
/// ```
pub fn homology_with(complex: &ChainComplex, coefficients: Coefficients) -> Homology {
    homology(complex).with_coefficients(coefficients)
}

/// Cohomology with coefficients: $H^k(C; G) = \operatorname{Hom}(H_k(C), G) \oplus
/// \operatorname{Ext}(H_{k-1}(C), G)$. Over Z the torsion of degree k is that of homology in degree k - 1.
///
/// # Examples
/// ```
/// # use coface_algebra::SparseMatrix;
/// # use coface_algebra::chains::ChainComplex;
/// use coface_topology::{Coefficients, cohomology};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// # let plane = ChainComplex::new(vec![
/// #     SparseMatrix::zero(1, 1)?,
/// #     SparseMatrix::from_entries(1, 1, [(0, 0, 2)])?,
/// # ])?;
/// let groups = cohomology(&plane, Coefficients::Integers);
/// assert_eq!(groups.groups()[2].to_string(), "Z/2");
/// # Ok(()) }
/// ```
pub fn cohomology(complex: &ChainComplex, coefficients: Coefficients) -> Homology {
    homology(complex).dual(coefficients)
}

fn change_coefficients(integral: &Homology, coefficients: Coefficients) -> Homology {
    let change = |(k, group): (usize, &AbelianGroup)| match coefficients {
        Coefficients::Integers => group.clone(),
        Coefficients::Rationals => AbelianGroup::new(group.betti(), Vec::new()),
        Coefficients::Modulo(n) => {
            let modulus = Integer::from(n);
            let below = k.checked_sub(1).map_or(&[][..], |k| integral.groups[k].torsion());
            let orders = group.torsion().iter().chain(below).map(|order| order.gcd(&modulus)).collect();
            // In invariant factors the summands Z/n gather at the end.
            let cyclic = AbelianGroup::new(0, orders);
            let full = cyclic.torsion().iter().filter(|&order| *order == modulus).count();
            let smaller = cyclic.torsion()[..cyclic.torsion().len() - full].to_vec();
            AbelianGroup::new(group.betti() + full, smaller)
        }
    };
    Homology { groups: integral.groups.iter().enumerate().map(change).collect() }
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::samples::random_complexes;
    use proptest::prelude::*;

    /// The second method: Smith normal form of the whole boundary matrices, without any matching.
    fn homology_by_smith_form(complex: &ChainComplex) -> Homology {
        let factors = |degree| complex.boundary_matrix(degree).map(invariant_factors).unwrap_or_default();
        let groups = (0..complex.degree_count()).map(|degree| {
            let (down, up) = (factors(degree), factors(degree + 1));
            AbelianGroup::new(complex.cell_count(degree) - down.len() - up.len(), up)
        });
        Homology { groups: groups.collect() }
    }

    /// The rank over a prime field by elimination of dense columns.
    fn rank_modulo(matrix: &coface_algebra::SparseMatrix, p: i64) -> usize {
        let dense = |column: coface_algebra::Column<'_>| -> Vec<i64> {
            (0..matrix.row_count()).map(|i| i64::from(column.entry(i)).rem_euclid(p)).collect()
        };
        let mut reduced: Vec<(usize, Vec<i64>)> = Vec::new();
        for mut column in matrix.columns().map(dense) {
            for (pivot, other) in &reduced {
                let factor = column[*pivot];
                column.iter_mut().zip(other).for_each(|(x, y)| *x = (*x - factor * y).rem_euclid(p));
            }
            if let Some(pivot) = column.iter().position(|&x| x != 0) {
                let inverse = (1..p).find(|x| x * column[pivot] % p == 1).unwrap();
                column.iter_mut().for_each(|x| *x = *x * inverse % p);
                reduced.push((pivot, column));
            }
        }
        reduced.len()
    }

    proptest! {
        /// Invariant 7, and invariant 6.
        #[test]
        fn reduction_agrees_with_smith_form(complex in random_complexes()) {
            let groups = homology(&complex);
            prop_assert_eq!(&groups, &homology_by_smith_form(&complex));
            prop_assert_eq!(groups.euler_characteristic(), complex.euler_characteristic());
        }

        /// Invariant 7: over F_p the universal coefficient theorem agrees with ranks taken modulo p.
        #[test]
        fn betti_numbers_over_fields_agree_with_ranks(complex in random_complexes(), p in prop::sample::select(vec![2, 3, 5])) {
            let rank = |degree| complex.boundary_matrix(degree).map_or(0, |matrix| rank_modulo(matrix, p));
            let expected: Vec<usize> =
                (0..complex.degree_count()).map(|k| complex.cell_count(k) - rank(k) - rank(k + 1)).collect();
            let modulo = Coefficients::Modulo(p as u64);
            prop_assert_eq!(&homology_with(&complex, modulo).betti_numbers(), &expected);
            prop_assert_eq!(&cohomology(&complex, modulo).betti_numbers(), &expected);
        }

        /// Cohomology is the homology of the transposed complex read backwards.
        #[test]
        fn cohomology_is_the_homology_of_the_dual(complex in random_complexes()) {
            let transposed = complex.boundary_matrices().iter().rev().map(|matrix| matrix.transpose());
            let dual = ChainComplex::new(transposed.collect()).unwrap();
            let mut backwards = homology(&dual).groups;
            backwards.reverse();
            prop_assert_eq!(cohomology(&complex, Coefficients::Integers).groups, backwards);
        }
    }

    #[test]
    fn composite_moduli_keep_cyclic_summands_of_smaller_order() {
        // A loop killed four times: H_0 = Z, H_1 = Z/4. Over Z/6: Z/6, then Z/2, then Tor(Z/4, Z/6) = Z/2.
        let complex = ChainComplex::new(vec![
            coface_algebra::SparseMatrix::zero(1, 1).unwrap(),
            coface_algebra::SparseMatrix::from_entries(1, 1, [(0, 0, 4)]).unwrap(),
        ])
        .unwrap();
        let groups = homology_with(&complex, Coefficients::Modulo(6));
        assert_eq!(groups.betti_numbers(), [1, 0, 0]);
        assert_eq!(groups.torsion(), [&[][..], &[2.into()], &[2.into()]]);
    }

    #[test]
    fn the_empty_complex_has_no_groups() {
        assert!(homology(&ChainComplex::of_points(0)).groups().is_empty());
        assert_eq!(homology(&ChainComplex::of_points(2)).betti_numbers(), [2]);
    }
}
