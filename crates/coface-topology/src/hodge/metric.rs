//! Complexes with weights: inner products, codifferentials and Laplacians of real cochains.

use super::eigenvalues::symmetric_eigenvalues;
use coface_algebra::SparseMatrix;
use coface_algebra::chains::{ChainComplex, Cochain};
use coface_algebra::{CellId, Error, ErrorKind};

/// A chain complex with a positive weight for each cell: an inner product on its real cochains.
///
/// # Examples
/// The rim of a triangle. A function that is 1 at one vertex climbs along one of its edges and falls along the other;
/// its Laplacian is 2 there and -1 at both neighbors.
/// ```
/// use coface_algebra::CellId;
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::{ChainComplex, Cochain};
/// use coface_topology::MetricComplex;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let rim =
///     SparseMatrix::from_entries(3, 3, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1), (0, 2, -1), (2, 2, 1)])?;
/// let circle = ChainComplex::new(vec![rim])?;
/// let peak = Cochain::new(&circle, 0, [(CellId::new(1), 1.0)])?;
/// assert_eq!(MetricComplex::new(&circle).laplacian(&peak)?.to_string(), "-c0 + 2 c1 - c2");
/// # Ok(()) }
/// ```
#[derive(Clone, Debug)]
pub struct MetricComplex<'a> {
    complex: &'a ChainComplex,
    /// The weight of each cell of degree k at position k.
    weights: Vec<Vec<f64>>,
}

impl<'a> MetricComplex<'a> {
    /// The complex with all weights 1: cells are orthonormal.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::MetricComplex;
    /// let points = ChainComplex::of_points(2);
    /// assert_eq!(MetricComplex::new(&points).weights(0), [1.0, 1.0]);
    /// ```
    pub fn new(complex: &'a ChainComplex) -> Self {
        Self { complex, weights: complex.f_vector().iter().map(|&count| vec![1.0; count]).collect() }
    }

    /// The complex with these weights: for each degree a list, for each cell a positive number.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] unless there is one weight for each cell; [`ErrorKind::InvalidInput`] naming a cell whose
    /// weight is not positive or not finite.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::MetricComplex;
    /// let points = ChainComplex::of_points(2);
    /// assert!(MetricComplex::with_weights(&points, vec![vec![1.0, 0.5]]).is_ok());
    /// assert!(MetricComplex::with_weights(&points, vec![vec![1.0, 0.0]]).is_err());
    /// ```
    pub fn with_weights(complex: &'a ChainComplex, weights: Vec<Vec<f64>>) -> Result<Self, Error> {
        let counts: Vec<usize> = weights.iter().map(Vec::len).collect();
        if counts != complex.f_vector() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!(
                    "the weights have the counts {counts:?}, but the complex has {:?} cells",
                    complex.f_vector()
                ),
            )
            .with_cure("give for each degree one weight a cell"));
        }
        for (degree, level) in weights.iter().enumerate() {
            if let Some(cell) = level.iter().position(|&weight| !(weight > 0.0 && weight.is_finite())) {
                return Err(Error::invalid(format!(
                    "the weight of cell {} of degree {degree} is {}, not a positive number",
                    CellId::new(cell),
                    level[cell]
                )));
            }
        }
        Ok(Self { complex, weights })
    }

    /// The complex without its weights.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::MetricComplex;
    /// let points = ChainComplex::of_points(2);
    /// assert_eq!(MetricComplex::new(&points).complex().f_vector(), [2]);
    /// ```
    pub fn complex(&self) -> &'a ChainComplex {
        self.complex
    }

    /// The weight of each cell of this degree; empty beyond the dimension.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::MetricComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(2);
    /// let metric = MetricComplex::with_weights(&points, vec![vec![1.0, 0.5]])?;
    /// assert_eq!(metric.weights(0), [1.0, 0.5]);
    /// assert!(metric.weights(1).is_empty());
    /// # Ok(()) }
    /// ```
    pub fn weights(&self, degree: usize) -> &[f64] {
        self.weights.get(degree).map_or(&[], Vec::as_slice)
    }

    /// The inner product of two cochains: the sum over cells of the weight times both values.
    ///
    /// # Errors
    /// [`ErrorKind::Shape`] if the degrees differ; [`ErrorKind::NotInComplex`] for a cell that is not here.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_algebra::chains::{ChainComplex, Cochain};
    /// use coface_topology::MetricComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(2);
    /// let metric = MetricComplex::with_weights(&points, vec![vec![1.0, 0.5]])?;
    /// let values = Cochain::new(&points, 0, [(CellId::new(0), 3.0), (CellId::new(1), 4.0)])?;
    /// // 1 * 3 * 3 + 0.5 * 4 * 4
    /// assert_eq!(metric.inner_product(&values, &values)?, 17.0);
    /// # Ok(()) }
    /// ```
    pub fn inner_product(&self, a: &Cochain<f64>, b: &Cochain<f64>) -> Result<f64, Error> {
        if a.degree() != b.degree() {
            return Err(Error::new(
                ErrorKind::Shape,
                format!("the degrees {} and {} do not fit together", a.degree(), b.degree()),
            ));
        }
        Ok(self.dot(a.degree(), &self.dense(a)?, &self.dense(b)?))
    }

    /// The norm of a cochain: the square root of its inner product with itself.
    ///
    /// # Errors
    /// As [`Self::inner_product`].
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::CellId;
    /// use coface_algebra::chains::{ChainComplex, Cochain};
    /// use coface_topology::MetricComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let points = ChainComplex::of_points(2);
    /// let values = Cochain::new(&points, 0, [(CellId::new(0), 3.0), (CellId::new(1), 4.0)])?;
    /// assert_eq!(MetricComplex::new(&points).norm(&values)?, 5.0);
    /// # Ok(()) }
    /// ```
    pub fn norm(&self, cochain: &Cochain<f64>) -> Result<f64, Error> {
        Ok(self.length(cochain.degree(), &self.dense(cochain)?))
    }

    /// The codifferential of a cochain, one degree below: $\langle \delta^* a, b \rangle = \langle a, \delta b
    /// \rangle$.
    ///
    /// Below degree 0 there is nothing: that of a 0-cochain is zero, given as a cochain of degree 0.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] for a cell that is not here.
    ///
    /// # Complexity
    /// Linear in the boundary matrix.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::{ChainComplex, Cochain};
    /// use coface_topology::MetricComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A circle of two edges from vertex 0 to vertex 1.
    /// let edges = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)])?;
    /// let circle = ChainComplex::new(vec![edges])?;
    /// let metric = MetricComplex::new(&circle);
    /// let first = Cochain::new(&circle, 1, [(CellId::new(0), 1.0)])?;
    /// // Edge 0 runs from vertex 0 to vertex 1.
    /// assert_eq!(metric.codifferential(&first)?.to_string(), "-c0 + c1");
    /// # Ok(()) }
    /// ```
    pub fn codifferential(&self, cochain: &Cochain<f64>) -> Result<Cochain<f64>, Error> {
        let values = self.dense(cochain)?;
        match cochain.degree().checked_sub(1) {
            Some(below) => self.cochain(below, &self.down(below + 1, &values)),
            None => Ok(Cochain::zero(0)),
        }
    }

    /// The Laplacian of a cochain, $\delta^* \delta + \delta \delta^*$.
    ///
    /// # Errors
    /// [`ErrorKind::NotInComplex`] for a cell that is not here.
    ///
    /// # Complexity
    /// Linear in the boundary matrices of the degree and of the one above.
    ///
    /// # Examples
    /// ```
    /// use coface_algebra::{CellId, SparseMatrix};
    /// use coface_algebra::chains::{ChainComplex, Cochain};
    /// use coface_topology::MetricComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// // A circle of two edges from vertex 0 to vertex 1.
    /// let edges = SparseMatrix::from_entries(2, 2, [(0, 0, -1), (1, 0, 1), (0, 1, -1), (1, 1, 1)])?;
    /// let circle = ChainComplex::new(vec![edges])?;
    /// let metric = MetricComplex::new(&circle);
    /// let first = Cochain::new(&circle, 1, [(CellId::new(0), 1.0)])?;
    /// assert_eq!(metric.laplacian(&first)?.to_string(), "2 c0 + 2 c1");
    /// # Ok(()) }
    /// ```
    pub fn laplacian(&self, cochain: &Cochain<f64>) -> Result<Cochain<f64>, Error> {
        let (degree, values) = (cochain.degree(), self.dense(cochain)?);
        let mut sum = self.down(degree + 1, &self.up(degree, &values));
        if degree > 0 {
            let lower = self.up(degree - 1, &self.down(degree, &values));
            sum.iter_mut().zip(lower).for_each(|(x, y)| *x += y);
        }
        self.cochain(degree, &sum)
    }

    /// The eigenvalues of the Laplacian of this degree, rising. Those that are zero but for rounding are as many as the
    /// Betti number.
    ///
    /// # Errors
    /// [`ErrorKind::TooLarge`] for more than 5,000 cells of this degree: the computation is dense.
    ///
    /// # Complexity
    /// Cubic in the number of cells of this degree.
    ///
    /// # Examples
    /// Two vertices joined by an edge: constants are harmonic, the difference has the eigenvalue 2.
    /// ```
    /// use coface_algebra::SparseMatrix;
    /// use coface_algebra::chains::ChainComplex;
    /// use coface_topology::MetricComplex;
    /// # fn main() -> Result<(), coface_algebra::Error> {
    /// let edge = ChainComplex::new(vec![SparseMatrix::from_entries(2, 1, [(0, 0, -1), (1, 0, 1)])?])?;
    /// let spectrum = MetricComplex::new(&edge).laplacian_spectrum(0)?;
    /// assert!(spectrum[0].abs() < 1e-12 && (spectrum[1] - 2.0).abs() < 1e-12);
    /// # Ok(()) }
    /// ```
    pub fn laplacian_spectrum(&self, degree: usize) -> Result<Vec<f64>, Error> {
        let count = self.complex.cell_count(degree);
        if count > MOST_DENSE {
            return Err(Error::new(
                ErrorKind::TooLarge,
                format!("the spectrum of {count} cells is dense work; the limit is {MOST_DENSE}"),
            )
            .with_cure("take homology for the number of harmonic cochains, or a smaller complex"));
        }
        if count == 0 {
            return Ok(Vec::new());
        }
        symmetric_eigenvalues(self.symmetric_laplacian(degree)).ok_or_else(|| {
            Error::invalid("the eigenvalues do not converge")
                .with_cure("take weights that are nearer to each other")
        })
    }

    /// The Laplacian in the orthonormal basis of cells divided by the roots of their weights: rows, dense and
    /// symmetric.
    pub(super) fn symmetric_laplacian(&self, degree: usize) -> Vec<Vec<f64>> {
        let count = self.complex.cell_count(degree);
        let roots: Vec<f64> = self.weights(degree).iter().map(|weight| weight.sqrt()).collect();
        let mut sum = vec![vec![0.0; count]; count];
        // Each cell above adds the square of its boundary, each cell below that of its coboundary.
        let mut add = |column: &[(usize, f64)], weight: f64| {
            for &(i, x) in column {
                for &(j, y) in column {
                    sum[i][j] += weight * x * y;
                }
            }
        };
        if let Some(matrix) = self.complex.boundary_matrix(degree + 1) {
            for (column, &weight) in matrix.columns().zip(self.weights(degree + 1)) {
                let column: Vec<(usize, f64)> =
                    column.iter().map(|(row, x)| (row, f64::from(x) / roots[row])).collect();
                add(&column, weight);
            }
        }
        if let Some(below) = degree.checked_sub(1)
            && let Some(matrix) = self.complex.coboundary_matrix(below)
        {
            for (column, &weight) in matrix.columns().zip(self.weights(below)) {
                let column: Vec<(usize, f64)> =
                    column.iter().map(|(row, x)| (row, f64::from(x) * roots[row])).collect();
                add(&column, 1.0 / weight);
            }
        }
        sum
    }

    /// The value on each cell of the degree.
    pub(super) fn dense(&self, cochain: &Cochain<f64>) -> Result<Vec<f64>, Error> {
        let count = self.complex.cell_count(cochain.degree());
        let mut values = vec![0.0; count];
        for &(cell, value) in cochain.terms() {
            let Some(place) = values.get_mut(cell.index()) else {
                return Err(Error::new(
                    ErrorKind::NotInComplex,
                    format!(
                        "there is no cell {cell} of degree {}: there are {count} such cells",
                        cochain.degree()
                    ),
                ));
            };
            *place = value;
        }
        Ok(values)
    }

    /// The cochain with these values.
    pub(super) fn cochain(&self, degree: usize, values: &[f64]) -> Result<Cochain<f64>, Error> {
        let terms = values.iter().enumerate().map(|(cell, &value)| (CellId::new(cell), value));
        Cochain::new(self.complex, degree, terms)
    }

    /// The inner product of values on cells of this degree.
    pub(super) fn dot(&self, degree: usize, a: &[f64], b: &[f64]) -> f64 {
        self.weights(degree).iter().zip(a).zip(b).map(|((weight, x), y)| weight * x * y).sum()
    }

    pub(super) fn length(&self, degree: usize, values: &[f64]) -> f64 {
        self.dot(degree, values, values).sqrt()
    }

    /// The coboundary from this degree to the one above.
    pub(super) fn up(&self, degree: usize, values: &[f64]) -> Vec<f64> {
        let Some(matrix) = self.complex.boundary_matrix(degree + 1) else { return Vec::new() };
        let value = |column: coface_algebra::Column<'_>| {
            column.iter().map(|(row, entry)| f64::from(entry) * values[row]).sum()
        };
        matrix.columns().map(value).collect()
    }

    /// The codifferential from this degree to the one below; the degree is positive.
    pub(super) fn down(&self, degree: usize, values: &[f64]) -> Vec<f64> {
        let mut sums = vec![0.0; self.complex.cell_count(degree - 1)];
        if let Some(matrix) = self.complex.boundary_matrix(degree) {
            for ((column, &weight), &value) in matrix.columns().zip(self.weights(degree)).zip(values) {
                for (row, entry) in column.iter() {
                    sums[row] += weight * f64::from(entry) * value;
                }
            }
        }
        sums.iter_mut().zip(self.weights(degree - 1)).for_each(|(sum, weight)| *sum /= weight);
        sums
    }
}

/// The largest number of cells whose Laplacian is made dense.
const MOST_DENSE: usize = 5_000;

/// The combinatorial Laplacian of this degree, with all weights 1: $\partial_{k+1} \partial_{k+1}^T + \partial_k^T
/// \partial_k$ for the boundary matrices, exact. Symmetric; rows and columns are the cells of the degree.
///
/// # Errors
/// [`ErrorKind::TooLarge`] if an entry does not fit in 32 bits.
///
/// # Complexity
/// That of the two products.
///
/// # References
/// B. Eckmann, *Harmonische Funktionen und Randwertaufgaben in einem Komplex* (1944).
///
/// # Examples
/// A path of two edges: degrees on the diagonal, -1 for neighbors.
/// ```
/// use coface_algebra::SparseMatrix;
/// use coface_algebra::chains::ChainComplex;
/// use coface_topology::laplacian_matrix;
/// # fn main() -> Result<(), coface_algebra::Error> {
/// let edges = SparseMatrix::from_entries(3, 2, [(0, 0, -1), (1, 0, 1), (1, 1, -1), (2, 1, 1)])?;
/// let laplacian = laplacian_matrix(&ChainComplex::new(vec![edges])?, 0)?;
/// assert_eq!((laplacian.entry(1, 1), laplacian.entry(1, 2), laplacian.entry(0, 2)), (2, -1, 0));
/// # Ok(()) }
/// ```
pub fn laplacian_matrix(complex: &ChainComplex, degree: usize) -> Result<SparseMatrix, Error> {
    let count = complex.cell_count(degree);
    let square = |matrix: Option<&SparseMatrix>, is_outer: bool| match matrix {
        None => SparseMatrix::zero(count, count),
        Some(matrix) if is_outer => matrix.checked_product(&matrix.transpose()),
        Some(matrix) => matrix.transpose().checked_product(matrix),
    };
    let upper = square(complex.boundary_matrix(degree + 1), true)?;
    let lower = square(complex.boundary_matrix(degree), false)?;
    upper.sum(&lower)?.into_narrow()
}
