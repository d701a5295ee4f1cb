//! Bases of a reduced complex in which all boundary maps are diagonal.

use coface_algebra::{
    Integer, SparseVector, WideMatrix, inner_product, linear_combination, smith_form_with_transforms,
};

/// A basis of the chains of one degree of a reduced complex, adapted to both boundary maps.
///
/// The first `rank` elements $q_j$ have the boundaries $\partial q_j = t_j z_j$, multiples of kernel elements of the
/// degree below. The others are a basis $z_0, z_1, \dots$ of the cycles, and the first of them, as many as `orders`,
/// bound when multiplied by their orders: orders 1 are boundaries, larger ones torsion; those beyond are free.
#[derive(Clone, Debug)]
pub(super) struct AdaptedBasis {
    /// The elements, on the cells of the reduced complex.
    pub(super) elements: Vec<SparseVector>,
    /// The dual basis: row j has the value 1 on element j and 0 on the others.
    pub(super) duals: Vec<SparseVector>,
    /// The number of elements that are no cycles; they come first.
    pub(super) rank: usize,
    /// The orders of the first cycles, each dividing the next.
    pub(super) orders: Vec<Integer>,
}

impl AdaptedBasis {
    /// The positions of the elements that generate homology: those of finite order above 1, then the free ones.
    pub(super) fn generators(&self) -> std::ops::Range<usize> {
        self.rank + self.orders.partition_point(|order| *order == Integer::ONE)..self.elements.len()
    }

    /// The order of the cycle at a position among the elements; `None` for a free one.
    pub(super) fn order(&self, position: usize) -> Option<&Integer> {
        self.orders.get(position - self.rank)
    }

    /// The coefficients of a cycle in the basis of cycles, from $z_0$ on.
    pub(super) fn coordinates(&self, cycle: &[(u32, Integer)]) -> Vec<Integer> {
        self.duals[self.rank..].iter().map(|dual| inner_product(dual, cycle)).collect()
    }
}

/// The adapted bases of all degrees of a reduced complex, from below: of this many vertices and so many degrees, with
/// the boundary matrix of each degree from 1 on, and one without columns beyond.
///
/// In each degree k a basis V is at hand whose elements beyond the rank are cycles. The boundaries from above, in the
/// coordinates of these cycles, are a matrix M, and its Smith form $P M Q = T$ does two things: the columns of
/// $P^{-1}$ recombine the cycles, and Q is the basis V of degree k + 1. So there is one Smith form a degree.
///
/// # References
/// J. R. Munkres, *Elements of Algebraic Topology* (1984), section 11.
pub(super) fn adapted_bases(
    vertex_count: usize,
    degree_count: usize,
    boundary_matrix: impl Fn(usize) -> WideMatrix,
) -> Vec<AdaptedBasis> {
    let mut bases = Vec::new();
    let mut elements = units(vertex_count);
    let mut duals = elements.clone();
    let mut rank = 0;
    for degree in 0..degree_count {
        let above = boundary_matrix(degree + 1);
        let cofaces = above.transpose();
        let rows: Vec<SparseVector> = duals[rank..]
            .iter()
            .map(|dual| {
                let lists: Vec<_> = dual.iter().map(|(cell, x)| (x, to_vector(&cofaces, *cell))).collect();
                linear_combination(lists.iter().map(|(x, list)| (*x, &list[..])))
            })
            .collect();
        let step = Diagonalization::new(&rows, above.column_count());
        recombine(&mut elements, rank, &step.used_rows, &step.left_inverse);
        recombine(&mut duals, rank, &step.used_rows, &step.left);
        bases.push(AdaptedBasis { elements, duals, rank, orders: step.orders.clone() });
        rank = step.orders.len();
        (elements, duals) = (step.right, step.right_inverse);
    }
    bases
}

/// The Smith form of a matrix given by rows. Rows and columns without entries take no part in it.
struct Diagonalization {
    /// The rows with entries, rising.
    used_rows: Vec<usize>,
    /// The invariant factors.
    orders: Vec<Integer>,
    /// The rows of P and the columns of its inverse, on the used rows.
    left: Vec<SparseVector>,
    left_inverse: Vec<SparseVector>,
    /// The columns of Q and the rows of its inverse, on all columns: first those of the pivots.
    right: Vec<SparseVector>,
    right_inverse: Vec<SparseVector>,
}

impl Diagonalization {
    fn new(rows: &[SparseVector], column_count: usize) -> Self {
        let used_rows: Vec<usize> = (0..rows.len()).filter(|&i| !rows[i].is_empty()).collect();
        let mut is_used = vec![false; column_count];
        for (column, _) in rows.iter().flatten() {
            is_used[*column as usize] = true;
        }
        let used_columns: Vec<u32> = (0..column_count as u32).filter(|&j| is_used[j as usize]).collect();
        let mut number = vec![0; column_count];
        for (new, &old) in used_columns.iter().enumerate() {
            number[old as usize] = new as u32;
        }
        let renumbered = used_rows.iter().map(|&i| {
            rows[i].iter().map(|(j, x)| (number[*j as usize], x.clone())).collect::<SparseVector>()
        });
        let matrix = WideMatrix::from_integer_columns(used_columns.len(), renumbered)
            .expect("a part of a matrix fits where the whole did")
            .transpose();
        let smith = smith_form_with_transforms(&matrix);
        let on_all_columns = |matrix: &WideMatrix| -> Vec<SparseVector> {
            let lifted = (0..used_columns.len()).map(|j| {
                let terms = matrix.column(j).terms();
                terms.map(|(i, x)| (used_columns[i], x.clone())).collect()
            });
            let unused = (0..column_count as u32).filter(|&j| !is_used[j as usize]);
            lifted.chain(unused.map(|j| vec![(j, Integer::ONE)])).collect()
        };
        let columns =
            |matrix: &WideMatrix| (0..matrix.column_count()).map(|j| to_vector(matrix, j as u32)).collect();
        Self {
            orders: smith.form().diagonal().to_vec(),
            left: columns(&smith.left().transpose()),
            left_inverse: columns(smith.left_inverse()),
            right: on_all_columns(smith.right()),
            right_inverse: on_all_columns(&smith.right_inverse().transpose()),
            used_rows,
        }
    }
}

/// Replaces the vectors at the used positions, counted from `first`, by combinations of them, and puts these first.
fn recombine(vectors: &mut Vec<SparseVector>, first: usize, used: &[usize], by: &[SparseVector]) {
    let old = vectors.split_off(first);
    vectors.extend(by.iter().map(|coefficients| {
        linear_combination(coefficients.iter().map(|(i, x)| (x, &old[used[*i as usize]][..])))
    }));
    let mut is_used = vec![false; old.len()];
    for &i in used {
        is_used[i] = true;
    }
    vectors.extend(old.into_iter().zip(is_used).filter(|(_, is_used)| !is_used).map(|(vector, _)| vector));
}

fn units(count: usize) -> Vec<SparseVector> {
    (0..count as u32).map(|i| vec![(i, Integer::ONE)]).collect()
}

fn to_vector(matrix: &WideMatrix, column: u32) -> SparseVector {
    matrix.column(column as usize).terms().map(|(row, x)| (row as u32, x.clone())).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use coface_algebra::chains::Reduction;
    use coface_algebra::samples::random_complexes;
    use proptest::prelude::*;

    proptest! {
        /// Elements and duals are inverse to each other, and boundaries are diagonal in them.
        #[test]
        fn bases_are_adapted(complex in random_complexes()) {
            let reduction = Reduction::new(&complex);
            let bases = adapted_bases(reduction.cell_count(0), complex.degree_count(), |degree| {
                reduction.boundary_matrix(degree)
            });
            for (degree, basis) in bases.iter().enumerate() {
                prop_assert_eq!(basis.elements.len(), reduction.cell_count(degree));
                prop_assert_eq!(basis.duals.len(), basis.elements.len());
                for (i, dual) in basis.duals.iter().enumerate() {
                    for (j, element) in basis.elements.iter().enumerate() {
                        prop_assert_eq!(inner_product(dual, element), Integer::from(i64::from(i == j)));
                    }
                }
                let matrix = reduction.boundary_matrix(degree);
                for (j, element) in basis.elements.iter().enumerate() {
                    let columns: Vec<_> = element.iter().map(|(i, x)| (x, to_vector(&matrix, *i))).collect();
                    let boundary = linear_combination(columns.iter().map(|(x, c)| (*x, &c[..])));
                    if j < basis.rank {
                        let below = &bases[degree - 1];
                        let cycle = &below.elements[below.rank + j];
                        prop_assert_eq!(boundary, linear_combination([(&below.orders[j], &cycle[..])]));
                    } else {
                        prop_assert!(boundary.is_empty());
                    }
                }
            }
        }
    }
}
