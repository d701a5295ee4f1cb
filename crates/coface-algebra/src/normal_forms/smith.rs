//! The Smith normal form of a sparse integer matrix.

use crate::ids::narrow;
use crate::integers::Integer;
use crate::integers::modular::rank_and_minor;
use crate::matrices::combination;
use crate::matrices::{Entry, SparseMatrix, SparseVector, WideMatrix};
use crate::normal_forms::elimination::{Elimination, Pivot, Transforms};

/// The Smith normal form of an integer matrix: a diagonal of positive integers, each dividing the next, then zeros.
///
/// # Examples
/// ```
/// use coface_algebra::{Integer, SparseMatrix, smith_form};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// // diag(4, 6) has the invariant factors gcd = 2 and lcm = 12.
/// let form = smith_form(&SparseMatrix::from_entries(2, 3, [(0, 0, 4), (1, 2, 6)])?);
/// assert_eq!(form.diagonal(), [Integer::from(2), Integer::from(12)]);
/// assert_eq!(form.rank(), 2);
/// # Ok(()) }
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct SmithForm {
    row_count: usize,
    column_count: usize,
    diagonal: Vec<Integer>,
}

impl SmithForm {
    /// The invariant factors $d_1 \mid d_2 \mid \dots$, all positive: the diagonal without its zeros.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{SparseMatrix, smith_form};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let form = smith_form(&SparseMatrix::from_entries(2, 2, [(0, 0, 2), (1, 1, 3)])?);
    /// assert_eq!(form.diagonal(), [1.into(), 6.into()]);
    /// # Ok(()) }
    /// ```
    pub fn diagonal(&self) -> &[Integer] {
        &self.diagonal
    }

    /// The invariant factors above 1: the orders of the torsion of the cokernel.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{SparseMatrix, smith_form};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let form = smith_form(&SparseMatrix::from_entries(2, 2, [(0, 0, 2), (1, 1, 3)])?);
    /// assert_eq!(form.torsion(), [6.into()]);
    /// # Ok(()) }
    /// ```
    pub fn torsion(&self) -> &[Integer] {
        &self.diagonal[self.diagonal.partition_point(|factor| *factor == Integer::ONE)..]
    }

    /// The rank of the matrix: the number of invariant factors.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{SparseMatrix, smith_form};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(smith_form(&SparseMatrix::from_entries(2, 2, [(0, 0, 1), (0, 1, 1)])?).rank(), 1);
    /// # Ok(()) }
    /// ```
    pub fn rank(&self) -> usize {
        self.diagonal.len()
    }

    /// The rank of the kernel: columns less rank.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{SparseMatrix, smith_form};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(smith_form(&SparseMatrix::from_entries(1, 3, [(0, 0, 1), (0, 1, 1)])?).nullity(), 2);
    /// # Ok(()) }
    /// ```
    pub fn nullity(&self) -> usize {
        self.column_count - self.rank()
    }

    /// The number of rows of the matrix.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{SparseMatrix, smith_form};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(smith_form(&SparseMatrix::zero(2, 3)?).row_count(), 2);
    /// # Ok(()) }
    /// ```
    pub fn row_count(&self) -> usize {
        self.row_count
    }

    /// The number of columns of the matrix.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{SparseMatrix, smith_form};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(smith_form(&SparseMatrix::zero(2, 3)?).column_count(), 3);
    /// # Ok(()) }
    /// ```
    pub fn column_count(&self) -> usize {
        self.column_count
    }

    /// The form as a matrix D, of the shape of the original.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{SparseMatrix, smith_form};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(2, 2, [(0, 1, -5)])?;
    /// assert_eq!(smith_form(&matrix).to_matrix(), SparseMatrix::from_entries(2, 2, [(0, 0, 5)])?);
    /// # Ok(()) }
    /// ```
    pub fn to_matrix(&self) -> WideMatrix {
        let columns = (0..self.column_count)
            .map(|j| self.diagonal.get(j).map(|factor| (narrow(j), factor.clone())).into_iter().collect());
        WideMatrix::from_integer_columns(self.row_count, columns)
            .expect("the diagonal fits where the matrix did")
    }
}

/// A Smith normal form with what makes it: unimodular U and V such that $U A V = D$.
///
/// With r the rank, the columns of V from r on are a basis of the kernel of A, the rows of U from r on vanish on its
/// image, and the first r columns of $U^{-1}$, times the invariant factors, are a basis of the image.
///
/// # Examples
/// ```
/// use coface_algebra::{SparseMatrix, smith_form_with_transforms};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let matrix = SparseMatrix::from_entries(1, 2, [(0, 0, 2), (0, 1, 3)])?;
/// let smith = smith_form_with_transforms(&matrix);
/// assert_eq!(smith.form().diagonal(), [1.into()]);
/// // The kernel of (2 3) is generated by (3, -2) or its opposite.
/// let kernel = smith.right().column(1);
/// assert_eq!(kernel.entry(0).abs(), 3.into());
/// assert_eq!(kernel.entry(1).abs(), 2.into());
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
#[non_exhaustive]
pub struct SmithTransforms {
    form: SmithForm,
    left: WideMatrix,
    left_inverse: WideMatrix,
    right: WideMatrix,
    right_inverse: WideMatrix,
}

impl SmithTransforms {
    /// The form D.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{SparseMatrix, smith_form_with_transforms};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let smith = smith_form_with_transforms(&SparseMatrix::from_entries(1, 2, [(0, 0, 4), (0, 1, 6)])?);
    /// assert_eq!(smith.form().diagonal(), [2.into()]);
    /// # Ok(()) }
    /// ```
    pub fn form(&self) -> &SmithForm {
        &self.form
    }

    /// U, with as many rows and columns as A has rows.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{SparseMatrix, smith_form_with_transforms};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(2, 2, [(0, 0, 2), (0, 1, 4), (1, 0, 3), (1, 1, 5)])?;
    /// let smith = smith_form_with_transforms(&matrix);
    /// let product = smith.left().product(&matrix)?.into_wide().product(smith.right())?.into_wide();
    /// assert_eq!(product, smith.form().to_matrix());
    /// # Ok(()) }
    /// ```
    pub fn left(&self) -> &WideMatrix {
        &self.left
    }

    /// The inverse of U.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{SparseMatrix, smith_form_with_transforms};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let smith = smith_form_with_transforms(&SparseMatrix::from_entries(2, 1, [(0, 0, 2), (1, 0, 3)])?);
    /// assert_eq!(smith.left().product(smith.left_inverse())?.into_narrow()?, SparseMatrix::identity(2)?);
    /// # Ok(()) }
    /// ```
    pub fn left_inverse(&self) -> &WideMatrix {
        &self.left_inverse
    }

    /// V, with as many rows and columns as A has columns.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{SparseMatrix, smith_form_with_transforms};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let matrix = SparseMatrix::from_entries(1, 2, [(0, 0, 2), (0, 1, 4)])?;
    /// let smith = smith_form_with_transforms(&matrix);
    /// // Columns from the rank on are a basis of the kernel.
    /// let kernel = smith.right().select_columns(&[1])?;
    /// assert!(matrix.product(&kernel)?.is_zero());
    /// # Ok(()) }
    /// ```
    pub fn right(&self) -> &WideMatrix {
        &self.right
    }

    /// The inverse of V.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{SparseMatrix, smith_form_with_transforms};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let smith = smith_form_with_transforms(&SparseMatrix::from_entries(1, 2, [(0, 0, 2), (0, 1, 4)])?);
    /// assert_eq!(smith.right().product(smith.right_inverse())?.into_narrow()?, SparseMatrix::identity(2)?);
    /// # Ok(()) }
    /// ```
    pub fn right_inverse(&self) -> &WideMatrix {
        &self.right_inverse
    }
}

/// The Smith normal form, without transforms.
///
/// Pivots of least absolute value and least fill are eliminated while 64 bits suffice. What is left then is
/// eliminated modulo a non-zero minor of the size of its rank, which every invariant factor divides, so that no number
/// outgrows that minor.
///
/// # Complexity
/// Depends on the fill: near linear for boundary matrices that collapse, at worst cubic in the size of what is left
/// with numbers of the size of the minor.
///
/// # References
/// H. M. Markowitz, *The elimination form of the inverse* (1957); P. D. Domich, R. Kannan and L. E. Trotter, *Hermite
/// normal form computation using modulo determinant arithmetic* (1987).
///
/// # Examples
/// ```
/// use coface_algebra::{SparseMatrix, smith_form};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let form = smith_form(&SparseMatrix::from_entries(2, 2, [(0, 0, 1), (0, 1, 1), (1, 0, 1), (1, 1, -1)])?);
/// assert_eq!(form.diagonal(), [1.into(), 2.into()]);
/// # Ok(()) }
/// ```
pub fn smith_form<E: Entry>(matrix: &SparseMatrix<E>) -> SmithForm {
    SmithForm {
        row_count: matrix.row_count(),
        column_count: matrix.column_count(),
        diagonal: invariant_factors(matrix),
    }
}

/// The positive invariant factors $d_1 \mid d_2 \mid \dots$ of a matrix; their number is the rank.
///
/// The algorithm is that of [`smith_form`].
///
/// # Examples
/// ```
/// use coface_algebra::{Integer, SparseMatrix, invariant_factors};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let matrix = SparseMatrix::from_entries(2, 2, [(0, 0, 1), (0, 1, 1), (1, 0, -1), (1, 1, 1)])?;
/// assert_eq!(invariant_factors(&matrix), [Integer::from(1), Integer::from(2)]);
/// # Ok(()) }
/// ```
pub fn invariant_factors<E: Entry>(matrix: &SparseMatrix<E>) -> Vec<Integer> {
    let mut elimination = Elimination::new(matrix, false);
    let is_done = elimination.finish_while_narrow();
    let mut chain = DivisorChain::default();
    for pivot in std::mem::take(&mut elimination.pivots) {
        chain.insert(pivot.value.abs(), 1);
    }
    if !is_done {
        let (rows, column_count) = elimination.into_remainder();
        for (factor, count) in factors_by_minor(&rows, column_count).runs {
            chain.insert(factor, count);
        }
    }
    chain.into_factors()
}

/// The invariant factors of a matrix by elimination modulo a minor.
///
/// Modulo a multiple D of all invariant factors the Smith form is that over the integers, with zero for D itself; the
/// rank says how many of its zeros are a factor D.
fn factors_by_minor(rows: &[SparseVector], column_count: usize) -> DivisorChain {
    let (rank, minor) = rank_and_minor(rows, column_count);
    let mut elimination = Elimination::modulo(rows, column_count, &minor);
    elimination.finish();
    let (pivots, _) = elimination.into_parts();
    let mut chain = DivisorChain::default();
    chain.insert(minor, rank.saturating_sub(pivots.len()));
    for pivot in pivots {
        chain.insert(pivot.value, 1);
    }
    chain.truncate(rank);
    chain
}

/// Positive integers each of which divides the next, as runs (value, how often).
#[derive(Clone, Debug, Default)]
struct DivisorChain {
    runs: Vec<(Integer, usize)>,
}

impl DivisorChain {
    /// Makes the chain that of the diagonal matrix with `count` more entries `value`.
    fn insert(&mut self, mut value: Integer, mut count: usize) {
        let mut at = 0;
        while count > 0 && at < self.runs.len() {
            let (present, present_count) = self.runs[at].clone();
            let gcd = present.gcd(&value);
            if gcd == present {
                at += 1;
                continue;
            }
            // diag(a, b) becomes diag(gcd, lcm) for as many pairs as there are.
            let pair_count = count.min(present_count);
            let lcm = &present * &value.exact_quotient(&gcd).expect("a common divisor divides");
            self.runs[at].1 -= pair_count;
            self.runs.insert(at, (gcd, pair_count));
            at += 1;
            if self.runs[at].1 == 0 {
                self.runs.remove(at);
            }
            if count > pair_count {
                // More new values than old ones: the rest of them goes in before the lcm does.
                self.insert(value, count - pair_count);
                return self.insert(lcm, pair_count);
            }
            (value, count) = (lcm, pair_count);
        }
        if count > 0 {
            self.runs.push((value, count));
        }
        self.runs.dedup_by(|next, kept| {
            let is_same = next.0 == kept.0;
            kept.1 += if is_same { next.1 } else { 0 };
            is_same
        });
    }

    /// Keeps the first `count`.
    fn truncate(&mut self, mut count: usize) {
        for run in &mut self.runs {
            run.1 = run.1.min(count);
            count -= run.1;
        }
        self.runs.retain(|&(_, count)| count > 0);
    }

    fn into_factors(self) -> Vec<Integer> {
        self.runs.into_iter().flat_map(|(value, count)| std::iter::repeat_n(value, count)).collect()
    }
}

/// The Smith normal form with the unimodular matrices that make it, and their inverses.
///
/// Unit pivots are eliminated first; the remainder is brought to a diagonal by Hermite forms of its columns and rows in
/// turns, with transforms that lattice basis reduction keeps short.
///
/// # Complexity
/// As [`smith_form`] for the unit pivots; for a remainder of m columns about $m^4$ operations on integers of the size
/// of its minors. Reduce a chain complex by an acyclic matching first.
///
/// # References
/// G. Havas, B. S. Majewski and K. R. Matthews, *Extended gcd and Hermite normal form algorithms via lattice basis
/// reduction* (1998).
///
/// # Examples
/// ```
/// use coface_algebra::{SparseMatrix, smith_form_with_transforms};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let matrix = SparseMatrix::from_entries(1, 2, [(0, 0, 2), (0, 1, 3)])?;
/// let smith = smith_form_with_transforms(&matrix);
/// let product = smith.left().product(&matrix)?.into_wide().product(smith.right())?;
/// assert_eq!(product.into_narrow()?, SparseMatrix::from_entries(1, 2, [(0, 0, 1)])?);
/// # Ok(()) }
/// ```
pub fn smith_form_with_transforms<E: Entry>(matrix: &SparseMatrix<E>) -> SmithTransforms {
    let mut elimination = Elimination::new(matrix, true);
    elimination.finish_units();
    elimination.diagonalize();
    elimination.finish();
    let (mut pivots, transforms) = elimination.into_parts();
    let mut transforms = transforms.expect("transforms were asked for");
    for pivot in &mut pivots {
        if pivot.value.signum() < 0 {
            pivot.value = -&pivot.value;
            for (_, entry) in &mut transforms.left_rows[pivot.row as usize] {
                *entry = -&*entry;
            }
            for (_, entry) in &mut transforms.left_inverse_columns[pivot.row as usize] {
                *entry = -&*entry;
            }
        }
    }
    pivots.sort_by(|a, b| a.value.cmp(&b.value));
    let first = pivots.partition_point(|pivot| pivot.value.is_unit());
    for i in first..pivots.len() {
        for j in i + 1..pivots.len() {
            make_divisible(&mut transforms, &mut pivots, i, j);
        }
    }
    let Transforms { left_rows, left_inverse_columns, right_columns, right_inverse_rows } = transforms;
    let row_order = pivots_first(pivots.iter().map(|pivot| pivot.row), matrix.row_count());
    let column_order = pivots_first(pivots.iter().map(|pivot| pivot.column), matrix.column_count());
    SmithTransforms {
        form: SmithForm {
            row_count: matrix.row_count(),
            column_count: matrix.column_count(),
            diagonal: pivots.into_iter().map(|pivot| pivot.value).collect(),
        },
        left: ordered(left_rows, &row_order).transpose(),
        left_inverse: ordered(left_inverse_columns, &row_order),
        right: ordered(right_columns, &column_order),
        right_inverse: ordered(right_inverse_rows, &column_order).transpose(),
    }
}

/// Turns two diagonal entries a and b into their greatest common divisor and least common multiple.
///
/// With g = x a + y b the row operations (x, y; -b/g, a/g) and the column operations (1, -y b/g; 1, x a/g) do it; both
/// have determinant 1.
fn make_divisible(transforms: &mut Transforms, pivots: &mut [Pivot], i: usize, j: usize) {
    let (a, b) = (pivots[i].value.clone(), pivots[j].value.clone());
    if a.divides(&b) {
        return;
    }
    let (gcd, x, y) = a.extended_gcd(&b);
    let (a_part, b_part) = (
        a.exact_quotient(&gcd).expect("a common divisor divides"),
        b.exact_quotient(&gcd).expect("a common divisor divides"),
    );
    let (ya, yb, xa, one) = (&y * &b_part, -&b_part, &x * &a_part, Integer::ONE);
    let rows = [pivots[i].row as usize, pivots[j].row as usize];
    let columns = [pivots[i].column as usize, pivots[j].column as usize];
    combine(&mut transforms.left_rows, rows, [[&x, &y], [&yb, &a_part]]);
    combine(&mut transforms.left_inverse_columns, rows, [[&a_part, &b_part], [&-&y, &x]]);
    combine(&mut transforms.right_columns, columns, [[&one, &one], [&-&ya, &xa]]);
    combine(&mut transforms.right_inverse_rows, columns, [[&xa, &ya], [&-&one, &one]]);
    pivots[i].value = gcd;
    pivots[j].value = &a * &b_part;
}

/// Replaces two vectors by two combinations of them.
fn combine(vectors: &mut [SparseVector], at: [usize; 2], by: [[&Integer; 2]; 2]) {
    let [first, second] = by.map(|[x, y]| combination(x, &vectors[at[0]], y, &vectors[at[1]]));
    vectors[at[0]] = first;
    vectors[at[1]] = second;
}

/// `0..count` with the pivots first, in their order.
fn pivots_first(pivots: impl Iterator<Item = u32>, count: usize) -> Vec<u32> {
    let mut order: Vec<u32> = pivots.collect();
    let mut is_pivot = vec![false; count];
    for &pivot in &order {
        is_pivot[pivot as usize] = true;
    }
    order.extend((0..narrow(count)).filter(|&i| !is_pivot[i as usize]));
    order
}

/// The square matrix whose columns are these vectors in this order.
fn ordered(mut vectors: Vec<SparseVector>, order: &[u32]) -> WideMatrix {
    let columns = order.iter().map(|&i| std::mem::take(&mut vectors[i as usize]));
    WideMatrix::from_integer_columns(order.len(), columns).expect("a transform has the size of the matrix")
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn matrix(rows: &[Vec<i64>], column_count: usize) -> SparseMatrix {
        let entries = rows
            .iter()
            .enumerate()
            .flat_map(|(i, row)| row.iter().enumerate().map(move |(j, &entry)| (i, j, entry)));
        SparseMatrix::from_entries(rows.len(), column_count, entries).unwrap()
    }

    /// Matrices of up to 5 x 5, many entries zero.
    fn matrices() -> impl Strategy<Value = SparseMatrix> {
        let entry = prop_oneof![3 => Just(0i64), 3 => -1i64..=1, 3 => -12i64..=12];
        (0usize..=5, 0usize..=5).prop_flat_map(move |(row_count, column_count)| {
            prop::collection::vec(prop::collection::vec(entry.clone(), column_count), row_count)
                .prop_map(move |rows| matrix(&rows, column_count))
        })
    }

    fn dense<E: Entry>(matrix: &SparseMatrix<E>) -> Vec<Vec<Integer>> {
        (0..matrix.row_count())
            .map(|i| (0..matrix.column_count()).map(|j| matrix.entry(i, j).to_integer()).collect())
            .collect()
    }

    fn product(a: &[Vec<Integer>], b: &[Vec<Integer>], column_count: usize) -> Vec<Vec<Integer>> {
        let dot = |row: &Vec<Integer>, j: usize| {
            row.iter().zip(b).fold(Integer::ZERO, |sum, (x, line)| sum + x * &line[j])
        };
        a.iter().map(|row| (0..column_count).map(|j| dot(row, j)).collect()).collect()
    }

    /// The determinant by expansion along the first row.
    fn determinant(rows: &[usize], columns: &[usize], matrix: &SparseMatrix) -> Integer {
        let Some((&first, rest)) = rows.split_first() else { return Integer::ONE };
        let mut sum = Integer::ZERO;
        for (at, &column) in columns.iter().enumerate() {
            let others: Vec<usize> = columns.iter().copied().filter(|&j| j != column).collect();
            let sign = if at % 2 == 0 { 1 } else { -1 };
            let entry = Integer::from(sign * matrix.entry(first, column));
            sum += &(entry * determinant(rest, &others, matrix));
        }
        sum
    }

    fn subsets(count: usize, size: usize) -> Vec<Vec<usize>> {
        (0..1usize << count)
            .filter(|mask| mask.count_ones() as usize == size)
            .map(|mask| (0..count).filter(|i| mask >> i & 1 == 1).collect())
            .collect()
    }

    /// The second method: the product of the first k factors is the greatest common divisor of all k x k minors.
    fn factors_by_all_minors(matrix: &SparseMatrix) -> Vec<Integer> {
        let (mut factors, mut last) = (Vec::new(), Integer::ONE);
        for size in 1..=matrix.row_count().min(matrix.column_count()) {
            let mut gcd = Integer::ZERO;
            for rows in subsets(matrix.row_count(), size) {
                for columns in subsets(matrix.column_count(), size) {
                    gcd = gcd.gcd(&determinant(&rows, &columns, matrix));
                }
            }
            if gcd.is_zero() {
                break;
            }
            factors.push(gcd.exact_quotient(&last).unwrap());
            last = gcd;
        }
        factors
    }

    fn check_transforms(matrix: &SparseMatrix) {
        let smith = smith_form_with_transforms(matrix);
        let (m, n) = (matrix.row_count(), matrix.column_count());
        let identity = |count| dense(&SparseMatrix::identity(count).unwrap());
        let (left, right) = (dense(smith.left()), dense(smith.right()));
        assert_eq!(product(&left, &dense(smith.left_inverse()), m), identity(m));
        assert_eq!(product(&right, &dense(smith.right_inverse()), n), identity(n));
        assert_eq!(product(&product(&left, &dense(matrix), n), &right, n), dense(&smith.form().to_matrix()));
        assert!(smith.form().diagonal().windows(2).all(|pair| pair[0].divides(&pair[1])));
        assert!(smith.form().diagonal().iter().all(|factor| factor.signum() > 0));
        assert_eq!(*smith.form(), smith_form(matrix));
    }

    fn remainder_rows(matrix: &SparseMatrix) -> (Vec<SparseVector>, usize) {
        Elimination::new(matrix, false).into_remainder()
    }

    proptest! {
        #[test]
        fn smith_transforms_are_unimodular(matrix in matrices()) {
            check_transforms(&matrix);
        }

        #[test]
        fn three_methods_agree(matrix in matrices()) {
            let factors = invariant_factors(&matrix);
            prop_assert_eq!(&factors, &factors_by_all_minors(&matrix));
            prop_assert_eq!(&factors, &invariant_factors(&matrix.transpose()));
            let (rows, column_count) = remainder_rows(&matrix);
            prop_assert_eq!(&factors, &factors_by_minor(&rows, column_count).into_factors());
        }

        #[test]
        fn the_chain_of_a_diagonal_is_its_smith_form(diagonal in prop::collection::vec(1i64..=60, 0..5)) {
            let mut chain = DivisorChain::default();
            for &entry in &diagonal {
                chain.insert(Integer::from(entry), 1);
            }
            let entries = diagonal.iter().enumerate().map(|(i, &entry)| (i, i, entry));
            let matrix = SparseMatrix::from_entries(diagonal.len(), diagonal.len(), entries).unwrap();
            prop_assert_eq!(chain.into_factors(), factors_by_all_minors(&matrix));
        }
    }

    /// The boundary matrix of degree 2 of the sum complex of `set` modulo n: all edges on n vertices, and the
    /// triangles whose sum lies in `set`.
    fn sum_complex(n: usize, set: &[usize]) -> SparseMatrix {
        let number = |i: usize, j: usize| i * n + j - (i + 1) * (i + 2) / 2;
        let (mut entries, mut count) = (Vec::new(), 0);
        for i in 0..n {
            for j in i + 1..n {
                for k in (j + 1..n).filter(|k| set.contains(&((i + j + k) % n))) {
                    entries.extend([
                        (number(j, k), count, 1),
                        (number(i, k), count, -1),
                        (number(i, j), count, 1),
                    ]);
                    count += 1;
                }
            }
        }
        SparseMatrix::from_entries(n * (n - 1) / 2, count, entries).unwrap()
    }

    #[test]
    fn sum_complexes_have_the_published_torsion() {
        for (n, set, order) in
            [(11, [0, 1, 3], 23), (13, [0, 1, 3], 159), (13, [0, 1, 5], 159), (17, [0, 1, 6], 24617)]
        {
            let form = smith_form(&sum_complex(n, &set));
            assert_eq!(form.torsion(), [Integer::from(order)], "n = {n}");
            assert_eq!(form.rank(), (n - 1) * (n - 2) / 2);
        }
    }

    #[test]
    fn transforms_of_a_sum_complex_with_large_torsion_are_unimodular() {
        check_transforms(&sum_complex(23, &[0, 1, 3]));
    }

    #[test]
    fn a_large_diagonal_is_chained_quickly() {
        let entries = (0..20_000).map(|i| (i, i, [2, 3, 4, 9][i % 4]));
        let factors = invariant_factors(&SparseMatrix::from_entries(20_000, 20_000, entries).unwrap());
        // The 2-parts are 2 and 4, the 3-parts 3 and 9, each five thousand times.
        let expected = [1, 6, 36].map(Integer::from);
        assert_eq!((factors[0].clone(), factors[10_000].clone(), factors[19_999].clone()), expected.into());
    }
}
