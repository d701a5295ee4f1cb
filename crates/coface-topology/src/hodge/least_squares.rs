//! The exact part of a cochain, by least squares.

use super::MetricComplex;
use super::cholesky::{CholeskyFactor, Entry, MOST_FILL};
use coface_algebra::progress::stage;
use coface_algebra::{Error, ErrorKind};

/// The orthogonal projection of cochains of one degree to the coboundaries among them.
///
/// With M for the coboundary restricted to cells whose coboundaries are a basis, and W for the weights, $M^T W M$ is
/// positive definite; its Cholesky factor is kept.
#[derive(Clone, Debug)]
pub(super) struct ExactProjection {
    degree: usize,
    /// The cells of one degree less whose coboundaries are a basis, rising.
    basis: Vec<u32>,
    factor: Option<CholeskyFactor>,
}

/// The largest number of products that are added up for the normal equations.
const MOST_PRODUCTS: usize = 1 << 25;

impl ExactProjection {
    /// The projection of cochains of a positive degree, for cells of one degree less whose coboundaries are a basis of
    /// all coboundaries.
    pub(super) fn new(metric: &MetricComplex<'_>, degree: usize, basis: Vec<u32>) -> Result<Self, Error> {
        if basis.is_empty() {
            return Ok(Self { degree, basis, factor: None });
        }
        let matrix = metric.complex().boundary_matrix(degree).expect("there are coboundaries of this degree");
        let mut number = vec![None; matrix.row_count()];
        for (i, &cell) in basis.iter().enumerate() {
            number[cell as usize] = Some(i);
        }
        let mut triplets: Vec<Entry> = Vec::new();
        for (cell, (column, &weight)) in matrix.columns().zip(metric.weights(degree)).enumerate() {
            let faces: Vec<(usize, f64)> =
                column.iter().filter_map(|(row, x)| Some((number[row]?, f64::from(x)))).collect();
            if triplets.len() + faces.len() * faces.len() / 2 > MOST_PRODUCTS {
                return Err(Error::new(
                    ErrorKind::TooLarge,
                    format!(
                        "the least squares problem of degree {degree} exceeds {MOST_PRODUCTS} products at cell c{cell}, \
                         which has {} faces",
                        column.rows().len()
                    ),
                )
                .with_cure("subdivide the cells that have very many faces"));
            }
            for (at, &(j, y)) in faces.iter().enumerate() {
                // The lower half, which is all that is looked at; basis numbers rise with rows.
                triplets.extend(faces[at..].iter().map(|&(i, x)| (i, j, weight * x * y)));
            }
        }
        let factor = CholeskyFactor::new(basis.len(), triplets, MOST_FILL)?;
        Ok(Self { degree, basis, factor: Some(factor) })
    }

    /// The exact part of a cochain given by its values, and a cochain of one degree less whose coboundary it is.
    ///
    /// The normal equations are solved, then solved again for what is left of their residual, as long as that at least
    /// halves: so the part is as exact as its computation from the potential.
    pub(super) fn project(
        &self,
        metric: &MetricComplex<'_>,
        values: &[f64],
    ) -> Result<(Vec<f64>, Vec<f64>), Error> {
        let below = self.degree - 1;
        let mut potential = vec![0.0; metric.complex().cell_count(below)];
        let mut exact = vec![0.0; values.len()];
        let Some(factor) = &self.factor else { return Ok((exact, potential)) };
        let mut last = f64::INFINITY;
        let steps = stage("solving for a potential", 0);
        loop {
            steps.advance(1);
            let rest: Vec<f64> = values.iter().zip(&exact).map(|(x, y)| x - y).collect();
            let down = metric.down(self.degree, &rest);
            // The codifferential carries the weights of its cells; the normal equations have none there.
            let weights = metric.weights(below);
            let mut step: Vec<f64> =
                self.basis.iter().map(|&cell| down[cell as usize] * weights[cell as usize]).collect();
            let size = step.iter().map(|x| x * x).sum::<f64>().sqrt();
            // Also ends for sizes that are no numbers.
            if !(size > 0.0 && size < 0.5 * last) {
                return Ok((exact, potential));
            }
            last = size;
            factor.solve(&mut step);
            for (&cell, step) in self.basis.iter().zip(step) {
                potential[cell as usize] += step;
            }
            exact = metric.up(below, &potential);
        }
    }
}
