//! Products of chain complexes.

use super::ChainComplex;
use crate::ids::narrow;
use crate::matrices::SparseMatrix;
use crate::{CellId, Error, ErrorKind};

/// The product of two chain complexes, with the numbers of its cells.
///
/// # Conventions
/// A cell of degree n is a pair of a cell a of degree p of the first factor and a cell b of degree n - p of the second.
/// Cells of one degree are in the order of p, then of a, then of b. The boundary is
/// $\partial(a \times b) = \partial a \times b + (-1)^p \, a \times \partial b$.
///
/// # Examples
/// The product of two intervals is a square: four vertices, four edges, one face.
/// ```
/// use coface_algebra::CellId;
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::{ChainComplex, ProductComplex};
/// # fn main() -> Result<(), coface_algebra::Error> {
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
    numbers: ProductNumbers,
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
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, ProductComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let product = ProductComplex::new(&ChainComplex::of_points(2), &ChainComplex::of_points(3))?;
    /// assert_eq!(product.complex(), &ChainComplex::of_points(6));
    /// # Ok(()) }
    /// ```
    pub fn new(first: &ChainComplex, second: &ChainComplex) -> Result<Self, Error> {
        let numbers = ProductNumbers::new(first.f_vector(), second.f_vector())?;
        let mut boundaries = Vec::with_capacity(numbers.degree_count().saturating_sub(1));
        for degree in 1..numbers.degree_count() {
            boundaries.push(boundary_matrix(first, second, &numbers, degree)?);
        }
        let complex = if boundaries.is_empty() {
            ChainComplex::of_points(numbers.cell_count(0))
        } else {
            ChainComplex::new(boundaries)?
        };
        Ok(Self { complex, numbers })
    }

    /// The product as a chain complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::RaggedArray;
    /// use coface_algebra::chains::{ProductComplex, TwoSkeleton};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let circle = TwoSkeleton::new(1, vec![0, 0], RaggedArray::new())?.chain_complex()?;
    /// let torus = ProductComplex::new(&circle, &circle)?;
    /// assert_eq!(torus.complex().f_vector(), [1, 2, 1]);
    /// # Ok(()) }
    /// ```
    pub fn complex(&self) -> &ChainComplex {
        &self.complex
    }

    /// The product as an owned chain complex.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::{ChainComplex, ProductComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let point = ChainComplex::of_points(1);
    /// assert_eq!(ProductComplex::new(&point, &point)?.into_complex(), point);
    /// # Ok(()) }
    /// ```
    pub fn into_complex(self) -> ChainComplex {
        self.complex
    }

    /// The number of the product of a cell of degree p of the first factor and a cell of degree q of the second, among
    /// the cells of degree p + q.
    ///
    /// # Panics
    /// If a factor has no such cell.
    ///
    /// # Complexity
    /// Constant.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_algebra::chains::{ChainComplex, ProductComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let product = ProductComplex::new(&ChainComplex::of_points(2), &ChainComplex::of_points(3))?;
    /// // The pairs are (0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2).
    /// assert_eq!(product.cell((0, CellId::new(1)), (0, CellId::new(2))), CellId::new(5));
    /// # Ok(()) }
    /// ```
    pub fn cell(&self, first: (usize, CellId), second: (usize, CellId)) -> CellId {
        let [(p, a), (q, b)] = [first, second];
        let [in_first, in_second] = &self.numbers.counts;
        assert!(a.index() < in_first[p] && b.index() < in_second[q], "the factors have these cells");
        CellId::from_u32(self.numbers.number(p, a.to_u32(), q, b.to_u32()))
    }

    /// The factors of a cell: the degree and the cell of each.
    ///
    /// # Panics
    /// If there is no such cell.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_algebra::chains::{ChainComplex, ProductComplex};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let product = ProductComplex::new(&ChainComplex::of_points(2), &ChainComplex::of_points(3))?;
    /// assert_eq!(product.factors(0, CellId::new(5)), [(0, CellId::new(1)), (0, CellId::new(2))]);
    /// # Ok(()) }
    /// ```
    pub fn factors(&self, degree: usize, cell: CellId) -> [(usize, CellId); 2] {
        let mut rest = cell.index();
        for p in self.numbers.first_degrees(degree) {
            let width = self.numbers.counts[1][degree - p];
            let block = self.numbers.counts[0][p] * width;
            if rest < block {
                return [(p, CellId::new(rest / width)), (degree - p, CellId::new(rest % width))];
            }
            rest -= block;
        }
        panic!("the product has no cell {cell} of degree {degree}");
    }
}

/// The boundaries of the cells of one degree of the product.
fn boundary_matrix(
    first: &ChainComplex,
    second: &ChainComplex,
    numbers: &ProductNumbers,
    degree: usize,
) -> Result<SparseMatrix, Error> {
    let entries_of = |complex: &ChainComplex, k: usize| {
        complex.boundary_matrix(k).map_or(0, |matrix| matrix.entry_count() as u64)
    };
    let entry_count: u64 = numbers
        .first_degrees(degree)
        .map(|p| {
            let q = degree - p;
            entries_of(first, p) * second.cell_count(q) as u64
                + first.cell_count(p) as u64 * entries_of(second, q)
        })
        .fold(0, u64::saturating_add);
    if u32::try_from(entry_count).is_err() {
        return Err(Error::new(
            ErrorKind::TooLarge,
            format!(
                "the boundary matrix of degree {degree} has {entry_count} entries; the limit is 2^32 - 1"
            ),
        ));
    }
    let mut starts = Vec::with_capacity(numbers.cell_count(degree) + 1);
    let capacity = usize::try_from(entry_count).expect("the number of entries has 32 bits");
    let (mut rows, mut entries) = (Vec::with_capacity(capacity), Vec::with_capacity(capacity));
    starts.push(0);
    for p in numbers.first_degrees(degree) {
        let q = degree - p;
        let first_matrix = first.boundary_matrix(p);
        let second_matrix = second.boundary_matrix(q);
        // The facets of the first factor move the number by whole rows of cells of the second.
        let width = narrow(second.cell_count(q));
        let sign = if p % 2 == 0 { 1 } else { -1 };
        for a in 0..first.cell_count(p) {
            let column = first_matrix.map(|matrix| matrix.column(a));
            let second_base = second_matrix.map(|_| numbers.number(p, narrow(a), q - 1, 0));
            for b in 0..width {
                // Both parts rise; those of the lower first degree have the lower numbers.
                if let Some(column) = column {
                    let base = numbers.number(p - 1, 0, q, b);
                    rows.extend(column.rows().iter().map(|face| base + face * width));
                    entries.extend_from_slice(column.entries());
                }
                if let (Some(matrix), Some(base)) = (second_matrix, second_base) {
                    let column = matrix.column(b as usize);
                    rows.extend(column.rows().iter().map(|face| base + face));
                    entries.extend(column.entries().iter().map(|entry| sign * entry));
                }
                starts.push(narrow(rows.len()));
            }
        }
    }
    SparseMatrix::from_trusted_parts(numbers.cell_count(degree - 1), starts, rows, entries)
}

/// The numbers of the cells of a product, given how many cells the factors have in each degree.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ProductNumbers {
    counts: [Vec<usize>; 2],
    /// At [degree][p]: the first number of the products with a cell of degree p of the first factor; beyond the last
    /// one the number of all.
    starts: Vec<Vec<u32>>,
}

impl ProductNumbers {
    /// # Errors
    /// [`ErrorKind::TooLarge`] if the cells of a degree have no 32-bit numbers.
    #[doc(hidden)]
    pub fn new(first: &[usize], second: &[usize]) -> Result<Self, Error> {
        let dimension = |counts: &[usize]| counts.iter().rposition(|&count| count > 0);
        let mut numbers = Self { counts: [first.to_vec(), second.to_vec()], starts: Vec::new() };
        let (Some(p), Some(q)) = (dimension(first), dimension(second)) else { return Ok(numbers) };
        for degree in 0..=p + q {
            let mut start = 0u32;
            let mut starts = Vec::with_capacity(degree + 2);
            for i in 0..=degree {
                starts.push(start);
                let count = |counts: &[usize], k: usize| counts.get(k).copied().unwrap_or(0);
                let block = count(first, i).checked_mul(count(second, degree - i));
                start = block
                    .and_then(|block| u32::try_from(block).ok())
                    .and_then(|block| start.checked_add(block))
                    .ok_or_else(|| {
                        Error::new(
                            ErrorKind::TooLarge,
                            format!("the product has more than 2^32 - 1 cells of degree {degree}"),
                        )
                    })?;
            }
            starts.push(start);
            numbers.starts.push(starts);
        }
        Ok(numbers)
    }

    /// One more than the highest degree with a cell; 0 for the empty product.
    #[doc(hidden)]
    pub fn degree_count(&self) -> usize {
        self.starts.len()
    }

    pub(crate) fn cell_count(&self, degree: usize) -> usize {
        self.starts.get(degree).and_then(|starts| starts.last()).map_or(0, |&count| count as usize)
    }

    /// The degrees that the first factor of a cell can have.
    #[doc(hidden)]
    pub fn first_degrees(&self, degree: usize) -> std::ops::Range<usize> {
        let [first, second] = self.counts.each_ref().map(Vec::len);
        (degree + 1).saturating_sub(second)..first.min(degree + 1)
    }

    /// The number of the product of cell a of degree p and cell b of degree q.
    #[doc(hidden)]
    pub fn number(&self, p: usize, a: u32, q: usize, b: u32) -> u32 {
        self.starts[p + q][p] + a * narrow(self.counts[1][q]) + b
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::samples::random_complexes;
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
                    // The rule of Leibniz, term by term.
                    let part = |complex: &ChainComplex, (k, cell): (usize, CellId)| -> Vec<(usize, i32)> {
                        complex.boundary_matrix(k).into_iter().flat_map(|m| m.column(cell.index()).iter()).collect()
                    };
                    let sign = if a.0 % 2 == 0 { 1 } else { -1 };
                    let faces_of_first = part(&first, a).into_iter();
                    let faces_of_second = part(&second, b).into_iter();
                    let mut expected: Vec<(usize, i32)> = faces_of_first
                        .map(|(face, entry)| (product.cell((a.0 - 1, CellId::new(face)), b).index(), entry))
                        .chain(faces_of_second.map(|(face, entry)| {
                            (product.cell(a, (b.0 - 1, CellId::new(face))).index(), sign * entry)
                        }))
                        .collect();
                    expected.sort_unstable();
                    prop_assert_eq!(part(complex, (degree, cell)), expected);
                }
            }
        }
    }

    #[test]
    fn products_that_are_empty_or_do_not_fit() {
        let none = ChainComplex::of_points(0);
        let many = ChainComplex::of_points(1 << 20);
        assert_eq!(ProductComplex::new(&none, &many).unwrap().complex(), &none);
        assert_eq!(ProductComplex::new(&many, &none).unwrap().complex(), &none);
        assert_eq!(ProductComplex::new(&many, &many).unwrap_err().kind(), ErrorKind::TooLarge);
        let pairs = ProductComplex::new(&many, &ChainComplex::of_points(3)).unwrap();
        assert_eq!(pairs.complex().f_vector(), [3 << 20]);
        assert_eq!(pairs.factors(0, CellId::new(7)), [(0, CellId::new(2)), (0, CellId::new(1))]);
    }
}
