//! Skew bilinear forms over the integers.

use crate::error::{Error, ErrorKind};
use crate::integers::Integer;
use crate::normal_forms::smith::invariant_factors;
use crate::normal_forms::symmetric_form::{check_square, evaluate, matrix};
use std::fmt;

/// A skew bilinear form on $\mathbb{Z}^n$, by its matrix: entry (i, j) is the value on the basis vectors i and j, entry
/// (j, i) its opposite, and the diagonal is zero.
///
/// # Examples
/// The intersections of loops on a surface of genus 1.
/// ```
/// use coface_algebra::SkewForm;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let torus = SkewForm::from_rows([[0, 1], [-1, 0]])?;
/// assert_eq!((torus.rank(), torus.determinant(), torus.is_unimodular()), (2, 1.into(), true));
/// # Ok(()) }
/// ```
#[derive(Clone, PartialEq, Eq)]
pub struct SkewForm {
    rows: Vec<Vec<Integer>>,
    divisors: Vec<Integer>,
}

impl SkewForm {
    /// The form with this matrix.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] if the matrix is not square or not skew, naming the first such row or entry.
    ///
    /// # Complexity
    /// That of Smith normal form.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{Integer, SkewForm};
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let rows = [[0, 2], [-2, 0]].map(|row| row.map(Integer::from).to_vec());
    /// assert_eq!(SkewForm::new(rows.to_vec())?.determinant(), 4.into());
    /// # Ok(()) }
    /// ```
    pub fn new(rows: Vec<Vec<Integer>>) -> Result<Self, Error> {
        check_square(&rows)?;
        for (i, row) in rows.iter().enumerate() {
            let fault = match (0..=i).find(|&j| row[j] != -&rows[j][i]) {
                Some(j) if j == i => format!("the entry ({i}, {i}) on the diagonal is {}, not 0", row[i]),
                Some(j) => format!("the entry ({i}, {j}) is {} but ({j}, {i}) is {}", row[j], rows[j][i]),
                None => continue,
            };
            return Err(Error::new(ErrorKind::Shape, fault)
                .with_cure("give a matrix that is the opposite of its transpose"));
        }
        // Each divisor stands twice among the invariant factors.
        let divisors = invariant_factors(&matrix(&rows)).into_iter().step_by(2).collect();
        Ok(Self { rows, divisors })
    }

    /// The form with this matrix of small integers.
    ///
    /// # Errors
    /// As [`Self::new`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SkewForm;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SkewForm::from_rows([[0, 3], [-3, 0]])?.divisors(), [3.into()]);
    /// assert!(SkewForm::from_rows([[1]]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn from_rows<const N: usize>(rows: [[i64; N]; N]) -> Result<Self, Error> {
        Self::new(rows.iter().map(|row| row.iter().map(|&x| Integer::from(x)).collect()).collect())
    }

    /// The number n of basis vectors.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SkewForm;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SkewForm::from_rows([[0, 1], [-1, 0]])?.size(), 2);
    /// # Ok(()) }
    /// ```
    pub fn size(&self) -> usize {
        self.rows.len()
    }

    /// The value on the basis vectors i and j.
    ///
    /// # Panics
    /// If one of them is not below the size.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SkewForm;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SkewForm::from_rows([[0, 1], [-1, 0]])?.entry(1, 0), &(-1).into());
    /// # Ok(()) }
    /// ```
    pub fn entry(&self, i: usize, j: usize) -> &Integer {
        &self.rows[i][j]
    }

    /// The rows of the matrix.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SkewForm;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SkewForm::from_rows([[0, 1], [-1, 0]])?.rows()[0], [0.into(), 1.into()]);
    /// # Ok(()) }
    /// ```
    pub fn rows(&self) -> &[Vec<Integer>] {
        &self.rows
    }

    /// The elementary divisors $d_1 | d_2 | \dots$: in some basis the form is a sum of blocks with $d_i$ and $-d_i$ off
    /// the diagonal, and zeros. They determine the form up to a change of basis.
    ///
    /// # References
    /// N. Bourbaki, *Algebra II* (1981), chapter IX, section 5, theorem 1.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SkewForm;
    /// let form = SkewForm::from_rows([[0, 6, 0], [-6, 0, 4], [0, -4, 0]])?;
    /// assert_eq!((form.divisors(), form.rank()), (&[2.into()][..], 2));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn divisors(&self) -> &[Integer] {
        &self.divisors
    }

    /// The rank, an even number.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SkewForm;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SkewForm::from_rows([[0, 1, 0], [-1, 0, 0], [0, 0, 0]])?.rank(), 2);
    /// # Ok(()) }
    /// ```
    pub fn rank(&self) -> usize {
        2 * self.divisors.len()
    }

    /// The determinant, the square of the product of the divisors if the rank is the size, else 0.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SkewForm;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SkewForm::from_rows([[0, 3], [-3, 0]])?.determinant(), 9.into());
    /// # Ok(()) }
    /// ```
    pub fn determinant(&self) -> Integer {
        if self.rank() < self.size() {
            return Integer::ZERO;
        }
        self.divisors.iter().fold(Integer::ONE, |product, d| &(&product * d) * d)
    }

    /// Whether the determinant is 1: the form is an isomorphism of the lattice with its dual.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SkewForm;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert!(SkewForm::from_rows([[0, 1], [-1, 0]])?.is_unimodular());
    /// assert!(!SkewForm::from_rows([[0, 3], [-3, 0]])?.is_unimodular());
    /// # Ok(()) }
    /// ```
    pub fn is_unimodular(&self) -> bool {
        self.determinant().is_unit()
    }

    /// The value on two vectors.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] if their lengths are not the size.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SkewForm;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SkewForm::from_rows([[0, 1], [-1, 0]])?;
    /// // The determinant of the two vectors (2, 3) and (1, 4).
    /// assert_eq!(torus.value(&[2.into(), 3.into()], &[1.into(), 4.into()])?, 5.into());
    /// # Ok(()) }
    /// ```
    pub fn value(&self, first: &[Integer], second: &[Integer]) -> Result<Integer, Error> {
        evaluate(&self.rows, first, second)
    }

    /// The form in another basis: entry (i, j) is the value on the vectors i and j of `basis`.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] for a vector whose length is not the size.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SkewForm;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let torus = SkewForm::from_rows([[0, 1], [-1, 0]])?;
    /// let swapped = torus.in_basis(&[vec![0.into(), 1.into()], vec![1.into(), 0.into()]])?;
    /// assert_eq!(swapped, SkewForm::from_rows([[0, -1], [1, 0]])?);
    /// # Ok(()) }
    /// ```
    pub fn in_basis(&self, basis: &[Vec<Integer>]) -> Result<Self, Error> {
        let row = |v: &Vec<Integer>| basis.iter().map(|w| self.value(v, w)).collect();
        Self::new(basis.iter().map(row).collect::<Result<_, Error>>()?)
    }
}

impl fmt::Debug for SkewForm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(&self.rows).finish()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::normal_forms::symmetric_form::tests::bases;
    use proptest::prelude::*;

    /// The Pfaffian by expansion along the first row.
    fn pfaffian(rows: &[Vec<Integer>]) -> Integer {
        if rows.is_empty() {
            return Integer::ONE;
        }
        let n = rows.len();
        let mut sum = Integer::ZERO;
        for j in 1..n {
            let keep = |i: &usize| *i != 0 && *i != j;
            let minor: Vec<Vec<Integer>> = (0..n)
                .filter(keep)
                .map(|i| (0..n).filter(keep).map(|k| rows[i][k].clone()).collect())
                .collect();
            let term = &rows[0][j] * &pfaffian(&minor);
            sum += &(if j % 2 == 1 { term } else { -&term });
        }
        sum
    }

    fn forms() -> impl Strategy<Value = SkewForm> {
        (0usize..7).prop_flat_map(|n| {
            prop::collection::vec(-4i64..=4, n * n).prop_map(move |values| {
                let entry = |i: usize, j: usize| -> Integer {
                    match i.cmp(&j) {
                        std::cmp::Ordering::Less => values[i * n + j].into(),
                        std::cmp::Ordering::Equal => Integer::ZERO,
                        std::cmp::Ordering::Greater => (-values[j * n + i]).into(),
                    }
                };
                SkewForm::new((0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()).unwrap()
            })
        })
    }

    proptest! {
        #[test]
        fn the_determinant_is_the_square_of_the_pfaffian(form in forms()) {
            let expected = if form.size() % 2 == 0 {
                let root = pfaffian(form.rows());
                &root * &root
            } else {
                Integer::ZERO
            };
            prop_assert_eq!(form.determinant(), expected);
        }

        #[test]
        fn divisors_are_those_of_every_basis(
            (form, basis) in forms().prop_flat_map(|form| { let n = form.size(); (Just(form), bases(n)) })
        ) {
            let other = form.in_basis(&basis).unwrap();
            prop_assert_eq!(form.divisors(), other.divisors());
        }
    }

    #[test]
    fn matrices_that_are_not_skew_are_refused() {
        assert_eq!(
            SkewForm::from_rows([[1]]).unwrap_err().message(),
            "the entry (0, 0) on the diagonal is 1, not 0"
        );
        assert_eq!(SkewForm::from_rows([[0, 1], [1, 0]]).unwrap_err().kind(), ErrorKind::Shape);
    }
}
