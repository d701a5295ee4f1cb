//! Hodge theory of a complex: real cochains with an inner product, Laplacians and harmonic cochains.
//!
//! # Words and conventions
//! * Each cell has a positive **weight**, 1 by default: $\langle a, b \rangle = \sum_c w_c\, a(c)\, b(c)$,
//!   the sum over all cells. A [`MetricComplex`] is a complex with weights.
//! * The **codifferential** $\delta^*$ is the adjoint of the coboundary $\delta$: one degree down. The **Laplacian** is
//!   $\delta^* \delta + \delta \delta^*$. A cochain is **harmonic** when its Laplacian is zero; equally, when it is
//!   **closed** (coboundary zero) and **coclosed** (codifferential zero).
//! * Every cochain has exactly one decomposition as the sum of an **exact** part (a coboundary), a **coexact** part
//!   (a codifferential) and a harmonic part, orthogonal to each other: the [`HodgeDecomposition`].
//! * Each real cohomology class has one harmonic cochain. Those of a basis of integral classes are the
//!   [`harmonic_basis`]; integers decide how many there are, floating point only their values.

mod cholesky;
mod decomposition;
mod eigenvalues;
mod image;
mod least_squares;
mod metric;
mod ordering;

#[cfg(test)]
mod tests;

pub(super) use cholesky::{CholeskyFactor, MOST_FILL};
pub use decomposition::{HarmonicCochain, HodgeDecomposition, HodgeSpace, harmonic_basis};
pub use metric::{MetricComplex, laplacian_matrix};
