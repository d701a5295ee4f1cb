//! Symmetric bilinear forms over the integers: rank, signature, parity, determinant, radical.

use crate::error::{Error, ErrorKind, Fault};
use crate::ids::narrow;
use crate::integers::Integer;
use crate::matrices::WideMatrix;
use crate::normal_forms::smith::smith_form_with_transforms;
use std::fmt;

/// A symmetric bilinear form on $\mathbb{Z}^n$, by its matrix: entry (i, j) is the value on the basis vectors i and j.
///
/// All answers are exact and do not depend on the basis.
///
/// # Examples
/// The hyperbolic plane: two null vectors that pair to 1.
/// ```
/// use coface_algebra::{Definiteness, Parity, SymmetricForm};
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let hyperbolic = SymmetricForm::from_rows([[0, 1], [1, 0]])?;
/// assert_eq!((hyperbolic.rank(), hyperbolic.signature(), hyperbolic.determinant()), (2, 0, (-1).into()));
/// assert_eq!((hyperbolic.parity(), hyperbolic.definiteness()), (Parity::Even, Definiteness::Indefinite));
/// assert_eq!(hyperbolic.name().as_deref(), Some("H"));
/// # Ok(()) }
/// ```
#[derive(Clone, PartialEq, Eq)]
pub struct SymmetricForm {
    rows: Vec<Vec<Integer>>,
    inertia: Inertia,
    determinant: Integer,
}

/// The numbers of positive and negative entries of any diagonal form of a symmetric form over the rationals.
///
/// By Sylvester's law of inertia they do not depend on the diagonal form.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Inertia {
    positive: usize,
    negative: usize,
}

impl Inertia {
    /// The dimension of a largest subspace on which the form is positive.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_algebra::SymmetricForm::diagonal([5, -1, -1]).inertia().positive(), 1);
    /// ```
    pub fn positive(self) -> usize {
        self.positive
    }

    /// The dimension of a largest subspace on which the form is negative.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_algebra::SymmetricForm::diagonal([5, -1, -1]).inertia().negative(), 2);
    /// ```
    pub fn negative(self) -> usize {
        self.negative
    }
}

/// Whether a form takes odd values on the diagonal.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Parity {
    /// The value on every vector with itself is even.
    Even,
    /// Some vector has an odd value with itself.
    Odd,
}

impl fmt::Display for Parity {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Even => "even",
            Self::Odd => "odd",
        })
    }
}

/// Which signs a form takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Definiteness {
    /// Positive on every vector but zero.
    Positive,
    /// Negative on every vector but zero.
    Negative,
    /// Positive or zero, and zero on more than the zero vector.
    PositiveSemi,
    /// Negative or zero, and zero on more than the zero vector.
    NegativeSemi,
    /// Both signs.
    Indefinite,
    /// Zero on every vector.
    Zero,
}

impl fmt::Display for Definiteness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Positive => "positive definite",
            Self::Negative => "negative definite",
            Self::PositiveSemi => "positive semidefinite",
            Self::NegativeSemi => "negative semidefinite",
            Self::Indefinite => "indefinite",
            Self::Zero => "zero",
        })
    }
}

impl SymmetricForm {
    /// The form with this matrix.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] if the matrix is not square or not symmetric, naming the first such row or entry.
    ///
    /// # Complexity
    /// $O(n^3)$ integer operations on minors of the matrix.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{Integer, SymmetricForm};
    /// let form = SymmetricForm::new(vec![vec![Integer::from(-3)]])?;
    /// assert_eq!(form.signature(), -1);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn new(rows: Vec<Vec<Integer>>) -> Result<Self, Error> {
        check_square(&rows)?;
        for (i, row) in rows.iter().enumerate() {
            if let Some(j) = (0..i).find(|&j| row[j] != rows[j][i]) {
                return Err(Error::new(
                    ErrorKind::Shape,
                    format!("the entry ({i}, {j}) is {} but ({j}, {i}) is {}", row[j], rows[j][i]),
                )
                .with_cure("give a symmetric matrix"));
            }
        }
        let (inertia, determinant) = eliminate(rows.clone());
        Ok(Self { rows, inertia, determinant })
    }

    /// The form with this matrix of small integers.
    ///
    /// # Errors
    /// As [`Self::new`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SymmetricForm;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SymmetricForm::from_rows([[2, 1], [1, 2]])?.determinant(), 3.into());
    /// assert!(SymmetricForm::from_rows([[0, 1], [2, 0]]).is_err());
    /// # Ok(()) }
    /// ```
    pub fn from_rows<const N: usize>(rows: [[i64; N]; N]) -> Result<Self, Error> {
        Self::new(rows.iter().map(|row| row.iter().map(|&x| Integer::from(x)).collect()).collect())
    }

    /// The form that is zero off the diagonal.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SymmetricForm;
    /// let form = SymmetricForm::diagonal([1, 1, -1]);
    /// assert_eq!((form.signature(), form.name().as_deref()), (1, Some("2(1) + (-1)")));
    /// ```
    pub fn diagonal(values: impl IntoIterator<Item = i64>) -> Self {
        let values: Vec<i64> = values.into_iter().collect();
        let row = |i: usize| {
            (0..values.len()).map(|j| if i == j { values[i].into() } else { Integer::ZERO }).collect()
        };
        Self::new((0..values.len()).map(row).collect()).expect("a diagonal matrix is symmetric")
    }

    /// The form $E_8$: even, positive definite, of determinant 1; 2 on the eight nodes of the diagram, -1 between
    /// neighbors.
    ///
    /// # References
    /// J. Milnor, D. Husemoller, *Symmetric bilinear forms* (1973), chapter II, section 6.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{Parity, SymmetricForm};
    /// let form = SymmetricForm::e8();
    /// assert_eq!((form.signature(), form.parity(), form.determinant()), (8, Parity::Even, 1.into()));
    /// ```
    pub fn e8() -> Self {
        // A path of seven nodes, and one more at the third.
        let are_neighbors =
            |i: usize, j: usize| (i.abs_diff(j) == 1 && i.max(j) < 7) || (i.min(j), i.max(j)) == (2, 7);
        let entry = |i, j| Integer::from(if i == j { 2 } else { -i64::from(are_neighbors(i, j)) });
        let rows = (0..8).map(|i| (0..8).map(|j| entry(i, j)).collect()).collect();
        Self::new(rows).expect("being neighbors is symmetric")
    }

    /// The number n of basis vectors.
    ///
    /// # Examples
    /// ```
    /// assert_eq!(coface_algebra::SymmetricForm::e8().size(), 8);
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
    /// use coface_algebra::SymmetricForm;
    /// assert_eq!(SymmetricForm::diagonal([2, -3]).entry(1, 1), &(-3).into());
    /// ```
    pub fn entry(&self, i: usize, j: usize) -> &Integer {
        &self.rows[i][j]
    }

    /// The rows of the matrix.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SymmetricForm;
    /// assert_eq!(SymmetricForm::diagonal([2, -3]).rows()[0], [2.into(), 0.into()]);
    /// ```
    pub fn rows(&self) -> &[Vec<Integer>] {
        &self.rows
    }

    /// The numbers of positive and negative entries of a diagonal form over the rationals.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SymmetricForm;
    /// let inertia = SymmetricForm::diagonal([5, -1, -1, 0]).inertia();
    /// assert_eq!((inertia.positive(), inertia.negative()), (1, 2));
    /// ```
    pub fn inertia(&self) -> Inertia {
        self.inertia
    }

    /// The rank: the size less that of the radical.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SymmetricForm;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SymmetricForm::from_rows([[1, 1], [1, 1]])?.rank(), 1);
    /// # Ok(()) }
    /// ```
    pub fn rank(&self) -> usize {
        self.inertia.positive + self.inertia.negative
    }

    /// The signature: positive less negative entries of a diagonal form over the rationals.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SymmetricForm;
    /// assert_eq!(SymmetricForm::diagonal([1, 1, -1]).signature(), 1);
    /// ```
    pub fn signature(&self) -> i64 {
        self.inertia.positive as i64 - self.inertia.negative as i64
    }

    /// The determinant of the matrix; 1 for the form of size 0. It is the same in every basis.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SymmetricForm;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// assert_eq!(SymmetricForm::from_rows([[2, 1], [1, 2]])?.determinant(), 3.into());
    /// # Ok(()) }
    /// ```
    pub fn determinant(&self) -> Integer {
        self.determinant.clone()
    }

    /// Whether the determinant is 1 or -1: the form is an isomorphism of the lattice with its dual.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SymmetricForm;
    /// assert!(SymmetricForm::e8().is_unimodular() && !SymmetricForm::diagonal([2]).is_unimodular());
    /// ```
    pub fn is_unimodular(&self) -> bool {
        self.determinant.is_unit()
    }

    /// Even if the diagonal is: then all values on a vector with itself are.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{Parity, SymmetricForm};
    /// assert_eq!(SymmetricForm::diagonal([1, -1]).parity(), Parity::Odd);
    /// ```
    pub fn parity(&self) -> Parity {
        let is_odd = |x: &Integer| !Integer::from(2).divides(x);
        if self.rows.iter().enumerate().any(|(i, row)| is_odd(&row[i])) { Parity::Odd } else { Parity::Even }
    }

    /// Which signs the form takes; that of size 0 takes none.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{Definiteness, SymmetricForm};
    /// let form = SymmetricForm::from_rows([[1, 1], [1, 1]])?;
    /// assert_eq!(form.definiteness(), Definiteness::PositiveSemi);
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn definiteness(&self) -> Definiteness {
        let Inertia { positive, negative } = self.inertia;
        let is_whole = positive + negative == self.size();
        match (positive, negative) {
            (0, 0) => Definiteness::Zero,
            (_, 0) if is_whole => Definiteness::Positive,
            (_, 0) => Definiteness::PositiveSemi,
            (0, _) if is_whole => Definiteness::Negative,
            (0, _) => Definiteness::NegativeSemi,
            _ => Definiteness::Indefinite,
        }
    }

    /// A basis of the radical: of all vectors whose value with every vector is zero. No multiple of another lattice
    /// vector lies in it without that vector.
    ///
    /// # Complexity
    /// That of Smith normal form with transforms.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SymmetricForm;
    /// let radical = SymmetricForm::from_rows([[2, -2], [-2, 2]])?.radical();
    /// assert_eq!(radical.len(), 1);
    /// assert!(radical[0][0] == radical[0][1] && radical[0][0].is_unit());
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn radical(&self) -> Vec<Vec<Integer>> {
        let transforms = smith_form_with_transforms(&matrix(&self.rows));
        let kernel = transforms.form().rank()..self.size();
        kernel
            .map(|j| {
                let mut vector = vec![Integer::ZERO; self.size()];
                for (i, x) in transforms.right().column(j).terms() {
                    vector[i] = x.clone();
                }
                vector
            })
            .collect()
    }

    /// The value on two vectors.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] if their lengths are not the size.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SymmetricForm;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let form = SymmetricForm::from_rows([[0, 1], [1, 0]])?;
    /// assert_eq!(form.value(&[1.into(), 2.into()], &[3.into(), 4.into()])?, 10.into());
    /// # Ok(()) }
    /// ```
    pub fn value(&self, first: &[Integer], second: &[Integer]) -> Result<Integer, Error> {
        evaluate(&self.rows, first, second)
    }

    /// The orthogonal sum: this form on the first basis vectors, the other on the rest.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SymmetricForm;
    /// let sum = SymmetricForm::diagonal([2]).direct_sum(&SymmetricForm::diagonal([-3]));
    /// assert_eq!(sum, SymmetricForm::diagonal([2, -3]));
    /// ```
    #[must_use]
    pub fn direct_sum(&self, other: &Self) -> Self {
        let (n, m) = (self.size(), other.size());
        let zeros = |count| std::iter::repeat_n(Integer::ZERO, count);
        let first = self.rows.iter().map(|row| row.iter().cloned().chain(zeros(m)).collect());
        let second = other.rows.iter().map(|row| zeros(n).chain(row.iter().cloned()).collect());
        Self::new(first.chain(second).collect()).expect("both blocks are symmetric")
    }

    /// The form with the opposite values: that of the manifold with the opposite orientation.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SymmetricForm;
    /// assert_eq!(SymmetricForm::diagonal([1, -2]).negated(), SymmetricForm::diagonal([-1, 2]));
    /// ```
    #[must_use]
    pub fn negated(&self) -> Self {
        let rows = self.rows.iter().map(|row| row.iter().map(|x| -x).collect()).collect();
        Self::new(rows).expect("the negative of a symmetric matrix is symmetric")
    }

    /// The form in another basis: entry (i, j) is the value on the vectors i and j of `basis`.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] for a vector whose length is not the size.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{Integer, SymmetricForm};
    /// let basis = [[1, 1], [1, -1]].map(|v| v.map(Integer::from).to_vec());
    /// let form = SymmetricForm::from_rows([[0, 1], [1, 0]])?.in_basis(&basis)?;
    /// assert_eq!(form, SymmetricForm::diagonal([2, -2]));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn in_basis(&self, basis: &[Vec<Integer>]) -> Result<Self, Error> {
        let row = |v: &Vec<Integer>| basis.iter().map(|w| self.value(v, w)).collect();
        Self::new(basis.iter().map(row).collect::<Result<_, Error>>()?)
    }

    /// The isomorphism class in the usual words, where rank, signature and parity fix it: $a(1) + b(-1)$ if odd, copies
    /// of $E_8$ or its negative and of the hyperbolic plane H if even. `None` for forms that are not unimodular and for
    /// definite ones above rank 8, where there are several; `0` for size 0.
    ///
    /// # References
    /// J. Milnor, D. Husemoller, *Symmetric bilinear forms* (1973), chapter II, theorems 5.3 and 4.3; definite forms up
    /// to rank 8: section 6.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::SymmetricForm;
    /// let hyperbolic = SymmetricForm::from_rows([[0, 1], [1, 0]])?;
    /// let form = SymmetricForm::e8().negated().direct_sum(&hyperbolic);
    /// assert_eq!(form.name().as_deref(), Some("(-E8) + H"));
    /// # Ok::<(), coface_algebra::Error>(())
    /// ```
    pub fn name(&self) -> Option<String> {
        let Inertia { positive, negative } = self.inertia;
        let is_definite = positive == 0 || negative == 0;
        if !self.is_unimodular() || (is_definite && self.size() > 8) {
            return None;
        }
        let copies = |count: usize, of: &str| match count {
            0 => None,
            1 => Some(of.to_string()),
            _ => Some(format!("{count}{of}")),
        };
        let parts = match self.parity() {
            Parity::Odd => [copies(positive, "(1)"), copies(negative, "(-1)")],
            Parity::Even => {
                let e8 = if positive > negative { "E8" } else { "(-E8)" };
                [copies(positive.abs_diff(negative) / 8, e8), copies(positive.min(negative), "H")]
            }
        };
        let parts: Vec<String> = parts.into_iter().flatten().collect();
        Some(if parts.is_empty() { "0".into() } else { parts.join(" + ") })
    }
}

impl fmt::Debug for SymmetricForm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_list().entries(&self.rows).finish()
    }
}

/// That every row has as many entries as there are rows.
pub(super) fn check_square(rows: &[Vec<Integer>]) -> Result<(), Error> {
    match rows.iter().position(|row| row.len() != rows.len()) {
        Some(i) => Err(Error::new(
            ErrorKind::Shape,
            format!("row {i} has {} entries; a form with {} rows needs as many", rows[i].len(), rows.len()),
        )
        .with_fault(Fault::Length { found: rows[i].len(), expected: rows.len() })),
        None => Ok(()),
    }
}

pub(super) fn matrix(rows: &[Vec<Integer>]) -> WideMatrix {
    let column = |j: usize| {
        (0..rows.len()).filter(|&i| !rows[i][j].is_zero()).map(|i| (narrow(i), rows[i][j].clone())).collect()
    };
    WideMatrix::from_integer_columns(rows.len(), (0..rows.len()).map(column))
        .expect("a square matrix has its rows in range")
}

pub(super) fn evaluate(
    rows: &[Vec<Integer>],
    first: &[Integer],
    second: &[Integer],
) -> Result<Integer, Error> {
    if let Some(length) = [first.len(), second.len()].into_iter().find(|&length| length != rows.len()) {
        return Err(Error::new(
            ErrorKind::Shape,
            format!("a vector of length {length} has no value under a form of size {}", rows.len()),
        )
        .with_fault(Fault::Length { found: length, expected: rows.len() }));
    }
    let mut sum = Integer::ZERO;
    for (x, row) in first.iter().zip(rows).filter(|(x, _)| !x.is_zero()) {
        for (entry, y) in row.iter().zip(second) {
            sum += &(&(x * entry) * y);
        }
    }
    Ok(sum)
}

/// Inertia and determinant of a symmetric matrix by fraction-free symmetric elimination.
///
/// After k steps the remaining entries are minors: those of the first k rows and columns together with one more of
/// each, so that every division is exact (E. H. Bareiss, *Sylvester's identity and multistep integer-preserving
/// Gaussian elimination*, 1968) and the pivots are the leading principal minors $D_1, D_2, \dots$ of a matrix congruent
/// to the given one. The diagonal form is $D_k / D_{k-1}$. Where no diagonal entry is left that is not zero, adding a
/// basis vector to another makes one.
fn eliminate(mut rows: Vec<Vec<Integer>>) -> (Inertia, Integer) {
    let n = rows.len();
    let mut inertia = Inertia::default();
    let mut last = Integer::ONE;
    for k in 0..n {
        let Some(pivot) = diagonal_pivot(&mut rows, k) else { return (inertia, Integer::ZERO) };
        rows.swap(k, pivot);
        rows.iter_mut().for_each(|row| row.swap(k, pivot));
        let (above, below) = rows.split_at_mut(k + 1);
        let pivot_row = &above[k];
        for row in below {
            let factor = row[k].clone();
            for j in k + 1..n {
                let minor = &(&pivot_row[k] * &row[j]) - &(&factor * &pivot_row[j]);
                row[j] = minor.exact_quotient(&last).expect("minors divide along by Sylvester's identity");
            }
            row[k] = Integer::ZERO;
        }
        let pivot = rows[k][k].clone();
        if pivot.signum() == last.signum() {
            inertia.positive += 1;
        } else {
            inertia.negative += 1;
        }
        last = pivot;
    }
    (inertia, last)
}

/// The place of a smallest entry that is not zero on the diagonal from `k` on, made by one congruence if there is none;
/// `None` if all that is left is zero.
fn diagonal_pivot(rows: &mut [Vec<Integer>], k: usize) -> Option<usize> {
    let n = rows.len();
    let smallest = (k..n).filter(|&i| !rows[i][i].is_zero()).min_by_key(|&i| rows[i][i].bit_length());
    if smallest.is_some() {
        return smallest;
    }
    let (i, j) = (k..n).flat_map(|i| (k..i).map(move |j| (i, j))).find(|&(i, j)| !rows[i][j].is_zero())?;
    // Of two different rows j < i one is read and the other changed.
    let (before, after) = rows.split_at_mut(i);
    after[0].iter_mut().zip(&before[j]).for_each(|(x, y)| *x += y);
    for row in &mut rows[k..n] {
        let entry = row[j].clone();
        row[i] += &entry;
    }
    Some(i)
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;
    use crate::integers::Rational;
    use crate::normal_forms::smith::smith_form;
    use proptest::prelude::*;

    fn integers(values: &[i64]) -> Vec<Integer> {
        values.iter().map(|&x| x.into()).collect()
    }

    /// A product of elementary operations: a basis of the lattice.
    pub(crate) fn bases(size: usize) -> impl Strategy<Value = Vec<Vec<Integer>>> {
        let step = (0..size.max(1), 0..size.max(1), -2i64..=2);
        prop::collection::vec(step, 0..12).prop_map(move |steps| {
            let mut rows: Vec<Vec<Integer>> =
                (0..size).map(|i| (0..size).map(|j| i64::from(i == j).into()).collect()).collect();
            for (from, to, factor) in steps {
                if from < size && to < size && from != to {
                    let added: Vec<Integer> = rows[from].iter().map(|x| x * &factor.into()).collect();
                    rows[to].iter_mut().zip(&added).for_each(|(x, y)| *x += y);
                }
            }
            rows
        })
    }

    fn forms() -> impl Strategy<Value = SymmetricForm> {
        (0usize..6).prop_flat_map(|n| {
            prop::collection::vec(-4i64..=4, n * n).prop_map(move |values| {
                let entry = |i: usize, j: usize| values[i.min(j) * n + i.max(j)].into();
                SymmetricForm::new((0..n).map(|i| (0..n).map(|j| entry(i, j)).collect()).collect()).unwrap()
            })
        })
    }

    /// The second method: diagonal entries by elimination with fractions, after Lagrange.
    fn diagonal_of_fractions(form: &SymmetricForm) -> Vec<Rational> {
        let mut rows: Vec<Vec<Rational>> =
            form.rows().iter().map(|row| row.iter().map(|x| x.clone().into()).collect()).collect();
        let n = rows.len();
        let add = |rows: &mut Vec<Vec<Rational>>, from: usize, to: usize, factor: &Rational| {
            let added: Vec<Rational> = rows[from].iter().map(|x| x * factor).collect();
            rows[to].iter_mut().zip(&added).for_each(|(x, y)| *x += y);
            for row in rows.iter_mut() {
                row[to] = &row[to] + &(&row[from] * factor);
            }
        };
        for k in 0..n {
            if rows[k][k].is_zero() {
                let other = (k + 1..n).find(|&j| !rows[k][j].is_zero());
                let Some(j) = other else { continue };
                add(&mut rows, j, k, &Rational::ONE);
                if rows[k][k].is_zero() {
                    // 2 a_kj + a_jj = 0, so the difference has not.
                    add(&mut rows, j, k, &Rational::from(-2));
                }
            }
            let inverse = rows[k][k].inverse().unwrap();
            for j in k + 1..n {
                let factor = -&(&rows[k][j] * &inverse);
                add(&mut rows, k, j, &factor);
            }
        }
        (0..n).map(|k| rows[k][k].clone()).collect()
    }

    proptest! {
        /// Sylvester's law: nothing depends on the basis.
        #[test]
        fn answers_are_those_of_every_basis(
            (form, basis) in forms().prop_flat_map(|form| { let n = form.size(); (Just(form), bases(n)) })
        ) {
            let other = form.in_basis(&basis).unwrap();
            prop_assert_eq!(form.inertia(), other.inertia());
            prop_assert_eq!(form.determinant(), other.determinant());
            prop_assert_eq!(form.parity(), other.parity());
            prop_assert_eq!(form.definiteness(), other.definiteness());
            prop_assert_eq!(form.name(), other.name());
            prop_assert_eq!(form.radical().len(), other.radical().len());
        }

        #[test]
        fn inertia_is_that_of_a_diagonal_form(form in forms()) {
            let diagonal = diagonal_of_fractions(&form);
            let zero = Rational::ZERO;
            prop_assert_eq!(form.inertia().positive, diagonal.iter().filter(|&x| *x > zero).count());
            prop_assert_eq!(form.inertia().negative, diagonal.iter().filter(|&x| *x < zero).count());
            let product = diagonal.iter().fold(Rational::ONE, |product, x| &product * x);
            prop_assert_eq!(product, Rational::from(form.determinant()));
            // Rank and determinant up to sign by Smith normal form.
            let smith = smith_form(&matrix(form.rows()));
            prop_assert_eq!(form.rank(), smith.rank());
            prop_assert_eq!(form.negated().signature(), -form.signature());
        }

        #[test]
        fn the_radical_pairs_to_zero_with_all(form in forms()) {
            let radical = form.radical();
            prop_assert_eq!(radical.len(), form.size() - form.rank());
            for vector in &radical {
                for i in 0..form.size() {
                    let unit: Vec<Integer> = (0..form.size()).map(|j| i64::from(i == j).into()).collect();
                    prop_assert!(form.value(vector, &unit).unwrap().is_zero());
                }
            }
            // The basis is primitive: no factor but 1.
            let columns = radical.iter().map(|v| (0..).zip(v.iter().cloned()).filter(|(_, x)| !x.is_zero()).collect());
            let basis = WideMatrix::from_integer_columns(form.size(), columns).unwrap();
            prop_assert!(smith_form(&basis).diagonal().iter().all(Integer::is_unit));
        }

        #[test]
        fn sums_add_up((a, b) in (forms(), forms())) {
            let sum = a.direct_sum(&b);
            prop_assert_eq!(sum.signature(), a.signature() + b.signature());
            prop_assert_eq!(sum.rank(), a.rank() + b.rank());
            prop_assert_eq!(sum.determinant(), &a.determinant() * &b.determinant());
            prop_assert_eq!(sum.parity() == Parity::Even, a.parity() == Parity::Even && b.parity() == Parity::Even);
        }
    }

    #[test]
    fn known_forms_have_their_invariants() {
        let h = SymmetricForm::from_rows([[0, 1], [1, 0]]).unwrap();
        let k3 = [&SymmetricForm::e8().negated(), &SymmetricForm::e8().negated(), &h, &h, &h]
            .into_iter()
            .fold(SymmetricForm::diagonal([]), |sum, form| sum.direct_sum(form));
        assert_eq!((k3.rank(), k3.signature(), k3.determinant()), (22, -16, (-1).into()));
        assert_eq!((k3.parity(), k3.name().as_deref()), (Parity::Even, Some("2(-E8) + 3H")));
        assert_eq!(SymmetricForm::e8().definiteness(), Definiteness::Positive);
        assert_eq!(SymmetricForm::e8().name().as_deref(), Some("E8"));
        assert_eq!(SymmetricForm::e8().direct_sum(&SymmetricForm::diagonal([1])).name(), None);
        assert_eq!(SymmetricForm::diagonal([1, -1, -1]).name().as_deref(), Some("(1) + 2(-1)"));
        assert_eq!(SymmetricForm::diagonal([2]).name(), None);
        assert_eq!(SymmetricForm::diagonal([]).name().as_deref(), Some("0"));
        assert_eq!(SymmetricForm::diagonal([]).definiteness(), Definiteness::Zero);
        assert_eq!(SymmetricForm::diagonal([0, -2]).definiteness(), Definiteness::NegativeSemi);
        // 1 + 1 + ... + 1 and E8 differ in parity alone.
        assert_eq!(SymmetricForm::diagonal([1; 8]).parity(), Parity::Odd);
    }

    #[test]
    fn entries_beyond_64_bits_are_exact() {
        let big = i64::MAX;
        let form = SymmetricForm::from_rows([[big, big - 1], [big - 1, big - 2]]).unwrap();
        // x (x - 2) - (x - 1)^2 = -1.
        assert_eq!(form.determinant(), (-1).into());
        assert_eq!((form.signature(), form.is_unimodular()), (0, true));
    }

    #[test]
    fn matrices_that_are_no_form_are_refused() {
        let error = SymmetricForm::new(vec![integers(&[1, 2]), integers(&[3, 4])]).unwrap_err();
        assert_eq!(error.message(), "the entry (1, 0) is 3 but (0, 1) is 2");
        let error = SymmetricForm::new(vec![integers(&[1, 2])]).unwrap_err();
        assert_eq!(
            (error.kind(), error.message()),
            (ErrorKind::Shape, "row 0 has 2 entries; a form with 1 rows needs as many")
        );
        let form = SymmetricForm::diagonal([1, 2]);
        assert_eq!(form.value(&integers(&[1]), &integers(&[1, 2])).unwrap_err().kind(), ErrorKind::Shape);
    }
}
