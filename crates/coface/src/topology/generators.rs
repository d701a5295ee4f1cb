//! Cycles that generate integral homology.

use crate::algebra::{Integer, WideMatrix, smith_form_with_transforms};
use crate::chains::{ChainComplex, MorseComplex};
use std::collections::BTreeMap;

/// A cycle on the original cells that generates one cyclic summand of integral homology.
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Generator {
    order: Option<Integer>,
    chain: Vec<(u32, Integer)>,
}

impl Generator {
    /// The least m > 0 such that m times the cycle bounds; `None` when no multiple does.
    pub fn order(&self) -> Option<&Integer> {
        self.order.as_ref()
    }

    /// The cycle: (cell, coefficient) by rising cells, no coefficient zero.
    pub fn chain(&self) -> &[(u32, Integer)] {
        &self.chain
    }
}

/// Cycles whose classes generate the integral homology of each degree: first those of finite order (orders dividing
/// along), then those of infinite order; as many as [`crate::topology::homology`] has cyclic summands.
///
/// # Complexity
/// That of [`crate::topology::homology`], Smith transforms of the Morse complex, and for each generator the cells that it reaches.
///
/// # Examples
/// The rim of a triangle has one loop, its three edges:
/// ```
/// use coface::algebra::SparseMatrix;
/// use coface::chains::ChainComplex;
/// use coface::topology::generators;
/// # fn main() -> Result<(), coface::Error> {
/// let rim =
///     SparseMatrix::from_entries(3, 3, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)])?;
/// let loops = generators(&ChainComplex::new(vec![rim])?);
/// assert_eq!(loops[1].len(), 1);
/// assert_eq!(loops[1][0].chain().len(), 3);
/// # Ok(()) }
/// ```
pub fn generators(complex: &ChainComplex) -> Vec<Vec<Generator>> {
    let morse = MorseComplex::new(complex);
    (0..complex.degree_count()).map(|degree| of_degree(&morse, degree)).collect()
}

/// With $U A V = D$ for the boundary A from this degree, the columns of V beyond the rank of A are a basis of the
/// cycles. The boundaries from one degree above in that basis, $M = (V^{-1} B)$ below the rank, have a Smith form
/// $P M Q = T$; then the columns of the basis times $P^{-1}$ generate, with the diagonal of T as orders.
fn of_degree(morse: &MorseComplex<'_>, degree: usize) -> Vec<Generator> {
    let boundary = smith_form_with_transforms(&morse.boundary_matrix(degree));
    let rank = boundary.form().rank();
    let from_above = morse.boundary_matrix(degree + 1);
    let in_basis = (0..from_above.column_count()).map(|j| {
        let coordinates = combination(boundary.right_inverse(), from_above.column(j).terms());
        coordinates
            .into_iter()
            .filter(|(row, _)| *row as usize >= rank)
            .map(|(row, x)| (row - rank as u32, x))
            .collect()
    });
    let cycle_count = morse.critical_count(degree) - rank;
    let bounding = WideMatrix::from_integer_columns(cycle_count, in_basis)
        .expect("rows beyond the rank fit where all rows did");
    let bounding = smith_form_with_transforms(&bounding);
    let orders = bounding.form().diagonal();
    (0..cycle_count)
        .filter(|&j| orders.get(j) != Some(&Integer::ONE))
        .map(|j| {
            let basis = bounding.left_inverse().column(j);
            let critical = combination(boundary.right(), basis.terms().map(|(i, x)| (i + rank, x)));
            Generator { order: orders.get(j).cloned(), chain: morse.inclusion(degree, &critical) }
        })
        .collect()
}

/// The combination of columns of a matrix with these coefficients, by rising rows.
fn combination<'a>(
    matrix: &WideMatrix,
    coefficients: impl Iterator<Item = (usize, &'a Integer)>,
) -> Vec<(u32, Integer)> {
    let mut sum: BTreeMap<u32, Integer> = BTreeMap::new();
    for (j, coefficient) in coefficients {
        for (row, entry) in matrix.column(j).terms() {
            *sum.entry(row as u32).or_default() += &(coefficient * entry);
        }
    }
    sum.into_iter().filter(|(_, x)| !x.is_zero()).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::algebra::{SparseMatrix, smith_form};
    use crate::chains::random_complexes;
    use crate::topology::homology;
    use proptest::prelude::*;

    fn columns(matrix: Option<&SparseMatrix>, cell_count: usize) -> Vec<Vec<(u32, Integer)>> {
        let column = |j| {
            matrix.map_or(Vec::new(), |m| m.column(j).iter().map(|(r, x)| (r as u32, x.into())).collect())
        };
        (0..cell_count).map(column).collect()
    }

    proptest! {
        /// Invariant 8. Generators are cycles, their orders are the group, and they generate: boundaries and
        /// generators together have the same quotient as the whole group of cycles.
        #[test]
        fn generators_are_cycles_that_generate(complex in random_complexes()) {
            let groups = homology(&complex);
            for (degree, found) in generators(&complex).into_iter().enumerate() {
                let group = &groups.groups()[degree];
                let orders: Vec<Integer> = found.iter().filter_map(|g| g.order().cloned()).collect();
                prop_assert_eq!(&orders[..], group.torsion());
                prop_assert_eq!(found.len() - orders.len(), group.betti());
                let count = complex.cell_count(degree);
                let below = complex.cell_count(degree.wrapping_sub(1));
                let boundary =
                    WideMatrix::from_integer_columns(below, columns(complex.boundary_matrix(degree), count)).unwrap();
                let mut bounding = columns(complex.boundary_matrix(degree + 1), complex.cell_count(degree + 1));
                for generator in &found {
                    let cycle = generator.chain().iter().map(|(cell, x)| (*cell as usize, x));
                    prop_assert!(combination(&boundary, cycle).is_empty());
                    bounding.push(generator.chain().to_vec());
                }
                // All cycles modulo boundaries and generators: zero, so the rank is that of the cycles and no factor
                // is left.
                let with_generators = smith_form(&WideMatrix::from_integer_columns(count, bounding).unwrap());
                prop_assert_eq!(with_generators.rank(), count - smith_form(&boundary).rank());
                prop_assert!(with_generators.torsion().is_empty());
            }
        }
    }

    /// m times a torsion generator bounds, and no smaller multiple does.
    #[test]
    fn torsion_generators_have_their_order() {
        // One vertex, two loops, disks along 2a + 4b and 6b: H_1 = Z/2 + Z/6.
        let complex = ChainComplex::new(vec![
            SparseMatrix::zero(1, 2).unwrap(),
            SparseMatrix::from_entries(2, 2, [(0, 0, 2), (1, 0, 4), (1, 1, 6)]).unwrap(),
        ])
        .unwrap();
        let loops = &generators(&complex)[1];
        assert_eq!(loops.iter().map(|g| g.order().unwrap().to_i64().unwrap()).collect::<Vec<_>>(), [2, 6]);
        for generator in loops {
            let [mut a, mut b] = [0, 0];
            for (cell, x) in generator.chain() {
                *(if *cell == 0 { &mut a } else { &mut b }) = x.to_i64().unwrap();
            }
            // x a + y b bounds when x = 2s and y = 4s + 6t.
            let bounds = |m: i64| (m * a) % 2 == 0 && (m * b - 2 * (m * a)) % 6 == 0;
            let order = generator.order().unwrap().to_i64().unwrap();
            assert_eq!((1..=order).find(|&m| bounds(m)), Some(order));
        }
    }
}
