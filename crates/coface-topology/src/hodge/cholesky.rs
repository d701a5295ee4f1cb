//! Sparse Cholesky factors of positive definite matrices.

use coface_algebra::{Error, ErrorKind};
use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::sparse::linalg::cholesky::{LltRef, SymbolicCholesky, factorize_symbolic_cholesky};
use faer::sparse::{SparseColMat, Triplet};
use faer::{Conj, MatMut, Par, Side};

/// The Cholesky factor of a symmetric positive definite matrix, with a fill-reducing order. One thread: the same input
/// gives the same bytes.
pub(crate) struct CholeskyFactor {
    symbolic: SymbolicCholesky<usize>,
    values: Vec<f64>,
}

/// The largest number of entries of a factor: 2 GiB.
pub(crate) const MOST_FILL: usize = 1 << 28;

impl CholeskyFactor {
    /// The factor of the matrix with these entries (row, column, value) in its lower half; those at one place are added.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if the factor has more than `most` entries, or the matrix is not positive definite in
    /// floating point.
    pub(crate) fn new(
        count: usize,
        entries: Vec<Triplet<usize, usize, f64>>,
        most: usize,
    ) -> Result<Self, Error> {
        let matrix = SparseColMat::try_new_from_triplets(count, count, &entries)
            .map_err(|error| too_hard(count, &error))?;
        drop(entries);
        let symbolic = factorize_symbolic_cholesky(
            matrix.symbolic(),
            Side::Lower,
            Default::default(),
            Default::default(),
        )
        .map_err(|error| too_hard(count, &error))?;
        let fill = symbolic.len_val();
        if fill > most {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("the Cholesky factor of {count} equations has {fill} entries; the limit is {most}"),
            )
            .with_cure("take a coarser complex"));
        }
        let mut values = vec![0.0; fill];
        let mut space =
            space(symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, Default::default()), count)?;
        symbolic
            .factorize_numeric_llt(
                &mut values,
                matrix.as_ref(),
                Side::Lower,
                Default::default(),
                Par::Seq,
                MemStack::new(&mut space),
                Default::default(),
            )
            .map_err(|error| too_hard(count, &error))?;
        Ok(Self { symbolic, values })
    }

    /// Solves the equations with this right side, in its place.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] if there is no memory to work in.
    pub(crate) fn solve(&self, right: &mut [f64]) -> Result<(), Error> {
        let count = right.len();
        let mut space = space(self.symbolic.solve_in_place_scratch::<f64>(1, Par::Seq), count)?;
        LltRef::new(&self.symbolic, &self.values).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(right, count, 1),
            Par::Seq,
            MemStack::new(&mut space),
        );
        Ok(())
    }
}

fn space(size: StackReq, count: usize) -> Result<MemBuffer, Error> {
    MemBuffer::try_new(size).map_err(|error| too_hard(count, &error))
}

fn too_hard(count: usize, error: &impl std::fmt::Debug) -> Error {
    Error::new(ErrorKind::TooLarge, format!("{count} equations cannot be solved: {error:?}"))
        .with_cure("take a coarser complex, or weights that are nearer to each other")
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The lower half of $A^T A + I$ for rows of A, which is positive definite.
    fn normal(rows: &[Vec<f64>]) -> Vec<Triplet<usize, usize, f64>> {
        let count = rows[0].len();
        let mut entries: Vec<_> = (0..count).map(|i| Triplet::new(i, i, 1.0)).collect();
        for row in rows {
            for j in 0..count {
                entries.extend((j..count).map(|i| Triplet::new(i, j, row[i] * row[j])));
            }
        }
        entries
    }

    proptest! {
        #[test]
        fn solutions_solve(
            rows in prop::collection::vec(prop::collection::vec(-2.0f64..2.0, 6), 1..8),
            right in prop::collection::vec(-1.0f64..1.0, 6),
        ) {
            let factor = CholeskyFactor::new(6, normal(&rows), MOST_FILL).unwrap();
            let mut solution = right.clone();
            factor.solve(&mut solution).unwrap();
            for (i, expected) in right.iter().enumerate() {
                let sum: f64 = solution[i]
                    + rows.iter().map(|row| row[i] * row.iter().zip(&solution).map(|(a, x)| a * x).sum::<f64>()).sum::<f64>();
                prop_assert!((sum - expected).abs() < 1e-10, "{} {}", sum, expected);
            }
        }
    }

    #[test]
    fn what_cannot_be_factorized_is_refused() {
        let dense = || normal(&[vec![1.0, 2.0, 3.0]]);
        let refused = |entries, most| CholeskyFactor::new(3, entries, most).err().map(|error| error.kind());
        assert_eq!(refused(dense(), MOST_FILL), None);
        assert_eq!(refused(dense(), 3), Some(ErrorKind::TooLarge), "six or nine entries are too many");
        let indefinite = [(0, 1.0), (1, -1.0), (2, 1.0)].map(|(i, x)| Triplet::new(i, i, x));
        assert_eq!(refused(indefinite.to_vec(), MOST_FILL), Some(ErrorKind::TooLarge));
    }
}
