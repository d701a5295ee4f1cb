//! Hermite normal form with a small transform, by lattice basis reduction.

use crate::integers::Integer;
use crate::progress::stage;

/// The row Hermite form of an integer matrix: $U A = H$ with U unimodular.
pub(super) struct HermiteTransform {
    /// H, by rows: first the rows with entries, the column of the first one rising, that entry positive and larger than
    /// those above it, which are not negative; then zero rows.
    pub(super) form: Vec<Vec<Integer>>,
    /// U, by rows; those that make zero rows are a reduced basis of the relations between the rows of A.
    pub(super) transform: Vec<Vec<Integer>>,
    /// The inverse of U, by columns.
    pub(super) inverse_columns: Vec<Vec<Integer>>,
}

/// Computes the row Hermite form by the algorithm of Havas, Majewski and Matthews, which keeps the rows of the
/// transform reduced in the sense of Lenstra, Lenstra and Lovász while it makes the form, so that they stay short.
///
/// # Complexity
/// Polynomial; about $m^4$ operations on integers of the size of the minors for m rows.
///
/// # References
/// G. Havas, B. S. Majewski and K. R. Matthews, *Extended gcd and Hermite normal form algorithms via lattice basis
/// reduction* (1998).
pub(super) fn hermite_with_transform(rows: Vec<Vec<Integer>>) -> HermiteTransform {
    let count = rows.len();
    let unit = |i: usize| -> Vec<Integer> {
        (0..count).map(|j| if i == j { Integer::ONE } else { Integer::ZERO }).collect()
    };
    let mut reduction = Reduction {
        rows,
        transform: (0..count).map(unit).collect(),
        inverse: (0..count).map(unit).collect(),
        minors: vec![Integer::ONE; count + 1],
        products: vec![vec![Integer::ZERO; count]; count],
    };
    reduction.run();
    // Rows came out with zero rows first and the earliest leading entry last.
    reduction.rows.reverse();
    reduction.transform.reverse();
    reduction.inverse.reverse();
    HermiteTransform {
        form: reduction.rows,
        transform: reduction.transform,
        inverse_columns: reduction.inverse,
    }
}

struct Reduction {
    rows: Vec<Vec<Integer>>,
    transform: Vec<Vec<Integer>>,
    /// Columns of the inverse.
    inverse: Vec<Vec<Integer>>,
    /// $D_0, D_1, \dots$: the determinants of the Gram matrices of the first rows of the transform, so that all
    /// coefficients of its orthogonalization are integers over them.
    minors: Vec<Integer>,
    /// Row k, column i < k: the coefficient of row k on row i in the orthogonalization, times $D_{i+1}$.
    products: Vec<Vec<Integer>>,
}

impl Reduction {
    fn run(&mut self) {
        let mut k = 1;
        // Rows go up and down: nobody knows how often.
        let steps = stage("reducing rows", 0);
        while k < self.rows.len() {
            steps.advance(1);
            let (above, own) = self.reduce(k, k - 1);
            let is_out_of_order = match (above, own) {
                (Some(above), Some(own)) => above <= own,
                (Some(_), None) => true,
                (None, Some(_)) => false,
                (None, None) => self.is_unreduced(k),
            };
            if is_out_of_order {
                self.swap(k);
                k = (k - 1).max(1);
            } else {
                for i in (0..k - 1).rev() {
                    self.reduce(k, i);
                }
                k += 1;
            }
        }
        // The last row may still be negative; when its sign changes it is to be reduced again.
        for k in 0..self.rows.len() {
            self.make_positive(k);
            for i in (0..k).rev() {
                self.reduce(k, i);
            }
        }
    }

    /// Lovász's condition fails, with the constant 3/4.
    fn is_unreduced(&self, k: usize) -> bool {
        let product = &self.products[k][k - 1];
        let left = &(&self.minors[k - 1] * &self.minors[k + 1]) + &(product * product);
        &left * &Integer::from(4) < &(&self.minors[k] * &self.minors[k]) * &Integer::from(3)
    }

    /// Subtracts the multiple of row i from row k that makes its entry under the leading one of row i smallest, or, if
    /// row i is zero, reduces the transform. Gives the leading columns of both.
    fn reduce(&mut self, k: usize, i: usize) -> (Option<usize>, Option<usize>) {
        self.make_positive(i);
        let leading = |row: &[Integer]| row.iter().position(|x| !x.is_zero());
        let above = leading(&self.rows[i]);
        let quotient = match above {
            Some(column) => self.rows[k][column].div_rem_floor(&self.rows[i][column]).0,
            None => self.products[k][i].div_rem_nearest(&self.minors[i + 1]).0,
        };
        if !quotient.is_zero() {
            subtract(&mut self.rows, k, &quotient, i);
            subtract(&mut self.transform, k, &quotient, i);
            subtract(&mut self.inverse, i, &-&quotient, k);
            subtract(&mut self.products, k, &quotient, i);
            let product = &self.minors[i + 1] * &quotient;
            self.products[k][i] -= &product;
        }
        (above, leading(&self.rows[k]))
    }

    fn make_positive(&mut self, i: usize) {
        if self.rows[i].iter().find(|x| !x.is_zero()).is_none_or(|x| x.signum() > 0) {
            return;
        }
        for vector in [&mut self.rows[i], &mut self.transform[i], &mut self.inverse[i], &mut self.products[i]]
        {
            vector.iter_mut().for_each(|x| *x = -&*x);
        }
        for row in &mut self.products[i + 1..] {
            row[i] = -&row[i];
        }
    }

    /// Exchanges rows k and k - 1.
    fn swap(&mut self, k: usize) {
        for matrix in [&mut self.rows, &mut self.transform, &mut self.inverse] {
            matrix.swap(k, k - 1);
        }
        let (head, tail) = self.products.split_at_mut(k);
        head[k - 1][..k - 1].swap_with_slice(&mut tail[0][..k - 1]);
        let product = self.products[k][k - 1].clone();
        let (before, minor, after) =
            (self.minors[k - 1].clone(), self.minors[k].clone(), self.minors[k + 1].clone());
        let exact = |x: Integer| x.exact_quotient(&minor).expect("minors divide these products");
        for row in &mut self.products[k + 1..] {
            let (first, second) = (row[k - 1].clone(), row[k].clone());
            row[k] = exact(&(&first * &after) - &(&second * &product));
            row[k - 1] = exact(&(&first * &product) + &(&second * &before));
        }
        self.minors[k] = exact(&(&before * &after) + &(&product * &product));
    }
}

/// Row `k` minus `factor` times row `i`.
fn subtract(rows: &mut [Vec<Integer>], k: usize, factor: &Integer, i: usize) {
    let source = std::mem::take(&mut rows[i]);
    for (x, y) in rows[k].iter_mut().zip(&source) {
        if !y.is_zero() {
            *x -= &(factor * y);
        }
    }
    rows[i] = source;
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn integers(rows: &[Vec<i64>]) -> Vec<Vec<Integer>> {
        rows.iter().map(|row| row.iter().map(|&x| x.into()).collect()).collect()
    }

    fn dot(a: &[Integer], b: &[Integer]) -> Integer {
        let mut sum = Integer::ZERO;
        for (x, y) in a.iter().zip(b) {
            sum += &(x * y);
        }
        sum
    }

    fn transposed(rows: &[Vec<Integer>], width: usize) -> Vec<Vec<Integer>> {
        (0..width).map(|j| rows.iter().map(|row| row[j].clone()).collect()).collect()
    }

    proptest! {
        #[test]
        fn the_form_is_hermite_and_the_transform_unimodular(
            numbers in prop::collection::vec(-9i64..10, 30),
            height in 1usize..6,
            width in 1usize..6,
            is_thin in any::<bool>(),
        ) {
            let mut rows: Vec<Vec<i64>> = (0..height).map(|i| numbers[i * width..(i + 1) * width].to_vec()).collect();
            if is_thin && height > 2 {
                rows[2] = rows[0].iter().zip(&rows[1]).map(|(x, y)| 2 * x - y).collect();
            }
            let rows = integers(&rows);
            let result = hermite_with_transform(rows.clone());
            let columns = transposed(&rows, width);
            for (i, (row, own)) in result.transform.iter().zip(&result.form).enumerate() {
                let product: Vec<Integer> = columns.iter().map(|column| dot(row, column)).collect();
                prop_assert_eq!(&product, own);
                for (j, column) in result.inverse_columns.iter().enumerate() {
                    prop_assert_eq!(dot(row, column), Integer::from(i64::from(i == j)));
                }
            }
            let leading: Vec<Option<usize>> =
                result.form.iter().map(|row| row.iter().position(|x| !x.is_zero())).collect();
            for pair in leading.windows(2) {
                prop_assert!(pair[1].is_none() || pair[0].is_some_and(|first| first < pair[1].unwrap()), "{leading:?}");
            }
            for (i, &column) in leading.iter().enumerate() {
                let Some(column) = column else { continue };
                let pivot = &result.form[i][column];
                prop_assert!(pivot.signum() > 0);
                for above in &result.form[..i] {
                    prop_assert!(above[column].signum() >= 0 && above[column] < *pivot);
                }
            }
        }
    }

    #[test]
    fn greatest_common_divisors_have_short_multipliers() {
        // A column of numbers: U is an extended greatest common divisor with short relations.
        let column = [
            763_836, 1_066_557, 113_192, 1_785_102, 1_470_060, 3_077_752, 114_793, 3_126_753, 1_997_137,
            2_603_018,
        ];
        let result = hermite_with_transform(integers(&column.map(|x| vec![x])));
        assert_eq!(result.form[0], [Integer::ONE]);
        let longest = result.transform.iter().map(|row| dot(row, row)).max().unwrap();
        assert!(longest < Integer::from(100), "{longest}");
    }
}
