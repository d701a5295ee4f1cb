//! Generators of integral homology.

use crate::homology::basis::HomologyBasis;
use crate::homology::class::Generator;
use coface_algebra::chains::ChainComplex;

/// Cycles whose classes generate the integral homology of each degree: first those of finite order (orders dividing
/// along), then those of infinite order; as many as [`crate::homology()`] has cyclic summands. They are made
/// short, see [`HomologyBasis::new`].
///
/// # Complexity
/// That of [`HomologyBasis`].
///
/// # Examples
/// The rim of a triangle has one loop, its three edges:
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::ChainComplex;
/// use coface_topology::generators;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let rim =
///     SparseMatrix::from_entries(3, 3, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)])?;
/// let loops = generators(&ChainComplex::new(vec![rim])?);
/// assert_eq!(loops[1].len(), 1);
/// assert_eq!(loops[1][0].length(), 3.into());
/// # Ok(()) }
/// ```
pub fn generators(complex: &ChainComplex) -> Vec<Vec<Generator>> {
    HomologyBasis::new(complex).into_generators()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::homology::homology;
    use coface_algebra::samples::random_complexes;
    use coface_algebra::{Integer, SparseMatrix, WideMatrix, smith_form};
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
                    prop_assert!(complex.is_cycle(generator.chain()).unwrap());
                    bounding.push(generator.chain().terms().iter().map(|(c, x)| (c.to_u32(), x.clone())).collect());
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
            for (cell, x) in generator.chain().terms() {
                *(if cell.index() == 0 { &mut a } else { &mut b }) = x.to_i64().unwrap();
            }
            // x a + y b bounds when x = 2s and y = 4s + 6t.
            let bounds = |m: i64| (m * a) % 2 == 0 && (m * b - 2 * (m * a)) % 6 == 0;
            let order = generator.order().unwrap().to_i64().unwrap();
            assert_eq!((1..=order).find(|&m| bounds(m)), Some(order));
        }
    }
}
