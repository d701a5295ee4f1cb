//! Products of chain complexes.

use super::ChainComplex;
use crate::algebra::SparseMatrix;
use crate::{CellId, Error};

/// The product of two chain complexes, with the numbers of its cells.
///
/// # Conventions
/// A cell of degree n is a pair of a cell a of degree p of the first factor and a cell b of degree n - p of the second. Cells of
/// one degree are in the order of p, then of a, then of b. The boundary is
/// $\partial(a \times b) = \partial a \times b + (-1)^p \, a \times \partial b$.
///
/// # Examples
/// The product of two intervals is a square: four vertices, four edges, one face.
/// ```
/// use coface::CellId;
/// use coface::algebra::SparseMatrix;
/// use coface::chains::{ChainComplex, ProductComplex};
/// # fn main() -> Result<(), coface::Error> {
/// let interval = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
/// let square = ProductComplex::new(&interval, &interval)?;
/// assert_eq!(square.complex().f_vector(), [4, 4, 1]);
/// // The face is the product of the two edges; its boundary runs around it.
/// assert_eq!(square.factors(2, CellId::new(0)), [(1, CellId::new(0)), (1, CellId::new(0))]);
/// assert_eq!(square.complex().boundary_matrix(2).expect("there is a face").column(0).entries(), [-1, 1, 1, -1]);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProductComplex {
    complex: ChainComplex,
    counts: [Vec<usize>; 2],
}

impl ProductComplex {
    /// The product of these complexes.
    ///
    /// # Errors
    /// [`crate::ErrorKind::TooLarge`] beyond 32 bits.
    ///
    /// # Complexity
    /// Linear in the result.
    ///
    /// # References
    /// J. R. Munkres, *Elements of Algebraic Topology* (1984), section 57.
    pub fn new(first: &ChainComplex, second: &ChainComplex) -> Result<Self, Error> {
        let counts = [first.f_vector().to_vec(), second.f_vector().to_vec()];
        let mut product = Self { complex: ChainComplex::of_points(0), counts };
        let (Some(p), Some(q)) = (first.dimension(), second.dimension()) else { return Ok(product) };
        let mut boundaries = Vec::with_capacity(p + q);
        for degree in 1..=p + q {
            let (row_count, column_count) = (product.cell_count(degree - 1), product.cell_count(degree));
            let (mut starts, mut rows, mut entries) = (vec![0u32], Vec::new(), Vec::new());
            let mut terms: Vec<(u32, i32)> = Vec::new();
            for i in product.first_degrees(degree) {
                let j = degree - i;
                for a in 0..product.counts[0][i] {
                    for b in 0..product.counts[1][j] {
                        terms.clear();
                        if let Some(matrix) = first.boundary_matrix(i).filter(|_| i > 0) {
                            let facets = matrix.column(a).iter();
                            terms.extend(
                                facets.map(|(face, entry)| (product.number(i - 1, face, j, b), entry)),
                            );
                        }
                        if let Some(matrix) = second.boundary_matrix(j).filter(|_| j > 0) {
                            let facets = matrix.column(b).iter();
                            let sign = if i % 2 == 0 { 1 } else { -1 };
                            terms.extend(
                                facets.map(|(face, entry)| (product.number(i, a, j - 1, face), sign * entry)),
                            );
                        }
                        // Both parts rise; those of the lower first degree have the lower numbers.
                        rows.extend(terms.iter().map(|&(row, _)| row));
                        entries.extend(terms.iter().map(|&(_, entry)| entry));
                        starts.push(u32::try_from(rows.len()).map_err(|_| too_large())?);
                    }
                }
            }
            debug_assert_eq!(starts.len(), column_count + 1);
            boundaries.push(SparseMatrix::from_parts(row_count, starts, rows, entries)?);
        }
        let points = product.cell_count(0);
        product.complex = if boundaries.is_empty() {
            ChainComplex::of_points(points)
        } else {
            ChainComplex::new(boundaries)?
        };
        Ok(product)
    }

    /// The product as a chain complex.
    pub fn complex(&self) -> &ChainComplex {
        &self.complex
    }

    /// The product by itself.
    pub fn into_complex(self) -> ChainComplex {
        self.complex
    }

    /// The number of the product of a cell of degree p of the first factor and a cell of degree q of the second, among the
    /// cells of degree p + q.
    ///
    /// # Panics
    /// If a factor has no such cell.
    pub fn cell(&self, first: (usize, CellId), second: (usize, CellId)) -> CellId {
        let [(p, a), (q, b)] = [first, second];
        assert!(
            a.index() < self.counts[0][p] && b.index() < self.counts[1][q],
            "the factors have these cells"
        );
        CellId::from_u32(self.number(p, a.index(), q, b.index()))
    }

    /// The factors of a cell: the degree and the cell of each.
    ///
    /// # Panics
    /// If there is no such cell.
    pub fn factors(&self, degree: usize, cell: CellId) -> [(usize, CellId); 2] {
        let mut rest = cell.index();
        for p in self.first_degrees(degree) {
            let width = self.counts[1][degree - p];
            let block = self.counts[0][p] * width;
            if rest < block {
                return [(p, CellId::new(rest / width)), (degree - p, CellId::new(rest % width))];
            }
            rest -= block;
        }
        panic!("the product has no cell {cell} of degree {degree}");
    }

    /// The degrees that the first factor of a cell can have.
    fn first_degrees(&self, degree: usize) -> std::ops::Range<usize> {
        let [first, second] = self.counts.each_ref().map(Vec::len);
        (degree + 1).saturating_sub(second)..first.min(degree + 1)
    }

    fn cell_count(&self, degree: usize) -> usize {
        self.first_degrees(degree).map(|p| self.counts[0][p] * self.counts[1][degree - p]).sum()
    }

    fn number(&self, p: usize, a: usize, q: usize, b: usize) -> u32 {
        let before: usize = self
            .first_degrees(p + q)
            .take_while(|&i| i < p)
            .map(|i| self.counts[0][i] * self.counts[1][p + q - i])
            .sum();
        (before + a * self.counts[1][q] + b) as u32
    }
}

fn too_large() -> Error {
    Error::new(crate::ErrorKind::TooLarge, "the product has more than 2^32 - 1 incidences")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::chains::random_complexes;
    use proptest::prelude::*;

    proptest! {
        #[test]
        fn products_are_complexes_with_all_pairs(first in random_complexes(), second in random_complexes()) {
            let product = ProductComplex::new(&first, &second).unwrap();
            let complex = product.complex();
            prop_assert_eq!(
                complex.euler_characteristic(),
                first.euler_characteristic() * second.euler_characteristic()
            );
            for degree in 0..complex.degree_count() {
                for cell in (0..complex.cell_count(degree)).map(CellId::new) {
                    let [a, b] = product.factors(degree, cell);
                    prop_assert_eq!(a.0 + b.0, degree);
                    prop_assert_eq!(product.cell(a, b), cell);
                }
            }
        }
    }
}
